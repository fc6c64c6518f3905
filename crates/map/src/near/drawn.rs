//! Edges, isolated vertices and inner boundary components by where they lie.

use core::cmp::Ordering;
use rstar::primitives::GeomWithData;
use rstar::{AABB, RTreeObject};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};

/// A half-edge as it is drawn: the vertices at its ends, and where they lie.
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

/// An edge or isolated vertex, and where its ends lie.
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

    /// From the lexicographically smaller end to the larger.
    pub(super) fn rising(&self) -> [Point; 2] {
        let [a, b] = self.ends;
        if compare_lexicographic(a, b).is_gt() { [b, a] } else { [a, b] }
    }

    /// Returns true if it passes below a point, where the sweep line through that point has it between its ends.
    pub(super) fn passes_below(&self, p: Point) -> bool {
        let [low, high] = self.rising();
        let spans = compare_lexicographic(low, p).is_lt() && compare_lexicographic(p, high).is_lt();
        spans && orientation(low, high, p) == Orientation::CounterClockwise
    }

    /// Of two that a sweep line meets, and that meet at most at an end, whether this is above.
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

/// An inner boundary component, by the place where it starts.
pub(super) type InnerStart = GeomWithData<[f64; 2], u32>;

/// Entries that an index has to take off and to add.
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
    /// Something before and after, unless it is the same.
    pub(super) fn put(&mut self, [before, after]: [Option<T>; 2]) {
        if before != after {
            self.gone.extend(before);
            self.come.extend(after);
        }
    }
}

/// The same for edges and isolated vertices, and for the inner boundary components.
#[derive(Default)]
pub(super) struct Update {
    pub(super) drawn: Exchange<Drawn>,
    pub(super) starts: Exchange<InnerStart>,
}
