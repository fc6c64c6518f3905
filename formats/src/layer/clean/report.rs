//! The report of cleaning.

use super::super::model::Geometry;
use twinedge_algorithm::area::{face_area, ring_area};
use twinedge_algorithm::claims::faces_of;
use twinedge_coverage::clean::{Change, ChangeKind, ChosenWidth};
use twinedge_coverage::tile::Outcome;
use twinedge_coverage::{CoverageRule, Defect, DefectKind, Finding, defects};
use twinedge_geometry::Point;
use twinedge_geometry::noding::{NodingSummary, Snap};
use twinedge_geometry::predicates::compare_lexicographic;
use twinedge_map::{Builder, FeatureId, Noding, Shape};

/// The report of cleaning. Areas and widths are in the units of the coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CleanReport {
    /// The number of features that have polygons.
    pub polygons: usize,
    /// The summary of noding.
    pub noding: Option<NodingSummary>,
    /// The area below which gaps were filled and slivers given away.
    pub sliver_area: f64,
    /// The greatest mean width of gaps that were filled, whatever their area.
    pub gap_width: Option<f64>,
    /// The choice of that width, if it was to be chosen and there was a clear one.
    pub chosen: Option<ChosenWidth>,
    /// The changes of hands, in order.
    pub changes: Vec<LayerChange>,
    /// The vertices of features that their neighbours lacked (C7), and have now: by the two features, then by place.
    pub added: Vec<AddedVertex>,
    /// The features that have another geometry than before, in order.
    pub features: Vec<FeatureChange>,
    /// The number of the feature that was made for the gaps.
    pub made: Option<usize>,
    /// The findings of C1 … C7 that are left, if there are any.
    pub left: Option<Left>,
    /// Each thing that does, in order of the rules, the largest of a rule first.
    pub remaining: Vec<Remaining>,
    /// The gaps that are wider than the width that was asked for. They are left as they are, and break nothing.
    pub wider_gaps: Vec<Remaining>,
    /// The gaps that were accepted by a point inside. They are left as they are, and break nothing.
    pub accepted_gaps: Vec<Remaining>,
    /// The accepted places in which there was no gap. It is not known of a layer that was cleaned by neighbourhoods.
    pub unmet: Vec<Point>,
}

impl CleanReport {
    /// The features that changed, and those between which something was wrong that was mended; some several times. O(changes).
    #[must_use]
    pub fn touched(&self) -> Vec<usize> {
        let mut all: Vec<usize> = self.features.iter().map(|change| change.feature).collect();
        for change in &self.changes {
            all.extend(&change.from);
            all.extend(change.to);
        }
        for vertex in &self.added {
            all.extend([vertex.to, vertex.of]);
        }
        all
    }

    /// Takes what the report of another part of the same layer says of changes.
    pub(super) fn append(&mut self, other: Self) {
        self.changes.extend(other.changes);
        self.added.extend(other.added);
        self.features.extend(other.features);
        // Only where points were rounded is there something to say.
        let rounded = |noding: Option<NodingSummary>| noding.filter(|noding| noding.cell > 0.0);
        self.noding = match (rounded(self.noding), rounded(other.noding)) {
            (Some(mut all), Some(more)) => {
                all.cell = all.cell.max(more.cell);
                all.crossings += more.crossings;
                all.split += more.split;
                all.duplicates += more.duplicates;
                all.collapsed += more.collapsed;
                all.merged += more.merged;
                all.rounds = all.rounds.max(more.rounds);
                all.largest_move = [0, 1].map(|axis| all.largest_move[axis].max(more.largest_move[axis]));
                Some(all)
            }
            (one, other) => one.or(other),
        };
    }

    /// Takes the report of cleaning the result once more, without what is left. O(n log n).
    pub fn followed_by(&mut self, next: Self) {
        self.append(next);
        self.sort();
        // Sorting is stable: of two changes of a feature the later one comes second.
        self.features.dedup_by(|later, first| {
            let is_same = later.feature == first.feature;
            if is_same {
                first.area_after = later.area_after;
                first.points_after = later.points_after;
            }
            is_same
        });
    }

    /// Puts changes in order of their kinds and places, vertices and features as always.
    pub(super) fn sort(&mut self) {
        self.changes.sort_by(|a, b| a.kind.cmp(&b.kind).then_with(|| compare_lexicographic(a.at, b.at)));
        let pair = |vertex: &AddedVertex| [vertex.to.min(vertex.of), vertex.to.max(vertex.of)];
        self.added.sort_by(|a, b| pair(a).cmp(&pair(b)).then_with(|| compare_lexicographic(a.at, b.at)));
        self.features.sort_by_key(|change| change.feature);
    }

    /// Takes what is left from an audit of the result by its tiles. If all neighbourhoods of the layer [were cleaned](super::clean_neighbourhoods), that
    /// is what the report of cleaning the whole says; otherwise findings of all rules may be left. O(findings).
    pub fn judge(&mut self, outcome: &Outcome) {
        let found = outcome.coverage.as_ref();
        let count = |rule| found.map_or(0, |found| found.of(rule).count());
        let left = Left {
            is_plane: outcome.crossings.is_empty(),
            overlaps: count(CoverageRule::Overlap),
            gaps: count(CoverageRule::Gap),
            near_misses: count(CoverageRule::NearMiss),
            slivers: count(CoverageRule::Sliver),
            invalid: outcome.defects.len(),
        };
        let all = |findings: &[Finding]| findings.iter().map(Remaining::from).collect::<Vec<_>>();
        self.remaining = found.map(|found| all(&found.findings)).unwrap_or_default();
        self.wider_gaps = found.map(|found| all(&found.wider_gaps)).unwrap_or_default();
        self.accepted_gaps = found.map(|found| all(&found.accepted_gaps)).unwrap_or_default();
        let first =
            |(feature, defects): &(u32, Vec<Defect>)| Some(Remaining::invalid(*feature as usize, defects.first()?));
        self.remaining.extend(outcome.defects.iter().filter_map(first));
        let is_sound = left.is_plane && found.is_some() && self.remaining.is_empty();
        self.left = (!is_sound).then_some(left);
    }
}

/// An area that changed hands. Features are named by their numbers, counted from 0.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LayerChange {
    /// Why.
    pub kind: ChangeKind,
    /// The features that had it.
    pub from: Vec<usize>,
    /// The feature that got it.
    pub to: Option<usize>,
    /// The area.
    pub area: f64,
    /// The mean width.
    pub width: f64,
    /// A point inside.
    pub at: Point,
}

/// A vertex that a feature has now, as its neighbour had it before. Features are named by their numbers, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct AddedVertex {
    /// The place.
    pub at: Point,
    /// The feature that lacked it.
    pub to: usize,
    /// The neighbour, or the same feature: of another ring of its own.
    pub of: usize,
}

/// A feature that has another geometry than before.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FeatureChange {
    /// Its number, counted from 0.
    pub feature: usize,
    /// The defects by the OGC before, each kind once.
    pub defects: Vec<DefectKind>,
    /// The area that its rings enclosed; of one that was not valid, the area that it covered by even-odd count.
    pub area_before: f64,
    /// The area that they enclose now; 0 if nothing is left of it, and then it has no geometry.
    pub area_after: f64,
    /// The points of its rings, the repeated end of each included.
    pub points_before: usize,
    /// Those that it has now.
    pub points_after: usize,
    /// The geometry that it had.
    pub before: Option<Geometry>,
}

/// A thing that was left as it is. Features are named by their numbers, counted from 0.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Remaining {
    /// The rule that it breaks, or would break if it were not as wide.
    pub rule: CoverageRule,
    /// The features involved.
    pub features: Vec<usize>,
    /// The area; 0 for C6.
    pub area: f64,
    /// The mean width; 0 for C6.
    pub width: f64,
    /// A point inside.
    pub at: Point,
}

impl Remaining {
    /// C6: the first defect of a feature.
    pub(super) fn invalid(feature: usize, defect: &Defect) -> Self {
        Self { rule: CoverageRule::Validity, features: vec![feature], area: 0.0, width: 0.0, at: defect.at }
    }
}

impl From<&Finding> for Remaining {
    fn from(finding: &Finding) -> Self {
        Self {
            rule: finding.rule,
            features: finding.features.iter().map(|feature| feature.index()).collect(),
            area: finding.area,
            width: finding.width,
            at: finding.at,
        }
    }
}

/// The number of findings of C1 … C7 that are left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Left {
    /// True if borders meet at common vertices only; otherwise C1 … C4 are not known.
    pub is_plane: bool,
    /// C1.
    pub overlaps: usize,
    /// C2: gaps that are larger and wider than those that are filled.
    pub gaps: usize,
    /// C3: borders that nearly meet, beside a space that is open to the outside or to a wider gap.
    pub near_misses: usize,
    /// C4: slivers that are all that there is of their feature.
    pub slivers: usize,
    /// C6: features that are not valid by the OGC.
    pub invalid: usize,
}

impl From<&Change> for LayerChange {
    fn from(change: &Change) -> Self {
        Self {
            kind: change.kind,
            from: change.from.iter().map(|feature| feature.index()).collect(),
            to: change.to.map(FeatureId::index),
            area: change.area,
            width: change.width,
            at: change.at,
        }
    }
}

impl FeatureChange {
    /// By the shapes and polygons before, and the polygons after, the outer ring of each first.
    pub(super) fn new(feature: usize, shapes: &[Shape], before: &[Vec<Vec<Point>>], after: &[Vec<Vec<Point>>]) -> Self {
        let area = |rings: &Vec<Vec<Point>>| {
            let areas = rings.iter().map(|ring| ring_area(ring.iter().copied()).abs());
            areas.enumerate().map(|(i, area)| if i == 0 { area } else { -area }).sum::<f64>()
        };
        let mut kinds: Vec<DefectKind> = defects(shapes).iter().map(|defect| defect.kind).collect();
        kinds.dedup();
        let by_faces = if kinds.is_empty() { None } else { covered(shapes) };
        let total = |polygons: &[Vec<Vec<Point>>]| polygons.iter().map(area).fold(0.0, |a, b| a + b);
        let points = |polygons: &[Vec<Vec<Point>>]| polygons.iter().flatten().map(Vec::len).sum();
        Self {
            feature,
            defects: kinds,
            area_before: by_faces.unwrap_or_else(|| total(before)),
            area_after: total(after),
            points_before: points(before),
            points_after: points(after),
            before: None,
        }
    }
}

/// The area that polygons cover whose rings may cross: that of the faces inside an odd number of rings, on the finest grid.
fn covered(shapes: &[Shape]) -> Option<f64> {
    let mut builder = Builder::new();
    let feature =
        builder.feature(&twinedge_map::Feature { shapes: shapes.to_vec(), ..twinedge_map::Feature::default() }).ok()?;
    let map = builder.build_with(Noding::Snap(Snap::Auto)).ok()?;
    let areas = faces_of(&map, feature).into_iter().filter_map(|face| face_area(&map, face).ok());
    Some(areas.fold(0.0, |a, b| a + b))
}
