//! Whole structures at once: from faces, from rotations, retained, compacted.

mod compact;
mod faces;
mod retain;
mod rotations;

use quickcheck::{Gen, QuickCheck, Testable};
use twinedge::dcel::Dcel;
use twinedge::program::{Program, Runner};

fn check(tests: u64, size: usize, law: impl Testable) {
    QuickCheck::new().rng(Gen::from_size_and_seed(size, 2026)).tests(tests).quickcheck(law);
}

fn built(program: &Program) -> Dcel {
    let mut runner = Runner::new(Dcel::default());
    runner.run(program);
    runner.into_subject()
}
