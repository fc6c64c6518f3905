//! The named structures that the commands work on.

use clap::ValueEnum;
use twinedge::dcel::{Audited, Dcel, Room};
use twinedge::validate::Expectation;
use twinedge_trials::Structure;
use twinedge_trials::planted::Planted;
use twinedge_trials::replay::Indexed;
use twinedge_trials::soak::Comparable;
use twinedge_trials::{Erased, RawPointers, ReportAudit, Rewound, TestSource};

/// A structure that programs can be run on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum StructureName {
    /// The structure of the library: slotmap keys over columns.
    #[default]
    Slots,
    /// The structure with room for 24 vertices, 40 edges, 40 boundary components and 24 faces.
    Limited,
    /// The structure, validated locally after each operator.
    Audited,
    /// The structure with a history: after each operator some changes are undone and redone, and compared with copies.
    History,
    /// A second independent model: records joined by raw pointers.
    Pointers,
    /// A structure with a planted bug: it turns edges the wrong way.
    Planted,
    /// A structure with a planted bug: it panics when a boundary component is moved.
    Panicking,
}

/// A task for a structure of any type. It is compiled for two types: the second model, and all others as one.
pub(crate) trait Task {
    type Result;

    fn run<K: Indexed + Clone + 'static>(self, structure: Structure<K>) -> Self::Result;
}

const DCEL: &str = "twinedge::dcel::Dcel";
const PROGRAM: &str = "twinedge::program::*";
const REPORT_AUDIT: &str = "twinedge_trials::ReportAudit";
const EXPECTATION: &str = "twinedge::validate::Expectation";
const DCEL_AND_ROOM: &str = "twinedge::dcel::{Dcel, Room}";

/// A structure, with the Rust source that constructs it.
const fn source(imports: &'static [&'static str], make: &'static str) -> TestSource {
    TestSource { imports, make, expectation: "Expectation::plane()", remark: "" }
}

const SLOTS: TestSource = source(&[DCEL, PROGRAM, EXPECTATION], "Dcel::new()");
const LIMITED: TestSource = source(
    &[DCEL_AND_ROOM, PROGRAM, EXPECTATION],
    "Dcel::with_limits(Room { vertices: 24, edges: 40, boundaries: 40, faces: 24 })",
);
const AUDITED: TestSource = source(
    &["twinedge::dcel::{Audited, Dcel}", PROGRAM, EXPECTATION],
    r#"Audited::new(Dcel::new()).expect("the empty map is valid")"#,
);
const HISTORY: TestSource = source(&[PROGRAM, EXPECTATION, "twinedge_trials::Rewound"], "Rewound::default()");
const POINTERS: TestSource = source(&[PROGRAM, EXPECTATION, "twinedge_trials::RawPointers"], "RawPointers::new()");
const PLANTED: TestSource =
    TestSource { remark: "The structure with the planted bug is not public. This one passes.", ..SLOTS };
const AUDITED_SLOTS: TestSource = source(&[DCEL, PROGRAM, EXPECTATION, REPORT_AUDIT], "ReportAudit::new(Dcel::new())");
const AUDITED_LIMITED: TestSource = source(
    &[DCEL_AND_ROOM, PROGRAM, EXPECTATION, REPORT_AUDIT],
    "ReportAudit::new(Dcel::with_limits(Room { vertices: 24, edges: 40, boundaries: 40, faces: 24 }))",
);

/// Creates an empty map with limits.
fn limited() -> Dcel {
    Dcel::with_limits(Room { vertices: 24, edges: 40, boundaries: 40, faces: 24 })
}

/// Creates an empty map that is audited.
fn audited() -> Audited {
    Audited::new(Dcel::new()).expect("the empty map is valid")
}

impl StructureName {
    /// The structure without and with limits, and the second model.
    pub(crate) const SOUND: [Self; 3] = [Self::Slots, Self::Limited, Self::Pointers];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Slots => "slots",
            Self::Limited => "limited",
            Self::Audited => "audited",
            Self::History => "history",
            Self::Pointers => "pointers",
            Self::Planted => "planted",
            Self::Panicking => "panicking",
        }
    }

    /// Runs a task on the structure of this name.
    pub(crate) fn with<T: Task>(self, task: T) -> T::Result {
        match self {
            Self::Slots => task.run(self.made(|| Erased::new(Dcel::new()), SLOTS)),
            Self::Limited => task.run(self.made(|| Erased::new(limited()), LIMITED)),
            Self::Audited => task.run(self.made(|| Erased::new(audited()), AUDITED)),
            Self::History => task.run(self.made(|| Erased::new(Rewound::default()), HISTORY)),
            Self::Pointers => task.run(self.made(RawPointers::new, POINTERS)),
            Self::Planted => task.run(self.made(|| Erased::new(Planted::<false>::default()), PLANTED)),
            Self::Panicking => task.run(self.made(|| Erased::new(Planted::<true>::default()), PLANTED)),
        }
    }

    /// Returns the structure of this name, for comparing programs. The reports of operators are compared as well.
    pub(crate) fn comparable(self) -> Box<dyn Comparable> {
        struct Boxed;
        impl Task for Boxed {
            type Result = Box<dyn Comparable>;

            fn run<K: Indexed + Clone + 'static>(self, structure: Structure<K>) -> Box<dyn Comparable> {
                Box::new(structure)
            }
        }
        match self {
            Self::Slots => Box::new(self.made(|| Erased::new(ReportAudit::default()), AUDITED_SLOTS)),
            Self::Limited => Box::new(self.made(|| Erased::new(ReportAudit::new(limited())), AUDITED_LIMITED)),
            Self::Audited | Self::History | Self::Pointers | Self::Planted | Self::Panicking => self.with(Boxed),
        }
    }

    /// The structure of this name, with its constructor and the source for it.
    const fn made<K: Indexed>(self, make: fn() -> K, source: TestSource) -> Structure<K> {
        Structure::new(self.name(), make, Expectation::plane()).source(source)
    }
}

#[cfg(test)]
mod tests {
    use super::StructureName;
    use twinedge::program::Program;

    /// Includes these modules as text to print, and compiles and runs the same text.
    macro_rules! printed {
        ($($name:ident: $on:ident;)*) => {
            $(#[rustfmt::skip] mod $name;)*

            #[test]
            fn printed_regression_tests_compile() {
                let program: Program = "twinedge program 1\nadd_isolated_vertex unbounded\nconnect i0 ~0 right inner 0 \
                    also h1\nflip_edge !h0 cw".parse().unwrap();
                $(assert_eq!(
                    StructureName::$on.comparable().to_rust("how it fails", &program),
                    include_str!(concat!("structures/tests/", stringify!($name), ".rs"))
                );)*
            }
        };
    }

    printed! {
        slots: Slots;
        limited: Limited;
        audited: Audited;
        history: History;
        pointers: Pointers;
        planted: Planted;
    }

    #[test]
    fn names_are_those_of_the_command_line() {
        for name in <StructureName as clap::ValueEnum>::value_variants() {
            let value = clap::ValueEnum::to_possible_value(name).unwrap();
            assert_eq!(value.get_name(), name.name());
        }
    }
}
