//! Walks that operators share: two sides in step, and the search for the outside of a component.

use crate::dcel::structure::Dcel;
use crate::store::{BoundarySlot, BoundaryStart, FaceSlot, HalfEdgeSlot, LAST, OUTER, Store};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OneOfTwo {
    First,
    Second,
}

/// A queue of outer boundary components, linked through their places. Membership also marks a component as seen.
struct Queue {
    ends: Option<(BoundarySlot, BoundarySlot)>,
    current: Option<BoundarySlot>,
}

impl Queue {
    const fn new() -> Self {
        Self { ends: None, current: None }
    }

    fn offer(&mut self, store: &mut Store, b: BoundarySlot) {
        if store.place(b) != OUTER {
            return;
        }
        store.mark_place(b, LAST);
        match &mut self.ends {
            Some((_, last)) => {
                store.mark_place(*last, b.index() as u32);
                *last = b;
            }
            None => self.ends = Some((b, b)),
        }
    }

    fn take(&mut self, store: &Store) -> Option<BoundarySlot> {
        let next = match self.current {
            None => self.ends.map(|(first, _)| first),
            Some(b) => Self::after(store, b),
        };
        if next.is_some() {
            self.current = next;
        }
        next
    }

    fn after(store: &Store, b: BoundarySlot) -> Option<BoundarySlot> {
        match store.place(b) {
            LAST => None,
            index => store.boundary_at(index as usize),
        }
    }

    fn clear(self, store: &mut Store) {
        let mut at = self.ends.map(|(first, _)| first);
        while let Some(b) = at {
            at = Self::after(store, b);
            store.mark_place(b, OUTER);
        }
    }
}

/// A search through the faces of one part of a component: first along a stretch of the cut cycle, then along every outer
/// cycle met across it.
struct Search {
    at: Option<HalfEdgeSlot>,
    stop: HalfEdgeSlot,
    queue: Queue,
}

enum WalkStep {
    GoOn,
    FoundOutside,
    Exhausted,
}

impl Search {
    fn along(first: HalfEdgeSlot, stop: HalfEdgeSlot) -> Self {
        Self { at: (first != stop).then_some(first), stop, queue: Queue::new() }
    }

    fn step(&mut self, store: &mut Store) -> WalkStep {
        let Some(h) = self.at else {
            let Some(b) = self.queue.take(store) else { return WalkStep::Exhausted };
            if let BoundaryStart::HalfEdge(start) = store.start(b) {
                (self.at, self.stop) = (Some(start), start);
            }
            return WalkStep::GoOn;
        };
        let across = store.boundary(store.twin(h));
        if store.outer(store.face(across)) != Some(across) {
            return WalkStep::FoundOutside;
        }
        self.queue.offer(store, across);
        let next = store.next(h);
        self.at = (next != self.stop).then_some(next);
        WalkStep::GoOn
    }
}

impl Dcel {
    /// Walks along two stretches in step, each from its first half-edge to its last, and returns the shorter one, the second if
    /// they are equally long. A stretch without a first half-edge is empty.
    ///
    /// O(shorter).
    pub(super) fn shorter_or_second(
        &self,
        (mut first, first_last): (Option<HalfEdgeSlot>, HalfEdgeSlot),
        (mut second, second_last): (Option<HalfEdgeSlot>, HalfEdgeSlot),
    ) -> OneOfTwo {
        let step = |h: HalfEdgeSlot, last: HalfEdgeSlot| (h != last).then(|| self.store.next(h));
        loop {
            let Some(b) = second else { return OneOfTwo::Second };
            let Some(a) = first else { return OneOfTwo::First };
            second = step(b, second_last);
            first = step(a, first_last);
        }
    }

    /// Labels the half-edges from `first` to `last`.
    pub(super) fn relabel(&mut self, first: HalfEdgeSlot, last: HalfEdgeSlot, b: BoundarySlot) {
        let mut h = first;
        loop {
            self.store.set_boundary(h, b);
            if h == last {
                return;
            }
            h = self.store.next(h);
        }
    }

    /// Returns the part of a component that keeps the outside when an edge, with both sides `n` and `t` on one outer cycle,
    /// is removed: the part of the origin of `n` (first) or of its target (second).
    ///
    /// The outside belongs to the part from which an inner boundary component can be reached across edges. Both parts are
    /// searched in step, so the cost is O(size of the smaller part), and less if the outside is near. The queues use a field
    /// that is free in outer boundary components, so nothing is allocated.
    pub(super) fn part_with_outside(&mut self, n: HalfEdgeSlot, t: HalfEdgeSlot) -> OneOfTwo {
        let cut = self.store.boundary(n);
        // Both searches treat the cut cycle as seen.
        self.store.mark_place(cut, LAST);
        let mut origin = Search::along(self.store.next(t), n);
        let mut target = Search::along(self.store.next(n), t);
        let which = loop {
            match origin.step(&mut self.store) {
                WalkStep::GoOn => {}
                WalkStep::FoundOutside => break OneOfTwo::First,
                WalkStep::Exhausted => break OneOfTwo::Second,
            }
            match target.step(&mut self.store) {
                WalkStep::GoOn => {}
                WalkStep::FoundOutside => break OneOfTwo::Second,
                WalkStep::Exhausted => break OneOfTwo::First,
            }
        };
        origin.queue.clear(&mut self.store);
        target.queue.clear(&mut self.store);
        self.store.mark_place(cut, OUTER);
        which
    }

    /// Tells whether face `f` belongs to the component of the inner boundary component `b`, or to a component inside it.
    ///
    /// O(size of that component and of everything inside it), without allocating.
    pub(super) fn encloses(&mut self, b: BoundarySlot, f: FaceSlot) -> bool {
        let mut queue = Queue::new();
        self.offer_across(&mut queue, b);
        let mut found = false;
        while let Some(outer) = if found { None } else { queue.take(&self.store) } {
            let inside = self.store.face(outer);
            found = inside == f;
            self.offer_across(&mut queue, outer);
            let mut position = 0;
            while let Some(inner) = self.store.inner(inside, position) {
                self.offer_across(&mut queue, inner);
                position += 1;
            }
        }
        queue.clear(&mut self.store);
        found
    }

    fn offer_across(&mut self, queue: &mut Queue, b: BoundarySlot) {
        let BoundaryStart::HalfEdge(start) = self.store.start(b) else { return };
        let mut h = start;
        loop {
            let across = self.store.boundary(self.store.twin(h));
            if self.is_outer(across) {
                queue.offer(&mut self.store, across);
            }
            h = self.store.next(h);
            if h == start {
                return;
            }
        }
    }
}
