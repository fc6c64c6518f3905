//! Audits a tile, from the whole map or from the surroundings of the tile.

use std::collections::BTreeMap;
use twinedge_coverage::tile::{AuditError, Cuts, Grid, Piece, Portion, Tile, TileError};
use twinedge_coverage::{Limits, insert_touches};
use twinedge_geometry::Point;
use twinedge_layers::io::ReadSummary;
use twinedge_layers::{Feature as LayerFeature, Indexed, ReadError, to_map};
use twinedge_map::{BuildError, Feature};
use twinedge_report::{Error, grid_of, no_cuts};

/// The tile to audit.
pub(super) struct Asked {
    pub(super) size: [u32; 2],
    /// The corners of the box that the grid divides, if not the map's box.
    pub(super) corners: Option<[Point; 2]>,
    pub(super) place: Tile,
    pub(super) limits: Limits,
}

impl Asked {
    fn grid(&self, corners: Option<[Point; 2]>) -> Result<Grid, Error> {
        match self.corners {
            Some([low, high]) => Ok(Grid::new(low, high, self.size[0], self.size[1])?),
            None => grid_of(corners, self.size),
        }
    }
}

/// Audits the tile from all features of a map, which lies between two corners.
pub(super) fn of_whole(features: &[Feature], corners: Option<[Point; 2]>, asked: &Asked) -> Result<Portion, Error> {
    let numbered = (0..).zip(features);
    audited(&asked.grid(corners)?, no_cuts(corners)?, numbered, asked)
}

/// Audits the tile from the features around it: the features that meet it, and then the features that meet their edges there and so cut them.
pub(super) fn by_windows(file: &mut Indexed, asked: &Asked) -> Result<Portion, Error> {
    let corners = file.corners();
    let (grid, cuts) = (asked.grid(corners)?, no_cuts(corners)?);
    if !grid.has(asked.place) {
        return Err(refused(TileError::NoSuchTile(asked.place)));
    }
    let mut features = BTreeMap::new();
    add(file, cuts.window(&grid, asked.place, []), &mut features)?;
    let pieces = pieces(&cuts, &grid, asked.place, numbered(&features))?;
    add(file, cuts.window(&grid, asked.place, &pieces), &mut features)?;
    audited(&grid, cuts, numbered(&features), asked)
}

fn audited<'f>(
    grid: &Grid,
    mut cuts: Cuts,
    features: impl Iterator<Item = (u32, &'f Feature)> + Clone,
    asked: &Asked,
) -> Result<Portion, Error> {
    // Finds the cuts among all of these features, unless there are too many.
    let (all, only) = (Grid::everything(), Tile(0));
    let whole = pieces(&cuts, &all, only, features.clone())?;
    let mut is_cut = true;
    while is_cut && !cuts.is_complete() {
        match cuts.search(&all, only, &whole).and_then(|found| cuts.take([found])) {
            Err(TileError::Build(BuildError::TooManyCuts { .. })) => is_cut = false,
            taken => taken.map_err(refused)?,
        }
    }
    drop(whole);
    let pieces = pieces(&cuts, grid, asked.place, features)?;
    Portion::new(grid, asked.place, &pieces, &asked.limits, is_cut.then_some(&cuts)).map_err(refused)
}

/// Returns the pieces of features that a tile needs.
fn pieces<'f>(
    cuts: &Cuts,
    grid: &Grid,
    tile: Tile,
    features: impl Iterator<Item = (u32, &'f Feature)>,
) -> Result<Vec<Piece>, Error> {
    let of = |(number, feature)| cuts.piece_of(grid, tile, number, feature).transpose();
    features.filter_map(of).collect::<Result<_, _>>().map_err(|error| refused(error.into()))
}

fn numbered(features: &BTreeMap<u32, Feature>) -> impl Iterator<Item = (u32, &Feature)> + Clone {
    features.iter().map(|(number, feature)| (*number, feature))
}

/// Adds the features in a window that are still missing.
fn add(file: &mut Indexed, window: [Point; 2], features: &mut BTreeMap<u32, Feature>) -> Result<(), Error> {
    if u32::try_from(file.amount().of_features).is_err() {
        return Err(ReadError::Refused("there are more than 4,294,967,295 features".into()).into());
    }
    let mut found = Vec::new();
    file.read(window, &mut |number| !features.contains_key(&(number as u32)), &mut |number, geometry| {
        let feature = LayerFeature { geometry, ..LayerFeature::default() };
        let mut feature = to_map(&feature, &mut ReadSummary::default());
        insert_touches(&mut feature.shapes);
        found.push((number as u32, feature));
    })?;
    features.extend(found);
    Ok(())
}

fn refused(error: TileError) -> Error {
    AuditError::from(error).into()
}
