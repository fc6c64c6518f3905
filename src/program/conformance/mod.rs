//! Conformance tests: programs run on a subject and on the reference in step, and both are compared after every operator.
//!
//! The reference is [`PointerModel`](crate::program::PointerModel), which shares only the meaning of the operators with
//! [`Dcel`](crate::dcel::Dcel): `Dcel` is tested against it like any other subject.
//!
//! | to | take |
//! | --- | --- |
//! | run random programs, and get the smallest failing one | [`check`] |
//! | run one program | [`run`] |
//! | run a fuzzer's program, and shrink it if it fails | [`Conformance::run_and_shrink`] |
//! | inspect the structure between operators | [`InStep`] |
//! | change the settings | [`Conformance`] |
//!
//! # What is compared
//!
//! After each operator:
//!
//! 1. the outcome: applied, refused (and the category of the error) or skipped;
//! 2. the subject's validity, by the validator;
//! 3. the view: `twin`, `next`, origin and face of every half-edge, and the face of every isolated vertex;
//!    [`Subject::half_edge_at`] and [`Subject::vertex_at`] name their handles. A wrong handle is found when it is returned, not when it
//!    is used;
//! 4. the answers to the same questions about handles, in order of creation;
//! 5. the handles of surviving vertices. Of two merged vertices either may survive, unless [`Conformance::collapse_keeps`] chooses one.
//!    [`Conformance::without_vertex_handles`] is for structures that renumber vertices.
//!
//! The kept, made and dropped boundary components and faces that an operator reports are not compared. For `Dcel`, `ReportAudit` of the
//! crate `twinedge-trials` also compares these.
//!
//! Parts that a structure lacks are not compared; the summary [lists them](ConformanceSummary::not_compared). If the subject does not
//! support an operator, or has no room for it, the reference does not run it either, and the subject must be unchanged. To continue
//! past a known difference, answer [`Refusal::Unsupported`](crate::program::Refusal::Unsupported) where it would occur.
//!
//! # The start
//!
//! A comparison begins with the subject in its current state. The empty map is enough if the subject has `add_isolated_vertex`.
//! Otherwise [`PointerModel::from_view`](crate::program::PointerModel::from_view) copies the structure into the reference (its page
//! covers meshes, borders and surfaces). Each half-edge needs a twin, also on the border;
//! [`mesh::Named`](crate::program::mesh::Named) adds twins that a mesh does not store. A half-edge on the border needs no `next`: its
//! view may answer nil.
//!
//! A mesh whose handles are indices needs a [`View`](crate::validate::View), which [`view_answers!`](crate::view_answers) writes from
//! one line per answer, and a [`Subject`], which [`subject_by_index!`](crate::subject_by_index) writes from the names of its operators.
//! Errors become a [`Refusal`](crate::program::Refusal) by `From`; wrap an error type of another crate, such as `String`, in your own.
//! [`program::mesh`](crate::program::mesh) lists each operator's refusals in order. The example `mesh_conformance` needs 39 lines for a
//! mesh with stable indices, stored border half-edges and the twin of `h` at `h ^ 1`.
//!
//! If operators move half-edges to other indices (as they must where `next` is arithmetic), or if half-edges on the border are not
//! stored, give the mesh and its operators to [`mesh::Named`](crate::program::mesh::Named); no `Subject` is needed.
//!
//! Implement `View` and `Subject` in the crate of the structure, or for a newtype elsewhere. For that crate's tests, twinedge is a
//! dev-dependency. A fuzz target is another crate, so the implementation must be in the library, behind a feature if users should not
//! see it:
//!
//! ```toml
//! [dependencies]
//! twinedge = { version = "0.1", default-features = false, features = ["dcel", "std"], optional = true }
//! [features]
//! fuzzing = ["dep:twinedge"]
//! ```
//!
//! # When nothing was tried
//!
//! A comparison in which nothing happens proves nothing. [`run`] fails if no operator was applied, and [`check`] fails if a supported
//! operator was never applied; [`Coverage`] changes this.
//!
//! ```
//! use twinedge::dcel::Dcel;
//! use twinedge::program::{Program, conformance};
//! use twinedge::validate::Expectation;
//!
//! let program = Program::from_bytes(b"some bytes that came from a fuzzer");
//! conformance::run(&program, Dcel::new(), &Expectation::plane())?;
//!
//! let summary = conformance::check(Dcel::new, &Expectation::plane())?;
//! assert!(summary.of("flip_edge").unwrap().applied > 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod compare;
mod difference;
mod in_step;

pub use difference::{
    Answer, ConformanceSummary, Counterexample, Difference, Failure, NotCompared, OperatorCounts, Question,
};
pub use in_step::InStep;

use crate::program::operators::Program;
use crate::program::subject::Subject;
use crate::validate::Expectation;

/// Runs a program on a subject and on the reference in step. `expectation` states the rules that the subject keeps.
///
/// O(n²) per operator for n half-edges and vertices, if the subject and its view answer in O(1). Comparing handles takes O(n²); a few
/// operators of the reference, and maps with many symmetries, also take more than O(n log n).
///
/// With the feature `std`, a panic of the subject is a difference like any other. The first comparison installs a hook that suppresses
/// the message of such a panic. A stack overflow and `panic = "abort"` still end the program.
///
/// # Errors
/// The first difference, with its operator. Before the first operator: the reason why the structure cannot be a start. After the last
/// one: [`Difference::NothingApplied`] if the program has operators and none was applied. Where that is not a failure, for example
/// while shrinking, set [`Coverage::Nothing`].
pub fn run<K: Subject>(
    program: &Program,
    subject: K,
    expectation: &Expectation,
) -> Result<ConformanceSummary, Failure> {
    Conformance::of(expectation).run(program, subject)
}

/// Runs 200 random programs of 40 operators, each on a new subject, and shrinks the first that fails. The programs are always the same;
/// [`Conformance`] changes the seed, the number and the length.
///
/// Draws only operators that the subject has not turned out to lack. Costs as much as 200 calls of [`run`].
///
/// # Errors
/// The smallest failing program found, with the difference. [`Difference::NeverApplied`] if an operator of the subject was never
/// applied; [`Difference::NothingApplied`].
pub fn check<K: Subject>(
    make: impl FnMut() -> K,
    expectation: &Expectation,
) -> Result<ConformanceSummary, Counterexample> {
    Conformance::of(expectation).check(make)
}

/// The operators that a run must cover to succeed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Coverage {
    /// Every supported operator was applied at least once. An operator that was never tried, or never found anything to choose from,
    /// counts as unsupported.
    EveryOperator,
    /// Some operator was applied. An empty program passes.
    SomeOperator,
    /// No requirement. For shrinking: fewer operators cover less.
    Nothing,
}

/// An end of a half-edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum End {
    /// The vertex where the half-edge starts.
    Origin,
    /// The vertex where the half-edge ends.
    Target,
}

/// The settings of a comparison.
///
/// ```
/// use twinedge::dcel::Dcel;
/// use twinedge::program::conformance::{Conformance, Coverage};
/// use twinedge::program::Program;
/// use twinedge::validate::Expectation;
///
/// let asked = Conformance::of(&Expectation::plane()).coverage(Coverage::Nothing);
/// let summary = asked.run(&Program::default(), Dcel::new())?;
/// assert_eq!(summary.total().all(), 0);
/// # Ok::<(), twinedge::program::conformance::Failure>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Conformance {
    expectation: Expectation,
    stale_handles: bool,
    vertex_handles: bool,
    survivor: Option<End>,
    coverage: Option<Coverage>,
    programs: usize,
    operators: usize,
    seed: u64,
}

impl Conformance {
    /// Compares a structure under this expectation; [`check`](Self::check) runs 200 programs of 40 operators.
    #[must_use]
    pub const fn of(expectation: &Expectation) -> Self {
        Self {
            expectation: *expectation,
            stale_handles: true,
            vertex_handles: true,
            survivor: None,
            coverage: None,
            programs: 200,
            operators: 40,
            seed: 0,
        }
    }

    /// Sets the operators to be covered. The default is [`Coverage::SomeOperator`] for one program, and [`Coverage::EveryOperator`] for
    /// [`Conformance::check`].
    #[must_use]
    pub const fn coverage(mut self, coverage: Coverage) -> Self {
        self.coverage = Some(coverage);
        self
    }

    /// Disables handles of removed records, for structures that reuse handles. Operators that choose one are skipped.
    #[must_use]
    pub const fn without_stale_handles(mut self) -> Self {
        self.stale_handles = false;
        self
    }

    /// Lets operators change the handles of vertices, for structures that keep vertices without gaps and use indices as handles. The
    /// owner must move data stored under such handles. Within one state, equal handles still mean equal vertices. Handles of half-edges
    /// and of isolated vertices must stay. [`mesh::Named`](crate::program::mesh::Named) finds half-edges by their vertices: with it,
    /// only a vertex that is made or kept may have a new index.
    #[must_use]
    pub const fn without_vertex_handles(mut self) -> Self {
        self.vertex_handles = false;
        self
    }

    /// Requires that contracting or collapsing an edge keeps this end. By default either end may survive, but no other vertex. For a
    /// half-edge on the border that the structure does not store, either may always survive.
    #[must_use]
    pub const fn collapse_keeps(mut self, end: End) -> Self {
        self.survivor = Some(end);
        self
    }

    /// Sets the number of random programs, and of operators in each.
    #[must_use]
    pub const fn programs(mut self, programs: usize, operators: usize) -> Self {
        self.programs = programs;
        self.operators = operators;
        self
    }

    /// Sets the seed. The same seed yields the same programs.
    #[must_use]
    pub const fn seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }
}
