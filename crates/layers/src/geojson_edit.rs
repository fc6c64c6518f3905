//! Editing GeoJSON: changing some features and keeping all other bytes.

use super::geojson::{write_feature, write_geometry};
use super::model::{Feature, Layer};
use crate::io::Format;
use serde::{Deserialize, Deserializer};
use serde_json::value::RawValue;
use std::io;
use std::ops::Range;

/// A range of a text, and its replacement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The number of its feature; `None` for a member of the whole.
    pub feature: Option<usize>,
    /// The range, in bytes of the old text.
    pub place: Range<usize>,
    /// The replacement.
    pub after: String,
}

/// The members of an object that can change. They borrow from the text, which determines their ranges.
#[derive(Default, Deserialize)]
struct Members<'a> {
    #[serde(borrow, default, deserialize_with = "present")]
    geometry: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "present")]
    bbox: Option<&'a RawValue>,
    #[serde(borrow, default)]
    features: Option<Vec<&'a RawValue>>,
}

/// Deserializes a member, even if it is null.
fn present<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<&'de RawValue>, D::Error> {
    <&RawValue>::deserialize(deserializer).map(Some)
}

/// Returns the edits that turn a GeoJSON text with `count` features into a layer with other geometries of some features, in
/// order, without overlaps. Features beyond `count` are new. The rest stays: white space, digits of numbers, the order of
/// members.
///
/// Returns `None` if the text has no place for an edit, such as a second feature in an object that is a feature, or if it is not
/// GeoJSON with this number of features; then the layer must be rewritten.
///
/// O(bytes).
///
/// ```
/// use twinedge_layers::{Format, Geometry, Position, ReadOptions, Shape, edited, edits, read_layer};
///
/// let text = r#"{ "type": "Feature",  "properties": {}, "geometry": {"type": "Point", "coordinates": [1e0, 2.0]} }"#;
/// let mut layer = read_layer(&mut text.as_bytes(), None, &ReadOptions::default())?;
/// layer.features[0].geometry = None;
/// let edits = edits(text, Format::GeoJson, 1, &layer, &[0]).expect("there is a geometry");
/// assert_eq!(edited(text, &edits), r#"{ "type": "Feature",  "properties": {}, "geometry": null }"#);
/// # Ok::<_, twinedge_layers::ReadError>(())
/// ```
#[must_use]
pub fn edits(text: &str, format: Format, count: usize, after: &Layer, changed: &[usize]) -> Option<Vec<Edit>> {
    let text_of = |raw: &RawValue| {
        let start = raw.get().as_ptr() as usize - text.as_ptr() as usize;
        start..start + raw.get().len()
    };
    let documents = documents(text, format)?;
    let mut edits = Vec::new();
    let (all, separator) = match (format, &documents[..]) {
        (Format::GeoJson, [document]) => {
            let Members { bbox, features, .. } = serde_json::from_str(document.get()).ok()?;
            let bbox = bbox
                .zip(after.header.members.get("bbox"))
                .filter(|(raw, bbox)| features.is_some() && !is_box(raw.get(), bbox));
            if let Some((raw, bbox)) = bbox {
                edits.push(Edit { feature: None, place: text_of(raw), after: bbox.to_string() });
            }
            match features {
                Some(features) => (features, Some(",\n")),
                None => (documents, None),
            }
        }
        (Format::GeoJsonSeq, _) if text.contains(SEPARATOR) => (documents, Some("\n\u{1e}")),
        (Format::GeoJsonSeq, _) => (documents, Some("\n")),
        _ => return None,
    };
    if all.len() != count {
        return None;
    }
    for (number, raw) in changed.iter().filter_map(|number| Some((*number, *all.get(*number)?))) {
        let mut put = |place: Range<usize>, after: String| edits.push(Edit { feature: Some(number), place, after });
        let feature = after.features.get(number)?;
        let members: Members<'_> = serde_json::from_str(raw.get()).ok()?;
        let bbox = feature.members.get("bbox");
        match members.geometry {
            Some(geometry) if members.bbox.is_some() == bbox.is_some() => {
                put(text_of(geometry), geometry_text(feature)?);
                if let Some((raw, bbox)) = members.bbox.zip(bbox).filter(|(raw, bbox)| !is_box(raw.get(), bbox)) {
                    put(text_of(raw), bbox.to_string());
                }
            }
            // The box is removed, with the comma before or after it.
            _ => put(text_of(raw), written(|out| write_feature(feature, out))?),
        }
    }
    let end = text_of(all.last()?).end;
    for (number, feature) in after.features.iter().enumerate().skip(all.len()) {
        let after = format!("{}{}", separator?, written(|out| write_feature(feature, out))?);
        edits.push(Edit { feature: Some(number), place: end..end, after });
    }
    edits.sort_by_key(|edit| edit.place.start);
    Some(edits)
}

/// Returns the text of one feature with another geometry; completely rewritten if it has no place for the edit. O(bytes).
pub(super) fn edited_feature(text: &str, after: &Layer) -> Option<String> {
    match edits(text, Format::GeoJson, 1, after, &[0]) {
        Some(edits) => Some(edited(text, &edits)),
        None => after.features.first().and_then(|feature| written(|out| write_feature(feature, out))),
    }
}

/// Returns true if a text states the same box, ignoring notation of numbers.
pub(super) fn is_box(text: &str, bbox: &serde_json::Value) -> bool {
    let numbers = Vec::<f64>::deserialize(bbox);
    numbers.is_ok_and(|numbers| serde_json::from_str::<Vec<f64>>(text).is_ok_and(|before| before == numbers))
}

/// The character before each text of a sequence of RFC 8142.
const SEPARATOR: char = '\u{1e}';

fn documents(text: &str, format: Format) -> Option<Vec<&RawValue>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let separated = text.split(SEPARATOR).filter(|_| format == Format::GeoJsonSeq);
    let whole = Some(text).filter(|_| format == Format::GeoJson);
    let texts = separated.chain(whole);
    texts
        .flat_map(|text| serde_json::Deserializer::from_str(text).into_iter::<&RawValue>())
        .collect::<Result<_, _>>()
        .ok()
}

fn geometry_text(feature: &Feature) -> Option<String> {
    match &feature.geometry {
        Some(geometry) => written(|out| write_geometry(geometry, out)),
        None => Some("null".to_owned()),
    }
}

fn written(write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>) -> Option<String> {
    let mut bytes = Vec::new();
    write(&mut bytes).ok()?;
    String::from_utf8(bytes).ok()
}

/// Applies edits, which must be in order and not overlap. O(bytes).
///
/// # Panics
/// If the edits overlap or do not fit the text.
#[must_use]
pub fn edited(text: &str, edits: &[Edit]) -> String {
    let mut done = String::with_capacity(text.len());
    let mut from = 0;
    for Edit { place, after, .. } in edits {
        done.push_str(&text[from..place.start]);
        done.push_str(after);
        from = place.end;
    }
    done + &text[from..]
}
