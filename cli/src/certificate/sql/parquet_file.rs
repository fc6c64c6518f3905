//! A table in Parquet: 64-bit integers as differences (`DELTA_BINARY_PACKED`), which keeps links small without compression.

use super::tables::{Table, TableColumn};
use crate::status::Failure;
use parquet::basic::{Encoding, Repetition, Type as PhysicalType};
use parquet::data_type::Int64Type;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{Type, TypePtr};
use std::fs::File;
use std::path::Path;
use std::sync::Arc;

/// The rows of a row group: engines give each group to one thread.
const ROWS: usize = 1 << 17;

/// Writes a table with these keys and values as metadata.
pub(super) fn write(folder: &Path, mut table: Table<'_>, metadata: &[(&str, &str)]) -> Result<(), Failure> {
    let file = File::create(folder.join(format!("{}.parquet", table.name)))?;
    let mut writer = SerializedFileWriter::new(file, schema(&table)?, Arc::new(properties(metadata)))?;
    loop {
        let group: Vec<Vec<Option<i64>>> =
            table.columns.iter_mut().map(|column| column.values.by_ref().take(ROWS).collect()).collect();
        if group.iter().all(Vec::is_empty) {
            break;
        }
        let mut row_group = writer.next_row_group()?;
        for (column, values) in table.columns.iter().zip(&group) {
            if let Some(into) = row_group.next_column()? {
                write_column(into, column, values)?;
            }
        }
        row_group.close()?;
    }
    writer.close()?;
    Ok(())
}

fn schema(table: &Table<'_>) -> Result<TypePtr, ParquetError> {
    let field = |column: &TableColumn<'_>| {
        let repetition = if column.is_nullable { Repetition::OPTIONAL } else { Repetition::REQUIRED };
        let field = Type::primitive_type_builder(column.name, PhysicalType::INT64).with_repetition(repetition);
        field.build().map(Arc::new)
    };
    let fields = table.columns.iter().map(field).collect::<Result<_, _>>()?;
    Ok(Arc::new(Type::group_type_builder(table.name).with_fields(fields).build()?))
}

fn properties(metadata: &[(&str, &str)]) -> WriterProperties {
    let metadata = metadata.iter().map(|(key, value)| KeyValue::new(format!("twinedge.{key}"), (*value).to_owned()));
    WriterProperties::builder()
        .set_created_by(format!("twinedge {}", env!("CARGO_PKG_VERSION")))
        .set_dictionary_enabled(false)
        .set_encoding(Encoding::DELTA_BINARY_PACKED)
        .set_statistics_enabled(EnabledStatistics::None)
        .set_key_value_metadata(Some(metadata.collect()))
        .build()
}

fn write_column(
    mut into: SerializedColumnWriter<'_>,
    column: &TableColumn<'_>,
    values: &[Option<i64>],
) -> Result<(), ParquetError> {
    let numbers: Vec<i64> = values.iter().copied().flatten().collect();
    let levels: Option<Vec<i16>> =
        column.is_nullable.then(|| values.iter().map(|value| i16::from(value.is_some())).collect());
    into.typed::<Int64Type>().write_batch(&numbers, levels.as_deref(), None)?;
    into.close()
}
