//! Reading a layer of a `GeoPackage`. The file is opened read-only, and its schema is not trusted.

use super::super::crs::Crs;
use super::super::each::Each;
use super::super::error::{Cause, Place, ReadError};
use super::super::model::{Feature, Field, FieldKind, Geometry, Header, Id, Value};
use super::super::wkb;
use super::{MAGIC, quoted};
use crate::io::Format;
use rusqlite::config::DbConfig;
use rusqlite::types::ValueRef;
use rusqlite::{Connection, OpenFlags, OptionalExtension};
use std::path::Path;

impl From<rusqlite::Error> for ReadError {
    fn from(error: rusqlite::Error) -> Self {
        Self::Database { message: error.to_string() }
    }
}

/// Reads the layer of this name, or the only one, in order of its primary key; a view in its own order.
pub(crate) fn read(path: &Path, layer: Option<&str>, each: &mut Each<'_>) -> Result<Header, ReadError> {
    let flags = OpenFlags::SQLITE_OPEN_READ_ONLY | OpenFlags::SQLITE_OPEN_NO_MUTEX;
    let database = Connection::open_with_flags(path, flags)?;
    database.set_db_config(DbConfig::SQLITE_DBCONFIG_TRUSTED_SCHEMA, false)?;
    database.set_db_config(DbConfig::SQLITE_DBCONFIG_DEFENSIVE, true)?;
    let table = table(&database, layer)?;
    let (geometry, srs): (String, i64) = database
        .query_row("SELECT column_name, srs_id FROM gpkg_geometry_columns WHERE table_name = ?1", [&table], |row| {
            Ok((row.get(0)?, row.get(1)?))
        })
        .optional()?
        .ok_or_else(|| {
            let cause = Cause::Invalid(format!("the table {table} has no geometry column"));
            ReadError::Content { format: Format::GeoPackage, place: Place::Header, cause }
        })?;
    let (key, fields) = columns(&database, &table, &geometry)?;
    let (key, order) = match key {
        Some(key) => (quoted(&key), " ORDER BY 1"),
        None if has_row_ids(&database, &table)? => ("rowid".to_owned(), " ORDER BY 1"),
        None => ("NULL".to_owned(), ""),
    };
    let mut selected = vec![key, quoted(&geometry)];
    selected.extend(fields.iter().map(|field| quoted(&field.name)));
    let sql = format!("SELECT {} FROM {}{order}", selected.join(", "), quoted(&table));
    let mut statement = database.prepare(&sql)?;
    let mut rows = statement.query([])?;
    let mut number = 0;
    while let Some(row) = rows.next()? {
        let failed = |cause| ReadError::Content { format: Format::GeoPackage, place: Place::Feature(number), cause };
        let id = match row.get_ref(0)? {
            ValueRef::Integer(id) => Some(Id::Number(id.into())),
            _ => None,
        };
        let geometry = match row.get_ref(1)? {
            ValueRef::Null => None,
            ValueRef::Blob(bytes) => Some(parse(bytes).map_err(failed)?),
            _ => return Err(failed(Cause::Invalid("the geometry is not of the type BLOB".to_owned()))),
        };
        let mut attributes = Vec::with_capacity(fields.len());
        for (field, column) in fields.iter().zip(2..) {
            attributes.push((field.name.clone(), value(field.kind, row.get_ref(column)?).map_err(failed)?));
        }
        each(Feature { id, geometry, attributes, ..Feature::default() })?;
        number += 1;
    }
    Ok(Header { name: Some(table), crs: crs(&database, srs)?, fields, ..Header::default() })
}

fn table(database: &Connection, wanted: Option<&str>) -> Result<String, ReadError> {
    let mut statement =
        database.prepare("SELECT table_name FROM gpkg_contents WHERE data_type = 'features' ORDER BY table_name")?;
    let layers: Vec<String> = statement.query_map([], |row| row.get(0))?.collect::<Result<_, _>>()?;
    let found = match (wanted, &layers[..]) {
        (None, [only]) => Some(only),
        (None, _) => None,
        (Some(wanted), layers) => layers.iter().find(|layer| *layer == wanted),
    };
    found.cloned().ok_or_else(|| ReadError::Layers { wanted: wanted.map(str::to_owned), layers: layers.clone() })
}

/// Returns true if the rows have row ids, which views and tables `WITHOUT ROWID` don't.
fn has_row_ids(database: &Connection, table: &str) -> Result<bool, ReadError> {
    let sql = "SELECT 1 FROM pragma_table_list(?1) WHERE schema = 'main' AND (type = 'view' OR wr)";
    Ok(database.query_row(sql, [table], |_| Ok(())).optional()?.is_none())
}

/// Returns the primary key, and the columns other than the key and the geometry.
fn columns(database: &Connection, table: &str, geometry: &str) -> Result<(Option<String>, Vec<Field>), ReadError> {
    let mut statement = database.prepare("SELECT name, type, pk FROM pragma_table_info(?1)")?;
    let mut rows = statement.query([table])?;
    let (mut key, mut fields) = (None, Vec::new());
    while let Some(row) = rows.next()? {
        let (name, declared, place): (String, String, i64) = (row.get(0)?, row.get(1)?, row.get(2)?);
        if place == 1 && declared.eq_ignore_ascii_case("INTEGER") {
            key = Some(name);
        } else if !name.eq_ignore_ascii_case(geometry) {
            let (kind, width) = kind(&declared);
            fields.push(Field { name: name.into(), kind, width, decimals: None });
        }
    }
    Ok((key, fields))
}

/// Returns the type of a column by its declaration, and the greatest number of characters.
fn kind(declared: &str) -> (FieldKind, Option<usize>) {
    let declared = declared.to_ascii_uppercase();
    let (name, size) = declared.split_once('(').unwrap_or((&declared, ""));
    let kind = match name.trim() {
        "BOOLEAN" => FieldKind::Bool,
        "TINYINT" | "SMALLINT" | "MEDIUMINT" | "INT" | "INTEGER" | "BIGINT" => FieldKind::Integer,
        "FLOAT" | "DOUBLE" | "REAL" | "NUMERIC" => FieldKind::Real,
        "BLOB" => FieldKind::Bytes,
        "DATE" => FieldKind::Date,
        "DATETIME" => FieldKind::DateTime,
        _ => FieldKind::Text,
    };
    (kind, size.trim_end_matches(')').trim().parse().ok())
}

/// Converts a value to its declared type if possible, as `SQLite` permits any value in any column.
fn value(kind: FieldKind, value: ValueRef<'_>) -> Result<Value, Cause> {
    Ok(match value {
        ValueRef::Null => Value::Null,
        ValueRef::Integer(number @ 0..=1) if kind == FieldKind::Bool => Value::Bool(number == 1),
        ValueRef::Integer(number) => Value::Integer(number),
        ValueRef::Real(number) => Value::Real(number),
        ValueRef::Text(bytes) => {
            let text = std::str::from_utf8(bytes).map_err(|_| Cause::Charset("UTF-8".to_owned()))?.to_owned();
            match kind {
                FieldKind::Date => Value::Date(text),
                FieldKind::DateTime => Value::DateTime(text),
                _ => Value::Text(text),
            }
        }
        ValueRef::Blob(bytes) => Value::Bytes(bytes.to_vec()),
    })
}

fn crs(database: &Connection, srs: i64) -> Result<Option<Crs>, ReadError> {
    // −1 and 0 stand for unknown systems.
    if srs <= 0 {
        return Ok(None);
    }
    let sql = "SELECT organization, organization_coordsys_id, definition FROM gpkg_spatial_ref_sys WHERE srs_id = ?1";
    let found: Option<(String, i64, String)> =
        database.query_row(sql, [srs], |row| Ok((row.get(0)?, row.get(1)?, row.get(2)?))).optional()?;
    Ok(found.map(|(authority, code, wkt)| Crs {
        code: Some((authority.to_ascii_uppercase(), code)),
        wkt: Some(wkt).filter(|wkt| !wkt.is_empty() && wkt != "undefined"),
        ..Crs::default()
    }))
}

/// Reads a geometry: the header, and then well-known binary.
pub(super) fn parse(bytes: &[u8]) -> Result<Geometry, Cause> {
    const EXTENDED: u8 = 1 << 5;
    let rest = bytes.strip_prefix(&MAGIC).ok_or_else(|| Cause::Invalid("the geometry has no header".to_owned()))?;
    let (flags, rest) = rest.split_first().ok_or(Cause::Truncated("the header of a geometry"))?;
    if flags & EXTENDED != 0 {
        return Err(Cause::Invalid("the geometry is of an extended type".to_owned()));
    }
    let envelope = match flags >> 1 & 7 {
        0 => 0,
        1 => 32,
        2 | 3 => 48,
        4 => 64,
        other => return Err(Cause::Invalid(format!("{other} is no kind of envelope"))),
    };
    let body = rest.get(4 + envelope..).ok_or(Cause::Truncated("the header of a geometry"))?;
    Ok(wkb::parse(body)?.0)
}
