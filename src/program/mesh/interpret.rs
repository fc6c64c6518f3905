//! The operators of triangle meshes in the interpreter: how the lists of handles follow them.
//!
//! ```text
//!        c                 c                                c
//!       ╱ ╲               ╱│╲             collapse         ╱│╲  f
//!      ╱   ╲   split     ╱ │ ╲              ──►           ╱ │ ╲
//!     a ──► b   ──►     a ─v─ b                             v
//!      ╲   ╱             ╲ │ ╱
//!       ╲ ╱               ╲│╱
//!        d                 d
//! ```
//!
//! Which handle a new edge has, and which of two edges that become one is kept, is left to the subject. So the new ones are found
//! from the half-edges of the surrounding boundary, which keep theirs.

use super::is_inside;
use crate::program::run::outcome::StepOutcome;
use crate::program::run::runner::Runner;
use crate::program::subject::{Refusal, Subject};

/// The two half-edges that follow `h` in a triangle to its left.
type Following<K> = [<K as Subject>::HalfEdge; 2];

/// An edge of a triangle that is to collapse, and where what becomes of it is found afterwards.
struct Merging<H> {
    /// The edges that become one.
    dropped: H,
    kept: H,
    /// After the collapse, so many half-edges after this one is the one that leads to the vertex opposite, or its twin.
    anchor: H,
    steps: usize,
    is_twin: bool,
}

impl<K: Subject> Runner<K> {
    pub(in crate::program) fn mesh_flip_edge(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let anchor = self.subject.twin_of(h).and_then(|t| self.subject.next_of(t));
        self.subject.mesh_flip_edge(h).map_err(StepOutcome::Refused)?;
        let turned = anchor.and_then(|anchor| self.subject.next_of(anchor)).map_err(StepOutcome::Refused)?;
        self.rename_edge(h, turned)
    }

    pub(in crate::program) fn mesh_split_edge(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let left = self.following(h);
        let right = self.subject.twin_of(h).and_then(|t| self.following(t));
        self.subject.mesh_split_edge(h).map_err(StepOutcome::Refused)?;
        let (left, right) = (left.map_err(StepOutcome::Refused)?, right.map_err(StepOutcome::Refused)?);
        // Of each side: the half-edges to the new vertex and from it, and the one from it to the vertex opposite.
        let around = |side: Option<Following<K>>| {
            side.map(|[second, third]| {
                let to = self.subject.next_of(third)?;
                let from = self.after(second, 2)?;
                Ok([to, from, self.subject.next_of(to)?])
            })
            .transpose()
        };
        let left = around(left).map_err(StepOutcome::Refused)?;
        let right = around(right).map_err(StepOutcome::Refused)?;
        let halves = match (left, right) {
            (Some([to, from, _]), _) => Ok([to, from]),
            (None, Some([to, from, _])) => {
                self.subject.twin_of(from).and_then(|first| Ok([first, self.subject.twin_of(to)?]))
            }
            (None, None) => Err(Refusal::Border),
        };
        let [first, second] = halves.map_err(StepOutcome::Refused)?;
        self.rename_edge(h, first)?;
        self.made_edge(second)?;
        [left, right].into_iter().flatten().try_for_each(|[_, _, spoke]| self.made_edge(spoke))
    }

    pub(in crate::program) fn mesh_split_face(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let following = self.following(h);
        self.subject.mesh_split_face(h).map_err(StepOutcome::Refused)?;
        let [second, third] = following.and_then(|sides| sides.ok_or(Refusal::Border)).map_err(StepOutcome::Refused)?;
        for side in [third, h, second] {
            let spoke = self.subject.next_of(side).map_err(StepOutcome::Refused)?;
            self.made_edge(spoke)?;
        }
        Ok(())
    }

    pub(in crate::program) fn mesh_collapse_edge(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let left = self.merging(h);
        let right = self.subject.twin_of(h).and_then(|t| self.merging(t));
        self.subject.mesh_collapse_edge(h).map_err(StepOutcome::Refused)?;
        let sides = [left.map_err(StepOutcome::Refused)?, right.map_err(StepOutcome::Refused)?];
        self.retire_edge(h);
        for Merging { dropped, kept, anchor, steps, is_twin } in sides.into_iter().flatten() {
            // The subject may keep either edge, so that the one that is dropped here has a place again with the other name.
            self.forget_edge(dropped);
            let found = self.after(anchor, steps).map_err(StepOutcome::Refused)?;
            let now = if is_twin { self.subject.twin_of(found).map_err(StepOutcome::Refused)? } else { found };
            self.rename_edge(kept, now)?;
        }
        Ok(())
    }

    /// The half-edge so many places after `h` on its cycle.
    fn after(&self, h: K::HalfEdge, places: usize) -> Result<K::HalfEdge, Refusal> {
        (0..places).try_fold(h, |h, _| self.subject.next_of(h))
    }

    /// The two half-edges after `h`, if a face lies to its left.
    fn following(&self, h: K::HalfEdge) -> Result<Option<Following<K>>, Refusal> {
        if !is_inside(&self.subject, h)? {
            return Ok(None);
        }
        Ok(Some([self.after(h, 1)?, self.after(h, 2)?]))
    }

    /// The edges of the triangle to the left of `h` that become one in a collapse, if a triangle is there.
    fn merging(&self, h: K::HalfEdge) -> Result<Option<Merging<K::HalfEdge>>, Refusal> {
        let Some([dropped, kept]) = self.following(h)? else { return Ok(None) };
        // Beyond `kept`, from the origin of `h` to the vertex opposite, there is a triangle, or else beyond `dropped`.
        let beyond = self.subject.twin_of(kept)?;
        Ok(Some(if is_inside(&self.subject, beyond)? {
            Merging { dropped, kept, anchor: self.after(beyond, 1)?, steps: 2, is_twin: true }
        } else {
            let beyond = self.subject.twin_of(dropped)?;
            Merging { dropped, kept, anchor: self.after(beyond, 2)?, steps: 1, is_twin: false }
        }))
    }

    /// Puts another handle in the place of `h`, and its twin in the place of the other half-edge of the edge. If that is the handle of
    /// another edge, the operator has not done what it should, and the lists stay as they are.
    fn rename_edge(&mut self, h: K::HalfEdge, now: K::HalfEdge) -> Result<(), StepOutcome> {
        let twin = self.subject.twin_of(now).map_err(StepOutcome::Refused)?;
        let place = |h: K::HalfEdge| self.half_edges.iter().position(|other| *other == h);
        let [before, known] = [place(h), place(now)];
        let free = before.filter(|before| known.is_none_or(|known| known / 2 == before / 2));
        if let Some(place) = free {
            self.half_edges[place] = now;
            self.half_edges[place ^ 1] = twin;
        }
        Ok(())
    }
}
