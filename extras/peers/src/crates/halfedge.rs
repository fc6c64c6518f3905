//! `halfedge` 0.3.0: half-edges store their target, links are keys that may be nil, and only some operators maintain `next` and
//! `prev` on borders.

use super::rotation::next_on_border;
use super::shapes::SHAPES;
use crate::peer::{self, Applied};
use crate::program::Operator;
use halfedge::{FaceId, HalfEdgeId, MeshStorage, Vertex, VertexId};
use std::collections::{HashMap, HashSet};
use std::hash::Hash;
use twinedge::validate::{Collect, Expectation, FaceRow, HalfEdgeRow, Part, Parts, Report, Table, VertexRow, validate};

/// The mesh as tables, with records in the order of iteration. The origin of a half-edge is the target of its twin, or of its
/// `prev` if it has no twin; a border without `next` is closed by turning around its vertices, and missing `prev` links are
/// derived from these `next` links.
#[must_use]
pub fn table(mesh: &MeshStorage) -> Table {
    let vertices = numbers(mesh.vertex_ids());
    let half_edges = numbers(mesh.halfedge_ids());
    let faces = numbers(mesh.face_ids());
    let number = |h: HalfEdgeId| half_edges.get(&h).copied().unwrap_or(usize::MAX);
    let get = |h: HalfEdgeId| mesh.get_halfedge(h);
    let next = |h: HalfEdgeId| {
        let record = get(h)?;
        record.next.or_else(|| {
            record.face.is_none().then_some(())?;
            let is_border = |h| get(h).is_some_and(|h| h.face.is_none());
            next_on_border(h, half_edges.len(), |h| get(h)?.twin, |h| get(h)?.prev, is_border)
        })
    };
    let before = mesh.halfedge_ids().filter_map(|h| Some((next(h)?, h))).collect::<HashMap<_, _>>();
    let half_edge = |h: HalfEdgeId| {
        let record = get(h)?;
        let vertex = |v: VertexId| vertices.get(&v).copied().unwrap_or(usize::MAX);
        let prev = record.prev.or_else(|| before.get(&h).copied().filter(|_| record.face.is_none()));
        Some(HalfEdgeRow {
            origin: record.twin.or(record.prev).and_then(get).map(|before| vertex(before.vertex)),
            twin: record.twin.map(number),
            next: next(h).map(number),
            prev: prev.map(number),
            face: record.face.map(|f| faces.get(&f).copied().unwrap_or(usize::MAX)),
            boundary: None,
        })
    };
    let leaving = |v: VertexId| Some(VertexRow { leaving: mesh.get_vertex(v)?.halfedge.map(number), isolated: None });
    let face =
        |f: FaceId| Some(FaceRow { outer_half_edge: mesh.get_face(f)?.halfedge.map(number), ..Default::default() });
    Table {
        parts: Parts::ALL.without(Part::BoundaryComponents),
        vertices: mesh.vertex_ids().map(leaving).collect(),
        half_edges: mesh.halfedge_ids().map(half_edge).collect(),
        faces: mesh.face_ids().map(face).collect(),
        ..Default::default()
    }
}

fn numbers<I: Eq + Hash>(ids: impl Iterator<Item = I>) -> HashMap<I, usize> {
    ids.zip(0..).collect()
}

/// Returns the report of the validator on the mesh.
#[must_use]
pub fn report(mesh: &MeshStorage) -> Report {
    validate(&table(mesh), &Expectation::surface().open(), Collect::All)
}

/// Random programs on the mesh.
pub struct Peer {
    mesh: MeshStorage,
    vertices: u32,
}

impl Peer {
    /// Distinct, and no three collinear.
    fn position(&mut self) -> [f64; 3] {
        let t = f64::from(self.vertices);
        self.vertices += 1;
        [t, t * t, t * t * t]
    }

    fn half_edge(&self, i: u32) -> Option<HalfEdgeId> {
        let half_edges = self.mesh.halfedge_ids().collect::<Vec<_>>();
        Some(half_edges[(i as usize).checked_rem(half_edges.len())?])
    }

    fn face(&self, i: u32) -> Option<FaceId> {
        let faces = self.mesh.face_ids().collect::<Vec<_>>();
        Some(faces[(i as usize).checked_rem(faces.len())?])
    }

    /// Returns true if adding the face keeps an oriented manifold with at most one fan at each vertex: its sides are new or on
    /// a border, and at each used corner at least one of its sides is on a border.
    fn may_add(&self, face: [VertexId; 3]) -> bool {
        let (mut border, mut taken) = (HashSet::new(), HashSet::new());
        for record in self.mesh.halfedges() {
            let twin = record.twin.and_then(|twin| self.mesh.get_halfedge(twin));
            if let Some(twin) = twin {
                let set = if record.face.is_none() { &mut border } else { &mut taken };
                set.insert((twin.vertex, record.vertex));
            }
        }
        let side = |i: usize| (face[i % 3], face[(i + 1) % 3]);
        let old = |i: usize| border.contains(&side(i));
        let is_new = |i: usize| {
            let (from, to) = side(i);
            let used = |side| taken.contains(&side) || border.contains(&side);
            !used((from, to)) && !used((to, from))
        };
        let used = |v: VertexId| self.mesh.get_vertex(v).is_some_and(|v| v.halfedge.is_some());
        (0..3).all(|i| old(i) || is_new(i)) && (0..3).all(|i| !used(face[i]) || old(i) || old(i + 2))
    }

    fn try_apply(&mut self, operator: &str, arguments: &[u32]) -> Option<Result<(), ()>> {
        let [a, b, c] = [0, 1, 2].map(|i| arguments.get(i).copied().unwrap_or(0));
        let mesh = &mut self.mesh;
        Some(match operator {
            // Replaces the current mesh by one from the builder.
            "build_shape" => {
                let (n, faces) = SHAPES[a as usize % SHAPES.len()];
                let positions = (0..n).map(|_| self.position()).collect::<Vec<_>>();
                self.mesh = halfedge::build_mesh_from_vertices_and_faces(&positions, faces).map_err(|_| ()).ok()?;
                Ok(())
            }
            "add_vertex" => {
                let position = self.position();
                self.mesh.add_vertex(Vertex::new(position));
                Ok(())
            }
            "add_triangle" => {
                let vertices = mesh.vertex_ids().collect::<Vec<_>>();
                let face = [a, b, c].map(|i| (i as usize).checked_rem(vertices.len()).map(|i| vertices[i]));
                let [Some(x), Some(y), Some(z)] = face else { return None };
                (x != y && y != z && z != x && self.may_add([x, y, z])).then_some(())?;
                halfedge::add_triangle(&mut self.mesh, x, y, z).map(|_| ()).map_err(|_| ())
            }
            "split_edge" => {
                let h = self.half_edge(a)?;
                halfedge::split_edge(&mut self.mesh, h).map(|_| ()).map_err(|_| ())
            }
            "flip_edge" => {
                let h = self.half_edge(a)?;
                halfedge::flip_edge(&mut self.mesh, h).map_err(|_| ())
            }
            "collapse_edge" => {
                let h = self.half_edge(a)?;
                halfedge::collapse_edge(&mut self.mesh, h).map(|_| ()).map_err(|_| ())
            }
            "split_face" => {
                let face = self.face(a)?;
                halfedge::split_face(&mut self.mesh, face).map(|_| ()).map_err(|_| ())
            }
            "extrude_face" => {
                let face = self.face(a)?;
                halfedge::extrude_face(&mut self.mesh, face, [0.5, 0.25, 1.0]).map(|_| ()).map_err(|_| ())
            }
            "remove_face" => {
                let face = self.face(a)?;
                halfedge::remove_face(&mut self.mesh, face).map_err(|_| ())
            }
            // The half-edge must have no face.
            "fill_hole" => {
                let border =
                    self.mesh.halfedge_ids().filter(|h| self.mesh.get_halfedge(*h).is_some_and(|h| h.face.is_none()));
                let border = border.collect::<Vec<_>>();
                let h = border[(a as usize).checked_rem(border.len())?];
                halfedge::fill_hole(&mut self.mesh, h).map(|_| ()).map_err(|_| ())
            }
            "remove_isolated_vertices" => {
                halfedge::remove_isolated_vertices(mesh);
                Ok(())
            }
            _ => unreachable!("{operator} is not an operator"),
        })
    }
}

impl peer::Peer for Peer {
    const OPERATORS: &'static [Operator] = &[
        Operator::with_values("build_shape", 1, 3),
        Operator::on_records("add_vertex", 0, 3),
        Operator::on_records("add_triangle", 3, 6),
        Operator::on_records("split_edge", 1, 4),
        Operator::on_records("flip_edge", 1, 5),
        Operator::on_records("collapse_edge", 1, 4),
        Operator::on_records("split_face", 1, 1),
        Operator::on_records("extrude_face", 1, 1),
        Operator::on_records("remove_face", 1, 2),
        Operator::on_records("fill_hole", 1, 2),
        Operator::on_records("remove_isolated_vertices", 0, 1),
    ];

    fn new() -> Self {
        Self { mesh: MeshStorage::new(), vertices: 0 }
    }

    fn apply(&mut self, operator: &str, arguments: &[u32]) -> Applied {
        match self.try_apply(operator, arguments) {
            Some(Ok(())) => Applied::Done,
            Some(Err(())) => Applied::Refused,
            None => Applied::Skipped,
        }
    }

    fn report(&self) -> Report {
        report(&self.mesh)
    }

    fn own_check(&self) -> Option<bool> {
        Some(halfedge::validate_topology(&self.mesh).is_empty())
    }
}
