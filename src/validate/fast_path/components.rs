//! The components, joined edge by edge.

use super::rotations::RotationWalk;
use crate::slots::{NIL, Sets};
use crate::validate::structure::View;
use crate::validate::subject::Extent;
use alloc::vec::Vec;

/// The number of the component of each vertex, and the first vertex of each component.
pub(super) struct ComponentNumbers {
    pub(super) of: Vec<u32>,
    pub(super) first: Vec<u32>,
}

/// Joins vertices until so few components are left, or every edge is used.
///
/// First each vertex joins its neighbour with the smallest number. Numbers fall along these steps, so they end, and where
/// neighbours have close numbers they end at one vertex of each component. What is left is joined edge by edge.
#[inline(never)]
pub(super) fn join<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    around: RotationWalk,
    fewest: usize,
) -> Option<ComponentNumbers> {
    let mut of = around.nearest;
    let mut first = Vec::new();
    first.try_reserve_exact(around.counted.roots).ok()?;
    for v in 0..of.len() {
        let nearest = of[v] as usize;
        if nearest == v {
            of[v] = first.len() as u32;
            first.push(v as u32);
        } else if nearest < v {
            of[v] = of[nearest];
        }
    }
    if first.len() > fewest {
        let mut sets = Sets::try_new(first.len())?;
        for h in extent.half_edges.all() {
            if sets.count == fewest {
                break;
            }
            if !view.is_half_edge(h) {
                continue;
            }
            // Without twin the edge ends where the next one starts.
            let t = match view.twin(h) {
                Some(t) if t < h => continue,
                Some(t) => extent.half_edges.existing(Some(t))?,
                None => extent.half_edges.existing(view.next(h))?,
            };
            sets.join(*of.get(view.origin(h)?)?, *of.get(view.origin(t)?)?);
        }
        // Sets are numbered in the order of their first members.
        let numbers = sets.numbered()?;
        let (mut count, mut number) = (0, numbers.iter());
        first.retain(|_| {
            let is_first = number.next() == Some(&count);
            count += u32::from(is_first);
            is_first
        });
        for of in of.iter_mut().filter(|of| **of != NIL) {
            *of = *numbers.get(*of as usize)?;
        }
    }
    Some(ComponentNumbers { of, first })
}
