//! Random programs in step with a reference.
//!
//! The reference, [`PointerModel`](twinedge::program::PointerModel), is written from the definitions of the operators. After each
//! operator the structure must have the same outcome (applied, refused for the same reason, or skipped), and it must be valid and
//! isomorphic, including nesting, with equal handles. Programs use stale handles. The first that fails, or panics, is made small.
//!
//! Reports of operators beyond handles are specific to a structure. [`ReportAudit`](crate::ReportAudit) checks them for `Dcel`.

use crate::outcome::{Outcome, Results};
use crate::random::Random;
use crate::rows::{add_rows, rows};
use crate::run::{Progress, Run};
use crate::structure::Structure;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use twinedge::program::conformance::{ConformanceSummary, InStep};
use twinedge::program::panics::catch;
use twinedge::program::{FacePick, Op, Program, Subject, candidates};

/// Runs random programs on structures in step with a reference, until one fails.
///
/// Each step takes O(n²) for n half-edges and vertices, and n grows with the steps. A panic of a structure is caught and
/// reported; meanwhile the panic hook of the process is replaced by a silent one.
///
/// The first failing program is the same on any number of threads, and the first of all parts of the work is also the first of
/// the whole. The counts are exact if no program fails. Without structures nothing is compared, and the outcome is not ok.
///
/// # Examples
/// A structure with a bug:
///
/// ```
/// use twinedge::validate::Expectation;
/// use twinedge_trials::planted::Planted;
/// use twinedge_trials::soak::SoakWork;
/// use twinedge_trials::{Run, Structure, soak};
/// let planted = Structure::new("planted", Planted::<false>::default, Expectation::plane());
/// let outcome = soak(&[&planted], SoakWork { programs: 50, steps: 60, seed: 1 }, &Run::default());
/// // Made as small as it can be, the program turns one edge.
/// assert!(outcome.results.failure.unwrap().program.contains("flip_edge"));
/// ```
pub fn soak(structures: &[&dyn Comparable], work: SoakWork, run: &Run<'_>) -> Outcome<SoakResults> {
    let rows = || structures.iter().map(|structure| SoakRow::of(structure.name())).collect::<Vec<_>>();
    let first_failing = AtomicU64::new(u64::MAX);
    let numbers = run.part().numbers(work.programs as usize);
    let (first, step) = (run.part().index(), run.part().count());
    let fresh = || Worker { structures, run, rows: rows(), failed: None };
    let workers = run.each("programs", numbers.len(), fresh, |worker, position| {
        let number = first + position as u32 * step;
        // Programs after a failing one are not needed.
        if u64::from(number) < first_failing.load(Ordering::Relaxed) {
            worker.soak(&work.program(number), number);
            if let Some(failed) = &worker.failed {
                first_failing.fetch_min(failed.number.into(), Ordering::Relaxed);
            }
        }
    });
    let mut structures = rows();
    for worker in &workers {
        add_rows(&mut structures, &worker.rows);
    }
    let failed = workers.into_iter().filter_map(|worker| worker.failed).min_by_key(|failed| failed.number);
    let results = SoakResults {
        seed: work.seed,
        structures,
        failure: failed.map(|failed| failed.made_small(&work, run)),
        saved: None,
    };
    Outcome::new(work, run, results)
}

struct Worker<'a> {
    structures: &'a [&'a dyn Comparable],
    run: &'a Run<'a>,
    rows: Vec<SoakRow>,
    failed: Option<FailedProgram<'a>>,
}

struct FailedProgram<'a> {
    on: &'a dyn Comparable,
    number: u32,
    /// The number of operators before the failing one.
    before: usize,
    message: String,
}

impl Worker<'_> {
    fn soak(&mut self, program: &Program, number: u32) {
        for (on, row) in self.structures.iter().zip(&mut self.rows) {
            let comparison = on.compare(program, self.run.reporter());
            row.count(&comparison.summary);
            match comparison.end {
                End::Finished => row.programs += 1,
                End::Interrupted => {
                    row.cut_short += 1;
                    return;
                }
                End::Failed { before, message } => {
                    let failed = FailedProgram { on: *on, number, before, message };
                    // Numbers are taken in order, but a thread may be late.
                    if self.failed.as_ref().is_none_or(|other| number < other.number) {
                        self.failed = Some(failed);
                    }
                    return;
                }
            }
        }
    }
}

impl FailedProgram<'_> {
    /// Makes the program small, as far as possible until the run is stopped.
    fn made_small(self, work: &SoakWork, run: &Run<'_>) -> SoakFailure {
        let Self { on, number, before, mut message } = self;
        let mut smallest: Program = work.program(number).0.into_iter().take(before + 1).collect();
        let failure = |program: Program| {
            let message = on.compare(&program, run.reporter()).failure()?.to_owned();
            Some((program, message))
        };
        while let Some(smaller) = candidates(&smallest).take_while(|_| !run.is_stopped()).find_map(failure) {
            (smallest, message) = smaller;
        }
        let rust = on.to_rust(&message, &smallest);
        SoakFailure { on: on.name().to_owned(), number, message, program: smallest.to_string(), rust }
    }
}

/// The results of [`soak()`](crate::soak()).
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct SoakResults {
    /// The seed of the programs.
    pub seed: u64,
    /// The counts of the programs, by structure.
    pub structures: Vec<SoakRow>,
    /// The first program that failed, made small. Later programs were not run, unless they had already started.
    pub failure: Option<SoakFailure>,
    /// The file to which the caller saved the failing program.
    pub saved: Option<PathBuf>,
}

rows! {
    /// The counts of the programs on one structure.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct SoakRow {
        /// The structure.
        label on: String = "on" 10;
        /// Programs that ran to their end.
        count programs: u64 = "programs" 13;
        /// Programs that were interrupted. Their operators up to that point are counted.
        count cut_short: u64;
        /// Operators that were applied.
        count applied: u64 = "applied" 13;
        /// Operators that were refused, for the same reason as the reference.
        count refused: u64 = "refused" 13;
        /// Operators that found nothing to choose from.
        count skipped: u64 = "skipped" 13;
        /// Operators that the structure had no room for, or does not have.
        count no_room: u64 = "no room" 13;
    }
}

/// A program on which a structure fails, as small as possible.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SoakFailure {
    /// The structure.
    pub on: String,
    /// The number of the program for the seed.
    pub number: u32,
    /// The failure, in one line.
    pub message: String,
    /// The text of the program: [`Program`] reads it.
    pub program: String,
    /// A regression test, or the program as a Rust expression: see [`Structure::source`](crate::Structure::source).
    pub rust: String,
}

impl SoakRow {
    pub(super) fn of(on: &str) -> Self {
        Self { on: on.to_owned(), programs: 0, cut_short: 0, applied: 0, refused: 0, skipped: 0, no_room: 0 }
    }

    pub(super) fn count(&mut self, summary: &ConformanceSummary) {
        let total = summary.total();
        self.applied += total.applied as u64;
        self.refused += total.refused as u64;
        self.skipped += total.skipped as u64;
        self.no_room += (total.no_room + total.unsupported) as u64;
    }
}

impl Results for SoakResults {
    type Work = SoakWork;

    fn on(&self) -> Vec<&str> {
        self.structures.iter().map(|row| row.on.as_str()).collect()
    }

    fn reasons(&self, _: &Self::Work, _: bool) -> Vec<String> {
        let mut reasons = Vec::new();
        if self.structures.is_empty() {
            reasons.push("no structure was given, so nothing was compared".to_owned());
        }
        if let Some(SoakFailure { on, number, message, rust, .. }) = &self.failure {
            reasons.push(format!("{on} differs from the reference in program {number}, {message}\n{rust}"));
        }
        reasons
    }

    fn absorb(&mut self, other: &Self) {
        add_rows(&mut self.structures, &other.structures);
        let failures = [self.failure.take(), other.failure.clone()];
        self.failure = failures.into_iter().flatten().min_by_key(|failure| failure.number);
    }

    fn complete(&mut self) {
        self.saved = None;
    }
}

/// The work of `soak`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SoakWork {
    /// The number of programs.
    pub programs: u32,
    /// The number of operators of each.
    pub steps: u32,
    /// The seed of the programs.
    pub seed: u64,
}

impl SoakWork {
    /// Returns the program with this number. Always the same for the same seed and number of steps.
    #[must_use]
    pub fn program(&self, number: u32) -> Program {
        // Without a vertex, most operators have nothing to choose from.
        let first = Op::AddIsolatedVertex { face: FacePick::Unbounded };
        let mut bytes = Random::new(self.seed, number.into()).bytes();
        let ops = std::iter::from_fn(|| Op::from_bytes(&mut bytes));
        std::iter::once(first).chain(ops).take(self.steps as usize).collect()
    }
}

/// The outcome of a program that was run in step with the reference.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Comparison {
    /// The numbers of operators that were applied, refused and so on, up to the end.
    pub summary: ConformanceSummary,
    /// The end.
    pub end: End,
}

/// The end of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum End {
    /// The structure agreed with the reference, up to the last operator.
    Finished,
    /// The run was stopped.
    Interrupted,
    /// The structure differs from the reference, or panicked.
    Failed {
        /// The number of operators before the failing one.
        before: usize,
        /// The failure, in one line.
        message: String,
    },
}

impl Comparison {
    /// Returns the failure, if the structure failed.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        match &self.end {
            End::Failed { message, .. } => Some(message),
            End::Finished | End::Interrupted => None,
        }
    }
}

/// A structure of any type on which programs can be compared.
pub trait Comparable: Sync {
    /// Returns the name of the structure.
    fn name(&self) -> &'static str;

    /// Runs a program on the structure and on the reference, [`PointerModel`](twinedge::program::PointerModel), and compares them
    /// after each operator, like [`conformance::run`](twinedge::program::conformance::run). A panic is caught. Costs as there.
    fn compare(&self, program: &Program, progress: &dyn Progress) -> Comparison;

    /// Returns a regression test of this program, or the program as a Rust expression if the structure has no
    /// [`source`](Structure::source).
    fn to_rust(&self, message: &str, program: &Program) -> String;
}

impl<K: Subject> Comparable for Structure<K> {
    fn name(&self) -> &'static str {
        Self::name(self)
    }

    fn compare(&self, program: &Program, progress: &dyn Progress) -> Comparison {
        let failed = |summary, before, message| Comparison { summary, end: End::Failed { before, message } };
        let begun = catch(|| self.make()).map_err(|panic| format!("at the start: panicked: {panic}"));
        let begun =
            begun.and_then(|subject| InStep::new(subject, &self.expectation()).map_err(|failure| failure.to_string()));
        let mut pair = match begun {
            Ok(pair) => pair,
            Err(message) => return failed(ConformanceSummary::default(), 0, message),
        };
        for (before, op) in program.0.iter().enumerate() {
            if progress.is_stopped() {
                return Comparison { summary: pair.summary(), end: End::Interrupted };
            }
            if let Err(failure) = pair.step(*op) {
                return failed(pair.summary(), before, failure.to_string());
            }
        }
        Comparison { summary: pair.summary(), end: End::Finished }
    }

    fn to_rust(&self, message: &str, program: &Program) -> String {
        self.test_source().map_or_else(|| program.to_rust(), |source| source.test(message, program))
    }
}
