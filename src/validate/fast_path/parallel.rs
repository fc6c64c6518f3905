//! The fast path on several threads: the scan and the walks in parts, one for each thread.
//!
//! It settles everything or nothing: where all that it asks is right, it notes what [`look`](super::look) would note, and
//! otherwise the caller looks again, on one thread. It takes closed structures with records of boundary components and their
//! places, and vertices that keep a half-edge: then no part has to know what another one has visited.
//!
//! # Why the parts suffice
//!
//! The argument of [the fast path](super) counts, and counts of parts add up. What it remembers besides is needed no more:
//!
//! - That a boundary component is listed once: each entry is at the place that the boundary component names, so two entries are of
//!   different ones.
//! - That no walk is longer than what is left of the half-edges: each part has them all as its limit, so the work is O(n) for
//!   each part.
//! - Which vertices were seen from a vertex: by a column for each part.

use super::boundaries::{Boundaries, Inner};
use super::cycles::{Cycles, Listed, along};
use super::doubts::{self, Settled};
use super::extent::{Extent, existing, nils};
use super::known::{Lists, Turned, Vertices};
use super::links::{self, Links};
use super::rotations::{Rotations, around, is_claimed};
use super::{extent_of, listed};
use crate::validate::expectation::Part;
use crate::validate::run::Run;
use crate::validate::view::{BoundaryPlace, Start, View};
use alloc::vec::Vec;
use core::ops::Range;
use rayon::prelude::*;

/// Finds out that R1 … B1, F1 and F2 hold, and notes that and what follows of the whole. False if they do not, or if this
/// cannot be found out in parts; then nothing is noted.
pub(in crate::validate) fn look<V: View + Sync + ?Sized>(run: &mut Run<'_, V>) -> bool {
    let extent = extent_of(run);
    let Some((links, around, lists)) = all(run.view, extent) else { return false };
    let settled = Settled { origins: true, names: true };
    let Some(doubts) = doubts::find(run.view, extent, &links, settled) else { return false };
    let Rotations { vertices: live, isolated, claimed, .. } = around;
    run.known.vertices = claimed.map(|claimed| Vertices { live, isolated, claimed });
    run.known.half_edges = Some(doubts);
    run.known.lists = Some(Lists::of(&lists, true));
    listed(run, extent, Turned { links, around }, &lists);
    true
}

/// What the scan and the walks find, where nothing is wrong.
fn all<V: View + Sync + ?Sized>(view: &V, extent: Extent) -> Option<(Links, Rotations, Boundaries)> {
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

/// What each part of so many slots gives; none if one part gives none. Parts are as many as there are threads.
fn parts<T: Send>(slots: usize, part: impl Fn(Range<usize>) -> Option<T> + Sync) -> Option<Vec<T>> {
    let length = part_length(slots);
    let part_of = |start: usize| part(start..slots.min(start + length));
    (0..slots.div_ceil(length)).into_par_iter().map(|i| part_of(i * length)).collect()
}

fn part_length(slots: usize) -> usize {
    slots.div_ceil(rayon::current_num_threads()).max(1)
}

/// Walks around all vertices.
fn rotations<V: View + Sync + ?Sized>(view: &V, extent: Extent, links: &Links) -> Option<Rotations> {
    let mut nearest = nils(extent.vertices)?;
    let length = part_length(extent.vertices);
    let found = nearest.par_chunks_mut(length).enumerate();
    let found = found.map(|(i, nearest)| rotations_of(view, extent, links, i * length, nearest));
    let found: Vec<Rotations> = found.collect::<Option<_>>()?;
    let none = Rotations {
        vertices: 0,
        isolated: 0,
        claimed: Some(0),
        half_edges: 0,
        nearest,
        roots: 0,
        simple: true,
        cycles: None,
    };
    let all = found.into_iter().fold(none, |all, part| Rotations {
        vertices: all.vertices + part.vertices,
        isolated: all.isolated + part.isolated,
        claimed: all.claimed.zip(part.claimed).map(|(all, part)| all + part),
        half_edges: all.half_edges + part.half_edges,
        nearest: all.nearest,
        roots: all.roots + part.roots,
        simple: all.simple && part.simple,
        cycles: None,
    });
    (all.half_edges == links.half_edges).then_some(all)
}

/// Walks around the vertices from `first` on, one for each entry of `nearest`, which it fills in.
fn rotations_of<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    links: &Links,
    first: usize,
    nearest: &mut [u32],
) -> Option<Rotations> {
    let mut found = Rotations {
        vertices: 0,
        isolated: 0,
        claimed: Some(0),
        half_edges: 0,
        nearest: Vec::new(),
        roots: 0,
        simple: true,
        cycles: None,
    };
    let mut seen_from = nils(extent.vertices)?;
    for (v, nearest_to) in (first..).zip(nearest).filter(|(v, _)| view.is_vertex(*v)) {
        found.vertices += 1;
        let mut nearest = v;
        match view.leaving(v) {
            None => {
                found.isolated += 1;
                found.claimed = found.claimed.and_then(|all| Some(all + usize::from(is_claimed(view, extent, v)?)));
            }
            Some(start) => {
                let leaves = start < extent.half_edges && view.is_half_edge(start) && view.origin(start) == Some(v);
                if !leaves {
                    return None;
                }
                if view.isolated(v).is_some() {
                    found.claimed = None;
                }
                let simple = &mut found.simple;
                found.half_edges += around(
                    view,
                    extent,
                    start,
                    links.half_edges,
                    |neighbour| {
                        let seen = seen_from.get_mut(neighbour)?;
                        *simple &= core::mem::replace(seen, v as u32) != v as u32;
                        nearest = nearest.min(neighbour);
                        Some(())
                    },
                    &mut Listed,
                )?;
                if found.half_edges > links.half_edges {
                    return None;
                }
            }
        }
        *nearest_to = nearest as u32;
        found.roots += usize::from(nearest == v);
    }
    Some(found)
}

/// Reads the lists of all faces, and walks along every cycle.
fn boundaries<V: View + Sync + ?Sized>(view: &V, extent: Extent, links: &Links) -> Option<Boundaries> {
    let live = parts(extent.boundaries, |range| Some(range.filter(|b| view.is_boundary(*b)).count()))?;
    let live = live.into_iter().sum();
    let found = parts(extent.faces, |range| {
        let mut part = FacesPart { view, extent, links, live, listed: 0, visited: 0, found: nothing() };
        range.into_iter().filter(|f| view.is_face(*f)).try_for_each(|f| part.face(f))?;
        Some((part.listed, part.visited, part.found))
    })?;
    let (mut listed, mut visited, mut all) = (0_usize, 0_usize, nothing());
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
    let unbounded = usize::from(extent.has(Part::UnboundedFace));
    let complete = listed == live && visited == links.half_edges && all.faces - all.outer == unbounded;
    complete.then_some(all)
}

fn nothing() -> Boundaries {
    let cycles = Cycles::default();
    Boundaries { faces: 0, outer: 0, inner: Vec::new(), at_vertex: 0, vertices_hold: true, cycles }
}

/// Some of the faces.
struct FacesPart<'a, V: ?Sized> {
    view: &'a V,
    extent: Extent,
    links: &'a Links,
    /// How many boundary components there are.
    live: usize,
    /// How many these faces list.
    listed: usize,
    /// How many half-edges were visited.
    visited: usize,
    found: Boundaries,
}

impl<V: View + ?Sized> FacesPart<'_, V> {
    fn face(&mut self, f: usize) -> Option<()> {
        self.found.faces += 1;
        let (outer, inner) = (self.view.outer(f), self.view.inner_count(f));
        self.listed = self.listed.checked_add(inner)?.checked_add(usize::from(outer.is_some()))?;
        if self.listed > self.live {
            return None;
        }
        if let Some(b) = outer {
            self.record(f, b, BoundaryPlace::Outer)?;
            self.found.outer += 1;
        }
        (0..inner).try_for_each(|i| self.record(f, self.view.inner(f, i)?, BoundaryPlace::Inner(i)))
    }

    /// Reads a boundary component that this face lists.
    fn record(&mut self, f: usize, b: usize, place: BoundaryPlace) -> Option<()> {
        let (view, extent) = (self.view, self.extent);
        let is_there = b < extent.boundaries
            && view.is_boundary(b)
            && view.boundary_face(b) == Some(f)
            && view.boundary_place(b) == Some(place);
        if !is_there {
            return None;
        }
        let vertex = match view.boundary_start(b)? {
            Start::Vertex(v) => {
                self.found.at_vertex += 1;
                Some(v).filter(|v| place != BoundaryPlace::Outer && *v < extent.vertices && view.is_vertex(*v))?
            }
            Start::HalfEdge(start) => {
                let start = existing(Some(start), extent.half_edges).filter(|h| view.is_half_edge(*h))?;
                let of_b = |h| (view.boundary(h) == Some(b)).then_some(());
                self.visited += along(view, extent, start, self.links.half_edges, of_b)?;
                self.found.cycles.named += 1;
                existing(view.origin(start), extent.vertices)?
            }
        };
        if self.visited > self.links.half_edges {
            return None;
        }
        if place != BoundaryPlace::Outer {
            self.found.inner.try_reserve(1).ok()?;
            self.found.inner.push(Inner { vertex: vertex as u32, face: f as u32 });
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::look;
    use crate::validate::run::Run;
    use crate::validate::{Collect, Expectation, Part, Table};

    /// Whether a structure is settled in parts.
    fn is_settled(table: &str, expectation: Expectation) -> bool {
        let table: Table = table.parse().unwrap();
        let mut run = Run::new(&table, expectation, Collect::All);
        run.measure().unwrap();
        let settled = look(&mut run);
        assert_eq!(settled, run.known.half_edges.is_some());
        settled
    }

    #[test]
    fn what_is_right_is_settled_and_nothing_else() {
        const LOOP: &str = "V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 1 h0 o 0 h1 i0 F 2 - 1 1 0 0";
        let plane = Expectation::plane();
        assert!(is_settled(LOOP, plane));
        assert!(is_settled(LOOP, plane.without(Part::Prev)));
        assert!(!is_settled(LOOP, plane.without(Part::Places)));
        assert!(!is_settled(&LOOP.replace("h1 i0", "h0 i0"), plane));
    }
}
