//! `twinedge diff`: the differences between two reports.

use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Failure, Format, Verdict, grouped, named, plain, print, print_json};
use serde_json::Value;
use std::fmt::Write as _;
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};
use twinedge_report::Compared;

/// Compare two reports of `twinedge audit --format json`: new, gone and changed findings.
///
/// Findings are known by their ids: the rule, the features by their ids or names, and the place. A finding has changed if it has other
/// measures. A report that does not list all that was found, or whose audit did not end, is refused.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge audit --coverage may.shp --list 1000000 -o may.json
  twinedge audit --coverage june.shp --list 1000000 -o june.json
  twinedge diff may.json june.json

Exit status: 0 nothing is new; 1 something is; 2 a report could not be read.")]
pub(crate) struct Diff {
    /// The older report.
    old: PathBuf,

    /// The newer report.
    new: PathBuf,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

impl Diff {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let (old, new) = (read(&self.old)?, read(&self.new)?);
        let found = old.difference(&new);
        match self.format {
            Format::Json => print_json(&found)?,
            Format::Text => {
                let mut out = String::new();
                let lists = [
                    ("new", BAD, &found.new, &new),
                    ("changed", BAD, &found.changed, &new),
                    ("gone", GOOD, &found.gone, &old),
                ];
                for (what, style, ids, report) in lists {
                    for id in ids {
                        let line = report.get(id).map(line).unwrap_or_default();
                        writeln!(out, "{style}{what}{style:#} {id} {QUIET}{line}{QUIET:#}")?;
                    }
                }
                let [new, gone, changed] = [&found.new, &found.gone, &found.changed].map(|ids| grouped(ids.len()));
                writeln!(out, "{new} new, {gone} gone, {changed} changed, {} the same", grouped(found.same))?;
                print(&out)?;
            }
        }
        Ok(if found.new.is_empty() { Verdict::Sound } else { Verdict::Wrong })
    }
}

fn read(path: &Path) -> Result<Compared, Failure> {
    let name = path.display().to_string();
    let file = File::open(path).map_err(named(&name))?;
    let report: Value = serde_json::from_reader(BufReader::new(file)).map_err(named(&name))?;
    Compared::new(&report).map_err(named(&name))
}

fn line(one: &Value) -> String {
    let name = |feature: &Value| match feature {
        Value::String(name) => name.clone(),
        feature => {
            let known = [&feature["name"], &feature["id"]].into_iter().find_map(Value::as_str);
            known.map_or_else(|| format!("feature {}", feature["number"]), str::to_owned)
        }
    };
    let features: Vec<String> = one["features"].as_array().into_iter().flatten().map(name).collect();
    let kind = one["kind"].as_str().unwrap_or_default();
    let message = one["message"].as_str().unwrap_or_default();
    let who = if features.is_empty() { String::new() } else { format!(": {}", features.join(", ")) };
    plain(&format!("{kind}{who}; {message}; at {}", one["at"]))
}
