//! A second, independent implementation: a rotation system, simple and slow.

mod operators;

use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::Corner;
use twinedge::program::{Refusal, Subject};
use twinedge::validate::{Link, Part, Parts, Start, View};

/// A vertex.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Vertex {
    /// The half-edges that leave it, counter-clockwise.
    leaving: Vec<usize>,
    /// The face in which it lies, if it is isolated.
    face: usize,
}

/// A half-edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct HalfEdge {
    origin: usize,
    face: usize,
}

/// A planar subdivision as a rotation system: each vertex lists its half-edges counter-clockwise, each half-edge names
/// its face, each bounded face a half-edge of its outer cycle. All else is searched for where it is needed.
///
/// It has nothing in common with [`Dcel`](twinedge::dcel::Dcel) but the meaning of the operators: `next` is not stored, no
/// boundary component has a record, and handles are numbers that are never used again. Which of two vertices or faces is
/// kept is not decided by cost. Every operator is O(n) or worse.
#[derive(Clone, Debug)]
pub struct RotationSystem {
    vertices: BTreeMap<usize, Vertex>,
    /// The twin of `h` is `h ^ 1`.
    half_edges: BTreeMap<usize, HalfEdge>,
    /// Each with a half-edge of its outer cycle.
    faces: BTreeMap<usize, Option<usize>>,
    made_vertices: usize,
    made_half_edges: usize,
    made_faces: usize,
}

const UNBOUNDED: usize = 0;

type ModelCorner = Corner<usize, usize>;

impl Default for RotationSystem {
    fn default() -> Self {
        Self::new()
    }
}

impl RotationSystem {
    /// The empty map.
    #[must_use]
    pub fn new() -> Self {
        Self {
            vertices: BTreeMap::new(),
            half_edges: BTreeMap::new(),
            faces: BTreeMap::from([(UNBOUNDED, None)]),
            made_vertices: 0,
            made_half_edges: 0,
            made_faces: 1,
        }
    }

    fn half_edge(&self, h: usize) -> Result<HalfEdge, Refusal> {
        self.half_edges.get(&h).copied().ok_or(Refusal::Stale)
    }

    fn vertex(&mut self, v: usize) -> &mut Vertex {
        self.vertices.entry(v).or_insert(Vertex { leaving: Vec::new(), face: UNBOUNDED })
    }

    fn origin(&self, h: usize) -> usize {
        self.half_edges[&h].origin
    }

    /// The half-edge so many places counter-clockwise of `h`.
    fn turned(&self, h: usize, places: usize) -> usize {
        let leaving = &self.vertices[&self.origin(h)].leaving;
        let position = leaving.iter().position(|other| *other == h).unwrap_or_default();
        leaving[(position + places) % leaving.len()]
    }

    fn next(&self, h: usize) -> usize {
        let degree = self.vertices[&self.origin(h ^ 1)].leaving.len();
        self.turned(h ^ 1, degree - 1)
    }

    fn prev(&self, h: usize) -> usize {
        self.turned(h, 1) ^ 1
    }

    fn cycle(&self, h: usize) -> Vec<usize> {
        let mut cycle = vec![h];
        let mut at = self.next(h);
        while at != h {
            cycle.push(at);
            at = self.next(at);
        }
        cycle
    }

    fn component(&self, h: usize) -> BTreeSet<usize> {
        let mut component = BTreeSet::new();
        let mut rest = vec![h];
        while let Some(h) = rest.pop() {
            if component.insert(h) {
                rest.extend([h ^ 1, self.next(h)]);
            }
        }
        component
    }

    /// Tells whether the cycle of `h` is the outer one of its face.
    fn is_outer(&self, h: usize) -> bool {
        self.faces[&self.half_edges[&h].face].is_some_and(|outer| self.cycle(h).contains(&outer))
    }

    /// The half-edges or the vertex of the boundary component on which a corner lies.
    fn boundary(&self, corner: ModelCorner) -> Vec<ModelCorner> {
        match corner {
            Corner::At(h) => self.cycle(h).into_iter().map(Corner::At).collect(),
            Corner::Isolated(_) => vec![corner],
        }
    }

    fn vertex_of(&self, corner: ModelCorner) -> Result<usize, Refusal> {
        self.face_of(corner)?;
        match corner {
            Corner::At(h) => self.origin_of(h),
            Corner::Isolated(v) => Ok(v),
        }
    }

    /// The starts of the inner boundary components of a face.
    fn inner_starts(&self, face: usize) -> Vec<Start> {
        let mut starts = Vec::new();
        let mut seen: BTreeSet<usize> = self.faces[&face].into_iter().flat_map(|outer| self.cycle(outer)).collect();
        for (h, record) in &self.half_edges {
            if record.face == face && !seen.contains(h) {
                seen.extend(self.cycle(*h));
                starts.push(Start::HalfEdge(*h));
            }
        }
        let isolated = self.vertices.iter().filter(|(_, v)| v.leaving.is_empty() && v.face == face);
        starts.extend(isolated.map(|(v, _)| Start::Vertex(*v)));
        starts
    }

    fn set_face(&mut self, corners: &[ModelCorner], face: usize) {
        for corner in corners {
            match corner {
                Corner::At(h) => {
                    self.half_edges.entry(*h).and_modify(|record| record.face = face);
                }
                Corner::Isolated(v) => self.vertex(*v).face = face,
            }
        }
    }

    /// Makes an edge that nothing leads to yet.
    fn make_edge(&mut self, origin: HalfEdge, target: HalfEdge) -> usize {
        let h = self.made_half_edges;
        self.made_half_edges += 2;
        self.half_edges.extend([(h, origin), (h + 1, target)]);
        h
    }

    fn make_vertex(&mut self, leaving: Vec<usize>, face: usize) -> usize {
        let v = self.made_vertices;
        self.made_vertices += 1;
        for h in &leaving {
            self.half_edges.entry(*h).and_modify(|record| record.origin = v);
        }
        self.vertices.insert(v, Vertex { leaving, face });
        v
    }

    /// Lists `h` next counter-clockwise of the half-edge of a corner, at its vertex.
    fn attach(&mut self, h: usize, v: usize, corner: ModelCorner) {
        let leaving = &mut self.vertex(v).leaving;
        let position = match corner {
            Corner::At(other) => {
                leaving.iter().position(|leaving| *leaving == other).map_or(0, |position| position + 1)
            }
            Corner::Isolated(_) => 0,
        };
        leaving.insert(position, h);
        self.half_edges.entry(h).and_modify(|record| record.origin = v);
    }

    fn detach(&mut self, h: usize) {
        let v = self.origin(h);
        self.vertex(v).leaving.retain(|other| *other != h);
    }

    fn remove_half_edges(&mut self, gone: [usize; 2]) {
        for h in gone {
            self.half_edges.remove(&h);
        }
    }

    /// Makes faces name another half-edge of their outer cycle than these two, which are about to go.
    fn spare(&mut self, gone: [usize; 2]) {
        for h in gone {
            let face = self.half_edges[&h].face;
            if self.faces[&face] == Some(h) {
                let other = self.cycle(h).into_iter().find(|other| !gone.contains(other));
                self.faces.insert(face, other);
            }
        }
    }

    /// Makes the faces on both sides one, and gives the one that was removed.
    fn merge(&mut self, n: usize, t: usize) -> usize {
        let (left, right) = (self.half_edges[&n].face, self.half_edges[&t].face);
        let (kept, dropped) = if self.is_outer(n) { (right, left) } else { (left, right) };
        if self.is_outer(n) && self.is_outer(t) {
            let other = self.cycle(n).into_iter().chain(self.cycle(t)).find(|h| ![n, t].contains(h));
            self.faces.insert(kept, other);
        }
        for h in self.half_edges.values_mut().filter(|h| h.face == dropped) {
            h.face = kept;
        }
        for v in self.vertices.values_mut().filter(|v| v.face == dropped) {
            v.face = kept;
        }
        self.faces.remove(&dropped);
        dropped
    }

    /// The half-edge that the face names if the bridge `n`, on its outer cycle, is removed: one of the part that the
    /// outside of the component belongs to.
    fn outer_after_parting(&self, n: usize, without: &Self) -> Option<usize> {
        let of_part = |h: usize| -> Option<usize> {
            let part = without.component(h);
            part.iter().any(|h| !self.is_outer(*h)).then_some(h)
        };
        let ends = [self.next(n ^ 1), self.next(n)];
        ends.into_iter().filter(|h| h >> 1 != n >> 1).find_map(of_part)
    }

    /// Tells whether a face is of the component of `h` or inside it.
    fn lies_inside(&self, face: usize, h: usize) -> bool {
        let component = self.component(h);
        let mut at = face;
        while let Some(outer) = self.faces[&at] {
            if component.contains(&outer) {
                return true;
            }
            let around = self.component(outer).into_iter().find(|h| !self.is_outer(*h));
            at = around.map_or(UNBOUNDED, |h| self.half_edges[&h].face);
        }
        false
    }

    /// Takes the edge off and puts it back where it goes, given the corners at which its half-edges go in; the second
    /// first.
    fn reattach(&mut self, n: usize, corners: impl FnOnce(&Self) -> [(usize, usize); 2]) {
        let (left, right) = (self.half_edges[&n].face, self.half_edges[&(n ^ 1)].face);
        let (left_outer, right_outer) = (self.is_outer(n), self.is_outer(n ^ 1));
        self.detach(n);
        self.detach(n ^ 1);
        for (h, corner) in corners(self) {
            let v = self.origin(corner);
            self.attach(h, v, Corner::At(corner));
        }
        for (h, face, outer) in [(n, left, left_outer), (n ^ 1, right, right_outer)] {
            let cycle = self.boundary(Corner::At(h));
            self.set_face(&cycle, face);
            if outer {
                self.faces.insert(face, Some(h));
            }
        }
    }
}

impl View for RotationSystem {
    fn parts(&self) -> Parts {
        Parts::ALL.without(Part::BoundaryComponents)
    }
    fn vertex_slots(&self) -> usize {
        self.made_vertices
    }
    fn half_edge_slots(&self) -> usize {
        self.made_half_edges
    }
    fn face_slots(&self) -> usize {
        self.made_faces
    }
    fn is_vertex(&self, vertex: usize) -> bool {
        self.vertices.contains_key(&vertex)
    }
    fn is_half_edge(&self, half_edge: usize) -> bool {
        self.half_edges.contains_key(&half_edge)
    }
    fn is_face(&self, face: usize) -> bool {
        self.faces.contains_key(&face)
    }
    fn origin(&self, half_edge: usize) -> Link {
        self.half_edges.get(&half_edge).map(|h| h.origin)
    }
    fn twin(&self, half_edge: usize) -> Link {
        Some(half_edge ^ 1)
    }
    fn next(&self, half_edge: usize) -> Link {
        self.half_edges.contains_key(&half_edge).then(|| self.next(half_edge))
    }
    fn prev(&self, half_edge: usize) -> Link {
        self.half_edges.contains_key(&half_edge).then(|| self.prev(half_edge))
    }
    fn face(&self, half_edge: usize) -> Link {
        self.half_edges.get(&half_edge).map(|h| h.face)
    }
    fn leaving(&self, vertex: usize) -> Link {
        self.vertices.get(&vertex)?.leaving.first().copied()
    }
    fn outer_half_edge(&self, face: usize) -> Link {
        self.faces.get(&face).copied().flatten()
    }
    fn inner_count(&self, face: usize) -> usize {
        if self.faces.contains_key(&face) { self.inner_starts(face).len() } else { 0 }
    }
    fn inner_start(&self, face: usize, position: usize) -> Option<Start> {
        self.faces.contains_key(&face).then(|| self.inner_starts(face).get(position).copied())?
    }
}
