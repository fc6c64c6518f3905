//! A file of TopoJSON: the arcs with their coordinates, and the objects as JSON.

use super::super::error::{Cause, Place, ReadError};
use super::super::model::{Line, Members, Position};
use crate::io::{Format, TextPlace};
use serde::de::{self, Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::Value as Json;
use serde_json::error::Category;
use std::fmt;
use std::io::Read;

/// A file with its numbers turned into coordinates.
#[derive(Debug, Default)]
pub(super) struct Document {
    pub(super) transform: Transform,
    pub(super) arcs: Vec<Line>,
    pub(super) objects: Members,
    pub(super) members: Members,
}

/// The transformation from the numbers of a quantised file to coordinates.
#[derive(Clone, Copy, Debug, serde::Deserialize)]
pub(super) struct Transform {
    scale: [f64; 2],
    translate: [f64; 2],
}

/// The identity.
impl Default for Transform {
    fn default() -> Self {
        Self { scale: [1.0; 2], translate: [0.0; 2] }
    }
}

impl Transform {
    pub(super) fn apply(&self, at: &mut Position) {
        at.x = at.x * self.scale[0] + self.translate[0];
        at.y = at.y * self.scale[1] + self.translate[1];
    }
}

pub(super) fn content(place: Place, cause: Cause) -> ReadError {
    ReadError::Content { format: Format::TopoJson, place, cause }
}

/// Returns an error if a coordinate is too large for a 64-bit number.
pub(super) fn check_finite(at: &Position) -> Result<(), Cause> {
    if at.x.is_finite() && at.y.is_finite() {
        return Ok(());
    }
    Err(Cause::Invalid(format!("the coordinates ({}, {}) are not finite", at.x, at.y)))
}

impl Document {
    /// Reads a file. O(bytes) time and memory; `serde_json` limits the nesting.
    pub(super) fn read(reader: &mut dyn Read) -> Result<Self, ReadError> {
        let mut bytes = Vec::new();
        reader.read_to_end(&mut bytes)?;
        let text = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(&bytes);
        let Raw { transform, mut arcs, objects, members } = serde_json::from_slice(text).map_err(|error| {
            let place = TextPlace { line: error.line(), column: Some(error.column()) };
            content(Place::Text(place), cause(&error))
        })?;
        for (number, arc) in arcs.iter_mut().enumerate() {
            decode(arc, transform.as_ref()).map_err(|cause| content(Place::Arc(number), cause))?;
        }
        Ok(Self { transform: transform.unwrap_or_default(), arcs, objects, members })
    }
}

fn cause(error: &serde_json::Error) -> Cause {
    if error.classify() == Category::Eof {
        return Cause::Truncated("the outermost object");
    }
    // The place is reported separately from the message.
    let message = error.to_string();
    let end = message.rfind(" at line ").unwrap_or(message.len());
    Cause::Invalid(message[..end].to_owned())
}

/// Decodes quantised positions, each the difference to the position before it.
fn decode(arc: &mut Line, transform: Option<&Transform>) -> Result<(), Cause> {
    let mut at = [0.0; 2];
    for position in arc {
        if let Some(transform) = transform {
            at = [at[0] + position.x, at[1] + position.y];
            [position.x, position.y] = at;
            transform.apply(position);
        }
        check_finite(position)?;
    }
    Ok(())
}

/// The members of the outermost object, as read.
struct Raw {
    transform: Option<Transform>,
    arcs: Vec<Line>,
    objects: Members,
    members: Members,
}

impl<'de> Deserialize<'de> for Raw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Topology;
        impl<'de> Visitor<'de> for Topology {
            type Value = Raw;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object with the type Topology")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Raw, A::Error> {
                let (mut kind, mut transform, mut arcs, mut objects) = (None, None, None, None);
                let mut members = Members::new();
                while let Some(name) = map.next_key::<String>()? {
                    let is_repeated = match name.as_str() {
                        "type" => kind.replace(map.next_value::<String>()?).is_some(),
                        "transform" => transform.replace(map.next_value::<Option<Transform>>()?).is_some(),
                        "arcs" => arcs.replace(map.next_value::<Vec<Line>>()?).is_some(),
                        "objects" => objects.replace(map.next_value::<Members>()?).is_some(),
                        _ => members.insert(name.clone(), map.next_value::<Json>()?).is_some(),
                    };
                    if is_repeated {
                        return Err(de::Error::custom(format_args!("the member `{name}` is repeated")));
                    }
                }
                match kind {
                    Some(kind) if kind == "Topology" => {}
                    Some(kind) => {
                        return Err(de::Error::custom(format_args!("the type is {kind:?}, and must be Topology")));
                    }
                    None => return Err(de::Error::missing_field("type")),
                }
                Ok(Raw {
                    transform: transform.flatten(),
                    arcs: arcs.ok_or_else(|| de::Error::missing_field("arcs"))?,
                    objects: objects.ok_or_else(|| de::Error::missing_field("objects"))?,
                    members,
                })
            }
        }
        deserializer.deserialize_map(Topology)
    }
}
