//! Audited structures record every write of an operator, and otherwise behave like the inner structure.

use crate::support::changes::difference;
use twinedge::dcel::{Audited, Dcel};
use twinedge::program::{Program, Runner, StepOutcome, conformance, every_op};
use twinedge::validate::{Expectation, Table, View};
use twinedge_trials::ReportAudit;
use twinedge_trials::census::{Census, Scope};

/// Every record that an operator changes is reported as written.
#[test]
fn what_changes_is_written() {
    let mut applied = 0;
    for map in Census::new(Scope::Subdivisions { edges: 3, vertices: 2 }) {
        let mut built = Runner::new(Dcel::new());
        built.run(&map.program);
        let before = Table::copy_of(built.subject()).unwrap();
        for op in every_op(&built) {
            let mut runner = Runner::new(Audited::new(Dcel::new()).unwrap());
            runner.run(&map.program);
            if runner.step(op) != StepOutcome::Applied {
                continue;
            }
            applied += 1;
            let after = Table::copy_of(runner.subject()).unwrap();
            let (written, changed) = (runner.subject().written(), difference(&before, &after));
            assert!(changed.vertices.iter().all(|v| written.vertices.contains(v)), "{op:?}: {changed:?}");
            assert!(changed.half_edges.iter().all(|h| written.half_edges.contains(h)), "{op:?}: {changed:?}");
            assert!(changed.boundaries.iter().all(|b| written.boundaries.contains(b)), "{op:?}: {changed:?}");
            assert!(changed.faces.iter().all(|f| written.faces.contains(f)), "{op:?}: {changed:?}");
            let mut listed = changed.listed.iter().filter(|(f, i)| after.is_face(*f) && *i < after.inner_count(*f));
            assert!(listed.all(|entry| written.listed.contains(entry)), "{op:?}: {changed:?}");
        }
    }
    assert!(applied > 1_000, "{applied}");
}

/// Several operators form one change, and keys are those in the inner structure.
#[test]
fn a_change_may_be_several_operators() {
    let mut dcel = Dcel::new();
    let v = dcel.add_isolated_vertex(dcel.unbounded_face().key()).unwrap().vertex;
    let mut audited = Audited::new(dcel).unwrap();
    let faces = audited
        .change(|dcel| {
            for _ in 0..3 {
                dcel.connect(v, v, twinedge::dcel::Split::default()).unwrap();
                let h = dcel.half_edges().next().unwrap().key();
                dcel.remove_edge(h).unwrap();
            }
            dcel.face_count()
        })
        .unwrap();
    assert_eq!(faces, audited.get().face_count());
    assert!(!audited.written().is_empty());
    let dcel = audited.into_inner();
    assert!(dcel.vertex(v).is_ok() && dcel.validate().is_valid());
    conformance::run(&Program::default(), ReportAudit::new(dcel), &Expectation::plane()).unwrap();
}
