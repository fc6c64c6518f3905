//! Operators change the counts of a map as stated in the table of operators.

use quickcheck::{Gen, QuickCheck};
use std::collections::BTreeSet;
use std::sync::Mutex;
use twinedge::dcel::Dcel;
use twinedge::program::{CountChange, Op, OpKind, Program, Runner, StepOutcome, every_mesh_op, every_op};

/// V, E, F and C.
fn counts(map: &Dcel) -> [usize; 4] {
    let report = map.validate();
    let components = report.counts().components.unwrap();
    [map.vertex_count(), map.edge_count(), map.face_count(), components]
}

/// The changes seen, by operator name.
static MET: Mutex<BTreeSet<(&str, [i8; 4])>> = Mutex::new(BTreeSet::new());

fn as_numbers(change: CountChange) -> [i8; 4] {
    [change.vertices, change.edges, change.faces, change.components]
}

#[test]
fn counts_change_as_the_table_says() {
    fn law(program: Program) {
        let mut runner = Runner::new(Dcel::new());
        let mut before = counts(runner.subject());
        for op in program.0 {
            let outcome = runner.step(op);
            let after = counts(runner.subject());
            let change: [i8; 4] =
                std::array::from_fn(|i| i8::try_from(after[i].cast_signed() - before[i].cast_signed()).unwrap());
            if outcome == StepOutcome::Applied {
                assert!(op.kind().changes().iter().any(|promised| as_numbers(*promised) == change), "{op}: {change:?}");
                MET.lock().unwrap().insert((op.name(), change));
            } else {
                assert_eq!(change, [0; 4]);
            }
            before = after;
        }
    }
    QuickCheck::new().rng(Gen::from_size_and_seed(100, 2026)).tests(100).quickcheck(law as fn(Program));
    let drawn = OpKind::SHARES.iter().filter(|(_, share)| *share > 0);
    let promised = drawn.flat_map(|(kind, _)| kind.changes().iter().map(|change| (kind.name(), as_numbers(*change))));
    assert_eq!(*MET.lock().unwrap(), promised.collect());
}

#[test]
fn every_operator_is_among_all_that_can_be_tried() {
    let mut runner = Runner::new(Dcel::new());
    runner.run(
        &"twinedge program 1\nadd_isolated_vertex unbounded\nsplit_vertex i0 i0\nadd_isolated_vertex h0"
            .parse()
            .unwrap(),
    );
    let all = every_op(&runner).into_iter().chain(every_mesh_op(&runner));
    let tried: BTreeSet<&str> = all.map(|op| op.name()).collect();
    assert_eq!(tried, Op::NAMES.iter().copied().collect());
    assert!(every_op(&runner).iter().all(|op| op.to_string().starts_with(op.name())));
}
