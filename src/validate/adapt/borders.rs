//! The adapter for structures whose border half-edges have no `next`.

use super::cycles::{entry, filled, inverse, live, nils};
use crate::validate::structure::{Link, View};
use alloc::vec::Vec;

/// A structure that stores border half-edges without face and `next`; their `next` is derived.
///
/// ```text
///        \ faces /         b, without face and next, ends at w. From its twin the walk turns around w,
///         \     /          by twin∘prev, to the half-edge c that follows no other one. If c is a border
///   ─── b ─► w ── c ──►    half-edge as b is, next(b) = c and prev(c) = b.
/// ```
///
/// For a border half-edge, `next`, `face` and `boundary` are all nil. A half-edge that lacks only `next` breaks R1, and so
/// does a walk that ends elsewhere than at a border half-edge. Along one border, either all half-edges store `next` or none
/// does. Each fan of faces gets its own border, so two fans at one vertex break V2. L3 compares the stored origin of `c`
/// with the stored origin of `b`'s twin.
///
/// In a structure without faces, a nil `next` alone makes a border.
///
/// The expectation needs [`open`](crate::validate::Expectation::open), because borders have no face.
///
/// ```
/// use twinedge::validate::adapt::Borders;
/// use twinedge::validate::{Collect, Expectation, Link, Part, Parts, View, validate};
///
/// /// A triangle with one face: half-edges 0, 2 and 4. Their twins 1, 3 and 5 know their origin, and nothing else.
/// struct Triangle;
///
/// impl View for Triangle {
///     fn parts(&self) -> Parts { Parts::NONE.with(Part::Faces) }
///     fn vertex_slots(&self) -> usize { 3 }
///     fn half_edge_slots(&self) -> usize { 6 }
///     fn face_slots(&self) -> usize { 1 }
///     fn origin(&self, h: usize) -> Link { Some([0, 1, 1, 2, 2, 0][h]) }
///     fn twin(&self, h: usize) -> Link { Some(h ^ 1) }
///     fn next(&self, h: usize) -> Link { [Some(2), None, Some(4), None, Some(0), None][h] }
///     fn face(&self, h: usize) -> Link { if h % 2 == 0 { Some(0) } else { None } }
///     fn outer_half_edge(&self, _: usize) -> Link { Some(0) }
/// }
///
/// let mesh = Expectation::surface().open();
/// assert!(!validate(&Triangle, &mesh, Collect::All).is_valid());
/// let closed = Borders::of(&Triangle).unwrap();
/// assert_eq!([1, 3, 5].map(|h| closed.next(h)), [Some(5), Some(1), Some(3)]);
/// assert!(validate(&closed, &mesh, Collect::All).is_valid());
/// ```
#[derive(Clone, Debug)]
pub struct Borders<V> {
    view: V,
    next: Vec<u32>,
    prev: Vec<u32>,
}

impl<V: View> Borders<V> {
    /// Wraps the structure. O(n) time; 8 bytes per half-edge, and 5 more temporarily. `None` if memory runs out, or if the
    /// structure claims more than `u32::MAX - 1` half-edges.
    #[must_use]
    pub fn of(view: V) -> Option<Self> {
        let before = inverse(&view, V::next)?;
        let (mut next, mut prev) = (nils(before.len())?, nils(before.len())?);
        let mut passed = filled(before.len(), false)?;
        for b in live(&view, before.len()).filter(|b| is_border(&view, *b)) {
            let Some(follows) = around(&view, &before, b, &mut passed) else { continue };
            if is_border(&view, follows) {
                (next[b], prev[follows]) = (follows as u32, b as u32);
            }
        }
        Some(Self { view, next, prev })
    }
}

fn is_border<V: View>(view: &V, h: usize) -> bool {
    view.is_half_edge(h) && view.next(h).is_none() && view.face(h).is_none() && view.boundary(h).is_none()
}

/// Turns around the target of a border half-edge to the half-edge without a predecessor. Stops at half-edges that another
/// walk has passed, so all walks together are O(n).
fn around<V: View>(view: &V, before: &[u32], border: usize, passed: &mut [bool]) -> Link {
    let mut arriving = border;
    loop {
        let leaving = view.twin(arriving).filter(|t| *t < before.len())?;
        let Some(previous) = entry(before, leaving) else { return Some(leaving) };
        if core::mem::replace(&mut passed[previous], true) {
            return None;
        }
        arriving = previous;
    }
}

impl<V: View> View for Borders<V> {
    crate::delegate_view!(|this| &this.view; except next, prev);

    fn next(&self, half_edge: usize) -> Link {
        self.view.next(half_edge).or_else(|| entry(&self.next, half_edge))
    }

    fn prev(&self, half_edge: usize) -> Link {
        self.view.prev(half_edge).or_else(|| entry(&self.prev, half_edge))
    }
}
