//! Does a subject do what the operators say? Programs are run on it and on the reference in step, and after every
//! operator both must have done the same.
//!
//! The reference is [`PointerModel`](crate::program::PointerModel), which has nothing in common with [`Dcel`](crate::dcel::Dcel) but the meaning of the
//! operators: `Dcel` is held to it like any other subject.
//!
//! | to | take |
//! | --- | --- |
//! | try random programs, and get the smallest one that fails | [`check`] |
//! | run one program | [`run`] |
//! | run one of a fuzzer, and make it small if it fails | [`Conformance::run_and_shrink`] |
//! | look at the structure between operators | [`InStep`] |
//! | ask for more or less | [`Conformance`] |
//!
//! # What is compared
//!
//! After each operator:
//!
//! 1. whether it was applied, refused (and with which category of error) or skipped;
//! 2. whether the subject is valid, by the validator;
//! 3. whether the view is the right map: by canonical forms, nesting and unbounded face included, if it has faces, their inner boundary
//!    components and the unbounded face, and else half-edge by half-edge;
//! 4. whether the handles say the same: `twin`, `next`, origins and faces of every half-edge and isolated vertex, in
//!    order of their creation. So a subject that hands out the wrong handle is found at once, and not when it is used;
//! 5. whether each vertex has the handle that it had before. Where two become one, either may be kept, unless
//!    [`Conformance::collapse_keeps`] says which. [`Conformance::without_vertex_handles`] is for structures that give vertices other indices.
//!
//! What an operator returns is not compared beyond its handles: which boundary components and faces it says that it kept, made and
//! dropped. For `Dcel`, `ReportAudit` of the crate `twinedge-trials` compares that, too.
//!
//! What a structure does not have is not compared, and the summary [says so](ConformanceSummary::not_compared). An operator that the
//! subject does not have, or has no room for, is not run on the reference either, but the subject must be as it was. To get on beyond a
//! difference that is known, answer [`Refusal::Unsupported`](crate::program::Refusal::Unsupported) where it would occur.
//!
//! # Where it begins
//!
//! With the subject as it is. The empty map will do if the subject has `add_isolated_vertex`. Any other valid structure becomes
//! that of the reference by [`PointerModel::from_view`](crate::program::PointerModel::from_view), which says how it stands for meshes, borders and
//! surfaces, and the subject tells its handles by [`Subject::half_edge_at`]. Each half-edge needs a twin,
//! on the border, too; [`mesh::Named`](crate::program::mesh::Named) adds those that a mesh does not store. A half-edge on the border
//! needs no `next`: its view may answer nil.
//!
//! A mesh whose handles are indices needs a [`View`](crate::validate::View), which [`view_answers!`](crate::view_answers) writes from an
//! answer to a line, and a [`Subject`], which [`subject_by_index!`](crate::subject_by_index) writes from the names of the operators that it
//! has. Errors become a [`Refusal`](crate::program::Refusal) by `From` (an error type of another crate, such as `String`, needs a
//! wrapper of your own for that): [`program::mesh`](crate::program::mesh) says for which reason each operator is
//! refused, and in which order. The example `mesh_conformance` is 39 lines of this beside the mesh: one whose half-edges keep their
//! indices, the twin of `h` being `h ^ 1`, and which stores the half-edges on its border.
//!
//! If operators move half-edges to other indices (where `next` is arithmetic they must), or if half-edges on the border are not
//! stored, [`mesh::Named`](crate::program::mesh::Named) takes the mesh and its operators, and no `Subject` has to be written.
//!
//! `View` and `Subject` are implemented in the crate of the structure, or for a newtype elsewhere. Tests of that crate need twinedge as
//! a dev-dependency; a fuzz target is another crate, so the implementation must be in the library then, behind a feature of its own if
//! users are not to see it:
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
//! A comparison in which nothing happens proves nothing. So [`run`] fails if no operator was applied, and [`check`] if some
//! operator that the subject has was never applied; [`Coverage`] asks for something else.
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
mod summary;

pub use difference::{Answer, Counterexample, Difference, Failure, Question};
pub use in_step::InStep;
pub use summary::{ConformanceSummary, NotCompared, OperatorCounts};

use crate::program::operators::Program;
use crate::program::subject::Subject;
use crate::validate::Expectation;

/// Runs a program on a subject, and on the reference in step. `expectation` says what the validator can hold the subject to.
///
/// O(n²) per operator for n half-edges and vertices, if the subject answers a question in O(1) and its view does. Of this
/// only comparing handles takes more than O(n log n), beside a few operators of the reference and maps with many
/// symmetries.
///
/// With the feature `std`, a panic of the subject is a difference like any other. The first comparison installs a hook that keeps such a
/// panic from being printed. A stack that overflows, and `panic = "abort"`, end the program all the same.
///
/// # Errors
/// The first difference, and the operator that made it. Before the first operator: what is wrong with the structure as a start.
/// After the last: [`Difference::NothingApplied`] if the program has operators and none was applied. Where that is no
/// failure, as for a program that is being made smaller, take [`Coverage::Nothing`].
pub fn run<K: Subject>(
    program: &Program,
    subject: K,
    expectation: &Expectation,
) -> Result<ConformanceSummary, Failure> {
    Conformance::of(expectation).run(program, subject)
}

/// Runs 200 random programs of 40 operators, each on a new subject, and makes the first that fails small. They are always the same
/// programs; [`Conformance`] has others, and more.
///
/// Operators are drawn among those that the subject has, as far as has been seen. Costs as much as so many calls of [`run`].
///
/// # Errors
/// The smallest program found that shows a difference, with the difference. [`Difference::NeverApplied`] if the subject has an
/// operator that none of them applied; [`Difference::NothingApplied`].
pub fn check<K: Subject>(
    make: impl FnMut() -> K,
    expectation: &Expectation,
) -> Result<ConformanceSummary, Counterexample> {
    Conformance::of(expectation).check(make)
}

/// The operators that a run must have covered to count.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Coverage {
    /// Every operator that the subject has was applied at least once. An operator that it was never asked for, or that
    /// found nothing to choose from each time, counts as one that it does not have.
    EveryOperator,
    /// Some operator was applied. An empty program passes.
    SomeOperator,
    /// Nothing. Take this to make a failing program small: fewer operators cover less.
    Nothing,
}

/// An end of a half-edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum End {
    /// The vertex where it starts.
    Origin,
    /// The vertex where it ends.
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
    /// A comparison with a structure that is held to this expectation: 200 programs of 40 operators, where programs
    /// are made up.
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

    /// The same, but something else must be covered. The default is [`Coverage::SomeOperator`] for one program, and
    /// [`Coverage::EveryOperator`] for [`Conformance::check`].
    #[must_use]
    pub const fn coverage(mut self, coverage: Coverage) -> Self {
        self.coverage = Some(coverage);
        self
    }

    /// The same without handles of removed records, for structures that use a handle again. Operators that ask for one
    /// are skipped.
    #[must_use]
    pub const fn without_stale_handles(mut self) -> Self {
        self.stale_handles = false;
        self
    }

    /// The same, but operators may give vertices other handles, as a structure does that keeps its vertices without gaps and whose handles are
    /// indices. Data that is kept by such handles must be moved by its owner. Within one state of the structure equal handles still mean
    /// equal vertices. Handles of half-edges and of isolated vertices must stay. [`mesh::Named`](crate::program::mesh::Named) finds
    /// half-edges again by their vertices: with it, a vertex that is made or kept may have a new index, and others may not.
    #[must_use]
    pub const fn without_vertex_handles(mut self) -> Self {
        self.vertex_handles = false;
        self
    }

    /// The same, but of the two ends of an edge that is contracted or collapsed this one is to be kept. By default either may be, and
    /// another vertex may not. Of a half-edge on the border that the structure does not store, either may be kept in any case.
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
