//! Loading saved cuts: points must be on the grid and chains must not turn back, so that following chains terminates.

use super::{Cuts, Found, Key, ROUNDS, Source, is_way, key};
use crate::tile::ends::{Ends, compare_edges, compare_points, unsigned};
use core::cmp::Ordering;
use thiserror::Error;
use twinedge_geometry::Point;

type Chains = Vec<(Ends, Vec<Point>)>;

/// The saved form of cuts: sorted, so that equal cuts have equal bytes.
#[derive(serde::Serialize, serde::Deserialize)]
pub(super) struct SavedCuts {
    source: Source,
    largest: f64,
    rounds: u32,
    crossings: Vec<Point>,
    chains: Chains,
    bends: Chains,
    fresh: Vec<Ends>,
    seen: Vec<Ends>,
}

/// The saved form of a tile's finds.
#[derive(serde::Deserialize)]
pub(super) struct SavedFound {
    source: Source,
    largest: f64,
    round: u32,
    crossings: Vec<Point>,
    chains: Chains,
    doubtful: Vec<Ends>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub(super) enum SavedError {
    #[error("the largest coordinate is out of range")]
    Largest,
    #[error("there are no such rounds")]
    Rounds,
    #[error("points, edges or chains of the cuts are out of order, or out of range")]
    Order,
}

impl From<Cuts> for SavedCuts {
    fn from(cuts: Cuts) -> Self {
        let ends = |key: Key| key.map(Point::of_hash_key);
        let chains = |of: rustc_hash::FxHashMap<Key, Vec<Point>>| {
            let mut all: Chains = of.into_iter().map(|(key, chain)| (ends(key), chain)).collect();
            all.sort_by(|a, b| compare_edges(&a.0, &b.0));
            all
        };
        let Cuts { source, largest, rounds, crossings, fresh, .. } = cuts;
        let mut seen: Vec<Ends> = cuts.seen.into_iter().map(ends).collect();
        seen.sort_by(compare_edges);
        Self { source, largest, rounds, crossings, chains: chains(cuts.chains), bends: chains(cuts.bends), fresh, seen }
    }
}

impl TryFrom<SavedCuts> for Cuts {
    type Error = SavedError;

    fn try_from(saved: SavedCuts) -> Result<Self, SavedError> {
        let SavedCuts { source, largest, rounds, crossings, chains, bends, fresh, seen } = saved;
        let none = Self::new(largest).map_err(|_| SavedError::Largest)?;
        let is_new = [chains.len(), bends.len(), crossings.len(), fresh.len(), seen.len()] == [0; 5];
        if rounds > ROUNDS && !fresh.is_empty() || rounds > ROUNDS + 1 || rounds == 0 && !is_new {
            return Err(SavedError::Rounds);
        }
        let is_chain = |(ends, chain): &(Ends, Vec<Point>), is_first: bool| {
            is_way(none.ends_of(ends, is_first), chain) && chain.iter().all(|p| none.is_centre(*p))
        };
        let edges = |of: &[Ends]| none.are_edges(of.iter(), false);
        let is_in_order = none.are_centres(&crossings)
            && [(&chains, true), (&bends, false)].into_iter().all(|(of, is_first)| {
                none.are_edges(of.iter().map(|(ends, _)| ends), is_first)
                    && of.iter().all(|one| is_chain(one, is_first))
            })
            && edges(&fresh)
            && edges(&seen);
        let seen = seen.iter().map(key).collect();
        let map = |of: Chains| of.into_iter().map(|(ends, chain)| (key(&ends), chain)).collect();
        let cuts = Self {
            rounds,
            is_complete: rounds > 0 && fresh.is_empty(),
            crossings,
            chains: map(chains),
            bends: map(bends),
            fresh,
            seen,
            ..none.with_source(source)
        };
        let is_known = cuts.fresh.iter().all(|ends| cuts.seen.contains(&key(ends)));
        if is_in_order && is_known { Ok(cuts) } else { Err(SavedError::Order) }
    }
}

impl TryFrom<SavedFound> for Found {
    type Error = SavedError;

    fn try_from(saved: SavedFound) -> Result<Self, SavedError> {
        let SavedFound { source, largest, round, crossings, chains, doubtful } = saved;
        let none = Cuts::new(largest).map_err(|_| SavedError::Largest)?;
        if round > 0 && !(crossings.is_empty() && doubtful.is_empty()) {
            return Err(SavedError::Rounds);
        }
        let is_in_order = none.are_centres(&crossings)
            && none.are_edges(chains.iter().map(|(ends, _)| ends), round == 0)
            && none.are_edges(doubtful.iter(), true)
            && chains.iter().all(|(_, chain)| chain.iter().all(|p| none.is_centre(*p)));
        let found = Self { source, largest, round, crossings, chains, doubtful };
        if is_in_order { Ok(found) } else { Err(SavedError::Order) }
    }
}

impl Cuts {
    /// Returns true if edges can be cut at a point.
    fn is_centre(&self, p: Point) -> bool {
        // Points are first checked to be in reach, since only such points can be snapped.
        let most = self.noding.snapped(Point::new(self.largest, self.largest)).x;
        let is_near = p.x.abs() <= most && p.y.abs() <= most;
        is_near && compare_points(self.noding.snapped(p), p).is_eq()
    }

    fn are_centres(&self, points: &[Point]) -> bool {
        points.windows(2).all(|pair| compare_points(pair[0], pair[1]).is_lt())
            && points.iter().all(|p| self.is_centre(*p))
    }

    /// Returns true if edges are in order and between valid points: of the input, or points where edges can be cut.
    fn are_edges<'e>(&self, edges: impl Iterator<Item = &'e Ends> + Clone, of_input: bool) -> bool {
        let is_of_input =
            |p: Point| p.x.abs().max(p.y.abs()) <= self.largest && compare_points(unsigned(p), p) == Ordering::Equal;
        let is_end = |p: &Point| if of_input { is_of_input(*p) } else { self.is_centre(*p) };
        edges.clone().zip(edges.clone().skip(1)).all(|(a, b)| compare_edges(a, b).is_lt())
            && edges.into_iter().all(|[a, b]| compare_points(*a, *b).is_lt() && is_end(a) && is_end(b))
    }
}
