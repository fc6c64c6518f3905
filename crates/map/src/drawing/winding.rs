//! G3 winding: outer cycles turn counter-clockwise, inner ones clockwise.

use crate::drawing::columns::Columns;
use crate::drawing::lists::{Listed, Lists};
use core::cmp::Ordering;
use twinedge::validate::{Findings, Flow, Rule, Start, Violation};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};

/// Runs G3.
pub(crate) fn check(findings: &mut Findings, columns: &Columns, lists: &Lists) -> Flow {
    let mut checked = 0;
    let mut seen = vec![false; columns.origin.len()];
    for Listed { boundary, start, is_outer, .. } in &lists.all {
        // By B1, no two boundary components start on one cycle.
        let Start::HalfEdge(h) = *start else { continue };
        if seen[h] {
            continue;
        }
        checked += 1;
        match (is_outer, turns_clockwise(columns, h, &mut seen)) {
            (true, true) => findings.add(Violation::OuterClockwise { boundary: *boundary })?,
            (false, false) => findings.add(Violation::InnerCounterClockwise { boundary: *boundary })?,
            _ => {}
        }
    }
    findings.checked(Rule::G3, checked);
    Ok(())
}

/// Returns true if the face lies outside the cycle: at the lexicographically smallest point, a vertex or a bend, the face lies to
/// the left. A cycle may pass that point more than once.
fn turns_clockwise(columns: &Columns, start: usize, seen: &mut [bool]) -> bool {
    let mut low = columns.tail(start);
    let mut around = false;
    let (mut before, mut at) = (low, columns.towards(start));
    let mut pass = |after: Point| {
        match compare_lexicographic(at, low) {
            Ordering::Less => {
                low = at;
                around = corner_opens_left(before, at, after);
            }
            Ordering::Equal => around |= corner_opens_left(before, at, after),
            Ordering::Greater => {}
        }
        (before, at) = (at, after);
    };
    let mut h = start;
    // The walk already starts at the first point of the cycle's line.
    let mut skip = 1;
    loop {
        seen[h] = true;
        columns.line(h).skip(skip).for_each(&mut pass);
        skip = 0;
        h = columns.next(h);
        if h == start {
            pass(columns.towards(start));
            return around;
        }
    }
}

/// Returns true if the corner left of the path `before`, `at`, `after` contains the direction to the left; `at` is the least.
fn corner_opens_left(before: Point, at: Point, after: Point) -> bool {
    before == after || orientation(at, before, after) == Orientation::CounterClockwise
}
