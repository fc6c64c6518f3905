//! The overlay of two layers: the pieces, with the attributes of both.

use super::crs::Crs;
use super::model::unique;
use super::model::{Dimensions, Feature, Field, Geometry, Header, Layer, Line, Members, Position, Shape, Value};
use super::to_map;
use crate::io::ReadSummary;
use std::collections::HashSet;
use std::sync::Arc;
use thiserror::Error;
use twinedge_algorithm::contour::{Contour, ContourError, of_faces};
use twinedge_coverage::CoverageError;
use twinedge_coverage::layers::{Piece, pieces};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::{BuildError, Builder, Noding};

/// The pieces to keep.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Keep {
    /// Those that either layer covers.
    #[default]
    Either,
    /// Those that both layers cover.
    Both,
    /// Everything in the first layer, covered by the second or not.
    First,
    /// Those that the first layer covers and the second does not.
    FirstOnly,
}

impl Keep {
    const fn keeps(self, piece: &Piece) -> bool {
        match self {
            Self::Either => true,
            Self::Both => piece.first.is_some() && piece.second.is_some(),
            Self::First => piece.first.is_some(),
            Self::FirstOnly => piece.second.is_none(),
        }
    }
}

/// The error of [`overlay`].
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum OverlayError {
    /// The layers are in different coordinate reference systems.
    #[error("the layers are in different coordinate reference systems: {0} and {1}")]
    OtherCrs(String, String),
    /// A coordinate is not a finite number, or the edges cannot be cut on this grid.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// The coverage of the features is not defined.
    #[error(transparent)]
    Coverage(#[from] CoverageError),
    /// A piece has no outline.
    #[error(transparent)]
    Contour(#[from] ContourError),
}

/// Overlays two layers. Each feature of the result is an area that a feature of the first layer and one of the second share, or
/// that only one layer covers, with the attributes of both. If both layers have a column of the same name, the second layer's
/// column gets a number. Ids become columns `id`. Lines, points and further dimensions are left out. Without `snap`, borders that
/// cross or touch are cut on the finest grid.
///
/// O((n + k) log n + size of the pieces) for n segments that meet k times.
///
/// ```
/// use twinedge_layers::{Dimensions, Feature, Geometry, Keep, Layer, Position, Shape, Value, overlay};
///
/// let layer = |low: f64, high: f64, name: &str| {
///     let ring = [[low, low], [high, low], [high, high], [low, high], [low, low]].map(|[x, y]| Position::new(x, y));
///     let geometry = Some(Geometry::new(Dimensions::Xy, Shape::Polygon(vec![ring.into()])));
///     let attributes = vec![("name".into(), Value::Text(name.to_owned()))];
///     Layer { features: vec![Feature { geometry, attributes, ..Feature::default() }], ..Layer::default() }
/// };
/// let both = overlay(&layer(0.0, 2.0, "field"), &layer(1.0, 3.0, "zone"), Keep::Both, None)?;
/// let [piece] = &both.features[..] else { unreachable!("they have one place in common") };
/// assert_eq!(piece.get("name"), Some(&Value::Text("field".to_owned())));
/// assert_eq!(piece.get("name_1"), Some(&Value::Text("zone".to_owned())));
/// # Ok::<(), twinedge_layers::OverlayError>(())
/// ```
///
/// # Errors
/// [`OverlayError`].
pub fn overlay(first: &Layer, second: &Layer, keep: Keep, snap: Option<Snap>) -> Result<Layer, OverlayError> {
    let crs = common_crs(first, second)?;
    let mut builder = Builder::new();
    for feature in first.features.iter().chain(&second.features) {
        let mut shapes = to_map(feature, &mut ReadSummary::default()).shapes;
        shapes.retain(|shape| matches!(shape, twinedge_map::Shape::Polygon(_)));
        builder.feature(&twinedge_map::Feature { shapes, ..twinedge_map::Feature::default() })?;
    }
    let map = match snap {
        Some(snap) => builder.build_with(Noding::Snap(snap))?,
        None => match builder.build_keeping()? {
            (_, Some(kept)) => kept.build_with(Noding::Snap(Snap::Auto))?,
            (map, None) => map,
        },
    };
    let count = first.features.len();
    let mut taken = HashSet::new();
    let columns = [first, second].map(|layer| Columns::of(layer, &mut taken));
    let mut features = Vec::new();
    for piece in pieces(&map, count)?.into_iter().filter(|piece| keep.keeps(piece)) {
        let contour = of_faces(&map, piece.faces.iter().copied())?;
        let one = piece.first.and_then(|one| first.features.get(one.index()));
        let other = piece.second.and_then(|one| second.features.get(one.index() - count));
        let attributes = columns.iter().zip([one, other]).flat_map(|(columns, feature)| columns.values(feature));
        features.push(Feature {
            id: None,
            geometry: Some(Geometry::from(&contour)),
            attributes: attributes.collect(),
            members: Members::new(),
        });
    }
    let fields = columns.into_iter().flat_map(|columns| columns.fields).map(|(_, field)| field).collect();
    Ok(Layer { header: Header { crs, fields, ..Header::default() }, features })
}

/// Returns the coordinate reference system of both layers. A layer without one takes the other's.
fn common_crs(first: &Layer, second: &Layer) -> Result<Option<Crs>, OverlayError> {
    match (&first.header.crs, &second.header.crs) {
        (Some(one), Some(other)) if one.name() != other.name() => Err(OverlayError::OtherCrs(one.name(), other.name())),
        (one, other) => Ok(one.as_ref().or(other.as_ref()).cloned()),
    }
}

/// The columns of a layer, with their new names.
struct Columns {
    /// The old name, none for the ids, and the column.
    fields: Vec<(Option<Arc<str>>, Field)>,
}

impl Columns {
    fn of(layer: &Layer, taken: &mut HashSet<String>) -> Self {
        let has_ids = layer.features.iter().any(|feature| feature.id.is_some());
        let ids = Field { name: "id".into(), kind: super::FieldKind::Text, width: None, decimals: None };
        let ids = has_ids.then_some((None, ids));
        let all = ids.into_iter().chain(layer.fields().into_iter().map(|field| (Some(field.name.clone()), field)));
        let named = |(before, field): (Option<Arc<str>>, Field)| {
            let name = unique(&field.name, taken).into();
            (before, Field { name, ..field })
        };
        Self { fields: all.map(named).collect() }
    }

    /// Returns the attributes of a feature; without a feature, all are null.
    fn values(&self, feature: Option<&Feature>) -> Vec<(Arc<str>, Value)> {
        let value = |before: &Option<Arc<str>>| {
            let feature = feature?;
            match before {
                Some(column) => feature.get(column).cloned(),
                None => feature.id.as_ref().map(|id| Value::Text(id.to_string())),
            }
        };
        let of = |(before, field): &(Option<Arc<str>>, Field)| (field.name.clone(), value(before).unwrap_or_default());
        self.fields.iter().map(of).collect()
    }
}

impl From<&Contour> for Geometry {
    fn from(contour: &Contour) -> Self {
        let ring = |ring: &[Point]| -> Line { ring.iter().map(|p| Position::new(p.x, p.y)).collect() };
        let polygons = contour.polygons.iter();
        let mut all: Vec<Vec<Line>> = polygons.map(|polygon| polygon.rings().map(ring).collect()).collect();
        let shape = match all.len() {
            1 => Shape::Polygon(all.remove(0)),
            _ => Shape::MultiPolygon(all),
        };
        Self::new(Dimensions::Xy, shape)
    }
}
