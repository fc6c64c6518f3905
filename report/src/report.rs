//! The report of an audit, which all writers take.

use crate::accepted::{Accepted, AcceptedSummary};
use crate::coverage::Coverage;
use crate::identity::Identities;
use crate::iso;
use crate::packed::Window;
use crate::verdict::{Judged, Verdict};
use crate::words::{counted, grouped, not_checked};
use serde::Serialize;
use serde_json::{Map, Value};
use twinedge::algorithm::coverage::CoverageRule;
use twinedge::validate::{Bounds, Counts};
use twinedge_formats::diagnosis::{Diagnosis, Document, Position, RuleLine, Trace};
use twinedge_formats::layer::Crs;

/// The report of an audit.
#[derive(Debug)]
pub(crate) struct AuditReport {
    pub(crate) input: String,
    /// Every rule that applies was checked, and holds.
    pub(crate) valid: bool,
    /// The reason why more is to be known, in sentences, whatever the rules say.
    pub(crate) doubts: Vec<String>,
    pub(crate) judged: Option<Judged>,
    /// The bytes of the layer by which it was judged.
    pub(crate) judged_by: Option<Judged>,
    /// The list by which findings were accepted.
    pub(crate) accepted_before: Option<Accepted>,
    /// The fate of accepted findings, if there is a list of them.
    pub(crate) accepted: Option<AcceptedSummary>,
    /// The options, as JSON.
    pub(crate) options: Map<String, Value>,
    /// The numbers of findings, if it is not valid.
    pub(crate) found: String,
    pub(crate) notes: Vec<Note>,
    /// The counts in words.
    pub(crate) counts: Vec<(&'static str, String)>,
    pub(crate) rules: Vec<RuleLine>,
    pub(crate) violations: Vec<Diagnosis>,
    /// The number of violations, listed or not.
    pub(crate) violation_count: u64,
    /// The faults of the faces of a mesh or the findings between layers, and their number.
    pub(crate) findings: Vec<Diagnosis>,
    pub(crate) finding_count: u64,
    /// The findings of C1 … C7, for a map with polygons or lines.
    pub(crate) coverage: Option<Coverage>,
    pub(crate) style: CoverageStyle,
    /// Sentences about violations that follow from findings.
    pub(crate) remarks: Vec<&'static str>,
    pub(crate) crs: Option<Crs>,
    pub(crate) json: JsonForm,
    pub(crate) elapsed_ms: f64,
}

/// The form of findings of a coverage in text.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct CoverageStyle {
    /// They count as violations.
    pub(crate) is_rule: bool,
    /// The number of findings of each rule that are shown.
    pub(crate) worst: usize,
    /// Places have so many decimal places at most.
    pub(crate) decimals: usize,
}

/// The entries that only JSON has.
#[derive(Debug, Default)]
pub(crate) struct JsonForm {
    pub(crate) counts: Value,
    /// The bounds of T4.
    pub(crate) bounds: Option<Bounds>,
    /// Rules have their names.
    pub(crate) is_named: bool,
    /// There is a list of findings.
    pub(crate) has_findings: bool,
    /// Keys beside those of all audits.
    pub(crate) extra: Map<String, Value>,
}

/// A note on the input, in a line.
#[derive(Debug)]
pub(crate) enum Note {
    Plain(String),
    Warning(String),
    /// A detail, which is in text only.
    Detail(String),
}

impl AuditReport {
    /// Nothing is known yet.
    pub(crate) fn new(input: &str) -> Self {
        Self {
            input: input.to_owned(),
            valid: false,
            doubts: Vec::new(),
            judged: None,
            accepted: None,
            accepted_before: None,
            judged_by: None,
            options: Map::new(),
            found: String::new(),
            notes: Vec::new(),
            counts: Vec::new(),
            rules: Vec::new(),
            violations: Vec::new(),
            violation_count: 0,
            findings: Vec::new(),
            finding_count: 0,
            coverage: None,
            style: CoverageStyle::default(),
            remarks: Vec::new(),
            crs: None,
            json: JsonForm::default(),
            elapsed_ms: 0.0,
        }
    }

    /// Drops causes and remedies.
    pub(crate) fn unexplained(self) -> Self {
        let all = |all: Vec<Diagnosis>| all.into_iter().map(Diagnosis::unexplained).collect();
        Self {
            violations: all(self.violations),
            findings: all(self.findings),
            coverage: self.coverage.map(Coverage::unexplained),
            ..self
        }
    }

    /// The number of things that were found, listed or not.
    pub(crate) fn total(&self) -> u64 {
        self.violation_count + self.finding_count + self.coverage.as_ref().map_or(0, |found| found.total() as u64)
    }

    /// The listed diagnoses. Those that follow from others come last.
    pub(crate) fn listed(&self) -> impl Iterator<Item = &Diagnosis> {
        let of_coverage = self.coverage.iter().flat_map(Coverage::findings);
        let [first, last] = [false, true]
            .map(|follows| self.violations.iter().filter(move |violation| violation.follows_from.is_some() == follows));
        first.chain(&self.findings).chain(of_coverage).chain(last)
    }

    /// The verdict.
    pub(crate) fn verdict(&self) -> Verdict {
        let of_coverage = self.coverage.as_ref().filter(|_| self.style.is_rule).map_or(0, Coverage::open);
        // Those of a mesh may be no faults, if they are listed.
        let of_faces = self.finding_count > 0
            && (self.findings.is_empty() || self.findings.iter().any(|finding| finding.is_violation));
        if self.violation_count > 0 || of_coverage > 0 || of_faces {
            Verdict::Invalid
        } else if self.valid && self.doubts.is_empty() {
            Verdict::Valid
        } else {
            Verdict::Unknown
        }
    }

    /// The first thing that is wrong. What follows from something else is not, if that is listed.
    pub(crate) fn first(&self) -> Option<&Diagnosis> {
        if self.verdict() != Verdict::Invalid {
            return None;
        }
        let source = self.violations.iter().find_map(|violation| violation.follows_from);
        let is_first = |one: &&Diagnosis| one.is_violation || one.rule.is_some() && one.rule == source;
        self.listed().find(is_first)
    }

    /// Gives their ids to all findings that are listed.
    pub(crate) fn identify(&mut self) {
        let mut identities = Identities::default();
        let of_coverage = self.coverage.iter_mut().flat_map(Coverage::findings_mut);
        for one in self.violations.iter_mut().chain(&mut self.findings).chain(of_coverage) {
            one.iso = iso::measure_of(one);
            identities.identify(one);
        }
    }

    /// The listed findings that can be accepted: those of the coverage and those between layers.
    pub(crate) fn acceptable(&self) -> impl Iterator<Item = &Diagnosis> {
        let between = self.findings.iter().filter(|one| is_between_layers(one));
        self.coverage.iter().flat_map(Coverage::findings).chain(between)
    }

    /// Marks the findings that are accepted: they make nothing invalid.
    pub(crate) fn accept(&mut self, accepted: &Accepted) {
        let between = self.findings.iter_mut().filter(|one| is_between_layers(one));
        let (summary, lines) = accepted.mark(self.coverage.iter_mut().flat_map(Coverage::findings_mut).chain(between));
        for rule in &mut self.rules {
            let accepted = self.findings.iter().filter(|one| one.rule == Some(rule.id) && one.accepted.is_some());
            rule.violations -= accepted.count() as u64;
        }
        self.notes.push(Note::Plain(format!("{} accepted", counted(summary.count, "finding"))));
        self.notes.extend(lines.into_iter().map(Note::Plain));
        self.recount();
        self.accepted = Some(summary);
        self.accepted_before = Some(accepted.clone());
    }

    /// Counts the violations of a map anew, as the findings of its coverage and those between layers are now.
    pub(crate) fn recount(&mut self) {
        let open = self.coverage.as_ref().filter(|_| self.style.is_rule).map_or(0, Coverage::open);
        let accepted = self.findings.iter().filter(|one| one.accepted.is_some()).count();
        let between = self.finding_count as usize - accepted;
        self.found = counted(self.violation_count as usize + open + between, "violation");
    }

    /// The number of rules that were not checked.
    fn open(&self) -> usize {
        let open = self.rules.iter().filter(|rule| rule.is_open()).count();
        // All but C6.
        let is_open = self.coverage.as_ref().is_some_and(|coverage| coverage.not_checked().is_some());
        open + if self.style.is_rule && is_open { CoverageRule::ALL.len() - 1 } else { 0 }
    }

    /// The reason why the verdict is not known, in sentences.
    pub(crate) fn unknown(&self) -> Vec<String> {
        if self.verdict() != Verdict::Unknown {
            return Vec::new();
        }
        let open = match self.open() {
            0 => None,
            1 => Some("1 rule was not checked".to_owned()),
            n => Some(format!("{} rules were not checked", grouped(n))),
        };
        open.into_iter().chain(self.doubts.iter().cloned()).collect()
    }

    /// The verdict, in a sentence.
    pub(crate) fn sentence(&self) -> String {
        if self.verdict() == Verdict::Valid {
            let beside = self.coverage.as_ref().map(Coverage::beside).unwrap_or_default();
            return format!("valid: every rule that applies holds{beside}");
        }
        if self.verdict() == Verdict::Unknown {
            return format!("unknown: nothing wrong was found, and {}", self.unknown().join("; "));
        }
        format!("not valid: {}{}", self.found, not_checked(self.open()))
    }

    /// The name of the rule that a finding breaks.
    pub(crate) fn name_of_rule(&self, one: &Diagnosis) -> &'static str {
        let rule = self.rules.iter().find(|rule| Some(rule.id) == one.rule);
        rule.map_or(one.kind.name(), |rule| rule.name)
    }

    /// The unit of lengths, if there are any.
    pub(crate) fn unit(&self) -> Option<&'static str> {
        self.coverage.as_ref().filter(|coverage| coverage.has_polygons()).map(Coverage::unit)
    }

    /// Around each finding.
    pub(crate) fn windows(&self) -> Vec<Window> {
        let of = |one: &Diagnosis| {
            let Trace { points, lines, polygons } = &one.trace;
            let rings = polygons.iter().flatten().chain(lines).flatten();
            Window::around(rings.chain(points).chain(&one.look))
        };
        self.listed().filter_map(of).collect()
    }

    /// The audit as one JSON object.
    pub(crate) fn json(&self) -> impl Serialize + '_ {
        #[derive(Serialize)]
        struct Json<'a> {
            input: &'a str,
            verdict: Verdict,
            #[serde(skip_serializing_if = "Vec::is_empty")]
            unknown: Vec<String>,
            first: Option<First<'a>>,
            judged: Option<&'a Judged>,
            #[serde(skip_serializing_if = "Option::is_none")]
            judged_by: Option<&'a Judged>,
            version: &'static str,
            #[serde(skip_serializing_if = "Option::is_none")]
            accepted: Option<&'a AcceptedSummary>,
            options: &'a Map<String, Value>,
            #[serde(flatten)]
            document: Document<'a, &'a Value>,
            #[serde(flatten)]
            extra: &'a Map<String, Value>,
            #[serde(skip_serializing_if = "Option::is_none")]
            coverage: Option<&'a Coverage>,
            elapsed_ms: f64,
        }
        let JsonForm { counts, bounds, is_named, has_findings, extra } = &self.json;
        let verdict = self.verdict();
        let mut document = Document::new(verdict == Verdict::Valid, counts, &self.rules)
            .bounds(*bounds)
            .violations(&self.violations, self.violation_count);
        if *is_named {
            document = document.named(&self.rules);
        }
        if *has_findings {
            document = document.findings(&self.findings, self.finding_count);
        }
        Json {
            input: &self.input,
            verdict,
            unknown: self.unknown(),
            first: self.first().map(|one| First { rule: one.rule, id: one.id.as_deref(), at: one.look }),
            judged: self.judged.as_ref(),
            judged_by: self.judged_by.as_ref(),
            version: env!("CARGO_PKG_VERSION"),
            accepted: self.accepted.as_ref(),
            options: &self.options,
            document,
            extra,
            coverage: self.coverage.as_ref(),
            elapsed_ms: self.elapsed_ms,
        }
    }
}

/// Returns true if it breaks one of the rules X1 … X6.
fn is_between_layers(one: &Diagnosis) -> bool {
    one.rule.is_some_and(|rule| rule.starts_with('X'))
}

/// The first thing that is wrong, in JSON.
#[derive(Serialize)]
struct First<'a> {
    rule: Option<&'static str>,
    id: Option<&'a str>,
    at: Option<Position>,
}

/// The words for the number of faces.
pub(crate) const FACES: &str = "faces (F), the unbounded one included";

/// The numbers of records, in words.
pub(crate) fn counts(counts: &Counts) -> Vec<(&'static str, String)> {
    let or_unknown = |n: Option<usize>| n.map_or_else(|| "unknown".to_owned(), grouped);
    vec![
        ("vertices (V)", grouped(counts.vertices)),
        ("edges (E)", grouped(counts.edges)),
        ("half-edges", grouped(counts.half_edges)),
        (FACES, grouped(counts.faces)),
        ("components (C)", or_unknown(counts.components)),
        ("outer boundary components", grouped(counts.outer_boundaries)),
        ("inner boundary components", grouped(counts.inner_boundaries)),
        ("isolated vertices", grouped(counts.isolated_vertices)),
        ("genus", or_unknown(counts.genus)),
    ]
}
