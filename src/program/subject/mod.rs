//! The trait of a structure that programs drive: its handles, a few questions, and the operators.

mod audited;
#[doc(hidden)]
pub mod by_index;
mod dcel;
mod delegate;

use crate::dcel::{Corner, Side, Turn};
use crate::validate::View;
use core::fmt::Debug;
use thiserror::Error;

/// A corner of the subject `K`, named by handles. It also names the one boundary component on which it lies, and the one
/// face.
///
/// No structure is asked for a handle of a boundary component: implementations may keep either record when two are merged,
/// as [`Dcel`](crate::dcel::Dcel) keeps the cheaper one. What lies on a corner is the same in every structure.
pub type CornerOf<K> = Corner<<K as Subject>::HalfEdge, <K as Subject>::Vertex>;

/// Why a subject refused: the category of its error, which is what subjects have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Error)]
#[non_exhaustive]
pub enum Refusal {
    /// A handle names nothing (any more).
    #[error("a handle is stale")]
    Stale,
    /// The vertex has half-edges.
    #[error("the vertex is not isolated")]
    NotIsolated,
    /// The two corners lie in different faces.
    #[error("the corners lie in different faces")]
    FacesDiffer,
    /// The two corners are at different vertices.
    #[error("the corners are at different vertices")]
    VerticesDiffer,
    /// A boundary component chosen for the new face is not another inner one of the old face.
    #[error("a boundary component chosen for the new face is not another inner one of the old face")]
    NotInner,
    /// The boundary component is an outer one.
    #[error("an outer boundary component cannot be moved")]
    IsOuter,
    /// The target has another degree than 2.
    #[error("the target does not have degree 2")]
    DegreeNotTwo,
    /// The edge starts and ends at the same vertex.
    #[error("the edge is a loop")]
    Loop,
    /// Both sides of the edge lie on one boundary component.
    #[error("the edge has the same boundary component on both sides")]
    NotSeparating,
    /// The face lies inside what was to be moved into it.
    #[error("the face lies inside what is to be moved into it")]
    InsideItself,
    /// A corner or a side of the edge is on the border: no face of the structure is there.
    #[error("no face is there: it is on the border")]
    Border,
    /// A face would have several boundary components or none, and faces of this structure are discs.
    #[error("a face would not be a disc any more")]
    NotDisc,
    /// A face at the edge is no triangle.
    #[error("a face at the edge is not a triangle")]
    NotTriangle,
    /// Two vertices would be joined by two edges, or the surface would be another one: the link condition does not hold.
    #[error("the triangulation would not be simple any more")]
    NotSimple,
    /// A policy of the subject's own does not allow it.
    #[error("a policy does not allow it")]
    Policy,
    /// The subject has no room for more records.
    #[error("there is no room")]
    Full,
    /// The subject does not have this operator.
    #[error("the operator is not supported")]
    Unsupported,
}

/// A structure that programs can drive: handles, questions and operators.
///
/// The meaning of each operator is that of the method of the same name of [`Dcel`](crate::dcel::Dcel), where its
/// picture is. Those whose names begin with `mesh_` are defined by steps of the others, in [`mesh`](crate::program::mesh).
///
/// # Structures that do less
///
/// Every operator has a default body: it answers [`Refusal::Unsupported`], as an operator that the structure does not have
/// must. So a structure that can only turn edges writes `flip_edge` and the questions; and where the indices of its
/// [`View`] are good handles, [`subject_by_index!`](crate::subject_by_index) writes the questions, and the operators of meshes from
/// their names. The example `mesh_conformance` is such a structure.
///
/// A face may be missing: half-edges on the border of a mesh have none. [`Subject::face_of`] answers [`Refusal::Border`]
/// there, and operators that need the face refuse with it. A structure that keeps no faces, or no `next` on the
/// border, answers these questions with [`Refusal::Unsupported`].
///
/// # Refusing
///
/// An operator that refuses leaves the structure as it was. So that two subjects refuse for the same reason where
/// several apply, the order is fixed: first each argument by itself, in their order ([`Stale`](Refusal::Stale), then
/// [`NotIsolated`](Refusal::NotIsolated) for a corner said to be that of an isolated vertex); then what the operator
/// asks of them together, in the order given there. [`Full`](Refusal::Full) may come anywhere. For structures with a border
/// and for those whose faces are discs there are two more, in the order that
/// [`PointerModel::from_view`](crate::program::PointerModel::from_view) lists.
///
/// # The view
///
/// [`View`] is the same structure as the validator sees it. Its indices need not have anything to do with the handles,
/// except that [`Subject::half_edge_at`] and [`Subject::vertex_at`] lead from the ones to the others where programs begin with
/// a structure that is not empty. A structure with keys keeps an [`Index`](crate::validate::adapt::Index) of all keys seen so far,
/// [extends](crate::validate::adapt::Index::extend) it after each operator, and answers `is_vertex`, `is_half_edge` and `is_face` by
/// asking whether the key is live.
#[allow(unused_variables, reason = "the default bodies need no arguments, whose names are documentation")]
pub trait Subject: View {
    /// Names a vertex. Like all handles it must never name another one once its vertex is gone.
    type Vertex: Copy + Eq + Debug;
    /// Names a half-edge.
    type HalfEdge: Copy + Eq + Debug;
    /// Names a face.
    type Face: Copy + Eq + Debug;

    /// True if half-edges are found again after each operator, as [`mesh::Named`](crate::program::mesh::Named) does. Only the advice in
    /// messages depends on it.
    #[doc(hidden)]
    fn is_named(&self) -> bool {
        false
    }

    /// The unbounded face; none, as by default, if the structure has no such face.
    fn unbounded_face(&self) -> Option<Self::Face> {
        None
    }

    /// The handle of the half-edge with this index in the view. By default there is none: programs then begin with the empty
    /// map.
    fn half_edge_at(&self, index: usize) -> Option<Self::HalfEdge> {
        None
    }

    /// The handle of the vertex with this index in the view. Only isolated vertices are asked for.
    fn vertex_at(&self, index: usize) -> Option<Self::Vertex> {
        None
    }

    /// The face in which a corner lies.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`NotIsolated`](Refusal::NotIsolated); [`Border`](Refusal::Border).
    fn face_of(&self, corner: CornerOf<Self>) -> Result<Self::Face, Refusal>;

    /// The vertex where a half-edge starts.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale).
    fn origin_of(&self, half_edge: Self::HalfEdge) -> Result<Self::Vertex, Refusal>;

    /// The other half-edge of the same edge.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale).
    fn twin_of(&self, half_edge: Self::HalfEdge) -> Result<Self::HalfEdge, Refusal>;

    /// The half-edge that follows on the same cycle.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale).
    fn next_of(&self, half_edge: Self::HalfEdge) -> Result<Self::HalfEdge, Refusal>;

    /// Adds an isolated vertex in a face, and gives it.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`Full`](Refusal::Full).
    fn add_isolated_vertex(&mut self, face: Self::Face) -> Result<Self::Vertex, Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Removes an isolated vertex.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`NotIsolated`](Refusal::NotIsolated).
    fn remove_isolated_vertex(&mut self, vertex: Self::Vertex) -> Result<(), Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Connects two corners of one face by a new edge, and gives the half-edge from the first to the second.
    ///
    /// If it splits the face, the new face lies to the `new_face` side of that half-edge, and the inner boundary
    /// components named in `inner` (one named twice counts once) go there. A bridge needs neither, but a stale handle
    /// is refused even so.
    ///
    /// # Errors
    /// For `from`, `to`, and each of `inner`: [`Stale`](Refusal::Stale), [`NotIsolated`](Refusal::NotIsolated). Then
    /// [`FacesDiffer`](Refusal::FacesDiffer); then, if the face is split, [`NotInner`](Refusal::NotInner).
    fn connect(
        &mut self,
        from: CornerOf<Self>,
        to: CornerOf<Self>,
        new_face: Side,
        inner: &[CornerOf<Self>],
    ) -> Result<Self::HalfEdge, Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Removes an edge, and gives the handle of the face that was removed, if two became one. The subject
    /// may keep either of the two, but the unbounded face stays.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`Full`](Refusal::Full).
    fn remove_edge(&mut self, half_edge: Self::HalfEdge) -> Result<Option<Self::Face>, Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Puts a new vertex on an edge. The given half-edge keeps its origin; gives the new half-edge that follows it.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`Full`](Refusal::Full).
    fn split_edge(&mut self, half_edge: Self::HalfEdge) -> Result<Self::HalfEdge, Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Joins the edge of a half-edge with the one that follows it. The given half-edge keeps its origin; the following
    /// edge and the vertex between them are removed.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); then [`DegreeNotTwo`](Refusal::DegreeNotTwo); then [`Loop`](Refusal::Loop).
    fn join_edges(&mut self, half_edge: Self::HalfEdge) -> Result<(), Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Splits a vertex in two, and gives the new half-edge between them: to its target go the half-edges met when
    /// turning counter-clockwise from the first corner to the second, none if these are the same. Either of the
    /// two vertices may be the new one.
    ///
    /// # Errors
    /// For `from` and `to`: [`Stale`](Refusal::Stale), [`NotIsolated`](Refusal::NotIsolated). Then
    /// [`VerticesDiffer`](Refusal::VerticesDiffer).
    fn split_vertex(&mut self, from: CornerOf<Self>, to: CornerOf<Self>) -> Result<Self::HalfEdge, Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Contracts an edge to a point, and gives the handle of the vertex that was removed. The subject may keep
    /// either of the two.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); then [`Loop`](Refusal::Loop).
    fn contract_edge(&mut self, half_edge: Self::HalfEdge) -> Result<Self::Vertex, Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Turns an edge one step inside the two faces that it separates.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); then [`NotSeparating`](Refusal::NotSeparating).
    fn flip_edge(&mut self, half_edge: Self::HalfEdge, turn: Turn) -> Result<(), Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Moves the inner boundary component on which the corner lies to another face, with all that lies inside. Moving
    /// it to the face where it is does nothing.
    ///
    /// # Errors
    /// For `inner`: [`Stale`](Refusal::Stale), [`NotIsolated`](Refusal::NotIsolated); for `face`:
    /// [`Stale`](Refusal::Stale). Then [`IsOuter`](Refusal::IsOuter); then [`InsideItself`](Refusal::InsideItself).
    fn move_inner(&mut self, inner: CornerOf<Self>, face: Self::Face) -> Result<(), Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Turns an edge inside the two triangles that it separates. See [`mesh::flip_edge`](crate::program::mesh::flip_edge).
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`Border`](Refusal::Border); [`NotTriangle`](Refusal::NotTriangle);
    /// [`NotSimple`](Refusal::NotSimple).
    fn mesh_flip_edge(&mut self, half_edge: Self::HalfEdge) -> Result<(), Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Puts a new vertex on an edge and joins it with the vertex opposite in each triangle. See
    /// [`mesh::split_edge`](crate::program::mesh::split_edge).
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`Border`](Refusal::Border); [`NotTriangle`](Refusal::NotTriangle);
    /// [`Full`](Refusal::Full).
    fn mesh_split_edge(&mut self, half_edge: Self::HalfEdge) -> Result<(), Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Collapses an edge together with its triangles. See [`mesh::collapse_edge`](crate::program::mesh::collapse_edge).
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`Border`](Refusal::Border); [`NotTriangle`](Refusal::NotTriangle);
    /// [`NotSimple`](Refusal::NotSimple).
    fn mesh_collapse_edge(&mut self, half_edge: Self::HalfEdge) -> Result<(), Refusal> {
        Err(Refusal::Unsupported)
    }

    /// Puts a new vertex into the triangle to the left of a half-edge and joins it with its corners. See
    /// [`mesh::split_face`](crate::program::mesh::split_face).
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`Border`](Refusal::Border); [`NotTriangle`](Refusal::NotTriangle);
    /// [`Full`](Refusal::Full).
    fn mesh_split_face(&mut self, half_edge: Self::HalfEdge) -> Result<(), Refusal> {
        Err(Refusal::Unsupported)
    }
}
