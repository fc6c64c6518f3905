//! The member `crs` of the outermost object, which was in GeoJSON before RFC 7946.

use ::geojson::JsonValue;
use core::fmt;
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

/// The suffixes of names for the default of RFC 7946: longitudes and latitudes on WGS 84.
const USUAL: [&str; 3] = ["CRS84", "EPSG::4326", "EPSG:4326"];

/// Returns true if this name of a coordinate reference system does not mean longitudes and latitudes on WGS 84.
pub(super) fn is_other(name: &str) -> bool {
    !USUAL.iter().any(|usual| name.ends_with(usual))
}

/// Returns true if the member `crs` of an object does not mean longitudes and latitudes on WGS 84. O(1).
///
/// ```
/// use twinedge_formats::io::geojson::names_other_crs;
///
/// let crs = |name: &str| serde_json::json!({"type": "name", "properties": {"name": name}});
/// assert!(!names_other_crs(&crs("urn:ogc:def:crs:OGC:1.3:CRS84")));
/// assert!(names_other_crs(&crs("urn:ogc:def:crs:EPSG::2056")));
/// ```
#[must_use]
pub fn names_other_crs(crs: &JsonValue) -> bool {
    let name = crs.pointer("/properties/name").and_then(JsonValue::as_str);
    !crs.is_null() && is_other(name.unwrap_or_default())
}

/// Looks for a text at the end of a path of keys: empty if there is another value; `None` for null. Other parts are skipped.
pub(super) struct TextAt(pub(super) &'static [&'static str]);

/// The path to the name of a coordinate reference system.
pub(super) const NAME: TextAt = TextAt(&["properties", "name"]);

impl<'de> DeserializeSeed<'de> for TextAt {
    type Value = Option<String>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for TextAt {
    type Value = Option<String>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("anything")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut found = String::new();
        while let Some(key) = map.next_key::<String>()? {
            match self.0.split_first() {
                Some((first, rest)) if **first == key => {
                    found = map.next_value_seed(TextAt(rest))?.unwrap_or_default();
                }
                _ => drop(map.next_value::<IgnoredAny>()?),
            }
        }
        Ok(Some(found))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
        Ok(Some(if self.0.is_empty() { text.to_owned() } else { String::new() }))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Self::Value, A::Error> {
        while array.next_element::<IgnoredAny>()?.is_some() {}
        Ok(Some(String::new()))
    }

    fn visit_unit<E: Error>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_bool<E: Error>(self, _: bool) -> Result<Self::Value, E> {
        Ok(Some(String::new()))
    }

    fn visit_i64<E: Error>(self, _: i64) -> Result<Self::Value, E> {
        Ok(Some(String::new()))
    }

    fn visit_u64<E: Error>(self, _: u64) -> Result<Self::Value, E> {
        Ok(Some(String::new()))
    }

    fn visit_f64<E: Error>(self, _: f64) -> Result<Self::Value, E> {
        Ok(Some(String::new()))
    }
}
