//! Reading GeoJSON ([RFC 7946](https://www.rfc-editor.org/rfc/rfc7946)), one feature at a time.
//!
//! [`read`] takes a feature collection, a feature or a bare geometry, and hands over each feature as soon as its
//! closing brace is read. Nothing is kept but the feature at hand, so a map of any size can be read as long as its
//! largest feature fits: about 16 bytes per position, 40 per ring and 32 per shape, and up to three times that while
//! the lists grow.
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
//! - A geometry that is null or absent, or whose coordinates are an empty array, gives a feature without shapes. An
//!   empty part of a multi-line or multi-polygon is dropped; an empty ring beside others, or alone, is kept.
//! - Geometry collections are flattened. They may lie inside each other
//!   [`MAX_NESTED_COLLECTIONS`](super::MAX_NESTED_COLLECTIONS) deep.
//! - What a position has beyond two numbers is dropped and counted.
//! - Members may come in any order. Foreign ones, `bbox` and `crs` are skipped, whatever they hold and however deep. A
//!   member that only another type gives a meaning to counts as foreign once the type is known.
//! - A member with a meaning that is given twice is a fault, since readers disagree about which one counts.
//! - Rings may be open or closed, and lines may have one position only: that is for the builder of a map to judge.
//!
//! # Why not the reader of the `geojson` crate
//!
//! Its streaming reader takes the first `[` of a file for the list of features, which is wrong behind a `bbox`, and
//! never looks at what follows the list. Its errors are texts without a type, often without a place; its positions may
//! have one number only; it keeps foreign members in memory, at 66 times the size of their text; and it reads no file
//! at all once any crate of a program turns on `arbitrary_precision` in `serde_json`. It serves the tests of this
//! module as a second opinion.

#![expect(clippy::doc_markdown, reason = "GeoJSON is a name, not an item")]

mod coordinates;
mod error;
mod json;
mod object;
mod scan;

use std::io::Read;

use serde::de::{DeserializeSeed, Error, IgnoredAny, MapAccess, SeqAccess};
use serde_json::error::Category;

pub use self::error::{Fault, Place, ReadError};
use self::json::{Any, Progress, Tracked, Value};
use self::object::{Key, Member, Object, Role, Type};
use self::scan::Scan;
use super::Summary;
use crate::geometry::Feature;

/// Reads a map, handing its features to `each` in the order of the file.
///
/// The reader is buffered inside. Faults may show only after some features have been handed over; `each` can stop the
/// reading by an error of its own, which is then returned. Time O(bytes); memory O(largest feature).
///
/// # Errors
///
/// Whatever [`ReadError`] describes, turned into `E`, and whatever `each` returns.
pub fn read<R, E>(reader: R, each: impl FnMut(Feature) -> Result<(), E>) -> Result<Summary, E>
where
    R: Read,
    E: From<ReadError>,
{
    let progress = Progress::new();
    let mut scan = Scan::new(&progress);
    let mut sink = Sink { each, summary: Summary::default(), failure: None };
    let mut input = serde_json::Deserializer::from_reader(Tracked::new(reader, &progress));

    let outcome = Any(Document { scan: &mut scan, sink: &mut sink }).deserialize(&mut input);
    if let Some(failure) = sink.failure {
        return Err(failure);
    }
    let outcome = outcome.map_err(|error| {
        let error = classify(error, &progress);
        if let ReadError::Syntax { at, message } = &error
            && message == "number out of range"
        {
            scan.fail(*at, Fault::OutOfRange);
        }
        error
    });
    if let Some(error) = scan.take_error(sink.summary.features) {
        return Err(error.into());
    }
    outcome?;
    input.end().map_err(|error| match classify(error, &progress) {
        ReadError::Syntax { at, .. } => ReadError::Trailing { at },
        other => other,
    })?;
    Ok(sink.summary)
}

/// Gives an error of `serde_json` a type. What category it does not tell, it tells in words only.
fn classify(error: serde_json::Error, progress: &Progress) -> ReadError {
    // `serde_json` reads on to the end of the arrays and objects around a fault, so its own note of the place comes
    // first.
    let at = match error.line() {
        0 => progress.at(),
        line => Place { line, column: error.column() },
    };
    // The message repeats the place.
    let mut message = error.to_string();
    if let Some(end) = message.rfind(" at line ") {
        message.truncate(end);
    }
    // A number cut short counts as a bad number there, not as an early end.
    let is_cut_number = progress.is_ended() && at == progress.at() && message == "invalid number";
    match error.classify() {
        Category::Io => ReadError::Io { at, source: error.into() },
        Category::Eof if progress.is_blank() => ReadError::Empty { at },
        Category::Eof => ReadError::Truncated { at },
        Category::Syntax if is_cut_number => ReadError::Truncated { at },
        Category::Syntax | Category::Data => ReadError::Syntax { at, message },
    }
}

/// Where features go.
struct Sink<F, E> {
    each: F,
    summary: Summary,
    /// What is to be returned; serde only gets to know that there is something.
    failure: Option<E>,
}

impl<F, E> Sink<F, E>
where
    F: FnMut(Feature) -> Result<(), E>,
    E: From<ReadError>,
{
    /// Hands over the feature that was just read, or fails with what was wrong with it.
    fn take<S: Error>(&mut self, mut feature: Feature, scan: &mut Scan<'_>) -> Result<(), S> {
        let outcome = if let Some(error) = scan.take_error(self.summary.features) {
            Err(error.into())
        } else {
            feature.name = scan.take_name();
            self.summary.add(&feature, scan.take_extra());
            (self.each)(feature)
        };
        outcome.map_err(|failure| {
            self.failure = Some(failure);
            S::custom("stopped")
        })
    }
}

/// The outermost value.
struct Document<'s, 'p, F, E> {
    scan: &'s mut Scan<'p>,
    sink: &'s mut Sink<F, E>,
}

impl<F, E> Value for Document<'_, '_, F, E>
where
    F: FnMut(Feature) -> Result<(), E>,
    E: From<ReadError>,
{
    type Out = ();

    fn other(self) {
        self.scan.fail(self.scan.here(), Fault::NotAnObject);
    }

    fn object<'de, A: MapAccess<'de>>(self, mut members: A) -> Result<(), A::Error> {
        let Self { scan, sink } = self;
        let at = scan.here();
        let mut object = Object::new(Role::Document, at);
        while let Some(key) = members.next_key()? {
            if key != Key::Features {
                object.read(key, &mut members, scan)?;
            } else if object.admit(key, scan) {
                members.next_value_seed(Any(Features { scan, sink }))?;
            } else {
                members.next_value::<IgnoredAny>()?;
            }
        }
        let is_collection = object.kind() == Some(Type::FeatureCollection);
        if object.has(Key::Features) && object.kind().is_some() && !is_collection {
            scan.leave_feature();
            scan.fail(at, Fault::Misplaced { member: "features" });
        }
        let feature = object.feature(scan);
        if is_collection || scan.failed() { Ok(()) } else { sink.take(feature, scan) }
    }
}

/// The value of `"features"`.
struct Features<'s, 'p, F, E> {
    scan: &'s mut Scan<'p>,
    sink: &'s mut Sink<F, E>,
}

impl<F, E> Value for Features<'_, '_, F, E>
where
    F: FnMut(Feature) -> Result<(), E>,
    E: From<ReadError>,
{
    type Out = ();

    fn other(self) {
        self.scan.fail(self.scan.here(), Fault::NotAnArray { member: "features" });
    }

    fn array<'de, A: SeqAccess<'de>>(self, mut array: A) -> Result<(), A::Error> {
        let Self { scan, sink } = self;
        loop {
            scan.start_feature();
            let Some(feature) = array.next_element_seed(Any(Member { scan: &mut *scan }))? else {
                break;
            };
            sink.take(feature, scan)?;
        }
        scan.leave_feature();
        Ok(())
    }
}
