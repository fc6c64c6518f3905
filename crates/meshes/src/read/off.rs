//! OFF (Object File Format of Geomview): <http://www.geomview.org/docs/html/OFF.html>.
//!
//! There is one point or face per line. Any further content of the line (colours, normals, texture coordinates) is dropped,
//! whether or not the prefix of `OFF` announces it.

use super::builder::Builder;
use super::dropped::{Dropped, Drops};
use super::error::{Cause, Failure};
use super::text::Text;
use crate::IndexedMesh;

pub(super) fn read(bytes: &[u8]) -> Result<(IndexedMesh, Vec<Dropped>), Failure> {
    let mut text = Text::new(bytes).with_comments(b'#');
    let mut mesh = Builder::new(0);
    let mut drops = Drops::default();

    let mut word = text.any_word();
    if let Some(keyword) = word.filter(|word| is_keyword(word)) {
        let prefix = &keyword[..keyword.len() - 3];
        if prefix.contains(&b'4') || prefix.contains(&b'n') {
            return Err(text.failed(Cause::Unsupported("OFF with other than three dimensions")));
        }
        word = text.any_word();
        if word == Some(b"BINARY") {
            return Err(text.failed(Cause::Unsupported("binary OFF")));
        }
    }
    let points: u64 = text.integer(word, "the number of points")?;
    let word = text.any_word();
    let faces: u64 = text.integer(word, "the number of faces")?;
    // The number of edges is 0 in most files and not needed.
    text.skip_words();
    mesh.reserve(points, faces, 4, text.left());

    for _ in 0..points {
        let mut point = [0.0; 3];
        let mut word = text.any_word();
        for (i, coordinate) in point.iter_mut().enumerate() {
            if i > 0 {
                word = text.word();
            }
            *coordinate = text.coordinate(word)?;
        }
        mesh.point(point, text.position())?;
        drops.add_if(text.skip_words() > 0, "values after the coordinates");
    }
    for _ in 0..faces {
        let word = text.any_word();
        let at = text.position();
        let sides: u64 = text.integer(word, "the number of sides of a face")?;
        for _ in 0..sides {
            let word = text.word();
            let point = text.integer(word, "the index of a point")?;
            mesh.corner(point, at)?;
        }
        mesh.face(at)?;
        drops.add_if(text.skip_words() > 0, "colours of faces");
    }
    let mut after = 0;
    while text.next_line() {
        after += usize::from(text.word().is_some());
    }
    drops.add("lines after the last face", after);
    Ok((mesh.finish()?, drops.into_list()))
}

/// Returns true if the word is `OFF`, with any of the prefixes `ST`, `C`, `N`, `4` and `n`, in this order.
pub(super) fn is_keyword(word: &[u8]) -> bool {
    let mut rest = word;
    for prefix in [&b"ST"[..], b"C", b"N", b"4", b"n"] {
        rest = rest.strip_prefix(prefix).unwrap_or(rest);
    }
    rest == b"OFF"
}
