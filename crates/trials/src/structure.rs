//! The structure under test, and the regression tests of its failures.

use crate::verdict::judge;
use std::fmt;
use thiserror::Error;
use twinedge::program::panics::catch;
use twinedge::program::{Program, Subject};
use twinedge::validate::{Expectation, Part, Parts, Violation};

/// A structure under test: its name, a function that makes an empty one, and an expectation for the validator.
///
/// ```
/// use twinedge_trials::RawPointers;
/// use twinedge::validate::Expectation;
/// use twinedge_trials::Structure;
/// let mine = Structure::new("mine", RawPointers::new, Expectation::plane());
/// assert_eq!(mine.name(), "mine");
/// ```
pub struct Structure<K> {
    name: &'static str,
    make: fn() -> K,
    expectation: Expectation,
    source: Option<TestSource>,
}

impl<K> Clone for Structure<K> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<K> Copy for Structure<K> {}

impl<K> fmt::Debug for Structure<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Structure").field("name", &self.name).finish_non_exhaustive()
    }
}

impl<K: Subject> Structure<K> {
    /// Returns a structure of this name. `make` makes the empty map.
    #[must_use]
    pub const fn new(name: &'static str, make: fn() -> K, expectation: Expectation) -> Self {
        Self { name, make, expectation, source: None }
    }

    /// Adds the Rust source that names it, for the regression tests that [`soak()`](crate::soak()) prints.
    #[must_use]
    pub const fn source(mut self, source: TestSource) -> Self {
        self.source = Some(source);
        self
    }

    /// Returns its name, as shown in outcomes.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// Returns its expectation.
    #[must_use]
    pub const fn expectation(&self) -> Expectation {
        self.expectation
    }

    /// Makes an empty map.
    #[must_use]
    pub fn make(&self) -> K {
        (self.make)()
    }

    pub(crate) const fn test_source(&self) -> Option<&TestSource> {
        self.source.as_ref()
    }

    /// Checks that maps can be told apart by faces, the lists of their boundary components, and the unbounded face.
    pub(crate) fn can_be_told_apart(&self) -> Result<(), StructureError> {
        // A structure that panics passes here: engines report that.
        let stored = catch(|| self.make().parts()).unwrap_or(Parts::ALL);
        let needed = [Part::Faces, Part::Holes, Part::UnboundedFace];
        let lacks = needed.into_iter().find(|part| !self.expectation.looks_at(stored).has(*part));
        lacks.map_or(Ok(()), |part| Err(StructureError::Lacks(part)))
    }

    /// Checks that the empty map keeps the rules. A structure that panics passes: engines report that with the program at fault.
    pub(crate) fn starts_valid(&self) -> Result<(), StructureError> {
        let Ok(report) = catch(|| judge(&self.make(), &self.expectation)) else { return Ok(()) };
        report.first().map_or(Ok(()), |violation| Err(StructureError::InvalidStart(*violation)))
    }
}

/// The name of a structure in Rust source, for a regression test of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TestSource {
    /// The paths to import, in order. `twinedge::program::*` must be among them.
    pub imports: &'static [&'static str],
    /// An expression for the empty structure.
    pub make: &'static str,
    /// An expression for its `Expectation`.
    pub expectation: &'static str,
    /// A comment in front of the run, without `//`; omitted if empty.
    pub remark: &'static str,
}

impl TestSource {
    /// Returns the test. `message` describes the failure in one line.
    ///
    /// ```
    /// use twinedge::program::Program;
    /// use twinedge_trials::TestSource;
    /// let source = TestSource {
    ///     imports: &["mine::Mine", "twinedge::program::*", "twinedge::validate::Expectation"],
    ///     make: "Mine::new()",
    ///     expectation: "Expectation::plane()",
    ///     remark: "",
    /// };
    /// let test = source.test("the edge turns the wrong way", &Program::default());
    /// assert!(test.contains("conformance::run(&program, Mine::new(), &Expectation::plane())"));
    /// ```
    #[must_use]
    pub fn test(&self, message: &str, program: &Program) -> String {
        let Self { imports, make, expectation, remark } = self;
        let imports: String = imports.iter().flat_map(|import| ["use ", import, ";\n"]).collect();
        let remark = if remark.is_empty() { String::new() } else { format!("    // {remark}\n") };
        let program = program.to_rust().replace('\n', "\n    ");
        format!(
            "{imports}\n/// {message}\n#[test]\nfn regression() {{\n    let program = {program};\n{remark}    let result = \
             conformance::run(&program, {make}, &{expectation});\n    assert!(result.is_ok(), \"{{result:?}}\");\n}}\n"
        )
    }
}

/// A structure is unsuitable for an engine.
#[derive(Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum StructureError {
    /// The structure does not store a part that is needed to tell two maps apart.
    #[error("the structure stores no {}; without it two maps cannot be told apart", .0.name())]
    Lacks(Part),
    /// The empty map breaks a rule, so every other map would.
    #[error(
        "the empty map of the structure breaks {}: {_0}; {}. Either `make` does not make an empty map, or the expectation is not \
that of the structure",
        _0.rule(), _0.remedy()
    )]
    InvalidStart(Violation),
}

/// Equal to `Display`, since `unwrap` shows it.
impl fmt::Debug for StructureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
