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
//! Records are owned by the four lists of the model and by nothing else (`Rc`); every link is `Weak`, so that links that run
//! in circles keep nothing alive.
//!
//! It is the reference with which other structures are compared, step by step. It shares only the meaning of the operators
//! with [`dcel`](crate::dcel), and it is written for clarity rather than for speed:
//!
//! - Two moves make all changes to `next` and `prev`: one end of an edge is [taken out](operators) of the rotation of its
//!   vertex, or put into one.
//! - Each half-edge says for itself which face is to its left and whether it is on the outer cycle of that face; an isolated
//!   vertex says in which face it lies. An operator changes these where its definition says so.
//! - Everything else (boundary components, the lists of the faces, the half-edge kept by a vertex, indices) is thrown away
//!   after each operator and [built anew](PointerModel::rebuild) from that. So every operator is O(n), and some are O(n²).

mod from_view;
mod operators;
mod view;

pub(super) use from_view::face_of as view_face_of;
pub use from_view::{PointerModelStart, StartError};

use crate::validate::BoundaryPlace;
use alloc::rc::{Rc, Weak};
use alloc::vec;
use alloc::vec::Vec;
use core::any::Any;
use core::cell::RefCell;

/// A record, as its list owns it. Operators have others, for as long as they run.
type Owned<T> = Rc<RefCell<T>>;
/// A link to a record.
type Pointer<T> = Weak<RefCell<T>>;

macro_rules! handles {
    ($($(#[$doc:meta])* $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name(u64);
    )*};
}

handles! {
    /// Names a vertex of a [`PointerModel`], for ever.
    PointerModelVertex;
    /// Names a half-edge of a [`PointerModel`], for ever.
    PointerModelHalfEdge;
    /// Names a face of a [`PointerModel`], for ever.
    PointerModelFace;
}

#[derive(Debug)]
struct Vertex {
    name: PointerModelVertex,
    /// If isolated: the face in which it lies.
    face: Option<Pointer<Face>>,

    // Built anew after each operator:
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
    /// The face to its left.
    face: Pointer<Face>,
    /// True if it is on the outer cycle of that face.
    outer: bool,

    // Built anew after each operator:
    boundary: Pointer<Boundary>,
    index: usize,
}

/// The start of a boundary component.
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
    /// True if it stands for what lies outside: the structure that the model was made from has no face there.
    border: bool,

    // Built anew after each operator:
    outer: Option<Pointer<Boundary>>,
    inner: Vec<Pointer<Boundary>>,
    index: usize,
}

/// The record to which a link leads.
///
/// Every link that is followed leads to a record in the lists of the model: what an operator removes it has unlinked before.
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

/// The half-edges of a cycle.
fn cycle(start: &Owned<HalfEdge>) -> Vec<Owned<HalfEdge>> {
    let mut found = vec![start.clone()];
    let mut h = next(start);
    while !same(&h, start) {
        found.push(h.clone());
        h = next(&h);
    }
    found
}

/// An independent model of the structure, to be compared with step by step.
///
/// ```
/// use twinedge::program::{Corner, Subject, PointerModel};
/// use twinedge::dcel::Side;
/// use twinedge::validate::{Collect, Expectation, validate};
///
/// let mut model = PointerModel::new();
/// let outside = model.unbounded_face().expect("the model of a planar map has one");
/// let v = model.add_isolated_vertex(outside)?;
/// let h = model.connect(Corner::Isolated(v), Corner::Isolated(v), Side::Left, &[])?;
/// assert_ne!(model.face_of(Corner::At(h))?, outside);
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
    /// The number of names that were given.
    names: u64,
}

impl Default for PointerModel {
    fn default() -> Self {
        Self::new()
    }
}

impl PointerModel {
    /// The empty map: one unbounded face, nothing in it.
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

    /// All records, watched: whether they are still there, how many own them, and how many links lead to them.
    ///
    /// As long as a record is in its list, `strong_count` is 1; once it is removed, or the model is dropped, it is 0.
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

    /// Makes all that follows from the rest: boundary components and their places in the lists of the faces, what the
    /// vertices keep, and the indices.
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
        // A cycle is a boundary component. The face to its left lists it.
        for h in self.half_edges.clone() {
            origin(&h).borrow_mut().leaving.get_or_insert_with(|| Rc::downgrade(&h));
            if h.borrow().boundary.upgrade().is_none() {
                let b = self.make_boundary(&face(&h), Beginning::HalfEdge(Rc::downgrade(&h)), is_outer(&h));
                for side in cycle(&h) {
                    side.borrow_mut().boundary = Rc::downgrade(&b);
                }
            }
        }
        // So is an isolated vertex.
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
