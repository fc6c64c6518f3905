//! Noding: turning any finite segments into edges that meet only at their ends.
//!
//! Segments drawn by hand or read from files cross, touch and overlap. [`node`] cuts them wherever they meet and rounds the cuts
//! to a grid. The result is the exact drawing of a plane graph in `f64` coordinates: every point is on the grid, edges are
//! distinct and not of zero length, and two edges meet at a common end or not at all. It never fails on finite input within reach
//! of the grid.
//!
//! ```
//! use twinedge_geometry::Point;
//! use twinedge_geometry::noding::{Snap, node};
//!
//! let cross = [[Point::new(0.0, 0.0), Point::new(4.0, 2.0)], [Point::new(0.0, 2.0), Point::new(4.0, 0.0)]];
//! let noded = node(&cross, &[], Snap::Auto)?;
//! assert_eq!((noded.points.len(), noded.segments.len()), (5, 4));
//! let way: Vec<Point> = noded.chain(1).unwrap().map(|v| noded.points[v as usize]).collect();
//! assert_eq!(way, [Point::new(0.0, 2.0), Point::new(2.0, 1.0), Point::new(4.0, 0.0)]);
//! # Ok::<(), twinedge_geometry::noding::NodingError>(())
//! ```
//!
//! # Snap rounding
//!
//! The grid has square cells, whose width is a power of two or any other number. Each grid point has a *pixel*: the square of one
//! cell around it, including only its left and lower sides. A pixel is *hot* if a segment ends in it, two segments cross in it,
//! or an input point lies in it. Every segment is replaced by the chain of the centres of the hot pixels that it visits, in the
//! order of its visits (J. D. Hobby, *Practical segment intersection with finite precision output*, 1999; L. J. Guibas and D. H.
//! Marimont, *Rounding arrangements dynamically*, 1998).
//!
//! ```text
//!   +-----+-----+-----+      +-----+-----+-----+
//!   |     |  h  |  b  |      |     |  h--|--b  |     The segment from a to b misses vertex h,
//!   |     |   __|--'  |      |     | /   |     |     but visits its pixel, which is hot.
//!   +-----+-''--+-----+  =>  +-----+/----+-----+
//!   |  a--|'    |     |      |  a-/|     |     |     It becomes the chain a, h, b.
//!   |     |     |     |      |     |     |     |
//!   +-----+-----+-----+      +-----+-----+-----+
//! ```
//!
//! Edges never cross, and none passes through a vertex. An edge is a new line, which can visit a hot pixel that its segment did
//! not visit: edges are bent until none does (iterated snap rounding: D. Halperin and E. Packer, 2002). So noding the result
//! changes nothing, on the same grid or on a finer one. `DESIGN.md` in the repository has the proofs.
//!
//! # What moves, and how far
//!
//! - Every input point and every end of a segment moves to the centre of its pixel, by at most half a cell in each direction. So
//!   does every crossing of segments, as read.
//! - Each round of bending moves chains by at most half a cell in each direction. After [`NodingSummary::rounds`] rounds, a chain
//!   is within `(rounds + 1) / 2` cells of its segment. Most maps on a fine grid need 0 or 1 rounds. Long lines past many
//!   vertices on a coarse grid can need more and are known to drift.
//! - A vertex can come to lie *on* an edge that passed nearby, but never on its other side.
//!
//! The input is read to 2^53 steps of the largest coordinate. That is exact for coordinates of more than half of the largest, and
//! off by less than a step for smaller coordinates that use all their digits. Pixels are larger than steps, by a factor of 8 with
//! [`Snap::Auto`], and according to the requested width with [`Snap::Size`], unless it is one step. So crossings are determined
//! before ends move, and vertices do not change sides. Opposite points are read at opposite positions, so diameters of a circle
//! around the origin meet in one vertex, with the same exception.
//!
//! # Exactness
//!
//! Coordinates are whole numbers of steps, of up to 54 bits. Crossings and their pixels, and the visited pixels of a segment and
//! their order, are signs and quotients of whole numbers of up to 112 bits. So `i128` is exact and needs no filter.
//!
//! # Cost
//!
//! O((n + k) log n) in practice, for n segments and k visits of hot pixels. Collinear segments have up to n² visits, but as their
//! chains are ranges of one chain, O(n) time and memory suffice (see `runs.rs`). Pairs that pass closely, or cross in the same
//! pixel, do not count: stars, fans, bundles and spirals are not quadratic (see `search.rs` and `chords.rs`).
//!
//! With the feature `rayon`, searching and sorting are divided among the threads of the current pool, with the same result.

mod bundle;
mod chains;
mod chords;
mod estimate;
mod grid;
mod input;
mod part;
mod pixel;
mod read;
mod runs;
mod search;

use crate::point::Point;
use crate::threads;
use chains::sorted;
use core::iter::FusedIterator;
use estimate::crossing_cuts;
use grid::{Cell, Grid};
use read::{Read, largest_coordinate};
use runs::Runs;

pub use input::{Input, NodingError, Snap};
pub use part::{PartCuts, PartNoding};

/// Counts and measures of one noding.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct NodingSummary {
    /// The width of a cell; 0 if nothing was rounded.
    pub cell: f64,
    /// The number of vertices that are only crossings: no input segment ends there.
    pub crossings: usize,
    /// The number of segments that have further vertices between their ends.
    pub split: usize,
    /// The number of segments that repeat an earlier one, in either direction.
    pub duplicates: usize,
    /// The number of segments with both ends at one vertex. They leave no edge.
    pub collapsed: usize,
    /// The number of distinct input points minus the number of vertices made from them.
    pub merged: usize,
    /// The rounds in which chains were bent, see [the module](self). 0 if nothing met or nearly met a segment's interior.
    pub rounds: usize,
    /// The largest move of a point of the input, in x and in y.
    pub largest_move: [f64; 2],
}

impl NodingSummary {
    /// Returns the vertex for an input point: its cell's middle, halves rounded up, or the point itself. −0 becomes 0. O(1).
    ///
    /// ```
    /// use twinedge_geometry::Point;
    /// use twinedge_geometry::noding::{Snap, node};
    ///
    /// let input = [[Point::new(0.1, 0.5), Point::new(7.9, -0.5)]];
    /// let noded = node(&input, &[], Snap::Size(1.0))?;
    /// let ends = input[0].map(|p| noded.summary.snapped(p));
    /// assert_eq!(ends, [Point::new(0.0, 1.0), Point::new(8.0, 0.0)]);
    /// assert!(ends.iter().all(|p| noded.points.contains(p)));
    /// # Ok::<(), twinedge_geometry::noding::NodingError>(())
    /// ```
    #[must_use]
    pub fn snapped(&self, p: Point) -> Point {
        if self.cell == 0.0 {
            return Point::new(p.x + 0.0, p.y + 0.0);
        }
        let cell = Cell::of(self.cell);
        // Adding zero turns −0 into 0. Coordinates out of reach of the grid stay.
        let middle = |number: f64| match (number / self.cell).abs() {
            cells if cells <= (1_u64 << 53) as f64 => cell.coordinate(cell.nearest(number)),
            _ => number + 0.0,
        };
        Point::new(middle(p.x), middle(p.y))
    }
}

/// The range of the pool that holds the vertices of a segment.
#[derive(Clone, Copy, Debug)]
struct ChainRange {
    start: usize,
    len: u32,
    reversed: bool,
}

/// A plane graph drawn with straight edges on a grid, with the path of each input segment along it.
///
/// Points and edges do not depend on the order of the input or on the direction of segments.
#[derive(Clone, Debug)]
pub struct Noded {
    /// The vertices: distinct points of the grid, in lexicographical order.
    pub points: Vec<Point>,
    /// The edges, as pairs of indices of points, the smaller one first; distinct, in lexicographical order, meeting only at ends.
    pub segments: Vec<[u32; 2]>,
    /// The counts and measures of the noding.
    pub summary: NodingSummary,
    pool: Vec<u32>,
    ranges: Vec<ChainRange>,
    vertex_of_point: Vec<u32>,
}

impl Noded {
    /// Returns the vertices along an input segment, from its first end to its second: one if the segment collapsed, otherwise at
    /// least two. `None` if there is no such segment. O(1).
    ///
    /// Two consecutive vertices form an edge. The chains of a ring's segments form a closed chain.
    #[must_use]
    pub fn chain(&self, segment: usize) -> Option<Chain<'_>> {
        let &ChainRange { start, len, reversed } = self.ranges.get(segment)?;
        Some(Chain { vertices: &self.pool[start..start + len as usize], reversed })
    }

    /// Returns the vertex for an input point. `None` if there is no such point. O(1).
    #[must_use]
    pub fn vertex_of_point(&self, point: usize) -> Option<u32> {
        self.vertex_of_point.get(point).copied()
    }
}

/// The vertices along an input segment: indices of [`Noded::points`].
#[derive(Clone, Debug)]
pub struct Chain<'a> {
    vertices: &'a [u32],
    reversed: bool,
}

impl Chain<'_> {
    fn take(&mut self, at_end: bool) -> Option<u32> {
        let (&vertex, rest) = if at_end { self.vertices.split_last() } else { self.vertices.split_first() }?;
        self.vertices = rest;
        Some(vertex)
    }
}

impl Iterator for Chain<'_> {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        self.take(self.reversed)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.vertices.len(), Some(self.vertices.len()))
    }
}

impl DoubleEndedIterator for Chain<'_> {
    fn next_back(&mut self) -> Option<u32> {
        self.take(!self.reversed)
    }
}

impl ExactSizeIterator for Chain<'_> {}
impl FusedIterator for Chain<'_> {}

/// Cuts segments where they meet and rounds to a grid, so that they meet only at common ends.
///
/// `points` are also vertices: a segment that visits the pixel of a point passes through its vertex. A point that no segment
/// touches, or the vertex of a collapsed segment, is an isolated vertex of the result.
///
/// Cost: see [the module](self#cost). [`node_within`] bounds it.
///
/// # Errors
///
/// [`NodingError`]: coordinates that are not finite or out of reach of the grid; an invalid size; too many points.
pub fn node(segments: &[[Point; 2]], points: &[Point], snap: Snap) -> Result<Noded, NodingError> {
    node_within(segments, points, snap, usize::MAX)
}

/// Nodes like [`node`], with at most `cuts` cuts: n segments may cross n² / 2 times, which would exhaust memory.
///
/// A segment is cut once at each vertex between its ends. Overlapping collinear segments count as one. A sample of pairs is tried
/// first; if it predicts more than twice the limit, noding does not begin. Otherwise it stops there. Memory is O(n + cuts).
///
/// ```
/// use twinedge_geometry::Point;
/// use twinedge_geometry::noding::{NodingError, Snap, node_within};
///
/// let line = |a: [f64; 2], b: [f64; 2]| [Point::from(a), Point::from(b)];
/// let level = (0..10).map(|i| line([-1.0, f64::from(i)], [10.0, f64::from(i)]));
/// let upright = (0..10).map(|i| line([f64::from(i), -1.0], [f64::from(i), 10.0]));
/// let grid: Vec<[Point; 2]> = level.chain(upright).collect();
/// // A hundred crossings, each of which cuts two segments.
/// assert!(node_within(&grid, &[], Snap::Auto, 200).is_ok());
/// assert_eq!(node_within(&grid, &[], Snap::Auto, 199).unwrap_err(), NodingError::TooManyCuts { allowed: 199 });
/// ```
///
/// # Errors
///
/// [`NodingError::TooManyCuts`], and the errors of [`node`].
pub fn node_within(segments: &[[Point; 2]], points: &[Point], snap: Snap, cuts: usize) -> Result<Noded, NodingError> {
    let (largest, holder) = largest_coordinate(segments, points)?;
    let grid = Grid::new(snap, largest, holder)?;
    if segments.len().saturating_mul(2).saturating_add(points.len()) >= u32::MAX as usize {
        return Err(NodingError::TooMany);
    }
    finish(&grid, Read::new(&grid, segments, points), cuts)
}

/// Nodes like [`node_within`] for distinct points, all of them vertices, and segments between them by number.
///
/// # Errors
/// The errors of [`node_within`].
pub fn node_numbered(points: &[Point], segments: &[[u32; 2]], snap: Snap, cuts: usize) -> Result<Noded, NodingError> {
    let (largest, holder) = largest_coordinate(&[], points)?;
    let grid = Grid::new(snap, largest, holder)?;
    if segments.len().max(points.len()) >= u32::MAX as usize {
        return Err(NodingError::TooMany);
    }
    finish(&grid, Read::numbered(&grid, points, segments), cuts)
}

fn finish(grid: &Grid, mut read: Read<'_>, cuts: usize) -> Result<Noded, NodingError> {
    let Runs { joined, of, duplicates } = runs::join(read.segments());
    if crossing_cuts(grid.pixels, &joined).is_some_and(|expected| expected / 2 > cuts as u64) {
        return Err(NodingError::TooManyCuts { allowed: cuts });
    }
    let mut vertices = core::mem::take(&mut read.vertices);
    let given = vertices.len();
    let (chains, rounds) = chains::snap(grid.pixels, &joined, &mut vertices, cuts)?;

    let mut collapsed = Vec::new();
    let mut runs = of.into_iter().map(|run| run as usize);
    let range_of = |[from, to]: [u32; 2]| {
        let Some(run) = (if from == to { None } else { runs.next() }) else {
            collapsed.push(from);
            return ChainRange { start: chains.pool().len() + collapsed.len() - 1, len: 1, reversed: false };
        };
        let [i, j] = [from, to].map(|end| chains.place(run, &joined[run], &vertices, end));
        ChainRange { start: i.min(j), len: i.abs_diff(j) as u32 + 1, reversed: i > j }
    };
    let ranges: Vec<ChainRange> = read.ends().map(range_of).collect();
    drop(joined);

    // The vertices are numbered by their positions in the order of the points.
    let by_pixel = |a: &u32, b: &u32| vertices[*a as usize].cmp(&vertices[*b as usize]);
    let mut order = core::mem::take(&mut read.order);
    let sorted_already = order.len();
    order.extend(sorted_already as u32..vertices.len() as u32);
    if sorted_already < order.len() {
        threads::sort_unstable_by(&mut order[sorted_already..], by_pixel);
        // At most two sorted runs, so this merges.
        order.sort_by(by_pixel);
    }
    let mut number = vec![0; vertices.len()];
    for (place, &v) in (0..).zip(&order) {
        number[v as usize] = place;
    }
    let renamed = |v: u32| number[v as usize];
    let summary = NodingSummary {
        cell: grid.cell(),
        crossings: vertices.len() - given,
        split: ranges.iter().filter(|range| range.len > 2).count(),
        duplicates,
        collapsed: collapsed.len(),
        merged: read.distinct() - given,
        rounds,
        largest_move: read.largest_move(grid, &vertices),
    };
    let (segments, (points, pool, vertex_of_point)) = threads::join(
        || distinct_edges(chains.edges().map(|edge| sorted(edge.map(renamed))), vertices.len()),
        || {
            let points = order.iter().map(|&v| grid.point(vertices[v as usize])).collect();
            let pool = chains.pool().iter().copied().chain(collapsed).map(renamed).collect();
            (points, pool, read.points().map(renamed).collect())
        },
    );
    Ok(Noded { points, segments, summary, pool, ranges, vertex_of_point })
}

/// Returns the edges in lexicographical order, each once. O(n + v) for v vertices, plus sorting the edges at each.
fn distinct_edges(edges: impl Iterator<Item = [u32; 2]>, vertices: usize) -> Vec<[u32; 2]> {
    let edges: Vec<[u32; 2]> = edges.collect();
    // After summation, `first[v + 1]` is the start of the edges of vertex v; filing moves it to their end.
    let mut first = vec![0_usize; vertices + 2];
    for [v, _] in &edges {
        first[*v as usize + 2] += 1;
    }
    for v in 1..first.len() {
        first[v] += first[v - 1];
    }
    let mut filed = vec![[0; 2]; edges.len()];
    for edge in edges {
        let place = &mut first[edge[0] as usize + 1];
        filed[*place] = edge;
        *place += 1;
    }
    for range in first.windows(2) {
        filed[range[0]..range[1]].sort_unstable();
    }
    filed.dedup();
    filed
}
