//! The outer cycle of each face, found from the labels of the half-edges and the unbounded face.
//!
//! Faces and components, joined by cycles, are a tree where the structure is a map. It hangs from the unbounded face, and the
//! cycle that joins a face to the component above it is its outer one.

use super::cycles::{Cycles, Groups};
use super::inverse::{filled, nils};
use crate::validate::columns::NIL;
use crate::validate::structure::Link;
use alloc::vec::Vec;

/// The search through faces and components.
struct Search<'a> {
    cycles: &'a Cycles,
    by_component: Groups,
    /// Per face its outer cycle, as far as it is known.
    outer: Vec<u32>,
    face_reached: Vec<bool>,
    /// By the number of a cycle that stands for it.
    component_reached: Vec<bool>,
    /// Faces whose cycles are still to be followed.
    queue: Vec<u32>,
}

/// Per face the number of its outer cycle, or nil. O(n). None if there is no memory for them.
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
    /// Follows the cycles of the faces that were reached, until no more are.
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

    /// Enters a component: its cycles are the outer ones of their faces. The one through which it is entered, its outside, is not,
    /// because the face of that has been reached.
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
