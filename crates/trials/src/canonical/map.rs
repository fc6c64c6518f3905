//! A view's half-edges, numbered without gaps, with their cycles and components; and the search for the least code of a connected
//! map.

use twinedge::validate::View;

/// No number.
pub(super) const NIL: u32 = u32::MAX;

pub(super) fn fill<T: Clone>(column: &mut Vec<T>, len: usize, value: T) -> Option<()> {
    column.clear();
    column.try_reserve(len).ok()?;
    column.resize(len, value);
    Some(())
}

/// The half-edges of a view, numbered without gaps. Every column is indexed by these numbers.
#[derive(Debug, Default)]
pub(super) struct Map {
    /// The number of each half-edge, by index in the view.
    numbers: Vec<u32>,
    pub(super) next: Vec<u32>,
    pub(super) twin: Vec<u32>,
    pub(super) cycle: Vec<u32>,
    pub(super) component: Vec<u32>,
    pub(super) cycles: Vec<u32>,
    components: usize,
    stack: Vec<u32>,
    /// True for vertices with half-edges and for isolated vertices seen so far, by index in the view.
    busy: Vec<bool>,
}

impl Map {
    /// Reads a view; `None` unless `twin` pairs its half-edges and `next` permutes them. O(slots).
    pub(super) fn read<V: View + ?Sized>(&mut self, view: &V) -> Option<()> {
        let slots = view.half_edge_slots();
        u32::try_from(slots).ok().filter(|slots| *slots < NIL)?;
        fill(&mut self.numbers, slots, NIL)?;
        let mut count = 0;
        for (h, number) in self.numbers.iter_mut().enumerate() {
            if view.is_half_edge(h) {
                *number = count;
                count += 1;
            }
        }
        fill(&mut self.next, count as usize, NIL)?;
        fill(&mut self.twin, count as usize, NIL)?;
        for h in 0..slots {
            let number = self.numbers[h];
            if number != NIL {
                self.next[number as usize] = self.dense(view.next(h)?)?;
                self.twin[number as usize] = self.dense(view.twin(h)?)?;
            }
        }
        self.check_twins()?;
        self.trace_cycles()?;
        self.trace_components()
    }

    pub(super) fn len(&self) -> usize {
        self.next.len()
    }

    pub(super) const fn components(&self) -> usize {
        self.components
    }

    pub(super) fn dense(&self, index: usize) -> Option<u32> {
        self.numbers.get(index).copied().filter(|number| *number != NIL)
    }

    /// Marks the origins of all half-edges; `None` if a half-edge has no origin. O(slots).
    pub(super) fn mark_busy<V: View + ?Sized>(&mut self, view: &V) -> Option<()> {
        u32::try_from(view.vertex_slots()).ok()?;
        fill(&mut self.busy, view.vertex_slots(), false)?;
        for h in (0..self.numbers.len()).filter(|h| self.numbers[*h] != NIL) {
            *self.busy.get_mut(view.origin(h)?)? = true;
        }
        Some(())
    }

    pub(super) fn mark_isolated(&mut self, vertex: usize) -> Option<()> {
        (!std::mem::replace(self.busy.get_mut(vertex)?, true)).then_some(())
    }

    pub(super) fn all_busy<V: View + ?Sized>(&self, view: &V) -> bool {
        self.busy.iter().enumerate().all(|(v, busy)| *busy || !view.is_vertex(v))
    }

    fn check_twins(&self) -> Option<()> {
        let paired = |(h, t): (usize, &u32)| self.twin[*t as usize] as usize == h && *t as usize != h;
        self.twin.iter().enumerate().all(paired).then_some(())
    }

    fn trace_cycles(&mut self) -> Option<()> {
        fill(&mut self.cycle, self.next.len(), NIL)?;
        self.cycles.clear();
        for start in 0..self.next.len() as u32 {
            if self.cycle[start as usize] != NIL {
                continue;
            }
            let mut h = start;
            while self.cycle[h as usize] == NIL {
                self.cycle[h as usize] = self.cycles.len() as u32;
                h = self.next[h as usize];
            }
            if h != start {
                return None;
            }
            self.cycles.push(start);
        }
        Some(())
    }

    fn trace_components(&mut self) -> Option<()> {
        fill(&mut self.component, self.next.len(), NIL)?;
        self.components = 0;
        for start in 0..self.next.len() as u32 {
            if self.component[start as usize] != NIL {
                continue;
            }
            self.component[start as usize] = self.components as u32;
            self.stack.push(start);
            while let Some(h) = self.stack.pop() {
                for other in [self.next[h as usize], self.twin[h as usize]] {
                    if self.component[other as usize] == NIL {
                        self.component[other as usize] = self.components as u32;
                        self.stack.push(other);
                    }
                }
            }
            self.components += 1;
        }
        Some(())
    }
}

#[derive(Debug, Default)]
pub(super) struct Search {
    /// The number of each half-edge met so far from the current root.
    numbers: Vec<u32>,
    order: Vec<u32>,
    candidate: Vec<u32>,
    least: Vec<u32>,
    ties: usize,
}

impl Search {
    pub(super) fn begin(&mut self, half_edges: usize) {
        // `offer` resets the numbers that it has set, so all of them are NIL.
        self.numbers.resize(half_edges, NIL);
        self.least.clear();
        self.ties = 0;
    }

    pub(super) fn least(&self) -> &[u32] {
        &self.least
    }

    /// The number of roots with the least code: the number of automorphisms, since only the identity fixes a half-edge.
    pub(super) const fn ties(&self) -> usize {
        self.ties
    }

    /// Tries another root of the same component. `note` adds words to the code of each cycle, after its length; it must be
    /// self-delimiting.
    pub(super) fn offer<'a>(&mut self, map: &Map, root: u32, note: impl Fn(u32) -> &'a [u32]) {
        self.candidate.clear();
        let smaller = self.write(map, root, note);
        for h in self.order.drain(..) {
            self.numbers[h as usize] = NIL;
        }
        match smaller {
            Some(true) => {
                std::mem::swap(&mut self.candidate, &mut self.least);
                self.ties = 1;
            }
            Some(false) => self.ties += 1,
            None => {}
        }
    }

    /// Returns whether the code is smaller than the least so far (`false` if equal); `None` as soon as it is known to be greater.
    fn write<'a>(&mut self, map: &Map, root: u32, note: impl Fn(u32) -> &'a [u32]) -> Option<bool> {
        // The first root has nothing to be compared with.
        let mut smaller = self.least.is_empty();
        self.write_cycle(map, root, &note, &mut smaller)?;
        let mut done = 0;
        while let Some(h) = self.order.get(done).copied() {
            let twin = map.twin[h as usize];
            let number = self.numbers[twin as usize];
            if number == NIL {
                self.push(self.order.len() as u32, &mut smaller)?;
                self.write_cycle(map, twin, &note, &mut smaller)?;
            } else {
                self.push(number, &mut smaller)?;
            }
            done += 1;
        }
        Some(smaller)
    }

    fn write_cycle<'a>(
        &mut self,
        map: &Map,
        first: u32,
        note: &impl Fn(u32) -> &'a [u32],
        smaller: &mut bool,
    ) -> Option<()> {
        let before = self.order.len();
        let mut h = first;
        loop {
            self.numbers[h as usize] = self.order.len() as u32;
            self.order.push(h);
            h = map.next[h as usize];
            if h == first {
                break;
            }
        }
        self.push((self.order.len() - before) as u32, smaller)?;
        note(first).iter().try_for_each(|number| self.push(*number, smaller))
    }

    fn push(&mut self, number: u32, smaller: &mut bool) -> Option<()> {
        if !*smaller {
            match self.least.get(self.candidate.len()) {
                Some(least) if number > *least => return None,
                Some(least) if number == *least => {}
                _ => *smaller = true,
            }
        }
        self.candidate.push(number);
        Some(())
    }
}
