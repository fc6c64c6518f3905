//! A torus of a million triangles: reading it in every format, joining it, and the whole audit.
//!
//! Joining must take at most three times as long as reading.

use criterion::{Criterion, criterion_group, criterion_main};
use std::fmt::Write as _;
use std::hint::black_box;
use twinedge::validate::Collect;
use twinedge_meshes::{Format, HalfEdgeMesh, IndexedMesh, audit, read_bytes};

/// Quadrilaterals around the torus, one way and the other: 1,000,000 triangles.
const AROUND: u32 = 1000;
const ALONG: u32 = 500;

fn torus() -> IndexedMesh {
    let angle = |i: u32, n: u32| f64::from(i) / f64::from(n) * std::f64::consts::TAU;
    let mut points = Vec::new();
    let mut faces = Vec::new();
    for i in 0..AROUND {
        for j in 0..ALONG {
            let (a, b) = (angle(i, AROUND), angle(j, ALONG));
            let from_axis = 3.0 + b.cos();
            points.push([from_axis * a.cos(), from_axis * a.sin(), b.sin()].map(|x| f64::from(x as f32)));
            let at = |i: u32, j: u32| (i % AROUND) * ALONG + j % ALONG;
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    IndexedMesh::from_faces(points, faces).expect("the indices are in range")
}

fn text(mesh: &IndexedMesh, header: &str, point: &str, face: &str, first: u32) -> Vec<u8> {
    let mut out = header.to_owned();
    for [x, y, z] in mesh.points() {
        let _ = writeln!(out, "{point}{x:.7} {y:.7} {z:.7}");
    }
    for corners in mesh.faces() {
        let _ = writeln!(out, "{face}{} {} {}", corners[0] + first, corners[1] + first, corners[2] + first);
    }
    out.into_bytes()
}

fn ply_header(mesh: &IndexedMesh, encoding: &str) -> String {
    let (points, faces) = (mesh.points().len(), mesh.face_count());
    format!(
        "ply\nformat {encoding} 1.0\nelement vertex {points}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {faces}\nproperty list uchar int vertex_indices\nend_header\n"
    )
}

fn binary_ply(mesh: &IndexedMesh) -> Vec<u8> {
    let mut out = ply_header(mesh, "binary_little_endian").into_bytes();
    for point in mesh.points() {
        for x in point {
            out.extend((*x as f32).to_le_bytes());
        }
    }
    for face in mesh.faces() {
        out.push(3);
        for v in face {
            out.extend(v.to_le_bytes());
        }
    }
    out
}

fn binary_stl(mesh: &IndexedMesh) -> Vec<u8> {
    let mut out = vec![0; 80];
    out.extend((mesh.face_count() as u32).to_le_bytes());
    for face in mesh.faces() {
        out.extend([0; 12]);
        for x in face.iter().flat_map(|v| mesh.points()[*v as usize]) {
            out.extend((x as f32).to_le_bytes());
        }
        out.extend([0; 2]);
    }
    out
}

fn text_stl(mesh: &IndexedMesh) -> Vec<u8> {
    let mut out = "solid torus\n".to_owned();
    for face in mesh.faces() {
        out.push_str("  facet normal 0 0 0\n    outer loop\n");
        for [x, y, z] in face.iter().map(|v| mesh.points()[*v as usize]) {
            let _ = writeln!(out, "      vertex {x:.6e} {y:.6e} {z:.6e}");
        }
        out.push_str("    endloop\n  endfacet\n");
    }
    out.push_str("endsolid torus\n");
    out.into_bytes()
}

fn million(criterion: &mut Criterion) {
    let mesh = torus();
    let mut group = criterion.benchmark_group("a million triangles");
    group.sample_size(10);
    let off = format!("OFF\n{} {} 0\n", mesh.points().len(), mesh.face_count());
    for (name, format, bytes) in [
        ("read OBJ", Format::Obj, text(&mesh, "", "v ", "f ", 1)),
        ("read OFF", Format::Off, text(&mesh, &off, "", "3 ", 0)),
        ("read text PLY", Format::Ply, text(&mesh, &ply_header(&mesh, "ascii"), "", "3 ", 0)),
        ("read binary PLY", Format::Ply, binary_ply(&mesh)),
        ("read text STL", Format::Stl, text_stl(&mesh)),
        ("read binary STL", Format::Stl, binary_stl(&mesh)),
    ] {
        group.bench_function(name, |b| {
            b.iter(|| {
                let file = read_bytes(black_box(&bytes), Some(format)).expect("it is well-formed");
                assert_eq!(file.mesh.face_count(), mesh.face_count());
                file
            });
        });
    }
    group.bench_function("join", |b| {
        b.iter(|| {
            let (half_edges, findings) = HalfEdgeMesh::link(black_box(&mesh), Collect::All);
            assert_eq!(findings.total(), 0);
            half_edges
        });
    });
    group.bench_function("audit", |b| {
        let expectation = HalfEdgeMesh::expectation().closed().genus(1).components(1).triangles().no_unused_vertices();
        b.iter(|| {
            let audit = audit(black_box(&mesh), &expectation, Collect::All);
            assert!(audit.is_valid());
            audit
        });
    });
    group.finish();
}

criterion_group!(benches, million);
criterion_main!(benches);
