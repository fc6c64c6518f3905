//! The edges of an embedding as segments, for the sweep. An edge with bends becomes several segments.

use super::columns::Columns;
use crate::numbers::NIL;
use core::cmp::Ordering;
use twinedge::validate::Violation;
use twinedge_geometry::Point;
use twinedge_geometry::crossing::Clash;
use twinedge_geometry::predicates::compare_lexicographic;

/// The embedding in the form that the sweep takes: live vertices, then the bends, and each edge once.
pub(crate) struct Segments {
    pub(crate) points: Vec<Point>,
    /// The vertex of each point; bends follow and have no entry.
    vertices: Vec<u32>,
    pub(crate) numbers: Vec<u32>,
    pub(crate) ends: Vec<[u32; 2]>,
    /// For each segment, the half-edge from its lexicographically smaller end to the larger; at an open boundary, the only one.
    half_edges: Vec<u32>,
    /// The number of each segment on its edge, in the direction of the half-edge that has the bends. Empty if no edge has bends.
    pieces: Vec<u32>,
    pub(crate) edges: usize,
}

impl Segments {
    pub(crate) fn of(columns: &Columns) -> Self {
        let mut numbers = vec![NIL; columns.points.len()];
        let (vertices, edges) = (columns.points.len(), columns.twin.len() / 2);
        let mut found = Self {
            points: Vec::with_capacity(vertices),
            vertices: Vec::with_capacity(vertices),
            numbers: Vec::new(),
            ends: Vec::with_capacity(edges),
            half_edges: Vec::with_capacity(edges),
            pieces: Vec::new(),
            edges: 0,
        };
        for v in columns.vertices() {
            numbers[v] = found.points.len() as u32;
            found.points.push(columns.points[v]);
            found.vertices.push(v as u32);
        }
        found.points.extend(&columns.bends.points);
        found.numbers = numbers;
        for h in columns.half_edges() {
            found.edges += usize::from(columns.is_asked(h));
            if !columns.bends_of(h).1.is_empty() {
                found.bent(columns, h);
            } else if rises(columns.tail(h), columns.head(h)) || columns.twin[h] == NIL {
                found.ends.push([columns.origin(h), columns.target(h)].map(|v| found.numbers[v]));
                found.half_edges.push(h as u32);
                if !columns.bends.points.is_empty() {
                    found.pieces.push(0);
                }
            }
        }
        found
    }

    /// Adds the segments of an edge with bends, once for its two half-edges.
    fn bent(&mut self, columns: &Columns, h: usize) {
        let (edge, places) = columns.bends_of(h);
        if edge != h {
            return;
        }
        let mut from = self.numbers[columns.origin(h)];
        let target = self.numbers[columns.target(h)];
        let vertices = self.vertices.len();
        let bend = |place: usize| (vertices + place) as u32;
        for (piece, to) in places.map(bend).chain([target]).enumerate() {
            let along = rises(self.points[from as usize], self.points[to as usize]) || columns.twin[h] == NIL;
            self.ends.push([from, to]);
            self.half_edges.push(if along { h as u32 } else { columns.twin[h] });
            self.pieces.push(piece as u32);
            from = to;
        }
    }

    pub(crate) fn bend(&self, place: usize) -> u32 {
        (self.vertices.len() + place) as u32
    }

    /// Returns the half-edge whose left side is the region above a segment, or `None` if the boundary is open there.
    pub(crate) fn above(&self, columns: &Columns, segment: u32) -> Option<usize> {
        let h = self.half_edge(segment);
        let [from, to] = self.ends[segment as usize].map(|end| self.points[end as usize]);
        // The ends are in the direction of the half-edge that represents the edge in calls for bends, if it has bends.
        let along = columns.bends_of(h).1.is_empty() || columns.is_asked(h);
        (rises(from, to) == along).then_some(h)
    }

    pub(crate) fn violation(&self, columns: &Columns, clash: Clash) -> Violation {
        match clash {
            Clash::SamePlace { a, b } => match (self.spot(columns, a), self.spot(columns, b)) {
                (Spot::Vertex(first), Spot::Vertex(second)) => Violation::SamePlace { first, second },
                (Spot::Bend(half_edge, bend), Spot::Vertex(vertex))
                | (Spot::Vertex(vertex), Spot::Bend(half_edge, bend)) => {
                    Violation::BendAtVertex { half_edge, bend, vertex }
                }
                (Spot::Bend(first, first_bend), Spot::Bend(second, second_bend)) => {
                    Violation::BendsAtSamePlace { first, first_bend, second, second_bend }
                }
            },
            Clash::Cross { a, b } if self.is_straight(columns, a) && self.is_straight(columns, b) => {
                Violation::Cross { first: self.half_edge(a), second: self.half_edge(b) }
            }
            Clash::Cross { a, b } => {
                let ((first, first_segment), (second, second_segment)) =
                    (self.piece(columns, a), self.piece(columns, b));
                Violation::SegmentsCross { first, first_segment, second, second_segment }
            }
            Clash::Overlap { a, b } if self.is_straight(columns, a) && self.is_straight(columns, b) => {
                Violation::Overlap { first: self.half_edge(a), second: self.half_edge(b) }
            }
            Clash::Overlap { a, b } => {
                let ((first, first_segment), (second, second_segment)) =
                    (self.piece(columns, a), self.piece(columns, b));
                Violation::SegmentsOverlap { first, first_segment, second, second_segment }
            }
            Clash::Touch { vertex, segment: other } => match self.spot(columns, vertex) {
                Spot::Vertex(vertex) if self.is_straight(columns, other) => {
                    Violation::Touch { vertex, half_edge: self.half_edge(other) }
                }
                Spot::Vertex(vertex) => {
                    let (half_edge, segment) = self.piece(columns, other);
                    Violation::VertexInSegment { vertex, half_edge, segment }
                }
                Spot::Bend(half_edge, bend) => {
                    let (other, segment) = self.piece(columns, other);
                    Violation::BendInSegment { half_edge, bend, other, segment }
                }
            },
        }
    }

    fn spot(&self, columns: &Columns, point: u32) -> Spot {
        match (point as usize).checked_sub(self.vertices.len()) {
            None => Spot::Vertex(self.vertices[point as usize] as usize),
            Some(place) => {
                let (half_edge, bend) = columns.bends.owner(place);
                Spot::Bend(half_edge, bend)
            }
        }
    }

    fn half_edge(&self, segment: u32) -> usize {
        self.half_edges[segment as usize] as usize
    }

    fn is_straight(&self, columns: &Columns, segment: u32) -> bool {
        columns.bends_of(self.half_edge(segment)).1.is_empty()
    }

    /// Returns the half-edge that answers for the bends of the segment's edge, and the segment's number on it. It has bends.
    fn piece(&self, columns: &Columns, segment: u32) -> (usize, usize) {
        let (edge, _) = columns.bends_of(self.half_edge(segment));
        (edge, self.pieces[segment as usize] as usize)
    }
}

enum Spot {
    Vertex(usize),
    /// A half-edge, and the number of its bend.
    Bend(usize, usize),
}

/// Returns true if the second point is lexicographically larger.
fn rises(from: Point, to: Point) -> bool {
    compare_lexicographic(from, to) == Ordering::Less
}
