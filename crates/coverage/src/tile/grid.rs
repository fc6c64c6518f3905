//! Grids and their tiles.

use super::clip::Bounds;
use super::extent::corners;
use super::side::Side;
use core::fmt;
use thiserror::Error;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::in_range;
use twinedge_map::Feature;

/// The greatest number of columns, and of rows.
const MOST: u32 = 1 << 16;

/// A division of the plane into columns and rows of half-open boxes.
///
/// The lines between them divide a box evenly. The first and last columns and rows extend to infinity, so every point of the
/// plane lies in exactly one tile: a point on a line belongs to the tile on its right or above it.
///
/// ```
/// use twinedge_geometry::Point;
/// use twinedge_coverage::tile::Grid;
///
/// let grid = Grid::new([0.0, 0.0], [8.0, 4.0], 4, 2)?;
/// let at = |x: f64, y: f64| { let tile = grid.tile_of(Point::new(x, y)); (tile.column, tile.row) };
/// assert_eq!((at(1.0, 1.0), at(2.0, 2.0), at(-9.0, 99.0)), ((0, 0), (1, 1), (0, 1)));
/// # Ok::<(), twinedge_coverage::tile::GridError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Saved", into = "Saved"))]
pub struct Grid {
    low: Point,
    high: Point,
    columns: u32,
    rows: u32,
}

/// A tile of a grid, by the number of its column from the left and of its row from the bottom, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Tile {
    /// The column.
    pub column: u32,
    /// The row.
    pub row: u32,
}

impl fmt::Display for Tile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{}", self.column, self.row)
    }
}

/// The error of [`Grid::new`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum GridError {
    /// There are no columns or no rows, or more than 65,536 of them.
    #[error("a grid has 1 to 65,536 columns and rows")]
    Size,
    /// Two lines coincide, or a line is out of the range in which predicates are exact.
    #[error("the lines of the grid are not distinct, or out of range")]
    Lines,
}

impl Grid {
    /// The grid of one tile, the whole plane.
    pub const EVERYTHING: Self =
        Self { low: Point { x: 0.0, y: 0.0 }, high: Point { x: 1.0, y: 1.0 }, columns: 1, rows: 1 };

    /// Creates a grid with these numbers of columns and rows, whose lines divide the box between two corners. O(columns + rows).
    ///
    /// # Errors
    /// [`GridError`].
    pub fn new(low: impl Into<Point>, high: impl Into<Point>, columns: u32, rows: u32) -> Result<Self, GridError> {
        let grid = Self { low: low.into(), high: high.into(), columns, rows };
        if !(1..=MOST).contains(&columns) || !(1..=MOST).contains(&rows) {
            return Err(GridError::Size);
        }
        let rises = |of: u32, line: &dyn Fn(u32) -> f64| (2..of).all(|i| line(i - 1) < line(i));
        let is_exact = |x: f64| in_range(Point::new(x, x));
        let is_right = rises(columns, &|i| grid.upright(i))
            && rises(rows, &|i| grid.level(i))
            && (1..columns).all(|i| is_exact(grid.upright(i)))
            && (1..rows).all(|i| is_exact(grid.level(i)));
        if is_right { Ok(grid) } else { Err(GridError::Lines) }
    }

    /// Returns the numbers of columns and rows.
    #[must_use]
    pub const fn size(&self) -> [u32; 2] {
        [self.columns, self.rows]
    }

    /// Returns the corners of the box that the lines divide.
    pub(super) const fn corners(&self) -> [Point; 2] {
        [self.low, self.high]
    }

    fn upright(&self, column: u32) -> f64 {
        line(self.low.x, self.high.x, column, self.columns)
    }

    fn level(&self, row: u32) -> f64 {
        line(self.low.y, self.high.y, row, self.rows)
    }

    /// Returns the tile that contains a point. O(log tiles).
    #[must_use]
    pub fn tile_of(&self, p: Point) -> Tile {
        let place = |of: u32, is_passed: &dyn Fn(u32) -> bool| {
            let (mut low, mut high) = (0, of - 1);
            while low < high {
                let middle = low + (high - low).div_ceil(2);
                if is_passed(middle) {
                    low = middle;
                } else {
                    high = middle - 1;
                }
            }
            low
        };
        Tile {
            column: place(self.columns, &|i| self.upright(i) <= p.x),
            row: place(self.rows, &|i| self.level(i) <= p.y),
        }
    }

    /// Returns the tiles that must be given a feature, row by row: the tiles that meet its box. O(points).
    ///
    /// ```
    /// use twinedge_map::{Feature, Shape};
    /// use twinedge_coverage::tile::Grid;
    ///
    /// let grid = Grid::new([0.0, 0.0], [3.0, 3.0], 3, 3)?;
    /// let path = Feature { shapes: vec![Shape::line([[0.5, 0.5], [1.0, 2.0]])], ..Feature::default() };
    /// assert_eq!(grid.tiles_of(&path).count(), 6);
    /// assert_eq!(grid.tiles_of(&Feature::default()).count(), 0);
    /// # Ok::<(), twinedge_coverage::tile::GridError>(())
    /// ```
    pub fn tiles_of(&self, feature: &Feature) -> impl Iterator<Item = Tile> + use<> {
        let grid = *self;
        corners(feature).into_iter().flat_map(move |(low, high)| grid.tiles_between(low, high))
    }

    /// Returns the tiles that meet the closed box between two corners, row by row.
    pub(super) fn tiles_between(&self, low: Point, high: Point) -> impl Iterator<Item = Tile> + use<> {
        let (first, last) = (self.tile_of(low), self.tile_of(high));
        let columns = first.column..=last.column;
        (first.row..=last.row).flat_map(move |row| columns.clone().map(move |column| Tile { column, row }))
    }

    /// Returns all tiles, row by row.
    ///
    /// ```
    /// use twinedge_coverage::tile::Grid;
    ///
    /// assert_eq!(Grid::new([0.0, 0.0], [1.0, 1.0], 64, 32)?.tiles().count(), 2048);
    /// # Ok::<(), twinedge_coverage::tile::GridError>(())
    /// ```
    pub fn tiles(&self) -> impl Iterator<Item = Tile> + use<> {
        let columns = self.columns;
        (0..self.rows).flat_map(move |row| (0..columns).map(move |column| Tile { column, row }))
    }

    /// Returns true if the grid has this tile.
    #[must_use]
    pub const fn has(&self, tile: Tile) -> bool {
        tile.column < self.columns && tile.row < self.rows
    }

    pub(super) fn bounds(&self, tile: Tile) -> Bounds {
        let Tile { column, row } = tile;
        Bounds {
            left: (column > 0).then(|| self.upright(column)),
            right: (column + 1 < self.columns).then(|| self.upright(column + 1)),
            bottom: (row > 0).then(|| self.level(row)),
            top: (row + 1 < self.rows).then(|| self.level(row + 1)),
        }
    }

    pub(super) fn neighbour(&self, Tile { column, row }: Tile, side: Side) -> Option<Tile> {
        let [column, row] = match side {
            Side::Bottom => [column, row.checked_sub(1)?],
            Side::Right => [column.checked_add(1)?, row],
            Side::Top => [column, row.checked_add(1)?],
            Side::Left => [column.checked_sub(1)?, row],
        };
        Some(Tile { column, row }).filter(|tile| self.has(*tile))
    }
}

fn line(low: f64, high: f64, i: u32, of: u32) -> f64 {
    // Adding zero turns −0 into 0.
    low + (high - low) * f64::from(i) / f64::from(of) + 0.0
}

#[cfg(feature = "serde")]
#[derive(serde::Serialize, serde::Deserialize)]
struct Saved {
    low: Point,
    high: Point,
    columns: u32,
    rows: u32,
}

#[cfg(feature = "serde")]
impl From<Grid> for Saved {
    fn from(Grid { low, high, columns, rows }: Grid) -> Self {
        Self { low, high, columns, rows }
    }
}

#[cfg(feature = "serde")]
impl TryFrom<Saved> for Grid {
    type Error = GridError;

    fn try_from(Saved { low, high, columns, rows }: Saved) -> Result<Self, GridError> {
        Self::new(low, high, columns, rows)
    }
}
