//! `twinedge sum`: merges the summaries of tiles.

use super::fact;
use crate::output::{Failure, Format, Verdict, named, print, print_bytes};
use crate::output_file::write_file;
use std::collections::HashMap;
use std::path::PathBuf;
use std::time::Instant;
use twinedge_coverage::tile::Portion;
use twinedge_layers::Crs;
use twinedge_report::{CoverageOptions, Judged, MapOptions, Options, audit_portion, merged};

/// Merge the summaries of tiles of one map.
///
/// Their sum is what `audit` says of the map. If two files have the same tile, one of them must be left out. Tiles that are missing, or
/// that were made without cuts where borders cross, are named by column and row.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge sum *.summary
  twinedge sum *.summary --coverage
  twinedge sum west/*.summary -o west.summary

Exit status: 0 all is well; 1 something is wrong in the map; 2 a file could not be read, or the files are not summaries of tiles of one map.")]
pub(crate) struct Sum {
    /// The summaries, as `tile` writes them, in any order.
    #[arg(required = true)]
    files: Vec<PathBuf>,

    /// Write the common summary, to which more tiles can be added, and print no report.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Count what breaks C1 … C7 as violations, as `audit --coverage` does. Otherwise they are counted and shown.
    #[arg(long, conflicts_with = "output")]
    coverage: bool,

    /// Accept a map without lines and polygons.
    #[arg(long, conflicts_with = "output")]
    allow_empty: bool,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

impl Sum {
    /// Reports the result, or writes the merged summary.
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
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
        let source = portions[0].source().clone();
        let whole = merged(portions)?.ok_or_else(|| Failure("there is no summary".to_owned()))?;
        if let Some(path) = &self.output {
            let inputs = self.files.iter().map(PathBuf::as_path);
            write_file(path, inputs, &whole.to_bytes())?;
            return Ok(Verdict::Sound);
        }
        let coverage = CoverageOptions { coverage: self.coverage, ..CoverageOptions::default() };
        let map = MapOptions { allow_empty: self.allow_empty, ..MapOptions::default() };
        // Only the number of a reference system identifies its units.
        let number = |name: &str| name.strip_prefix("EPSG:").and_then(|number| number.parse().ok());
        let crs = source.get(fact::CRS).map(|name| number(name).map_or_else(Crs::default, Crs::epsg));
        let mut audited = audit_portion(whole, crs, &Options { coverage, map, ..Options::default() })?;
        if let (Some(sha256), Some(Ok(bytes))) = (source.get(fact::SHA_256), source.get(fact::SIZE).map(|n| n.parse()))
        {
            audited.judged(Judged { sha256: sha256.clone(), bytes });
        }
        audited.took(start.elapsed().as_secs_f64() * 1000.0);
        match self.format {
            Format::Text => print(&audited.text()?)?,
            Format::Json => print_bytes(&audited.json()?)?,
        }
        Ok(if audited.is_valid() { Verdict::Sound } else { Verdict::Wrong })
    }
}
