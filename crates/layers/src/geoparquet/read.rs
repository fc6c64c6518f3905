//! Reading `GeoParquet`, row by row.
//!
//! The crate `parquet` panics on some damaged files. These panics are caught and converted to errors.

use super::super::each::Each;
use super::super::error::{Cause, Place, ReadError};
use super::super::model::{Feature, Field, FieldKind, Geometry, Header};
use super::super::wkb;
use super::geometry_column::{GeometryColumn, entry_of};
use super::{ids, value};
use crate::io::Format;
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field as Cell;
use parquet::record::reader::RowIter;
use parquet::schema::types::{Type, TypePtr};
use std::fs::File;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;

pub(super) fn content(place: Place, cause: Cause) -> ReadError {
    ReadError::Content { format: Format::GeoParquet, place, cause }
}

/// Runs a call of the crate, reporting errors at a place.
pub(super) fn ask<T>(place: Place, question: impl FnOnce() -> Result<T, ParquetError>) -> Result<T, ReadError> {
    let answer = catch_unwind(AssertUnwindSafe(question));
    let answer = answer.unwrap_or_else(|_| Err(ParquetError::General("the file is damaged".to_owned())));
    answer.map_err(|error| {
        const OFF: &str = "Disabled feature at compile time: ";
        let message = error.to_string();
        let compression = message.split_once(OFF).map(|(_, name)| {
            format!(
                "it is compressed by {name}, which is not read here: \
                 `ogr2ogr -f Parquet -lco COMPRESSION=ZSTD map.parquet FILE`"
            )
        });
        content(place, Cause::Invalid(compression.unwrap_or(message)))
    })
}

struct Column {
    of_file: TypePtr,
    role: Role,
}

#[derive(PartialEq)]
enum Role {
    Geometry,
    Id,
    Attribute(Arc<str>),
}

/// Reads the features, passing each to `each`. Memory O(pages of a row group).
pub(crate) fn read(path: &Path, each: &mut Each<'_>) -> Result<Header, ReadError> {
    let in_header = |cause| content(Place::Header, cause);
    let file = File::open(path)?;
    let reader = ask(Place::Header, || SerializedFileReader::new(file))?;
    let metadata = reader.metadata().file_metadata();
    let geometries = GeometryColumn::of_file(metadata).map_err(in_header)?;
    let schema = metadata.schema();
    let ids = ids::named(|key| entry_of(metadata, key));
    let columns = columns(schema, &geometries, ids.as_deref()).map_err(in_header)?;
    let fields = columns.iter().filter_map(|column| {
        let Role::Attribute(name) = &column.role else { return None };
        let name = name.clone();
        Some(Field { name, kind: value::kind(&column.of_file), width: None, decimals: None })
    });
    let header = Header { fields: fields.collect(), ..geometries.header() };
    let of_file = columns.iter().map(|column| column.of_file.clone()).collect();
    let wanted = Type::group_type_builder(schema.name()).with_fields(of_file).build();
    let wanted = wanted.map_err(|error| in_header(Cause::Invalid(error.to_string())))?;
    let mut number = 0;
    for group in 0..reader.num_row_groups() {
        let place = Place::Feature(number);
        let group = ask(place, || reader.get_row_group(group))?;
        let mut rows = ask(place, || RowIter::from_row_group(Some(wanted.clone()), &*group))?;
        loop {
            let place = Place::Feature(number);
            let Some(row) = ask(place, || rows.next().transpose())? else { break };
            each(feature(row.into_columns(), &columns).map_err(|cause| content(place, cause))?)?;
            number += 1;
        }
    }
    Ok(header)
}

/// Returns the columns to read: all except the boxes.
fn columns(schema: &Type, geometries: &GeometryColumn, ids: Option<&str>) -> Result<Vec<Column>, Cause> {
    let mut columns = Vec::new();
    for of_file in schema.get_fields() {
        let name = of_file.name();
        if geometries.covering.as_ref().is_some_and(|[path, ..]| path[0] == name) {
            continue;
        }
        if value::is_interval(of_file) {
            return Err(Cause::Invalid(format!("the column {name} has intervals of time, which are not read here")));
        }
        let role = if name == geometries.name {
            Role::Geometry
        } else if ids == Some(name) && matches!(value::kind(of_file), FieldKind::Integer | FieldKind::Text) {
            Role::Id
        } else {
            Role::Attribute(name.into())
        };
        columns.push(Column { of_file: of_file.clone(), role });
    }
    if columns.iter().all(|column| column.role != Role::Geometry) {
        return Err(Cause::Invalid(format!("it has no column {}, where the geometries should be", geometries.name)));
    }
    Ok(columns)
}

fn feature(row: Vec<(String, Cell)>, columns: &[Column]) -> Result<Feature, Cause> {
    let mut feature = Feature::default();
    for ((_, cell), column) in row.into_iter().zip(columns) {
        match &column.role {
            Role::Attribute(name) => feature.attributes.push((name.clone(), value::value(cell, &column.of_file)?)),
            Role::Id => feature.id = ids::of_value(value::value(cell, &column.of_file)?),
            Role::Geometry => feature.geometry = geometry(cell)?,
        }
    }
    feature.attributes.shrink_to_fit();
    Ok(feature)
}

pub(super) fn geometry(cell: Cell) -> Result<Option<Geometry>, Cause> {
    match cell {
        Cell::Null => Ok(None),
        Cell::Bytes(bytes) => Ok(Some(wkb::parse(bytes.data())?.0)),
        _ => Err(Cause::Invalid("a geometry that is not made of bytes".to_owned())),
    }
}
