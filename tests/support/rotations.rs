//! All surfaces with few edges.

use twinedge::validate::{FaceRow, HalfEdgeRow, Part, Parts, Table, VertexRow};

/// Visits each surface of this many edges: twins `2e, 2e + 1`, any permutation as `next`, and the resulting vertices and
/// faces, with every part that surfaces have.
pub(crate) fn each_rotation_system(edges: usize, mut visit: impl FnMut(&Table)) {
    let mut next: Vec<usize> = (0..2 * edges).collect();
    permute(&mut next, 2 * edges, &mut |next| visit(&rotation_system(next)));
}

/// Heap's algorithm.
fn permute(numbers: &mut [usize], left: usize, visit: &mut impl FnMut(&[usize])) {
    if left <= 1 {
        return visit(numbers);
    }
    for i in 0..left {
        permute(numbers, left - 1, visit);
        numbers.swap(if left % 2 == 0 { i } else { 0 }, left - 1);
    }
}

fn rotation_system(next: &[usize]) -> Table {
    // The numbers of the orbits, in the order of their first half-edges.
    let orbits = |step: &dyn Fn(usize) -> usize| {
        let (mut of, mut first) = (vec![usize::MAX; next.len()], Vec::new());
        for start in 0..next.len() {
            let mut h = start;
            while of[h] == usize::MAX {
                if h == start {
                    first.push(start);
                }
                of[h] = first.len() - 1;
                h = step(h);
            }
        }
        (of, first)
    };
    let (origin, leaving) = orbits(&|h| next[h ^ 1]);
    let (face, outer) = orbits(&|h| next[h]);
    let half_edge = |h: usize| HalfEdgeRow {
        origin: Some(origin[h]),
        twin: Some(h ^ 1),
        next: Some(next[h]),
        prev: next.iter().position(|next| *next == h),
        face: Some(face[h]),
        ..HalfEdgeRow::default()
    };
    let vertex = |h: &usize| Some(VertexRow { leaving: Some(*h), ..VertexRow::default() });
    let face = |h: &usize| Some(FaceRow { outer_half_edge: Some(*h), ..FaceRow::default() });
    Table {
        parts: Parts::NONE.with(Part::Prev).with(Part::Leaving).with(Part::Faces),
        vertices: leaving.iter().map(vertex).collect(),
        half_edges: (0..next.len()).map(|h| Some(half_edge(h))).collect(),
        faces: outer.iter().map(face).collect(),
        ..Table::default()
    }
}
