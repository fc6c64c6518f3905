//! Cleaning a layer of polygons: noding, then [`twinedge::algorithm::clean`], then the polygons of the features that changed.
//!
//! ```text
//!   polygons ─► map, cut where they meet ─► faces, each of one feature ─► outlines ─► polygons
//!                                                                            │
//!                     what is the same as before stays as it is, to the byte ◄┘
//! ```
//!
//! Ids, attributes, the order of features and foreign members stay. Of a feature whose outline is the same, so does the geometry.
//! That of the others is made anew: rings are closed, outer ones counter-clockwise, without repeated points and spikes, valid by
//! the rules of the OGC. Vertices that were there before keep their further dimensions; for the others these are interpolated
//! along the ring.
//!
//! Lines and points are neither cut nor moved.

mod dimensions;
mod rebuild;
mod report;
mod restored;

use super::model::{Feature, Layer};
use dimensions::Further;
use rebuild::{is_same, polygons_of, replace};
use restored::Restored;
use twinedge::algorithm::area::ring_area;
use twinedge::algorithm::clean::{Cleaned, Options, clean as assign};
use twinedge::algorithm::contour::{self, ContourError, Polygon};
use twinedge::algorithm::coverage::{CoverageError, CoverageRule, Limits, check, defects};
use twinedge::geometry::Point;
use twinedge::geometry::noding::Snap;
use twinedge::io::ReadSummary;
use twinedge::map::{self, BuildError, Builder, Noding, PlanarMap};

pub use report::{CleanReport, FeatureChange, Left, LayerChange};

/// How a layer is cleaned.
#[derive(Clone, Copy, Debug, Default)]
pub struct CleanOptions {
    /// The grid to which points are rounded. Without one nothing moves, unless borders cross where there is no point: then all
    /// points are rounded to the finest grid that the coordinates allow.
    pub snap: Option<Snap>,
    /// Which feature gets what.
    pub assign: Options,
}

/// Why a layer could not be cleaned.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CleanError {
    /// There is no polygon.
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

/// Cleans a layer in place, and reports what was done. O(n log n) for most layers; see
/// [`twinedge::algorithm::clean::clean`] and [noding](twinedge::geometry::noding#cost).
///
/// Cleaning the result again changes nothing.
///
/// ```
/// use twinedge_formats::layer::clean::{CleanOptions, clean};
/// use twinedge_formats::layer::{ReadOptions, read_layer};
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
    let map = build(&layer.features, options.snap)?;
    let cleaned = assign(&map, &options.assign)?;
    let cell = map.noding().map(|noding| noding.cell).filter(|cell| *cell > 0.0);
    // A grid that nobody asked for is a means only: points go back to where they were, if nothing crosses then.
    let restored = match (options.snap, cell) {
        (None, Some(cell)) => Some(Restored::new(&layer.features, cell)),
        _ => None,
    };
    let mut report = CleanReport::new(&map, &cleaned);
    let mut features = outlined(&layer.features, &map, &cleaned, restored.as_ref(), &mut report)?;
    report.left = left(&features, options)?;
    if restored.is_some() && report.left.is_some_and(|left| !left.is_plane) {
        features = outlined(&layer.features, &map, &cleaned, None, &mut report)?;
        report.left = left(&features, options)?;
    }
    layer.features = features;
    if !report.features.is_empty() {
        rebuild::update_box_of_layer(layer);
    }
    Ok(report)
}

/// The features with their outlines, and in the report what changed.
fn outlined(
    features: &[Feature],
    map: &PlanarMap,
    cleaned: &Cleaned,
    restored: Option<&Restored>,
    report: &mut CleanReport,
) -> Result<Vec<Feature>, CleanError> {
    let cell = map.noding().map(|noding| noding.cell).filter(|cell| *cell > 0.0);
    let mut further = Further::new(features, cell);
    report.features.clear();
    report.polygons = 0;
    let mut all = features.to_vec();
    for (number, (feature, faces)) in all.iter_mut().zip(&cleaned.faces).enumerate() {
        let Some(geometry) = &feature.geometry else { continue };
        let before = polygons_of(geometry);
        if before.is_empty() {
            continue;
        }
        report.polygons += 1;
        let mut after = contour::of_faces(map, faces.iter().copied())?.polygons;
        if let Some(restored) = restored {
            after.iter_mut().for_each(|polygon| restored.polygon(polygon));
        }
        if !is_same(&before, &after) {
            report.features.push(feature_change(number, &before, &after));
            feature.geometry = replace(geometry, &after, &mut further);
            rebuild::update_box(feature);
        }
    }
    Ok(all)
}

/// The map of all polygons, cut where they meet.
fn build(features: &[Feature], snap: Option<Snap>) -> Result<PlanarMap, CleanError> {
    let mut builder = Builder::new();
    let mut any = false;
    for feature in features {
        let shapes = shapes(feature);
        any |= !shapes.is_empty();
        builder.feature(&map::Feature { name: feature.name(), id: None, shapes })?;
    }
    if !any {
        return Err(CleanError::NoPolygons);
    }
    if let Some(snap) = snap {
        return Ok(builder.build_with(Noding::Snap(snap))?);
    }
    match builder.clone().build_with(Noding::Exact) {
        Err(BuildError::Crossing { .. }) => Ok(builder.build_with(Noding::Snap(Snap::Auto))?),
        built => Ok(built?),
    }
}

/// The polygons of a feature, as the library takes them.
fn shapes(feature: &Feature) -> Vec<map::Shape> {
    let mut shapes = super::to_map(feature, &mut ReadSummary::default()).shapes;
    shapes.retain(|shape| matches!(shape, map::Shape::Polygon(_)));
    shapes
}

fn feature_change(number: usize, before: &[Vec<Vec<Point>>], after: &[Polygon]) -> FeatureChange {
    let area = |rings: &Vec<Vec<Point>>| {
        let areas = rings.iter().map(|ring| ring_area(ring.iter().copied()).abs());
        areas.enumerate().map(|(i, area)| if i == 0 { area } else { -area }).sum::<f64>()
    };
    FeatureChange {
        feature: number,
        area_before: before.iter().map(area).sum(),
        area_after: after.iter().map(Polygon::area).sum(),
        points_before: before.iter().flatten().map(Vec::len).sum(),
        points_after: after.iter().flat_map(Polygon::rings).map(<[Point]>::len).sum(),
    }
}

/// What breaks C1 … C6 afterwards, judged by the polygons that are written.
fn left(features: &[Feature], options: &CleanOptions) -> Result<Option<Left>, CleanError> {
    let mut builder = Builder::new();
    let mut left = Left::default();
    for feature in features {
        let shapes = shapes(feature);
        left.invalid += usize::from(!defects(&shapes).is_empty());
        builder.feature(&map::Feature { shapes, ..map::Feature::default() })?;
    }
    let map = builder.build()?;
    left.is_plane = map.is_plane();
    if map.is_plane() {
        let Options { gap_width, sliver_area, thinness, .. } = options.assign;
        let found = check(&map, &Limits { gap_width, sliver_area, thinness })?;
        let count = |rule| found.of(rule).count();
        left.overlaps = count(CoverageRule::Overlap);
        left.gaps = count(CoverageRule::Gap);
        left.near_misses = count(CoverageRule::NearMiss);
        left.slivers = count(CoverageRule::Sliver);
    }
    Ok((left != Left { is_plane: true, ..Left::default() }).then_some(left))
}
