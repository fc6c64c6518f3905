//! The audit of a map whose edges are arcs of great circles.

mod clash;
mod finding;
mod lines;

use crate::coverage::Coverage;
use crate::error::Error;
use crate::imported::Imported;
use crate::map_json::extra;
use crate::options::Options;
use crate::report::{AuditReport, CoverageStyle, FACES, JsonForm, Note, counts};
use crate::words::{counted, grouped};
use clash::{antipodal, clashing};
use serde_json::{json, to_value};
use twinedge::validate::{Collect, Counts, Expectation, Report, Rule, Unchecked, validate};
use twinedge_diagnosis::{Diagnosis, Reason, RuleLine};
use twinedge_sphere::{Clash, Cover, Drawing, Inside, RADIUS, Subdivision, check, mismatches};

use finding::Judged;

/// Validates the map drawn by great circles, and judges it as a coverage. The features stay as read.
pub(crate) fn audit(
    imported: &Imported,
    asked: &Options,
    stage: &mut dyn FnMut(&'static str),
) -> Result<AuditReport, Error> {
    let Imported { name, noted, .. } = imported;
    if !noted.look_like_degrees(&imported.read) {
        return Err(Error::NotDegrees);
    }
    let list = asked.most();
    let drawing = Drawing::new(&imported.features)?;
    stage("cutting great circles");
    let (clashes, map) = Subdivision::new(&drawing);
    stage("validating");
    let report = map.as_ref().ok().map(|map| validate(map.dcel(), &Expectation::plane(), Collect::AtMost(list)));
    stage("checking the coverage");
    let judged = judged(&drawing, &clashes, map.as_ref().map_err(ToString::to_string), asked);
    let coverage = Coverage::on_sphere(imported, &asked.coverage, list, judged);

    let of_structure = report.as_ref().map_or(0, Report::violation_count);
    let of_map = map.as_ref().ok().zip(report.as_ref());
    let rules = rules(&drawing, &clashes, of_map);
    let own: u64 = rules.iter().filter(|rule| rule.id.starts_with('G')).map(|rule| rule.violations).sum();
    let is_rule = asked.coverage.coverage;
    let is_checked = report.is_some() && (!is_rule || coverage.not_checked().is_none());
    let undrawn = drawing.undrawn().iter().map(|one| antipodal(imported, one));
    let clashing = clashes.iter().map(|one| clashing(imported, &drawing, one, &coverage));
    let of_links = report.iter().flat_map(Report::violations).map(Diagnosis::from);
    let violations: Vec<Diagnosis> = of_links.chain(undrawn).chain(clashing).take(list).collect();
    let warnings: Vec<String> = noted.without_geometry().into_iter().collect();
    let mut more = extra(imported, &warnings);
    more.insert("edges".to_owned(), json!({ "kind": "great circles", "radius": RADIUS }));
    Ok(AuditReport {
        valid: own == 0 && is_checked && report.as_ref().is_some_and(Report::is_valid),
        doubts: map.as_ref().err().map(ToString::to_string).into_iter().collect(),
        json: JsonForm {
            counts: report.as_ref().map(|report| to_value(report.counts())).transpose()?.unwrap_or_default(),
            bounds: report.as_ref().and_then(Report::figures).and_then(|figures| figures.bounds),
            extra: more,
            ..JsonForm::default()
        },
        notes: notes(imported, &drawing, warnings),
        counts: report.as_ref().map(|report| numbers(report.counts())).unwrap_or_default(),
        rules,
        violations,
        violation_count: of_structure + own,
        style: CoverageStyle { is_rule, list: asked.list, decimals: noted.decimals() },
        crs: imported.crs.clone(),
        coverage: Some(coverage),
        ..AuditReport::new(name)
    })
}

/// Returns the findings of the coverage, or the reason why there are none.
fn judged(
    drawing: &Drawing,
    clashes: &[Clash],
    map: Result<&Subdivision, String>,
    asked: &Options,
) -> Result<Judged, String> {
    let map = map?;
    let open = drawing.undrawn().iter().filter(|one| one.of_polygon).count();
    if open > 0 {
        return Err(format!(
            "{} between antipodes, which no way is the shortest to join, so that polygons are not closed",
            counted(open, "edge")
        ));
    }
    let cover = Cover::new(map, drawing, Inside::Smaller);
    let mut found = check(&cover, &asked.coverage.limits.limits());
    found.findings.extend(mismatches(&cover, drawing, clashes));
    Ok(Judged(found))
}

/// Returns the rules of the structure and of the arcs. G3 needs an outside, which a sphere does not have.
fn rules(drawing: &Drawing, clashes: &[Clash], map: Option<(&Subdivision, &Report)>) -> Vec<RuleLine> {
    let line = |rule: Rule, checked: usize, violations: usize| RuleLine {
        id: rule.id(),
        name: rule.name(),
        statement: rule.statement(),
        checked: checked as u64,
        unit: rule.unit(checked as u64),
        violations: violations as u64,
        unchecked: None,
        left_out: None,
    };
    let unchecked = |rule: Rule, why: Reason| RuleLine { unchecked: Some(why), ..line(rule, 0, 0) };
    let outside = unchecked(Rule::G3, Reason::Validator(Unchecked::PlaneOnly));
    let finite = line(Rule::G1, drawing.places().len(), drawing.undrawn().len());
    let disjoint = line(Rule::G4, drawing.arcs().len(), clashes.len());
    let Some((map, report)) = map else {
        let [order, inside] = [Rule::G2, Rule::G5].map(|rule| unchecked(rule, Reason::Broken(Rule::G4.id())));
        return vec![finite, order, outside, disjoint, inside];
    };
    let order = line(Rule::G2, report.counts().vertices, map.out_of_order());
    let inside = line(Rule::G5, report.counts().components.unwrap_or_default(), map.misplaced());
    RuleLine::of(report).into_iter().chain([finite, order, outside, disjoint, inside]).collect()
}

fn notes(imported: &Imported, drawing: &Drawing, warnings: Vec<String>) -> Vec<Note> {
    let edges = drawing.arcs().len() + drawing.repeated_arcs();
    let repeated =
        [(drawing.repeated_arcs(), "repeated and merged"), (drawing.repeated_points(), "of zero length and dropped")];
    let repeated = repeated.into_iter().filter(|(count, _)| *count > 0);
    let input: Vec<String> = [counted(imported.summary.features, "feature"), counted(edges, "edge")]
        .into_iter()
        .chain(repeated.map(|(count, what)| format!("{} {what}", grouped(count))))
        .collect();
    let why = if imported.edges.is_some() { ", as the file says" } else { "" };
    let edges = format!(
        "edges are great circles{why}, cut where they meet; lengths in metres and areas in square metres, on a sphere with a radius of {RADIUS} m"
    );
    let notes = [Note::Plain(input.join(", ")), Note::Plain(edges)].into_iter();
    notes.chain(warnings.into_iter().map(Note::Warning)).chain(imported.noted.hint().map(Note::Plain)).collect()
}

fn numbers(of: &Counts) -> Vec<(&'static str, String)> {
    let named = |(name, count)| (if name == FACES { "faces (F)" } else { name }, count);
    let is_of_sphere = |(name, _): &(&'static str, String)| !name.ends_with("boundary components");
    counts(of).into_iter().filter(is_of_sphere).map(named).collect()
}
