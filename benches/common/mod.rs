//! Workloads that the benchmarks share.

#![allow(dead_code, unreachable_pub, reason = "each benchmark uses its part")]

use twinedge::dcel::{Dcel, Face, HalfEdge, Vertex};
use twinedge::validate::{Link, Part, Parts, View};
use twinedge::view_answers;
use twinedge_layers::{ReadOptions, read_for_map};
use twinedge_map::{Builder, Feature, PlanarMap};

/// A grid of `side` × `side` vertices, each square cut in two triangles.
pub fn triangulated_grid(side: u32) -> PlanarMap {
    let at = |x: u32, y: u32| [f64::from(x), f64::from(y)];
    let mut builder = Builder::new();
    let mut add = |from, to| {
        builder.segment(from, to).expect("small integers are in range");
    };
    for y in 0..side {
        for x in 0..side {
            if x + 1 < side {
                add(at(x, y), at(x + 1, y));
            }
            if y + 1 < side {
                add(at(x, y), at(x, y + 1));
            }
            if x + 1 < side && y + 1 < side {
                add(at(x, y), at(x + 1, y + 1));
            }
        }
    }
    builder.build().expect("a grid fits")
}

/// The links of a `Dcel` as plain arrays of `u32`, with the same numbering: a structure without keys.
pub struct PlainArrays {
    pub origin: Vec<u32>,
    pub twin: Vec<u32>,
    pub next: Vec<u32>,
    /// Per vertex a half-edge that leaves it, `u32::MAX` where there is no vertex.
    pub leaving: Vec<u32>,
    /// Per face a half-edge of its outer cycle, `u32::MAX` where there is none.
    pub outer: Vec<u32>,
}

impl PlainArrays {
    pub fn of(dcel: &Dcel) -> Self {
        let end = |last: Option<usize>| last.map_or(0, |last| last + 1);
        let half_edges = end(dcel.half_edges().map(HalfEdge::index).max());
        let mut plain = Self {
            origin: vec![u32::MAX; half_edges],
            twin: vec![u32::MAX; half_edges],
            next: vec![u32::MAX; half_edges],
            leaving: vec![u32::MAX; end(dcel.vertices().map(Vertex::index).max())],
            outer: vec![u32::MAX; end(dcel.faces().map(Face::index).max())],
        };
        for h in dcel.half_edges() {
            plain.origin[h.index()] = h.origin().index() as u32;
            plain.twin[h.index()] = h.twin().index() as u32;
            plain.next[h.index()] = h.next().index() as u32;
        }
        for v in dcel.vertices() {
            plain.leaving[v.index()] = v.leaving().map_or(u32::MAX, |h| h.index() as u32);
        }
        for f in dcel.faces() {
            plain.outer[f.index()] = f.outer_half_edge().map_or(u32::MAX, |h| h.index() as u32);
        }
        plain
    }

    /// The least that any check must do: follow each link once.
    pub fn one_pass(&self) -> usize {
        let links = self.origin.iter().zip(&self.twin).zip(&self.next);
        links
            .filter(|((_, twin), next)| {
                **twin != u32::MAX && self.origin[**twin as usize] == self.origin[**next as usize]
            })
            .count()
    }
}

/// The links of a `Dcel` in the form of meshes: half-edges that name their face, with a border in place of the
/// unbounded face, or without.
pub struct Mesh {
    origin: Vec<u32>,
    twin: Vec<u32>,
    next: Vec<u32>,
    prev: Vec<u32>,
    face: Vec<u32>,
    leaving: Vec<u32>,
    outer: Vec<u32>,
}

impl View for Mesh {
    view_answers! { |mesh|
        parts => Parts::NONE.with(Part::Prev).with(Part::Leaving).with(Part::Faces),
        vertex_slots => mesh.leaving.len(),
        half_edge_slots => mesh.next.len(),
        face_slots => mesh.outer.len(),
        is_vertex(v) => mesh.leaving[v] != u32::MAX,
        is_half_edge(h) => mesh.origin[h] != u32::MAX,
        is_face(f) => mesh.outer[f] != u32::MAX,
        origin(h) => link(mesh.origin[h]),
        twin(h) => link(mesh.twin[h]),
        next(h) => link(mesh.next[h]),
        prev(h) => link(mesh.prev[h]),
        face(h) => link(mesh.face[h]),
        leaving(v) => link(mesh.leaving[v]),
        outer_half_edge(f) => link(mesh.outer[f]),
    }
}

fn link(slot: u32) -> Link {
    (slot != u32::MAX).then_some(slot as usize)
}

impl Mesh {
    pub fn of(plain: &PlainArrays) -> Self {
        let vacant = || vec![u32::MAX; plain.next.len()];
        let mut mesh = Self {
            origin: plain.origin.clone(),
            twin: plain.twin.clone(),
            next: plain.next.clone(),
            prev: vacant(),
            face: vacant(),
            leaving: plain.leaving.clone(),
            outer: Vec::new(),
        };
        for start in (0..mesh.next.len()).filter(|h| plain.origin[*h] != u32::MAX) {
            let mut h = start;
            while mesh.prev[mesh.next[h] as usize] == u32::MAX {
                let next = mesh.next[h] as usize;
                mesh.prev[next] = h as u32;
                mesh.face[h] = mesh.outer.len() as u32;
                h = next;
            }
            if mesh.face[start] as usize == mesh.outer.len() {
                mesh.outer.push(start as u32);
            }
        }
        mesh
    }

    /// Leaves out the longest face, which is the only one that is no triangle: this leaves a border.
    pub fn open(mut self) -> Self {
        let mut sides = vec![0_u32; self.outer.len()];
        for face in self.face.iter().filter(|face| **face != u32::MAX) {
            sides[*face as usize] += 1;
        }
        let longest = (0..sides.len()).max_by_key(|f| sides[*f]).unwrap_or_default();
        self.outer[longest] = u32::MAX;
        for h in 0..self.next.len() {
            if self.face[h] == longest as u32 {
                let twin = self.twin[h] as usize;
                self.twin[twin] = u32::MAX;
                self.origin[h] = u32::MAX;
            }
        }
        for h in 0..self.next.len() {
            if let Some(vertex) = self.origin(h) {
                self.leaving[vertex] = h as u32;
            }
        }
        self
    }

    /// Reads each link by index.
    pub fn scan(&self, parts: Parts) -> usize {
        let (with_prev, with_faces) = (parts.has(Part::Prev), parts.has(Part::Faces));
        let holds = |h: &usize| {
            let Some(next) = self.next(*h) else { return false };
            self.twin(*h).is_none_or(|twin| self.twin(twin) == Some(*h) && self.origin(twin) == self.origin(next))
                && (!with_prev || self.prev(next) == Some(*h))
                && (!with_faces || self.face(next) == self.face(*h))
        };
        (0..self.half_edge_slots()).filter(holds).count()
    }
}

/// The features of `world-50m`.
pub fn world_50m_features() -> Vec<Feature> {
    let mut file: &[u8] = include_bytes!("../../tests/data/world-50m.geojson");
    read_for_map(&mut file, &ReadOptions::default()).expect("the file is GeoJSON").0
}

/// The map of `world-50m`.
pub fn world_50m() -> PlanarMap {
    let mut builder = Builder::new();
    for feature in world_50m_features() {
        builder.feature(&feature).expect("longitudes and latitudes are in range");
    }
    builder.build().expect("the world fits")
}
