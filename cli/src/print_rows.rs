//! Rows of counts as text: a head, and a line for each row.

use crate::output::style::{BAD, QUIET};
use crate::output::{grouped, zero};
use std::fmt::Write as _;
use twinedge_trials::{Cell, Column, Row};

pub(crate) fn head<R: Row>() -> String {
    let names = R::COLUMNS.iter().map(|column| (*column, column.name.to_owned()));
    format!("{QUIET}{}{QUIET:#}\n", in_columns(names))
}

/// Formats a row, with the expected count next to each count that differs. A part of the work (`is_whole` is false) has no expected counts.
pub(crate) fn line<R: Row>(row: &R, is_whole: bool) -> String {
    let cells = row.cells().into_iter().map(|cell| match cell {
        Cell::Text(text) => text,
        Cell::Count { found, expected: Some(expected) } if is_whole && found != expected => {
            format!("{BAD}{}≠{}{BAD:#}", grouped(found), grouped(expected))
        }
        Cell::Count { found, .. } => grouped(found),
        Cell::Zero(found) => zero(found),
        _ => String::new(),
    });
    in_columns(R::COLUMNS.iter().copied().zip(cells)) + "\n"
}

pub(crate) fn table<'a, R: Row + 'a>(rows: impl IntoIterator<Item = &'a R>, is_whole: bool) -> String {
    rows.into_iter().fold(head::<R>(), |text, row| text + &line(row, is_whole))
}

/// Aligns cells in columns. Two spaces separate a label that is not in the first column.
fn in_columns(cells: impl Iterator<Item = (Column, String)>) -> String {
    let mut line = String::new();
    for (column, cell) in cells.filter(|(column, _)| column.width > 0) {
        let (width, is_first) = (column.width, line.is_empty());
        // Writing to a string never fails.
        let _ = match (column.is_label, is_first) {
            (true, true) => write!(line, "{cell:width$}"),
            (true, false) => write!(line, "  {cell:width$}"),
            (false, true) => write!(line, "{cell:>width$}"),
            (false, false) => write!(line, " {cell:>width$}"),
        };
    }
    line
}
