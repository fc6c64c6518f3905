//! The structures that programs are run on, by name.

mod planted;

use clap::ValueEnum;
pub(crate) use planted::Planted;
use serde::Serialize;
use twinedge::dcel::Dcel;
use twinedge::program::{Kernel, Textbook};
use twinedge::store::{FixedStore, PointerStore};
use twinedge::validate::Expectation;

/// A structure that programs can be run on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub(crate) enum KernelName {
    /// The default store: slotmap keys over columns.
    #[default]
    Slots,
    /// Records joined by raw pointers.
    Pointers,
    /// Fixed arrays, with room for 24 vertices, 40 edges, 40 boundary components and 24 faces.
    Fixed,
    /// The independent model: the structure of the textbooks, records joined by references that are counted.
    Textbook,
    /// A structure with a planted bug: it turns edges the wrong way.
    Planted,
}

/// Something to be done with a structure, of whichever type.
pub(crate) trait Task {
    type Result;

    fn run<K: Kernel>(self, make: fn() -> K, expectation: Expectation) -> Self::Result;
}

impl KernelName {
    /// The stores and the model; not the structure with the bug.
    pub(crate) const SOUND: [Self; 4] = [Self::Slots, Self::Pointers, Self::Fixed, Self::Textbook];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Slots => "slots",
            Self::Pointers => "pointers",
            Self::Fixed => "fixed",
            Self::Textbook => "textbook",
            Self::Planted => "planted",
        }
    }

    /// How the empty structure is made, in Rust, and what it is held to.
    pub(crate) const fn rust(self) -> (&'static str, &'static str) {
        match self {
            Self::Slots => ("Dcel::new()", "Expectation::plane()"),
            Self::Pointers => ("Dcel::<PointerStore>::default()", "Expectation::plane()"),
            Self::Fixed => ("Dcel::<FixedStore<24, 40, 40, 24>>::default()", "Expectation::plane()"),
            Self::Textbook => ("Textbook::new()", "Expectation::plane()"),
            Self::Planted => ("Planted::default()", "Expectation::plane()"),
        }
    }

    /// Does something with the structure of this name.
    pub(crate) fn run<T: Task>(self, task: T) -> T::Result {
        match self {
            Self::Slots => task.run(Dcel::new, Expectation::plane()),
            Self::Pointers => task.run(Dcel::<PointerStore>::default, Expectation::plane()),
            Self::Fixed => task.run(Dcel::<FixedStore<24, 40, 40, 24>>::default, Expectation::plane()),
            Self::Textbook => task.run(Textbook::new, Expectation::plane()),
            Self::Planted => task.run(<Planted>::default, Expectation::plane()),
        }
    }
}
