//! Certificates: a valid structure has labels that pass, and nothing else has.

use crate::tables::{TETRAHEDRON, Without, half_edge, textbook_mesh, torus, vertex, with_boundary_components};
use std::cell::Cell;
use std::collections::BTreeSet;
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{BoundaryPlace, Expectation, Only, Part, Parts, Rule, Start, Table, View};
use twinedge_certificate::{
    Certificate, Column, Labels, LabelsError, SurfaceCertificate, Test, check, check_surface, passes, passes_surface,
};
use twinedge_trials::census::{Census, Scope};
use twinedge_trials::corrupt::{CorruptWork, abort};
use twinedge_trials::enumerate::for_each_corruption;
use twinedge_trials::forms::{Form, forms, projected};
use twinedge_trials::sample::SampleWork;
use twinedge_trials::tables::TablesWork;
use twinedge_trials::{Certificates, RawPointers, Run, Structure, corrupt, sample, tables};

const PLANE: Expectation = Expectation::plane();

fn small_maps() -> impl Iterator<Item = Table> {
    Census::new(Scope::Subdivisions { edges: 3, vertices: 4 }).map(|map| Table::copy_of(map.runner.subject()).unwrap())
}

/// The forms of a closed planar subdivision that have labels.
fn certified_forms() -> Vec<Form> {
    let has_labels = |form: &Form| {
        form.expectation == PLANE && (!form.parts.has(Part::Faces) || form.parts.has(Part::UnboundedFace))
    };
    forms().into_iter().filter(has_labels).collect()
}

#[test]
fn every_small_map_in_every_form_has_labels() {
    let (mut maps, mut certificates) = (0, 0);
    for table in small_maps() {
        maps += 1;
        for form in certified_forms() {
            let projection = projected(&table, &form);
            let labels = Labels::new(&projection).unwrap();
            assert_eq!(check(&projection, &labels), Ok(()), "{projection}");
            let certificate = Certificate::new(&projection, &labels).unwrap();
            assert_eq!(certificate.check(), Ok(()), "{projection}");
            assert_eq!(first_broken_rule(&certificate, &PLANE), None, "{projection}");
            certificates += 1;
        }
    }
    assert_eq!((maps, certificates), (537, 8592));
}

/// With the labels of the original map, a corruption that passes is valid; and a valid one is another map, with its own labels.
#[test]
fn a_corruption_passes_only_if_the_rules_hold() {
    let (mut wrong, mut right, mut other_maps) = (0, 0, 0);
    for table in small_maps().filter(|table| table.half_edges.len() <= 4) {
        for form in certified_forms() {
            let mut projection = projected(&table, &form);
            let labels = Labels::new(&projection).unwrap();
            for_each_corruption(&mut projection, form.parts, |corrupt, cell, value| {
                let found = check(corrupt, &labels);
                let is_certified = found.is_ok();
                assert_eq!(passes(corrupt, &labels), is_certified, "{cell:?} = {value:?}: {corrupt}");
                let broken = first_broken_rule(corrupt, &PLANE);
                let own = Labels::new(corrupt).unwrap();
                assert_eq!(check(corrupt, &own).is_ok(), broken.is_none(), "{cell:?} = {value:?}: {corrupt}");
                let stands_alone = Certificate::new(corrupt, &own).is_ok_and(|certificate| certificate.check().is_ok());
                assert_eq!(stands_alone, broken.is_none(), "{cell:?} = {value:?}: {corrupt}");
                assert!(!is_certified || broken.is_none(), "{cell:?} = {value:?}: {corrupt}");
                wrong += usize::from(broken.is_some());
                right += usize::from(is_certified);
                other_maps += usize::from(broken.is_none() && !is_certified);
            });
        }
    }
    assert_eq!((wrong, right, other_maps), (31_364, 92, 36));
}

/// A changed label is detected, or still certifies: everything the checker reports about the structure stays true.
#[test]
fn a_changed_label_is_found_or_certifies_as_well() {
    let (mut found, mut as_good) = (0, 0);
    for table in small_maps().filter(|table| table.half_edges.len() <= 4) {
        for form in certified_forms() {
            let projection = projected(&table, &form);
            let mut labels = Labels::new(&projection).unwrap();
            for column in Column::ALL {
                for i in 0..labels.column(column).len() {
                    let before = labels.column(column)[i];
                    let most = labels.column(Column::HalfEdgeRank).len().max(labels.column(column).len()) as u32;
                    for value in (0..=most).chain([u32::MAX - 1, u32::MAX]).filter(|value| *value != before) {
                        labels.column_mut(column)[i] = value;
                        let is_certified = check(&projection, &labels).is_ok();
                        assert_eq!(passes(&projection, &labels), is_certified, "{projection}");
                        if is_certified {
                            let certificate = Certificate::new(&projection, &labels).unwrap();
                            assert_eq!(first_broken_rule(&certificate, &PLANE), None, "{projection}");
                        }
                        *if is_certified { &mut as_good } else { &mut found } += 1;
                    }
                    labels.column_mut(column)[i] = before;
                }
            }
        }
    }
    assert_eq!((found, as_good), (27_064, 13_448));
}

#[test]
fn every_corruption_of_small_maps_in_every_form_is_judged_as_by_the_reference() {
    let structure = Structure::new("second model", RawPointers::new, PLANE);
    let work = CorruptWork { edges: 2, pairs: 2000, seed: 1 };
    corrupt(&structure, work, &Certificates, &Run::default(), &abort).unwrap().into_result().unwrap();
}

#[test]
fn every_small_table_is_judged_as_by_the_reference() {
    tables(TablesWork { half_edges: 2 }, &Certificates, &Run::default()).into_result().unwrap();
}

#[test]
fn random_tables_are_judged_as_by_the_reference() {
    let outcome = sample(SampleWork { tables: 20_000, seed: 1 }, &Certificates, &Run::default());
    let outcome = outcome.into_result().unwrap();
    assert!(outcome.right > 1000, "{}", outcome.right);
}

/// No test is idle: each fails for some corruption.
#[test]
fn each_test_finds_something() {
    let mut seen = BTreeSet::new();
    for table in small_maps().filter(|table| table.half_edges.len() <= 4) {
        for form in certified_forms() {
            let mut projection = projected(&table, &form);
            let labels = Labels::new(&projection).unwrap();
            for_each_corruption(&mut projection, form.parts, |corrupt, _, _| {
                let failures = check(corrupt, &labels).err().unwrap_or_default();
                seen.extend(failures.iter().map(|failure| failure.test()));
            });
        }
    }
    // The others belong to drawings and surfaces.
    let unseen: Vec<Test> = Test::ALL.into_iter().filter(|test| !seen.contains(test)).collect();
    let others = Test::ALL.into_iter().filter(|test| *test == Test::Readable || *test >= Test::DartTwinOk);
    assert!(unseen.iter().copied().eq(others), "{unseen:?}");
}

/// Separate tori: their total genus is found, and no other genus passes.
#[test]
fn surfaces_are_certified_with_their_genus() {
    for parts in 0..4 {
        let triangles: Vec<_> = (0..parts)
            .flat_map(|part| torus([3, 4]).into_iter().map(move |triangle| triangle.map(|v| v + 12 * part)))
            .collect();
        // One vertex more than there are corners.
        let mesh = textbook_mesh(12 * parts + 1, &triangles);
        for table in [Part::Prev, Part::Leaving, Part::Faces].map(|part| mesh.without(part)).iter().chain([&mesh]) {
            let (labels, genus) = Labels::of_surface(table).unwrap();
            assert_eq!((check_surface(table, &labels, genus), genus), (Ok(()), parts), "{table}");
            assert!(passes_surface(table, &labels, genus), "{table}");
            assert_eq!(
                labels.column(Column::HalfEdgeComponent).len(),
                if parts == 1 { 1 } else { 36 * 2 * parts },
                "{table}"
            );
            for wrong in (0..5).filter(|wrong| *wrong != genus) {
                let failures = check_surface(table, &labels, wrong).unwrap_err();
                assert!(!passes_surface(table, &labels, wrong), "{table}");
                assert_eq!(failures.iter().map(|failure| failure.test()).collect::<Vec<_>>(), [Test::GenusOk]);
            }
        }
    }
}

/// Every entry of the labels of two tori without a common vertex, and then of one glued to itself at a vertex: two rotations of
/// one vertex, and two cycles of one face, have no positions.
#[test]
fn positions_find_a_vertex_with_two_rotations_and_a_face_with_two_cycles() {
    let triangles: Vec<_> =
        (0..2).flat_map(|part| torus([3, 3]).into_iter().map(move |triangle| triangle.map(|v| v + 9 * part))).collect();
    let right = textbook_mesh(18, &triangles);
    let (labels, genus) = Labels::of_surface(&right).unwrap();
    assert_eq!(check_surface(&right, &labels, genus), Ok(()));
    let tests = |table: &Table| {
        let (own, own_genus) = Labels::of_surface(table).unwrap();
        let failing = |labels: &Labels, genus| {
            let failures = check_surface(table, labels, genus).unwrap_err();
            assert!(!passes_surface(table, labels, genus), "{table}");
            failures.iter().map(|failure| failure.test()).collect::<BTreeSet<_>>()
        };
        // The genus that would balance the sums.
        [failing(&labels, genus), failing(&own, own_genus), failing(&own, own_genus + 1)]
    };
    let mut pinched = right.clone();
    for row in pinched.half_edges.iter_mut().flatten().filter(|row| row.origin == Some(9)) {
        row.origin = Some(0);
    }
    pinched.vertices[9].as_mut().unwrap().leaving = None;
    assert!(tests(&pinched).iter().all(|failing| failing.contains(&Test::TurnOk)));
    let mut joined = right.clone();
    for row in joined.half_edges.iter_mut().flatten().filter(|row| row.face == Some(1)) {
        row.face = Some(0);
    }
    joined.faces[1] = None;
    assert!(tests(&joined).iter().all(|failing| failing.contains(&Test::StepOk)));
}

/// A loop inside itself satisfies all tests of single records.
#[test]
fn ranks_find_a_component_inside_itself() {
    let table: Table = "V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 1 h0 o 1 h1 i0 F 2 - 0 0 1 1".parse().unwrap();
    assert_eq!(first_broken_rule(&table, &PLANE), Some(Rule::T2));
    for ranks in (0..9).map(|ranks| vec![ranks / 3, ranks % 3]) {
        let mut labels = Labels::default();
        *labels.column_mut(Column::HalfEdgeRank) = ranks;
        let failures = check(&table, &labels).unwrap_err();
        assert_eq!(failures.iter().map(|failure| failure.test()).collect::<Vec<_>>(), [Test::RankOk]);
    }
}

#[test]
fn labels_of_another_length_are_refused() {
    for table in small_maps() {
        let mut labels = Labels::new(&table).unwrap();
        labels.column_mut(Column::HalfEdgeRank).push(0);
        assert_eq!(check(&table, &labels).unwrap_err()[0].test(), Test::Readable);
        assert!(!passes(&table, &labels));
        labels.column_mut(Column::HalfEdgeRank).pop();
        if labels.column_mut(Column::HalfEdgeRank).pop().is_some() {
            assert_eq!(check(&table, &labels).unwrap_err()[0].test(), Test::Readable);
        }
    }
}

/// All other columns may be missing: then their entries are nil.
#[test]
fn labels_that_are_missing_are_nil() {
    let bare: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse().unwrap();
    let bare = bare.without(Part::Prev).without(Part::Leaving).without(Part::Faces);
    let labels = Labels::new(&bare).unwrap();
    assert_eq!(check(&bare, &labels), Ok(()));
    for column in Column::ALL.into_iter().filter(|column| !labels.column(*column).is_empty()) {
        let mut missing = labels.clone();
        missing.column_mut(column).clear();
        // Nil in these means not isolated, outer, or not listed, as required here anyway.
        let says_nil = matches!(column, Column::VertexIsolated | Column::BoundaryVertex);
        assert_eq!(check(&bare, &missing).is_ok(), says_nil, "{}", column.name());
    }
}

/// More vertices than can be numbered.
struct Large;
impl View for Large {
    fn parts(&self) -> Parts {
        Parts::NONE
    }
    fn vertex_slots(&self) -> usize {
        usize::MAX
    }
    fn half_edge_slots(&self) -> usize {
        0
    }
    fn origin(&self, _: usize) -> Option<usize> {
        None
    }
    fn twin(&self, _: usize) -> Option<usize> {
        None
    }
    fn next(&self, _: usize) -> Option<usize> {
        None
    }
}

/// A vertex without half-edges, and one more on each call.
struct Growing(Cell<usize>);
impl View for Growing {
    twinedge::view_answers! { |this|
        parts => Parts::NONE,
        vertex_slots => this.0.replace(this.0.get() + 1),
        half_edge_slots => 0,
        origin(_h) => None,
        twin(_h) => None,
        next(_h) => None,
    }
}

#[test]
fn labels_of_a_structure_that_grows_are_made() {
    for first in 0..4 {
        assert!(Labels::new(&Growing(Cell::new(first))).is_ok());
        assert!(Labels::of_surface(&Growing(Cell::new(first))).is_ok());
        let _ = SurfaceCertificate::new(&Growing(Cell::new(first)));
    }
}

#[test]
fn structures_without_containment_have_no_labels() {
    let table: Table = "V 0 H 0 B 0 F 1 - 0".parse().unwrap();
    for part in [Part::UnboundedFace, Part::Holes] {
        assert_eq!(Labels::new(&table.without(part)), Err(LabelsError::NoContainment));
    }
    assert_eq!(Labels::new(&Large), Err(LabelsError::TooLarge));
    assert_eq!(check(&Large, &Labels::default()).unwrap_err()[0].test(), Test::Readable);
}

/// Records keep their numbers: vacant slots stay vacant, and links that fit into no column lead nowhere.
#[test]
fn a_certificate_keeps_the_numbers_of_records() {
    let mut table: Table = "V 2 x 0 - H 3 1 1 0 0 0 1 0 1 1 1 x B 2 1 h0 o 0 h1 i0 F 2 - 1 1 0 0".parse().unwrap();
    let labels = Labels::new(&table).unwrap();
    let certificate = Certificate::new(&table, &labels).unwrap();
    assert_eq!(certificate.check(), Ok(()));
    assert_eq!(certificate.columns().column(Column::VertexLeaving), [u32::MAX - 1, 0]);
    assert_eq!(certificate.columns().column(Column::HalfEdgeOrigin), [1, 1, u32::MAX - 1]);
    half_edge(&mut table, 0).origin = Some(usize::MAX);
    vertex(&mut table, 1).isolated = Some(usize::MAX);
    let certificate = Certificate::new(&table, &labels).unwrap();
    assert_eq!(certificate.check(), check(&table, &labels));
    assert!(certificate.is_half_edge(0) && certificate.check().is_err());
}

#[test]
fn labels_are_written_and_read() {
    let table: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse().unwrap();
    let labels = Labels::new(&table).unwrap();
    let text = serde_json::to_string(&labels).unwrap();
    assert_eq!(serde_json::from_str::<Labels>(&text).unwrap(), labels);
    let certificate = Certificate::new(&table, &labels).unwrap();
    let text = serde_json::to_string(&certificate).unwrap();
    assert_eq!(serde_json::from_str::<Certificate>(&text).unwrap(), certificate);
}

fn failing(view: &impl View, labels: &Labels) -> Vec<Test> {
    check(view, labels).unwrap_err().iter().map(|failure| failure.test()).collect()
}

/// The columns of entries of a face are longer than the columns of faces: the boundary component lies in a missing face.
#[test]
fn a_face_past_the_last_one_holds_nothing() {
    let edge: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse().unwrap();
    let edge = edge.without(Part::Faces);
    let mut labels = Labels::new(&edge).unwrap();
    assert_eq!(check(&edge, &labels), Ok(()));
    *labels.column_mut(Column::BoundaryFace) = vec![1];
    *labels.column_mut(Column::FaceEnd) = vec![0, 1];
    assert_eq!(failing(&edge, &labels), [Test::PlaceOk]);
    labels.column_mut(Column::FaceOuter).push(u32::MAX);
    assert_eq!(failing(&edge, &labels), [Test::OneUnbounded]);
}

/// An isolated vertex whose boundary component is always where it was last looked for, in an endless list.
struct Everywhere(Cell<usize>);

impl View for Everywhere {
    twinedge::view_answers! { |this|
        parts => Parts::ALL,
        vertex_slots => 1,
        half_edge_slots => 0,
        boundary_slots => 1,
        face_slots => 1,
        origin(_h) => None,
        twin(_h) => None,
        next(_h) => None,
        prev(_h) => None,
        boundary(_h) => None,
        leaving(_v) => None,
        isolated(_v) => Some(0),
        boundary_face(_b) => Some(0),
        boundary_start(_b) => Some(Start::Vertex(0)),
        boundary_place(_b) => Some(BoundaryPlace::Inner(this.0.get())),
        outer(_f) => None,
        inner_count(_f) => usize::MAX,
        inner(_f, i) => {
            this.0.set(i);
            Some(0)
        },
    }
}

#[test]
fn a_list_without_end_is_not_read_to_its_end() {
    assert_eq!(failing(&Everywhere(Cell::default()), &Labels::default()), [Test::FaceOk]);
}

/// Maps whose half-edges and faces name each other, without boundary components, and their labels.
fn maps_by_name() -> impl Iterator<Item = (Table, Labels)> {
    let forms = || certified_forms().into_iter().filter(|form| form.parts.has(Part::Faces));
    let by_name = move |form: &Form| !form.parts.has(Part::BoundaryComponents);
    small_maps()
        .filter(|table| table.half_edges.len() <= 4)
        .flat_map(move |table| forms().filter(by_name).map(move |form| projected(&table, &form)).collect::<Vec<_>>())
        .map(|table| {
            let labels = Labels::new(&table).unwrap();
            (table, labels)
        })
}

/// Boundary components are not stored, so the vertex's answer about them is never read.
#[test]
fn what_is_not_stored_is_not_read() {
    let mut seen = 0;
    for table in small_maps() {
        let parts = Parts::ALL.without(Part::BoundaryComponents);
        let stored = projected(&table, &Form { parts, expectation: PLANE });
        let mut all = table.clone();
        for (row, stored) in all.half_edges.iter_mut().zip(&stored.half_edges) {
            if let Some(row) = row {
                row.face = stored.as_ref().and_then(|stored| stored.face);
            }
        }
        for (row, stored) in all.faces.iter_mut().zip(&stored.faces) {
            let (Some(row), Some(stored)) = (row, stored) else { continue };
            row.outer_half_edge = stored.outer_half_edge;
            row.inner_starts.clone_from(&stored.inner_starts);
        }
        let only = Only::new(all, parts);
        assert_eq!(first_broken_rule(&only, &PLANE), None, "{table}");
        let labels = Labels::new(&only).unwrap();
        assert_eq!(check(&only, &labels), Ok(()), "{table}");
        assert_eq!(Certificate::new(&only, &labels).unwrap().check(), Ok(()), "{table}");
        seen += usize::from(table.vertices.iter().flatten().any(|vertex| vertex.isolated.is_some()));
    }
    assert!(seen > 0);
}

/// No column of a certificate contains the names by which half-edges and faces name each other.
#[test]
fn a_certificate_is_not_silent_on_wrong_names() {
    // A loop whose inside is named by both sides.
    let table: Table = "P 5 prev leaving faces holes unbounded_face V 1 0 - H 2 0 1 0 0 - 0 0 1 1 - B 0 F 2 - 0 - 0 \
                        HF 2 1 1 FH 2 0 0 - 1 h1"
        .parse()
        .unwrap();
    assert_eq!(first_broken_rule(&table, &PLANE), Some(Rule::B1));
    let labels = Labels::new(&table).unwrap();
    assert!(check(&table, &labels).is_err());
    assert_eq!(Certificate::new(&table, &labels), Err(LabelsError::FaceOfHalfEdge(0)));
}

#[test]
fn a_face_names_no_more_than_its_boundary_components() {
    let mut seen = 0;
    for (mut table, labels) in maps_by_name() {
        for f in 0..table.faces.len() {
            let Some(last) = table.faces[f].as_ref().and_then(|face| face.inner_starts.last().copied()) else {
                continue;
            };
            table.faces[f].as_mut().unwrap().inner_starts.push(last);
            assert!(first_broken_rule(&table, &PLANE).is_some(), "{table}");
            assert_eq!(failing(&table, &labels), [Test::FaceStartsOk], "{table}");
            table.faces[f].as_mut().unwrap().inner_starts.pop();
            seen += 1;
        }
    }
    assert!(seen > 0);
}

/// Tables that the checker of labels finds wrong, with their own labels. No other test finds what one test names.
#[test]
fn each_wrong_table_fails_these_tests() {
    let two_loops =
        "V 1 0 - H 4 0 1 0 0 0 0 0 1 1 1 0 3 2 2 2 0 2 3 3 3 B 4 1 h0 o 0 h1 i0 2 h2 o 0 h3 i1 F 3 - 2 1 3 0 0 2 0";
    let cases: [(&str, &str, Rule, &[Test]); 7] = [
        ("a vertex with two rotations: only the sums show it", two_loops, Rule::V2, &[Test::EulerOk]),
        ("two faces without an outer boundary component", "V 0 H 0 B 0 F 2 - 0 - 0", Rule::F1, &[Test::OneUnbounded]),
        ("an isolated vertex bounds a face", "V 1 - 0 H 0 B 1 1 v0 o F 2 - 0 0 0", Rule::F1, &[Test::StartOk]),
        (
            "two boundary components start at an isolated vertex, which no sum includes",
            "V 1 - 0 H 0 B 2 0 v0 i0 0 v0 i1 F 1 - 2 0 1",
            Rule::B2,
            &[Test::StartOk],
        ),
        (
            "half-edges are on the boundary component of an isolated vertex",
            "V 3 0 - 1 - - 0 H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 v2 i0 F 1 - 1 0",
            Rule::B1,
            &[Test::CycleOk, Test::RankOk, Test::EulerOk],
        ),
        (
            "an outer boundary component is no root, and its face does not list it",
            "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 o F 1 - 1 0",
            Rule::F2,
            &[Test::RankOk, Test::PlaceOk, Test::FaceOk, Test::EulerOk],
        ),
        (
            "a boundary component starts at a vertex with half-edges",
            "V 1 0 2 H 2 0 1 0 0 0 0 0 1 1 1 B 3 0 h0 o 1 h1 i0 1 v0 i1 F 2 0 0 - 2 1 2",
            Rule::B2,
            &[Test::VertexOk, Test::StartOk],
        ),
    ];
    for (name, text, rule, tests) in cases {
        let table: Table = text.parse().unwrap();
        assert_eq!(first_broken_rule(&table, &PLANE), Some(rule), "{name}");
        assert_eq!(failing(&table, &Labels::new(&table).unwrap()), tests, "{name}");
    }
    let table: Table = two_loops.parse().unwrap();
    let failures = check(&table, &Labels::new(&table).unwrap()).unwrap_err();
    assert_eq!((failures[0].to_string().as_str(), failures[0].first(), failures[0].count()), ("euler_ok", None, 1));
    // Each half of the test follows from the other at some half-edge; both are tested at each.
    let mut edge: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse().unwrap();
    let labels = Labels::new(&edge).unwrap();
    half_edge(&mut edge, 1).next = Some(1);
    let failures = check(&edge, &labels).unwrap_err();
    assert_eq!(failures[0].to_string(), "next_ok: 2 of the half-edges, the first is 0");
}

/// The checker of labels accepts only closed surfaces, where each boundary component is the outer one of a face.
#[test]
fn each_wrong_surface_fails_one_test() {
    let mesh = with_boundary_components(&textbook_mesh(4, &TETRAHEDRON));
    let (labels, genus) = Labels::of_surface(&mesh).unwrap();
    assert_eq!(check_surface(&mesh, &labels, genus), Ok(()));
    let failing = |table: &Table, labels: &Labels, genus| {
        let failures = check_surface(table, labels, genus).unwrap_err();
        failures.iter().map(|failure| failure.test()).collect::<Vec<_>>()
    };
    let mut hole = mesh.clone();
    hole.boundaries[0].as_mut().unwrap().face = None;
    hole.faces[0] = None;
    let mut inner = mesh.clone();
    inner.boundaries[0].as_mut().unwrap().place = Some(BoundaryPlace::Inner(0));
    for table in [hole, inner] {
        assert_eq!(failing(&table, &labels, genus), [Test::SurfaceBoundaryOk]);
    }
    let mut ranks = labels;
    ranks.column_mut(Column::HalfEdgeRank).push(0);
    assert_eq!(failing(&mesh, &ranks, genus), [Test::Readable]);
    // Four half-edges that are their own twins, around one vertex: the sums match a torus.
    let text =
        "P 3 prev leaving faces V 1 0 - H 4 0 0 1 3 - 0 1 2 0 - 0 2 3 1 - 0 3 0 2 - B 0 F 1 - 0 HF 4 0 0 0 0 FH 1 0 0";
    let table: Table = text.parse().unwrap();
    assert_eq!(failing(&table, &Labels::of_surface(&table).unwrap().0, 1), [Test::TwinOk]);
}
