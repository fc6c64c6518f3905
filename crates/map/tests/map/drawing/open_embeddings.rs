//! G1 … G5 in structures with an open boundary or without an unbounded face: components outside everything lie in no face.

use crate::support::drawn::Drawn;
use crate::support::tables::{TEXTBOOK, Without, half_edge, map, textbook_map};
use twinedge::validate::{
    Expectation, FaceRow, HalfEdgeRow, Part, Parts, Record, Rule, Start, Table, VertexRow, Violation,
};

const OPEN: Expectation = Expectation::plane().open();

const BOUNDED: Parts = TEXTBOOK.without(Part::UnboundedFace);

/// Two triangles, A of vertices 0 1 2 and half-edges 0 to 5, B of 3 4 5 and 6 to 11, the even ones inside. A lies outside
/// everything. B is listed by the face in A, or also lies outside everything.
fn two_triangles(by_record: bool, listed: bool, b: [[f64; 2]; 3]) -> Drawn {
    let triangle = [(0, 2), (1, 5), (1, 4), (2, 1), (2, 0), (0, 3)];
    let mut half_edges = triangle.to_vec();
    half_edges.extend(triangle.map(|(origin, next)| (origin + 3, next + 6)));
    let inner: &[Start] = if listed { &[Start::HalfEdge(7)] } else { &[] };
    let faces = [(Some(0), inner), (Some(6), &[])];
    let table = if by_record { map(6, &half_edges, &faces) } else { textbook_map(6, &half_edges, &faces) };
    let points = [[[0.0, 0.0], [10.0, 0.0], [0.0, 10.0]], b].concat();
    Drawn::new(table.without(Part::UnboundedFace), points)
}

const IN_A: [[f64; 2]; 3] = [[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]];
const FAR: [[f64; 2]; 3] = [[100.0, 100.0], [101.0, 100.0], [100.0, 101.0]];
const ABOVE_A: [[f64; 2]; 3] = [[5.0, 100.0], [6.0, 100.0], [5.0, 101.0]];

#[test]
fn g5_a_hole_that_lies_outside_everything() {
    for (by_record, boundary, name) in
        [(false, Record::HalfEdge(7), "at half-edge 7"), (true, Record::Boundary(1), "1")]
    {
        let report = two_triangles(by_record, true, IN_A).report(&OPEN);
        assert!(report.is_valid(), "{report}");
        assert_eq!(report.outcome(Rule::G5).map(|outcome| (outcome.checked, outcome.unchecked)), Some((1, None)));
        for outside in [FAR, ABOVE_A] {
            let report = two_triangles(by_record, true, outside).report(&OPEN);
            let violation = Violation::WrongFace { boundary, face: 0, found: None };
            assert_eq!(report.violations(), [violation], "{report}");
            let sentence = format!("the inner boundary component {name} is listed by face 0, but lies in no face");
            assert_eq!(violation.message(), sentence);
        }
    }
}

#[test]
fn g5_what_no_face_lists_lies_in_a_face() {
    for by_record in [false, true] {
        for outside in [FAR, ABOVE_A] {
            let report = two_triangles(by_record, false, outside).report(&OPEN);
            assert!(report.is_valid(), "{report}");
        }
        let report = two_triangles(by_record, false, IN_A).report(&OPEN);
        let violation = Violation::Unlisted { vertex: 3, face: 0 };
        assert_eq!(report.violations(), [violation], "{report}");
        assert_eq!(
            (violation.rule(), violation.records()),
            (Rule::G5, [Some(Record::Vertex(3)), Some(Record::Face(0))])
        );
        assert_eq!(violation.message(), "the component of vertex 3 lies in face 0, which does not list it");
    }
}

/// The unbounded face may exist although open boundaries have no face: then they lie in it without being listed.
#[test]
fn g5_an_open_outside_in_the_unbounded_face() {
    let mut drawn = two_triangles(false, false, FAR);
    drawn.structure.faces.push(Some(FaceRow::default()));
    drawn.structure.parts = TEXTBOOK;
    assert!(drawn.report(&OPEN).is_valid(), "{}", drawn.report(&OPEN));
    drawn.points = two_triangles(false, false, IN_A).points;
    assert_eq!(drawn.report(&OPEN).violations(), [Violation::Unlisted { vertex: 3, face: 0 }]);
}

/// Triangles of half-edges without twins: nothing is known beyond them.
fn without_twins(triangles: &[[[f64; 2]; 3]]) -> Drawn {
    let mut drawn = Drawn::new(Table { parts: BOUNDED, ..Table::default() }, triangles.concat());
    for f in 0..triangles.len() {
        for i in 0..3 {
            let at = |i: usize| Some(3 * f + i % 3);
            drawn.structure.vertices.push(Some(VertexRow { leaving: at(i), isolated: None }));
            let (next, prev) = (at(i + 1), at(i + 2));
            drawn.structure.half_edges.push(Some(HalfEdgeRow {
                origin: at(i),
                next,
                prev,
                face: Some(f),
                ..HalfEdgeRow::default()
            }));
        }
        drawn.structure.faces.push(Some(FaceRow { outer_half_edge: Some(3 * f), ..FaceRow::default() }));
    }
    drawn
}

/// A half-edge that runs to the left does not have the face above its edge on its left.
#[test]
fn g5_no_face_above_an_open_boundary() {
    let below = [[0.0, 0.0], [10.0, 0.0], [5.0, 5.0]];
    let above = [[4.0, 6.0], [6.0, 6.0], [5.0, 8.0]];
    let report = without_twins(&[below, above]).report(&OPEN);
    assert!(report.is_valid(), "{report}");
    let inside = [[4.0, 1.0], [6.0, 1.0], [5.0, 3.0]];
    let report = without_twins(&[below, inside]).report(&OPEN);
    assert_eq!(report.violations(), [Violation::Unlisted { vertex: 3, face: 0 }], "{report}");
}

/// Three triangles side by side around vertex 0, without half-edges on the border. All angles, from every starting number.
///
/// ```text
///    3 ─── 2
///    │ ╲ │ ╱ ╲
///    4 ── 0 ── 1
/// ```
#[test]
fn g2_around_a_vertex_at_an_open_boundary() {
    let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 2.0], [-1.0, 2.0], [-2.0, 0.0]];
    for first in 0..3 {
        let mut table = Table { parts: BOUNDED, ..Table::default() };
        // Triangle i has half-edges 0 → i + 1, i + 1 → i + 2 and i + 2 → 0.
        let number = |triangle: usize, side: usize| 3 * ((triangle + first) % 3) + side;
        table.half_edges.resize(9, None);
        table.vertices.resize(5, Some(VertexRow::default()));
        table.faces.resize(3, None);
        for triangle in 0..3 {
            let corners = [0, triangle + 1, triangle + 2];
            for (side, corner) in corners.into_iter().enumerate() {
                let h = number(triangle, side);
                table.vertices[corner] = Some(VertexRow { leaving: Some(h), isolated: None });
                let twin = match side {
                    0 if triangle > 0 => Some(number(triangle - 1, 2)),
                    2 if triangle < 2 => Some(number(triangle + 1, 0)),
                    _ => None,
                };
                table.half_edges[h] = Some(HalfEdgeRow {
                    origin: Some(corner),
                    twin,
                    next: Some(number(triangle, (side + 1) % 3)),
                    prev: Some(number(triangle, (side + 2) % 3)),
                    face: Some(triangle),
                    boundary: None,
                });
            }
            table.faces[triangle] = Some(FaceRow { outer_half_edge: Some(number(triangle, 0)), ..FaceRow::default() });
        }
        // The last vertex keeps a half-edge only if one leaves it.
        assert_eq!(half_edge(&mut table, number(2, 2)).origin, Some(4));
        let drawn = Drawn::new(table, points);
        assert!(drawn.report(&OPEN).is_valid(), "{}", drawn.report(&OPEN));
        let mirrored = Drawn::new(drawn.structure.clone(), points.map(|[x, y]| [-x, y]));
        let report = mirrored.report(&OPEN);
        assert_eq!(report.outcome(Rule::G2).map(|outcome| outcome.violations), Some(1), "{report}");
    }
}
