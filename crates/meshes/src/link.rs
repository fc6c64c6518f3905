//! From faces to half-edges.
//!
//! ```text
//!   faces       left out: degenerate, repeated
//!     │
//!     ▼
//!   sides       sorted by their smaller vertex, then by the other one: all sides of an edge are together
//!     │
//!     ▼
//!   edges       one side: border; two in opposite directions: twins; two in the same: flipped; more: not manifold
//!     │
//!     ▼
//!   vertices    no half-edge: unused; faces that no common edge connects: several fans
//! ```
//!
//! The sorting is by counting, with one array over the vertices, so that everything is linear.

use super::half_edges::{NIL, widest};
use super::{Finding, Findings, HalfEdgeMesh, IndexedMesh, Kind, repeated};
use petgraph::unionfind::UnionFind;
use twinedge::validate::Collect;

/// One side of an edge: a half-edge, and the larger vertex of the edge.
#[derive(Clone, Copy)]
struct Side {
    half_edge: u32,
    far: u32,
}

impl<'a> HalfEdgeMesh<'a> {
    /// Joins the faces of a mesh to half-edges and reports the parts that cannot be joined.
    ///
    /// Of faces that repeat each other, the first is kept. If two are back to back, their order therefore decides whether the
    /// remaining one fits its neighbours.
    ///
    /// `collect` limits the findings of each kind that are kept; all are counted. Time and memory are linear in points and
    /// corners (expected, since a hash table is used, and up to the inverse of Ackermann's function). It accepts every mesh.
    ///
    /// ```
    /// use twinedge::validate::{Collect, validate};
    /// use twinedge_meshes::{HalfEdgeMesh, IndexedMesh, Kind};
    ///
    /// // Two triangles at the edge between 1 and 2, both from 1 to 2.
    /// let mesh = IndexedMesh::from_faces(vec![[0.0; 3]; 4], [[0, 1, 2], [3, 1, 2]])?;
    /// let (half_edges, findings) = HalfEdgeMesh::link(&mesh, Collect::All);
    /// assert_eq!(findings.list()[0].kind(), Kind::FlippedFaces);
    /// assert_eq!(findings.list()[0].faces(), [0, 1]);
    /// assert_eq!(findings.list()[0].vertices(), [1, 2]);
    ///
    /// // The second one the other way round.
    /// let mesh = IndexedMesh::from_faces(vec![[0.0; 3]; 4], [[0, 1, 2], [3, 2, 1]])?;
    /// let (half_edges, findings) = HalfEdgeMesh::link(&mesh, Collect::All);
    /// assert_eq!(findings.total(), 0);
    /// assert!(validate(&half_edges, &HalfEdgeMesh::expectation(), Collect::All).is_valid());
    /// # Ok::<(), twinedge_meshes::IndexedMeshError>(())
    /// ```
    #[must_use]
    pub fn link(mesh: &'a IndexedMesh, collect: Collect) -> (Self, Findings) {
        let mut findings = Findings::new(collect);
        if mesh.face_count() == 0 {
            findings.add(Kind::NoFaces, || Finding::NoFaces);
        }
        let mut left_out = vec![false; mesh.face_count()];
        leave_out_degenerate(mesh, &mut left_out, &mut findings);
        repeated::leave_out(mesh, &mut left_out, &mut findings);

        let corners = mesh.corners().len();
        let mut this = Self {
            mesh,
            face_of: vec![NIL; corners],
            twins: vec![NIL; corners],
            leaving: vec![NIL; mesh.points().len()],
            left_out,
            edges: 0,
            border_edges: 0,
            orientable: true,
            axes: widest(mesh.points()),
        };
        let degrees = this.number_corners();
        let flipped = this.join(&mut findings);
        this.orientable = flipped.is_empty() || this.can_be_oriented(&flipped);
        this.check_vertices(&degrees, &mut findings);
        findings.sort();
        (this, findings)
    }

    /// Gives each corner its face and each vertex a half-edge; returns the number of half-edges that leave each vertex.
    fn number_corners(&mut self) -> Vec<u32> {
        let mut degrees = vec![0; self.leaving.len()];
        for (f, range) in self.mesh.offsets().windows(2).enumerate().filter(|(f, _)| !self.left_out[*f]) {
            for h in range[0]..range[1] {
                let v = self.mesh.corners()[h as usize] as usize;
                self.face_of[h as usize] = f as u32;
                degrees[v] += 1;
                if self.leaving[v] == NIL {
                    self.leaving[v] = h;
                }
            }
        }
        degrees
    }

    /// Returns all sides of all edges, sorted by the smaller vertex, and the end of the range of each vertex.
    fn sides(&self) -> (Vec<Side>, Vec<u32>) {
        let live = || (0..self.face_of.len() as u32).filter(|h| self.is_live(*h));
        let ends_of = |h: u32| {
            let (a, b) = (self.vertex_of(h), self.vertex_of(self.next_of(h)));
            (a.min(b) as usize, a.max(b))
        };
        let mut ends = vec![0_u32; self.leaving.len() + 1];
        for h in live() {
            ends[ends_of(h).0 + 1] += 1;
        }
        for v in 1..ends.len() {
            ends[v] += ends[v - 1];
        }
        let mut sides = vec![Side { half_edge: NIL, far: NIL }; ends.last().map_or(0, |end| *end as usize)];
        // As the sides are filled in, the start of each vertex becomes its end.
        for half_edge in live() {
            let (near, far) = ends_of(half_edge);
            sides[ends[near] as usize] = Side { half_edge, far };
            ends[near] += 1;
        }
        ends.pop();
        (sides, ends)
    }

    /// Joins the two sides of each edge that has two; returns the pairs of faces with the same direction along their edge.
    fn join(&mut self, findings: &mut Findings) -> Vec<[u32; 2]> {
        let (sides, ends) = self.sides();
        // The last visited side of the edge to each vertex. Each side stores the one before it in place of its future twin.
        let mut last = vec![NIL; self.leaving.len()];
        let mut flipped = Vec::new();
        let mut edge = Vec::new();
        let mut start = 0;
        for end in ends {
            let around = &sides[start..end as usize];
            start = end as usize;
            for side in around {
                self.twins[side.half_edge as usize] = last[side.far as usize];
                last[side.far as usize] = side.half_edge;
            }
            for side in around {
                let mut h = std::mem::replace(&mut last[side.far as usize], NIL);
                if h == NIL {
                    continue;
                }
                edge.clear();
                while h != NIL {
                    edge.push(h);
                    h = std::mem::replace(&mut self.twins[h as usize], NIL);
                }
                edge.reverse();
                self.join_edge(&edge, &mut flipped, findings);
            }
        }
        flipped
    }

    /// Handles all sides of one edge, in the order of their faces.
    fn join_edge(&mut self, sides: &[u32], flipped: &mut Vec<[u32; 2]>, findings: &mut Findings) {
        self.edges += 1;
        let face = |h: u32| self.face_of[h as usize];
        let ends = |h: u32| [self.vertex_of(h), self.vertex_of(self.next_of(h))].map(|v| v as usize);
        match *sides {
            [_] => self.border_edges += 1,
            [a, b] if self.vertex_of(a) != self.vertex_of(b) => {
                self.twins[a as usize] = b;
                self.twins[b as usize] = a;
            }
            [a, b] => {
                let faces = [face(a), face(b)];
                flipped.push(faces);
                findings.add(Kind::FlippedFaces, || Finding::FlippedFaces {
                    vertices: ends(a),
                    faces: faces.map(|f| f as usize),
                });
            }
            _ => findings.add(Kind::NonManifoldEdge, || {
                let mut vertices = ends(sides[0]);
                vertices.sort_unstable();
                Finding::NonManifoldEdge { vertices, faces: sides.iter().map(|h| face(*h) as usize).collect() }
            }),
        }
    }

    fn check_vertices(&self, degrees: &[u32], findings: &mut Findings) {
        let mut suspects = Vec::new();
        for (vertex, degree) in degrees.iter().enumerate() {
            if *degree == 0 {
                findings.add(Kind::UnusedVertex, || Finding::UnusedVertex { vertex });
            } else if self.reached(self.leaving[vertex]) < *degree {
                suspects.push(vertex as u32);
            }
        }
        self.check_fans(&suspects, findings);
    }

    /// Returns the number of half-edges that the rotation around the origin of `start` reaches through twins, both ways.
    fn reached(&self, start: u32) -> u32 {
        let mut reached = 1;
        let mut h = start;
        loop {
            let twin = self.twins[h as usize];
            if twin == NIL {
                break;
            }
            h = self.next_of(twin);
            if h == start {
                return reached;
            }
            reached += 1;
        }
        h = start;
        loop {
            h = self.twins[self.prev_of(h) as usize];
            if h == NIL {
                return reached;
            }
            reached += 1;
        }
    }

    /// Counts the fans at these vertices, which are in order. Faces are in one fan if a common edge connects them, joined or not.
    fn check_fans(&self, suspects: &[u32], findings: &mut Findings) {
        if suspects.is_empty() {
            return;
        }
        // The corners at each suspect.
        let mut rank = vec![NIL; self.leaving.len()];
        for (i, v) in suspects.iter().enumerate() {
            rank[*v as usize] = i as u32;
        }
        let mut corners = vec![Vec::new(); suspects.len()];
        for h in (0..self.face_of.len() as u32).filter(|h| self.is_live(*h)) {
            if let Some(corners) = corners.get_mut(rank[self.vertex_of(h) as usize] as usize) {
                corners.push(h);
            }
        }
        // From here on: the first corner with an edge to each vertex.
        let mut first_to = rank;
        first_to.fill(NIL);
        for (v, corners) in suspects.iter().zip(corners) {
            let mut fans = UnionFind::new(corners.len());
            let neighbours = |h: u32| [self.vertex_of(self.next_of(h)), self.vertex_of(self.prev_of(h))];
            for (i, h) in corners.iter().enumerate() {
                for to in neighbours(*h) {
                    let first = &mut first_to[to as usize];
                    if *first == NIL {
                        *first = i as u32;
                    } else {
                        fans.union(i as u32, *first);
                    }
                }
            }
            for h in &corners {
                for to in neighbours(*h) {
                    first_to[to as usize] = NIL;
                }
            }
            let mut seen = vec![false; corners.len()];
            let is_first = |i: &usize| !std::mem::replace(&mut seen[fans.find_mut(*i as u32) as usize], true);
            let firsts: Vec<_> = (0..corners.len()).filter(is_first).collect();
            if firsts.len() > 1 {
                findings.add(Kind::NonManifoldVertex, || {
                    let faces = firsts.iter().map(|i| self.face_of[corners[*i] as usize] as usize).collect();
                    Finding::NonManifoldVertex { vertex: *v as usize, faces }
                });
            }
        }
    }

    /// Returns true if the faces can be flipped so that the existing twins stay, and these pairs become twins as well.
    fn can_be_oriented(&self, flipped: &[[u32; 2]]) -> bool {
        // Each face twice: as it is, and flipped.
        let faces = self.left_out.len() as u32;
        let mut sets = UnionFind::new(2 * self.left_out.len());
        for (h, twin) in self.twins.iter().enumerate().filter(|(_, twin)| **twin != NIL) {
            let (a, b) = (self.face_of[h], self.face_of[*twin as usize]);
            sets.union(a, b);
            sets.union(a + faces, b + faces);
        }
        for [a, b] in flipped {
            sets.union(*a, b + faces);
            sets.union(a + faces, *b);
        }
        flipped.iter().all(|[a, _]| !sets.equiv(*a, a + faces))
    }
}

fn leave_out_degenerate(mesh: &IndexedMesh, left_out: &mut [bool], findings: &mut Findings) {
    // The last visited face that lists each vertex.
    let mut listed_by = vec![NIL; mesh.points().len()];
    for (face, vertices) in mesh.faces().enumerate() {
        let (mut distinct, mut again) = (0, None);
        for v in vertices {
            let last = std::mem::replace(&mut listed_by[*v as usize], face as u32);
            if last == face as u32 {
                again = again.or(Some(*v as usize));
            } else {
                distinct += 1;
            }
        }
        if distinct < 3 {
            left_out[face] = true;
            findings.add(Kind::DegenerateFace, || {
                let mut different = Vec::with_capacity(distinct);
                for v in vertices.iter().map(|v| *v as usize) {
                    if !different.contains(&v) {
                        different.push(v);
                    }
                }
                Finding::DegenerateFace { face, vertices: different }
            });
        } else if let Some(vertex) = again {
            left_out[face] = true;
            findings.add(Kind::RepeatedVertex, || Finding::RepeatedVertex { face, vertex });
        }
    }
}
