//! G4: each newly drawn edge or vertex is compared with all records whose boxes it meets.

use super::drawn::{Drawn, Thing};
use super::tree::DrawnTrees;
use twinedge_geometry::predicates::{Meeting, meeting, on_segment};

/// Returns true if all newly drawn records, already in the trees, meet others only at shared vertices.
pub(super) fn is_disjoint(come: &[Drawn], trees: &DrawnTrees) -> bool {
    let free = |drawn: &Drawn| trees.beside(drawn).all(|other| other.thing == drawn.thing || !clash(drawn, other));
    come.iter().all(free)
}

fn clash(a: &Drawn, b: &Drawn) -> bool {
    match (a.thing, b.thing) {
        (Thing::Vertex(_), _) => on_segment(a.ends[0], b.ends[0], b.ends[1]),
        (_, Thing::Vertex(_)) => on_segment(b.ends[0], a.ends[0], a.ends[1]),
        (Thing::Edge(_), Thing::Edge(_)) => match meeting(a.ends[0], a.ends[1], b.ends[0], b.ends[1]) {
            Meeting::Disjoint => false,
            // Equal points are allowed only for the same vertex.
            Meeting::SharedEndpoint => (0..2).any(|i| {
                let other = (0..2).find(|j| a.ends[i] == b.ends[*j]);
                other.is_some_and(|j| a.vertices[i] != b.vertices[j])
            }),
            Meeting::Cross | Meeting::Touch(_) | Meeting::Overlap => true,
        },
    }
}
