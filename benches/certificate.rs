//! Certificates against validation: a triangulated grid of 1,000 × 1,000 vertices and 6 million half-edges, as a mesh
//! whose half-edges name their faces and as a plane subdivision, and the drawing of a map against the triangulation of
//! the same edges by `spade`.
//!
//! Targets: a check takes at most 5 times the floor, L3 alone on plain arrays, and at most 2.6 times on two threads.
//! Labels and the verdict take at most 1.6 times as long as validation. Labels take at most 12 bytes for each
//! half-edge. A drawing takes at most 1.5 times the triangulation, and its check at most 60 ns for each edge. The map
//! is `world-50m`, or the GeoJSON file named by the environment variable `MAP`.
//!
//! Run with `cargo bench -p twinedge-benches --bench certificate`.

mod common;

use common::{Mesh, PlainArrays, triangulated_grid};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _};
use std::hint::black_box;
use twinedge::validate::{Collect, Expectation, validate};
use twinedge_certificate::{Column, Labels, check, check_drawing, check_surface};
use twinedge_geometry::noding::Snap;
use twinedge_map::{Builder, Noding, PlanarMap, certificate};

fn grid(criterion: &mut Criterion) {
    let map = triangulated_grid(1000);
    let dcel = map.dcel();
    let half_edges = dcel.half_edge_count();
    let plain = PlainArrays::of(dcel);
    let mesh = Mesh::of(&plain);
    let mut group = criterion.benchmark_group("certify a grid");
    group.throughput(Throughput::Elements(half_edges as u64));
    group.bench_function("floor: L3 alone on plain u32 arrays", |b| b.iter(|| black_box(&plain).one_pass()));

    let surface = Expectation::surface().genus(0);
    let (labels, genus) = Labels::of_surface(&mesh).expect("there is memory");
    print_size("mesh", &labels, half_edges);
    group.bench_function("mesh: validate", |b| {
        b.iter(|| assert!(validate(black_box(&mesh), &surface, Collect::All).is_valid()));
    });
    group.bench_function("mesh: check", |b| {
        b.iter(|| assert_eq!(check_surface(black_box(&mesh), black_box(&labels), genus), Ok(())));
    });
    group.bench_function("mesh: labels", |b| b.iter(|| Labels::of_surface(black_box(&mesh))));
    group.bench_function("mesh: labels, and their check", |b| {
        b.iter(|| {
            let (labels, genus) = Labels::of_surface(black_box(&mesh)).expect("there is memory");
            assert_eq!(check_surface(&mesh, &labels, genus), Ok(()));
        });
    });

    let labels = Labels::new(dcel).expect("there is memory");
    print_size("plane", &labels, half_edges);
    group.bench_function("plane: validate", |b| {
        b.iter(|| assert!(validate(black_box(dcel), &Expectation::plane(), Collect::All).is_valid()));
    });
    group.bench_function("plane: check", |b| {
        b.iter(|| assert_eq!(check(black_box(dcel), black_box(&labels)), Ok(())));
    });
    group.bench_function("plane: labels", |b| b.iter(|| Labels::new(black_box(dcel))));
    group.finish();
}

fn print_size(what: &str, labels: &Labels, half_edges: usize) {
    let numbers: usize = Column::ALL.iter().map(|column| labels.column(*column).len()).sum();
    println!("{what}: {:.2} bytes of labels for each half-edge", (4 * numbers) as f64 / half_edges as f64);
}

fn drawing(criterion: &mut Criterion) {
    let map = drawn_map();
    let edges = map.dcel().half_edge_count() / 2;
    let mut group = criterion.benchmark_group("certify a drawing");
    group.throughput(Throughput::Elements(edges as u64));
    let vertices: Vec<_> = map.dcel().vertices().collect();
    let points: Vec<_> = vertices
        .iter()
        .map(|v| map.position(v.key()).expect("it is a vertex"))
        .map(|p| Point2::new(p.x, p.y))
        .collect();
    let mut number = vec![0; vertices.iter().map(|v| v.index() + 1).max().unwrap_or_default()];
    vertices.iter().enumerate().for_each(|(i, v)| number[v.index()] = i);
    let ends = map.dcel().half_edges().filter(|h| h.index() < h.twin().index());
    let ends: Vec<_> = ends.map(|h| [h, h.twin()].map(|h| number[h.origin().index()])).collect();
    group.bench_function("spade's triangulation", |b| {
        b.iter(|| {
            let cdt = ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(points.clone(), ends.clone());
            cdt.expect("coordinates are finite").num_vertices()
        });
    });
    group.bench_function("draw", |b| b.iter(|| certificate::draw(black_box(&map)).expect("it is on a grid")));
    let labels = Labels::new(&map).expect("there is memory");
    let drawing = certificate::draw(&map).expect("it is on a grid");
    group.bench_function("check", |b| {
        b.iter(|| assert_eq!(check_drawing(black_box(&map), &labels, black_box(&drawing)), Ok(())));
    });
    group.finish();
}

/// The map, snapped to a fine grid.
fn drawn_map() -> PlanarMap {
    let features = match std::env::var_os("MAP") {
        None => common::world_50m_features(),
        Some(path) => {
            let mut file = std::fs::File::open(path).expect("MAP is a file");
            twinedge_layers::read_for_map(&mut file, &twinedge_layers::ReadOptions::default())
                .expect("MAP is GeoJSON")
                .0
        }
    };
    let mut builder = Builder::new();
    for feature in &features {
        builder.feature(feature).expect("longitudes and latitudes are in range");
    }
    builder.build_with(Noding::Snap(Snap::Auto)).expect("the world fits")
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = grid, drawing
}
criterion_main!(benches);
