//! Layers: features with geometries and attributes, and further data of a file.

use super::crs::Crs;
use std::collections::HashSet;
use std::sync::Arc;

/// A position: x, y, and the further dimensions of the file. With the feature `geojson` or `topojson` it is deserialized from an array
/// of two numbers or more.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Position {
    /// The first coordinate.
    pub x: f64,
    /// The second coordinate.
    pub y: f64,
    /// The other coordinates, described by [`Geometry::dimensions`]. GeoJSON may have any number of them.
    pub more: Box<[f64]>,
}

impl Position {
    /// Creates a position with two dimensions.
    #[must_use]
    pub fn new(x: f64, y: f64) -> Self {
        Self { x, y, more: Box::default() }
    }
}

/// The meaning of the numbers of a geometry's positions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Dimensions {
    /// x and y, and in GeoJSON any further numbers, usually z.
    #[default]
    Xy,
    /// x, y and height.
    Xyz,
    /// x, y and a measure.
    Xym,
    /// x, y, height and a measure.
    Xyzm,
}

impl Dimensions {
    /// Returns the number of coordinates after x and y; [`Xy`](Self::Xy) may have others.
    #[must_use]
    pub const fn more(self) -> usize {
        match self {
            Self::Xy => 0,
            Self::Xyz | Self::Xym => 1,
            Self::Xyzm => 2,
        }
    }

    /// Returns the dimensions with a height, a measure, or both.
    #[must_use]
    pub const fn with(height: bool, measure: bool) -> Self {
        match (height, measure) {
            (false, false) => Self::Xy,
            (true, false) => Self::Xyz,
            (false, true) => Self::Xym,
            (true, true) => Self::Xyzm,
        }
    }
}

/// A geometry.
#[derive(Clone, Debug, PartialEq)]
pub struct Geometry {
    /// The meaning of the positions' numbers.
    pub dimensions: Dimensions,
    /// The positions.
    pub shape: Shape,
    /// Further members of its object in GeoJSON, including `bbox`. In TopoJSON, a feature has the members of its outermost
    /// geometry.
    pub members: Members,
}

impl Geometry {
    /// Creates a geometry without further members.
    #[must_use]
    pub fn new(dimensions: Dimensions, shape: Shape) -> Self {
        Self { dimensions, shape, members: Members::new() }
    }
}

/// A chain of positions. A ring is closed if its last position repeats the first.
pub type Line = Vec<Position>;

/// The positions of a geometry. Shapes are neither repaired nor refused: rings may be open, wind either way, or be empty.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Shape {
    /// A point; `None` for an empty one.
    Point(Option<Position>),
    /// Points; `None` for an empty one.
    MultiPoint(Vec<Option<Position>>),
    /// A line.
    Line(Line),
    /// Lines.
    MultiLine(Vec<Line>),
    /// A polygon: the outer ring followed by the holes.
    Polygon(Vec<Line>),
    /// Polygons.
    MultiPolygon(Vec<Vec<Line>>),
    /// Geometries of any kind.
    Collection(Vec<Geometry>),
}

impl Shape {
    /// Returns the OGC name of its kind.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Point(_) => "Point",
            Self::MultiPoint(_) => "MultiPoint",
            Self::Line(_) => "LineString",
            Self::MultiLine(_) => "MultiLineString",
            Self::Polygon(_) => "Polygon",
            Self::MultiPolygon(_) => "MultiPolygon",
            Self::Collection(_) => "GeometryCollection",
        }
    }

    /// Returns true if it has no positions.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let mut any = false;
        self.visit(&mut |_| any = true);
        !any
    }

    /// Calls `each` for all positions, in order. The recursion is as deep as collections are nested.
    pub fn visit<'a>(&'a self, each: &mut dyn FnMut(&'a Position)) {
        match self {
            Self::Point(point) => point.iter().for_each(each),
            Self::MultiPoint(points) => points.iter().flatten().for_each(each),
            Self::Line(points) => points.iter().for_each(each),
            Self::MultiLine(lines) | Self::Polygon(lines) => lines.iter().flatten().for_each(each),
            Self::MultiPolygon(polygons) => polygons.iter().flatten().flatten().for_each(each),
            Self::Collection(geometries) => geometries.iter().for_each(|geometry| geometry.shape.visit(each)),
        }
    }
}

/// The value of an attribute. With the feature `geojson` it is deserialized from a value of JSON.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum Value {
    /// No value.
    #[default]
    Null,
    /// A boolean.
    Bool(bool),
    /// An integer.
    Integer(i64),
    /// Another number.
    Real(f64),
    /// A text.
    Text(String),
    /// A day, as `2026-01-31`.
    Date(String),
    /// A day and a time, as in the file, usually `2026-01-31T12:00:00Z`.
    DateTime(String),
    /// Bytes.
    Bytes(Vec<u8>),
    /// A list or an object, or an integer beyond signed 64 bits.
    Json(serde_json::Value),
}

impl Value {
    /// Returns the value as text: a string as it is, a number or a boolean in JSON notation, a list or an object as JSON, bytes
    /// in hexadecimal digits; `None` for null.
    #[must_use]
    pub fn text(&self) -> Option<String> {
        Some(match self {
            Self::Null => return None,
            Self::Text(text) | Self::Date(text) | Self::DateTime(text) => text.clone(),
            other => match other.to_json() {
                serde_json::Value::String(text) => text,
                json => json.to_string(),
            },
        })
    }

    /// Converts the value to JSON. Bytes become hexadecimal digits, and non-finite numbers become null.
    #[must_use]
    pub fn to_json(&self) -> serde_json::Value {
        match self {
            Self::Null => serde_json::Value::Null,
            Self::Bool(value) => (*value).into(),
            Self::Integer(value) => (*value).into(),
            Self::Real(value) => (*value).into(),
            Self::Text(text) | Self::Date(text) | Self::DateTime(text) => text.as_str().into(),
            Self::Bytes(bytes) => hex(bytes).into(),
            Self::Json(json) => json.clone(),
        }
    }

    /// Creates a value from JSON.
    #[must_use]
    pub fn of_json(json: serde_json::Value) -> Self {
        use serde_json::Value as Json;
        match json {
            Json::Null => Self::Null,
            Json::Bool(value) => Self::Bool(value),
            Json::String(text) => Self::Text(text),
            Json::Number(number) => match (number.as_i64(), number.is_f64(), number.as_f64()) {
                (Some(value), ..) => Self::Integer(value),
                (None, true, Some(value)) => Self::Real(value),
                _ => Self::Json(Json::Number(number)),
            },
            Json::Array(_) | Json::Object(_) => Self::Json(json),
        }
    }
}

/// Converts a 64-bit number to JSON: integers without a point.
pub(super) fn json_number(number: f64) -> serde_json::Value {
    const EXACT: f64 = 1e15;
    let is_whole = number.abs() < EXACT && number.fract() == 0.0 && !(number == 0.0 && number.is_sign_negative());
    if is_whole { (number as i64).into() } else { number.into() }
}

pub(super) fn hex(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 16] = b"0123456789ABCDEF";
    let digit = |half: u8| char::from(DIGITS[usize::from(half & 15)]);
    bytes.iter().flat_map(|byte| [digit(byte >> 4), digit(*byte)]).collect()
}

/// The id of a feature. With the feature `geojson` it is deserialized from a text or a number.
#[derive(Clone, Debug, PartialEq)]
pub enum Id {
    /// A text.
    Text(String),
    /// A number, as in JSON.
    Number(serde_json::Number),
}

impl std::fmt::Display for Id {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Text(text) => f.write_str(text),
            Self::Number(number) => number.fmt(f),
        }
    }
}

/// Foreign members of an object, in order.
pub type Members = serde_json::Map<String, serde_json::Value>;

/// A feature.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Feature {
    /// The id.
    pub id: Option<Id>,
    /// The geometry.
    pub geometry: Option<Geometry>,
    /// The attributes by name of column, in order.
    pub attributes: Vec<(Arc<str>, Value)>,
    /// Further members of its object in GeoJSON, including `bbox`.
    pub members: Members,
}

impl Feature {
    /// Returns the value in a column. O(columns).
    #[must_use]
    pub fn get(&self, column: &str) -> Option<&Value> {
        self.attributes.iter().find(|(name, _)| **name == *column).map(|(_, value)| value)
    }

    /// Returns the name: the first text or number among the usual columns (`crate::io::geojson::NAME_COLUMNS`).
    #[must_use]
    pub fn name(&self) -> Option<String> {
        let label = |value: &Value| match value {
            Value::Text(text) => Some(text.clone()),
            Value::Integer(_) | Value::Real(_) => value.text(),
            _ => None,
        };
        crate::io::geojson::NAME_COLUMNS.iter().find_map(|column| self.get(column).and_then(label))
    }
}

/// The type of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum FieldKind {
    /// Booleans.
    Bool,
    /// Integers.
    Integer,
    /// Numbers.
    Real,
    /// Texts.
    Text,
    /// Days.
    Date,
    /// Days with times.
    DateTime,
    /// Bytes.
    Bytes,
    /// Lists and objects.
    Json,
}

/// A column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// The name.
    pub name: Arc<str>,
    /// The type.
    pub kind: FieldKind,
    /// The greatest number of characters, if the file states one.
    pub width: Option<usize>,
    /// The number of digits after the point, if the file states one.
    pub decimals: Option<usize>,
}

/// The members of a file other than the features.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Header {
    /// The name of the layer.
    pub name: Option<String>,
    /// The coordinate reference system.
    pub crs: Option<Crs>,
    /// The columns in order, if the format lists them.
    pub fields: Vec<Field>,
    /// Further members of the outermost object of GeoJSON.
    pub members: Members,
    /// The character set of the texts, if the format leaves it open.
    pub charset: Option<String>,
}

impl Header {
    /// Returns the shape of edges, if the file declares that they are not straight in the plane of the coordinates: `spherical`
    /// in `GeoParquet`, or an algorithm of Parquet's own type `GEOGRAPHY`.
    #[must_use]
    pub fn edges(&self) -> Option<&str> {
        let edges = self.members.get(EDGES).and_then(serde_json::Value::as_str);
        edges.filter(|edges| ["spherical", "vincenty", "thomas", "andoyer", "karney"].contains(edges))
    }
}

/// The member of a header that states that edges are not straight in the plane of the coordinates, in the terms of `GeoParquet`.
pub(super) const EDGES: &str = "edges";

/// Features, with the further data of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layer {
    /// The members other than the features.
    pub header: Header,
    /// The features in order.
    pub features: Vec<Feature>,
}

/// The layer already has a column of this name.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is a column {0} already")]
pub struct ColumnTaken(pub String);

impl Layer {
    /// Moves the ids of features to a column of this name, placed first in each feature with an id. O(attributes).
    ///
    /// ```
    /// use twinedge_layers::{Feature, Format, Id, Layer, Value, losses};
    ///
    /// let feature = Feature { id: Some(Id::Text("A-1".into())), ..Feature::default() };
    /// let mut layer = Layer { features: vec![feature], ..Layer::default() };
    /// layer.move_ids("parcel")?;
    /// assert_eq!(layer.features[0].get("parcel"), Some(&Value::Text("A-1".into())));
    /// assert!(losses(&layer, Format::Shapefile).is_empty());
    /// # Ok::<_, twinedge_layers::ColumnTaken>(())
    /// ```
    ///
    /// # Errors
    /// [`ColumnTaken`], if there is such a column.
    pub fn move_ids(&mut self, column: &str) -> Result<(), ColumnTaken> {
        if self.fields().iter().any(|field| *field.name == *column) {
            return Err(ColumnTaken(column.to_owned()));
        }
        let name: Arc<str> = column.into();
        for feature in &mut self.features {
            if let Some(id) = feature.id.take() {
                let value = match id {
                    Id::Text(text) => Value::Text(text),
                    Id::Number(number) => Value::of_json(number.into()),
                };
                feature.attributes.insert(0, (name.clone(), value));
            }
        }
        Ok(())
    }

    /// Returns the columns: those of the header, followed by further columns of features, in order. The type of a column outside
    /// the header is the type of its values, or text if they differ; integers and other numbers together are numbers. Expected
    /// O(attributes).
    #[must_use]
    pub fn fields(&self) -> Vec<Field> {
        let mut fields = self.header.fields.clone();
        let known = fields.len();
        let mut places: rustc_hash::FxHashMap<Arc<str>, usize> =
            fields.iter().map(|field| field.name.clone()).zip(0..).collect();
        let mut kinds: Vec<Option<FieldKind>> = vec![None; known];
        for (name, value) in self.features.iter().flat_map(|feature| &feature.attributes) {
            let place = *places.entry(name.clone()).or_insert_with(|| {
                fields.push(Field { name: name.clone(), kind: FieldKind::Text, width: None, decimals: None });
                kinds.push(None);
                fields.len() - 1
            });
            let kind = kind_of(value);
            kinds[place] = match (kinds[place], kind) {
                (None, kind) | (kind, None) => kind,
                (Some(a), Some(b)) if a == b => Some(a),
                (Some(FieldKind::Integer | FieldKind::Real), Some(FieldKind::Integer | FieldKind::Real)) => {
                    Some(FieldKind::Real)
                }
                _ => Some(FieldKind::Text),
            };
        }
        for (field, kind) in fields.iter_mut().zip(kinds).skip(known) {
            field.kind = kind.unwrap_or(FieldKind::Text);
        }
        fields
    }
}

/// Returns the type of a value; `None` for null.
pub(super) fn kind_of(value: &Value) -> Option<FieldKind> {
    Some(match value {
        Value::Null => return None,
        Value::Bool(_) => FieldKind::Bool,
        Value::Integer(_) => FieldKind::Integer,
        Value::Real(_) => FieldKind::Real,
        Value::Text(_) => FieldKind::Text,
        Value::Date(_) => FieldKind::Date,
        Value::DateTime(_) => FieldKind::DateTime,
        Value::Bytes(_) => FieldKind::Bytes,
        Value::Json(_) => FieldKind::Json,
    })
}

/// Returns a name that no other column has, ignoring case.
pub(super) fn unique(name: &str, taken: &mut HashSet<String>) -> String {
    let mut free = if name.is_empty() { "field".to_owned() } else { name.to_owned() };
    for number in 1.. {
        if taken.insert(free.to_lowercase()) {
            break;
        }
        free = format!("{name}_{number}");
    }
    free
}
