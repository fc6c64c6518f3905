//! The features of a file with boxes, read from the file tile by tile.

use crate::on_disk::shelf_for;
use std::borrow::Cow;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use twinedge_coverage::insert_touches;
use twinedge_coverage::tile::{Cuts, Grid, Piece, Tile};
use twinedge_geometry::Point;
use twinedge_layers::io::ReadSummary;
use twinedge_layers::{Feature as LayerFeature, Geometry, Indexed, ReadError, ReadOptions, to_map};
use twinedge_map::Feature;
use twinedge_report::{Division, Shelf};

/// The maximal number of passes over the features; beyond it, copying them is cheaper.
const TIMES: u64 = 8;

const EVERYTHING: [Point; 2] =
    [Point { x: f64::NEG_INFINITY, y: f64::NEG_INFINITY }, Point { x: f64::INFINITY, y: f64::INFINITY }];

/// The features of a file with boxes. They are copied to another shelf if the features of each tile are scattered over
/// the file.
pub(super) struct ByIndex {
    source: Source,
    /// The tiles, if they are read from the file.
    tiles: Option<(Grid, Cuts)>,
    division: Division,
    copied: Option<Box<dyn Shelf>>,
}

struct Source {
    path: PathBuf,
    options: ReadOptions,
    /// The readers that no thread is using.
    free: Mutex<Vec<Indexed>>,
}

/// Returns the best shelf for a file: the file itself if it has boxes, otherwise the shelf for the division.
pub(super) fn shelf_of(path: Option<&Path>, options: ReadOptions, division: Division) -> io::Result<Box<dyn Shelf>> {
    // A pipe cannot be opened again.
    let Some(path) = path.filter(|path| path.is_file()) else { return shelf_for(division) };
    match Indexed::open(path, &options) {
        // Feature numbers have 32 bits.
        Ok(Some(file)) if u32::try_from(file.amount().of_features).is_ok() => {
            let source = Source { path: path.to_owned(), options, free: Mutex::new(vec![file]) };
            Ok(Box::new(ByIndex { source, tiles: None, division, copied: None }))
        }
        // A damaged file is refused once all of it is read.
        _ => shelf_for(division),
    }
}

impl Source {
    fn read(&self, window: [Point; 2], each: &mut dyn FnMut(u32, Feature)) -> io::Result<()> {
        let free = || self.free.lock().unwrap_or_else(PoisonError::into_inner);
        let reader = free().pop();
        let mut file = match reader {
            Some(file) => file,
            None => Indexed::open(&self.path, &self.options).map_err(refused)?.ok_or_else(changed)?,
        };
        let mut take = |number: u64, geometry: Option<Geometry>| {
            let feature = LayerFeature { geometry, ..LayerFeature::default() };
            let mut feature = to_map(&feature, &mut ReadSummary::default());
            insert_touches(&mut feature.shapes);
            each(number as u32, feature);
        };
        file.read(window, &mut |_| true, &mut take).map_err(refused)?;
        free().push(file);
        Ok(())
    }

    /// Returns true if reading the features of all windows is cheaper than copying everything.
    fn is_in_order(&self, windows: &[[Point; 2]]) -> bool {
        let free = self.free.lock().unwrap_or_else(PoisonError::into_inner);
        free.first().is_some_and(|file| {
            let passed = windows.iter().map(|window| file.passed(*window)).fold(0, u64::saturating_add);
            passed <= file.amount().of_features.saturating_mul(TIMES)
        })
    }
}

fn refused(error: ReadError) -> io::Error {
    match error {
        ReadError::Io(error) => error,
        error => io::Error::other(error),
    }
}

fn changed() -> io::Error {
    io::Error::other("the file changed while it was read")
}

impl Shelf for ByIndex {
    fn put(&mut self, _: Feature) -> io::Result<()> {
        Ok(())
    }

    fn each(&mut self, show: &mut dyn FnMut(&Feature)) -> io::Result<()> {
        self.source.read(EVERYTHING, &mut |_, feature| show(&feature))
    }

    fn file(&mut self, grid: &Grid, cuts: &Cuts) -> io::Result<()> {
        let windows: Vec<[Point; 2]> = grid.tiles().map(|tile| cuts.window(grid, tile, [])).collect();
        if self.source.is_in_order(&windows) {
            self.tiles = Some((grid.clone(), cuts.clone()));
            return Ok(());
        }
        let (mut copied, mut put) = (shelf_for(self.division)?, Ok(()));
        self.source.read(EVERYTHING, &mut |_, feature| {
            if put.is_ok() {
                put = copied.put(feature);
            }
        })?;
        put?;
        copied.file(grid, cuts)?;
        self.copied = Some(copied);
        Ok(())
    }

    fn of_tile(&self, tile: Tile) -> io::Result<Vec<Cow<'_, Piece>>> {
        if let Some(copied) = &self.copied {
            return copied.of_tile(tile);
        }
        let Some((grid, cuts)) = &self.tiles else { return Ok(Vec::new()) };
        let (mut pieces, mut divided) = (Vec::new(), Ok(()));
        self.source.read(cuts.window(grid, tile, []), &mut |number, feature| match cuts
            .piece_of(grid, tile, number, &feature)
        {
            Ok(piece) => pieces.extend(piece.map(Cow::Owned)),
            Err(error) => divided = Err(io::Error::other(error)),
        })?;
        divided?;
        Ok(pieces)
    }
}
