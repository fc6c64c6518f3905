//! `tri-mesh` 0.6.1: half-edges store their target, and border half-edges have no `next`.

use super::rotation::next_on_border;
use super::shapes::SHAPES;
use crate::peer::{self, Applied};
use crate::program::Operator;
use std::collections::HashSet;
use tri_mesh::{FaceID, HalfEdgeID, Mesh, VertexID, vec3};
use twinedge::validate::{Collect, Expectation, Part, Parts, Report, View, validate};
use twinedge::view_answers;

/// A mesh as seen by the validator: the origin of a half-edge is the target of its twin, and the `next` of a half-edge without
/// face is found by turning around its target.
pub struct MeshView<'a> {
    mesh: &'a Mesh,
    vertices: Vec<Option<VertexID>>,
    half_edges: Vec<Option<HalfEdgeID>>,
    faces: Vec<Option<FaceID>>,
}

impl<'a> MeshView<'a> {
    /// Lists the live records.
    #[must_use]
    pub fn new(mesh: &'a Mesh) -> Self {
        Self {
            mesh,
            vertices: slots(mesh.vertex_iter(), |id| **id),
            half_edges: slots(mesh.halfedge_iter(), |id| **id),
            faces: slots(mesh.face_iter(), |id| **id),
        }
    }

    /// Returns the report of the validator.
    #[must_use]
    pub fn report(&self) -> Report {
        validate(self, &Expectation::surface().open(), Collect::All)
    }

    fn twin_of(&self, h: HalfEdgeID) -> Option<HalfEdgeID> {
        self.mesh.walker_from_halfedge(h).twin_id().filter(|twin| self.is_half_edge(**twin as usize))
    }
}

/// The ids, by number.
fn slots<I: Copy>(ids: impl Iterator<Item = I>, number: impl Fn(&I) -> u32) -> Vec<Option<I>> {
    let mut slots = Vec::new();
    for id in ids {
        let at = number(&id) as usize;
        slots.resize(slots.len().max(at + 1), None);
        slots[at] = Some(id);
    }
    slots
}

impl View for MeshView<'_> {
    view_answers! { |view|
        parts => Parts::NONE.with(Part::Faces).with(Part::Leaving),
        vertex_slots => view.vertices.len(),
        half_edge_slots => view.half_edges.len(),
        face_slots => view.faces.len(),
        is_vertex(v) => view.vertices.get(v).is_some_and(Option::is_some),
        is_half_edge(h) => view.half_edges.get(h).is_some_and(Option::is_some),
        is_face(f) => view.faces.get(f).is_some_and(Option::is_some),
        origin(h) => {
            let twin = view.twin_of(view.half_edges[h]?)?;
            Some(*view.mesh.walker_from_halfedge(twin).vertex_id()? as usize)
        },
        twin(h) => Some(*view.mesh.walker_from_halfedge(view.half_edges[h]?).twin_id()? as usize),
        next(h) => {
            let id = view.half_edges[h]?;
            let walker = view.mesh.walker_from_halfedge(id);
            let next = walker.next_id().or_else(|| {
                let previous = |h| view.mesh.walker_from_halfedge(h).previous_id();
                let is_border = |h| view.mesh.walker_from_halfedge(h).face_id().is_none();
                walker.face_id().is_none().then_some(())?;
                next_on_border(id, view.half_edges.len(), |h| view.twin_of(h), previous, is_border)
            });
            Some(*next? as usize)
        },
        face(h) => Some(*view.mesh.walker_from_halfedge(view.half_edges[h]?).face_id()? as usize),
        leaving(v) => Some(*view.mesh.walker_from_vertex(view.vertices[v]?).halfedge_id()? as usize),
        outer_half_edge(f) => Some(*view.mesh.walker_from_face(view.faces[f]?).halfedge_id()? as usize),
    }
}

/// Random programs on the mesh.
pub struct Peer {
    mesh: Mesh,
    vertices: u32,
}

impl Peer {
    fn vertex(&mut self) -> VertexID {
        // Distinct, and no three collinear.
        let t = f64::from(self.vertices);
        self.vertices += 1;
        self.mesh.add_vertex(vec3(t, t * t, t * t * t))
    }

    fn half_edge(&self, i: u32) -> Option<HalfEdgeID> {
        let half_edges = self.mesh.halfedge_iter().collect::<Vec<_>>();
        Some(half_edges[(i as usize).checked_rem(half_edges.len())?])
    }

    fn face(&self, i: u32) -> Option<FaceID> {
        let faces = self.mesh.face_iter().collect::<Vec<_>>();
        Some(faces[(i as usize).checked_rem(faces.len())?])
    }

    /// Returns true if adding the face keeps an oriented manifold with at most one fan at each vertex: its sides are new or on
    /// a border, and at each used corner at least one of its sides is on a border.
    fn may_add(&self, face: [VertexID; 3]) -> bool {
        let border = self.mesh.halfedge_iter().filter(|h| self.mesh.walker_from_halfedge(*h).face_id().is_none());
        let ends = |h: HalfEdgeID| {
            let walker = self.mesh.walker_from_halfedge(h);
            (walker.into_twin().vertex_id(), self.mesh.walker_from_halfedge(h).vertex_id())
        };
        let border = border.map(ends).collect::<HashSet<_>>();
        let taken = self.mesh.halfedge_iter().map(ends).filter(|h| !border.contains(h)).collect::<HashSet<_>>();
        let side = |i: usize| (Some(face[i % 3]), Some(face[(i + 1) % 3]));
        let old = |i: usize| border.contains(&side(i));
        let is_new = |i: usize| {
            let (from, to) = side(i);
            !taken.contains(&(from, to)) && !taken.contains(&(to, from)) && !border.contains(&(to, from))
        };
        let used = |v: VertexID| self.mesh.walker_from_vertex(v).halfedge_id().is_some();
        (0..3).all(|i| old(i) || is_new(i))
            && (0..3).all(|i| !used(face[i]) || old(i) != old(i + 2) || old(i) && old(i + 2))
    }

    /// Returns true if the ends share only the third corners of the faces at the edge, an edge between two border vertices is
    /// on the border, and the mesh is not a tetrahedron.
    fn may_collapse(&self, h: HalfEdgeID) -> bool {
        let (a, b) = self.mesh.edge_vertices(h);
        let around = |v| {
            let target = |h| self.mesh.walker_from_halfedge(h).vertex_id();
            self.mesh.vertex_halfedge_iter(v).filter_map(target).collect::<HashSet<_>>()
        };
        let walker = self.mesh.walker_from_halfedge(h);
        let sides = [walker.clone(), walker.into_twin()];
        let faces = sides.iter().filter(|side| side.face_id().is_some()).count();
        let apexes = sides.into_iter().filter_map(|side| side.into_next().vertex_id()).collect::<HashSet<_>>();
        let both_on_border = self.mesh.is_vertex_on_boundary(a) && self.mesh.is_vertex_on_boundary(b);
        let apex_remains = |v: &VertexID| around(*v).len() > 2 + usize::from(!self.mesh.is_vertex_on_boundary(*v));
        apexes.len() == faces
            && around(a).intersection(&around(b)).count() == faces
            && (faces == 1 || !both_on_border)
            && apexes.iter().all(apex_remains)
    }

    fn try_apply(&mut self, operator: &str, arguments: &[u32]) -> Option<()> {
        let [a, b, c] = [0, 1, 2].map(|i| arguments.get(i).copied().unwrap_or(0));
        match operator {
            "append_shape" => {
                let (n, faces) = SHAPES[a as usize % SHAPES.len()];
                let from = f64::from(self.vertices);
                self.vertices += n;
                let positions = (0..n).map(|i| from + f64::from(i)).map(|t| vec3(t, t * t, t * t * t)).collect();
                self.mesh.append(&Mesh::new(&three_d_asset::TriMesh {
                    positions: three_d_asset::Positions::F64(positions),
                    indices: three_d_asset::Indices::U32(faces.concat()),
                    ..Default::default()
                }));
            }
            "add_vertex" => {
                self.vertex();
            }
            "add_face" => {
                let vertices = self.mesh.vertex_iter().collect::<Vec<_>>();
                let face = [a, b, c].map(|i| (i as usize).checked_rem(vertices.len()).map(|i| vertices[i]));
                let [Some(x), Some(y), Some(z)] = face else { return None };
                (x != y && y != z && z != x && self.may_add([x, y, z])).then_some(())?;
                self.mesh.add_face(x, y, z);
            }
            "flip_edge" => return self.mesh.flip_edge(self.half_edge(a)?).ok(),
            "split_edge" => {
                let h = self.half_edge(a)?;
                let t = f64::from(self.vertices);
                self.vertices += 1;
                self.mesh.split_edge(h, vec3(t, t * t, t * t * t));
            }
            "split_face" => {
                let face = self.face(a)?;
                let t = f64::from(self.vertices);
                self.vertices += 1;
                self.mesh.split_face(face, vec3(t, t * t, t * t * t));
            }
            "collapse_edge" => {
                let h = self.half_edge(a)?;
                self.may_collapse(h).then_some(())?;
                self.mesh.collapse_edge(h);
            }
            "collapse_any_edge" => {
                let h = self.half_edge(a)?;
                self.mesh.collapse_edge(h);
            }
            "remove_face" => {
                let face = self.face(a)?;
                self.mesh.remove_face(face);
            }
            "remove_lonely_primitives" => self.mesh.remove_lonely_primitives(),
            "flip_orientation" => self.mesh.flip_orientation(),
            "fix_orientation" => self.mesh.fix_orientation(),
            _ => unreachable!("{operator} is not an operator"),
        }
        Some(())
    }
}

impl peer::Peer for Peer {
    const OPERATORS: &'static [Operator] = &[
        Operator::with_values("append_shape", 1, 5),
        Operator::on_records("add_vertex", 0, 2),
        Operator::on_records("add_face", 3, 6),
        Operator::on_records("flip_edge", 1, 5),
        Operator::on_records("split_edge", 1, 4),
        Operator::on_records("split_face", 1, 4),
        Operator::on_records("collapse_edge", 1, 4),
        Operator::on_records("collapse_any_edge", 1, 1),
        Operator::on_records("remove_face", 1, 2),
        Operator::on_records("remove_lonely_primitives", 0, 1),
        Operator::on_records("flip_orientation", 0, 1),
        Operator::on_records("fix_orientation", 0, 1),
    ];

    fn new() -> Self {
        Self {
            mesh: Mesh::new(&three_d_asset::TriMesh {
                positions: three_d_asset::Positions::F64(Vec::new()),
                ..Default::default()
            }),
            vertices: 0,
        }
    }

    fn apply(&mut self, operator: &str, arguments: &[u32]) -> Applied {
        match self.try_apply(operator, arguments) {
            Some(()) => Applied::Done,
            None if operator == "flip_edge" => Applied::Refused,
            None => Applied::Skipped,
        }
    }

    fn report(&self) -> Report {
        MeshView::new(&self.mesh).report()
    }

    fn own_check(&self) -> Option<bool> {
        Some(self.mesh.is_valid().is_ok())
    }
}
