//! `twinedge query … neighbours --all`: all pairs of neighbours, as a table.

use super::list::{Limit, TableFormat, csv, greatest_first};
use super::source::Source;
use crate::output::style::QUIET;
use crate::output::{measure, print_answer, print_json};
use crate::status::Failure;
use clap::ValueEnum;
use serde::Serialize;
use std::fmt::Write as _;
use twinedge::algorithm::neighbours::pairs;
use twinedge::dcel::Face;
use twinedge::map::FeatureId;
use twinedge_report::Units;
use twinedge_report::names::label;

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
    pairs: Vec<Row>,
}

/// Two features and their border.
#[derive(Debug, Serialize)]
struct Row {
    number: usize,
    id: Option<String>,
    name: String,
    other_number: usize,
    other_id: Option<String>,
    other_name: String,
    /// The border of the first with the second.
    length: f64,
    /// The part of it on which one ends and the other begins.
    shared: f64,
    lines: usize,
    /// The area that both cover.
    overlap: f64,
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
    let id = |feature: FeatureId| noted.ids.get(feature.index()).cloned().flatten();
    let mut rows: Vec<Row> = Vec::new();
    for pair in pairs(map) {
        let [one, other] = pair.features;
        let border = pair.border;
        let plane = border.length;
        let (length, overlap) = match units {
            Units::Plane { .. } => (plane, pair.overlap),
            Units::Geodesic(_) => {
                let covers = |face: Face<'_>, of| map.features_of(face.key()).into_iter().flatten().any(|f| f == of);
                let both = map.dcel().faces().filter(|f| pair.overlap > 0.0 && covers(*f, one) && covers(*f, other));
                let length = border.borders.iter().map(|chain| units.length(chain)).sum();
                (length, both.map(|face| units.area(map, face)).sum())
            }
        };
        // Where features overlap along a part of their border, that part is known in the units of the coordinates.
        let shared = if plane > 0.0 { length * (border.shared / plane) } else { 0.0 };
        rows.push(Row {
            number: one.index(),
            id: id(one),
            name: label(map, one),
            other_number: other.index(),
            other_id: id(other),
            other_name: label(map, other),
            length,
            shared,
            lines: border.borders.len(),
            overlap,
        });
    }
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

fn text(rows: &[Row], units: &Units) -> Result<String, std::fmt::Error> {
    let mut out = String::new();
    let width = |name: fn(&Row) -> &str| rows.iter().map(|row| name(row).chars().count()).max().unwrap_or(0).max(7);
    let (one, other) = (width(|row| &row.name), width(|row| &row.other_name));
    writeln!(out, "{:one$}  {:other$}  {:>12}  {:>12}  {:>12}", "feature", "other", "length", "shared", "overlap")?;
    for row in rows {
        let [length, shared, overlap] = [row.length, row.shared, row.overlap].map(measure);
        writeln!(out, "{:one$}  {:other$}  {length:>12}  {shared:>12}  {overlap:>12}", row.name, row.other_name)?;
    }
    writeln!(out, "{QUIET}{}{QUIET:#}", units.sentence())?;
    Ok(out)
}
