//! Every program does the same to the pointer model and to this crate's structure, with limits and without: the same refusals,
//! the same map after each step, and no violation.

use crate::support::erased::validate;
use quickcheck::{Arbitrary, Gen, QuickCheck};
use twinedge::dcel::{Dcel, Room};
use twinedge::program::canonical::{Canonizer, Code};
use twinedge::program::{Op, PointerModel, Program, Refusal, Runner, StepOutcome, Subject};
use twinedge::validate::{Collect, Expectation};

const SIZE: usize = 100;
const SEED: u64 = 11;
const TESTS: u64 = 1000;

/// A subject in a run, and a function that inspects it.
struct Lane<K: Subject> {
    runner: Runner<K>,
    canonizer: Canonizer,
}

impl<K: Subject> Lane<K> {
    fn new(subject: K) -> Self {
        Self { runner: Runner::new(subject), canonizer: Canonizer::new() }
    }

    /// Runs an operator, and returns its outcome and the resulting map.
    fn step(&mut self, op: Op) -> (StepOutcome, Option<Code>) {
        let outcome = self.runner.step(op);
        let report = validate(self.runner.subject(), &Expectation::plane(), Collect::All);
        assert!(report.is_valid(), "{op:?}: {report:?}");
        (outcome, self.canonizer.subdivision(self.runner.subject()))
    }
}

/// Returns the operator after which two subjects differ. A full subject drops out.
fn first_difference(program: &Program) -> Option<Op> {
    let mut pointer_model = Lane::new(PointerModel::new());
    let mut slots = Lane::new(Dcel::new());
    let most = Room { vertices: 30, edges: 40, boundaries: 30, faces: 20 };
    let mut limited = Some(Lane::new(Dcel::with_limits(most)));
    program.0.iter().copied().find(|op| {
        let expected = pointer_model.step(*op);
        assert!(expected.1.is_some(), "{op:?}: a valid map has a canonical form");
        let of_limited = limited.as_mut().map(|lane| lane.step(*op));
        if matches!(of_limited, Some((StepOutcome::Refused(Refusal::Full), _))) {
            limited = None;
        }
        expected != slots.step(*op) || (limited.is_some() && of_limited.as_ref() != Some(&expected))
    })
}

#[allow(clippy::needless_pass_by_value, reason = "what quickcheck hands over")]
fn in_step(program: Program) -> bool {
    first_difference(&program).is_none()
}

#[test]
fn all_subjects_stay_in_step() {
    QuickCheck::new().rng(Gen::from_size_and_seed(SIZE, SEED)).tests(TESTS).quickcheck(in_step as fn(Program) -> bool);
}

#[test]
fn all_subjects_stay_in_step_for_long() {
    QuickCheck::new().rng(Gen::from_size_and_seed(1000, SEED)).tests(10).quickcheck(in_step as fn(Program) -> bool);
}

/// The programs of the test above cover every operator and every refusal.
#[test]
fn programs_meet_every_refusal() {
    let mut met: Vec<Refusal> = Vec::new();
    let mut generator = Gen::from_size_and_seed(SIZE, SEED);
    for _ in 0..TESTS {
        for outcome in Runner::new(PointerModel::new()).run(&Program::arbitrary(&mut generator)) {
            if let StepOutcome::Refused(refusal) = outcome
                && !met.contains(&refusal)
            {
                met.push(refusal);
            }
        }
    }
    met.sort_unstable();
    let all = [
        Refusal::Stale,
        Refusal::NotIsolated,
        Refusal::FacesDiffer,
        Refusal::VerticesDiffer,
        Refusal::NotInner,
        Refusal::IsOuter,
        Refusal::DegreeNotTwo,
        Refusal::Loop,
        Refusal::NotSeparating,
        Refusal::InsideItself,
    ];
    assert_eq!(met, all);
}
