//! Structures of different types as one type, for which the engines are compiled once.

use crate::replay::Indexed;
use std::fmt;
use twinedge::dcel::{Dcel, FaceKey, HalfEdgeKey, VertexKey};
use twinedge::program::{CallOf, HandleOf, Refusal, Subject};
use twinedge::validate::View;
use twinedge::{delegate_subject, delegate_view};

/// A structure of any type whose handles are keys: a [`Dcel`](twinedge::dcel::Dcel) over any store, or a wrapper of a `Dcel`.
///
/// An engine that tries several of them is compiled once, not for each. Each query is a call through a pointer.
///
/// ```
/// use twinedge::dcel::Dcel;
/// use twinedge::validate::Expectation;
/// use twinedge_trials::soak::SoakWork;
/// use twinedge_trials::{Erased, Run, Structure, soak};
/// let columns = Structure::new("columns", || Erased::new(Dcel::new()), Expectation::plane());
/// let arrays = || Erased::new(Dcel::new());
/// let arrays = Structure::new("arrays", arrays, Expectation::plane());
/// soak(&[&columns, &arrays], SoakWork { programs: 5, steps: 20, seed: 1 }, &Run::default()).into_result()?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Erased(Box<dyn Keyed>);

trait Keyed: Indexed<Vertex = VertexKey, HalfEdge = HalfEdgeKey, Face = FaceKey> {
    fn boxed_clone(&self) -> Box<dyn Keyed>;
}

impl<K> Keyed for K
where
    K: Indexed<Vertex = VertexKey, HalfEdge = HalfEdgeKey, Face = FaceKey> + Clone + 'static,
{
    fn boxed_clone(&self) -> Box<dyn Keyed> {
        Box::new(self.clone())
    }
}

impl Erased {
    /// Wraps this structure, whatever its type.
    #[must_use]
    pub fn new<K>(structure: K) -> Self
    where
        K: Indexed<Vertex = VertexKey, HalfEdge = HalfEdgeKey, Face = FaceKey> + Clone + 'static,
    {
        Self(Box::new(structure))
    }

    fn structure(&self) -> &dyn Keyed {
        &*self.0
    }
}

impl Clone for Erased {
    fn clone(&self) -> Self {
        Self(self.0.boxed_clone())
    }
}

impl fmt::Debug for Erased {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Erased").finish_non_exhaustive()
    }
}

impl View for Erased {
    delegate_view!(|this| this.structure());
}

impl Subject for Erased {
    delegate_subject!(Dcel, |this| this.structure());

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        self.0.apply(call)
    }
}

impl Indexed for Erased {
    fn index(&self, handle: HandleOf<Self>) -> Option<usize> {
        self.0.index(handle)
    }
}
