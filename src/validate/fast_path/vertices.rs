//! The vertices one by one, where a wrong link keeps the walks around them from settling V1.

use super::facts::VertexFigures;
use super::links::Links;
use super::rotations::{is_claimed, leaves};
use crate::validate::structure::{Part, View};
use crate::validate::subject::Extent;

/// V1 and R1 of vertices. None if something is wrong with one, or one keeps no half-edge although some leave it.
pub(super) fn by_index<V: View + ?Sized>(view: &V, extent: Extent, links: &Links) -> Option<VertexFigures> {
    let names_boundary = extent.has(Part::BoundaryComponents) && extent.has(Part::Holes);
    let mut found = VertexFigures { live: 0, isolated: 0, claimed: 0 };
    for v in extent.vertices.all().filter(|v| view.is_vertex(*v)) {
        found.live += 1;
        if let Some(start) = links.leaving(view, v) {
            let names_nothing = !names_boundary || view.isolated(v).is_none();
            (leaves(view, extent, start, v) && names_nothing).then_some(())?;
        } else {
            found.isolated += 1;
            if names_boundary {
                found.claimed += usize::from(is_claimed(view, extent, v)?);
            }
        }
    }
    (found.isolated == 0 || !extent.has(Part::Leaving) || each_origin_keeps_one(view, extent)).then_some(found)
}

/// True if no half-edge leaves a vertex that keeps none.
fn each_origin_keeps_one<V: View + ?Sized>(view: &V, extent: Extent) -> bool {
    let mut half_edges = extent.half_edges.all().filter(|h| view.is_half_edge(*h));
    half_edges.all(|h| {
        let origin = extent.vertices.existing(view.origin(h)).filter(|v| view.is_vertex(*v));
        origin.is_none_or(|v| view.leaving(v).is_some())
    })
}
