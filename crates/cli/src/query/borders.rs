//! `twinedge query … neighbours --all`: all pairs of neighbours, as a table.

use super::list::{Limit, TableFormat, csv, greatest_first};
use super::which::Source;
use crate::output::style::QUIET;
use crate::output::{Failure, measure, print_answer, print_json};
use clap::ValueEnum;
use serde::Serialize;
use std::fmt::Write as _;
use twinedge_report::{Border, Units, borders};

/// The order of a table of neighbours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum SortBy {
    /// The numbers of the features.
    #[default]
    Number,
    /// The names of the features.
    Name,
    /// The length of the border, the longest first.
    Length,
    /// The area that both cover, the largest first.
    Overlap,
}

#[derive(Debug, Serialize)]
struct BorderAnswer<'a> {
    input: &'a str,
    unit: &'static str,
    pairs: Vec<Border>,
}

const HEADINGS: [&str; 10] =
    ["number", "id", "name", "other_number", "other_id", "other_name", "length", "shared", "lines", "overlap"];

/// Prints all pairs of features with a border or an overlap.
pub(super) fn print_all(
    asked: &Source,
    units: &Units,
    sort: SortBy,
    limit: &Limit,
    format: TableFormat,
) -> Result<(), Failure> {
    let Source { input, map, noted } = asked;
    let mut rows = borders(map, noted, units);
    match sort {
        SortBy::Number => {}
        SortBy::Name => rows.sort_by(|a, b| (&a.name, &a.other_name).cmp(&(&b.name, &b.other_name))),
        SortBy::Length => greatest_first(&mut rows, |row| row.length),
        SortBy::Overlap => greatest_first(&mut rows, |row| row.overlap),
    }
    limit.cut(&mut rows);
    match format {
        TableFormat::Text => print_answer(&text(&rows, units)?),
        TableFormat::Csv => print_answer(&csv(&rows, &HEADINGS)?),
        TableFormat::Json => print_json(&BorderAnswer { input, unit: units.name(), pairs: rows }),
    }
}

fn text(rows: &[Border], units: &Units) -> Result<String, std::fmt::Error> {
    let mut out = String::new();
    let width = |name: fn(&Border) -> &str| rows.iter().map(|row| name(row).chars().count()).max().unwrap_or(0).max(7);
    let (one, other) = (width(|row| &row.name), width(|row| &row.other_name));
    writeln!(out, "{:one$}  {:other$}  {:>12}  {:>12}  {:>12}", "feature", "other", "length", "shared", "overlap")?;
    for row in rows {
        let [length, shared, overlap] = [row.length, row.shared, row.overlap].map(measure);
        writeln!(out, "{:one$}  {:other$}  {length:>12}  {shared:>12}  {overlap:>12}", row.name, row.other_name)?;
    }
    writeln!(out, "{QUIET}{}{QUIET:#}", units.sentence())?;
    Ok(out)
}
