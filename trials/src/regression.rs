//! A failing program as a regression test: a complete file of Rust that compiles.

use twinedge::program::Program;

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
    /// use twinedge_trials::regression::TestSource;
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
