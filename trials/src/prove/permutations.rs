//! All permutations of a few half-edges. Each is the `next` of a map on some surface.

use twinedge::validate::{Link, Part, Parts, View};

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
