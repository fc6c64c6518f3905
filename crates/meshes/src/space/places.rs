//! The points of a mesh, with those at the same place merged, and exact signs.

use super::super::{HalfEdgeMesh, IndexedMesh};
use robust::{Coord, Coord3D};
use std::cmp::Ordering;
use std::collections::HashMap;

pub(super) type Place = [f64; 3];

/// A corner of a triangle: its place and its identifying number.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) number: u32,
    pub(super) at: Place,
}

pub(super) struct Places<'a> {
    mesh: &'a IndexedMesh,
    /// For each point, the first point at its place.
    first: Vec<u32>,
}

impl<'a> Places<'a> {
    /// O(points), expected.
    pub(super) fn new(mesh: &'a IndexedMesh) -> Self {
        let mut known: HashMap<[u64; 3], u32> = HashMap::new();
        // Adding 0 turns −0 into 0, which is the same place.
        let key = |at: &Place| at.map(|x| (x + 0.0).to_bits());
        let first = mesh.points().iter().zip(0..).map(|(at, number)| *known.entry(key(at)).or_insert(number)).collect();
        Self { mesh, first }
    }

    pub(super) fn corners(&self, face: usize) -> Vec<Corner> {
        let corner =
            |point: &u32| Corner { number: self.first[*point as usize], at: self.mesh.points()[*point as usize] };
        self.mesh.face(face).iter().map(corner).collect()
    }

    /// Returns the triangles of a face: those between its first corner and its other sides.
    pub(super) fn triangles(&self, face: usize) -> Vec<[Corner; 3]> {
        match &self.corners(face)[..] {
            [first, others @ ..] => others.windows(2).map(|pair| [*first, pair[0], pair[1]]).collect(),
            [] => Vec::new(),
        }
    }
}

pub(super) fn faces(mesh: &HalfEdgeMesh<'_>) -> impl Iterator<Item = usize> {
    (0..mesh.mesh().face_count()).filter(|face| !mesh.is_left_out(*face))
}

/// Returns the side of the plane through three places on which a fourth lies: greater for the side from which they turn
/// clockwise, equal on the plane. Exact.
pub(super) fn side([a, b, c]: [Place; 3], d: Place) -> Ordering {
    let of = |[x, y, z]: Place| Coord3D { x, y, z };
    sign(robust::orient3d(of(a), of(b), of(c), of(d)))
}

/// Returns the turn of three places, seen along an axis: greater to the left. Exact.
pub(super) fn turn([a, b, c]: [Place; 3], axis: usize) -> Ordering {
    let of = |at: Place| Coord { x: at[(axis + 1) % 3], y: at[(axis + 2) % 3] };
    sign(robust::orient2d(of(a), of(b), of(c)))
}

/// Returns an axis along which three places turn; `None` for places on one line.
pub(super) fn axis_of(places: [Place; 3]) -> Option<usize> {
    (0..3).find(|axis| turn(places, *axis).is_ne())
}

pub(super) fn sign(number: f64) -> Ordering {
    number.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}
