//! OBJ (Wavefront): <https://paulbourke.net/dataformats/obj/>.
//!
//! Read here and not by a crate, since the audit is about the points that the *file* has: the well-kept reader (`tobj`) keeps
//! only points that faces use, renumbers them for each group and material, and reports errors without line and index. The tests
//! compare with it.

use super::builder::Builder;
use super::dropped::{Dropped, Drops};
use super::error::{Cause, Failure};
use super::text::Text;
use crate::IndexedMesh;

pub(super) fn read(bytes: &[u8]) -> Result<(IndexedMesh, Vec<Dropped>), Failure> {
    let mut text = Text::new(bytes).with_comments(b'#').with_continued_lines();
    let mut mesh = Builder::new(1);
    let mut drops = Drops::default();
    loop {
        if let Some(statement) = text.word() {
            match statement {
                b"v" => point(&mut text, &mut mesh, &mut drops)?,
                b"f" | b"fo" => face(&mut text, &mut mesh, &mut drops)?,
                _ => drops.add(what_is(statement), 1),
            }
        }
        if !text.next_line() {
            break;
        }
    }
    let mesh = mesh.finish()?;
    // Unknown statements are skipped, so any text could be an OBJ file: one without points is refused.
    if mesh.points().is_empty() {
        return Err(text.failed(Cause::Missing("point")));
    }
    Ok((mesh, drops.into_list()))
}

/// Returns the name of a statement that is neither a point nor a face.
fn what_is(statement: &[u8]) -> &'static str {
    match statement {
        b"vt" => "texture coordinates",
        b"vn" => "normals",
        b"l" => "lines",
        b"p" => "points as elements",
        b"g" | b"o" | b"s" | b"mg" => "groups and objects",
        b"usemtl" | b"mtllib" | b"usemap" | b"maplib" => "materials",
        _ => "other statements",
    }
}

fn point(text: &mut Text<'_>, mesh: &mut Builder, drops: &mut Drops) -> Result<(), Failure> {
    let mut point = [0.0; 3];
    for coordinate in &mut point {
        let word = text.word();
        *coordinate = text.coordinate(word)?;
    }
    match text.skip_words() {
        0 => {}
        1 => drops.add("weights of points", 1),
        _ => drops.add("colours of points", 1),
    }
    mesh.point(point, text.position())
}

fn face(text: &mut Text<'_>, mesh: &mut Builder, drops: &mut Drops) -> Result<(), Failure> {
    let at = text.position();
    let mut with_more = false;
    while let Some(word) = text.word() {
        let end = word.iter().position(|byte| *byte == b'/').unwrap_or(word.len());
        let (number, more) = word.split_at(end);
        if !more.iter().all(|byte| matches!(byte, b'/' | b'-' | b'0'..=b'9')) {
            return Err(text.expected("indices as 1/2/3", Some(word)));
        }
        with_more |= !more.is_empty();
        let index: i64 = text.integer(Some(number), "the index of a point")?;
        let points = mesh.points().len();
        let from_zero = match index {
            1.. => index - 1,
            0 => return Err(text.failed(Cause::IndexZero)),
            // Counted backwards from the latest point.
            _ => index.saturating_add_unsigned(points as u64),
        };
        if from_zero < 0 {
            return Err(text.failed(Cause::IndexOutOfRange { index, points }));
        }
        mesh.corner(from_zero, text.position())?;
    }
    if with_more {
        drops.add("faces' links to texture coordinates and normals", 1);
    }
    mesh.face(at)
}
