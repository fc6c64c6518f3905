//! The order in which the rules are run, and the columns that they share.

use super::components::Components;
use super::report::{Findings, Halt};
use super::{Collect, Counts, Expectation, Link, Part, Report, Rule, Unchecked, View};
use alloc::vec::Vec;

/// Nil in the validator's own columns.
pub(super) const NIL: u32 = u32::MAX;

/// The rules of this module: all but the geometric ones.
const TOPOLOGICAL: &[Rule] = &[
    Rule::R1,
    Rule::L1,
    Rule::L2,
    Rule::L3,
    Rule::V1,
    Rule::V2,
    Rule::B1,
    Rule::B2,
    Rule::F1,
    Rule::F2,
    Rule::T1,
    Rule::T2,
    Rule::T3,
    Rule::T4,
];

/// A column of `n` entries, or the news that there is no memory for it.
pub(super) fn column<T: Clone>(n: u32, value: T) -> Result<Vec<T>, Halt> {
    let mut column = Vec::new();
    column.try_reserve_exact(n as usize).map_err(|_| Halt::OutOfMemory)?;
    column.resize(n as usize, value);
    Ok(column)
}

/// The half-edges that leave one vertex: how many there are, and one of them.
#[derive(Clone, Copy)]
pub(super) struct Fan {
    pub(super) degree: u32,
    pub(super) leaving: u32,
}

/// One run of the validator over one structure.
pub(super) struct Run<'a, V: ?Sized> {
    pub(super) view: &'a V,
    pub(super) expect: Expectation,
    pub(super) findings: Findings,
    pub(super) counts: Counts,
    /// Slots of each kind.
    pub(super) vertices: u32,
    pub(super) half_edges: u32,
    pub(super) boundaries: u32,
    pub(super) faces: u32,
    /// How many list entries may be read before it is plain that the lists are too long.
    pub(super) list_budget: usize,
    /// Whether the links among half-edges and vertices (all that makes the combinatorial map) are live.
    pub(super) map_is_live: bool,
    /// Per vertex: how many half-edges name it as their origin, and one of those.
    pub(super) fans: Vec<Fan>,
    /// Per boundary component: how many half-edges name it.
    pub(super) sizes: Vec<u32>,
    /// The components, once V2 is known to hold.
    pub(super) components: Option<Components>,
    /// `prev` as it follows from `next`, where the structure has none of its own.
    pub(super) derived_prev: Vec<u32>,
}

/// Validates any half-edge structure: rules R1 … T4.
///
/// Cost: O(n) time and memory, n being the number of slots of all kinds: 12 bytes per vertex and 52 per component where
/// every part is there and right, at most about 9 more per half-edge and 8 per vertex elsewhere. It does not panic
/// unless the [`View`] does, and it always ends.
pub fn validate<V: View + ?Sized>(view: &V, expectation: &Expectation, collect: Collect) -> Report {
    let mut run = Run {
        view,
        expect: *expectation,
        findings: Findings::new(collect),
        counts: Counts::default(),
        vertices: 0,
        half_edges: 0,
        boundaries: 0,
        faces: 0,
        list_budget: 0,
        map_is_live: true,
        fans: Vec::new(),
        sizes: Vec::new(),
        components: None,
        derived_prev: Vec::new(),
    };
    let mut bounds = None;
    let ended = run.measure().and_then(|()| {
        run.all_rules(&mut bounds).map_err(|halt| match halt {
            Halt::Found => Unchecked::Stopped,
            Halt::OutOfMemory => Unchecked::OutOfMemory,
        })
    });
    if let Err(why) = ended {
        run.none_checked(why);
    }
    let (outcomes, violations) = run.findings.into_parts(TOPOLOGICAL);
    Report { outcomes, violations, counts: run.counts, bounds }
}

impl<V: View + ?Sized> Run<'_, V> {
    fn measure(&mut self) -> Result<(), Unchecked> {
        let slots = |n: usize| u32::try_from(n).ok().filter(|n| *n < NIL).ok_or(Unchecked::TooLarge);
        self.vertices = slots(self.view.vertex_slots())?;
        self.half_edges = slots(self.view.half_edge_slots())?;
        if self.expect.has(Part::BoundaryComponents) {
            self.boundaries = slots(self.view.boundary_slots())?;
        }
        if self.expect.has(Part::Faces) {
            self.faces = slots(self.view.face_slots())?;
        }
        Ok(())
    }

    fn all_rules(&mut self, bounds: &mut Option<super::Bounds>) -> Result<(), Halt> {
        let glanced = self.glance();
        if !glanced {
            self.live()?;
            self.links()?;
            self.rotations()?;
            self.boundaries()?;
            self.faces()?;
        }
        self.topology(glanced, bounds)
    }

    /// Marks as not checked whatever has neither been checked nor has a reason of its own.
    fn none_checked(&mut self, why: Unchecked) {
        for rule in TOPOLOGICAL {
            self.findings.not_checked_yet(*rule, why);
        }
    }

    /// The first broken rule among those that make the half-edges and vertices a combinatorial map.
    pub(super) fn map_broken(&self) -> Option<Rule> {
        let map = if self.map_is_live { None } else { Some(Rule::R1) };
        map.or_else(|| self.findings.broken(&[Rule::L1, Rule::L2, Rule::L3]))
    }

    /// A link as a slot in range, or [`NIL`].
    fn slot(link: Link, slots: u32) -> u32 {
        match link {
            Some(i) if i < slots as usize => i as u32,
            _ => NIL,
        }
    }

    #[inline]
    pub(super) fn origin(&self, h: u32) -> u32 {
        Self::slot(self.view.origin(h as usize), self.vertices)
    }

    #[inline]
    pub(super) fn twin(&self, h: u32) -> u32 {
        Self::slot(self.view.twin(h as usize), self.half_edges)
    }

    #[inline]
    pub(super) fn next(&self, h: u32) -> u32 {
        Self::slot(self.view.next(h as usize), self.half_edges)
    }

    #[inline]
    pub(super) fn prev(&self, h: u32) -> u32 {
        Self::slot(self.view.prev(h as usize), self.half_edges)
    }

    #[inline]
    pub(super) fn boundary(&self, h: u32) -> u32 {
        Self::slot(self.view.boundary(h as usize), self.boundaries)
    }

    #[inline]
    pub(super) fn live_vertex(&self, v: u32) -> bool {
        v != NIL && self.view.is_vertex(v as usize)
    }

    #[inline]
    pub(super) fn live_half_edge(&self, h: u32) -> bool {
        h != NIL && self.view.is_half_edge(h as usize)
    }

    #[inline]
    pub(super) fn live_boundary(&self, b: u32) -> bool {
        b != NIL && self.view.is_boundary(b as usize)
    }

    /// Calls `visit` for each half-edge leaving `v` and its twin, in order of rotation, stopping when the walk returns or
    /// has met as many half-edges as name `v` as their origin. Tells how many it met. With an open boundary it goes on from
    /// the start in the other direction.
    #[inline]
    pub(super) fn around(&self, v: u32, mut visit: impl FnMut(u32, u32)) -> u32 {
        let Fan { degree, leaving: start } = self.fans[v as usize];
        let mut h = start;
        let mut seen = 0;
        while h != NIL && seen < degree {
            let t = self.twin(h);
            visit(h, t);
            seen += 1;
            h = if t == NIL { NIL } else { self.next(t) };
            if h == start {
                return seen;
            }
        }
        if !self.expect.is_open() {
            return seen;
        }
        let mut h = start;
        while seen < degree {
            h = self.before(h).map_or(NIL, |before| self.twin(before));
            if h == NIL || h == start {
                break;
            }
            visit(h, self.twin(h));
            seen += 1;
        }
        seen
    }

    /// The half-edge before `h` on its cycle.
    pub(super) fn before(&self, h: u32) -> Option<u32> {
        let before = if self.expect.has(Part::Prev) {
            self.prev(h)
        } else {
            self.derived_prev.get(h as usize).copied().unwrap_or(NIL)
        };
        (before != NIL).then_some(before)
    }

    /// The target of a half-edge without twin.
    pub(super) fn target_by_next(&self, h: u32) -> u32 {
        match self.next(h) {
            NIL => NIL,
            n => self.origin(n),
        }
    }
}
