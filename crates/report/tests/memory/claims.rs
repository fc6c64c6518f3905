//! The counts declared in a file cost no memory, and the content of a mesh costs little.

use crate::peak;
use twinedge::validate::Collect;
use twinedge_meshes::{Format, HalfEdgeMesh, IndexedMesh, read_bytes};

#[test]
fn claims_of_meshes_cost_nothing() {
    let xyz = "property float x\nproperty float y\nproperty float z\n";
    let list = "property list uint int vertex_indices\n";
    let ply = |encoding: &str, body: &[u8]| {
        let header = format!(
            "ply\nformat {encoding} 1.0\nelement vertex 18446744073709551615\n{xyz}element face 18446744073709551615\n{list}\
             end_header\n"
        );
        [header.as_bytes(), body].concat()
    };
    let long_face = |count: &[u8]| {
        let header =
            format!("ply\nformat binary_little_endian 1.0\nelement vertex 0\n{xyz}element face 1\n{list}end_header\n");
        [header.as_bytes(), count].concat()
    };
    let mut stl = vec![0; 80];
    stl.extend([0xff; 4]);
    let files: [(Format, Vec<u8>); 7] = [
        (Format::Off, b"OFF\n18446744073709551615 18446744073709551615 0\n0 0 0\n".to_vec()),
        (Format::Off, b"OFF\n1 1 0\n0 0 0\n18446744073709551615 0 0 0\n".to_vec()),
        (Format::Ply, ply("ascii", b"1 2 3\n")),
        (Format::Ply, ply("binary_little_endian", &[0; 12])),
        (Format::Ply, ply("binary_big_endian", &[0; 12])),
        (Format::Ply, long_face(&[0xff; 4])),
        (Format::Stl, stl),
    ];
    for (format, bytes) in files {
        let used = peak(|| assert!(read_bytes(&bytes, Some(format)).is_err()));
        assert!(used < 20_000, "{format}: {used} bytes for a file of {}", bytes.len());
    }
}

#[test]
fn joining_takes_memory_in_proportion() {
    let faces = |n: u32| (0..n).map(move |i| [i, i + 1, i + 2]);
    let used = |n: u32| {
        let mesh = IndexedMesh::from_faces(vec![[0.0; 3]; n as usize + 2], faces(n)).expect("indices in range");
        peak(|| assert_eq!(HalfEdgeMesh::link(&mesh, Collect::AtMost(0)).0.edge_count(), 2 * n as usize + 1))
    };
    let (small, large) = (used(10_000), used(100_000));
    assert!(large < 11 * small, "{small} bytes for 10,000 faces, {large} for 100,000");
}

#[test]
fn claims_of_streams_cost_nothing() {
    let header: &[u8] = b"PGCOPY\n\xff\r\n\0\0\0\0\0";
    let begun = [header, &[0; 4]].concat();
    let long: &[u8] = &[0x7f, 0xff, 0xff, 0xff];
    let node: &[u8] = &[0, 3, 0, 0, 0, 4, 0, 0, 0, 1, 0xff, 0xff, 0xff, 0xff];
    let empty_table: &[u8] = &[0xff, 0xff];
    for bytes in [
        // An extension of the header, a geometry, a line and a polygon with a count of 2³¹ bytes, points or rings.
        [header, &[0xff; 4]].concat(),
        [&begun, node, long, &[1, 1]].concat(),
        [&begun, node, &[0, 0, 0, 9], &[1, 2, 0, 0, 0, 0xff, 0xff, 0xff, 0x7f]].concat(),
        [&begun, empty_table, &begun, &[0, 2, 0, 0, 0, 4, 0, 0, 0, 1], &[0, 0, 0, 9], &[1, 3, 0, 0, 0], &[0xff; 4]]
            .concat(),
    ] {
        let used = peak(|| assert!(twinedge_postgis::read(&*bytes, 100).is_err()));
        assert!(used < 20_000, "{used} bytes for a stream of {}", bytes.len());
    }
}
