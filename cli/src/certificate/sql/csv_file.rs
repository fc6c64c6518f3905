//! A table in CSV.

use super::tables::Table;
use crate::status::Failure;
use std::fs::File;
use std::io::{BufWriter, Write as _};
use std::path::Path;

/// Writes a table; NULL is empty.
pub(super) fn write(folder: &Path, mut table: Table<'_>) -> Result<(), Failure> {
    let mut file = BufWriter::new(File::create(folder.join(format!("{}.csv", table.name)))?);
    let names: Vec<&str> = table.columns.iter().map(|column| column.name).collect();
    writeln!(file, "{}", names.join(","))?;
    loop {
        let row: Option<Vec<_>> = table.columns.iter_mut().map(|column| column.values.next()).collect();
        let Some(row) = row else { break };
        let fields: Vec<String> = row.iter().map(|field| field.map_or_else(String::new, |n| n.to_string())).collect();
        writeln!(file, "{}", fields.join(","))?;
    }
    file.flush()?;
    Ok(())
}
