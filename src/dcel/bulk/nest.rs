//! What is left of a structure without some of its edges: the cycles, the faces that have become one, and which cycle of a face
//! is its outer one.
//!
//! ```text
//!   the unbounded group:   all its cycles are inner
//!     across an inner cycle:    the other cycles of that component, each the outer one of its group
//!       the other cycles of that group:    inner again, and so on
//! ```

use crate::dcel::import::gather::NIL;
use crate::dcel::structure::Dcel;
use crate::store::Store;
use crate::store::links::{BoundaryStart, VertexLink};
use alloc::vec;
use alloc::vec::Vec;

/// A structure without the edges that are to go. Nothing of it is changed yet.
pub(super) struct Rest<'a, S: Store> {
    pub(super) dcel: &'a Dcel<S>,
    /// By half-edge, whether it goes.
    pub(super) goes: &'a [bool],
}

/// The cycles that are left, and the faces whose borders go, in groups that become one face each.
pub(super) struct Nest<S: Store> {
    /// By half-edge its cycle; nil for those that go.
    pub(super) cycle_of: Vec<u32>,
    /// By cycle its half-edge with the smallest index.
    pub(super) starts: Vec<S::HalfEdge>,
    /// By face its group. That of the unbounded face is 0.
    pub(super) group_of: Vec<u32>,
    /// By group the cycle that is its outer boundary component; nil for the unbounded one.
    pub(super) outer: Vec<u32>,
}

impl<S: Store> Nest<S> {
    /// The group of the face that a cycle bounds.
    pub(super) fn group_of_cycle(&self, store: &S, cycle: usize) -> u32 {
        self.group_of[store.face_index(store.face(store.boundary(self.starts[cycle])))]
    }
}

impl<S: Store> Rest<'_, S> {
    pub(super) fn goes(&self, h: S::HalfEdge) -> bool {
        self.goes[self.dcel.store.half_edge_index(h)]
    }

    /// The half-edge that will follow one that stays. O(half-edges between them that go).
    pub(super) fn next(&self, h: S::HalfEdge) -> S::HalfEdge {
        let store = &self.dcel.store;
        let mut next = store.next(h);
        while self.goes(next) {
            // At the latest the twin of `h` stays.
            next = store.next(store.twin(next));
        }
        next
    }

    /// A half-edge that leaves the vertex and stays, from the one that it keeps on. O(degree).
    pub(super) fn leaving(&self, v: S::Vertex) -> Option<S::HalfEdge> {
        let store = &self.dcel.store;
        let VertexLink::Leaving(start) = store.vertex_link(v) else { return None };
        let mut h = start;
        while self.goes(h) {
            h = store.next(store.twin(h));
            if h == start {
                return None;
            }
        }
        Some(h)
    }

    /// The half-edges of a cycle that is left, from one on.
    pub(super) fn cycle(&self, start: S::HalfEdge) -> impl Iterator<Item = S::HalfEdge> {
        core::iter::successors(Some(start), move |h| Some(self.next(*h)).filter(|next| *next != start))
    }

    /// Finds the cycles and the groups. O(slots).
    pub(super) fn nest(&self) -> Nest<S> {
        let store = &self.dcel.store;
        let (mut cycle_of, mut starts) = (vec![NIL; self.goes.len()], Vec::new());
        for start in (0..self.goes.len()).filter_map(|i| store.half_edge_at(i)) {
            if self.goes(start) || cycle_of[store.half_edge_index(start)] != NIL {
                continue;
            }
            for h in self.cycle(start) {
                cycle_of[store.half_edge_index(h)] = starts.len() as u32;
            }
            starts.push(start);
        }
        let (group_of, groups) = self.groups();
        let mut nest = Nest { cycle_of, starts, group_of, outer: vec![NIL; groups] };
        self.find_outer(&mut nest);
        nest
    }

    /// By face its group, and how many there are: a search from face to face across the edges that go.
    fn groups(&self) -> (Vec<u32>, usize) {
        let store = &self.dcel.store;
        let mut of = vec![NIL; store.face_slots()];
        let mut groups = 0;
        let mut queue = Vec::new();
        let faces = (0..of.len()).filter_map(|i| store.face_at(i));
        for first in core::iter::once(store.unbounded()).chain(faces) {
            if of[store.face_index(first)] != NIL {
                continue;
            }
            of[store.face_index(first)] = groups;
            queue.push(first);
            while let Some(f) = queue.pop() {
                let inner = (0..store.inner_count(f)).filter_map(|i| store.inner(f, i));
                for b in store.outer(f).into_iter().chain(inner) {
                    let BoundaryStart::HalfEdge(start) = store.start(b) else { continue };
                    let along =
                        core::iter::successors(Some(start), |h| Some(store.next(*h)).filter(|next| *next != start));
                    for h in along.filter(|h| self.goes(*h)) {
                        let across = store.face(store.boundary(store.twin(h)));
                        let group = &mut of[store.face_index(across)];
                        if *group == NIL {
                            *group = groups;
                            queue.push(across);
                        }
                    }
                }
            }
            groups += 1;
        }
        (of, groups as usize)
    }

    /// Finds the outer cycle of each group, from the unbounded one inwards.
    fn find_outer(&self, nest: &mut Nest<S>) {
        let store = &self.dcel.store;
        let Nest { cycle_of, starts, group_of, outer } = nest;
        let group_of_cycle = |cycle: u32| {
            let start = starts[cycle as usize];
            group_of[store.face_index(store.face(store.boundary(start)))] as usize
        };
        // The cycles of each group, as a list threaded through all.
        let mut cycles = vec![NIL; outer.len()];
        let mut after = vec![NIL; starts.len()];
        for cycle in (0..starts.len() as u32).rev() {
            let first = &mut cycles[group_of_cycle(cycle)];
            after[cycle as usize] = core::mem::replace(first, cycle);
        }
        let mut seen = vec![false; starts.len()];
        let mut queue = Vec::new();
        let mut offer_all = |group: usize, seen: &mut [bool], queue: &mut Vec<u32>| {
            let mut cycle = core::mem::replace(&mut cycles[group], NIL);
            while cycle != NIL {
                if !core::mem::replace(&mut seen[cycle as usize], true) {
                    queue.push(cycle);
                }
                cycle = after[cycle as usize];
            }
        };
        offer_all(0, &mut seen, &mut queue);
        while let Some(cycle) = queue.pop() {
            for h in self.cycle(starts[cycle as usize]) {
                let across = cycle_of[store.half_edge_index(store.twin(h))];
                if seen[across as usize] {
                    continue;
                }
                let group = group_of_cycle(across);
                outer[group] = across;
                offer_all(group, &mut seen, &mut queue);
            }
        }
    }
}
