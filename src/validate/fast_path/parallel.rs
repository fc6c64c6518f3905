//! The fast path on several threads: the scan and the walks in parts, one for each thread.
//!
//! It settles everything or nothing: where all that it asks is right, it gives what [`settle`](super::settle) would give, and
//! otherwise the caller settles on one thread. It takes closed structures with records of boundary components and their
//! places, and vertices that keep a half-edge: then no part has to know what another one has visited.
//!
//! # Why the parts suffice
//!
//! The argument of [the fast path](super) counts, and counts of parts add up. What it remembers besides, each part remembers for itself:
//!
//! - How many half-edges are left, which no walk may exceed: each part begins with them all, so the work is O(n) for each part.
//! - Which vertices were seen from a vertex: by a column for each part.

use super::boundaries::{Boundaries, Lists};
use super::cycles::NoCount;
use super::doubts::{self, Assurances};
use super::facts::{Facts, ListFigures, Rotations, VertexFigures};
use super::links::{self, Links};
use super::rotations::{RotationWalk, VertexTally, walk_from};
use super::{agree, whole};
use crate::validate::structure::{Part, View};
use crate::validate::subject::{Extent, Slots, Subject};
use alloc::vec::Vec;
use core::ops::Range;
use rayon::prelude::*;

/// The facts, where R1 … B1, F1 and F2 hold. None if they do not, or if this cannot be found out in parts.
pub(crate) fn settle_in_parts<V: View + Sync + ?Sized>(subject: Subject<'_, V>) -> Option<Facts> {
    let Subject { view, extent } = subject;
    let (links, around, lists) = all(view, extent)?;
    let doubts = doubts::find(view, extent, &links, Assurances { origins: true, names: true })?;
    let figures = ListFigures::of(&lists, true, agree(extent, &around, &lists));
    let vertices = VertexFigures::of(around.counted);
    let whole = whole(view, extent, links, around, Some(lists));
    let rotations = whole.map_or(Rotations::Hold, Rotations::Whole);
    Some(Facts { half_edges: Some(doubts), vertices, lists: Some(figures), rotations })
}

/// Returns the results of the scan and the walks, if nothing is wrong.
fn all<V: View + Sync + ?Sized>(view: &V, extent: Extent) -> Option<(Links, RotationWalk, Boundaries)> {
    let needed = [Part::Leaving, Part::Faces, Part::BoundaryComponents, Part::Places, Part::Holes];
    if extent.expect.is_open() || !needed.into_iter().all(|part| extent.has(part)) {
        return None;
    }
    let with_prev = extent.has(Part::Prev);
    let live = parts(extent.half_edges, |range| links::count_right(view, extent, with_prev, range))?;
    let links = Links::right(live.into_iter().sum());
    let (around, lists) = rayon::join(|| rotations(view, extent, &links), || boundaries(view, extent, &links));
    Some((links, around?, lists?))
}

/// Returns the result for each part of so many slots; none if one part gives none. There are as many parts as threads.
fn parts<T: Send>(slots: Slots, part: impl Fn(Range<usize>) -> Option<T> + Sync) -> Option<Vec<T>> {
    let (length, end) = (part_length(slots), slots.count());
    let part_of = |start: usize| part(start..end.min(start + length));
    (0..end.div_ceil(length)).into_par_iter().map(|i| part_of(i * length)).collect()
}

fn part_length(slots: Slots) -> usize {
    slots.count().div_ceil(rayon::current_num_threads()).max(1)
}

/// Walks around all vertices.
fn rotations<V: View + Sync + ?Sized>(view: &V, extent: Extent, links: &Links) -> Option<RotationWalk> {
    let mut nearest = extent.vertices.nils()?;
    let length = part_length(extent.vertices);
    let found = nearest.par_chunks_mut(length).enumerate();
    let found = found.map(|(i, nearest)| walk_from(view, extent, links, i * length, nearest, &mut NoCount));
    let found: Vec<VertexTally> = found.collect::<Option<_>>()?;
    let counted = found.into_iter().fold(VertexTally::NOTHING, |all, part| VertexTally {
        vertices: all.vertices + part.vertices,
        isolated: all.isolated + part.isolated,
        claimed: all.claimed.zip(part.claimed).map(|(all, part)| all + part),
        half_edges: all.half_edges + part.half_edges,
        cycles: all.cycles + part.cycles,
        roots: all.roots + part.roots,
        simple: all.simple && part.simple,
    });
    (counted.half_edges == links.half_edges).then_some(RotationWalk { counted, nearest, cycles: None })
}

/// Reads the lists of all faces, and walks along every cycle.
fn boundaries<V: View + Sync + ?Sized>(view: &V, extent: Extent, links: &Links) -> Option<Boundaries> {
    let live = parts(extent.boundaries, |range| Some(range.filter(|b| view.is_boundary(*b)).count()))?;
    let live = live.into_iter().sum();
    let found = parts(extent.faces, |range| {
        let mut part = Lists::<V, true>::new(view, extent, links);
        part.by_record(range, live)?;
        Some((part.listed, part.visited, part.found))
    })?;
    let (mut listed, mut visited, mut all) = (0_usize, 0_usize, Boundaries::default());
    for (more_listed, more_visited, part) in found {
        listed += more_listed;
        visited += more_visited;
        all.faces += part.faces;
        all.outer += part.outer;
        all.at_vertex += part.at_vertex;
        all.cycles.named += part.cycles.named;
        all.inner.try_reserve(part.inner.len()).ok()?;
        all.inner.extend(part.inner);
    }
    (listed == live && visited == links.half_edges && all.has_unbounded(extent)).then_some(all)
}

#[cfg(test)]
mod tests;
