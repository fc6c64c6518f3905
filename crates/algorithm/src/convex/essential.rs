//! Essential diagonals, and removal of the others.

use twinedge::dcel::{HalfEdge, HalfEdgeKey, StaleKey};
use twinedge_geometry::predicates::{Orientation, compare_angle, orientation};
use twinedge_map::edit::EditError;
use twinedge_map::{Embedding, PlanarMap};

/// Returns true if removing `h` leaves at most a straight angle at its origin, between the half-edges before and after it.
fn stays_convex(map: &PlanarMap, h: HalfEdge<'_>) -> bool {
    let [v, a, b] = [h.origin(), h.clockwise().target(), h.counter_clockwise().target()].map(|v| map.point(v.index()));
    match orientation(v, a, b) {
        Orientation::CounterClockwise => true,
        // Opposite directions form a straight angle, equal ones a full turn.
        Orientation::Collinear => compare_angle(v, a, b).is_ne(),
        Orientation::Clockwise => false,
    }
}

/// Returns true if an edge between convex corners is essential: without it one of its ends would have a corner larger than a
/// straight angle. An edge that does not separate two faces is also essential. O(1).
///
/// # Errors
/// [`StaleKey::HalfEdge`].
pub fn is_essential(map: &PlanarMap, half_edge: HalfEdgeKey) -> Result<bool, StaleKey> {
    let h = map.dcel().half_edge(half_edge)?;
    let separates = h.boundary() != h.twin().boundary();
    Ok(!(separates && stays_convex(map, h) && stays_convex(map, h.twin())))
}

/// Examines each of these edges once, in order, and removes it unless it is essential. Returns the kept edges.
///
/// Each piece is covered by the features that covered both sides of its removed edges; inside one triangulated face these are
/// equal. O(1) for each edge, plus O(length of the shorter cycle) for each removed edge.
///
/// # Errors
/// [`EditError::NotPlane`]; [`EditError::Operator`] for a stale key, or an edge named twice and removed, after processing the
/// earlier ones.
pub fn remove_inessential(map: &mut PlanarMap, edges: &[HalfEdgeKey]) -> Result<Vec<HalfEdgeKey>, EditError> {
    let mut kept = Vec::new();
    for h in edges {
        if is_essential(map, *h)? {
            kept.push(*h);
        } else {
            map.remove_edge(*h)?;
        }
    }
    Ok(kept)
}
