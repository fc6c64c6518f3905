//! The number of valid tables, counted map by map and without the validator.

use super::work::LazyWork;
use crate::published::{binomial, factorial};
use crate::rows::narrow;
use crate::tables::formulas::pairings;
use twinedge::validate::{Expectation, Part, Rule, Surface};

/// Returns the number of valid tables of this work: `None` for open structures and for lists of holes.
pub(super) fn right(work: &LazyWork) -> Option<u64> {
    let parts = work.parts();
    if work.expectation.is_open() || parts.has(Part::Holes) {
        return None;
    }
    let has_boundaries = parts.has(Part::BoundaryComponents);
    let [faces, boundaries] = [(work.faces, parts.has(Part::Faces)), (work.boundaries, has_boundaries)]
        .map(|(slots, is_there)| if is_there { slots } else { 0 });
    // Each number of live records, or each choice of live ones.
    let live = |slots: usize| if work.vacant { 0..=slots } else { slots..=slots };
    let chosen = |slots: usize, live: usize| binomial(slots as u128, live as u128);
    let mut right = 0;
    for half_edges in live(work.half_edges) {
        for map in Map::all(half_edges) {
            for v in live(work.vertices) {
                for f in live(faces) {
                    for b in live(boundaries) {
                        let slots = chosen(work.half_edges, half_edges)
                            * chosen(work.vertices, v)
                            * chosen(faces, f)
                            * chosen(boundaries, b);
                        right += slots * map.tables(work, [v, f, b]);
                    }
                }
            }
        }
    }
    Some(narrow(right))
}

/// A map on labelled half-edges, with 0 and 1, 2 and 3 … as twins: the lengths of its orbits.
struct Map {
    half_edges: usize,
    cycles: Vec<u128>,
    rotations: Vec<u128>,
    components: usize,
    simple: bool,
}

impl Map {
    /// Returns all of them: each permutation can be `next`.
    fn all(half_edges: usize) -> Vec<Self> {
        let mut all = Vec::new();
        if half_edges.is_multiple_of(2) {
            for_each_permutation(&mut (0..half_edges).collect::<Vec<_>>(), half_edges, &mut |next| {
                all.push(Self::new(next));
            });
        }
        all
    }

    fn new(next: &[usize]) -> Self {
        let around: Vec<usize> = (0..next.len()).map(|h| next[h ^ 1]).collect();
        let both = |start: usize, component: &mut Vec<usize>| {
            component.push(start);
            let mut done = 0;
            while let Some(h) = component.get(done).copied() {
                done += 1;
                for other in [h ^ 1, next[h]] {
                    if !component.contains(&other) {
                        component.push(other);
                    }
                }
            }
        };
        let mut components = 0;
        let mut seen = Vec::new();
        for h in 0..next.len() {
            if !seen.contains(&h) {
                components += 1;
                let mut component = Vec::new();
                both(h, &mut component);
                seen.extend(component);
            }
        }
        let simple = is_simple(&around);
        Self { half_edges: next.len(), cycles: orbits(next), rotations: orbits(&around), components, simple }
    }

    /// Returns the sum of the genera of its components, by Euler's formula.
    fn genus(&self) -> usize {
        (self.half_edges / 2 + 2 * self.components - self.rotations.len() - self.cycles.len()) / 2
    }

    /// Returns true if it meets the expectation on this many vertices. M4 and M8 always hold, since it is closed.
    fn is_asked_for(&self, expectation: &Expectation, vertices: usize) -> bool {
        let is_count = |rule, found| expectation.expected_count(rule).is_none_or(|expected| found == expected);
        let sides = expectation.expected_count(Rule::M3);
        (!expectation.asks_for(Rule::M1) || self.rotations.len() == vertices)
            && (!expectation.asks_for(Rule::M2) || self.simple)
            && sides.is_none_or(|sides| self.cycles.iter().all(|length| *length == sides as u128))
            && is_count(Rule::M5, self.components)
            && is_count(Rule::M6, 0)
            && is_count(Rule::M7, self.genus())
    }

    /// Returns the number of tables that keep it with these numbers of vertices, faces and boundary components.
    fn tables(&self, work: &LazyWork, [vertices, faces, boundaries]: [usize; 3]) -> u128 {
        let parts = work.parts();
        let (rotations, cycles) = (self.rotations.len(), self.cycles.len());
        if work.expectation.surface_kind() == Surface::Plane && self.genus() > 0
            || rotations > vertices
            || !self.is_asked_for(&work.expectation, vertices)
        {
            return 0;
        }
        // Every other pairing of twins is this one, renamed. The other vertices are isolated.
        let mut tables = pairings(self.half_edges as u128 / 2) * factorial(rotations as u128);
        tables *= binomial(vertices as u128, rotations as u128);
        if parts.has(Part::Leaving) {
            tables *= self.rotations.iter().product::<u128>();
        }
        if parts.has(Part::Faces) {
            // Each face starts at a half-edge of its cycle, or each boundary component does.
            tables *= if cycles == faces { factorial(faces as u128) * self.cycles.iter().product::<u128>() } else { 0 };
        }
        if parts.has(Part::BoundaryComponents) {
            tables *= if cycles == boundaries { factorial(boundaries as u128) } else { 0 };
        }
        tables
    }
}

/// Returns true if no edge is a loop and no two join the same vertices. After half-edge `h`, `around[h]` leaves the same vertex.
fn is_simple(around: &[usize]) -> bool {
    let origin = |h: usize| {
        let mut least = h;
        let mut at = around[h];
        while at != h {
            least = least.min(at);
            at = around[at];
        }
        least
    };
    let ends: Vec<_> = (0..around.len()).map(|h| (origin(h), origin(h ^ 1))).collect();
    // The two half-edges of a loop also have the same ends.
    (0..ends.len()).all(|h| !ends[..h].contains(&ends[h]))
}

fn orbits(permutation: &[usize]) -> Vec<u128> {
    let mut lengths = Vec::new();
    let mut seen = vec![false; permutation.len()];
    for start in 0..permutation.len() {
        let (mut x, mut length) = (start, 0);
        while !std::mem::replace(&mut seen[x], true) {
            length += 1;
            x = permutation[x];
        }
        lengths.extend((length > 0).then_some(length));
    }
    lengths
}

/// Calls `visit` with every order of the first elements.
fn for_each_permutation(order: &mut [usize], first: usize, visit: &mut impl FnMut(&[usize])) {
    if first <= 1 {
        return visit(order);
    }
    for i in 0..first {
        order.swap(i, first - 1);
        for_each_permutation(order, first - 1, visit);
        order.swap(i, first - 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::formulas;
    use twinedge::validate::Parts;

    fn work(expectation: Expectation, parts: Parts, [vertices, half_edges]: [usize; 2]) -> LazyWork {
        LazyWork {
            expectation,
            parts,
            vertices,
            half_edges,
            boundaries: 0,
            faces: 0,
            vacant: false,
            certificates: false,
        }
    }

    #[test]
    fn the_recount_is_that_of_the_formulas() {
        let leaving = Parts::NONE.with(Part::Leaving);
        for edges in 0..=3 {
            for vertices in 1..=3 {
                let size = [vertices, 2 * edges];
                let (e, v) = (edges as u128, vertices as u128);
                let bare = work(Expectation::surface(), Parts::NONE, size);
                assert_eq!(right(&bare).map(u128::from), Some(formulas::maps_with_vertices(e, v)));
                let kept = work(Expectation::surface(), leaving, size);
                let with_leaving = if edges == 0 { 1 } else { formulas::maps_with_leaving(e, v) };
                assert_eq!(right(&kept).map(u128::from), Some(with_leaving));
            }
        }
        assert_eq!(right(&work(Expectation::surface(), leaving, [2, 6])), Some(75_600));
        assert_eq!(right(&work(Expectation::plane(), leaving, [2, 6])), Some(44_640));
    }

    #[test]
    fn two_triangles_are_glued_in_as_many_ways_as_there_are_cubic_maps() {
        // Two cycles of three in 40 ways, and 15 pairings. By duality these are the rooted cubic maps with two vertices, with 5!
        // numberings of the other half-edges each: 4 in the plane (A002005) with the theta graph, 1 on the torus.
        let triangles = Expectation::surface().triangles().no_unused_vertices().closed();
        let count = |expectation, vertices| right(&work(expectation, Parts::NONE, [vertices, 6])).unwrap();
        let (sphere, torus) = (count(triangles, 3), count(triangles, 1));
        assert_eq!((sphere, torus), (4 * 120 * 6, 120));
        assert_eq!(sphere / 6 + torus, 40 * 15);
        assert_eq!(count(triangles.simple(), 3), 120 * 6);
        assert_eq!(count(triangles.genus(1), 1), 120);
        assert_eq!(
            [count(triangles.genus(1), 3), count(triangles.components(2), 3), count(triangles.borders(1), 3)],
            [0; 3]
        );
        assert_eq!(count(Expectation::plane().triangles(), 4), 4 * 120 * 24);
    }
}
