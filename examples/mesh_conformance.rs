//! A triangle mesh that can flip, split and collapse edges, tried against the definition of these operators:
//! `cargo run --example mesh_conformance`.
//!
//! The mesh stands for one of your own. What the test needs stands between the two lines: the view that is also audited, a
//! refusal for each error, a line for each operator, and what to begin with. That is 39 lines of code, imports included. The mesh has a
//! bug that is easily made: before it flips an edge, it does not look whether the two other vertices are adjacent already. Random
//! programs find it, and shrinking leaves the one flip.

use twinedge::program::{Refusal, Subject, conformance};
use twinedge::validate::{Expectation, Part, Parts, View};
use twinedge::{subject_by_index, view_answers};

/// A refusal: the mesh is unchanged.
#[derive(Debug)]
pub enum Refused {
    /// The edge was removed.
    NoSuchEdge,
    /// There is a triangle on one side only.
    OnTheBorder,
    /// Two vertices would be joined twice.
    NotSimple,
}

/// A triangle mesh. The twin of `h` is `h ^ 1`; half-edges on the border have no face. Slots are never used again.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// None if the half-edge was removed.
    origin: Vec<Option<usize>>,
    next: Vec<usize>,
    face: Vec<Option<usize>>,
    has_vertex: Vec<bool>,
    has_face: Vec<bool>,
    has_bug: bool,
}

impl Mesh {
    /// The mesh of these triangles, whose vertices are given counter-clockwise.
    #[must_use]
    pub fn new(vertices: usize, triangles: &[[usize; 3]], has_bug: bool) -> Self {
        let mut mesh = Self { has_vertex: vec![true; vertices], has_bug, ..Self::default() };
        let mut edges = std::collections::BTreeMap::new();
        for triangle in triangles {
            let f = mesh.make_face();
            let sides = [0, 1, 2].map(|i| {
                let (from, to) = (triangle[i], triangle[(i + 1) % 3]);
                *edges.entry((from, to)).or_insert_with(|| mesh.make_edge(from, to))
            });
            for (i, h) in sides.into_iter().enumerate() {
                edges.insert((triangle[(i + 1) % 3], triangle[i]), h ^ 1);
                mesh.face[h] = Some(f);
                mesh.next[h] = sides[(i + 1) % 3];
            }
        }
        // On the border: turn at the target until there is no face.
        for h in (0..mesh.next.len()).filter(|h| mesh.face[*h].is_none()).collect::<Vec<_>>() {
            let mut at = h ^ 1;
            while mesh.face[at].is_some() {
                at = mesh.next[mesh.next[at]] ^ 1;
            }
            mesh.next[h] = at;
        }
        mesh
    }

    fn make_face(&mut self) -> usize {
        self.has_face.push(true);
        self.has_face.len() - 1
    }

    fn make_edge(&mut self, from: usize, to: usize) -> usize {
        self.origin.extend([Some(from), Some(to)]);
        self.face.extend([None, None]);
        self.next.extend([0, 0]);
        self.next.len() - 2
    }

    fn drop_edge(&mut self, h: usize) {
        for side in [h, h ^ 1] {
            (self.origin[side], self.face[side]) = (None, None);
        }
    }

    fn live(&self, h: usize) -> Result<usize, Refused> {
        self.origin.get(h).copied().flatten().ok_or(Refused::NoSuchEdge)
    }

    fn link(&mut self, cycle: &[usize]) {
        for (i, h) in cycle.iter().enumerate() {
            self.next[*h] = cycle[(i + 1) % cycle.len()];
            self.face[*h] = self.face[cycle[0]];
        }
    }

    fn prev(&self, h: usize) -> usize {
        let is_before = |other: &usize| self.origin[*other].is_some() && self.next[*other] == h;
        (0..self.next.len()).find(is_before).expect("something comes before")
    }

    /// The vertex opposite in the triangle to the left, if there is one.
    fn opposite(&self, h: usize) -> Option<usize> {
        self.face[h].and_then(|_| self.origin[self.next[self.next[h]]])
    }

    fn neighbours(&self, v: usize) -> Vec<usize> {
        (0..self.next.len()).filter(|h| self.origin[*h] == Some(v)).filter_map(|h| self.origin[h ^ 1]).collect()
    }

    fn is_on_border(&self, v: usize) -> bool {
        (0..self.next.len()).any(|h| self.origin[h] == Some(v) && self.face[h].is_none())
    }

    /// Turns an edge inside its two triangles.
    fn flip(&mut self, h: usize) -> Result<(), Refused> {
        self.live(h)?;
        let t = h ^ 1;
        let (Some(c), Some(d)) = (self.opposite(h), self.opposite(t)) else { return Err(Refused::OnTheBorder) };
        if !self.has_bug && (c == d || self.neighbours(c).contains(&d)) {
            return Err(Refused::NotSimple);
        }
        let ([bc, ad], [ca, db]) = ([self.next[h], self.next[t]], [h, t].map(|h| self.next[self.next[h]]));
        (self.origin[h], self.origin[t]) = (Some(d), Some(c));
        self.link(&[h, ca, ad]);
        self.link(&[t, db, bc]);
        Ok(())
    }

    /// Puts a vertex on an edge, and joins it with the vertices opposite.
    fn split(&mut self, h: usize) -> Result<(), Refused> {
        self.live(h)?;
        let t = h ^ 1;
        let (before, after) = (self.prev(t), self.next[h]);
        self.has_vertex.push(true);
        let v = self.has_vertex.len() - 1;
        let n = self.make_edge(v, self.live(t)?);
        self.origin[t] = Some(v);
        (self.face[n], self.face[n ^ 1]) = (self.face[h], self.face[t]);
        (self.next[h], self.next[n], self.next[before], self.next[n ^ 1]) = (n, after, n ^ 1, t);
        for (from, to) in [(h, n), (n ^ 1, t)] {
            if self.face[from].is_some() {
                let second = self.next[to];
                let third = self.next[second];
                let spoke = self.make_edge(v, self.live(third)?);
                let f = self.make_face();
                self.face[to] = Some(f);
                self.link(&[from, spoke, third]);
                self.link(&[to, second, spoke ^ 1]);
            }
        }
        Ok(())
    }

    /// Collapses an edge with its triangles.
    fn collapse(&mut self, h: usize) -> Result<(), Refused> {
        let (a, b) = (self.live(h)?, self.live(h ^ 1)?);
        let sides: Vec<usize> = [h, h ^ 1].into_iter().filter(|side| self.face[*side].is_some()).collect();
        let opposite: Vec<usize> = sides.iter().filter_map(|side| self.opposite(*side)).collect();
        let of_b = self.neighbours(b);
        let mut common = self.neighbours(a).into_iter().filter(|v| of_b.contains(v));
        // Both triangles beyond are one and the same, as in a tetrahedron, or both edges are on the border.
        let is_ear = |side: &usize| {
            let second = self.next[*side];
            self.opposite(second ^ 1) == self.opposite(self.next[second] ^ 1)
        };
        let pinches = sides.len() == 2 && self.is_on_border(a) && self.is_on_border(b);
        if pinches
            || (sides.len() == 2 && opposite[0] == opposite[1])
            || common.any(|v| !opposite.contains(&v))
            || sides.iter().any(is_ear)
        {
            return Err(Refused::NotSimple);
        }
        let border = [h, h ^ 1].map(|side| (self.face[side].is_none(), self.prev(side), self.next[side]));
        for origin in self.origin.iter_mut().filter(|origin| **origin == Some(b)) {
            *origin = Some(a);
        }
        for (_, before, after) in border.into_iter().filter(|(is_border, ..)| *is_border) {
            self.next[before] = after;
        }
        self.drop_edge(h);
        for side in sides {
            // The second side of the triangle takes the place of what is beyond the third.
            let second = self.next[side];
            let third = self.next[second];
            let (beyond, before) = (third ^ 1, self.prev(third ^ 1));
            // Its origin was b, or is a already; it ends at the vertex opposite, as `beyond` does.
            (self.next[before], self.next[second]) = (second, self.next[beyond]);
            if let Some(f) = self.face[second] {
                self.has_face[f] = false;
            }
            self.face[second] = self.face[beyond];
            self.drop_edge(third);
        }
        self.has_vertex[b] = false;
        Ok(())
    }
}

// ---- the adapter and the test -------------------------------------------------------------------------------------

impl View for Mesh {
    view_answers! { |mesh|
        parts => Parts::NONE.with(Part::Faces),
        vertex_slots => mesh.has_vertex.len(),
        half_edge_slots => mesh.origin.len(),
        face_slots => mesh.has_face.len(),
        is_vertex(v) => mesh.has_vertex[v],
        is_half_edge(h) => mesh.origin[h].is_some(),
        is_face(f) => mesh.has_face[f],
        origin(h) => mesh.origin[h],
        twin(h) => Some(h ^ 1),
        next(h) => Some(mesh.next[h]),
        face(h) => mesh.face[h],
        outer_half_edge(f) => mesh.face.iter().position(|face| *face == Some(f)),
    }
}

impl From<Refused> for Refusal {
    fn from(refused: Refused) -> Self {
        match refused {
            Refused::NoSuchEdge => Self::Stale,
            Refused::OnTheBorder => Self::Border,
            Refused::NotSimple => Self::NotSimple,
        }
    }
}

impl Subject for Mesh {
    subject_by_index! {
        MeshFlipEdge => Self::flip,
        MeshSplitEdge => Self::split,
        MeshCollapseEdge => Self::collapse,
    }
}

/// A surface with a border.
pub const MESH: Expectation = Expectation::surface().open();

fn main() {
    // A square pyramid without its base: the border is the square.
    let pyramid = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    let found = conformance::check(|| Mesh::new(5, &pyramid, true), &MESH).expect_err("the bug is found");
    // ---- to here --------------------------------------------------------------------------------------------------

    println!("With the bug, {found}");
    assert_eq!(found.program.0.last().map(|op| op.name()), Some("mesh_flip_edge"));
    let summary = conformance::check(|| Mesh::new(5, &pyramid, false), &MESH);
    println!("{}", summary.expect("the mesh does what the operators say"));
}
