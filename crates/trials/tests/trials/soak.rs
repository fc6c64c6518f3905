//! `soak` and `replay`.

use super::incomplete::Partial;
use super::{panics, slots};
use std::sync::atomic::{AtomicUsize, Ordering};
use twinedge::program::{Call, Program, StepOutcome};
use twinedge::validate::{Expectation, Part};
use twinedge_trials::TestSource;
use twinedge_trials::soak::{Comparable, End, SoakWork};
use twinedge_trials::{Progress, Run, Silent, Structure, replay, soak};

const WORK: SoakWork = SoakWork { programs: 30, steps: 40, seed: 1 };

#[test]
fn a_failing_program_is_made_small() {
    let failure = soak(&[&slots(), &panics()], WORK, &Run::default()).results.failure.unwrap();
    assert_eq!(failure.on, "panics");
    assert_eq!(failure.program, "twinedge program 1\nadd_isolated_vertex unbounded\nmove_inner i0 unbounded\n");
    assert!(failure.message.contains("panicked: a planted panic ("), "{}", failure.message);
    // Without the names in source, the program alone.
    assert_eq!(failure.rust, failure.program.parse::<Program>().unwrap().to_rust());
    let source = TestSource { imports: &["mine::Mine"], make: "Mine::new()", expectation: "EXPECTED", remark: "Why." };
    let failure = soak(&[&panics().source(source)], WORK, &Run::default()).results.failure.unwrap();
    for line in
        ["use mine::Mine;", "    // Why.", "    let result = conformance::run(&program, Mine::new(), &EXPECTED);"]
    {
        assert!(failure.rust.lines().any(|other| other == line), "{}", failure.rust);
    }
}

#[test]
fn a_failure_is_told_with_its_program() {
    let reasons = soak(&[&panics()], WORK, &Run::default()).into_result().unwrap_err().to_string();
    assert!(
        reasons.contains("panics differs from the reference in program ") && reasons.contains(".parse::<Program>()"),
        "{reasons}"
    );
}

#[test]
fn a_structure_that_cannot_be_compared_fails_at_the_start() {
    let less = Structure::new("less", || Partial::without(Part::Faces), Expectation::plane());
    let comparison = less.compare(&WORK.program(0), &Silent);
    assert!(
        comparison.failure().unwrap().starts_with("at the start: the structure is empty, and stores no faces"),
        "{comparison:?}"
    );
}

#[test]
fn a_program_is_interrupted_between_two_operators() {
    struct StopAfter(AtomicUsize);
    impl Progress for StopAfter {
        fn is_stopped(&self) -> bool {
            self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1)).is_err()
        }
    }
    let comparison = slots().compare(&WORK.program(0), &StopAfter(7.into()));
    assert_eq!((comparison.summary.total().all(), comparison.end), (7, End::Interrupted));
    let progress = StopAfter(100.into());
    let outcome = soak(&[&slots()], WORK, &Run::default().threads(1).progress(&progress));
    let row = &outcome.structures[0];
    assert!(outcome.interrupted && !outcome.is_ok() && outcome.failure.is_none());
    assert_eq!((row.programs, row.cut_short), (2, 1));
}

#[test]
fn a_replay_keeps_each_step() {
    let program = "twinedge program 1\nadd_isolated_vertex unbounded\nsplit_vertex i0 i0\nremove_edge !h0\n";
    let steps = replay(&slots(), &program.parse().unwrap());
    let after: Vec<_> = steps.iter().map(|step| step.outcome.as_ref().unwrap()).collect();
    assert_eq!(after.iter().map(|after| after.report.counts().edges).collect::<Vec<_>>(), [0, 1, 1]);
    assert!(after.iter().all(|after| after.report.is_valid()));
    assert_eq!(after[1].table.as_ref().unwrap().half_edges.iter().flatten().count(), 2);
    // The face and the vertex have indices, and the stale edge was not chosen.
    assert!(matches!(steps[0].call, Some(Call::AddIsolatedVertex { face: Some(_) })));
    assert_eq!((&steps[2].call, after[2].outcome), (&None, StepOutcome::Skipped));
}

#[test]
fn a_replay_ends_with_a_panic() {
    let program =
        "twinedge program 1\nadd_isolated_vertex unbounded\nmove_inner i0 unbounded\nadd_isolated_vertex unbounded\n";
    let steps = replay(&panics(), &program.parse().unwrap());
    assert_eq!(steps.len(), 2);
    assert!(steps[1].outcome.as_ref().unwrap_err().starts_with("a planted panic ("), "{:?}", steps[1]);
}
