//! The content of each format is read, or dropped and reported.

use crate::support::shapes::{CUBE, TETRAHEDRON, mesh};
use crate::support::write::{Kind as Written, write};
use twinedge_meshes::{Format, MeshFile, ReadError, read, read_bytes, read_path};

fn file(content: impl AsRef<[u8]>, format: Format) -> MeshFile {
    read_bytes(content.as_ref(), Some(format)).unwrap_or_else(|error| panic!("{error}"))
}

fn faces(file: &MeshFile) -> Vec<Vec<u32>> {
    file.mesh.faces().map(<[u32]>::to_vec).collect()
}

fn dropped(file: &MeshFile) -> Vec<(&str, usize)> {
    file.dropped.iter().map(|dropped| (dropped.what.as_ref(), dropped.count)).collect()
}

#[test]
fn obj_with_everything() {
    let file = file(
        "# a comment\nmtllib a.mtl\no first\nv 0 0 0\nv 1 0 0 1.0\nv 1e0 1. 0 # here, too\nv .5 +1 -0.5 0.1 0.2 0.3\n\
         vt 0 0\nvn 0 0 1\ng second\nusemtl red\ns off\nf 1/1/1 2/1/1 3/1/1\nf 1//1 3//1 -1//1\nf 4/1 3/1 \\\n 2/1 1/1#end\n\
         l 1 2 3\np 1\nv 9 9 9\ncurv 0 1 1 2\n",
        Format::Obj,
    );
    assert_eq!(file.mesh.points()[2..], [[1.0, 1.0, 0.0], [0.5, 1.0, -0.5], [9.0, 9.0, 9.0]]);
    assert_eq!(faces(&file), [vec![0, 1, 2], vec![0, 2, 3], vec![3, 2, 1, 0]]);
    assert_eq!(
        dropped(&file),
        [
            ("materials", 2),
            ("groups and objects", 3),
            ("weights of points", 1),
            ("colours of points", 1),
            ("texture coordinates", 1),
            ("normals", 1),
            ("faces' links to texture coordinates and normals", 3),
            ("lines", 1),
            ("points as elements", 1),
            ("other statements", 1),
        ]
    );
}

#[test]
fn obj_faces_may_come_before_their_points_and_count_back() {
    let file = file("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\r\nf\nf 2\n", Format::Obj);
    assert_eq!(faces(&file), [vec![0, 1, 2], vec![0, 1, 2], vec![], vec![1]]);
}

#[test]
fn a_byte_order_mark_is_passed_over() {
    let obj = file("\u{feff}v 0 0 0\nv 1 2 3\n", Format::Obj);
    assert_eq!(obj.mesh.points().len(), 2);
    assert_eq!(dropped(&obj), []);
    assert_eq!(file("\u{feff}OFF\n1 0 0\n1 2 3\n", Format::Off).mesh.points().len(), 1);
    assert_eq!(Format::of_content("\u{feff}OFF\n".as_bytes()), Some(Format::Off));
}

#[test]
fn off_with_prefixes_comments_and_colours() {
    for keyword in ["OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCNOFF", ""] {
        let text = format!(
            "{keyword} # header\n# nothing\n3 2 # no edges\n\n0 0 0 255 0 0\n1 0 0\n0 1 0\n3 0 1 2 0.5 0.5 0.5\n# last\n2 1 0\n"
        );
        let file = file(text, Format::Off);
        assert_eq!(file.mesh.points(), [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], "{keyword}");
        assert_eq!(faces(&file), [vec![0, 1, 2], vec![1, 0]]);
        assert_eq!(dropped(&file), [("values after the coordinates", 1), ("colours of faces", 1)]);
    }
    // Counts on the line of the keyword, and text at the end.
    let file = file("OFF 1 0 0\n1 2 3\nmore\n\nand more", Format::Off);
    assert_eq!(file.mesh.points(), [[1.0, 2.0, 3.0]]);
    assert_eq!(dropped(&file), [("lines after the last face", 2)]);
}

#[test]
fn ply_with_other_elements_and_properties() {
    let header = "format ascii 1.0\nobj_info x\nelement face 2\nproperty uchar red\nproperty list uchar uint vertex_index\n\
                  property list uchar float texcoord\nelement edge 1\nproperty int a\nproperty int b\nelement vertex 3\n\
                  property float z\nproperty float nx\nproperty float y\nproperty double x\nelement nothing 9000000000000000000\n";
    let file = file(
        format!("ply\n{header}end_header\n7 3 0 1 2 2 .5 .5\n7 0\n0\n8 9\n3 0 2 1\n 6 0 5 4\n\n9 0 8. +7\nmore\n"),
        Format::Ply,
    );
    assert_eq!(file.mesh.points(), [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]);
    assert_eq!(faces(&file), [vec![0, 1, 2], vec![]]);
    assert_eq!(
        dropped(&file),
        [
            ("property red of element face", 2),
            ("property texcoord of element face", 2),
            ("elements edge", 1),
            ("property nx of element vertex", 3),
            ("elements nothing", 9_000_000_000_000_000_000),
            ("values after the last element", 1),
        ]
    );
}

#[test]
fn ply_numbers_of_every_type_and_order() {
    let types: [(&str, &str, Vec<u8>, f64); 8] = [
        ("char", "int8", (-1_i8).to_le_bytes().to_vec(), -1.0),
        ("uchar", "uint8", 200_u8.to_le_bytes().to_vec(), 200.0),
        ("short", "int16", (-300_i16).to_le_bytes().to_vec(), -300.0),
        ("ushort", "uint16", 60_000_u16.to_le_bytes().to_vec(), 60_000.0),
        ("int", "int32", (-70_000_i32).to_le_bytes().to_vec(), -70_000.0),
        ("uint", "uint32", 4_000_000_000_u32.to_le_bytes().to_vec(), 4_000_000_000.0),
        ("float", "float32", 1.5_f32.to_le_bytes().to_vec(), 1.5),
        ("double", "float64", 0.1_f64.to_le_bytes().to_vec(), 0.1),
    ];
    for big in [false, true] {
        let ordered = |bytes: &[u8]| {
            let mut bytes = bytes.to_vec();
            if big {
                bytes.reverse();
            }
            bytes
        };
        for (old, new, number, value) in &types {
            let (end, mark) = if big { ("big", "\r\n") } else { ("little", "\n") };
            let header = [
                "ply",
                &format!("format binary_{end}_endian 1.0"),
                "element vertex 1",
                &format!("property {old} x"),
                "property ushort skipped",
                &format!("property {new} y"),
                "property float z",
                "element face 1",
                "property list ushort uchar vertex_indices",
                "end_header",
                "",
            ];
            let records = [number, &vec![7, 7], number, &vec![0; 4], &vec![3, 0], &vec![0], &vec![0], &vec![0]];
            let mut bytes = header.join(mark).into_bytes();
            bytes.extend(records.iter().flat_map(|record| ordered(record)));
            let file = file(bytes, Format::Ply);
            assert_eq!(file.mesh.points(), [[*value, *value, 0.0]], "{old}");
            assert_eq!(faces(&file), [vec![0, 0, 0]]);
            assert_eq!(dropped(&file), [("property skipped of element vertex", 1)]);
        }
    }
}

#[test]
fn a_cloud_of_points_has_no_faces() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n";
    let file = file(ply, Format::Ply);
    assert_eq!((file.mesh.points().len(), file.mesh.face_count()), (1, 0));
}

#[test]
fn stl_in_text_with_several_solids_and_any_case() {
    let facet = |z: &str| {
        format!(
            "  FACET NORMAL nan nan nan\n OUTER LOOP\n  vertex 0 0 {z}\n vertex 1 0 0\n\tvertex 0 1 0\nendloop\nendfacet\n"
        )
    };
    let text =
        format!("solid\n{}endsolid\nSolid two facet names\n{}{}endsolid two\n", facet("0"), facet("-0"), facet("1"));
    let file = file(text, Format::Stl);
    // 0 and −0 are the same place.
    assert_eq!(faces(&file), [[0, 1, 2], [0, 1, 2], [3, 1, 2]]);
    assert_eq!(file.mesh.points().len(), 4);
    assert_eq!(dropped(&file), [("normals", 3)]);
}

#[test]
fn stl_in_binary_with_attributes_and_a_tail() {
    let mut bytes = write(&mesh(4, TETRAHEDRON), Written::BinaryStl);
    bytes[84 + 48] = 1;
    bytes[84 + 50 + 49] = 1;
    assert_eq!(dropped(&file(&bytes, Format::Stl)), [("normals", 4), ("attributes of triangles", 2)]);
    // The header does not look like text, so the length may differ.
    bytes[0] = b'b';
    bytes.extend([0; 7]);
    let file = file(bytes, Format::Stl);
    assert_eq!(dropped(&file)[2], ("bytes after the last triangle", 7));
    assert_eq!(file.mesh.face_count(), 4);
}

#[test]
fn corners_are_welded_at_exactly_the_same_place_only() {
    let next = f64::from_bits(1.0_f64.to_bits() + 1);
    let triangle =
        |x: f64| format!("facet normal 0 0 0 outer loop vertex {x:?} 0 0 vertex 0 1 0 vertex 0 0 1 endloop endfacet ");
    let text = |x| format!("solid\n{}{}endsolid\n", triangle(1.0), triangle(x));
    assert_eq!(file(text(1.0), Format::Stl).mesh.points().len(), 3);
    assert_eq!(file(text(next), Format::Stl).mesh.points().len(), 4);
}

#[test]
fn the_content_says_the_format() {
    let cube = mesh(8, CUBE);
    let tetrahedron = mesh(4, TETRAHEDRON);
    for kind in Written::ALL {
        let mesh = if Written::INDEXED.contains(&kind) { &cube } else { &tetrahedron };
        let bytes = write(mesh, kind);
        assert_eq!(Format::of_content(&bytes), Some(kind.format()), "{kind:?}");
        let from_stream = read(&bytes[..], None).expect("well-formed");
        assert_eq!(from_stream.format, kind.format());
        assert_eq!(from_stream.mesh.face_count(), mesh.face_count());
    }
    // A binary file without a name in its header is recognized by its length.
    let mut binary = write(&tetrahedron, Written::BinaryStl);
    binary[0] = b'b';
    assert_eq!(Format::of_content(&binary), Some(Format::Stl));
    assert_eq!(Format::of_content(&binary[..binary.len() - 1]), None);
    for other in ["", "hello world", "plywood", "OFFER", "# only a comment", "\0\0\0", "{\"type\": 1}"] {
        assert_eq!(Format::of_content(other.as_bytes()), None, "{other}");
        assert!(matches!(read_bytes(other.as_bytes(), None), Err(ReadError::UnknownFormat)));
    }
}

#[test]
fn the_name_says_the_format_where_the_content_does_not() {
    for format in Format::ALL {
        assert_eq!(Format::of_name(format!("a/b.c.{}", format.name().to_uppercase())), Some(*format));
    }
    assert_eq!(Format::of_name("a/obj"), None);

    let folder = tempdir("names");
    let write_file = |name: &str, content: &str| {
        let path = folder.join(name);
        std::fs::write(&path, content).expect("the folder is there");
        path
    };
    // OFF without its keyword.
    let path = write_file("a.off", "1 0 0\n1 2 3\n");
    assert_eq!(read_path(path).expect("well-formed").format, Format::Off);
    // The content determines the format if the name does not fit.
    let path = write_file("b.stl", "OFF\n1 0 0\n1 2 3\n");
    assert_eq!(read_path(path).expect("well-formed").format, Format::Off);
    // An OBJ file whose first statement is unknown.
    let path = write_file("c.obj", "extension 1\nv 1 2 3\n");
    assert_eq!(read_path(path).expect("well-formed").format, Format::Obj);
    // A binary file whose header starts like an OBJ file, and whose length does not fit.
    let binary = [&b"v"[..], &[b' '; 79], &[0; 10]].concat();
    let path = folder.join("e.stl");
    std::fs::write(&path, binary).expect("the folder is there");
    assert_eq!(read_path(path).expect("well-formed").format, Format::Stl);
    let path = write_file("d.mesh", "v 1 2 3\n");
    assert_eq!(read_path(path).expect("well-formed").format, Format::Obj);
    assert!(matches!(read_path(folder.join("none.obj")), Err(ReadError::Io(_))));
    std::fs::remove_dir_all(folder).expect("it is ours");
}

fn tempdir(name: &str) -> std::path::PathBuf {
    let folder = std::env::temp_dir().join(format!("twinedge-meshes-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a place for files");
    folder
}

/// Written like by Windows programs, in either byte order.
#[test]
fn text_in_utf_16_is_read() {
    let text = "# Würfel\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let units = || "\u{FEFF}".encode_utf16().chain(text.encode_utf16());
    let big: Vec<u8> = units().flat_map(u16::to_be_bytes).collect();
    let little: Vec<u8> = units().flat_map(u16::to_le_bytes).collect();
    for bytes in [big, little] {
        assert_eq!(faces(&file(&bytes, Format::Obj)), [[0, 1, 2]]);
        assert_eq!(read_bytes(&bytes, None).unwrap().format, Format::Obj);
    }
}
