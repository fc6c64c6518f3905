//! Every program does the same to the pointer model and to this crate's structure, with limits and without: the same refusals,
//! the same map after each step, and no violation.

use quickcheck::{Gen, QuickCheck};
use twinedge::dcel::{Dcel, Room};
use twinedge::program::Program;
use twinedge::program::conformance::{Conformance, Coverage};
use twinedge::validate::Expectation;

#[test]
fn all_subjects_stay_in_step() {
    fn law(program: Program) {
        let settings = Conformance::of(&Expectation::plane()).coverage(Coverage::Nothing);
        let most = Room { vertices: 30, edges: 40, boundaries: 30, faces: 20 };
        for subject in [Dcel::new(), Dcel::with_limits(most)] {
            settings.run(&program, subject).unwrap_or_else(|failure| panic!("{failure}\n{program}"));
        }
    }
    for (size, tests) in [(100, 1000), (1000, 10)] {
        QuickCheck::new().rng(Gen::from_size_and_seed(size, 11)).tests(tests).quickcheck(law as fn(Program));
    }
}
