//! Summaries that were saved: what they name must be there.

use super::fault::{Crossing, SeamFault, Uneven};
use super::grid::{Grid, Tile};
use super::summary::{Border, Component, Face, Summary, Totals};
use thiserror::Error;

/// A summary as it was read.
#[derive(serde::Deserialize)]
pub(super) struct Saved {
    grid: Grid,
    tiles: Vec<Tile>,
    totals: Totals,
    borders: Vec<Border>,
    faces: Vec<Face>,
    components: Vec<Component>,
    cycles: Vec<u32>,
    is_plane: bool,
    crossings: Vec<Crossing>,
    uneven: Vec<Uneven>,
    seams: Vec<SeamFault>,
}

/// The error of reading a summary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub(super) enum SavedError {
    #[error("tiles or borders are out of order, or the grid does not have them")]
    Tiles,
    #[error("a border names what the summary does not have")]
    Names,
}

impl TryFrom<Saved> for Summary {
    type Error = SavedError;

    fn try_from(saved: Saved) -> Result<Self, SavedError> {
        let Saved { grid, tiles, totals, borders, faces, components, cycles, is_plane, crossings, uneven, seams } = saved;
        let rise = |tiles: &[Tile]| tiles.windows(2).all(|pair| pair[0] < pair[1]);
        if !rise(&tiles) || !tiles.iter().all(|tile| grid.has(*tile)) {
            return Err(SavedError::Tiles);
        }
        // A border is there if and only if the tile beyond it is not.
        let expected = tiles.iter().flat_map(|tile| {
            let sides = super::grid::Side::ALL.into_iter();
            let is_open = |side: &super::grid::Side| {
                grid.neighbour(*tile, *side).is_some_and(|there| tiles.binary_search(&there).is_err())
            };
            sides.filter(is_open).map(|side| (*tile, side))
        });
        if !expected.eq(borders.iter().map(|border| (border.tile, border.side))) {
            return Err(SavedError::Tiles);
        }
        let has = |of: usize, i: u32| (i as usize) < of;
        let is_named = |border: &Border| {
            let count = if is_plane { border.contacts.len() + 1 } else { 0 };
            border.faces.len() == count
                && border.faces.iter().all(|face| has(faces.len(), *face))
                && border.contacts.iter().all(|contact| {
                    has(components.len(), contact.component) && contact.cycles.iter().all(|c| has(cycles.len(), *c))
                })
        };
        if !borders.iter().all(is_named) || !cycles.iter().all(|component| has(components.len(), *component)) {
            return Err(SavedError::Names);
        }
        Ok(Self { grid, tiles, totals, borders, faces, components, cycles, is_plane, crossings, uneven, seams })
    }
}
