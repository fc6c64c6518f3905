//! Grids and their tiles.

use super::bounds::{Bounds, Line};
use super::side::Side;
use core::fmt;
use core::ops::Range;
use std::sync::Arc;
use thiserror::Error;
use twinedge_geometry::predicates::in_range;
use twinedge_geometry::{Point, threads};

/// The greatest number of tiles.
const MOST: u32 = 1 << 20;

/// The greatest depth of the tree of lines. A fitted tree is about twice as deep as the logarithm of its sample.
const DEEPEST: usize = 100;

/// A division of the plane into half-open boxes, the tiles.
///
/// [`Grid::new`] divides a box evenly, and [`Grid::fitted`] divides it by a sample of points, so that tiles have about the same
/// number of vertices. The tiles at the border extend to infinity, so every point of the plane lies in exactly one tile: a point
/// on a line belongs to the tile on its right or above it.
///
/// ```
/// use twinedge_geometry::Point;
/// use twinedge_coverage::tile::{Grid, Tile};
///
/// let grid = Grid::new([0.0, 0.0], [8.0, 4.0], 4, 2)?;
/// let at = |x: f64, y: f64| grid.tile_of(Point::new(x, y));
/// assert_eq!((at(1.0, 1.0), at(2.0, 2.0), at(-9.0, 99.0)), (Tile(0), Tile(5), Tile(4)));
/// # Ok::<(), twinedge_coverage::tile::GridError>(())
/// ```
#[derive(Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Form", into = "Form"))]
pub struct Grid {
    form: Form,
    /// A number by which pieces know the grid.
    fingerprint: u64,
    /// The tree of lines: each node that is divided is followed by its lower part.
    nodes: Arc<[Node]>,
    bounds: Arc<[Bounds]>,
}

/// A tile of a grid, by its number. An even grid numbers its tiles row by row from the lower left, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Tile(pub u32);

impl fmt::Display for Tile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// The definition of a grid.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
enum Form {
    Even {
        low: Point,
        high: Point,
        columns: u32,
        rows: u32,
    },
    /// The lines of the tree, in order of its nodes; `None` for a tile.
    Fitted(Vec<Option<Line>>),
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Node {
    Tile(Tile),
    /// The line between the lower part, which is the next node, and the upper part, which is the node with this index.
    Divided(Line, usize),
}

/// The error of [`Grid::new`] and [`Grid::fitted`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum GridError {
    /// There are no tiles, or more than 1,048,576 of them.
    #[error("a grid has 1 to 1,048,576 tiles")]
    Size,
    /// Two lines coincide, lines are nested too deeply, or a line or a point is out of the range in which predicates are exact.
    #[error("the lines of the grid are not distinct, or out of range")]
    Lines,
}

impl PartialEq for Grid {
    fn eq(&self, other: &Self) -> bool {
        self.form == other.form
    }
}

impl fmt::Debug for Grid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.form.fmt(f)
    }
}

/// The form of a grid, in words.
impl fmt::Display for Grid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.form {
            Form::Even { low, high, columns, rows } => {
                write!(f, "{columns}x{rows} between ({}, {}) and ({}, {})", low.x, low.y, high.x, high.y)
            }
            Form::Fitted(lines) => {
                write!(f, "{} fitted tiles", self.len())?;
                let first = lines.iter().flatten().next();
                let axis = |line: &Line| if line.is_level { "y" } else { "x" };
                first.map_or(Ok(()), |line| write!(f, " on both sides of {} = {}", axis(line), line.at))
            }
        }
    }
}

impl Grid {
    /// Returns the grid of one tile, the whole plane.
    #[must_use]
    pub fn everything() -> Self {
        Self::of_form(Form::Fitted(vec![None])).unwrap_or_else(|_| unreachable!("one tile needs no line"))
    }

    /// Creates a grid with these numbers of columns and rows, whose lines divide the box between two corners. O(tiles).
    ///
    /// # Errors
    /// [`GridError`].
    pub fn new(low: impl Into<Point>, high: impl Into<Point>, columns: u32, rows: u32) -> Result<Self, GridError> {
        Self::of_form(Form::Even { low: low.into(), high: high.into(), columns, rows })
    }

    /// Creates a grid whose tiles each contain at most `most` points of a sample, as far as lines can part them: equal samples make
    /// equal grids. Each line divides the longer side of the points' box, where half of them are on either side. O(n log n).
    ///
    /// ```
    /// use twinedge_geometry::Point;
    /// use twinedge_coverage::tile::Grid;
    ///
    /// // A town, and a few villages.
    /// let town = (0..900).map(|i| Point::new(f64::from(i % 30), f64::from(i / 30)));
    /// let villages = [[200.0, 100.0], [-300.0, 50.0], [90.0, 800.0]].map(Point::from);
    /// let grid = Grid::fitted(town.chain(villages).collect(), 100)?;
    /// assert_eq!(grid.len(), 16);
    /// # Ok::<(), twinedge_coverage::tile::GridError>(())
    /// ```
    ///
    /// # Errors
    /// [`GridError`]: a point of the sample is out of range, or there are too many tiles.
    pub fn fitted(mut sample: Vec<Point>, most: usize) -> Result<Self, GridError> {
        if !sample.iter().all(|p| in_range(*p)) {
            return Err(GridError::Lines);
        }
        let mut lines = Vec::new();
        fit(&mut sample, most.max(1), &mut lines);
        Self::of_form(Form::Fitted(lines))
    }

    fn of_form(form: Form) -> Result<Self, GridError> {
        let mut nodes = Vec::new();
        match &form {
            Form::Even { low, high, columns, rows } => {
                if columns.checked_mul(*rows).is_none_or(|tiles| tiles == 0 || tiles > MOST) {
                    return Err(GridError::Size);
                }
                if ![low, high].into_iter().all(|p| p.x.is_finite() && p.y.is_finite()) {
                    return Err(GridError::Lines);
                }
                let even = Even { low: *low, high: *high, columns: *columns, rows: *rows };
                even.divide(0..*columns, 0..*rows, &mut nodes);
            }
            Form::Fitted(lines) => {
                let mut lines = lines.iter();
                nodes = tree(&mut lines)?;
                if lines.next().is_some() {
                    return Err(GridError::Size);
                }
            }
        }
        let tiles = nodes.iter().filter(|node| matches!(node, Node::Tile(_))).count();
        let mut bounds = vec![Bounds::EVERYTHING; tiles];
        place(&nodes, &mut bounds)?;
        Ok(Self { fingerprint: fingerprint(&bounds), form, nodes: nodes.into(), bounds: bounds.into() })
    }

    /// Returns the numbers of columns and rows, if tiles form some.
    #[must_use]
    pub const fn size(&self) -> Option<[u32; 2]> {
        match self.form {
            Form::Even { columns, rows, .. } => Some([columns, rows]),
            Form::Fitted(_) => None,
        }
    }

    /// Returns the number of tiles.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a grid has a tile")]
    pub fn len(&self) -> usize {
        self.bounds.len()
    }

    /// Returns all tiles, in order.
    ///
    /// ```
    /// use twinedge_coverage::tile::Grid;
    ///
    /// assert_eq!(Grid::new([0.0, 0.0], [1.0, 1.0], 64, 32)?.tiles().count(), 2048);
    /// # Ok::<(), twinedge_coverage::tile::GridError>(())
    /// ```
    pub fn tiles(&self) -> impl Iterator<Item = Tile> + use<> {
        (0..self.len() as u32).map(Tile)
    }

    /// Returns true if the grid has this tile.
    #[must_use]
    pub fn has(&self, tile: Tile) -> bool {
        (tile.0 as usize) < self.len()
    }

    /// Returns the tile that contains a point. O(depth of the lines).
    #[must_use]
    pub fn tile_of(&self, p: Point) -> Tile {
        let mut node = 0;
        loop {
            match self.nodes[node] {
                Node::Tile(tile) => return tile,
                Node::Divided(line, above) => node = if line.is_passed(p) { above } else { node + 1 },
            }
        }
    }

    /// Returns the corners of a tile's box, infinite where the grid ends; `None` if there is no such tile.
    #[must_use]
    pub fn corners_of(&self, tile: Tile) -> Option<[Point; 2]> {
        self.bounds.get(tile.0 as usize).map(|bounds| [bounds.low, bounds.high])
    }

    pub(super) fn bounds(&self, tile: Tile) -> Bounds {
        self.bounds[tile.0 as usize]
    }

    pub(super) const fn fingerprint(&self) -> u64 {
        self.fingerprint
    }

    pub(super) fn node(&self, node: usize) -> Node {
        self.nodes[node]
    }

    /// Returns the tiles beyond a side of a tile, from the bottom up or from left to right.
    pub(super) fn beyond(&self, tile: Tile, side: Side) -> Vec<Tile> {
        let Bounds { low, high } = self.bounds(tile);
        let at = match side {
            Side::Bottom => low.y,
            Side::Right => high.x,
            Side::Top => high.y,
            Side::Left => low.x,
        };
        if at.is_infinite() {
            return Vec::new();
        }
        let is_upper = matches!(side, Side::Right | Side::Top);
        self.search(|line| {
            if line.is_level == side.is_upright() {
                let [from, to] = if line.is_level { [low.y, high.y] } else { [low.x, high.x] };
                [from < line.at, line.at < to]
            } else {
                let is_above = if is_upper { line.at <= at } else { line.at < at };
                [!is_above, is_above]
            }
        })
    }

    /// Returns the tiles of the parts that `of_line` asks for on both sides of each line, lower parts first.
    fn search(&self, of_line: impl Fn(Line) -> [bool; 2]) -> Vec<Tile> {
        let (mut found, mut left) = (Vec::new(), vec![0]);
        while let Some(node) = left.pop() {
            match self.nodes[node] {
                Node::Tile(tile) => found.push(tile),
                Node::Divided(line, above) => {
                    let [is_below, is_above] = of_line(line);
                    left.extend(is_above.then_some(above));
                    left.extend(is_below.then_some(node + 1));
                }
            }
        }
        found
    }
}

struct Even {
    low: Point,
    high: Point,
    columns: u32,
    rows: u32,
}

impl Even {
    /// Divides a block of tiles in halves, so that trees are low.
    fn divide(&self, columns: Range<u32>, rows: Range<u32>, nodes: &mut Vec<Node>) {
        if columns.len() <= 1 && rows.len() <= 1 {
            nodes.push(Node::Tile(Tile(rows.start * self.columns + columns.start)));
            return;
        }
        let is_level = rows.len() > columns.len();
        let (of, low, high, count) = if is_level {
            (&rows, self.low.y, self.high.y, self.rows)
        } else {
            (&columns, self.low.x, self.high.x, self.columns)
        };
        let middle = of.start.midpoint(of.end);
        // Adding zero turns −0 into 0.
        let at = low + (high - low) * f64::from(middle) / f64::from(count) + 0.0;
        let node = nodes.len();
        nodes.push(Node::Divided(Line { is_level, at }, 0));
        let (below, above) = (of.start..middle, middle..of.end);
        let part = |of: Range<u32>| if is_level { (columns.clone(), of) } else { (of, rows.clone()) };
        let (these, those) = part(below);
        self.divide(these, those, nodes);
        nodes[node] = Node::Divided(Line { is_level, at }, nodes.len());
        let (these, those) = part(above);
        self.divide(these, those, nodes);
    }
}

/// Appends the lines that part some points.
fn fit(points: &mut [Point], most: usize, lines: &mut Vec<Option<Line>>) {
    let line = if points.len() > most { parting(points) } else { None };
    lines.push(line);
    if let Some(line) = line {
        let below = points.partition_point(|p| !line.is_passed(*p));
        let (these, those) = points.split_at_mut(below);
        fit(these, most, lines);
        fit(those, most, lines);
    }
}

/// Returns the line through the middle of some points, which it sorts across the line; `None` if they are equal.
fn parting(points: &mut [Point]) -> Option<Line> {
    let of = |is_level: bool, p: &Point| if is_level { p.y } else { p.x };
    let extent = |is_level: bool| {
        let all = points.iter().map(|p| of(is_level, p));
        all.clone().fold(f64::NEG_INFINITY, f64::max) - all.fold(f64::INFINITY, f64::min)
    };
    let is_level = extent(true) > extent(false);
    if extent(is_level) <= 0.0 {
        return None;
    }
    threads::sort_unstable_by(points, |p, q| of(is_level, p).total_cmp(&of(is_level, q)));
    let middle = of(is_level, &points[points.len() / 2]);
    // Some points lie below the line: where half of them are equal to the least, it is the line through the next.
    let least = of(is_level, &points[0]);
    let next = || points.iter().map(|p| of(is_level, p)).find(|x| *x > least);
    let at = if middle > least { middle } else { next()? };
    Some(Line { is_level, at: at + 0.0 })
}

/// Returns the nodes of lines in order; tiles are numbered in order.
fn tree<'l>(lines: &mut impl Iterator<Item = &'l Option<Line>>) -> Result<Vec<Node>, GridError> {
    // The nodes whose upper parts are still open.
    let (mut nodes, mut open, mut tiles) = (Vec::new(), Vec::new(), 0);
    loop {
        if let Some(line) = lines.next().ok_or(GridError::Size)? {
            open.push(nodes.len());
            nodes.push(Node::Divided(*line, 0));
            continue;
        }
        nodes.push(Node::Tile(Tile(tiles)));
        tiles += 1;
        if tiles > MOST {
            return Err(GridError::Size);
        }
        let Some(node) = open.pop() else { return Ok(nodes) };
        let next = nodes.len();
        if let Node::Divided(_, above) = &mut nodes[node] {
            *above = next;
        }
    }
}

/// Hashes the bounds of tiles, by FNV-1a.
fn fingerprint(bounds: &[Bounds]) -> u64 {
    let corners = bounds.iter().flat_map(|Bounds { low, high }| [low.x, low.y, high.x, high.y]);
    let bytes = corners.flat_map(|x| x.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// Sets the bounds of the tiles.
fn place(nodes: &[Node], bounds: &mut [Bounds]) -> Result<(), GridError> {
    let mut left = vec![(0, Bounds::EVERYTHING, 0)];
    while let Some((node, within, depth)) = left.pop() {
        match nodes[node] {
            Node::Tile(tile) => bounds[tile.0 as usize] = within,
            Node::Divided(line, above) => {
                let [low, high] =
                    if line.is_level { [within.low.y, within.high.y] } else { [within.low.x, within.high.x] };
                let is_within = low < line.at && line.at < high && depth < DEEPEST;
                if !is_within || !in_range(Point::new(line.at, line.at)) {
                    return Err(GridError::Lines);
                }
                let [lower, upper] = within.divided(line);
                left.extend([(node + 1, lower, depth + 1), (above, upper, depth + 1)]);
            }
        }
    }
    Ok(())
}

#[cfg(feature = "serde")]
impl From<Grid> for Form {
    fn from(grid: Grid) -> Self {
        grid.form
    }
}

#[cfg(feature = "serde")]
impl TryFrom<Form> for Grid {
    type Error = GridError;

    fn try_from(form: Form) -> Result<Self, GridError> {
        Self::of_form(form)
    }
}
