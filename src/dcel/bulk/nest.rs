//! The groups of faces that become one when edges are removed, and the outer boundary component of each group.
//!
//! ```text
//!   a group with one cycle: it is the outer one            ┐ and so on, of the cycles
//!   a component with one cycle: it is its outside, inner   ┘ that are left; the unbounded group has no outer one
//! ```
//!
//! Each cycle is of one group and of one component. Groups and components are a tree in this way, rooted at the unbounded group. A
//! cycle is outer if the component is the parent of the group, and inner if it is the other way round. The tree is taken apart from
//! its leaves, each of which has one cycle left: that to its parent.

use crate::slots::{NIL, Sets};
use crate::store::Store;
use crate::store::links::BoundaryStart;
use alloc::vec;
use alloc::vec::Vec;

/// The group of the unbounded face.
pub(super) const UNBOUNDED: usize = 0;

/// The faces in groups that become one face each.
pub(super) struct Groups {
    /// By face its group.
    of: Vec<u32>,
    pub(super) count: usize,
}

impl Groups {
    /// Groups the faces that become one when these edges are removed. Each edge is given by one half-edge. O(slots α(slots)),
    /// where α is the inverse of Ackermann's function.
    pub(super) fn without<S: Store>(store: &S, edges: &[S::HalfEdge]) -> Self {
        let index = |h: S::HalfEdge| store.face_index(store.face(store.boundary(h))) as u32;
        let mut sets = Sets::new(store.face_slots());
        for h in edges {
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
        Self { of, count: count as usize }
    }

    pub(super) fn of_face<S: Store>(&self, store: &S, f: S::Face) -> usize {
        self.of[store.face_index(f)] as usize
    }

    pub(super) fn of_boundary<S: Store>(&self, store: &S, b: S::Boundary) -> usize {
        self.of_face(store, store.face(b))
    }

    /// By group the index of the boundary component that is its outer one, or nil, once each cycle has a boundary component, which
    /// still names a face of its group. O(slots α(slots)).
    pub(super) fn outer<S: Store>(&self, store: &S) -> Vec<u32> {
        let index = |h: S::HalfEdge| store.boundary_index(store.boundary(h)) as u32;
        // The components, as sets of boundary components.
        let mut components = Sets::new(store.boundary_slots());
        for h in (0..store.half_edge_slots()).filter_map(|i| store.half_edge_at(i)) {
            let twin = store.twin(h);
            if store.half_edge_index(h) < store.half_edge_index(twin) {
                components.join(index(h), index(twin));
            }
        }
        // The nodes of the tree: the groups, then the components, by the number that stands for each. Of each, how many cycles are left,
        // and the exclusive or of their numbers: if one is left, that is its number.
        let mut left = vec![(0_u32, 0_u32); self.count + store.boundary_slots()];
        let mut take = |left: &mut [(u32, u32)], b: S::Boundary, by: u32| {
            let cycle = store.boundary_index(b) as u32;
            let ends = [self.of_boundary(store, b), self.count + components.find(cycle) as usize];
            for node in ends {
                left[node].0 = left[node].0.wrapping_add(by);
                left[node].1 ^= cycle;
            }
            ends
        };
        for b in (0..store.boundary_slots()).filter_map(|i| store.boundary_at(i)) {
            if matches!(store.start(b), BoundaryStart::HalfEdge(_)) {
                take(&mut left, b, 1);
            }
        }
        let mut outer = vec![NIL; self.count];
        for first in 1..left.len() {
            let mut node = first;
            while node != 0 && left[node].0 == 1 {
                let cycle = left[node].1;
                let Some(b) = store.boundary_at(cycle as usize) else { break };
                let [group, component] = take(&mut left, b, u32::MAX);
                if node == group {
                    outer[group] = cycle;
                    node = component;
                } else {
                    node = group;
                }
            }
        }
        outer
    }
}
