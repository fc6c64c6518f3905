//! Tiles in words.

use crate::words::grouped;
use twinedge_coverage::tile::Tile;

/// The number of tiles named in a message.
pub(crate) const NAMED: usize = 10;

/// Names the first tiles by their columns and rows, and counts the rest of `count`.
pub(crate) fn in_words(tiles: &[Tile], count: u64) -> String {
    let named = tiles.iter().take(NAMED).map(|tile| format!("({tile})"));
    let mut named: Vec<String> = named.collect();
    let more = count.saturating_sub(named.len() as u64);
    named.extend((more > 0).then(|| format!("{} more", grouped(more))));
    let last = named.pop().unwrap_or_default();
    if named.is_empty() { last } else { format!("{} and {last}", named.join(", ")) }
}

pub(crate) fn of_tiles(tiles: &[Tile]) -> String {
    format!("tile{} {}", if tiles.len() == 1 { "" } else { "s" }, in_words(tiles, tiles.len() as u64))
}

/// A sentence about tiles made without cuts.
pub(crate) fn made_without(tiles: &[Tile]) -> String {
    format!("{} {} made without cuts", of_tiles(tiles), if tiles.len() == 1 { "was" } else { "were" })
}
