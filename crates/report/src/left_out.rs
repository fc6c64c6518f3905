//! Names of missing tiles.

use crate::error::Error;
use crate::words::{NAMED, of_tiles};
use twinedge_coverage::tile::{Crossing, CrossingKind, Grid, Outcome, Portion, Summary, Tile};
use twinedge_geometry::Point;

/// Refuses a summary that does not cover all tiles. O(tiles of the summary).
pub(crate) fn refuse_missing(summary: &Summary) -> Result<(), Error> {
    let count = summary.grid().len().saturating_sub(summary.tiles().len()) as u64;
    let is_missing = |tile: &Tile| summary.tiles().binary_search(tile).is_err();
    let missing: Vec<Tile> = summary.grid().tiles().filter(is_missing).take(NAMED).collect();
    if missing.is_empty() { Ok(()) } else { Err(Error::Missing { tiles: missing, count }) }
}

/// Refuses a portion if some of its tiles have their edges cut and others do not.
///
/// # Errors
/// [`Error::WithoutCuts`].
pub fn refuse_without_cuts(portion: &Portion) -> Result<(), Error> {
    let tiles = portion.without_cuts();
    if tiles.is_empty() { Ok(()) } else { Err(Error::WithoutCuts { tiles }) }
}

/// Returns the reason, if any, why the tiles do not determine the map with its edges cut.
pub(crate) fn reason(grid: &Grid, cut: &Outcome) -> Option<String> {
    let mut tiles: Vec<Tile> = cut.crossings.iter().map(|one| grid.tile_of(place(one))).collect();
    let why = if tiles.is_empty() {
        tiles.extend(cut.seams.iter().map(|fault| fault.tile));
        "other cuts were taken there than beside it"
    } else {
        "edges still meet elsewhere than at vertices there, as after a round of cuts without it"
    };
    tiles.sort_unstable();
    tiles.dedup();
    (!tiles.is_empty()).then(|| format!("{}: {why}", of_tiles(&tiles)))
}

fn place(one: &Crossing) -> Point {
    let ([a, b], [c, d]) = (one.first, one.second);
    let [along, across] = [[b.x - a.x, b.y - a.y], [d.x - c.x, d.y - c.y]];
    let area = along[0] * across[1] - along[1] * across[0];
    let part = ((c.x - a.x) * across[1] - (c.y - a.y) * across[0]) / area;
    match one.kind {
        CrossingKind::Cross if part.is_finite() => Point::new(a.x + part * along[0], a.y + part * along[1]),
        CrossingKind::Touch => a,
        // In sorted order, the second of the ends of two overlapping edges lies on both.
        _ => {
            let mut ends = [a, b, c, d];
            ends.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
            ends[1]
        }
    }
}
