//! What a structure implements to be driven by programs: its handles, a few questions, and the operators.

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
    /// What was to go to the new face is no other inner boundary component of the old one.
    #[error("what is to go to the new face is no other inner boundary component of the old one")]
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
/// picture is. An operator that the structure does not have answers [`Refusal::Unsupported`].
///
/// # Refusing
///
/// An operator that refuses leaves the structure as it was. So that two subjects refuse for the same reason where
/// several apply, the order is fixed: first each argument by itself, in their order ([`Stale`](Refusal::Stale), then
/// [`NotIsolated`](Refusal::NotIsolated) for a corner said to be that of an isolated vertex); then what the operator
/// asks of them together, in the order given there. [`Full`](Refusal::Full) may come anywhere.
///
/// # The view
///
/// [`View`] is the same structure as the validator sees it. Its indices need not have anything to do with the handles.
/// To run programs nothing of it is needed; [`conformance::run`](super::conformance::run) needs faces, their inner
/// boundary components and the unbounded face, by which it tells maps apart.
pub trait Subject: View {
    /// Names a vertex. Like all handles it must never name another one once its vertex is gone.
    type Vertex: Copy + Eq + Debug;
    /// Names a half-edge.
    type HalfEdge: Copy + Eq + Debug;
    /// Names a face.
    type Face: Copy + Eq + Debug;
    /// What the operators refuse with. [`Refusal`] itself will do.
    type Error: Debug;

    /// The category of an error.
    fn refusal(error: &Self::Error) -> Refusal;

    /// The unbounded face.
    fn unbounded_face(&self) -> Self::Face;

    /// The face in which a corner lies.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`NotIsolated`](Refusal::NotIsolated).
    fn face_of(&self, corner: CornerOf<Self>) -> Result<Self::Face, Self::Error>;

    /// The vertex where a half-edge starts.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale).
    fn origin_of(&self, half_edge: Self::HalfEdge) -> Result<Self::Vertex, Self::Error>;

    /// The other half-edge of the same edge.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale).
    fn twin_of(&self, half_edge: Self::HalfEdge) -> Result<Self::HalfEdge, Self::Error>;

    /// The half-edge that follows on the same cycle.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale).
    fn next_of(&self, half_edge: Self::HalfEdge) -> Result<Self::HalfEdge, Self::Error>;

    /// Adds an isolated vertex in a face, and gives it.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`Full`](Refusal::Full).
    fn add_isolated_vertex(&mut self, face: Self::Face) -> Result<Self::Vertex, Self::Error>;

    /// Removes an isolated vertex.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`NotIsolated`](Refusal::NotIsolated).
    fn remove_isolated_vertex(&mut self, vertex: Self::Vertex) -> Result<(), Self::Error>;

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
    ) -> Result<Self::HalfEdge, Self::Error>;

    /// Removes an edge, and gives the handle of the face that was removed, if two became one. The subject
    /// may keep either of the two, but the unbounded face stays.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`Full`](Refusal::Full).
    fn remove_edge(&mut self, half_edge: Self::HalfEdge) -> Result<Option<Self::Face>, Self::Error>;

    /// Puts a new vertex on an edge. The given half-edge keeps its origin; gives the new half-edge that follows it.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`Full`](Refusal::Full).
    fn split_edge(&mut self, half_edge: Self::HalfEdge) -> Result<Self::HalfEdge, Self::Error>;

    /// Joins the edge of a half-edge with the one that follows it. The given half-edge keeps its origin; the following
    /// edge and the vertex between them are removed.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); then [`DegreeNotTwo`](Refusal::DegreeNotTwo); then [`Loop`](Refusal::Loop).
    fn join_edges(&mut self, half_edge: Self::HalfEdge) -> Result<(), Self::Error>;

    /// Splits a vertex in two, and gives the new half-edge between them: to its target go the half-edges met when
    /// turning counter-clockwise from the first corner to the second, none if these are the same. Either of the
    /// two vertices may be the new one.
    ///
    /// # Errors
    /// For `from` and `to`: [`Stale`](Refusal::Stale), [`NotIsolated`](Refusal::NotIsolated). Then
    /// [`VerticesDiffer`](Refusal::VerticesDiffer).
    fn split_vertex(&mut self, from: CornerOf<Self>, to: CornerOf<Self>) -> Result<Self::HalfEdge, Self::Error>;

    /// Contracts an edge to a point, and gives the handle of the vertex that was removed. The subject may keep
    /// either of the two.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); then [`Loop`](Refusal::Loop).
    fn contract_edge(&mut self, half_edge: Self::HalfEdge) -> Result<Self::Vertex, Self::Error>;

    /// Turns an edge one step inside the two faces that it separates.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); then [`NotSeparating`](Refusal::NotSeparating).
    fn flip_edge(&mut self, half_edge: Self::HalfEdge, turn: Turn) -> Result<(), Self::Error>;

    /// Moves the inner boundary component on which the corner lies to another face, with all that lies inside. Moving
    /// it to the face where it is does nothing.
    ///
    /// # Errors
    /// For `inner`: [`Stale`](Refusal::Stale), [`NotIsolated`](Refusal::NotIsolated); for `face`:
    /// [`Stale`](Refusal::Stale). Then [`IsOuter`](Refusal::IsOuter); then [`InsideItself`](Refusal::InsideItself).
    fn move_inner(&mut self, inner: CornerOf<Self>, face: Self::Face) -> Result<(), Self::Error>;
}
