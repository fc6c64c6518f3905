//! Random rotation systems: the order of half-edges around each vertex.

use crate::random::Random;

/// A half-edge that is in no rotation yet.
const NOWHERE: usize = usize::MAX;

/// A rotation system of several components. `h ^ 1` is the twin of `h`.
#[derive(Clone, Debug, Default)]
pub(super) struct Rotations {
    /// The next half-edge with the same origin, clockwise.
    turn: Vec<usize>,
    back: Vec<usize>,
    pub(super) origin: Vec<usize>,
    pub(super) component: Vec<usize>,
    pub(super) components: usize,
}

impl Rotations {
    /// Adds a component with this many edges: an isolated vertex for none.
    ///
    /// Each edge leads to a new vertex, or from a corner to another one of the same cycle. With handles, it may lead to any
    /// corner of the component, which raises the genus if that is on another cycle.
    pub(super) fn add_component(&mut self, edges: usize, handles: bool, random: &mut Random) {
        let first_vertex = self.component.len();
        let first = self.turn.len();
        self.add_vertex();
        for edge in 0..edges {
            let (a, b) = (self.turn.len(), self.turn.len() + 1);
            self.turn.extend([NOWHERE; 2]);
            self.back.extend([NOWHERE; 2]);
            self.origin.extend([NOWHERE; 2]);
            let to_new_vertex = random.below(2) == 0;
            if edge == 0 {
                self.put_alone(a, first_vertex);
            } else {
                self.put_before(a, first + random.below(a - first));
            }
            if to_new_vertex {
                let vertex = self.add_vertex();
                self.put_alone(b, vertex);
            } else {
                let corner = if handles && random.below(2) == 0 {
                    first + random.below(a - first + 1)
                } else {
                    self.on_cycle_with(a, random)
                };
                self.put_before(b, corner);
            }
        }
        self.components += 1;
    }

    fn add_vertex(&mut self) -> usize {
        self.component.push(self.components);
        self.component.len() - 1
    }

    fn put_alone(&mut self, h: usize, vertex: usize) {
        (self.turn[h], self.back[h], self.origin[h]) = (h, h, vertex);
    }

    fn put_before(&mut self, h: usize, other: usize) {
        let before = self.back[other];
        (self.turn[h], self.back[h], self.origin[h]) = (other, before, self.origin[other]);
        self.turn[before] = h;
        self.back[other] = h;
    }

    /// Returns a half-edge with the corner before it on the cycle of the corners next to `a`, whose twin has no rotation yet.
    fn on_cycle_with(&self, a: usize, random: &mut Random) -> usize {
        let mut corners = vec![a];
        let mut h = self.turn[a];
        while h != a {
            corners.push(h);
            h = self.turn[h ^ 1];
        }
        corners[random.below(corners.len())]
    }

    pub(super) fn next(&self, h: usize) -> usize {
        self.turn[h ^ 1]
    }

    pub(super) fn cycles(&self) -> Vec<Vec<usize>> {
        let mut seen = vec![false; self.turn.len()];
        let mut cycles = Vec::new();
        for first in 0..self.turn.len() {
            let mut cycle = Vec::new();
            let mut h = first;
            while !seen[h] {
                seen[h] = true;
                cycle.push(h);
                h = self.next(h);
            }
            if !cycle.is_empty() {
                cycles.push(cycle);
            }
        }
        cycles
    }
}
