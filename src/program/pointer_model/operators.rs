//! The operators of the model, each written from its definition.
//!
//! All surgery consists of two moves, inverses of each other:
//!
//! ```text
//!        \   /  a                    \   /  a
//!         \ ╱        put_in(x, a)     \ ╱
//!          ·              ──►          ·───── x        the end where x leaves becomes the next one
//!                         ◄──         ╱                counter-clockwise of a
//!     · x ─────       take_out(x)
//! ```
//!
//! There are no special cases: loops, leaves and last edges work because each move reads the result of the move before it.

use super::{Face, HalfEdge, Owned, PointerModel, PointerModelFace, PointerModelHalfEdge, PointerModelVertex, Vertex};
use super::{component, contains, cycle, face, is_outer, label, label_cycle, next, origin, prev, same, to, twin};
use crate::dcel::{Corner, Side, Turn};
use crate::program::mesh;
use crate::program::operators::{Call, Handle};
use crate::program::subject::{CallOf, CornerOf, HandleOf, Refusal, Subject};
use alloc::rc::Rc;
use alloc::vec::Vec;

/// A corner whose handle has been found.
type Spot = Corner<Owned<HalfEdge>, Owned<Vertex>>;

fn follow(h: &Owned<HalfEdge>, n: &Owned<HalfEdge>) {
    h.borrow_mut().next = Rc::downgrade(n);
    n.borrow_mut().prev = Rc::downgrade(h);
}

/// Takes the origin end of `x` out of the rotation of its vertex, and closes the gap.
fn take_out(x: &Owned<HalfEdge>) {
    follow(&prev(x), &next(&twin(x)));
}

/// Puts the origin end of `x`, which is in no rotation, into the rotation of `a`, next counter-clockwise of it.
fn put_in(x: &Owned<HalfEdge>, a: &Owned<HalfEdge>) {
    follow(&prev(a), x);
    follow(&twin(x), a);
    x.borrow_mut().origin = Rc::downgrade(&origin(a));
}

fn counter_clockwise(h: &Owned<HalfEdge>) -> Owned<HalfEdge> {
    twin(&prev(h))
}

fn isolate(v: &Owned<Vertex>, f: &Owned<Face>) {
    v.borrow_mut().face = Some(Rc::downgrade(f));
}

fn spot_vertex(spot: &Spot) -> Owned<Vertex> {
    match spot {
        Corner::At(h) => origin(h),
        Corner::Isolated(v) => v.clone(),
    }
}

fn spot_side(spot: &Spot) -> Result<(Owned<Face>, bool), Refusal> {
    match spot {
        Corner::At(h) => Ok((face(h), is_outer(h))),
        Corner::Isolated(v) => Ok((v.borrow().face.as_ref().map(to).ok_or(Refusal::NotIsolated)?, false)),
    }
}

fn no_border<'a>(faces: impl IntoIterator<Item = &'a Owned<Face>>) -> Result<(), Refusal> {
    if faces.into_iter().any(|f| f.borrow().border) { Err(Refusal::Border) } else { Ok(()) }
}

fn same_boundary(a: &Spot, b: &Spot) -> bool {
    match (a, b) {
        (Corner::At(h), Corner::At(other)) => contains(&cycle(h), other),
        (Corner::Isolated(v), Corner::Isolated(other)) => same(v, other),
        _ => false,
    }
}

fn give(spot: &Spot, f: &Owned<Face>) {
    match spot {
        Corner::At(h) => label_cycle(h, f, false),
        Corner::Isolated(v) => isolate(v, f),
    }
}

/// Finds a record by name. Names rise along each list: new records come last.
fn find<T, N: Ord>(list: &[Owned<T>], name: &N, of: impl Fn(&T) -> N) -> Result<Owned<T>, Refusal> {
    let position = list.binary_search_by(|record| of(&record.borrow()).cmp(name));
    position.map(|position| list[position].clone()).map_err(|_| Refusal::Stale)
}

impl PointerModel {
    fn find_vertex(&self, name: PointerModelVertex) -> Result<Owned<Vertex>, Refusal> {
        find(&self.vertices, &name, |v| v.name)
    }

    fn find_half_edge(&self, name: PointerModelHalfEdge) -> Result<Owned<HalfEdge>, Refusal> {
        find(&self.half_edges, &name, |h| h.name)
    }

    fn find_face(&self, name: PointerModelFace) -> Result<Owned<Face>, Refusal> {
        find(&self.faces, &name, |f| f.name)
    }

    fn find_corner(&self, corner: CornerOf<Self>) -> Result<Spot, Refusal> {
        let spot = match corner {
            Corner::At(h) => Corner::At(self.find_half_edge(h)?),
            Corner::Isolated(v) => Corner::Isolated(self.find_vertex(v)?),
        };
        spot_side(&spot)?;
        Ok(spot)
    }

    /// Makes an edge whose ends are in no rotation yet, and returns its two half-edges.
    fn make_edge(&mut self, from: &Owned<Vertex>, to: &Owned<Vertex>) -> (Owned<HalfEdge>, Owned<HalfEdge>) {
        let (n, t) = (self.make_half_edge(from), self.make_half_edge(to));
        n.borrow_mut().twin = Rc::downgrade(&t);
        t.borrow_mut().twin = Rc::downgrade(&n);
        follow(&n, &t);
        follow(&t, &n);
        (n, t)
    }

    fn drop_edge(&mut self, n: &Owned<HalfEdge>, t: &Owned<HalfEdge>) {
        self.half_edges.retain(|h| !same(h, n) && !same(h, t));
    }

    fn drop_vertex(&mut self, v: &Owned<Vertex>) {
        self.vertices.retain(|other| !same(other, v));
    }

    fn has_half_edges(&self, v: &Owned<Vertex>) -> bool {
        self.half_edges.iter().any(|h| same(&origin(h), v))
    }

    /// The faces inside a component: the faces it bounds from outside, and the faces inside components that lie in these.
    fn faces_inside(&self, of: &Owned<HalfEdge>) -> Vec<Owned<Face>> {
        let mut inside = Vec::new();
        let mut half_edges = component(of);
        while let Some(h) = half_edges.pop() {
            let f = face(&h);
            if is_outer(&h) && !contains(&inside, &f) {
                for inner in self.half_edges.iter().filter(|inner| same(&face(inner), &f) && !is_outer(inner)) {
                    half_edges.extend(component(inner));
                }
                inside.push(f);
            }
        }
        inside
    }

    fn merge_faces(&mut self, kept: &Owned<Face>, dropped: &Owned<Face>) {
        for h in self.half_edges.iter().filter(|h| same(&face(h), dropped)) {
            h.borrow_mut().face = Rc::downgrade(kept);
        }
        for v in &self.vertices {
            let lies_there = v.borrow().face.as_ref().is_some_and(|f| same(&to(f), dropped));
            if lies_there {
                isolate(v, kept);
            }
        }
        self.faces.retain(|f| !same(f, dropped));
    }
}

impl Subject for PointerModel {
    type Vertex = PointerModelVertex;
    type HalfEdge = PointerModelHalfEdge;
    type Face = PointerModelFace;

    fn unbounded_face(&self) -> Option<PointerModelFace> {
        let first = self.faces.first().filter(|_| !self.discs)?.borrow();
        (!first.border).then_some(first.name)
    }

    fn half_edge_at(&self, index: usize) -> Option<PointerModelHalfEdge> {
        Some(self.half_edges.get(index)?.borrow().name)
    }

    fn vertex_at(&self, index: usize) -> Option<PointerModelVertex> {
        Some(self.vertices.get(index)?.borrow().name)
    }

    fn face_of(&self, corner: CornerOf<Self>) -> Result<PointerModelFace, Refusal> {
        let (f, _) = spot_side(&self.find_corner(corner)?)?;
        no_border([&f])?;
        Ok(f.borrow().name)
    }

    fn origin_of(&self, half_edge: PointerModelHalfEdge) -> Result<PointerModelVertex, Refusal> {
        Ok(origin(&self.find_half_edge(half_edge)?).borrow().name)
    }

    fn twin_of(&self, half_edge: PointerModelHalfEdge) -> Result<PointerModelHalfEdge, Refusal> {
        Ok(twin(&self.find_half_edge(half_edge)?).borrow().name)
    }

    fn next_of(&self, half_edge: PointerModelHalfEdge) -> Result<PointerModelHalfEdge, Refusal> {
        Ok(next(&self.find_half_edge(half_edge)?).borrow().name)
    }

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        let nothing = |()| None;
        match call {
            Call::AddIsolatedVertex { face } => self.add_isolated_vertex(face).map(Handle::Vertex).map(Some),
            Call::RemoveIsolatedVertex { vertex } => self.remove_isolated_vertex(vertex).map(nothing),
            Call::Connect { from, to, new_face, inner } => {
                self.connect(from, to, new_face, &inner).map(Handle::HalfEdge).map(Some)
            }
            Call::RemoveEdge { half_edge } => Ok(self.remove_edge(half_edge)?.map(Handle::Face)),
            Call::SplitEdge { half_edge } => self.split_edge(half_edge).map(Handle::HalfEdge).map(Some),
            Call::JoinEdges { half_edge } => self.join_edges(half_edge).map(nothing),
            Call::SplitVertex { from, to } => self.split_vertex(from, to).map(Handle::HalfEdge).map(Some),
            Call::ContractEdge { half_edge } => self.contract_edge(half_edge).map(Handle::Vertex).map(Some),
            Call::FlipEdge { half_edge, turn } => self.flip_edge(half_edge, turn).map(nothing),
            Call::MoveInner { inner, face } => self.move_inner(inner, face).map(nothing),
            Call::MeshFlipEdge { half_edge } => mesh::flip_edge(self, half_edge).map(nothing),
            Call::MeshSplitEdge { half_edge } => mesh::split_edge(self, half_edge).map(nothing),
            Call::MeshSplitFace { half_edge } => mesh::split_face(self, half_edge).map(nothing),
            Call::MeshCollapseEdge { half_edge } => mesh::collapse_edge(self, half_edge).map(nothing),
        }
    }
}

impl PointerModel {
    fn add_isolated_vertex(&mut self, face: PointerModelFace) -> Result<PointerModelVertex, Refusal> {
        let f = self.find_face(face)?;
        if self.discs {
            return Err(Refusal::NotDisc);
        }
        let v = self.make_vertex();
        isolate(&v, &f);
        self.rebuild();
        Ok(v.borrow().name)
    }

    fn remove_isolated_vertex(&mut self, vertex: PointerModelVertex) -> Result<(), Refusal> {
        let v = self.find_vertex(vertex)?;
        if v.borrow().face.is_none() {
            return Err(Refusal::NotIsolated);
        }
        self.drop_vertex(&v);
        self.rebuild();
        Ok(())
    }

    fn connect(
        &mut self,
        from: CornerOf<Self>,
        to: CornerOf<Self>,
        new_face: Side,
        inner: &[CornerOf<Self>],
    ) -> Result<PointerModelHalfEdge, Refusal> {
        let (from, to) = (self.find_corner(from)?, self.find_corner(to)?);
        let inner: Vec<Spot> = inner.iter().map(|corner| self.find_corner(*corner)).collect::<Result<_, _>>()?;
        let ((f, from_outer), (other, to_outer)) = (spot_side(&from)?, spot_side(&to)?);
        no_border([&f, &other])?;
        if !same(&f, &other) {
            return Err(Refusal::FacesDiffer);
        }
        let splits = same_boundary(&from, &to);
        if splits {
            for spot in &inner {
                let (lies_in, outer) = spot_side(spot)?;
                if same_boundary(spot, &from) || outer || !same(&lies_in, &f) {
                    return Err(Refusal::NotInner);
                }
            }
        }
        let (n, t) = self.make_edge(&spot_vertex(&from), &spot_vertex(&to));
        if let Corner::At(a) = &from {
            put_in(&n, a);
        }
        match &to {
            Corner::At(b) => put_in(&t, b),
            // By now there is a half-edge at the vertex that was isolated.
            Corner::Isolated(_) if splits => put_in(&t, &n),
            Corner::Isolated(_) => {}
        }
        for end in [&from, &to] {
            spot_vertex(end).borrow_mut().face = None;
        }
        if splits {
            let g = self.make_face();
            let (of_new, of_old) = match new_face {
                Side::Left => (&n, &t),
                Side::Right => (&t, &n),
            };
            label_cycle(of_new, &g, true);
            label_cycle(of_old, &f, from_outer);
            for spot in &inner {
                give(spot, &g);
            }
        } else {
            label_cycle(&n, &f, from_outer || to_outer);
        }
        self.rebuild();
        Ok(n.borrow().name)
    }

    fn remove_edge(&mut self, half_edge: PointerModelHalfEdge) -> Result<Option<PointerModelFace>, Refusal> {
        let n = self.find_half_edge(half_edge)?;
        let t = twin(&n);
        let ends = [origin(&n), origin(&t)];
        let parts = contains(&cycle(&n), &t);
        let (left, right) = (face(&n), face(&t));
        no_border([&left, &right])?;
        if self.discs && parts {
            return Err(Refusal::NotDisc);
        }
        let outer = is_outer(&n) && is_outer(&t);
        // The rest of the boundary at either end; the same cycle, if two cycles become one.
        let rests: Vec<_> = [next(&n), next(&t)].into_iter().filter(|h| !same(h, &n) && !same(h, &t)).collect();
        // The surrounding face survives; of two faces side by side, the left one.
        let kept = if is_outer(&n) && !is_outer(&t) { &right } else { &left };
        let dropped = if same(kept, &left) { &right } else { &left };

        take_out(&n);
        take_out(&t);
        self.drop_edge(&n, &t);
        for rest in &rests {
            // If an outer cycle falls into two parts, the part whose component has its outside elsewhere stays outer.
            let stays_outer = outer && (!parts || component(rest).iter().any(|h| !is_outer(h)));
            label_cycle(rest, kept, stays_outer);
        }
        for end in ends.iter().filter(|end| !self.has_half_edges(end)) {
            isolate(end, kept);
        }
        if !parts {
            self.merge_faces(kept, dropped);
        }
        self.rebuild();
        Ok(if parts { None } else { Some(dropped.borrow().name) })
    }

    fn split_edge(&mut self, half_edge: PointerModelHalfEdge) -> Result<PointerModelHalfEdge, Refusal> {
        let h = self.find_half_edge(half_edge)?;
        let t = twin(&h);
        let w = self.make_vertex();
        let (n, m) = self.make_edge(&w, &origin(&t));
        // The new edge takes the place of the old one, which now ends at the new vertex.
        put_in(&m, &t);
        take_out(&t);
        put_in(&t, &n);
        label(&n, &face(&h), is_outer(&h));
        label(&m, &face(&t), is_outer(&t));
        self.rebuild();
        Ok(n.borrow().name)
    }

    fn join_edges(&mut self, half_edge: PointerModelHalfEdge) -> Result<(), Refusal> {
        let h = self.find_half_edge(half_edge)?;
        let t = twin(&h);
        let v = origin(&t);
        if self.half_edges.iter().filter(|other| same(&origin(other), &v)).count() != 2 {
            return Err(Refusal::DegreeNotTwo);
        }
        if same(&origin(&h), &v) {
            return Err(Refusal::Loop);
        }
        let n = next(&h);
        let m = twin(&n);
        // The old edge takes the place of the next one.
        take_out(&t);
        put_in(&t, &m);
        take_out(&m);
        self.drop_edge(&n, &m);
        self.drop_vertex(&v);
        self.rebuild();
        Ok(())
    }

    fn split_vertex(&mut self, from: CornerOf<Self>, to: CornerOf<Self>) -> Result<PointerModelHalfEdge, Refusal> {
        let (from, to) = (self.find_corner(from)?, self.find_corner(to)?);
        let v = spot_vertex(&from);
        if !same(&v, &spot_vertex(&to)) {
            return Err(Refusal::VerticesDiffer);
        }
        let ((f, from_outer), (g, to_outer)) = (spot_side(&from)?, spot_side(&to)?);
        if f.borrow().border && g.borrow().border {
            return Err(Refusal::Border);
        }
        let w = self.make_vertex();
        let (n, t) = self.make_edge(&v, &w);
        if let (Corner::At(a), Corner::At(b)) = (&from, &to) {
            let mut moving = Vec::new();
            let mut h = a.clone();
            while !same(&h, b) {
                h = counter_clockwise(&h);
                moving.push(h.clone());
            }
            put_in(&n, a);
            let mut last = t.clone();
            for h in moving {
                take_out(&h);
                put_in(&h, &last);
                last = h;
            }
        }
        v.borrow_mut().face = None;
        label(&t, &f, from_outer);
        label(&n, &g, to_outer);
        self.rebuild();
        Ok(n.borrow().name)
    }

    fn contract_edge(&mut self, half_edge: PointerModelHalfEdge) -> Result<PointerModelVertex, Refusal> {
        let n = self.find_half_edge(half_edge)?;
        let t = twin(&n);
        let (kept, dropped) = (origin(&n), origin(&t));
        if same(&kept, &dropped) {
            return Err(Refusal::Loop);
        }
        if self.discs && same(&next(&n), &t) && same(&next(&t), &n) {
            return Err(Refusal::NotDisc);
        }
        let mut last = n.clone();
        loop {
            let h = counter_clockwise(&t);
            if same(&h, &t) {
                break;
            }
            take_out(&h);
            put_in(&h, &last);
            last = h;
        }
        take_out(&n);
        let f = face(&n);
        self.drop_edge(&n, &t);
        self.drop_vertex(&dropped);
        if !self.has_half_edges(&kept) {
            isolate(&kept, &f);
        }
        self.rebuild();
        Ok(dropped.borrow().name)
    }

    fn flip_edge(&mut self, half_edge: PointerModelHalfEdge, turn: Turn) -> Result<(), Refusal> {
        let n = self.find_half_edge(half_edge)?;
        let t = twin(&n);
        no_border([&face(&n), &face(&t)])?;
        if contains(&cycle(&n), &t) {
            return Err(Refusal::NotSeparating);
        }
        let (n_alone, t_alone) = (same(&next(&n), &n), same(&next(&t), &t));
        if n_alone && t_alone {
            return Ok(());
        }
        let (left, left_outer) = (face(&n), is_outer(&n));
        let (right, right_outer) = (face(&t), is_outer(&t));
        // The two half-edges along which the ends move. A loop with nothing on one side moves along the other.
        let (x, y) = match turn {
            Turn::CounterClockwise => (next(&n), next(&t)),
            Turn::Clockwise => (prev(&n), prev(&t)),
        };
        let (x, y) = (if n_alone { &y } else { &x }, if t_alone { &x } else { &y });
        take_out(&n);
        take_out(&t);
        let (for_n, for_t) = match turn {
            Turn::CounterClockwise => (next(y), next(x)),
            Turn::Clockwise => (x.clone(), y.clone()),
        };
        // The end of a loop that is put in last has nothing to its left.
        if n_alone {
            put_in(&t, &for_t);
            put_in(&n, &for_n);
        } else {
            put_in(&n, &for_n);
            put_in(&t, &for_t);
        }
        label_cycle(&n, &left, left_outer);
        label_cycle(&t, &right, right_outer);
        self.rebuild();
        Ok(())
    }

    fn move_inner(&mut self, inner: CornerOf<Self>, face: PointerModelFace) -> Result<(), Refusal> {
        let spot = self.find_corner(inner)?;
        let f = self.find_face(face)?;
        let (old, outer) = spot_side(&spot)?;
        no_border([&old])?;
        if outer {
            return Err(Refusal::IsOuter);
        }
        let inside_itself = match &spot {
            Corner::At(h) => contains(&self.faces_inside(h), &f),
            Corner::Isolated(_) => false,
        };
        if inside_itself {
            return Err(Refusal::InsideItself);
        }
        give(&spot, &f);
        self.rebuild();
        Ok(())
    }
}
