//! Loading saved summaries, portions and pieces: all references must be valid.

use super::ends::{Ends, compare_edges, compare_points, unsigned};
use super::grid::Tile;
use super::piece::{Part, Piece, Whole};
use super::portion::Portion;
use super::region::{Claim, Region};
use super::side::Side;
use super::summary::{Border, Component, Face, MOST, Summary};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use thiserror::Error;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::in_range;

const EXPONENTS: u16 = 1 << 11;

/// The error of a saved value that contradicts itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
enum SavedError {
    #[error("tiles or borders are out of order, or the grid does not have them")]
    Tiles,
    #[error("a border names what the summary does not have")]
    Names,
    #[error("edges or features are out of order, or out of range")]
    Order,
    #[error("a number is larger than any map has")]
    Number,
}

/// Returns true if exponents are in order.
fn rise(extents: &[(u16, u64)]) -> bool {
    extents.windows(2).all(|pair| pair[0].0 < pair[1].0)
}

fn are_in_range(extents: &[(u16, u64)]) -> bool {
    extents.iter().all(|(exponent, edges)| *exponent < EXPONENTS && *edges <= MOST)
}

/// Saves a type by its fields, and checks each loaded value.
macro_rules! checked {
    ($($of:ty),*) => {$(
        impl Serialize for $of {
            fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                Self::serialize(self, to)
            }
        }

        impl<'de> Deserialize<'de> for $of {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                let loaded = Self::deserialize(from)?;
                loaded.check().map_err(D::Error::custom)?;
                Ok(loaded)
            }
        }
    )*};
}

checked!(Summary, Portion, Piece);

impl Summary {
    fn check(&self) -> Result<(), SavedError> {
        let Self { grid, tiles, corners, totals, borders, faces, components, cycles, regions, closed, .. } = self;
        let Self { claimed, extents, is_plane, .. } = self;
        if !tiles.windows(2).all(|pair| pair[0] < pair[1]) || !tiles.iter().all(|tile| grid.has(*tile)) {
            return Err(SavedError::Tiles);
        }
        // A border exists if and only if the tile beyond it is absent.
        let mut expected: Vec<(Tile, Tile)> = Vec::new();
        for tile in tiles {
            let beyond = Side::ALL.into_iter().flat_map(|side| grid.beyond(*tile, side));
            expected.extend(beyond.filter(|there| tiles.binary_search(there).is_err()).map(|there| (*tile, there)));
        }
        expected.sort_unstable();
        if !expected.into_iter().eq(borders.iter().map(|border| (border.tile, border.beyond))) {
            return Err(SavedError::Tiles);
        }
        let has = |of: usize, i: u32| (i as usize) < of;
        let is_named = |border: &Border| {
            let count = if *is_plane { border.contacts.len() + 1 } else { 0 };
            border.faces.len() == count
                && border.faces.iter().all(|face| has(faces.len(), *face))
                && border.contacts.iter().all(|contact| {
                    has(components.len(), contact.component) && contact.cycles.iter().all(|c| has(cycles.len(), *c))
                })
        };
        if !borders.iter().all(is_named) || !cycles.iter().all(|component| has(components.len(), *component)) {
            return Err(SavedError::Names);
        }
        // Each face has the regions of its claims.
        let is_claimed = |face: &Face| {
            let claims = Claim::all(&face.features);
            face.regions.len() == claims.len()
                && face
                    .regions
                    .iter()
                    .zip(&claims)
                    .all(|(i, claim)| regions.get(*i as usize).is_some_and(|r| r.claim == *claim))
        };
        if !faces.iter().all(is_claimed) {
            return Err(SavedError::Names);
        }
        let is_exact = |ends: &Ends| ends.iter().all(|p| in_range(*p));
        let contacts = || borders.iter().flat_map(|border| &border.contacts);
        let all = || regions.iter().chain(closed);
        let is_sorted = |Region { sets, edges, .. }: &Region| {
            edges.windows(2).all(|pair| compare_edges(&pair[0].ends, &pair[1].ends).is_lt())
                && edges.iter().all(|edge| is_exact(&edge.ends) && edge.sides.iter().all(|set| has(sets.len(), *set)))
        };
        let is_first = |place: u32| claimed.get(place as usize).is_some_and(|one| one.like == Some(place));
        let is_in_order = all().all(is_sorted)
            && rise(extents)
            && contacts().all(|contact| is_exact(&contact.edge))
            && corners.is_none_or(|[low, high]| is_exact(&[low, high]) && low.x <= high.x && low.y <= high.y)
            && claimed.windows(2).all(|pair| pair[0].key() < pair[1].key())
            && claimed.iter().all(|one| one.of > 0 && grid.has(one.first))
            && (0..).zip(claimed).all(|(place, one)| one.like.is_none_or(|like| like <= place && is_first(like)));
        if !is_in_order {
            return Err(SavedError::Order);
        }
        let is_small = |one: &Component| one.vertices.max(one.edges).max(one.cycles) <= MOST;
        if !totals.is_in_range() || !components.iter().all(is_small) || !are_in_range(extents) {
            return Err(SavedError::Number);
        }
        Ok(())
    }
}

impl Portion {
    fn check(&self) -> Result<(), SavedError> {
        let Self { summary, cut, .. } = self;
        let is_of = |cut: &Summary| cut.tiles.iter().all(|tile| summary.tiles.binary_search(tile).is_ok());
        let is_cut = |cut: &Summary| is_of(cut) && cut.grid == summary.grid && cut.limits == summary.limits;
        if cut.as_ref().is_none_or(is_cut) { Ok(()) } else { Err(SavedError::Tiles) }
    }
}

impl Piece {
    fn check(&self) -> Result<(), SavedError> {
        let is_point = |p: &Point| in_range(*p) && compare_points(unsigned(*p), *p).is_eq();
        let is_part = |part: &Part| {
            part.chains.iter().all(|chain| !chain.is_empty() && chain.iter().all(is_point))
                && (part.is_polygon || !part.has_corner)
        };
        let is_whole = |Whole { corners, extents, .. }: &Whole| {
            rise(extents)
                && are_in_range(extents)
                && corners
                    .is_none_or(|[low, high]| is_point(&low) && is_point(&high) && low.x <= high.x && low.y <= high.y)
        };
        let is_of_any_grid = self.tile == Tile(0) && self.parts.is_empty();
        let is_piece = self.first <= self.tile
            && self.of > 0
            && self.whole.is_some() == (self.first == self.tile)
            && (self.grid.is_some() || is_of_any_grid);
        if !is_piece {
            return Err(SavedError::Tiles);
        }
        if self.parts.iter().all(is_part) && self.whole.iter().all(is_whole) { Ok(()) } else { Err(SavedError::Order) }
    }
}
