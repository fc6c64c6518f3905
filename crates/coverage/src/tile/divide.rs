//! Dividing a feature into the pieces that tiles need.
//!
//! A tile needs the edges that meet it, and to know whether each polygon contains its lower left corner: each face of the tile
//! lies some edges away from the corner, and crossing an edge enters or leaves the polygons that have it.
//!
//! ```text
//!   ┌───────┬───────┬───────┐
//!   │     ╱─┼───────┼─╲     │     a polygon, and six tiles: the tile in the middle of the lower row has no edge
//!   ├────╱──┼───────┼──╲────┤     and lies inside, each other one has the edges that meet it
//!   │    │  │       │  │    │
//!   └────┼──┴───────┴──┼────┘
//! ```
//!
//! A feature is divided along the lines of the grid, from the first to those between two tiles. What contains the corner of an
//! upper part follows from the corner of the whole, and from the edges that pass between the two.

use super::bounds::{Bounds, passes_level, passes_upright};
use super::cuts::Cuts;
use super::ends::{Ends, around, in_order, unsigned};
use super::grid::{Grid, Node, Tile};
use super::piece::{Part, Piece, Whole};
use crate::defects;
use std::collections::BTreeMap;
use twinedge_geometry::Point;
use twinedge_map::{BuildError, Feature, Shape};

impl Cuts {
    /// Divides a feature, which has this number in the map, into the pieces that tiles need: the edges in each tile and very near it, since
    /// edges are bent a little where they are cut. They depend on the largest coordinate only, not on cuts that were found. The piece of a
    /// feature without points is for the first tile.
    ///
    /// O(n log tiles) for n points, at most, plus the pieces.
    ///
    /// ```
    /// use twinedge_map::{Feature, Shape};
    /// use twinedge_coverage::tile::{Cuts, Grid, Tile};
    ///
    /// let grid = Grid::new([0.0, 0.0], [30.0, 30.0], 3, 3)?;
    /// let square = Shape::polygon([[1.0, 1.0], [29.0, 1.0], [29.0, 29.0], [1.0, 29.0]]);
    /// let square = Feature { shapes: vec![square], ..Feature::default() };
    /// let pieces = Cuts::new(30.0)?.pieces(&grid, 7, &square)?;
    /// // A corner, in which the ring begins and ends, a side, a corner.
    /// let points: Vec<usize> = pieces.iter().map(|piece| piece.point_count()).collect();
    /// assert_eq!(points, [4, 2, 3, 2, 0, 2, 3, 2, 3]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BuildError::NotFinite`] and [`BuildError::OutOfRange`], with the position, and [`BuildError::OutOfReach`] if a coordinate is larger
    /// than announced.
    pub fn pieces(&self, grid: &Grid, number: u32, feature: &Feature) -> Result<Vec<Piece>, BuildError> {
        self.divided(grid, number, feature, |_| true)
    }

    /// Returns the piece of a feature that one tile needs; `None` if it needs nothing. As [`pieces`](Self::pieces).
    ///
    /// # Errors
    /// As [`pieces`](Self::pieces).
    pub fn piece_of(
        &self,
        grid: &Grid,
        tile: Tile,
        number: u32,
        feature: &Feature,
    ) -> Result<Option<Piece>, BuildError> {
        Ok(self.divided(grid, number, feature, |other| other == tile)?.pop())
    }

    fn divided(
        &self,
        grid: &Grid,
        number: u32,
        feature: &Feature,
        is_wanted: impl Fn(Tile) -> bool,
    ) -> Result<Vec<Piece>, BuildError> {
        feature.check(number as usize)?;
        self.check(feature.points())?;
        let mut division = Division { grid, margin: self.margin(), found: BTreeMap::new() };
        for shape in &feature.shapes {
            division.shape(shape);
        }
        let mut found = division.found;
        if found.is_empty() {
            found.insert(Tile(0), Vec::new());
        }
        let (first, of) = (found.keys().next().copied().unwrap_or(Tile(0)), found.len() as u32);
        let piece = |(tile, parts)| Piece {
            grid: Some(grid.fingerprint()),
            tile,
            feature: number,
            first,
            of,
            whole: (tile == first).then(|| whole(feature)),
            parts,
        };
        Ok(found.into_iter().filter(|(tile, _)| is_wanted(*tile)).map(piece).collect())
    }
}

fn whole(feature: &Feature) -> Whole {
    let corners = around(feature.points().map(unsigned));
    let mut extents: BTreeMap<u16, u64> = BTreeMap::new();
    for shape in &feature.shapes {
        let Shape::Polygon(rings) = shape else { continue };
        for pair in rings.iter().flat_map(|ring| ring.windows(2)) {
            let extent = (pair[0].x - pair[1].x).abs().max((pair[0].y - pair[1].y).abs());
            *extents.entry((extent.to_bits() >> (f64::MANTISSA_DIGITS - 1)) as u16).or_default() += 1;
        }
    }
    Whole { corners, unreadable: None, defects: defects(&feature.shapes), extents: extents.into_iter().collect() }
}

/// A feature that is being divided.
struct Division<'a> {
    grid: &'a Grid,
    margin: f64,
    found: BTreeMap<Tile, Vec<Part>>,
}

/// The content of a part of the grid: edges, directed as in the feature, and whether the polygon contains the lower left corner. A
/// point is an edge without length.
struct Within {
    edges: Vec<Ends>,
    has_corner: bool,
}

impl Division<'_> {
    fn shape(&mut self, shape: &Shape) {
        let mut edges = Vec::new();
        match shape {
            Shape::Polygon(rings) => rings.iter().for_each(|ring| take(ring, true, &mut edges)),
            Shape::Line(points) => take(points, false, &mut edges),
            Shape::Point(point) => take(&[*point], false, &mut edges),
        }
        let Some([low, high]) = around(edges.iter().flatten().copied()) else { return };
        // Above a line that the shape does not meet, nothing contains a corner.
        let (mut node, mut bounds) = (0, Bounds::EVERYTHING);
        let around = Bounds { low, high }.grown(self.margin);
        while let Node::Divided(line, above) = self.grid.node(node) {
            let [lower, upper] = bounds.divided(line);
            match [line.is_passed(around.low), line.is_passed(around.high)] {
                [true, _] => (node, bounds) = (above, upper),
                [_, false] => (node, bounds) = (node + 1, lower),
                _ => break,
            }
        }
        self.divide(node, bounds, Within { edges, has_corner: false }, matches!(shape, Shape::Polygon(_)));
    }

    fn divide(&mut self, node: usize, bounds: Bounds, Within { edges, has_corner }: Within, is_polygon: bool) {
        if edges.is_empty() && !has_corner {
            return;
        }
        match self.grid.node(node) {
            Node::Tile(tile) => self.put(tile, Part { is_polygon, has_corner, chains: chains(&edges) }),
            Node::Divided(line, above) => {
                let [lower, upper] = bounds.divided(line);
                let from = bounds.low;
                let passes = |ends: &&Ends| {
                    if line.is_level {
                        passes_upright(in_order(**ends), from.x, [from.y, line.at])
                    } else {
                        passes_level(**ends, from.y, [from.x, line.at])
                    }
                };
                let is_odd = is_polygon && edges.iter().filter(passes).count() % 2 == 1;
                let near = [lower, upper].map(|part| {
                    let part = part.grown(self.margin);
                    edges.iter().copied().filter(|ends| part.meets(in_order(*ends))).collect()
                });
                drop(edges);
                let [below, beyond] = near;
                self.divide(node + 1, lower, Within { edges: below, has_corner }, is_polygon);
                self.divide(above, upper, Within { edges: beyond, has_corner: has_corner != is_odd }, is_polygon);
            }
        }
    }

    /// Adds a part to the piece of a tile. Lines and points of a feature form one part.
    fn put(&mut self, tile: Tile, part: Part) {
        let parts = self.found.entry(tile).or_default();
        match parts.last_mut() {
            Some(last) if !last.is_polygon && !part.is_polygon => last.chains.extend(part.chains),
            _ => parts.push(part),
        }
    }
}

/// Appends the edges of a chain; a chain whose points are equal is a point.
fn take(points: &[Point], is_closed: bool, into: &mut Vec<Ends>) {
    let Some((first, last)) = points.first().zip(points.last()) else { return };
    let before = into.len();
    let closing = is_closed.then_some([*last, *first]);
    let all = points.windows(2).map(|pair| [pair[0], pair[1]]).chain(closing);
    into.extend(all.filter(|[a, b]| a != b).map(|ends| ends.map(unsigned)));
    if into.len() == before {
        into.push([unsigned(*first); 2]);
    }
}

/// Joins edges that follow each other.
fn chains(edges: &[Ends]) -> Vec<Vec<Point>> {
    let follows = |[a, b]: &Ends, [c, d]: &Ends| b == c && a != b && c != d;
    let chain = |edges: &[Ends]| match edges {
        [[a, b]] if a == b => vec![*a],
        _ => edges.iter().map(|ends| ends[0]).chain(edges.last().map(|ends| ends[1])).collect(),
    };
    edges.chunk_by(follows).map(chain).collect()
}
