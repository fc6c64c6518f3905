//! A grid over the map, which answers most searches without the graph.

use super::graph::{Graph, GraphHit, Stage};
use alloc::vec;
use alloc::vec::Vec;
use twinedge_geometry::Point;
use twinedge_geometry::bounds::Bounds;
use twinedge_geometry::predicates::{Orientation, in_range, orientation};

/// The greatest average number of marks per cell, beyond which the grid is abandoned.
const MAX_MARKS_PER_CELL: usize = 16;

/// A square grid with about one cell for each segment. An empty cell stores its face. Any other cell stores the first question of
/// the graph whose answer differs between points of the cell, and searches start there.
///
/// The grid only saves time. If drawing the segments cell by cell would take more than O(n), all cells count as non-empty.
pub(super) struct Cells {
    columns: Axis,
    rows: Axis,
    /// Row by row.
    stages: Vec<Stage>,
}

/// A range of numbers, divided into equal pieces.
struct Axis {
    first: f64,
    last: f64,
    /// Pieces per unit of length; 0 if the range is a single number.
    scale: f64,
    pieces: usize,
    /// Two bounds for each piece: the first or last number of the range, or numbers in other pieces. Others lie between.
    bounds: Vec<[f64; 2]>,
}

impl Axis {
    fn new(first: f64, last: f64, pieces: usize) -> Self {
        let scale = if first < last { pieces as f64 / (last - first) } else { 0.0 };
        let mut axis = Self { first, last, scale, pieces, bounds: vec![[first, last]; pieces] };
        for i in 1..pieces {
            if axis.piece(last) < i {
                break;
            }
            // One of the two numbers is in an earlier piece, the other is not, and no number is between them.
            let (mut before, mut after) = (first, last);
            loop {
                let middle = f64::midpoint(before, after);
                if middle <= before || after <= middle {
                    break;
                }
                *(if axis.piece(middle) < i { &mut before } else { &mut after }) = middle;
            }
            axis.bounds[i - 1][1] = after;
            axis.bounds[i][0] = before;
        }
        axis
    }

    /// Returns the piece of a number of the range. It never falls as the number grows, since rounding is monotonic.
    #[inline]
    fn piece(&self, c: f64) -> usize {
        #[expect(clippy::cast_sign_loss, reason = "numbers of the range are at least the first")]
        let piece = ((c - self.first) * self.scale) as usize;
        piece.min(self.pieces - 1)
    }
}

impl Cells {
    /// Builds the grid for the points and segments in this box. O(n), plus a short search for each cell.
    pub(super) fn new(graph: &Graph, Bounds { low, high }: Bounds) -> Self {
        let side = 1 << graph.segments().len().max(1).ilog2().div_ceil(2);
        let (columns, rows) = (Axis::new(low.x, high.x, side), Axis::new(low.y, high.y, side));
        let mut cells = Self { columns, rows, stages: vec![graph.root(); side * side] };
        cells.narrow(graph, side);
        if let Some(marked) = cells.marked(graph) {
            for row in 0..side {
                let mut face = None;
                for column in 0..side {
                    let place = row * side + column;
                    if marked[place] {
                        face = None;
                        continue;
                    }
                    // Nothing is drawn between this cell and its empty neighbour.
                    face = face.or_else(|| cells.face(graph, column, row));
                    if let Some(face) = face {
                        cells.stages[place] = face;
                    }
                }
            }
        }
        cells
    }

    /// Stores for each cell the stage up to which all its points take the same way: first for all cells, then for quarters.
    fn narrow(&mut self, graph: &Graph, side: usize) {
        let mut blocks = vec![([0, 0], side, graph.root())];
        while let Some(([column, row], size, from)) = blocks.pop() {
            let [[left, right], [lower, upper]] = [(&self.columns, column), (&self.rows, row)]
                .map(|(axis, at)| [axis.bounds[at][0], axis.bounds[at + size - 1][1]]);
            let stage = graph.narrow(from, &Bounds { low: Point::new(left, lower), high: Point::new(right, upper) });
            if size == 1 {
                self.stages[row * side + column] = stage;
            } else {
                let half = size / 2;
                let quarters = [[0, 0], [half, 0], [0, half], [half, half]];
                blocks.extend(quarters.map(|[right, up]| ([column + right, row + up], half, stage)));
            }
        }
    }

    /// Returns a mark for each non-empty cell, or `None` if the segments pass through too many.
    fn marked(&self, graph: &Graph) -> Option<Vec<bool>> {
        let mut marked = vec![false; self.stages.len()];
        let mut marks_left = MAX_MARKS_PER_CELL * self.stages.len();
        for p in graph.points() {
            marked[self.place(*p)] = true;
        }
        for [low, high] in graph.segments() {
            let (bottom, top) = (low.y.min(high.y), low.y.max(high.y));
            let (lowest, highest) = (self.rows.piece(bottom), self.rows.piece(top));
            let (first, last) = (self.columns.piece(low.x), self.columns.piece(high.x));
            for column in first..=last {
                let rows = if first == last || lowest == highest {
                    lowest..highest + 1
                } else {
                    self.rows_on_the_way([*low, *high], column, lowest..highest + 1)
                };
                marks_left = marks_left.checked_sub(1 + rows.len())?;
                for row in rows {
                    marked[row * self.columns.pieces + column] = true;
                }
            }
        }
        Some(marked)
    }

    /// Returns the rows, perhaps with a neighbour, in which a segment passes through a column.
    fn rows_on_the_way(
        &self,
        [low, high]: [Point; 2],
        column: usize,
        rows: core::ops::Range<usize>,
    ) -> core::ops::Range<usize> {
        let [left, right] = self.columns.bounds[column];
        // The lowest and the highest point of the segment in the column.
        let (lowest, highest) = if low.y <= high.y { (left, right) } else { (right, left) };
        let is = |side: Orientation, x: f64, y: f64| {
            let corner = Point::new(x, y);
            in_range(corner) && orientation(low, high, corner) == side
        };
        let all = &self.rows.bounds[rows.clone()];
        let below = all.partition_point(|row| is(Orientation::Clockwise, lowest, row[1]));
        let above = all.partition_point(|row| !is(Orientation::CounterClockwise, highest, row[0]));
        rows.start + below..rows.start + above
    }

    /// Returns the face that contains an empty cell.
    fn face(&self, graph: &Graph, column: usize, row: usize) -> Option<Stage> {
        let [x, y] = [self.columns.bounds[column], self.rows.bounds[row]].map(|[a, b]| f64::midpoint(a, b));
        let p = Point::new(x, y);
        if !in_range(p) || self.place(p) != row * self.columns.pieces + column {
            return None;
        }
        match graph.find(self.stages[self.place(p)], p) {
            GraphHit::Face(face) => Some(Graph::stage(face)),
            GraphHit::Point(_) | GraphHit::Segment(_) => None,
        }
    }

    /// Returns the index of the cell that contains a point.
    #[inline]
    fn place(&self, p: Point) -> usize {
        self.rows.piece(p.y) * self.columns.pieces + self.columns.piece(p.x)
    }

    /// Returns the stage at which to start the search for a point, or `None` if the point lies outside.
    #[inline]
    pub(super) fn stage(&self, p: Point) -> Option<Stage> {
        let inside = (self.columns.first..=self.columns.last).contains(&p.x)
            && (self.rows.first..=self.rows.last).contains(&p.y);
        inside.then(|| self.stages[self.place(p)])
    }
}
