//! Groups of faces that merge when edges are removed, and the outer boundary component of each group.
//!
//! Removing an edge between two faces merges the faces and their cycles. Removing an edge with one face on both sides splits a cycle.
//! So the numbers of faces and edges determine the number of cycles of each group, without a walk. A single cycle is the outer one. Of
//! several cycles, the one with the unbounded face beyond it is outer:
//!
//! ```text
//!   the group ──► cycle ──► what lies beyond ──► ends: the cycle is inner
//!             ──► cycle ──► what lies beyond ──► ends: the cycle is inner
//!             ──► cycle ──► what lies beyond ──► …     the one that is left is outer
//! ```
//!
//! A search runs beyond each cycle, from group to group across edges, and all searches advance in turn. A group reached through an
//! inner cycle has as its outer cycle the one through which it was reached, and is not searched again. So the searches that end take
//! linear time together, and the remaining search takes no longer than the longest of them.

use crate::dcel::structure::Dcel;
use crate::numbers::{NIL, Sets};
use crate::store::{BoundarySlot, BoundaryStart, FaceSlot, HalfEdgeSlot, Store, VertexLink};
use alloc::vec;
use alloc::vec::Vec;
use core::mem;

pub(super) const UNBOUNDED: usize = 0;

/// The faces, grouped by the face that they will form.
pub(super) struct Groups {
    faces: Sets,
    pub(super) all: Vec<Group>,
}

#[derive(Clone, Copy)]
pub(super) struct Group {
    /// The final number of cycles, not counting cycles that shrink to isolated vertices.
    pub(super) cycles: u32,
    /// True if the group loses an edge or a vertex. Boundary components of other groups are unchanged.
    pub(super) changes: bool,
}

pub(super) struct Cycle {
    pub(super) boundary: BoundarySlot,
    pub(super) group: u32,
    /// The old face to the left of the half-edge with the smallest index, once known.
    pub(super) face: Option<FaceSlot>,
}

impl Groups {
    /// Groups the faces that merge when these edges, each given by one half-edge, are removed. O(slots α(slots)), where α is the
    /// inverse of Ackermann's function.
    pub(super) fn without(store: &Store, edges: &[HalfEdgeSlot]) -> Self {
        let index = |h: HalfEdgeSlot| store.face(store.boundary(h)).index() as u32;
        let mut faces = Sets::new(store.face_slots());
        let mut parted = Vec::new();
        for h in edges {
            let (face, before) = (index(*h), faces.count);
            faces.join(face, index(store.twin(*h)));
            if faces.count == before {
                parted.push(face);
            }
        }
        let mut all: Vec<Group> = Vec::with_capacity(store.face_count().saturating_sub(edges.len() - parted.len()));
        let mut count = 0;
        let unbounded = store.unbounded();
        let others = (0..store.face_slots()).filter_map(|i| store.face_at(i)).filter(|f| *f != unbounded);
        for f in core::iter::once(unbounded).chain(others) {
            let inner = (0..store.inner_count(f)).filter_map(|place| store.inner(f, place));
            let cycles = inner.filter(|b| matches!(store.start(*b), BoundaryStart::HalfEdge(_))).count() as u32;
            let cycles = cycles + u32::from(f != unbounded);
            let group = faces.number(f.index() as u32, &mut count) as usize;
            if group == all.len() {
                all.push(Group { cycles, changes: false });
            } else {
                all[group] = Group { cycles: all[group].cycles + cycles - 1, changes: true };
            }
        }
        for face in parted {
            let group = &mut all[faces.known_number(face) as usize];
            *group = Group { cycles: group.cycles + 1, changes: true };
        }
        Self { faces, all }
    }

    pub(super) fn change(&mut self, store: &Store, b: BoundarySlot) {
        let group = self.of_boundary(store, b);
        self.all[group].changes = true;
    }

    pub(super) fn of_face(&self, f: FaceSlot) -> usize {
        self.faces.known_number(f.index() as u32) as usize
    }

    pub(super) fn of_boundary(&self, store: &Store, b: BoundarySlot) -> usize {
        self.of_face(store.face(b))
    }

    /// Returns the index of the outer boundary component of each changed group, or nil. `cycles` are all cycles of these groups; each
    /// has a boundary component that still names a face of its group. O(slots).
    pub(super) fn outer(&self, store: &Store, cycles: &[Cycle]) -> Vec<u32> {
        let index = |cycle: &Cycle| cycle.boundary.index() as u32;
        let mut nest =
            Nest { groups: self, outer: vec![NIL; self.all.len()], cycles, first: Vec::new(), next: Vec::new() };
        let mut several = Vec::new();
        for (i, cycle) in cycles.iter().enumerate() {
            let group = cycle.group as usize;
            if group == UNBOUNDED {
                continue;
            }
            if self.all[group].cycles == 1 {
                nest.outer[group] = index(cycle);
                continue;
            }
            if several.is_empty() {
                nest.first = vec![NIL; self.all.len()];
                nest.next = vec![NIL; cycles.len()];
            }
            nest.next[i] = mem::replace(&mut nest.first[group], i as u32);
            several.push(group);
        }
        let mut seen = vec![0; if several.is_empty() { 0 } else { self.all.len() }];
        for (round, group) in (1..).zip(several) {
            if nest.outer[group] == NIL {
                nest.search(store, group, round, &mut seen);
            }
        }
        nest.outer
    }
}

const DONE: u32 = NIL;

/// The cycles of groups with several cycles, and the outer ones found so far.
struct Nest<'a> {
    groups: &'a Groups,
    outer: Vec<u32>,
    cycles: &'a [Cycle],
    /// By group: its first cycle; by cycle: the next cycle of its group.
    first: Vec<u32>,
    next: Vec<u32>,
}

/// A search of the region beyond a cycle.
struct Search {
    from: u32,
    /// Boundary components still to be walked around.
    ahead: Vec<BoundarySlot>,
    /// The half-edge to cross next, and the last half-edge of the walk.
    walk: Option<[HalfEdgeSlot; 2]>,
    /// The reached groups, with the boundary components through which they were reached.
    reached: Vec<(usize, u32)>,
    /// True if it reached the unbounded face, where it stops.
    is_outer: bool,
}

impl Nest<'_> {
    /// Finds the outer cycle of a group, and of all groups beyond its other cycles.
    fn search(&mut self, store: &Store, group: usize, round: u32, seen: &mut [u32]) {
        seen[group] = round;
        let mut ahead = Vec::new();
        self.push_cycles(store, group, self.cycles[self.first[group] as usize].boundary, &mut ahead);
        let begin = |b: BoundarySlot| {
            let from = b.index() as u32;
            Search { from, ahead: vec![b], walk: None, reached: Vec::new(), is_outer: false }
        };
        let mut searches: Vec<Search> = ahead.into_iter().map(begin).collect();
        while searches.len() > 1 {
            searches.retain_mut(|search| {
                let goes_on = search.is_outer || self.step(store, search, round, seen);
                if !goes_on {
                    for (group, by) in search.reached.drain(..) {
                        seen[group] = DONE;
                        self.outer[group] = by;
                    }
                }
                goes_on
            });
        }
        self.outer[group] = searches.first().map_or(NIL, |search| search.from);
    }

    /// Crosses one half-edge; returns false if none is left.
    fn step(&self, store: &Store, search: &mut Search, round: u32, seen: &mut [u32]) -> bool {
        let Some([h, last]) = search.walk.take() else {
            let Some(b) = search.ahead.pop() else { return false };
            if let BoundaryStart::HalfEdge(h) = store.start(b) {
                search.walk = Some([h, store.prev(h)]);
            }
            return true;
        };
        if h != last {
            search.walk = Some([store.next(h), last]);
        }
        let b = store.boundary(store.twin(h));
        let group = self.groups.of_boundary(store, b);
        if group == UNBOUNDED {
            search.is_outer = true;
        } else if seen[group] != round && seen[group] != DONE {
            seen[group] = round;
            search.reached.push((group, b.index() as u32));
            if self.outer[group] == NIL {
                self.push_cycles(store, group, b, &mut search.ahead);
            } else {
                search.ahead.push(b);
            }
        }
        true
    }

    fn push_cycles(&self, store: &Store, group: usize, b: BoundarySlot, all: &mut Vec<BoundarySlot>) {
        if self.groups.all[group].changes {
            let mut cycle = self.first[group];
            while let Some(Cycle { boundary, .. }) = self.cycles.get(cycle as usize) {
                all.push(*boundary);
                cycle = self.next[cycle as usize];
            }
        } else {
            let f = store.face(b);
            all.extend(store.outer(f));
            all.extend((0..store.inner_count(f)).filter_map(|place| store.inner(f, place)));
        }
    }
}

impl Dcel {
    /// Unlinks an edge from its cycles and rotations. Its record and the labels stay. If a vertex loses its last half-edge, appends
    /// that half-edge to `last`. O(1).
    pub(super) fn splice_out(&mut self, n: HalfEdgeSlot, last: &mut impl Extend<HalfEdgeSlot>) {
        let store = &mut self.store;
        let t = store.twin(n);
        for h in [n, t] {
            let v = store.origin(h);
            if store.vertex_link(v) == VertexLink::Leaving(h) {
                // The next half-edge clockwise, skipping the other half of a loop.
                let after = store.next(store.twin(h));
                let after = if after == store.twin(h) { store.next(h) } else { after };
                if after == h {
                    last.extend([h]);
                } else {
                    store.set_vertex_link(v, VertexLink::Leaving(after));
                }
            }
        }
        let (before_n, after_n) = (store.prev(n), store.next(n));
        let (before_t, after_t) = (store.prev(t), store.next(t));
        if after_n == n {
            if after_t != t {
                store.join(before_t, after_t);
            }
        } else if after_t == t {
            store.join(before_n, after_n);
        } else {
            if after_t != n {
                store.join(before_n, after_t);
            }
            if after_n != t {
                store.join(before_t, after_n);
            }
        }
    }
}
