//! The pieces of a feature: what each tile needs of it.

use super::ends::Ends;
use super::error::TileError;
use super::grid::{Grid, Tile};
use crate::Defect;
use twinedge_geometry::Point;

/// The part of a feature that a tile needs, as [`Cuts::pieces`](super::Cuts::pieces) returns it.
///
/// With the feature `serde`, pieces are saved and loaded as bytes, so that each can be sent to the worker of its tile.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(remote = "Self"))]
pub struct Piece {
    /// The fingerprint of the grid; `None` if the feature cannot be read, as its piece fits any grid.
    pub(super) grid: Option<u64>,
    pub(super) tile: Tile,
    pub(super) feature: u32,
    /// The first tile that has a piece of the feature, and the number of these tiles.
    pub(super) first: Tile,
    pub(super) of: u32,
    /// In the piece of the first tile.
    pub(super) whole: Option<Whole>,
    pub(super) parts: Vec<Part>,
}

/// Facts about the whole feature.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Whole {
    /// The corners of the box around it; `None` if it has no points.
    pub(super) corners: Option<[Point; 2]>,
    /// The reason why its geometry could not be read, if it could not.
    pub(super) unreadable: Option<String>,
    pub(super) defects: Vec<Defect>,
    /// The number of its polygons' edges by the exponent of their extent, in order.
    pub(super) extents: Vec<(u16, u64)>,
}

/// The part of a polygon, or of lines and points, in a tile.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Part {
    pub(super) is_polygon: bool,
    /// True if the polygon contains the lower left corner of the tile.
    pub(super) has_corner: bool,
    /// Edges that follow each other, or a single point.
    pub(super) chains: Vec<Vec<Point>>,
}

impl Piece {
    /// Creates the piece of a feature whose geometry cannot be read, for the first tile. The audit of the whole names the feature.
    #[must_use]
    pub fn unreadable(feature: u32, why: impl Into<String>) -> Self {
        let unreadable = Some(why.into());
        let whole = Whole { corners: None, unreadable, defects: Vec::new(), extents: Vec::new() };
        Self { grid: None, tile: Tile(0), feature, first: Tile(0), of: 1, whole: Some(whole), parts: Vec::new() }
    }

    /// Returns the tile.
    #[must_use]
    pub const fn tile(&self) -> Tile {
        self.tile
    }

    /// Returns the number of the feature.
    #[must_use]
    pub const fn feature(&self) -> u32 {
        self.feature
    }

    /// Returns the number of points. O(1) for each part.
    #[must_use]
    pub fn point_count(&self) -> usize {
        self.chains().map(Vec::len).sum()
    }

    pub(super) fn chains(&self) -> impl Iterator<Item = &Vec<Point>> {
        self.parts.iter().flat_map(|part| &part.chains)
    }
}

/// Returns the edges of a chain that have a length.
pub(super) fn edges(chain: &[Point]) -> impl Iterator<Item = Ends> + '_ {
    chain.windows(2).map(|pair| [pair[0], pair[1]]).filter(|[a, b]| a != b)
}

/// Returns the pieces of a tile.
pub(super) fn of_tile<'p>(
    grid: &Grid,
    tile: Tile,
    pieces: impl IntoIterator<Item = &'p Piece>,
) -> Result<Vec<&'p Piece>, TileError> {
    if !grid.has(tile) {
        return Err(TileError::NoSuchTile(tile));
    }
    let is_of_grid = |piece: &&Piece| piece.grid.is_none_or(|other| other == grid.fingerprint());
    let pieces: Vec<&Piece> = pieces.into_iter().collect();
    if !pieces.iter().all(is_of_grid) {
        return Err(TileError::OtherGrid);
    }
    Ok(pieces.into_iter().filter(|piece| piece.tile == tile).collect())
}
