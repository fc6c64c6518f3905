//! The half-edges of an indexed mesh, as the validator sees them.

use super::IndexedMesh;
use twinedge::validate::{Expectation, Link, Part, Parts, View};
use twinedge_geometry::Point;
use twinedge_map::Embedding;

pub(super) const NIL: u32 = u32::MAX;

/// The half-edges of an [`IndexedMesh`]: one for each corner, with the corner's number, from its vertex to the next one of the
/// face.
///
/// Faces that are degenerate or repeat others are left out: their slots are vacant. Where an edge cannot be joined (three faces,
/// flipped faces), its half-edges have no twin. The mesh is borrowed: this adds 8 bytes per corner, 4 per vertex and 1 per face.
///
/// As a [`View`], `next`, `prev` and the faces come straight from the lists, so that L2, B1, F1 and F2 hold by construction. The
/// validator judges the joining: L1, L3, V1, V2 and T3.
#[derive(Clone, Debug)]
pub struct HalfEdgeMesh<'a> {
    pub(super) mesh: &'a IndexedMesh,
    /// The face of each corner; nil if it is left out.
    pub(super) face_of: Vec<u32>,
    pub(super) twins: Vec<u32>,
    pub(super) leaving: Vec<u32>,
    pub(super) left_out: Vec<bool>,
    pub(super) edges: usize,
    pub(super) border_edges: usize,
    pub(super) orientable: bool,
    /// The axes of the plane of drawing.
    pub(super) axes: [usize; 2],
}

impl HalfEdgeMesh<'_> {
    /// Surfaces of any genus, with or without border. Other claims are added to that; [`simple`](Expectation::simple) is implied,
    /// as an edge is identified by its two ends.
    ///
    /// ```
    /// use twinedge_meshes::HalfEdgeMesh;
    /// // A torus of triangles.
    /// let torus = HalfEdgeMesh::expectation().closed().components(1).genus(1).triangles().no_unused_vertices();
    /// # let _ = torus;
    /// ```
    #[must_use]
    pub const fn expectation() -> Expectation {
        Expectation::surface().open()
    }

    /// The mesh.
    #[must_use]
    pub const fn mesh(&self) -> &IndexedMesh {
        self.mesh
    }

    /// Returns the number of edges, each counted once regardless of its number of faces. Faces that are left out have none.
    #[must_use]
    pub const fn edge_count(&self) -> usize {
        self.edges
    }

    /// Returns the number of edges with one face only.
    #[must_use]
    pub const fn border_edge_count(&self) -> usize {
        self.border_edges
    }

    /// Returns true if after flipping some faces, or none, any two faces would run in opposite directions along their common
    /// edge. A Möbius strip is not orientable. Edges with three or more faces do not count.
    #[must_use]
    pub const fn is_orientable(&self) -> bool {
        self.orientable
    }

    /// Returns true if the face is degenerate or repeats another.
    ///
    /// # Panics
    ///
    /// If there is no such face.
    #[must_use]
    pub fn is_left_out(&self, face: usize) -> bool {
        self.left_out[face]
    }

    pub(super) fn is_live(&self, h: u32) -> bool {
        self.face_of[h as usize] != NIL
    }

    pub(super) fn vertex_of(&self, h: u32) -> u32 {
        self.mesh.corners()[h as usize]
    }

    /// Of a live half-edge.
    #[inline]
    pub(super) fn next_of(&self, h: u32) -> u32 {
        let (offsets, face) = (self.mesh.offsets(), self.face_of[h as usize] as usize);
        if h + 1 == offsets[face + 1] { offsets[face] } else { h + 1 }
    }

    /// Of a live half-edge.
    #[inline]
    pub(super) fn prev_of(&self, h: u32) -> u32 {
        let (offsets, face) = (self.mesh.offsets(), self.face_of[h as usize] as usize);
        if h == offsets[face] { offsets[face + 1] - 1 } else { h - 1 }
    }
}

/// Drawn along the axis of the smallest extent.
impl Embedding for HalfEdgeMesh<'_> {
    fn point(&self, vertex: usize) -> Point {
        let point = self.mesh.points()[vertex];
        self.axes.map(|axis| point[axis]).into()
    }
}

/// Returns the two axes of the largest extent, in order. O(points).
pub(super) fn widest(points: &[[f64; 3]]) -> [usize; 2] {
    let extent = [0, 1, 2].map(|axis| {
        let all = points.iter().map(|point| point[axis]).filter(|x| x.is_finite());
        let [low, high] = all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
        high - low
    });
    match [0, 1, 2].into_iter().min_by(|a, b| extent[*a].total_cmp(&extent[*b]).then(b.cmp(a))) {
        Some(0) => [1, 2],
        Some(1) => [0, 2],
        _ => [0, 1],
    }
}

fn link(slot: u32) -> Link {
    (slot != NIL).then_some(slot as usize)
}

/// Vacant slots answer nil, except for the origin of a half-edge. As with any `View`, only existing slots may be queried.
impl View for HalfEdgeMesh<'_> {
    fn parts(&self) -> Parts {
        Parts::NONE.with(Part::Prev).with(Part::Leaving).with(Part::Faces)
    }

    fn vertex_slots(&self) -> usize {
        self.leaving.len()
    }

    fn half_edge_slots(&self) -> usize {
        self.face_of.len()
    }

    fn face_slots(&self) -> usize {
        self.left_out.len()
    }

    fn is_half_edge(&self, half_edge: usize) -> bool {
        self.face_of.get(half_edge).is_some_and(|face| *face != NIL)
    }

    fn is_face(&self, face: usize) -> bool {
        self.left_out.get(face).is_some_and(|left_out| !left_out)
    }

    fn origin(&self, half_edge: usize) -> Link {
        Some(self.mesh.corners()[half_edge] as usize)
    }

    fn twin(&self, half_edge: usize) -> Link {
        link(self.twins[half_edge])
    }

    fn next(&self, half_edge: usize) -> Link {
        self.is_half_edge(half_edge).then(|| self.next_of(half_edge as u32) as usize)
    }

    fn prev(&self, half_edge: usize) -> Link {
        self.is_half_edge(half_edge).then(|| self.prev_of(half_edge as u32) as usize)
    }

    fn face(&self, half_edge: usize) -> Link {
        link(self.face_of[half_edge])
    }

    fn leaving(&self, vertex: usize) -> Link {
        link(self.leaving[vertex])
    }

    fn outer_half_edge(&self, face: usize) -> Link {
        (!self.left_out[face]).then(|| self.mesh.offsets()[face] as usize)
    }
}
