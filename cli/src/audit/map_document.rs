//! The report of a map, for the formats with a map.

use super::audited::{Audited, FOLLOWS, features};
use super::document::{Document, Marked, RuleLine, counts, rule_lines};
use super::map_text::{dropped_line, input_line};
use super::packed::{Beside, Map, Names, Window};
use super::remedies::remedy;
use crate::coverage::{Entry, Named};
use crate::coverage_words::statement;
use crate::input::Imported;
use crate::noding_text;
use twinedge::algorithm::colouring::feature_colours;
use twinedge::map::PlanarMap;
use twinedge::validate::Violation;

/// All that is listed.
pub(super) fn document(audited: &Audited<'_>, explain: bool) -> Document {
    let Audited { imported, report, coverage, is_coverage_rule, is_valid, .. } = audited;
    let Imported { name, read, map, noted, crs, .. } = imported;
    let mut notes = vec![input_line(map.summary(), imported.orients_rings)];
    notes.extend(dropped_line(read));
    notes.extend(map.noding().map(noding_text::line));
    notes.extend(noted.hint());
    notes.extend(
        noted.without_geometry().into_iter().chain(noted.warnings(read)).map(|warning| format!("Warning: {warning}")),
    );
    let mut rules: Vec<RuleLine> = rule_lines(report);
    if coverage.has_polygons() {
        rules.extend(coverage.counts().map(|(rule, count, _)| RuleLine {
            id: rule.id(),
            name: rule.name(),
            statement: Some(statement(rule)),
            outcome: coverage.outcome(rule),
            found: count as u64,
        }));
    }
    let (first, following) = audited.violations();
    let of_report = |violation: &Violation| of_violation(imported, violation, explain);
    let following = following.into_iter().map(|violation| {
        let marked = of_report(violation);
        Marked { message: format!("{}, {FOLLOWS}", marked.message), ..marked }
    });
    let of_coverage = coverage.findings().iter().map(|entry| of_entry(entry, *is_coverage_rule));
    let feature = |(id, colour)| {
        let Named { id, name, .. } = Named::new(imported, id);
        (name, id, colour)
    };
    // Where the map is not plane, it is not known on it which features are neighbours.
    let colours = feature_colours(coverage.of_input().filter(|_| !map.is_plane()).unwrap_or(map));
    Document {
        input: name.clone(),
        valid: *is_valid,
        verdict: audited.verdict(),
        notes,
        counts: counts(report),
        rules,
        unit: coverage.has_polygons().then(|| coverage.unit()),
        findings: first.into_iter().map(of_report).chain(of_coverage).chain(following).collect(),
        total: report.violation_count() + coverage.total() as u64,
        features: map.features().zip(colours).map(feature).collect(),
        crs: crs.clone(),
    }
}

fn of_violation(imported: &Imported, violation: &Violation, explain: bool) -> Marked {
    let map = &imported.map;
    Marked {
        features: features(map, violation).into_iter().map(|feature| Named::new(imported, feature)).collect(),
        remedy: explain.then(|| remedy(violation)),
        ..Marked::of_violation(map, violation, explain)
    }
}

fn of_entry(entry: &Entry, is_rule: bool) -> Marked {
    let snapped = entry.snapping().map_or_else(String::new, |what| format!(" ({what} by snapping)"));
    Marked {
        rule: entry.rule(),
        name: entry.kind(),
        kind: entry.kind(),
        message: format!("{}{snapped}", entry.detail()),
        violation: is_rule,
        records: Vec::new(),
        features: entry.features().to_vec(),
        area: entry.area,
        width: entry.width,
        length: entry.length,
        cause: entry.cause,
        remedy: entry.remedy,
        at: Some(entry.at()),
        trace: entry.trace().clone(),
    }
}

/// The map, packed. Where it is not plane, the faces that are filled are those of the input with its borders cut.
pub(super) fn packed(audited: &Audited<'_>, document: &Document) -> Map {
    let map = &audited.imported.map;
    let windows: Vec<Window> = document.windows();
    let pack = |map: &PlanarMap| {
        let features = |face: usize| match map.dcel().face_at(face) {
            Some(face) if map.is_plane() => {
                map.features_of(face.key()).into_iter().flatten().map(|f| f.index()).collect()
            }
            _ => Vec::new(),
        };
        Map::pack(map, Beside { features: &features, names: Names::Indices, windows: &windows })
    };
    let mut packed = pack(map);
    if let Some(of_input) = audited.coverage.of_input().filter(|_| !map.is_plane()) {
        packed.areas = Some(Box::new(pack(of_input)));
    }
    packed
}
