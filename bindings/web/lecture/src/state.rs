//! A structure as JavaScript sees it: tables, rules, violations.

use serde::Serialize;
use twinedge::dcel::Dcel;
use twinedge::validate::{Collect, Expectation, Record, Report, Rule, Table, Violation, validate};

/// The name of a record in tables and sentences.
pub(crate) fn name(record: Record) -> String {
    let letter = match record {
        Record::Vertex(_) => 'v',
        Record::HalfEdge(_) => 'h',
        Record::Boundary(_) => 'b',
        Record::Face(_) => 'f',
    };
    format!("{letter}{}", record.index())
}

/// The keys of all records, as errors print them. A removed record never passes its key on to another one.
pub(crate) fn keys(dcel: &Dcel) -> Vec<(String, Record)> {
    let vertices = dcel.vertices().map(|vertex| (format!("{:?}", vertex.key()), Record::Vertex(vertex.index())));
    let half_edges = dcel.half_edges().map(|h| (format!("{:?}", h.key()), Record::HalfEdge(h.index())));
    let boundaries = dcel.boundaries().map(|b| (format!("{:?}", b.key()), Record::Boundary(b.index())));
    let faces = dcel.faces().map(|face| (format!("{:?}", face.key()), Record::Face(face.index())));
    vertices.chain(half_edges).chain(boundaries).chain(faces).collect()
}

/// A rule and its outcome.
#[derive(Debug, Serialize)]
struct RuleState {
    id: &'static str,
    name: &'static str,
    statement: &'static str,
    violations: u64,
    /// Explains why the rule was not checked.
    unchecked: Option<String>,
}

/// A violation in the words of the validator.
#[derive(Debug, Serialize)]
struct Broken {
    rule: &'static str,
    kind: &'static str,
    message: String,
    cause: &'static str,
    remedy: &'static str,
    records: Vec<Record>,
}

/// Everything that a page shows of a structure.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct State {
    /// The tables, with the cells set by hand.
    table: Table,
    /// The tables without these cells: the structure in the picture.
    sound: Table,
    /// The keys of records, in the order of the tables. They distinguish a record from a later one with the same
    /// index.
    keys: Vec<(String, Record)>,
    /// The name of the change to undo.
    undo: Option<String>,
    /// The name of the change to redo.
    redo: Option<String>,
    /// The report on `table`.
    report: Report,
    rules: Vec<RuleState>,
    violations: Vec<Broken>,
}

fn broken(violation: &Violation) -> Broken {
    Broken {
        rule: violation.rule().id(),
        kind: violation.kind(),
        message: violation.named(name).message(),
        cause: violation.cause(),
        remedy: violation.remedy(),
        records: violation.records().into_iter().flatten().collect(),
    }
}

impl State {
    pub(crate) fn new(dcel: &Dcel, sound: Table, table: Table, undo: Option<String>, redo: Option<String>) -> Self {
        let report = validate(&table, &Expectation::plane(), Collect::All);
        let of_rule = |(rule, outcome): (Rule, twinedge::validate::RuleOutcome)| RuleState {
            id: rule.id(),
            name: rule.name(),
            statement: rule.statement(),
            violations: outcome.violations,
            unchecked: outcome.unchecked.map(|reason| reason.to_string()),
        };
        let rules = report.outcomes().map(of_rule).collect();
        let violations = report.violations().iter().map(broken).collect();
        Self { keys: keys(dcel), table, sound, undo, redo, report, rules, violations }
    }
}
