//! Validation, per half-edge: R1 … T4 of a triangulated grid of 1,000 × 1,000 vertices beside one plain pass over the same
//! links, of the same links as a structure of somebody else's with and without parts, border and fault, each beside a scan by index
//! that reads the same parts, and R1 … G5 of `world-50m`.
//!
//! Targets: 15 ns per half-edge for R1 … T4; 150 ns with G1 … G5. Run with `cargo bench -p twinedge-benches --bench validation`.

mod common;

use common::{PlainArrays, triangulated_grid};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use twinedge::validate::reference::rule_by_rule;
use twinedge::validate::{Collect, Expectation, Link, Only, Part, Parts, View, validate};
use twinedge::{delegate_view, view_answers};

/// The least that any check must do: follow each link once.
fn one_pass(plain: &PlainArrays) -> usize {
    let links = plain.origin.iter().zip(&plain.twin).zip(&plain.next);
    links
        .filter(|((_, twin), next)| {
            **twin != u32::MAX && plain.origin[**twin as usize] == plain.origin[**next as usize]
        })
        .count()
}

/// The same links as meshes keep them: half-edges that name their face, with a border where the unbounded face was, or without.
struct Mesh {
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
    fn of(plain: &PlainArrays) -> Self {
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

    /// The same without the longest of the faces, which are triangles but for that one: a border is left.
    fn open(mut self) -> Self {
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
    fn scan(&self, parts: Parts) -> usize {
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

/// A structure with one wrong link: the twin, or the next, of one half-edge is the first half-edge. If there is no such half-edge,
/// nothing is wrong.
struct Wrong<'a, V> {
    right: &'a V,
    twin: bool,
    at: usize,
}

impl<V: View> View for Wrong<'_, V> {
    delegate_view!(|this| this.right; except twin, next);

    fn twin(&self, h: usize) -> Link {
        if self.twin && h == self.at { Some(1) } else { self.right.twin(h) }
    }
    fn next(&self, h: usize) -> Link {
        if !self.twin && h == self.at { Some(1) } else { self.right.next(h) }
    }
}

/// Structures with the same links that lack parts, or have a border.
fn foreign(criterion: &mut Criterion) {
    let map = triangulated_grid(1000);
    let plain = PlainArrays::of(map.dcel());
    let (plane, surface) = (Expectation::plane(), Expectation::surface());
    let mut group = criterion.benchmark_group("validate a foreign grid");
    group.throughput(Throughput::Elements(map.dcel().half_edge_count() as u64));
    for (border, mesh) in [("closed", Mesh::of(&plain)), ("open", Mesh::of(&plain).open())] {
        for (name, parts, expectation) in [
            ("no faces, prev, leaving", Parts::NONE, plane),
            ("no faces", mesh.parts().without(Part::Faces), plane),
            ("faces, no prev, leaving", Parts::NONE.with(Part::Faces), surface),
            ("faces", mesh.parts(), surface),
        ] {
            let expectation = if border == "open" { expectation.open() } else { expectation };
            group.bench_function(format!("scan, {border}, {name}"), |b| b.iter(|| black_box(&mesh).scan(parts)));
            let view = Only::new(&mesh, parts);
            group.bench_function(format!("R1 … T4, {border}, {name}"), |b| {
                b.iter(|| assert!(validate(black_box(&view), &expectation, Collect::All).is_valid()));
            });
        }
    }
    group.finish();
}

/// One wrong link.
fn faulty(criterion: &mut Criterion) {
    let map = triangulated_grid(1000);
    let plane = Expectation::plane();
    let mut group = criterion.benchmark_group("validate a grid with one fault");
    group.throughput(Throughput::Elements(map.dcel().half_edge_count() as u64));
    let middle = map.dcel().half_edges().map(|h| h.index()).max().unwrap_or_default() / 2;
    // The same view without the fault: it, too, asks at each link whether this is the wrong one.
    let right = Wrong { right: map.dcel(), twin: true, at: usize::MAX };
    group.bench_function("none", |b| {
        b.iter(|| assert!(validate(black_box(&right), &plane, Collect::All).is_valid()));
    });
    for (what, twin) in [("twin", true), ("next", false)] {
        let view = Wrong { right: map.dcel(), twin, at: middle };
        for (how_many, collect) in [("all", Collect::All), ("the first", Collect::First)] {
            group.bench_function(format!("{what}, {how_many}"), |b| {
                b.iter(|| assert!(!validate(black_box(&view), &plane, collect).is_valid()));
            });
        }
        group.bench_function(format!("{what}, rule by rule"), |b| {
            b.iter(|| assert!(!rule_by_rule(black_box(&view), &plane, Collect::All).is_valid()));
        });
    }
    group.finish();
}

fn validation(criterion: &mut Criterion) {
    let map = triangulated_grid(1000);
    let plain = PlainArrays::of(map.dcel());
    let mut group = criterion.benchmark_group("validate a grid");
    group.throughput(Throughput::Elements(map.dcel().half_edge_count() as u64));
    group.bench_function("L3 alone on plain u32 arrays", |b| b.iter(|| one_pass(black_box(&plain))));
    group.bench_function("R1 … T4", |b| {
        b.iter(|| {
            let report = validate(black_box(map.dcel()), &Expectation::plane(), Collect::All);
            assert!(report.is_valid());
        });
    });
    group.finish();

    let map = common::world_50m();
    let mut group = criterion.benchmark_group("validate world-50m");
    group.throughput(Throughput::Elements(map.dcel().half_edge_count() as u64));
    group.bench_function("R1 … T4", |b| b.iter(|| assert!(black_box(map.dcel()).validate().is_valid())));
    group.bench_function("R1 … G5", |b| b.iter(|| assert!(black_box(&map).validate().is_valid())));
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = validation, foreign, faulty
}
criterion_main!(benches);
