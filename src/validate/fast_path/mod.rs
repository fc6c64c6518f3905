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

mod boundaries;
mod components;
mod extent;
mod links;
mod marks;
mod rotations;

use super::columns::{Component, Components, NIL};
use super::counts::Counts;
use super::expectation::{Part, Surface};
use super::report::Unchecked;
use super::rule::Rule;
use super::run::Run;
use super::view::View;
use alloc::vec::Vec;
use boundaries::Inner;
use components::Joined;
use extent::Extent;
use rotations::Rotations;

/// Whether R1 … T3 hold. If so, their outcomes are entered, and all is known that later rules need; if not, nothing is.
pub(super) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> bool {
    if run.expect.is_open() {
        return false;
    }
    let extent = Extent {
        vertices: run.vertices as usize,
        half_edges: run.half_edges as usize,
        boundaries: run.boundaries as usize,
        faces: run.faces as usize,
        expect: run.expect,
    };
    let Some((counts, components)) = look(run.view, extent) else { return false };
    settle(run, counts, components);
    true
}

/// What the scan and the walks find, or nothing if something is wrong.
fn look<V: View + ?Sized>(view: &V, extent: Extent) -> Option<(Counts, Components)> {
    let links = links::scan(view, extent)?;
    let along = boundaries::walk(view, extent, &links)?;
    let around = rotations::walk(view, extent, &links)?;
    // By record each isolated vertex names what starts at it; otherwise those listed are marked, so it suffices to count.
    let claimed = if extent.has(Part::BoundaryComponents) { around.claimed } else { around.isolated };
    let may_be_unclaimed = !extent.has(Part::BoundaryComponents) && !extent.has(Part::UnboundedFace);
    if around.half_edges != links.half_edges || claimed != along.at_vertex && !may_be_unclaimed {
        return None;
    }
    let half_edges = links.half_edges;
    drop(links);
    let mut counts = Counts {
        vertices: around.vertices,
        half_edges,
        edges: half_edges / 2,
        faces: along.faces,
        outer_boundaries: along.outer,
        inner_boundaries: along.inner.len(),
        isolated_vertices: around.isolated,
        cycles: Some(along.cycles),
        borders: Some(0),
        ..Counts::default()
    };
    // Euler's formula, where an isolated vertex has one cycle: V + cycles − E is twice the number of components, at genus 0.
    let twice = (counts.vertices + along.cycles + around.isolated).checked_sub(counts.edges)?;
    let (components, genus) = join(view, extent, around, &along.inner, twice)?;
    counts.components = Some(components.all.len());
    counts.genus = Some(genus);
    Some((counts, components))
}

/// The components and the genus; nothing if T1 or T3 is broken.
fn join<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    around: Rotations,
    inner: &[Inner],
    twice: usize,
) -> Option<(Components, usize)> {
    let plane = extent.expect.surface_kind() == Surface::Plane;
    let least = twice / 2;
    let simple = around.simple;
    let Joined { of, first } = components::join(view, extent, around, least.max(1))?;
    let genus = first.len().checked_sub(least)?;
    if twice % 2 != 0 || plane && genus > 0 {
        return None;
    }
    let mut all = Vec::new();
    all.try_reserve_exact(first.len()).ok()?;
    all.extend(first.into_iter().map(Component::at));
    if plane && extent.has(Part::Holes) {
        outsides(&of, &mut all, inner, extent.has(Part::UnboundedFace))?;
    }
    Some((Components { of, all, simple }, genus))
}

/// T1: notes in which face each component lies.
fn outsides(of: &[u32], all: &mut [Component], inner: &[Inner], every: bool) -> Option<()> {
    for entry in inner {
        let component = all.get_mut(*of.get(entry.vertex as usize)? as usize)?;
        if component.lies_in != NIL {
            return None;
        }
        component.lies_in = entry.face;
    }
    (!every || inner.len() == all.len()).then_some(())
}

/// Enters what the rules would have counted one by one.
fn settle<V: View + ?Sized>(run: &mut Run<'_, V>, counts: Counts, components: Components) {
    let has = |part| run.expect.has(part);
    let half_edges = counts.half_edges as u64;
    let connected = (counts.vertices - counts.isolated_vertices) as u64;
    let by_record = has(Part::BoundaryComponents);
    let boundaries = (counts.outer_boundaries + counts.inner_boundaries) as u64;
    let links_of_half_edge = 3 + u64::from(has(Part::Prev)) + u64::from(has(Part::Faces));
    let link_of_vertex = u64::from(has(Part::Leaving) || by_record && has(Part::Holes));
    let links_of_boundary = if by_record { 2 } else { 0 };
    let others = [
        counts.vertices as u64 * link_of_vertex,
        boundaries * links_of_boundary,
        (counts.faces + counts.inner_boundaries) as u64,
    ];
    let findings = &mut run.findings;
    findings.checked(Rule::R1, half_edges * links_of_half_edge + others.iter().sum::<u64>());
    for rule in [Rule::L1, Rule::L2, Rule::L3] {
        findings.checked(rule, half_edges);
    }
    findings.checked(Rule::V2, connected);
    for (rule, needs, checked) in [
        (Rule::V1, [Part::Leaving].as_slice(), connected),
        (Rule::B1, &[Part::Faces], half_edges),
        (Rule::B2, &[Part::Faces, Part::Holes], counts.vertices as u64),
        (Rule::F1, &[Part::Faces], counts.faces as u64),
        (Rule::F2, &[Part::Faces], boundaries),
    ] {
        match needs.iter().find(|part| !run.expect.has(**part)) {
            Some(part) => findings.not_checked(rule, Unchecked::Lacks(*part)),
            None => findings.checked(rule, checked),
        }
    }
    let total = components.all.len() as u64;
    match run.containment_unchecked() {
        None => run.findings.checked(Rule::T1, total),
        Some(why) => run.findings.not_checked(Rule::T1, why),
    }
    run.findings.checked(Rule::T3, total);
    run.counts = counts;
    run.components = Some(components);
}
