//! Builds the model of an existing structure.

use super::{Owned, PointerModel, PointerModelHalfEdge, PointerModelVertex, label, label_cycle, same};
use crate::program::subject::view_face_of;
use crate::validate::{Expectation, Part, Parts, Start, View};
use alloc::collections::BTreeMap;
use alloc::rc::Rc;
use alloc::vec::Vec;
use core::mem::replace;
use thiserror::Error;

/// A model built from a view, with the mapping between their elements.
#[derive(Debug)]
pub struct PointerModelStart {
    /// The model.
    pub model: PointerModel,
    /// The half-edges, with their indices in the view; the two half-edges of an edge are adjacent.
    pub half_edges: Vec<(usize, PointerModelHalfEdge)>,
    /// The isolated vertices that lie in a face, with their indices in the view.
    pub isolated: Vec<(usize, PointerModelVertex)>,
}

/// The reason why no model can be built from a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum StartError {
    /// A half-edge has no twin. Operators change both half-edges of an edge.
    #[error(
        "half-edge {0} has no twin; both half-edges of each edge are needed, those of the border included (program::mesh::Named adds them to a mesh)"
    )]
    NoTwin(usize),
    /// The structure has both holes and open boundaries, and the view does not say which boundaries are outside.
    #[error("the structure has holes in faces and open boundaries; which boundaries are outside is not known then")]
    OpenWithHoles,
    /// The links are inconsistent: the view is not valid.
    #[error("the links of half-edge {0} do not fit together")]
    Inconsistent(usize),
}

impl PointerModel {
    /// Builds the model of a valid structure, with the mapping between its elements and the view's indices.
    ///
    /// A structure that is not a planar subdivision is modelled as follows:
    ///
    /// - **Without lists of inner boundary components** ([`Part::Holes`]), faces are discs. Each cycle is a face with one boundary
    ///   component, on a surface of any genus. A map on closed surfaces is given by its half-edges, `twin` and `next` alone (Edmonds;
    ///   see Lando and Zvonkin, *Graphs on Surfaces and Their Applications*, 2004, section 1.3). The operators change these as in the
    ///   plane, since they only look at the faces at the edge. An operator that would make a face other than a disc is refused as
    ///   [`Refusal::NotDisc`](crate::program::Refusal::NotDisc), after all other reasons: adding an isolated vertex, removing an edge
    ///   with the same face on both sides, contracting the only edge of a component. Isolated vertices of the view are omitted.
    /// - **Without faces** ([`Part::Faces`]), each cycle is a face, and half-edges without `next` form a border.
    /// - **Where a half-edge has no face** (a border), a face marked as outside closes the surface, so genus and neighbours belong to
    ///   the closed surface. Operators that need that face are refused as [`Refusal::Border`](crate::program::Refusal::Border), after
    ///   stale handles and before other reasons: connecting or flipping there, removing an edge of the border, splitting a vertex
    ///   between two corners of the border. A border half-edge without `next` is followed by the half-edge at the next gap around its
    ///   target.
    /// - **Without unbounded face** ([`Part::UnboundedFace`]) but with holes, the unbounded face of the model is also marked as
    ///   outside.
    ///
    /// O(n²).
    ///
    /// # Errors
    /// [`StartError`]. A view that the validator accepts is never [`StartError::Inconsistent`], unless its answers change.
    ///
    /// ```
    /// use twinedge::program::PointerModel;
    /// use twinedge::validate::{Collect, Expectation, Part, Table, validate};
    ///
    /// // A loop on a sphere: two half-edges, two faces.
    /// let table: Table = "V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 0 h0 o 1 h1 o F 2 0 0 1 0".parse()?;
    /// let start = PointerModel::from_view(&table, &Expectation::surface())?;
    /// assert_eq!(start.half_edges.len(), 2);
    /// let report = validate(&start.model, &Expectation::surface(), Collect::All);
    /// assert_eq!(report.figures().unwrap().genus, 0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_view<V: View + ?Sized>(view: &V, expectation: &Expectation) -> Result<PointerModelStart, StartError> {
        // A trait object, so that this is compiled once for all views.
        Self::start(&view, expectation.looks_at(view.parts()), expectation.is_open())
    }

    fn start(view: &dyn View, parts: Parts, is_open: bool) -> Result<PointerModelStart, StartError> {
        let discs = !parts.has(Part::Holes);
        if !discs && is_open {
            return Err(StartError::OpenWithHoles);
        }
        let mut start = PointerModelStart {
            model: if discs { Self::without_faces(true) } else { Self::new() },
            half_edges: Vec::new(),
            isolated: Vec::new(),
        };
        let records = start.join(view)?;
        if discs {
            start.close(view, &records, parts.has(Part::Faces));
        } else {
            start.nest(view, &records, parts)?;
        }
        start.model.rebuild();
        Ok(start)
    }
}

/// The model's half-edges, by index in the view.
type Records = BTreeMap<usize, Owned<super::HalfEdge>>;

impl PointerModelStart {
    fn join(&mut self, view: &dyn View) -> Result<Records, StartError> {
        let live = || (0..view.half_edge_slots()).filter(|h| view.is_half_edge(*h));
        let mut vertices = BTreeMap::new();
        for h in live() {
            let origin = view.origin(h).ok_or(StartError::Inconsistent(h))?;
            vertices.entry(origin).or_insert_with(|| self.model.make_vertex());
        }
        let mut records = Records::new();
        for h in live() {
            let t = view.twin(h).ok_or(StartError::NoTwin(h))?;
            if t == h || view.twin(t) != Some(h) {
                return Err(StartError::Inconsistent(h));
            }
            if t > h {
                for side in [h, t] {
                    let origin = view.origin(side).and_then(|v| vertices.get(&v)).ok_or(StartError::Inconsistent(h))?;
                    let record = self.model.make_half_edge(origin);
                    self.half_edges.push((side, record.borrow().name));
                    records.insert(side, record);
                }
                let (one, other) = (&records[&h], &records[&t]);
                one.borrow_mut().twin = Rc::downgrade(other);
                other.borrow_mut().twin = Rc::downgrade(one);
            }
        }
        for (h, following) in successors(view, &records)? {
            let (record, next) = (&records[&h], records.get(&following).ok_or(StartError::Inconsistent(h))?);
            if replace(&mut next.borrow_mut().prev, Rc::downgrade(record)).upgrade().is_some() {
                return Err(StartError::Inconsistent(h));
            }
            record.borrow_mut().next = Rc::downgrade(next);
        }
        Ok(records)
    }

    fn close(&mut self, view: &dyn View, records: &Records, has_faces: bool) {
        for (h, record) in records {
            if record.borrow().face.upgrade().is_none() {
                let f = self.model.make_face();
                let is_border = if has_faces { view_face_of(view, *h).is_none() } else { view.next(*h).is_none() };
                f.borrow_mut().border = is_border;
                label_cycle(record, &f, true);
            }
        }
    }

    /// Makes the faces of the view, with their boundary components and isolated vertices.
    fn nest(&mut self, view: &dyn View, records: &Records, parts: Parts) -> Result<(), StartError> {
        let unbounded = self.model.faces[0].clone();
        unbounded.borrow_mut().border = !parts.has(Part::UnboundedFace);
        // A boundary component without a face lies outside.
        for record in records.values() {
            label(record, &unbounded, false);
        }
        for f in (0..view.face_slots()).filter(|f| view.is_face(*f)) {
            let outer = view
                .outer(f)
                .map_or_else(|| view.outer_half_edge(f).map(Start::HalfEdge), |boundary| view.boundary_start(boundary));
            let face = match outer {
                None => unbounded.clone(),
                Some(_) => self.model.make_face(),
            };
            if let Some(Start::HalfEdge(h)) = outer {
                label_cycle(records.get(&h).ok_or(StartError::Inconsistent(h))?, &face, true);
            }
            for position in 0..view.inner_count(f) {
                let start = match view.inner(f, position) {
                    Some(boundary) => view.boundary_start(boundary),
                    None => view.inner_start(f, position),
                };
                match start {
                    Some(Start::HalfEdge(h)) => {
                        label_cycle(records.get(&h).ok_or(StartError::Inconsistent(h))?, &face, false);
                    }
                    Some(Start::Vertex(v)) => {
                        let record = self.model.make_vertex();
                        record.borrow_mut().face = Some(Rc::downgrade(&face));
                        self.isolated.push((v, record.borrow().name));
                    }
                    None => {}
                }
            }
        }
        debug_assert!(same(&unbounded, &self.model.faces[0]), "the unbounded face stays the first");
        Ok(())
    }
}

/// The half-edge after each half-edge. A border half-edge without `next` is followed by the half-edge before which there is a gap at
/// its target.
fn successors(view: &dyn View, records: &Records) -> Result<BTreeMap<usize, usize>, StartError> {
    let mut next: BTreeMap<usize, usize> = BTreeMap::new();
    let mut prev: BTreeMap<usize, usize> = BTreeMap::new();
    for h in records.keys() {
        if let Some(following) = view.next(*h) {
            next.insert(*h, following);
            prev.insert(following, *h);
        }
    }
    for h in records.keys().filter(|h| view.next(**h).is_none()) {
        let mut at = view.twin(*h);
        for _ in records {
            match at.and_then(|at| prev.get(&at)) {
                Some(before) => at = view.twin(*before),
                None => break,
            }
        }
        next.insert(*h, at.ok_or(StartError::Inconsistent(*h))?);
    }
    Ok(next)
}
