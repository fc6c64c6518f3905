//! A map to build once and query often: neighbours, places, contours, overlays, pictures.

use crate::overlay::{Covered, pieces};
use crate::source::{Failure, Source, snap};
use crate::work::within;
use pyo3::exceptions::{PyIndexError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use twinedge::dcel::FaceKey;
use twinedge::validate::{Collect, Expectation};
use twinedge_algorithm::claims::faces_of;
use twinedge_algorithm::contour;
use twinedge_algorithm::contour::Contour;
use twinedge_algorithm::overlay::{Operand, overlay};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::{FeatureId, Located, PlanarMap, validate_embedding};
use twinedge_report::svg;
use twinedge_report::{Imported, Keep, MapOptions, Units, borders};

/// With details, a picture of more half-edges than this is not legible.
const LEGIBLE: usize = 1_000;

/// A planar map.
#[pyclass(frozen, name = "Map", module = "twinedge._twinedge")]
pub(crate) struct Map(Arc<Imported>);

/// Polygons, each as its rings.
pub(crate) type Polygons = Vec<Vec<Vec<[f64; 2]>>>;

/// A part of an overlay: the features that cover it in either map, and its polygons, each as its rings.
type Piece = (Vec<usize>, Vec<usize>, Polygons);

/// Two features, the length of their border, the length of the part of it on which one ends and the other begins, the
/// number of its lines, and the area that both cover.
type Border = (usize, usize, f64, f64, usize, f64);

/// Builds the map of a layer. A `cell` of 0 chooses the grid on which its segments are cut.
#[pyfunction]
pub(crate) fn build_map(py: Python<'_>, source: Source, cell: Option<f64>) -> PyResult<Map> {
    let work = move || {
        let options = MapOptions { snap: snap(cell), allow_empty: true, ..MapOptions::default() };
        let name = source.name().to_owned();
        let (input, _) = source.open()?;
        let imported = Imported::read(input, &options, Keep::default(), &mut |_| {});
        imported.map_err(|error| Failure::Value(format!("{name}: {error}")))
    };
    let built = within(py, None, work)?.ok_or_else(|| PyRuntimeError::new_err("time was up"))?;
    Ok(Map(Arc::new(built?)))
}

impl Map {
    /// Returns the map, if its edges meet at shared ends only.
    pub(crate) fn plane(&self) -> PyResult<&PlanarMap> {
        if self.0.map.is_plane() {
            return Ok(&self.0.map);
        }
        Err(PyValueError::new_err(
            "borders cross, touch or overlap, so it is not well defined what lies where: snap=\"auto\" cuts them, and audit() says where they are",
        ))
    }

    fn feature(&self, number: usize) -> PyResult<FeatureId> {
        self.0.map.feature(number).ok_or_else(|| PyIndexError::new_err(format!("there is no feature {number}")))
    }
}

fn polygons(contour: Contour) -> Polygons {
    let ring = |ring: &[Point]| ring.iter().copied().map(Into::into).collect();
    contour.polygons.iter().map(|polygon| polygon.rings().map(ring).collect()).collect()
}

pub(crate) fn of_faces(map: &PlanarMap, faces: Vec<FaceKey>) -> PyResult<Polygons> {
    let contour = contour::of_faces(map, faces).map_err(|error| PyValueError::new_err(error.to_string()))?;
    Ok(polygons(contour))
}

#[pymethods]
impl Map {
    /// Returns the number of features.
    fn __len__(&self) -> usize {
        self.0.map.features().count()
    }

    /// Returns all pairs of features with a border or an overlap.
    fn neighbours(&self, geodesic: bool) -> PyResult<Vec<Border>> {
        let map = self.plane()?;
        let units = Units::of(&self.0, geodesic).map_err(|error| PyValueError::new_err(error.to_string()))?;
        let rows = borders(map, &self.0.noted, &units).into_iter();
        Ok(rows.map(|row| (row.number, row.other_number, row.length, row.shared, row.lines, row.overlap)).collect())
    }

    /// Returns, for each point, the kind of record that lies there and the features that it belongs to or bounds.
    fn at(&self, py: Python<'_>, points: Vec<[f64; 2]>) -> PyResult<Vec<(&'static str, Vec<usize>)>> {
        let map = self.plane()?;
        py.detach(|| {
            let failed = |error: &dyn std::fmt::Display| PyValueError::new_err(error.to_string());
            let place = |located: Located| {
                let mut features = BTreeSet::new();
                let kind = match located {
                    Located::Face(face) => {
                        features.extend(map.features_of(face).into_iter().flatten());
                        "face"
                    }
                    Located::Edge(edge) => {
                        features.extend(map.features_along(edge).into_iter().flatten());
                        "edge"
                    }
                    Located::Vertex(vertex) => {
                        let around = map.dcel().vertex(vertex).into_iter().flat_map(|v| v.rotation());
                        for h in around {
                            features.extend(map.features_of(h.face().key()).into_iter().flatten());
                            features.extend(map.features_along(h.key()).into_iter().flatten());
                        }
                        "vertex"
                    }
                };
                (kind, features.into_iter().map(FeatureId::index).collect())
            };
            let found = points.into_iter().map(|p| map.locate(Point::from(p)));
            found.map(|one| one.map(place).map_err(|error| failed(&error))).collect()
        })
    }

    /// Returns the outline of the union of some features: polygons, each as its rings.
    fn contour(&self, numbers: Vec<usize>) -> PyResult<Polygons> {
        let map = self.plane()?;
        let mut faces = BTreeSet::new();
        for number in numbers {
            faces.extend(faces_of(map, self.feature(number)?));
        }
        of_faces(map, faces.into_iter().collect())
    }

    /// Returns the parts of the plane made by the features of two maps, each with the features that cover it. A `cell`
    /// of 0 chooses the grid.
    fn overlay(&self, py: Python<'_>, other: &Self, cell: f64) -> PyResult<Vec<Piece>> {
        let (left, right) = (self.plane()?, other.plane()?);
        let counts = [left, right].map(|map| map.features().count());
        py.detach(|| {
            let snap = snap(Some(cell)).unwrap_or(Snap::Auto);
            let both = overlay(left, right, snap).map_err(|error| PyValueError::new_err(error.to_string()))?;
            let mut owners: BTreeMap<FeatureId, (usize, usize)> = BTreeMap::new();
            for (layer, operand, map) in [(0, Operand::Left, left), (1, Operand::Right, right)] {
                for feature in map.features().take(counts[layer]) {
                    if let Some(of_both) = both.feature_of(operand, feature) {
                        owners.insert(of_both, (layer, feature.index()));
                    }
                }
            }
            let map = both.map();
            let parts = pieces(map, |feature| owners.get(&feature).copied());
            let piece = |([left, right], faces): (Covered, Vec<FaceKey>)| {
                Ok((left.into_iter().collect(), right.into_iter().collect(), of_faces(map, faces)?))
            };
            parts.into_iter().map(piece).collect()
        })
    }

    /// Returns the picture as SVG, with broken rules in red.
    fn svg(&self, size: f64, detail: bool, window: Option<[f64; 4]>, whole: bool, list: usize) -> PyResult<String> {
        let map = &self.0.map;
        let window = window.map(|[x0, y0, x1, y1]| [Point::new(x0, y0), Point::new(x1, y1)]);
        let half_edges = svg::half_edges_in(map, window);
        if detail && half_edges > LEGIBLE {
            return Err(PyValueError::new_err(format!(
                "detail: {half_edges} half-edges are too many, it is legible up to {LEGIBLE}: choose a part by window="
            )));
        }
        let report = validate_embedding(map, &Expectation::plane(), Collect::AtMost(list));
        let violations = report.violations();
        Ok(svg::draw(map, &svg::Options { size, detail, window, insets: !whole, violations }))
    }
}
