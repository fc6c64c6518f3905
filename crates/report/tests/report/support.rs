//! Audits of texts in memory, with options in the words of the program, and comparisons of their reports.

use clap::Parser as _;
use serde_json::Value;
use std::error::Error;
use std::io::Cursor;
use std::path::Path;
use twinedge_report::{
    Accepted, Audited, CoverageOptions, Division, Edges, InMemory, Input, InputKind, MapOptions, Measured, MeshOptions,
    Options, ParentColumn, audit, audit_against, audit_in_tiles,
};

/// The options of an audit, in the words of the program.
#[derive(clap::Parser)]
#[command(no_binary_name = true)]
struct Words {
    #[command(flatten)]
    map: MapOptions,
    #[command(flatten)]
    coverage: CoverageOptions,
    #[command(flatten)]
    measured: Measured,
    #[command(flatten)]
    mesh: MeshOptions,
    #[arg(long)]
    list: Option<usize>,
    #[arg(long)]
    explain: bool,
    #[arg(long)]
    edges: Option<Edges>,
    #[arg(long)]
    parent_column: Option<ParentColumn>,
    #[arg(long)]
    layer: Option<String>,
    #[arg(long)]
    arcs: bool,
    #[arg(long)]
    postgis: bool,
    #[arg(long)]
    tiles: Option<u32>,
    #[arg(long)]
    memory: Option<u64>,
}

/// An audit that is asked for.
#[derive(Default)]
pub(crate) struct Asked {
    pub(crate) options: Options,
    division: Option<Division>,
    arcs: bool,
    postgis: bool,
    layer: Option<String>,
}

impl Asked {
    pub(crate) fn new(words: &str) -> Self {
        let Words {
            map,
            coverage,
            measured,
            mesh,
            list,
            explain,
            edges,
            parent_column,
            layer,
            arcs,
            postgis,
            tiles,
            memory,
        } = Words::try_parse_from(words.split_whitespace()).unwrap_or_else(|error| panic!("{error}"));
        let options = Options { list, explain, map, coverage, accepted: None, parent_column, edges, measured, mesh };
        let division = tiles.map(Division::Across).or(memory.map(Division::Within));
        Self { options, division, arcs, postgis, layer }
    }

    /// Accepts the findings of this list, and lists all findings.
    pub(crate) fn accepting(mut self, list: &[u8]) -> Self {
        self.options.accepted = Some(Accepted::read(str::from_utf8(list).unwrap()).unwrap());
        self.options.list = Some(usize::MAX);
        self
    }

    /// Audits an input with this name.
    pub(crate) fn audit(&self, name: &str, bytes: impl Into<Vec<u8>>) -> Result<Audited, twinedge_report::Error> {
        let mut input = Input { layer: self.layer.clone(), ..opened(name, bytes) };
        let kind = InputKind::of(self.postgis, self.arcs, &mut input)?;
        match self.division {
            Some(division) => audit_in_tiles(input, &self.options, division, &mut InMemory::default(), &mut |_| {}),
            None => audit(input, kind, &self.options, &mut |_| {}),
        }
    }

    /// Audits a layer by another layer.
    pub(crate) fn against(&self, bytes: &str, other: &str) -> Result<Audited, twinedge_report::Error> {
        audit_against(opened("layer", bytes), Some(opened("other", other)), &self.options, &mut |_| {})
    }
}

fn opened(name: &str, bytes: impl Into<Vec<u8>>) -> Input {
    let path = Path::new(name).extension().map(|_| Path::new(name));
    Input::new(name, Box::new(Cursor::new(bytes.into())), path)
}

/// Audits a text, whose beginning tells its format.
pub(crate) fn audited(input: impl Into<Vec<u8>>, words: &str) -> Audited {
    Asked::new(words).audit("input", input).unwrap_or_else(|error| panic!("{words}: {error}"))
}

/// Returns the report as JSON.
pub(crate) fn json(input: impl Into<Vec<u8>>, words: &str) -> Value {
    parsed(&audited(input, words))
}

pub(crate) fn parsed(audited: &Audited) -> Value {
    serde_json::from_slice(&audited.json().unwrap()).unwrap()
}

/// Returns the report for people, without colours.
pub(crate) fn text(input: impl Into<Vec<u8>>, words: &str) -> String {
    uncoloured(&audited(input, words).text().unwrap())
}

/// Asserts that people read these words.
#[track_caller]
pub(crate) fn says(input: impl Into<Vec<u8>>, options: &str, all: &[&str]) {
    let text = text(input, options);
    for words in all {
        assert!(text.contains(words), "{options}: {words}\n{text}");
    }
}

/// Removes the commands of a terminal.
pub(crate) fn uncoloured(text: &str) -> String {
    let mut pieces = text.split('\u{1b}');
    let first = pieces.next().unwrap_or_default();
    std::iter::once(first).chain(pieces.map(|piece| piece.split_once('m').unwrap().1)).collect()
}

/// Returns the reason why there is no report.
pub(crate) fn refused(input: impl Into<Vec<u8>>, words: &str) -> String {
    Asked::new(words).audit("input", input).map_or_else(|error| error.to_string(), |_| panic!("{words}: a report"))
}

/// Returns the findings as a layer. There must be no warnings.
pub(crate) fn layer(audited: &Audited) -> Value {
    let (layer, warnings) = audited.findings().unwrap();
    assert_eq!(warnings, [""; 0]);
    serde_json::from_slice(&layer).unwrap()
}

/// Returns the data of a page.
pub(crate) fn page_data(page: &str) -> Result<Value, Box<dyn Error>> {
    let (_, data) = page.split_once("<script id=\"data\" type=\"application/json\">").ok_or("no data")?;
    let (data, _) = data.split_once("</script>").ok_or("no end")?;
    Ok(serde_json::from_str(data)?)
}

/// The number of violations of each broken rule.
pub(crate) fn broken(report: &Value) -> Vec<(&str, u64)> {
    let rules = report["rules"].as_array().unwrap().iter();
    let rules = rules.map(|rule| (rule["id"].as_str().unwrap(), rule["violations"].as_u64().unwrap()));
    rules.filter(|(_, violations)| *violations > 0).collect()
}

/// Returns the content of a file of the workspace.
pub(crate) fn bytes(path: &str) -> Vec<u8> {
    std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)).unwrap()
}

/// Returns the text of a file of the workspace.
pub(crate) fn file(path: &str) -> String {
    String::from_utf8(bytes(path)).unwrap()
}

/// The map of the world, with two crossings.
pub(crate) fn crossing() -> String {
    file("tests/data/world-110m-crossing.geojson")
}

/// The map of the world.
pub(crate) fn world() -> String {
    file("crates/cli/data/world-110m.geojson")
}
