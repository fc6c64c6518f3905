//! The common case first: a scan by index and walks around the vertices that settle R1 … T3 at once.
//!
//! Most structures that are validated are valid, and most of the others are wrong at few places. So the fast path reads every
//! link once or twice, counts, and notes what it has settled ([`known`]). Then the rules are run in order, each by the file
//! that is named after it: what is settled they enter, and look only at the rest. The report is the same as that of
//! [`rule_by_rule`](super::reference::rule_by_rule). The fast path takes every expectation.
//!
//! ```text
//!   scan, by index:               along each cycle:             around v, from leaving(v):
//!
//!        h          n             ┌──► h ──► n ──► · ──┐              \   |   /
//!   ·────────►w────────►·         └────────────────────┘           ◄── \  |  / ──►
//!   ·◄────────w                   boundary(h) = b,                ─────── v ───────
//!        t                        face(b) lists b
//!   twin(t) = h ≠ t,                                            at an open boundary, across v,
//!   origin(n) = origin(t),                                      from the half-edge without twin that ends at v:
//!   prev(n) = h                                                     ──p──► v ──► · · · ──► v ──last──►
//! ```
//!
//! # Why this is enough
//!
//! The walks remember little, because they count. Say that the scan finds nothing wrong, that every step of every walk finds what the
//! picture says, that every walk returns to where it started, or at an open boundary ends at a half-edge without twin, and that
//! each kind of walk takes as many steps as there are half-edges.
//!
//! - The scan is L1 and L3, and it finds that `twin` and `next` lead from half-edges to half-edges. Where there is `prev`, each half-edge
//!   is the `prev` of its next, so `next` is a permutation, and `prev` is live and `next` undoes it (L2).
//! - By L3 the origin stays the same around a vertex, and `leaving(v)` leaves v, so the walks around different vertices do not meet,
//!   and visit every half-edge once, and each with its origin: that is V1 and V2, and R1 of origins. Where vertices keep no half-edge,
//!   the scan notes one of each that is the next of some half-edge; if there is none, too few half-edges are visited.
//! - At an open boundary a rotation that is not closed is a chain, and begins after a half-edge without twin that ends at the vertex. The
//!   scan notes one of these for each vertex; if it meets two, two fans share the vertex, and V2 is broken. A chain ends at the
//!   first half-edge without twin, so as many leave the vertex as end there: one. They follow one another around the border loops.
//! - Without `prev`, a step around a vertex leads from h to `next(twin(h))`. Each half-edge is reached by one step of one walk, or
//!   begins a chain as the next of one half-edge without twin. So no two half-edges have the same next: L2.
//! - The walks along the cycles start where faces list them. No two of them meet: their half-edges have different boundary
//!   components, or different faces, or they are marked. So they visit every half-edge once, and each names what lists its cycle
//!   (B1, and R1 of these names). Cycles that name nothing are border loops, and are marked, too.
//! - The faces list as many boundary components as there are, each of them once, by its own face, and each starts at a half-edge that
//!   names it, or at a vertex (F1, F2, and R1 of faces and boundary components).
//! - Each isolated vertex names a boundary component that starts at it, and there are as many of these as of those (B2).
//! - Without faces the walks around the vertices pass each half-edge once, together with its next, and the cycles are counted on the way;
//!   where the lists are wrong, a scan passes them. A cycle of up to four half-edges is counted by the one with the smallest number. The
//!   half-edges of longer cycles are marked, and in the end these cycles are walked along.
//! - Components are joined until as few are left as Euler's formula allows. It says that `V − E + cycles = 2C − 2g` with
//!   `g ≥ 0`, where border loops are cycles, so there are never fewer, and once there are as many, C is known and g is 0. Where all
//!   edges are used up before, the difference is the genus (T3).
//! - Then each component needs one inner boundary component, or none if a border loop is its outside (T1).
//!
//! # What of this is proved
//!
//! `proofs/coq/FastPath.v` models the scan with `prev`, the walks from what vertices keep and from records of boundary components, the
//! counts, the joining and T1: what structures in the plane with every part and without open boundary go through. It is proved to accept
//! exactly what keeps R1 … T1 and T3. That is a proof of the model; this code is compared with the rules by tests. The rest is argued
//! here and tested, not proved: structures that lack a part, open boundaries, other surfaces, cycles without faces, what is settled
//! where something is wrong, and what several threads read in parts.
//!
//! # Where something is wrong
//!
//! A half-edge at which the scan finds nothing wrong keeps L1 and L3, and R1 of `twin` and `next`, and its next L2. So the rules
//! look at the half-edges at which something is wrong, at their twins, and, by a second scan, at those that are the
//! next of no right half-edge, if any `next` or `prev` is wrong, at those whose origins are not live, if the rotations are wrong, and at those that name what
//! is not live or what the next does not name, if the lists are wrong. If they are too many, nothing is settled. Without `prev`, two
//! half-edges of the same next may be anywhere, and L looks at all.
//!
//! What is right in spite of that is settled: V1 and V2 where the links are right; T3 where V2 is, by all cycles of `next`; and the lists.
//!
//! Where some link is wrong, no walk around a vertex is sure to return. Then V1 is settled by index: each vertex keeps a half-edge that
//! leaves it, or keeps none, and none leaves it. Where some `next` is wrong, no walk along a cycle is sure to return, either. Then
//! F1 and F2 are settled without these walks, and that each start names what lists it. The rest of B1 needs the cycles, so it is not
//! checked where L2 or R1 is broken, but for half-edges that name a boundary component that starts at a vertex: where there is one,
//! B1 looks at all half-edges.

mod borders;
mod boundaries;
mod components;
mod cycles;
mod doubts;
mod extent;
pub(super) mod known;
mod links;
mod marks;
#[cfg(feature = "rayon")]
pub(super) mod parallel;
mod rotations;
mod vertices;

use super::columns::{Component, Components, NIL};
use super::expectation::{Part, Surface};
use super::run::Run;
use super::view::View;
use alloc::vec::Vec;
use boundaries::Boundaries;
use components::Joined;
use cycles::Cycles;
use doubts::Settled;
use extent::{Extent, Slots};
use known::{Known, Lists, Turned, Vertices, Whole};
use links::Links;
use rotations::{Counted, Rotations};

/// Finds out what holds of R1 … T3, part by part.
///
/// What is noted as known holds whatever else is broken.
pub(super) fn look<V: View + ?Sized>(run: &mut Run<'_, V>) {
    let (view, extent) = (run.view, extent_of(run));
    let Some(mut links) = links::scan(view, extent) else { return };
    let around = turn(run, extent, &mut links);
    // Where the links or the rotations are wrong the lists stand on their own, but their rules come after one that is broken.
    let is_wanted = around.is_some() || !run.findings.wants_first_only();
    let lists = if extent.has(Part::Faces) && is_wanted { boundaries::read(view, extent, &links) } else { None };
    let settled = Settled { origins: around.is_some(), names: lists.is_some() && links.next_holds };
    let Some(doubts) = doubts::find(view, extent, &links, settled) else {
        run.known = Known::default();
        return;
    };
    run.known.half_edges = Some(doubts);
    run.known.lists = lists.as_ref().map(|lists| Lists::of(lists, links.next_holds));
    let Some(around) = around else { return };
    let turned = Turned { links, around };
    match lists {
        Some(lists) => listed(run, extent, turned, &lists),
        None => run.known.turned = Some(turned),
    }
    if !extent.has(Part::Faces) {
        whole(run);
    }
}

/// Walks around the vertices, where the links are right, and notes what holds of these.
fn turn<V: View + ?Sized>(run: &mut Run<'_, V>, extent: Extent, links: &mut Links) -> Option<Rotations> {
    if !links.are_right() {
        run.known.vertices = vertices::by_index(run.view, extent, links);
        return None;
    }
    if let Some(around) = rotations::walk(run.view, extent, links) {
        run.known.vertices = Vertices::of(around.counted);
        return Some(around);
    }
    // What a vertex keeps may be all that is wrong.
    links.note_leaving(run.view, extent)?;
    rotations::walk(run.view, extent, links)
}

const fn extent_of<V: ?Sized>(run: &Run<'_, V>) -> Extent {
    Extent {
        vertices: Slots(run.vertices),
        half_edges: Slots(run.half_edges),
        boundaries: Slots(run.boundaries),
        faces: Slots(run.faces),
        expect: run.expect,
    }
}

/// Where the lists are right, too: what follows of the whole.
fn listed<V: View + ?Sized>(run: &mut Run<'_, V>, extent: Extent, turned: Turned, lists: &Boundaries) {
    run.known.isolated = agree(extent, &turned.around, lists);
    let Some(mut whole) = join(run.view, extent, turned, &lists.cycles) else { return };
    if extent.expect.surface_kind() == Surface::Plane && extent.has(Part::Holes) {
        run.known.outsides = outsides(&mut whole.components, lists, extent.has(Part::UnboundedFace)).is_some();
    }
    run.known.whole = Some(whole);
}

/// The rest of B2: as many isolated vertices name a boundary component as are listed. By record each names what starts at it;
/// otherwise those listed are marked, so it suffices to count.
fn agree(extent: Extent, around: &Rotations, lists: &Boundaries) -> bool {
    if extent.has(Part::BoundaryComponents) {
        around.counted.claimed == Some(lists.at_vertex)
    } else {
        !lists.is_vertex_wrong && (around.counted.isolated == lists.at_vertex || !extent.has(Part::UnboundedFace))
    }
}

/// Where the rotations are right, and the lists may be wrong: finds the components and the genus from the cycles.
pub(super) fn whole<V: View + ?Sized>(run: &mut Run<'_, V>) {
    let Some(mut turned) = run.known.turned.take() else { return };
    let extent = extent_of(run);
    let cycles = turned.around.cycles.take().or_else(|| cycles::count(run.view, extent, &turned.links));
    let Some(cycles) = cycles else { return };
    run.known.whole = join(run.view, extent, turned, &cycles);
}

/// The components and the genus; nothing if T3 is broken.
fn join<V: View + ?Sized>(view: &V, extent: Extent, turned: Turned, cycles: &Cycles) -> Option<Whole> {
    let Turned { mut links, around } = turned;
    let Counted { vertices, isolated, simple, .. } = around.counted;
    let loops = borders::loops(view, extent, &mut links)?;
    let (half_edges, unpaired) = (links.half_edges, links.unpaired);
    drop(links);
    let edges = (half_edges - unpaired) / 2 + unpaired;
    let borders = cycles.unnamed.len() + loops.len();
    // Euler's formula, where an isolated vertex has one cycle: V + cycles − E is twice the number of components, at genus 0.
    let twice = (vertices + cycles.named + borders + isolated).checked_sub(edges)?;
    let least = twice / 2;
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
        for component in all {
            component.lies_in = NIL;
        }
    }
    (!twice && !none).then_some(())
}
