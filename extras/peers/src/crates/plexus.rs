//! `plexus` 0.0.11: arcs are keyed by their two vertices, and views follow the links.

use super::shapes::SHAPES;
use crate::peer::{self, Applied};
use crate::program::Operator;
use plexus::graph::{ArcKey, FaceKey, GraphError, MeshGraph, Selector, VertexKey};
use plexus::prelude::*;
use plexus::primitive::Triangle;
use std::collections::HashMap;
use std::hash::Hash;
use twinedge::validate::{Collect, Expectation, FaceRow, HalfEdgeRow, Part, Parts, Report, Table, VertexRow, validate};

/// A mesh without positions.
pub type Graph = MeshGraph<Numbered>;

/// Numbered vertices.
#[derive(Clone, Copy, Debug)]
pub struct Numbered;

impl plexus::geometry::Geometry for Numbered {
    type Vertex = f64;
    type Arc = ();
    type Edge = ();
    type Face = ();
}

/// The graph as tables, with records in the order of iteration.
#[must_use]
pub fn table(graph: &Graph) -> Table {
    let vertices = numbers(graph.vertices().map(|vertex| vertex.key()));
    let arcs = numbers(graph.arcs().map(|arc| arc.key()));
    let faces = numbers(graph.faces().map(|face| face.key()));
    let arc_number = |key: ArcKey| Some(arcs.get(&key).copied().unwrap_or(usize::MAX));
    Table {
        parts: Parts::ALL.without(Part::BoundaryComponents),
        vertices: graph
            .vertices()
            .map(|vertex| Some(VertexRow { leaving: arc_number(vertex.outgoing_arc().key()), isolated: None }))
            .collect(),
        half_edges: graph
            .arcs()
            .map(|arc| {
                Some(HalfEdgeRow {
                    origin: vertices.get(&arc.source_vertex().key()).copied(),
                    twin: arc_number(arc.opposite_arc().key()),
                    next: arc_number(arc.next_arc().key()),
                    prev: arc_number(arc.previous_arc().key()),
                    face: arc.face().map(|face| faces.get(&face.key()).copied().unwrap_or(usize::MAX)),
                    boundary: None,
                })
            })
            .collect(),
        faces: graph
            .faces()
            .map(|face| Some(FaceRow { outer_half_edge: arc_number(face.arc().key()), ..Default::default() }))
            .collect(),
        ..Default::default()
    }
}

fn numbers<I: Eq + Hash>(ids: impl Iterator<Item = I>) -> HashMap<I, usize> {
    ids.zip(0..).collect()
}

/// Returns the report of the validator on the graph.
#[must_use]
pub fn report(graph: &Graph) -> Report {
    validate(&table(graph), &Expectation::surface().open(), Collect::All)
}

/// Random programs on the graph.
pub struct Peer(Graph);

impl Peer {
    fn arc(&self, i: u32) -> Option<ArcKey> {
        let arcs = self.0.arcs().map(|arc| arc.key()).collect::<Vec<_>>();
        Some(arcs[(i as usize).checked_rem(arcs.len())?])
    }

    fn face(&self, i: u32) -> Option<FaceKey> {
        let faces = self.0.faces().map(|face| face.key()).collect::<Vec<_>>();
        Some(faces[(i as usize).checked_rem(faces.len())?])
    }

    fn vertex(&self, i: u32) -> Option<VertexKey> {
        let vertices = self.0.vertices().map(|vertex| vertex.key()).collect::<Vec<_>>();
        Some(vertices[(i as usize).checked_rem(vertices.len())?])
    }

    fn try_apply(&mut self, operator: &str, arguments: &[u32]) -> Option<Result<(), GraphError>> {
        let [a, b] = [0, 1].map(|i| arguments.get(i).copied().unwrap_or(0));
        Some(match operator {
            // Replaces the current graph.
            "from_raw_buffers" => {
                let (n, faces) = SHAPES[a as usize % SHAPES.len()];
                let triangles = faces.iter().map(|[a, b, c]| Triangle::new(*a, *b, *c));
                Graph::from_raw_buffers(triangles, (0..n).map(f64::from)).map(|graph| self.0 = graph)
            }
            "arc_split" => {
                let arc = self.arc(a)?;
                self.0.arc_mut(arc)?.split_with(|| 0.0);
                Ok(())
            }
            "arc_bridge" => {
                let (from, to) = (self.arc(a)?, self.arc(b)?);
                self.0.arc_mut(from)?.bridge(Selector::ByKey(to)).map(|_| ())
            }
            "arc_remove" => {
                let arc = self.arc(a)?;
                self.0.arc_mut(arc)?.remove();
                Ok(())
            }
            "face_split" => {
                let face = self.face(a)?;
                let n = self.0.face(face)?.arity();
                let at = |i: u32| Selector::ByIndex(i as usize % n);
                self.0.face_mut(face)?.split(at(a), at(b)).map(|_| ())
            }
            "face_merge" => {
                let (from, to) = (self.face(a)?, self.face(b)?);
                self.0.face_mut(from)?.merge(Selector::ByKey(to)).map(|_| ())
            }
            "face_bridge" => {
                let (from, to) = (self.face(a)?, self.face(b)?);
                self.0.face_mut(from)?.bridge(to)
            }
            "face_triangulate" => {
                let face = self.face(a)?;
                self.0.face_mut(face)?.triangulate();
                Ok(())
            }
            "face_poke" => {
                let face = self.face(a)?;
                self.0.face_mut(face)?.poke_with(|| 0.0);
                Ok(())
            }
            "face_remove" => {
                let face = self.face(a)?;
                self.0.face_mut(face)?.remove();
                Ok(())
            }
            "vertex_remove" => {
                let vertex = self.vertex(a)?;
                self.0.vertex_mut(vertex)?.remove();
                Ok(())
            }
            _ => unreachable!("{operator} is not an operator"),
        })
    }
}

impl peer::Peer for Peer {
    const OPERATORS: &'static [Operator] = &[
        Operator::with_values("from_raw_buffers", 1, 4),
        Operator::on_records("arc_split", 1, 4),
        Operator::on_records("arc_bridge", 2, 2),
        Operator::on_records("arc_remove", 1, 1),
        Operator::on_records("face_split", 2, 4),
        Operator::on_records("face_merge", 2, 3),
        Operator::on_records("face_bridge", 2, 1),
        Operator::on_records("face_triangulate", 1, 3),
        Operator::on_records("face_poke", 1, 4),
        Operator::on_records("face_remove", 1, 2),
        Operator::on_records("vertex_remove", 1, 1),
    ];

    fn new() -> Self {
        Self(Graph::new())
    }

    fn apply(&mut self, operator: &str, arguments: &[u32]) -> Applied {
        match self.try_apply(operator, arguments) {
            Some(Ok(())) => Applied::Done,
            Some(Err(_)) => Applied::Refused,
            None => Applied::Skipped,
        }
    }

    fn report(&self) -> Report {
        report(&self.0)
    }
}
