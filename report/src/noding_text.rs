//! The summary of noding, in a line.

use crate::words::counted;
use std::fmt::Write as _;
use twinedge::geometry::noding::NodingSummary;

/// The summary of noding, in a line.
#[must_use]
pub fn line(noding: &NodingSummary) -> String {
    let cut = counted(noding.split, "segment");
    let mut line = format!("snapped to a grid of 2^{}: {cut} cut", noding.cell.log2());
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
