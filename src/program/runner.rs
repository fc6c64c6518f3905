//! The interpreter: chooses arguments, applies operators, and keeps the lists of handles.

use super::arguments::{CornerPick, FacePick, Fit, HalfEdgePick, InnerPick, SecondPick, VertexPick};
use super::mesh::is_inside;
use super::operators::{Call, Handle, Op, Program};
use super::subject::{CallOf, CornerOf, Refusal, StepOutcome, Subject};
use crate::dcel::Corner;
use alloc::vec::Vec;

/// A subject with all handles it ever returned, in order of creation.
///
/// Choices depend on these lists and on the subject's answers about corners, faces and vertices, but not on the values of handles. A
/// program therefore does the same to every correct subject.
#[derive(Clone, Debug)]
pub struct Runner<K: Subject> {
    pub(in crate::program) subject: K,
    pub(in crate::program) half_edges: Vec<K::HalfEdge>,
    pub(in crate::program) isolated: Vec<K::Vertex>,
    pub(in crate::program) retired_half_edges: Vec<K::HalfEdge>,
    pub(in crate::program) retired_vertices: Vec<K::Vertex>,
    pub(in crate::program) retired_faces: Vec<K::Face>,
}

impl<K: Subject> Runner<K> {
    /// Starts with a subject that is the empty map.
    pub const fn new(subject: K) -> Self {
        Self::starting_with(subject, Vec::new(), Vec::new())
    }

    /// Starts with these half-edges, the two of an edge adjacent, and isolated vertices.
    pub(in crate::program) const fn starting_with(
        subject: K,
        half_edges: Vec<K::HalfEdge>,
        isolated: Vec<K::Vertex>,
    ) -> Self {
        Self {
            subject,
            half_edges,
            isolated,
            retired_half_edges: Vec::new(),
            retired_vertices: Vec::new(),
            retired_faces: Vec::new(),
        }
    }

    pub(in crate::program) fn forget_retired(&mut self) {
        self.retired_half_edges.clear();
        self.retired_vertices.clear();
        self.retired_faces.clear();
    }

    /// Returns the subject.
    pub const fn subject(&self) -> &K {
        &self.subject
    }

    /// Returns the subject, consuming the runner.
    pub fn into_subject(self) -> K {
        self.subject
    }

    /// The live half-edges in order of creation; the two of an edge are adjacent.
    pub fn half_edges(&self) -> &[K::HalfEdge] {
        &self.half_edges
    }

    /// The isolated vertices in the order in which they became isolated.
    pub fn isolated(&self) -> &[K::Vertex] {
        &self.isolated
    }

    /// The removed half-edges.
    pub fn retired_half_edges(&self) -> &[K::HalfEdge] {
        &self.retired_half_edges
    }

    /// The removed vertices.
    pub fn retired_vertices(&self) -> &[K::Vertex] {
        &self.retired_vertices
    }

    /// The removed faces.
    pub fn retired_faces(&self) -> &[K::Face] {
        &self.retired_faces
    }

    /// All corners, corners of half-edges first.
    pub fn corners(&self) -> impl Iterator<Item = CornerOf<K>> + '_ {
        let isolated = self.isolated.iter().copied().map(Corner::Isolated);
        self.half_edges.iter().copied().map(Corner::At).chain(isolated)
    }

    /// Runs a whole program, and returns the outcome of each operator.
    pub fn run(&mut self, program: &Program) -> Vec<StepOutcome> {
        program.0.iter().map(|op| self.step(*op)).collect()
    }

    /// Runs one operator: chooses its arguments, and applies it.
    ///
    /// O(live elements), plus the cost of the operator, plus O(length²) of the boundary of the split face if inner boundary components
    /// are chosen.
    pub fn step(&mut self, op: Op) -> StepOutcome {
        self.resolve(op).and_then(|call| self.apply(call)).err().unwrap_or(StepOutcome::Applied)
    }
}

/// The `k`-th entry, modulo the length of the list.
fn nth<T: Copy>(list: &[T], k: u32) -> Result<T, StepOutcome> {
    let position = (k as usize).checked_rem(list.len()).ok_or(StepOutcome::Skipped)?;
    list.get(position).copied().ok_or(StepOutcome::Skipped)
}

/// Resolves choices into handles.
impl<K: Subject> Runner<K> {
    /// Resolves the choices of an operator in the current state. Costs as much as [`Runner::step`].
    ///
    /// # Errors
    /// [`StepOutcome::Skipped`] if there is nothing to choose from; [`StepOutcome::Refused`] if the subject refuses a question.
    pub fn resolve(&self, op: Op) -> Result<CallOf<K>, StepOutcome> {
        Ok(match op {
            Op::AddIsolatedVertex { face } => Call::AddIsolatedVertex { face: self.face(face)? },
            Op::RemoveIsolatedVertex { vertex } => Call::RemoveIsolatedVertex { vertex: self.vertex(vertex)? },
            Op::Connect { from, to, new_face, inner } => {
                let from = self.corner(from)?;
                Call::Connect { from, to: self.second(to, from, Fit::Face)?, new_face, inner: self.inner(inner, from)? }
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
            Op::MeshFlipEdge { half_edge } => Call::MeshFlipEdge { half_edge: self.half_edge(half_edge)? },
            Op::MeshSplitEdge { half_edge } => Call::MeshSplitEdge { half_edge: self.half_edge(half_edge)? },
            Op::MeshSplitFace { half_edge } => Call::MeshSplitFace { half_edge: self.half_edge(half_edge)? },
            Op::MeshCollapseEdge { half_edge } => Call::MeshCollapseEdge { half_edge: self.half_edge(half_edge)? },
        })
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
            VertexPick::OriginOf(k) => Ok(self.subject.origin_of(nth(&self.half_edges, k)?)?),
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
            FacePick::Unbounded => self.subject.unbounded_face().ok_or(StepOutcome::Skipped),
            FacePick::Of(pick) => Ok(self.subject.face_of(self.corner(pick)?)?),
            FacePick::Retired(k) => nth(&self.retired_faces, k),
        }
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

    fn inner(&self, pick: InnerPick, from: CornerOf<K>) -> Result<Vec<CornerOf<K>>, StepOutcome> {
        let mut named = Vec::new();
        if pick.mask != 0 {
            let face = self.subject.face_of(from)?;
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

    fn vertex_of(&self, corner: CornerOf<K>) -> Result<K::Vertex, StepOutcome> {
        match corner {
            Corner::At(h) => Ok(self.subject.origin_of(h)?),
            Corner::Isolated(v) => Ok(v),
        }
    }

    /// The places, in [`Runner::corners`], of the corners that fit the first one.
    pub(super) fn fitting(&self, first: CornerOf<K>, fit: Fit) -> Result<Vec<usize>, StepOutcome> {
        let corners = self.corners().enumerate();
        Ok(match fit {
            Fit::Face if self.subject.face_of(first) == Err(Refusal::Unsupported) => {
                // Without faces, each cycle is a face.
                let mut cycle = Vec::new();
                self.append_boundary(first, &mut cycle);
                corners.filter(|(_, corner)| cycle.contains(corner)).map(|(place, _)| place).collect()
            }
            Fit::Face => {
                let face = self.subject.face_of(first)?;
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

    /// Appends all corners of one boundary component. Terminates even if the subject's cycle never closes.
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
}

impl<K: Subject> Runner<K> {
    pub(super) fn apply(&mut self, call: CallOf<K>) -> Result<(), StepOutcome> {
        match call {
            Call::AddIsolatedVertex { .. } => {
                if let Some(Handle::Vertex(v)) = self.subject.apply(call)? {
                    self.isolated.push(v);
                }
            }
            Call::RemoveIsolatedVertex { vertex } => {
                self.subject.apply(call)?;
                self.no_longer_isolated(Corner::Isolated(vertex));
                self.retired_vertices.push(vertex);
            }
            Call::Connect { from, to, .. } => {
                let n = self.subject.make_edge(call)?;
                self.no_longer_isolated(from);
                self.no_longer_isolated(to);
                self.made_edge(n)?;
            }
            Call::RemoveEdge { half_edge } => {
                let ends = self.ends(half_edge);
                if let Some(Handle::Face(dropped)) = self.subject.apply(call)? {
                    self.retired_faces.push(dropped);
                }
                self.retire_edge(half_edge);
                // A stale handle has no ends. If the subject accepts it all the same, the outcome shows that.
                for v in ends.into_iter().flatten() {
                    self.perhaps_isolated(v);
                }
            }
            Call::SplitEdge { .. } => {
                let n = self.subject.make_edge(call)?;
                self.made_edge(n)?;
            }
            Call::JoinEdges { half_edge } => {
                let following =
                    self.subject.next_of(half_edge).and_then(|next| Ok((next, self.subject.origin_of(next)?)));
                if following == Err(Refusal::Unsupported) {
                    // On a border without `next`, the edge to be removed is unknown.
                    return Err(StepOutcome::Refused(Refusal::Unsupported));
                }
                self.subject.apply(call)?;
                if let Ok((following, v)) = following {
                    self.retire_edge(following);
                    self.retired_vertices.push(v);
                }
            }
            Call::SplitVertex { from, .. } => {
                let n = self.subject.make_edge(call)?;
                self.no_longer_isolated(from);
                self.made_edge(n)?;
            }
            Call::ContractEdge { half_edge } => {
                let ends = self.ends(half_edge);
                let given = self.subject.apply(call)?;
                self.retire_edge(half_edge);
                if let Some(Handle::Vertex(dropped)) = given {
                    self.retired_vertices.push(dropped);
                    if let Ok([origin, target]) = ends {
                        self.perhaps_isolated(if dropped == origin { target } else { origin });
                    }
                }
            }
            Call::FlipEdge { .. } | Call::MoveInner { .. } => {
                self.subject.apply(call)?;
            }
            Call::MeshFlipEdge { half_edge } => self.mesh_flip_edge(half_edge)?,
            Call::MeshSplitEdge { half_edge } => self.mesh_split_edge(half_edge)?,
            Call::MeshSplitFace { half_edge } => self.mesh_split_face(half_edge)?,
            Call::MeshCollapseEdge { half_edge } => self.mesh_collapse_edge(half_edge)?,
        }
        Ok(())
    }

    /// The ends of an edge, read before it is removed. Refuses a stale handle, but the operator itself must report that.
    fn ends(&self, h: K::HalfEdge) -> Result<[K::Vertex; 2], Refusal> {
        let target = self.subject.twin_of(h).and_then(|t| self.subject.origin_of(t));
        Ok([self.subject.origin_of(h)?, target?])
    }

    fn made_edge(&mut self, h: K::HalfEdge) -> Result<(), Refusal> {
        let t = self.subject.twin_of(h)?;
        self.half_edges.extend([h, t]);
        Ok(())
    }

    fn retire_edge(&mut self, h: K::HalfEdge) {
        let gone = self.forget_edge(h);
        self.retired_half_edges.extend(gone.into_iter().flatten());
    }

    fn forget_edge(&mut self, h: K::HalfEdge) -> Option<[K::HalfEdge; 2]> {
        let first = self.half_edges.iter().position(|other| *other == h)? & !1;
        let twin = self.half_edges.remove(first + 1);
        Some([self.half_edges.remove(first), twin])
    }

    fn no_longer_isolated(&mut self, corner: CornerOf<K>) {
        self.isolated.retain(|v| Corner::Isolated(*v) != corner);
    }

    /// Lists a vertex that has lost an edge as isolated, if the edge was its last.
    fn perhaps_isolated(&mut self, v: K::Vertex) {
        if self.subject.face_of(Corner::Isolated(v)).is_ok() && !self.isolated.contains(&v) {
            self.isolated.push(v);
        }
    }
}

type Following<K> = [<K as Subject>::HalfEdge; 2];

/// A triangle that collapses with an edge, and the place of its merged edge afterwards.
struct Merging<H> {
    /// The merging edges.
    dropped: H,
    kept: H,
    /// After the collapse, the half-edge `steps` after this one, or its twin, leads to the opposite vertex.
    anchor: H,
    steps: usize,
    is_twin: bool,
}

/// Updates the lists for the operators of triangle meshes.
///
/// ```text
///        c                 c                                c
///       ╱ ╲               ╱│╲             collapse         ╱│╲  f
///      ╱   ╲   split     ╱ │ ╲              ──►           ╱ │ ╲
///     a ──► b   ──►     a ─v─ b                             v
///      ╲   ╱             ╲ │ ╱
///       ╲ ╱               ╲│╱
///        d                 d
/// ```
///
/// The subject chooses the handle of a new edge and the survivor of two merged edges. So new handles are found from the half-edges of
/// the surrounding boundary, which keep theirs.
impl<K: Subject> Runner<K> {
    fn mesh_flip_edge(&mut self, h: K::HalfEdge) -> Result<(), Refusal> {
        let anchor = self.subject.twin_of(h).and_then(|t| self.subject.next_of(t));
        self.subject.apply(Call::MeshFlipEdge { half_edge: h })?;
        let turned = anchor.and_then(|anchor| self.subject.next_of(anchor))?;
        self.rename_edge(h, turned)
    }

    fn mesh_split_edge(&mut self, h: K::HalfEdge) -> Result<(), Refusal> {
        let left = self.following(h);
        let right = self.subject.twin_of(h).and_then(|t| self.following(t));
        self.subject.apply(Call::MeshSplitEdge { half_edge: h })?;
        let (left, right) = (left?, right?);
        // On each side: the half-edges to and from the new vertex, and the half-edge from it to the opposite vertex.
        let around = |side: Option<Following<K>>| -> Result<_, Refusal> {
            side.map(|[second, third]| {
                let to = self.subject.next_of(third)?;
                let from = self.after(second, 2)?;
                Ok([to, from, self.subject.next_of(to)?])
            })
            .transpose()
        };
        let left = around(left)?;
        let right = around(right)?;
        let halves = match (left, right) {
            (Some([to, from, _]), _) => Ok([to, from]),
            (None, Some([to, from, _])) => {
                self.subject.twin_of(from).and_then(|first| Ok([first, self.subject.twin_of(to)?]))
            }
            (None, None) => Err(Refusal::Border),
        };
        let [first, second] = halves?;
        self.rename_edge(h, first)?;
        self.made_edge(second)?;
        [left, right].into_iter().flatten().try_for_each(|[_, _, spoke]| self.made_edge(spoke))
    }

    fn mesh_split_face(&mut self, h: K::HalfEdge) -> Result<(), Refusal> {
        let following = self.following(h);
        self.subject.apply(Call::MeshSplitFace { half_edge: h })?;
        let [second, third] = following.and_then(|sides| sides.ok_or(Refusal::Border))?;
        for side in [third, h, second] {
            let spoke = self.subject.next_of(side)?;
            self.made_edge(spoke)?;
        }
        Ok(())
    }

    fn mesh_collapse_edge(&mut self, h: K::HalfEdge) -> Result<(), Refusal> {
        let left = self.merging(h);
        let right = self.subject.twin_of(h).and_then(|t| self.merging(t));
        self.subject.apply(Call::MeshCollapseEdge { half_edge: h })?;
        let sides = [left?, right?];
        self.retire_edge(h);
        for Merging { dropped, kept, anchor, steps, is_twin } in sides.into_iter().flatten() {
            // If the subject keeps the other edge, the edge dropped here gets a place again under the other handle.
            self.forget_edge(dropped);
            let found = self.after(anchor, steps)?;
            let now = if is_twin { self.subject.twin_of(found)? } else { found };
            self.rename_edge(kept, now)?;
        }
        Ok(())
    }

    fn after(&self, h: K::HalfEdge, places: usize) -> Result<K::HalfEdge, Refusal> {
        (0..places).try_fold(h, |h, _| self.subject.next_of(h))
    }

    fn following(&self, h: K::HalfEdge) -> Result<Option<Following<K>>, Refusal> {
        if !is_inside(&self.subject, h)? {
            return Ok(None);
        }
        Ok(Some([self.after(h, 1)?, self.after(h, 2)?]))
    }

    /// The edges of the triangle to the left of `h` that merge in a collapse, if there is a triangle.
    fn merging(&self, h: K::HalfEdge) -> Result<Option<Merging<K::HalfEdge>>, Refusal> {
        let Some([dropped, kept]) = self.following(h)? else { return Ok(None) };
        // If there is no triangle beyond `kept`, from the origin of `h` to the opposite vertex, there is one beyond `dropped`.
        let beyond = self.subject.twin_of(kept)?;
        Ok(Some(if is_inside(&self.subject, beyond)? {
            Merging { dropped, kept, anchor: self.after(beyond, 1)?, steps: 2, is_twin: true }
        } else {
            let beyond = self.subject.twin_of(dropped)?;
            Merging { dropped, kept, anchor: self.after(beyond, 2)?, steps: 1, is_twin: false }
        }))
    }

    /// Replaces the handle of `h`, and of its twin. If the new handle belongs to another edge, the operator is faulty, and the lists
    /// stay unchanged.
    fn rename_edge(&mut self, h: K::HalfEdge, now: K::HalfEdge) -> Result<(), Refusal> {
        let twin = self.subject.twin_of(now)?;
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
