//! The structures that the commands work on, by name.

use clap::ValueEnum;
use twinedge::dcel::{Audited, Dcel};
use twinedge::store::{FixedStore, PointerStore, SlotStore};
use twinedge::validate::Expectation;
use twinedge_trials::Structure;
use twinedge_trials::planted::Planted;
use twinedge_trials::regression::TestSource;
use twinedge_trials::replay::Indexed;
use twinedge_trials::soak::Comparable;
use twinedge_trials::{ReportAudit, RotationSystem};

/// A structure that programs can be run on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum StructureName {
    /// The default store: slotmap keys over columns.
    #[default]
    Slots,
    /// Records joined by raw pointers.
    Pointers,
    /// Fixed arrays, with room for 24 vertices, 40 edges, 40 boundary components and 24 faces.
    Fixed,
    /// The default store, validated locally after each operator.
    Audited,
    /// A second independent model: a rotation system.
    #[value(name = "model")]
    RotationSystem,
    /// A structure with a planted bug: it turns edges the wrong way.
    Planted,
    /// A structure with a planted bug: it panics when a boundary component is moved.
    Panicking,
}

/// Something to be done with a structure of any type.
pub(crate) trait Task {
    type Result;

    fn run<K: Indexed + Clone + 'static>(self, structure: Structure<K>) -> Self::Result;
}

const DCEL: &str = "twinedge::dcel::Dcel";
const PROGRAM: &str = "twinedge::program::*";
const REPORT_AUDIT: &str = "twinedge_trials::ReportAudit";
const EXPECTATION: &str = "twinedge::validate::Expectation";

/// A store of the library, by the source that names it.
const fn dcel_source(imports: &'static [&'static str], make: &'static str) -> TestSource {
    TestSource { imports, make, expectation: "Expectation::plane()", remark: "" }
}

const PLANTED: TestSource = TestSource {
    remark: "The structure with the planted bug is not public. This one passes.",
    ..dcel_source(&[DCEL, PROGRAM, EXPECTATION], "Dcel::new()")
};

const AUDITED: &str = r#"Audited::new(Dcel::new()).expect("the empty map is valid")"#;

/// The empty map, audited.
fn audited() -> Audited {
    Audited::new(Dcel::new()).expect("the empty map is valid")
}

impl StructureName {
    /// The stores and the second model, without the structures that have a bug.
    pub(crate) const SOUND: [Self; 4] = [Self::Slots, Self::Pointers, Self::Fixed, Self::RotationSystem];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Slots => "slots",
            Self::Pointers => "pointers",
            Self::Fixed => "fixed",
            Self::Audited => "audited",
            Self::RotationSystem => "model",
            Self::Planted => "planted",
            Self::Panicking => "panicking",
        }
    }

    /// Does something with the structure of this name.
    pub(crate) fn with<T: Task>(self, task: T) -> T::Result {
        let (name, plane) = (self.name(), Expectation::plane());
        match self {
            Self::Slots => {
                let source = dcel_source(&[DCEL, PROGRAM, EXPECTATION], "Dcel::new()");
                task.run(Structure::new(name, Dcel::new, plane).source(source))
            }
            Self::Pointers => {
                let imports = &[DCEL, PROGRAM, "twinedge::store::PointerStore", EXPECTATION];
                let source = dcel_source(imports, "Dcel::<PointerStore>::default()");
                task.run(Structure::new(name, Dcel::<PointerStore>::default, plane).source(source))
            }
            Self::Fixed => {
                let imports = &[DCEL, PROGRAM, "twinedge::store::FixedStore", EXPECTATION];
                let source = dcel_source(imports, "Dcel::<FixedStore<24, 40, 40, 24>>::default()");
                task.run(Structure::new(name, Dcel::<FixedStore<24, 40, 40, 24>>::default, plane).source(source))
            }
            Self::Audited => {
                let imports = &["twinedge::dcel::{Audited, Dcel}", PROGRAM, EXPECTATION];
                let source = dcel_source(imports, AUDITED);
                task.run(Structure::new(name, audited, plane).source(source))
            }
            Self::RotationSystem => {
                let source = TestSource {
                    imports: &[PROGRAM, EXPECTATION, "twinedge_trials::RotationSystem"],
                    make: "RotationSystem::new()",
                    expectation: "Expectation::plane()",
                    remark: "",
                };
                task.run(Structure::new(name, RotationSystem::new, Expectation::plane()).source(source))
            }
            Self::Planted => task.run(Structure::new(name, Planted::<false>::default, plane).source(PLANTED)),
            Self::Panicking => task.run(Structure::new(name, Planted::<true>::default, plane).source(PLANTED)),
        }
    }

    /// The structure of this name, to compare programs on. What the operators of the stores report is checked, too.
    pub(crate) fn comparable(self) -> Box<dyn Comparable> {
        struct Boxed;
        impl Task for Boxed {
            type Result = Box<dyn Comparable>;

            fn run<K: Indexed + Clone + 'static>(self, structure: Structure<K>) -> Box<dyn Comparable> {
                Box::new(structure)
            }
        }
        let (name, plane) = (self.name(), Expectation::plane());
        match self {
            Self::Slots => {
                let source = dcel_source(&[DCEL, PROGRAM, EXPECTATION, REPORT_AUDIT], "ReportAudit::new(Dcel::new())");
                Box::new(Structure::new(name, ReportAudit::<SlotStore>::default, plane).source(source))
            }
            Self::Pointers => {
                let imports = &[PROGRAM, "twinedge::store::PointerStore", EXPECTATION, REPORT_AUDIT];
                let source = dcel_source(imports, "ReportAudit::<PointerStore>::default()");
                Box::new(Structure::new(name, ReportAudit::<PointerStore>::default, plane).source(source))
            }
            Self::Fixed => {
                let imports = &[DCEL, PROGRAM, "twinedge::store::FixedStore", EXPECTATION, REPORT_AUDIT];
                let source = dcel_source(imports, "ReportAudit::new(Dcel::<FixedStore<24, 40, 40, 24>>::default())");
                let make = ReportAudit::<FixedStore<24, 40, 40, 24>>::default;
                Box::new(Structure::new(name, make, plane).source(source))
            }
            Self::Audited | Self::RotationSystem | Self::Planted | Self::Panicking => self.with(Boxed),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::StructureName;
    use twinedge::program::Program;

    /// The text that is printed is compiled as it stands, and run: it is these modules.
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
        pointers: Pointers;
        fixed: Fixed;
        audited: Audited;
        model: RotationSystem;
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
