//! Two triangles, one in the other, and an isolated vertex between them.

use super::tables::{ShortFace, map, textbook_map};
use twinedge::validate::{Expectation, Start, Table};

pub(crate) const PLANE: Expectation = Expectation::plane();

/// ```text
///   face 0                 A: vertices 0 1 2, half-edges 0 2 4 inside and 1 3 5 outside
///        2                 B: vertices 3 4 5, half-edges 6 8 10 inside and 7 9 11 outside
///       / \                boundary components: 0 around A, listed by face 0
///      / 5 \                                    1 in A, outer of face 1
///     / / \ \                                   2 around B and 3, which is vertex 6, listed by face 1
///    / /_2_\ \  ·6                              4 in B, outer of face 2
///   /  3   4  \            face 1 lies between A and B, face 2 in B
///  0 ───────── 1
/// ```
pub(crate) const HALF_EDGES: [(usize, usize); 12] =
    [(0, 2), (1, 5), (1, 4), (2, 1), (2, 0), (0, 3), (3, 8), (4, 11), (4, 10), (5, 7), (5, 6), (3, 9)];
pub(crate) const FACES: [ShortFace<'_>; 3] =
    [(None, &[Start::HalfEdge(1)]), (Some(0), &[Start::HalfEdge(7), Start::Vertex(6)]), (Some(6), &[])];

/// The triangles as a table.
pub(crate) fn nested() -> Table {
    map(7, &HALF_EDGES, &FACES)
}

/// The triangles in the form of the textbook.
pub(crate) fn nested_textbook() -> Table {
    textbook_map(7, &HALF_EDGES, &FACES)
}
