//! The report of an audit, the input of all writers.

use crate::accepted::{Accepted, AcceptedSummary};
use crate::coverage::Coverage;
use crate::identity::Identities;
use crate::iso_measure::measure_of;
use crate::packed::Window;
use crate::trace::has_place;
use crate::verdict::{Judged, Verdict};
use crate::words::{counted, grouped, not_checked};
use crate::{causes, diagnosis_text};
use serde::Serialize;
use serde_json::{Map, Value};
use std::collections::HashMap;
use twinedge::validate::{Bounds, Counts, Rule};
use twinedge_coverage::CoverageRule;
use twinedge_diagnosis::{Diagnosis, Document, Position, Reason, RuleLine, Trace};
use twinedge_layers::Crs;

#[derive(Debug)]
pub(crate) struct AuditReport {
    pub(crate) input: String,
    /// Every rule that applies was checked and holds, regardless of accepted findings.
    pub(crate) valid: bool,
    /// Reasons, in sentences, why the verdict stays unknown even if the rules hold.
    pub(crate) doubts: Vec<String>,
    pub(crate) judged: Option<Judged>,
    /// The bytes of the other layer.
    pub(crate) judged_by: Option<Judged>,
    pub(crate) accepted_before: Option<Accepted>,
    pub(crate) accepted: Option<AcceptedSummary>,
    pub(crate) options: Map<String, Value>,
    pub(crate) notes: Vec<Note>,
    pub(crate) counts: Vec<(&'static str, String)>,
    pub(crate) rules: Vec<RuleLine>,
    pub(crate) violations: Vec<Diagnosis>,
    /// The number of all violations, listed or not.
    pub(crate) violation_count: u64,
    /// The listed faults of a mesh's faces or findings between layers; `finding_count` counts all.
    pub(crate) findings: Vec<Diagnosis>,
    pub(crate) finding_count: u64,
    /// The findings of C1 … C7, for a map with polygons or lines.
    pub(crate) coverage: Option<Coverage>,
    pub(crate) style: CoverageStyle,
    /// Sentences on violations that follow from findings.
    pub(crate) remarks: Vec<&'static str>,
    pub(crate) crs: Option<Crs>,
    pub(crate) json: JsonForm,
    pub(crate) elapsed_ms: f64,
}

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct CoverageStyle {
    /// True if findings count as violations.
    pub(crate) is_rule: bool,
    /// The number of findings to show for each rule. `None` shows a few, and only counts consequences.
    pub(crate) list: Option<usize>,
    pub(crate) decimals: usize,
}

#[derive(Debug, Default)]
pub(crate) struct JsonForm {
    pub(crate) counts: Value,
    pub(crate) bounds: Option<Bounds>,
    /// True if rules are given with their names.
    pub(crate) is_named: bool,
    /// True if there is a list of findings.
    pub(crate) has_findings: bool,
    /// The keys specific to the kind of input.
    pub(crate) extra: Map<String, Value>,
}

#[derive(Debug)]
pub(crate) enum Note {
    Plain(String),
    Warning(String),
    /// A detail, shown only in text.
    Detail(String),
}

impl AuditReport {
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

    pub(crate) fn unexplained(self) -> Self {
        let all = |all: Vec<Diagnosis>| all.into_iter().map(Diagnosis::unexplained).collect();
        Self {
            violations: all(self.violations),
            findings: all(self.findings),
            coverage: self.coverage.map(Coverage::unexplained),
            ..self
        }
    }

    /// The number of all findings, listed or not.
    pub(crate) fn total(&self) -> u64 {
        self.violation_count + self.finding_count + self.coverage.as_ref().map_or(0, |found| found.total() as u64)
    }

    /// Returns the listed diagnoses: causes first, in terms of features before structure; then consequences.
    pub(crate) fn listed(&self) -> impl Iterator<Item = &Diagnosis> {
        let all = || {
            let of_coverage = self.coverage.iter().flat_map(Coverage::findings);
            self.findings.iter().chain(of_coverage).chain(&self.violations)
        };
        let follows = |placed: bool| all().filter(move |one| one.follows_from.is_some() && has_place(one) == placed);
        all().filter(|one| one.follows_from.is_none()).chain(follows(true)).chain(follows(false))
    }

    /// Returns the listed consequences, by the ids of their causes.
    pub(crate) fn consequences(&self) -> HashMap<&str, Vec<&Diagnosis>> {
        let mut found: HashMap<&str, Vec<&Diagnosis>> = HashMap::new();
        for one in self.listed().filter(|one| one.accepted.is_none()) {
            if let Some(id) = &one.follows_from_id {
                found.entry(id).or_default().push(one);
            }
        }
        found
    }

    /// Returns the numbers of unaccepted causes and of unaccepted consequences. A diagnosis that is not listed counts as a cause.
    pub(crate) fn causes(&self) -> [usize; 2] {
        let open = |follows: bool| {
            self.listed().filter(move |one| one.accepted.is_none() && one.follows_from.is_some() == follows).count()
        };
        [open(false) + self.unlisted(), open(true)]
    }

    fn unlisted(&self) -> usize {
        (self.total() as usize).saturating_sub(self.listed().count())
    }

    fn open_violations(&self) -> u64 {
        let accepted = self.violations.iter().filter(|one| one.accepted.is_some()).count();
        self.violation_count.saturating_sub(accepted as u64)
    }

    pub(crate) fn verdict(&self) -> Verdict {
        let of_coverage = self.coverage.as_ref().filter(|_| self.style.is_rule).map_or(0, Coverage::open);
        // Findings of a mesh may be harmless; the list shows it.
        let of_faces = self.finding_count > 0
            && (self.findings.is_empty() || self.findings.iter().any(|finding| finding.is_violation));
        if self.open_violations() > 0 || of_coverage > 0 || of_faces {
            Verdict::Invalid
        } else if self.holds() && self.doubts.is_empty() {
            Verdict::Valid
        } else {
            Verdict::Unknown
        }
    }

    /// Returns true if every rule that applies was checked and holds, apart from accepted findings.
    fn holds(&self) -> bool {
        let is_accepted = self.violation_count > 0 && self.open() == 0;
        self.valid || is_accepted
    }

    /// Returns the first cause.
    pub(crate) fn first(&self) -> Option<&Diagnosis> {
        if self.verdict() != Verdict::Invalid {
            return None;
        }
        self.listed().find(|one| one.is_violation)
    }

    pub(crate) fn identify(&mut self) {
        let mut identities = Identities::default();
        let of_coverage = self.coverage.iter_mut().flat_map(Coverage::findings_mut);
        for one in self.violations.iter_mut().chain(&mut self.findings).chain(of_coverage) {
            one.iso = measure_of(one);
            identities.identify(one);
        }
    }

    /// Returns the listed findings that can be accepted: findings of the coverage and between layers.
    pub(crate) fn acceptable(&self) -> impl Iterator<Item = &Diagnosis> {
        let between = self.findings.iter().filter(|one| is_between_layers(one));
        self.coverage.iter().flat_map(Coverage::findings).chain(between)
    }

    /// Marks accepted findings, which make nothing invalid, and then records the cause of each finding.
    pub(crate) fn settle(&mut self, accepted: Option<&Accepted>) {
        if let Some(accepted) = accepted {
            let between = self.findings.iter_mut().filter(|one| is_between_layers(one));
            let of_coverage = self.coverage.iter_mut().flat_map(Coverage::findings_mut);
            let (summary, lines) = accepted.mark(of_coverage.chain(between));
            self.notes.push(Note::Plain(format!("{} accepted", counted(summary.count, "finding"))));
            self.notes.extend(lines.into_iter().map(Note::Plain));
            self.accepted = Some(summary);
            self.accepted_before = Some(accepted.clone());
        }
        for one in &mut self.violations {
            one.sentence = diagnosis_text::sentence(one, self.style.decimals);
        }
        let clashes = self.rules.iter().find(|rule| rule.id == Rule::G4.id()).map_or(0, |rule| rule.violations);
        if let Some(coverage) = &mut self.coverage {
            causes::trace(coverage.findings_mut(), &mut self.violations, clashes);
        }
        for rule in &mut self.rules {
            let all = self.findings.iter().chain(&self.violations);
            let accepted = all.filter(|one| one.rule == Some(rule.id) && one.accepted.is_some()).count();
            rule.violations = rule.violations.saturating_sub(accepted as u64);
        }
    }

    /// The number of unchecked rules. A rule that relies on another rule counts as accepted if all violations of that rule are accepted.
    fn open(&self) -> usize {
        let is_accepted = |rule: Rule| {
            let line = self.rules.iter().find(|line| line.id == rule.id());
            line.is_some_and(|line| line.violations == 0 && line.unchecked.is_none())
        };
        let is_open = |line: &&RuleLine| {
            let broken = line.unchecked.and_then(Reason::broken);
            line.is_open() && !broken.is_some_and(is_accepted)
        };
        let open = self.rules.iter().filter(is_open).count();
        // Only C6 was checked.
        let is_open = self.coverage.as_ref().is_some_and(|coverage| coverage.not_checked().is_some());
        open + if self.style.is_rule && is_open { CoverageRule::ALL.len() - 1 } else { 0 }
    }

    /// The reasons, in sentences, why the verdict is unknown.
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

    /// Returns the verdict in a sentence. If the coverage has findings, the sentence has separate verdicts on the structure and on the coverage.
    pub(crate) fn sentence(&self) -> String {
        let verdict = self.verdict();
        let accepted = match self.accepted.as_ref().map_or(0, |summary| summary.count) {
            0 => String::new(),
            n => format!(" ({} accepted)", grouped(n)),
        };
        let coverage = self.coverage.as_ref().filter(|coverage| coverage.has_polygons());
        let of_coverage = coverage.and_then(Coverage::outcome_in_words);
        let of_structure = match self.open_violations() {
            0 => "structure valid",
            _ => "structure not valid",
        };
        match verdict {
            Verdict::Unknown => {
                let beside = of_coverage.map_or_else(String::new, |coverage| format!(" · coverage: {coverage}"));
                format!("unknown: nothing wrong was found, and {}{beside}", self.unknown().join("; "))
            }
            Verdict::Valid => match of_coverage {
                // Rules that rely on accepted violations were not checked.
                None if self.open_violations() < self.violation_count => {
                    format!("valid{accepted}: all else that was checked holds")
                }
                None => format!("valid{accepted}: every rule that applies holds"),
                Some(coverage) => format!("{of_structure}{accepted} · coverage: {coverage}"),
            },
            Verdict::Invalid => {
                let [causes, others] = self.causes();
                let noun = if coverage.is_some() || self.finding_count > 0 { "finding" } else { "violation" };
                let more = if self.unlisted() > 0 { "up to " } else { "" };
                let follow = match others {
                    0 => String::new(),
                    1 => ", from which 1 other follows".to_owned(),
                    n => format!(", from which {} others follow", grouped(n)),
                };
                let parts = of_coverage
                    .map_or_else(String::new, |coverage| format!(" · {of_structure} · coverage: {coverage}"));
                format!(
                    "not valid{accepted}: {more}{}{follow}{parts}{}",
                    counted(causes, noun),
                    not_checked(self.open())
                )
            }
        }
    }

    /// Returns advice if all clashes of borders are missing vertices, or borders closer than a cell of the finest grid: no overlap or gap explains
    /// these.
    pub(crate) fn advice(&self) -> Option<&'static str> {
        let clashes = || self.violations.iter().filter(|one| one.rule == Some(Rule::G4.id()) && one.accepted.is_none());
        let is_small = |one: &Diagnosis| one.follows_from.is_none_or(|rule| rule == CoverageRule::Mismatch.id());
        let is_judged = self.coverage.as_ref().is_some_and(|coverage| coverage.not_checked().is_none());
        (is_judged && clashes().count() > 0 && clashes().all(is_small)).then_some(
            "all clashes of borders are missing vertices or smaller than a cell of the finest grid: --snap auto audits the map as if \
borders met, and `twinedge clean` makes them meet",
        )
    }

    pub(crate) fn name_of_rule(&self, one: &Diagnosis) -> &'static str {
        let rule = self.rules.iter().find(|rule| Some(rule.id) == one.rule);
        rule.map_or(one.kind.name(), |rule| rule.name)
    }

    pub(crate) fn unit(&self) -> Option<&'static str> {
        self.coverage.as_ref().filter(|coverage| coverage.has_polygons()).map(Coverage::unit)
    }

    pub(crate) fn windows(&self) -> Vec<Window> {
        let of = |one: &Diagnosis| {
            let Trace { points, lines, polygons } = &one.trace;
            let rings = polygons.iter().flatten().chain(lines).flatten();
            Window::around(rings.chain(points).chain(&one.look))
        };
        self.listed().filter_map(of).collect()
    }

    pub(crate) fn json(&self) -> impl Serialize + '_ {
        #[derive(Serialize)]
        struct Json<'a> {
            input: &'a str,
            verdict: Verdict,
            headline: String,
            #[serde(skip_serializing_if = "Vec::is_empty")]
            unknown: Vec<String>,
            causes: usize,
            consequences: usize,
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
            coverage: Option<OfCoverage<'a>>,
            elapsed_ms: f64,
        }
        #[derive(Serialize)]
        struct OfCoverage<'a> {
            verdict: Verdict,
            #[serde(flatten)]
            found: &'a Coverage,
        }
        let JsonForm { counts, bounds, is_named, has_findings, extra } = &self.json;
        let verdict = self.verdict();
        let [causes, consequences] = self.causes();
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
            headline: self.sentence(),
            unknown: self.unknown(),
            causes,
            consequences,
            first: self.first().map(|one| First { rule: one.rule, id: one.id.as_deref(), at: one.look }),
            judged: self.judged.as_ref(),
            judged_by: self.judged_by.as_ref(),
            version: env!("CARGO_PKG_VERSION"),
            accepted: self.accepted.as_ref(),
            options: &self.options,
            document,
            extra,
            coverage: self.coverage.as_ref().map(|found| OfCoverage { verdict: found.verdict(), found }),
            elapsed_ms: self.elapsed_ms,
        }
    }
}

/// Returns true if the finding breaks one of the rules X1 … X6.
fn is_between_layers(one: &Diagnosis) -> bool {
    one.rule.is_some_and(|rule| rule.starts_with('X'))
}

/// The first cause, in JSON.
#[derive(Serialize)]
struct First<'a> {
    rule: Option<&'static str>,
    id: Option<&'a str>,
    at: Option<Position>,
}

/// The label for the number of faces.
pub(crate) const FACES: &str = "faces (F), the unbounded one included";

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
