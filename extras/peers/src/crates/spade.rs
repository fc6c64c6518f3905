//! `spade` 2.15.1: constrained Delaunay triangulations, with coordinates and an unbounded face.

use crate::peer::{self, Applied};
use crate::program::Operator;
use spade::handles::{
    DirectedEdgeHandle, FixedDirectedEdgeHandle, FixedFaceHandle, FixedVertexHandle, PossiblyOuterTag,
};
use spade::{CdtEdge, ConstrainedDelaunayTriangulation, Point2, Triangulation};
use twinedge::validate::{Collect, Expectation, Link, Part, Parts, Report, Start, View, validate};
use twinedge::view_answers;
use twinedge_geometry::Point;
use twinedge_map::{Embedding, validate_embedding};

/// A triangulation of points without data.
pub type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// A triangulation as seen by the validator.
pub struct CdtView<'a> {
    cdt: &'a Cdt,
    edges: Vec<FixedDirectedEdgeHandle>,
    faces: Vec<FixedFaceHandle<PossiblyOuterTag>>,
}

impl<'a> CdtView<'a> {
    /// Lists the handles; only handles of vertices can be made from an index.
    #[must_use]
    pub fn new(cdt: &'a Cdt) -> Self {
        Self { cdt, edges: cdt.fixed_directed_edges().collect(), faces: cdt.fixed_all_faces().collect() }
    }

    fn edge(&self, h: usize) -> DirectedEdgeHandle<'_, Point2<f64>, (), CdtEdge<()>, ()> {
        self.cdt.directed_edge(self.edges[h])
    }

    fn face_edge(&self, f: usize) -> Link {
        let face = self.cdt.face(self.faces[f]);
        let edge = match face.as_inner() {
            Some(inner) => inner.adjacent_edge(),
            None => face.adjacent_edge()?,
        };
        Some(edge.fix().index())
    }

    /// Returns the report of the validator: first on the links, then on the coordinates.
    #[must_use]
    pub fn report(&self) -> Report {
        let expectation = Expectation::plane();
        let report = validate(self, &expectation, Collect::All);
        if report.is_valid() { validate_embedding(self, &expectation, Collect::All) } else { report }
    }
}

impl View for CdtView<'_> {
    view_answers! { |view|
        parts => Parts::ALL.without(Part::BoundaryComponents),
        vertex_slots => view.cdt.num_vertices(),
        half_edge_slots => view.cdt.num_directed_edges(),
        face_slots => view.cdt.num_all_faces(),
        origin(h) => Some(view.edge(h).from().fix().index()),
        twin(h) => Some(view.edge(h).rev().fix().index()),
        next(h) => Some(view.edge(h).next().fix().index()),
        prev(h) => Some(view.edge(h).prev().fix().index()),
        face(h) => Some(view.edge(h).face().fix().index()),
        leaving(v) => {
            let vertex = view.cdt.vertex(FixedVertexHandle::from_index(v));
            Some(vertex.out_edge()?.fix().index())
        },
        outer_half_edge(f) => if f == 0 { None } else { view.face_edge(f) },
        inner_count(f) => usize::from(f == 0 && view.cdt.num_vertices() > 0),
        // The unbounded face has one inner boundary component: the convex hull, or the only vertex.
        inner_start(f, _i) => Some(view.face_edge(f).map_or(Start::Vertex(0), Start::HalfEdge)),
    }
}

impl Embedding for CdtView<'_> {
    fn point(&self, v: usize) -> Point {
        let at = self.cdt.vertex(FixedVertexHandle::from_index(v)).position();
        Point::new(at.x, at.y)
    }
}

/// Random programs on the triangulation.
pub struct Peer(Cdt);

impl Peer {
    fn vertex(&self, i: u32) -> Option<FixedVertexHandle> {
        Some(FixedVertexHandle::from_index((i as usize).checked_rem(self.0.num_vertices())?))
    }

    fn try_apply(&mut self, operator: &str, arguments: &[u32]) -> Option<()> {
        let [a, b] = [0, 1].map(|i| arguments.get(i).copied().unwrap_or(0));
        match operator {
            "insert" => {
                self.0.insert(Point2::new(f64::from(a % 16), f64::from(b % 16))).ok()?;
            }
            // Coordinates whose differences are not exact.
            "insert_inexact" => {
                self.0.insert(Point2::new(f64::from(a).sin(), f64::from(b).cos())).ok()?;
            }
            "remove" => {
                self.0.remove(self.vertex(a)?);
            }
            // "Panics if the new constraint edge intersects an existing constraint edge": `can_add_constraint` tells.
            "add_constraint" => {
                let (from, to) = (self.vertex(a)?, self.vertex(b)?);
                self.0.can_add_constraint(from, to).then_some(())?;
                self.0.add_constraint(from, to);
            }
            "try_add_constraint" => {
                self.0.try_add_constraint(self.vertex(a)?, self.vertex(b)?);
            }
            "add_constraint_and_split" => {
                self.0.add_constraint_and_split(self.vertex(a)?, self.vertex(b)?, |position| position);
            }
            "remove_constraint_edge" => {
                let edges = self.0.fixed_undirected_edges().collect::<Vec<_>>();
                self.0.remove_constraint_edge(edges[(a as usize).checked_rem(edges.len())?]);
            }
            _ => unreachable!("{operator} is not an operator"),
        }
        Some(())
    }
}

impl peer::Peer for Peer {
    const OPERATORS: &'static [Operator] = &[
        Operator::with_values("insert", 2, 5),
        Operator::with_values("insert_inexact", 2, 5),
        Operator::on_records("remove", 1, 3),
        Operator::on_records("add_constraint", 2, 2),
        Operator::on_records("try_add_constraint", 2, 2),
        Operator::on_records("add_constraint_and_split", 2, 8),
        Operator::on_records("remove_constraint_edge", 1, 1),
    ];

    fn new() -> Self {
        Self(Cdt::new())
    }

    fn apply(&mut self, operator: &str, arguments: &[u32]) -> Applied {
        if self.try_apply(operator, arguments).is_some() { Applied::Done } else { Applied::Skipped }
    }

    fn report(&self) -> Report {
        CdtView::new(&self.0).report()
    }
}
