//! Random tables, valid or invalid.
//!
//! Beyond all small tables, these are maps of several components with nesting, vacant rows and records in random order. They come
//! from random programs, and from random rotation systems with random containment. The latter may have handles (T3), components
//! nested in themselves (T2), no outside or two (T1), and two merged vertices (V2), which programs never make. Most of them are
//! then damaged, usually with unchanged counts: two cells, two records, two cycles or the lists of two faces are exchanged.
//!
//! Each rule except T4 is often the first broken one. T4 follows from the others.

mod damage;
mod subdivision;

use crate::corrupt::RuleRow;
use crate::outcome::{Outcome, Results, faults};
use crate::random::Random;
use crate::rows::{add_findings, add_rows};
use crate::run::{Estimate, Run};
use crate::verdict::{Checker, Judgement};
use damage::damage;
use subdivision::subdivision;
use twinedge::dcel::Dcel;
use twinedge::program::{Op, Program, Runner};
use twinedge::validate::{Expectation, Rule, Table};

/// Judges random tables by a validator and by the reference. O(1) for each table: it has at most about 40 edges.
///
/// The tables are always the same for the same seed, on any number of threads, in any order.
///
/// # Panics
/// If the checker panics.
///
/// # Examples
/// ```
/// use twinedge_trials::sample::SampleWork;
/// use twinedge_trials::{Run, Validator, sample};
/// let outcome = sample(SampleWork { tables: 2_000, seed: 1 }, &Validator, &Run::default()).into_result()?;
/// assert!(outcome.right > 100 && outcome.right < outcome.judged);
/// # Ok::<(), twinedge_trials::Failed>(())
/// ```
pub fn sample(work: SampleWork, checker: &dyn Checker, run: &Run<'_>) -> Outcome<SampleResults> {
    let pieces: Vec<usize> = run.part().numbers(work.pieces() as usize).collect();
    let found = run.each("tables", pieces.len(), Judgement::default, |judged, position| {
        for table in work.piece(pieces[position] as u64) {
            if run.is_stopped() {
                return;
            }
            judged.compare(&table, &Expectation::plane(), checker);
        }
    });
    let all = Judgement::sum(found);
    let rules = Rule::ALL.iter().filter(|rule| !rule.is_geometric() && !rule.is_optional());
    let results = SampleResults {
        judged: all.tables,
        right: all.tables - all.first_broken.values().sum::<u64>(),
        first_broken: rules
            .map(|rule| RuleRow { rule: *rule, wrong: all.first_broken.get(rule).copied().unwrap_or(0) })
            .collect(),
        disagreements: all.disagreements,
        findings: all.findings,
    };
    Outcome::new(work, run, results)
}

/// The results of [`sample()`](crate::sample()).
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct SampleResults {
    /// The number of judged tables.
    pub judged: u64,
    /// The number of valid ones, by the reference.
    pub right: u64,
    /// For each rule, the number of tables that break it first, by the reference.
    pub first_broken: Vec<RuleRow>,
    /// The number of differences between the validator and the reference.
    pub disagreements: u64,
    /// The first disagreements. All are counted.
    pub findings: Vec<String>,
}

impl Results for SampleResults {
    type Work = SampleWork;

    fn reasons(&self, _: &Self::Work, _: bool) -> Vec<String> {
        faults("disagreements", self.disagreements, &self.findings)
    }

    fn absorb(&mut self, other: &Self) {
        self.judged += other.judged;
        self.right += other.right;
        add_rows(&mut self.first_broken, &other.first_broken);
        self.disagreements += other.disagreements;
        add_findings(&mut self.findings, &other.findings);
    }
}

pub(super) const TABLES_OF_A_PIECE: u64 = 1000;

/// The work of `sample`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SampleWork {
    /// The number of tables.
    pub tables: u64,
    /// Their seed.
    pub seed: u64,
}

impl SampleWork {
    /// Returns the approximate number of judged tables.
    #[must_use]
    pub fn estimate(&self) -> Estimate {
        Estimate { amount: self.tables.into(), unit: "tables", per_second: 50_000 }
    }

    pub(super) const fn pieces(&self) -> u64 {
        self.tables.div_ceil(TABLES_OF_A_PIECE)
    }

    pub(super) fn piece(&self, number: u64) -> impl Iterator<Item = Table> + use<> {
        let mut random = Random::new(self.seed, number);
        let count = TABLES_OF_A_PIECE.min(self.tables - number * TABLES_OF_A_PIECE);
        (0..count).map(move |_| table(&mut random))
    }
}

/// Returns one table: the map of a random program, or random rotations with random containment, damaged up to three times.
fn table(random: &mut Random) -> Table {
    let mut table = if random.below(5) == 0 { made_by_program(random) } else { subdivision(random) };
    for _ in 0..[0, 1, 1, 2, 2, 3][random.below(6)] {
        damage(&mut table, random);
    }
    table
}

fn made_by_program(random: &mut Random) -> Table {
    let mut bytes = Random::new(random.next(), 0).bytes();
    let ops = std::iter::from_fn(|| Op::from_bytes(&mut bytes));
    let program: Program = ops.take(5 + random.below(25)).collect();
    let mut runner = Runner::new(Dcel::new());
    for op in &program.0 {
        runner.step(*op);
    }
    // Without enough memory for such a small table, an empty one is judged.
    let mut table = Table::copy_of(runner.subject()).unwrap_or_default();
    // These fields belong to tables without boundary components.
    for row in table.half_edges.iter_mut().flatten() {
        row.face = None;
    }
    for row in table.faces.iter_mut().flatten() {
        row.outer_half_edge = None;
        row.inner_starts.clear();
    }
    table
}
