//! Writing `GeoParquet` 1.1, in the order of the features, with a column of boxes.

use super::super::error::WriteError;
use super::super::loss::{Loss, absent};
use super::super::model::unique;
use super::super::model::{Dimensions, EDGES, Feature, Field, FieldKind, Geometry, Layer, Value, kind_of};
use super::super::wkb;
use super::ids::{self, id_kind};
use super::{GEO, SIDES, crs, moment};
use parquet::basic::{Compression, LogicalType, Repetition, TimeUnit, Type as Physical, ZstdLevel};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int32Type, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{ColumnPath, Type, TypePtr};
use serde_json::{Value as Json, json};
use std::collections::{BTreeSet, HashSet};
use std::fs::File;
use std::io;
use std::path::Path;
use std::sync::Arc;

/// The number of rows per row group: readers of a region skip whole groups by their boxes.
const ROWS: usize = 1 << 16;

impl From<ParquetError> for WriteError {
    fn from(error: ParquetError) -> Self {
        match error {
            ParquetError::External(error) => Self::Io(io::Error::other(error)),
            error => Self::Io(io::Error::other(error.to_string())),
        }
    }
}

/// Returns the columns as written: a column with values of another type becomes text.
fn columns(layer: &Layer) -> Vec<(Field, FieldKind)> {
    let of_field = |field: Field| {
        let values = || layer.features.iter().filter_map(|feature| feature.get(&field.name));
        let has_both = field.kind == FieldKind::DateTime && {
            let clocks: BTreeSet<bool> = values().filter_map(|value| Some(moment_of(value)?.1)).collect();
            clocks.len() > 1
        };
        let kind =
            if !has_both && values().all(|value| fits(field.kind, value)) { field.kind } else { FieldKind::Text };
        (field, kind)
    };
    layer.fields().into_iter().map(of_field).collect()
}

/// Returns true if a column of a type can hold a value unchanged.
fn fits(kind: FieldKind, value: &Value) -> bool {
    match (kind, value) {
        (FieldKind::Date, Value::Date(text)) => moment::days(text).is_some(),
        (FieldKind::DateTime, value @ Value::DateTime(_)) => moment_of(value).is_some(),
        (FieldKind::Bool, Value::Bool(_))
        | (FieldKind::Integer, Value::Integer(_))
        | (FieldKind::Real, Value::Real(_) | Value::Integer(_))
        | (FieldKind::Bytes, Value::Bytes(_))
        | (FieldKind::Text, Value::Text(_))
        | (FieldKind::Json, Value::Json(_))
        | (_, Value::Null) => true,
        _ => false,
    }
}

/// Returns the microseconds of a moment, and whether it is in UTC.
fn moment_of(value: &Value) -> Option<(i64, bool)> {
    match value {
        Value::DateTime(text) => moment::microseconds(text),
        _ => None,
    }
}

/// Adds losses other than of geometries and the reference system.
pub(crate) fn losses(layer: &Layer, found: &mut Vec<Loss>) {
    let columns = columns(layer);
    for (field, kind) in &columns {
        let values = layer.features.iter().filter_map(|feature| feature.get(&field.name));
        let from = values.map(|value| kind_of(value).unwrap_or(*kind)).find(|from| from != kind);
        // Integers in a column of numbers become numbers.
        if let Some(from) = from.filter(|from| (*from, *kind) != (FieldKind::Integer, FieldKind::Real)) {
            found.push(Loss::Type { column: field.name.to_string(), from, to: *kind });
        }
    }
    match absent(layer, columns.len()) {
        0 => {}
        count => found.push(Loss::Absent(count)),
    }
}

pub(crate) fn write(layer: &Layer, path: &Path) -> Result<(), WriteError> {
    let columns = columns(layer);
    let mut taken: HashSet<String> = columns.iter().map(|(field, _)| field.name.to_lowercase()).collect();
    let [geometry, covering] = ["geometry", "bbox"].map(|name| unique(name, &mut taken));
    let ids = id_kind(layer).map(|kind| (unique(ids::usual_name(kind), &mut taken), kind));
    let schema = schema(layer, &columns, ids.as_ref(), [&geometry, &covering])?;
    let of_geometries = KeyValue::new(GEO.to_owned(), metadata(layer, &geometry, &covering).to_string());
    let of_ids = ids.as_ref().map(|(name, kind)| ids::metadata(*kind, name));
    let metadata = [of_geometries].into_iter().chain(of_ids).collect();
    let properties = WriterProperties::builder()
        .set_created_by(format!("twinedge {}", env!("CARGO_PKG_VERSION")))
        .set_compression(Compression::ZSTD(ZstdLevel::default()))
        .set_column_dictionary_enabled(ColumnPath::from(geometry.as_str()), false)
        .set_column_statistics_enabled(ColumnPath::from(geometry.as_str()), EnabledStatistics::None)
        .set_key_value_metadata(Some(metadata))
        .build();
    let mut writer = SerializedFileWriter::new(File::create(path)?, schema, Arc::new(properties))?;
    for features in layer.features.chunks(ROWS) {
        let mut group = writer.next_row_group()?;
        match &ids {
            Some((_, FieldKind::Integer)) => column::<Int64Type, _>(&mut group, features, ids::number)?,
            Some(_) => column::<ByteArrayType, _>(&mut group, features, ids::text)?,
            None => {}
        }
        for (field, kind) in &columns {
            attribute(&mut group, features, &field.name, *kind)?;
        }
        column::<ByteArrayType, _>(&mut group, features, |feature| {
            let mut bytes = Vec::new();
            wkb::append(feature.geometry.as_ref()?, &mut bytes);
            Some(bytes.into())
        })?;
        let boxes: Vec<Option<[f64; 4]>> = features.iter().map(|feature| extent(feature.geometry.iter())).collect();
        for side in 0..SIDES.len() {
            column::<DoubleType, _>(&mut group, &boxes, |one| one.map(|sides| sides[side]))?;
        }
        group.close()?;
    }
    writer.close()?;
    Ok(())
}

fn schema(
    layer: &Layer,
    columns: &[(Field, FieldKind)],
    ids: Option<&(String, FieldKind)>,
    [geometry, covering]: [&str; 2],
) -> Result<TypePtr, ParquetError> {
    let primitive = |name: &str, physical, logical| {
        let builder = Type::primitive_type_builder(name, physical).with_repetition(Repetition::OPTIONAL);
        builder.with_logical_type(logical).build().map(Arc::new)
    };
    let of_field = |(field, kind): &(Field, FieldKind)| {
        let (physical, logical) = match kind {
            FieldKind::Bool => (Physical::BOOLEAN, None),
            FieldKind::Integer => (Physical::INT64, None),
            FieldKind::Real => (Physical::DOUBLE, None),
            FieldKind::Text => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
            FieldKind::Date => (Physical::INT32, Some(LogicalType::Date)),
            FieldKind::DateTime => {
                let moments = layer.features.iter().filter_map(|feature| moment_of(feature.get(&field.name)?));
                let is_utc = moments.map(|(_, is_utc)| is_utc).next().unwrap_or(true);
                (Physical::INT64, Some(LogicalType::timestamp(is_utc, TimeUnit::MICROS)))
            }
            FieldKind::Bytes => (Physical::BYTE_ARRAY, None),
            FieldKind::Json => (Physical::BYTE_ARRAY, Some(LogicalType::Json)),
        };
        primitive(&field.name, physical, logical)
    };
    let of_ids = ids.map(|(name, kind)| match kind {
        FieldKind::Integer => primitive(name, Physical::INT64, None),
        _ => primitive(name, Physical::BYTE_ARRAY, Some(LogicalType::String)),
    });
    let mut fields = of_ids.into_iter().chain(columns.iter().map(of_field)).collect::<Result<Vec<_>, _>>()?;
    fields.push(primitive(geometry, Physical::BYTE_ARRAY, None)?);
    let side = |name: &&str| {
        Type::primitive_type_builder(name, Physical::DOUBLE).with_repetition(Repetition::REQUIRED).build().map(Arc::new)
    };
    let sides = SIDES.iter().map(side).collect::<Result<Vec<_>, _>>()?;
    let of_boxes = Type::group_type_builder(covering).with_repetition(Repetition::OPTIONAL).with_fields(sides);
    fields.push(Arc::new(of_boxes.build()?));
    Ok(Arc::new(Type::group_type_builder("schema").with_fields(fields).build()?))
}

fn metadata(layer: &Layer, geometry: &str, covering: &str) -> Json {
    let geometries = || layer.features.iter().filter_map(|feature| feature.geometry.as_ref());
    let is_flat = geometries().all(|one| one.dimensions == Dimensions::Xy);
    let has_measures = geometries().any(|one| matches!(one.dimensions, Dimensions::Xym | Dimensions::Xyzm));
    let name = |one: &Geometry| match one.dimensions {
        Dimensions::Xyz => format!("{} Z", one.shape.name()),
        _ => one.shape.name().to_owned(),
    };
    // Measures have no name in the list, and an empty list states nothing.
    let kinds: BTreeSet<String> = if has_measures { BTreeSet::new() } else { geometries().map(name).collect() };
    let of_side = |side: &str| json!([covering, side]);
    let boxes = json!({"xmin": of_side(SIDES[0]), "ymin": of_side(SIDES[1]), "xmax": of_side(SIDES[2]), "ymax": of_side(SIDES[3])});
    let mut column = json!({"encoding": "WKB", "geometry_types": kinds, "covering": {"bbox": boxes}});
    if let Some(crs) = crs::member(layer.header.crs.as_ref()) {
        column["crs"] = crs;
    }
    if let Some(extent) = extent(geometries()).filter(|_| is_flat) {
        column["bbox"] = json!(extent);
    }
    if let Some(edges) = layer.header.members.get(EDGES) {
        column[EDGES] = edges.clone();
    }
    json!({"version": "1.1.0", "primary_column": geometry, "columns": {geometry: column}})
}

/// Returns the least and greatest coordinates of geometries; `None` without a position.
fn extent<'a>(geometries: impl Iterator<Item = &'a Geometry>) -> Option<[f64; 4]> {
    let mut extent: Option<[f64; 4]> = None;
    for geometry in geometries {
        geometry.shape.visit(&mut |p| {
            let [x0, y0, x1, y1] = extent.unwrap_or([p.x, p.y, p.x, p.y]);
            extent = Some([x0.min(p.x), y0.min(p.y), x1.max(p.x), y1.max(p.y)]);
        });
    }
    extent
}

fn attribute(
    group: &mut SerializedRowGroupWriter<'_, File>,
    features: &[Feature],
    name: &str,
    kind: FieldKind,
) -> Result<(), ParquetError> {
    let text = |feature: &Feature| Some(ByteArray::from(feature.get(name)?.text()?.into_bytes()));
    match kind {
        FieldKind::Bool => column::<BoolType, _>(group, features, |feature| match feature.get(name)? {
            Value::Bool(value) => Some(*value),
            _ => None,
        }),
        FieldKind::Integer => column::<Int64Type, _>(group, features, |feature| match feature.get(name)? {
            Value::Integer(number) => Some(*number),
            _ => None,
        }),
        FieldKind::Real => column::<DoubleType, _>(group, features, |feature| match feature.get(name)? {
            Value::Real(number) => Some(*number),
            Value::Integer(number) => Some(*number as f64),
            _ => None,
        }),
        FieldKind::Date => column::<Int32Type, _>(group, features, |feature| match feature.get(name)? {
            Value::Date(text) => moment::days(text),
            _ => None,
        }),
        FieldKind::DateTime => {
            column::<Int64Type, _>(group, features, |feature| Some(moment_of(feature.get(name)?)?.0))
        }
        FieldKind::Bytes => column::<ByteArrayType, _>(group, features, |feature| match feature.get(name)? {
            Value::Bytes(bytes) => Some(bytes.clone().into()),
            _ => None,
        }),
        FieldKind::Text | FieldKind::Json => column::<ByteArrayType, _>(group, features, text),
    }
}

/// Writes the next column of a row group: one value per row, or null.
fn column<T: DataType, R>(
    group: &mut SerializedRowGroupWriter<'_, File>,
    rows: &[R],
    value: impl Fn(&R) -> Option<T::T>,
) -> Result<(), ParquetError> {
    let values: Vec<Option<T::T>> = rows.iter().map(value).collect();
    let levels: Vec<i16> = values.iter().map(|value| i16::from(value.is_some())).collect();
    let values: Vec<T::T> = values.into_iter().flatten().collect();
    if let Some(mut into) = group.next_column()? {
        into.typed::<T>().write_batch(&values, Some(&levels), None)?;
        into.close()?;
    }
    Ok(())
}
