//! A failing program as a regression test: a file of Rust that compiles as it stands.

use crate::subjects::SubjectName;
use twinedge::program::Program;

/// What a test says of a structure.
struct Source {
    /// What is to be imported beside the program language.
    imports: &'static [&'static str],
    /// How the empty structure is made.
    make: &'static str,
    /// What it is held to.
    expectation: &'static str,
    /// What there is to be said before.
    remark: &'static str,
}

const DCEL: &str = "twinedge::dcel::Dcel";
const PROGRAM: &str = "twinedge::program::*";
const EXPECTATION: &str = "twinedge::validate::Expectation";

impl Source {
    const fn of(on: SubjectName) -> Self {
        let plane = "Expectation::plane()";
        match on {
            SubjectName::Slots => {
                Self { imports: &[DCEL, PROGRAM, EXPECTATION], make: "Dcel::new()", expectation: plane, remark: "" }
            }
            SubjectName::Pointers => Self {
                imports: &[DCEL, PROGRAM, "twinedge::store::PointerStore", EXPECTATION],
                make: "Dcel::<PointerStore>::default()",
                expectation: plane,
                remark: "",
            },
            SubjectName::Fixed => Self {
                imports: &[DCEL, PROGRAM, "twinedge::store::FixedStore", EXPECTATION],
                make: "Dcel::<FixedStore<24, 40, 40, 24>>::default()",
                expectation: plane,
                remark: "",
            },
            SubjectName::RotationSystem => Self {
                imports: &[PROGRAM],
                make: "RotationSystem::new()",
                expectation: "RotationSystem::expectation()",
                remark: "",
            },
            SubjectName::Planted | SubjectName::Panicking => Self {
                imports: &[DCEL, PROGRAM, EXPECTATION],
                make: "Dcel::new()",
                expectation: plane,
                remark: "    // The structure with the planted bug is not public. This one passes.\n",
            },
        }
    }
}

/// The test. `message` says in one line how the structure fails.
pub(crate) fn test(on: SubjectName, message: &str, program: &Program) -> String {
    let Source { imports, make, expectation, remark } = Source::of(on);
    let imports: Vec<String> = imports.iter().map(|import| format!("use {import};\n")).collect();
    let imports = imports.concat();
    let program = program.to_rust().replace('\n', "\n    ");
    format!(
        "{imports}\n/// {message}\n#[test]\nfn regression() {{\n    let program = {program};\n{remark}    let result = \
         conformance::run(&program, {make}, &{expectation});\n    assert!(result.is_ok(), \"{{result:?}}\");\n}}\n"
    )
}

#[cfg(test)]
mod tests {
    use super::test;
    use crate::subjects::SubjectName;
    use twinedge::program::Program;

    /// What is printed is compiled, as it stands, and run: it is these modules.
    macro_rules! printed {
        ($($name:ident: $on:ident;)*) => {
            $(#[rustfmt::skip] mod $name;)*

            #[test]
            fn what_is_printed_compiles() {
                let program: Program = "twinedge program 1\nadd_isolated_vertex unbounded\nconnect i0 ~0 right inner 0 \
                    also h1\nflip_edge !h0 cw".parse().unwrap();
                $(assert_eq!(
                    test(SubjectName::$on, "how it fails", &program),
                    include_str!(concat!("regression/tests/", stringify!($name), ".rs"))
                );)*
            }
        };
    }

    printed! {
        slots: Slots;
        pointers: Pointers;
        fixed: Fixed;
        model: RotationSystem;
        planted: Planted;
    }
}
