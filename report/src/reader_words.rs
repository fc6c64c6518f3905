//! Clashes of borders in the words of somebody who knows the features of a map, and not its half-edges.

use crate::words::place;
use twinedge::validate::Violation;
use twinedge_formats::diagnosis::{Diagnosis, FeatureName, Kind, Position};

/// The number of features that are named.
const NAMED: usize = 3;

/// The sentence; none for other violations, and where no feature is known. Places have so many decimal places at most.
pub(crate) fn sentence(one: &Diagnosis, decimals: usize) -> Option<String> {
    let Kind::Of(violation) = one.kind else { return None };
    let features = one.features.as_deref().filter(|features| !features.is_empty())?;
    let at = place(one.look?, decimals);
    let (alone, together, where_) = match violation {
        Violation::Cross { .. } | Violation::SegmentsCross { .. } => ("crosses itself", "cross", format!("at {at}")),
        Violation::Overlap { .. } | Violation::SegmentsOverlap { .. } => {
            let [from, to] = common(one.places.as_deref()?)?.map(|end| place(end, decimals));
            ("overlaps itself", "overlap", format!("from {from} to {to}"))
        }
        Violation::Touch { .. } | Violation::VertexInSegment { .. } | Violation::BendInSegment { .. } => {
            ("touches itself", "touch", format!("at {at}, where only one has a vertex"))
        }
        _ => return None,
    };
    let names: Vec<String> = features.iter().map(FeatureName::title).collect();
    Some(match &names[..] {
        [name] => format!("the border of {name} {alone} {where_}"),
        _ => format!("the borders of {} {together} {where_}", listed(&names)),
    })
}

/// Names with commas and an `and` between them.
fn listed(names: &[String]) -> String {
    let (named, more) = names.split_at(names.len().min(NAMED));
    match (named, more.len()) {
        ([all @ .., last], 0) => format!("{} and {last}", all.join(", ")),
        (_, more) => format!("{} and {more} more", named.join(", ")),
    }
}

/// The ends of what two segments on one line have in common, if these are their four ends.
fn common(ends: &[Position]) -> Option<[Position; 2]> {
    let mut ends: [Position; 4] = ends.try_into().ok()?;
    let span = |axis: usize| ends.iter().map(|p| (p[axis] - ends[0][axis]).abs()).fold(0.0, f64::max);
    let axis = usize::from(span(1) > span(0));
    ends.sort_by(|a, b| a[axis].total_cmp(&b[axis]));
    Some([ends[1], ends[2]])
}
