//! Settings of a comparison: of one program, or of many random ones.

use crate::validate::Expectation;

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
    pub(super) expectation: Expectation,
    pub(super) stale_handles: bool,
    pub(super) vertex_handles: bool,
    pub(super) survivor: Option<End>,
    pub(super) coverage: Option<Coverage>,
    pub(super) programs: usize,
    pub(super) operators: usize,
    pub(super) seed: u64,
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

    /// The same with so many random programs of so many operators.
    #[must_use]
    pub const fn programs(mut self, programs: usize, operators: usize) -> Self {
        self.programs = programs;
        self.operators = operators;
        self
    }

    /// The same with other random programs. The same seed gives the same programs.
    #[must_use]
    pub const fn seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }
}
