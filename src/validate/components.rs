//! V2, and the components on the way: one walk around every vertex.

use super::report::Halt;
use super::run::{NIL, Run, column};
use super::{Record, Rule, View, Violation};
use alloc::vec::Vec;

/// What a component is made of.
#[derive(Clone, Copy)]
pub(super) struct Component {
    /// Its first vertex, to name it by.
    pub(super) vertex: u32,
    pub(super) vertices: u32,
    /// Half-edges with and without a twin: the edges are half the former and all of the latter.
    pub(super) paired: u32,
    pub(super) unpaired: u32,
    pub(super) cycles: u32,
    /// Whether some half-edge lacks its twin or its face: its outside may be there.
    pub(super) open: bool,
    /// The face that lists its outside, once known.
    pub(super) lies_in: u32,
    pub(super) outside: Option<Record>,
}

impl Component {
    /// The component of this vertex, of which nothing else is known yet.
    pub(super) const fn at(vertex: u32) -> Self {
        Self { vertex, vertices: 0, paired: 0, unpaired: 0, cycles: 0, open: false, lies_in: NIL, outside: None }
    }

    pub(super) const fn edges(&self) -> usize {
        self.paired as usize / 2 + self.unpaired as usize
    }
}

/// The components of the whole map.
pub(super) struct Components {
    /// Per vertex the number of its component.
    pub(super) of: Vec<u32>,
    pub(super) all: Vec<Component>,
    /// Whether there is neither a loop nor a pair of parallel edges.
    pub(super) simple: bool,
}

impl<V: View + ?Sized> Run<'_, V> {
    /// Runs V2, and finds the components. Each vertex waits once, and the first to come goes first: by far the fewest
    /// cache misses where numbers follow places.
    pub(super) fn components(&mut self) -> Result<(), Halt> {
        let mut of = column(self.vertices, NIL)?;
        // The last vertex from which a vertex was seen as a neighbour: seen twice from one means parallel edges.
        let mut seen_from = column(self.vertices, NIL)?;
        let mut waiting: Vec<u32> = Vec::new();
        let mut served = 0;
        waiting.try_reserve_exact(self.vertices as usize).map_err(|_| Halt::OutOfMemory)?;
        let mut all: Vec<Component> = Vec::new();
        let mut simple = true;
        let open = self.expect.is_open();
        for first in 0..self.vertices {
            if of[first as usize] != NIL || !self.live_vertex(first) {
                continue;
            }
            let number = all.len() as u32;
            let mut component = Component::at(first);
            of[first as usize] = number;
            waiting.push(first);
            while let Some(v) = waiting.get(served).copied() {
                served += 1;
                component.vertices += 1;
                let mut neighbour = |u: u32| {
                    let Some(component) = of.get_mut(u as usize) else { return };
                    simple &= u != v && core::mem::replace(&mut seen_from[u as usize], v) != v;
                    if *component == NIL {
                        *component = number;
                        waiting.push(u);
                    }
                };
                let reached = self.around(v, |h, t| {
                    if t == NIL {
                        component.unpaired += 1;
                        neighbour(self.target_by_next(h));
                    } else {
                        component.paired += 1;
                        neighbour(self.origin(t));
                    }
                    // An edge without twin that ends at `v` is seen from there only as what comes before `h`.
                    if open
                        && let Some(before) = self.before(h)
                        && self.twin(before) == NIL
                    {
                        neighbour(self.origin(before));
                    }
                });
                let fan = self.fans[v as usize];
                if reached != fan.degree {
                    self.findings.add(Violation::SplitRotation {
                        vertex: v as usize,
                        half_edge: fan.leaving as usize,
                        reached: reached as usize,
                        degree: fan.degree as usize,
                    })?;
                }
            }
            component.open = component.unpaired > 0;
            all.try_reserve(1).map_err(|_| Halt::OutOfMemory)?;
            all.push(component);
        }
        self.findings.checked(Rule::V2, (self.counts.vertices - self.counts.isolated_vertices) as u64);
        self.components = Some(Components { of, all, simple });
        Ok(())
    }
}
