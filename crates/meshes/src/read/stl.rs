//! STL (stereolithography), text and binary: <https://www.fabbers.com/tech/STL_Format>.
//!
//! A file of separate triangles: corners at exactly the same coordinates become one point (and 0 equals −0).
//!
//! Read here and not by a crate: the well-kept reader (`stl_io`) takes a binary file whose header starts with `solid` for text,
//! and a text without name for binary; both are common. It reports an error without a line. The tests use it as a second opinion.

use super::builder::Builder;
use super::dropped::{Dropped, Drops};
use super::error::{Cause, Failure, Position};
use super::text::Text;
use super::weld::Weld;
use crate::IndexedMesh;

/// The header of a binary file, and the number of triangles.
const HEADER: usize = 84;
/// A triangle: its normal, three points, and two further bytes.
const TRIANGLE: usize = 50;

pub(super) fn read(bytes: &[u8]) -> Result<(IndexedMesh, Vec<Dropped>), Failure> {
    if is_text(bytes) { read_text(bytes) } else { read_binary(bytes) }
}

/// Returns true if it is a text. The first word does not decide: the header of a binary file is arbitrary, and may start with
/// `solid`. A file of exactly the length of a binary file is therefore binary.
pub(super) fn is_text(bytes: &[u8]) -> bool {
    is_named_solid(bytes) && expected_length(bytes) != Some(bytes.len() as u64)
}

pub(super) fn is_named_solid(bytes: &[u8]) -> bool {
    Text::new(bytes).any_word().is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
}

/// Returns the length of a binary file according to its own count.
pub(super) fn expected_length(bytes: &[u8]) -> Option<u64> {
    let count = bytes.get(HEADER - 4..HEADER)?.try_into().ok()?;
    Some(HEADER as u64 + TRIANGLE as u64 * u64::from(u32::from_le_bytes(count)))
}

fn read_binary(bytes: &[u8]) -> Result<(IndexedMesh, Vec<Dropped>), Failure> {
    let truncated = |at, what| Failure::new(Position::Byte(at), Cause::Truncated { what });
    let length = expected_length(bytes)
        .ok_or_else(|| truncated(bytes.len() as u64, "80 bytes of header and the number of triangles"))?;
    let mut mesh = Builder::new(0);
    let mut drops = Drops::default();
    let count = (length - HEADER as u64) / TRIANGLE as u64;
    mesh.reserve(count / 2, count, 3, bytes.len());
    let mut weld = Weld::default();
    let triangles = bytes[HEADER..].chunks_exact(TRIANGLE);
    for (i, triangle) in triangles.take(usize::try_from(count).unwrap_or(usize::MAX)).enumerate() {
        let start = HEADER + i * TRIANGLE;
        for corner in 1..4 {
            let mut point = [0.0; 3];
            for (axis, coordinate) in point.iter_mut().enumerate() {
                let offset = 12 * corner + 4 * axis;
                let [a, b, c, d] = [0, 1, 2, 3].map(|i| triangle[offset + i]);
                *coordinate = f64::from(f32::from_le_bytes([a, b, c, d]));
                if !coordinate.is_finite() {
                    let at = Position::Byte((start + offset) as u64);
                    return Err(Failure::new(at, Cause::NotFinite { found: *coordinate }));
                }
            }
            weld.corner(&mut mesh, point, Position::Byte((start + 12 * corner) as u64))?;
        }
        mesh.face(Position::Byte(start as u64))?;
        drops.add("normals", 1);
        drops.add_if(triangle[48..] != [0, 0], "attributes of triangles");
    }
    if length > bytes.len() as u64 {
        return Err(truncated(bytes.len() as u64, "as many triangles as the header says"));
    }
    drops.add("bytes after the last triangle", bytes.len() - length as usize);
    Ok((mesh.finish()?, drops.into_list()))
}

fn read_text(bytes: &[u8]) -> Result<(IndexedMesh, Vec<Dropped>), Failure> {
    let mut text = Text::new(bytes);
    let mut mesh = Builder::new(0);
    let mut drops = Drops::default();
    let mut weld = Weld::default();
    // A file may hold several solids.
    while let Some(word) = text.any_word() {
        expect(&text, Some(word), "solid")?;
        text.next_line();
        loop {
            let word = text.any_word();
            if word.is_some_and(|word| word.eq_ignore_ascii_case(b"endsolid")) {
                text.next_line();
                break;
            }
            expect(&text, word, "facet")?;
            facet(&mut text, &mut mesh, &mut weld)?;
            drops.add("normals", 1);
        }
    }
    Ok((mesh.finish()?, drops.into_list()))
}

fn facet(text: &mut Text<'_>, mesh: &mut Builder, weld: &mut Weld) -> Result<(), Failure> {
    let at = text.position();
    expect_next(text, "normal")?;
    for _ in 0..3 {
        let word = text.any_word();
        // Some writers give triangles without area the normal NaN.
        text.number(word, "a component of the normal")?;
    }
    expect_next(text, "outer")?;
    expect_next(text, "loop")?;
    for _ in 0..3 {
        expect_next(text, "vertex")?;
        let mut point = [0.0; 3];
        for coordinate in &mut point {
            let word = text.any_word();
            *coordinate = text.coordinate(word)?;
        }
        weld.corner(mesh, point, text.position())?;
    }
    expect_next(text, "endloop")?;
    expect_next(text, "endfacet")?;
    mesh.face(at)
}

fn expect_next(text: &mut Text<'_>, keyword: &'static str) -> Result<(), Failure> {
    let word = text.any_word();
    expect(text, word, keyword)
}

fn expect(text: &Text<'_>, word: Option<&[u8]>, keyword: &'static str) -> Result<(), Failure> {
    match word {
        Some(word) if word.eq_ignore_ascii_case(keyword.as_bytes()) => Ok(()),
        _ => Err(text.expected(keyword, word)),
    }
}
