//! The edges of an embedding as segments, for the sweep.

use super::columns::Columns;
use crate::geometry::Point;
use crate::geometry::crossing::Clash;
use crate::geometry::predicates::compare_lexicographic;
use crate::validate::columns::NIL;
use crate::validate::violation::Violation;
use core::cmp::Ordering;

/// The embedding in the form that the sweep takes: live vertices only, and each edge once.
pub(in crate::validate) struct Segments {
    pub(in crate::validate) points: Vec<Point>,
    /// The vertex of each point.
    vertices: Vec<usize>,
    /// The point of each vertex.
    pub(in crate::validate) numbers: Vec<u32>,
    pub(in crate::validate) ends: Vec<[u32; 2]>,
    /// For each segment the half-edge that runs from its lexicographically smaller end to the larger; at an open boundary
    /// the only one.
    half_edges: Vec<usize>,
}

impl Segments {
    pub(in crate::validate) fn of(columns: &Columns) -> Self {
        let mut numbers = vec![NIL; columns.points.len()];
        let mut found = Self {
            points: Vec::new(),
            vertices: Vec::new(),
            numbers: Vec::new(),
            ends: Vec::new(),
            half_edges: Vec::new(),
        };
        for v in columns.vertices() {
            numbers[v] = found.points.len() as u32;
            found.points.push(columns.points[v]);
            found.vertices.push(v);
        }
        for h in columns.half_edges() {
            if rises(columns, h) || columns.twin[h] == NIL {
                found.ends.push([columns.origin(h), columns.target(h)].map(|v| numbers[v]));
                found.half_edges.push(h);
            }
        }
        found.numbers = numbers;
        found
    }

    /// The half-edge that has the region above a segment to its left; none if the boundary is open there.
    pub(in crate::validate) fn above(&self, columns: &Columns, segment: u32) -> Option<usize> {
        let h = self.half_edges[segment as usize];
        rises(columns, h).then_some(h)
    }

    /// A clash of segments as a violation of G4.
    pub(in crate::validate) fn violation(&self, clash: Clash) -> Violation {
        let vertex = |p: u32| self.vertices[p as usize];
        let edge = |s: u32| self.half_edges[s as usize];
        match clash {
            Clash::SamePlace { a, b } => Violation::SamePlace { first: vertex(a), second: vertex(b) },
            Clash::Cross { a, b } => Violation::Cross { first: edge(a), second: edge(b) },
            Clash::Overlap { a, b } => Violation::Overlap { first: edge(a), second: edge(b) },
            Clash::Touch { vertex: v, segment } => Violation::Touch { vertex: vertex(v), half_edge: edge(segment) },
        }
    }
}

fn rises(columns: &Columns, h: usize) -> bool {
    compare_lexicographic(columns.tail(h), columns.head(h)) == Ordering::Less
}
