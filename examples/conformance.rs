//! A half-edge structure of somebody's own, tried against the reference: `cargo run --example conformance`.
//!
//! The structure is the textbook's, with four of the ten operators. It has a bug that is easily made. Removing an edge
//! whose two sides lie in the same face cuts a component in two; if that happened inside a face, one part still bounds
//! the face from outside and the other is an island now. Which is which? `Mine` believes that the part where the
//! half-edge starts stays outside. Random programs find the bug, and shrinking leaves what matters of the one that did.

use twinedge::program::{Call, CallOf, Corner, Handle, HandleOf, Refusal, Side, Subject, conformance};
use twinedge::validate::{Expectation, Part, Parts, Start, View};
use twinedge::view_answers;

#[derive(Clone)]
struct Vertex {
    leaving: Option<usize>,
    /// The face in which it lies, if nothing leaves it.
    face: usize,
}

#[derive(Clone)]
struct HalfEdge {
    origin: usize,
    next: usize,
    prev: usize,
    face: usize,
}

#[derive(Clone)]
struct Face {
    /// A half-edge of the outer cycle; none for the unbounded face. Holes are found by looking.
    outer: Option<usize>,
}

/// The structure on trial. The twin of `h` is `h ^ 1`; slots are never used again, so an old index is a stale handle.
#[derive(Clone)]
struct Mine {
    vertices: Vec<Option<Vertex>>,
    half_edges: Vec<Option<HalfEdge>>,
    faces: Vec<Option<Face>>,
    has_bug: bool,
}

impl Mine {
    fn new(has_bug: bool) -> Self {
        Self { vertices: Vec::new(), half_edges: Vec::new(), faces: vec![Some(Face { outer: None })], has_bug }
    }

    fn live(&self, h: usize) -> Result<&HalfEdge, Refusal> {
        self.half_edges.get(h).and_then(Option::as_ref).ok_or(Refusal::Stale)
    }

    fn get(&self, h: usize) -> &HalfEdge {
        self.half_edges[h].as_ref().expect("a link leads to a live half-edge")
    }

    fn get_mut(&mut self, h: usize) -> &mut HalfEdge {
        self.half_edges[h].as_mut().expect("a link leads to a live half-edge")
    }

    fn vertex(&mut self, v: usize) -> &mut Vertex {
        self.vertices[v].as_mut().expect("a link leads to a live vertex")
    }

    fn outer(&self, f: usize) -> Option<usize> {
        self.faces[f].as_ref()?.outer
    }

    fn join(&mut self, h: usize, next: usize) {
        self.get_mut(h).next = next;
        self.get_mut(next).prev = h;
    }

    fn cycle(&self, start: usize) -> Vec<usize> {
        let mut cycle = vec![start];
        while self.get(cycle[cycle.len() - 1]).next != start {
            cycle.push(self.get(cycle[cycle.len() - 1]).next);
        }
        cycle
    }

    fn is_outer(&self, h: usize) -> bool {
        self.outer(self.get(h).face).is_some_and(|outer| self.cycle(h).contains(&outer))
    }

    fn relabel(&mut self, corner: Corner<usize, usize>, face: usize) {
        match corner {
            Corner::At(h) => self.cycle(h).into_iter().for_each(|h| self.get_mut(h).face = face),
            Corner::Isolated(v) => self.vertex(v).face = face,
        }
    }

    /// Puts a half-edge that has nowhere to come from yet into a corner: it leaves, and its twin arrives.
    fn attach(&mut self, h: usize, corner: Corner<usize, usize>) {
        match corner {
            Corner::At(at) => {
                let before = self.get(at).prev;
                self.join(before, h);
                self.join(h ^ 1, at);
            }
            Corner::Isolated(v) => {
                // A loop at an isolated vertex finds its other end there.
                let at = self.vertex(v).leaving.get_or_insert(h).to_owned();
                let before = if at == h { h ^ 1 } else { self.get(at).prev };
                self.join(before, h);
                self.join(h ^ 1, at);
            }
        }
    }

    fn detach(&mut self, h: usize) {
        let HalfEdge { origin, prev, face, .. } = self.get(h).clone();
        let after = self.get(h ^ 1).next;
        self.join(prev, after);
        let alone = after == h;
        *self.vertex(origin) = Vertex { leaving: (!alone).then_some(after), face };
    }

    fn inner_starts(&self, face: usize) -> Vec<Start> {
        let mut starts = Vec::new();
        let mut seen: Vec<usize> = self.outer(face).map_or(Vec::new(), |outer| self.cycle(outer));
        for (h, record) in self.half_edges.iter().enumerate() {
            if record.as_ref().is_some_and(|record| record.face == face) && !seen.contains(&h) {
                seen.extend(self.cycle(h));
                starts.push(Start::HalfEdge(h));
            }
        }
        let lies_here = |v: &Option<Vertex>| v.as_ref().is_some_and(|v| v.leaving.is_none() && v.face == face);
        starts.extend((0..self.vertices.len()).filter(|v| lies_here(&self.vertices[*v])).map(Start::Vertex));
        starts
    }
}

/// The questions of the validator.
impl View for Mine {
    view_answers! { |map|
        parts => Parts::ALL.without(Part::BoundaryComponents),
        vertex_slots => map.vertices.len(),
        half_edge_slots => map.half_edges.len(),
        face_slots => map.faces.len(),
        is_vertex(v) => map.vertices[v].is_some(),
        is_half_edge(h) => map.half_edges[h].is_some(),
        is_face(f) => map.faces[f].is_some(),
        origin(h) => Some(map.get(h).origin),
        twin(h) => Some(h ^ 1),
        next(h) => Some(map.get(h).next),
        prev(h) => Some(map.get(h).prev),
        face(h) => Some(map.get(h).face),
        leaving(v) => map.vertices[v].as_ref()?.leaving,
        outer_half_edge(f) => map.outer(f),
        inner_count(f) => map.inner_starts(f).len(),
        inner_start(f, position) => map.inner_starts(f).get(position).copied(),
    }
}

/// The questions and operators of programs.
impl Subject for Mine {
    type Vertex = usize;
    type HalfEdge = usize;
    type Face = usize;

    fn unbounded_face(&self) -> Option<usize> {
        Some(0)
    }

    fn half_edge_at(&self, index: usize) -> Option<usize> {
        Some(index)
    }

    fn vertex_at(&self, index: usize) -> Option<usize> {
        Some(index)
    }

    fn face_of(&self, corner: Corner<usize, usize>) -> Result<usize, Refusal> {
        match corner {
            Corner::At(h) => Ok(self.live(h)?.face),
            Corner::Isolated(v) => {
                let v = self.vertices.get(v).and_then(Option::as_ref).ok_or(Refusal::Stale)?;
                if v.leaving.is_some() { Err(Refusal::NotIsolated) } else { Ok(v.face) }
            }
        }
    }

    fn origin_of(&self, h: usize) -> Result<usize, Refusal> {
        Ok(self.live(h)?.origin)
    }

    fn twin_of(&self, h: usize) -> Result<usize, Refusal> {
        self.live(h).map(|_| h ^ 1)
    }

    fn next_of(&self, h: usize) -> Result<usize, Refusal> {
        Ok(self.live(h)?.next)
    }

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        match call {
            Call::AddIsolatedVertex { face } => Ok(Some(Handle::Vertex(self.add_isolated_vertex(face)?))),
            Call::RemoveIsolatedVertex { vertex } => self.remove_isolated_vertex(vertex).map(|()| None),
            Call::Connect { from, to, new_face, inner } => {
                Ok(Some(Handle::HalfEdge(self.connect(from, to, new_face, &inner)?)))
            }
            Call::RemoveEdge { half_edge } => Ok(self.remove_edge(half_edge)?.map(Handle::Face)),
            _ => Err(Refusal::Unsupported),
        }
    }
}

impl Mine {
    fn add_isolated_vertex(&mut self, face: usize) -> Result<usize, Refusal> {
        self.faces.get(face).and_then(Option::as_ref).ok_or(Refusal::Stale)?;
        self.vertices.push(Some(Vertex { leaving: None, face }));
        Ok(self.vertices.len() - 1)
    }

    fn remove_isolated_vertex(&mut self, v: usize) -> Result<(), Refusal> {
        self.face_of(Corner::Isolated(v))?;
        self.vertices[v] = None;
        Ok(())
    }

    fn connect(
        &mut self,
        from: Corner<usize, usize>,
        to: Corner<usize, usize>,
        new_face: Side,
        inner: &[Corner<usize, usize>],
    ) -> Result<usize, Refusal> {
        let (face, face_of_to) = (self.face_of(from)?, self.face_of(to)?);
        let inner_faces = inner.iter().map(|corner| self.face_of(*corner)).collect::<Result<Vec<_>, _>>()?;
        if face != face_of_to {
            return Err(Refusal::FacesDiffer);
        }
        let is_split = |corner: Corner<usize, usize>| match (from, corner) {
            (Corner::At(a), Corner::At(b)) => self.cycle(a).contains(&b),
            _ => from == corner,
        };
        let splits = is_split(to);
        let may_go =
            |corner: Corner<usize, usize>| !is_split(corner) && !matches!(corner, Corner::At(h) if self.is_outer(h));
        if splits && (inner_faces.iter().any(|f| *f != face) || !inner.iter().all(|corner| may_go(*corner))) {
            return Err(Refusal::NotInner);
        }
        let was_outer = matches!(from, Corner::At(h) if self.is_outer(h));
        let n = self.half_edges.len();
        for (h, corner) in [(n, from), (n + 1, to)] {
            let origin = match corner {
                Corner::At(at) => self.get(at).origin,
                Corner::Isolated(v) => v,
            };
            self.half_edges.push(Some(HalfEdge { origin, next: h ^ 1, prev: h ^ 1, face }));
        }
        self.attach(n, from);
        self.attach(n + 1, to);
        if splits {
            let (of_new, of_old) = if new_face == Side::Left { (n, n + 1) } else { (n + 1, n) };
            self.faces.push(Some(Face { outer: Some(of_new) }));
            let new = self.faces.len() - 1;
            self.relabel(Corner::At(of_new), new);
            for corner in inner {
                self.relabel(*corner, new);
            }
            if was_outer {
                self.faces[face] = Some(Face { outer: Some(of_old) });
            }
        }
        Ok(n)
    }

    fn remove_edge(&mut self, n: usize) -> Result<Option<usize>, Refusal> {
        self.live(n)?;
        let t = n ^ 1;
        let before = self.clone();
        let rest = [self.get(t).next, self.get(n).next].into_iter().filter(|h| *h != n && *h != t);
        let (left, right) = (self.get(n).face, self.get(t).face);
        let (kept, dropped) = if self.is_outer(n) { (right, left) } else { (left, right) };
        for h in 0..self.half_edges.len() {
            if self.half_edges[h].as_ref().is_some_and(|record| record.face == dropped) {
                self.get_mut(h).face = kept;
            }
        }
        for v in self.vertices.iter_mut().flatten().filter(|v| v.face == dropped) {
            v.face = kept;
        }
        self.detach(n);
        self.detach(t);
        if left != right {
            // Two faces side by side: what was around both bounds what is kept.
            if before.is_outer(n) && before.is_outer(t) {
                self.faces[kept] = Some(Face { outer: rest.into_iter().next() });
            }
            self.faces[dropped] = None;
        } else if before.is_outer(n) {
            // Topology decides: the part that has the component's outside stays.
            let has_outside = |h: &usize| {
                let (mut part, mut done) = (vec![*h], 0);
                while let Some(h) = part.get(done).copied() {
                    let others =
                        [h ^ 1, self.get(h).next].into_iter().filter(|h| !part.contains(h)).collect::<Vec<_>>();
                    part.extend(others);
                    done += 1;
                }
                part.into_iter().any(|h| !before.is_outer(h))
            };
            let outer = rest.into_iter().find(|h| self.has_bug || has_outside(h));
            self.faces[left] = Some(Face { outer });
        }
        (self.half_edges[n], self.half_edges[t]) = (None, None);
        Ok((left != right).then_some(dropped))
    }
}

fn main() {
    let expectation = Expectation::plane();

    let found = conformance::check(|| Mine::new(true), &expectation).expect_err("the bug is found");
    println!("{found}");
    println!("For a regression test:\n\n{}\n", found.program.to_rust());

    println!("Without the bug:\n");
    println!("{}", conformance::check(|| Mine::new(false), &expectation).expect("no program fails"));
}
