//! Each error, from a file without any other error.

use crate::support::shapes::{TETRAHEDRON, mesh};
use crate::support::write::{Kind as Written, write};
use twinedge_meshes::{Cause, Format, IndexedMesh, IndexedMeshError, Position, ReadError, read, read_bytes};

fn error(content: impl AsRef<[u8]>, format: Format) -> (Position, Cause) {
    match read_bytes(content.as_ref(), Some(format)) {
        Err(ReadError::Content { format: said, position, cause }) => {
            assert_eq!(said, format);
            (position, cause)
        }
        other => panic!("no error about the content: {other:?}"),
    }
}

fn expected(what: &'static str, found: &str) -> Cause {
    Cause::Expected { what, found: found.into() }
}

const fn truncated(what: &'static str) -> Cause {
    Cause::Truncated { what }
}

const fn out_of_range(index: i64, points: usize) -> Cause {
    Cause::IndexOutOfRange { index, points }
}

const COORDINATE: &str = "a coordinate";
const INDEX: &str = "the index of a point";
const SIDES: &str = "the number of sides of a face";

#[test]
fn obj() {
    use Position::Line;
    for (text, line, cause) in [
        ("v 1 2 x\n", 1, expected(COORDINATE, "x")),
        ("\n\nv 1 2\n", 3, truncated(COORDINATE)),
        ("v 1 2 3\nv 1 2 inf\n", 2, Cause::NotFinite { found: f64::INFINITY }),
        ("v 1 2 -1e999\n", 1, Cause::NotFinite { found: f64::NEG_INFINITY }),
        ("v 1 2 3\nf 1 a 1\n", 2, expected(INDEX, "a")),
        ("v 1 2 3\nf 1 /1 1\n", 2, expected(INDEX, "")),
        ("v 1 2 3\nf 1 1/x 1\n", 2, expected("indices as 1/2/3", "1/x")),
        ("v 1 2 3\nf 1 1.5 1\n", 2, expected(INDEX, "1.5")),
        ("v 1 2 3\nf 1 99999999999999999999\n", 2, expected(INDEX, "99999999999999999999")),
        ("v 1 2 3\nf 1 0 1\n", 2, Cause::IndexZero),
        ("v 1 2 3\nf 1 2 1\nv 1 2 3 1\nf 1 9 1\nf 3 3 3\n", 4, out_of_range(9, 2)),
        ("v 1 2 3\nf 1 2 1\nf 1 2 1\n", 2, out_of_range(2, 1)),
        ("v 1 2 3\nf -1 -2 1\nv 1 2 3\n", 2, out_of_range(-2, 1)),
        ("v 1 2 3\nf -9223372036854775808\n", 2, out_of_range(i64::MIN, 1)),
        ("v 1 2 3\nf 9223372036854775807\n", 2, out_of_range(i64::MAX, 1)),
        ("v 1 2 3\nf 1 \\\n 1 \\\r\n 2\n", 4, out_of_range(2, 1)),
        ("v 1 2 3\rf 1 1 2\r", 2, out_of_range(2, 1)),
        ("", 1, Cause::Missing("point")),
        ("hello\nworld\nf\n", 4, Cause::Missing("point")),
    ] {
        assert_eq!(error(text, Format::Obj), (Line(line), cause), "{text}");
    }
    assert_eq!(error(b"v 1 2 \xff\xfe", Format::Obj).1, expected(COORDINATE, "\u{fffd}\u{fffd}"));
}

#[test]
fn off() {
    use Position::Line;
    let other_dimensions = Cause::Unsupported("OFF with other than three dimensions");
    for (text, line, cause) in [
        ("", 1, truncated("the number of points")),
        ("OFF\n", 2, truncated("the number of points")),
        ("OFFER\n1 0 0\n", 1, expected("the number of points", "OFFER")),
        ("OFF\n-1 0 0\n", 2, expected("the number of points", "-1")),
        ("OFF\n1\n", 3, truncated("the number of faces")),
        ("OFF\n1 x 0\n", 2, expected("the number of faces", "x")),
        ("OFF BINARY\n\0\0\0\x01", 1, Cause::Unsupported("binary OFF")),
        ("4OFF\n1 0 0\n1 2 3 4\n", 1, other_dimensions.clone()),
        ("nOFF 5\n", 1, other_dimensions.clone()),
        ("OFF\n2 0 0\n1 2 3\n", 4, truncated(COORDINATE)),
        ("OFF\n1 0 0\n1 2\n", 3, truncated(COORDINATE)),
        ("OFF\n1 0 0\n1 nan 3\n", 3, expected(COORDINATE, "nan")),
        ("OFF\n1 1 0\n1 2 3\n", 4, truncated(SIDES)),
        ("OFF\n1 1 0\n1 2 3\n-3 0 0 0\n", 4, expected(SIDES, "-3")),
        ("OFF\n1 1 0\n1 2 3\n3 0 0\n", 4, truncated(INDEX)),
        ("OFF\n1 1 0\n1 2 3\n3 0 0 z\n", 4, expected(INDEX, "z")),
        ("OFF\n1 2 0\n1 2 3\n3 0 0 0\n3 0 1 0\n", 5, out_of_range(1, 1)),
        ("OFF\n1 1 0\n1 2 3\n3 0 -1 0\n", 4, out_of_range(-1, 1)),
        ("OFF\n1 1 0\n1 2 3\n3 0 4294967296 0\n", 4, out_of_range(4_294_967_296, 1)),
    ] {
        if text.contains("nan") {
            let (at, cause) = error(text, Format::Off);
            assert_eq!(at, Line(line));
            assert!(matches!(cause, Cause::NotFinite { found } if found.is_nan()));
        } else {
            assert_eq!(error(text, Format::Off), (Line(line), cause), "{text}");
        }
    }
}

fn ply(header: &str, body: &str) -> String {
    format!("ply\nformat ascii 1.0\n{header}end_header\n{body}")
}

const XYZ: &str = "property float x\nproperty float y\nproperty float z\n";

#[test]
fn text_ply() {
    use Position::Line;
    let vertex = format!("element vertex 1\n{XYZ}");
    let both = format!("{vertex}element face 1\nproperty list uchar int vertex_indices\n");
    let value = "the value of a property";
    for (text, line, cause) in [
        (ply("element face 0\nproperty list uchar int vertex_indices\n", ""), 6, Cause::Missing("element vertex")),
        (
            ply("element vertex 0\nproperty float x\nproperty float y\n", ""),
            7,
            Cause::Missing("number x, y or z in element vertex"),
        ),
        (
            ply(&format!("element vertex 0\n{}", XYZ.replace("float y", "list uchar float y")), ""),
            8,
            Cause::Missing("number x, y or z in element vertex"),
        ),
        (
            ply(&format!("{vertex}element face 1\nproperty int vertex_indices\n"), "1 2 3\n0\n"),
            10,
            Cause::Missing("list vertex_indices in element face"),
        ),
        (ply(&format!("{vertex}{vertex}"), "1 2 3\n1 2 3\n"), 11, Cause::DefinedTwice),
        (ply(&format!("{vertex}property float x\n"), "1 2 3\n1 2 3\n"), 8, Cause::DefinedTwice),
        (ply(&vertex, "1 2\n"), 9, truncated(COORDINATE)),
        (ply(&vertex, "1 2 z\n"), 8, expected(COORDINATE, "z")),
        (ply(&vertex, "1 2 -inf\n"), 8, Cause::NotFinite { found: f64::NEG_INFINITY }),
        (ply(&both, "1 2 3\n"), 11, truncated(SIDES)),
        (ply(&both, "1 2 3\n-1\n"), 11, expected(SIDES, "-1")),
        (ply(&both, "1 2 3\n1.5 0\n"), 11, expected(SIDES, "1.5")),
        (ply(&both, "1 2 3\n3 0 0\n"), 12, truncated(INDEX)),
        (ply(&both, "1 2 3\n3 0 0.25 0\n"), 11, expected(INDEX, "0.25")),
        (ply(&both, "1 2 3\n3 0 0 1\n"), 11, out_of_range(1, 1)),
        (ply(&both, "1 2 3\n3 0 0 -1\n"), 11, out_of_range(-1, 1)),
        (ply(&format!("element other 1\nproperty int a\n{vertex}"), "x 1 2 3\n"), 10, expected(value, "x")),
    ] {
        assert_eq!(error(&text, Format::Ply), (Line(line), cause), "{text}");
    }
}

#[test]
fn ply_headers() {
    for (text, line) in [
        ("", 1),
        ("plx\n", 1),
        ("ply\nformat ascii 1.0\n", 3),
        ("ply\nformat utf8 1.0\nend_header\n", 2),
        ("ply\nelement vertex 0\nend_header\n", 4),
        ("ply\nformat ascii 1.0\nelement vertex -1\nend_header\n", 3),
        ("ply\nformat ascii 1.0\nelement vertex 99999999999999999999\nend_header\n", 3),
        ("ply\nformat ascii 1.0\nproperty float x\nend_header\n", 3),
        ("ply\nformat ascii 1.0\nelement vertex 0\nproperty quad x\nend_header\n", 4),
    ] {
        let (at, cause) = error(text, Format::Ply);
        assert_eq!(at, Position::Line(line), "{text}");
        assert!(matches!(&cause, Cause::Header(message) if !message.is_empty()), "{text} {cause:?}");
    }
}

#[test]
fn binary_ply() {
    use Position::Byte;
    let whole = write(&mesh(4, TETRAHEDRON), Written::LittlePly);
    let body = whole.len() - 4 * 24 - 4 * 16;
    assert_eq!(error(&whole[..body + 30], Format::Ply), (Byte(body as u64 + 24), truncated(COORDINATE)));
    assert_eq!(error(&whole[..whole.len() - 1], Format::Ply), (Byte(whole.len() as u64 - 4), truncated(INDEX)));
    let faces = body + 4 * 24;
    assert_eq!(error(&whole[..faces + 2], Format::Ply), (Byte(faces as u64), truncated(SIDES)));
    let mut spoilt = whole.clone();
    spoilt[faces + 4] = 4;
    assert_eq!(error(&spoilt, Format::Ply).1, out_of_range(4, 4));
    spoilt[faces + 4..faces + 8].fill(0xff);
    assert_eq!(error(&spoilt, Format::Ply).1, out_of_range(-1, 4));
    let mut spoilt = whole;
    spoilt[body + 8..body + 16].copy_from_slice(&f64::NAN.to_le_bytes());
    let (at, cause) = error(&spoilt, Format::Ply);
    assert_eq!(at, Byte(body as u64 + 8));
    assert!(matches!(cause, Cause::NotFinite { found } if found.is_nan()));
}

#[test]
fn text_stl() {
    use Position::Line;
    let facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    let solid = |inner: &str| format!("solid\n{inner}endsolid\n");
    for (text, line, cause) in [
        (solid(&facet.replace("facet normal", "face normal")), 2, expected("facet", "face")),
        (solid(&facet.replace("normal", "")), 2, expected("normal", "0")),
        (solid(&facet.replace("0 0 1\n", "0 0 up\n")), 2, expected("a component of the normal", "up")),
        (solid(&facet.replace("outer", "inner")), 3, expected("outer", "inner")),
        (solid(&facet.replace("outer loop", "outer")), 4, expected("loop", "vertex")),
        (solid(&facet.replace("vertex 1 0 0\n", "")), 6, expected("vertex", "endloop")),
        (solid(&facet.replace("vertex 0 1 0\n", "vertex 0 1 0\nvertex 1 1 0\n")), 7, expected("endloop", "vertex")),
        (solid(&facet.replace("vertex 1 0 0", "vertex 1 0")), 6, expected(COORDINATE, "vertex")),
        (solid(&facet.replace("vertex 1 0 0", "vertex 1 1e400 0")), 5, Cause::NotFinite { found: f64::INFINITY }),
        (solid(&facet.replace("endfacet\n", "")), 8, expected("endfacet", "endsolid")),
        (format!("solid\n{facet}"), 9, truncated("facet")),
        (format!("{}solids", solid(facet)), 10, expected("solid", "solids")),
    ] {
        assert_eq!(error(&text, Format::Stl), (Line(line), cause), "{text}");
    }
}

#[test]
fn binary_stl() {
    use Position::Byte;
    let whole = write(&mesh(4, TETRAHEDRON), Written::BinaryStl);
    let header = "80 bytes of header and the number of triangles";
    assert_eq!(error("", Format::Stl), (Byte(0), truncated(header)));
    assert_eq!(error([0; 83], Format::Stl), (Byte(83), truncated(header)));
    let mut spoilt = whole;
    spoilt[0] = b'b';
    let short = spoilt.len() as u64 - 1;
    let too_few = truncated("as many triangles as the header says");
    assert_eq!(error(&spoilt[..short as usize], Format::Stl), (Byte(short), too_few));
    let y = 84 + 50 + 12 + 12 + 4;
    spoilt[y..y + 4].copy_from_slice(&f32::INFINITY.to_le_bytes());
    assert_eq!(error(&spoilt, Format::Stl), (Byte(y as u64), Cause::NotFinite { found: f64::INFINITY }));
}

#[test]
fn streams_that_fail() {
    struct Broken;
    impl std::io::Read for Broken {
        fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
            Err(std::io::Error::other("unplugged"))
        }
    }
    assert!(matches!(read(Broken, Some(Format::Obj)), Err(ReadError::Io(error)) if error.to_string() == "unplugged"));
}

#[test]
fn errors_say_where_and_what() {
    let say = |text: &str, format| read_bytes(text.as_bytes(), Some(format)).unwrap_err().to_string();
    assert_eq!(say("v 1 2 x", Format::Obj), "OBJ, line 1: expected a coordinate, found `x`");
    assert_eq!(say("OFF\n1 0 0\n1 2", Format::Off), "OFF, line 3: expected a coordinate, but there is nothing more");
    assert_eq!(say("v 1 2 1e999", Format::Obj), "OBJ, line 1: the coordinate inf is not finite");
    assert_eq!(say("f -1", Format::Obj), "OBJ, line 1: a face lists point -1, but there are no points");
    assert_eq!(
        say("", Format::Stl),
        "STL, byte 0: expected 80 bytes of header and the number of triangles, but there is nothing more"
    );
    assert_eq!(say("OFF BINARY", Format::Off), "OFF, line 1: binary OFF cannot be read");
    // The excerpt of the file in a message is short and has no control characters.
    let long = format!("v 1 2 \u{1b}[31m{}", "x".repeat(10_000));
    let said = say(&long, Format::Obj);
    assert!(said.contains("\\u{1b}[31m") && said.ends_with("…`") && said.len() < 120, "{said}");
}

#[test]
fn arrays_that_are_no_mesh() {
    let one = || vec![[0.0; 3]];
    let new = |corners: &[u32], offsets: &[u32]| IndexedMesh::new(one(), corners.to_vec(), offsets.to_vec());
    assert_eq!(new(&[], &[]), Err(IndexedMeshError::Offsets { position: 0 }));
    assert_eq!(new(&[], &[1]), Err(IndexedMeshError::Offsets { position: 0 }));
    assert_eq!(new(&[0, 0, 0], &[1, 3]), Err(IndexedMeshError::Offsets { position: 0 }));
    assert_eq!(new(&[0, 0, 0], &[0, 2, 1, 3]), Err(IndexedMeshError::Offsets { position: 2 }));
    assert_eq!(new(&[0, 0, 0], &[0, 2]), Err(IndexedMeshError::Offsets { position: 1 }));
    assert_eq!(new(&[0, 0, 0], &[0, 4]), Err(IndexedMeshError::Offsets { position: 1 }));
    let out = IndexedMeshError::IndexOutOfRange { face: 2, index: 1, points: 1 };
    assert_eq!(new(&[0, 0, 1], &[0, 2, 2, 3]), Err(out));
    assert_eq!(out.to_string(), "face 2 lists point 1, but there are 1 points, counted from 0");
    assert_eq!(
        IndexedMesh::from_faces(one(), [[0, 0], [0, 1]]),
        Err(IndexedMeshError::IndexOutOfRange { face: 1, index: 1, points: 1 })
    );
    assert!(new(&[0, 0, 0], &[0, 0, 3]).is_ok());
}
