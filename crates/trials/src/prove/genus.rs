//! Accepted rotation systems by genus, from all permutations.

use crate::run::Run;
use twinedge::validate::{Collect, Expectation, Link, Part, Parts, View, validate};

/// The largest number of edges for which all permutations are tried: 10! of them.
pub(super) const MOST_EDGES: usize = 5;

/// Returns, for maps of `edges` edges with labelled half-edges, the number that the validator accepts by genus in this part of
/// the work, and the number that it rejects, which should be 0.
///
/// With fixed twins, every permutation of the half-edges is the `next` of a map on closed surfaces. If the validator accepts it
/// and finds one component, it counts for the genus that the validator finds.
pub(super) fn labelled(edges: usize, run: &Run<'_>) -> (Vec<u64>, u64) {
    if edges == 0 {
        // One vertex.
        return (if run.part().has(0) { vec![1] } else { vec![] }, 0);
    }
    let half_edges = 2 * edges as u8;
    let beginnings = beginnings(half_edges);
    let numbers: Vec<usize> = run.part().numbers(beginnings.len()).collect();
    let stage = format!("rotation systems of {edges} edges");
    let found = run.each(
        &stage,
        numbers.len(),
        || (Vec::new(), 0),
        |(by_genus, refused), number| {
            for_each(half_edges, &beginnings[numbers[number]], |map| judge(map, by_genus, refused));
        },
    );
    let mut sum = Vec::new();
    let mut refused = 0;
    for (by_genus, more_refused) in found {
        add(&mut sum, &by_genus);
        refused += more_refused;
    }
    (sum, refused)
}

pub(super) fn add(sum: &mut Vec<u64>, by_genus: &[u64]) {
    sum.resize(sum.len().max(by_genus.len()), 0);
    sum.iter_mut().zip(by_genus).for_each(|(sum, count)| *sum += count);
}

/// Returns the numbers of rooted maps for numbers of labelled ones. A rooted map has no symmetry, so it has 2ⁿ⁻¹ (n − 1)!
/// labellings.
pub(super) fn rooted(edges: usize, labelled: &[u64]) -> Vec<u64> {
    let names: u64 = (1..edges as u64).map(|i| 2 * i).product();
    // A number that is not divisible is not a count of maps. Rounded up, it is no published one either.
    labelled.iter().map(|labelled| labelled.div_ceil(names)).collect()
}

fn judge(map: &CombinatorialMap, by_genus: &mut Vec<u64>, refused: &mut u64) {
    let report = validate(map, &Expectation::surface(), Collect::First);
    let counts = report.counts();
    match (report.is_valid(), counts.genus) {
        (true, Some(genus)) if counts.components == Some(1) => {
            by_genus.resize(by_genus.len().max(genus + 1), 0);
            by_genus[genus] += 1;
        }
        (true, Some(_)) => {}
        _ => *refused += 1,
    }
}

const MOST: usize = 10;

/// A map without faces: twins are 0 and 1, 2 and 3, …; `next` is any permutation; vertices follow from these.
#[derive(Clone, Copy, Debug)]
pub(super) struct CombinatorialMap {
    len: usize,
    next: [u8; MOST],
    prev: [u8; MOST],
    origin: [u8; MOST],
    leaving: [u8; MOST],
    vertices: usize,
}

impl CombinatorialMap {
    /// Returns the map with this `next`. `None` unless that is a permutation of at most 10 half-edges.
    fn new(next: &[u8]) -> Option<Self> {
        const NONE: u8 = u8::MAX;
        let len = next.len();
        let mut map = Self {
            len,
            next: [NONE; MOST],
            prev: [NONE; MOST],
            origin: [NONE; MOST],
            leaving: [NONE; MOST],
            vertices: 0,
        };
        map.next.get_mut(..len)?.copy_from_slice(next);
        for (h, n) in (0..).zip(next) {
            *map.prev.get_mut(..len)?.get_mut(usize::from(*n))? = h;
        }
        for start in 0..len {
            if map.origin[start] == NONE {
                let mut h = start;
                while map.origin[h] == NONE {
                    map.origin[h] = map.vertices as u8;
                    h = usize::from(map.next[h ^ 1]);
                }
                map.leaving[map.vertices] = start as u8;
                map.vertices += 1;
            }
        }
        map.prev[..len].iter().all(|p| *p != NONE).then_some(map)
    }

    pub(super) const fn len(&self) -> usize {
        self.len
    }

    pub(super) const fn vertices(&self) -> usize {
        self.vertices
    }

    pub(super) fn next_column(&self) -> &[u8] {
        &self.next[..self.len]
    }
}

impl View for CombinatorialMap {
    fn parts(&self) -> Parts {
        Parts::ALL.without(Part::Faces)
    }
    fn vertex_slots(&self) -> usize {
        self.vertices
    }
    fn half_edge_slots(&self) -> usize {
        self.len
    }
    fn origin(&self, half_edge: usize) -> Link {
        Some(self.origin[half_edge].into())
    }
    fn twin(&self, half_edge: usize) -> Link {
        Some(half_edge ^ 1)
    }
    fn next(&self, half_edge: usize) -> Link {
        Some(self.next[half_edge].into())
    }
    fn prev(&self, half_edge: usize) -> Link {
        Some(self.prev[half_edge].into())
    }
    fn leaving(&self, vertex: usize) -> Link {
        Some(self.leaving[vertex].into())
    }
}

/// Returns the possible beginnings of a permutation of this many half-edges. Each is one piece of the work.
pub(super) fn beginnings(half_edges: u8) -> Vec<Vec<u8>> {
    let firsts = 0..half_edges;
    firsts.flat_map(|a| (0..half_edges).filter(move |b| *b != a).map(move |b| vec![a, b])).collect()
}

/// Visits every map of this many half-edges whose `next` has this beginning, in lexicographic order.
pub(super) fn for_each(half_edges: u8, beginning: &[u8], mut visit: impl FnMut(&CombinatorialMap)) {
    let mut next = beginning.to_vec();
    next.extend((0..half_edges).filter(|h| !beginning.contains(h)));
    let fixed = beginning.len();
    loop {
        if let Some(map) = CombinatorialMap::new(&next) {
            visit(&map);
        }
        let rest = &mut next[fixed..];
        let Some(falls) = rest.windows(2).rposition(|pair| pair[0] < pair[1]) else { return };
        let above = rest.iter().rposition(|value| *value > rest[falls]).unwrap_or(falls);
        rest.swap(falls, above);
        rest[falls + 1..].reverse();
    }
}

#[cfg(test)]
mod tests {
    use super::{labelled, rooted};
    use crate::published::BY_GENUS;
    use crate::run::Run;

    #[test]
    fn rooted_maps_of_every_genus_are_as_many_as_published() {
        for (edges, published) in BY_GENUS.iter().enumerate().take(5) {
            let (labelled, refused) = labelled(edges, &Run::default());
            assert_eq!((rooted(edges, &labelled), refused), (published.to_vec(), 0), "{edges} edges");
        }
    }
}
