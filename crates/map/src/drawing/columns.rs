//! The embedding as plain columns, which read each link and each point of the structure once.
//!
//! Links must not change during a walk. So L1, L2 and L3 are checked again on the columns. Where they hold, `next` and
//! `next∘twin` return to their start or end at an open boundary, and walks around two vertices share no half-edge.

use super::bends::{Bends, asked};
use super::reserved::reserved;
use crate::Embedding;
use crate::numbers::NIL;
use core::ops::Range;
use twinedge::validate::{Rule, Unchecked};
use twinedge_geometry::Point;

pub(crate) struct Columns {
    /// The origin of each half-edge; `NIL` if it is not live.
    pub(crate) origin: Vec<u32>,
    /// The twin of each half-edge; `NIL` at an open boundary.
    pub(crate) twin: Vec<u32>,
    pub(crate) next: Vec<u32>,
    pub(crate) is_vertex: Vec<bool>,
    pub(crate) points: Vec<Point>,
    pub(crate) bends: Bends,
}

impl Columns {
    /// Reads a structure that satisfies R1 and L. Fails if the rules no longer hold, memory runs out, or for too many bends.
    pub(crate) fn read<E: Embedding + ?Sized>(embedding: &E) -> Result<Self, Unchecked> {
        // A structure that has changed since its validation is unreliable.
        let mut columns = Self::of_links(embedding).ok_or(Unchecked::Broken(Rule::R1))?;
        let edges = columns.half_edges().filter(|h| columns.is_asked(*h));
        let most = NIL as usize - 1 - columns.points.len();
        columns.bends = Bends::read(embedding, columns.origin.len(), edges, most)?;
        Ok(columns)
    }

    fn of_links<E: Embedding + ?Sized>(embedding: &E) -> Option<Self> {
        let slots = |n: usize| u32::try_from(n).ok().filter(|n| *n < NIL).map(|n| n as usize);
        let vertices = slots(embedding.vertex_slots())?;
        let half_edges = slots(embedding.half_edge_slots())?;
        let mut columns = Self {
            origin: reserved(half_edges)?,
            twin: reserved(half_edges)?,
            next: reserved(half_edges)?,
            is_vertex: reserved(vertices)?,
            points: reserved(vertices)?,
            bends: Bends::default(),
        };
        for v in 0..vertices {
            let live = embedding.is_vertex(v);
            columns.is_vertex.push(live);
            columns.points.push(if live { embedding.point(v) } else { Point::default() });
        }
        let slot = |link: Option<usize>, slots| link.filter(|i| *i < slots).map_or(NIL, |i| i as u32);
        for h in 0..half_edges {
            let [origin, twin, next] = if embedding.is_half_edge(h) {
                [embedding.origin(h), embedding.twin(h), embedding.next(h)]
            } else {
                [None; 3]
            };
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

    pub(crate) fn half_edges(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.origin.len()).filter(|h| self.origin[*h] != NIL)
    }

    pub(crate) fn vertices(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.points.len()).filter(|v| self.is_vertex[*v])
    }

    pub(crate) fn next(&self, h: usize) -> usize {
        self.next[h] as usize
    }

    /// Returns the next half-edge clockwise around the origin, or `None` at an open boundary.
    pub(crate) fn clockwise(&self, h: usize) -> Option<usize> {
        let t = self.twin[h];
        (t != NIL).then(|| self.next(t as usize))
    }

    pub(crate) fn origin(&self, h: usize) -> usize {
        self.origin[h] as usize
    }

    pub(crate) fn target(&self, h: usize) -> usize {
        self.origin(self.next(h))
    }

    /// Returns the coordinates of the origin of a half-edge.
    pub(crate) fn tail(&self, h: usize) -> Point {
        self.points[self.origin(h)]
    }

    /// Returns the coordinates of the target of a half-edge.
    pub(crate) fn head(&self, h: usize) -> Point {
        self.points[self.target(h)]
    }

    /// Returns true if this half-edge represents its edge in calls for bends.
    pub(crate) fn is_asked(&self, h: usize) -> bool {
        asked(h, self.twin[h]) == h
    }

    /// Returns the half-edge that represents the edge in calls for bends, and the indices of the bends.
    pub(crate) fn bends_of(&self, h: usize) -> (usize, Range<usize>) {
        let edge = asked(h, self.twin[h]);
        (edge, self.bends.range(edge))
    }

    /// Returns the points of a half-edge after its origin: its bends and its target.
    pub(crate) fn line(&self, h: usize) -> impl Iterator<Item = Point> + '_ {
        let (edge, places) = self.bends_of(h);
        let (forward, backward) = if edge == h { (places, 0..0) } else { (0..0, places) };
        forward.chain(backward.rev()).map(|place| self.bends.points[place]).chain([self.head(h)])
    }

    /// Returns the first point of a half-edge after its origin.
    pub(crate) fn towards(&self, h: usize) -> Point {
        let (edge, places) = self.bends_of(h);
        match places.len() {
            0 => self.head(h),
            n => self.bends.points[if edge == h { places.start } else { places.start + n - 1 }],
        }
    }
}
