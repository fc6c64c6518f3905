//! The counts of a mesh.

use super::{Findings, HalfEdgeMesh, Kind};
use petgraph::unionfind::UnionFind;
use twinedge::validate::Report;

/// The counts of a mesh. Edges and all counts derived from them ignore the faces that are left out, and unused vertices.
///
/// If all of them are known, `euler_characteristic = 2 · components − 2 · genus − borders`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct MeshCounts {
    /// V: the points of the file.
    pub vertices: usize,
    /// Vertices that no face uses, except perhaps one that is left out.
    pub unused_vertices: usize,
    /// E: pairs of consecutive vertices in a face.
    pub edges: usize,
    /// Edges with one face only.
    pub border_edges: usize,
    /// F: the faces of the file.
    pub faces: usize,
    /// Faces that are degenerate or repeat others.
    pub left_out_faces: usize,
    /// Triangles among the other faces.
    pub triangles: usize,
    /// Connected components. Two faces with a common vertex are connected.
    pub components: usize,
    /// Border loops: 0 if every edge has two faces or more. Unknown if some edge has one face and either edges could not be
    /// joined or a vertex on a border has several fans.
    pub borders: Option<usize>,
    /// V − E + F, without unused vertices and faces that are left out.
    pub euler_characteristic: isize,
    /// The sum of the genera of the components, that is their handles. Unknown if the faces could not be joined to surfaces.
    pub genus: Option<usize>,
    /// True if the faces could be turned to a consistent orientation. A Möbius strip is not orientable.
    pub orientable: bool,
}

impl MeshCounts {
    /// Counts, in linear time (up to the inverse of Ackermann's function).
    pub(super) fn new(half_edges: &HalfEdgeMesh<'_>, findings: &Findings, report: &Report) -> Self {
        let mesh = half_edges.mesh();
        let (vertices, faces) = (mesh.points().len(), mesh.face_count());
        let unused_vertices = findings.count(Kind::UnusedVertex);
        let kept = || mesh.faces().enumerate().filter(|(f, _)| !half_edges.is_left_out(*f)).map(|(_, face)| face);
        let (mut kept_faces, mut triangles) = (0, 0);
        let mut connected = UnionFind::new(vertices);
        let mut components = vertices - unused_vertices;
        for face in kept() {
            kept_faces += 1;
            triangles += usize::from(face.len() == 3);
            for pair in face.windows(2) {
                components -= usize::from(connected.union(pair[0], pair[1]));
            }
        }
        let border_edges = half_edges.border_edge_count();
        Self {
            vertices,
            unused_vertices,
            edges: half_edges.edge_count(),
            border_edges,
            faces,
            left_out_faces: faces - kept_faces,
            triangles,
            components,
            // Wherever faces are not joined along an edge, the rotations around its ends are split, and the validator, which
            // reports this (V2), counts neither borders nor handles.
            borders: if border_edges == 0 { Some(0) } else { report.counts().borders },
            euler_characteristic: (vertices - unused_vertices + kept_faces).cast_signed()
                - half_edges.edge_count().cast_signed(),
            genus: report.counts().genus,
            orientable: half_edges.is_orientable(),
        }
    }
}
