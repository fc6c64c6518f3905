//! Auditing a topology of PostGIS, as `psql` wrote it, or the arcs of TopoJSON.

use super::destination::{Destination, ReportFormat};
use super::document::{Document, Marked, RuleLine};
use super::packed::{Beside, Map, Names};
use super::write::write;
use crate::input::Input;
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{counted, grouped, not_checked, plain};
use crate::status::{Failure, Verdict};
use crate::trace::{Trace, middle};
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::time::Instant;
use twinedge::validate::{Embedding, Record, Rule};
use twinedge_formats::layer::topojson;
use twinedge_formats::postgis::{self, TopologyAudit, TopologyRule, TopologyViolation};

#[derive(Debug, Serialize)]
struct Json<'a> {
    input: &'a str,
    #[serde(flatten)]
    audit: &'a TopologyAudit,
    elapsed_ms: f64,
}

/// Reads a topology of PostGIS and prints what was found. At most `list` violations are listed.
pub(super) fn audit_postgis(
    Input { name, reader, .. }: Input,
    list: usize,
    explain: bool,
    to: Destination<'_>,
) -> Result<Verdict, Failure> {
    let start = Instant::now();
    let failed = |error| Failure(format!("{name}: {error}"));
    let topology = postgis::read(reader, list).map_err(failed)?;
    let audit = postgis::audit(&topology, list).map_err(failed)?;
    let found = Found { name: &name, audit: &audit, what: &POSTGIS, explain, elapsed_ms: elapsed_ms(start) };
    found.write(&to, &topology, |record| topology.name(record))
}

/// Reads the arcs of an object of TopoJSON and prints what was found. At most `list` violations are listed.
pub(super) fn audit_arcs(
    Input { name, mut reader, .. }: Input,
    layer: Option<&str>,
    list: usize,
    explain: bool,
    to: Destination<'_>,
) -> Result<Verdict, Failure> {
    let start = Instant::now();
    let topology = topojson::read(&mut reader, layer, list).map_err(|error| Failure(format!("{name}: {error}")))?;
    let audit = topojson::audit(&topology, list);
    let found = Found { name: &name, audit: &audit, what: &ARCS, explain, elapsed_ms: elapsed_ms(start) };
    found.write(&to, &topology, |record| topology.name(record))
}

fn elapsed_ms(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1000.0
}

/// What is audited, in words.
struct What {
    note: &'static str,
    nodes: &'static str,
    edges: &'static str,
    faces: &'static str,
    repeated: &'static str,
}

const POSTGIS: What = What {
    note: "a topology of PostGIS; records have the ids of the database",
    nodes: "nodes (V)",
    edges: "edges (E)",
    faces: "faces (F), face 0 included",
    repeated: "repeated points, which are legal",
};

const ARCS: What = What {
    note: "arcs of TopoJSON; half-edge 3 is arc 3, and ~3 is arc 3 backwards",
    nodes: "ends of arcs (V)",
    edges: "arcs at polygons (E)",
    faces: "polygons (F)",
    repeated: "repeated points",
};

/// What was found.
struct Found<'a> {
    name: &'a str,
    audit: &'a TopologyAudit,
    what: &'static What,
    explain: bool,
    elapsed_ms: f64,
}

impl Found<'_> {
    fn write(
        &self,
        to: &Destination<'_>,
        topology: &impl Embedding,
        name: impl Fn(Record) -> String,
    ) -> Result<Verdict, Failure> {
        match to.format {
            ReportFormat::Text => to.text(&self.text()?)?,
            ReportFormat::Json => {
                let json = Json { input: self.name, audit: self.audit, elapsed_ms: self.elapsed_ms };
                if self.explain { to.json(&explained(&json)?)? } else { to.json(&json)? }
            }
            ReportFormat::Geojson | ReportFormat::Html => {
                let document = self.document();
                write(&document, to, || packed(topology, name, &document))?;
            }
        }
        Ok(if self.audit.is_valid() { Verdict::Sound } else { Verdict::Wrong })
    }

    /// What was found.
    fn document(&self) -> Document {
        let Self { name, audit, what, explain, .. } = *self;
        let named = |id: &str| audit.rules().iter().find(|rule| rule.id == id).map_or("", |rule| rule.name);
        let marked = |one: &TopologyViolation| Marked {
            rule: one.rule,
            name: named(one.rule),
            kind: one.kind,
            message: one.message.clone(),
            violation: true,
            cause: explain.then_some(one.cause),
            remedy: explain.then_some(one.remedy),
            records: one.records.clone(),
            at: middle(&one.at),
            trace: Trace {
                points: if one.lines.is_empty() { one.at.clone() } else { Vec::new() },
                lines: one.lines.clone(),
                ..Trace::default()
            },
            ..Marked::default()
        };
        let rule = |rule: &TopologyRule| {
            let checked = format!("{} {}", grouped(rule.checked), rule.unit);
            let outcome = match (rule.violations, &rule.unchecked) {
                (0, None) => format!("holds for {checked}"),
                (0, Some(why)) => format!("not checked: {why}"),
                (n, _) => format!("{} in {checked}", counted(n as usize, "violation")),
            };
            RuleLine { id: rule.id, name: rule.name, statement: statement(rule.id), outcome, found: rule.violations }
        };
        let counts = audit.counts();
        Document {
            input: name.to_owned(),
            valid: audit.is_valid(),
            verdict: self.verdict(),
            notes: vec![what.note.to_owned()],
            counts: vec![
                (what.nodes, grouped(counts.nodes)),
                (what.edges, grouped(counts.edges)),
                (what.faces, grouped(counts.faces)),
                ("isolated nodes", grouped(counts.isolated_nodes)),
                ("bends", grouped(counts.bends)),
            ],
            rules: audit.rules().iter().map(rule).collect(),
            findings: audit.violations().iter().map(marked).collect(),
            total: audit.violation_count(),
            ..Document::default()
        }
    }

    fn text(&self) -> Result<String, std::fmt::Error> {
        let Self { name, audit, what, explain, elapsed_ms } = *self;
        let mut out = String::new();
        let counts = audit.counts();
        writeln!(out, "{name}\n{QUIET}{}{QUIET:#}\n", what.note)?;
        for (what, count) in [
            (what.nodes, grouped(counts.nodes)),
            (what.edges, grouped(counts.edges)),
            (what.faces, grouped(counts.faces)),
            ("components (C)", counts.components.map_or_else(|| "unknown".to_owned(), grouped)),
            ("isolated nodes", grouped(counts.isolated_nodes)),
            ("bends", grouped(counts.bends)),
            (what.repeated, grouped(counts.repeated_points)),
        ] {
            writeln!(out, "  {what:38} {count:>12}")?;
        }
        out.push('\n');
        for TopologyRule { id, name, checked, unit, violations, unchecked } in audit.rules() {
            let checked = grouped(*checked);
            write!(out, "  {id:2}  {name:10} ")?;
            match (violations, unchecked) {
                (0, None) => writeln!(out, "{GOOD}ok{GOOD:#}      {checked} {unit}")?,
                (0, Some(why)) => writeln!(out, "{QUIET}not checked: {why}{QUIET:#}")?,
                (n, why) => {
                    let why = why.as_ref().map_or_else(String::new, |why| format!("; not checked {why}"));
                    writeln!(
                        out,
                        "{BAD}BROKEN{BAD:#}  {} in {checked} {unit}{why}",
                        counted(*n as usize, "violation")
                    )?;
                }
            }
        }
        out.push('\n');
        for TopologyViolation { rule, message, at, .. } in audit.violations() {
            writeln!(out, "{BAD}{rule}{BAD:#} {}", plain(message))?;
            let at: Vec<_> = at.iter().map(|[x, y]| format!("({x}, {y})")).collect();
            if !at.is_empty() {
                writeln!(out, "   at {}", at.join(" "))?;
            }
        }
        let more = audit.violation_count().saturating_sub(audit.violations().len() as u64);
        if more > 0 {
            writeln!(out, "… and {} more; see --list", grouped(more))?;
        }
        if explain {
            let explained = audit.violations().iter().map(|one| (one.rule, one.cause, one.remedy));
            for (rule, cause, remedy) in explained.collect::<BTreeSet<_>>() {
                writeln!(out, "{rule}: usual cause: {cause}; remedy: {remedy}")?;
            }
        }
        let verdict = self.verdict();
        let (word, rest) = verdict.split_once(':').unwrap_or((&verdict, ""));
        let style = if audit.is_valid() { GOOD } else { BAD };
        writeln!(out, "{style}{word}{style:#}:{rest} ({elapsed_ms:.0} ms)")?;
        Ok(out)
    }

    /// Whether the topology is valid, in a sentence.
    fn verdict(&self) -> String {
        if self.audit.is_valid() {
            return "valid: every rule that applies holds".to_owned();
        }
        let violations = counted(self.audit.violation_count() as usize, "violation");
        format!("not valid: {violations}{}", not_checked(self.audit.unchecked_count()))
    }
}

/// What a rule says.
fn statement(id: &str) -> Option<&'static str> {
    let own = [
        ("P0", "ids are there and unique, and those of edges are positive"),
        ("P1", "every edge is a line from its start node to its end node, all in one reference system"),
        ("P2", "nodes with edges have no `containing_face`; those of the others are faces in which they lie"),
        ("P3", "every face but face 0 has edges"),
        ("P4", "`mbr` and the `abs_next_…` columns are what they are computed of"),
        ("A0", "every arc has two different positions, and every ring encloses something"),
        ("A1", "every index is that of an arc, arcs join end to end, rings close"),
        ("A2", "each side of an arc has one polygon at most, and not the same one as the other side"),
        ("A3", "some object uses the arc"),
    ];
    let of_validator = || Rule::ALL.iter().find(|rule| rule.id() == id).map(|rule| rule.statement());
    own.into_iter().find(|(own, _)| *own == id).map(|(_, says)| says).or_else(of_validator)
}

fn packed(topology: &impl Embedding, name: impl Fn(Record) -> String, document: &Document) -> Map {
    let names = Names::Ids {
        vertices: (0..topology.vertex_slots()).map(|v| name(Record::Vertex(v))).collect(),
        edges: (0..topology.half_edge_slots() / 2)
            .map(|edge| name(Record::HalfEdge(2 * edge)).trim_start_matches('+').to_owned())
            .collect(),
        faces: (0..topology.face_slots()).map(|f| name(Record::Face(f))).collect(),
    };
    Map::pack(topology, Beside { features: &|_| Vec::new(), names, windows: &document.windows() })
}

/// The same, with the usual cause and the remedy of each violation.
fn explained(json: &Json<'_>) -> Result<serde_json::Value, Failure> {
    let mut value = serde_json::to_value(json)?;
    let listed = value["violations"].as_array_mut().into_iter().flatten();
    for (object, violation) in listed.zip(json.audit.violations()) {
        object["cause"] = violation.cause.into();
        object["remedy"] = violation.remedy.into();
    }
    Ok(value)
}
