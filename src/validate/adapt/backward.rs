//! An adapter for structures whose cycles are linked backwards.

use super::cycles::{entry, inverse};
use crate::validate::structure::{Link, Part, Parts, View};
use alloc::vec::Vec;

/// A structure whose half-edges store `prev` but not `next`; `next` is derived as the inverse of `prev`.
///
/// If two half-edges have the same `prev`, some half-edge has no `next`, which breaks R1; L2 is also broken, at the second
/// of the two. (The reverse, `next` without `prev`, needs no adapter: [`parts`](View::parts) omits [`Part::Prev`].)
///
/// ```
/// use twinedge::validate::adapt::Backward;
/// use twinedge::validate::{Collect, Expectation, Link, Part, Parts, Rule, View, validate};
///
/// /// A triangle, both of its sides.
/// struct Triangle {
///     prev: [usize; 6],
/// }
///
/// impl View for Triangle {
///     fn parts(&self) -> Parts { Parts::NONE.with(Part::Prev) }
///     fn vertex_slots(&self) -> usize { 3 }
///     fn half_edge_slots(&self) -> usize { 6 }
///     fn origin(&self, h: usize) -> Link { Some([0, 1, 1, 2, 2, 0][h]) }
///     fn twin(&self, h: usize) -> Link { Some(h ^ 1) }
///     fn next(&self, _: usize) -> Link { None }
///     fn prev(&self, h: usize) -> Link { Some(self.prev[h]) }
/// }
///
/// let expectation = Expectation::plane();
/// let right = Triangle { prev: [4, 3, 0, 5, 2, 1] };
/// assert!(validate(&Backward::of(&right).unwrap(), &expectation, Collect::All).is_valid());
/// let wrong = Triangle { prev: [4, 3, 0, 5, 0, 1] };
/// let report = validate(&Backward::of(&wrong).unwrap(), &expectation, Collect::All);
/// assert_eq!(report.broken_rules().collect::<Vec<_>>(), [Rule::R1, Rule::L2]);
/// ```
#[derive(Clone, Debug)]
pub struct Backward<V> {
    view: V,
    next: Vec<u32>,
}

impl<V: View> Backward<V> {
    /// Wraps the structure. O(n) time; 4 bytes per half-edge. `None` if memory runs out, or if the structure claims more
    /// than `u32::MAX - 1` half-edges.
    #[must_use]
    pub fn of(view: V) -> Option<Self> {
        let next = inverse(&view, V::prev)?;
        Some(Self { view, next })
    }
}

impl<V: View> View for Backward<V> {
    crate::delegate_view!(|this| &this.view; except parts, next);

    fn parts(&self) -> Parts {
        self.view.parts().with(Part::Prev)
    }

    fn next(&self, half_edge: usize) -> Link {
        entry(&self.next, half_edge)
    }
}
