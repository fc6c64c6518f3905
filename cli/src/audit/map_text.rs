//! The report of a map as text.

use super::audited::{Audited, FOLLOWS, labels};
use super::remedies::remedy;
use crate::coverage::Asked;
use crate::input::Imported;
use crate::noding_text;
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{counted, grouped, plain};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use twinedge::io::ReadSummary;
use twinedge::map::{BuildSummary, IrregularityKind, PlanarMap};
use twinedge::validate::{Violation, places};

/// How the report is shown.
#[derive(Clone, Copy)]
pub(super) struct Shown<'a> {
    pub(super) coverage: &'a Asked,
    /// How many findings of each rule C1 … C6.
    pub(super) worst: usize,
    pub(super) explain: bool,
}

impl Shown<'_> {
    /// The report for people.
    pub(super) fn text(&self, audited: &Audited<'_>) -> Result<String, std::fmt::Error> {
        let Audited { imported, report, coverage, .. } = audited;
        let Imported { name, read, map, noted, .. } = imported;
        let explain = self.explain;
        let mut out = String::new();
        writeln!(out, "{name}")?;
        writeln!(out, "{QUIET}{}{QUIET:#}", input_line(map.summary(), imported.orients_rings))?;
        if let Some(dropped) = dropped_line(read) {
            writeln!(out, "{QUIET}{dropped}{QUIET:#}")?;
        }
        if let Some(noding) = map.noding() {
            writeln!(out, "{QUIET}{}{QUIET:#}", noding_text::line(noding))?;
        }
        for warning in noted.without_geometry().into_iter().chain(noted.warnings(read)) {
            writeln!(out, "{BAD}warning{BAD:#}: {warning}")?;
        }
        if let Some(hint) = noted.hint() {
            writeln!(out, "{QUIET}{hint}{QUIET:#}")?;
        }
        out.push_str(&irregularities(map));
        out.push('\n');
        let counts = report.counts();
        let or_unknown = |n: Option<usize>| n.map_or_else(|| "unknown".to_owned(), grouped);
        for (what, count) in [
            ("vertices (V)", grouped(counts.vertices)),
            ("edges (E)", grouped(counts.edges)),
            ("half-edges", grouped(counts.half_edges)),
            ("faces (F), the unbounded one included", grouped(counts.faces)),
            ("components (C)", or_unknown(counts.components)),
            ("outer boundary components", grouped(counts.outer_boundaries)),
            ("inner boundary components", grouped(counts.inner_boundaries)),
            ("isolated vertices", grouped(counts.isolated_vertices)),
            ("genus", or_unknown(counts.genus)),
        ] {
            writeln!(out, "  {what:38} {count:>12}")?;
        }
        out.push('\n');
        for (rule, outcome) in report.outcomes() {
            write!(out, "  {:2}  {:10} ", rule.id(), rule.name())?;
            match (outcome.violations, outcome.unchecked) {
                (0, None) => {
                    write!(out, "{GOOD}ok{GOOD:#}      {} {}", grouped(outcome.checked), rule.unit(outcome.checked))?;
                }
                (0, Some(why)) => write!(out, "{QUIET}not checked: {why}{QUIET:#}")?,
                (n, _) => {
                    let of = grouped(outcome.checked);
                    write!(
                        out,
                        "{BAD}BROKEN{BAD:#}  {} in {of} {}",
                        counted(n as usize, "violation"),
                        rule.unit(outcome.checked)
                    )?;
                }
            }
            out.push('\n');
        }
        if coverage.has_polygons() {
            out.push('\n');
            coverage.write_rules(&mut out, self.coverage)?;
        }
        out.push('\n');
        let (first, following) = audited.violations();
        for violation in first {
            write_violation(&mut out, map, violation)?;
        }
        let more = report.violation_count().saturating_sub(report.violations().len() as u64);
        if more > 0 {
            writeln!(out, "… and {} more; see --list", grouped(more))?;
        }
        if explain {
            let mut kinds = BTreeSet::new();
            for violation in report.violations().iter().filter(|violation| kinds.insert(violation.kind())) {
                writeln!(
                    out,
                    "{}: usual cause: {}; remedy: {}",
                    violation.rule(),
                    violation.cause(),
                    remedy(violation)
                )?;
            }
        }
        if coverage.has_polygons() {
            coverage.write_worst(&mut out, self.worst, noted.decimals())?;
        }
        for violation in following {
            write_violation(&mut out, map, violation)?;
            writeln!(out, "   {QUIET}{FOLLOWS}{QUIET:#}")?;
        }
        // The first word is coloured.
        let verdict = audited.verdict();
        let (word, rest) = verdict.split_once(':').unwrap_or((&verdict, ""));
        let style = if audited.is_valid { GOOD } else { BAD };
        writeln!(out, "{style}{word}{style:#}:{rest} ({:.0} ms)", audited.elapsed)?;
        Ok(out)
    }
}

/// A violation with its places and the features around.
fn write_violation(out: &mut String, map: &PlanarMap, violation: &Violation) -> std::fmt::Result {
    writeln!(out, "{BAD}{}{BAD:#} {violation}", violation.rule())?;
    let at: Vec<_> = places(map, violation).iter().map(|p| format!("({}, {})", p.x, p.y)).collect();
    if !at.is_empty() {
        writeln!(out, "   at {}", at.join(" "))?;
    }
    let features = labels(map, violation);
    if !features.is_empty() {
        writeln!(out, "   on the border of {}", features.join(", "))?;
    }
    Ok(())
}

/// What the reader dropped, except for properties, which every file has.
pub(super) fn dropped_line(read: &ReadSummary) -> Option<String> {
    let mut dropped = Vec::new();
    if read.with_extra_dimensions > 0 {
        dropped.push(format!("the dimensions beyond x and y of {}", counted(read.with_extra_dimensions, "position")));
    }
    if read.dropped_empty > 0 {
        dropped.push(counted(read.dropped_empty, "empty shape"));
    }
    (!dropped.is_empty()).then(|| format!("dropped: {}", dropped.join(", ")))
}

pub(super) fn input_line(summary: &BuildSummary, orients_rings: bool) -> String {
    let (features, segments) = (summary.features, summary.segments);
    let mut line = format!("{}, {}", counted(features, "feature"), counted(segments, "segment"));
    for (count, what) in [
        (summary.duplicate_segments, "repeated and merged"),
        (summary.zero_length_segments, "of zero length and dropped"),
        (summary.open_rings, "added to close open rings"),
    ] {
        if count > 0 {
            let _ = write!(line, ", {} {what}", grouped(count));
        }
    }
    let mut mark = ';';
    for (count, one, several) in [
        (summary.degenerate_rings, "ring encloses nothing", "rings enclose nothing"),
        (
            if orients_rings { summary.rings_wound_wrongly } else { 0 },
            "ring is wound the wrong way",
            "rings are wound the wrong way",
        ),
        (summary.self_touching_rings, "ring touches itself", "rings touch themselves"),
        (summary.spikes, "spike", "spikes"),
    ] {
        if count > 0 {
            let what = if count == 1 { one } else { several };
            let _ = write!(line, "{mark} {} {what}", grouped(count));
            mark = ',';
        }
    }
    line
}

/// How many irregularities of each kind the text shows. Rings wound the wrong way are not shown: usually all or none are.
const SHOWN: usize = 3;

fn irregularities(map: &PlanarMap) -> String {
    let mut out = String::new();
    let found = &map.summary().irregularities;
    let kinds: BTreeSet<_> =
        found.iter().map(|one| one.kind).filter(|kind| *kind != IrregularityKind::WoundWrongly).collect();
    for kind in kinds {
        for one in found.iter().filter(|one| one.kind == kind).take(SHOWN) {
            let (at, position) = (one.at, one.position);
            let _ = write!(out, "{QUIET}  {kind} at ({}, {}): {position}", at.x, at.y);
            if let Some(name) = map.features().nth(position.feature).and_then(|feature| map.name(feature)) {
                let _ = write!(out, " ({})", plain(name));
            }
            let _ = writeln!(out, "{QUIET:#}");
        }
    }
    out
}
