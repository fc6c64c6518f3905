//! `twinedge audit` of the three tables of a textbook.

use super::destination::{Destination, ReportFormat};
use super::document::{Document, Marked, counts, rule_lines};
use super::packed::{Beside, Map, Names};
use super::write::write;
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{counted, grouped, plain};
use crate::status::{Failure, Verdict};
use serde::Serialize;
use std::fmt::Write as _;
use std::io::Read;
use twinedge::io::tables::Textbook;
use twinedge::validate::{
    self, Collect, Expectation, REPORT_SCHEMA, Record, Report, RuleOutcome, View, validate, validate_embedding,
};

/// Whether a file that begins so has the three tables of a textbook: the first word that is no comment is a heading, or the
/// name of a vertex, a half-edge or a face.
pub(super) fn is_textbook(beginning: &[u8]) -> bool {
    let text = String::from_utf8_lossy(beginning);
    let mut lines = text.lines().map(|line| line.split('#').next().unwrap_or_default());
    let word = lines.find_map(|line| line.split([' ', '\t', '|']).find(|word| !word.is_empty()));
    let word = word.unwrap_or_default().to_lowercase();
    let is_name = |letter| {
        let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        word.strip_prefix(letter).is_some_and(|rest| rest.splitn(2, ',').all(digits))
    };
    ["vertex", "face", "half-edge", "halfedge"].contains(&word.as_str()) || ['v', 'e', 'f'].into_iter().any(is_name)
}

#[derive(Debug, Serialize)]
struct Audited<'a> {
    input: &'a str,
    schema: &'static str,
    valid: bool,
    counts: Counts,
    rules: Vec<Rule>,
    violation_count: u64,
    violations: Vec<Violation>,
}

#[derive(Debug, Serialize)]
struct Counts {
    vertices: usize,
    edges: usize,
    half_edges: usize,
    faces: usize,
    components: Option<usize>,
}

#[derive(Debug, Serialize)]
struct Rule {
    id: validate::Rule,
    name: &'static str,
    #[serde(flatten)]
    outcome: RuleOutcome,
}

#[derive(Debug, Serialize)]
struct Violation {
    rule: &'static str,
    kind: &'static str,
    records: Vec<Record>,
    /// With the names of the tables.
    message: String,
}

/// Reads the tables and validates them.
pub(super) fn audit(
    name: &str,
    mut reader: impl Read,
    list: usize,
    explain: bool,
    to: Destination<'_>,
) -> Result<Verdict, Failure> {
    let mut text = String::new();
    reader.read_to_string(&mut text).map_err(|error| Failure(format!("{name}: {error}")))?;
    let tables: Textbook = text.parse().map_err(|error| Failure(format!("{name}: {error}")))?;
    let (expectation, collect) = (Expectation::plane(), Collect::AtMost(list));
    let report = if tables.has_coordinates() {
        validate_embedding(&tables, &expectation, collect)
    } else {
        validate(&tables, &expectation, collect)
    };
    let audited = Audited::new(name, &tables, &report);
    match to.format {
        ReportFormat::Text => to.text(&audited.text(report.violation_count())?)?,
        ReportFormat::Json => to.json(&audited)?,
        ReportFormat::Geojson | ReportFormat::Html => {
            let document = document(name, &tables, &report, explain);
            write(&document, &to, || packed(&tables, &document))?;
        }
    }
    Ok(if audited.valid { Verdict::Sound } else { Verdict::Wrong })
}

/// What was found, with the names of the tables.
fn document(name: &str, tables: &Textbook, report: &Report, explain: bool) -> Document {
    let marked = |violation: &validate::Violation| {
        let named = |record: Record| tables.name(record).map_or_else(|| record.to_string(), str::to_owned);
        Marked {
            message: with_names(&violation.to_string(), tables),
            records: violation.records().into_iter().flatten().map(named).collect(),
            ..Marked::of_violation(tables, violation, explain)
        }
    };
    let no_places = "The tables have no coordinates: there is nothing to draw.";
    let count = report.violation_count();
    Document {
        input: name.to_owned(),
        valid: report.is_valid(),
        verdict: match counted(count as usize, "violation") {
            _ if report.is_valid() => "valid: every rule that applies holds".to_owned(),
            violations => format!("not valid: {violations}"),
        },
        notes: ["The three tables of a textbook."]
            .into_iter()
            .chain((!tables.has_coordinates()).then_some(no_places))
            .map(str::to_owned)
            .collect(),
        counts: counts(report),
        rules: rule_lines(report),
        findings: report.violations().iter().map(marked).collect(),
        total: count,
        ..Document::default()
    }
}

fn packed(tables: &Textbook, document: &Document) -> Map {
    let name = |record: Record| tables.name(record).unwrap_or_default().to_owned();
    let half_edges = 0..tables.half_edge_slots();
    let mutual = |h: &usize| tables.twin(*h).filter(|t| half_edges.contains(t) && tables.twin(*t) == Some(*h));
    let names = Names::Own {
        vertices: (0..tables.vertex_slots()).map(|v| name(Record::Vertex(v))).collect(),
        half_edges: half_edges.clone().map(|h| name(Record::HalfEdge(h))).collect(),
        faces: (0..tables.face_slots()).map(|f| name(Record::Face(f))).collect(),
        twins: half_edges.clone().map(|h| mutual(&h)).collect(),
    };
    Map::pack(tables, Beside { features: &|_| Vec::new(), names, windows: &document.windows() })
}

/// Makes a record of an index.
type ToRecord = fn(usize) -> Record;

/// Words after which a message of the validator has the index of a record, or two of them with an `and` between.
const BEFORE_INDEX: [(&str, ToRecord); 12] = [
    ("half-edge ", Record::HalfEdge),
    ("half-edges ", Record::HalfEdge),
    ("twin ", Record::HalfEdge),
    ("twin is ", Record::HalfEdge),
    ("next ", Record::HalfEdge),
    ("next is ", Record::HalfEdge),
    ("prev ", Record::HalfEdge),
    ("prev is ", Record::HalfEdge),
    ("vertex ", Record::Vertex),
    ("face ", Record::Face),
    ("faces ", Record::Face),
    ("bounds ", Record::Face),
];

/// A message with the names of records in place of their indices.
fn with_names(message: &str, tables: &Textbook) -> String {
    let mut out = String::new();
    // What the word before the last said, after an index.
    let mut kind: Option<ToRecord> = None;
    for (i, word) in message.split(' ').enumerate() {
        let digits = word.bytes().take_while(u8::is_ascii_digit).count();
        let (number, after) = word.split_at(digits);
        let before = BEFORE_INDEX.iter().find(|(words, _)| {
            out.strip_suffix(words.trim_end()).is_some_and(|rest| rest.is_empty() || rest.ends_with([' ', '(']))
        });
        let record = before.map(|(_, record)| *record).or(kind.filter(|_| out.ends_with(" and")));
        let named = record.zip(number.parse().ok()).and_then(|(record, index)| tables.name(record(index)));
        if i > 0 {
            out.push(' ');
        }
        out.push_str(named.unwrap_or(number));
        out.push_str(after);
        kind = record.filter(|_| named.is_some()).or(kind.filter(|_| word == "and"));
    }
    out
}

impl<'a> Audited<'a> {
    fn new(input: &'a str, tables: &Textbook, report: &Report) -> Self {
        let counts = report.counts();
        let rules = report.outcomes().map(|(rule, outcome)| Rule { id: rule, name: rule.name(), outcome });
        let violations = report.violations().iter().map(|violation| Violation {
            rule: violation.rule().id(),
            kind: violation.kind(),
            records: violation.records().into_iter().flatten().collect(),
            message: with_names(&violation.to_string(), tables),
        });
        Self {
            input,
            schema: REPORT_SCHEMA,
            valid: report.is_valid(),
            counts: Counts {
                vertices: counts.vertices,
                edges: counts.edges,
                half_edges: counts.half_edges,
                faces: counts.faces,
                components: counts.components,
            },
            rules: rules.collect(),
            violation_count: report.violation_count(),
            violations: violations.collect(),
        }
    }

    fn text(&self, count: u64) -> Result<String, std::fmt::Error> {
        let mut out = String::new();
        let Counts { vertices, half_edges, faces, .. } = self.counts;
        writeln!(out, "{}", plain(self.input))?;
        let [vertices, half_edges, faces] =
            [(vertices, "vertex"), (half_edges, "half-edge"), (faces, "face")].map(|(n, name)| counted(n, name));
        writeln!(out, "{QUIET}the three tables of a textbook: {vertices}, {half_edges}, {faces}{QUIET:#}\n")?;
        for rule in &self.rules {
            write!(out, "  {:2}  {:10} ", rule.id.id(), rule.name)?;
            match (rule.outcome.violations, rule.outcome.unchecked) {
                (0, None) => writeln!(out, "{GOOD}ok{GOOD:#}")?,
                (0, Some(why)) => writeln!(out, "{QUIET}not checked: {why}{QUIET:#}")?,
                (n, _) => writeln!(out, "{BAD}BROKEN{BAD:#}  {}", counted(n as usize, "violation"))?,
            }
        }
        out.push('\n');
        for violation in &self.violations {
            writeln!(out, "{BAD}{}{BAD:#} {}", violation.rule, plain(&violation.message))?;
        }
        let more = count.saturating_sub(self.violations.len() as u64);
        if more > 0 {
            writeln!(out, "… and {} more; see --list", grouped(more))?;
        }
        if self.valid {
            writeln!(out, "{GOOD}valid{GOOD:#}: every rule that applies holds")?;
        } else {
            writeln!(out, "{BAD}not valid{BAD:#}: {}", counted(count as usize, "violation"))?;
        }
        Ok(out)
    }
}

#[cfg(test)]
mod tests {
    use super::{is_textbook, with_names};
    use twinedge::io::tables::Textbook;

    #[test]
    fn tables_are_told_from_other_files() {
        for text in ["v1 e1,1", "# a\n\n| Vertex | IncidentEdge |", "e1,2 v1", "F3 nil", "Half-edge Origin"] {
            assert!(is_textbook(text.as_bytes()), "{text}");
        }
        for text in ["", "{}", "V 1 - 0 H 0 B 0 F 0", "POINT (1 2)", "vertices", "e", "v1x"] {
            assert!(!is_textbook(text.as_bytes()), "{text}");
        }
    }

    #[test]
    fn messages_have_the_names_of_the_tables() {
        let tables: Textbook = "V7 e3,1\nf9 nil e3,1\ne3,1 V7 e3,1 f9 e3,1 e3,1".parse().unwrap();
        for (message, expected) in [
            ("half-edge 0: vertex 0 is not vertex 12, face 0", "half-edge e3,1: vertex V7 is not vertex 12, face f9"),
            ("half-edge 0 has twin 0, whose twin is 0: both", "half-edge e3,1 has twin e3,1, whose twin is e3,1: both"),
            ("faces 0 and 0 both have 0 edges", "faces f9 and f9 both have 0 edges"),
            ("3 − 0 + 0 half-edges in 0 faces", "3 − 0 + 0 half-edges in 0 faces"),
        ] {
            assert_eq!(with_names(message, &tables), expected);
        }
    }
}
