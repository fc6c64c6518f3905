//! `twinedge sum`: merges the summaries of tiles.

use super::Saved;
use crate::output::{Failure, Format, Verdict, named, print, print_bytes};
use crate::output_file::write_file;
use serde_json::Value;
use std::collections::HashMap;
use std::path::PathBuf;
use std::time::Instant;
use twinedge_layers::Crs;
use twinedge_report::{CoverageOptions, MapOptions, Options, audit_summary, merged};

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

/// A part, and its file.
struct Part {
    name: String,
    value: Value,
}

impl Sum {
    /// Reports the result, or writes the merged summary.
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
        let parts = self.files.iter().map(Part::read).collect::<Result<Vec<_>, Failure>>()?;
        if parts[0].value["command"] != Saved::COMMAND {
            return Err(named(&parts[0].name)("not a summary of a tile"));
        }
        for path in ["command", "version", "crs", "summary/grid", "summary/limits"] {
            same(&parts, path)?;
        }
        let crs = parts[0].value["crs"].as_str().map(str::to_owned);
        let mut tiles = HashMap::new();
        let summary = |Part { name, value }: Part| {
            let saved: Saved = serde_json::from_value(value).map_err(named(&name))?;
            for tile in saved.summary.tiles() {
                if let Some(other) = tiles.insert(*tile, name.clone()) {
                    return Err(Failure(format!("{name}: tile {tile} is in {other}, too")));
                }
            }
            Ok((saved.summary, saved.cut))
        };
        let summaries = parts.into_iter().map(summary).collect::<Result<Vec<_>, Failure>>()?;
        let (summaries, of_cut): (Vec<_>, Vec<_>) = summaries.into_iter().unzip();
        let whole = merged(summaries)?.ok_or_else(|| Failure("there is no summary".to_owned()))?;
        let cut = merged(of_cut.into_iter().flatten().collect())?;
        if let Some(path) = &self.output {
            let inputs = self.files.iter().map(PathBuf::as_path);
            write_file(path, inputs, &Saved::bytes(crs, whole, cut)?)?;
            return Ok(Verdict::Sound);
        }
        let coverage = CoverageOptions { coverage: self.coverage, ..CoverageOptions::default() };
        let map = MapOptions { allow_empty: self.allow_empty, ..MapOptions::default() };
        // Only the number of a reference system identifies its units.
        let number = |name: &str| name.strip_prefix("EPSG:").and_then(|number| number.parse().ok());
        let crs = crs.map(|name| number(&name).map_or_else(Crs::default, Crs::epsg));
        let mut audited = audit_summary(whole, cut, crs, &Options { coverage, map, ..Options::default() })?;
        audited.took(start.elapsed().as_secs_f64() * 1000.0);
        match self.format {
            Format::Text => print(&audited.text()?)?,
            Format::Json => print_bytes(&audited.json()?)?,
        }
        Ok(if audited.is_valid() { Verdict::Sound } else { Verdict::Wrong })
    }
}

impl Part {
    fn read(path: &PathBuf) -> Result<Self, Failure> {
        let name = path.display().to_string();
        let text = std::fs::read(path).map_err(named(&name))?;
        let value =
            serde_json::from_slice(&text).map_err(|error| named(&name)(format!("not a summary of a tile: {error}")))?;
        Ok(Self { name, value })
    }
}

/// Refuses parts that differ in a value that identifies the work, given by the path of its keys. Keys below it are compared one by one.
fn same(parts: &[Part], path: &str) -> Result<(), Failure> {
    let (first, key) = (&parts[0], path.rsplit('/').next().unwrap_or(path));
    let at_path = |part: &Part| part.value.pointer(&format!("/{path}")).cloned().unwrap_or_default();
    let expected = &at_path(first);
    for part in &parts[1..] {
        let value = &at_path(part);
        if value == expected {
            continue;
        }
        let keys = expected.as_object().into_iter().flat_map(serde_json::Map::keys);
        let below = keys.into_iter().find(|key| value[key.as_str()] != expected[key.as_str()]);
        let (key, value, expected) = match below {
            Some(below) => (below.as_str(), &value[below.as_str()], &expected[below.as_str()]),
            None => (key, value, expected),
        };
        let (name, first) = (&part.name, &first.name);
        return Err(Failure(format!("{name}: {key} is {value}, but {expected} in {first}: not tiles of one map")));
    }
    Ok(())
}
