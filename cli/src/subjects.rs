//! The structures that programs are run on, by name.

mod planted;

use clap::ValueEnum;
pub(crate) use planted::Planted;
use serde::Serialize;
use twinedge::dcel::Dcel;
use twinedge::program::{RotationSystem, Subject};
use twinedge::store::{FixedStore, PointerStore, Store};
use twinedge::validate::{Expectation, View};

/// A structure that programs can be run on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub(crate) enum SubjectName {
    /// The default store: slotmap keys over columns.
    #[default]
    Slots,
    /// Records joined by raw pointers.
    Pointers,
    /// Fixed arrays, with room for 24 vertices, 40 edges, 40 boundary components and 24 faces.
    Fixed,
    /// The second independent model: a rotation system.
    RotationSystem,
    /// A structure with a planted bug: it turns edges the wrong way.
    Planted,
    /// A structure with a planted bug: it panics when a boundary component is moved.
    Panicking,
}

/// A structure of which it is known by which index the validator sees what a handle names. Of a stale one, by none.
pub(crate) trait Indexed: Subject {
    fn vertex_index(&self, vertex: Self::Vertex) -> Option<usize>;
    fn half_edge_index(&self, half_edge: Self::HalfEdge) -> Option<usize>;
    fn face_index(&self, face: Self::Face) -> Option<usize>;
}

impl<S: Store> Indexed for Dcel<S> {
    fn vertex_index(&self, vertex: Self::Vertex) -> Option<usize> {
        self.vertex(vertex).ok().map(|v| v.index())
    }
    fn half_edge_index(&self, half_edge: Self::HalfEdge) -> Option<usize> {
        self.half_edge(half_edge).ok().map(|h| h.index())
    }
    fn face_index(&self, face: Self::Face) -> Option<usize> {
        self.face(face).ok().map(|f| f.index())
    }
}

impl Indexed for RotationSystem {
    fn vertex_index(&self, vertex: usize) -> Option<usize> {
        self.is_vertex(vertex).then_some(vertex)
    }
    fn half_edge_index(&self, half_edge: usize) -> Option<usize> {
        self.is_half_edge(half_edge).then_some(half_edge)
    }
    fn face_index(&self, face: usize) -> Option<usize> {
        self.is_face(face).then_some(face)
    }
}

/// Something to be done with a structure, of whichever type.
pub(crate) trait Task {
    type Result;

    fn run<K: Indexed>(self, make: fn() -> K, expectation: Expectation) -> Self::Result;
}

impl SubjectName {
    /// The stores and the second model; not the structures with a bug.
    pub(crate) const SOUND: [Self; 4] = [Self::Slots, Self::Pointers, Self::Fixed, Self::RotationSystem];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Slots => "slots",
            Self::Pointers => "pointers",
            Self::Fixed => "fixed",
            Self::RotationSystem => "model",
            Self::Planted => "planted",
            Self::Panicking => "panicking",
        }
    }

    /// Does something with the structure of this name.
    pub(crate) fn run<T: Task>(self, task: T) -> T::Result {
        match self {
            Self::Slots => task.run(Dcel::new, Expectation::plane()),
            Self::Pointers => task.run(Dcel::<PointerStore>::default, Expectation::plane()),
            Self::Fixed => task.run(Dcel::<FixedStore<24, 40, 40, 24>>::default, Expectation::plane()),
            Self::RotationSystem => task.run(RotationSystem::new, RotationSystem::expectation()),
            Self::Planted => task.run(Planted::<false>::default, Expectation::plane()),
            Self::Panicking => task.run(Planted::<true>::default, Expectation::plane()),
        }
    }
}
