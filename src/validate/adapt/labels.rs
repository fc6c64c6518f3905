//! An adapter for structures whose half-edges name their face, and whose faces store nothing.
//!
//! In a map, faces and components, joined by cycles, form a tree rooted at the unbounded face. The cycle that joins a face to its
//! parent component is its outer one.

use super::cycles::{Cycles, Groups, entry, filled, fits, live, nils};
use crate::numbers::NIL;
use crate::validate::structure::{HalfEdgeColumns, Link, Part, Parts, Start, View};
use alloc::vec::Vec;

/// A structure whose half-edges name their [face](View::face) and whose faces store nothing. The lists of the faces are derived:
/// [`outer_half_edge`](View::outer_half_edge) and [`inner_start`](View::inner_start).
///
/// Use [`one_cycle`](Self::one_cycle) if each face has one cycle, as in a mesh, and [`with_holes`](Self::with_holes) if faces have
/// holes. [`parts`](View::parts) includes the derived parts, so the structure's own `parts` can omit faces.
///
/// Since lists are derived from labels, B1 and F2 cannot find a list that contradicts the labels. They still find a label that changes
/// along a cycle (B1), a face that no half-edge names (F1), two cycles naming a face that should have one (F2), cycles that cannot nest
/// as a tree (T1), and labels that lead nowhere (R1).
///
/// ```
/// use twinedge::validate::adapt::FaceLabels;
/// use twinedge::validate::{Collect, Expectation, Link, Parts, Rule, View, validate};
///
/// /// Two triangles back to back, a sphere. Faces are numbers that half-edges keep.
/// struct Pillow {
///     face: [usize; 6],
/// }
///
/// impl View for Pillow {
///     fn parts(&self) -> Parts { Parts::NONE }
///     fn vertex_slots(&self) -> usize { 3 }
///     fn half_edge_slots(&self) -> usize { 6 }
///     fn face_slots(&self) -> usize { 2 }
///     fn origin(&self, h: usize) -> Link { Some([0, 1, 1, 2, 2, 0][h]) }
///     fn twin(&self, h: usize) -> Link { Some(h ^ 1) }
///     fn next(&self, h: usize) -> Link { Some([2, 5, 4, 1, 0, 3][h]) }
///     fn face(&self, h: usize) -> Link { Some(self.face[h]) }
/// }
///
/// let mesh = Expectation::surface();
/// let right = Pillow { face: [0, 1, 0, 1, 0, 1] };
/// assert!(validate(&FaceLabels::one_cycle(&right).unwrap(), &mesh, Collect::All).is_valid());
/// let wrong = Pillow { face: [0, 1, 0, 1, 1, 1] };
/// let report = validate(&FaceLabels::one_cycle(&wrong).unwrap(), &mesh, Collect::All);
/// assert_eq!(report.broken_rules().next(), Some(Rule::B1));
/// ```
#[derive(Clone, Debug)]
pub struct FaceLabels<V> {
    view: V,
    parts: Parts,
    /// By face: a half-edge of its outer cycle.
    outer: Vec<u32>,
    /// Half-edges of the inner cycles, grouped by face, and the beginning of each group.
    inner: Vec<u32>,
    begin: Vec<u32>,
}

impl<V: View> FaceLabels<V> {
    /// Wraps a structure with one cycle per face: the first half-edge that names a face is its outer half-edge.
    ///
    /// O(n) time; 4 bytes per face. `None` if memory runs out, or if the structure claims more than `u32::MAX - 1` records of one kind.
    #[must_use]
    pub fn one_cycle(view: V) -> Option<Self> {
        let mut outer = nils(view.face_slots())?;
        for h in live(&view, fits(view.half_edge_slots())?) {
            let named = view.face(h).and_then(|f| outer.get_mut(f));
            if let Some(entry) = named.filter(|entry| **entry == NIL) {
                *entry = h as u32;
            }
        }
        let parts = view.parts().without(Part::Faces).with(Part::Faces);
        Some(Self { view, parts, outer, inner: Vec::new(), begin: Vec::new() })
    }

    /// Wraps a structure whose faces may have holes. The unbounded face determines which cycles are outer.
    ///
    /// All cycles of the unbounded face are inner. Each is the outside of a component, whose other cycles are the outer ones of their
    /// faces. All other cycles of those faces are again inner, and so on. If the unbounded face is not a record, pass `None`: the
    /// search then begins with the components at an open boundary, or else with any component. Labels do not determine which of two
    /// components contains the other, and if one reading is a map, so is the other.
    ///
    /// No face lists isolated vertices, since no half-edge names their face. If the unbounded face is a record, isolated vertices break
    /// B2.
    ///
    /// O(n) time; 4 bytes per face and per cycle, and about 20 per half-edge temporarily. `None` if memory runs out, or if the
    /// structure claims more than `u32::MAX - 1` records of one kind.
    ///
    /// ```
    /// use twinedge::validate::adapt::FaceLabels;
    /// use twinedge::validate::{Collect, Expectation, Start, Table, View, validate};
    /// // Two loops, of which the second (half-edges 2 and 3) lies inside the first, and its inside is face 2.
    /// // Section HF gives the face of each half-edge; the faces (FH) keep nothing.
    /// let loops: Table = "P 1 prev V 2 - - - - H 4 0 1 0 0 - 0 0 1 1 - 1 3 2 2 - 1 2 3 3 - \
    ///     B 0 F 3 - 0 - 0 - 0 HF 4 1 0 2 1 FH 3 - 0 - 0 - 0".parse()?;
    /// let view = FaceLabels::with_holes(&loops, Some(0)).unwrap();
    /// assert_eq!([0, 1, 2].map(|f| view.outer_half_edge(f)), [None, Some(0), Some(2)]);
    /// assert_eq!(view.inner_start(1, 0), Some(Start::HalfEdge(3)));
    /// assert!(validate(&view, &Expectation::plane(), Collect::All).is_valid());
    /// # Ok::<(), twinedge::validate::ParseTableError>(())
    /// ```
    #[must_use]
    pub fn with_holes(view: V, unbounded: Link) -> Option<Self> {
        let cycles = Cycles::of(&view)?;
        let outer_cycle = outer_cycles(&cycles, unbounded)?;
        let mut outer = nils(outer_cycle.len())?;
        let mut begin = filled(outer_cycle.len() + 1, 0)?;
        let mut inner = Vec::new();
        inner.try_reserve_exact(cycles.start.len()).ok()?;
        for (f, chosen) in outer_cycle.iter().enumerate() {
            for c in cycles.of_face(f) {
                let start = cycles.start[*c as usize];
                if c == chosen {
                    outer[f] = start;
                } else {
                    inner.push(start);
                }
            }
            begin[f + 1] = inner.len() as u32;
        }
        let last = if unbounded.is_some() { Part::UnboundedFace } else { Part::Holes };
        let parts = view.parts().without(Part::Faces).with(last);
        Some(Self { view, parts, outer, inner, begin })
    }

    fn listed(&self, face: usize) -> &[u32] {
        let bound = |f: usize| self.begin.get(f).map(|i| *i as usize);
        match (bound(face), face.checked_add(1).and_then(bound)) {
            (Some(from), Some(to)) => self.inner.get(from..to).unwrap_or_default(),
            _ => &[],
        }
    }
}

impl<V: View> View for FaceLabels<V> {
    crate::delegate_view!(|this| &this.view; except parts, outer_half_edge, inner_count, inner_start);

    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        self.view.half_edge_columns()
    }

    fn parts(&self) -> Parts {
        self.parts
    }

    fn outer_half_edge(&self, face: usize) -> Link {
        entry(&self.outer, face)
    }

    fn inner_count(&self, face: usize) -> usize {
        self.listed(face).len()
    }

    fn inner_start(&self, face: usize, position: usize) -> Option<Start> {
        entry(self.listed(face), position).map(Start::HalfEdge)
    }
}

struct Search<'a> {
    cycles: &'a Cycles,
    by_component: Groups,
    /// By face: its outer cycle, once known.
    outer: Vec<u32>,
    face_reached: Vec<bool>,
    /// By the number of a cycle that represents the component.
    component_reached: Vec<bool>,
    /// Reached faces whose cycles are still to be followed.
    queue: Vec<u32>,
}

/// By face: the number of its outer cycle, or nil. `None` if memory runs out. O(n).
pub(super) fn outer_cycles(cycles: &Cycles, unbounded: Link) -> Option<Vec<u32>> {
    let count = cycles.start.len();
    let mut search = Search {
        cycles,
        by_component: Groups::of(&cycles.component, count)?,
        outer: nils(cycles.faces())?,
        face_reached: filled(cycles.faces(), false)?,
        component_reached: filled(count, false)?,
        queue: Vec::new(),
    };
    search.queue.try_reserve_exact(cycles.faces()).ok()?;
    if let Some(reached) = unbounded.and_then(|f| search.face_reached.get_mut(f)) {
        *reached = true;
        search.queue.extend(unbounded.map(|f| f as u32));
        search.follow();
    }
    let open = (0..count).filter(|c| cycles.face[*c] == NIL || cycles.unpaired[*c]);
    for c in open.chain(0..count) {
        search.enter(cycles.component[c]);
        search.follow();
    }
    Some(search.outer)
}

impl Search<'_> {
    fn follow(&mut self) {
        let cycles = self.cycles;
        while let Some(face) = self.queue.pop() {
            for c in cycles.of_face(face as usize) {
                if *c != self.outer[face as usize] {
                    self.enter(cycles.component[*c as usize]);
                }
            }
        }
    }

    /// Enters a component: its cycles are the outer ones of their faces, except its outside, whose face was reached before.
    fn enter(&mut self, component: u32) {
        if core::mem::replace(&mut self.component_reached[component as usize], true) {
            return;
        }
        for c in self.by_component.group(component as usize) {
            let face = self.cycles.face[*c as usize];
            if face != NIL && !core::mem::replace(&mut self.face_reached[face as usize], true) {
                self.outer[face as usize] = *c;
                self.queue.push(face);
            }
        }
    }
}
