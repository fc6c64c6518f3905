//! Reading a map: from a file, from standard input, or the one that is built in.

use crate::Failure;
use indicatif::{ProgressBar, ProgressStyle};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use twinedge::geometry::noding::Snap;
use twinedge::io::{ReadError, geojson};
use twinedge::map::{BuildError, Builder, Noding, PlanarMap};

/// The map of the world that is built in; see `data/README.md`.
const EMBEDDED: &[u8] = include_bytes!("../data/world-110m.geojson");
const EMBEDDED_NAME: &str = "world-110m.geojson (built in)";

/// A shape could not be read, or not be taken.
#[derive(Debug, thiserror::Error)]
enum InputError {
    #[error(transparent)]
    Read(#[from] ReadError),
    #[error(transparent)]
    Build(#[from] BuildError),
}

/// Reads a GeoJSON map into a builder: from `path`, from standard input where that is `-`, or the built-in map where there
/// is none. Gives the name of the input along with it.
fn read(path: Option<&Path>) -> Result<(String, Builder), Failure> {
    let (name, builder) = match path {
        None => (EMBEDDED_NAME.to_owned(), gather(EMBEDDED)),
        Some(path) if path == Path::new("-") => ("standard input".to_owned(), gather(io::stdin().lock())),
        Some(path) => {
            let name = path.display().to_string();
            let file = File::open(path).map_err(|error| Failure(format!("{name}: {error}")))?;
            let length = file.metadata().map_or(0, |metadata| metadata.len());
            let bar = progress(length);
            (name, gather(bar.wrap_read(file)))
        }
    };
    match builder {
        Ok(builder) => Ok((name, builder)),
        Err(error) => Err(Failure(format!("{name}: {error}"))),
    }
}

fn gather(reader: impl Read) -> Result<Builder, InputError> {
    let mut builder = Builder::new();
    geojson::read(reader, |feature| builder.feature(&feature).map(drop).map_err(InputError::from))?;
    Ok(builder)
}

/// A bar on standard error, if that is a terminal.
fn progress(bytes: u64) -> ProgressBar {
    let bar = ProgressBar::new(bytes);
    if let Ok(style) = ProgressStyle::with_template("reading {bar:40} {bytes}/{total_bytes}, {eta} left") {
        bar.set_style(style);
    }
    bar
}

/// Where a file is named on the command line.
#[derive(Debug, clap::Args)]
pub(crate) struct MapFile {
    /// A GeoJSON file, or `-` for standard input; without it, the built-in map of the world.
    file: Option<PathBuf>,

    #[command(flatten)]
    cutting: Cutting,
}

/// What is done about segments that cross, touch or overlap.
#[derive(Debug, clap::Args)]
pub(crate) struct Cutting {
    /// Cut segments wherever they cross, touch or overlap, and round everything to a grid: `auto` for one as fine as
    /// coordinates allow, or the width of its cells.
    #[arg(long, value_name = "auto|SIZE", value_parser = snap)]
    snap: Option<Snap>,
}

impl MapFile {
    /// Reads the map and builds it. Gives the name of the input along with it.
    pub(crate) fn build(&self) -> Result<(String, PlanarMap), Failure> {
        let (name, builder) = read(self.file.as_deref())?;
        let noding = self.cutting.snap.map_or(Noding::None, Noding::Snap);
        let map = builder.build_with(noding).map_err(|error| Failure(format!("{name}: {error}")))?;
        Ok((name, map))
    }
}

fn snap(text: &str) -> Result<Snap, String> {
    if text == "auto" {
        return Ok(Snap::Auto);
    }
    match text.parse() {
        Ok(size) if size > 0.0 && f64::is_finite(size) => Ok(Snap::Size(size)),
        _ => Err("neither `auto` nor a positive number".to_owned()),
    }
}
