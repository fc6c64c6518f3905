//! Reading features, one at a time.

use core::cell::Cell;
use core::fmt;
use std::io::Read;

use ::geojson::{Feature as Parsed, FeatureCollection, GeoJson, GeometryValue, JsonValue, Position};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, DeserializeSeed, Deserializer, Error, IntoDeserializer, MapAccess, SeqAccess, Visitor};
use serde_json::error::Category;

use super::input::{self, Progress};
use crate::io::error::{MAX_NESTED_COLLECTIONS, ReadCause, ReadError, TextPlace};

/// The number of GeoJSON objects in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Documents {
    /// One object.
    One,
    /// Any number of successive objects.
    Many,
}

/// A part of a file, in the types of the crate `geojson`.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Part {
    /// A feature with all its data; a geometry without a feature around it counts as one.
    Feature(Box<Parsed>),
    /// A member of a collection of features, by name: `crs`, `name`, `bbox` and foreign ones.
    Member(String, JsonValue),
}

/// Reads a file without dropping anything: passes features to `each` in the order of the file, in the types of the crate
/// `geojson`, with their properties, foreign members and all dimensions, and the members of the outermost object.
///
/// Documents in a row may have one object per line, or record separators before them
/// ([RFC 8142](https://www.rfc-editor.org/rfc/rfc8142)): both count as white space, which is optional. The reader is buffered
/// inside. Features before a fault have been passed on. An error of `each` stops reading and is returned. Time O(bytes); memory
/// O(largest feature).
///
/// ```
/// use twinedge_layers::io::ReadError;
/// use twinedge_layers::io::geojson::{Documents, Part, read_parts};
///
/// let text = r#"{"type":"FeatureCollection","name":"peaks","features":[
///     {"type":"Feature","geometry":{"type":"Point","coordinates":[7.66,45.98,4478]},"properties":{"first":1865}}]}"#;
/// let mut names = Vec::new();
/// read_parts(text.as_bytes(), Documents::One, |part| {
///     match part {
///         Part::Member(name, _) => names.push(name),
///         Part::Feature(feature) => assert_eq!(feature.property("first"), Some(&1865.into())),
///         _ => {}
///     }
///     Ok::<_, ReadError>(())
/// })?;
/// assert_eq!(names, ["name"]);
/// # Ok::<_, ReadError>(())
/// ```
///
/// # Errors
/// [`ReadError`], converted to `E`, and the errors of `each`. Content after the end of the object is [`ReadCause::Trailing`].
pub fn read_parts<R, E>(reader: R, documents: Documents, mut each: impl FnMut(Part) -> Result<(), E>) -> Result<(), E>
where
    R: Read,
    E: From<ReadError>,
{
    let mut failure = None;
    let mut take = |part| {
        if let Part::Feature(feature) = &part {
            let checked = feature.geometry.as_ref().map_or(Ok(()), |geometry| check(&geometry.value, 0));
            checked?;
        }
        Ok(each(part).map_err(|error| failure = Some(error)).is_ok())
    };
    let outcome = read_all(reader, documents, &mut take);
    match (failure, outcome) {
        (Some(failure), _) => Err(failure),
        (None, Err(error)) => Err(error.into()),
        (None, Ok(())) => Ok(()),
    }
}

/// Checks that positions have two numbers and that collections are not nested too deep, which the crate does not check.
fn check(value: &GeometryValue, depth: usize) -> Result<(), ReadCause> {
    fn positions<'a>(all: impl IntoIterator<Item = &'a Position>) -> Result<(), ReadCause> {
        match all.into_iter().map(|position| position.len()).find(|numbers| *numbers < 2) {
            Some(numbers) => Err(ReadCause::ShortPosition { numbers }),
            None => Ok(()),
        }
    }
    match value {
        GeometryValue::Point { coordinates } => positions([coordinates]),
        GeometryValue::MultiPoint { coordinates } | GeometryValue::LineString { coordinates } => positions(coordinates),
        GeometryValue::MultiLineString { coordinates } | GeometryValue::Polygon { coordinates } => {
            positions(coordinates.iter().flatten())
        }
        GeometryValue::MultiPolygon { coordinates } => positions(coordinates.iter().flatten().flatten()),
        GeometryValue::GeometryCollection { .. } if depth == MAX_NESTED_COLLECTIONS => Err(ReadCause::TooDeep),
        GeometryValue::GeometryCollection { geometries } => {
            geometries.iter().try_for_each(|geometry| check(&geometry.value, depth + 1))
        }
    }
}

/// Passes on all parts. `take` returns true to continue.
fn read_all(
    reader: impl Read,
    documents: Documents,
    take: &mut dyn FnMut(Part) -> Result<bool, ReadCause>,
) -> Result<(), ReadError> {
    let progress = Cell::new(Progress::START);
    let text = input::open(reader, &progress, documents == Documents::Many)
        .map_err(|error| ReadError::new(progress.get().at, ReadCause::Io(error)))?;
    let mut input = serde_json::Deserializer::from_reader(text);
    let mut sink = Sink { take, features: 0, in_features: false, fault: None };
    if documents == Documents::One {
        read_document(&mut input, &mut sink, &progress)?;
    }
    while let Err(error) = input.end() {
        let error = classify(error, progress.get());
        match (documents, error.cause) {
            (Documents::Many, ReadCause::Syntax { .. }) => read_document(&mut input, &mut sink, &progress)?,
            (Documents::One, ReadCause::Syntax { .. }) => {
                return Err(ReadError::new(error.place, ReadCause::Trailing { what: "GeoJSON object" }));
            }
            (_, cause) => return Err(ReadError::new(error.place, cause)),
        }
    }
    Ok(())
}

/// Reads one object. Also returns an error if `each` stopped reading.
fn read_document<'de>(
    input: &mut serde_json::Deserializer<impl serde_json::de::Read<'de>>,
    sink: &mut Sink<'_>,
    progress: &Cell<Progress>,
) -> Result<(), ReadError> {
    Walk { part: DocumentPart::Document, sink }.deserialize(input).map_err(|error| {
        let error = classify(error, progress.get());
        let index = sink.features;
        match (&error.cause, sink.fault.take()) {
            (ReadCause::Malformed { .. } | ReadCause::OutOfRange | ReadCause::TooDeep, Some(cause)) => {
                ReadError::new(error.place, cause).in_feature(index)
            }
            (ReadCause::Malformed { .. } | ReadCause::OutOfRange | ReadCause::TooDeep, None) if sink.in_features => {
                error.in_feature(index)
            }
            _ => error,
        }
    })
}

/// Classifies an error of `serde_json`. Some distinctions are only in its text.
fn classify(error: serde_json::Error, progress: Progress) -> ReadError {
    let at = TextPlace { line: error.line(), column: Some(error.column()) };
    // The message repeats the place.
    let mut message = error.to_string();
    message.truncate(message.rfind(" at line ").unwrap_or(message.len()));
    // A number cut short counts as an invalid number there, not as an early end.
    let is_cut_number = progress.stopped && at == progress.at && message == "invalid number";
    match (error.classify(), &*message) {
        (Category::Io, _) => ReadError::new(progress.at, ReadCause::Io(error.into())),
        (Category::Eof, _) if progress.blank => ReadError::new(at, ReadCause::Empty),
        (Category::Eof, _) => ReadError::new(at, ReadCause::Truncated),
        (Category::Syntax, _) if is_cut_number => ReadError::new(at, ReadCause::Truncated),
        (Category::Syntax, "number out of range") => ReadError::new(at, ReadCause::OutOfRange),
        (Category::Syntax, "recursion limit exceeded") => ReadError::new(at, ReadCause::TooDeep),
        (Category::Syntax, _) => ReadError::new(at, ReadCause::Syntax { message }),
        (Category::Data, _) => {
            ReadError::new(at, ReadCause::Malformed { message: message.chars().take(200).collect() })
        }
    }
}

struct Sink<'f> {
    /// Takes a part, and returns true to continue.
    take: &'f mut dyn FnMut(Part) -> Result<bool, ReadCause>,
    features: usize,
    /// True while an element of `"features"` is being read.
    in_features: bool,
    /// Serde only learns that there is a fault, and adds the place.
    fault: Option<ReadCause>,
}

impl Sink<'_> {
    fn take<S: Error>(&mut self, part: Part) -> Result<(), S> {
        let is_feature = matches!(part, Part::Feature(_));
        match (self.take)(part) {
            Ok(goes_on) => {
                self.features += usize::from(is_feature);
                if goes_on { Ok(()) } else { Err(S::custom("stopped")) }
            }
            Err(fault) => {
                self.fault = Some(fault);
                Err(S::custom("faulty"))
            }
        }
    }
}

/// The columns that may hold the name of a feature, unless specified otherwise; the first existing one counts.
pub const NAME_COLUMNS: [&str; 7] = ["name", "NAME", "Name", "ADMIN", "admin", "title", "id"];

/// The parts of a document that this module handles itself.
#[derive(Clone, Copy)]
enum DocumentPart {
    Document,
    Features,
    Element,
}

/// Walks through one part of a document.
struct Walk<'s, 'f> {
    part: DocumentPart,
    sink: &'s mut Sink<'f>,
}

impl<'de> DeserializeSeed<'de> for Walk<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        match self.part {
            DocumentPart::Document | DocumentPart::Element => deserializer.deserialize_map(self),
            DocumentPart::Features => deserializer.deserialize_seq(self),
        }
    }
}

impl<'de> Visitor<'de> for Walk<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.part {
            DocumentPart::Document => "a GeoJSON object",
            DocumentPart::Features => "an array of features",
            DocumentPart::Element => "a feature",
        })
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<(), A::Error> {
        self.sink.in_features = true;
        while array.next_element_seed(Walk { part: DocumentPart::Element, sink: &mut *self.sink })?.is_some() {}
        self.sink.in_features = false;
        Ok(())
    }

    /// Errors raised in here get the place of the closing brace, so features are also converted in here.
    fn visit_map<A: MapAccess<'de>>(self, inner: A) -> Result<(), A::Error> {
        let Self { part, sink } = self;
        if let DocumentPart::Element = part {
            let feature = Parsed::deserialize(MapAccessDeserializer::new(inner))?;
            return sink.take(Part::Feature(feature.into()));
        }
        let mut members = Members { inner, sink, at_features: false, has_features: false, kept: Vec::new() };
        let document = GeoJson::deserialize(MapAccessDeserializer::new(&mut members))?;
        let kept = core::mem::take(&mut members.kept);
        match document {
            GeoJson::FeatureCollection(_) => {
                kept.into_iter().try_for_each(|(name, value)| members.sink.take(Part::Member(name, value)))
            }
            // The features of an object of another type have already been passed on.
            other if members.has_features => FeatureCollection::try_from(other).map(drop).map_err(A::Error::custom),
            GeoJson::Feature(feature) => members.sink.take(Part::Feature(with_members(feature, kept).into())),
            GeoJson::Geometry(geometry) => members.sink.take(Part::Feature(with_members(geometry.into(), kept).into())),
        }
    }
}

/// Returns a feature that is the outermost object, with the members hidden from the crate.
fn with_members(mut feature: Parsed, kept: Vec<(String, JsonValue)>) -> Parsed {
    if !kept.is_empty() {
        feature.foreign_members.get_or_insert_default().extend(kept);
    }
    feature
}

/// The members of the outermost object as presented to the crate: without irrelevant members, and with an empty array for `"features"`, whose elements go to the sink.
struct Members<'s, 'f, A> {
    inner: A,
    sink: &'s mut Sink<'f>,
    at_features: bool,
    has_features: bool,
    /// The irrelevant members.
    kept: Vec<(String, JsonValue)>,
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
            let value = self.inner.next_value()?;
            self.kept.push((key, value));
        }
        Ok(None)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, A::Error> {
        if !self.at_features {
            return self.inner.next_value_seed(seed);
        }
        self.has_features = true;
        self.inner.next_value_seed(Walk { part: DocumentPart::Features, sink: self.sink })?;
        seed.deserialize(JsonValue::Array(Vec::new())).map_err(A::Error::custom)
    }
}
