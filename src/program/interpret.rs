//! The interpreter: it keeps the handles in order of creation and chooses among them as a program says.

use super::call::{Call, CallOf};
use super::op::{CornerPick, FacePick, HalfEdgePick, InnerPick, Op, Program, SecondPick, VertexPick};
use super::subject::{Corner, CornerOf, Refusal, Subject};
use crate::dcel::Side;
use alloc::vec::Vec;

/// What became of one operator of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum StepOutcome {
    /// The subject did it.
    Applied,
    /// The subject refused.
    Refused(Refusal),
    /// It was not asked: there is nothing (no half-edge, no stale handle, …) to choose from.
    Skipped,
}

impl core::fmt::Display for StepOutcome {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Applied => f.write_str("applied"),
            Self::Refused(refusal) => write!(f, "refused: {refusal}"),
            Self::Skipped => f.write_str("skipped: nothing to choose from"),
        }
    }
}

/// A subject together with all handles it ever gave out, in order of creation.
///
/// What a program chooses depends on these lists and on what the subject says of corners, faces and vertices, never on
/// the names of its records, so the same program does the same to every right subject.
#[derive(Clone, Debug)]
pub struct Runner<K: Subject> {
    subject: K,
    half_edges: Vec<K::HalfEdge>,
    isolated: Vec<K::Vertex>,
    retired_half_edges: Vec<K::HalfEdge>,
    retired_vertices: Vec<K::Vertex>,
    retired_faces: Vec<K::Face>,
}

/// What two corners must have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fit {
    Face,
    Vertex,
}

/// The `k`-th of a list that starts again where it ends.
fn nth<T: Copy>(list: &[T], k: u16) -> Result<T, StepOutcome> {
    let position = usize::from(k).checked_rem(list.len()).ok_or(StepOutcome::Skipped)?;
    list.get(position).copied().ok_or(StepOutcome::Skipped)
}

#[allow(clippy::needless_pass_by_value, reason = "what `map_err` hands over")]
fn refused<K: Subject>(error: K::Error) -> StepOutcome {
    StepOutcome::Refused(K::refusal(&error))
}

impl<K: Subject> Runner<K> {
    /// Starts with a subject that is the empty map.
    pub const fn new(subject: K) -> Self {
        Self {
            subject,
            half_edges: Vec::new(),
            isolated: Vec::new(),
            retired_half_edges: Vec::new(),
            retired_vertices: Vec::new(),
            retired_faces: Vec::new(),
        }
    }

    /// The subject.
    pub const fn subject(&self) -> &K {
        &self.subject
    }

    /// The subject, for good.
    pub fn into_subject(self) -> K {
        self.subject
    }

    /// The half-edges in order of creation; the two of an edge side by side.
    pub fn half_edges(&self) -> &[K::HalfEdge] {
        &self.half_edges
    }

    /// The isolated vertices in the order in which they became so.
    pub fn isolated(&self) -> &[K::Vertex] {
        &self.isolated
    }

    /// The half-edges that are gone.
    pub fn retired_half_edges(&self) -> &[K::HalfEdge] {
        &self.retired_half_edges
    }

    /// The vertices that are gone.
    pub fn retired_vertices(&self) -> &[K::Vertex] {
        &self.retired_vertices
    }

    /// The faces that are gone.
    pub fn retired_faces(&self) -> &[K::Face] {
        &self.retired_faces
    }

    /// All corners, those of half-edges first.
    pub fn corners(&self) -> impl Iterator<Item = CornerOf<K>> + '_ {
        let isolated = self.isolated.iter().copied().map(Corner::Isolated);
        self.half_edges.iter().copied().map(Corner::At).chain(isolated)
    }

    /// Runs a whole program and tells what became of each operator.
    pub fn run(&mut self, program: &Program) -> Vec<StepOutcome> {
        program.0.iter().map(|op| self.step(*op)).collect()
    }

    /// Runs one operator: chooses its arguments, and calls it.
    ///
    /// O(live elements) beside what the operator itself costs, and O(length²) of the boundary of the face that is split
    /// if some of its inner boundary components are to be chosen.
    pub fn step(&mut self, op: Op) -> StepOutcome {
        self.resolve(op).and_then(|call| self.call(call)).err().unwrap_or(StepOutcome::Applied)
    }

    /// What an operator would choose now. Costs what is said of [`Runner::step`].
    ///
    /// # Errors
    /// What becomes of the operator if it cannot choose: [`StepOutcome::Skipped`] where there is nothing to choose from, and
    /// [`StepOutcome::Refused`] where the subject refuses a question.
    pub fn resolve(&self, op: Op) -> Result<CallOf<K>, StepOutcome> {
        Ok(match op {
            Op::AddIsolatedVertex { face } => Call::AddIsolatedVertex { face: self.face(face)? },
            Op::RemoveIsolatedVertex { vertex } => Call::RemoveIsolatedVertex { vertex: self.vertex(vertex)? },
            Op::Connect { from, to, new_face, inner } => {
                let from = self.corner(from)?;
                let to = self.second(to, from, Fit::Face)?;
                Call::Connect { from, to, new_face, inner: self.inner(inner, from)? }
            }
            Op::RemoveEdge { half_edge } => Call::RemoveEdge { half_edge: self.half_edge(half_edge)? },
            Op::SplitEdge { half_edge } => Call::SplitEdge { half_edge: self.half_edge(half_edge)? },
            Op::JoinEdges { half_edge } => Call::JoinEdges { half_edge: self.half_edge(half_edge)? },
            Op::SplitVertex { from, to } => {
                let from = self.corner(from)?;
                Call::SplitVertex { from, to: self.second(to, from, Fit::Vertex)? }
            }
            Op::ContractEdge { half_edge } => Call::ContractEdge { half_edge: self.half_edge(half_edge)? },
            Op::FlipEdge { half_edge, turn } => Call::FlipEdge { half_edge: self.half_edge(half_edge)?, turn },
            Op::MoveInner { inner, face } => Call::MoveInner { inner: self.corner(inner)?, face: self.face(face)? },
        })
    }

    fn call(&mut self, call: CallOf<K>) -> Result<(), StepOutcome> {
        match call {
            Call::AddIsolatedVertex { face } => self.add_isolated_vertex(face),
            Call::RemoveIsolatedVertex { vertex } => self.remove_isolated_vertex(vertex),
            Call::Connect { from, to, new_face, inner } => self.connect(from, to, new_face, &inner),
            Call::RemoveEdge { half_edge } => self.remove_edge(half_edge),
            Call::SplitEdge { half_edge } => self.split_edge(half_edge),
            Call::JoinEdges { half_edge } => self.join_edges(half_edge),
            Call::SplitVertex { from, to } => self.split_vertex(from, to),
            Call::ContractEdge { half_edge } => self.contract_edge(half_edge),
            Call::FlipEdge { half_edge, turn } => self.subject.flip_edge(half_edge, turn).map_err(refused::<K>),
            Call::MoveInner { inner, face } => self.subject.move_inner(inner, face).map_err(refused::<K>),
        }
    }

    fn half_edge(&self, pick: HalfEdgePick) -> Result<K::HalfEdge, StepOutcome> {
        match pick {
            HalfEdgePick::Live(k) => nth(&self.half_edges, k),
            HalfEdgePick::Retired(k) => nth(&self.retired_half_edges, k),
        }
    }

    fn vertex(&self, pick: VertexPick) -> Result<K::Vertex, StepOutcome> {
        match pick {
            VertexPick::Isolated(k) => nth(&self.isolated, k),
            VertexPick::OriginOf(k) => self.subject.origin_of(nth(&self.half_edges, k)?).map_err(refused::<K>),
            VertexPick::Retired(k) => nth(&self.retired_vertices, k),
        }
    }

    pub(super) fn corner(&self, pick: CornerPick) -> Result<CornerOf<K>, StepOutcome> {
        match pick {
            Corner::At(pick) => self.half_edge(pick).map(Corner::At),
            Corner::Isolated(pick) => self.vertex(pick).map(Corner::Isolated),
        }
    }

    fn face(&self, pick: FacePick) -> Result<K::Face, StepOutcome> {
        match pick {
            FacePick::Unbounded => Ok(self.subject.unbounded_face()),
            FacePick::Of(pick) => self.subject.face_of(self.corner(pick)?).map_err(refused::<K>),
            FacePick::Retired(k) => nth(&self.retired_faces, k),
        }
    }

    /// The vertex of a corner.
    fn vertex_of(&self, corner: CornerOf<K>) -> Result<K::Vertex, StepOutcome> {
        match corner {
            Corner::At(h) => self.subject.origin_of(h).map_err(refused::<K>),
            Corner::Isolated(v) => Ok(v),
        }
    }

    /// The places, in [`Runner::corners`], of those that fit a first one.
    pub(super) fn fitting(&self, first: CornerOf<K>, fit: Fit) -> Result<Vec<usize>, StepOutcome> {
        let corners = self.corners().enumerate();
        Ok(match fit {
            Fit::Face => {
                let face = self.subject.face_of(first).map_err(refused::<K>)?;
                let same = |corner| self.subject.face_of(corner).is_ok_and(|other| other == face);
                corners.filter(|(_, corner)| same(*corner)).map(|(place, _)| place).collect()
            }
            Fit::Vertex => {
                let vertex = self.vertex_of(first)?;
                let same = |corner| self.vertex_of(corner) == Ok(vertex);
                corners.filter(|(_, corner)| same(*corner)).map(|(place, _)| place).collect()
            }
        })
    }

    fn second(&self, pick: SecondPick, first: CornerOf<K>, fit: Fit) -> Result<CornerOf<K>, StepOutcome> {
        match pick {
            SecondPick::Any(pick) => self.corner(pick),
            SecondPick::Fitting(k) => {
                let place = nth(&self.fitting(first, fit)?, k)?;
                self.corners().nth(place).ok_or(StepOutcome::Skipped)
            }
        }
    }

    /// One corner of each boundary component to be named.
    fn inner(&self, pick: InnerPick, from: CornerOf<K>) -> Result<Vec<CornerOf<K>>, StepOutcome> {
        let mut named = Vec::new();
        if pick.mask != 0 {
            let face = self.subject.face_of(from).map_err(refused::<K>)?;
            let mut seen = Vec::new();
            self.append_boundary(from, &mut seen);
            let mut count = 0;
            for corner in self.corners() {
                if self.subject.face_of(corner).is_ok_and(|f| f == face) && !seen.contains(&corner) {
                    self.append_boundary(corner, &mut seen);
                    if pick.mask >> (count % 16) & 1 == 1 {
                        named.push(corner);
                    }
                    count += 1;
                }
            }
        }
        if let Some(also) = pick.also {
            named.push(self.corner(also)?);
        }
        Ok(named)
    }

    /// Appends all corners of one boundary component: no more than there are, even if the subject's cycle never closes.
    fn append_boundary(&self, corner: CornerOf<K>, corners: &mut Vec<CornerOf<K>>) {
        corners.push(corner);
        let Corner::At(start) = corner else { return };
        let mut h = start;
        for _ in 1..self.half_edges.len() {
            match self.subject.next_of(h) {
                Ok(next) if next != start => h = next,
                _ => return,
            }
            corners.push(Corner::At(h));
        }
    }

    fn add_isolated_vertex(&mut self, face: K::Face) -> Result<(), StepOutcome> {
        let v = self.subject.add_isolated_vertex(face).map_err(refused::<K>)?;
        self.isolated.push(v);
        Ok(())
    }

    fn remove_isolated_vertex(&mut self, v: K::Vertex) -> Result<(), StepOutcome> {
        self.subject.remove_isolated_vertex(v).map_err(refused::<K>)?;
        self.no_longer_isolated(v);
        self.retired_vertices.push(v);
        Ok(())
    }

    fn connect(
        &mut self,
        from: CornerOf<K>,
        to: CornerOf<K>,
        new_face: Side,
        inner: &[CornerOf<K>],
    ) -> Result<(), StepOutcome> {
        let n = self.subject.connect(from, to, new_face, inner).map_err(refused::<K>)?;
        for corner in [from, to] {
            if let Corner::Isolated(v) = corner {
                self.no_longer_isolated(v);
            }
        }
        self.made_edge(n)
    }

    fn remove_edge(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let ends = self.ends(h)?;
        let dropped = self.subject.remove_edge(h).map_err(refused::<K>)?;
        self.retired_faces.extend(dropped);
        self.retire_edge(h);
        for v in ends {
            self.perhaps_isolated(v);
        }
        Ok(())
    }

    fn split_edge(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let n = self.subject.split_edge(h).map_err(refused::<K>)?;
        self.made_edge(n)
    }

    fn join_edges(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let following = self.subject.next_of(h).map_err(refused::<K>)?;
        let v = self.subject.origin_of(following).map_err(refused::<K>)?;
        self.subject.join_edges(h).map_err(refused::<K>)?;
        self.retire_edge(following);
        self.retired_vertices.push(v);
        Ok(())
    }

    fn split_vertex(&mut self, from: CornerOf<K>, to: CornerOf<K>) -> Result<(), StepOutcome> {
        let n = self.subject.split_vertex(from, to).map_err(refused::<K>)?;
        if let Corner::Isolated(v) = from {
            self.no_longer_isolated(v);
        }
        self.made_edge(n)
    }

    fn contract_edge(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let [origin, target] = self.ends(h)?;
        let dropped = self.subject.contract_edge(h).map_err(refused::<K>)?;
        self.retire_edge(h);
        self.retired_vertices.push(dropped);
        self.perhaps_isolated(if dropped == origin { target } else { origin });
        Ok(())
    }

    fn ends(&self, h: K::HalfEdge) -> Result<[K::Vertex; 2], StepOutcome> {
        let target = self.subject.twin_of(h).and_then(|t| self.subject.origin_of(t));
        Ok([self.subject.origin_of(h).map_err(refused::<K>)?, target.map_err(refused::<K>)?])
    }

    fn made_edge(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let t = self.subject.twin_of(h).map_err(refused::<K>)?;
        self.half_edges.extend([h, t]);
        Ok(())
    }

    fn retire_edge(&mut self, h: K::HalfEdge) {
        if let Some(position) = self.half_edges.iter().position(|other| *other == h) {
            let first = position & !1;
            self.retired_half_edges.extend(self.half_edges.drain(first..first + 2));
        }
    }

    fn no_longer_isolated(&mut self, v: K::Vertex) {
        self.isolated.retain(|other| *other != v);
    }

    /// Lists a vertex that has just lost an edge among the isolated ones if it was its last.
    fn perhaps_isolated(&mut self, v: K::Vertex) {
        if self.subject.face_of(Corner::Isolated(v)).is_ok() && !self.isolated.contains(&v) {
            self.isolated.push(v);
        }
    }
}
