//! The tables of the textbooks, entered by hand, and every change of one of their fields.
//!
//! (a) is the polygonal map with a dangling edge of the lecture notes CS60064, lecture 12, after de Berg et al.,
//! *Computational Geometry*, chapter 2. (b) is the map of five faces that is often used to explain the three tables;
//! only four rows of its half-edge table are given (marked `*`), but all of the vertex and the face table.

use crate::support::erased::validate;
use crate::support::nested::PLANE;
use crate::support::opinions::agree;
use crate::support::tables::{TEXTBOOK, face, with_boundary_components};
use std::collections::BTreeSet;
use twinedge::validate::{
    Collect, Expectation, FaceRow, Figures, HalfEdgeRow, Link, Rule, Start, Table, Unchecked, VertexRow, View,
};
use twinedge_trials::enumerate::{Cell, Value, for_each_corruption};

/// ```text
///   v1 ────e1──── v2        e1,1 runs from v1 to v2, with f1 on its left
///     \    f2   /
///       e3    e4    f1
///         \  /
///          v3 ──e2── v4     e2 dangles in f1
/// ```
const DANGLING: Textbook = Textbook {
    half_edges: "
        e1,1  v1  e1,2  f1  e4,2  e3,1
        e1,2  v2  e1,1  f2  e3,2  e4,1
        e2,1  v3  e2,2  f1  e2,2  e4,2
        e2,2  v4  e2,1  f1  e3,1  e2,1
        e3,1  v3  e3,2  f1  e1,1  e2,2
        e3,2  v1  e3,1  f2  e4,1  e1,2
        e4,1  v3  e4,2  f2  e1,2  e3,2
        e4,2  v2  e4,1  f1  e2,1  e1,1",
    vertices: "
        v1  e1,1
        v2  e4,2
        v3  e2,1
        v4  e2,2",
    faces: "
        f1  nil   e1,1
        f2  e4,1",
};

/// ```text
///         v1
///        /  \            f1 = e1 e2 e3    f2 = e3 e4 e5
///      e2 f1 e1          f3 = e5 e6 e7    f4 = e6 e8 e9
///      /      \          f5 is outside
///    v2 ──e3── v3
///      \  f2  / \
///      e4   e5   e7
///        \  / f3  \
///         v4 ──e6── v6
///          \  f4   /
///           e8    e9
///             \  /
///              v5
/// ```
///
/// The given rows have two completions, which differ in the edge that joins v3 to v6, e7 or e9. This one numbers the
/// edges of each triangle as the drawing does, in the order in which the faces are added.
const FIVE_FACES: Textbook = Textbook {
    half_edges: "
        e1,1  V3  e1,2  f1  e2,1  e3,1
        e1,2  V1  e1,1  f5  e7,2  e2,2
        e2,1  V1  e2,2  f1  e3,1  e1,1
        e2,2  V2  e2,1  f5  e1,2  e4,2
      * e3,1  V2  e3,2  f1  e1,1  e2,1
      * e3,2  V3  e3,1  f2  e4,1  e5,1
      * e4,1  V2  e4,2  f2  e5,1  e3,2
      * e4,2  V4  e4,1  f5  e2,2  e8,2
        e5,1  V4  e5,2  f2  e3,2  e4,1
        e5,2  V3  e5,1  f3  e6,1  e7,1
        e6,1  V4  e6,2  f3  e7,1  e5,2
        e6,2  V6  e6,1  f4  e8,1  e9,1
        e7,1  V6  e7,2  f3  e5,2  e6,1
        e7,2  V3  e7,1  f5  e9,2  e1,2
        e8,1  V4  e8,2  f4  e9,1  e6,2
        e8,2  V5  e8,1  f5  e4,2  e9,2
        e9,1  V5  e9,2  f4  e6,2  e8,1
        e9,2  V6  e9,1  f5  e8,2  e7,2",
    vertices: "
      * V1  e2,1
      * V2  e4,1
      * V3  e3,2
      * V4  e6,1
      * V5  e9,1
      * V6  e7,1",
    faces: "
      * f1  e1,1
      * f2  e5,1
      * f3  e5,2
      * f4  e8,1
      * f5  nil   e9,2",
};

/// Three tables as printed. A half-edge has origin, twin, face, next and prev; a vertex a leaving half-edge; a face a
/// half-edge of its outer boundary component and of each inner one.
struct Textbook {
    half_edges: &'static str,
    vertices: &'static str,
    faces: &'static str,
}

impl Textbook {
    fn rows(text: &'static str) -> Vec<Vec<&'static str>> {
        let rows = text.lines().map(|line| line.split_whitespace().filter(|word| *word != "*").collect::<Vec<_>>());
        rows.filter(|row| !row.is_empty()).collect()
    }

    fn table(&self) -> Table {
        let [half_edges, vertices, faces] = [self.half_edges, self.vertices, self.faces].map(Self::rows);
        let find = |rows: &[Vec<&str>], name: &str| -> Link {
            (name != "nil").then(|| rows.iter().position(|row| row[0] == name).unwrap())
        };
        let half_edge = |name| find(&half_edges, name);
        Table {
            parts: TEXTBOOK,
            vertices: vertices
                .iter()
                .map(|row| Some(VertexRow { leaving: half_edge(row[1]), ..VertexRow::default() }))
                .collect(),
            half_edges: half_edges
                .iter()
                .map(|row| {
                    Some(HalfEdgeRow {
                        origin: find(&vertices, row[1]),
                        twin: half_edge(row[2]),
                        face: find(&faces, row[3]),
                        next: half_edge(row[4]),
                        prev: half_edge(row[5]),
                        boundary: None,
                    })
                })
                .collect(),
            boundaries: vec![],
            faces: faces
                .iter()
                .map(|row| {
                    let inner_starts = row[2..].iter().map(|name| half_edge(name).map(Start::HalfEdge)).collect();
                    Some(FaceRow { outer_half_edge: half_edge(row[1]), inner_starts, ..FaceRow::default() })
                })
                .collect(),
        }
    }
}

fn figures(table: &Table, expectation: Expectation) -> Figures {
    assert_eq!(agree(table, expectation), None);
    validate(table, &expectation, Collect::All).figures().unwrap()
}

#[test]
fn the_map_with_a_dangling_edge_is_accepted() {
    for table in [DANGLING.table(), with_boundary_components(&DANGLING.table())] {
        let found = figures(&table, PLANE);
        assert_eq!((found.vertices, found.edges, found.faces), (4, 4, 2));
        assert_eq!((found.components, found.cycles, found.isolated_vertices, found.genus), (1, 2, 0, 0));
        let bounds = found.bounds.unwrap();
        assert_eq!((bounds.most_edges, bounds.most_faces), (6, 4));
        assert_eq!(found.not_checked, []);
    }
}

#[test]
fn the_map_of_five_faces_is_accepted() {
    for table in [FIVE_FACES.table(), with_boundary_components(&FIVE_FACES.table())] {
        let found = figures(&table, PLANE);
        assert_eq!((found.vertices, found.edges, found.faces), (6, 9, 5));
        assert_eq!((found.components, found.cycles, found.isolated_vertices, found.genus), (1, 5, 0, 0));
        let bounds = found.bounds.unwrap();
        assert_eq!((bounds.most_edges, bounds.most_faces), (12, 8));
        assert_eq!(found.not_checked, []);
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
fn every_change_of_one_field_of_the_first_map_is_judged_right() {
    let table = DANGLING.table();
    let harmless = (8 - 4) + (8 - 2);
    let rows = 8 * (6 + 10 + 10 + 10 + 4) + 4 * 10;
    assert_eq!(change_every_field(&table, false), (rows + 2 * 10 + 16, harmless));
    assert_eq!(change_every_field(&table, true), (rows + 4 * 4 + 2 * (4 + 16 + 4) + 2 * 4 + 4, harmless));
}

#[test]
fn every_change_of_one_field_of_the_second_map_is_judged_right() {
    let table = FIVE_FACES.table();
    let harmless = (18 - 6) + (18 - 5);
    let rows = 18 * (8 + 20 + 20 + 20 + 7) + 6 * 20;
    assert_eq!(change_every_field(&table, false), (rows + 5 * 20 + 28, harmless));
    assert_eq!(change_every_field(&table, true), (rows + 6 * 7 + 5 * (7 + 28 + 4) + 5 * 7 + 7, harmless));
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
