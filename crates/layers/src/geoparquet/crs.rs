//! Reference systems in `GeoParquet`: PROJJSON, and none for longitude and latitude on WGS 84.

use super::super::crs::Crs;
use super::super::epsg;
use serde_json::Value as Json;

/// The number of longitude and latitude on WGS 84.
const WGS_84: i64 = 4326;

/// Creates the system of a definition in PROJJSON. The definition is kept if its number does not lead to one.
pub(super) fn of_projjson(json: &Json) -> Crs {
    let id = |key| json.pointer("/id").and_then(|id| id.get(key));
    let authority = id("authority").and_then(Json::as_str).unwrap_or_default();
    if authority == "OGC" && id("code").and_then(Json::as_str) == Some("CRS84") {
        return Crs::epsg(WGS_84);
    }
    let code = id("code").and_then(|code| code.as_i64().or_else(|| code.as_str()?.parse().ok()));
    let code = code.filter(|_| !authority.is_empty()).map(|code| (authority.to_owned(), code));
    let crs = Crs { code, ..Crs::default() };
    let is_known = !crs.is_other() && crs.code.is_some() || of_code(&crs).is_some();
    Crs { projjson: (!is_known).then(|| json.clone()), ..crs }
}

/// Creates the system of Parquet's own geometry type: a number (`srid:2056`, `EPSG:2056`), PROJJSON, or its key in the metadata.
/// `None` for an unknown one.
pub(super) fn of_native(text: Option<&str>, metadata: impl Fn(&str) -> Option<String>) -> Option<Crs> {
    let Some(text) = text else { return Some(Crs::epsg(WGS_84)) };
    let json = |text: &str| serde_json::from_str::<Json>(text).ok().filter(Json::is_object);
    if let Some(json) = json(text) {
        return Some(of_projjson(&json));
    }
    let (kind, rest) = text.split_once(':')?;
    match kind {
        "srid" => rest.parse().ok().filter(|code| *code > 0).map(Crs::epsg),
        "projjson" => Some(of_projjson(&json(&metadata(rest)?)?)),
        "OGC" if rest == "CRS84" => Some(Crs::epsg(WGS_84)),
        authority => Some(Crs { code: Some((authority.to_owned(), rest.parse().ok()?)), ..Crs::default() }),
    }
}

/// Returns the member `crs` of a column: `None` for longitude and latitude on WGS 84, null for an unknown system.
pub(super) fn member(crs: Option<&Crs>) -> Option<Json> {
    match crs {
        Some(crs) if !crs.is_other() => None,
        Some(crs) => Some(crs.projjson.clone().or_else(|| of_code(crs)).unwrap_or(Json::Null)),
        None => Some(Json::Null),
    }
}

/// Returns true if a file can hold the system.
pub(crate) fn is_held(crs: &Crs) -> bool {
    !crs.is_other() || member(Some(crs)).is_some_and(|member| !member.is_null())
}

fn of_code(crs: &Crs) -> Option<Json> {
    let (authority, code) = crs.code.as_ref()?;
    let text = authority.eq_ignore_ascii_case("EPSG").then(|| epsg::projjson(*code))??;
    serde_json::from_str(&text).ok()
}
