//! A feature of GeoJSON, parsed into the types of a layer at once.
//!
//! Whatever is not in its usual form is an error here: the reader of [`io::geojson`](crate::io::geojson) decides about it then.

use super::json::{self, Names};
use super::model::{Feature, Geometry, Id, Line, Members, Position, Shape, Value, json_number};
use crate::io::MAX_NESTED_COLLECTIONS;
use rustc_hash::FxHashSet;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_json::Value as Json;
use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

/// A feature as it is written.
#[derive(serde::Deserialize)]
pub(super) struct FeatureText<'t> {
    #[serde(rename = "type")]
    _type: FeatureType,
    /// A collection is not read as a whole.
    #[serde(rename = "features", default)]
    _features: Refused,
    bbox: Option<Vec<f64>>,
    geometry: Option<GeometryText>,
    #[serde(default)]
    id: Option<Id>,
    #[serde(borrow)]
    properties: Option<Properties<'t>>,
    #[serde(flatten)]
    members: Members,
}

#[derive(serde::Deserialize)]
enum FeatureType {
    Feature,
}

#[derive(Default)]
struct Refused;

impl<'de> Deserialize<'de> for Refused {
    fn deserialize<D: Deserializer<'de>>(_: D) -> Result<Self, D::Error> {
        Err(D::Error::custom("refused"))
    }
}

#[derive(serde::Deserialize)]
struct GeometryText {
    #[serde(rename = "type")]
    kind: Kind,
    #[serde(default)]
    coordinates: Option<Coordinates>,
    #[serde(default)]
    geometries: Option<Vec<Self>>,
    bbox: Option<Vec<f64>>,
    #[serde(flatten)]
    members: Members,
}

#[derive(serde::Deserialize)]
enum Kind {
    Point,
    MultiPoint,
    LineString,
    MultiLineString,
    Polygon,
    MultiPolygon,
    GeometryCollection,
}

/// Coordinates by their depth, which the first elements show. An empty array counts as a line.
enum Coordinates {
    Position(Position),
    Line(Line),
    Lines(Vec<Line>),
    Polygons(Vec<Vec<Line>>),
}

/// The first element of an array of coordinates.
enum First {
    Number(f64),
    Array(Coordinates),
}

impl<'de> Deserialize<'de> for Coordinates {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match First::deserialize(deserializer)? {
            First::Array(coordinates) => Ok(coordinates),
            First::Number(_) => Err(D::Error::custom("a number")),
        }
    }
}

impl<'de> Deserialize<'de> for First {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct FirstVisitor;
        impl<'de> Visitor<'de> for FirstVisitor {
            type Value = First;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number or an array")
            }

            fn visit_f64<E>(self, number: f64) -> Result<First, E> {
                Ok(First::Number(number))
            }

            fn visit_i64<E>(self, number: i64) -> Result<First, E> {
                Ok(First::Number(number as f64))
            }

            fn visit_u64<E>(self, number: u64) -> Result<First, E> {
                Ok(First::Number(number as f64))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<First, A::Error> {
                Ok(First::Array(match array.next_element()? {
                    None => Coordinates::Line(Line::new()),
                    Some(First::Number(x)) => Coordinates::Position(json::position(x, array)?),
                    Some(First::Array(Coordinates::Position(first))) => Coordinates::Line(all(first, array)?),
                    Some(First::Array(Coordinates::Line(first))) => Coordinates::Lines(all(first, array)?),
                    Some(First::Array(Coordinates::Lines(first))) => Coordinates::Polygons(all(first, array)?),
                    Some(First::Array(Coordinates::Polygons(_))) => return Err(A::Error::custom("too deep")),
                }))
            }
        }
        deserializer.deserialize_any(FirstVisitor)
    }
}

/// Returns all elements of an array whose first one is known.
fn all<'de, T: Deserialize<'de>, A: SeqAccess<'de>>(first: T, mut array: A) -> Result<Vec<T>, A::Error> {
    let mut all = vec![first];
    while let Some(next) = array.next_element()? {
        all.push(next);
    }
    Ok(all)
}

struct Properties<'t>(Vec<(Cow<'t, str>, Value)>);

impl<'de: 't, 't> Deserialize<'de> for Properties<'t> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct PropertiesVisitor;
        impl<'de> Visitor<'de> for PropertiesVisitor {
            type Value = Properties<'de>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Properties<'de>, A::Error> {
                let mut all = Vec::new();
                while let Some((Name(name), value)) = object.next_entry()? {
                    all.push((name, value));
                }
                Ok(Properties(all))
            }
        }
        deserializer.deserialize_map(PropertiesVisitor)
    }
}

/// A name, borrowed from the text if it has no escapes.
#[derive(serde::Deserialize)]
#[serde(transparent)]
struct Name<'t>(#[serde(borrow)] Cow<'t, str>);

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ValueVisitor;
        impl<'de> Visitor<'de> for ValueVisitor {
            type Value = Value;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a value of JSON")
            }

            fn visit_unit<E>(self) -> Result<Value, E> {
                Ok(Value::Null)
            }

            fn visit_bool<E>(self, value: bool) -> Result<Value, E> {
                Ok(Value::Bool(value))
            }

            fn visit_i64<E>(self, value: i64) -> Result<Value, E> {
                Ok(Value::Integer(value))
            }

            fn visit_u64<E>(self, value: u64) -> Result<Value, E> {
                Ok(Value::of_json(value.into()))
            }

            fn visit_f64<E>(self, value: f64) -> Result<Value, E> {
                Ok(Value::Real(value))
            }

            fn visit_str<E>(self, text: &str) -> Result<Value, E> {
                Ok(Value::Text(text.to_owned()))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, array: A) -> Result<Value, A::Error> {
                Json::deserialize(SeqAccessDeserializer::new(array)).map(Value::Json)
            }

            fn visit_map<A: MapAccess<'de>>(self, object: A) -> Result<Value, A::Error> {
                Json::deserialize(MapAccessDeserializer::new(object)).map(Value::Json)
            }
        }
        deserializer.deserialize_any(ValueVisitor)
    }
}

impl<'de> Deserialize<'de> for Id {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct IdVisitor;
        impl Visitor<'_> for IdVisitor {
            type Value = Id;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a text or a number")
            }

            fn visit_i64<E>(self, number: i64) -> Result<Id, E> {
                Ok(Id::Number(number.into()))
            }

            fn visit_u64<E>(self, number: u64) -> Result<Id, E> {
                Ok(Id::Number(number.into()))
            }

            fn visit_f64<E: Error>(self, number: f64) -> Result<Id, E> {
                serde_json::Number::from_f64(number).map(Id::Number).ok_or_else(|| E::custom("not finite"))
            }

            fn visit_str<E>(self, text: &str) -> Result<Id, E> {
                Ok(Id::Text(text.to_owned()))
            }
        }
        deserializer.deserialize_any(IdVisitor)
    }
}

/// The columns of features, which are mostly those of the feature before.
#[derive(Debug, Default)]
pub(super) struct Rows {
    pub(super) names: Names,
    last: Vec<Arc<str>>,
}

impl Rows {
    /// Shares the names of a row; `None` if a name is repeated.
    fn shared(&mut self, row: Vec<(Cow<'_, str>, Value)>) -> Option<Vec<(Arc<str>, Value)>> {
        let is_like_last = row.len() == self.last.len() && row.iter().zip(&self.last).all(|((a, _), b)| **a == **b);
        if !is_like_last {
            self.last = row.iter().map(|(name, _)| self.names.get(name)).collect();
            let distinct: FxHashSet<&str> = self.last.iter().map(|name| &**name).collect();
            if distinct.len() < self.last.len() {
                self.last.clear();
                return None;
            }
        }
        Some(self.last.iter().cloned().zip(row.into_iter().map(|(_, value)| value)).collect())
    }
}

/// The greatest depth of other values: the other reader counts what is around a feature as well.
const DEEPEST: usize = 40;

/// Returns true if a value is nested no deeper than this.
fn is_flat(value: &Json, depth: usize) -> bool {
    match value {
        Json::Array(all) => depth > 0 && all.iter().all(|one| is_flat(one, depth - 1)),
        Json::Object(all) => depth > 0 && all.values().all(|one| is_flat(one, depth - 1)),
        _ => true,
    }
}

fn are_flat(members: &Members) -> bool {
    members.values().all(|value| is_flat(value, DEEPEST))
}

impl FeatureText<'_> {
    /// Returns the feature, unless something is not in its usual form.
    pub(super) fn feature(self, rows: &mut Rows) -> Option<Feature> {
        let properties = self.properties.map(|properties| properties.0).unwrap_or_default();
        let is_flat = |value: &Value| if let Value::Json(value) = value { is_flat(value, DEEPEST) } else { true };
        if !are_flat(&self.members) || !properties.iter().all(|(_, value)| is_flat(value)) {
            return None;
        }
        let geometry = match self.geometry {
            Some(geometry) => Some(geometry.geometry(0)?),
            None => None,
        };
        let attributes = rows.shared(properties)?;
        Some(Feature { id: self.id, geometry, attributes, members: with_box(self.bbox, self.members) })
    }
}

impl GeometryText {
    fn geometry(self, depth: usize) -> Option<Geometry> {
        let empty = |line: &Line| line.is_empty();
        let shape = match (self.kind, self.coordinates, self.geometries) {
            (Kind::Point, Some(Coordinates::Position(position)), None) => Shape::Point(Some(position)),
            (Kind::MultiPoint, Some(Coordinates::Line(points)), None) => {
                Shape::MultiPoint(points.into_iter().map(Some).collect())
            }
            (Kind::LineString, Some(Coordinates::Line(line)), None) => Shape::Line(line),
            (Kind::MultiLineString, Some(Coordinates::Lines(lines)), None) => Shape::MultiLine(lines),
            (Kind::MultiLineString, Some(Coordinates::Line(line)), None) if empty(&line) => {
                Shape::MultiLine(Vec::new())
            }
            (Kind::Polygon, Some(Coordinates::Lines(rings)), None) => Shape::Polygon(rings),
            (Kind::Polygon, Some(Coordinates::Line(line)), None) if empty(&line) => Shape::Polygon(Vec::new()),
            (Kind::MultiPolygon, Some(Coordinates::Polygons(polygons)), None) => Shape::MultiPolygon(polygons),
            (Kind::MultiPolygon, Some(Coordinates::Line(line)), None) if empty(&line) => {
                Shape::MultiPolygon(Vec::new())
            }
            (Kind::GeometryCollection, None, Some(geometries)) if depth < MAX_NESTED_COLLECTIONS => {
                Shape::Collection(geometries.into_iter().map(|one| one.geometry(depth + 1)).collect::<Option<_>>()?)
            }
            _ => return None,
        };
        if !are_flat(&self.members) {
            return None;
        }
        Some(json::geometry(shape, with_box(self.bbox, self.members)))
    }
}

/// Returns foreign members, preceded by the box.
pub(super) fn with_box(bbox: Option<Vec<f64>>, members: Members) -> Members {
    match bbox {
        None => members,
        Some(bbox) => {
            let bbox = ("bbox".to_owned(), bbox.into_iter().map(json_number).collect());
            [bbox].into_iter().chain(members).collect()
        }
    }
}
