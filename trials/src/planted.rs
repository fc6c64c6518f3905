//! Structures with a planted bug, to see that the engines find it.

use crate::replay::Indexed;
use twinedge::dcel::{Dcel, FaceKey, HalfEdgeKey, Side, Turn, VertexKey};
use twinedge::program::{CornerOf, Refusal, Subject};
use twinedge::validate::{BoundaryPlace, Link, Parts, Start, View};

/// A [`Dcel`] with a bug. `Planted<false>` turns edges the wrong way and keeps every rule; `Planted<true>` panics when a boundary
/// component is moved.
///
/// ```
/// use twinedge::validate::Expectation;
/// use twinedge_trials::planted::Planted;
/// use twinedge_trials::prove::ProveWork;
/// use twinedge_trials::{Outcome, Run, Structure, prove};
/// let panics = Structure::new("panics", Planted::<true>::default, Expectation::plane());
/// let outcome = prove(&panics, ProveWork { edges: 1 }, &Run::default())?;
/// assert!(outcome.findings[0].message.starts_with("panicked: a planted panic"));
/// assert!(!outcome.is_ok());
/// # Ok::<(), twinedge_trials::StructureError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Planted<const PANICS: bool>(Dcel);

macro_rules! view_as_it_is {
    ($($name:ident($($arg:ident),*) -> $answer:ty;)*) => {
        impl<const PANICS: bool> View for Planted<PANICS> {
            $(fn $name(&self $(, $arg: usize)*) -> $answer { View::$name(&self.0 $(, $arg)*) })*
        }
    };
}

view_as_it_is! {
    parts() -> Parts;
    vertex_slots() -> usize;
    half_edge_slots() -> usize;
    boundary_slots() -> usize;
    face_slots() -> usize;
    is_vertex(v) -> bool;
    is_half_edge(h) -> bool;
    is_boundary(b) -> bool;
    is_face(f) -> bool;
    origin(h) -> Link;
    twin(h) -> Link;
    next(h) -> Link;
    prev(h) -> Link;
    boundary(h) -> Link;
    leaving(v) -> Link;
    isolated(v) -> Link;
    boundary_face(b) -> Link;
    boundary_start(b) -> Option<Start>;
    boundary_place(b) -> Option<BoundaryPlace>;
    outer(f) -> Link;
    inner_count(f) -> usize;
    inner(f, position) -> Link;
}

macro_rules! operators_as_they_are {
    ($($name:ident($($arg:ident: $argument:ty),*) -> $answer:ty;)*) => {
        $(fn $name(&mut self $(, $arg: $argument)*) -> Result<$answer, Refusal> {
            Subject::$name(&mut self.0 $(, $arg)*)
        })*
    };
}

impl<const PANICS: bool> Subject for Planted<PANICS> {
    type Vertex = VertexKey;
    type HalfEdge = HalfEdgeKey;
    type Face = FaceKey;
    fn unbounded_face(&self) -> Option<FaceKey> {
        Subject::unbounded_face(&self.0)
    }
    fn half_edge_at(&self, index: usize) -> Option<HalfEdgeKey> {
        Subject::half_edge_at(&self.0, index)
    }
    fn vertex_at(&self, index: usize) -> Option<VertexKey> {
        Subject::vertex_at(&self.0, index)
    }
    fn face_of(&self, corner: CornerOf<Self>) -> Result<FaceKey, Refusal> {
        Subject::face_of(&self.0, corner)
    }
    fn origin_of(&self, half_edge: HalfEdgeKey) -> Result<VertexKey, Refusal> {
        Subject::origin_of(&self.0, half_edge)
    }
    fn twin_of(&self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, Refusal> {
        Subject::twin_of(&self.0, half_edge)
    }
    fn next_of(&self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, Refusal> {
        Subject::next_of(&self.0, half_edge)
    }
    operators_as_they_are! {
        add_isolated_vertex(face: FaceKey) -> VertexKey;
        remove_isolated_vertex(vertex: VertexKey) -> ();
        connect(from: CornerOf<Self>, to: CornerOf<Self>, side: Side, inner: &[CornerOf<Self>]) -> HalfEdgeKey;
        remove_edge(half_edge: HalfEdgeKey) -> Option<FaceKey>;
        split_edge(half_edge: HalfEdgeKey) -> HalfEdgeKey;
        join_edges(half_edge: HalfEdgeKey) -> ();
        split_vertex(from: CornerOf<Self>, to: CornerOf<Self>) -> HalfEdgeKey;
        contract_edge(half_edge: HalfEdgeKey) -> VertexKey;
    }
    fn flip_edge(&mut self, half_edge: HalfEdgeKey, turn: Turn) -> Result<(), Refusal> {
        Subject::flip_edge(&mut self.0, half_edge, if PANICS { turn } else { turn.reversed() })
    }
    fn move_inner(&mut self, inner: CornerOf<Self>, face: FaceKey) -> Result<(), Refusal> {
        let done = Subject::move_inner(&mut self.0, inner, face);
        assert!(!PANICS || done.is_err(), "a planted panic");
        done
    }
}

impl<const PANICS: bool> Indexed for Planted<PANICS> {
    fn vertex_index(&self, vertex: VertexKey) -> Option<usize> {
        self.0.vertex_index(vertex)
    }
    fn half_edge_index(&self, half_edge: HalfEdgeKey) -> Option<usize> {
        self.0.half_edge_index(half_edge)
    }
    fn face_index(&self, face: FaceKey) -> Option<usize> {
        self.0.face_index(face)
    }
}
