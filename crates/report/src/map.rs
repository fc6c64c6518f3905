//! The audit of a map.

use crate::coverage::Coverage;
use crate::error::Error;
use crate::imported::Imported;
use crate::map_json::extra;
use crate::map_notes::notes;
use crate::names::named;
use crate::options::Options;
use crate::packed::{Beside, Map, Names, Picture};
use crate::report::{AuditReport, CoverageStyle, JsonForm, counts};
use crate::trace::placed;
use crate::units::Units;
use serde_json::to_value;
use std::cmp::Ordering;
use std::collections::BTreeSet;
use twinedge::dcel::{Boundary, Face, Vertex};
use twinedge::validate::{Collect, Expectation, Record, Report, Rule, Violation};
use twinedge_algorithm::colouring::feature_colours;
use twinedge_coverage::CoverageRule;
use twinedge_diagnosis::{Diagnosis, FeatureName, RuleLine};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_lexicographic;
use twinedge_map::{Embedding as _, FeatureId, PlanarMap, places, validate_embedding};

/// Validates the map and judges it as a coverage. Consumes the builder.
pub(crate) fn audit(
    imported: &mut Imported,
    asked: &Options,
    stage: &mut dyn FnMut(&'static str),
) -> Result<AuditReport, Error> {
    let builder = imported.builder.take();
    let imported = &*imported;
    let Imported { name, map, noted, crs, .. } = imported;
    let list = asked.most();
    stage("validating");
    let report = validate_embedding(map, &Expectation::plane(), Collect::AtMost(list));
    let units = Units::of(imported, asked.measured.geodesic)?;
    let coverage = Coverage::new(imported, builder, &asked.coverage, &units, list, stage);
    let is_rule = asked.coverage.coverage;
    // A rule that cannot be checked is not known to hold.
    let is_checked = !is_rule || coverage.not_checked().is_none();
    let warnings: Vec<String> = imported.warnings().into_iter().chain(coverage.warnings()).collect();
    Ok(AuditReport {
        valid: report.is_valid() && is_checked,
        json: JsonForm {
            counts: to_value(report.counts())?,
            bounds: report.figures().and_then(|figures| figures.bounds),
            extra: extra(imported, &warnings),
            ..JsonForm::default()
        },
        notes: notes(imported, warnings),
        counts: counts(report.counts()),
        rules: RuleLine::of(&report),
        violations: violations(imported, &report, &coverage),
        violation_count: report.violation_count(),
        style: CoverageStyle { is_rule, list: asked.list, decimals: noted.decimals() },
        crs: crs.clone(),
        coverage: Some(coverage),
        ..AuditReport::new(name)
    })
}

/// Returns the violations with their places, the features around them, and remedies by commands of this program.
fn violations(imported: &Imported, report: &Report, coverage: &Coverage) -> Vec<Diagnosis> {
    let map = &imported.map;
    let clashes = report.outcome(Rule::G4).map_or(0, |outcome| outcome.violations);
    let clash = |violation: &Violation| violation.rule() == Rule::G4;
    let is_mismatch = |violation: &Violation| {
        // A crossing of two edges has no vertex.
        let may_be =
            clash(violation) && !matches!(violation, Violation::Cross { .. } | Violation::SegmentsCross { .. });
        let around = || features(map, violation).into_iter().map(FeatureId::index).collect();
        may_be && coverage.lacks_any(&places(map, violation), &around())
    };
    let of_mismatches = report.violations().iter().filter(|violation| is_mismatch(violation)).count() as u64;
    let diagnosis = |violation: &Violation| {
        // If borders clash, the map does not fit in the plane.
        let follows_from = match violation.rule() {
            Rule::G4 => is_mismatch(violation).then_some(CoverageRule::Mismatch.id()),
            Rule::T3 if clashes > 0 && of_mismatches == clashes => Some(CoverageRule::Mismatch.id()),
            Rule::T3 if clashes > 0 => Some(Rule::G4.id()),
            _ => None,
        };
        let features = features(map, violation).into_iter().map(|feature| named(imported, feature)).collect();
        following(Diagnosis { features: Some(features), ..placed(map, violation) }, violation.rule(), follows_from)
    };
    by_place(map, report.violations()).iter().map(diagnosis).collect()
}

/// Returns the violations sorted, with each T3 naming the least vertex of its component, so that the order of features does not matter. O(n log n).
fn by_place(map: &PlanarMap, violations: &[Violation]) -> Vec<Violation> {
    let mut found = violations.to_vec();
    let mut seen = Vec::new();
    for violation in &mut found {
        if let Violation::Genus { vertex, .. } = violation {
            *vertex = least_vertex(map, *vertex, &mut seen).unwrap_or(*vertex);
        }
    }
    let mut keyed: Vec<_> = found.into_iter().map(|violation| (order(map, &violation), violation)).collect();
    let compare = |a: &[Point], b: &[Point]| {
        let mut orders = a.iter().zip(b).map(|(a, b)| compare_lexicographic(*a, *b));
        orders.find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
    };
    for of_rule in keyed.chunk_by_mut(|(_, a), (_, b)| a.rule() == b.rule()) {
        of_rule.sort_by(|((size, places), _), ((other, beside), _)| size.cmp(other).then(compare(places, beside)));
    }
    keyed.into_iter().map(|(_, violation)| violation).collect()
}

/// Returns the sizes and the places by which the violations of T3 and of G4 are sorted, as in an audit by tiles: crossings before touching vertices
/// before overlaps, and then by their edges.
fn order(map: &PlanarMap, violation: &Violation) -> ([usize; 3], Vec<Point>) {
    let mut around = places(map, violation);
    let kind = match *violation {
        Violation::Genus { vertices, edges, cycles, .. } => return ([vertices, edges, cycles], around),
        Violation::Cross { .. } => 0,
        Violation::Touch { .. } => 1,
        Violation::Overlap { .. } => 2,
        _ => return Default::default(),
    };
    // A touching vertex precedes its edge.
    let skipped = around.len() % 2;
    around[skipped..].chunks_mut(2).for_each(|ends| ends.sort_by(|a, b| compare_lexicographic(*a, *b)));
    if let [a, b, c, d] = around[..]
        && compare_lexicographic(a, c).then(compare_lexicographic(b, d)).is_gt()
    {
        around = vec![c, d, a, b];
    }
    ([kind, 0, 0], around)
}

/// Returns the vertex of the same component with the least coordinates, by x and then y. `seen` marks the visited vertices of all components. O(size
/// of the component), and O(vertices) for the first call.
fn least_vertex(map: &PlanarMap, vertex: usize, seen: &mut Vec<bool>) -> Option<usize> {
    let first = map.dcel().vertex_at(vertex)?;
    if seen.is_empty() {
        *seen = vec![false; map.dcel().vertices().last()?.index() + 1];
    }
    let (mut ahead, mut least) = (vec![first], first);
    while let Some(v) = ahead.pop() {
        if std::mem::replace(&mut seen[v.index()], true) {
            continue;
        }
        if compare_lexicographic(map.point(v.index()), map.point(least.index())).is_lt() {
            least = v;
        }
        ahead.extend(v.rotation().map(|h| h.target()));
    }
    Some(least.index())
}

/// Adds the violation's cause, and a remedy by commands of this program.
pub(crate) fn following(diagnosis: Diagnosis, rule: Rule, follows_from: Option<&'static str>) -> Diagnosis {
    let remedy = match rule {
        // If the map is not plane, the library's remedies name its own functions.
        Rule::G4 | Rule::T3 if follows_from == Some(CoverageRule::Mismatch.id()) => {
            Some("`twinedge clean` adds the vertices that are missing (C7), from which it follows")
        }
        Rule::T3 => Some("mend the crossings (G4), from which it follows"),
        Rule::G4 => Some(
            "`twinedge clean` repairs a layer of polygons; `--snap auto` cuts borders where they meet, and the rest is \
audited as if they were cut",
        ),
        _ => diagnosis.remedy,
    };
    Diagnosis { remedy, follows_from, ..diagnosis }
}

fn features(map: &PlanarMap, violation: &Violation) -> BTreeSet<FeatureId> {
    let dcel = map.dcel();
    let mut found = BTreeSet::new();
    for record in violation.records().into_iter().flatten() {
        let half_edges: Vec<_> = match record {
            Record::HalfEdge(h) => dcel.half_edge_at(h).into_iter().collect(),
            Record::Vertex(v) => dcel.vertex_at(v).into_iter().flat_map(Vertex::rotation).collect(),
            Record::Boundary(b) => dcel.boundary_at(b).and_then(Boundary::start).into_iter().collect(),
            Record::Face(f) => {
                let face = dcel.face_at(f).map(Face::key);
                found.extend(face.and_then(|f| map.features_of(f).ok()).into_iter().flatten());
                Vec::new()
            }
        };
        for h in half_edges {
            found.extend(map.features_along(h.key()).into_iter().flatten());
        }
    }
    found
}

/// Returns the map for a page. If it is not plane, the page fills the faces of the input with its borders cut.
pub(crate) fn picture(imported: &Imported, report: &AuditReport) -> Picture {
    let map = &imported.map;
    let windows = report.windows();
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
    let of_input = report.coverage.as_ref().and_then(Coverage::of_input).filter(|_| !map.is_plane());
    packed.areas = of_input.map(|of_input| Box::new(pack(of_input)));
    // If the map is not plane, the neighbours of features are unknown.
    let colours = feature_colours(of_input.unwrap_or(map));
    let feature = |(id, colour)| {
        let FeatureName { id, name, .. } = named(imported, id);
        (name, id, colour)
    };
    Picture { map: packed, features: map.features().zip(colours).map(feature).collect() }
}
