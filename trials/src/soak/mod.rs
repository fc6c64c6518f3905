//! Random programs in step with a reference.
//!
//! The reference, [`PointerModel`](twinedge::program::PointerModel), is written from the definitions of the operators. After each
//! operator the structure must have the same outcome (applied, refused for the same reason, or skipped), and it must be valid and
//! isomorphic, including nesting, with equal handles. Programs use stale handles. The first that fails, or panics, is made small.
//!
//! Reports of operators beyond handles are specific to a structure. [`ReportAudit`](crate::ReportAudit) checks them for `Dcel`.

mod in_step;
mod outcome;
mod work;

pub use in_step::{Comparable, Comparison, End};
pub use outcome::{SoakFailure, SoakOutcome, SoakRow};
pub use work::SoakWork;

use crate::rows::add_rows;
use crate::run::Run;
use std::sync::atomic::{AtomicU64, Ordering};
use twinedge::program::{Program, candidates};

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
/// assert!(outcome.failure.unwrap().program.contains("flip_edge"));
/// ```
pub fn soak(structures: &[&dyn Comparable], work: SoakWork, run: &Run<'_>) -> SoakOutcome {
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
    SoakOutcome {
        work,
        shard: run.part(),
        seed: work.seed,
        structures,
        failure: failed.map(|failed| failed.made_small(&work, run)),
        interrupted: run.is_stopped(),
    }
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
