//! `twinedge tile`: the summary of one tile of a map. `twinedge sum` merges summaries.

mod made;
mod sum;

pub(crate) use sum::Sum;

use crate::input::MapFile;
use crate::output::{Failure, Verdict, named};
use crate::output_file::write_file;
use made::{Asked, by_windows, of_whole};
use std::path::PathBuf;
use twinedge_coverage::tile::{Source, Tile as Place};
use twinedge_geometry::Point;
use twinedge_layers::io::ReadSummary;
use twinedge_layers::{Amount, Crs, Format, Indexed};
use twinedge_report::words::grouped;
use twinedge_report::{Error, Imported, Judged, Keep, LimitOptions, refuse_edges};

/// Make the summary of one tile of a map.
///
/// A grid cuts the map into tiles, and each can be judged by a process of its own, on whatever machine. `twinedge sum` of the summaries of
/// all tiles says what `twinedge audit` says of the map. Summaries that are equal are equal byte by byte, so a tile may be made again.
///
/// Of `FlatGeobuf` with an index, and of `GeoParquet` with a column of boxes or Parquet's own geometries, only the features that meet the tile are read, and features that
/// cut their edges. A box that is smaller than its feature is an error in each tile that it meets: if all tiles can be made, no feature was missed. Other files are read
/// as a whole for each tile; `twinedge convert` writes both formats.
///
/// All tiles must be made of the same file, with the same grid, box and limits; `sum` refuses others. Each summary stores the SHA-256 of the file, for
/// which the whole file is read; with --source, it stores the given text instead.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge tile parcels.geojson --grid 2x1 --tile 0 -o 0.summary
  twinedge tile parcels.geojson --grid 2x1 --tile 1 -o 1.summary
  twinedge sum *.summary

Exit status: 0 the summary is written, whatever is in it; 2 the input could not be read.")]
pub(crate) struct Tile {
    #[command(flatten)]
    map: MapFile,

    /// The numbers of columns and rows.
    #[arg(long, value_name = "COLUMNSxROWS", value_parser = grid_size)]
    grid: [u32; 2],

    /// The number of the tile, counted from 0, row by row from the lower left.
    #[arg(long = "tile", value_name = "NUMBER")]
    place: u32,

    /// The box that the grid divides, by two corners. Points outside belong to the tiles at the border. Default: the box around the map.
    #[arg(long = "box", value_name = "X0,Y0,X1,Y1", value_parser = corners, allow_hyphen_values = true)]
    corners: Option<[Point; 2]>,

    /// Take edges as straight, whatever the file says. Otherwise a `GeoParquet` file is refused that says that its edges are not planar.
    #[arg(long, value_name = "SHAPE", value_parser = ["straight"])]
    edges: Option<String>,

    #[command(flatten)]
    limits: LimitOptions,

    /// A text that identifies the file in place of its SHA-256, such as the version of the layer. `sum` refuses summaries with different texts.
    #[arg(long, value_name = "TEXT")]
    source: Option<String>,

    /// Say on standard error how much of the file was read.
    #[arg(short, long)]
    verbose: bool,

    /// The file to write.
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

/// The names of the facts about a tile's source.
mod fact {
    pub(super) const CRS: &str = "crs";
    pub(super) const LAYER: &str = "layer";
    pub(super) const SHA_256: &str = "sha256";
    pub(super) const SIZE: &str = "size";
    pub(super) const SOURCE: &str = "source";
    pub(super) const VERSION: &str = "version";
}

fn grid_size(text: &str) -> Result<[u32; 2], String> {
    let numbers = text.split_once('x').and_then(|(columns, rows)| Some([columns.parse().ok()?, rows.parse().ok()?]));
    numbers.ok_or_else(|| "not the numbers of columns and rows, as in 64x64".to_owned())
}

fn corners(text: &str) -> Result<[Point; 2], String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|x| x.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[x0, y0, x1, y1]) if x0 < x1 && y0 < y1 && [x0, y0, x1, y1].iter().all(|x| x.is_finite()) => {
            Ok([Point::new(x0, y0), Point::new(x1, y1)])
        }
        Some(&[_, _, _, _]) => Err("not the lower left corner and then the upper right one, finite".to_owned()),
        _ => Err("not four numbers with commas between".to_owned()),
    }
}

impl Tile {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let (mut input, watch) = self.map.open_watched()?;
        let name = input.name.clone();
        if self.map.options.snap.is_some() {
            return Err(Failure(format!("{name}: --snap is for whole maps: a tile takes edges as they are")));
        }
        let options = input.options();
        let may_say = input.map_format().map_err(named(&name))? == Some(Format::GeoParquet) && self.edges.is_none();
        // A pipe can only be read once, so it is not opened a second time.
        let path = input.path.as_deref().filter(|path| path.is_file());
        let indexed = path.map(|path| Indexed::open(path, &options)).transpose().map_err(named(&name))?.flatten();
        // Cuts depend on the extent of the map.
        let indexed = indexed.filter(|file| file.corners().is_some());
        let asked =
            Asked { size: self.grid, corners: self.corners, place: Place(self.place), limits: self.limits.limits() };
        let refuse = |edges: Option<&str>, crs: Option<&Crs>, corners| {
            refuse_edges(edges.filter(|_| may_say), crs, corners).map_err(named(&name))
        };
        let (portion, crs, amount) = if let Some(mut file) = indexed {
            let header = file.header().map_err(named(&name))?;
            refuse(header.edges(), header.crs.as_ref(), file.corners())?;
            let may_be_empty = self.map.options.allow_empty;
            if !may_be_empty && file.has_only_points().map_err(named(&name))? {
                let points = file.amount().of_features as usize;
                let mut read = ReadSummary::default();
                (read.features, read.points) = (points, points);
                return Err(named(&name)(Error::NoMap(Box::new(read))));
            }
            (by_windows(&mut file, &asked).map_err(named(&name))?, header.crs, Some(file.amount()))
        } else {
            let mut features = Vec::new();
            let mut put = |feature| {
                features.push(feature);
                Ok(())
            };
            let imported = Imported::features(input, &self.map.options, Keep::default(), &mut put);
            let Imported { edges, crs, noted, .. } = imported.map_err(named(&name))?;
            refuse(edges.as_deref(), crs.as_ref(), noted.corners())?;
            let portion = of_whole(&features, noted.corners(), &asked).map_err(named(&name))?;
            (portion, crs, None)
        };
        if self.verbose {
            eprintln!("{name}: {}", told(amount));
        }
        let judged = if self.source.is_some() {
            None
        } else {
            let (judged, is_same) = watch.judged(&self.map)?;
            if !is_same {
                return Err(Failure(format!("{name}: the file changed while it was read")));
            }
            judged
        };
        let portion = portion.with_source(self.facts(judged, crs.filter(Crs::is_other)));
        write_file(&self.output, self.map.path(), &portion.to_bytes())?;
        Ok(Verdict::Sound)
    }

    /// Returns the facts that identify the source of the tile.
    fn facts(&self, judged: Option<Judged>, crs: Option<Crs>) -> Source {
        let (sha256, bytes) = judged.map(|judged| (judged.sha256, judged.bytes.to_string())).unzip();
        let facts = [
            (fact::SOURCE, self.source.clone()),
            (fact::SHA_256, sha256),
            (fact::SIZE, bytes),
            (fact::LAYER, self.map.layer().map(str::to_owned)),
            (fact::CRS, crs.map(|crs| crs.name())),
            (fact::VERSION, Some(env!("CARGO_PKG_VERSION").to_owned())),
        ];
        facts.into_iter().filter_map(|(name, value)| Some((name.to_owned(), value?))).collect()
    }
}

fn told(amount: Option<Amount>) -> String {
    let Some(Amount { features, of_features, bytes, of_bytes, .. }) = amount else {
        return "the whole file was read, as it has no boxes that say where all its features are".to_owned();
    };
    let [features, of_features, bytes, of_bytes] = [features, of_features, bytes, of_bytes].map(grouped);
    format!("{features} of {of_features} features were read, and {bytes} bytes; the file has {of_bytes}")
}
