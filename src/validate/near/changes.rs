//! What has changed since, and memory to find it out.

use super::column::Seen;
use super::mirror::{Face, HalfEdge, Label, Mirror, Vertex};
use super::orbits::Walks;
use alloc::vec::Vec;

/// How many records there are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Counts {
    pub(super) vertices: usize,
    pub(super) half_edges: usize,
    pub(super) faces: usize,
    pub(super) unbounded: usize,
    pub(super) inner: usize,
}

/// A half-edge as it is now.
#[derive(Clone, Debug)]
pub(super) struct SeenHalfEdge {
    pub(super) row: HalfEdge,
    /// Whether another half-edge than before has been found to lead to it.
    pub(super) is_led: bool,
}

/// A vertex or label as it is now, and the first of its members that are new there, or have another successor; see [`Members`].
#[derive(Clone, Debug)]
pub(super) struct SeenGroup<R> {
    pub(super) row: R,
    pub(super) first: usize,
}

/// A face as it is now, and how many boundary components say that they have come to its list, and gone from it.
#[derive(Clone, Debug)]
pub(super) struct SeenFace {
    pub(super) row: Face,
    pub(super) gained: usize,
    pub(super) lost: usize,
}

impl SeenFace {
    pub(super) const fn new(row: Face) -> Self {
        Self { row, gained: 0, lost: 0 }
    }
}

/// Members of vertices and of labels, as lists threaded through one column. The position 0 ends a list.
#[derive(Clone, Debug, Default)]
pub(super) struct Members {
    rows: Vec<Member>,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Member {
    pub(super) half_edge: usize,
    /// Whether it belonged there before.
    pub(super) is_old: bool,
    rest: usize,
}

impl Members {
    /// Puts one in front of the list that begins at a position, and gives the new position.
    pub(super) fn push(&mut self, half_edge: usize, is_old: bool, rest: usize) -> usize {
        self.rows.push(Member { half_edge, is_old, rest });
        self.rows.len()
    }

    /// The list that begins at a position.
    pub(super) fn list(&self, first: usize) -> impl Iterator<Item = &Member> {
        let at = |position: usize| self.rows.get(position.checked_sub(1)?);
        core::iter::successors(at(first), move |member| at(member.rest))
    }
}

/// What has changed since, for the mirror to follow. The memory is kept from one check to the next.
#[derive(Clone, Debug, Default)]
pub(super) struct Changes {
    /// The half-edges that may differ, and behind them those that do not and have another half-edge leading to them now.
    pub(super) half_edges: Seen<SeenHalfEdge>,
    /// How many may differ.
    pub(super) touched: usize,
    pub(super) vertices: Seen<SeenGroup<Vertex>>,
    pub(super) labels: Seen<SeenGroup<Label>>,
    pub(super) faces: Seen<SeenFace>,
    pub(super) counts: Counts,
    pub(super) members: Members,
    /// The members of one vertex or label, sorted.
    pub(super) group: Vec<usize>,
    pub(super) walks: Walks,
}

impl Changes {
    /// Nothing has changed. Takes the marks off.
    pub(super) fn clear(&mut self, was: &mut Mirror, counts: Counts) {
        self.half_edges.clear(&mut was.half_edges);
        self.touched = 0;
        self.vertices.clear(&mut was.vertices);
        self.labels.clear(&mut was.labels);
        self.faces.clear(&mut was.faces);
        self.counts = counts;
        self.members.rows.clear();
    }

    /// Of a structure that has come since there was nothing, with that nothing.
    #[cfg(feature = "geometry")]
    pub(super) fn all_of(mirror: &Mirror, counts: Counts) -> (Mirror, Self) {
        let (mut was, mut changes) = (Mirror::default(), Self { counts, ..Self::default() });
        was.half_edges.fit(mirror.half_edges.len());
        for (h, row) in mirror.half_edges.iter() {
            changes.half_edges.see(&mut was.half_edges, h, SeenHalfEdge { row, is_led: false });
        }
        changes.touched = mirror.half_edges.len();
        was.vertices.fit(mirror.vertices.len());
        for (v, row) in mirror.vertices.iter() {
            changes.vertices.see(&mut was.vertices, v, SeenGroup { row, first: 0 });
        }
        was.labels.fit(mirror.labels.len());
        for (b, row) in mirror.labels.iter() {
            changes.labels.see(&mut was.labels, b, SeenGroup { row, first: 0 });
        }
        was.faces.fit(mirror.faces.len());
        for (f, row) in mirror.faces.iter() {
            changes.faces.see(&mut was.faces, f, SeenFace::new(row));
        }
        (was, changes)
    }

    /// The half-edges that may differ.
    pub(super) fn touched(&self) -> impl Iterator<Item = (usize, HalfEdge)> + '_ {
        self.half_edges.iter().take(self.touched).map(|(h, seen)| (h, seen.row))
    }

    /// The links of a half-edge now.
    #[cfg(feature = "geometry")]
    #[inline]
    pub(super) fn half_edge(&self, was: &Mirror, h: usize) -> HalfEdge {
        self.half_edges.find(&was.half_edges, h).map_or_else(|| was.half_edge(h), |seen| seen.row)
    }
}
