//! Structures with a planted bug, to test that the engines find it.

use crate::replay::Indexed;
use twinedge::dcel::Dcel;
use twinedge::program::{Call, CallOf, HandleOf, Refusal, Subject};
use twinedge::validate::View;
use twinedge::{delegate_subject, delegate_view};

/// A [`Dcel`] with a bug. `Planted<false>` turns edges the wrong way and keeps every rule; `Planted<true>` panics when
/// it moves a boundary component.
///
/// ```
/// use twinedge::validate::Expectation;
/// use twinedge_trials::planted::Planted;
/// use twinedge_trials::prove::ProveWork;
/// use twinedge_trials::{Run, Structure, prove};
/// let panics = Structure::new("panics", Planted::<true>::default, Expectation::plane());
/// let outcome = prove(&panics, ProveWork { edges: 1 }, &Run::default())?;
/// assert!(outcome.findings[0].message.starts_with("panicked: a planted panic"));
/// assert!(!outcome.is_ok());
/// # Ok::<(), twinedge_trials::StructureError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Planted<const PANICS: bool>(Dcel);

impl<const PANICS: bool> View for Planted<PANICS> {
    delegate_view!(|this| &this.0);
}

impl<const PANICS: bool> Subject for Planted<PANICS> {
    delegate_subject!(Dcel, |this| &this.0);

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        match call {
            Call::FlipEdge { half_edge, turn } => {
                self.0.apply(Call::FlipEdge { half_edge, turn: if PANICS { turn } else { turn.reversed() } })
            }
            Call::MoveInner { .. } => {
                let done = self.0.apply(call);
                assert!(!PANICS || done.is_err(), "a planted panic");
                done
            }
            _ => self.0.apply(call),
        }
    }
}

impl<const PANICS: bool> Indexed for Planted<PANICS> {
    fn index(&self, handle: HandleOf<Self>) -> Option<usize> {
        self.0.index(handle)
    }
}
