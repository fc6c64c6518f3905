//! Structures with a planted bug, to see that the engines find it.

use crate::replay::Indexed;
use twinedge::dcel::{Dcel, FaceKey, HalfEdgeKey, Turn, VertexKey};
use twinedge::program::{CornerOf, Refusal, Subject};
use twinedge::validate::View;
use twinedge::{delegate_subject, delegate_view};

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

impl<const PANICS: bool> Planted<PANICS> {
    const fn dcel(&self) -> &Dcel {
        &self.0
    }

    fn run<T>(&mut self, operator: impl FnOnce(&mut Dcel) -> T) -> T {
        operator(&mut self.0)
    }
}

impl<const PANICS: bool> View for Planted<PANICS> {
    delegate_view!(|this| &this.0);
}

impl<const PANICS: bool> Subject for Planted<PANICS> {
    delegate_subject!(Dcel, Self::dcel, Self::run; except flip_edge, move_inner);

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
