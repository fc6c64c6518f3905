//! `twinedge sum`: adds up the parts of one work.

use crate::document::{Document, Printed};
use crate::output::{Format, print, print_bytes};
use crate::output_file::write_file;
use crate::status::{Failure, Verdict};
use crate::tile::Saved;
use serde_json::Value;
use std::collections::HashMap;
use std::path::PathBuf;
use std::time::Instant;
use twinedge_formats::layer::Crs;
use twinedge_report::{CoverageOptions, MapOptions, Options, audit_summary, merged};
use twinedge_trials::corrupt::CorruptOutcome;
use twinedge_trials::lazy::LazyOutcome;
use twinedge_trials::meshes::MeshesOutcome;
use twinedge_trials::prove::ProveOutcome;
use twinedge_trials::sample::SampleOutcome;
use twinedge_trials::soak::SoakOutcome;
use twinedge_trials::tables::TablesOutcome;
use twinedge_trials::{SumError, sum};

/// Add up the JSON output of all parts of one work.
///
/// The parts come from `prove`, `corrupt`, `tables`, `sample` or `soak` with `--shard K/N --format json`. Their sum is what one run of the
/// whole work would have printed, except for times: `elapsed_ms` is added up, and of `slowest_us` the greatest is kept. If a
/// program of `soak` fails, the counts cover the programs that were run.
///
/// Summaries of tiles, as `tile` writes them, are merged instead. Their sum is what `audit` says of the map. If two files have the same
/// tile, one of them must be left out. Tiles that are missing, or that were made without cuts where borders cross, are named by column and row.
///
/// The files must have the same command, version and arguments. All N parts must be there, each once, and none may have been
/// interrupted.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  for k in 0 1 2 3; do twinedge prove --edges 7 --shard $k/4 --format json > part-$k.json; done
  twinedge sum part-*.json
  twinedge sum part-*.json --format json | jq .ok
  twinedge sum *.summary
  twinedge sum *.summary --coverage

Exit status: 0 all is well; 1 something is wrong in the whole work; 2 a file could not be read, or the files are not all parts \
of one work.")]
pub(crate) struct Sum {
    /// JSON output of the parts, in any order.
    #[arg(required = true)]
    files: Vec<PathBuf>,

    /// For summaries of tiles: write their common summary, to which more tiles can be added, and print no report.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Of summaries of tiles: count what breaks C1 … C7 as violations, as `audit --coverage` does. Otherwise they are counted and shown.
    #[arg(long, conflicts_with = "output")]
    coverage: bool,

    /// Of summaries of tiles: accept a map without lines and polygons.
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
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
        let parts = self.files.iter().map(Part::read).collect::<Result<Vec<_>, Failure>>()?;
        if parts[0].value["command"] == Saved::COMMAND {
            return self.sum_tiles(parts, start);
        }
        let of_tiles =
            [(self.output.is_some(), "-o"), (self.coverage, "--coverage"), (self.allow_empty, "--allow-empty")];
        if let Some((_, option)) = of_tiles.into_iter().find(|(is_given, _)| *is_given) {
            return Err(Failure(format!("{option} is for summaries of tiles")));
        }
        for key in ["command", "version", "work", "on"] {
            same(&parts, key)?;
        }
        match parts[0].value["command"].as_str() {
            Some(ProveOutcome::COMMAND) => add_up::<ProveOutcome>(parts, self.format),
            Some(MeshesOutcome::COMMAND) => add_up::<MeshesOutcome>(parts, self.format),
            Some(CorruptOutcome::COMMAND) => add_up::<CorruptOutcome>(parts, self.format),
            Some(TablesOutcome::COMMAND) => add_up::<TablesOutcome>(parts, self.format),
            Some(LazyOutcome::COMMAND) => add_up::<LazyOutcome>(parts, self.format),
            Some(SampleOutcome::COMMAND) => add_up::<SampleOutcome>(parts, self.format),
            Some(SoakOutcome::COMMAND) => add_up::<SoakOutcome>(parts, self.format),
            _ => Err(Failure(format!(
                "{}: not the JSON output of prove, corrupt, tables, sample or soak, nor a summary of a tile",
                parts[0].name
            ))),
        }
    }
}

impl Sum {
    /// Merges summaries of tiles. Reports the result, or writes the merged summary.
    fn sum_tiles(&self, parts: Vec<Part>, start: Instant) -> Result<Verdict, Failure> {
        for path in ["command", "version", "crs", "summary/grid", "summary/limits"] {
            same(&parts, path)?;
        }
        let crs = parts[0].value["crs"].as_str().map(str::to_owned);
        let mut tiles = HashMap::new();
        let summary = |Part { name, value }: Part| {
            let saved: Saved = serde_json::from_value(value).map_err(|error| Failure(format!("{name}: {error}")))?;
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
        let coverage = CoverageOptions { is_rule: self.coverage, ..CoverageOptions::default() };
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
        let text = std::fs::read(path).map_err(|error| Failure(format!("{name}: {error}")))?;
        let not_json =
            |error| Failure(format!("{name}: not the JSON output of prove, corrupt, tables or soak: {error}"));
        let value = serde_json::from_slice(&text).map_err(not_json)?;
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
        return Err(Failure(format!("{name}: {key} is {value}, but {expected} in {first}: not parts of one work")));
    }
    Ok(())
}

fn add_up<O: Printed>(parts: Vec<Part>, format: Format) -> Result<Verdict, Failure> {
    let mut names = Vec::new();
    let mut documents = Vec::new();
    for Part { name, value } in parts {
        let document: Document<O> =
            serde_json::from_value(value).map_err(|error| Failure(format!("{name}: {error}")))?;
        names.push(name);
        documents.push(document);
    }
    let elapsed_ms = documents.iter().map(|document| document.elapsed_ms).sum();
    let outcomes: Vec<O> = documents.into_iter().map(|document| document.outcome).collect();
    let whole = sum(&outcomes).map_err(|error| in_words(&error, &names))?;
    let document = Document::timed(whole, elapsed_ms);
    document.print(format)?;
    Ok(document.verdict())
}

/// The error, with the name of the file.
fn in_words(error: &SumError, names: &[String]) -> Failure {
    match error.position().and_then(|position| names.get(position)) {
        Some(name) => Failure(format!("{name}: {error}")),
        None => Failure(error.to_string()),
    }
}
