//! The member `crs` of the outermost object, which was in GeoJSON before RFC 7946.

use ::geojson::JsonValue;

/// The suffixes of names for the default of RFC 7946: longitudes and latitudes on WGS 84.
const USUAL: [&str; 3] = ["CRS84", "EPSG::4326", "EPSG:4326"];

/// Returns true if this name of a coordinate reference system does not mean longitudes and latitudes on WGS 84.
fn is_other(name: &str) -> bool {
    !USUAL.iter().any(|usual| name.ends_with(usual))
}

/// Returns true if the member `crs` of an object does not mean longitudes and latitudes on WGS 84. O(1).
///
/// ```
/// use twinedge_layers::io::geojson::names_other_crs;
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
