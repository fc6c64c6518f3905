//! The work of `sample`.

use super::damage::damage;
use super::subdivision::subdivision;
use crate::random::Random;
use crate::run::Estimate;
use twinedge::dcel::Dcel;
use twinedge::program::{Op, Program, Runner};
use twinedge::validate::Table;

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
