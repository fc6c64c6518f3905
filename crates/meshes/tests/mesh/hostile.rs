//! Malicious files: every prefix and many changes of valid files lead to a mesh or to a typed error.

use crate::support::shapes::{TETRAHEDRON, mesh};
use crate::support::write::{Kind as Written, write};
use quickcheck::{Gen, QuickCheck};
use twinedge::validate::Collect;
use twinedge_meshes::{Format, HalfEdgeMesh, IndexedMesh, ReadError, audit, read_bytes};

/// Reads and audits the input; returns true if it is a mesh.
fn survives(bytes: &[u8], format: Option<Format>) -> bool {
    match read_bytes(bytes, format) {
        Ok(file) => {
            assert!(file.mesh.points().iter().flatten().all(|x| x.is_finite()));
            assert!(file.mesh.corners().iter().all(|v| (*v as usize) < file.mesh.points().len()));
            let audit = audit(&file.mesh, &HalfEdgeMesh::expectation().closed().genus(0), Collect::All);
            assert_eq!(audit.counts().faces, file.mesh.face_count());
            true
        }
        Err(ReadError::Content { format: said, cause, .. }) => {
            assert!(format.is_none_or(|format| format == said));
            assert!(!cause.to_string().is_empty());
            false
        }
        Err(ReadError::UnknownFormat) => {
            assert_eq!(format, None);
            false
        }
        Err(error) => panic!("{error}"),
    }
}

#[test]
fn prefixes() {
    for kind in Written::ALL {
        let whole = write(&mesh(4, TETRAHEDRON), kind);
        assert!(survives(&whole, Some(kind.format())));
        let complete = (0..whole.len()).filter(|length| survives(&whole[..*length], Some(kind.format()))).count();
        // An OBJ file may end after any statement; other formats declare their length, except for final blanks and
        // names.
        let most = match kind {
            Written::Obj => whole.len(),
            Written::TextStl => "\n a name".len() + 1,
            Written::BinaryStl => 0,
            _ => 1,
        };
        assert!(complete <= most, "{kind:?}: {complete} prefixes are accepted");
    }
}

#[test]
fn changed_bytes() {
    fn survive(changes: Vec<(usize, u8)>) {
        for kind in Written::ALL {
            let mut bytes = write(&mesh(4, TETRAHEDRON), kind);
            for (at, byte) in &changes {
                let at = at % bytes.len();
                bytes[at] = *byte;
            }
            survives(&bytes, Some(kind.format()));
            survives(&bytes, None);
        }
    }
    QuickCheck::new().tests(500).rng(Gen::new(6)).quickcheck(survive as fn(Vec<(usize, u8)>));
}

#[test]
fn any_bytes() {
    fn survive(bytes: Vec<u8>) {
        for format in Format::ALL {
            survives(&bytes, Some(*format));
        }
        survives(&bytes, None);
    }
    QuickCheck::new().tests(2000).rng(Gen::new(300)).quickcheck(survive as fn(Vec<u8>));
}

/// Words of the formats in any order pass more checks than random bytes.
#[test]
fn any_words() {
    const WORDS: &str = "v f OFF COFF BINARY ply format ascii 1.0 element vertex face property list float uchar int x y z \
        vertex_indices end_header solid facet normal outer loop endloop endfacet endsolid 0 1 -1 3 \
        18446744073709551615 1e308 nan # \\ 1//2";
    fn survive(words: Vec<(u8, u8)>) {
        let all: Vec<&str> = WORDS.split(' ').collect();
        let mut text = String::new();
        for (word, blank) in words {
            text.push_str(all[usize::from(word) % all.len()]);
            text.push(if blank % 3 == 0 { '\n' } else { ' ' });
        }
        for start in ["", "OFF\n", "ply\nformat ascii 1.0\n", "solid\n"] {
            let text = format!("{start}{text}");
            for format in Format::ALL {
                survives(text.as_bytes(), Some(*format));
            }
        }
    }
    QuickCheck::new().tests(2000).rng(Gen::new(60)).quickcheck(survive as fn(Vec<(u8, u8)>));
}

/// A hundred thousand faces at one edge, one vertex, or one set of vertices: a quadratic algorithm would not finish.
#[test]
fn crowds() {
    const MANY: u32 = 100_000;
    let points = || vec![[0.0; 3]; MANY as usize + 3];
    let edges = |faces: Vec<Vec<u32>>| {
        let mesh = IndexedMesh::from_faces(points(), faces).expect("indices in range");
        let audit = audit(&mesh, &HalfEdgeMesh::expectation(), Collect::All);
        assert!(!audit.is_valid());
        (audit.counts().edges, audit.findings().total())
    };
    let many = MANY as usize;
    // All at one edge: that edge, and one unused vertex.
    assert_eq!(edges((0..MANY).map(|i| vec![0, 1, i + 2]).collect()), (2 * many + 1, 2));
    // All equal: all but one repeat it, and only it uses vertices.
    assert_eq!(edges((0..MANY).map(|_| vec![0, 1, 2]).collect()), (3, many - 1 + many));
    // All at one vertex, the only contact.
    let fans = (0..MANY / 2).map(|i| vec![0, 2 * i + 1, 2 * i + 2]).collect();
    assert_eq!(edges(fans), (3 * many / 2, 1 + 2));
    // One face with all vertices, and one with the reverse order.
    let around: Vec<_> = (0..MANY).collect();
    let back = around.iter().rev().copied().collect();
    assert_eq!(edges(vec![around, back]), (many, 1 + 3));
}
