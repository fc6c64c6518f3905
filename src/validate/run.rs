//! One run of the validator over one structure: what all rules share, and the ways in which they read the structure.

use super::columns::{Component, Components, Fan, NIL, column};
use super::counts::{Bounds, Counts};
use super::expectation::{Expectation, Part, Surface};
use super::fast_path::known::Known;
use super::findings::{Findings, Flow};
use super::report::{Collect, Unchecked};
use super::rule::Rule;
use super::view::{Link, Start, View};
use super::violation::Violation;
use alloc::vec::Vec;

/// One run of the validator over one structure.
pub(super) struct Run<'a, V: ?Sized> {
    pub(super) view: &'a V,
    pub(super) expect: Expectation,
    pub(super) findings: Findings,
    pub(super) counts: Counts,
    pub(super) bounds: Option<Bounds>,
    /// Slots of each kind.
    pub(super) vertices: u32,
    pub(super) half_edges: u32,
    pub(super) boundaries: u32,
    pub(super) faces: u32,
    /// How many list entries each rule reads. Lists with more are broken.
    pub(super) list_budget: usize,
    /// Whether the links among half-edges and vertices (all that makes the combinatorial map) are live.
    pub(super) map_is_live: bool,
    /// Per vertex: how many half-edges name it as their origin, and one of those.
    pub(super) fans: Vec<Fan>,
    /// What the fast path has settled.
    pub(super) known: Known,
    /// The components, once V2 is known to hold.
    pub(super) components: Option<Components>,
    /// `prev` as it follows from `next`, where the structure has none of its own.
    pub(super) derived_prev: Vec<u32>,
}

impl<'a, V: View + ?Sized> Run<'a, V> {
    /// A run of which nothing is known yet.
    pub(super) fn new(view: &'a V, expectation: Expectation, collect: Collect) -> Self {
        Self {
            view,
            expect: expectation,
            findings: Findings::new(collect),
            counts: Counts::default(),
            bounds: None,
            vertices: 0,
            half_edges: 0,
            boundaries: 0,
            faces: 0,
            list_budget: 0,
            map_is_live: true,
            fans: Vec::new(),
            known: Known::default(),
            components: None,
            derived_prev: Vec::new(),
        }
    }

    /// Asks for the numbers of slots.
    ///
    /// # Errors
    /// [`Unchecked::TooLarge`] if there are more of a kind than the columns can number.
    pub(super) fn measure(&mut self) -> Result<(), Unchecked> {
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

    /// How many half-edges R1, L1 … L3 and B1 look at one by one: all, or those that are in doubt.
    pub(super) fn in_doubt(&self) -> u32 {
        self.known.half_edges.as_ref().map_or(self.half_edges, |doubts| doubts.half_edges.len() as u32)
    }

    /// The half-edge at this position among those, if it is live.
    #[inline]
    pub(super) fn doubtful(&self, i: u32) -> Option<u32> {
        let h = match &self.known.half_edges {
            None => i,
            Some(doubts) => doubts.half_edges.get(i as usize).copied()?,
        };
        self.live_half_edge(h).then_some(h)
    }

    /// How many live half-edges are not in doubt.
    pub(super) fn beyond_doubt(&self) -> usize {
        self.known.half_edges.as_ref().map_or(0, |doubts| doubts.live.saturating_sub(doubts.half_edges.len()))
    }

    /// Counts the half-edges at each vertex, unless that is done.
    pub(super) fn count_fans(&mut self) -> Flow {
        if self.fans.len() == self.vertices as usize {
            return Ok(());
        }
        self.fans = column(self.vertices, Fan { degree: 0, leaving: NIL })?;
        for h in 0..self.half_edges {
            if !self.live_half_edge(h) {
                continue;
            }
            if let Some(fan) = self.view.origin(h as usize).and_then(|v| self.fans.get_mut(v)) {
                *fan = Fan { degree: fan.degree + 1, leaving: h };
            }
        }
        Ok(())
    }

    /// Notes what precedes each half-edge, where an open boundary needs it and nothing has noted it.
    pub(super) fn derive_prev(&mut self) -> Flow {
        if self.expect.has(Part::Prev) || !self.expect.is_open() || !self.derived_prev.is_empty() {
            return Ok(());
        }
        self.derived_prev = column(self.half_edges, NIL)?;
        for h in 0..self.half_edges {
            let next = self.next(h) as usize;
            if let Some(before) = self.derived_prev.get_mut(next).filter(|_| self.view.is_half_edge(h as usize)) {
                *before = h;
            }
        }
        Ok(())
    }

    /// The first broken rule among those that make the half-edges and vertices a combinatorial map.
    pub(super) fn map_broken(&self) -> Option<Rule> {
        let map = if self.map_is_live { None } else { Some(Rule::R1) };
        map.or_else(|| self.findings.broken(&[Rule::L1, Rule::L2, Rule::L3]))
    }

    /// The first broken rule among those that make the rotations of the vertices whole, so that components are known.
    pub(super) fn rotations_broken(&self) -> Option<Rule> {
        self.map_broken().or_else(|| self.findings.broken(&[Rule::V2]))
    }

    /// The rule without which a cycle does not either have a face or bound nothing, if it is broken: at an open boundary,
    /// border loops cannot be told from the others then.
    pub(super) fn borders_broken(&self) -> Option<Rule> {
        if self.expect.is_open() { self.findings.broken(&[Rule::B1]) } else { None }
    }

    /// Whether a rule that must be asked for is passed over: it was not asked for, or the one that it needs is broken, which
    /// is then entered as the reason.
    pub(super) fn passes_over(&mut self, rule: Rule, broken: Option<Rule>) -> bool {
        if !self.expect.asks_for(rule) {
            return true;
        }
        if let Some(broken) = broken {
            self.findings.not_checked(rule, Unchecked::Broken(broken));
        }
        broken.is_some()
    }

    /// Why T1 and T2 cannot be checked, if so.
    pub(super) fn containment_unchecked(&self) -> Option<Unchecked> {
        if self.expect.surface_kind() != Surface::Plane {
            return Some(Unchecked::PlaneOnly);
        }
        if !self.expect.has(Part::Holes) {
            return Some(Unchecked::Lacks(Part::Holes));
        }
        let below = [Rule::R1, Rule::V1, Rule::B1, Rule::B2, Rule::F1, Rule::F2];
        self.findings.broken(&below).map(Unchecked::Broken)
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

    /// The vertex where a half-edge ends, with twin or without.
    pub(super) fn target(&self, h: u32) -> u32 {
        match self.twin(h) {
            NIL => self.target_by_next(h),
            t => self.origin(t),
        }
    }

    /// The vertices that the edge of a half-edge joins, the smaller one first.
    pub(super) fn ends(&self, h: u32) -> [u32; 2] {
        let (origin, target) = (self.origin(h), self.target(h));
        [origin.min(target), origin.max(target)]
    }

    /// Whether the face link of a half-edge is live, or legally nil.
    pub(super) fn is_sound_face_link(&self, link: Link) -> bool {
        link.map_or(self.expect.is_open(), |f| f < self.faces as usize && self.view.is_face(f))
    }

    /// Whether the structure has faces and the half-edge has none, or no boundary component to have one: a cycle of such is a
    /// border loop.
    pub(super) fn lacks_face(&self, h: usize) -> bool {
        if self.expect.has(Part::BoundaryComponents) {
            self.view.boundary(h).is_none()
        } else {
            self.expect.has(Part::Faces) && self.view.face(h).is_none()
        }
    }

    /// Calls `visit` with each face, position and start of the inner lists, for structures without boundary components.
    pub(super) fn for_each_inner_start(
        &mut self,
        mut visit: impl FnMut(&mut Self, usize, usize, Start) -> Flow,
    ) -> Flow {
        if !self.expect.has(Part::Holes) {
            return Ok(());
        }
        let mut budget = self.list_budget;
        for f in 0..self.faces as usize {
            if !self.view.is_face(f) {
                continue;
            }
            let listed = self.view.inner_count(f).min(budget);
            budget -= listed;
            for i in 0..listed {
                if let Some(start) = self.view.inner_start(f, i) {
                    visit(self, f, i, start)?;
                }
            }
        }
        Ok(())
    }

    /// Reports, under R1, a list that is not read to its end: links that are not read cannot be said to be live.
    pub(super) fn list_too_long(&mut self, face: usize, claimed: usize) -> Flow {
        self.findings.not_checked(Rule::R1, Unchecked::ListTooLong);
        self.findings.add(Violation::ListTooLong { face, claimed })
    }

    /// The component of the vertex where a half-edge starts.
    pub(super) fn component_at<'c>(&self, components: &'c mut Components, h: u32) -> Option<&'c mut Component> {
        let c = components.of.get(self.origin(h) as usize).copied()?;
        components.all.get_mut(c as usize)
    }

    /// The number of the component in which a boundary component starts.
    pub(super) fn component_of_start(&self, components: &Components, start: Option<Start>) -> Option<usize> {
        let vertex = match start? {
            Start::HalfEdge(h) if h < self.half_edges as usize => self.origin(h as u32) as usize,
            Start::HalfEdge(_) => return None,
            Start::Vertex(v) => v,
        };
        components.of.get(vertex).filter(|c| **c != NIL).map(|c| *c as usize)
    }
}
