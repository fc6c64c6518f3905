//! For each rule, tables that break only it, and for each way of breaking it the exact violation.

use crate::support::erased::validate;
use crate::support::nested::{PLANE, nested, nested_textbook};
use crate::support::opinions::{agree, broken, only};
use crate::support::tables::{TETRAHEDRON, Without, boundary, digon, face, half_edge, k7, map, mesh, one_loop, vertex};
use twinedge::validate::{
    BoundaryPlace, BoundaryRow, Collect, Expectation, FaceRow, Field, Part, Record, Rule, Start, Table, Unchecked,
    VertexRow, Violation,
};

/// Asserts that a change to the nested triangles breaks only this rule, in this way.
#[track_caller]
fn change(rule: Rule, change: impl FnOnce(&mut Table), violations: &[Violation]) {
    let mut table = nested();
    change(&mut table);
    only(rule, &table, PLANE, violations);
}

/// Asserts this in the form of the textbook.
#[track_caller]
fn change_textbook(rule: Rule, change: impl FnOnce(&mut Table), violations: &[Violation]) {
    let mut table = nested_textbook();
    change(&mut table);
    only(rule, &table, PLANE, violations);
}

#[test]
fn what_is_changed_below_is_right_before() {
    for table in [nested(), digon(), one_loop()] {
        assert_eq!(agree(&table, PLANE), None);
    }
    assert_eq!(agree(&nested_textbook(), PLANE), None);
}

#[test]
fn r1_a_link_that_is_needed_is_nil() {
    let (record, field) = (Record::HalfEdge(0), Field::Next);
    change(Rule::R1, |t| half_edge(t, 0).next = None, &[Violation::Nil { record, field }]);
    let (record, field) = (Record::Boundary(4), Field::Start);
    change(Rule::R1, |t| boundary(t, 4).start = None, &[Violation::Nil { record, field }]);
}

#[test]
fn r1_a_link_dangles() {
    let (record, field) = (Record::Vertex(3), Field::Leaving);
    let dangling = |value| [Violation::Dangling { record, field, value }];
    change(Rule::R1, |t| vertex(t, 3).leaving = Some(12), &dangling(12));
    change(Rule::R1, |t| vertex(t, 3).leaving = Some(usize::MAX), &dangling(usize::MAX));
    // A slot of a retired record is no better.
    let retired = |t: &mut Table| {
        t.half_edges.push(None);
        vertex(t, 3).leaving = Some(12);
    };
    change(Rule::R1, retired, &dangling(12));
}

#[test]
fn l1_the_twins_twin_is_another() {
    let mut table = digon();
    half_edge(&mut table, 0).twin = Some(3);
    let violations = [
        Violation::TwinNotMutual { half_edge: 0, twin: 3, found: Some(2) },
        Violation::TwinNotMutual { half_edge: 1, twin: 0, found: Some(3) },
    ];
    only(Rule::L1, &table, PLANE, &violations);
}

#[test]
fn l1_a_half_edge_is_its_own_twin() {
    let mut table = one_loop();
    half_edge(&mut table, 0).twin = Some(0);
    let not_mutual = Violation::TwinNotMutual { half_edge: 1, twin: 0, found: Some(0) };
    only(Rule::L1, &table, PLANE, &[Violation::TwinIsSelf { half_edge: 0 }, not_mutual]);
}

#[test]
fn l2_next_and_prev_disagree() {
    let violations = [
        Violation::PrevOfNext { half_edge: 0, next: 2, found: 4 },
        Violation::NextOfPrev { half_edge: 2, prev: 4, found: 0 },
    ];
    change(Rule::L2, |t| half_edge(t, 2).prev = Some(4), &violations);
}

#[test]
fn l2_without_prev_two_half_edges_share_their_next() {
    let mut table = digon();
    half_edge(&mut table, 0).next = Some(1);
    let table = table.without(Part::Faces).without(Part::Prev);
    only(Rule::L2, &table, PLANE, &[Violation::NextShared { first: 0, second: 2, next: 1 }]);
}

#[test]
fn l3_the_next_half_edge_starts_elsewhere() {
    let violations = [
        Violation::Target { half_edge: 1, next: 5, target: 1, found: 0 },
        Violation::Target { half_edge: 4, next: 0, target: 0, found: 1 },
    ];
    let moved = |t: &mut Table| {
        half_edge(t, 0).origin = Some(1);
        vertex(t, 0).leaving = Some(5);
    };
    change(Rule::L3, moved, &violations);
}

#[test]
fn v1_the_half_edge_of_a_vertex_leaves_another() {
    let violation = Violation::NotLeaving { vertex: 0, half_edge: 2, origin: 1 };
    change(Rule::V1, |t| vertex(t, 0).leaving = Some(2), &[violation]);
    let violation = Violation::NotLeaving { vertex: 6, half_edge: 2, origin: 1 };
    change(Rule::V1, |t| vertex(t, 6).leaving = Some(2), &[violation]);
}

#[test]
fn v2_two_fans_share_a_vertex() {
    let pinched = |t: &mut Table| {
        half_edge(t, 6).origin = Some(0);
        half_edge(t, 11).origin = Some(0);
        t.vertices[3] = None;
    };
    change(Rule::V2, pinched, &[Violation::SplitRotation { vertex: 0, half_edge: 11, reached: 2, degree: 4 }]);
}

#[test]
fn b1_the_boundary_component_changes_along_a_cycle() {
    let violations = [
        Violation::BoundaryChanges { half_edge: 0, next: 2, boundary: Some(1), found: Some(4) },
        Violation::BoundaryChanges { half_edge: 2, next: 4, boundary: Some(4), found: Some(1) },
    ];
    change(Rule::B1, |t| half_edge(t, 2).boundary = Some(4), &violations);
}

#[test]
fn b1_a_boundary_component_starts_on_another() {
    let violation = Violation::StartElsewhere { boundary: 1, half_edge: 6, found: Some(4) };
    change(Rule::B1, |t| boundary(t, 1).start = Some(Start::HalfEdge(6)), &[violation]);
}

#[test]
fn b1_a_boundary_component_has_a_second_cycle() {
    let inside_of_both = |t: &mut Table| {
        for h in [6, 8, 10] {
            half_edge(t, h).boundary = Some(1);
        }
        t.boundaries[4] = None;
        t.faces[2] = None;
    };
    change(Rule::B1, inside_of_both, &[Violation::SecondCycle { boundary: 1, cycle: 3, half_edges: 6 }]);
    let cycle_of_a_vertex = |t: &mut Table| {
        for h in [7, 9, 11] {
            half_edge(t, h).boundary = Some(3);
        }
        t.boundaries[2] = None;
        face(t, 1).inner = vec![Some(3)];
        boundary(t, 3).place = Some(BoundaryPlace::Inner(0));
    };
    change(Rule::B1, cycle_of_a_vertex, &[Violation::SecondCycle { boundary: 3, cycle: 0, half_edges: 3 }]);
}

#[test]
fn b1_the_face_changes_along_a_cycle() {
    let violations = [
        Violation::FaceChanges { half_edge: 0, next: 2, face: Some(1), found: Some(2) },
        Violation::FaceChanges { half_edge: 2, next: 4, face: Some(2), found: Some(1) },
    ];
    change_textbook(Rule::B1, |t| half_edge(t, 2).face = Some(2), &violations);
}

#[test]
fn b1_a_face_lists_a_half_edge_of_another() {
    let violations = [
        Violation::ListedElsewhere { face: 1, half_edge: 6, found: Some(2) },
        Violation::ListedElsewhere { face: 2, half_edge: 0, found: Some(1) },
    ];
    let swapped = |t: &mut Table| {
        face(t, 1).outer_half_edge = Some(6);
        face(t, 2).outer_half_edge = Some(0);
    };
    change_textbook(Rule::B1, swapped, &violations);
}

#[test]
fn b2_nothing_starts_at_an_isolated_vertex() {
    let forgotten = |t: &mut Table| {
        face(t, 1).inner.pop();
        t.boundaries[3] = None;
        vertex(t, 6).isolated = None;
    };
    change(Rule::B2, forgotten, &[Violation::IsolatedUnclaimed { vertex: 6 }]);
    let forgotten = |t: &mut Table| face(t, 1).inner_starts.truncate(1);
    change_textbook(Rule::B2, forgotten, &[Violation::IsolatedUnclaimed { vertex: 6 }]);
}

/// Adds boundary component 5, which starts at this vertex and is listed by face 0.
fn claim(table: &mut Table, v: usize) {
    let (face_link, start, place) = (Some(0), Some(Start::Vertex(v)), Some(BoundaryPlace::Inner(1)));
    table.boundaries.push(Some(BoundaryRow { face: face_link, start, place }));
    face(table, 0).inner.push(Some(5));
}

#[test]
fn b2_two_boundary_components_start_at_an_isolated_vertex() {
    let (first, second) = (Record::Boundary(3), Record::Boundary(5));
    change(Rule::B2, |t| claim(t, 6), &[Violation::IsolatedTwice { vertex: 6, first, second }]);
    let (first, second) = (Record::Face(0), Record::Face(1));
    let listed = |t: &mut Table| face(t, 0).inner_starts.push(Some(Start::Vertex(6)));
    change_textbook(Rule::B2, listed, &[Violation::IsolatedTwice { vertex: 6, first, second }]);
}

#[test]
fn b2_a_boundary_component_starts_at_a_connected_vertex() {
    let record = Record::Boundary(5);
    change(Rule::B2, |t| claim(t, 0), &[Violation::StartsAtConnected { record, vertex: 0 }]);
    let record = Record::Face(0);
    let listed = |t: &mut Table| face(t, 0).inner_starts.push(Some(Start::Vertex(0)));
    change_textbook(Rule::B2, listed, &[Violation::StartsAtConnected { record, vertex: 0 }]);
}

/// Also where the component has no other outside, so that each component has one.
#[test]
fn b2_a_connected_vertex_stands_for_the_outside_of_its_component() {
    let outside = |t: &mut Table| {
        face(t, 1).inner = vec![Some(3), Some(5)];
        boundary(t, 3).place = Some(BoundaryPlace::Inner(0));
        t.boundaries.push(Some(BoundaryRow {
            face: Some(1),
            start: Some(Start::Vertex(3)),
            place: Some(BoundaryPlace::Inner(1)),
        }));
        t.faces.push(Some(FaceRow { outer: Some(2), ..FaceRow::default() }));
        let row = boundary(t, 2);
        (row.face, row.place) = (Some(3), Some(BoundaryPlace::Outer));
    };
    change(Rule::B2, outside, &[Violation::StartsAtConnected { record: Record::Boundary(5), vertex: 3 }]);
}

#[test]
fn b2_a_vertex_names_a_boundary_component_that_it_is_not() {
    let mismatch = |found| [Violation::IsolatedMismatch { vertex: 6, boundary: 3, found }];
    change(Rule::B2, |t| vertex(t, 6).isolated = Some(2), &mismatch(Some(2)));
    change(Rule::B2, |t| vertex(t, 6).isolated = None, &mismatch(None));
    let violation = Violation::ConnectedNamesBoundary { vertex: 0, boundary: 0 };
    change(Rule::B2, |t| vertex(t, 0).isolated = Some(0), &[violation]);
}

#[test]
fn f1_no_face_is_unbounded_or_two_are() {
    let bounded = |t: &mut Table| {
        *face(t, 0) = FaceRow { outer: Some(0), ..FaceRow::default() };
        boundary(t, 0).place = Some(BoundaryPlace::Outer);
    };
    change(Rule::F1, bounded, &[Violation::NoUnboundedFace]);
    let violation = Violation::SecondUnboundedFace { first: 0, second: 3 };
    change(Rule::F1, |t| t.faces.push(Some(FaceRow::default())), &[violation]);
}

#[test]
fn f1_on_a_surface_every_face_is_bounded() {
    let mut table = map(2, &[(0, 3), (1, 2), (0, 1), (1, 0)], &[(Some(1), &[]), (Some(0), &[])]);
    assert_eq!(agree(&table, Expectation::surface()), None);
    table.faces.push(Some(FaceRow::default()));
    only(Rule::F1, &table, Expectation::surface(), &[Violation::NoOuter { face: 2 }]);
}

#[test]
fn f1_an_isolated_vertex_bounds_nothing() {
    let outer = |t: &mut Table| {
        face(t, 1).inner.pop();
        t.faces.push(Some(FaceRow { outer: Some(3), ..FaceRow::default() }));
        let row = boundary(t, 3);
        (row.face, row.place) = (Some(3), Some(BoundaryPlace::Outer));
    };
    change(Rule::F1, outer, &[Violation::OuterIsVertex { face: 3, boundary: 3 }]);
}

#[test]
fn f1_on_a_surface_an_isolated_vertex_bounds_nothing_either() {
    let mut table = mesh(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]);
    table.vertices.push(Some(VertexRow { leaving: None, isolated: None }));
    table.boundaries.push(Some(BoundaryRow {
        face: Some(4),
        start: Some(Start::Vertex(4)),
        place: Some(BoundaryPlace::Outer),
    }));
    table.faces.push(Some(FaceRow { outer: Some(4), ..FaceRow::default() }));
    let surface = Expectation::surface();
    assert!(agree(&table, surface).is_some());
    let report = validate(&table, &surface, Collect::All);
    assert!(report.violations().contains(&Violation::OuterIsVertex { face: 4, boundary: 4 }), "{report}");
}

#[test]
fn f2_a_boundary_component_is_not_listed() {
    let violation = Violation::NotListed { boundary: 3, face: Some(1) };
    change(Rule::F2, |t| face(t, 1).inner.truncate(1), &[violation]);
    let violation = Violation::CycleNotListed { half_edge: 1 };
    change_textbook(Rule::F2, |t| face(t, 0).inner_starts.clear(), &[violation]);
}

#[test]
fn f2_a_boundary_component_is_listed_twice() {
    let mut table = nested();
    face(&mut table, 1).inner.push(Some(3));
    let twice = Violation::ListedTwice { record: Record::Boundary(3), face: 1 };
    only(Rule::F2, &table.without(Part::Places), PLANE, &[twice]);
    let place = Some(BoundaryPlace::Inner(1));
    let wrong_place = Violation::WrongPlace { boundary: 3, place, listed: BoundaryPlace::Inner(2) };
    only(Rule::F2, &table, PLANE, &[twice, wrong_place]);
    let twice = Violation::ListedTwice { record: Record::HalfEdge(3), face: 0 };
    change_textbook(Rule::F2, |t| face(t, 0).inner_starts.push(Some(Start::HalfEdge(3))), &[twice]);
}

#[test]
fn f2_a_boundary_component_is_listed_by_another_face_or_at_another_place() {
    let violation = Violation::ListedByOther { boundary: 3, face: 1, found: Some(2) };
    change(Rule::F2, |t| boundary(t, 3).face = Some(2), &[violation]);
    let wrong = |place| [Violation::WrongPlace { boundary: 3, place, listed: BoundaryPlace::Inner(1) }];
    for place in
        [None, Some(BoundaryPlace::Outer), Some(BoundaryPlace::Inner(0)), Some(BoundaryPlace::Inner(usize::MAX))]
    {
        change(Rule::F2, |t| boundary(t, 3).place = place, &wrong(place));
    }
}

/// Regression, found by fuzzing: R1 was called valid, and F2 the first broken rule, although R1 had not read all lists.
#[test]
fn r1_is_not_called_sound_where_lists_were_not_read_to_the_end() {
    for mut table in [nested(), nested_textbook()] {
        let row = face(&mut table, 1);
        row.inner.resize(100, Some(3));
        row.inner.push(Some(usize::MAX));
        row.inner_starts.resize(100, Some(Start::HalfEdge(7)));
        row.inner_starts.push(None);
        assert_eq!(agree(&table, PLANE), Some(Rule::R1));
        // Among the entries read, the second is listed twice, which breaks F2.
        let first = validate(&table, &PLANE, Collect::First);
        assert_eq!(first.violations(), [Violation::ListTooLong { face: 1, claimed: 101 }]);
        let report = validate(&table, &PLANE, Collect::AtMost(0));
        let said = report.outcome(Rule::R1).unwrap();
        assert_eq!((said.violations, said.unchecked), (1, Some(Unchecked::ListTooLong)));
        assert_eq!(report.outcome(Rule::F2).unwrap().unchecked, Some(Unchecked::ListTooLong));
        assert!(report.to_string().contains("the rest not checked: the lists of the faces are too long"), "{report}");
    }
}

#[test]
fn t1_a_component_has_no_outside() {
    let outer = |t: &mut Table| {
        face(t, 1).inner = vec![Some(3)];
        boundary(t, 3).place = Some(BoundaryPlace::Inner(0));
        t.faces.push(Some(FaceRow { outer: Some(2), ..FaceRow::default() }));
        let row = boundary(t, 2);
        (row.face, row.place) = (Some(3), Some(BoundaryPlace::Outer));
    };
    change(Rule::T1, outer, &[Violation::NoOutside { vertex: 3 }]);
    // Only components at an open boundary may lack an inner one, even if open boundaries are legal.
    let mut table = nested();
    outer(&mut table);
    only(Rule::T1, &table, PLANE.open(), &[Violation::NoOutside { vertex: 3 }]);
}

#[test]
fn t1_a_component_has_two_outsides() {
    let inner = |t: &mut Table| {
        t.faces[2] = None;
        face(t, 0).inner.push(Some(4));
        let row = boundary(t, 4);
        (row.face, row.place) = (Some(0), Some(BoundaryPlace::Inner(1)));
    };
    let (first, second) = (Record::Boundary(4), Record::Boundary(2));
    change(Rule::T1, inner, &[Violation::TwoOutsides { vertex: 3, first, second }]);
    let inner = |t: &mut Table| {
        t.faces[2] = None;
        face(t, 0).inner_starts.push(Some(Start::HalfEdge(6)));
        for h in [6, 8, 10] {
            half_edge(t, h).face = Some(0);
        }
    };
    let (first, second) = (Record::HalfEdge(6), Record::HalfEdge(7));
    change_textbook(Rule::T1, inner, &[Violation::TwoOutsides { vertex: 3, first, second }]);
}

/// In both tables every local rule holds, and Euler's formula.
#[test]
fn t2_a_component_lies_inside_itself() {
    let in_itself = |t: &mut Table| {
        face(t, 1).inner = vec![Some(3)];
        boundary(t, 3).place = Some(BoundaryPlace::Inner(0));
        face(t, 2).inner = vec![Some(2)];
        boundary(t, 2).face = Some(2);
    };
    change(Rule::T2, in_itself, &[Violation::NestedInItself { vertex: 3, face: 2 }]);
    let in_each_other = |t: &mut Table| {
        face(t, 0).inner.clear();
        face(t, 2).inner = vec![Some(0)];
        boundary(t, 0).face = Some(2);
    };
    change(Rule::T2, in_each_other, &[Violation::NestedInItself { vertex: 0, face: 2 }]);
}

/// Two loops at one vertex that cross there: the smallest map of the torus, with one face.
#[test]
fn t3_a_component_has_a_handle() {
    let table = map(1, &[(0, 3), (0, 2), (0, 0), (0, 1)], &[(None, &[Start::HalfEdge(0)])]);
    let violation = Violation::Genus { vertex: 0, vertices: 1, edges: 2, cycles: 1, genus: 1 };
    only(Rule::T3, &table, PLANE, &[violation]);
}

/// Lists the outer boundary component of face 0 as an inner one, which makes the face unbounded.
fn turn_inside_out(table: &mut Table) {
    *face(table, 0) = FaceRow { inner: vec![Some(0)], ..FaceRow::default() };
    boundary(table, 0).place = Some(BoundaryPlace::Inner(0));
}

#[test]
fn t3_and_t4_seven_vertices_all_joined_do_not_fit_in_the_plane() {
    let mut table = k7();
    let report = validate(&table, &Expectation::surface(), Collect::All);
    assert_eq!(report.figures().unwrap().genus, 1);
    assert_eq!(agree(&table, Expectation::surface()), None);
    turn_inside_out(&mut table);
    let report = validate(&table, &PLANE, Collect::All);
    let violations = [
        Violation::Genus { vertex: 0, vertices: 7, edges: 21, cycles: 14, genus: 1 },
        Violation::TooManyEdges { vertices: 7, edges: 21 },
        Violation::TooManyFaces { vertices: 7, faces: 14 },
    ];
    assert_eq!(report.violations(), violations, "{report}");
    assert_eq!(broken(&report), [Rule::T3, Rule::T4]);
    assert_eq!(agree(&table, PLANE), Some(Rule::T3));
    // Without faces only the edges are too many.
    let bare = k7().without(Part::Faces);
    assert_eq!(agree(&bare, PLANE), Some(Rule::T3));
    let report = validate(&bare, &PLANE, Collect::All);
    assert_eq!(broken(&report), [Rule::T3, Rule::T4]);
}

/// T4 is never broken alone. Where all rules before it hold, the structure is a planar subdivision, which by Euler's
/// formula satisfies the bounds of T4. Too many edges always break T3. Too many faces can also mean that the faces are
/// counted wrong, as here: four triangles of a tetrahedron all face inwards, and a fifth face is outside.
#[test]
fn t4_is_broken_with_t1_where_faces_are_counted_wrong() {
    let mut table = mesh(4, &TETRAHEDRON);
    table.faces.push(Some(FaceRow::default()));
    let report = validate(&table, &PLANE, Collect::All);
    let violations = [Violation::NoOutside { vertex: 0 }, Violation::TooManyFaces { vertices: 4, faces: 5 }];
    assert_eq!(report.violations(), violations, "{report}");
    assert_eq!(agree(&table, PLANE), Some(Rule::T1));
    // With an outside the structure is valid, and no further face or edge fits.
    table.faces.pop();
    turn_inside_out(&mut table);
    let bounds = validate(&table, &PLANE, Collect::All).figures().unwrap().bounds.unwrap();
    assert_eq!((bounds.most_edges, bounds.most_faces), (6, 4));
}

#[test]
fn r1_alone_reports_the_boundary_component_of_a_half_edge_that_leads_nowhere() {
    // These start no boundary component, which would then not be on its own cycle.
    for h in [2, 3, 8, 9] {
        let (record, field) = (Record::HalfEdge(h), Field::Boundary);
        change(Rule::R1, |t| half_edge(t, h).boundary = None, &[Violation::Nil { record, field }]);
        for value in [5, usize::MAX] {
            let dangling = Violation::Dangling { record, field, value };
            change(Rule::R1, |t| half_edge(t, h).boundary = Some(value), &[dangling]);
        }
    }
}
