//! An object of a file as features, their lines and rings assembled from arcs.

use super::super::crs::Crs;
use super::super::each::Each;
use super::super::error::{Cause, Place, ReadError};
use super::super::json::Names;
use super::super::json::{InDegrees, geometry};
use super::super::model::{Feature, Header, Id, Line, Members, Position, Shape, Value};
use super::document::{Document, check_finite, content};
use crate::io::MAX_NESTED_COLLECTIONS;
use serde_json::Value as Json;
use std::io::Read;

/// The limit on the total number of positions of features: `TIMES` times the positions of all arcs, plus `MORE`. A few features
/// share each arc, but a small file may name a long arc any number of times.
const TIMES: u64 = 16;
const MORE: u64 = 1 << 20;

/// Reads the object of this name, or the only one. Each part of a collection is a feature and is passed to `each`.
pub(crate) fn read(reader: &mut dyn Read, layer: Option<&str>, each: &mut Each<'_>) -> Result<Header, ReadError> {
    let mut document = Document::read(reader)?;
    let name = chosen(&document.objects, layer)?;
    let object = document.objects.remove(&name).unwrap_or_default();
    let mut header = Header { name: Some(name), members: std::mem::take(&mut document.members), ..Header::default() };
    header.crs = header.members.shift_remove("crs").map(Crs::of_member);
    let mut reading = Reading::new(&document);
    let mut names = Names::default();
    let mut in_degrees = InDegrees::default();
    let mut take = |number, object| {
        let found = reading.feature(object, &mut names).map_err(|cause| content(Place::Feature(number), cause))?;
        found.geometry.iter().for_each(|geometry| in_degrees.look_at(geometry));
        each(found)
    };
    match object {
        Json::Object(mut collection) if is_collection(&collection) => {
            let Some(Json::Array(parts)) = collection.shift_remove("geometries") else {
                return Err(content(Place::Header, Cause::Invalid("a collection without geometries".to_owned())));
            };
            for (number, part) in parts.into_iter().enumerate() {
                take(number, part)?;
            }
            // The members of the object become members of the layer.
            collection.shift_remove("type");
            for (name, value) in collection {
                header.members.entry(name).or_insert(value);
            }
        }
        single => take(0, single)?,
    }
    header.crs = header.crs.or_else(|| in_degrees.crs());
    Ok(header)
}

pub(super) fn chosen(objects: &Members, wanted: Option<&str>) -> Result<String, ReadError> {
    let name = match wanted {
        Some(name) => objects.contains_key(name).then_some(name),
        None if objects.len() == 1 => objects.keys().next().map(String::as_str),
        None => None,
    };
    name.map(str::to_owned).ok_or_else(|| ReadError::Layers {
        wanted: wanted.map(str::to_owned),
        layers: objects.keys().cloned().collect(),
    })
}

fn is_collection(object: &Members) -> bool {
    object.get("type").and_then(Json::as_str) == Some("GeometryCollection")
}

struct Reading<'a> {
    document: &'a Document,
    /// The number of positions that may still be added.
    left: u64,
    limit: u64,
}

impl<'a> Reading<'a> {
    fn new(document: &'a Document) -> Self {
        let positions: usize = document.arcs.iter().map(Vec::len).sum();
        let limit = MORE + TIMES * positions as u64;
        Self { document, left: limit, limit }
    }

    fn feature(&mut self, object: Json, names: &mut Names) -> Result<Feature, Cause> {
        let mut members = object_of(object)?;
        let id = match members.shift_remove("id") {
            None | Some(Json::Null) => None,
            Some(Json::String(text)) => Some(Id::Text(text)),
            Some(Json::Number(number)) => Some(Id::Number(number)),
            Some(_) => return Err(Cause::Invalid("an id that is neither a text nor a number".to_owned())),
        };
        let properties = match members.shift_remove("properties") {
            None | Some(Json::Null) => Members::new(),
            Some(Json::Object(properties)) => properties,
            Some(_) => return Err(Cause::Invalid("properties that are no object".to_owned())),
        };
        let shape = self.shape(&mut members, 0)?;
        Ok(Feature {
            id,
            geometry: shape.map(|shape| geometry(shape, Members::new())),
            attributes: properties.into_iter().map(|(name, value)| (names.get(&name), Value::of_json(value))).collect(),
            members,
        })
    }

    /// Returns the shape of a geometry and removes its members; none, if the type is null. The recursion follows the nesting.
    fn shape(&mut self, members: &mut Members, depth: usize) -> Result<Option<Shape>, Cause> {
        let kind = match members.shift_remove("type") {
            Some(Json::String(kind)) => kind,
            Some(Json::Null) => return Ok(None),
            _ => return Err(Cause::Invalid("a geometry without a type".to_owned())),
        };
        let content = match kind.as_str() {
            "Point" | "MultiPoint" => "coordinates",
            "LineString" | "MultiLineString" | "Polygon" | "MultiPolygon" => "arcs",
            "GeometryCollection" => "geometries",
            _ => return Err(Cause::Invalid(format!("{kind:?} is no type of geometries"))),
        };
        let given = members.shift_remove(content);
        let given = given.ok_or_else(|| Cause::Invalid(format!("a {kind} without {content}")))?;
        Ok(Some(match kind.as_str() {
            "Point" => Shape::Point(Some(self.position(&given)?)),
            "MultiPoint" => Shape::MultiPoint(list(&given, |position| self.position(position).map(Some))?),
            "LineString" => Shape::Line(self.line(&given)?),
            "MultiLineString" => Shape::MultiLine(list(&given, |line| self.line(line))?),
            "Polygon" => Shape::Polygon(list(&given, |ring| self.line(ring))?),
            "MultiPolygon" => Shape::MultiPolygon(list(&given, |rings| list(rings, |ring| self.line(ring)))?),
            _ => {
                if depth == MAX_NESTED_COLLECTIONS {
                    return Err(Cause::TooDeep);
                }
                let Json::Array(parts) = given else { return Err(no_list()) };
                let mut geometries = Vec::new();
                for part in parts {
                    let mut members = object_of(part)?;
                    // A null part is skipped.
                    if let Some(shape) = self.shape(&mut members, depth + 1)? {
                        geometries.push(geometry(shape, members));
                    }
                }
                Shape::Collection(geometries)
            }
        }))
    }

    fn position(&self, numbers: &Json) -> Result<Position, Cause> {
        let numbers: Option<Vec<f64>> =
            numbers.as_array().and_then(|numbers| numbers.iter().map(Json::as_f64).collect());
        let short = || Cause::Invalid("a position has two numbers or more".to_owned());
        let numbers = numbers.ok_or_else(short)?;
        let (&[x, y], more) = numbers.split_first_chunk().ok_or_else(short)?;
        let mut position = Position { x, y, more: more.into() };
        self.document.transform.apply(&mut position);
        check_finite(&position)?;
        Ok(position)
    }

    /// Returns a line of arcs; each arc begins at the end of the one before it.
    fn line(&mut self, indices: &Json) -> Result<Line, Cause> {
        let mut line = Line::new();
        for (place, index) in indices.as_array().ok_or_else(no_list)?.iter().enumerate() {
            let index = index.as_i64().ok_or_else(|| Cause::Invalid(format!("{index} is no index of an arc")))?;
            let arcs = &self.document.arcs;
            // The index ~i means arc i backwards.
            let number = usize::try_from(if index < 0 { !index } else { index }).unwrap_or(usize::MAX);
            let arc = arcs.get(number).ok_or(Cause::NoSuchArc { index, arcs: arcs.len() })?;
            let positions = arc.len() as u64;
            self.left = self.left.checked_sub(positions).ok_or(Cause::Expanded { limit: self.limit })?;
            let first = if index < 0 { arc.last() } else { arc.first() };
            let Some(first) = first else {
                return Err(Cause::Invalid(format!("arc {number} has no positions")));
            };
            let skipped = match line.last() {
                Some(end) if end != first => {
                    let (from, to) = ((end.x, end.y), (first.x, first.y));
                    return Err(Cause::Invalid(format!(
                        "arc {index}, number {place} of a line, begins at {to:?}, and the one before it ends at {from:?}"
                    )));
                }
                end => usize::from(end.is_some()),
            };
            if index < 0 {
                line.extend(arc.iter().rev().skip(skipped).cloned());
            } else {
                line.extend(arc.iter().skip(skipped).cloned());
            }
        }
        Ok(line)
    }
}

fn object_of(json: Json) -> Result<Members, Cause> {
    match json {
        Json::Object(members) => Ok(members),
        _ => Err(Cause::Invalid("a geometry that is no object".to_owned())),
    }
}

pub(super) fn no_list() -> Cause {
    Cause::Invalid("something else where a list should be".to_owned())
}

pub(super) fn list<T>(json: &Json, each: impl FnMut(&Json) -> Result<T, Cause>) -> Result<Vec<T>, Cause> {
    json.as_array().ok_or_else(no_list)?.iter().map(each).collect()
}
