//! Random rotation systems with random containment, as tables.

use crate::random::Random;
use twinedge::validate::{BoundaryPlace, BoundaryRow, FaceRow, HalfEdgeRow, Start, Table, VertexRow};

/// Returns a random table, usually a planar subdivision. In some of them a component has handles (T3), lies in a face that lies
/// in that component (T2), has no outside or two (T1), or two vertices are merged (V2).
pub(super) fn subdivision(random: &mut Random) -> Table {
    let mut rotations = Rotations::default();
    let most = 1 + random.below(10);
    for _ in 0..random.below(5) {
        let handles = random.below(8) == 0;
        rotations.add_component(random.below(most), handles, random);
    }
    let mut plan = Plan::new(&rotations, random);
    if random.below(12) == 0 {
        plan.weld(random);
    }
    plan.table(random)
}

/// A boundary component, before a face lists it.
struct Boundary {
    component: usize,
    /// Its half-edges; empty for an isolated vertex.
    cycle: Vec<usize>,
    start: Start,
    is_inner: bool,
    /// The face that it bounds. Face 0 is the unbounded one.
    face: usize,
}

struct Plan<'a> {
    rotations: &'a Rotations,
    origin: Vec<usize>,
    vertices: usize,
    boundaries: Vec<Boundary>,
    faces: usize,
}

impl<'a> Plan<'a> {
    fn new(rotations: &'a Rotations, random: &mut Random) -> Self {
        let mut boundaries: Vec<Boundary> = Vec::new();
        for cycle in rotations.cycles() {
            let component = rotations.component[rotations.origin[cycle[0]]];
            let start = Start::HalfEdge(cycle[random.below(cycle.len())]);
            boundaries.push(Boundary { component, cycle, start, is_inner: false, face: 0 });
        }
        for (vertex, component) in rotations.component.iter().enumerate() {
            if !rotations.origin.contains(&vertex) {
                let start = Start::Vertex(vertex);
                boundaries.push(Boundary { component: *component, cycle: Vec::new(), start, is_inner: true, face: 0 });
            }
        }
        let (origin, vertices) = (rotations.origin.clone(), rotations.component.len());
        let mut plan = Self { rotations, origin, vertices, boundaries, faces: 1 };
        plan.choose_outsides(random);
        plan.choose_faces(random);
        plan
    }

    /// Makes one cycle of each component its outside. Sometimes there is none, or two.
    fn choose_outsides(&mut self, random: &mut Random) {
        for component in 0..self.rotations.components {
            let of_it = |boundary: &Boundary| boundary.component == component && !boundary.is_inner;
            let cycles: Vec<usize> = (0..self.boundaries.len()).filter(|b| of_it(&self.boundaries[*b])).collect();
            let outsides = match random.below(40) {
                0 => 0,
                1 => 2,
                _ => 1,
            };
            for _ in 0..if cycles.is_empty() { 0 } else { outsides } {
                self.boundaries[cycles[random.below(cycles.len())]].is_inner = true;
            }
        }
    }

    /// Gives each outer cycle a face of its own. Each component lies in a face of the earlier ones; sometimes in any face.
    fn choose_faces(&mut self, random: &mut Random) {
        for boundary in self.boundaries.iter_mut().filter(|boundary| !boundary.is_inner) {
            boundary.face = self.faces;
            self.faces += 1;
        }
        let anywhere = random.below(8) == 0;
        for b in 0..self.boundaries.len() {
            let component = self.boundaries[b].component;
            let bounded = self.boundaries.iter().filter(|other| !other.is_inner);
            let faces = bounded.filter(|other| anywhere || other.component < component).map(|other| other.face);
            let faces: Vec<usize> = std::iter::once(0).chain(faces).collect();
            if self.boundaries[b].is_inner {
                self.boundaries[b].face = faces[random.below(faces.len())];
            }
        }
    }

    /// Merges two vertices that have half-edges.
    fn weld(&mut self, random: &mut Random) {
        let Some(last) = self.origin.len().checked_sub(1) else { return };
        let (kept, other) = (self.origin[random.below(last + 1)], self.origin[random.below(last + 1)]);
        if kept != other {
            for origin in &mut self.origin {
                *origin = if *origin == other { kept } else { *origin };
            }
        }
    }

    /// Returns the table: slots in random order, some of them vacant, lists in random order.
    fn table(&self, random: &mut Random) -> Table {
        let half_edges = slots(self.origin.len(), random);
        let vertices = slots(self.vertices, random);
        let boundaries = slots(self.boundaries.len(), random);
        let faces = slots(self.faces, random);
        let mut table = Table {
            vertices: vec![None; vertices.count],
            half_edges: vec![None; half_edges.count],
            boundaries: vec![None; boundaries.count],
            faces: vec![None; faces.count],
            ..Table::default()
        };
        for f in &faces.of {
            table.faces[*f] = Some(FaceRow::default());
        }
        for (h, origin) in self.origin.iter().enumerate() {
            let row = HalfEdgeRow {
                origin: Some(vertices.of[*origin]),
                twin: Some(half_edges.of[h ^ 1]),
                next: Some(half_edges.of[self.rotations.next(h)]),
                ..HalfEdgeRow::default()
            };
            table.half_edges[half_edges.of[h]] = Some(row);
        }
        for h in 0..self.origin.len() {
            let next = half_edges.of[self.rotations.next(h)];
            if let Some(row) = &mut table.half_edges[next] {
                row.prev = Some(half_edges.of[h]);
            }
            // The last one wins, and can be any of them, as the slots are in random order.
            let slot = vertices.of[self.origin[h]];
            table.vertices[slot] = Some(VertexRow { leaving: Some(half_edges.of[h]), isolated: None });
        }
        let mut order: Vec<usize> = (0..self.boundaries.len()).collect();
        shuffle(&mut order, random);
        for b in order {
            let (boundary, slot) = (&self.boundaries[b], boundaries.of[b]);
            for h in &boundary.cycle {
                if let Some(row) = &mut table.half_edges[half_edges.of[*h]] {
                    row.boundary = Some(slot);
                }
            }
            let start = match boundary.start {
                Start::HalfEdge(h) => Start::HalfEdge(half_edges.of[h]),
                Start::Vertex(v) => {
                    table.vertices[vertices.of[v]] = Some(VertexRow { leaving: None, isolated: Some(slot) });
                    Start::Vertex(vertices.of[v])
                }
            };
            let face = faces.of[boundary.face];
            let Some(row) = &mut table.faces[face] else { continue };
            let place = if boundary.is_inner {
                row.inner.push(Some(slot));
                BoundaryPlace::Inner(row.inner.len() - 1)
            } else {
                row.outer = Some(slot);
                BoundaryPlace::Outer
            };
            table.boundaries[slot] = Some(BoundaryRow { face: Some(face), start: Some(start), place: Some(place) });
        }
        table
    }
}

/// The slot of each record, and the number of slots.
struct Slots {
    of: Vec<usize>,
    count: usize,
}

/// Returns slots in random order for this many records, up to two of them vacant.
fn slots(records: usize, random: &mut Random) -> Slots {
    let count = records + random.below(6).saturating_sub(3);
    let mut of: Vec<usize> = (0..count).collect();
    shuffle(&mut of, random);
    of.truncate(records);
    Slots { of, count }
}

pub(super) fn shuffle<T>(items: &mut [T], random: &mut Random) {
    for i in (1..items.len()).rev() {
        items.swap(i, random.below(i + 1));
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;
    use twinedge::validate::reference::first_broken_rule;
    use twinedge::validate::{Expectation, Rule};

    #[test]
    fn most_are_planar_subdivisions_and_the_others_break_the_rules_that_are_meant() {
        let mut found: BTreeMap<Option<Rule>, usize> = BTreeMap::new();
        for stream in 0..3_000 {
            let table = subdivision(&mut Random::new(1, stream));
            *found.entry(first_broken_rule(&table, &Expectation::plane())).or_default() += 1;
        }
        let rules: Vec<Option<Rule>> = found.keys().copied().collect();
        assert_eq!(rules, [None, Some(Rule::V2), Some(Rule::T1), Some(Rule::T2), Some(Rule::T3)]);
        assert!(found[&None] > 1_500 && found.values().all(|count| *count > 30), "{found:?}");
    }
}
