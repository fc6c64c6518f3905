//! The audit of a map by its tiles, and of tiles whose summaries were saved.

use crate::coverage::{Coverage, CoverageOptions, SHOWN};
use crate::error::Error;
use crate::imported::{Imported, names};
use crate::input::Input;
use crate::map_json::extra;
use crate::map_notes::notes;
use crate::noted::{Keep, Noted};
use crate::options::Options;
use crate::report::{AuditReport, CoverageStyle, JsonForm, counts};
use crate::trace::position;
use crate::units::Units;
use crate::words::counted;
use serde_json::{Map, Value, json, to_value};
use twinedge::geometry::Point;
use twinedge::io::ReadSummary;
use twinedge::map::{BuildSummary, Feature, Shape};
use twinedge::tile::{Crossing, CrossingKind, Grid, Outcome, SeamFault, SeamRule, Summary, Uneven};
use twinedge::validate::Rule;
use twinedge_formats::diagnosis::{Diagnosis, Kind, Records, RuleLine};

/// Cuts the map into tiles, and says what all of them say.
pub(crate) fn audit(input: Input, asked: &Options, stage: &mut dyn FnMut(&'static str)) -> Result<AuditReport, Error> {
    let (imported, features) = Imported::features(input, &asked.map, Keep { coverage: true, condition: None })?;
    let Imported { noted, crs, .. } = &imported;
    let across = asked.tiles.unwrap_or(1);
    let grid = grid_around(&features, [across; 2])?;
    stage("judging the tiles");
    let columns = grid.size()[0] as usize;
    let mut given: Vec<Vec<u32>> = vec![Vec::new(); columns * grid.size()[1] as usize];
    for (number, feature) in (0..).zip(&features) {
        for tile in grid.tiles_of(feature) {
            given[tile.row as usize * columns + tile.column as usize].push(number);
        }
    }
    let summary = |(tile, given): (_, &Vec<u32>)| {
        let of_tile = given.iter().map(|number| (*number, &features[*number as usize]));
        Ok(Summary::new(&grid, tile, of_tile, &asked.coverage.limits)?)
    };
    let summaries: Vec<Summary> = grid.tiles().zip(&given).map(summary).collect::<Result<_, Error>>()?;
    let outcome = merged(summaries)?.ok_or(Error::Grid(twinedge::tile::GridError::Size))?.finish()?;
    drop(features);
    let warnings: Vec<String> = noted.without_geometry().into_iter().chain(noted.warnings(&imported.read)).collect();
    let mut extra = extra(&imported, &warnings);
    extra.insert("tiles".to_owned(), size(&grid));
    let units = Units::of(&imported, asked.geodesic)?;
    let found = report(&imported, outcome, &asked.coverage, &units, asked.most())?;
    Ok(AuditReport {
        notes: notes(&imported, warnings),
        style: CoverageStyle {
            is_rule: asked.coverage.is_rule,
            worst: asked.list.unwrap_or(SHOWN),
            decimals: noted.decimals(),
        },
        crs: crs.clone(),
        json: JsonForm { extra, ..found.json },
        ..found
    })
}

/// Says what the summary of all tiles says. The features are known by their numbers.
pub(crate) fn audit_summary(summary: Summary, asked: &Options) -> Result<AuditReport, Error> {
    let grid = *summary.grid();
    let outcome = summary.finish()?;
    let findings = outcome.coverage.iter().flat_map(|found| &found.findings);
    let named = findings.flat_map(|finding| &finding.features).map(|feature| feature.index());
    let most = named.chain(outcome.defects.iter().map(|(feature, _)| *feature as usize)).max();
    let mut noted = Noted::new(None);
    noted.defects = outcome.defects.iter().map(|(feature, found)| (*feature as usize, found.clone())).collect();
    let [columns, rows] = grid.size();
    let mut read = ReadSummary::default();
    read.polygons = 1;
    let imported = Imported {
        name: counted(columns as usize * rows as usize, "tile"),
        read,
        map: names((0..most.map_or(0, |most| most + 1)).map(|_| None))?,
        summary: BuildSummary::default(),
        noted,
        builder: None,
        unmatched: Vec::new(),
        crs: None,
        orients_rings: false,
    };
    let units = Units::Plane { degrees: false };
    let found = report(&imported, outcome, &asked.coverage, &units, asked.most())?;
    let extra: Map<String, Value> = [("tiles".to_owned(), size(&grid))].into_iter().collect();
    Ok(AuditReport {
        style: CoverageStyle { worst: SHOWN, decimals: 6, is_rule: asked.coverage.is_rule },
        json: JsonForm { extra, ..found.json },
        ..found
    })
}

fn size(grid: &Grid) -> Value {
    let [columns, rows] = grid.size();
    json!({ "columns": columns, "rows": rows })
}

fn points(shape: &Shape) -> &[Point] {
    match shape {
        Shape::Polygon(rings) => rings.first().map_or(&[], Vec::as_slice),
        Shape::Line(points) => points,
        Shape::Point(point) => std::slice::from_ref(point),
    }
}

/// The grid that divides the box around all features.
///
/// # Errors
/// [`Error::Grid`].
pub fn grid_around(features: &[Feature], [columns, rows]: [u32; 2]) -> Result<Grid, Error> {
    let all = features.iter().flat_map(|feature| &feature.shapes).flat_map(points);
    let far = f64::INFINITY;
    let (mut low, mut high) = (Point::new(far, far), Point::new(-far, -far));
    for p in all {
        low = Point::new(low.x.min(p.x), low.y.min(p.y));
        high = Point::new(high.x.max(p.x), high.y.max(p.y));
    }
    // What has no width is divided all the same.
    let wide = |low: f64, high: f64| if low < high { (low, high) } else { (low.min(0.0) - 1.0, high.max(0.0) + 1.0) };
    let is_empty = low.x > high.x;
    let ((left, right), (bottom, top)) =
        if is_empty { ((0.0, 1.0), (0.0, 1.0)) } else { (wide(low.x, high.x), wide(low.y, high.y)) };
    Ok(Grid::new([left, bottom], [right, top], columns, rows)?)
}

/// Merges summaries, neighbours first; none, if there are none.
///
/// # Errors
/// [`Error::Merge`].
pub fn merged(mut summaries: Vec<Summary>) -> Result<Option<Summary>, Error> {
    while summaries.len() > 1 {
        let mut rest = summaries.into_iter();
        let mut pairs = Vec::new();
        while let Some(one) = rest.next() {
            pairs.push(match rest.next() {
                Some(other) => one.merge(other)?,
                None => one,
            });
        }
        summaries = pairs;
    }
    Ok(summaries.pop())
}

/// The report, apart from what is known of the input.
fn report(
    imported: &Imported,
    outcome: Outcome,
    asked: &CoverageOptions,
    units: &Units,
    list: usize,
) -> Result<AuditReport, Error> {
    let mut rules: Vec<RuleLine> = outcome.rules().map(|(rule, outcome)| RuleLine::new(rule, outcome)).collect();
    rules.extend(SeamRule::ALL.into_iter().filter_map(|rule| seam_line(rule, &outcome)));
    let mut violations: Vec<Diagnosis> = outcome.uneven.iter().map(uneven).collect();
    violations.extend(outcome.crossings.iter().map(crossing));
    violations.extend(outcome.seams.iter().map(seam));
    violations.extend(outcome.not_given.iter().map(|feature| not_given(*feature)));
    if outcome.adds_up == Some(false) && violations.is_empty() {
        violations.push(violation(Rule::T3.id(), "sums", "V − E + F is not 1 + C".to_owned(), &[]));
    }
    let violation_count = violations.len() as u64;
    violations.truncate(list);
    let (is_valid, bounds) = (outcome.is_valid(), outcome.bounds().filter(|_| outcome.is_valid()));
    let found = outcome.counts;
    let is_plane = outcome.crossings.is_empty() && outcome.adds_up.is_some();
    let why = if is_plane { "tiles contradict each other" } else { "borders cross, and tiles do not cut them" };
    let found_in_tiles = outcome.coverage.ok_or_else(|| why.to_owned());
    let coverage = Coverage::of_tiles(imported, asked, units, list, found_in_tiles);
    let of_coverage = if asked.is_rule { coverage.total() } else { 0 };
    let is_coverage = of_coverage == 0 && (!asked.is_rule || coverage.not_checked().is_none());
    Ok(AuditReport {
        valid: is_valid && is_coverage,
        found: counted(violation_count as usize + of_coverage, "violation"),
        json: JsonForm { counts: to_value(found)?, bounds, ..JsonForm::default() },
        counts: counts(&found),
        rules,
        violations,
        violation_count,
        coverage: Some(coverage),
        ..AuditReport::new(&imported.name)
    })
}

/// The line of a rule of seams; none if it is kept.
fn seam_line(rule: SeamRule, outcome: &Outcome) -> Option<RuleLine> {
    let faults = outcome.seams.iter().filter(|fault| fault.rule == rule).count();
    let not_given = if rule == SeamRule::Features { outcome.not_given.len() } else { 0 };
    let violations = (faults + not_given) as u64;
    (violations > 0).then_some(RuleLine {
        id: rule.id(),
        name: rule.name(),
        statement: "what two tiles say of the border between them is the same",
        checked: violations,
        unit: "places",
        violations,
        unchecked: None,
        left_out: None,
    })
}

fn violation(rule: &'static str, kind: &'static str, message: String, places: &[Point]) -> Diagnosis {
    Diagnosis {
        rule: Some(rule),
        kind: Kind::Named { kind },
        message,
        // Tiles do not number records.
        records: Records::Names { records: Vec::new() },
        places: Some(places.iter().copied().map(position).collect()),
        look: places.first().copied().map(position),
        is_violation: true,
        ..Diagnosis::default()
    }
}

fn edge([a, b]: [Point; 2]) -> String {
    format!("({}, {})-({}, {})", a.x, a.y, b.x, b.y)
}

fn crossing(one: &Crossing) -> Diagnosis {
    let [first, second] = [one.first, one.second].map(edge);
    let (kind, message) = match one.kind {
        CrossingKind::Touch => {
            let vertex = one.first[0];
            ("touch", format!("the vertex at ({}, {}) lies inside the edge {second}", vertex.x, vertex.y))
        }
        CrossingKind::Overlap => ("overlap", format!("the edges {first} and {second} overlap")),
        _ => ("cross", format!("the edges {first} and {second} cross where no vertex is")),
    };
    violation(Rule::G4.id(), kind, message, &[one.first, one.second].concat())
}

fn uneven(one: &Uneven) -> Diagnosis {
    let Uneven { vertices, edges, cycles, at, .. } = one;
    let message =
        format!("a component has V = {vertices}, E = {edges} and {cycles} cycles: it does not fit in the plane");
    violation(Rule::T3.id(), "genus", message, at.as_slice())
}

fn seam(one: &SeamFault) -> Diagnosis {
    let (tile, side) = (one.tile, format!("{:?}", one.side).to_lowercase());
    let what = match one.rule {
        SeamRule::Contact => "has an edge there that its neighbour has not",
        SeamRule::Order => "has edges there in another order than its neighbour",
        _ => "and its neighbour name different features there",
    };
    let at = one.edge.map(|ends| format!(", at the edge {}", edge(ends))).unwrap_or_default();
    let places = one.edge.map(|ends| ends.to_vec()).unwrap_or_default();
    violation(one.rule.id(), one.rule.name(), format!("{side} side of tile {tile}: the tile {what}{at}"), &places)
}

fn not_given(feature: u32) -> Diagnosis {
    let message = format!("feature {feature} was not given to every tile that the box around it meets");
    violation(SeamRule::Features.id(), "not_given", message, &[])
}
