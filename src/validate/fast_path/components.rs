//! The components, joined edge by edge.

use super::rotations::Rotations;
use crate::slots::{NIL, Sets};
use crate::validate::structure::View;
use crate::validate::subject::{Extent, Subject};
use alloc::vec::Vec;

/// The number of the component of each vertex; nil if it is not live.
pub(super) struct ComponentNumbers {
    pub(super) of: Vec<u32>,
    pub(super) count: usize,
}

/// Joins vertices until `fewest` components are left, or every edge is used.
///
/// First each vertex joins its neighbour with the smallest number. Numbers fall along these steps, so they end, and if
/// neighbours have close numbers they end at one vertex of each component. The rest is joined edge by edge.
#[inline(never)]
pub(super) fn join<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    around: Rotations,
    fewest: usize,
) -> Option<ComponentNumbers> {
    let (mut of, mut count) = (around.nearest, 0);
    for v in 0..of.len() {
        let nearest = of[v] as usize;
        if nearest == v {
            of[v] = count as u32;
            count += 1;
        } else if nearest < v {
            of[v] = of[nearest];
        }
    }
    if count <= fewest {
        return Some(ComponentNumbers { of, count });
    }
    let mut sets = Sets::try_new(count)?;
    for h in (Subject { view, extent }).half_edges() {
        if sets.count == fewest {
            break;
        }
        // Without twin the edge ends at the origin of the next half-edge.
        let t = match view.twin(h as usize) {
            Some(t) if t < h as usize => continue,
            Some(t) => extent.half_edges.existing(Some(t))?,
            None => extent.half_edges.existing(view.next(h as usize))?,
        };
        sets.join(*of.get(view.origin(h as usize)?)?, *of.get(view.origin(t)?)?);
    }
    let count = sets.count;
    let numbers = sets.numbered()?;
    for of in of.iter_mut().filter(|of| **of != NIL) {
        *of = *numbers.get(*of as usize)?;
    }
    Some(ComponentNumbers { of, count })
}
