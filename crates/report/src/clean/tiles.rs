//! Cleans a file that is larger than memory: judges its tiles, cleans the neighbourhoods of findings, and judges the tiles of the result.

use super::names::no_column;
use super::told::{Called, ToldTiles, mentioned};
use super::{Names, Repair};
use crate::error::Error;
use crate::shelf::Shelf;
use crate::tiles::{Division, fitting, grid_of, judged, size};
use crate::words::{counted, grouped, place};
use serde_json::json;
use std::collections::BTreeSet;
use std::io;
use twinedge_coverage::tile::{Grid, Outcome};
use twinedge_coverage::{CoverageRule, Finding, Limits, insert_touches};
use twinedge_diagnosis::FeatureName;
use twinedge_layers::clean::{
    CleanError, CleanOptions, CleanReport, Extent, Neighbourhoods, Source, TooLarge, clean_neighbourhoods, is_tidy,
};
use twinedge_layers::io::ReadSummary;
use twinedge_layers::{Feature, FileError, GeoJsonFile, to_map};

/// The bytes used per vertex of a neighbourhood: twice the measured number.
const BYTES: u64 = 800;

/// The maximal number of rounds in which the result is judged and cleaned again.
const ROUNDS: usize = 8;

/// The factor by which measured numbers are increased against rounding.
const ROUNDING: f64 = 1.0 + 1e-6;

/// A layer cleaned by tiles.
#[derive(Clone, Debug)]
pub struct CleanedTiles {
    /// The report.
    pub report: CleanReport,
    /// The neighbourhoods left unchanged because they have more vertices than fit into memory.
    pub too_large: Vec<TooLarge>,
    pub(super) features: usize,
    pub(super) called: Vec<(usize, Called)>,
    pub(super) largest: f64,
    grid: Grid,
    neighbourhoods: usize,
    vertices: u64,
}

impl CleanedTiles {
    /// Returns the tiles as the text and the JSON show them, with `decimals` decimal places.
    pub(super) fn told(&self, decimals: usize, named: impl Fn(&usize) -> FeatureName) -> ToldTiles {
        let neighbourhoods = counted(self.neighbourhoods, "neighbourhood");
        let largest = grouped(self.vertices as usize);
        let too_large = |one: &TooLarge| {
            json!({
                "window": one.window.map(|p| [p.x, p.y]),
                "features": one.features.iter().map(&named).collect::<Vec<_>>(),
                "vertices": one.vertices,
            })
        };
        let line_of = |one: &TooLarge| {
            let [low, high] = one.window.map(|p| place([p.x, p.y], decimals));
            let (features, vertices) = (counted(one.features.len(), "feature"), grouped(one.vertices as usize));
            format!("{features} between {low} and {high}: the neighbourhood has {vertices} vertices")
        };
        let mut json = size(&self.grid);
        json["neighbourhoods"] = self.neighbourhoods.into();
        json["largest_vertices"] = self.vertices.into();
        json["not_cleaned"] = self.too_large.iter().map(too_large).collect();
        ToldTiles {
            line: format!(
                "{} judged, {neighbourhoods} cleaned, the largest with {largest} vertices",
                counted(self.grid.len(), "tile")
            ),
            too_large: self.too_large.iter().map(line_of).collect(),
            json,
        }
    }
}

/// Cleans a file by tiles. `open` opens the file and hands over its features; `shelves` creates empty shelves. The returned file has the cleaned
/// features, for the caller to write. The options `snap`, `chooses_width` and `gaps_to` are ignored, because they look at the whole layer.
///
/// Costs two audits by tiles plus the cleaning of the neighbourhoods. Needs the memory of an audit, 64 bytes for each feature, and the memory for the
/// largest neighbourhood, which is bounded as tiles are.
///
/// # Errors
/// [`Error`].
pub fn clean_in_tiles(
    open: impl FnOnce(&mut dyn FnMut(Feature)) -> Result<GeoJsonFile, FileError>,
    repair: &Repair<'_>,
    division: Division,
    shelves: impl Fn() -> io::Result<Box<dyn Shelf>>,
    stage: &mut dyn FnMut(&'static str),
) -> Result<(GeoJsonFile, CleanedTiles), Error> {
    let mut shelf = shelves()?;
    let mut read = FirstReading::new(repair.names);
    let mut full = Ok(());
    let mut file = open(&mut |feature| {
        if full.is_ok() {
            full = read.take(&feature, &mut *shelf);
        }
    })?;
    full?;
    let FirstReading { untidy, .. } = read.checked()?;
    let Some(corners) = Extent::around(file.extents()) else { return Err(CleanError::NoPolygons.into()) };
    let largest = Extent::largest(file.extents());
    let limits = limits(&repair.options);
    stage("dividing the map");
    let (grid, most) = match division {
        Division::Across(across) => (grid_of(Some(corners), [across; 2])?, u64::MAX),
        Division::Within(bytes) => (fitting(&mut *shelf, bytes)?, bytes / BYTES),
    };
    let before = judged(&grid, Some(corners), &limits, &mut *shelf, || stage("judging the tiles"))?;
    drop(shelf);
    let sliver_area = before.coverage.as_ref().map(|found| found.sliver_area).ok_or_else(|| unknown(&before))?;
    let mut options = repair.options.clone();
    options.assign.sliver_area.get_or_insert(sliver_area);
    let clean = |file: &mut GeoJsonFile, outcome: &Outcome| {
        let all = [untidy.clone(), concerned(outcome, &options)].concat();
        clean_neighbourhoods(file, &all, &options, most)
    };
    stage("cleaning the neighbourhoods");
    let mut done = clean(&mut file, &before)?;
    let mut after = before;
    let mut is_fixed = done.report.features.is_empty();
    for round in 1..=ROUNDS {
        if is_fixed {
            break;
        }
        file.settle()?;
        let mut shelf = shelves()?;
        file.each(|feature| Ok::<_, Error>(shelf.put(polygons(&feature))?))?;
        after = judged(&grid, Some(corners), &limits, &mut *shelf, || stage("judging the result"))?;
        if round == ROUNDS || concerned(&after, &options).is_empty() {
            break;
        }
        let next = clean(&mut file, &after)?;
        is_fixed = next.report.features.is_empty();
        done.report.followed_by(next.report);
        done.cleaned = done.cleaned.max(next.cleaned);
        done.largest = done.largest.max(next.largest);
        done.too_large = next.too_large;
    }
    let Neighbourhoods { mut report, cleaned, largest: vertices, too_large, .. } = done;
    report.judge(&after);
    let mut numbers = mentioned(&report);
    numbers.extend(too_large.iter().flat_map(|one| &one.features));
    numbers.sort_unstable();
    numbers.dedup();
    let name = |number| Ok::<_, Error>((number, Called::new(repair.names, &file.read(number)?)));
    let called = numbers.into_iter().map(name).collect::<Result<_, _>>()?;
    let features = file.extents().len();
    let tiles = CleanedTiles { report, too_large, features, called, largest, grid, neighbourhoods: cleaned, vertices };
    Ok((file, tiles))
}

struct FirstReading<'a> {
    names: Names<'a>,
    features: u32,
    is_named: bool,
    columns: BTreeSet<String>,
    /// The features whose rings are open or repeat points. This breaks no rule; each feature is a set by itself.
    untidy: Vec<Vec<usize>>,
}

impl<'a> FirstReading<'a> {
    fn new(names: Names<'a>) -> Self {
        Self { names, features: 0, is_named: false, columns: BTreeSet::new(), untidy: Vec::new() }
    }

    fn take(&mut self, feature: &Feature, shelf: &mut dyn Shelf) -> io::Result<()> {
        let number = self.features;
        self.features = number.checked_add(1).ok_or_else(|| io::Error::other("there are 2^32 features or more"))?;
        self.is_named |= self.names.of(feature).is_some();
        self.names.columns(feature, &mut self.columns);
        if !is_tidy(feature) {
            self.untidy.push(vec![number as usize]);
        }
        shelf.put(polygons(feature))
    }

    fn checked(self) -> Result<Self, Error> {
        match self.names.from {
            Some(column) if !self.is_named => Err(no_column(column, self.columns)),
            _ => Ok(self),
        }
    }
}

/// Returns a feature's polygons as a map takes them.
fn polygons(feature: &Feature) -> twinedge_map::Feature {
    let mut shapes = to_map(feature, &mut ReadSummary::default()).shapes;
    shapes.retain(|shape| matches!(shape, twinedge_map::Shape::Polygon(_)));
    insert_touches(&mut shapes);
    twinedge_map::Feature { shapes, ..twinedge_map::Feature::default() }
}

/// Returns the limits for judging the layer, as in cleaning the whole layer.
fn limits(options: &CleanOptions) -> Limits {
    let assign = options.assign.clone();
    Limits {
        gap_width: assign.gap_width,
        lake_width: assign.lake_width,
        accepted_gaps: assign.accepted_gaps,
        sliver_area: assign.sliver_area,
        thinness: assign.thinness,
    }
}

fn unknown(outcome: &Outcome) -> Error {
    let why = outcome.uncut.as_ref().map_or_else(|| "tiles contradict each other".to_owned(), ToString::to_string);
    Error::Unjudged(why)
}

/// Returns the sets of features with a finding between them that cleaning fixes.
fn concerned(outcome: &Outcome, options: &CleanOptions) -> Vec<Vec<usize>> {
    let assign = &options.assign;
    let is_filled = |gap: &Finding| {
        assign.sliver_area.is_some_and(|limit| gap.area < limit * ROUNDING)
            || assign.gap_width.is_some_and(|limit| gap.width <= limit * ROUNDING)
    };
    let is_mended = |finding: &&Finding| match finding.rule {
        CoverageRule::Gap => is_filled(finding),
        CoverageRule::NearMiss => assign.gap_width.is_some(),
        _ => true,
    };
    let found = outcome.coverage.iter().flat_map(|found| found.findings.iter().chain(&found.wider_gaps));
    let of_coverage = found.filter(is_mended).map(|one| one.features.iter().map(|feature| feature.index()).collect());
    let crossings = outcome.crossings.iter().map(|one| one.features.iter().map(|number| *number as usize).collect());
    let invalid = outcome.defects.iter().map(|(feature, _)| vec![*feature as usize]);
    of_coverage.chain(crossings).chain(invalid).collect()
}

#[cfg(test)]
mod tests;
