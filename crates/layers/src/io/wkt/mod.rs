//! Reading and writing well-known text, one geometry per line.
//!
//! The grammar follows the `wkt` crate: `POINT`, `LINESTRING`, `LINEARRING`, `POLYGON`, their `MULTI` forms and
//! `GEOMETRYCOLLECTION`, each with an optional `Z`, `M` or `ZM`, in upper or lower case. Without these, three numbers of a
//! position are x, y and z, and four are x, y, z and m. `SRID=2056;` may stand before a geometry, as PostGIS writes it.

mod dialect;

use core::str;
use std::io::{BufRead, BufReader, Read, Write};

use ::wkt::Wkt;
use ::wkt::types::{
    Coord, Dimension, GeometryCollection, LineString, MultiLineString, MultiPoint, MultiPolygon, Polygon,
};

use self::dialect::{plain, split_srid, with_nothing};
use super::error::{MAX_NESTED_COLLECTIONS, ReadCause, ReadError, TextPlace};
use super::unread::{unread_geometry, unread_in};
use super::write::{self, GeometryPiece, WriteError};
use twinedge_geometry::Point;
use twinedge_map::Feature;

/// A line with a geometry.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct GeometryLine {
    /// The line number, counted from 1.
    pub number: usize,
    /// The number of the reference system, if the line states one.
    pub srid: Option<i64>,
    /// The geometry in the type of the crate `wkt`.
    pub geometry: Wkt<f64>,
}

/// Reads a file, passing the geometry of each line to `each`. Numbers are not checked. A point with NaN coordinates is empty.
///
/// Blank lines and lines that start with `#` are skipped, and so is a byte order mark. The reader is buffered inside. Time
/// O(bytes); memory O(longest line).
///
/// # Errors
/// [`ReadError`] with the line, converted to `E`, and the errors of `each`. Earlier lines have been passed on by then.
///
/// ```
/// use twinedge_layers::io::{ReadError, wkt};
///
/// wkt::read_geometries("SRID=2056;POINT(1 2 3)".as_bytes(), |line| {
///     assert_eq!((line.srid, line.geometry.to_string().as_str()), (Some(2056), "POINT Z(1 2 3)"));
///     Ok::<_, ReadError>(())
/// })?;
/// # Ok::<_, ReadError>(())
/// ```
pub fn read_geometries<R, E>(reader: R, mut each: impl FnMut(GeometryLine) -> Result<(), E>) -> Result<(), E>
where
    R: Read,
    E: From<ReadError>,
{
    let mut input = BufReader::new(reader);
    let mut bytes = Vec::new();
    for number in 1.. {
        bytes.clear();
        if input.read_until(b'\n', &mut bytes).map_err(|error| error_in(number, ReadCause::Io(error)))? == 0 {
            break;
        }
        let text = str::from_utf8(&bytes).map_err(|_| error_in(number, ReadCause::NotUtf8))?;
        let text = if number == 1 { text.strip_prefix('\u{FEFF}').unwrap_or(text) } else { text };
        let text = text.trim();
        if text.is_empty() || text.starts_with('#') {
            continue;
        }
        let after_srid = || error_in(number, syntax("expected SRID=, a number and a semicolon"));
        let (srid, text) = split_srid(text).ok_or_else(after_srid)?;
        check_frame(text, number)?;
        let geometry = plain(&with_nothing(text)).parse().map_err(|message| {
            let unread = unread_in(text).map(unread_geometry);
            error_in(number, unread.map_or_else(|| syntax(message), |message| ReadCause::Unread { message }))
        })?;
        each(GeometryLine { number, srid, geometry: emptied(geometry) })?;
    }
    Ok(())
}

/// Replaces points with NaN coordinates by empty ones. The recursion is as deep as the brackets.
fn emptied(geometry: Wkt<f64>) -> Wkt<f64> {
    let point = |point: ::wkt::types::Point<f64>| match point.coord() {
        Some(coord) if coord.x.is_nan() && coord.y.is_nan() => ::wkt::types::Point::empty(point.dimension()),
        _ => point,
    };
    match geometry {
        Wkt::Point(one) => point(one).into(),
        Wkt::MultiPoint(points) => {
            let (points, dimension) = points.into_inner();
            MultiPoint::new(points.into_iter().map(point).collect(), dimension).into()
        }
        Wkt::GeometryCollection(all) => {
            let (geometries, dimension) = all.into_inner();
            GeometryCollection::new(geometries.into_iter().map(emptied).collect(), dimension).into()
        }
        other => other,
    }
}

fn error_in(line: usize, cause: ReadCause) -> ReadError {
    ReadError::new(TextPlace::line(line), cause)
}

fn syntax(message: &str) -> ReadCause {
    ReadCause::Syntax { message: message.to_owned() }
}

/// Checks that nothing follows the geometry, and that its brackets are not nested so deep that a recursive parser would exhaust
/// the stack; the `wkt` crate does not. The text must be words, then one pair of brackets unless the last word is `EMPTY`.
fn check_frame(text: &str, line: usize) -> Result<(), ReadError> {
    let is_empty_mark = |word: &str| word.eq_ignore_ascii_case("EMPTY");
    let (head, body) = text.split_at(text.find('(').unwrap_or(text.len()));
    if !head.chars().all(|c| c.is_ascii_alphabetic() || c.is_ascii_whitespace()) {
        return Err(error_in(line, syntax("expected the type of a geometry")));
    }
    if let Some(mark) = head.split_ascii_whitespace().position(is_empty_mark) {
        let is_last = head.split_ascii_whitespace().count() == mark + 1 && body.is_empty();
        return if is_last { Ok(()) } else { Err(error_in(line, ReadCause::Trailing { what: "geometry" })) };
    }
    let mut depth = 0_usize;
    for (at, byte) in body.bytes().enumerate() {
        match byte {
            b'(' => depth += 1,
            b')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        // A multi-polygon has three pairs of brackets of its own.
        if depth > MAX_NESTED_COLLECTIONS + 3 {
            return Err(error_in(line, ReadCause::TooDeep));
        }
        if depth == 0 {
            return if at + 1 == body.len() {
                Ok(())
            } else {
                Err(error_in(line, ReadCause::Trailing { what: "geometry" }))
            };
        }
    }
    Err(error_in(line, syntax("expected ( or EMPTY, and a ) for every (")))
}

/// Writes features, one geometry per line; names are not written.
///
/// One shape is written directly, several of a kind as a multi-geometry, other mixtures and features without shapes as a
/// collection. Numbers have enough digits to be read back exactly. Points, lines and rings are written as they are, so rings
/// should be closed, like the rings of a [contour](twinedge_algorithm::contour). The writer is not buffered inside. O(points).
///
/// # Errors
///
/// [`WriteError::NotFinite`], before anything is written, and [`WriteError::Io`].
///
/// ```
/// use twinedge_map::{Feature, Shape};
/// use twinedge_layers::io::wkt;
///
/// let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 0.5], [0.0, 0.0]];
/// let parcel = Feature { shapes: vec![Shape::polygon(corners)], ..Feature::default() };
/// let mut text = Vec::new();
/// wkt::write(&mut text, &[parcel])?;
/// assert_eq!(text, b"POLYGON((0 0,1 0,0 0.5,0 0))\n");
/// # Ok::<_, twinedge_layers::io::WriteError>(())
/// ```
pub fn write(mut writer: impl Write, features: &[Feature]) -> Result<(), WriteError> {
    write::check(features)?;
    for feature in features {
        let mut geometries: Vec<Wkt<f64>> = write::pieces(feature).into_iter().map(written).collect();
        let geometry = match geometries.pop() {
            Some(only) if geometries.is_empty() => only,
            last => {
                geometries.extend(last);
                GeometryCollection::new(geometries, Dimension::XY).into()
            }
        };
        writeln!(writer, "{geometry}")?;
    }
    Ok(())
}

fn written(piece: GeometryPiece) -> Wkt<f64> {
    const XY: Dimension = Dimension::XY;
    let coord = |p: Point| Coord { x: p.x, y: p.y, z: None, m: None };
    let line = |points: Vec<Point>| LineString::new(points.into_iter().map(coord).collect(), XY);
    let polygon = |rings: Vec<Vec<Point>>| Polygon::new(rings.into_iter().map(line).collect(), XY);
    let point = |p: Point| ::wkt::types::Point::from_coord(coord(p));
    match piece {
        GeometryPiece::Points(points) => match points[..] {
            [only] => point(only).into(),
            _ => MultiPoint::new(points.into_iter().map(point).collect(), XY).into(),
        },
        GeometryPiece::Lines(mut lines) => match lines.pop() {
            Some(only) if lines.is_empty() => line(only).into(),
            last => MultiLineString::new(lines.into_iter().chain(last).map(line).collect(), XY).into(),
        },
        GeometryPiece::Polygons(mut polygons) => match polygons.pop() {
            Some(only) if polygons.is_empty() => polygon(only).into(),
            last => MultiPolygon::new(polygons.into_iter().chain(last).map(polygon).collect(), XY).into(),
        },
    }
}
