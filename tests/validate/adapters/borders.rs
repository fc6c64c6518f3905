//! Borders without `next`.

use super::{MESH, fan, with_bare_border};
use crate::support::erased::{first_broken_rule, validate};
use crate::support::opinions::agree;
use crate::support::tables::{TETRAHEDRON, half_edge, textbook_mesh};
use twinedge::validate::adapt::Borders;
use twinedge::validate::{Collect, Rule, Table, View, Violation};

#[test]
fn a_border_without_next_is_linked() {
    let table = fan();
    assert_eq!(agree(&table, MESH.open()), Some(Rule::R1));
    let linked = Borders::of(&table).unwrap();
    assert_eq!(first_broken_rule(&linked, &MESH.open()), None);
    let found = validate(&linked, &MESH.open(), Collect::All).into_result().unwrap();
    assert_eq!((found.cycles, found.edges, found.borders), (3, 7, 1));
    // Its other links are unchanged, and missing half-edges have none.
    for h in (0..14).filter(|h| table.half_edges[*h].unwrap().face.is_some()) {
        assert_eq!((linked.next(h), linked.prev(h)), (table.next(h), table.prev(h)));
    }
    assert_eq!((linked.next(99), linked.prev(usize::MAX)), (None, None));
}

/// Two triangles sharing only a vertex: two borders, and the fans are not joined, so V2 reports them.
#[test]
fn each_fan_has_a_border_of_its_own() {
    let table = with_bare_border(5, &[[0, 1, 2], [0, 3, 4]]);
    let report = validate(&Borders::of(&table).unwrap(), &MESH.open(), Collect::All);
    let Some(Violation::SplitRotation { vertex, reached, degree, .. }) = report.first() else { panic!("{report}") };
    assert_eq!((*vertex, *reached, *degree, report.violations().len()), (0, 2, 4, 1));
}

/// A border either lacks every `next` or none, and a cycle that is no border gets no `next`.
#[test]
fn a_border_with_one_next_is_refused() {
    let right = Table::copy_of(&Borders::of(&fan()).unwrap()).unwrap();
    assert_eq!(agree(&right, MESH.open()), None);
    let broken = |table: &Table| first_broken_rule(&Borders::of(table).unwrap(), &MESH.open());
    assert_eq!(broken(&right), None);
    for h in 0..14 {
        let mut mixed = fan();
        half_edge(&mut mixed, h).next = if fan().next(h).is_none() { right.next(h) } else { None };
        assert_eq!(broken(&mixed), Some(Rule::R1));
        // A half-edge whose twin is also missing.
        let mut single = fan();
        half_edge(&mut single, h).twin = None;
        assert!(broken(&single).is_some());
    }
}

/// Half-edges that name a face are on no border, even if their cycle lacks every `next`.
#[test]
fn the_cycle_of_a_face_is_no_border() {
    let whole = textbook_mesh(4, &TETRAHEDRON);
    let mut without = whole.clone();
    for row in without.half_edges.iter_mut().flatten().filter(|row| row.face == Some(3)) {
        row.next = None;
    }
    let report = validate(&Borders::of(&without).unwrap(), &MESH.open(), Collect::All);
    assert_eq!(report.broken_rules().next(), Some(Rule::R1), "{report}");
    // They are on a border if they name no face.
    without.half_edges.iter_mut().flatten().filter(|row| row.next.is_none()).for_each(|row| row.face = None);
    without.faces.pop();
    assert_eq!(first_broken_rule(&Borders::of(&without).unwrap(), &MESH.open()), None);
}
