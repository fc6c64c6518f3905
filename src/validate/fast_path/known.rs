//! What the scan and the walks have settled, for the rules to enter or to start from.

use super::boundaries::Boundaries;
use super::doubts::Doubts;
use super::links::Links;
use super::rotations::{Counted, Rotations};
use crate::validate::columns::Components;

/// What holds already, part by part. Nothing of what is none, or false, is known.
#[derive(Default)]
pub(in crate::validate) struct Known {
    /// R1, L1 … L3 and the part of B1 that compares a half-edge with the next: of all half-edges but some.
    pub(in crate::validate) half_edges: Option<Doubts>,
    /// V1, and R1 of vertices.
    pub(in crate::validate) vertices: Option<Vertices>,
    /// F1, F2, R1 of boundary components and faces, and that starts name what lists them. If all cycles were walked along, the rest of
    /// B1, too.
    pub(in crate::validate) lists: Option<Lists>,
    /// V2: what the scan and the walks around the vertices have found, until the components are joined from it.
    pub(super) turned: Option<Turned>,
    /// B2.
    pub(in crate::validate) isolated: bool,
    /// V2 and T3.
    pub(in crate::validate) whole: Option<Whole>,
    /// T1: each component knows in which face it lies.
    pub(in crate::validate) outsides: bool,
}

/// The scan and the walks around the vertices, where nothing is wrong with the rotations.
pub(super) struct Turned {
    pub(super) links: Links,
    pub(super) around: Rotations,
}

/// How many vertices there are.
#[derive(Clone, Copy)]
pub(in crate::validate) struct Vertices {
    pub(in crate::validate) live: usize,
    pub(in crate::validate) isolated: usize,
    /// How many of the isolated ones name a boundary component that starts at them. No other vertex names one.
    pub(in crate::validate) claimed: usize,
}

/// How much the faces list.
#[derive(Clone, Copy)]
pub(in crate::validate) struct Lists {
    pub(in crate::validate) faces: usize,
    pub(in crate::validate) outer: usize,
    pub(in crate::validate) inner: usize,
    /// How many of the inner ones start at a vertex.
    pub(in crate::validate) at_vertex: usize,
    /// Whether the cycles are known to have the half-edges that name what lists them, and no others.
    pub(in crate::validate) walked: bool,
}

impl Lists {
    pub(super) fn of(lists: &Boundaries, walked: bool) -> Self {
        let Boundaries { faces, outer, at_vertex, .. } = *lists;
        Self { faces, outer, inner: lists.inner.len(), at_vertex, walked }
    }
}

impl Vertices {
    /// What the walks around the vertices have counted, if it is known what isolated ones name.
    pub(super) fn of(counted: Counted) -> Option<Self> {
        let Counted { vertices: live, isolated, claimed, .. } = counted;
        claimed.map(|claimed| Self { live, isolated, claimed })
    }
}

impl Known {
    /// Whether V2 holds.
    pub(in crate::validate) const fn rotations_hold(&self) -> bool {
        self.turned.is_some() || self.whole.is_some()
    }
}

/// The whole, once its components are known and keep Euler's formula.
pub(in crate::validate) struct Whole {
    pub(in crate::validate) components: Components,
    pub(in crate::validate) genus: usize,
    /// Cycles that are no border loops.
    pub(in crate::validate) cycles: usize,
    pub(in crate::validate) borders: usize,
}
