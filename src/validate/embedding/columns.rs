//! The drawing as plain columns, each answer of the structure asked for once.
//!
//! What is walked along must not change under the walk. So L1, L2 and L3 are looked at once more, in what was read: where
//! they hold, `next` and `next∘twin` come back to where they started, or end at an open boundary, and the walks around
//! two vertices share no half-edge.

use super::Embedding;
use crate::geometry::Point;

/// Nil, and the link of what is not live.
pub(super) const NIL: u32 = u32::MAX;

/// Links and points, by slots.
pub(super) struct Columns {
    /// For each half-edge its origin; nil if it is not live.
    pub(super) origin: Vec<u32>,
    /// For each half-edge its twin; nil at an open boundary.
    pub(super) twin: Vec<u32>,
    /// For each half-edge the next.
    pub(super) next: Vec<u32>,
    /// Which vertices are live.
    pub(super) is_vertex: Vec<bool>,
    /// Where they lie.
    pub(super) points: Vec<Point>,
}

impl Columns {
    /// What a structure says of which R1 and L hold; none if it no longer says the same, or there is no memory for it.
    pub(super) fn read<D: Embedding + ?Sized>(drawing: &D) -> Option<Self> {
        let slots = |n: usize| u32::try_from(n).ok().filter(|n| *n < NIL).map(|n| n as usize);
        let vertices = slots(drawing.vertex_slots())?;
        let half_edges = slots(drawing.half_edge_slots())?;
        let mut columns = Self {
            origin: room(half_edges)?,
            twin: room(half_edges)?,
            next: room(half_edges)?,
            is_vertex: room(vertices)?,
            points: room(vertices)?,
        };
        for v in 0..vertices {
            let live = drawing.is_vertex(v);
            columns.is_vertex.push(live);
            columns.points.push(if live { drawing.point(v) } else { Point::default() });
        }
        let slot = |link: Option<usize>, slots| link.filter(|i| *i < slots).map_or(NIL, |i| i as u32);
        for h in 0..half_edges {
            let [origin, twin, next] =
                if drawing.is_half_edge(h) { [drawing.origin(h), drawing.twin(h), drawing.next(h)] } else { [None; 3] };
            columns.origin.push(slot(origin, vertices));
            columns.twin.push(slot(twin, half_edges));
            columns.next.push(slot(next, half_edges));
        }
        columns.hold().then_some(columns)
    }

    fn hold(&self) -> bool {
        let mut follows = vec![false; self.origin.len()];
        self.half_edges().all(|h| {
            let (v, t, n) = (self.origin[h], self.twin[h], self.next[h]);
            let is_mutual = || t as usize != h && self.twin[t as usize] == h as u32;
            self.is_vertex[v as usize]
                && n != NIL
                && self.origin[n as usize] != NIL
                && !std::mem::replace(&mut follows[n as usize], true)
                && (t == NIL || is_mutual() && self.origin[t as usize] == self.origin[n as usize])
        })
    }

    /// The live half-edges.
    pub(super) fn half_edges(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.origin.len()).filter(|h| self.origin[*h] != NIL)
    }

    /// The live vertices.
    pub(super) fn vertices(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.points.len()).filter(|v| self.is_vertex[*v])
    }

    /// The half-edge that follows on the cycle.
    pub(super) fn next(&self, h: usize) -> usize {
        self.next[h] as usize
    }

    /// The half-edge that leaves the same vertex and comes next clockwise; none at an open boundary.
    pub(super) fn clockwise(&self, h: usize) -> Option<usize> {
        let t = self.twin[h];
        (t != NIL).then(|| self.next(t as usize))
    }

    /// The vertex where a half-edge starts.
    pub(super) fn origin(&self, h: usize) -> usize {
        self.origin[h] as usize
    }

    /// The vertex where a half-edge ends.
    pub(super) fn target(&self, h: usize) -> usize {
        self.origin(self.next(h))
    }

    /// Where a half-edge starts.
    pub(super) fn tail(&self, h: usize) -> Point {
        self.points[self.origin(h)]
    }

    /// Where a half-edge ends.
    pub(super) fn head(&self, h: usize) -> Point {
        self.points[self.target(h)]
    }
}

/// A column with that much room, if there is memory for it.
fn room<T>(n: usize) -> Option<Vec<T>> {
    let mut column = Vec::new();
    column.try_reserve_exact(n).ok()?;
    Some(column)
}
