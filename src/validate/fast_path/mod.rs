//! The fast path: most validated structures are valid. It accepts a valid structure, or returns `None`.
//!
//! It checks R1 … T3 all at once. If they hold, it returns the counts of the report. If a record breaks a rule, or memory runs out, the
//! rules then look at every record. It supports every expectation.
//!
//! ```text
//!   around v, from leaving(v):                 at an open boundary, across v,
//!      \   |   /                               from the half-edge without twin that ends at v:
//!       \  |  / h                                  ──p──► v ──► · · · ──► v ──last──►
//!    ─── ─ v ───────►
//!       /  |  ◄───────                         at each step, n = next(t):
//!      / n |      t                            origin(n) = v, prev(n) = t, boundary(n) = boundary(t)
//! ```
//!
//! # Why this suffices
//!
//! Suppose that each step finds the relations in the picture, where `t = twin(h)`, `twin(t) = h ≠ t`, and `t` and `n` are live; that
//! each walk returns to its start, or at an open boundary ends at a half-edge without twin; and that all walks together take one step
//! per half-edge.
//!
//! - A walk that returns visits no half-edge twice, and walks around different vertices do not meet: their half-edges have different
//!   origins. So every half-edge `n` is visited once, by one step from one `t`. That is L1, L3, V1, V2 and R1 of half-edges; and `next`
//!   is a permutation with the inverse `prev` (L2).
//! - At an open boundary a rotation that is not closed is a chain, and begins after a half-edge without twin that ends at the vertex.
//!   These half-edges are recorded first. If two end at one vertex, two fans share it, and V2 is broken. A chain ends at the first
//!   half-edge without twin, so exactly one such half-edge ends at the vertex, and one leaves it. They follow one another around the
//!   border loops.
//! - If vertices store no half-edge, one that leaves each vertex is recorded first.
//! - Each boundary component is listed once, by the face it names, at the place it claims (F1, F2), and starts at a half-edge that
//!   names it, or at an isolated vertex that names it (B2). Without records, each start names the face that lists it, and the cycles of
//!   a face with several are marked. Names are constant along `next`, so all listed cycles differ: the number of cycles is at least the
//!   number of list entries. At an open boundary the cycles that name nothing are also counted.
//! - Euler's formula says `V − E + cycles = 2C − 2g`, where an isolated vertex has one cycle and border loops are cycles. So `V − E +
//!   listed ≤ 2C`. Components are joined until both sides are equal. Then every cycle is listed, which is the rest of B1 and of R1, and
//!   `g = 0` (T3).
//! - If all edges are used up before, there are handles, or cycles that are not listed. In the plane both are invalid. On surfaces, and
//!   without faces, the cycles are counted: a cycle of up to four half-edges at its smallest half-edge; longer cycles are walked and
//!   marked.
//! - Finally, each component needs one inner boundary component, unless a border loop is its outside (T1), and containment must not be
//!   circular (T2).
//!
//! # Evidence
//!
//! This argument is tested, not proved. Two of its parts are theorems of `proofs/coq`: Euler's formula for each component
//! (`component_euler`), and that components may be joined until Euler's formula allows no fewer (`few_sets_are_components`).
//! `proofs/coq/fast_path/FastPath.v` proves an older fast path, which scanned the half-edges by index and walked along every cycle, for the
//! closed plane with every part. `proofs/coq/compare --fast-path` compares the two on tables.

mod boundaries;
mod cycles;
mod rotations;

use super::findings::Halt;
use super::rules::whole::each_nested_in_itself;
use super::structure::{Part, View};
use super::subject::{Extent, Subject, column};
use crate::numbers::NIL;
use alloc::vec::Vec;
use boundaries::{Boundaries, Inner};
use rotations::ComponentNumbers;

/// The counts of a structure that keeps R1 … T3.
pub(crate) struct Accepted {
    pub(crate) vertices: usize,
    pub(crate) isolated: usize,
    pub(crate) half_edges: usize,
    pub(crate) unpaired: usize,
    pub(crate) faces: usize,
    pub(crate) outer: usize,
    pub(crate) inner: usize,
    pub(crate) components: usize,
    /// The number of cycles other than border loops.
    pub(crate) cycles: usize,
    pub(crate) borders: usize,
    pub(crate) genus: usize,
    /// True if there are neither loops nor parallel edges.
    pub(crate) simple: bool,
}

/// Accepts a structure that keeps R1 … T3, or returns `None`.
pub(crate) fn accept<V: View + ?Sized>(subject: Subject<'_, V>) -> Option<Accepted> {
    let Subject { view, extent } = subject;
    let mut starts = rotations::find_starts(view, extent)?;
    let around = rotations::walk(view, extent, &starts)?;
    let has_faces = extent.has(Part::Faces);
    let lists = if has_faces { boundaries::read(view, extent, &starts)? } else { Boundaries::default() };
    let is_claimed = if extent.has(Part::BoundaryComponents) {
        around.claimed == lists.at_vertex
    } else {
        around.isolated == lists.at_vertex || !extent.has(Part::UnboundedFace)
    };
    is_claimed.then_some(())?;
    let unnamed = if has_faces && extent.expect.is_open() { cycles::unnamed(view, extent)? } else { Vec::new() };
    let loops = if extent.expect.is_open() { cycles::border_loops(view, extent, &mut starts)? } else { Vec::new() };
    let cycles = if has_faces { lists.cycles() } else { cycles::count(view, extent)? };
    let borders = unnamed.len() + loops.len();

    let (half_edges, unpaired) = (starts.half_edges, starts.unpaired);
    drop(starts);
    let (vertices, isolated, simple) = (around.vertices, around.isolated, around.simple);
    // By Euler's formula, V + cycles − E is twice the number of components at genus 0. It is negative if there are more handles than
    // components.
    let signed = |n: usize| i64::try_from(n).ok();
    let edges = (half_edges - unpaired) / 2 + unpaired;
    let twice = signed(vertices + isolated + cycles + borders)? - signed(edges)?;
    let fewest = usize::try_from(twice / 2).unwrap_or(0).max(1);
    let ComponentNumbers { of, count } = rotations::join(view, extent, around, fewest)?;
    let twice_genus = usize::try_from(2 * signed(count)? - twice).ok()?;
    if twice_genus > 0 {
        let is_right = !extent.is_plane() && twice_genus % 2 == 0;
        (is_right && (!has_faces || cycles::count(view, extent)? == cycles + unnamed.len())).then_some(())?;
    }
    if extent.is_plane() && extent.has(Part::Holes) {
        let mut open = column(if borders > 0 { count as u32 } else { 0 }, false).ok()?;
        for v in unnamed.iter().chain(&loops) {
            *open.get_mut(*of.get(*v as usize)? as usize)? = true;
        }
        let lies_in = outsides(&of, count, &open, &lists.inner, extent)?;
        each_nested_in_itself(subject, &of, &lies_in, |_, _| Err(Halt::Found)).ok()?;
    }
    Some(Accepted {
        vertices,
        isolated,
        half_edges,
        unpaired,
        faces: lists.faces,
        outer: lists.outer,
        inner: lists.inner.len(),
        components: count,
        cycles,
        borders,
        genus: twice_genus / 2,
        simple,
    })
}

/// T1: the face in which each component lies. `None` if a component has two outsides, or lacks one that it needs.
fn outsides(of: &[u32], count: usize, open: &[bool], inner: &[Inner], extent: Extent) -> Option<Vec<u32>> {
    let mut lies_in = column(count as u32, NIL).ok()?;
    for entry in inner {
        let face = lies_in.get_mut(*of.get(entry.vertex as usize)? as usize)?;
        let first = core::mem::replace(face, entry.face);
        (first == NIL).then_some(())?;
    }
    let is_open = |c: usize| open.get(c).copied().unwrap_or(false);
    let lacks_one = |(c, face): (usize, &u32)| *face == NIL && !is_open(c);
    (!extent.has(Part::UnboundedFace) || !lies_in.iter().enumerate().any(lacks_one)).then_some(lies_in)
}
