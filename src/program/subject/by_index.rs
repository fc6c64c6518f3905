//! Handles that are the indices of the view.

/// Writes the types and the questions of a [`Subject`](crate::program::Subject) whose handles are the indices of its
/// [`View`](crate::validate::View). It stands inside `impl Subject for …`, before the operators that the structure has.
///
/// Operators that take a half-edge and give nothing, as those of meshes do, can be named in it, each with the method of the
/// structure that does it: `mesh_flip_edge => Self::flip`. The method takes `&mut self` and the index, may give anything, which is
/// dropped, and its error becomes a [`Refusal`](crate::program::Refusal) by `From`.
///
/// Operators must leave half-edges at their indices; [`mesh::Named`](crate::program::mesh::Named) is for meshes that move them.
///
/// The unbounded face is the default: none. If the structure uses the indices of removed records again, stale handles cannot
/// be told from live ones: see [`Conformance::without_stale_handles`](crate::program::conformance::Conformance::without_stale_handles).
///
/// The questions are written so: a half-edge whose slot is empty is [`Stale`](crate::program::Refusal::Stale); where `next` is nil,
/// and where half-edges keep neither face nor boundary component and the structure has no slots for faces,
/// [`Unsupported`](crate::program::Refusal::Unsupported); a half-edge without face is on the
/// [`Border`](crate::program::Refusal::Border).
///
/// ```
/// use twinedge::program::{Corner, Refusal, Subject};
/// use twinedge::validate::{Table, View};
/// use twinedge::{delegate_view, subject_by_index};
///
/// struct Mine(Table);
/// impl View for Mine {
///     delegate_view!(|this| &this.0);
/// }
/// impl Subject for Mine {
///     subject_by_index!();
/// }
///
/// // A loop on a sphere.
/// let mine = Mine("V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 0 h0 o 1 h1 o F 2 0 0 1 0".parse()?);
/// assert_eq!(mine.twin_of(0), Ok(1));
/// assert_eq!(mine.face_of(Corner::At(1)), Ok(1));
/// assert_eq!(mine.twin_of(2), Err(Refusal::Stale));
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
#[macro_export]
macro_rules! subject_by_index {
    ($($operator:ident => $method:expr),* $(,)?) => {
        type Vertex = usize;
        type HalfEdge = usize;
        type Face = usize;

        fn half_edge_at(&self, index: usize) -> Option<usize> {
            Some(index)
        }
        fn vertex_at(&self, index: usize) -> Option<usize> {
            Some(index)
        }
        fn face_of(&self, corner: $crate::program::Corner<usize, usize>) -> Result<usize, $crate::program::Refusal> {
            $crate::program::by_index::face_of(self, corner)
        }
        fn origin_of(&self, half_edge: usize) -> Result<usize, $crate::program::Refusal> {
            $crate::program::by_index::link(self, half_edge, $crate::validate::View::origin)
        }
        fn twin_of(&self, half_edge: usize) -> Result<usize, $crate::program::Refusal> {
            $crate::program::by_index::link(self, half_edge, $crate::validate::View::twin)
        }
        fn next_of(&self, half_edge: usize) -> Result<usize, $crate::program::Refusal> {
            $crate::program::by_index::link(self, half_edge, $crate::validate::View::next)
        }
        $(fn $operator(&mut self, half_edge: usize) -> Result<(), $crate::program::Refusal> {
            match $method(self, half_edge) {
                Ok(_) => Ok(()),
                Err(refused) => Err($crate::program::Refusal::from(refused)),
            }
        })*
    };
}

use super::Refusal;
use crate::dcel::Corner;
use crate::program::pointer_model::view_face_of;
use crate::validate::{Link, Start, View};

/// Tells whether the slot holds a half-edge.
fn is_live<V: View>(view: &V, half_edge: usize) -> bool {
    half_edge < view.half_edge_slots() && view.is_half_edge(half_edge)
}

/// A link of a half-edge.
#[doc(hidden)]
pub fn link<V: View>(view: &V, half_edge: usize, kept: fn(&V, usize) -> Link) -> Result<usize, Refusal> {
    if !is_live(view, half_edge) {
        return Err(Refusal::Stale);
    }
    kept(view, half_edge).ok_or(Refusal::Unsupported)
}

/// The face in which a corner lies.
#[doc(hidden)]
pub fn face_of<V: View>(view: &V, corner: Corner<usize, usize>) -> Result<usize, Refusal> {
    match corner {
        Corner::At(h) if !is_live(view, h) => Err(Refusal::Stale),
        Corner::At(_) if view.face_slots() == 0 => Err(Refusal::Unsupported),
        Corner::At(h) => view_face_of(view, h).ok_or(Refusal::Border),
        Corner::Isolated(v) if v >= view.vertex_slots() || !view.is_vertex(v) => Err(Refusal::Stale),
        Corner::Isolated(v) => {
            let leaves = |h| is_live(view, h) && view.origin(h) == Some(v);
            if (0..view.half_edge_slots()).any(leaves) {
                return Err(Refusal::NotIsolated);
            }
            let lists = |f: &usize| {
                let start = |position| match view.inner(*f, position) {
                    Some(boundary) => view.boundary_start(boundary),
                    None => view.inner_start(*f, position),
                };
                view.is_face(*f) && (0..view.inner_count(*f)).any(|i| start(i) == Some(Start::Vertex(v)))
            };
            (0..view.face_slots()).find(lists).ok_or(Refusal::Unsupported)
        }
    }
}
