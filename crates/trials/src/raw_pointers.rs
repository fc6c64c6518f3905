//! A second, independent model: boxed records joined by raw pointers, as in the literature.
//!
//! It shares only the meaning of the operators with [`Dcel`](twinedge::dcel::Dcel). No boundary component has a record: a
//! half-edge stores the face to its left and whether it is on the outer cycle of that face, and an isolated vertex stores its
//! face. Handles are numbers that are never used again. Operators search where others would keep records, so that most are O(n).
//!
//! # Why the unsafe here is sound
//!
//! 1. *A link is followed only while its record lives.* The tables of the model own all records. An operator frees a record as
//!    its last step, when no other record leads to it, and keeps no link after its end. A handle is a number that is looked up in
//!    a table.
//! 2. *There is never a `&mut` to a record*: all fields are cells, and all access goes through shared references.
//! 3. *A record is freed once*: by [`Table::remove`], which takes it off the table, or by the drop of the table.
//!
//! The first claim is about operators and a fault would break it: valgrind and `AddressSanitizer` run the tests of this file.

#![allow(unsafe_code, reason = "this is the file to which the raw pointers are confined")]

use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::ops::Deref;
use std::ptr::NonNull;
use twinedge::dcel::{Corner, Side, Turn};
use twinedge::program::{Call, CallOf, Handle, HandleOf, Refusal, Subject, mesh};
use twinedge::validate::{Link as ViewLink, Part, Parts, Start, View};

struct Link<T>(NonNull<T>);

impl<T> Clone for Link<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Link<T> {}

impl<T> PartialEq for Link<T> {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl<T> Deref for Link<T> {
    type Target = T;

    fn deref(&self) -> &T {
        // SAFETY: the record lives, and nobody has a `&mut` to it: see the head of this file.
        unsafe { self.0.as_ref() }
    }
}

/// The records of one kind by their numbers, owned by the table.
struct Table<T>(Vec<Option<Link<T>>>);

impl<T> Table<T> {
    /// Adds the record that `make` returns for its number.
    fn add(&mut self, make: impl FnOnce(usize) -> T) -> Link<T> {
        let record = Link(NonNull::from(Box::leak(Box::new(make(self.0.len())))));
        self.0.push(Some(record));
        record
    }

    fn find(&self, number: usize) -> Result<Link<T>, Refusal> {
        self.0.get(number).copied().flatten().ok_or(Refusal::Stale)
    }

    fn all(&self) -> impl Iterator<Item = Link<T>> {
        self.0.iter().copied().flatten()
    }

    /// Returns the record of this number, which must exist.
    fn same(&self, number: usize) -> Link<T> {
        self.find(number).expect("a record that is linked is in its table")
    }

    /// Copies the records of another table, each with its number.
    fn copy(&mut self, other: &Self, copy: impl Fn(Link<T>) -> T) {
        for record in &other.0 {
            self.0.push(record.map(|record| Link(NonNull::from(Box::leak(Box::new(copy(record)))))));
        }
    }

    /// Frees a record that nothing leads to any more.
    fn remove(&mut self, number: usize) {
        if let Some(record) = self.0.get_mut(number).and_then(Option::take) {
            // SAFETY: it was leaked by `add`, and is off the table now.
            drop(unsafe { Box::from_raw(record.0.as_ptr()) });
        }
    }
}

impl<T> Drop for Table<T> {
    fn drop(&mut self) {
        (0..self.0.len()).for_each(|number| self.remove(number));
    }
}

struct Vertex {
    number: usize,
    /// The face in which an isolated vertex lies.
    face: Cell<Option<Link<Face>>>,
}

struct HalfEdge {
    number: usize,
    origin: Cell<Link<Vertex>>,
    /// This link and the next two are set after both half-edges of an edge exist.
    twin: Cell<Option<Link<HalfEdge>>>,
    next: Cell<Option<Link<HalfEdge>>>,
    prev: Cell<Option<Link<HalfEdge>>>,
    face: Cell<Link<Face>>,
    is_outer: Cell<bool>,
}

struct Face {
    number: usize,
}

type Half = Link<HalfEdge>;

impl Half {
    /// Returns the half-edge at one of the links; itself while the link is not set.
    fn to(self, link: &Cell<Option<Self>>) -> Self {
        link.get().unwrap_or(self)
    }

    fn twin(self) -> Self {
        self.to(&self.twin)
    }

    fn next(self) -> Self {
        self.to(&self.next)
    }

    fn prev(self) -> Self {
        self.to(&self.prev)
    }

    fn origin(self) -> Link<Vertex> {
        self.origin.get()
    }

    fn face(self) -> Link<Face> {
        self.face.get()
    }

    fn is_outer(self) -> bool {
        self.is_outer.get()
    }

    /// Returns the next half-edge counter-clockwise around the same vertex.
    fn counter_clockwise(self) -> Self {
        self.prev().twin()
    }

    fn join(self, n: Self) {
        self.next.set(Some(n));
        n.prev.set(Some(self));
    }

    /// Removes its origin end from the rotation of the vertex, and closes the gap.
    fn take_out(self) {
        self.prev().join(self.twin().next());
    }

    /// Inserts its origin end, which is in no rotation, into the rotation of `a`: next counter-clockwise of it.
    fn put_in(self, a: Self) {
        a.prev().join(self);
        self.twin().join(a);
        self.origin.set(a.origin());
    }

    fn cycle(self) -> Vec<Self> {
        let mut cycle = vec![self];
        let mut h = self.next();
        while h != self {
            cycle.push(h);
            h = h.next();
        }
        cycle
    }

    fn component(self) -> Vec<Self> {
        let mut found = BTreeMap::from([(self.number, self)]);
        let mut rest = vec![self];
        while let Some(h) = rest.pop() {
            for other in [h.next(), h.twin()] {
                if found.insert(other.number, other).is_none() {
                    rest.push(other);
                }
            }
        }
        found.into_values().collect()
    }

    fn label(self, face: Link<Face>, is_outer: bool) {
        self.face.set(face);
        self.is_outer.set(is_outer);
    }

    fn label_cycle(self, face: Link<Face>, is_outer: bool) {
        self.cycle().into_iter().for_each(|h| h.label(face, is_outer));
    }
}

type Spot = Corner<Half, Link<Vertex>>;

fn vertex_of(spot: Spot) -> Link<Vertex> {
    match spot {
        Corner::At(h) => h.origin(),
        Corner::Isolated(v) => v,
    }
}

/// Returns the face in which a corner lies, and true if its boundary component is the outer one.
fn side_of(spot: Spot) -> Result<(Link<Face>, bool), Refusal> {
    match spot {
        Corner::At(h) => Ok((h.face(), h.is_outer())),
        Corner::Isolated(v) => Ok((v.face.get().ok_or(Refusal::NotIsolated)?, false)),
    }
}

fn share_boundary(a: Spot, b: Spot) -> bool {
    match (a, b) {
        (Corner::At(h), Corner::At(other)) => h.cycle().contains(&other),
        (Corner::Isolated(v), Corner::Isolated(other)) => v == other,
        _ => false,
    }
}

/// Moves the inner boundary component of a corner to a face.
fn give(spot: Spot, face: Link<Face>) {
    match spot {
        Corner::At(h) => h.label_cycle(face, false),
        Corner::Isolated(v) => v.face.set(Some(face)),
    }
}

/// A planar subdivision of records that are joined by raw pointers.
///
/// ```
/// use twinedge::program::{Program, conformance};
/// use twinedge::validate::Expectation;
/// use twinedge_trials::RawPointers;
/// let program = Program::from_bytes(b"some bytes that came from a fuzzer");
/// conformance::run(&program, RawPointers::new(), &Expectation::plane())?;
/// # Ok::<(), conformance::Failure>(())
/// ```
pub struct RawPointers {
    vertices: Table<Vertex>,
    half_edges: Table<HalfEdge>,
    /// The unbounded face has number 0.
    faces: Table<Face>,
}

const UNBOUNDED: usize = 0;

impl fmt::Debug for RawPointers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RawPointers")
            .field("vertices", &self.vertices.all().count())
            .field("half_edges", &self.half_edges.all().count())
            .field("faces", &self.faces.all().count())
            .finish()
    }
}

impl Default for RawPointers {
    fn default() -> Self {
        Self::new()
    }
}

impl RawPointers {
    /// Returns the empty map.
    #[must_use]
    pub fn new() -> Self {
        let mut faces = Table(Vec::new());
        faces.add(|number| Face { number });
        Self { vertices: Table(Vec::new()), half_edges: Table(Vec::new()), faces }
    }

    fn spot(&self, corner: Corner<usize, usize>) -> Result<Spot, Refusal> {
        let spot = match corner {
            Corner::At(h) => Corner::At(self.half_edges.find(h)?),
            Corner::Isolated(v) => Corner::Isolated(self.vertices.find(v)?),
        };
        side_of(spot).map(|_| spot)
    }

    fn make_vertex(&mut self, face: Option<Link<Face>>) -> Link<Vertex> {
        self.vertices.add(|number| Vertex { number, face: Cell::new(face) })
    }

    /// Makes an edge as a component of its own. The caller sets its face.
    fn make_edge(&mut self, from: Link<Vertex>, to: Link<Vertex>, face: Link<Face>) -> (Half, Half) {
        let [n, t] = [from, to].map(|origin| {
            self.half_edges.add(|number| HalfEdge {
                number,
                origin: Cell::new(origin),
                twin: Cell::new(None),
                next: Cell::new(None),
                prev: Cell::new(None),
                face: Cell::new(face),
                is_outer: Cell::new(false),
            })
        });
        for (h, twin) in [(n, t), (t, n)] {
            h.twin.set(Some(twin));
            h.join(twin);
        }
        (n, t)
    }

    fn drop_edge(&mut self, n: Half, t: Half) {
        for h in [n.number, t.number] {
            self.half_edges.remove(h);
        }
    }

    fn degree(&self, v: Link<Vertex>) -> usize {
        self.half_edges.all().filter(|h| h.origin() == v).count()
    }

    /// Returns the faces of the component of `h`, and those inside it.
    fn faces_inside(&self, h: Half) -> Vec<Link<Face>> {
        let mut faces: Vec<Link<Face>> = Vec::new();
        let mut rest = vec![h];
        while let Some(h) = rest.pop() {
            let outer = h.component().into_iter().filter(|h| h.is_outer()).map(Half::face);
            let outer: Vec<_> = outer.collect();
            for face in outer {
                if !faces.contains(&face) {
                    faces.push(face);
                    rest.extend(self.half_edges.all().filter(|h| h.face() == face && !h.is_outer()));
                }
            }
        }
        faces
    }

    fn connect(&mut self, from: Spot, to: Spot, new_face: Side, inner: &[Spot]) -> Result<usize, Refusal> {
        let ((face, from_outer), (other, to_outer)) = (side_of(from)?, side_of(to)?);
        if face != other {
            return Err(Refusal::FacesDiffer);
        }
        let splits = share_boundary(from, to);
        for spot in inner.iter().filter(|_| splits) {
            let (lies_in, is_outer) = side_of(*spot)?;
            if share_boundary(*spot, from) || is_outer || lies_in != face {
                return Err(Refusal::NotInner);
            }
        }
        let (n, t) = self.make_edge(vertex_of(from), vertex_of(to), face);
        if let Corner::At(a) = from {
            n.put_in(a);
        }
        match to {
            Corner::At(b) => t.put_in(b),
            // The formerly isolated vertex has a half-edge by now.
            Corner::Isolated(_) if splits => t.put_in(n),
            Corner::Isolated(_) => {}
        }
        for end in [from, to] {
            vertex_of(end).face.set(None);
        }
        if splits {
            let made = self.faces.add(|number| Face { number });
            let (of_new, of_old) = if new_face == Side::Left { (n, t) } else { (t, n) };
            of_new.label_cycle(made, true);
            of_old.label_cycle(face, from_outer);
            for spot in inner {
                give(*spot, made);
            }
        } else {
            n.label_cycle(face, from_outer || to_outer);
        }
        Ok(n.number)
    }

    fn remove_edge(&mut self, n: Half) -> Option<usize> {
        let t = n.twin();
        let (ends, left, right) = ([n.origin(), t.origin()], n.face(), t.face());
        let parts = n.cycle().contains(&t);
        let is_outer = n.is_outer() && t.is_outer();
        // The rest of the boundary at either end; the same cycle, if two cycles become one.
        let rests: Vec<Half> = [n.next(), t.next()].into_iter().filter(|h| *h != n && *h != t).collect();
        // If one face surrounds the other, it stays; of two side by side, the left one stays.
        let (kept, dropped) = if n.is_outer() && !t.is_outer() { (right, left) } else { (left, right) };
        n.take_out();
        t.take_out();
        self.drop_edge(n, t);
        for rest in rests {
            // When an outer cycle falls into two parts, the part whose component has its outside elsewhere stays outer.
            let stays_outer = is_outer && (!parts || rest.component().iter().any(|h| !h.is_outer()));
            rest.label_cycle(kept, stays_outer);
        }
        for end in ends {
            if self.degree(end) == 0 {
                end.face.set(Some(kept));
            }
        }
        if parts {
            return None;
        }
        let number = dropped.number;
        self.half_edges.all().filter(|h| h.face() == dropped).for_each(|h| h.face.set(kept));
        self.vertices.all().filter(|v| v.face.get() == Some(dropped)).for_each(|v| v.face.set(Some(kept)));
        self.faces.remove(number);
        Some(number)
    }

    fn split_edge(&mut self, h: Half) -> usize {
        let t = h.twin();
        let w = self.make_vertex(None);
        let (n, m) = self.make_edge(w, t.origin(), h.face());
        // The new edge takes the place of the old one, which then ends at the new vertex.
        m.put_in(t);
        t.take_out();
        t.put_in(n);
        n.label(h.face(), h.is_outer());
        m.label(t.face(), t.is_outer());
        n.number
    }

    fn join_edges(&mut self, h: Half) -> Result<(), Refusal> {
        let t = h.twin();
        let v = t.origin();
        if self.degree(v) != 2 {
            return Err(Refusal::DegreeNotTwo);
        }
        if h.origin() == v {
            return Err(Refusal::Loop);
        }
        let (n, m) = (h.next(), h.next().twin());
        // The old edge takes the place of the next one.
        t.take_out();
        t.put_in(m);
        m.take_out();
        self.drop_edge(n, m);
        self.vertices.remove(v.number);
        Ok(())
    }

    fn split_vertex(&mut self, from: Spot, to: Spot) -> Result<usize, Refusal> {
        let v = vertex_of(from);
        if v != vertex_of(to) {
            return Err(Refusal::VerticesDiffer);
        }
        let ((right, right_outer), (left, left_outer)) = (side_of(from)?, side_of(to)?);
        let w = self.make_vertex(None);
        let (n, t) = self.make_edge(v, w, left);
        if let (Corner::At(a), Corner::At(b)) = (from, to) {
            let mut moving = Vec::new();
            let mut h = a;
            while h != b {
                h = h.counter_clockwise();
                moving.push(h);
            }
            n.put_in(a);
            moving.into_iter().fold(t, |last, h| {
                h.take_out();
                h.put_in(last);
                h
            });
        }
        v.face.set(None);
        t.label(right, right_outer);
        n.label(left, left_outer);
        Ok(n.number)
    }

    fn contract_edge(&mut self, n: Half) -> Result<usize, Refusal> {
        let t = n.twin();
        let (kept, dropped) = (n.origin(), t.origin());
        if kept == dropped {
            return Err(Refusal::Loop);
        }
        let mut last = n;
        loop {
            let h = t.counter_clockwise();
            if h == t {
                break;
            }
            h.take_out();
            h.put_in(last);
            last = h;
        }
        n.take_out();
        let (face, number) = (n.face(), dropped.number);
        self.drop_edge(n, t);
        self.vertices.remove(number);
        if self.degree(kept) == 0 {
            kept.face.set(Some(face));
        }
        Ok(number)
    }

    fn flip_edge(n: Half, turn: Turn) -> Result<(), Refusal> {
        let t = n.twin();
        if n.cycle().contains(&t) {
            return Err(Refusal::NotSeparating);
        }
        let (n_alone, t_alone) = (n.next() == n, t.next() == t);
        if n_alone && t_alone {
            return Ok(());
        }
        let sides = [n, t].map(|h| (h, h.face(), h.is_outer()));
        // The two half-edges along which the ends move. A loop with nothing on one side moves along the other.
        let (x, y) = match turn {
            Turn::CounterClockwise => (n.next(), t.next()),
            Turn::Clockwise => (n.prev(), t.prev()),
        };
        let (x, y) = (if n_alone { y } else { x }, if t_alone { x } else { y });
        n.take_out();
        t.take_out();
        let (for_n, for_t) = match turn {
            Turn::CounterClockwise => (y.next(), x.next()),
            Turn::Clockwise => (x, y),
        };
        // The end of a loop that is put in last has nothing to its left.
        let ends = if n_alone { [(t, for_t), (n, for_n)] } else { [(n, for_n), (t, for_t)] };
        for (end, at) in ends {
            end.put_in(at);
        }
        for (h, face, is_outer) in sides {
            h.label_cycle(face, is_outer);
        }
        Ok(())
    }

    fn move_inner(&self, spot: Spot, face: Link<Face>) -> Result<(), Refusal> {
        if side_of(spot)?.1 {
            return Err(Refusal::IsOuter);
        }
        if matches!(spot, Corner::At(h) if self.faces_inside(h).contains(&face)) {
            return Err(Refusal::InsideItself);
        }
        give(spot, face);
        Ok(())
    }

    fn inner_starts(&self, face: usize) -> Vec<Start> {
        let (mut starts, mut seen) = (Vec::new(), BTreeSet::new());
        for h in self.half_edges.all().filter(|h| h.face().number == face && !h.is_outer()) {
            if !seen.contains(&h.number) {
                seen.extend(h.cycle().iter().map(|h| h.number));
                starts.push(Start::HalfEdge(h.number));
            }
        }
        let isolated = self.vertices.all().filter(|v| v.face.get().is_some_and(|f| f.number == face));
        starts.extend(isolated.map(|v| Start::Vertex(v.number)));
        starts
    }
}

impl Clone for RawPointers {
    fn clone(&self) -> Self {
        let faces = Table(Vec::with_capacity(self.faces.0.len()));
        let mut clone = Self { vertices: Table(Vec::new()), half_edges: Table(Vec::new()), faces };
        clone.faces.copy(&self.faces, |face| Face { number: face.number });
        let faces = &clone.faces;
        clone.vertices.copy(&self.vertices, |v| {
            let face = v.face.get().and_then(|face| faces.find(face.number).ok());
            Vertex { number: v.number, face: Cell::new(face) }
        });
        let vertices = &clone.vertices;
        clone.half_edges.copy(&self.half_edges, |h| HalfEdge {
            number: h.number,
            origin: Cell::new(vertices.same(h.origin().number)),
            twin: Cell::new(None),
            next: Cell::new(None),
            prev: Cell::new(None),
            face: Cell::new(faces.same(h.face().number)),
            is_outer: h.is_outer.clone(),
        });
        for (copy, h) in clone.half_edges.all().zip(self.half_edges.all()) {
            copy.twin.set(clone.half_edges.find(h.twin().number).ok());
            copy.join(clone.half_edges.same(h.next().number));
        }
        clone
    }
}

impl Subject for RawPointers {
    type Vertex = usize;
    type HalfEdge = usize;
    type Face = usize;

    fn unbounded_face(&self) -> Option<usize> {
        Some(UNBOUNDED)
    }

    fn half_edge_at(&self, index: usize) -> Option<usize> {
        self.is_half_edge(index).then_some(index)
    }

    fn vertex_at(&self, index: usize) -> Option<usize> {
        self.is_vertex(index).then_some(index)
    }

    fn face_of(&self, corner: Corner<usize, usize>) -> Result<usize, Refusal> {
        Ok(side_of(self.spot(corner)?)?.0.number)
    }

    fn origin_of(&self, half_edge: usize) -> Result<usize, Refusal> {
        Ok(self.half_edges.find(half_edge)?.origin().number)
    }

    fn twin_of(&self, half_edge: usize) -> Result<usize, Refusal> {
        Ok(self.half_edges.find(half_edge)?.twin().number)
    }

    fn next_of(&self, half_edge: usize) -> Result<usize, Refusal> {
        Ok(self.half_edges.find(half_edge)?.next().number)
    }

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        let nothing = |()| None;
        match call {
            Call::AddIsolatedVertex { face } => {
                let face = self.faces.find(face)?;
                Ok(Some(Handle::Vertex(self.make_vertex(Some(face)).number)))
            }
            Call::RemoveIsolatedVertex { vertex } => {
                self.spot(Corner::Isolated(vertex))?;
                self.vertices.remove(vertex);
                Ok(None)
            }
            Call::Connect { from, to, new_face, inner } => {
                let (from, to) = (self.spot(from)?, self.spot(to)?);
                let inner = inner.into_iter().map(|corner| self.spot(corner)).collect::<Result<Vec<_>, _>>()?;
                self.connect(from, to, new_face, &inner).map(Handle::HalfEdge).map(Some)
            }
            Call::RemoveEdge { half_edge } => {
                let n = self.half_edges.find(half_edge)?;
                Ok(self.remove_edge(n).map(Handle::Face))
            }
            Call::SplitEdge { half_edge } => {
                let h = self.half_edges.find(half_edge)?;
                Ok(Some(Handle::HalfEdge(self.split_edge(h))))
            }
            Call::JoinEdges { half_edge } => self.join_edges(self.half_edges.find(half_edge)?).map(nothing),
            Call::SplitVertex { from, to } => {
                let (from, to) = (self.spot(from)?, self.spot(to)?);
                self.split_vertex(from, to).map(Handle::HalfEdge).map(Some)
            }
            Call::ContractEdge { half_edge } => {
                let n = self.half_edges.find(half_edge)?;
                self.contract_edge(n).map(Handle::Vertex).map(Some)
            }
            Call::FlipEdge { half_edge, turn } => Self::flip_edge(self.half_edges.find(half_edge)?, turn).map(nothing),
            Call::MoveInner { inner, face } => self.move_inner(self.spot(inner)?, self.faces.find(face)?).map(nothing),
            Call::MeshFlipEdge { half_edge } => mesh::flip_edge(self, half_edge).map(nothing),
            Call::MeshSplitEdge { half_edge } => mesh::split_edge(self, half_edge).map(nothing),
            Call::MeshSplitFace { half_edge } => mesh::split_face(self, half_edge).map(nothing),
            Call::MeshCollapseEdge { half_edge } => mesh::collapse_edge(self, half_edge).map(nothing),
        }
    }
}

impl View for RawPointers {
    fn parts(&self) -> Parts {
        Parts::ALL.without(Part::BoundaryComponents)
    }
    fn vertex_slots(&self) -> usize {
        self.vertices.0.len()
    }
    fn half_edge_slots(&self) -> usize {
        self.half_edges.0.len()
    }
    fn face_slots(&self) -> usize {
        self.faces.0.len()
    }
    fn is_vertex(&self, vertex: usize) -> bool {
        self.vertices.find(vertex).is_ok()
    }
    fn is_half_edge(&self, half_edge: usize) -> bool {
        self.half_edges.find(half_edge).is_ok()
    }
    fn is_face(&self, face: usize) -> bool {
        self.faces.find(face).is_ok()
    }
    fn origin(&self, half_edge: usize) -> ViewLink {
        Some(self.half_edges.find(half_edge).ok()?.origin().number)
    }
    fn twin(&self, half_edge: usize) -> ViewLink {
        Some(self.half_edges.find(half_edge).ok()?.twin().number)
    }
    fn next(&self, half_edge: usize) -> ViewLink {
        Some(self.half_edges.find(half_edge).ok()?.next().number)
    }
    fn prev(&self, half_edge: usize) -> ViewLink {
        Some(self.half_edges.find(half_edge).ok()?.prev().number)
    }
    fn face(&self, half_edge: usize) -> ViewLink {
        Some(self.half_edges.find(half_edge).ok()?.face().number)
    }
    fn leaving(&self, vertex: usize) -> ViewLink {
        self.half_edges.all().find(|h| h.origin().number == vertex).map(|h| h.number)
    }
    fn outer_half_edge(&self, face: usize) -> ViewLink {
        self.half_edges.all().find(|h| h.face().number == face && h.is_outer()).map(|h| h.number)
    }
    fn inner_count(&self, face: usize) -> usize {
        self.inner_starts(face).len()
    }
    fn inner_start(&self, face: usize, position: usize) -> Option<Start> {
        self.inner_starts(face).get(position).copied()
    }
}
