//! Stable numbers for the half-edges of a mesh whose operators move them.

use crate::delegate_view;
use crate::program::operators::{Call, OpKind};
use crate::program::subject::{CallOf, HandleOf, Refusal, Subject};
use crate::validate::{Link, Start, View};
use alloc::boxed::Box;
use alloc::collections::{BTreeMap, BTreeSet};
use alloc::vec::Vec;
use core::fmt;

type Operator<M> = Box<dyn FnMut(&mut M, usize) -> Result<(), Refusal>>;

/// The place of a half-edge: twice its index in the mesh, plus one for the missing twin of that half-edge.
type Place = usize;
const NOWHERE: Place = usize::MAX;

/// A simple triangle mesh as a [`Subject`], even if its operators change the indices of half-edges or it does not store half-edges on
/// its border. The mesh is any [`View`]: it may have vacant slots, and `prev`, `leaving` and faces are optional.
///
/// Where `next` is arithmetic (`3 ⌊h / 3⌋ + (h + 1) mod 3`, as in corner tables and lists of triangles), an operator has to move
/// half-edges to other indices, so an index is not a handle. In a simple mesh no two half-edges have the same origin and target. So
/// every half-edge gets a stable number here, and is found again by its two ends after each operator. Vertices and faces keep their
/// indices.
///
/// Messages of [`conformance`](crate::program::conformance) contain these numbers (programs count differently: see
/// [`Program`](crate::program::Program)). To find half-edge 10 of a message in the mesh, run the program again:
///
/// ```no_run
/// # use twinedge::program::{conformance::{Counterexample, InStep}, mesh::Named};
/// # use twinedge::validate::{Expectation, View};
/// # fn find<M: View>(found: Counterexample, make: fn() -> Named<M>, expectation: Expectation) {
/// let mut steps = InStep::new(make(), &expectation).expect("the start is right");
/// let failure = found.program.0.iter().find_map(|op| steps.step(*op).err());
/// let named = steps.subject().subject();
/// println!("{failure:?}: in the mesh it is half-edge {:?}", named.in_mesh(10));
/// # }
/// ```
///
/// ```text
///        3 ◄────────── 2          A half-edge without twin gets one: it has no face
///        │ ╲   ╲       ▲          and no next. Here 4 half-edges of 6 have none, and
///        │   ╲   ╲     │          the mesh as it is seen has 10.
///        ▼     ╲   ╲   │
///        0 ──────────► 1
/// ```
///
/// O(n log n) per operator, for n half-edges. The view is the mesh's, renumbered, at O(log n) per question.
///
/// ```
/// use std::collections::BTreeSet;
/// use twinedge::program::mesh::Named;
/// use twinedge::program::{Refusal, conformance};
/// use twinedge::validate::{Expectation, Part, Parts};
/// use twinedge::view_answers;
///
/// /// Triangles: half-edge `3t + i` leads from corner `i` of triangle `t` to the next.
/// #[derive(Clone)]
/// struct Triangles(Vec<[usize; 3]>);
///
/// impl Triangles {
///     fn origin(&self, h: usize) -> usize { self.0[h / 3][h % 3] }
///     fn target(&self, h: usize) -> usize { self.0[h / 3][(h + 1) % 3] }
///     fn twin(&self, h: usize) -> Option<usize> {
///         (0..3 * self.0.len()).find(|t| (self.origin(*t), self.target(*t)) == (self.target(h), self.origin(h)))
///     }
///     fn flip(&mut self, h: usize) -> Result<(), Refusal> {
///         let twin = self.twin(h).ok_or(Refusal::Border)?;
///         let across = |h: usize| self.0[h / 3][(h + 2) % 3];
///         let (a, b, c, d) = (self.origin(h), self.origin(twin), across(h), across(twin));
///         if self.0.iter().any(|t| t.contains(&c) && t.contains(&d)) { return Err(Refusal::NotSimple); }
///         (self.0[h / 3], self.0[twin / 3]) = ([a, d, c], [b, c, d]);
///         Ok(())
///     }
/// }
///
/// impl twinedge::validate::View for Triangles {
///     view_answers! { |m|
///         parts => Parts::NONE.with(Part::Faces),
///         vertex_slots => m.0.iter().flatten().max().map_or(0, |v| v + 1),
///         half_edge_slots => 3 * m.0.len(),
///         face_slots => m.0.len(),
///         origin(h) => Some(m.origin(h)),
///         twin(h) => m.twin(h),
///         next(h) => Some(h - h % 3 + (h + 1) % 3),
///         face(h) => Some(h / 3),
///         outer_half_edge(f) => Some(3 * f),
///     }
/// }
///
/// // Two triangles side by side, and a third.
/// let mesh = Triangles(vec![[0, 1, 3], [1, 2, 3], [2, 4, 3]]);
/// let expectation = Expectation::surface().open();
/// let make = || Named::new(mesh.clone()).flip_edge(Triangles::flip);
/// let summary = conformance::check(make, &expectation.simple().triangles())?;
/// assert!(summary.of("mesh_flip_edge").unwrap().applied > 0);
/// assert_eq!(make().in_mesh(2), Some(1));
/// # Ok::<(), twinedge::program::conformance::Counterexample>(())
/// ```
pub struct Named<M> {
    mesh: M,
    /// The place of each half-edge, by number.
    place: Vec<Place>,
    /// The number of the half-edge at each place.
    number: BTreeMap<Place, usize>,
    ends: Vec<[Link; 2]>,
    operators: Vec<(OpKind, Operator<M>)>,
}

impl<M: View> Named<M> {
    /// Begins with the mesh in its current state. O(n log n).
    #[must_use]
    pub fn new(mesh: M) -> Self {
        let mut named =
            Self { mesh, place: Vec::new(), number: BTreeMap::new(), ends: Vec::new(), operators: Vec::new() };
        named.find_again(|v| v);
        named
    }

    /// Adds the operator [`flip_edge`](super::flip_edge), called with the index of a half-edge of the mesh. Its value is dropped, and
    /// its error becomes a [`Refusal`] by `Into`.
    #[must_use]
    pub fn flip_edge<T, E: Into<Refusal>>(self, operator: impl FnMut(&mut M, usize) -> Result<T, E> + 'static) -> Self {
        self.with(OpKind::MeshFlipEdge, operator)
    }

    /// Adds the operator [`split_edge`](super::split_edge), called with the index of a half-edge of the mesh. Its value is dropped, and
    /// its error becomes a [`Refusal`] by `Into`.
    #[must_use]
    pub fn split_edge<T, E: Into<Refusal>>(
        self,
        operator: impl FnMut(&mut M, usize) -> Result<T, E> + 'static,
    ) -> Self {
        self.with(OpKind::MeshSplitEdge, operator)
    }

    /// Adds the operator [`split_face`](super::split_face), called with the index of a half-edge of the mesh. Its value is dropped, and
    /// its error becomes a [`Refusal`] by `Into`.
    #[must_use]
    pub fn split_face<T, E: Into<Refusal>>(
        self,
        operator: impl FnMut(&mut M, usize) -> Result<T, E> + 'static,
    ) -> Self {
        self.with(OpKind::MeshSplitFace, operator)
    }

    /// Adds the operator [`collapse_edge`](super::collapse_edge), called with the index of a half-edge of the mesh. Its value is
    /// dropped, and its error becomes a [`Refusal`] by `Into`.
    #[must_use]
    pub fn collapse_edge<T, E: Into<Refusal>>(
        self,
        operator: impl FnMut(&mut M, usize) -> Result<T, E> + 'static,
    ) -> Self {
        self.with(OpKind::MeshCollapseEdge, operator)
    }

    fn with<T, E: Into<Refusal>>(
        mut self,
        kind: OpKind,
        mut operator: impl FnMut(&mut M, usize) -> Result<T, E> + 'static,
    ) -> Self {
        self.operators.retain(|(other, _)| *other != kind);
        self.operators.push((kind, Box::new(move |mesh, h| operator(mesh, h).map(drop).map_err(Into::into))));
        self
    }

    /// Returns the mesh.
    #[must_use]
    pub const fn mesh(&self) -> &M {
        &self.mesh
    }

    /// Returns the index in the mesh of the half-edge with this number, or of its twin if the half-edge is not stored; `None` if no
    /// live half-edge has this number. O(1).
    #[must_use]
    pub fn in_mesh(&self, number: usize) -> Option<usize> {
        self.place(number).map(|place| place / 2)
    }

    /// All places, including the places of missing twins.
    fn places(&self) -> Vec<Place> {
        let live = (0..self.mesh.half_edge_slots()).filter(|h| self.mesh.is_half_edge(*h));
        live.flat_map(|h| [Some(2 * h), self.mesh.twin(h).is_none().then_some(2 * h + 1)]).flatten().collect()
    }

    fn ends_at(&self, place: Place) -> [Link; 2] {
        let h = place / 2;
        let start = |link: Link| link.filter(|h| *h < self.mesh.half_edge_slots()).and_then(|h| self.mesh.origin(h));
        let ends = [self.mesh.origin(h), start(self.mesh.next(h)).or_else(|| start(self.mesh.twin(h)))];
        if place % 2 == 0 { ends } else { [ends[1], ends[0]] }
    }

    /// Finds the half-edges again by their ends after an operator. `now` maps each vertex to its vertex afterwards.
    fn find_again(&mut self, now: impl Fn(usize) -> usize) {
        let mut known: BTreeMap<[Link; 2], usize> = BTreeMap::new();
        for (n, _) in self.place.iter().enumerate().filter(|(_, place)| **place != NOWHERE) {
            known.entry(self.ends[n].map(|end| end.map(&now))).or_insert(n);
        }
        self.place.fill(NOWHERE);
        let before = core::mem::take(&mut self.number);
        for place in self.places() {
            let ends = self.ends_at(place);
            let n = known.remove(&ends).unwrap_or(self.place.len());
            if n == self.place.len() {
                self.place.push(NOWHERE);
                self.ends.push(ends);
            }
            (self.place[n], self.ends[n]) = (place, ends);
            self.number.insert(place, n);
        }
        // A link to a removed half-edge leads to its former number.
        for (place, n) in before {
            if self.place(n).is_none() {
                self.number.entry(place).or_insert(n);
            }
        }
    }

    fn place(&self, n: usize) -> Option<Place> {
        self.place.get(n).copied().filter(|place| *place != NOWHERE)
    }

    /// The number of a half-edge of the mesh; its former number if it was removed, and an unused one if it never existed.
    fn numbered(&self, link: Link) -> Link {
        link.map(|h| h.checked_mul(2).and_then(|place| self.number.get(&place)).copied().unwrap_or(usize::MAX))
    }

    fn start(&self, start: Option<Start>) -> Option<Start> {
        match start? {
            Start::HalfEdge(h) => self.numbered(Some(h)).map(Start::HalfEdge),
            vertex @ Start::Vertex(_) => Some(vertex),
        }
    }

    /// A link of the half-edge with this number, if the half-edge is stored.
    fn kept(&self, n: usize, link: impl Fn(&M, usize) -> Link) -> Link {
        self.place(n).filter(|place| place % 2 == 0).and_then(|place| link(&self.mesh, place / 2))
    }

    /// Runs an operator of the mesh on the half-edge with this number, or on its twin if the half-edge is not stored.
    fn run(&mut self, kind: OpKind, n: usize) -> Result<(), Refusal> {
        let place = self.place(n).ok_or(Refusal::Stale)?;
        let operator = self.operators.iter_mut().find(|(other, _)| *other == kind);
        let (_, operator) = operator.ok_or(Refusal::Unsupported)?;
        if kind == OpKind::MeshSplitFace && place % 2 == 1 {
            return Err(Refusal::Border);
        }
        operator(&mut self.mesh, place / 2)
    }

    /// Runs the operator that collapses an edge. The surviving vertex stands for both ends.
    fn collapse(&mut self, n: usize) -> Result<(), Refusal> {
        let ends = self.ends.get(n).copied().unwrap_or_default();
        let vertices = |mesh: &M| (0..mesh.vertex_slots()).filter(|v| mesh.is_vertex(*v)).collect::<BTreeSet<usize>>();
        let before = vertices(&self.mesh);
        self.run(OpKind::MeshCollapseEdge, n)?;
        // The merged vertex: one of the two ends, or a new vertex.
        let after = vertices(&self.mesh);
        let of_both = ends.into_iter().flatten().chain(after.difference(&before).copied()).find(|v| after.contains(v));
        self.find_again(|v| if ends.contains(&Some(v)) { of_both.unwrap_or(v) } else { v });
        Ok(())
    }
}

impl<M: View> View for Named<M> {
    delegate_view!(|this| &this.mesh; only parts, vertex_slots, is_vertex, isolated, face_slots, is_face, outer, inner_count, inner);
    delegate_view!(|this| &this.mesh; only boundary_slots, is_boundary, boundary_face, boundary_place);

    fn half_edge_slots(&self) -> usize {
        self.place.len()
    }
    fn is_half_edge(&self, n: usize) -> bool {
        self.place(n).is_some()
    }
    fn origin(&self, n: usize) -> Link {
        self.ends.get(n)?[0]
    }
    fn twin(&self, n: usize) -> Link {
        let place = self.place(n)?;
        match (place % 2, self.mesh.twin(place / 2)) {
            (0, None) => self.number.get(&(place + 1)).copied(),
            (0, twin) => self.numbered(twin),
            _ => self.numbered(Some(place / 2)),
        }
    }
    fn next(&self, n: usize) -> Link {
        self.numbered(self.kept(n, M::next))
    }
    fn prev(&self, n: usize) -> Link {
        self.numbered(self.kept(n, M::prev))
    }
    fn boundary(&self, n: usize) -> Link {
        self.kept(n, M::boundary)
    }
    fn face(&self, n: usize) -> Link {
        self.kept(n, M::face)
    }
    fn leaving(&self, v: usize) -> Link {
        self.numbered(self.mesh.leaving(v))
    }
    fn outer_half_edge(&self, f: usize) -> Link {
        self.numbered(self.mesh.outer_half_edge(f))
    }
    fn boundary_start(&self, b: usize) -> Option<Start> {
        self.start(self.mesh.boundary_start(b))
    }
    fn inner_start(&self, f: usize, position: usize) -> Option<Start> {
        self.start(self.mesh.inner_start(f, position))
    }
}

impl<M: View> Subject for Named<M> {
    crate::subject_by_index!();

    fn is_named(&self) -> bool {
        true
    }

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        match call {
            Call::MeshCollapseEdge { half_edge } => self.collapse(half_edge)?,
            Call::MeshFlipEdge { half_edge }
            | Call::MeshSplitEdge { half_edge }
            | Call::MeshSplitFace { half_edge } => {
                self.run(call.kind(), half_edge)?;
                self.find_again(|v| v);
            }
            _ => return Err(Refusal::Unsupported),
        }
        Ok(None)
    }
}

impl<M: fmt::Debug> fmt::Debug for Named<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Named").field("mesh", &self.mesh).field("place", &self.place).finish_non_exhaustive()
    }
}
