//! The groups of faces that become one when edges are removed, and the outer boundary component of each group.
//!
//! Removing an edge between two faces makes them one, and two cycles one. Removing an edge with one face on both sides makes two cycles of
//! one. So the numbers of faces and edges give the number of cycles of each group, without a walk. A single cycle is the outer one. Of
//! several, the outer one is that beyond which the unbounded face lies:
//!
//! ```text
//!   the group ──► cycle ──► what lies beyond ──► ends: the cycle is inner
//!             ──► cycle ──► what lies beyond ──► ends: the cycle is inner
//!             ──► cycle ──► what lies beyond ──► …     the one that is left is outer
//! ```
//!
//! There is a search beyond each cycle, from group to group over the edges, and all take their steps in turn. Beyond an inner cycle, the outer
//! cycle of a group is that over which the search reaches it. No group that was reached so is searched again. So the searches that
//! end take linear time together, and the one that is left takes no longer than the longest of these.

use crate::slots::{NIL, Sets};
use crate::store::{BoundarySlot, BoundaryStart, FaceSlot, HalfEdgeSlot, Store};
use alloc::vec;
use alloc::vec::Vec;
use core::mem;

/// The group of the unbounded face.
pub(super) const UNBOUNDED: usize = 0;

/// The faces in groups that become one face each.
pub(super) struct Groups {
    /// The faces, with a number for each group.
    faces: Sets,
    pub(super) all: Vec<Group>,
}

/// A group of faces.
#[derive(Clone, Copy)]
pub(super) struct Group {
    /// The number of cycles that it has in the end, once those are taken off of which isolated vertices are left.
    pub(super) cycles: u32,
    /// True if it loses an edge or a vertex. What belongs to the others stays as it is.
    pub(super) changes: bool,
}

/// A cycle of a group in which something changes.
pub(super) struct Cycle {
    pub(super) boundary: BoundarySlot,
    pub(super) group: u32,
    /// The face to the left of the half-edge with the smallest index, as it was, once it is known.
    pub(super) face: Option<FaceSlot>,
}

impl Groups {
    /// Groups the faces that become one when these edges are removed. Each edge is given by one half-edge. O(slots α(slots)),
    /// where α is the inverse of Ackermann's function.
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

    /// Notes that the group of a boundary component changes.
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

    /// By group that changes the index of the boundary component that is its outer one, or nil. These are all cycles of such groups, each
    /// with a boundary component, which still names a face of its group. O(slots).
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

/// Stands for the round of a group all of whose ways have been searched.
const DONE: u32 = NIL;

/// The cycles of groups with several, and what is known of them.
struct Nest<'a> {
    groups: &'a Groups,
    outer: Vec<u32>,
    cycles: &'a [Cycle],
    /// By group its first cycle, then by cycle the next one of its group.
    first: Vec<u32>,
    next: Vec<u32>,
}

/// A search for what lies beyond a cycle.
struct Search {
    /// The boundary component with which it began.
    from: u32,
    /// Boundary components still to be walked around.
    ahead: Vec<BoundarySlot>,
    /// The half-edge to be crossed next, and that with which the walk ends.
    walk: Option<[HalfEdgeSlot; 2]>,
    /// The groups that it reached, and the boundary components by which.
    reached: Vec<(usize, u32)>,
    /// True if it reached the unbounded face, from which it does not go on.
    is_outer: bool,
}

impl Nest<'_> {
    /// Finds out which cycle of a group is outer, and the same for all groups beyond the others.
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

    /// Crosses one half-edge. False if there was none left.
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

    /// Pushes the boundary components of a group, of which this is one.
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
