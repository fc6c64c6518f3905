//! Loading saved summaries: all references must be valid.

use super::claimed::Claimed;
use super::cuts::Source;
use super::ends::{Ends, compare_edges};
use super::fault::{Crossing, SeamFault, Uneven};
use super::grid::{Grid, Tile};
use super::portion::Portion;
use super::region::{Claim, Region, Sliver};
use super::side::Side;
use super::summary::{Border, Component, Face, MOST, Summary, Totals};
use crate::{Defect, Limits};
use thiserror::Error;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::in_range;
use twinedge_map::UnmatchedVertex;

const EXPONENTS: u16 = 1 << 11;

#[derive(serde::Deserialize)]
pub(super) struct Saved {
    grid: Grid,
    limits: Limits,
    tiles: Vec<Tile>,
    corners: Option<[Point; 2]>,
    totals: Totals,
    borders: Vec<Border>,
    faces: Vec<Face>,
    components: Vec<Component>,
    cycles: Vec<u32>,
    regions: Vec<Region>,
    closed: Vec<Region>,
    slivers: Vec<Sliver>,
    lengths: Vec<f64>,
    areas: Vec<f64>,
    claimed: Vec<Claimed>,
    extents: Vec<(u16, u64)>,
    absent: Vec<(u32, Option<String>)>,
    defects: Vec<(u32, Vec<Defect>)>,
    unmatched: Vec<UnmatchedVertex>,
    is_plane: bool,
    crossings: Vec<Crossing>,
    uneven: Vec<Uneven>,
    seams: Vec<SeamFault>,
    plane_seams: Vec<SeamFault>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub(super) enum SavedError {
    #[error("tiles or borders are out of order, or the grid does not have them")]
    Tiles,
    #[error("a border names what the summary does not have")]
    Names,
    #[error("edges or features are out of order, or out of range")]
    Order,
    #[error("a number is larger than any map has")]
    Number,
}

impl TryFrom<Saved> for Summary {
    type Error = SavedError;

    fn try_from(saved: Saved) -> Result<Self, SavedError> {
        let Saved { grid, limits, tiles, corners, totals, borders, faces, components, cycles, regions, closed, .. } =
            saved;
        let Saved { slivers, lengths, areas, claimed, extents, absent, defects, unmatched, .. } = saved;
        let Saved { is_plane, crossings, uneven, seams, plane_seams, .. } = saved;
        let rise = |tiles: &[Tile]| tiles.windows(2).all(|pair| pair[0] < pair[1]);
        if !rise(&tiles) || !tiles.iter().all(|tile| grid.has(*tile)) {
            return Err(SavedError::Tiles);
        }
        // A border exists if and only if the tile beyond it is absent.
        let mut expected: Vec<(Tile, Tile)> = Vec::new();
        for tile in &tiles {
            let beyond = Side::ALL.into_iter().flat_map(|side| grid.beyond(*tile, side));
            expected.extend(beyond.filter(|there| tiles.binary_search(there).is_err()).map(|there| (*tile, there)));
        }
        expected.sort_unstable();
        if !expected.into_iter().eq(borders.iter().map(|border| (border.tile, border.beyond))) {
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
        let all = || regions.iter().chain(&closed);
        let is_sorted = |Region { sets, edges, .. }: &Region| {
            edges.windows(2).all(|pair| compare_edges(&pair[0].ends, &pair[1].ends).is_lt())
                && edges.iter().all(|edge| is_exact(&edge.ends) && edge.sides.iter().all(|set| has(sets.len(), *set)))
        };
        let is_first = |place: u32| claimed.get(place as usize).is_some_and(|one| one.like == Some(place));
        let is_in_order = all().all(is_sorted)
            && extents.windows(2).all(|pair| pair[0].0 < pair[1].0)
            && contacts().all(|contact| is_exact(&contact.edge))
            && corners.is_none_or(|[low, high]| is_exact(&[low, high]) && low.x <= high.x && low.y <= high.y)
            && claimed.windows(2).all(|pair| pair[0].key() < pair[1].key())
            && claimed.iter().all(|one| one.of > 0 && grid.has(one.first))
            && (0..).zip(&claimed).all(|(place, one)| one.like.is_none_or(|like| like <= place && is_first(like)));
        if !is_in_order {
            return Err(SavedError::Order);
        }
        let is_small = |one: &Component| one.vertices.max(one.edges).max(one.cycles) <= MOST;
        let is_extent = |(exponent, edges): &(u16, u64)| *exponent < EXPONENTS && *edges <= MOST;
        if !totals.is_in_range() || !components.iter().all(is_small) || !extents.iter().all(is_extent) {
            return Err(SavedError::Number);
        }
        Ok(Self {
            grid,
            limits,
            tiles,
            corners,
            totals,
            borders,
            faces,
            components,
            cycles,
            regions,
            closed,
            slivers,
            lengths,
            areas,
            claimed,
            extents,
            absent,
            defects,
            unmatched,
            is_plane,
            crossings,
            uneven,
            seams,
            plane_seams,
        })
    }
}

#[derive(serde::Deserialize)]
pub(super) struct SavedPortion {
    source: Source,
    summary: Summary,
    cut: Option<Summary>,
}

impl TryFrom<SavedPortion> for Portion {
    type Error = SavedError;

    fn try_from(SavedPortion { source, summary, cut }: SavedPortion) -> Result<Self, SavedError> {
        let is_of = |cut: &Summary| cut.tiles.iter().all(|tile| summary.tiles.binary_search(tile).is_ok());
        if cut.as_ref().is_none_or(|cut| is_of(cut) && cut.grid == summary.grid && cut.limits == summary.limits) {
            Ok(Self { source, summary, cut })
        } else {
            Err(SavedError::Tiles)
        }
    }
}
