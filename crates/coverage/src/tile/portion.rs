//! The audited portion of a map: what tiles were made of, and their summaries, as they are saved, sent and merged.

use super::cuts::{Cuts, Source};
use super::error::{MergeError, TileError};
use super::grid::{Grid, Tile};
use super::piece::Piece;
use super::summary::Summary;
use crate::Limits;

/// The audit of one tile, or of several merged tiles.
///
/// It has the [`Summary`] of the tiles as they are, which judges the subdivision, and the summary with their edges cut, which judges the
/// coverage if edges meet other than at vertices anywhere in the map. One tile cannot know that, so it has both.
///
/// Portions of different sources are not merged: after a layer was replaced, tiles of the former layer and of the new one do not add up to
/// an audit of either.
///
/// ```
/// use twinedge_coverage::Limits;
/// use twinedge_coverage::tile::{Cuts, Grid, MergeError, Portion, Source, Tile};
/// use twinedge_map::{Feature, Shape};
///
/// let square = Feature { shapes: vec![Shape::polygon([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])], ..Feature::default() };
/// let grid = Grid::new([0.0, 0.0], [2.0, 2.0], 2, 1)?;
/// let pieces = Cuts::new(2.0)?.pieces(&grid, 0, &square)?;
/// let portion = |tile, snapshot: &str| {
///     let source = Source::from([("snapshot".to_owned(), snapshot.to_owned())]);
///     let portion = Portion::new(&grid, Tile(tile), &pieces, &Limits::default(), None);
///     portion.map(|portion| portion.with_source(source))
/// };
/// let whole = portion(0, "7")?.merge(portion(1, "7")?)?;
/// assert!(whole.summary().clone().finish()?.is_valid());
/// assert!(matches!(portion(0, "7")?.merge(portion(1, "8")?), Err(MergeError::Different { .. })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(remote = "Self"))]
pub struct Portion {
    pub(super) source: Source,
    pub(super) summary: Summary,
    pub(super) cut: Option<Summary>,
}

impl Portion {
    /// Audits a tile from its pieces of features, as [`Cuts::pieces`] returns them; pieces of other tiles have no effect. Without `cuts`, which
    /// may be too many to be found, the coverage is known only if edges meet at vertices alone. Cuts bring their own source. O(n log n)
    /// for n points.
    ///
    /// # Errors
    /// [`TileError`]; of these [`OtherCuts`](TileError::OtherCuts) if the cuts are not complete.
    pub fn new<'p>(
        grid: &Grid,
        tile: Tile,
        pieces: impl IntoIterator<Item = &'p Piece> + Clone,
        limits: &Limits,
        cuts: Option<&Cuts>,
    ) -> Result<Self, TileError> {
        if cuts.is_some_and(|cuts| !cuts.is_complete()) {
            return Err(TileError::OtherCuts);
        }
        let summary = Summary::new(grid, tile, pieces.clone(), limits)?;
        // Even if there are no cuts: edges that meet within one cell are moved apart, or together, by rounding alone.
        let cut = cuts.map(|cuts| Summary::cut(grid, tile, pieces, limits, cuts)).transpose()?;
        Ok(Self { source: cuts.map(|cuts| cuts.source().clone()).unwrap_or_default(), summary, cut })
    }

    /// Audits a tile without features, for a map whose tiles have their edges cut, or for one whose tiles do not.
    ///
    /// # Errors
    /// [`TileError::NoSuchTile`].
    pub fn of_nothing(grid: &Grid, tile: Tile, limits: &Limits, is_cut: bool) -> Result<Self, TileError> {
        let summary = Summary::new(grid, tile, [], limits)?;
        Ok(Self { source: Source::new(), cut: is_cut.then(|| summary.clone()), summary })
    }

    /// Sets the source of the map.
    #[must_use]
    pub fn with_source(self, source: Source) -> Self {
        Self { source, ..self }
    }

    /// Returns what the tiles were made of.
    #[must_use]
    pub const fn source(&self) -> &Source {
        &self.source
    }

    /// Returns the summary of the tiles as they are.
    #[must_use]
    pub const fn summary(&self) -> &Summary {
        &self.summary
    }

    /// Returns the summary of the tiles with their edges cut, of those made with cuts.
    #[must_use]
    pub const fn cut(&self) -> Option<&Summary> {
        self.cut.as_ref()
    }

    /// Returns both summaries.
    #[must_use]
    pub fn into_summaries(self) -> (Summary, Option<Summary>) {
        (self.summary, self.cut)
    }

    /// Returns the tiles made without cuts, if others were made with cuts.
    #[must_use]
    pub fn without_cuts(&self) -> Vec<Tile> {
        let Some(cut) = &self.cut else { return Vec::new() };
        self.summary.tiles().iter().copied().filter(|tile| cut.tiles().binary_search(tile).is_err()).collect()
    }

    /// Checks that two portions belong to one audit of one map: that they have the same source, grid and limits, and no tile in common.
    ///
    /// # Errors
    /// [`MergeError`].
    pub fn belongs_to(&self, other: &Self) -> Result<(), MergeError> {
        let differs = |fact: &&String| self.source.get(*fact) != other.source.get(*fact);
        if let Some(fact) = self.source.keys().chain(other.source.keys()).find(differs) {
            let [one, other] = [self, other].map(|one| one.source.get(fact).map_or("none", String::as_str).to_owned());
            return Err(MergeError::Different { what: fact.clone(), one, other });
        }
        self.summary.belongs_to(&other.summary)
    }

    /// Merges two portions, in either order: associative and commutative. O(n log n) for the listed records of both, expected.
    ///
    /// # Errors
    /// [`MergeError`].
    pub fn merge(self, other: Self) -> Result<Self, MergeError> {
        self.belongs_to(&other)?;
        let cut = match (self.cut, other.cut) {
            (Some(one), Some(other)) => Some(one.merge(other)?),
            (one, other) => one.or(other),
        };
        Ok(Self { source: self.source, summary: self.summary.merge(other.summary)?, cut })
    }
}
