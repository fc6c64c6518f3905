//! Tables of integers in Parquet, without compression: 64-bit integers as differences (`DELTA_BINARY_PACKED`), which makes links small.

use super::{Format, WriteError};
use std::path::Path;

/// A column of a table of integers, from the first row to the last.
pub struct IntegerColumn<'a> {
    /// Its name.
    pub name: &'static str,
    /// True if values may be missing.
    pub is_nullable: bool,
    /// The values.
    pub values: Box<dyn Iterator<Item = Option<i64>> + 'a>,
}

impl std::fmt::Debug for IntegerColumn<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("IntegerColumn").field("name", &self.name).finish_non_exhaustive()
    }
}

/// Writes a table of columns of equal length, with these keys and values as metadata (`twinedge.` precedes each key). O(values).
///
/// # Errors
/// The file cannot be written; [`WriteError::FeatureOff`] without the feature `geoparquet`.
pub fn write_integers(
    path: &Path,
    name: &str,
    columns: &mut [IntegerColumn<'_>],
    metadata: &[(&str, &str)],
) -> Result<(), WriteError> {
    writes_integers()?;
    #[cfg(feature = "geoparquet")]
    in_parquet::write(path, name, columns, metadata).map_err(std::io::Error::other)?;
    #[cfg(not(feature = "geoparquet"))]
    let _ = (path, name, columns, metadata);
    Ok(())
}

/// Succeeds if this build writes tables of integers: to ask before a folder is cleared for them. O(1).
///
/// # Errors
/// [`WriteError::FeatureOff`] without the feature `geoparquet`.
pub const fn writes_integers() -> Result<(), WriteError> {
    if cfg!(feature = "geoparquet") { Ok(()) } else { Err(WriteError::FeatureOff(Format::GeoParquet)) }
}

#[cfg(feature = "geoparquet")]
mod in_parquet {
    use super::IntegerColumn;
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

    pub(super) fn write(
        path: &Path,
        name: &str,
        columns: &mut [IntegerColumn<'_>],
        metadata: &[(&str, &str)],
    ) -> Result<(), ParquetError> {
        let mut writer =
            SerializedFileWriter::new(File::create(path)?, schema(name, columns)?, Arc::new(properties(metadata)))?;
        loop {
            let group: Vec<Vec<Option<i64>>> =
                columns.iter_mut().map(|column| column.values.by_ref().take(ROWS).collect()).collect();
            if group.iter().all(Vec::is_empty) {
                break;
            }
            let mut row_group = writer.next_row_group()?;
            for (column, values) in columns.iter().zip(&group) {
                if let Some(into) = row_group.next_column()? {
                    write_column(into, column, values)?;
                }
            }
            row_group.close()?;
        }
        writer.close()?;
        Ok(())
    }

    fn schema(name: &str, columns: &[IntegerColumn<'_>]) -> Result<TypePtr, ParquetError> {
        let field = |column: &IntegerColumn<'_>| {
            let repetition = if column.is_nullable { Repetition::OPTIONAL } else { Repetition::REQUIRED };
            let field = Type::primitive_type_builder(column.name, PhysicalType::INT64).with_repetition(repetition);
            field.build().map(Arc::new)
        };
        let fields = columns.iter().map(field).collect::<Result<_, _>>()?;
        Ok(Arc::new(Type::group_type_builder(name).with_fields(fields).build()?))
    }

    fn properties(metadata: &[(&str, &str)]) -> WriterProperties {
        let metadata =
            metadata.iter().map(|(key, value)| KeyValue::new(format!("twinedge.{key}"), (*value).to_owned()));
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
        column: &IntegerColumn<'_>,
        values: &[Option<i64>],
    ) -> Result<(), ParquetError> {
        let numbers: Vec<i64> = values.iter().copied().flatten().collect();
        let levels: Option<Vec<i16>> =
            column.is_nullable.then(|| values.iter().map(|value| i16::from(value.is_some())).collect());
        into.typed::<Int64Type>().write_batch(&numbers, levels.as_deref(), None)?;
        into.close()
    }
}
