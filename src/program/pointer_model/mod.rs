//! An independent model: the doubly connected edge list with pointers, as the literature draws it.
//!
//! ```text
//!   PointerModel                         Vertex          HalfEdge          Boundary        Face
//!   vertices   [Rc][Rc]…          leaving  ·····► origin   ·····►   face    ·····►  outer  ·····► Boundary
//!   half-edges [Rc][Rc]…          isolated ·····► twin     ·····►   start   ·····►  inner [····►][····►]…
//!   boundaries [Rc]…                              next     ·····►
//!   faces      [Rc]…                              prev     ·····►   ···► is a Weak link
//!                                                 boundary ·····►
//! ```
//!
//! The four lists of the model own all records (`Rc`); every link is `Weak`, so cycles of links keep nothing alive.
//!
//! The model is the reference with which other structures are compared, step by step. It shares only the meaning of the
//! operators with [`dcel`](crate::dcel), and is written for clarity rather than speed:
//!
//! - Two moves make all changes to `next` and `prev`: one end of an edge is [taken out](operators) of the rotation of its
//!   vertex, or put into one.
//! - Each half-edge stores the face to its left and whether it is on the outer cycle of that face; an isolated vertex stores
//!   its face. Operators change these as their definitions say.
//! - Everything else (boundary components, the lists of the faces, the half-edge kept by a vertex, indices) is discarded
//!   after each operator and [rebuilt](PointerModel::rebuild). Every operator is O(n), and some are O(n²).

mod from_view;
mod operators;

pub use from_view::{PointerModelStart, StartError};

use crate::validate::{BoundaryPlace, Link, Parts, Start, View};
use alloc::rc::{Rc, Weak};
use alloc::vec;
use alloc::vec::Vec;
use core::any::Any;
use core::cell::{Ref, RefCell};

/// A record, owned by its list and temporarily by running operators.
type Owned<T> = Rc<RefCell<T>>;
type Pointer<T> = Weak<RefCell<T>>;

/// Names a vertex of a [`PointerModel`]; never reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PointerModelVertex(u64);

/// Names a half-edge of a [`PointerModel`]; never reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PointerModelHalfEdge(u64);

/// Names a face of a [`PointerModel`]; never reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PointerModelFace(u64);

#[derive(Debug)]
struct Vertex {
    name: PointerModelVertex,
    /// The face of an isolated vertex.
    face: Option<Pointer<Face>>,

    // Rebuilt after each operator:
    leaving: Option<Pointer<HalfEdge>>,
    isolated: Option<Pointer<Boundary>>,
    index: usize,
}

#[derive(Debug)]
struct HalfEdge {
    name: PointerModelHalfEdge,
    origin: Pointer<Vertex>,
    twin: Pointer<HalfEdge>,
    next: Pointer<HalfEdge>,
    prev: Pointer<HalfEdge>,
    face: Pointer<Face>,
    /// True on the outer cycle of that face.
    outer: bool,

    // Rebuilt after each operator:
    boundary: Pointer<Boundary>,
    index: usize,
}

#[derive(Debug)]
enum Beginning {
    HalfEdge(Pointer<HalfEdge>),
    Vertex(Pointer<Vertex>),
}

#[derive(Debug)]
struct Boundary {
    face: Pointer<Face>,
    start: Beginning,
    place: BoundaryPlace,
    index: usize,
}

#[derive(Debug)]
struct Face {
    name: PointerModelFace,
    /// True for a face that stands for the outside, where the original structure has no face.
    border: bool,

    // Rebuilt after each operator:
    outer: Option<Pointer<Boundary>>,
    inner: Vec<Pointer<Boundary>>,
    index: usize,
}

/// The record to which a link leads.
///
/// Always succeeds: an operator unlinks a record before removing it.
fn to<T>(link: &Pointer<T>) -> Owned<T> {
    link.upgrade().expect("a link leads to a record of the model")
}

fn origin(h: &Owned<HalfEdge>) -> Owned<Vertex> {
    to(&h.borrow().origin)
}

fn twin(h: &Owned<HalfEdge>) -> Owned<HalfEdge> {
    to(&h.borrow().twin)
}

fn next(h: &Owned<HalfEdge>) -> Owned<HalfEdge> {
    to(&h.borrow().next)
}

fn prev(h: &Owned<HalfEdge>) -> Owned<HalfEdge> {
    to(&h.borrow().prev)
}

fn face(h: &Owned<HalfEdge>) -> Owned<Face> {
    to(&h.borrow().face)
}

fn is_outer(h: &Owned<HalfEdge>) -> bool {
    h.borrow().outer
}

fn same<T>(a: &Owned<T>, b: &Owned<T>) -> bool {
    Rc::ptr_eq(a, b)
}

fn contains<T>(list: &[Owned<T>], record: &Owned<T>) -> bool {
    list.iter().any(|other| same(other, record))
}

fn cycle(start: &Owned<HalfEdge>) -> Vec<Owned<HalfEdge>> {
    let mut found = vec![start.clone()];
    let mut h = next(start);
    while !same(&h, start) {
        found.push(h.clone());
        h = next(&h);
    }
    found
}

fn component(start: &Owned<HalfEdge>) -> Vec<Owned<HalfEdge>> {
    let mut found = vec![start.clone()];
    let mut done = 0;
    while let Some(h) = found.get(done).cloned() {
        for neighbour in [next(&h), twin(&h)] {
            if !contains(&found, &neighbour) {
                found.push(neighbour);
            }
        }
        done += 1;
    }
    found
}

fn label(h: &Owned<HalfEdge>, f: &Owned<Face>, outer: bool) {
    h.borrow_mut().face = Rc::downgrade(f);
    h.borrow_mut().outer = outer;
}

fn label_cycle(h: &Owned<HalfEdge>, f: &Owned<Face>, outer: bool) {
    for side in cycle(h) {
        label(&side, f, outer);
    }
}

/// An independent model of the structure, for step-by-step comparison.
///
/// ```
/// use twinedge::program::{Call, Corner, Handle, PointerModel, Side, Subject};
/// use twinedge::validate::{Collect, Expectation, validate};
///
/// let mut model = PointerModel::new();
/// let face = model.unbounded_face().expect("the model of a planar map has one");
/// let Some(Handle::Vertex(v)) = model.apply(Call::AddIsolatedVertex { face })? else { unreachable!() };
/// let v = Corner::Isolated(v);
/// let h = model.make_edge(Call::Connect { from: v, to: v, new_face: Side::Left, inner: vec![] })?;
/// assert_ne!(model.face_of(Corner::At(h))?, face);
/// assert!(validate(&model, &Expectation::plane(), Collect::All).is_valid());
/// # Ok::<(), twinedge::program::Refusal>(())
/// ```
#[derive(Debug)]
pub struct PointerModel {
    vertices: Vec<Owned<Vertex>>,
    half_edges: Vec<Owned<HalfEdge>>,
    boundaries: Vec<Owned<Boundary>>,
    /// The unbounded face comes first, unless all faces are discs.
    faces: Vec<Owned<Face>>,
    /// True if all faces are discs: they have one boundary component, which is a cycle.
    discs: bool,
    names: u64,
}

impl Default for PointerModel {
    fn default() -> Self {
        Self::new()
    }
}

impl PointerModel {
    /// The empty map: one unbounded face and nothing else.
    #[must_use]
    pub fn new() -> Self {
        let mut model = Self::without_faces(false);
        model.make_face();
        model
    }

    const fn without_faces(discs: bool) -> Self {
        Self {
            vertices: Vec::new(),
            half_edges: Vec::new(),
            boundaries: Vec::new(),
            faces: Vec::new(),
            discs,
            names: 0,
        }
    }

    /// Returns weak pointers to all records, to observe their lifetimes and counts.
    ///
    /// `strong_count` is 1 while a record is in its list, and 0 once it is removed or the model is dropped.
    #[must_use]
    pub fn records(&self) -> Vec<Weak<dyn Any>> {
        fn watch<T: 'static>(list: &[Owned<T>]) -> impl Iterator<Item = Weak<dyn Any>> {
            list.iter().map(|record| {
                let weak: Pointer<T> = Rc::downgrade(record);
                weak as Weak<dyn Any>
            })
        }
        let half_edges = watch(&self.half_edges);
        watch(&self.vertices).chain(half_edges).chain(watch(&self.boundaries)).chain(watch(&self.faces)).collect()
    }

    fn new_name(&mut self) -> u64 {
        self.names += 1;
        self.names
    }

    fn make_vertex(&mut self) -> Owned<Vertex> {
        let name = PointerModelVertex(self.new_name());
        let v = Rc::new(RefCell::new(Vertex { name, face: None, leaving: None, isolated: None, index: 0 }));
        self.vertices.push(v.clone());
        v
    }

    fn make_half_edge(&mut self, origin: &Owned<Vertex>) -> Owned<HalfEdge> {
        let h = Rc::new(RefCell::new(HalfEdge {
            name: PointerModelHalfEdge(self.new_name()),
            origin: Rc::downgrade(origin),
            twin: Weak::new(),
            next: Weak::new(),
            prev: Weak::new(),
            face: Weak::new(),
            outer: false,
            boundary: Weak::new(),
            index: 0,
        }));
        self.half_edges.push(h.clone());
        h
    }

    fn make_face(&mut self) -> Owned<Face> {
        let name = PointerModelFace(self.new_name());
        let f = Rc::new(RefCell::new(Face { name, border: false, outer: None, inner: Vec::new(), index: 0 }));
        self.faces.push(f.clone());
        f
    }

    /// Rebuilds the derived data: boundary components and their places in the lists of the faces, the links of the vertices,
    /// and the indices.
    fn rebuild(&mut self) {
        for f in &self.faces {
            f.borrow_mut().outer = None;
            f.borrow_mut().inner.clear();
        }
        for v in &self.vertices {
            v.borrow_mut().leaving = None;
            v.borrow_mut().isolated = None;
        }
        for h in &self.half_edges {
            h.borrow_mut().boundary = Weak::new();
        }
        self.boundaries.clear();
        // A cycle is a boundary component, listed by the face to its left.
        for h in self.half_edges.clone() {
            origin(&h).borrow_mut().leaving.get_or_insert_with(|| Rc::downgrade(&h));
            if h.borrow().boundary.upgrade().is_none() {
                let b = self.make_boundary(&face(&h), Beginning::HalfEdge(Rc::downgrade(&h)), is_outer(&h));
                for side in cycle(&h) {
                    side.borrow_mut().boundary = Rc::downgrade(&b);
                }
            }
        }
        // An isolated vertex also is one.
        for v in self.vertices.clone() {
            let lies_in = v.borrow().face.as_ref().map(to);
            if let Some(f) = lies_in {
                let b = self.make_boundary(&f, Beginning::Vertex(Rc::downgrade(&v)), false);
                v.borrow_mut().isolated = Some(Rc::downgrade(&b));
            }
        }
        self.vertices.iter().enumerate().for_each(|(i, v)| v.borrow_mut().index = i);
        self.half_edges.iter().enumerate().for_each(|(i, h)| h.borrow_mut().index = i);
        self.boundaries.iter().enumerate().for_each(|(i, b)| b.borrow_mut().index = i);
        self.faces.iter().enumerate().for_each(|(i, f)| f.borrow_mut().index = i);
    }

    fn make_boundary(&mut self, f: &Owned<Face>, start: Beginning, outer: bool) -> Owned<Boundary> {
        let place = if outer { BoundaryPlace::Outer } else { BoundaryPlace::Inner(f.borrow().inner.len()) };
        let b = Rc::new(RefCell::new(Boundary { face: Rc::downgrade(f), start, place, index: 0 }));
        if outer {
            f.borrow_mut().outer = Some(Rc::downgrade(&b));
        } else {
            f.borrow_mut().inner.push(Rc::downgrade(&b));
        }
        self.boundaries.push(b.clone());
        b
    }
}

fn read<T, U>(list: &[Owned<T>], index: usize, answer: impl FnOnce(Ref<'_, T>) -> Option<U>) -> Option<U> {
    answer(list.get(index)?.borrow())
}

fn index<T>(link: &Pointer<T>, of: impl FnOnce(Ref<'_, T>) -> usize) -> Link {
    Some(of(link.upgrade()?.borrow()))
}

/// The model as a view: the index of a record is its place in its list.
impl View for PointerModel {
    fn parts(&self) -> Parts {
        Parts::ALL
    }
    fn vertex_slots(&self) -> usize {
        self.vertices.len()
    }
    fn half_edge_slots(&self) -> usize {
        self.half_edges.len()
    }
    fn boundary_slots(&self) -> usize {
        self.boundaries.len()
    }
    fn face_slots(&self) -> usize {
        self.faces.len()
    }
    fn origin(&self, half_edge: usize) -> Link {
        read(&self.half_edges, half_edge, |h| index(&h.origin, |v| v.index))
    }
    fn twin(&self, half_edge: usize) -> Link {
        read(&self.half_edges, half_edge, |h| index(&h.twin, |t| t.index))
    }
    fn next(&self, half_edge: usize) -> Link {
        read(&self.half_edges, half_edge, |h| index(&h.next, |n| n.index))
    }
    fn prev(&self, half_edge: usize) -> Link {
        read(&self.half_edges, half_edge, |h| index(&h.prev, |p| p.index))
    }
    fn boundary(&self, half_edge: usize) -> Link {
        read(&self.half_edges, half_edge, |h| index(&h.boundary, |b| b.index))
    }
    fn leaving(&self, vertex: usize) -> Link {
        read(&self.vertices, vertex, |v| index(v.leaving.as_ref()?, |h| h.index))
    }
    fn isolated(&self, vertex: usize) -> Link {
        read(&self.vertices, vertex, |v| index(v.isolated.as_ref()?, |b| b.index))
    }
    fn boundary_face(&self, boundary: usize) -> Link {
        read(&self.boundaries, boundary, |b| index(&b.face, |f| f.index))
    }
    fn boundary_start(&self, boundary: usize) -> Option<Start> {
        read(&self.boundaries, boundary, |b| match &b.start {
            Beginning::HalfEdge(h) => index(h, |h| h.index).map(Start::HalfEdge),
            Beginning::Vertex(v) => index(v, |v| v.index).map(Start::Vertex),
        })
    }
    fn boundary_place(&self, boundary: usize) -> Option<BoundaryPlace> {
        read(&self.boundaries, boundary, |b| Some(b.place))
    }
    fn outer(&self, face: usize) -> Link {
        read(&self.faces, face, |f| index(f.outer.as_ref()?, |b| b.index))
    }
    fn inner_count(&self, face: usize) -> usize {
        self.faces.get(face).map_or(0, |f| f.borrow().inner.len())
    }
    fn inner(&self, face: usize, position: usize) -> Link {
        read(&self.faces, face, |f| index(f.inner.get(position)?, |b| b.index))
    }
}
