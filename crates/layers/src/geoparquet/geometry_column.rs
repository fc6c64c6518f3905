//! The geometry column, as described by the metadata of a file.

use super::super::crs::Crs;
use super::super::error::Cause;
use super::super::model::{EDGES, Header};
use super::{GEO, SIDES, crs};
use parquet::basic::LogicalType;
use parquet::file::metadata::FileMetaData;
use parquet::schema::types::Type;
use serde_json::Value as Json;

pub(super) struct GeometryColumn {
    pub(super) name: String,
    /// The paths of the columns of the boxes of the geometries: least x, least y, greatest x, greatest y.
    pub(super) covering: Option<[Vec<String>; 4]>,
    pub(super) crs: Option<Crs>,
    /// The kind of edges, if they are not straight in the plane of the coordinates.
    pub(super) edges: Option<String>,
    /// True if the metadata declare that all geometries are points.
    pub(super) has_only_points: bool,
}

pub(super) fn entry_of(file: &FileMetaData, key: &str) -> Option<String> {
    let all = file.key_value_metadata().into_iter().flatten();
    all.into_iter().find(|entry| entry.key == key).and_then(|entry| entry.value.clone())
}

impl GeometryColumn {
    /// Finds the primary geometry column; without metadata of `GeoParquet`, the first one of Parquet's own type.
    pub(super) fn of_file(metadata: &FileMetaData) -> Result<Self, Cause> {
        let value = |key: &str| entry_of(metadata, key);
        let Some(text) = value(GEO) else {
            let columns = metadata.schema().get_fields().iter();
            let native = columns.into_iter().find_map(|column| Self::native(column, value));
            let nothing =
                "it has no column of geometries: neither metadata of GeoParquet nor a type GEOMETRY of Parquet";
            return native.ok_or_else(|| Cause::Invalid(nothing.to_owned()));
        };
        let geo: Json = serde_json::from_str(&text)
            .map_err(|error| Cause::Invalid(format!("the metadata \"{GEO}\" are not JSON: {error}")))?;
        let name = geo.get("primary_column").and_then(Json::as_str);
        let name = name.ok_or_else(|| Cause::Invalid(format!("the metadata \"{GEO}\" name no primary_column")))?;
        let column = geo.get("columns").and_then(|columns| columns.get(name));
        let column = column.ok_or_else(|| Cause::Invalid(format!("the metadata \"{GEO}\" do not describe {name}")))?;
        let text = |key: &str| column.get(key).and_then(Json::as_str);
        let encoding = text("encoding").unwrap_or_default();
        if !encoding.eq_ignore_ascii_case("WKB") {
            return Err(Cause::Invalid(format!(
                "the geometries are encoded as \"{encoding}\", and only WKB is read here: \
                 `ogr2ogr -f Parquet -lco GEOMETRY_ENCODING=WKB map.parquet FILE`"
            )));
        }
        Ok(Self {
            name: name.to_owned(),
            covering: column.pointer("/covering/bbox").and_then(covering),
            crs: match column.get("crs") {
                None => crs::of_native(None, |_| None),
                Some(Json::Null) => None,
                // Not in the standard, but written by some programs.
                Some(Json::String(text)) => crs::of_native(Some(text), value),
                Some(json) => Some(crs::of_projjson(json)),
            },
            edges: text(EDGES).filter(|edges| *edges != "planar").map(str::to_owned),
            has_only_points: column.get("geometry_types").and_then(Json::as_array).is_some_and(|all| are_points(all)),
        })
    }

    fn native(column: &Type, metadata: impl Fn(&str) -> Option<String>) -> Option<Self> {
        let (text, edges) = match column.get_basic_info().logical_type_ref()? {
            LogicalType::Geometry(geometry) => (&geometry.crs, None),
            LogicalType::Geography(geography) => {
                let algorithm = geography.algorithm.map_or_else(|| "spherical".to_owned(), |one| one.to_string());
                (&geography.crs, Some(algorithm.to_lowercase()))
            }
            _ => return None,
        };
        let name = column.name().to_owned();
        let crs = crs::of_native(text.as_deref(), metadata);
        Some(Self { name, covering: None, crs, edges, has_only_points: false })
    }

    /// Returns everything in the file except features and columns.
    pub(super) fn header(&self) -> Header {
        let edges = self.edges.as_ref().map(|edges| (EDGES.to_owned(), edges.as_str().into()));
        Header { crs: self.crs.clone(), members: edges.into_iter().collect(), ..Header::default() }
    }
}

/// Returns true if these type names are all of points, with any dimensions, and at least one is given.
fn are_points(names: &[Json]) -> bool {
    let name = |name: &Json| name.as_str().and_then(|name| name.split(' ').next().map(str::to_owned));
    !names.is_empty() && names.iter().all(|one| matches!(name(one).as_deref(), Some("Point" | "MultiPoint")))
}

fn covering(boxes: &Json) -> Option<[Vec<String>; 4]> {
    let path = |side: &str| {
        let path = boxes.get(side)?.as_array()?.iter();
        path.map(|name| name.as_str().map(str::to_owned)).collect::<Option<Vec<_>>>().filter(|path| !path.is_empty())
    };
    let [x0, y0, x1, y1] = SIDES.map(path);
    Some([x0?, y0?, x1?, y1?])
}
