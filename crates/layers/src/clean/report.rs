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
    /// The number of features with polygons.
    pub polygons: usize,
    /// The summary of noding.
    pub noding: Option<NodingSummary>,
    /// The area below which gaps were filled and slivers given away.
    pub sliver_area: f64,
    /// The greatest mean width of gaps that were filled at any area.
    pub gap_width: Option<f64>,
    /// The choice of that width, if it was to be chosen and there was a clear one.
    pub chosen: Option<ChosenWidth>,
    /// The changes of ownership, in order.
    pub changes: Vec<LayerChange>,
    /// The vertices that features lacked of their neighbours (C7), and have now: by the two features, then by place.
    pub added: Vec<AddedVertex>,
    /// The features with a changed geometry, in order.
    pub features: Vec<FeatureChange>,
    /// The number of the feature made for the gaps.
    pub made: Option<usize>,
    /// The remaining findings of C1 … C7, if there are any.
    pub left: Option<Left>,
    /// Each remaining finding, in order of the rules, the largest of a rule first.
    pub remaining: Vec<Remaining>,
    /// The gaps wider than the requested width. They are kept, and break nothing.
    pub wider_gaps: Vec<Remaining>,
    /// The gaps accepted by a point inside. They are kept, and break nothing.
    pub accepted_gaps: Vec<Remaining>,
    /// The accepted places without a gap. Unknown for a layer cleaned by neighbourhoods.
    pub unmet: Vec<Point>,
}

impl CleanReport {
    /// Returns the changed features, and features next to a fixed fault, possibly repeated. O(changes).
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

    pub(super) fn append(&mut self, other: Self) {
        self.changes.extend(other.changes);
        self.added.extend(other.added);
        self.features.extend(other.features);
        // There is something to report only if points were rounded.
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

    /// Adds the report of cleaning the result again, without the remaining findings. O(n log n).
    pub fn followed_by(&mut self, next: Self) {
        self.append(next);
        self.sort();
        // Sorting is stable: among two changes of a feature the later one comes second.
        self.features.dedup_by(|later, first| {
            let is_same = later.feature == first.feature;
            if is_same {
                first.area_after = later.area_after;
                first.points_after = later.points_after;
            }
            is_same
        });
    }

    /// Sorts changes by kind and place, and vertices and features in their usual order.
    pub(super) fn sort(&mut self) {
        self.changes.sort_by(|a, b| a.kind.cmp(&b.kind).then_with(|| compare_lexicographic(a.at, b.at)));
        let pair = |vertex: &AddedVertex| [vertex.to.min(vertex.of), vertex.to.max(vertex.of)];
        self.added.sort_by(|a, b| pair(a).cmp(&pair(b)).then_with(|| compare_lexicographic(a.at, b.at)));
        self.features.sort_by_key(|change| change.feature);
    }

    /// Sets the remaining findings from an audit of the result by its tiles. If all neighbourhoods of the layer [were
    /// cleaned](super::clean_neighbourhoods), they equal the findings of a full cleaning; otherwise others remain. O(findings).
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

/// An area that changed hands. Features are given by number, counted from 0.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LayerChange {
    /// The reason.
    pub kind: ChangeKind,
    /// The previous features.
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

/// A vertex that a feature has got from its neighbour. Features are given by number, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct AddedVertex {
    /// The place.
    pub at: Point,
    /// The feature that lacked it.
    pub to: usize,
    /// The neighbour, or the same feature for another ring of its own.
    pub of: usize,
}

/// A feature with a changed geometry.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FeatureChange {
    /// The number, counted from 0.
    pub feature: usize,
    /// The OGC defects before, each kind once.
    pub defects: Vec<DefectKind>,
    /// The area that its rings enclosed; for an invalid feature, the area that it covered by even-odd count.
    pub area_before: f64,
    /// The area that they enclose now; 0 if nothing is left, and then it has no geometry.
    pub area_after: f64,
    /// The number of points of its old rings, including the repeated end of each.
    pub points_before: usize,
    /// The number of points of its new rings.
    pub points_after: usize,
    /// The old geometry.
    pub before: Option<Geometry>,
}

/// A remaining finding. Features are given by number, counted from 0.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Remaining {
    /// The rule that it breaks, or would break if it were narrower.
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
    /// Makes a finding of C6 from the first defect of a feature.
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

/// The numbers of remaining findings of C1 … C7.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Left {
    /// True if borders meet only at common vertices; otherwise C1 … C4 are unknown.
    pub is_plane: bool,
    /// C1.
    pub overlaps: usize,
    /// C2: gaps larger and wider than the filled ones.
    pub gaps: usize,
    /// C3: borders that nearly meet, at a space that is open to the outside or to a wider gap.
    pub near_misses: usize,
    /// C4: slivers that are the only part of their feature.
    pub slivers: usize,
    /// C6: features invalid by the OGC.
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
    /// Compares the old shapes and polygons with the new polygons, the outer ring of each first.
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

/// Returns the area covered by polygons whose rings may cross: the faces inside an odd number of rings, on the finest grid.
fn covered(shapes: &[Shape]) -> Option<f64> {
    let mut builder = Builder::new();
    let feature =
        builder.feature(&twinedge_map::Feature { shapes: shapes.to_vec(), ..twinedge_map::Feature::default() }).ok()?;
    let map = builder.build_with(Noding::Snap(Snap::Auto)).ok()?;
    let areas = faces_of(&map, feature).into_iter().filter_map(|face| face_area(&map, face).ok());
    Some(areas.fold(0.0, |a, b| a + b))
}
