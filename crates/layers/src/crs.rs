//! Coordinate reference systems, as far as files name them.

use super::epsg;
use serde_json::Value as Json;

/// A coordinate reference system, as far as the file names it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Crs {
    /// The authority, usually `EPSG`, and its number.
    pub code: Option<(String, i64)>,
    /// The definition in well-known text.
    pub wkt: Option<String>,
    /// The member `crs` of a GeoJSON object.
    pub member: Option<Json>,
    /// The definition in PROJJSON, if its number does not lead to one.
    pub projjson: Option<Json>,
}

/// Esri's name of longitude and latitude on WGS 84.
const ESRI_WGS_84: &str = "GCS_WGS_1984";

/// The number of longitude and latitude on WGS 84.
const WGS_84: i64 = 4326;

/// The first words of the older form of well-known text (OGC 01-009), used by Esri and `GeoPackage`.
const WKT1: [&str; 7] = ["GEOGCS", "PROJCS", "COMPD_CS", "GEOCCS", "VERT_CS", "LOCAL_CS", "FITTED_CS"];

impl Crs {
    /// Creates the system with this EPSG number.
    #[must_use]
    pub fn epsg(code: i64) -> Self {
        Self { code: Some(("EPSG".to_owned(), code)), ..Self::default() }
    }

    /// Creates the system of the member `crs` of a GeoJSON object, with its number if the name contains an EPSG number.
    ///
    /// ```
    /// use twinedge_layers::Crs;
    ///
    /// let crs = |name: &str| Crs::of_member(serde_json::json!({"type": "name", "properties": {"name": name}}));
    /// assert_eq!(crs("urn:ogc:def:crs:EPSG::2056").code, Some(("EPSG".into(), 2056)));
    /// assert_eq!(crs("urn:ogc:def:crs:OGC:1.3:CRS84").code, Some(("EPSG".into(), 4326)));
    /// assert_eq!(crs("Bern").code, None);
    /// ```
    #[must_use]
    pub fn of_member(member: Json) -> Self {
        let name = member.pointer("/properties/name").and_then(Json::as_str);
        let code = name.and_then(|name| {
            if !crate::io::geojson::names_other_crs(&member) {
                return Some(WGS_84);
            }
            let mut parts = name.split([':', '/']);
            let is_of_epsg = parts.any(|part| part.eq_ignore_ascii_case("EPSG"));
            parts.next_back().filter(|_| is_of_epsg)?.parse().ok()
        });
        Self { member: Some(member), ..code.map_or_else(Self::default, Self::epsg) }
    }

    /// Creates the system of a definition in well-known text, with its number if the text equals Esri's definition of an EPSG
    /// system.
    #[must_use]
    pub fn of_wkt(wkt: String) -> Self {
        let code = epsg::code(&wkt);
        Self { wkt: Some(wkt), ..code.map_or_else(Self::default, Self::epsg) }
    }

    /// Returns true if it does not mean longitudes and latitudes on WGS 84.
    #[must_use]
    pub fn is_other(&self) -> bool {
        if let Some(member) = &self.member {
            return crate::io::geojson::names_other_crs(member);
        }
        match (&self.code, &self.wkt) {
            (Some((authority, code)), _) => !(authority.eq_ignore_ascii_case("EPSG") && *code == WGS_84),
            (None, Some(wkt)) => {
                let is_named = wkt.contains(ESRI_WGS_84) || wkt.contains("\"WGS 84\"");
                !(wkt.trim_start().starts_with("GEOG") && is_named)
            }
            (None, None) => self.projjson.is_some(),
        }
    }

    /// Returns the definition in the older form of well-known text: its own, or Esri's for its number.
    #[must_use]
    pub fn wkt1(&self) -> Option<String> {
        let is_wkt1 = |wkt: &&String| {
            let text = wkt.trim_start();
            WKT1.iter().any(|word| text.starts_with(word))
        };
        if let Some(wkt) = self.wkt.as_ref().filter(is_wkt1) {
            return Some(wkt.clone());
        }
        let is_of_epsg = |(authority, _): &&(String, i64)| authority.eq_ignore_ascii_case("EPSG");
        let code = self.code.as_ref().filter(is_of_epsg).map(|(_, code)| *code);
        epsg::wkt(code.or((!self.is_other()).then_some(WGS_84))?)
    }

    /// Returns the unit of lengths of a projected system, in the plural, if it is metres or feet. O(length of the definition).
    ///
    /// ```
    /// use twinedge_layers::Crs;
    ///
    /// let prj = "PROJCS[\"a\",GEOGCS[\"b\",UNIT[\"Degree\",0.0174532925199433]],UNIT[\"Meter\",1.0]]";
    /// assert_eq!(Crs::of_wkt(prj.to_owned()).unit(), Some("metres"));
    /// assert_eq!(Crs::of_wkt("GEOGCS[\"b\",UNIT[\"Degree\",0.0174532925199433]]".to_owned()).unit(), None);
    /// ```
    #[must_use]
    pub fn unit(&self) -> Option<&'static str> {
        let wkt = self.wkt.clone().or_else(|| self.wkt1())?;
        if !wkt.trim_start().starts_with("PROJ") {
            return None;
        }
        // The last unit applies to the projected coordinates.
        let (_, last) = wkt.rsplit_once("UNIT[\"")?;
        match last.split('"').next()?.to_lowercase().as_str() {
            "metre" | "meter" | "metres" | "meters" | "m" => Some("metres"),
            "us survey foot" | "us_survey_foot" | "foot_us" | "foot" | "feet" | "ft" => Some("feet"),
            _ => None,
        }
    }

    /// Returns the name for messages.
    #[must_use]
    pub fn name(&self) -> String {
        if let Some((authority, code)) = &self.code {
            return format!("{authority}:{code}");
        }
        let of_wkt = self.wkt.as_deref().and_then(|wkt| wkt.split('"').nth(1));
        let of_member = self.member.as_ref().and_then(|m| m.pointer("/properties/name")).and_then(|name| name.as_str());
        let of_projjson = self.projjson.as_ref().and_then(|json| json.get("name")).and_then(|name| name.as_str());
        of_member.or(of_wkt).or(of_projjson).unwrap_or("without name").to_owned()
    }
}
