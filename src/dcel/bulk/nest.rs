//! What is left of a structure without some of its edges: the cycles, the faces that have become one, and which cycle of a face
//! is its outer one.
//!
//! ```text
//!   a group with one cycle: it is the outer one            ┐ and so on, of the cycles
//!   a component with one cycle: it is its outside, inner   ┘ that are left; the unbounded group has no outer one
//! ```
//!
//! Each cycle is of one group and of one component. Groups and components are a tree in this way, rooted at the unbounded group. A
//! cycle is outer if the component is the parent of the group, and inner if it is the other way round. The tree is taken apart from
//! its leaves, each of which has one cycle left: that to its parent.

use super::sets::Sets;
use crate::dcel::import::gather::NIL;
use crate::dcel::structure::Dcel;
use crate::store::Store;
use crate::store::links::VertexLink;
use alloc::vec;
use alloc::vec::Vec;

/// A structure without the edges that are to go. Nothing of it is changed yet.
pub(super) struct Rest<'a, S: Store> {
    pub(super) dcel: &'a Dcel<S>,
    /// By half-edge, whether it goes.
    pub(super) goes: &'a [bool],
    /// Of each edge that goes one half-edge.
    pub(super) edges: &'a [S::HalfEdge],
}

/// The cycles that are left, and the faces whose borders go, in groups that become one face each.
pub(super) struct Nest<S: Store> {
    /// By half-edge its cycle; nil for those that go.
    pub(super) cycle_of: Vec<u32>,
    /// By cycle its half-edge with the smallest index.
    pub(super) starts: Vec<S::HalfEdge>,
    /// By cycle the group of the face that it bounds.
    pub(super) group_of_cycle: Vec<u32>,
    /// By face its group. That of the unbounded face is 0.
    pub(super) group_of: Vec<u32>,
    /// By group the cycle that is its outer boundary component; nil for the unbounded one.
    pub(super) outer: Vec<u32>,
    /// Half-edges that get another next.
    pub(super) joins: Vec<[S::HalfEdge; 2]>,
}

impl<S: Store> Rest<'_, S> {
    pub(super) fn goes(&self, h: S::HalfEdge) -> bool {
        self.goes[self.dcel.store.half_edge_index(h)]
    }

    /// The half-edge that will follow one that stays. O(half-edges between them that go).
    fn next(&self, h: S::HalfEdge) -> S::HalfEdge {
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

    /// Finds the groups and the cycles. O(slots α(slots)), where α is the inverse of Ackermann's function.
    pub(super) fn nest(&self) -> Nest<S> {
        let store = &self.dcel.store;
        let (group_of, groups) = self.groups();
        let (mut cycle_of, mut joins) = (vec![NIL; self.goes.len()], Vec::new());
        let (mut starts, mut group_of_cycle) = (Vec::new(), Vec::new());
        for index in 0..self.goes.len() {
            if self.goes[index] || cycle_of[index] != NIL {
                continue;
            }
            let Some(start) = store.half_edge_at(index) else { continue };
            let mut h = start;
            loop {
                cycle_of[store.half_edge_index(h)] = starts.len() as u32;
                let next = self.next(h);
                if next != store.next(h) {
                    joins.push([h, next]);
                }
                h = next;
                if h == start {
                    break;
                }
            }
            starts.push(start);
            group_of_cycle.push(group_of[store.face_index(store.face(store.boundary(start)))]);
        }
        let outer = self.outer(&cycle_of, &group_of_cycle, groups);
        Nest { cycle_of, starts, group_of_cycle, group_of, outer, joins }
    }

    /// By face its group, and how many there are. An edge that goes joins the groups of its faces.
    fn groups(&self) -> (Vec<u32>, usize) {
        let store = &self.dcel.store;
        let index = |h: S::HalfEdge| store.face_index(store.face(store.boundary(h))) as u32;
        let mut sets = Sets::new(store.face_slots());
        for h in self.edges {
            sets.join(index(*h), index(store.twin(*h)));
        }
        let mut of = vec![NIL; store.face_slots()];
        // By number that stands for a set, the group.
        let mut groups = vec![NIL; of.len()];
        let mut count = 0;
        let faces = (0..of.len()).filter_map(|i| store.face_at(i));
        for f in core::iter::once(store.unbounded()).chain(faces) {
            let f = store.face_index(f);
            let group = &mut groups[sets.find(f as u32) as usize];
            if *group == NIL {
                *group = count;
                count += 1;
            }
            of[f] = *group;
        }
        (of, count as usize)
    }

    /// By group its outer cycle.
    fn outer(&self, cycle_of: &[u32], group_of_cycle: &[u32], groups: usize) -> Vec<u32> {
        let store = &self.dcel.store;
        // The components, as sets of cycles.
        let mut components = Sets::new(group_of_cycle.len());
        for (index, cycle) in cycle_of.iter().enumerate().filter(|(_, cycle)| **cycle != NIL) {
            if let Some(h) = store.half_edge_at(index) {
                let across = cycle_of[store.half_edge_index(store.twin(h))];
                if *cycle < across {
                    components.join(*cycle, across);
                }
            }
        }
        // The nodes of the tree: the groups, then the components, by the cycle that stands for each. Of each, how many cycles are left,
        // and the exclusive or of their numbers: if one is left, that is its number.
        let mut ends = |cycle: u32| [group_of_cycle[cycle as usize] as usize, groups + components.find(cycle) as usize];
        let mut left = vec![(0_u32, 0_u32); groups + group_of_cycle.len()];
        for cycle in 0..group_of_cycle.len() as u32 {
            for node in ends(cycle) {
                left[node].0 += 1;
                left[node].1 ^= cycle;
            }
        }
        let mut outer = vec![NIL; groups];
        for first in 1..left.len() {
            let mut node = first;
            while node != 0 && left[node].0 == 1 {
                let cycle = left[node].1;
                let [group, component] = ends(cycle);
                if node == group {
                    outer[group] = cycle;
                }
                for node in [group, component] {
                    left[node].0 -= 1;
                    left[node].1 ^= cycle;
                }
                node = if node == group { component } else { group };
            }
        }
        outer
    }
}
