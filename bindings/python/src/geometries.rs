//! Geometries of Arrow: well-known binary, or the coordinates and offsets of `GeoArrow`, read in place.

use crate::source::Failure;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use std::ops::Range;
use twinedge_geometry::Point;
use twinedge_layers::io::ReadSummary;
use twinedge_layers::{Feature as LayerFeature, geometry_of_wkb, to_map};
use twinedge_map::{Feature, Shape};

/// A column of geometries.
#[derive(FromPyObject)]
pub(crate) enum Column<'py> {
    Native(Native<'py>),
    Binary(Binary<'py>),
}

/// A column of binary values, such as well-known binary.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Binary<'py> {
    data: PyReadonlyArray1<'py, u8>,
    /// The ends of values, after the start of the first.
    ends: PyReadonlyArray1<'py, i64>,
    missing: Option<PyReadonlyArray1<'py, bool>>,
}

/// A column of `GeoArrow`.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Native<'py> {
    /// The type, such as `multipolygon`.
    kind: String,
    /// The offsets of each level, the outermost one first.
    offsets: Vec<Offsets<'py>>,
    x: PyReadonlyArray1<'py, f64>,
    y: PyReadonlyArray1<'py, f64>,
    /// The number of geometries.
    length: usize,
    /// True for geometries that are missing.
    missing: Option<PyReadonlyArray1<'py, bool>>,
}

#[derive(FromPyObject)]
enum Offsets<'py> {
    Narrow(PyReadonlyArray1<'py, i32>),
    Wide(PyReadonlyArray1<'py, i64>),
}

/// A column that no longer needs Python.
pub(crate) enum Given<'c> {
    Features(Vec<Row>),
    Binary(Values<'c>),
}

/// The values of a binary column, in place.
pub(crate) struct Values<'c> {
    data: &'c [u8],
    ends: &'c [i64],
    missing: Option<&'c [bool]>,
}

impl<'c> Values<'c> {
    /// Returns each value, or nothing where it is missing.
    ///
    /// # Errors
    /// The place of a value whose offsets are out of order.
    pub(crate) fn each(&self) -> impl Iterator<Item = Result<Option<&'c [u8]>, Failure>> + '_ {
        self.ends.windows(2).enumerate().map(|(place, ends)| {
            if self.missing.is_some_and(|missing| missing.get(place) == Some(&true)) {
                return Ok(None);
            }
            let at = |end: i64| usize::try_from(end).ok();
            let value = at(ends[0]).zip(at(ends[1])).and_then(|(from, to)| self.data.get(from..to));
            value.map(Some).ok_or_else(|| Failure::Value(format!("value {place}: its offsets are out of order")))
        })
    }
}

impl Binary<'_> {
    pub(crate) fn values(&self) -> Result<Values<'_>, Failure> {
        let missing = self.missing.as_ref().map(PyReadonlyArray1::as_slice).transpose();
        let found = self.data.as_slice().and_then(|data| Ok((data, self.ends.as_slice()?, missing?)));
        let (data, ends, missing) = found.map_err(Failure::value)?;
        Ok(Values { data, ends, missing })
    }
}

/// A feature, or why its geometry cannot be read.
pub(crate) type Row = Result<Feature, String>;

/// Takes columns, one after the other. Reads columns of `GeoArrow`.
pub(crate) fn given<'c>(columns: &'c [Column<'_>]) -> Result<Vec<Given<'c>>, Failure> {
    let of_column = |column: &'c Column<'_>| match column {
        Column::Binary(binary) => binary.values().map(Given::Binary),
        Column::Native(native) => native.features().map(Given::Features),
    };
    columns.iter().map(of_column).collect()
}

/// Returns the features of all columns. Reads well-known binary.
pub(crate) fn rows(given: Vec<Given<'_>>) -> Result<Vec<Row>, Failure> {
    let mut rows = Vec::new();
    for column in given {
        match column {
            Given::Binary(values) => {
                for geometry in values.each() {
                    rows.push(feature(geometry?));
                }
            }
            Given::Features(mut found) => rows.append(&mut found),
        }
    }
    Ok(rows)
}

/// Returns the features of all columns. All must be readable.
pub(crate) fn features(given: Vec<Given<'_>>) -> Result<Vec<Feature>, Failure> {
    let feature = |(place, row): (usize, Row)| row.map_err(|why| Failure::Value(format!("geometry {place}: {why}")));
    rows(given)?.into_iter().enumerate().map(feature).collect()
}

fn feature(geometry: Option<&[u8]>) -> Row {
    let geometry = geometry.map(geometry_of_wkb).transpose().map_err(|error| error.to_string())?;
    Ok(to_map(&LayerFeature { geometry, ..LayerFeature::default() }, &mut ReadSummary::default()))
}

impl Offsets<'_> {
    /// Returns the positions below a position, if they are in order.
    fn below(&self, place: usize) -> Option<Range<usize>> {
        let at = |place: usize| match self {
            Self::Narrow(offsets) => offsets.as_array().get(place).and_then(|offset| usize::try_from(*offset).ok()),
            Self::Wide(offsets) => offsets.as_array().get(place).and_then(|offset| usize::try_from(*offset).ok()),
        };
        Some(at(place)?..at(place + 1)?).filter(|range| range.start <= range.end)
    }
}

impl Native<'_> {
    fn features(&self) -> Result<Vec<Row>, Failure> {
        let depth = match self.kind.as_str() {
            "point" => 0,
            "linestring" | "multipoint" => 1,
            "polygon" | "multilinestring" => 2,
            "multipolygon" => 3,
            other => return Err(Failure::Value(format!("geometries of the type {other} are not read here"))),
        };
        let missing = self.missing.as_ref().map(PyReadonlyArray1::as_array);
        let is_missing = |place: usize| missing.is_some_and(|missing| missing.get(place).is_none_or(|one| *one));
        let feature = |place: usize| {
            if self.offsets.len() != depth {
                return None;
            }
            let shapes = if is_missing(place) { Vec::new() } else { self.shapes(place)? };
            Some(Feature { shapes, ..Feature::default() })
        };
        let wrong = || "its offsets are out of order, or a coordinate is not finite".to_owned();
        Ok((0..self.length).map(|place| feature(place).ok_or_else(wrong)).collect())
    }

    /// Returns `None` if offsets are out of order, or a coordinate is not finite.
    fn shapes(&self, place: usize) -> Option<Vec<Shape>> {
        let polygon = |place: usize| {
            let rings: Vec<Vec<Point>> =
                self.below(1, place)?.map(|ring| self.points(2, ring)).collect::<Option<_>>()?;
            Some((!rings.is_empty()).then_some(Shape::Polygon(rings)))
        };
        let line = |level: usize, place: usize| {
            let points = self.points(level, place)?;
            Some((!points.is_empty()).then_some(Shape::Line(points)))
        };
        let shapes: Vec<Option<Shape>> = match self.kind.as_str() {
            // An empty point has NaN coordinates.
            "point" if self.at(place)?.x.is_nan() => Vec::new(),
            "point" => vec![Some(Shape::Point(self.point(place)?))],
            "multipoint" => self.points(0, place)?.into_iter().map(|p| Some(Shape::Point(p))).collect(),
            "linestring" => vec![line(0, place)?],
            "multilinestring" => self.below(0, place)?.map(|one| line(1, one)).collect::<Option<_>>()?,
            "polygon" => {
                let rings: Vec<Vec<Point>> =
                    self.below(0, place)?.map(|ring| self.points(1, ring)).collect::<Option<_>>()?;
                vec![(!rings.is_empty()).then_some(Shape::Polygon(rings))]
            }
            _ => self.below(0, place)?.map(polygon).collect::<Option<_>>()?,
        };
        Some(shapes.into_iter().flatten().collect())
    }

    fn below(&self, level: usize, place: usize) -> Option<Range<usize>> {
        self.offsets.get(level)?.below(place)
    }

    fn points(&self, level: usize, place: usize) -> Option<Vec<Point>> {
        self.below(level, place)?.map(|i| self.point(i)).collect()
    }

    fn point(&self, i: usize) -> Option<Point> {
        self.at(i).filter(|p| p.x.is_finite() && p.y.is_finite())
    }

    fn at(&self, i: usize) -> Option<Point> {
        Some(Point::new(*self.x.as_array().get(i)?, *self.y.as_array().get(i)?))
    }
}
