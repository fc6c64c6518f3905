//! glTF 2.0, as text and binary (GLB): <https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html>.
//!
//! The triangles of all meshes of the scene, moved as its nodes say. Corners at exactly the same place become one point, since files repeat a point
//! for each normal and texture. Skins and morph targets are not applied.
//!
//! Read here and not by a crate: the well-kept reader (`gltf`) brings a second model of the document and its own validation, and reads buffers only
//! together with pictures.

mod buffers;
mod document;
mod scene;

use super::builder::Builder;
use super::dropped::{Dropped, Drops};
use super::error::{Cause, Failure, Position};
use super::weld::Weld;
use crate::mesh::IndexedMesh;
use buffers::Buffers;
use document::{Document, Primitive};

/// The first bytes of a binary file.
const MAGIC: [u8; 4] = *b"glTF";

/// Returns true if it begins as a binary file. A text is known by its name only, as there are many kinds of JSON.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    bytes.starts_with(&MAGIC)
}

/// Nodes may use a mesh several times: there are at most so many times as many corners as the file has bytes, and four million more.
const TIMES: usize = 16;
const AND_MORE: usize = 1 << 22;

pub(super) fn read(bytes: &[u8]) -> Result<(IndexedMesh, Vec<Dropped>), Failure> {
    let (text, start, binary) = split(bytes)?;
    let document: Document<'_> = serde_json::from_slice(text).map_err(|error| {
        let at = if start == 0 { Position::Line(error.line() as u64) } else { Position::Byte(start) };
        Failure::new(at, Cause::Document(error.to_string().into()))
    })?;
    // Whatever is wrong with the document, the place is that of it.
    let at = if start == 0 { Position::Line(1) } else { Position::Byte(start) };
    load(&document, binary).map_err(|failure| Failure::new(at, failure.cause))
}

/// The text of a file, where it begins, and the buffer that follows it in a binary file.
type Parts<'a> = (&'a [u8], u64, Option<&'a [u8]>);

fn split(bytes: &[u8]) -> Result<Parts<'_>, Failure> {
    const CHUNKS: usize = 12;
    const HEAD: usize = 8;
    if !is_binary(bytes) {
        return Ok((bytes, 0, None));
    }
    let word = |at: usize| Some(u32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?));
    let chunk = |at: usize| {
        let length = word(at)? as usize;
        Some((bytes.get(at + 4..at + HEAD)?, bytes.get(at + HEAD..(at + HEAD).checked_add(length)?)?))
    };
    let truncated = |what| Failure::new(Position::Byte(bytes.len() as u64), Cause::Truncated { what });
    if word(4).ok_or_else(|| truncated("the version"))? != 2 {
        return Err(Failure::new(Position::Byte(4), Cause::Unsupported("a version of glTF other than 2")));
    }
    let Some((b"JSON", text)) = chunk(CHUNKS) else { return Err(truncated("the chunk JSON")) };
    let next = CHUNKS + HEAD + text.len().next_multiple_of(4);
    let binary = chunk(next).filter(|(kind, _)| *kind == b"BIN\0").map(|(_, data)| data);
    if binary.is_none() && next < bytes.len() {
        return Err(truncated("the chunk BIN"));
    }
    Ok((text, (CHUNKS + HEAD) as u64, binary))
}

/// The triangles of a document.
fn load(document: &Document<'_>, binary: Option<&[u8]>) -> Result<(IndexedMesh, Vec<Dropped>), Failure> {
    let at = Position::Byte(0);
    let wrong = |text: String| Failure::new(at, Cause::Document(text.into()));
    let (mut mesh, mut weld, mut drops) = (Builder::new(0), Weld::default(), Drops::default());
    for (what, count) in [
        ("animations", document.animations.len()),
        ("skins", document.skins.len()),
        ("materials", document.materials.len()),
    ] {
        drops.add(what, count);
    }
    let buffers = Buffers::new(document, binary)?;
    let meshes = scene::meshes(document)?;
    let corners = meshes.iter().fold(0, |sum: usize, (number, _)| sum.saturating_add(document.corners(*number)));
    if corners > TIMES.saturating_mul(buffers.length()).saturating_add(AND_MORE) {
        return Err(Failure::new(at, Cause::TooLarge));
    }
    for (number, transform) in meshes {
        let found = document.meshes.get(number).ok_or_else(|| wrong(format!("there is no mesh {number}")))?;
        for primitive in &found.primitives {
            drops.add("attributes of vertices other than their places", primitive.attributes.len().saturating_sub(1));
            drops.add("morph targets", primitive.targets.len());
            if primitive.is_compressed() {
                return Err(Failure::new(at, Cause::Unsupported("compression by Draco")));
            }
            let Some(places) = primitive.attributes.get("POSITION") else {
                drops.add("primitives without places", 1);
                continue;
            };
            let points: Vec<[f64; 3]> = buffers.places(*places)?.into_iter().map(|p| transform.of(p)).collect();
            if let Some(found) = points.iter().flatten().find(|x| !x.is_finite()) {
                return Err(Failure::new(at, Cause::NotFinite { found: *found }));
            }
            let indices = match primitive.indices {
                Some(accessor) => buffers.indices(accessor)?,
                None => (0..points.len() as u32).collect(),
            };
            let Some(triangles) = triangles(primitive, &indices) else {
                drops.add("primitives of points and lines", 1);
                continue;
            };
            for [a, b, c] in triangles {
                // A mirror image is wound the other way round.
                for index in if transform.is_mirror() { [a, c, b] } else { [a, b, c] } {
                    let out = Cause::IndexOutOfRange { index: i64::from(index), points: points.len() };
                    let point = points.get(index as usize).ok_or_else(|| Failure::new(at, out))?;
                    weld.corner(&mut mesh, *point, at)?;
                }
                mesh.face(at)?;
            }
        }
    }
    Ok((mesh.finish()?, drops.into_list()))
}

/// The triangles of a primitive, all wound the same way round; none if it is made of points or lines.
fn triangles(primitive: &Primitive, indices: &[u32]) -> Option<Vec<[u32; 3]>> {
    const TRIANGLES: u64 = 4;
    const STRIP: u64 = 5;
    const FAN: u64 = 6;
    Some(match primitive.mode.unwrap_or(TRIANGLES) {
        TRIANGLES => indices.chunks_exact(3).map(|triple| [triple[0], triple[1], triple[2]]).collect(),
        STRIP => {
            let turned = |(i, w): (usize, &[u32])| if i % 2 == 0 { [w[0], w[1], w[2]] } else { [w[0], w[2], w[1]] };
            indices.windows(3).enumerate().map(turned).collect()
        }
        FAN => indices.get(1..).unwrap_or_default().windows(2).map(|pair| [pair[0], pair[1], indices[0]]).collect(),
        _ => return None,
    })
}
