//! Writing a layer as a new `GeoPackage`.

use super::super::crs::Crs;
use super::super::error::WriteError;
use super::super::model::unique;
use super::super::model::{Dimensions, Feature, Field, FieldKind, Geometry, Id, Layer, Value};
use super::super::wkb;
use super::{MAGIC, quoted};
use rusqlite::types::Value as Sql;
use rusqlite::{Connection, params, params_from_iter};
use std::collections::HashSet;
use std::path::Path;

impl From<rusqlite::Error> for WriteError {
    fn from(error: rusqlite::Error) -> Self {
        Self::Database { message: error.to_string() }
    }
}

/// "GPKG", and version 1.3.
const HEAD: &str = "PRAGMA application_id = 1196444487; PRAGMA user_version = 10300; PRAGMA journal_mode = OFF;";

const TABLES: &str = "
CREATE TABLE gpkg_spatial_ref_sys (
  srs_name TEXT NOT NULL, srs_id INTEGER NOT NULL PRIMARY KEY, organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT
);
INSERT INTO gpkg_spatial_ref_sys VALUES ('Undefined Cartesian SRS', -1, 'NONE', -1, 'undefined', NULL);
INSERT INTO gpkg_spatial_ref_sys VALUES ('Undefined geographic SRS', 0, 'NONE', 0, 'undefined', NULL);
CREATE TABLE gpkg_contents (
  table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE, description TEXT DEFAULT '',
  last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')),
  min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, srs_id INTEGER,
  CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id)
);
CREATE TABLE gpkg_geometry_columns (
  table_name TEXT NOT NULL, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL, srs_id INTEGER NOT NULL,
  z TINYINT NOT NULL, m TINYINT NOT NULL,
  CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name), CONSTRAINT uk_gc_table_name UNIQUE (table_name),
  CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name),
  CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id)
);";

const WGS_84: &str = "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563,\
AUTHORITY[\"EPSG\",\"7030\"]],AUTHORITY[\"EPSG\",\"6326\"]],PRIMEM[\"Greenwich\",0,AUTHORITY[\"EPSG\",\"8901\"]],\
UNIT[\"degree\",0.0174532925199433,AUTHORITY[\"EPSG\",\"9122\"]],AUTHORITY[\"EPSG\",\"4326\"]]";

/// The number of a reference system without its own number.
const OWN: i64 = 100_000;

/// Returns true if the ids can be primary keys, in whose order features are read: all features have one, and they are ascending
/// integers.
pub(crate) fn holds_ids(layer: &Layer) -> bool {
    layer.features.iter().all(|feature| key(feature).is_some()) && layer.features.is_sorted_by(|a, b| key(a) < key(b))
}

fn key(feature: &Feature) -> Option<i64> {
    match &feature.id {
        Some(Id::Number(number)) => number.as_i64(),
        _ => None,
    }
}

pub(crate) fn write(layer: &Layer, path: &Path) -> Result<(), WriteError> {
    let mut database = Connection::open(path)?;
    database.execute_batch(HEAD)?;
    let transaction = database.transaction()?;
    transaction.execute_batch(TABLES)?;
    let srs = write_crs(&transaction, layer.header.crs.as_ref())?;
    let stem = || path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    // Names with these prefixes are reserved by the format and by SQLite.
    let is_free =
        |name: &String| !["gpkg_", "rtree_", "sqlite_"].iter().any(|own| name.to_lowercase().starts_with(own));
    let table = layer.header.name.clone().or_else(stem).filter(|name| !name.is_empty() && is_free(name));
    let table = table.unwrap_or_else(|| "layer".to_owned());
    let fields = layer.fields();
    let mut taken = HashSet::new();
    let columns: Vec<String> = fields.iter().map(|field| unique(&field.name, &mut taken)).collect();
    let [key_column, geometry_column] = ["fid", "geom"].map(|name| unique(name, &mut taken));
    let mut definitions = vec![format!("{} INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL", quoted(&key_column))];
    let kind = geometry_kind(layer);
    definitions.push(format!("{} {kind}", quoted(&geometry_column)));
    definitions
        .extend(columns.iter().zip(&fields).map(|(name, field)| format!("{} {}", quoted(name), declared(field))));
    transaction.execute_batch(&format!("CREATE TABLE {} ({})", quoted(&table), definitions.join(", ")))?;
    let [x0, y0, x1, y1] = extent(layer).map_or([None; 4], |extent| extent.map(Some));
    transaction.execute(
        "INSERT INTO gpkg_contents (table_name, data_type, identifier, min_x, min_y, max_x, max_y, srs_id)
         VALUES (?1, 'features', ?1, ?2, ?3, ?4, ?5, ?6)",
        params![table, x0, y0, x1, y1, srs],
    )?;
    let [z, m] = dimension_flags(layer, kind == ANY);
    transaction.execute(
        "INSERT INTO gpkg_geometry_columns VALUES (?1, ?2, ?3, ?4, ?5, ?6)",
        params![table, geometry_column, kind, srs, z, m],
    )?;
    let names: Vec<String> = [&key_column, &geometry_column].into_iter().chain(&columns).map(|n| quoted(n)).collect();
    let marks = vec!["?"; names.len()].join(", ");
    let sql = format!("INSERT INTO {} ({}) VALUES ({marks})", quoted(&table), names.join(", "));
    {
        let mut insert = transaction.prepare(&sql)?;
        let keeps_ids = holds_ids(layer);
        for feature in &layer.features {
            let key = key(feature).filter(|_| keeps_ids).map_or(Sql::Null, Sql::Integer);
            let geometry = feature.geometry.as_ref().map_or(Sql::Null, |geometry| Sql::Blob(blob(geometry, srs)));
            let values = fields.iter().map(|field| feature.get(&field.name).map_or(Sql::Null, sql_value));
            insert.execute(params_from_iter([key, geometry].into_iter().chain(values)))?;
        }
    }
    transaction.commit()?;
    database.close().map_err(|(_, error)| error.into())
}

fn write_crs(database: &Connection, crs: Option<&Crs>) -> Result<i64, WriteError> {
    let insert = |name: &str, id: i64, organization: &str, code: i64, definition: &str| {
        let sql = "INSERT INTO gpkg_spatial_ref_sys VALUES (?1, ?2, ?3, ?4, ?5, NULL)";
        database.execute(sql, params![name, id, organization, code, definition])
    };
    // Every GeoPackage includes this system.
    let wgs_84 = 4326;
    insert("WGS 84 geodetic", wgs_84, "EPSG", wgs_84, WGS_84)?;
    let Some(crs) = crs else { return Ok(-1) };
    if !crs.is_other() {
        return Ok(wgs_84);
    }
    let wkt1 = crs.wkt1();
    let definition = wkt1.as_deref().or(crs.wkt.as_deref()).unwrap_or("undefined");
    let (id, organization, code) = match &crs.code {
        Some((authority, code)) if *code > 0 => (*code, authority.as_str(), *code),
        _ if crs.wkt.is_some() => (OWN, "NONE", OWN),
        _ => return Ok(-1),
    };
    insert(&crs.name(), id, organization, code, definition)?;
    Ok(id)
}

const fn declared(field: &Field) -> &'static str {
    match field.kind {
        FieldKind::Bool => "BOOLEAN",
        FieldKind::Integer => "INTEGER",
        FieldKind::Real => "REAL",
        FieldKind::Date => "DATE",
        FieldKind::DateTime => "DATETIME",
        FieldKind::Bytes => "BLOB",
        FieldKind::Text | FieldKind::Json => "TEXT",
    }
}

fn sql_value(value: &Value) -> Sql {
    match value {
        Value::Null => Sql::Null,
        Value::Bool(value) => Sql::Integer((*value).into()),
        Value::Integer(value) => Sql::Integer(*value),
        Value::Real(value) => Sql::Real(*value),
        Value::Text(text) | Value::Date(text) | Value::DateTime(text) => Sql::Text(text.clone()),
        Value::Bytes(bytes) => Sql::Blob(bytes.clone()),
        Value::Json(json) => Sql::Text(json.to_string()),
    }
}

fn geometries(layer: &Layer) -> impl Iterator<Item = &Geometry> {
    layer.features.iter().filter_map(|feature| feature.geometry.as_ref())
}

/// The kind that allows all geometries.
const ANY: &str = "GEOMETRY";

fn geometry_kind(layer: &Layer) -> String {
    let mut kinds = geometries(layer).map(|geometry| geometry.shape.name());
    let first = kinds.next();
    first.filter(|first| kinds.all(|kind| kind == *first)).unwrap_or(ANY).to_uppercase()
}

/// Returns flags for heights and measures: 0 if no geometry has them, 1 if all have, 2 if some have. Mixed kinds never get 1, as
/// in GDAL, whose users have no type for that.
fn dimension_flags(layer: &Layer, is_mixed: bool) -> [i64; 2] {
    let has_z = |d: Dimensions| matches!(d, Dimensions::Xyz | Dimensions::Xyzm);
    let has_m = |d: Dimensions| matches!(d, Dimensions::Xym | Dimensions::Xyzm);
    let flag = |has: &dyn Fn(Dimensions) -> bool| {
        let count = geometries(layer).filter(|geometry| has(geometry.dimensions)).count();
        if count == 0 {
            0
        } else if count == geometries(layer).count() && !is_mixed {
            1
        } else {
            2
        }
    };
    [flag(&has_z), flag(&has_m)]
}

fn extent(layer: &Layer) -> Option<[f64; 4]> {
    let mut extent: Option<[f64; 4]> = None;
    for geometry in geometries(layer) {
        geometry.shape.visit(&mut |p| {
            let [x0, y0, x1, y1] = extent.unwrap_or([p.x, p.y, p.x, p.y]);
            extent = Some([x0.min(p.x), y0.min(p.y), x1.max(p.x), y1.max(p.y)]);
        });
    }
    extent
}

/// Returns a geometry after its header, without an envelope.
fn blob(geometry: &Geometry, srs: i64) -> Vec<u8> {
    const LITTLE: u8 = 1;
    const EMPTY: u8 = 1 << 4;
    let mut bytes = MAGIC.to_vec();
    bytes.push(if geometry.shape.is_empty() { LITTLE | EMPTY } else { LITTLE });
    bytes.extend((srs as i32).to_le_bytes());
    wkb::append(geometry, &mut bytes);
    bytes
}
