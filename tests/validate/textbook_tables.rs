//! The tables of the textbooks, and every change of one of their fields.

use crate::support::erased::validate;
use crate::support::nested::PLANE;
use crate::support::opinions::agree;
use crate::support::tables::{face, with_boundary_components};
use crate::support::textbook::{DANGLING, FIVE_FACES, Textbook};
use std::collections::BTreeSet;
use twinedge::validate::{Collect, Expectation, FaceRow, Figures, Rule, Start, Table, Unchecked, View};
use twinedge_trials::enumerate::{Cell, Value, for_each_corruption};

fn figures(table: &Table, expectation: Expectation) -> Figures {
    assert_eq!(agree(table, expectation), None);
    validate(table, &expectation, Collect::All).figures().unwrap()
}

#[test]
fn the_maps_are_accepted() {
    for (textbook, [vertices, edges, faces], most) in [(DANGLING, [4, 4, 2], (6, 4)), (FIVE_FACES, [6, 9, 5], (12, 8))]
    {
        for table in [textbook.table(), with_boundary_components(&textbook.table())] {
            let found = figures(&table, PLANE);
            assert_eq!([found.vertices, found.edges, found.faces, found.cycles], [vertices, edges, faces, faces]);
            assert_eq!((found.components, found.isolated_vertices, found.genus), (1, 0, 0));
            let bounds = found.bounds.unwrap();
            assert_eq!((bounds.most_edges, bounds.most_faces), most);
            assert_eq!(found.not_checked, []);
        }
    }
}

#[test]
fn the_first_four_faces_of_the_second_map_are_triangles() {
    let table = FIVE_FACES.table();
    let sides = |f| (0..18).filter(|h| table.face(*h) == Some(f)).count();
    assert_eq!([0, 1, 2, 3, 4].map(sides), [3, 3, 3, 3, 6]);
}

/// The other completion of the second map: e7 joins v5 to v6, and e9 joins v3 to v5.
#[test]
fn the_other_completion_is_accepted_too() {
    let half_edges = "
        e1,1  V3  e1,2  f1  e2,1  e3,1
        e1,2  V1  e1,1  f5  e9,2  e2,2
        e2,1  V1  e2,2  f1  e3,1  e1,1
        e2,2  V2  e2,1  f5  e1,2  e4,2
        e3,1  V2  e3,2  f1  e1,1  e2,1
        e3,2  V3  e3,1  f2  e4,1  e5,1
        e4,1  V2  e4,2  f2  e5,1  e3,2
        e4,2  V4  e4,1  f5  e2,2  e8,2
        e5,1  V4  e5,2  f2  e3,2  e4,1
        e5,2  V3  e5,1  f3  e6,1  e9,1
        e6,1  V4  e6,2  f3  e9,1  e5,2
        e6,2  V5  e6,1  f4  e8,1  e7,1
        e7,1  V6  e7,2  f4  e6,2  e8,1
        e7,2  V5  e7,1  f5  e8,2  e9,2
        e8,1  V4  e8,2  f4  e7,1  e6,2
        e8,2  V6  e8,1  f5  e4,2  e7,2
        e9,1  V5  e9,2  f3  e5,2  e6,1
        e9,2  V3  e9,1  f5  e7,2  e1,2";
    let table = Textbook { half_edges, ..FIVE_FACES }.table();
    assert_eq!(figures(&table, PLANE).faces, 5);
}

/// The changes of one field that produce another valid table, each with the reason. There are only two reasons: a
/// vertex may store any leaving half-edge, and a boundary component may start at any half-edge of its cycle.
fn harmless(textbook: &Table, records: &Table, by_record: bool) -> BTreeSet<(Cell, Value)> {
    let half_edges = 0..textbook.half_edges.len();
    let mut harmless = BTreeSet::new();
    for h in half_edges.clone() {
        let v = textbook.origin(h).unwrap();
        if textbook.leaving(v) != Some(h) {
            harmless.insert((Cell::Leaving(v), Value::Link(Some(h))));
        }
    }
    for (f, face) in textbook.faces.iter().flatten().enumerate() {
        // In these two maps each face has one boundary component.
        for h in half_edges.clone().filter(|h| textbook.face(*h) == Some(f)) {
            let start = Some(Start::HalfEdge(h));
            let (cell, value, before) = if by_record {
                let b = records.boundary(h).unwrap();
                (Cell::BoundaryStart(b), Value::Start(start), Value::Start(records.boundary_start(b)))
            } else if face.outer_half_edge.is_some() {
                (Cell::OuterHalfEdge(f), Value::Link(Some(h)), Value::Link(face.outer_half_edge))
            } else {
                (Cell::InnerStart(f, 0), Value::Start(start), Value::Start(face.inner_starts[0]))
            };
            if value != before {
                harmless.insert((cell, value));
            }
        }
    }
    harmless
}

/// Changes one field at a time; returns the numbers of changes and of harmless ones.
fn change_every_field(textbook: &Table, by_record: bool) -> (usize, usize) {
    let records = with_boundary_components(textbook);
    let mut table = if by_record { records.clone() } else { textbook.clone() };
    let (mut changes, mut accepted) = (0, BTreeSet::new());
    let parts = table.parts;
    for_each_corruption(&mut table, parts, |changed, cell, value| {
        changes += 1;
        if agree(changed, PLANE).is_none() {
            accepted.insert((cell, value));
        }
    });
    assert_eq!(accepted, harmless(textbook, &records, by_record));
    (changes, accepted.len())
}

/// A link has all slots plus two more wrong values (nil, and two past the end, minus the original value). A start may
/// be any half-edge or vertex.
///
/// There are 2E − V harmless changes at the vertices and 2E − cycles at the starts.
#[test]
fn every_change_of_one_field_is_judged_right() {
    for (textbook, [v, h, f]) in [(DANGLING, [4, 8, 2]), (FIVE_FACES, [6, 18, 5])] {
        let table = textbook.table();
        let harmless = (h - v) + (h - f);
        let rows = h * ((v + 2) + 3 * (h + 2) + (f + 2)) + v * (h + 2);
        // Each face has one boundary component, and one face lists it as an inner one.
        let starts = h + v + 4;
        assert_eq!(change_every_field(&table, false), (rows + f * (h + 2) + starts, harmless));
        let by_record = rows + v * (f + 2) + f * (f + 2 + starts + 4) + f * (f + 2) + f + 2;
        assert_eq!(change_every_field(&table, true), (by_record, harmless));
    }
}

/// A list with one entry too many or too few is never valid, whatever the entry.
#[test]
fn every_change_of_the_length_of_a_list_is_caught() {
    for textbook in [DANGLING, FIVE_FACES] {
        let table = textbook.table();
        let records = with_boundary_components(&table);
        for f in 0..table.faces.len() {
            for h in 0..=table.half_edges.len() {
                let mut longer = table.clone();
                face(&mut longer, f).inner_starts.push(Some(Start::HalfEdge(h)));
                assert!(agree(&longer, PLANE).is_some());
            }
            for v in 0..=table.vertices.len() {
                let mut longer = table.clone();
                face(&mut longer, f).inner_starts.push(Some(Start::Vertex(v)));
                assert!(agree(&longer, PLANE).is_some());
            }
            for b in 0..=records.boundaries.len() {
                let mut longer = records.clone();
                face(&mut longer, f).inner.push(Some(b));
                assert!(agree(&longer, PLANE).is_some());
            }
            let (mut shorter, mut shorter_records) = (table.clone(), records.clone());
            if face(&mut shorter, f).inner_starts.pop().is_some() {
                face(&mut shorter_records, f).inner.pop();
                assert_eq!(agree(&shorter, PLANE), Some(Rule::F2));
                assert_eq!(agree(&shorter_records, PLANE), Some(Rule::F2));
            }
        }
    }
}

/// The tables as a mesh would store them: without lists of inner boundary components, the unbounded face is an ordinary
/// face.
#[test]
fn the_maps_are_meshes_of_a_sphere_too() {
    for (textbook, unbounded, start) in [(DANGLING, 0, 0), (FIVE_FACES, 4, 17)] {
        let mut table = textbook.table();
        table.faces[unbounded] = Some(FaceRow { outer_half_edge: Some(start), ..FaceRow::default() });
        let found = figures(&table, Expectation::surface());
        assert_eq!(found.genus, 0);
        let reasons = [
            (Rule::B2, Unchecked::PlaneOnly),
            (Rule::T1, Unchecked::PlaneOnly),
            (Rule::T2, Unchecked::PlaneOnly),
            (Rule::T4, Unchecked::PlaneOnly),
        ];
        assert_eq!(found.not_checked, reasons);
    }
}
