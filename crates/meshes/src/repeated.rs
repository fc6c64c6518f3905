//! Faces with the vertices of an earlier face, in the same order or the opposite one.
//!
//! Only faces with the same smallest vertex are compared: few in pairs, many by a hash table with random keys, so that no file
//! can slow it down.

use super::{Finding, Findings, IndexedMesh, Kind};
use std::collections::HashMap;
use std::hash::{Hash, Hasher};

/// The largest number of faces that are compared in pairs.
const FEW: usize = 8;

/// A face, read from its smallest vertex towards the smaller one of that vertex's neighbours.
#[derive(Clone, Copy)]
struct Cycle<'a> {
    vertices: &'a [u32],
    start: usize,
    reversed: bool,
}

impl<'a> Cycle<'a> {
    /// Of a face with three or more vertices, all distinct.
    fn new(vertices: &'a [u32]) -> Self {
        let start = (0..vertices.len()).min_by_key(|i| vertices[*i]).unwrap_or_default();
        let after = vertices[(start + 1) % vertices.len()];
        let before = vertices[(start + vertices.len() - 1) % vertices.len()];
        Self { vertices, start, reversed: before < after }
    }

    fn iter(self) -> impl Iterator<Item = u32> + 'a {
        let Self { vertices, start, reversed } = self;
        let (from_start, to_start) = (&vertices[start..], &vertices[..start]);
        let forward = from_start.iter().chain(to_start);
        // The start comes first in both directions.
        let backward = from_start[..1].iter().chain(to_start.iter().rev()).chain(from_start[1..].iter().rev());
        let (forward, backward) = if reversed { (None, Some(backward)) } else { (Some(forward), None) };
        forward.into_iter().flatten().chain(backward.into_iter().flatten()).copied()
    }
}

impl PartialEq for Cycle<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

impl Eq for Cycle<'_> {}

impl Hash for Cycle<'_> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.iter().for_each(|vertex| state.write_u32(vertex));
    }
}

/// Leaves out every face that repeats an earlier one. O(corners), expected.
pub(super) fn leave_out(mesh: &IndexedMesh, left_out: &mut [bool], findings: &mut Findings) {
    // The faces, sorted by their smallest vertex.
    let mut ends = vec![0_u32; mesh.points().len() + 1];
    let smallest = |face: &[u32]| face.iter().copied().min().map_or(0, |vertex| vertex as usize);
    for (_, face) in mesh.faces().enumerate().filter(|(f, _)| !left_out[*f]) {
        ends[smallest(face) + 1] += 1;
    }
    for v in 1..ends.len() {
        ends[v] += ends[v - 1];
    }
    let mut sorted = vec![0_u32; ends.last().map_or(0, |end| *end as usize)];
    // As the buckets are filled, the start of each becomes its end.
    for (f, face) in mesh.faces().enumerate().filter(|(f, _)| !left_out[*f]) {
        let end = &mut ends[smallest(face)];
        sorted[*end as usize] = f as u32;
        *end += 1;
    }

    let mut found = Vec::new();
    let mut start = 0;
    for end in ends {
        let bucket = &sorted[start..(end as usize).max(start)];
        start = start.max(end as usize);
        if bucket.len() > FEW {
            let mut first_of = HashMap::with_capacity(bucket.len());
            for f in bucket {
                let first = *first_of.entry(Cycle::new(mesh.face(*f as usize))).or_insert(*f);
                if first != *f {
                    found.push((*f, first));
                }
            }
        } else {
            for (i, f) in bucket.iter().enumerate() {
                let cycle = Cycle::new(mesh.face(*f as usize));
                if let Some(first) = bucket[..i].iter().find(|first| Cycle::new(mesh.face(**first as usize)) == cycle) {
                    found.push((*f, *first));
                }
            }
        }
    }
    found.sort_unstable();
    for (face, first) in found.into_iter().map(|(face, first)| (face as usize, first as usize)) {
        left_out[face] = true;
        findings.add(Kind::RepeatedFace, || {
            let vertices = mesh.face(face);
            let reversed = Cycle::new(vertices).reversed != Cycle::new(mesh.face(first)).reversed;
            Finding::RepeatedFace { face, first, reversed, vertices: vertices.iter().map(|v| *v as usize).collect() }
        });
    }
}
