//! An audited `Dcel` as a subject.

use super::subject::{CornerOf, Refusal, Subject};
use crate::dcel::{Audited, Corner, Dcel, Side, Turn};
use crate::delegate_view;
use crate::store::{FaceKey, HalfEdgeKey, Store, VertexKey, WatchedStore};
use crate::validate::View;

impl<S: Store> View for Audited<S> {
    delegate_view!(|this| this.dcel());
}

/// Runs an operator.
///
/// # Panics
/// Panics with the report if a rule is broken after it.
fn change<S: Store, T>(
    audited: &mut Audited<S>,
    operator: impl FnOnce(&mut Dcel<WatchedStore<S>>) -> Result<T, Refusal>,
) -> Result<T, Refusal> {
    match audited.change(operator) {
        Ok(answer) => answer,
        Err(report) => panic!("{report}"),
    }
}

macro_rules! operators {
    ($($name:ident($($argument:ident: $type:ty),*) -> $answer:ty;)*) => {
        $(fn $name(&mut self, $($argument: $type),*) -> Result<$answer, Refusal> {
            change(self, |dcel| Subject::$name(dcel, $($argument),*))
        })*
    };
}

macro_rules! questions {
    ($($name:ident($($argument:ident: $type:ty),*) -> $answer:ty;)*) => {
        $(fn $name(&self, $($argument: $type),*) -> $answer {
            Subject::$name(self.dcel(), $($argument),*)
        })*
    };
}

/// # Panics
/// The operators panic with the report if a rule is broken after them. See [`Audited::change`] for the report as an error.
impl<S: Store> Subject for Audited<S> {
    type Vertex = VertexKey;
    type HalfEdge = HalfEdgeKey;
    type Face = FaceKey;

    questions! {
        unbounded_face() -> Option<FaceKey>;
        half_edge_at(index: usize) -> Option<HalfEdgeKey>;
        vertex_at(index: usize) -> Option<VertexKey>;
        face_of(corner: CornerOf<Self>) -> Result<FaceKey, Refusal>;
        origin_of(half_edge: HalfEdgeKey) -> Result<VertexKey, Refusal>;
        twin_of(half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, Refusal>;
        next_of(half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, Refusal>;
    }

    operators! {
        add_isolated_vertex(face: FaceKey) -> VertexKey;
        remove_isolated_vertex(vertex: VertexKey) -> ();
        connect(from: Corner, to: Corner, new_face: Side, inner: &[Corner]) -> HalfEdgeKey;
        remove_edge(half_edge: HalfEdgeKey) -> Option<FaceKey>;
        split_edge(half_edge: HalfEdgeKey) -> HalfEdgeKey;
        join_edges(half_edge: HalfEdgeKey) -> ();
        split_vertex(from: Corner, to: Corner) -> HalfEdgeKey;
        contract_edge(half_edge: HalfEdgeKey) -> VertexKey;
        flip_edge(half_edge: HalfEdgeKey, turn: Turn) -> ();
        move_inner(inner: Corner, face: FaceKey) -> ();
        mesh_flip_edge(half_edge: HalfEdgeKey) -> ();
        mesh_split_edge(half_edge: HalfEdgeKey) -> ();
        mesh_split_face(half_edge: HalfEdgeKey) -> ();
        mesh_collapse_edge(half_edge: HalfEdgeKey) -> ();
    }
}
