//! The chains of the runs: snapped, then bent until no edge visits the pixel of a foreign vertex.

use super::input::NodingError;
use super::pixel::{Pixel, Pixels, Segment};
use super::search::search;
use crate::threads;
use rustc_hash::{FxHashMap, FxHashSet};

pub(super) struct Chains {
    pool: Vec<u32>,
    /// The start of each chain in the pool, and the end of the last one.
    starts: Vec<usize>,
}

impl Chains {
    fn len(&self) -> usize {
        self.starts.len() - 1
    }

    fn get(&self, chain: usize) -> &[u32] {
        &self.pool[self.starts[chain]..self.starts[chain + 1]]
    }

    pub(super) fn all(&self) -> impl Iterator<Item = &[u32]> + Clone {
        (0..self.len()).map(|chain| self.get(chain))
    }

    /// Returns all steps of all chains from one vertex to the next.
    pub(super) fn edges(&self) -> impl Iterator<Item = [u32; 2]> {
        self.all().flat_map(edges)
    }

    /// Returns the vertices of all chains, chain after chain.
    pub(super) fn pool(&self) -> &[u32] {
        &self.pool
    }

    /// Returns the index of a vertex in the pool, on the chain of a run that visits it.
    pub(super) fn place(&self, chain: usize, run: &Segment, vertices: &[Pixel], vertex: u32) -> usize {
        let along = |v: u32| run.progress(vertices[v as usize]);
        match run.ends {
            [first, _] if vertex == first => self.starts[chain],
            [_, last] if vertex == last => self.starts[chain + 1] - 1,
            _ => self.starts[chain] + self.get(chain).partition_point(|&v| along(v) < along(vertex)),
        }
    }

    /// Makes the chains of segments through the vertices that they visit, in order.
    pub(super) fn through(segments: &[Segment], vertices: &[Pixel], mut visits: Vec<[u32; 2]>) -> Self {
        let place = |&[s, v]: &[u32; 2]| (s, segments[s as usize].progress(vertices[v as usize]), v);
        threads::sort_unstable_by(&mut visits, |a, b| place(a).cmp(&place(b)));
        let mut chains = Self {
            pool: Vec::with_capacity(2 * segments.len() + visits.len()),
            starts: Vec::with_capacity(segments.len() + 1),
        };
        let mut visits = visits.into_iter().peekable();
        for (id, segment) in segments.iter().enumerate() {
            chains.starts.push(chains.pool.len());
            chains.pool.push(segment.ends[0]);
            while let Some([_, v]) = visits.next_if(|&[s, _]| s as usize == id) {
                chains.pool.push(v);
            }
            chains.pool.push(segment.ends[1]);
        }
        chains.starts.push(chains.pool.len());
        chains
    }
}

/// Makes the chains of runs, and counts the rounds in which one was bent.
///
/// Adds the vertices where runs cross to `vertices`. Returns an error if there are too many cuts.
pub(super) fn snap(
    pixels: Pixels,
    runs: &[Segment],
    vertices: &mut Vec<Pixel>,
    cuts: usize,
) -> Result<(Chains, usize), NodingError> {
    let found = search(pixels, runs, vertices, cuts)?;
    let mut bends_left = cuts - found.visits.len();
    let chains = Chains::through(runs, vertices, found.visits);
    // All edges of a bent chain are new lines, which can visit pixels that the run did not visit. So can the only edge of a chain
    // without bends, if the ends of the run moved.
    let straight = found.doubtful.into_iter().map(|run| chains.get(run as usize)).filter(|chain| chain.len() == 2);
    let crooked = chains.all().filter(|chain| chain.len() > 2);
    let rounds = usize::from(crooked.clone().next().is_some());
    let mut seen = FxHashSet::default();
    let mut fresh: Vec<[u32; 2]> =
        straight.chain(crooked).flat_map(edges).map(sorted).filter(|&e| seen.insert(e)).collect();
    // The chain of each bent edge, by its ends.
    let mut bends: FxHashMap<[u32; 2], Vec<u32>> = FxHashMap::default();
    let hot = vertices.len();
    while !fresh.is_empty() {
        let segments: Vec<Segment> = fresh.iter().map(|&edge| Segment::between(vertices, edge)).collect();
        let found = search(Pixels::ONE_STEP, &segments, vertices, bends_left)
            .map_err(|error| match error {
                NodingError::TooManyCuts { .. } => NodingError::TooManyCuts { allowed: cuts },
                other => other,
            })?
            .visits;
        bends_left -= found.len();
        debug_assert_eq!(hot, vertices.len(), "snapped edges do not cross");
        let pieces = Chains::through(&segments, vertices, found);
        fresh.clear();
        for (segment, chain) in segments.iter().zip(pieces.all()).filter(|(_, chain)| chain.len() > 2) {
            let mut chain = chain.to_vec();
            fresh.extend(edges(&chain).map(sorted).filter(|&e| seen.insert(e)));
            if segment.ends[0] > segment.ends[1] {
                chain.reverse();
            }
            bends.insert(sorted(segment.ends), chain);
        }
    }
    if bends.is_empty() {
        return Ok((chains, rounds));
    }
    let (chains, depth) = bend(&chains, &bends);
    Ok((chains, rounds + depth))
}

/// Replaces each bent edge by its chain, recursively. Also returns the depth of the recursion.
fn bend(chains: &Chains, bends: &FxHashMap<[u32; 2], Vec<u32>>) -> (Chains, usize) {
    let mut bent =
        Chains { pool: Vec::with_capacity(chains.pool.len()), starts: Vec::with_capacity(chains.starts.len()) };
    let mut deepest = 0;
    // The remaining vertices, the next one last, with the number of bends behind the edge to each.
    let mut ahead: Vec<(u32, usize)> = Vec::new();
    for chain in chains.all() {
        bent.starts.push(bent.pool.len());
        ahead.extend(chain.iter().rev().map(|&v| (v, 0)));
        while let Some((from, _)) = ahead.pop() {
            while let Some((to, depth)) = ahead.last_mut() {
                let forwards = from < *to;
                let Some(pieces) = bends.get(&sorted([from, *to])) else {
                    break;
                };
                *depth += 1;
                let depth = *depth;
                deepest = deepest.max(depth);
                let inner = pieces[1..pieces.len() - 1].iter().map(|&v| (v, depth));
                if forwards {
                    ahead.extend(inner.rev());
                } else {
                    ahead.extend(inner);
                }
            }
            bent.pool.push(from);
        }
    }
    bent.starts.push(bent.pool.len());
    (bent, deepest)
}

fn edges(chain: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    chain.windows(2).map(|pair| [pair[0], pair[1]])
}

pub(super) fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
