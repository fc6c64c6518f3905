//! `twinedge sum`: merges the summaries of tiles.

use super::fact;
use crate::audit::{Report, ReportFormat};
use crate::input::open;
use crate::output::{Failure, Verdict, named};
use crate::output_file::write_file;
use std::collections::HashMap;
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::time::Instant;
use twinedge_coverage::tile::{Portion, Source};
use twinedge_layers::Crs;
use twinedge_report::{
    CoverageOptions, Imported, Judged, Keep, MapOptions, Options, TiledLayer, audit_portion, merged,
};

/// Merge the summaries of tiles of one map.
///
/// Their sum is what `audit` says of the map. If two files have the same tile, one of them must be left out. Tiles that are missing, or
/// that were made without cuts where borders cross, are named by number.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge sum *.summary
  twinedge sum *.summary --of parcels.geojson --coverage --accept accepted.json
  twinedge sum west/*.summary --merge west.summary

Exit status: 0 all is well; 1 something is wrong in the map; 2 a file could not be read, or the files are not summaries of tiles of one map.")]
pub(crate) struct Sum {
    /// The summaries, as `tile` writes them, in any order.
    #[arg(required = true)]
    files: Vec<PathBuf>,

    /// The file that the tiles were made of, read for the names and ids of its features, on which the ids of findings depend. Otherwise features are known by
    /// their numbers.
    #[arg(long, value_name = "FILE")]
    of: Option<PathBuf>,

    /// Take the names of features from this column, as `audit` does.
    #[arg(long, value_name = "COLUMN", requires = "of")]
    name_from: Option<String>,

    /// Write the common summary, to which more tiles can be added, and print no report.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["of", "coverage", "allow_empty", "format", "output", "list", "explain", "accept", "accept_all"])]
    merge: Option<PathBuf>,

    /// Count what breaks C1 … C7 as violations, as `audit --coverage` does. Otherwise they are counted and shown.
    #[arg(long)]
    coverage: bool,

    /// Accept a map without lines and polygons.
    #[arg(long)]
    allow_empty: bool,

    #[command(flatten)]
    report: Report,
}

impl Sum {
    /// Reports the result, or writes the merged summary.
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
        let inputs = || self.files.iter().chain(&self.of).map(PathBuf::as_path);
        let to = self.report.destination(inputs())?;
        if to.format == ReportFormat::Html {
            return Err(Failure("the format html is for whole maps, and tiles keep no map to draw".to_owned()));
        }
        let (source, whole) = self.merged()?;
        if let Some(path) = &self.merge {
            write_file(path, inputs(), &whole.to_bytes())?;
            return Ok(Verdict::Sound);
        }
        let coverage = CoverageOptions { coverage: self.coverage, ..CoverageOptions::default() };
        let map =
            MapOptions { allow_empty: self.allow_empty, name_from: self.name_from.clone(), ..MapOptions::default() };
        let options = self.report.options(self.report.accepted()?, Options { coverage, map, ..Options::default() });
        let size = source.get(fact::SIZE).and_then(|bytes| bytes.parse().ok());
        let judged = source.get(fact::SHA_256).cloned().zip(size).map(|(sha256, bytes)| Judged { sha256, bytes });
        let (layer, name) = match &self.of {
            Some(path) => (read(path, &source, judged.as_ref(), &options.map)?, path.display().to_string()),
            None => (TiledLayer::Unread { ids: Vec::new(), are_all: true, crs: crs(&source) }, "the tiles".to_owned()),
        };
        let mut audited = audit_portion(whole, layer, &options)?;
        if let Some(judged) = judged {
            audited.judged(judged);
        }
        audited.took(start.elapsed().as_secs_f64() * 1000.0);
        self.report.write(&audited, &options, &name, &to)
    }

    /// Reads and merges the summaries. Returns their source, too.
    fn merged(&self) -> Result<(Source, Portion), Failure> {
        let (mut portions, mut tiles): (Vec<Portion>, _) = (Vec::new(), HashMap::new());
        for path in &self.files {
            let name = path.display().to_string();
            let bytes = std::fs::read(path).map_err(named(&name))?;
            let portion = Portion::from_bytes(&bytes).map_err(named(&name))?;
            for tile in portion.summary().tiles() {
                if let Some(other) = tiles.insert(*tile, name.clone()) {
                    return Err(Failure(format!("{name}: tile {tile} is in {other}, too")));
                }
            }
            if let Some(Err(why)) = portions.first().map(|first| first.belongs_to(&portion)) {
                let (one, other) = (self.files[0].display(), &name);
                return Err(Failure(format!("{one} and {other}: {why}")));
            }
            portions.push(portion);
        }
        let whole = merged(portions)?.ok_or_else(|| Failure("there is no summary".to_owned()))?;
        Ok((whole.source().clone(), whole))
    }
}

/// Reads the layer of the tiles; refuses another file, if their bytes are known.
fn read(path: &Path, source: &Source, judged: Option<&Judged>, options: &MapOptions) -> Result<TiledLayer, Failure> {
    let name = path.display().to_string();
    if let Some(of_tiles) = judged {
        let found = File::open(path).and_then(|file| Judged::of(BufReader::new(file))).map_err(named(&name))?;
        if found.sha256 != of_tiles.sha256 {
            let (one, other) = (&of_tiles.sha256, found.sha256);
            return Err(Failure(format!(
                "{name}: the tiles were made of another file: sha256 is {one} for them and {other} for this file"
            )));
        }
    }
    let input = open(Some(path), source.get(fact::LAYER).map(String::as_str))?;
    let imported = Imported::features(input, options, Keep::default(), &mut |_| Ok(()));
    Ok(TiledLayer::Read(Box::new(imported.map_err(named(&name))?)))
}

/// The reference system of the tiles. Only its number identifies its units.
fn crs(source: &Source) -> Option<Box<Crs>> {
    let number = |name: &str| name.strip_prefix("EPSG:").and_then(|number| number.parse().ok());
    source.get(fact::CRS).map(|name| Box::new(number(name).map_or_else(Crs::default, Crs::epsg)))
}
