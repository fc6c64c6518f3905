//! Edges, isolated vertices and inner boundary components by their coordinates.

use core::cmp::Ordering;
use rstar::primitives::GeomWithData;
use rstar::{AABB, RTreeObject};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};

/// A half-edge as drawn: the vertices at its ends, and their coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Line {
    pub(super) vertices: [u32; 2],
    pub(super) points: [Point; 2],
}

/// An edge, by the smaller of its half-edges, or an isolated vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Thing {
    Edge(u32),
    Vertex(u32),
}

/// An edge or isolated vertex with the coordinates of its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Drawn {
    pub(super) thing: Thing,
    pub(super) vertices: [u32; 2],
    pub(super) ends: [Point; 2],
}

impl Drawn {
    pub(super) fn edge(h: usize, line: Line) -> Self {
        Self { thing: Thing::Edge(h as u32), vertices: line.vertices, ends: line.points }
    }

    pub(super) fn vertex(v: usize, at: Point) -> Self {
        Self { thing: Thing::Vertex(v as u32), vertices: [v as u32; 2], ends: [at; 2] }
    }

    /// Returns the ends, the lexicographically smaller one first.
    pub(super) fn rising(&self) -> [Point; 2] {
        let [a, b] = self.ends;
        if compare_lexicographic(a, b).is_gt() { [b, a] } else { [a, b] }
    }

    /// Returns true if it passes below a point and the sweep line through the point crosses it between its ends.
    pub(super) fn passes_below(&self, p: Point) -> bool {
        let [low, high] = self.rising();
        let spans = compare_lexicographic(low, p).is_lt() && compare_lexicographic(p, high).is_lt();
        spans && orientation(low, high, p) == Orientation::CounterClockwise
    }

    /// Returns true if this edge is above another one. A sweep line must cross both, and they may meet only at an end.
    pub(super) fn is_above(&self, other: &Self) -> bool {
        let ([low, high], [other_low, other_high]) = (self.rising(), other.rising());
        match compare_lexicographic(low, other_low) {
            Ordering::Less => orientation(low, high, other_low) == Orientation::Clockwise,
            Ordering::Equal => orientation(low, high, other_high) == Orientation::Clockwise,
            Ordering::Greater => orientation(other_low, other_high, low) == Orientation::CounterClockwise,
        }
    }
}

impl RTreeObject for Drawn {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        let [a, b] = self.ends.map(<[f64; 2]>::from);
        AABB::from_corners(a, b)
    }
}

/// An inner boundary component, by its starting point.
pub(super) type InnerStart = GeomWithData<[f64; 2], u32>;

/// Entries to remove from an index, and entries to add.
pub(super) struct Exchange<T> {
    pub(super) gone: Vec<T>,
    pub(super) come: Vec<T>,
}

impl<T> Default for Exchange<T> {
    fn default() -> Self {
        Self { gone: Vec::new(), come: Vec::new() }
    }
}

impl<T: PartialEq> Exchange<T> {
    /// Adds the old and the new state of something, unless they are equal.
    pub(super) fn put(&mut self, [before, after]: [Option<T>; 2]) {
        if before != after {
            self.gone.extend(before);
            self.come.extend(after);
        }
    }
}

/// The entries of edges and isolated vertices, and of inner boundary components, to exchange.
#[derive(Default)]
pub(super) struct Update {
    pub(super) drawn: Exchange<Drawn>,
    pub(super) starts: Exchange<InnerStart>,
}
