//! The audit of a map by tiles, and of tiles with saved summaries.

use crate::coverage::Coverage;
use crate::error::Error;
use crate::imported::{Imported, names};
use crate::left_out::{reason, refuse_missing};
use crate::map::following;
use crate::map_json::extra;
use crate::map_notes::notes;
use crate::names::numbered_name;
use crate::noted::{Noted, are_degrees};
use crate::options::{CoverageOptions, Options};
use crate::report::{AuditReport, CoverageStyle, JsonForm, Note, counts};
use crate::shelf::Shelf;
use crate::trace::position;
use crate::units::Units;
use crate::words::counted;
use crate::words::made_without;
use serde_json::{Value, json, to_value};
use twinedge::validate::{Rule, Violation};
use twinedge_coverage::tile::{
    AuditError, Crossing, CrossingKind, Cuts, Grid, Outcome, Portion, SeamFault, SeamRule, Uneven,
};
use twinedge_coverage::{CoverageRule, Defect, Limits, tile};
use twinedge_diagnosis::{Diagnosis, Figures, Kind, Records, RuleLine, middle};
use twinedge_geometry::Point;
use twinedge_layers::Crs;
use twinedge_layers::io::ReadSummary;
use twinedge_map::{BuildError, BuildSummary};

/// The way to divide a map into tiles.
#[derive(Clone, Copy, Debug)]
pub enum Division {
    /// This number of columns, and of rows.
    Across(u32),
    /// The memory in bytes that judging the tiles may take, approximately.
    Within(u64),
}

/// The bytes used per vertex of the features of a tile, and the number of tiles judged at a time.
const BYTES: u64 = 700;
const AT_ONCE: u64 = 3;

/// The size of a sample of vertices, and the greatest number of tiles, about.
const SAMPLE: usize = 1 << 16;
const MOST_TILES: u64 = 1 << 12;

/// The number of vertices below which a tile would cost more than it saves.
const LEAST: u64 = 16;

/// Divides a map on a shelf into tiles, judges them and merges their summaries.
pub(crate) fn audit(
    mut imported: Imported,
    asked: &Options,
    division: Division,
    shelf: &mut dyn Shelf,
    stage: &mut dyn FnMut(&'static str),
) -> Result<AuditReport, Error> {
    stage("dividing the map");
    let corners = imported.noted.corners();
    let grid = match division {
        Division::Across(across) => grid_of(corners, [across; 2])?,
        Division::Within(bytes) => fitting(shelf, bytes)?,
    };
    let outcome = judged(&grid, corners, &asked.coverage.limits.limits(), shelf, || stage("judging the tiles"))?;
    imported.noted.defects = invalid(&outcome);
    finished(imported, &grid, outcome, None, asked)
}

/// The layer that tiles were made of, as far as it is known.
#[derive(Debug)]
pub enum TiledLayer {
    /// Facts in place of the layer.
    Unread {
        /// The ids of the features by number, or none: then features are known by their numbers.
        ids: Vec<Option<String>>,
        /// True if `ids` has all features.
        are_all: bool,
        /// The coordinate reference system, unless it is longitude and latitude on WGS 84.
        crs: Option<Box<Crs>>,
    },
    /// The layer, read without building a map ([`Imported::features`]).
    Read(Box<Imported>),
}

/// Adds facts about the input to the report on all tiles.
fn finished(
    mut imported: Imported,
    grid: &Grid,
    outcome: Outcome,
    left_out: Option<String>,
    asked: &Options,
) -> Result<AuditReport, Error> {
    let summary = &mut imported.summary;
    // Equal segments are one edge.
    summary.duplicate_segments = (summary.segments - summary.zero_length_segments).saturating_sub(outcome.counts.edges);
    let warnings: Vec<String> = imported.warnings();
    let mut extra = extra(&imported, &warnings);
    extra.insert("tiles".to_owned(), size(grid));
    let units = Units::of(&imported, asked.measured.geodesic)?;
    let found = report(&imported, outcome, left_out, &asked.coverage, &units, asked.most())?;
    Ok(AuditReport {
        notes: notes(&imported, warnings),
        style: CoverageStyle {
            is_rule: asked.coverage.coverage,
            list: asked.list,
            decimals: imported.noted.decimals(),
        },
        crs: imported.crs.clone(),
        json: JsonForm { extra, ..found.json },
        ..found
    })
}

/// Files the features of a shelf under the tiles of a grid and judges these, calling `filed` in between.
pub(crate) fn judged(
    grid: &Grid,
    corners: Option<[Point; 2]>,
    limits: &Limits,
    shelf: &mut dyn Shelf,
    filed: impl FnOnce(),
) -> Result<Outcome, Error> {
    let cuts = no_cuts(corners)?;
    shelf.file(grid, &cuts)?;
    filed();
    Ok(tile::audit(grid, limits, cuts, |tile| shelf.of_tile(tile))?)
}

/// Returns the features that are invalid by the rules of the OGC or could not be read.
fn invalid(outcome: &Outcome) -> Vec<(usize, Vec<Defect>)> {
    let unreadable = outcome.unreadable.iter().map(|(feature, _)| (*feature as usize, Vec::new()));
    let defects = outcome.defects.iter().map(|(feature, found)| (*feature as usize, found.clone()));
    let mut all: Vec<_> = defects.chain(unreadable).collect();
    all.sort_by_key(|(feature, _)| *feature);
    all
}

/// Returns a grid whose tiles each fit into `bytes`, as far as a sample of the vertices shows.
pub(crate) fn fitting(shelf: &mut dyn Shelf, bytes: u64) -> Result<Grid, Error> {
    let (mut sample, mut step, mut count) = (Vec::new(), 1_u64, 0_u64);
    shelf.each(&mut |feature| {
        for point in feature.points() {
            if count.is_multiple_of(step) {
                sample.push(point);
            }
            count += 1;
            if sample.len() == SAMPLE {
                // From here on, half as many vertices are sampled.
                let mut is_kept = false;
                sample.retain(|_| {
                    is_kept = !is_kept;
                    is_kept
                });
                step *= 2;
            }
        }
    })?;
    let most = (bytes / (BYTES * AT_ONCE)).max(count / MOST_TILES).max(LEAST);
    Ok(Grid::fitted(sample, (most / step) as usize)?)
}

/// Reports the audit of all tiles.
pub(crate) fn audit_portion(portion: Portion, layer: TiledLayer, asked: &Options) -> Result<AuditReport, Error> {
    let grid = portion.summary().grid().clone();
    refuse_missing(portion.summary())?;
    let without = portion.without_cuts();
    let (summary, cut) = portion.into_summaries();
    let outcome = summary.finish().map_err(AuditError::from)?;
    let (outcome, left_out) = match cut.filter(|_| without.is_empty()) {
        Some(cut) => {
            let cut = cut.finish().map_err(AuditError::from)?;
            let left_out = reason(&grid, &cut);
            (outcome.with_cut(cut), left_out)
        }
        None => (outcome, (!without.is_empty()).then(|| made_without(&without))),
    };
    if outcome.counts.edges == 0 && !asked.map.allow_empty {
        return Err(Error::NoEdges);
    }
    let are_all = !matches!(layer, TiledLayer::Unread { are_all: false, .. });
    let (mut imported, is_read) = match layer {
        TiledLayer::Read(imported) => (*imported, true),
        TiledLayer::Unread { ids, crs, .. } => (unread(&grid, &outcome, ids, crs.map(|crs| *crs))?, false),
    };
    imported.noted.defects = invalid(&outcome);
    imported.noted.unreadable =
        outcome.unreadable.iter().map(|(number, why)| (*number as usize, why.clone())).collect();
    if are_all {
        refuse_other(&imported, &outcome)?;
    }
    let has_ids = !imported.noted.ids.is_empty();
    let mut found = finished(imported, &grid, outcome, left_out, asked)?;
    if !is_read {
        // Nothing is known of the input.
        found.json.extra.remove("import");
        found.notes.retain(|note| matches!(note, Note::Warning(_)));
        let by_number = "features are known by their numbers: --of FILE reads their names and ids, on which the ids of findings depend";
        found.notes.extend((!has_ids).then(|| Note::Plain(by_number.to_owned())));
    }
    Ok(found)
}

/// What tiles know of the layer that they were made of.
fn unread(grid: &Grid, outcome: &Outcome, ids: Vec<Option<String>>, crs: Option<Crs>) -> Result<Imported, Error> {
    let mut noted = Noted::new(None);
    noted.ids = ids;
    for number in &outcome.without_geometry {
        noted.put_null(*number as usize, None);
        noted.without_geometry.push(*number as usize);
    }
    if let Some(corners) = outcome.corners {
        noted.reach(corners, &outcome.extents);
    }
    let mut read = ReadSummary::default();
    read.polygons = 1;
    read.other_crs = usize::from(crs.is_some());
    Ok(Imported {
        name: counted(grid.len(), "tile"),
        read,
        map: names(std::iter::empty())?,
        summary: BuildSummary::default(),
        noted,
        builder: None,
        unmatched: Vec::new(),
        features: Vec::new(),
        crs,
        orients_rings: false,
        edges: None,
    })
}

/// Refuses a layer with another box than the tiles, or without a feature that they name.
fn refuse_other(imported: &Imported, outcome: &Outcome) -> Result<(), Error> {
    let in_words = |corners: Option<[Point; 2]>| corners.map_or_else(|| "nothing".to_owned(), edge);
    let (of_tiles, of_layer) = (outcome.corners, imported.noted.corners());
    if of_tiles != of_layer {
        let [one, other] = [of_tiles, of_layer].map(in_words);
        return Err(Error::OtherLayer(format!("the box around theirs is {one}, and that of this one {other}")));
    }
    let of_findings = outcome.coverage.iter().flat_map(|found| &found.findings).flat_map(|one| &one.features);
    let of_crossings = outcome.crossings.iter().flat_map(|one| one.features.iter().map(|feature| *feature as usize));
    let numbers = of_findings.map(|feature| feature.index()).chain(of_crossings);
    let greatest = numbers.chain(imported.noted.defects.iter().map(|(feature, _)| *feature)).max();
    let count = imported.noted.ids.len();
    match greatest.filter(|number| count > 0 && *number >= count) {
        Some(number) => {
            let features = counted(count, "feature");
            Err(Error::OtherLayer(format!("theirs has a feature {number}, and this one has {features}")))
        }
        None => Ok(()),
    }
}

pub(crate) fn size(grid: &Grid) -> Value {
    match grid.size() {
        Some([columns, rows]) => json!({ "count": grid.len(), "columns": columns, "rows": rows }),
        None => json!({ "count": grid.len() }),
    }
}

/// Refuses a file whose header declares that its edges, between longitudes and latitudes in a box, are great circles: tiles have straight edges.
///
/// # Errors
/// [`Error::NotStraight`].
pub fn refuse_edges(edges: Option<&str>, crs: Option<&Crs>, corners: Option<[Point; 2]>) -> Result<(), Error> {
    let are_degrees = !crs.is_some_and(Crs::is_other) && are_degrees(corners);
    edges.filter(|_| are_degrees).map_or(Ok(()), |edges| Err(Error::NotStraight(edges.to_owned())))
}

/// Returns empty cuts for a map in the box between two corners, or for nothing.
///
/// # Errors
/// [`BuildError::OutOfReach`].
pub fn no_cuts(corners: Option<[Point; 2]>) -> Result<Cuts, BuildError> {
    Cuts::new(corners.iter().flatten().fold(0.0, |most: f64, p| most.max(p.x.abs()).max(p.y.abs())))
}

/// Returns the grid that divides the box between two corners, or a grid around nothing.
///
/// # Errors
/// [`Error::Grid`].
pub fn grid_of(corners: Option<[Point; 2]>, [columns, rows]: [u32; 2]) -> Result<Grid, Error> {
    // A box without width is divided as well.
    let wide = |low: f64, high: f64| if low < high { (low, high) } else { (low.min(0.0) - 1.0, high.max(0.0) + 1.0) };
    let ((left, right), (bottom, top)) = match corners {
        Some([low, high]) => (wide(low.x, high.x), wide(low.y, high.y)),
        None => ((0.0, 1.0), (0.0, 1.0)),
    };
    Ok(Grid::new([left, bottom], [right, top], columns, rows)?)
}

/// Merges portions, neighbours first; `None` if there are none.
///
/// # Errors
/// [`Error::Tiles`].
pub fn merged(mut portions: Vec<Portion>) -> Result<Option<Portion>, Error> {
    while portions.len() > 1 {
        let mut rest = portions.into_iter();
        let mut pairs = Vec::new();
        while let Some(one) = rest.next() {
            pairs.push(match rest.next() {
                Some(other) => one.merge(other).map_err(AuditError::from)?,
                None => one,
            });
        }
        portions = pairs;
    }
    Ok(portions.pop())
}

/// Creates the report, without facts about the input. `left_out` explains which tiles were left out when edges were cut.
fn report(
    imported: &Imported,
    mut outcome: Outcome,
    left_out: Option<String>,
    asked: &CoverageOptions,
    units: &Units,
    list: usize,
) -> Result<AuditReport, Error> {
    let mut rules: Vec<RuleLine> = outcome.rules().map(|(rule, outcome)| RuleLine::new(rule, outcome)).collect();
    rules.extend(SeamRule::ALL.into_iter().filter_map(|rule| seam_line(rule, &outcome)));
    let is_plane = outcome.crossings.is_empty() && outcome.adds_up.is_some();
    let why = match (&outcome.uncut, left_out) {
        (Some(why), _) => why.to_string(),
        (None, _) if is_plane => "tiles contradict each other".to_owned(),
        (None, Some(why)) => format!("borders cross, and {why}"),
        (None, None) => "borders cross, and it is not known how to cut them".to_owned(),
    };
    let too_far = imported.noted.too_far_to_cut().filter(|_| !is_plane);
    let found = too_far.map_or_else(|| outcome.coverage.take().ok_or(why), Err);
    let coverage = Coverage::of_tiles(imported, asked, units, list, found);
    let mismatched = |one: &Crossing| {
        let features = one.features.iter().map(|number| *number as usize).collect();
        one.kind != CrossingKind::Cross && coverage.lacks_any(&[one.first, one.second].concat(), &features)
    };
    let of_mismatches = outcome.crossings.iter().filter(|one| mismatched(one)).count();
    let source = |is_mismatch: bool, rule: Rule| {
        let of_clash = (rule == Rule::T3 && !outcome.crossings.is_empty()).then_some(Rule::G4.id());
        if is_mismatch { Some(CoverageRule::Mismatch.id()) } else { of_clash }
    };
    let all_mismatch = of_mismatches > 0 && of_mismatches == outcome.crossings.len();
    let mut violations: Vec<Diagnosis> =
        outcome.uneven.iter().map(|one| following(uneven(one), Rule::T3, source(all_mismatch, Rule::T3))).collect();
    violations.extend(
        outcome
            .crossings
            .iter()
            .map(|one| following(crossing(imported, one), Rule::G4, source(mismatched(one), Rule::G4))),
    );
    let too_many = outcome.too_many();
    violations.extend(too_many.iter().map(|one| violation(one.rule().id(), one.kind(), one.to_string(), &[])));
    violations.extend(outcome.seams.iter().map(seam));
    violations.extend(outcome.not_given.iter().map(|feature| not_given(*feature)));
    if outcome.adds_up == Some(false) && violations.is_empty() {
        violations.push(violation(Rule::T3.id(), "sums", "V − E + F is not 1 + C".to_owned(), &[]));
    }
    let violation_count = violations.len() as u64;
    violations.truncate(list);
    let (is_valid, bounds) = (outcome.is_valid(), outcome.bounds().filter(|_| outcome.is_valid()));
    let found = outcome.counts;
    // A rule that cannot be checked is not known to hold.
    let is_checked = !asked.coverage || coverage.not_checked().is_none();
    Ok(AuditReport {
        valid: is_valid && is_checked,
        json: JsonForm { counts: to_value(found)?, bounds, ..JsonForm::default() },
        counts: counts(&found),
        rules,
        violations,
        violation_count,
        coverage: Some(coverage),
        ..AuditReport::new(&imported.name)
    })
}

/// The line of a rule of seams; `None` if the rule holds.
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

fn crossing(imported: &Imported, one: &Crossing) -> Diagnosis {
    let [first, second] = [one.first, one.second].map(edge);
    let (kind, message) = match one.kind {
        CrossingKind::Touch => {
            let vertex = one.first[0];
            ("touch", format!("the vertex at ({}, {}) lies inside the edge {second}", vertex.x, vertex.y))
        }
        CrossingKind::Overlap => ("overlap", format!("the edges {first} and {second} overlap")),
        _ => ("cross", format!("the edges {first} and {second} cross where no vertex is")),
    };
    let places = match one.kind {
        CrossingKind::Touch => [&one.first[..1], &one.second].concat(),
        _ => [one.first, one.second].concat(),
    };
    let features = one.features.iter().map(|number| numbered_name(imported, *number as usize));
    let found = violation(Rule::G4.id(), kind, message, &places);
    let positions: Vec<_> = places.iter().copied().map(position).collect();
    let of_whole = match one.kind {
        CrossingKind::Touch => Violation::Touch { vertex: 0, half_edge: 0 },
        CrossingKind::Overlap => Violation::Overlap { first: 0, second: 0 },
        _ => Violation::Cross { first: 0, second: 0 },
    };
    Diagnosis {
        cause: Some(of_whole.cause()),
        features: Some(features.collect()),
        look: if one.kind == CrossingKind::Touch { found.look } else { middle(&positions) },
        ..found
    }
}

fn uneven(one: &Uneven) -> Diagnosis {
    let Uneven { vertices, edges, cycles, at, .. } = *one;
    let message =
        format!("a component has V = {vertices}, E = {edges} and {cycles} cycles: it does not fit in the plane");
    let found = violation(Rule::T3.id(), "genus", message, at.as_slice());
    let Some(genus) = one.genus() else { return found };
    let of_whole = Violation::Genus { vertex: 0, vertices: 0, edges: 0, cycles: 0, genus: 0 };
    let fields = Figures { vertices, edges, cycles, genus };
    Diagnosis { kind: Kind::Counted { kind: of_whole.kind(), fields }, cause: Some(of_whole.cause()), ..found }
}

fn seam(one: &SeamFault) -> Diagnosis {
    let what = match one.rule {
        SeamRule::Contact => "the first has an edge there that the second lacks",
        SeamRule::Order => "they have edges there in different orders",
        _ => "they name different features there",
    };
    let at = one.edge.map(|ends| format!(", at the edge {}", edge(ends))).unwrap_or_default();
    let places = one.edge.map(|ends| ends.to_vec()).unwrap_or_default();
    let (tile, beyond) = (one.tile, one.beyond);
    violation(one.rule.id(), one.rule.name(), format!("tiles {tile} and {beyond}: {what}{at}"), &places)
}

fn not_given(feature: u32) -> Diagnosis {
    let message = format!("a tile was not given its piece of feature {feature}, or was given another one");
    violation(SeamRule::Features.id(), "not_given", message, &[])
}
