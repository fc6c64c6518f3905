//! The facts that the scan and the walks have settled, for the rules to enter or to start from.

use super::boundaries::Boundaries;
use super::doubts::Doubts;
use super::rotations::VertexTally;
use crate::validate::columns::Components;
use crate::validate::structure::Part;
use crate::validate::subject::Extent;
use alloc::vec::Vec;

/// The facts that hold already, whatever else is broken. Where a field is none, nothing of it is settled.
#[derive(Default)]
pub(crate) struct Facts {
    /// R1, L1 … L3 and the part of B1 that compares a half-edge with the next, of all half-edges but those in doubt.
    pub(crate) half_edges: Option<Doubts>,
    /// V1, and R1 of vertices.
    pub(crate) vertices: Option<VertexFigures>,
    /// F1, F2, R1 of boundary components and faces, and that starts name what lists them.
    pub(crate) lists: Option<ListFigures>,
    /// V2, and where T3 holds, the whole.
    pub(crate) rotations: Rotations,
}

/// The facts about the rotations of the vertices.
#[derive(Default)]
pub(crate) enum Rotations {
    /// Nothing is settled.
    #[default]
    Unknown,
    /// V2 holds.
    Hold,
    /// V2 and T3 hold.
    Whole(Whole),
}

/// The numbers of vertices.
#[derive(Clone, Copy)]
pub(crate) struct VertexFigures {
    pub(crate) live: usize,
    pub(crate) isolated: usize,
    /// The isolated ones that name a boundary component that starts at them. No other vertex names one.
    pub(crate) claimed: usize,
}

/// The numbers of faces and of what they list.
#[derive(Clone, Copy)]
pub(crate) struct ListFigures {
    pub(crate) faces: usize,
    pub(crate) outer: usize,
    pub(crate) inner: usize,
    /// The inner ones that start at a vertex.
    pub(crate) at_vertex: usize,
    /// The rest of B1: each cycle has the half-edges that name what lists it, and no others.
    pub(crate) cycles_hold: bool,
    /// B2.
    pub(crate) isolated_hold: bool,
}

/// The components, and the figures of the whole.
pub(crate) struct Whole {
    pub(crate) components: Components,
    /// T1: for each component the face in which it lies, or nil.
    pub(crate) lies_in: Option<Vec<u32>>,
    pub(crate) genus: usize,
    /// Cycles that are no border loops.
    pub(crate) cycles: usize,
    pub(crate) borders: usize,
}

impl Facts {
    /// True if R1 … T1 and T3 are settled.
    pub(super) fn are_all(&self, extent: Extent) -> bool {
        let lies_in_faces = extent.is_plane() && extent.has(Part::Holes);
        self.half_edges.as_ref().is_some_and(|doubts| doubts.half_edges.is_empty())
            && self.vertices.is_some()
            && (!extent.has(Part::Faces) || self.lists.is_some_and(|lists| lists.cycles_hold && lists.isolated_hold))
            && matches!(&self.rotations, Rotations::Whole(whole) if whole.lies_in.is_some() || !lies_in_faces)
    }

    /// True if V2 is settled.
    pub(crate) const fn rotations_hold(&self) -> bool {
        !matches!(self.rotations, Rotations::Unknown)
    }
}

impl ListFigures {
    pub(super) fn of(lists: &Boundaries, cycles_hold: bool, isolated_hold: bool) -> Self {
        let Boundaries { faces, outer, at_vertex, .. } = *lists;
        Self { faces, outer, inner: lists.inner.len(), at_vertex, cycles_hold, isolated_hold }
    }
}

impl VertexFigures {
    /// Those that the walks around the vertices have counted, if it is known what isolated ones name.
    pub(super) fn of(counted: VertexTally) -> Option<Self> {
        let VertexTally { vertices: live, isolated, claimed, .. } = counted;
        claimed.map(|claimed| Self { live, isolated, claimed })
    }
}
