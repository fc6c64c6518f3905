//! G4: edges meet only at shared endpoints.

use super::columns::{Columns, NIL};
use super::{Embedding, Run};
use crate::geometry::Point;
use crate::geometry::crossing::{Clash, clashes};
use crate::geometry::predicates::compare_lexicographic;
use crate::geometry::sweep::sweep;
use crate::validate::{Halt, Rule, Unchecked, Violation};
use core::cmp::Ordering;

/// For each of some points the segment below it.
pub(super) type Below = Vec<Option<u32>>;

/// The drawing as the sweep wants it: live vertices only, and each edge once.
pub(super) struct Segments {
    points: Vec<Point>,
    /// The vertex of each point.
    vertices: Vec<usize>,
    /// The point of each vertex.
    numbers: Vec<u32>,
    ends: Vec<[u32; 2]>,
    /// For each segment the half-edge that runs from its lexicographically smaller end to the larger; at an open boundary
    /// the only one.
    half_edges: Vec<usize>,
}

impl Segments {
    pub(super) fn of(columns: &Columns) -> Self {
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

    /// The half-edge of which the left side is above a segment; none at an open boundary there.
    pub(super) fn above(&self, columns: &Columns, segment: u32) -> Option<usize> {
        let h = self.half_edges[segment as usize];
        rises(columns, h).then_some(h)
    }

    fn violation(&self, clash: Clash) -> Violation {
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

impl<D: Embedding + ?Sized> Run<'_, D> {
    /// Runs G4, and gives the segment below each of these vertices, which is a guess if G4 is broken. Nothing, if there are
    /// too many segments.
    pub(super) fn disjoint(&mut self, segments: &Segments, vertices: &[u32]) -> Result<Option<Below>, Halt> {
        self.findings.checked(Rule::G4, segments.ends.len() as u64);
        let queries: Vec<u32> = vertices.iter().map(|v| segments.numbers[*v as usize]).collect();
        // The arrays describe a drawing: G1 holds, and every number was given out above.
        let Ok(swept) = sweep(&segments.points, &segments.ends, &queries) else {
            self.findings.not_checked(Rule::G4, Unchecked::TooLarge);
            return Ok(None);
        };
        if swept.clash.is_some() {
            let (found, total) =
                clashes(&segments.points, &segments.ends, self.findings.room()).unwrap_or_else(|_| (Vec::new(), 0));
            let kept = found.len() as u64;
            for clash in found {
                self.findings.add(segments.violation(clash))?;
            }
            self.findings.add_uncollected(Rule::G4, total.saturating_sub(kept));
        }
        Ok(Some(swept.below))
    }
}
