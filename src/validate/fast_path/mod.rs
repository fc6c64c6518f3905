//! The common case first: a scan and two walks that settle R1 … T3 at once.
//!
//! Most structures that are validated are valid. So where the boundary is closed, the fast path reads every link once or
//! twice, counts, and settles R1 … T3 for all records if everything agrees; otherwise it gives up, and the rules are checked
//! one by one, each by the file that is named after it. It takes every expectation without open boundaries.
//!
//! ```text
//!   scan, by index:               along each cycle:             around v, from leaving(v):
//!
//!        h          n             ┌──► h ──► n ──► · ──┐              \   |   /
//!   ·────────►w────────►·         └────────────────────┘           ◄── \  |  / ──►
//!   ·◄────────w                   prev(n) = h,                    ─────── v ───────
//!        t                        boundary(h) = b,
//!   twin(t) = h ≠ t,              face(b) lists b
//!   origin(n) = origin(t)
//! ```
//!
//! # Why this is enough
//!
//! The walks remember little, because they count. Say that every step of every walk finds what the picture says, that every
//! walk returns to where it started, and that each kind of walk takes as many steps as there are half-edges.
//!
//! - The scan is L1 and L3, and it finds that `twin` and `next` lead from half-edges to half-edges.
//! - The walks along the cycles start where faces list them. No two of them meet: their half-edges have different boundary
//!   components, or different faces, or they are marked. So they visit every half-edge once, and `next` is a permutation,
//!   which `prev` undoes (L2); then `prev` is live and `next` undoes it, too. Each half-edge names what lists its cycle (B1).
//!   Without faces the walks start anywhere, and all half-edges are marked.
//! - By L3 the origin stays the same around a vertex, and `leaving(v)` leaves v, so the walks around the vertices visit every
//!   half-edge once, and each with its origin: that is V1 and V2. Where vertices keep no half-edge, the scan notes one of each.
//! - The faces list as many boundary components as there are, each of them once, by its own face (F1, F2, and R1 of faces).
//! - Each isolated vertex names a boundary component that starts at it, and there are as many of these as of those (B2).
//! - Components are joined until as few are left as Euler's formula allows. It says that `V − E + cycles = 2C − 2g` with
//!   `g ≥ 0`, so there are never fewer, and once there are as many, C is known and g is 0. Where all edges are used up
//!   before, the difference is the genus (T3).
//! - Then each component needs one inner boundary component (T1).
//!
//! Every structure that keeps R1 … T3 and has no open boundary is settled here.

mod borders;
mod boundaries;
mod components;
mod extent;
mod known;
mod links;
mod marks;
mod rotations;

use super::columns::{Component, Components, NIL};
use super::expectation::{Part, Surface};
use super::run::Run;
use super::view::View;
use alloc::vec::Vec;
use boundaries::{Boundaries, Cycles};
use components::Joined;
use extent::Extent;
pub(super) use known::Known;
use known::{Lists, Vertices, Whole};
use links::Links;
use rotations::Rotations;

/// The scan and the walks around the vertices, where nothing is wrong with the rotations.
pub(super) struct Turned {
    links: Links,
    around: Rotations,
}

/// Finds out what holds of R1 … T3, part by part.
pub(super) fn look<V: View + ?Sized>(run: &mut Run<'_, V>) {
    let view = run.view;
    let extent = Extent::of(run);
    let Some(mut links) = links::scan(view, extent) else { return };
    let Some(doubts) = links.doubts(view, extent) else { return };
    run.known.half_edges = Some(doubts);
    let is_map = links.next_holds && links.twin_holds && links.one_into_each;
    let mut vertices_hold = true;
    let mut around = if is_map { rotations::walk(view, extent, &links) } else { None };
    if is_map && around.is_none() && links.note_leaving(view, extent).is_some() {
        // What a vertex keeps may be all that is wrong.
        vertices_hold = false;
        around = rotations::walk(view, extent, &links);
    }
    let Some(around) = around else {
        // The lists stand on their own, but their rules come after one that is broken.
        if !run.findings.wants_first_only() && links.next_holds && links.name_holds && extent.has(Part::Faces) {
            run.known.lists = boundaries::read(view, extent, &links, true).map(|lists| Lists::of(&lists));
        }
        return;
    };
    if vertices_hold && around.claimed.is_some() {
        run.known.vertices = Some(Vertices { live: around.vertices, isolated: around.isolated });
    }
    let turned = Turned { links, around };
    if !extent.has(Part::Faces) {
        run.known.turned = Some(turned);
        whole(run);
    } else if !turned.links.name_holds {
        run.known.turned = Some(turned);
    } else {
        let walked = extent.expect.surface_kind() != Surface::Plane;
        match boundaries::read(view, extent, &turned.links, walked) {
            Some(lists) => listed(run, extent, turned, &lists),
            None => run.known.turned = Some(turned),
        }
    }
}

/// Where the lists are right, or right if the components are as many as they leave room for: what follows of the whole.
fn listed<V: View + ?Sized>(run: &mut Run<'_, V>, extent: Extent, turned: Turned, lists: &Boundaries) {
    let Some(unnamed) = boundaries::cycles(run.view, extent, &turned.links, false) else { return };
    let claims_agree = agree(extent, &turned.around, lists);
    let cycles = Cycles { named: lists.cycles, unnamed: unnamed.unnamed };
    let Some(mut whole) = join(run.view, extent, turned, &cycles) else { return };
    run.known.lists = Some(Lists::of(lists));
    run.known.isolated = claims_agree;
    if extent.expect.surface_kind() == Surface::Plane && extent.has(Part::Holes) {
        run.known.outsides = outsides(&mut whole.components, lists, extent.has(Part::UnboundedFace)).is_some();
    }
    run.known.whole = Some(whole);
}

/// The rest of B2: as many isolated vertices name a boundary component as are listed. By record each names what starts at it;
/// otherwise those listed are marked, so it suffices to count.
fn agree(extent: Extent, around: &Rotations, lists: &Boundaries) -> bool {
    if extent.has(Part::BoundaryComponents) {
        around.claimed == Some(lists.at_vertex)
    } else {
        lists.vertices_hold && (around.isolated == lists.at_vertex || !extent.has(Part::UnboundedFace))
    }
}

/// Where the rotations are right, and the lists may be wrong: finds the components and the genus from the cycles.
pub(super) fn whole<V: View + ?Sized>(run: &mut Run<'_, V>) {
    let Some(turned) = run.known.turned.take() else { return };
    let extent = Extent::of(run);
    let Some(cycles) = boundaries::cycles(run.view, extent, &turned.links, true) else { return };
    run.known.whole = join(run.view, extent, turned, &cycles);
}

/// The components and the genus; nothing if T3 is broken.
fn join<V: View + ?Sized>(view: &V, extent: Extent, turned: Turned, cycles: &Cycles) -> Option<Whole> {
    let Turned { mut links, around } = turned;
    let loops = borders::loops(view, extent, &mut links)?;
    let (half_edges, unpaired) = (links.half_edges, links.unpaired);
    drop(links);
    let edges = (half_edges - unpaired) / 2 + unpaired;
    let borders = cycles.unnamed.len() + loops.len();
    // Euler's formula, where an isolated vertex has one cycle: V + cycles − E is twice the number of components, at genus 0.
    let twice = (around.vertices + cycles.named + borders + around.isolated).checked_sub(edges)?;
    let least = twice / 2;
    let simple = around.simple;
    let Joined { of, first } = components::join(view, extent, around, least.max(1))?;
    let genus = first.len().checked_sub(least)?;
    if twice % 2 != 0 || extent.expect.surface_kind() == Surface::Plane && genus > 0 {
        return None;
    }
    let mut all = Vec::new();
    all.try_reserve_exact(first.len()).ok()?;
    all.extend(first.into_iter().map(Component::at));
    for v in cycles.unnamed.iter().chain(&loops) {
        all.get_mut(*of.get(*v as usize)? as usize)?.open = true;
    }
    let components = Components { of, all, simple };
    Some(Whole { components, genus, cycles: cycles.named, borders })
}

/// T1: notes in which face each component lies.
fn outsides(components: &mut Components, lists: &Boundaries, every: bool) -> Option<()> {
    let Components { of, all, .. } = components;
    let mut twice = false;
    for entry in &lists.inner {
        let component = all.get_mut(*of.get(entry.vertex as usize)? as usize)?;
        twice |= component.lies_in != NIL;
        component.lies_in = entry.face;
    }
    let none = every && all.iter().any(|component| component.lies_in == NIL && !component.open);
    if twice || none {
        // T1 begins anew.
        all.iter_mut().for_each(|component| component.lies_in = NIL);
    }
    (!twice && !none).then_some(())
}
