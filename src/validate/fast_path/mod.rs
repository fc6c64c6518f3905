//! The common case first: a scan by index and walks around the vertices that settle R1 … T3 at once.
//!
//! Most structures that are validated are valid, and most of the others are wrong at few places. So the fast path reads every
//! link once or twice, counts, and gives what it has settled as [`Facts`]. Then the rules are run in order, each by the file
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
//! exactly what keeps R1 … T1 and T3. That is a proof of the model; `proofs/coq/compare --fast-path` runs it beside this code, and tests compare
//! this code with the rules. The rest is argued here and tested, not proved: structures that lack a part, open boundaries, other surfaces, cycles without faces, and what is
//! settled where something is wrong.
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
mod facts;
mod links;
mod marks;
mod rotations;
mod vertices;

pub(crate) use facts::{Facts, Rotations, Whole};

use super::columns::{Component, Components, NIL};
use super::structure::{Part, View};
use super::subject::{Extent, Subject};
use alloc::vec::Vec;
use boundaries::Boundaries;
use components::ComponentNumbers;
use cycles::Cycles;
use doubts::Assurances;
use facts::{ListFigures, VertexFigures};
use links::Links;
use rotations::{RotationWalk, VertexTally};

/// The place where the fast path stops reading a structure that is wrong.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stop {
    /// It reads all that can be settled.
    Never,
    /// After the first broken rule.
    AfterRule,
    /// At the first record that it cannot settle. A right structure has none.
    AtDoubt,
}

impl Stop {
    const fn most_doubts(self) -> usize {
        if matches!(self, Self::AtDoubt) { 0 } else { links::MOST_DOUBTS }
    }
}

/// Settles as much of R1 … T3 as can be.
pub(crate) fn settle<V: View + ?Sized>(subject: Subject<'_, V>, stop: Stop) -> Facts {
    let Subject { view, extent } = subject;
    let Some(mut links) = links::scan(view, extent, stop.most_doubts()) else { return Facts::default() };
    let (vertices, around) = turn(view, extent, &mut links, stop);
    if stop == Stop::AtDoubt && vertices.is_none() {
        return Facts::default();
    }
    // Lists can be read although the links or the rotations are wrong, but their rules come after one that is broken.
    let is_wanted = around.is_some() || stop == Stop::Never;
    let lists = if extent.has(Part::Faces) && is_wanted { boundaries::read(view, extent, &links) } else { None };
    let are_lists_settled = lists.is_some() || !extent.has(Part::Faces);
    if stop == Stop::AtDoubt && !are_lists_settled {
        return Facts::default();
    }
    let settled = Assurances { origins: around.is_some(), names: lists.is_some() && links.next_holds };
    let Some(doubts) = doubts::find(view, extent, &links, settled) else { return Facts::default() };
    let isolated_hold = around.as_ref().zip(lists.as_ref()).is_some_and(|(around, lists)| agree(extent, around, lists));
    let figures = lists.as_ref().map(|lists| ListFigures::of(lists, links.next_holds, isolated_hold));
    let rotations = match around {
        None => Rotations::Unknown,
        Some(around) => {
            let is_wanted = are_lists_settled || stop == Stop::Never;
            let whole = if is_wanted { whole(view, extent, links, around, lists) } else { None };
            whole.map_or(Rotations::Hold, Rotations::Whole)
        }
    };
    Facts { half_edges: Some(doubts), vertices, lists: figures, rotations }
}

/// Settles R1 … T1 and T3; none, at the first doubt, where one of them is broken.
pub(crate) fn settle_all<V: View + ?Sized>(subject: Subject<'_, V>) -> Option<Facts> {
    Some(settle(subject, Stop::AtDoubt)).filter(|facts| facts.are_all(subject.extent))
}

/// Walks around the vertices, where the links are right, and gives what holds of these.
fn turn<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    links: &mut Links,
    stop: Stop,
) -> (Option<VertexFigures>, Option<RotationWalk>) {
    let around = if links.are_right() { rotations::walk(view, extent, links) } else { None };
    if let Some(around) = around {
        return (VertexFigures::of(around.counted), Some(around));
    }
    if stop == Stop::AtDoubt {
        return (None, None);
    }
    if !links.are_right() {
        return (vertices::by_index(view, extent, links), None);
    }
    // The half-edges that vertices keep may be all that is wrong.
    let around = links.note_leaving(view, extent).and_then(|()| rotations::walk(view, extent, links));
    (None, around)
}

/// The rest of B2: as many isolated vertices name a boundary component as are listed. By record each names what starts at it;
/// otherwise those listed are marked, so it suffices to count.
fn agree(extent: Extent, around: &RotationWalk, lists: &Boundaries) -> bool {
    if extent.has(Part::BoundaryComponents) {
        around.counted.claimed == Some(lists.at_vertex)
    } else {
        !lists.is_vertex_wrong && (around.counted.isolated == lists.at_vertex || !extent.has(Part::UnboundedFace))
    }
}

/// Derives the facts about the whole where the rotations are right: none if T3 is broken. The cycles are those of the lists, or
/// those of `next` where there are no lists or they are wrong.
fn whole<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    links: Links,
    mut around: RotationWalk,
    lists: Option<Boundaries>,
) -> Option<Whole> {
    let Some(lists) = lists else {
        let cycles = around.cycles.take().or_else(|| cycles::count(view, extent, &links))?;
        return join(view, extent, links, around, &cycles);
    };
    let mut whole = join(view, extent, links, around, &lists.cycles)?;
    if extent.is_plane() && extent.has(Part::Holes) {
        whole.lies_in = outsides(&whole.components, &lists, extent.has(Part::UnboundedFace));
    }
    Some(whole)
}

/// The components and the genus; nothing if T3 is broken.
fn join<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    mut links: Links,
    around: RotationWalk,
    cycles: &Cycles,
) -> Option<Whole> {
    let VertexTally { vertices, isolated, simple, .. } = around.counted;
    let loops = borders::loops(view, extent, &mut links)?;
    let (half_edges, unpaired) = (links.half_edges, links.unpaired);
    drop(links);
    let edges = (half_edges - unpaired) / 2 + unpaired;
    let borders = cycles.unnamed.len() + loops.len();
    // Euler's formula, where an isolated vertex has one cycle: V + cycles − E is twice the number of components, at genus 0.
    // The sum is negative where the handles outnumber the components.
    let signed = |n: usize| i64::try_from(n).ok();
    let twice = signed(vertices + cycles.named + borders + isolated)? - signed(edges)?;
    if twice % 2 != 0 {
        return None;
    }
    let least = usize::try_from(twice / 2).unwrap_or(0);
    let ComponentNumbers { of, first } = components::join(view, extent, around, least.max(1))?;
    let genus = usize::try_from(signed(first.len())? - twice / 2).ok()?;
    if extent.is_plane() && genus > 0 {
        return None;
    }
    let mut all = Vec::new();
    all.try_reserve_exact(first.len()).ok()?;
    all.extend(first.into_iter().map(Component::at));
    for v in cycles.unnamed.iter().chain(&loops) {
        all.get_mut(*of.get(*v as usize)? as usize)?.open = true;
    }
    let components = Components { of, all, simple };
    Some(Whole { components, lies_in: None, genus, cycles: cycles.named, borders })
}

/// T1: for each component the face in which it lies. None if a component has two outsides, or `every` one needs one and some has none.
fn outsides(components: &Components, lists: &Boundaries, every: bool) -> Option<Vec<u32>> {
    let Components { of, all, .. } = components;
    let mut lies_in = Vec::new();
    lies_in.try_reserve_exact(all.len()).ok()?;
    lies_in.resize(all.len(), NIL);
    for entry in &lists.inner {
        let face = lies_in.get_mut(*of.get(entry.vertex as usize)? as usize)?;
        let first = core::mem::replace(face, entry.face);
        if first != NIL {
            return None;
        }
    }
    let lacks_one = |(component, face): (&Component, &u32)| *face == NIL && !component.open;
    (!(every && all.iter().zip(&lies_in).any(lacks_one))).then_some(lies_in)
}
