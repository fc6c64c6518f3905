//! Tiles in words.

use crate::words::grouped;
use twinedge_coverage::tile::Tile;

/// The number of tiles that a message names.
pub(crate) const NAMED: usize = 10;

/// Tiles by their columns and rows, the first ones of so many.
pub(crate) fn in_words(tiles: &[Tile], count: u64) -> String {
    let named = tiles.iter().take(NAMED).map(|tile| format!("({tile})"));
    let mut named: Vec<String> = named.collect();
    let more = count.saturating_sub(named.len() as u64);
    named.extend((more > 0).then(|| format!("{} more", grouped(more))));
    let last = named.pop().unwrap_or_default();
    if named.is_empty() { last } else { format!("{} and {last}", named.join(", ")) }
}

/// The noun, and then the tiles.
pub(crate) fn of_tiles(tiles: &[Tile]) -> String {
    format!("tile{} {}", if tiles.len() == 1 { "" } else { "s" }, in_words(tiles, tiles.len() as u64))
}

/// Says that tiles were made without cuts.
pub(crate) fn made_without(tiles: &[Tile]) -> String {
    format!("{} {} made without cuts", of_tiles(tiles), if tiles.len() == 1 { "was" } else { "were" })
}
