//! The cuts of a map whose edges meet other than at vertices, found tile by tile.
//!
//! The whole map is cut by [snap rounding](twinedge_geometry::noding) on the finest grid of cells. Each edge becomes the chain of
//! the *hot* pixels that it visits, and the pieces of a chain are bent by the hot pixels that they visit in turn, until nothing
//! bends any more. A pixel is hot if an edge ends or crosses another one in it. So the tile of a pixel knows whether it is hot
//! and which edges visit it; the bends of an edge are known once both of its ends are.
//!
//! ```text
//!   round 0   each tile: hot pixels of crossings, and the edges that visit hot pixels          all tiles
//!      │      together: the chains of these edges
//!   round 1   each tile: the hot pixels that the pieces of these chains visit                  tiles with such pieces
//!      │      together: pieces that are bent, and what they become
//!    …        until no piece is bent
//! ```
//!
//! Both sides of a seam have the same pieces, made from one list. It has only cut edges: few, if borders meet at vertices.

use super::bounds::Bounds;
use super::ends::{Ends, compare_edges, compare_points, in_order};
use super::error::TileError;
use super::grid::{Grid, Tile};
use super::piece::{Piece, edges, of_tile};
use core::cmp::Ordering;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;
use twinedge::dcel::RecordKind;
use twinedge_geometry::Point;
use twinedge_geometry::noding::{NodingError, PartNoding};
use twinedge_map::{BuildError, usual_cuts};

#[cfg(feature = "serde")]
mod saved;

/// The greatest number of rounds: more would let a chain drift out of the tiles of its feature.
const ROUNDS: u32 = 60;

/// The margin around tiles in which they are given edges, in cells: more than half a cell for each round.
const MARGIN: f64 = 40.0;

/// A step reads a point up to an eighth of a cell off, and a pixel extends half a cell around its centre.
const REACH: f64 = 2.0;

/// Facts that identify a map, by name: for example the SHA-256 of a file, or the snapshot of a table and its filter.
pub type Source = BTreeMap<String, String>;

type Key = [(u64, u64); 2];

fn key(ends: &Ends) -> Key {
    ends.map(Point::hash_key)
}

/// The cuts of a map whose edges meet other than at vertices. Each tile cuts its pieces with them.
///
/// ```
/// use twinedge_coverage::Limits;
/// use twinedge_map::{Feature, Shape};
/// use twinedge_coverage::tile::{Cuts, Grid, Summary};
///
/// // Two squares that overlap, in four tiles.
/// let square = |x: f64| Shape::polygon([[x, x], [x + 2.0, x], [x + 2.0, x + 2.0], [x, x + 2.0]]);
/// let [one, other] = [0.0, 1.0].map(|x| Feature { shapes: vec![square(x)], ..Feature::default() });
/// let grid = Grid::new([0.0, 0.0], [3.0, 3.0], 2, 2)?;
/// // No coordinate is larger than 3.
/// let mut cuts = Cuts::new(3.0)?;
/// let pieces = [cuts.pieces(&grid, 0, &one)?, cuts.pieces(&grid, 1, &other)?].concat();
/// while !cuts.is_complete() {
///     let found = grid.tiles().map(|tile| cuts.search(&grid, tile, &pieces)).collect::<Result<Vec<_>, _>>()?;
///     cuts.take(found)?;
/// }
/// let tiles = grid.tiles().map(|tile| Summary::cut(&grid, tile, &pieces, &Limits::default(), &cuts));
/// let mut tiles = tiles.collect::<Result<Vec<_>, _>>()?.into_iter();
/// let first = tiles.next().unwrap();
/// let whole = tiles.try_fold(first, Summary::merge)?.finish()?;
/// assert_eq!(whole.counts.vertices, 10);
/// assert_eq!(whole.coverage.unwrap().findings[0].area, 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// With the feature `serde`, cuts can be saved and loaded between rounds; equal cuts have equal bytes.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "saved::SavedCuts", into = "saved::SavedCuts"))]
pub struct Cuts {
    source: Source,
    noding: PartNoding,
    largest: f64,
    rounds: u32,
    is_complete: bool,
    /// The hot pixels where edges cross but none ends, in order.
    crossings: Vec<Point>,
    /// The hot pixels along edges, in order from the smaller end, by the ends of the edges in the input.
    chains: FxHashMap<Key, Vec<Point>>,
    /// The hot pixels along pieces, by the ends of the pieces.
    bends: FxHashMap<Key, Vec<Point>>,
    /// The pieces not yet examined for bends.
    fresh: Vec<Ends>,
    seen: FxHashSet<Key>,
}

/// The cuts that a tile found in a round. With the feature `serde`, equal cuts are saved as equal bytes.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "saved::SavedFound"))]
pub struct Found {
    source: Source,
    /// The largest coordinate and the round of the search.
    largest: f64,
    round: u32,
    // All in order.
    crossings: Vec<Point>,
    chains: Vec<(Ends, Vec<Point>)>,
    doubtful: Vec<Ends>,
}

impl Cuts {
    /// Creates empty cuts for a map with coordinates up to `largest`.
    ///
    /// # Errors
    /// [`BuildError::OutOfReach`], if the number is not finite.
    pub fn new(largest: f64) -> Result<Self, BuildError> {
        let refused = || BuildError::OutOfReach { x: largest, y: largest };
        if !(0.0..f64::INFINITY).contains(&largest) {
            return Err(refused());
        }
        let noding = PartNoding::new(largest).map_err(|_| refused())?;
        Ok(Self {
            source: Source::new(),
            noding,
            largest,
            rounds: 0,
            is_complete: false,
            crossings: Vec::new(),
            chains: FxHashMap::default(),
            bends: FxHashMap::default(),
            fresh: Vec::new(),
            seen: FxHashSet::default(),
        })
    }

    /// Sets the source of the map. [`take`](Self::take) then refuses what was found in maps of other sources.
    #[must_use]
    pub fn with_source(self, source: Source) -> Self {
        Self { source, ..self }
    }

    /// Returns what the map was made of; nothing if it was not said.
    #[must_use]
    pub const fn source(&self) -> &Source {
        &self.source
    }

    /// Returns true if the search is finished.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// Returns true if there are no cuts.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.chains.is_empty() && self.bends.is_empty()
    }

    /// Returns the corners of a box around all edges and vertices that determine the cuts near a tile: around the tile, and around the
    /// edges of its `pieces`. It is infinite where the grid ends. O(points).
    #[must_use]
    pub fn window<'p>(&self, grid: &Grid, tile: Tile, pieces: impl IntoIterator<Item = &'p Piece>) -> [Point; 2] {
        let margin = 2.0 * self.margin();
        let near = grid.bounds(tile).grown(margin);
        let Bounds { mut low, mut high } = near;
        let all = pieces.into_iter().flat_map(Piece::chains).flat_map(|chain| edges(chain)).map(in_order);
        let is_near = |ends: &Ends| near.meets([ends[0], ends[1]]);
        for [a, b] in all.filter(is_near) {
            low = Point::new(low.x.min(a.x - margin), low.y.min(a.y.min(b.y) - margin));
            high = Point::new(high.x.max(b.x + margin), high.y.max(a.y.max(b.y) + margin));
        }
        [low, high]
    }

    /// Returns the distance from a tile up to which edges are given to it.
    pub(super) fn margin(&self) -> f64 {
        MARGIN * self.noding.cell()
    }

    /// Returns true if the tile has something to find in this round. O(pieces of the last round).
    #[must_use]
    pub fn concern(&self, grid: &Grid, tile: Tile) -> bool {
        self.rounds == 0 || self.fresh_near(&grid.bounds(tile)).next().is_some()
    }

    fn fresh_near(&self, bounds: &Bounds) -> impl Iterator<Item = &Ends> {
        let bounds = bounds.grown(self.noding.cell());
        self.fresh.iter().filter(move |ends| bounds.meets(**ends))
    }

    /// Finds the cuts of a tile in this round, from its [pieces](Self::pieces); pieces of other tiles have no effect. O(n log n + k) for k
    /// cuts.
    ///
    /// # Errors
    /// [`TileError::NoSuchTile`], [`TileError::OtherGrid`], and [`TileError::Build`] with [`BuildError::TooManyCuts`], or with [`BuildError::OutOfReach`]
    /// if a coordinate is larger than announced.
    pub fn search<'p>(
        &self,
        grid: &Grid,
        tile: Tile,
        pieces: impl IntoIterator<Item = &'p Piece>,
    ) -> Result<Found, TileError> {
        let of_tile = of_tile(grid, tile, pieces)?;
        let bounds = grid.bounds(tile);
        let near = bounds.grown(REACH * self.noding.cell());
        let chains: Vec<&Vec<Point>> = of_tile.into_iter().flat_map(Piece::chains).collect();
        let points = || chains.iter().copied().flatten().copied();
        self.check(points())?;
        let mut found = if self.rounds == 0 {
            let vertices: Vec<Point> = points().filter(|p| near.contains(*p)).collect();
            let segments = chains.iter().flat_map(|chain| edges(chain)).map(in_order);
            let segments: Vec<Ends> = segments.filter(|ends| near.meets(*ends)).collect();
            self.cuts_of(&segments, &vertices)?
        } else {
            let vertices = points().filter(|p| near.contains(*p)).map(|p| self.noding.snapped(p));
            let hot: Vec<Point> =
                vertices.chain(self.crossings.iter().copied()).filter(|p| near.contains(*p)).collect();
            let pieces: Vec<Ends> = self.fresh_near(&bounds).copied().collect();
            let bends = self.noding.bends(&pieces, &hot, usual_cuts(pieces.len())).map_err(refused)?;
            let chains = bends.into_iter().map(|(piece, chain)| (pieces[piece], chain)).collect();
            Found { chains, ..self.nothing() }
        };
        // Each pixel belongs to one tile.
        found.crossings.retain(|p| bounds.contains(*p));
        for (_, chain) in &mut found.chains {
            chain.retain(|p| bounds.contains(*p));
        }
        found.chains.retain(|(_, chain)| !chain.is_empty());
        found.crossings.sort_by(|a, b| compare_points(*a, *b));
        // Edges of several features are found once for each.
        found.chains.sort_by(|a, b| compare_edges(&a.0, &b.0));
        found.chains.dedup_by_key(|(ends, _)| *ends);
        found.doubtful.sort_by(compare_edges);
        found.doubtful.dedup();
        Ok(found)
    }

    fn nothing(&self) -> Found {
        let (source, largest, round) = (self.source.clone(), self.largest, self.rounds);
        Found { source, largest, round, crossings: Vec::new(), chains: Vec::new(), doubtful: Vec::new() }
    }

    fn cuts_of(&self, segments: &[Ends], vertices: &[Point]) -> Result<Found, TileError> {
        let found = self.noding.cuts(segments, vertices, usual_cuts(segments.len())).map_err(refused)?;
        Ok(Found {
            crossings: found.crossings,
            chains: found.chains.into_iter().map(|(segment, chain)| (segments[segment], chain)).collect(),
            doubtful: found.doubtful.into_iter().map(|segment| segments[segment]).collect(),
            ..self.nothing()
        })
    }

    /// Adds the finds of all tiles in a round, and ends the round. A tile's finds may be repeated. O(n log n) for the finds.
    ///
    /// # Errors
    /// [`TileError::OtherCuts`], with nothing added; [`TileError::Build`] with [`BuildError::TooManyCuts`], if edges bend so
    /// often that they drift out of their tiles.
    pub fn take(&mut self, found: impl IntoIterator<Item = Found>) -> Result<(), TileError> {
        let mut of_round: FxHashMap<Key, (Ends, Vec<Point>)> = FxHashMap::default();
        let (mut crossings, mut doubtful) = (Vec::new(), Vec::new());
        for mut one in found {
            let is_here = one.round == self.rounds && one.largest.to_bits() == self.largest.to_bits();
            if self.is_complete || !is_here || one.source != self.source {
                return Err(TileError::OtherCuts);
            }
            crossings.append(&mut one.crossings);
            doubtful.append(&mut one.doubtful);
            for (ends, mut chain) in one.chains {
                of_round.entry(key(&ends)).or_insert_with(|| (ends, Vec::new())).1.append(&mut chain);
            }
        }
        let is_first = self.rounds == 0;
        for (ends, chain) in of_round.values_mut() {
            let ends = self.ends_of(ends, is_first);
            // Chains never turn back, in x or in y.
            let way = |p: &Point| (p.x - ends[0].x).abs() + (p.y - ends[0].y).abs();
            chain.sort_by(|a, b| way(a).total_cmp(&way(b)));
            chain.dedup();
            if !is_way(ends, chain) {
                return Err(TileError::OtherCuts);
            }
        }
        self.crossings.append(&mut crossings);
        self.crossings.sort_by(|a, b| compare_points(*a, *b));
        self.crossings.dedup();
        self.fresh.clear();
        let mut pieces = Vec::new();
        for (key, (ends, chain)) in of_round {
            let [first, last] = self.ends_of(&ends, is_first);
            let all = [first].into_iter().chain(chain.iter().copied()).chain([last]);
            pieces.extend(all.clone().zip(all.skip(1)));
            (if is_first { &mut self.chains } else { &mut self.bends }).insert(key, chain);
        }
        let uncut = doubtful.iter().filter(|ends| !self.chains.contains_key(&key(ends)));
        pieces.extend(uncut.map(|ends| ends.map(|p| self.noding.snapped(p))).map(|[a, b]| (a, b)));
        for (a, b) in pieces {
            let piece = in_order([a, b]);
            if a != b && self.seen.insert(key(&piece)) {
                self.fresh.push(piece);
            }
        }
        self.fresh.sort_by(compare_edges);
        self.rounds += 1;
        self.is_complete = self.fresh.is_empty();
        if self.rounds > ROUNDS && !self.is_complete {
            return Err(BuildError::TooManyCuts { allowed: self.bends.len() }.into());
        }
        Ok(())
    }

    /// Returns the ends of the chain of an edge of the input, or of a piece.
    fn ends_of(&self, ends: &Ends, of_input: bool) -> Ends {
        if of_input { ends.map(|p| self.noding.snapped(p)) } else { *ends }
    }

    /// Refuses a coordinate larger than announced.
    pub(super) fn check(&self, mut points: impl Iterator<Item = Point>) -> Result<(), BuildError> {
        let is_within = |p: &Point| p.x.abs() <= self.largest && p.y.abs() <= self.largest;
        match points.find(|p| !is_within(p)) {
            Some(Point { x, y }) => Err(BuildError::OutOfReach { x, y }),
            None => Ok(()),
        }
    }

    pub(super) fn snapped(&self, p: Point) -> Point {
        self.noding.snapped(p)
    }

    /// Cuts a chain of edges, and bends it.
    pub(super) fn cut(&self, chain: &[Point]) -> Vec<Point> {
        let mut way: Vec<Point> = chain.first().map(|p| self.snapped(*p)).into_iter().collect();
        for [a, b] in edges(chain) {
            let ends = in_order([a, b]);
            let along = self.chains.get(&key(&ends)).map_or(&[][..], Vec::as_slice);
            let is_forth = ends[0] == a;
            for i in 0..along.len() {
                self.bend(along[if is_forth { i } else { along.len() - 1 - i }], &mut way);
            }
            self.bend(self.snapped(b), &mut way);
        }
        way
    }

    /// Extends a chain to a point, through the vertices that bend it.
    fn bend(&self, to: Point, way: &mut Vec<Point>) {
        let mut ahead = vec![to];
        while let (Some(to), Some(from)) = (ahead.last().copied(), way.last().copied()) {
            let piece = in_order([from, to]);
            match self.bends.get(&key(&piece)) {
                Some(bends) if piece[0] == from => ahead.extend(bends.iter().rev()),
                Some(bends) => ahead.extend(bends),
                None => {
                    if from != to {
                        way.push(to);
                    }
                    ahead.pop();
                }
            }
        }
    }
}

fn refused(error: NodingError) -> BuildError {
    match error {
        NodingError::TooManyCuts { allowed } => BuildError::TooManyCuts { allowed },
        _ => BuildError::Full(RecordKind::Vertex),
    }
}

/// Returns true if points lead from end to end without turning back.
fn is_way([first, last]: Ends, between: &[Point]) -> bool {
    let course = |a: Point, b: Point| [a.x.partial_cmp(&b.x), a.y.partial_cmp(&b.y)];
    let whole = course(first, last);
    let leads = |a: Point, b: Point| {
        a != b && course(a, b).iter().zip(&whole).all(|(step, whole)| step == whole || *step == Some(Ordering::Equal))
    };
    let all = [first].into_iter().chain(between.iter().copied()).chain([last]);
    !between.is_empty() && all.clone().zip(all.skip(1)).all(|(a, b)| leads(a, b))
}
