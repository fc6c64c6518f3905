//! The output of the long commands, as text or JSON, and the command that adds up the JSON of parts.

use crate::output::style::{BAD, GOOD};
use crate::output::{Failure, Format, Verdict, named};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::fmt;
use std::path::PathBuf;
use std::time::Duration;
use twinedge_trials::corrupt::CorruptResults;
use twinedge_trials::lazy::LazyResults;
use twinedge_trials::meshes::MeshesResults;
use twinedge_trials::prove::ProveResults;
use twinedge_trials::sample::SampleResults;
use twinedge_trials::soak::SoakResults;
use twinedge_trials::tables::TablesResults;
use twinedge_trials::{Outcome, Results, sum};

/// The results of a long command.
pub(crate) trait Printed: Results<Work: Serialize + DeserializeOwned> + Serialize + DeserializeOwned {
    const COMMAND: &'static str;

    /// Writes everything in front of the verdict.
    fn describe(outcome: &Outcome<Self>, f: &mut fmt::Formatter<'_>) -> fmt::Result;

    /// Returns the verdict in words if the run was finished: the coloured beginning, and the rest.
    fn verdict(outcome: &Outcome<Self>, is_ok: bool) -> (String, String);

    /// Returns true if the outcome has errors, even if the run was interrupted.
    fn is_wrong(outcome: &Outcome<Self>) -> bool {
        !outcome.interrupted && !outcome.is_ok()
    }
}

/// The end of the verdict on a part of the work, whose counts are compared only in the sum.
pub(crate) const IN_THIS_PART: &str = " in this part; `twinedge-trials sum` compares the counts";

/// An outcome, with everything that identifies the work.
#[derive(Serialize, Deserialize)]
#[serde(bound = "")]
pub(crate) struct Document<R: Printed> {
    command: String,
    version: String,
    #[serde(flatten)]
    outcome: Outcome<R>,
    ok: bool,
    elapsed_ms: f64,
}

impl<R: Printed> Document<R> {
    pub(crate) fn new(outcome: Outcome<R>, elapsed: Duration) -> Self {
        Self::timed(outcome, elapsed.as_secs_f64() * 1000.0)
    }

    fn timed(outcome: Outcome<R>, elapsed_ms: f64) -> Self {
        let (command, version) = (R::COMMAND.to_owned(), env!("CARGO_PKG_VERSION").to_owned());
        Self { command, version, ok: outcome.is_ok(), outcome, elapsed_ms }
    }

    pub(crate) fn verdict(&self) -> Verdict {
        match (R::is_wrong(&self.outcome), self.outcome.interrupted) {
            (false, true) => Verdict::Interrupted,
            (is_wrong, _) => Verdict::of(!is_wrong),
        }
    }
}

impl<R: Printed> fmt::Display for Document<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { outcome, ok, elapsed_ms, .. } = self;
        if outcome.interrupted {
            write!(f, "{BAD}interrupted{BAD:#}: this is what was covered\n\n")?;
        }
        if !outcome.shard.is_whole() {
            let shard = outcome.shard;
            write!(f, "Part {shard}, counted from 0; `twinedge-trials sum` adds up the JSON output of all parts\n\n")?;
        }
        R::describe(outcome, f)?;
        let style = if *ok { GOOD } else { BAD };
        let (verdict, rest) =
            if outcome.interrupted { ("not finished".to_owned(), String::new()) } else { R::verdict(outcome, *ok) };
        writeln!(f, "{style}{verdict}{style:#}{rest} ({:.1} s)", elapsed_ms / 1000.0)
    }
}

/// Add up the JSON output of all parts of one work.
///
/// The parts come from `prove`, `corrupt`, `tables`, `sample` or `soak` with `--shard K/N --format json`. Their sum is what one run of the
/// whole work would have printed, except for times: `elapsed_ms` is added up, and of `slowest_us` the greatest is kept. If a
/// program of `soak` fails, the counts cover the programs that were run.
///
/// The files must have the same command, version and arguments. All N parts must be there, each once, and none may have been
/// interrupted.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  for k in 0 1 2 3; do twinedge-trials prove --edges 7 --shard $k/4 --format json > part-$k.json; done
  twinedge-trials sum part-*.json
  twinedge-trials sum part-*.json --format json | jq .ok

Exit status: 0 all is well; 1 something is wrong in the whole work; 2 a file could not be read, or the files are not all parts \
of one work.")]
pub(crate) struct Sum {
    /// JSON output of the parts, in any order.
    #[arg(required = true)]
    files: Vec<PathBuf>,

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
        let parts = self.files.iter().map(Part::read).collect::<Result<Vec<_>, Failure>>()?;
        for key in ["command", "version", "work", "on"] {
            same(&parts, key)?;
        }
        match parts[0].value["command"].as_str() {
            Some(ProveResults::COMMAND) => self.add_up::<ProveResults>(parts),
            Some(MeshesResults::COMMAND) => self.add_up::<MeshesResults>(parts),
            Some(CorruptResults::COMMAND) => self.add_up::<CorruptResults>(parts),
            Some(TablesResults::COMMAND) => self.add_up::<TablesResults>(parts),
            Some(LazyResults::COMMAND) => self.add_up::<LazyResults>(parts),
            Some(SampleResults::COMMAND) => self.add_up::<SampleResults>(parts),
            Some(SoakResults::COMMAND) => self.add_up::<SoakResults>(parts),
            _ => Err(named(&parts[0].name)("not the JSON output of prove, corrupt, tables, sample or soak")),
        }
    }

    fn add_up<R: Printed>(&self, parts: Vec<Part>) -> Result<Verdict, Failure> {
        let mut names = Vec::new();
        let mut outcomes = Vec::new();
        let mut elapsed_ms = 0.0;
        for Part { name, value } in parts {
            let document: Document<R> = serde_json::from_value(value).map_err(named(&name))?;
            names.push(name);
            outcomes.push(document.outcome);
            elapsed_ms += document.elapsed_ms;
        }
        let whole =
            sum(&outcomes).map_err(|error| match error.position().and_then(|position| names.get(position)) {
                Some(name) => named(name)(error),
                None => error.into(),
            })?;
        let document = Document::timed(whole, elapsed_ms);
        self.format.print(&document)?;
        Ok(document.verdict())
    }
}

impl Part {
    fn read(path: &PathBuf) -> Result<Self, Failure> {
        let name = path.display().to_string();
        let text = std::fs::read(path).map_err(named(&name))?;
        let not_json =
            |error| named(&name)(format!("not the JSON output of prove, corrupt, tables, sample or soak: {error}"));
        let value = serde_json::from_slice(&text).map_err(not_json)?;
        Ok(Self { name, value })
    }
}

/// Refuses parts that differ in a value that identifies the work. Keys below it are compared one by one.
fn same(parts: &[Part], key: &str) -> Result<(), Failure> {
    let (Part { name: first, value: expected }, others) = (&parts[0], &parts[1..]);
    for Part { name, value } in others {
        let (value, expected) = (&value[key], &expected[key]);
        if value == expected {
            continue;
        }
        let mut keys = expected.as_object().into_iter().flat_map(serde_json::Map::keys);
        let (key, value, expected) = match keys.find(|key| value[key.as_str()] != expected[key.as_str()]) {
            Some(below) => (below.as_str(), &value[below.as_str()], &expected[below.as_str()]),
            None => (key, value, expected),
        };
        return Err(named(name)(format!("{key} is {value}, but {expected} in {first}: not parts of one work")));
    }
    Ok(())
}
