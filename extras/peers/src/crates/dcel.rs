//! `dcel` 0.8.14: the textbook's records in stable vectors.
//!
//! Faces store one half-edge and no lists of holes: the adapter treats every other cycle labelled with a face as one of
//! its inner boundary components.

use crate::peer::{self, Applied};
use crate::program::Operator;
use dcel::{EdgeId, FaceId, HalfEdgeId, StableDcel, VertexId};
use twinedge::validate::{Collect, Expectation, Part, Parts, Report, Start, View, validate};
use twinedge::view_answers;

/// A structure with numbered vertices.
pub type Dcel = StableDcel<u32>;

/// A structure as seen by the validator.
pub struct DcelView<'a> {
    dcel: &'a Dcel,
    inner: Vec<Vec<usize>>,
}

impl<'a> DcelView<'a> {
    /// Walks each cycle once.
    #[must_use]
    pub fn new(dcel: &'a Dcel) -> Self {
        let n = dcel.half_edges().next_push_index();
        let live = |h: &usize| dcel.half_edges().has_element_at(*h);
        let mut inner = vec![Vec::new(); dcel.faces().next_push_index()];
        let mut seen = vec![false; n];
        let cycle = |h: usize, seen: &mut Vec<bool>| {
            let mut at = Some(h);
            while let Some(h) = at.filter(|h| live(h) && !seen[*h]) {
                seen[h] = true;
                at = Some(dcel.next(HalfEdgeId::new(h)).id());
            }
        };
        for f in dcel.faces().indices().filter(|f| *f != 0) {
            if let Some(h) = dcel.face_representative(FaceId::new(f)) {
                cycle(h.id(), &mut seen);
            }
        }
        for h in (0..n).filter(live) {
            if !seen[h] {
                cycle(h, &mut seen);
                if let Some(list) = inner.get_mut(dcel.incident_face(HalfEdgeId::new(h)).id()) {
                    list.push(h);
                }
            }
        }
        Self { dcel, inner }
    }

    /// Returns the report of the validator.
    #[must_use]
    pub fn report(&self) -> Report {
        validate(self, &Expectation::plane(), Collect::All)
    }
}

impl View for DcelView<'_> {
    view_answers! { |view|
        parts => Parts::ALL.without(Part::BoundaryComponents),
        vertex_slots => view.dcel.vertices().next_push_index(),
        half_edge_slots => view.dcel.half_edges().next_push_index(),
        face_slots => view.dcel.faces().next_push_index(),
        is_vertex(v) => view.dcel.vertices().has_element_at(v),
        is_half_edge(h) => view.dcel.half_edges().has_element_at(h),
        is_face(f) => view.dcel.faces().has_element_at(f),
        origin(h) => Some(view.dcel.source(HalfEdgeId::new(h)).id()),
        twin(h) => Some(view.dcel.twin(HalfEdgeId::new(h)).id()),
        next(h) => Some(view.dcel.next(HalfEdgeId::new(h)).id()),
        prev(h) => Some(view.dcel.prev(HalfEdgeId::new(h)).id()),
        face(h) => Some(view.dcel.incident_face(HalfEdgeId::new(h)).id()),
        leaving(v) => Some(view.dcel.vertex_representative(VertexId::new(v)).id()),
        outer_half_edge(f) => {
            if f == view.dcel.unbounded_face().id() {
                None
            } else {
                Some(view.dcel.face_representative(FaceId::new(f))?.id())
            }
        },
        inner_count(f) => view.inner[f].len(),
        inner_start(f, position) => view.inner[f].get(position).copied().map(Start::HalfEdge),
    }
}

/// Random programs on the structure.
pub struct Peer {
    dcel: Dcel,
    vertices: u32,
}

impl Peer {
    fn fresh(&mut self, n: u32) -> Vec<u32> {
        self.vertices += n;
        (self.vertices - n..self.vertices).collect()
    }

    fn face(&self, i: u32) -> FaceId {
        let faces = self.dcel.faces().indices().collect::<Vec<_>>();
        FaceId::new(faces[i as usize % faces.len()])
    }

    fn half_edge(&self, i: u32) -> Option<HalfEdgeId> {
        let half_edges = self.dcel.half_edges().indices().collect::<Vec<_>>();
        Some(HalfEdgeId::new(half_edges[(i as usize).checked_rem(half_edges.len())?]))
    }

    fn edge(&self, i: u32) -> Option<EdgeId> {
        Some(self.dcel.full_edge(self.half_edge(i)?))
    }

    fn vertex(&self, i: u32) -> Option<VertexId> {
        let vertices = self.dcel.vertices().indices().collect::<Vec<_>>();
        Some(VertexId::new(vertices[(i as usize).checked_rem(vertices.len())?]))
    }

    /// The cycle of the half-edge. The structure keeps the rules, or the program would have ended before.
    fn cycle(&self, h: HalfEdgeId) -> Vec<HalfEdgeId> {
        let mut cycle = vec![h];
        let mut next = self.dcel.next(h);
        while next != h {
            cycle.push(next);
            next = self.dcel.next(next);
        }
        cycle
    }

    /// Two half-edges of one cycle from different vertices.
    fn corners(&self, a: u32, b: u32) -> Option<(HalfEdgeId, HalfEdgeId)> {
        let from = self.half_edge(a)?;
        let cycle = self.cycle(from);
        let to = cycle[b as usize % cycle.len()];
        (self.dcel.source(from) != self.dcel.source(to)).then_some((from, to))
    }

    /// Returns true if an edge between the two would be parallel to one of the same cycle.
    fn beside(&self, from: HalfEdgeId, to: HalfEdgeId) -> bool {
        self.dcel.next(from) == to || self.dcel.next(to) == from
    }

    /// Returns the number of half-edges that leave the vertex.
    fn degree(&self, v: VertexId) -> usize {
        self.dcel.half_edges().indices().filter(|h| self.dcel.source(HalfEdgeId::new(*h)) == v).count()
    }

    /// Returns true if no half-edge that leaves the vertex bounds the unbounded face.
    fn is_inner(&self, v: VertexId) -> bool {
        let mut spokes = self.dcel.half_edges().indices().map(HalfEdgeId::new).filter(|h| self.dcel.source(*h) == v);
        spokes.all(|h| self.dcel.incident_face(h) != self.dcel.unbounded_face())
    }

    fn try_apply(&mut self, operator: &str, arguments: &[u32]) -> Option<()> {
        let [a, b] = [0, 1].map(|i| arguments.get(i).copied().unwrap_or(0));
        match operator {
            "insert_polygon" => {
                let polygon = self.fresh(3 + a % 3);
                self.dcel.insert_polygon(polygon);
            }
            "insert_polygon_in_face" => {
                let (face, polygon) = (self.face(a), self.fresh(3 + b % 3));
                self.dcel.insert_polygon_in_face(face, polygon);
            }
            // Adjacent squares with the same orientation.
            "insert_mesh" => {
                let (columns, rows) = (1 + a % 3, 1 + b % 3);
                let v = self.fresh((columns + 1) * (rows + 1));
                let at = |x: u32, y: u32| v[(y * (columns + 1) + x) as usize];
                let square = |x, y| [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
                self.dcel
                    .insert_mesh((0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))).map(|(x, y)| square(x, y)));
            }
            // "Insert an edge between two vertices, splitting a face in two": so both are on one cycle of that face.
            "insert_edge" | "insert_edge_beside_edge" | "insert_edge_chain" | "insert_edge_chain_beside_edge" => {
                let (from, to) = self.corners(a, b)?;
                (self.beside(from, to) == operator.ends_with("beside_edge")).then_some(())?;
                let (from, to) = (self.dcel.source(from), self.dcel.source(to));
                let face = self.dcel.find_vertices_common_face(from, to)?;
                let spoke = |v| self.dcel.vertex_half_spokes(v).find(|h| self.dcel.incident_face(*h) == face);
                self.cycle(spoke(from)?).contains(&spoke(to)?).then_some(())?;
                if operator.starts_with("insert_edge_chain") {
                    let chain = self.fresh(1 + b % 2);
                    self.dcel.insert_edge_chain(from, to, chain);
                } else {
                    self.dcel.insert_edge(from, to);
                }
            }
            "split_face_by_edge" => {
                let (from, to) = self.corners(a, b)?;
                (!self.beside(from, to)).then_some(())?;
                let face = self.dcel.incident_face(from);
                self.dcel.split_face_by_edge(self.dcel.source(from), self.dcel.source(to), face);
            }
            "split_edge_by_vertex" => {
                let (edge, v) = (self.edge(a)?, self.fresh(1)[0]);
                self.dcel.split_edge_by_vertex(edge, v);
            }
            "triangulate_face_around_point" => {
                let (face, v) = (self.face(a), self.fresh(1)[0]);
                (face != self.dcel.unbounded_face()).then_some(())?;
                self.dcel.triangulate_face_around_point(face, v);
            }
            // "By connecting an existing vertex to all of the face's boundary vertices".
            "fan_triangulate" => {
                let h = self.half_edge(a)?;
                let face = self.dcel.incident_face(h);
                (face != self.dcel.unbounded_face()).then_some(())?;
                self.dcel.fan_triangulate(face, self.dcel.source(h));
            }
            // "Remove an edge, merging the faces separated by it."
            "remove_edge" | "remove_inner_edge" => {
                let edge = self.edge(a)?;
                let faces = [edge.lesser(), edge.greater()].map(|h| self.dcel.incident_face(h));
                (faces[0] != faces[1]).then_some(())?;
                (operator == "remove_edge" || !faces.contains(&self.dcel.unbounded_face())).then_some(())?;
                self.dcel.remove_edge(edge);
            }
            "remove_face" | "remove_inner_face" => {
                let h = self.half_edge(a)?;
                let face = self.dcel.incident_face(h);
                (face != self.dcel.unbounded_face()).then_some(())?;
                let cycle = self.cycle(h);
                let is_inner = cycle.iter().all(|h| self.is_inner(self.dcel.source(*h)));
                (operator == "remove_face" || is_inner).then_some(())?;
                self.dcel.remove_face(face);
            }
            "smoothen_vertex" => {
                let v = self.vertex(a)?;
                (self.degree(v) == 2).then_some(())?;
                self.dcel.smoothen_vertex(v);
            }
            // "Remove a degree-2 vertex together with its incident edges".
            "merge_faces_around_vertex" => {
                let v = self.vertex(a)?;
                (self.degree(v) == 2 && !self.is_inner(v)).then_some(())?;
                self.dcel.merge_faces_around_vertex(v);
            }
            // The crate's own tests call it with a vertex of degree 3.
            "merge_faces_around_inner_vertex" => {
                let v = self.vertex(a)?;
                self.is_inner(v).then_some(())?;
                self.dcel.merge_faces_around_vertex(v);
            }
            // "The set of input faces must be contiguous".
            "merge_faces" | "merge_inner_faces" => {
                let h = self.half_edge(a)?;
                let faces = [self.dcel.incident_face(h), self.dcel.opposite_face(h)];
                (faces[0] != faces[1]).then_some(())?;
                (operator == "merge_faces" || !faces.contains(&self.dcel.unbounded_face())).then_some(())?;
                self.dcel.merge_faces(faces);
            }
            _ => unreachable!("{operator} is not an operator"),
        }
        Some(())
    }
}

impl peer::Peer for Peer {
    const OPERATORS: &'static [Operator] = &[
        Operator::with_values("insert_polygon", 1, 4),
        Operator::on_records("insert_polygon_in_face", 2, 2),
        Operator::with_values("insert_mesh", 2, 4),
        Operator::on_records("insert_edge", 2, 6),
        Operator::on_records("insert_edge_beside_edge", 2, 1),
        Operator::on_records("insert_edge_chain_beside_edge", 2, 1),
        Operator::on_records("insert_edge_chain", 2, 3),
        Operator::on_records("split_face_by_edge", 2, 4),
        Operator::on_records("split_edge_by_vertex", 1, 4),
        Operator::on_records("triangulate_face_around_point", 1, 2),
        Operator::on_records("fan_triangulate", 1, 1),
        Operator::on_records("remove_edge", 1, 2),
        Operator::on_records("remove_inner_edge", 1, 2),
        Operator::on_records("remove_face", 1, 1),
        Operator::on_records("remove_inner_face", 1, 1),
        Operator::on_records("smoothen_vertex", 1, 1),
        Operator::on_records("merge_faces_around_vertex", 1, 1),
        Operator::on_records("merge_faces_around_inner_vertex", 1, 2),
        Operator::on_records("merge_faces", 1, 1),
        Operator::on_records("merge_inner_faces", 1, 2),
    ];

    fn new() -> Self {
        Self { dcel: Dcel::new(), vertices: 0 }
    }

    fn apply(&mut self, operator: &str, arguments: &[u32]) -> Applied {
        if self.try_apply(operator, arguments).is_some() { Applied::Done } else { Applied::Skipped }
    }

    fn report(&self) -> Report {
        DcelView::new(&self.dcel).report()
    }
}
