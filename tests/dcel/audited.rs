//! Audited structures record every write of an operator, and otherwise behave like the inner structure.

use twinedge::dcel::{Audited, Dcel};
use twinedge::program::{Program, Runner, StepOutcome, conformance, every_op};
use twinedge::validate::{Expectation, Table};
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
            let (after, written) = (Table::copy_of(runner.subject()).unwrap(), runner.subject().written());
            differ(&before.vertices, &after.vertices, |v| assert!(written.vertices.contains(&v), "{op:?}: vertex {v}"));
            differ(&before.half_edges, &after.half_edges, |h| {
                assert!(written.half_edges.contains(&h), "{op:?}: half-edge {h}");
            });
            differ(&before.boundaries, &after.boundaries, |b| {
                assert!(written.boundaries.contains(&b), "{op:?}: boundary component {b}");
            });
            differ(&before.faces, &after.faces, |f| {
                assert!(written.faces.contains(&f), "{op:?}: face {f}");
                let list = |table: &Table| match table.faces.get(f) {
                    Some(Some(row)) => row.inner.clone(),
                    _ => vec![],
                };
                let (before, after) = (list(&before), list(&after));
                for i in (0..after.len()).filter(|i| before.get(*i) != after.get(*i)) {
                    assert!(written.listed.contains(&(f, i)), "{op:?}: entry {i} of face {f}");
                }
            });
        }
    }
    assert!(applied > 1_000, "{applied}");
}

fn differ<R: PartialEq>(before: &[Option<R>], after: &[Option<R>], mut visit: impl FnMut(usize)) {
    for i in 0..before.len().max(after.len()) {
        let row = |rows: &[Option<R>]| rows.get(i).is_some_and(Option::is_some);
        if row(before) != row(after) || row(before) && before[i] != after[i] {
            visit(i);
        }
    }
}

#[test]
fn it_does_what_the_operators_say() {
    let summary = conformance::check(|| Audited::new(Dcel::new()).unwrap(), &Expectation::plane()).unwrap();
    assert!(summary.of("contract_edge").unwrap().applied > 0);
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
