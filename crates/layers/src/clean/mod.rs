//! Cleaning a layer of polygons: noding, then [`twinedge_coverage::clean`], then the polygons of the changed features.
//!
//! ```text
//!   polygons ─► map, cut where they meet ─► faces, each of one feature ─► outlines ─► polygons
//!                                                                            │
//!                     what is the same as before stays as it is, to the byte ◄┘
//! ```
//!
//! Ids, attributes, the order of features and foreign members stay. A feature with an unchanged outline keeps its geometry. Other
//! geometries are rebuilt: rings are closed, without repeated points and spikes, valid by the rules of the OGC, and keep their
//! direction. If only vertices of a neighbour were missing (C7), they are inserted into the otherwise unchanged rings. Existing
//! vertices keep their further dimensions; for new ones these are interpolated along the ring.
//!
//! Narrow spaces between two features that are open to the outside or to a wider gap (C3) are filled if a width of gaps is given:
//! quadrangles are drawn between the borders that face each other, and their area goes to a neighbour.
//!
//! Lines and points are neither cut nor moved.

mod dimensions;
mod extent;
mod fillers;
mod gaps_to;
mod missing;
mod neighbourhoods;
mod rebuild;
mod report;
mod restored;

use super::model::{Dimensions, Feature, Geometry, Layer, Shape};
use crate::io::ReadSummary;
use dimensions::Further;
use fillers::fillers;
use missing::Missing;
use rebuild::{is_same, polygons_of, replace, rings_of};
use restored::Restoration;
use std::borrow::Cow;
use twinedge_algorithm::contour;
use twinedge_algorithm::contour::ContourError;
use twinedge_coverage::clean::{ChosenWidth, Cleaned, Options, choose_gap_width, clean_with_fillers};
use twinedge_coverage::{CoverageError, CoverageRule, Finding, Limits, check, defects, insert_touches};
use twinedge_geometry::Point;
use twinedge_geometry::noding::{NodingSummary, Snap};
use twinedge_map::{BuildError, Builder, Noding, PlanarMap};

pub use extent::Extent;
pub use gaps_to::{GapsTo, GapsToError};
pub use neighbourhoods::{Neighbourhoods, Source, TooLarge, clean_neighbourhoods};
#[cfg(feature = "geojson")]
pub(super) use rebuild::Bounds;
pub use rebuild::is_tidy;
pub use report::{AddedVertex, CleanReport, FeatureChange, LayerChange, Left, Remaining};

/// The options of cleaning a layer.
#[derive(Clone, Debug, Default)]
pub struct CleanOptions {
    /// The grid to which points are rounded. Without one nothing moves, unless borders cross where there is no point: then all
    /// points are rounded to the finest grid that the coordinates allow.
    pub snap: Option<Snap>,
    /// The assignment of faces to features. [`gaps_to`](Self::gaps_to) selects the features that get gaps.
    pub assign: Options,
    /// True to choose the [greatest width of filled gaps](Options::gap_width) from the existing gaps ([`choose_gap_width`]).
    pub chooses_width: bool,
    /// The feature that gets filled gaps; by default a neighbour.
    pub gaps_to: Option<GapsTo>,
}

/// The reason why a layer could not be cleaned.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CleanError {
    /// The layer has no polygons.
    #[error("there is no polygon to clean")]
    NoPolygons,
    /// No map can be made of the polygons.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// The map is not plane: an error of the library.
    #[error(transparent)]
    Coverage(#[from] CoverageError),
    /// A feature has no outline: an error of the library.
    #[error(transparent)]
    Contour(#[from] ContourError),
}

/// Cleans a layer in place, and reports the changes. O(n log n) for most layers; see [`twinedge_coverage::clean::clean`] and
/// [noding](twinedge_geometry::noding#cost).
///
/// Cleaning the result again changes nothing.
///
/// ```
/// use twinedge_layers::clean::{CleanOptions, clean};
/// use twinedge_layers::{ReadOptions, read_layer};
///
/// # #[cfg(feature = "wkt")] {
/// // The right parcel begins half a unit inside the left one.
/// let text = "POLYGON((0 0, 10 0, 10 10, 0 10, 0 0))\nPOLYGON((9.5 0, 19 0, 19 10, 9.5 10, 9.5 0))\n";
/// let mut layer = read_layer(&mut text.as_bytes(), None, &ReadOptions::default())?;
/// let report = clean(&mut layer, &CleanOptions::default())?;
/// assert_eq!((report.changes.len(), report.changes[0].area), (1, 5.0));
/// assert!(report.left.is_none());
/// # }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`CleanError`]; the layer is then unchanged.
pub fn clean(layer: &mut Layer, options: &CleanOptions) -> Result<CleanReport, CleanError> {
    let extents: Vec<Extent> = layer.features.iter().map(Extent::of).collect();
    clean_part(layer, options, Extent::largest(&extents))
}

/// Cleans like [`clean`] a part of a layer with this largest coordinate. So the part has the finest grid of the layer, and each
/// round has that of the first, even if the point farthest out is gone.
fn clean_part(layer: &mut Layer, options: &CleanOptions, largest: f64) -> Result<CleanReport, CleanError> {
    let mut options = options.clone();
    let mut features: Vec<Cow<'_, Feature>> = layer.features.iter().map(Cow::Borrowed).collect();
    options.assign.gaps_to = options.gaps_to.take().map(|to| receiving(&mut features, to)).unwrap_or_default();
    let mut done = pass(&features, &[], largest, &options)?;
    let chosen = done.chosen;
    if std::mem::take(&mut options.chooses_width) {
        options.assign.gap_width = chosen.map(|chosen| chosen.width);
    }
    let options = &options;
    // Narrow spaces that are open to the outside are filled, as long as their number falls.
    if let Some(width) = options.assign.gap_width {
        let mut near_misses = done.near_misses(options.assign.window);
        while !near_misses.is_empty() {
            let next = pass(&done.features, &fillers(&near_misses, width), largest, options)?;
            let left = next.near_misses(options.assign.window);
            if left.len() >= near_misses.len() || !next.is_plane() {
                break;
            }
            near_misses = left;
            let noding = done.noding.filter(|noding| noding.cell > 0.0).or(next.noding);
            done.changes.extend(next.changes.iter().cloned());
            done = Pass { changes: done.changes, added: done.added, noding, ..next };
        }
    }
    let mut report = CleanReport {
        polygons: 0,
        noding: done.noding,
        sliver_area: done.sliver_area,
        gap_width: options.assign.gap_width,
        chosen,
        changes: done.changes,
        added: done.added,
        features: Vec::new(),
        made: None,
        left: done.judged.left,
        remaining: done.judged.remaining.iter().map(Remaining::from).collect(),
        wider_gaps: done.judged.wider_gaps.iter().map(Remaining::from).collect(),
        accepted_gaps: done.judged.accepted_gaps.iter().map(Remaining::from).collect(),
        unmet: done.judged.unmet,
    };
    report.remaining.extend(done.judged.invalid);
    let mut changed = Vec::new();
    let nothing = Feature::default();
    for (number, after) in done.features.into_iter().enumerate() {
        let before = layer.features.get(number).unwrap_or(&nothing);
        let polygons = before.geometry.as_ref().map(polygons_of).unwrap_or_default();
        report.polygons += usize::from(!polygons.is_empty());
        // A feature that was selected for gaps and got none.
        let is_still_empty = before.geometry.is_none() && after.geometry.as_ref().is_none_or(|it| it.shape.is_empty());
        if before.geometry != after.geometry && !is_still_empty {
            let mut after = after.into_owned();
            let now = after.geometry.as_ref().map(polygons_of).unwrap_or_default();
            report.features.push(FeatureChange::new(number, &shapes(before), &polygons, &now));
            rebuild::update_box(&mut after);
            changed.push((number, after));
        }
    }
    for ((number, feature), change) in changed.into_iter().zip(&mut report.features) {
        if let Some(place) = layer.features.get_mut(number) {
            change.before = std::mem::replace(place, feature).geometry;
        } else {
            report.made = Some(number);
            layer.features.push(feature);
        }
    }
    if !report.features.is_empty() {
        rebuild::update_box_of_layer(layer);
    }
    Ok(report)
}

/// Returns the numbers of the features selected for gaps, giving each a geometry, possibly empty. A new one is added last.
fn receiving(features: &mut Vec<Cow<'_, Feature>>, to: GapsTo) -> Vec<usize> {
    let mut of_all =
        features.iter().filter_map(|feature| feature.geometry.as_ref()).map(|geometry| geometry.dimensions);
    let dimensions = of_all.next().filter(|first| of_all.all(|other| other == *first)).unwrap_or(Dimensions::Xy);
    let numbers = match to {
        GapsTo::Features(numbers) => numbers,
        GapsTo::New(attributes) => {
            features.push(Cow::Owned(Feature { attributes, ..Feature::default() }));
            vec![features.len() - 1]
        }
    };
    for number in &numbers {
        if let Some(feature) = features.get_mut(*number).filter(|feature| feature.geometry.is_none()) {
            feature.to_mut().geometry = Some(Geometry::new(dimensions, Shape::MultiPolygon(Vec::new())));
        }
    }
    numbers
}

struct Pass<'a> {
    /// Unchanged features are borrowed.
    features: Vec<Cow<'a, Feature>>,
    changes: Vec<LayerChange>,
    added: Vec<AddedVertex>,
    noding: Option<NodingSummary>,
    sliver_area: f64,
    chosen: Option<ChosenWidth>,
    judged: Judgement,
}

impl Pass<'_> {
    fn is_plane(&self) -> bool {
        self.judged.left.is_none_or(|left| left.is_plane)
    }

    fn near_misses(&self, window: Option<[Point; 2]>) -> Vec<Finding> {
        let all = self.judged.remaining.iter().filter(|finding| finding.rule == CoverageRule::NearMiss);
        let is_in =
            |p: &Point| window.is_none_or(|[low, high]| low.x <= p.x && low.y <= p.y && p.x <= high.x && p.y <= high.y);
        all.filter(|finding| finding.stretches.iter().flatten().all(is_in)).cloned().collect()
    }
}

/// Runs one round: noding, faces to features, outlines.
fn pass<'a>(
    features: &[Cow<'a, Feature>],
    fillers: &[twinedge_map::Shape],
    largest: f64,
    options: &CleanOptions,
) -> Result<Pass<'a>, CleanError> {
    // A point outside of everything sets the finest grid.
    let anchor = twinedge_map::Shape::Point(Point::new(largest, largest));
    let beside = [fillers, &[anchor]].concat();
    // The corners of fillers are computed: they lie beside the borders, not on them.
    let snap = options.snap.or((!fillers.is_empty()).then_some(Snap::Auto));
    let map = build(features, &beside, snap)?;
    let is_cut = map.noding().is_some_and(|noding| noding.split > 0);
    let unmatched = if is_cut { gather(features, &[])?.unmatched() } else { Vec::new() };
    let missing = Missing::new(&map, &unmatched)?;
    let mut options = Cow::Borrowed(options);
    let chosen = if options.chooses_width { choose_gap_width(&map, &options.assign)? } else { None };
    if options.chooses_width {
        options.to_mut().assign.gap_width = chosen.map(|chosen| chosen.width);
    }
    let options = &*options;
    let cleaned = clean_with_fillers(&map, &options.assign, features.len())?;
    let (noding, sliver_area) = (map.noding().copied(), cleaned.sliver_area);
    let changes = cleaned.changes.iter().map(LayerChange::from).collect();
    // A grid that was not requested is only a means: points move back to their original positions, if nothing crosses then.
    let restored = match (options.snap, noding) {
        (None, Some(noding)) if noding.cell > 0.0 => Some(Restoration::new(features, &noding)),
        _ => None,
    };
    let heirs = &options.assign.gaps_to;
    let mut made = outlined(features, heirs, &map, &cleaned, &missing, restored.as_ref())?;
    // The map is dropped before the outlines are judged, unless they may be rebuilt.
    let kept = restored.is_some().then_some((map, cleaned));
    let mut found = judged(&made, options)?;
    if let Some((map, cleaned)) = kept.filter(|_| found.left.is_some_and(|left| !left.is_plane)) {
        made = outlined(features, heirs, &map, &cleaned, &missing, None)?;
        found = judged(&made, options)?;
    }
    Ok(Pass { features: made, changes, added: missing.added, noding, sliver_area, chosen, judged: found })
}

fn outlined<'a>(
    features: &[Cow<'a, Feature>],
    heirs: &[usize],
    map: &PlanarMap,
    cleaned: &Cleaned,
    missing: &Missing,
    restored: Option<&Restoration>,
) -> Result<Vec<Cow<'a, Feature>>, CleanError> {
    let noding = map.noding().copied().filter(|noding| noding.cell > 0.0);
    let mut further = Further::new(features, noding);
    let mut all = features.to_vec();
    for (number, (feature, faces)) in all.iter_mut().zip(&cleaned.faces).enumerate() {
        let Some(geometry) = &feature.geometry else { continue };
        let before = polygons_of(geometry);
        if before.is_empty() && !heirs.contains(&number) {
            continue;
        }
        let mut after = contour::of_faces(map, faces.iter().copied())?.polygons;
        if let Some(restored) = restored {
            for polygon in &mut after {
                restored.polygon(polygon);
            }
        }
        if !is_same(&before, &after) && !is_same(&with_touches(feature), &after) {
            let with_vertices = missing.inserted(number, &before).filter(|rings| is_same(rings, &after));
            let mut rings: Vec<rebuild::Rings> =
                with_vertices.unwrap_or_else(|| after.into_iter().map(rings_of).collect());
            rebuild::wind_as(&before, &mut rings);
            let geometry = replace(geometry, &rings, &mut further);
            feature.to_mut().geometry = geometry;
        }
    }
    Ok(all)
}

/// Builds the map of all polygons followed by the fillers, cut where they meet. Without a grid nothing moves, unless borders cross.
fn build(
    features: &[Cow<'_, Feature>],
    fillers: &[twinedge_map::Shape],
    snap: Option<Snap>,
) -> Result<PlanarMap, CleanError> {
    if let Some(snap) = snap {
        return Ok(gather(features, fillers)?.build_with(Noding::Snap(snap))?);
    }
    match gather(features, fillers)?.build_with(Noding::Exact) {
        Err(BuildError::Crossing { .. }) => Ok(gather(features, fillers)?.build_with(Noding::Snap(Snap::Auto))?),
        built => Ok(built?),
    }
}

/// Returns a builder with all polygons followed by the fillers.
fn gather(features: &[Cow<'_, Feature>], fillers: &[twinedge_map::Shape]) -> Result<Builder, CleanError> {
    let mut builder = Builder::new();
    let mut any = false;
    for feature in features {
        let shapes = shapes(feature);
        any |= !shapes.is_empty();
        builder.feature(&twinedge_map::Feature { name: feature.name(), id: None, shapes })?;
    }
    if !any {
        return Err(CleanError::NoPolygons);
    }
    for filler in fillers {
        builder.shape(filler)?;
    }
    Ok(builder)
}

/// Returns the polygons of a feature for the library, with vertices added where rings touch as the OGC allows.
fn shapes(feature: &Feature) -> Vec<twinedge_map::Shape> {
    let mut shapes = super::to_map(feature, &mut ReadSummary::default()).shapes;
    shapes.retain(|shape| matches!(shape, twinedge_map::Shape::Polygon(_)));
    insert_touches(&mut shapes);
    shapes
}

fn with_touches(feature: &Feature) -> Vec<rebuild::Rings> {
    let rings = |shape| if let twinedge_map::Shape::Polygon(rings) = shape { rings } else { Vec::new() };
    shapes(feature).into_iter().map(rings).collect()
}

#[derive(Default)]
struct Judgement {
    left: Option<Left>,
    /// C1 … C4.
    remaining: Vec<Finding>,
    /// C6.
    invalid: Vec<Remaining>,
    wider_gaps: Vec<Finding>,
    accepted_gaps: Vec<Finding>,
    /// The accepted places without a gap.
    unmet: Vec<Point>,
}

/// Returns the findings of C1 … C7 afterwards, judged by the polygons that are written.
fn judged(features: &[Cow<'_, Feature>], options: &CleanOptions) -> Result<Judgement, CleanError> {
    let mut builder = Builder::new();
    let mut left = Left::default();
    let mut judged = Judgement::default();
    for (number, feature) in features.iter().enumerate() {
        let shapes = shapes(feature);
        if let Some(defect) = defects(&shapes).first() {
            left.invalid += 1;
            judged.invalid.push(Remaining::invalid(number, defect));
        }
        builder.feature(&twinedge_map::Feature { shapes, ..twinedge_map::Feature::default() })?;
    }
    let map = builder.build()?;
    left.is_plane = map.is_plane();
    if map.is_plane() {
        let Options { gap_width, lake_width, accepted_gaps, sliver_area, thinness, .. } = options.assign.clone();
        let limits = Limits { gap_width, lake_width, accepted_gaps, sliver_area, thinness };
        let found = check(&map, &limits)?;
        judged.unmet = found.unmet_places(&map, &limits);
        let count = |rule| found.of(rule).count();
        left.overlaps = count(CoverageRule::Overlap);
        left.gaps = count(CoverageRule::Gap);
        left.near_misses = count(CoverageRule::NearMiss);
        left.slivers = count(CoverageRule::Sliver);
        judged.wider_gaps = found.wider_gaps;
        judged.accepted_gaps = found.accepted_gaps;
        judged.remaining = found.findings;
        judged.remaining.retain(|finding| finding.rule != CoverageRule::Duplicate);
    }
    judged.left = (left != Left { is_plane: true, ..Left::default() }).then_some(left);
    Ok(judged)
}
