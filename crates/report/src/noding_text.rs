//! The summary of noding as text.

use crate::words::counted;
use std::fmt::Write as _;
use twinedge_geometry::noding::NodingSummary;

/// Returns the summary of noding in one line.
#[must_use]
pub fn line(noding: &NodingSummary) -> String {
    let cut = counted(noding.split, "segment");
    let exponent = noding.cell.log2();
    let cell = if exponent.fract() == 0.0 { format!("2^{exponent}") } else { noding.cell.to_string() };
    let mut line = format!("snapped to a grid of {cell}: {cut} cut");
    for (count, name, what) in [
        (noding.crossings, "vertex", "made at crossings"),
        (noding.merged, "point", "merged with others"),
        (noding.collapsed, "segment", "collapsed"),
        (noding.duplicates, "segment", "repeated"),
    ] {
        if count > 0 {
            let _ = write!(line, ", {} {what}", counted(count, name));
        }
    }
    let [x, y] = noding.largest_move;
    let _ = write!(line, "; points moved by at most {x:.2e} in x and {y:.2e} in y");
    line
}
