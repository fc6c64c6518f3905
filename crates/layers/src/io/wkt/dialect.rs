//! Common forms of well-known text that the crate `wkt` rejects, converted to accepted forms.

use std::borrow::Cow;

/// Splits off a reference system before a geometry, as PostGIS writes it: `SRID=2056;POINT(1 2)`. `None` without a number.
pub(super) fn split_srid(text: &str) -> Option<(Option<i64>, &str)> {
    const MARK: &str = "SRID=";
    let Some((_, rest)) = text.split_at_checked(MARK.len()).filter(|(mark, _)| mark.eq_ignore_ascii_case(MARK)) else {
        return Some((None, text));
    };
    let (number, geometry) = rest.split_once(';')?;
    let srid: u32 = number.trim().parse().ok()?;
    Some((Some(srid.into()), geometry.trim_start()))
}

/// Adds the dimensions of geometries that leave them to the numbers, as in `POINT(1 2 3)`, and replaces the empty points of
/// multi-points by points with NaN coordinates, [`NOTHING`]. O(bytes · depth of collections).
pub(super) fn plain(text: &str) -> Cow<'_, str> {
    let mut out = String::new();
    let mut copied = 0;
    for (at, _) in text.match_indices('(').filter(|(at, _)| *at > 0) {
        let head = text[..at].trim_ascii_end();
        if at < copied || !head.ends_with(|c: char| c.is_ascii_alphabetic()) {
            continue;
        }
        let dimensions = dimensions(head, &text[at + 1..]);
        let word = if dimensions.is_empty() { last_word(head) } else { dimensions };
        let points = is_multi_point(head).then(|| points(&text[at + 1..], word)).flatten();
        if dimensions.is_empty() && points.is_none() {
            continue;
        }
        out.push_str(&text[copied..at]);
        out.push_str(dimensions);
        copied = at;
        if let Some((kept, end)) = points {
            out.push_str(&kept);
            copied = at + 1 + end;
        }
    }
    if copied == 0 {
        return Cow::Borrowed(text);
    }
    out.push_str(&text[copied..]);
    Cow::Owned(out)
}

/// Returns the dimensions that a geometry leaves to the numbers of its first position.
fn dimensions(head: &str, body: &str) -> &'static str {
    if says_dimensions(last_word(head)) {
        return "";
    }
    match first_position(body).map(|position| position.split_ascii_whitespace().count()) {
        Some(3) => " Z",
        Some(4) => " ZM",
        _ => "",
    }
}

fn last_word(text: &str) -> &str {
    let start = text.bytes().rposition(|byte| !byte.is_ascii_alphabetic()).map_or(0, |before| before + 1);
    &text[start..]
}

/// Returns true for `Z`, `M`, `ZM` and types with such a suffix; plain geometry types end in other letters.
fn says_dimensions(word: &str) -> bool {
    word.ends_with(['Z', 'z', 'M', 'm'])
}

/// Returns the numbers of the first position of a body; `None` without a position, or if an inner geometry states dimensions.
fn first_position(body: &str) -> Option<&str> {
    let mut depth = 1_usize;
    let mut rest = body;
    loop {
        rest = rest.trim_start_matches(|c: char| c == ',' || c.is_ascii_whitespace());
        match rest.chars().next()? {
            '(' => depth += 1,
            ')' if depth == 1 => return None,
            ')' => depth -= 1,
            c if c.is_ascii_alphabetic() => {
                let end = rest.find(|c: char| !c.is_ascii_alphabetic())?;
                if says_dimensions(&rest[..end]) {
                    return None;
                }
                rest = &rest[end..];
                continue;
            }
            _ => return rest.find([',', ')']).map(|end| &rest[..end]),
        }
        rest = &rest[1..];
    }
}

fn is_multi_point(head: &str) -> bool {
    const NAME: &str = "MULTIPOINT";
    let name = head.trim_end_matches(['Z', 'z', 'M', 'm']).trim_ascii_end();
    name.len()
        .checked_sub(NAME.len())
        .and_then(|start| name.get(start..))
        .is_some_and(|end| end.eq_ignore_ascii_case(NAME))
}

/// NaN in the form that the crate reads.
const NOTHING: &str = "+NaN";

/// Rewrites NaN in the form that the crate reads. O(bytes).
pub(super) fn with_nothing(text: &str) -> Cow<'_, str> {
    let bytes = text.as_bytes();
    let is_number = |at: &usize| {
        let starts = at.checked_sub(1).is_none_or(|before| matches!(bytes[before], b'(' | b',' | b' ' | b'\t'));
        starts && bytes[*at..].get(..3).is_some_and(|word| word.eq_ignore_ascii_case(b"nan"))
    };
    let places: Vec<usize> = (0..bytes.len()).filter(is_number).collect();
    if places.is_empty() {
        return Cow::Borrowed(text);
    }
    let mut out = text.to_owned();
    for at in places.into_iter().rev() {
        out.insert(at, '+');
    }
    Cow::Owned(out)
}

/// Returns the points of a multi-point in brackets, with NaN for empty ones, and the end of its body; `None` if no point is
/// empty. `word` ends with the dimensions.
fn points(body: &str, word: &str) -> Option<(String, usize)> {
    let is_empty = |point: &&str| point.trim_ascii().eq_ignore_ascii_case("EMPTY");
    let mut depth = 1_usize;
    let end = body.bytes().position(|byte| {
        match byte {
            b'(' => depth += 1,
            b')' => depth -= 1,
            _ => {}
        }
        depth == 0
    })?;
    // Commas stand only between points.
    let all = || body[..end].split(',');
    if !all().any(|point| is_empty(&point)) {
        return None;
    }
    let numbers = 2 + word.bytes().rev().take_while(|byte| matches!(byte, b'Z' | b'z' | b'M' | b'm')).count();
    let nothing = format!("({})", [NOTHING; 4][..numbers.min(4)].join(" "));
    let written: Vec<&str> = all().map(|point| if is_empty(&point) { &nothing } else { point }).collect();
    Some((format!("({})", written.join(",")), end + 1))
}
