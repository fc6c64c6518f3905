//! The certificate of a drawing: a triangulation that contains the edges of the structure.

use super::columns::{Column, Labels};
use super::storage::Columns;
use alloc::vec::Vec;

/// A triangulation: darts in the [columns of drawings](Column::of_drawing), and the coordinates of points.
///
/// Darts `3 i`, `3 i + 1` and `3 i + 2` are the sides of triangle `i`. Triangle 0 is the outside of a big triangle around
/// everything. The numbers may be arbitrary. `twinedge_map::certificate` makes drawings.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Drawing {
    /// The columns. Columns other than the [columns of drawings](Column::of_drawing) are ignored.
    pub columns: Labels,
    /// The coordinates of points, in units of some grid. The first points are the vertices.
    pub points: Vec<[i64; 2]>,
    /// The grid: a unit is two to this exponent. Not checked; only for restoring the original coordinates.
    pub exponent: i32,
}

impl Columns for Drawing {
    type Numbers<'a> = &'a [u32];

    fn column(&self, column: Column) -> &[u32] {
        self.columns.column(column)
    }
    fn points(&self) -> usize {
        self.points.len()
    }
    #[inline(always)]
    fn point(&self, i: usize) -> Option<[i64; 2]> {
        self.points.get(i).copied()
    }
}
