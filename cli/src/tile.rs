//! `twinedge tile`: the summary of one tile of a map.

use crate::coverage::CoverageOptions;
use crate::input::MapFile;
use crate::noted::Keep;
use crate::output_file::write_file;
use crate::status::{Failure, Verdict};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use twinedge::algorithm::coverage::Limits;
use twinedge::geometry::Point;
use twinedge::map::{Feature, Shape};
use twinedge::tile::{Grid, Summary, Tile as Place};

/// Make the summary of one tile of a map.
///
/// A grid cuts the map into tiles, and each can be judged by a process of its own, on whatever machine. `twinedge sum` of the summaries of
/// all tiles says what `twinedge audit` says of the map. Summaries that are equal are equal byte by byte, so a tile may be made again.
///
/// All tiles must be made of the same file, with the same grid, box and limits.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge tile parcels.geojson --grid 2x1 --tile 0,0 -o 0-0.summary
  twinedge tile parcels.geojson --grid 2x1 --tile 1,0 -o 1-0.summary
  twinedge sum *.summary

Exit status: 0 the summary is written, whatever is in it; 2 the input could not be read.")]
pub(crate) struct Tile {
    #[command(flatten)]
    map: MapFile,

    /// The numbers of columns and rows.
    #[arg(long, value_name = "COLUMNSxROWS", value_parser = grid_size)]
    grid: [u32; 2],

    /// The column and the row of the tile, counted from 0, from the lower left.
    #[arg(long, value_name = "COLUMN,ROW", value_parser = place)]
    tile: Place,

    /// The box that the grid divides, by two corners. Points outside belong to the tiles at the border. Default: the box around the map.
    #[arg(long = "box", value_name = "X0,Y0,X1,Y1", value_parser = corners, allow_hyphen_values = true)]
    corners: Option<[Point; 2]>,

    #[command(flatten)]
    coverage: CoverageOptions,

    /// The file to write.
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

/// The file of a summary.
#[derive(Serialize, Deserialize)]
pub(crate) struct Saved {
    pub(crate) command: String,
    pub(crate) version: String,
    pub(crate) summary: Summary,
}

impl Saved {
    pub(crate) const COMMAND: &'static str = "tile";

    /// The file with this summary.
    pub(crate) fn bytes(summary: Summary) -> Result<Vec<u8>, Failure> {
        let (command, version) = (Self::COMMAND.to_owned(), env!("CARGO_PKG_VERSION").to_owned());
        let mut bytes = serde_json::to_vec(&Self { command, version, summary })?;
        bytes.push(b'\n');
        Ok(bytes)
    }
}

fn grid_size(text: &str) -> Result<[u32; 2], String> {
    let numbers = text.split_once('x').and_then(|(columns, rows)| Some([columns.parse().ok()?, rows.parse().ok()?]));
    numbers.ok_or_else(|| "not the numbers of columns and rows, as in 64x64".to_owned())
}

fn place(text: &str) -> Result<Place, String> {
    let numbers = text.split_once(',').and_then(|(column, row)| Some((column.parse().ok()?, row.parse().ok()?)));
    let place = |(column, row)| Place { column, row };
    numbers.map(place).ok_or_else(|| "not a column and a row, as in 3,4".to_owned())
}

fn corners(text: &str) -> Result<[Point; 2], String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|x| x.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[x0, y0, x1, y1]) => Ok([Point::new(x0, y0), Point::new(x1, y1)]),
        _ => Err("not four numbers with commas between".to_owned()),
    }
}

impl Tile {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let input = self.map.open()?;
        let name = input.name.clone();
        let in_file = |error: &dyn std::fmt::Display| Failure(format!("{name}: {error}"));
        if self.map.is_snapped() {
            return Err(in_file(&"--snap is for whole maps: a tile takes edges as they are"));
        }
        let (_, features) = self.map.features_from(input, Keep::default())?;
        let grid = match self.corners {
            Some([low, high]) => Grid::new(low, high, self.grid[0], self.grid[1])?,
            None => grid_around(&features, self.grid)?,
        };
        let numbered = (0..).zip(&features);
        let summary = Summary::new(&grid, self.tile, numbered, &self.coverage.limits());
        let summary = summary.map_err(|error| in_file(&error))?;
        write_file(&self.output, self.map.path(), &Saved::bytes(summary)?)?;
        Ok(Verdict::Sound)
    }
}

fn points(shape: &Shape) -> &[Point] {
    match shape {
        Shape::Polygon(rings) => rings.first().map_or(&[], Vec::as_slice),
        Shape::Line(points) => points,
        Shape::Point(point) => std::slice::from_ref(point),
    }
}

/// The grid that divides the box around all features.
pub(crate) fn grid_around(features: &[Feature], [columns, rows]: [u32; 2]) -> Result<Grid, Failure> {
    let all = features.iter().flat_map(|feature| &feature.shapes).flat_map(points);
    let far = f64::INFINITY;
    let (mut low, mut high) = (Point::new(far, far), Point::new(-far, -far));
    for p in all {
        low = Point::new(low.x.min(p.x), low.y.min(p.y));
        high = Point::new(high.x.max(p.x), high.y.max(p.y));
    }
    // What has no width is divided all the same.
    let wide = |low: f64, high: f64| if low < high { (low, high) } else { (low.min(0.0) - 1.0, high.max(0.0) + 1.0) };
    let is_empty = low.x > high.x;
    let ((left, right), (bottom, top)) =
        if is_empty { ((0.0, 1.0), (0.0, 1.0)) } else { (wide(low.x, high.x), wide(low.y, high.y)) };
    Ok(Grid::new([left, bottom], [right, top], columns, rows)?)
}

/// The summaries of all tiles, on as many threads as there are.
pub(crate) fn tiles(features: &[Feature], grid: &Grid, limits: &Limits) -> Result<Vec<Summary>, Failure> {
    let all: Vec<Place> = grid.tiles().collect();
    let mut given: Vec<Vec<u32>> = vec![Vec::new(); all.len()];
    let columns = grid.size()[0];
    for (number, feature) in (0..).zip(features) {
        for tile in grid.tiles_of(feature) {
            given[(tile.row * columns + tile.column) as usize].push(number);
        }
    }
    let next = AtomicUsize::new(0);
    let done = Mutex::new(Vec::new());
    let work = || {
        while let Some((place, tile)) = Some(next.fetch_add(1, Ordering::Relaxed)).and_then(|i| Some((i, *all.get(i)?)))
        {
            let of_tile = given[place].iter().map(|number| (*number, &features[*number as usize]));
            let summary = Summary::new(grid, tile, of_tile, limits);
            if let Ok(mut done) = done.lock() {
                done.push((place, summary));
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
        work();
    });
    let mut done = done.into_inner().unwrap_or_default();
    done.sort_by_key(|(place, _)| *place);
    done.into_iter().map(|(_, summary)| Ok(summary?)).collect()
}

/// Merges summaries, neighbours first.
pub(crate) fn merged(summaries: Result<Vec<Summary>, Failure>) -> Result<Summary, Failure> {
    let mut summaries = summaries?;
    while summaries.len() > 1 {
        let mut rest = summaries.into_iter();
        let mut pairs = Vec::new();
        while let Some(one) = rest.next() {
            pairs.push(match rest.next() {
                Some(other) => one.merge(other)?,
                None => one,
            });
        }
        summaries = pairs;
    }
    summaries.pop().ok_or_else(|| Failure("there is no summary".to_owned()))
}
