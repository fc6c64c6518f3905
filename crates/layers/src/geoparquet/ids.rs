//! The column of the ids of features, as named by the metadata of a file.
//!
//! `GeoParquet` leaves ids to the writer. GDAL names an integer column in its own metadata, as done here. Text columns, which
//! GDAL does not accept as ids, are named in separate metadata.

use super::super::model::{Feature, FieldKind, Id, Layer, Value};
use parquet::data_type::ByteArray;
use parquet::file::metadata::KeyValue;
use serde_json::{Value as Json, json};

const GDAL: &str = "gdal:schema";

/// The key of the metadata that name a text column of ids.
const TEXTS: &str = "twinedge:id";

/// Returns the type of a column that holds the ids of all features; `None` if there is no such type, or no id.
pub(crate) fn id_kind(layer: &Layer) -> Option<FieldKind> {
    let mut kinds = layer.features.iter().filter_map(|feature| feature.id.as_ref()).map(|id| match id {
        Id::Text(_) => Some(FieldKind::Text),
        Id::Number(number) => number.as_i64().map(|_| FieldKind::Integer),
    });
    let first = kinds.next().flatten()?;
    kinds.all(|kind| kind == Some(first)).then_some(first)
}

/// Returns the usual name of a column of ids of a type.
pub(super) const fn usual_name(kind: FieldKind) -> &'static str {
    match kind {
        FieldKind::Integer => "fid",
        _ => "id",
    }
}

pub(super) fn metadata(kind: FieldKind, column: &str) -> KeyValue {
    match kind {
        FieldKind::Integer => KeyValue::new(GDAL.to_owned(), json!({"fid": column, "columns": {}}).to_string()),
        _ => KeyValue::new(TEXTS.to_owned(), column.to_owned()),
    }
}

/// Returns the column named by the metadata, which are looked up by key.
pub(super) fn named(metadata: impl Fn(&str) -> Option<String>) -> Option<String> {
    let of_gdal = || {
        let schema: Json = serde_json::from_str(&metadata(GDAL)?).ok()?;
        Some(schema.get("fid")?.as_str()?.to_owned())
    };
    metadata(TEXTS).or_else(of_gdal).filter(|name| !name.is_empty())
}

/// Converts a value to an id; `None` for null and for other types.
pub(super) fn of_value(value: Value) -> Option<Id> {
    match value {
        Value::Integer(number) => Some(Id::Number(number.into())),
        Value::Text(text) => Some(Id::Text(text)),
        _ => None,
    }
}

pub(super) fn number(feature: &Feature) -> Option<i64> {
    match feature.id.as_ref()? {
        Id::Number(number) => number.as_i64(),
        Id::Text(_) => None,
    }
}

pub(super) fn text(feature: &Feature) -> Option<ByteArray> {
    match feature.id.as_ref()? {
        Id::Text(text) => Some(text.as_str().into()),
        Id::Number(_) => None,
    }
}
