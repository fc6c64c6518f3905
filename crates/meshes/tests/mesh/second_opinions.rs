//! Files read by other crates, for comparison.

use crate::support::shapes::{mesh, points};
use crate::support::soup::Soup;
use crate::support::write::{Kind as Written, write};
use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{DefaultElement, Property};
use quickcheck::{Gen, QuickCheck};
use std::io::Cursor;
use twinedge_meshes::{IndexedMesh, read_bytes};

fn places(mesh: &IndexedMesh) -> Vec<Vec<[f64; 3]>> {
    mesh.faces().map(|face| face.iter().map(|v| mesh.points()[*v as usize]).collect()).collect()
}

fn ours(bytes: &[u8], kind: Written) -> IndexedMesh {
    read_bytes(bytes, Some(kind.format())).expect("well-formed").mesh
}

fn check(tests: u64, property: fn(Soup)) {
    QuickCheck::new().tests(tests).rng(Gen::new(60)).quickcheck(property);
}

#[test]
fn obj_is_what_tobj_reads() {
    fn agrees(soup: Soup) {
        // This crate drops faces without vertices.
        let faces: Vec<_> = soup.faces.iter().filter(|face| !face.is_empty()).collect();
        let mesh = IndexedMesh::from_faces(points(soup.points), faces).expect("indices in range");
        let bytes = write(&mesh, Written::Obj);
        let (models, _) = tobj::load_obj_buf(&mut Cursor::new(&bytes), &tobj::LoadOptions::default(), |_| {
            Err(tobj::LoadError::GenericFailure)
        })
        .expect("well-formed");
        let mut theirs = Vec::new();
        for model in models {
            let mut indices = model.mesh.indices.iter();
            let mut arities = model.mesh.face_arities.clone();
            if arities.is_empty() {
                arities = vec![3; model.mesh.indices.len() / 3];
            }
            for arity in arities {
                let corner = |v: &u32| [0, 1, 2].map(|axis| model.mesh.positions[3 * *v as usize + axis]);
                theirs.push(indices.by_ref().take(arity as usize).map(corner).collect::<Vec<_>>());
            }
        }
        assert_eq!(places(&ours(&bytes, Written::Obj)), theirs);
    }
    check(300, agrees);
}

#[test]
fn ply_is_what_ply_rs_reads() {
    fn agrees(soup: Soup) {
        let mesh = soup.mesh();
        for kind in [Written::TextPly, Written::LittlePly, Written::BigPly] {
            let bytes = write(&mesh, kind);
            let ply = Parser::<DefaultElement>::new().read_ply(&mut Cursor::new(&bytes)).expect("well-formed");
            let ours = ours(&bytes, kind);
            let number = |property: &Property| match property {
                Property::Double(number) => *number,
                other => panic!("not a double: {other:?}"),
            };
            let theirs: Vec<_> =
                ply.payload["vertex"].iter().map(|point| ["x", "y", "z"].map(|axis| number(&point[axis]))).collect();
            assert_eq!(ours.points(), theirs);
            let theirs = ply.payload["face"].iter().map(|face| match &face["vertex_indices"] {
                Property::ListInt(list) => list.iter().map(|v| v.cast_unsigned()).collect::<Vec<_>>(),
                other => panic!("not a list: {other:?}"),
            });
            assert_eq!(ours.faces().map(<[u32]>::to_vec).collect::<Vec<_>>(), theirs.collect::<Vec<_>>());
        }
    }
    check(200, agrees);
}

#[test]
fn stl_is_what_stl_io_reads() {
    fn agrees(soup: Soup) {
        let triangles: Vec<_> = soup.faces.into_iter().filter(|face| face.len() == 3).collect();
        let mesh = mesh(soup.points, triangles);
        for kind in [Written::TextStl, Written::BinaryStl] {
            let mut bytes = write(&mesh, kind);
            if kind == Written::BinaryStl {
                // This crate takes a header with `solid` for text.
                bytes[0] = b'b';
            }
            let stl = stl_io::read_stl(&mut Cursor::new(&bytes)).expect("well-formed");
            let ours = ours(&bytes, kind);
            let theirs: Vec<[f64; 3]> = stl.vertices.iter().map(|vertex| vertex.0.map(f64::from)).collect();
            assert_eq!(ours.points(), theirs);
            let theirs: Vec<_> = stl.faces.iter().map(|face| face.vertices.map(|v| v as u32).to_vec()).collect();
            assert_eq!(ours.faces().map(<[u32]>::to_vec).collect::<Vec<_>>(), theirs);
        }
    }
    check(300, agrees);
}

#[test]
fn stl_that_stl_io_writes_is_read() {
    let corner = |x, y, z| stl_io::Vertex::new([x, y, z]);
    let corners = [corner(0.0, 0.0, 0.0), corner(1.5, 0.0, 0.0), corner(0.0, 2.5, 0.0)];
    let triangle = stl_io::Triangle { normal: stl_io::Normal::new([0.0, 0.0, 1.0]), vertices: corners };
    let mut bytes = Vec::new();
    stl_io::write_stl(&mut bytes, [&triangle, &triangle].into_iter()).expect("memory takes it");
    let mesh = ours(&bytes, Written::BinaryStl);
    assert_eq!(mesh.points(), [[0.0, 0.0, 0.0], [1.5, 0.0, 0.0], [0.0, 2.5, 0.0]]);
    assert_eq!(mesh.corners(), [0, 1, 2, 0, 1, 2]);
}
