//! Tables that can be sorted and truncated.

use crate::output::style::QUIET;
use crate::output::{Failure, print_answer, print_json};
use clap::ValueEnum;
use serde::Serialize;
use twinedge_report::Units;

/// The output format of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum TableFormat {
    /// Text.
    #[default]
    Text,
    /// Comma-separated values, with a line of headings.
    Csv,
    /// One JSON object.
    Json,
}

/// The number of rows that are wanted.
#[derive(Debug, clap::Args)]
pub(super) struct Limit {
    /// Greatest number of rows; all by default.
    #[arg(long, value_name = "N", value_parser = twinedge_report::whole, allow_negative_numbers = true)]
    limit: Option<usize>,
}

impl Limit {
    /// Drops the rows after the last one wanted.
    pub(super) fn cut<T>(&self, rows: &mut Vec<T>) {
        rows.truncate(self.limit.unwrap_or(usize::MAX));
    }
}

/// The rows of a table that are wanted, and its format.
#[derive(Debug, clap::Args)]
pub(super) struct Rows {
    #[command(flatten)]
    limit: Limit,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: TableFormat,
}

impl Rows {
    /// Drops the rows after the last one wanted.
    pub(super) fn cut<T>(&self, rows: &mut Vec<T>) {
        self.limit.cut(rows);
    }

    /// Prints a table in one of these forms; text with the units below it.
    pub(super) fn print(
        &self,
        units: &Units,
        text: impl FnOnce() -> Result<String, Failure>,
        csv: impl FnOnce() -> Result<String, Failure>,
        json: &impl Serialize,
    ) -> Result<(), Failure> {
        match self.format {
            TableFormat::Text => print_answer(&format!("{}{QUIET}{}{QUIET:#}\n", text()?, units.sentence())),
            TableFormat::Csv => print_answer(&csv()?),
            TableFormat::Json => print_json(json),
        }
    }
}

/// Sorts rows by a number, the greatest first. The sort is stable.
pub(super) fn greatest_first<T>(rows: &mut [T], number: impl Fn(&T) -> f64) {
    rows.sort_by(|a, b| number(b).total_cmp(&number(a)));
}

pub(super) fn csv<T: Serialize>(rows: impl IntoIterator<Item = T>, headings: &[&str]) -> Result<String, Failure> {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    writer.write_record(headings)?;
    for row in rows {
        writer.serialize(row)?;
    }
    Ok(String::from_utf8(writer.into_inner().map_err(|error| Failure(error.to_string()))?)?)
}
