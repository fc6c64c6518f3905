//! The tables of the textbooks, entered by hand.
//!
//! (a) is the polygonal map with a dangling edge of the lecture notes CS60064, lecture 12, after de Berg et al.,
//! *Computational Geometry*, chapter 2. (b) is the map of five faces that is often used to explain the three tables;
//! only four rows of its half-edge table are given (marked `*`), but all of the vertex and the face table.

use super::tables::TEXTBOOK;
use twinedge::validate::{FaceRow, HalfEdgeRow, Link, Start, Table, VertexRow};

/// ```text
///   v1 ────e1──── v2        e1,1 runs from v1 to v2, with f1 on its left
///     \    f2   /
///       e3    e4    f1
///         \  /
///          v3 ──e2── v4     e2 dangles in f1
/// ```
pub(crate) const DANGLING: Textbook = Textbook {
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
pub(crate) const FIVE_FACES: Textbook = Textbook {
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
pub(crate) struct Textbook {
    pub(crate) half_edges: &'static str,
    pub(crate) vertices: &'static str,
    pub(crate) faces: &'static str,
}

impl Textbook {
    fn rows(text: &'static str) -> Vec<Vec<&'static str>> {
        let rows = text.lines().map(|line| line.split_whitespace().filter(|word| *word != "*").collect::<Vec<_>>());
        rows.filter(|row| !row.is_empty()).collect()
    }

    /// The table in the form of the textbook.
    pub(crate) fn table(&self) -> Table {
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
