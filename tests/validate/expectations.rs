//! Expectations: each accepts the right structures, and the report lists the unchecked rules.

use crate::support::erased::validate;
use crate::support::opinions::agree;
use crate::support::tables::{
    TETRAHEDRON, TEXTBOOK, Without, boundary, face, half_edge, k7, map, textbook_map, textbook_mesh, vertex,
    without_border,
};
use twinedge::validate::{
    BoundaryPlace, Collect, Expectation, FaceRow, Field, Figures, HalfEdgeRow, ParseExpectationError, Part, Parts,
    Record, Rule, Start, Table, Unchecked, VertexRow, View, Violation,
};
use twinedge::view_answers;
use twinedge_trials::enumerate::for_each_corruption;

const PLANE: Expectation = Expectation::plane();
const MESH: Expectation = Expectation::surface();

/// Returns the figures, after both validators agreed on the table and on every change of one of its fields.
#[track_caller]
fn figures(table: &Table, expectation: Expectation) -> Figures {
    let report = validate(table, &expectation, Collect::All);
    let figures = report.figures().unwrap_or_else(|| panic!("{report}"));
    assert_eq!(agree(table, expectation), None);
    let Figures { vertices, edges, components, cycles, borders, isolated_vertices, genus, .. } = figures;
    assert_eq!(vertices + cycles + borders + isolated_vertices + 2 * genus, edges + 2 * components, "T3, added up");
    for_each_corruption(&mut table.clone(), expectation.looks_at(table.parts), |changed, _, _| {
        agree(changed, expectation);
    });
    figures
}

#[track_caller]
fn violations(table: &Table, expectation: Expectation) -> Vec<Violation> {
    agree(table, expectation);
    validate(table, &expectation, Collect::All).violations().to_vec()
}

/// Returns the unchecked rules with their reasons.
fn not_checked(table: &Table, expectation: Expectation) -> Vec<(Rule, Unchecked)> {
    let report = validate(table, &expectation, Collect::All);
    report.outcomes().filter_map(|(rule, outcome)| Some((rule, outcome.unchecked?))).collect()
}

#[test]
fn a_mesh_without_prev() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    for h in 0..12 {
        half_edge(&mut table, h).prev = None;
    }
    let found = figures(&table.without(Part::Prev), MESH);
    assert_eq!((found.vertices, found.edges, found.faces, found.cycles, found.genus), (4, 6, 4, 4, 0));
    // If the links are required, each is missing.
    let nil = |h| Violation::Nil { record: Record::HalfEdge(h), field: Field::Prev };
    assert_eq!(violations(&table, MESH), (0..12).map(nil).collect::<Vec<_>>());
}

/// The triangle of face 3 is missing, but its half-edges exist without a face.
#[test]
fn a_mesh_with_a_border_of_half_edges_without_face() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    let border: Vec<usize> = (0..12).filter(|h| half_edge(&mut table, *h).face == Some(3)).collect();
    for h in &border {
        half_edge(&mut table, *h).face = None;
    }
    table.faces[3] = None;
    let found = figures(&table, MESH.open());
    assert_eq!((found.vertices, found.edges, found.faces, found.cycles, found.borders), (4, 6, 3, 3, 1));
    let nil = |h: &usize| Violation::Nil { record: Record::HalfEdge(*h), field: Field::Face };
    assert_eq!(violations(&table, MESH), border.iter().map(nil).collect::<Vec<_>>());
    // A face that all half-edges of a border name still changes along the border.
    half_edge(&mut table, border[0]).face = Some(0);
    assert_eq!(agree(&table, MESH.open()), Some(Rule::B1));
}

/// The triangle of face 3 is missing with its half-edges, so their twins have none.
#[test]
fn a_mesh_with_a_border_of_half_edges_without_twin() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    let missing: Vec<usize> = (0..12).filter(|h| half_edge(&mut table, *h).face == Some(3)).collect();
    for h in &missing {
        half_edge(&mut table, *h).face = None;
    }
    table.faces[3] = None;
    let mut table = without_border(&table);
    let found = figures(&table, MESH.open());
    assert_eq!((found.vertices, found.edges, found.faces, found.cycles, found.borders), (4, 6, 3, 3, 1));
    let nil = |h: usize| Violation::Nil { record: Record::HalfEdge(h), field: Field::Twin };
    let expected: Vec<_> = (0..12).filter(|h| missing.contains(&(h ^ 1))).map(nil).collect();
    assert_eq!(violations(&table, MESH), expected);
    // Nor can a half-edge name a twin that has none.
    half_edge(&mut table, missing[0] ^ 1).twin = Some(missing[1] ^ 1);
    assert_eq!(agree(&table, MESH.open()), Some(Rule::L1));
}

/// A border has one of two forms. A half-edge with neither twin nor face bounds nothing.
#[test]
fn r1_at_a_border_twin_and_face_are_not_both_missing() {
    // A separate face with its whole cycle: the half-edges have no twins. Then they also lose their face.
    let row = |h: usize| HalfEdgeRow {
        origin: Some(h),
        next: Some((h + 1) % 3),
        prev: Some((h + 2) % 3),
        ..Default::default()
    };
    let vertices = (0..3).map(|v| Some(VertexRow { leaving: Some(v), isolated: None })).collect();
    let half_edges = (0..3).map(|h| Some(row(h))).collect();
    let mut table = Table { parts: TEXTBOOK, vertices, half_edges, ..Table::default() };
    let nil = |field| (0..3).map(|h| Violation::Nil { record: Record::HalfEdge(h), field }).collect::<Vec<_>>();
    assert_eq!(violations(&table, MESH.open()), nil(Field::Face));
    assert_eq!(violations(&Table { parts: Parts::ALL, ..table.clone() }, MESH.open()), nil(Field::Boundary));
    for expectation in [MESH, PLANE] {
        assert_eq!(agree(&table.without(Part::UnboundedFace), expectation.open()), Some(Rule::R1));
    }
    // Without faces no face is missing.
    assert_eq!(figures(&table.without(Part::Faces), MESH.open()).borders, 1);
    // With one of the two links it is a border of the first form, and with two such triangles back to back of the second.
    for h in 0..3 {
        half_edge(&mut table, h).face = Some(0);
    }
    table.faces = vec![Some(FaceRow { outer_half_edge: Some(0), ..FaceRow::default() })];
    assert_eq!(figures(&table, MESH.open()).borders, 1);
    let twin_row = |h: usize| HalfEdgeRow {
        origin: Some((h + 1) % 3),
        twin: Some(h),
        next: Some(3 + (h + 2) % 3),
        prev: Some(3 + (h + 1) % 3),
        ..Default::default()
    };
    for h in 0..3 {
        half_edge(&mut table, h).twin = Some(3 + h);
    }
    table.half_edges.extend((0..3).map(|h| Some(twin_row(h))));
    let found = figures(&table, MESH.open());
    assert_eq!((found.borders, found.cycles), (1, 1));
}

/// An edge of a tetrahedron is cut open: two half-edges without twin, which T4 counts as parallel edges.
#[test]
fn a_mesh_with_a_slit_is_planar_but_not_simple() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    half_edge(&mut table, 0).twin = None;
    half_edge(&mut table, 1).twin = None;
    let found = figures(&table.without(Part::Holes), PLANE.open());
    assert_eq!((found.vertices, found.edges, found.cycles, found.genus, found.bounds), (4, 7, 4, 0, None));
    assert!(found.not_checked.contains(&(Rule::T4, Unchecked::NotSimple)));
}

/// One vertex and four loops, each pair crossing as on a torus: a = 0, b = 2, c = 4, d = 6 and one cycle.
fn two_handles() -> Table {
    map(1, &[(0, 3), (0, 2), (0, 4), (0, 1), (0, 7), (0, 6), (0, 0), (0, 5)], &[(Some(0), &[])])
}

#[test]
fn surfaces_of_genus_1_and_2() {
    let torus = k7();
    let found = validate(&torus, &MESH, Collect::All).figures().unwrap();
    assert_eq!((agree(&torus, MESH), found.genus, found.faces), (None, 1, 14));
    assert_eq!(agree(&torus.without(Part::Holes), PLANE), Some(Rule::T3));
    let double = two_handles();
    assert_eq!(figures(&double, MESH).genus, 2);
    let violation = Violation::Genus { vertex: 0, vertices: 1, edges: 4, cycles: 1, genus: 2 };
    assert_eq!(violations(&double.without(Part::Holes), PLANE), [violation]);
}

#[test]
fn a_combinatorial_map_alone() {
    let mut table = two_handles().without(Part::Faces);
    table.boundaries.clear();
    table.faces.clear();
    let found = figures(&table, MESH);
    assert_eq!((found.edges, found.faces, found.cycles, found.genus), (4, 0, 1, 2));
    let lacks = Unchecked::Lacks(Part::Faces);
    let only = Unchecked::PlaneOnly;
    let faces = [(Rule::B1, lacks), (Rule::B2, only), (Rule::F1, lacks), (Rule::F2, lacks)];
    assert_eq!(found.not_checked, [&faces[..], &[Rule::T1, Rule::T2, Rule::T4].map(|rule| (rule, only))].concat());
    assert_eq!(agree(&table, PLANE), Some(Rule::T3));
}

/// There are no half-edges, so the lists have more entries than half-edges.
#[test]
fn nothing_but_isolated_vertices_in_either_form() {
    let all: Vec<Start> = (0..9).map(Start::Vertex).collect();
    let faces: [(Option<usize>, &[Start]); 1] = [(None, &all)];
    let by_record = map(9, &[], &faces);
    for table in [by_record.without(Part::Places), by_record, textbook_map(9, &[], &faces)] {
        let found = figures(&table, PLANE);
        assert_eq!((found.vertices, found.edges, found.faces, found.components), (9, 0, 1, 9));
    }
}

/// A loop inside a loop, with half-edges 0 and 2 on their insides; face 1 is between them, face 2 innermost.
const LOOP_IN_LOOP: [(usize, usize); 4] = [(0, 0), (0, 1), (1, 2), (1, 3)];

/// Half-edge 1 is outside everything, where there is no face, and the face between has a hole and an isolated vertex.
#[test]
fn an_open_outside_and_holes_inside() {
    let faces: [(Option<usize>, &[Start]); 2] = [(Some(0), &[Start::HalfEdge(3), Start::Vertex(2)]), (Some(2), &[])];
    for mut table in [map(3, &LOOP_IN_LOOP, &faces), textbook_map(3, &LOOP_IN_LOOP, &faces)] {
        let found = figures(&table.without(Part::UnboundedFace), PLANE.open());
        assert_eq!((found.components, found.faces, found.cycles, found.borders), (3, 2, 3, 1));
        // If the outside has no face, a record of the unbounded face is optional.
        assert_eq!(agree(&table, PLANE.open()), Some(Rule::F1));
        table.faces.push(Some(FaceRow::default()));
        assert_eq!(figures(&table, PLANE.open()).faces, 3);
        assert_eq!(agree(&table, PLANE), Some(Rule::R1));
    }
}

/// Two triangles side by side in the plane, without twins on the border: no face lists the outside.
#[test]
fn an_outside_without_half_edges() {
    let mut table = textbook_mesh(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]);
    table.half_edges.iter_mut().flatten().filter(|row| row.face >= Some(2)).for_each(|row| row.face = None);
    table.faces.truncate(2);
    let table = without_border(&table);
    let found = figures(&table.without(Part::UnboundedFace), PLANE.open());
    assert_eq!((found.vertices, found.edges, found.faces, found.components), (4, 5, 2, 1));
    assert!(found.bounds.is_some(), "no two edges are parallel");
}

/// As on a sphere, both sides of the outer loop are bounded, so its component has no inner boundary component.
#[test]
fn no_unbounded_face_but_holes() {
    let faces: [(Option<usize>, &[Start]); 3] = [(Some(1), &[]), (Some(0), &[Start::HalfEdge(3)]), (Some(2), &[])];
    let mut table = map(3, &LOOP_IN_LOOP, &faces);
    let unclaimed = Violation::IsolatedUnclaimed { vertex: 2 };
    assert_eq!(violations(&table, PLANE), [unclaimed, Violation::NoUnboundedFace]);
    // Vertex 2 lies in no face, so no boundary component starts at it.
    table.parts = table.parts.without(Part::UnboundedFace);
    assert_eq!(figures(&table, PLANE).isolated_vertices, 1);
    // But it cannot name one.
    vertex(&mut table, 2).isolated = Some(0);
    assert_eq!(violations(&table, PLANE), [unclaimed]);
    // And nothing lies inside itself.
    vertex(&mut table, 2).isolated = None;
    face(&mut table, 1).inner.clear();
    face(&mut table, 2).inner.push(Some(2));
    boundary(&mut table, 2).face = Some(2);
    assert_eq!(violations(&table, PLANE), [Violation::NestedInItself { vertex: 1, face: 2 }]);
}

#[test]
fn what_a_structure_lacks_is_not_checked_and_said() {
    let table = map(
        3,
        &LOOP_IN_LOOP,
        &[(None, &[Start::HalfEdge(1)]), (Some(0), &[Start::HalfEdge(3), Start::Vertex(2)]), (Some(2), &[])],
    );
    let not_simple = (Rule::T4, Unchecked::NotSimple);
    assert_eq!(not_checked(&table, PLANE), [not_simple]);
    // An incorrect part of the table only matters if it is stored.
    let mut wrong = table.clone();
    vertex(&mut wrong, 0).leaving = Some(2);
    assert_eq!(agree(&wrong, PLANE), Some(Rule::V1));
    assert_eq!(agree(&wrong.without(Part::Leaving), PLANE), None);
    let lacks = |rule, part| (rule, Unchecked::Lacks(part));
    assert_eq!(not_checked(&wrong.without(Part::Leaving), PLANE), [lacks(Rule::V1, Part::Leaving), not_simple]);
    let mut wrong = table.clone();
    boundary(&mut wrong, 3).place = None;
    assert_eq!(agree(&wrong, PLANE), Some(Rule::F2));
    assert_eq!(agree(&wrong.without(Part::Places), PLANE), None);
    let mut wrong = table;
    half_edge(&mut wrong, 0).prev = Some(1);
    assert_eq!(agree(&wrong, PLANE), Some(Rule::L2));
    assert_eq!(agree(&wrong.without(Part::Prev), PLANE), None);
    let without_holes = map(1, &LOOP_IN_LOOP[..2], &[(Some(1), &[]), (Some(0), &[])]);
    let holes = [Rule::B2, Rule::T1, Rule::T2].map(|rule| lacks(rule, Part::Holes));
    let expected = [holes.as_slice(), &[not_simple]].concat();
    assert_eq!(not_checked(&without_holes.without(Part::Holes), PLANE), expected);
}

#[test]
fn what_relies_on_a_broken_rule_is_not_checked_and_said() {
    let faces: [(Option<usize>, &[Start]); 3] =
        [(None, &[Start::HalfEdge(1)]), (Some(0), &[Start::HalfEdge(3)]), (Some(2), &[])];
    let right = map(2, &LOOP_IN_LOOP, &faces);
    let because = |broken, rules: &[Rule]| rules.iter().map(|r| (*r, Unchecked::Broken(broken))).collect::<Vec<_>>();
    let after = |change: &dyn Fn(&mut Table)| {
        let mut table = right.clone();
        change(&mut table);
        let report = validate(&table, &PLANE, Collect::All);
        assert!(!report.is_valid());
        assert_eq!(report.figures(), None);
        not_checked(&table, PLANE).into_iter().filter(|(_, why)| !why.is_by_design()).collect::<Vec<_>>()
    };
    let topology = [Rule::T1, Rule::T2, Rule::T3, Rule::T4];
    let all_but_live = [[Rule::L1, Rule::L2, Rule::L3, Rule::V2, Rule::B1].as_slice(), &topology].concat();
    assert_eq!(after(&|t| half_edge(t, 0).next = None), because(Rule::R1, &all_but_live));
    assert_eq!(after(&|t| vertex(t, 0).leaving = None), because(Rule::R1, &[Rule::T1, Rule::T2]));
    let all_but_links = [[Rule::V2].as_slice(), &topology].concat();
    assert_eq!(after(&|t| half_edge(t, 0).twin = Some(0)), because(Rule::L1, &all_but_links));
    let all_but_links = [[Rule::V2, Rule::B1].as_slice(), &topology].concat();
    assert_eq!(after(&|t| half_edge(t, 0).prev = Some(1)), because(Rule::L2, &all_but_links));
    assert_eq!(after(&|t| boundary(t, 0).start = Some(Start::HalfEdge(0))), because(Rule::B1, &[Rule::T1, Rule::T2]));
    let in_itself = |t: &mut Table| {
        (face(t, 0).outer, boundary(t, 0).place) = (Some(0), Some(BoundaryPlace::Outer));
        face(t, 0).inner.clear();
        t.faces.push(Some(FaceRow::default()));
    };
    assert_eq!(after(&in_itself), because(Rule::T1, &[Rule::T2]));
}

#[test]
fn as_many_violations_are_kept_as_asked_for_and_all_are_counted() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    for h in 0..12 {
        half_edge(&mut table, h).prev = None;
        half_edge(&mut table, h).face = Some(4);
    }
    let all = validate(&table, &MESH, Collect::All);
    assert_eq!((all.violations().len(), all.violation_count()), (24, 24));
    for kept in [0, 1, 5, 24, 25, usize::MAX] {
        let some = validate(&table, &MESH, Collect::AtMost(kept));
        assert_eq!(some.violations(), &all.violations()[..kept.min(24)]);
        assert_eq!(some.violation_count(), 24);
        assert!(some.outcomes().eq(all.outcomes()));
        assert_eq!(some.to_string().contains("… and"), kept < 24);
    }
    let first = validate(&table, &MESH, Collect::First);
    assert_eq!(first.violations(), &all.violations()[..1]);
    assert_eq!(first.violation_count(), 1);
    let mut later = first.outcomes().skip(1).filter(|(rule, _)| !rule.is_planar());
    assert!(later.all(|(_, outcome)| outcome.unchecked == Some(Unchecked::Stopped)));
}

#[test]
fn no_more_than_a_thousand_violations_are_kept_by_default() {
    let half_edges = vec![Some(HalfEdgeRow::default()); 1000];
    let table = Table { parts: Parts::ALL.without(Part::Faces), half_edges, ..Table::default() };
    let report = validate(&table, &MESH, Collect::All);
    assert_eq!((report.violations().len(), report.violation_count()), (Collect::DEFAULT_CAP, 4000));
    assert!(report.to_string().contains("hint: the prev of the first 250 half-edges is nil"), "{report}");
}

#[test]
fn the_debug_form_of_a_report_is_the_one_to_read() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    face(&mut table, 2).outer_half_edge = None;
    let report = validate(&table, &MESH, Collect::All);
    assert_eq!(format!("{report:?}"), report.to_string());
    assert!(report.to_string().contains(
        "face 2 has no outer boundary component, but every face of this structure needs one: `outer` (or, without \
         boundary component records, `outer_half_edge`) is nil"
    ));
}

#[test]
fn a_report_reads_as_sentences() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    let right = validate(&table, &MESH, Collect::All).to_string();
    for line in ["R1 live      ok, 68 links", "L1 twin      ok, 12 half-edges", "T3 Euler     ok, 1 component"] {
        assert!(right.lines().any(|found| found == line), "{right}");
    }
    half_edge(&mut table, 3).next = Some(99);
    half_edge(&mut table, 4).next = Some(usize::MAX);
    half_edge(&mut table, 5).twin = None;
    let wrong = validate(&table, &MESH, Collect::All).to_string();
    for part in [
        "R1 live      BROKEN, 3 violations in 68 links\n",
        "R1: the next of half-edge 4 leads to no record at all: following it reads something else\n",
        "V2 rotation  not checked: needs R1, which is broken\n",
        "R1: the next of half-edge 3 is 99, which is no live record: following it reads something else\n",
        "R1: the twin of half-edge 5 is nil, but the record needs one\n",
    ] {
        assert!(wrong.contains(part), "{wrong}");
    }
    let (boundary, listed) = (3, BoundaryPlace::Inner(1));
    let placed = |place| Violation::WrongPlace { boundary, place, listed };
    let sentences = [
        (placed(Some(BoundaryPlace::Inner(4))), "inner position 4"),
        (placed(Some(BoundaryPlace::Outer)), "the outer one"),
        (placed(None), "no place"),
        (placed(None), "inner position 1"),
        (Violation::TwinNotMutual { half_edge: 1, twin: 2, found: None }, "half-edge 1 has twin 2, whose twin is nil"),
        (Violation::NoUnboundedFace, "one face of a plane is unbounded"),
        (Violation::TooManyEdges { vertices: 5, edges: 10 }, "10 edges on 5 vertices, more than 3V − 6 = 9"),
        (Violation::TooManyFaces { vertices: 1, faces: 9 }, "more than 2V − 4 = 0"),
        (Violation::TooManyFaces { vertices: usize::MAX, faces: 9 }, "has 9 faces"),
    ];
    for (violation, part) in sentences {
        assert!(violation.to_string().contains(part), "{violation}");
    }
}

/// A view of a combinatorial map answers only six questions; everything else is absent by default.
#[test]
fn what_a_view_does_not_answer_is_not_there() {
    struct Digon;
    impl View for Digon {
        view_answers! { |_digon|
            parts => Parts::NONE,
            vertex_slots => 2,
            half_edge_slots => 4,
            origin(h) => Some(h % 2),
            twin(h) => Some(h ^ 1),
            next(h) => Some(3 - h),
        }
    }
    let found = validate(&Digon, &PLANE, Collect::All);
    let found = found.figures().unwrap_or_else(|| panic!("{found}"));
    assert_eq!((found.vertices, found.edges, found.cycles, found.components), (2, 2, 2, 1));

    assert_eq!((Digon.boundary_slots(), Digon.face_slots()), (0, 0));
    assert_eq!([0, 1, 2, usize::MAX].map(|v| Digon.is_vertex(v)), [true, true, false, false]);
    assert_eq!([0, 3, 4, usize::MAX].map(|h| Digon.is_half_edge(h)), [true, true, false, false]);
    assert_eq!([0, 1].map(|i| (Digon.is_boundary(i), Digon.is_face(i))), [(false, false); 2]);
    assert_eq!((Digon.prev(0), Digon.boundary(0), Digon.face(0)), (None, None, None));
    assert_eq!((Digon.leaving(0), Digon.isolated(0)), (None, None));
    assert_eq!((Digon.boundary_face(0), Digon.boundary_start(0), Digon.boundary_place(0)), (None, None, None));
    assert_eq!((Digon.outer(0), Digon.inner_count(0), Digon.inner(0, 0)), (None, 0, None));
    assert_eq!((Digon.outer_half_edge(0), Digon.inner_start(0, 0)), (None, None));
}

#[test]
fn every_expectation_is_read_as_it_was_written() {
    let mut all = Expectation::surface().open();
    let words = ["no-unused-vertices", "simple", "sides", "closed", "components", "borders", "genus", "border-kept"];
    for (word, rule) in words.into_iter().zip(Rule::ALL.iter().filter(|rule| rule.is_optional())) {
        let number = matches!(word, "sides" | "components" | "borders" | "genus").then_some(7);
        let [one, more] = [Expectation::plane(), all].map(|expectation| expectation.asking(word, number).unwrap());
        assert!(one.asks_for(*rule) && !Expectation::plane().asks_for(*rule));
        assert!(one.to_string().starts_with(&["plane asking ", word].concat()));
        for expectation in [one, more] {
            assert_eq!(expectation.to_string().parse(), Ok(expectation));
        }
        all = more;
    }
    assert_eq!(
        all.to_string(),
        "surface open asking no-unused-vertices simple sides 7 closed components 7 \
         borders 7 genus 7 border-kept"
    );
    assert_eq!("plane open asking closed".parse(), Ok(Expectation::plane().open().closed()));
    assert_eq!("surface".parse(), Ok(Expectation::surface()));
}

#[test]
fn other_words_are_errors() {
    for (text, error, told) in [
        ("", ParseExpectationError::Surface, "expected `plane` or `surface`"),
        ("sphere", ParseExpectationError::Surface, "expected `plane` or `surface`"),
        (
            "plane closed",
            ParseExpectationError::Claim { word: "closed".into() },
            "expected `open` or `asking` in place of `closed`",
        ),
        (
            "plane asking handles",
            ParseExpectationError::Rule { word: "handles".into() },
            "`handles` cannot be asked for, but no-unused-vertices, simple, sides, closed, components, borders, genus, \
             border-kept can",
        ),
        ("plane asking genus", ParseExpectationError::Number { after: "genus" }, "expected a number after `genus`"),
        (
            "plane asking sides three",
            ParseExpectationError::Number { after: "sides" },
            "expected a number after `sides`",
        ),
    ] {
        assert_eq!(error.to_string(), told);
        assert_eq!(text.parse::<Expectation>(), Err(error), "{text}");
    }
    let with_a_number = Expectation::surface().asking("closed", Some(1));
    assert_eq!(with_a_number, Err(ParseExpectationError::Rule { word: "1".into() }));
}
