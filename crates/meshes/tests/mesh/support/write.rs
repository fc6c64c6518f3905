//! Minimal writers for all formats.

use std::fmt::Write as _;
use twinedge_meshes::{Format, IndexedMesh};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    Obj,
    Off,
    TextPly,
    LittlePly,
    BigPly,
    TextStl,
    BinaryStl,
}

impl Kind {
    /// The formats that keep the numbers of points.
    pub(crate) const INDEXED: [Self; 5] = [Self::Obj, Self::Off, Self::TextPly, Self::LittlePly, Self::BigPly];
    pub(crate) const ALL: [Self; 7] =
        [Self::Obj, Self::Off, Self::TextPly, Self::LittlePly, Self::BigPly, Self::TextStl, Self::BinaryStl];

    pub(crate) const fn format(self) -> Format {
        match self {
            Self::Obj => Format::Obj,
            Self::Off => Format::Off,
            Self::TextPly | Self::LittlePly | Self::BigPly => Format::Ply,
            Self::TextStl | Self::BinaryStl => Format::Stl,
        }
    }
}

pub(crate) fn write(mesh: &IndexedMesh, kind: Kind) -> Vec<u8> {
    match kind {
        Kind::Obj => text(mesh, String::new(), "v ", |face| format!("f{}", words(face, 1))),
        Kind::Off => {
            let header = format!("OFF\n{} {} 0\n", mesh.points().len(), mesh.face_count());
            text(mesh, header, "", |face| format!("{}{}", face.len(), words(face, 0)))
        }
        Kind::TextPly => text(mesh, ply_header(mesh, "ascii"), "", |face| format!("{}{}", face.len(), words(face, 0))),
        Kind::LittlePly => binary_ply(mesh, "binary_little_endian", |bytes| bytes),
        Kind::BigPly => binary_ply(mesh, "binary_big_endian", |mut bytes| {
            bytes.reverse();
            bytes
        }),
        Kind::TextStl => text_stl(mesh),
        Kind::BinaryStl => binary_stl(mesh),
    }
}

fn words(face: &[u32], first: u32) -> String {
    face.iter().fold(String::new(), |mut out, v| {
        let _ = write!(out, " {}", v + first);
        out
    })
}

fn text(mesh: &IndexedMesh, header: String, point: &str, face: impl Fn(&[u32]) -> String) -> Vec<u8> {
    let mut out = header;
    for [x, y, z] in mesh.points() {
        let _ = writeln!(out, "{point}{x:?} {y:?} {z:?}");
    }
    for corners in mesh.faces() {
        let _ = writeln!(out, "{}", face(corners));
    }
    out.into_bytes()
}

fn ply_header(mesh: &IndexedMesh, encoding: &str) -> String {
    format!(
        "ply\nformat {encoding} 1.0\ncomment any\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {}\nproperty list uint int vertex_indices\nend_header\n",
        mesh.points().len(),
        mesh.face_count()
    )
}

fn binary_ply(mesh: &IndexedMesh, encoding: &str, order: impl Fn(Vec<u8>) -> Vec<u8>) -> Vec<u8> {
    let mut out = ply_header(mesh, encoding).into_bytes();
    for x in mesh.points().iter().flatten() {
        out.extend(order(x.to_le_bytes().to_vec()));
    }
    for face in mesh.faces() {
        out.extend(order((face.len() as u32).to_le_bytes().to_vec()));
        for v in face {
            out.extend(order(v.to_le_bytes().to_vec()));
        }
    }
    out
}

fn text_stl(mesh: &IndexedMesh) -> Vec<u8> {
    let mut out = "solid a name\n".to_owned();
    for face in mesh.faces() {
        out.push_str("facet normal 0 0 1\n outer loop\n");
        for [x, y, z] in face.iter().map(|v| mesh.points()[*v as usize]) {
            let _ = writeln!(out, "  vertex {x:?} {y:?} {z:?}");
        }
        out.push_str(" endloop\nendfacet\n");
    }
    out.push_str("endsolid a name\n");
    out.into_bytes()
}

fn binary_stl(mesh: &IndexedMesh) -> Vec<u8> {
    // A header that looks like text, as written by some programs.
    let mut out = format!("{:80}", "solid of a binary file").into_bytes();
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
