//! A structure in the terms of the rules: sets of records, and links that lead to a live record or to nil.

use crate::validate::expectation::{Expectation, Surface};
use crate::validate::structure::{BoundaryPlace, Link, Part, Parts, Start, View};
use alloc::collections::BTreeSet;
use alloc::vec::Vec;
use core::cell::OnceCell;

/// The kind of link by which half-edges name their faces.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Says {
    Nothing,
    Boundary,
    Face,
}

pub(super) struct Entry {
    pub(super) face: Link,
    pub(super) place: BoundaryPlace,
    /// The listed boundary component, if boundary components are records.
    pub(super) boundary: Link,
    pub(super) start: Option<Start>,
}

impl Entry {
    pub(super) fn is_outer(&self) -> bool {
        self.place == BoundaryPlace::Outer
    }
}

/// The structure in the terms of the rules. A link that does not lead to a live record is treated as nil.
pub(super) struct Structure<'a> {
    view: &'a dyn View,
    pub(super) expect: Expectation,
    /// The parts considered.
    parts: Parts,
    pub(super) open: bool,
    pub(super) says: Says,
    pub(super) vertices: Vec<Link>,
    pub(super) half_edges: Vec<Link>,
    pub(super) boundaries: Vec<Link>,
    pub(super) faces: Vec<Link>,
    /// The entries of the lists of the faces, read on first use.
    entries: OnceCell<Vec<Entry>>,
}

impl<'a> Structure<'a> {
    pub(super) fn new(view: &'a dyn View, expect: Expectation) -> Self {
        let parts = expect.looks_at(view.parts());
        let says = match (parts.has(Part::Faces), parts.has(Part::BoundaryComponents)) {
            (false, _) => Says::Nothing,
            (true, true) => Says::Boundary,
            (true, false) => Says::Face,
        };
        let boundary_slots = if says == Says::Boundary { view.boundary_slots() } else { 0 };
        let face_slots = if says == Says::Nothing { 0 } else { view.face_slots() };
        Self {
            view,
            expect,
            parts,
            open: expect.is_open(),
            says,
            vertices: (0..view.vertex_slots()).filter(|v| view.is_vertex(*v)).map(Some).collect(),
            half_edges: (0..view.half_edge_slots()).filter(|h| view.is_half_edge(*h)).map(Some).collect(),
            boundaries: (0..boundary_slots).filter(|b| view.is_boundary(*b)).map(Some).collect(),
            faces: (0..face_slots).filter(|f| view.is_face(*f)).map(Some).collect(),
            entries: OnceCell::new(),
        }
    }

    pub(super) fn entries(&self) -> &[Entry] {
        self.entries.get_or_init(|| {
            let mut entries = Vec::new();
            for f in self.faces.iter().copied().flatten() {
                let inner = if self.lacks(Part::Holes) { 0 } else { self.view.inner_count(f) };
                let places = [BoundaryPlace::Outer].into_iter().chain((0..inner).map(BoundaryPlace::Inner));
                entries.extend(places.filter_map(|place| self.entry(f, place)));
            }
            entries
        })
    }

    /// The entry of the face at that place; `None` if the face has no outer boundary component.
    fn entry(&self, f: usize, place: BoundaryPlace) -> Option<Entry> {
        let boundary = match (self.says, place) {
            (Says::Boundary, BoundaryPlace::Outer) => self.view.outer(f),
            (Says::Boundary, BoundaryPlace::Inner(i)) => self.view.inner(f, i),
            _ => None,
        };
        let start = match (self.says, place) {
            (Says::Boundary, _) => self.start(boundary),
            (_, BoundaryPlace::Outer) => self.view.outer_half_edge(f).map(Start::HalfEdge),
            (_, BoundaryPlace::Inner(i)) => self.view.inner_start(f, i),
        };
        let nothing = place == BoundaryPlace::Outer && boundary.is_none() && start.is_none();
        (!nothing).then_some(Entry { face: Some(f), place, boundary, start })
    }

    pub(super) fn lacks(&self, part: Part) -> bool {
        !self.parts.has(part)
    }

    pub(super) fn has_containment(&self) -> bool {
        !self.lacks(Part::Holes) && self.expect.surface_kind() == Surface::Plane
    }

    pub(super) fn origin(&self, h: Link) -> Link {
        self.view.origin(live(&self.half_edges, h)?)
    }

    pub(super) fn twin(&self, h: Link) -> Link {
        self.view.twin(live(&self.half_edges, h)?)
    }

    pub(super) fn next(&self, h: Link) -> Link {
        self.view.next(live(&self.half_edges, h)?)
    }

    /// The half-edge before `h`; without `prev`, the half-edge whose next is `h`.
    pub(super) fn prev(&self, h: Link) -> Link {
        if self.lacks(Part::Prev) {
            return self.half_edges.iter().copied().find(|&g| self.next(g) == h).flatten();
        }
        self.view.prev(live(&self.half_edges, h)?)
    }

    pub(super) fn boundary(&self, h: Link) -> Link {
        self.view.boundary(live(&self.half_edges, h)?)
    }

    pub(super) fn face(&self, h: Link) -> Link {
        self.view.face(live(&self.half_edges, h)?)
    }

    pub(super) fn leaving(&self, v: Link) -> Link {
        if self.lacks(Part::Leaving) { None } else { self.view.leaving(live(&self.vertices, v)?) }
    }

    pub(super) fn isolated(&self, v: Link) -> Link {
        if self.says == Says::Boundary { self.view.isolated(live(&self.vertices, v)?) } else { None }
    }

    pub(super) fn boundary_face(&self, b: Link) -> Link {
        self.view.boundary_face(live(&self.boundaries, b)?)
    }

    pub(super) fn start(&self, b: Link) -> Option<Start> {
        self.view.boundary_start(live(&self.boundaries, b)?)
    }

    pub(super) fn place(&self, b: Link) -> Option<BoundaryPlace> {
        self.view.boundary_place(live(&self.boundaries, b)?)
    }

    /// True if the twin of `h` is legally missing.
    pub(super) fn on_border(&self, h: Link) -> bool {
        self.open && self.twin(h).is_none()
    }

    /// The end of `h`: the origin of its twin, or without a twin the origin of its next.
    pub(super) fn target(&self, h: Link) -> Link {
        self.origin(if self.twin(h).is_some() { self.twin(h) } else { self.next(h) })
    }

    pub(super) fn all_leaving(&self, v: Link) -> BTreeSet<Link> {
        self.half_edges.iter().copied().filter(|&h| self.origin(h) == v).collect()
    }

    pub(super) fn cycle(&self, h: Link) -> BTreeSet<Link> {
        orbit(h, |h| self.next(h))
    }

    /// The orbit of `h` under `next∘twin`, and under `twin∘prev`, which matters only at an open boundary.
    pub(super) fn rotation(&self, h: Link) -> BTreeSet<Link> {
        &orbit(h, |h| self.next(self.twin(h))) | &orbit(h, |h| self.twin(self.prev(h)))
    }

    pub(super) fn vertex_at(&self, start: Option<Start>) -> Link {
        match start? {
            Start::HalfEdge(h) => self.origin(Some(h)),
            Start::Vertex(v) => Some(v),
        }
    }

    /// The connected components, as sets of vertices.
    pub(super) fn components(&self) -> BTreeSet<BTreeSet<Link>> {
        self.vertices.iter().map(|&v| self.connected_to(v)).collect()
    }

    /// All vertices connected to `v`: the smallest set with `v` that no edge leaves.
    fn connected_to(&self, v: Link) -> BTreeSet<Link> {
        let mut set = BTreeSet::from([v]);
        loop {
            let leaves = |h: &Link| set.contains(&self.origin(*h)) != set.contains(&self.target(*h));
            let Some(h) = self.half_edges.iter().copied().find(leaves) else {
                return set;
            };
            set.extend([self.origin(h), self.target(h)]);
        }
    }

    /// The edges at these vertices, each as the set of its half-edges.
    pub(super) fn edges(&self, vertices: &BTreeSet<Link>) -> BTreeSet<BTreeSet<Link>> {
        let edge = |h: Link| [h, self.twin(h)].into_iter().flatten().map(Some).collect();
        self.half_edges.iter().filter(|&&h| vertices.contains(&self.origin(h))).map(|&h| edge(h)).collect()
    }

    pub(super) fn all_edges(&self) -> BTreeSet<BTreeSet<Link>> {
        self.edges(&self.vertices.iter().copied().collect())
    }

    /// True if there are neither loops nor parallel edges.
    pub(super) fn is_simple(&self) -> bool {
        let edges = self.all_edges();
        edges.iter().all(|e| self.ends(e).len() == 2)
            && edges.iter().all(|d| edges.iter().all(|e| d == e || self.ends(d) != self.ends(e)))
    }

    pub(super) fn face_of(&self, h: Link) -> Link {
        match self.says {
            Says::Nothing => None,
            Says::Boundary => self.boundary_face(self.boundary(h)),
            Says::Face => self.face(h),
        }
    }

    pub(super) fn lacks_face(&self, h: Link) -> bool {
        match self.says {
            Says::Nothing => false,
            Says::Boundary => self.boundary(h).is_none(),
            Says::Face => self.face(h).is_none(),
        }
    }

    /// The ends of an edge: two vertices, or one if it is a loop.
    fn ends(&self, edge: &BTreeSet<Link>) -> BTreeSet<Link> {
        edge.iter().flat_map(|&h| [self.origin(h), self.target(h)]).collect()
    }

    /// Returns the number of cycles of a component: its cycles of `next`, or one for an isolated vertex, plus one for each
    /// border.
    pub(super) fn cycles(&self, component: &BTreeSet<Link>) -> usize {
        let of_component = |h: &&Link| component.contains(&self.origin(**h));
        let half_edges: Vec<&Link> = self.half_edges.iter().filter(of_component).collect();
        let cycles: BTreeSet<_> = half_edges.iter().map(|&&h| self.cycle(h)).collect();
        let borders: BTreeSet<_> =
            half_edges.iter().filter(|&&&h| self.on_border(h)).map(|&&h| self.border(h)).collect();
        usize::from(half_edges.is_empty()) + cycles.len() + borders.len()
    }

    /// The half-edges without twin that follow one another from `h`, each from the target of the previous one.
    pub(super) fn border(&self, h: Link) -> BTreeSet<Link> {
        let follows = |g: Link, h: Link| self.on_border(h) && self.origin(h) == self.target(g);
        orbit(h, |g| self.half_edges.iter().copied().find(|&h| follows(g, h)).flatten())
    }

    /// True if some half-edge of the component lacks its twin or its face.
    pub(super) fn is_open_somewhere(&self, component: &BTreeSet<Link>) -> bool {
        let of_component = |h: &&Link| component.contains(&self.origin(**h));
        self.half_edges.iter().filter(of_component).any(|&h| self.on_border(h) || self.lacks_face(h))
    }
}

/// The index of the record to which the link leads, if it is among `records`.
fn live(records: &[Link], link: Link) -> Option<usize> {
    if records.contains(&link) { link } else { None }
}

/// `x`, `step(x)`, `step(step(x))`, … up to nil or the first repetition.
pub(super) fn orbit(x: Link, step: impl Fn(Link) -> Link) -> BTreeSet<Link> {
    let mut seen = BTreeSet::new();
    let mut at = x;
    while at.is_some() && seen.insert(at) {
        at = step(at);
    }
    seen
}
