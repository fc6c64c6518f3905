//! Reading GeoJSON ([RFC 7946](https://www.rfc-editor.org/rfc/rfc7946)), one feature at a time, and writing it.
//!
//! [`read`] takes a feature collection, a feature or a bare geometry, and hands over each feature as soon as its
//! closing brace is read. Nothing is kept but the feature at hand, so a map of any size can be read as long as its
//! largest feature fits: 32 bytes per position, up to three times that while the lists grow, and 32 more for a position
//! of three or four numbers.
//!
//! ```
//! use twinedge::io::geojson::{self, ReadError};
//!
//! let text = r#"{"type": "Feature", "properties": {"name": "Unit square"},
//!     "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}}"#;
//! let mut names = Vec::new();
//! let summary = geojson::read(text.as_bytes(), |feature| {
//!     names.extend(feature.name);
//!     Ok::<_, ReadError>(())
//! })?;
//! assert_eq!(names, ["Unit square"]);
//! assert_eq!((summary.polygons, summary.positions), (1, 5));
//! # Ok::<_, ReadError>(())
//! ```
//!
//! # What is taken, and how
//!
//! - A feature's name is its property `name`, `NAME`, `Name`, `ADMIN`, `admin`, `title` or `id`, the first of these
//!   that is a string or a number.
//! - A geometry that is null or absent gives a feature without shapes. An empty line or polygon draws nothing; an empty
//!   ring is kept.
//! - Geometry collections are flattened. They may lie inside each other [`MAX_NESTED_COLLECTIONS`] deep.
//! - What a position has beyond two numbers is dropped and counted.
//! - Members may come in any order. `bbox`, `crs` and foreign members of the outermost object are skipped, whatever
//!   they hold and however deep.
//! - Rings may be open or closed, and lines may have one position only: that is for the builder of a map to judge.
//!
//! # What is done by the `geojson` crate
//!
//! It reads every feature and every geometry, and decides what the outermost object is and whether that has its
//! members. Only the array `"features"` does not reach it as a whole: this module walks through it and hands the crate
//! one element after the other. The crate's own streaming reader takes the first `[` of a file for that array, which is
//! wrong behind a `bbox`, and looks at nothing that follows the array. What the crate leaves open is checked here: that
//! positions have two numbers, and how deep collections lie.
//!
//! Two of its limits are limits here: a point or the first polygon of a multi-polygon must not be empty, and no file
//! can be read in a program that turns on the feature `arbitrary_precision` of `serde_json`.

mod error;
mod input;
mod output;

use core::cell::Cell;
use core::fmt;
use std::io::Read;

use ::geojson::feature::Id;
use ::geojson::{Feature as Parsed, FeatureCollection, GeoJson, GeometryValue, JsonValue, Position};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, DeserializeSeed, Deserializer, Error, IgnoredAny};
use serde::de::{IntoDeserializer, MapAccess, SeqAccess, Visitor};
use serde_json::error::Category;

pub use self::error::{Fault, Place, ReadError};
use self::input::Progress;
pub use self::output::write;
use super::{MAX_NESTED_COLLECTIONS, ReadSummary};
use crate::geometry::Point;
use crate::map::{Feature, Shape};

/// Reads a map, handing its features to `each` in the order of the file.
///
/// The reader is buffered inside. Faults may show only after some features have been handed over; `each` can stop the
/// reading by an error of its own, which is then returned. Time O(bytes); memory O(largest feature).
///
/// # Errors
///
/// Whatever [`ReadError`] describes, turned into `E`, and whatever `each` returns.
pub fn read<R, E>(reader: R, mut each: impl FnMut(Feature) -> Result<(), E>) -> Result<ReadSummary, E>
where
    R: Read,
    E: From<ReadError>,
{
    let progress = Cell::new(Progress::START);
    let text = input::open(reader, &progress).map_err(|source| ReadError::Io { at: progress.get().at, source })?;
    let mut input = serde_json::Deserializer::from_reader(text);
    let mut failure = None;
    let mut goes_on = |feature| each(feature).map_err(|error| failure = Some(error)).is_ok();
    let mut sink = Sink { goes_on: &mut goes_on, summary: ReadSummary::default(), in_features: false, fault: None };
    let outcome = Walk { part: Part::Document, sink: &mut sink }.deserialize(&mut input);
    let Sink { summary, in_features, fault, .. } = sink;
    if let Some(failure) = failure {
        return Err(failure);
    }
    let index = summary.features;
    outcome.map_err(|error| match (classify(error, progress.get()), fault) {
        (ReadError::NotGeoJson { at, .. }, Some((name, fault))) => ReadError::Feature { index, name, at, fault },
        (ReadError::NotGeoJson { at, fault }, None) if in_features => {
            ReadError::Feature { index, name: None, at, fault }
        }
        (error, _) => error,
    })?;
    input.end().map_err(|error| match classify(error, progress.get()) {
        ReadError::Syntax { at, .. } => ReadError::Trailing { at },
        other => other,
    })?;
    Ok(summary)
}

/// Gives an error of `serde_json` a type. What its category does not tell, it tells in words only.
fn classify(error: serde_json::Error, progress: Progress) -> ReadError {
    let at = Place { line: error.line(), column: error.column() };
    // The message repeats the place.
    let mut message = error.to_string();
    message.truncate(message.rfind(" at line ").unwrap_or(message.len()));
    // A number cut short counts as a bad number there, not as an early end.
    let is_cut_number = progress.stopped && at == progress.at && message == "invalid number";
    match (error.classify(), &*message) {
        (Category::Io, _) => ReadError::Io { at: progress.at, source: error.into() },
        (Category::Eof, _) if progress.blank => ReadError::Empty { at },
        (Category::Eof, _) => ReadError::Truncated { at },
        (Category::Syntax, _) if is_cut_number => ReadError::Truncated { at },
        (Category::Syntax, "number out of range") => ReadError::NotGeoJson { at, fault: Fault::OutOfRange },
        (Category::Syntax, "recursion limit exceeded") => ReadError::NotGeoJson { at, fault: Fault::TooDeep },
        (Category::Syntax, _) => ReadError::Syntax { at, message },
        (Category::Data, _) => {
            ReadError::NotGeoJson { at, fault: Fault::Malformed { message: message.chars().take(200).collect() } }
        }
    }
}

/// Where features go.
struct Sink<'f> {
    /// Takes a feature, and says whether to go on.
    goes_on: &'f mut dyn FnMut(Feature) -> bool,
    summary: ReadSummary,
    /// Whether an element of `"features"` is being read.
    in_features: bool,
    /// A fault of a feature that the crate took, and the feature's name. Serde only gets to know that there is one, and
    /// adds the place.
    fault: Option<(Option<String>, Fault)>,
}

impl Sink<'_> {
    fn take<S: Error>(&mut self, parsed: Parsed) -> Result<(), S> {
        let label = |value: &JsonValue| match value {
            JsonValue::String(text) => Some(text.clone()),
            JsonValue::Number(number) => Some(number.to_string()),
            _ => None,
        };
        let keys = ["name", "NAME", "Name", "ADMIN", "admin", "title", "id"];
        let name = keys.into_iter().find_map(|key| parsed.property(key).and_then(label));
        let id = parsed.id.map(|id| match id {
            Id::String(text) => text,
            Id::Number(number) => number.to_string(),
        });
        let mut drawing = Embedding::default();
        if let Some(geometry) = parsed.geometry
            && let Err(fault) = drawing.add(geometry.value, 0)
        {
            self.fault = Some((name, fault));
            return Err(S::custom("faulty"));
        }
        let feature = Feature { name, id, shapes: drawing.shapes };
        self.summary.add(&feature, drawing.with_extra_dimensions);
        if (self.goes_on)(feature) { Ok(()) } else { Err(S::custom("stopped")) }
    }
}

/// The shapes of one feature.
#[derive(Default)]
struct Embedding {
    shapes: Vec<Shape>,
    with_extra_dimensions: usize,
}

impl Embedding {
    /// Adds a geometry that lies inside this many collections, a number that bounds the recursion.
    fn add(&mut self, value: GeometryValue, depth: usize) -> Result<(), Fault> {
        match value {
            GeometryValue::Point { coordinates } => {
                let point = self.point(&coordinates)?;
                self.shapes.push(Shape::Point(point));
            }
            GeometryValue::MultiPoint { coordinates } => {
                let points = self.line(coordinates)?;
                self.shapes.extend(points.into_iter().map(Shape::Point));
            }
            GeometryValue::LineString { coordinates } => self.add_line(coordinates)?,
            GeometryValue::MultiLineString { coordinates } => {
                coordinates.into_iter().try_for_each(|line| self.add_line(line))?;
            }
            GeometryValue::Polygon { coordinates } => self.add_polygon(coordinates)?,
            GeometryValue::MultiPolygon { coordinates } => {
                coordinates.into_iter().try_for_each(|rings| self.add_polygon(rings))?;
            }
            GeometryValue::GeometryCollection { .. } if depth == MAX_NESTED_COLLECTIONS => return Err(Fault::TooDeep),
            GeometryValue::GeometryCollection { geometries } => {
                geometries.into_iter().try_for_each(|geometry| self.add(geometry.value, depth + 1))?;
            }
        }
        Ok(())
    }

    fn add_line(&mut self, line: Vec<Position>) -> Result<(), Fault> {
        let points = self.line(line)?;
        self.shapes.extend(Some(points).filter(|points| !points.is_empty()).map(Shape::Line));
        Ok(())
    }

    fn add_polygon(&mut self, rings: Vec<Vec<Position>>) -> Result<(), Fault> {
        let rings = rings.into_iter().map(|ring| self.line(ring)).collect::<Result<Vec<_>, _>>()?;
        self.shapes.extend(Some(rings).filter(|rings| !rings.is_empty()).map(Shape::Polygon));
        Ok(())
    }

    fn line(&mut self, positions: Vec<Position>) -> Result<Vec<Point>, Fault> {
        // Collecting results would not reserve the memory at once.
        let mut points = Vec::with_capacity(positions.len());
        for position in positions {
            points.push(self.point(&position)?);
        }
        Ok(points)
    }

    fn point(&mut self, position: &Position) -> Result<Point, Fault> {
        let &[x, y, ref extra @ ..] = position.as_slice() else {
            return Err(Fault::ShortPosition { numbers: position.len() });
        };
        self.with_extra_dimensions += usize::from(!extra.is_empty());
        Ok(Point { x, y })
    }
}

/// The parts of a document that this module looks at itself.
#[derive(Clone, Copy)]
enum Part {
    /// The outermost object.
    Document,
    /// The array `"features"`.
    Features,
    /// One element of that array.
    Element,
}

/// Walks through one part of a document.
struct Walk<'s, 'f> {
    part: Part,
    sink: &'s mut Sink<'f>,
}

impl<'de> DeserializeSeed<'de> for Walk<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        match self.part {
            Part::Document | Part::Element => deserializer.deserialize_map(self),
            Part::Features => deserializer.deserialize_seq(self),
        }
    }
}

impl<'de> Visitor<'de> for Walk<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.part {
            Part::Document => "a GeoJSON object",
            Part::Features => "an array of features",
            Part::Element => "a feature",
        })
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<(), A::Error> {
        self.sink.in_features = true;
        while array.next_element_seed(Walk { part: Part::Element, sink: &mut *self.sink })?.is_some() {}
        self.sink.in_features = false;
        Ok(())
    }

    /// What fails in here gets the place of the closing brace, so features are converted in here too.
    fn visit_map<A: MapAccess<'de>>(self, inner: A) -> Result<(), A::Error> {
        let Self { part, sink } = self;
        if let Part::Element = part {
            let feature = Parsed::deserialize(MapAccessDeserializer::new(inner))?;
            return sink.take(feature);
        }
        let mut members = Members { inner, sink, at_features: false, has_features: false };
        match GeoJson::deserialize(MapAccessDeserializer::new(&mut members))? {
            GeoJson::FeatureCollection(_) => Ok(()),
            // The features of an object of another type, which have been handed over already.
            other if members.has_features => FeatureCollection::try_from(other).map(drop).map_err(A::Error::custom),
            GeoJson::Feature(feature) => members.sink.take(feature),
            GeoJson::Geometry(geometry) => members.sink.take(geometry.into()),
        }
    }
}

/// The members of the outermost object as the crate gets to see them: without those that mean nothing here, which it
/// would keep in memory, and with an empty array for `"features"`, whose elements go to the sink.
struct Members<'s, 'f, A> {
    inner: A,
    sink: &'s mut Sink<'f>,
    at_features: bool,
    has_features: bool,
}

impl<'de, A: MapAccess<'de>> MapAccess<'de> for Members<'_, '_, A> {
    type Error = A::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, A::Error> {
        const KNOWN: [&str; 7] = ["type", "features", "geometry", "properties", "id", "coordinates", "geometries"];
        while let Some(key) = self.inner.next_key::<String>()? {
            if let Some(known) = KNOWN.into_iter().find(|&known| known == key) {
                self.at_features = known == "features";
                return seed.deserialize(known.into_deserializer()).map(Some);
            }
            self.inner.next_value::<IgnoredAny>()?;
        }
        Ok(None)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, A::Error> {
        if !self.at_features {
            return self.inner.next_value_seed(seed);
        }
        self.has_features = true;
        self.inner.next_value_seed(Walk { part: Part::Features, sink: self.sink })?;
        seed.deserialize(JsonValue::Array(Vec::new())).map_err(A::Error::custom)
    }
}
