//! Finds the outer cycle of each face from the labels of the half-edges and the unbounded face.
//!
//! In a map, faces and components, joined by cycles, form a tree rooted at the unbounded face. The cycle that joins a face to its
//! parent component is its outer one.

use super::cycles::{Cycles, Groups};
use super::inverse::{filled, nils};
use crate::validate::columns::NIL;
use crate::validate::structure::Link;
use alloc::vec::Vec;

struct Search<'a> {
    cycles: &'a Cycles,
    by_component: Groups,
    /// By face: its outer cycle, once known.
    outer: Vec<u32>,
    face_reached: Vec<bool>,
    /// By the number of a cycle that represents the component.
    component_reached: Vec<bool>,
    /// Reached faces whose cycles are still to be followed.
    queue: Vec<u32>,
}

/// By face: the number of its outer cycle, or nil. `None` if memory runs out. O(n).
pub(super) fn outer_cycles(cycles: &Cycles, unbounded: Link) -> Option<Vec<u32>> {
    let count = cycles.start.len();
    let mut search = Search {
        cycles,
        by_component: Groups::of(&cycles.component, count)?,
        outer: nils(cycles.faces())?,
        face_reached: filled(cycles.faces(), false)?,
        component_reached: filled(count, false)?,
        queue: Vec::new(),
    };
    search.queue.try_reserve_exact(cycles.faces()).ok()?;
    if let Some(reached) = unbounded.and_then(|f| search.face_reached.get_mut(f)) {
        *reached = true;
        search.queue.extend(unbounded.map(|f| f as u32));
        search.follow();
    }
    let open = (0..count).filter(|c| cycles.face[*c] == NIL || cycles.unpaired[*c]);
    for c in open.chain(0..count) {
        search.enter(cycles.component[c]);
        search.follow();
    }
    Some(search.outer)
}

impl Search<'_> {
    fn follow(&mut self) {
        let cycles = self.cycles;
        while let Some(face) = self.queue.pop() {
            for c in cycles.of_face(face as usize) {
                if *c != self.outer[face as usize] {
                    self.enter(cycles.component[*c as usize]);
                }
            }
        }
    }

    /// Enters a component: its cycles are the outer ones of their faces, except its outside, whose face was reached before.
    fn enter(&mut self, component: u32) {
        if core::mem::replace(&mut self.component_reached[component as usize], true) {
            return;
        }
        for c in self.by_component.group(component as usize) {
            let face = self.cycles.face[*c as usize];
            if face != NIL && !core::mem::replace(&mut self.face_reached[face as usize], true) {
                self.outer[face as usize] = *c;
                self.queue.push(face);
            }
        }
    }
}
