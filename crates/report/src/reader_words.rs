//! Clashes of borders in terms of features, for readers who do not know the map's half-edges.

use crate::words::place;
use twinedge_diagnosis::{Diagnosis, FeatureName, Position};

/// The number of features named.
const NAMED: usize = 3;

/// Returns the sentence; `None` for other violations, and if no feature is known. Coordinates have at most `decimals` decimal places.
pub(crate) fn sentence(one: &Diagnosis, decimals: usize) -> Option<String> {
    let features = one.features.as_deref().filter(|features| !features.is_empty())?;
    let at = place(one.look?, decimals);
    let (alone, together, where_) = match one.kind.name() {
        "cross" | "segments_cross" => ("crosses itself", "cross", format!("at {at}")),
        "overlap" | "segments_overlap" => {
            let [from, to] = common(one.places.as_deref()?)?.map(|end| place(end, decimals));
            ("overlaps itself", "overlap", format!("from {from} to {to}"))
        }
        "touch" | "vertex_in_segment" | "bend_in_segment" => {
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

/// Joins names with commas and `and`.
fn listed(names: &[String]) -> String {
    let (named, more) = names.split_at(names.len().min(NAMED));
    match (named, more.len()) {
        ([all @ .., last], 0) => format!("{} and {last}", all.join(", ")),
        (_, more) => format!("{} and {more} more", named.join(", ")),
    }
}

/// Returns the ends of the common part of two segments on one line, given their four ends.
pub(crate) fn common(ends: &[Position]) -> Option<[Position; 2]> {
    let mut ends: [Position; 4] = ends.try_into().ok()?;
    let span = |axis: usize| ends.iter().map(|p| (p[axis] - ends[0][axis]).abs()).fold(0.0, f64::max);
    let axis = usize::from(span(1) > span(0));
    ends.sort_by(|a, b| a[axis].total_cmp(&b[axis]));
    Some([ends[1], ends[2]])
}
