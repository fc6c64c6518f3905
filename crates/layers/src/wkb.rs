//! Well-known binary, as defined by the OGC and ISO, and the extended form of PostGIS, which adds a reference system.
//!
//! Counts are trusted only as far as the data can hold them.
//!
//! Sources: "Simple feature access, part 1: common architecture" (OGC 06-103r4), section 8; the documentation of PostGIS for the
//! extended form.

use super::crs::Crs;
use super::each::Each;
use super::error::{Cause, Place, ReadError, WriteError};
use super::model::{Dimensions, Feature, Geometry, Header, Layer, Line, Position, Shape, hex};
use crate::io::{Format, unread_geometry};
use std::io::{BufRead, BufReader, Read, Write};

/// The largest number of collections around a geometry.
const NESTED: usize = 32;

/// The bits of the extended form: height, measure, reference system.
const EXTENDED: [u32; 3] = [0x8000_0000, 0x4000_0000, 0x2000_0000];

/// Reads a geometry per line in hexadecimal digits, or consecutive geometries as bytes; each is a feature.
pub(super) fn read(reader: &mut dyn Read, each: &mut Each<'_>) -> Result<Header, ReadError> {
    let mut reader = BufReader::new(reader);
    let mut header = Header::default();
    let mut take = |geometry, srid: Option<i64>| {
        if let Some(srid) = srid.filter(|_| header.crs.is_none()) {
            header.crs = Some(Crs::epsg(srid));
        }
        each(Feature { geometry: Some(geometry), ..Feature::default() })
    };
    if matches!(reader.fill_buf()?.first(), Some(0 | 1)) {
        let mut bytes = Vec::new();
        reader.read_to_end(&mut bytes)?;
        let mut rest = Bytes { rest: &bytes };
        for number in 0.. {
            if rest.rest.is_empty() {
                break;
            }
            let (geometry, srid) = rest.geometry(0).map_err(|cause| content(Place::Feature(number), cause))?;
            take(geometry, srid)?;
        }
    } else {
        let mut line = Vec::new();
        for number in 1.. {
            line.clear();
            if reader.read_until(b'\n', &mut line)? == 0 {
                break;
            }
            let digits = line.trim_ascii();
            let digits = digits.strip_prefix(b"\\x").unwrap_or(digits);
            if digits.is_empty() {
                continue;
            }
            let failed = |cause| content(Place::Line(number), cause);
            let bytes = from_hex(digits).ok_or_else(|| failed(Cause::Invalid("not hexadecimal digits".to_owned())))?;
            let (geometry, srid) = parse(&bytes).map_err(failed)?;
            take(geometry, srid)?;
        }
    }
    Ok(header)
}

fn content(place: Place, cause: Cause) -> ReadError {
    ReadError::Content { format: Format::Wkb, place, cause }
}

fn from_hex(digits: &[u8]) -> Option<Vec<u8>> {
    let digit = |byte: u8| char::from(byte).to_digit(16).map(|digit| digit as u8);
    let pairs = digits.chunks(2);
    pairs.map(|pair| Some(digit(*pair.first()?)? << 4 | digit(*pair.get(1)?)?)).collect()
}

/// Reads one geometry as well-known binary, which must use all of the bytes. O(bytes).
///
/// ```
/// use twinedge_layers::{Shape, geometry_of_wkb};
///
/// let mut point = vec![1, 1, 0, 0, 0];
/// point.extend([7.66_f64, 45.98].into_iter().flat_map(f64::to_le_bytes));
/// assert!(matches!(geometry_of_wkb(&point)?.shape, Shape::Point(Some(at)) if at.y == 45.98));
/// assert!(geometry_of_wkb(&point[..20]).is_err());
/// # Ok::<(), twinedge_layers::Cause>(())
/// ```
///
/// # Errors
/// [`Cause`].
pub fn geometry_of_wkb(bytes: &[u8]) -> Result<Geometry, Cause> {
    parse(bytes).map(|(geometry, _)| geometry)
}

/// Writes one geometry as well-known binary of ISO, little-endian. O(positions).
///
/// ```
/// use twinedge_layers::{Dimensions, Geometry, Position, Shape, geometry_of_wkb, wkb_of_geometry};
///
/// let summit = Geometry::new(Dimensions::Xy, Shape::Point(Some(Position::new(7.66, 45.98))));
/// assert_eq!(geometry_of_wkb(&wkb_of_geometry(&summit))?, summit);
/// # Ok::<(), twinedge_layers::Cause>(())
/// ```
#[must_use]
pub fn wkb_of_geometry(geometry: &Geometry) -> Vec<u8> {
    let mut bytes = Vec::new();
    append(geometry, &mut bytes);
    bytes
}

/// Reads one geometry, which must use all of the bytes, and its reference system. O(bytes).
pub(super) fn parse(bytes: &[u8]) -> Result<(Geometry, Option<i64>), Cause> {
    let mut bytes = Bytes { rest: bytes };
    let geometry = bytes.geometry(0)?;
    match bytes.rest.len() {
        0 => Ok(geometry),
        trailing => Err(Cause::Trailing(trailing)),
    }
}

/// The unread part.
struct Bytes<'a> {
    rest: &'a [u8],
}

#[derive(Clone, Copy)]
struct Form {
    is_little: bool,
    dimensions: Dimensions,
}

impl Form {
    const fn position_bytes(self) -> usize {
        8 * (2 + self.dimensions.more())
    }
}

impl Bytes<'_> {
    fn take<const N: usize>(&mut self, what: &'static str) -> Result<[u8; N], Cause> {
        let (first, rest) = self.rest.split_first_chunk().ok_or(Cause::Truncated(what))?;
        self.rest = rest;
        Ok(*first)
    }

    fn integer(&mut self, is_little: bool, what: &'static str) -> Result<u32, Cause> {
        let bytes = self.take(what)?;
        Ok(if is_little { u32::from_le_bytes(bytes) } else { u32::from_be_bytes(bytes) })
    }

    /// Reads the number of items that need at least this many bytes each.
    fn count(&mut self, form: Form, what: &'static str, bytes: usize) -> Result<usize, Cause> {
        let count = self.integer(form.is_little, what)?;
        if count as usize > self.rest.len() / bytes {
            return Err(Cause::TooMany { what, count: count.into() });
        }
        Ok(count as usize)
    }

    /// The recursion is as deep as collections are nested, at most [`NESTED`].
    fn geometry(&mut self, depth: usize) -> Result<(Geometry, Option<i64>), Cause> {
        let is_little = match self.take("the byte order")? {
            [0] => false,
            [1] => true,
            [other] => return Err(Cause::Invalid(format!("the byte order is {other}, and must be 0 or 1"))),
        };
        let kind = self.integer(is_little, "the type of a geometry")?;
        let [has_z, has_m, has_srid] = EXTENDED.map(|bit| kind & bit != 0);
        let srid = has_srid.then(|| self.integer(is_little, "the reference system")).transpose()?;
        let plain = kind & !(EXTENDED[0] | EXTENDED[1] | EXTENDED[2]);
        let of_thousands = match plain / 1000 {
            0 => Dimensions::with(has_z, has_m),
            1 => Dimensions::Xyz,
            2 => Dimensions::Xym,
            3 => Dimensions::Xyzm,
            _ => return Err(Cause::Invalid(format!("{kind} is no type of geometries"))),
        };
        let form = Form { is_little, dimensions: of_thousands };
        let shape = match plain % 1000 {
            1 => Shape::Point(self.point(form)?),
            2 => Shape::Line(self.line(form)?),
            3 => Shape::Polygon(self.polygon(form)?),
            kind @ 4..=7 => {
                let count = self.count(form, "geometries", 5)?;
                self.collection(kind, count, depth)?
            }
            kind => return Err(Cause::Invalid(unread_geometry(kind))),
        };
        Ok((Geometry::new(form.dimensions, shape), srid.map(i64::from)))
    }

    fn collection(&mut self, kind: u32, count: usize, depth: usize) -> Result<Shape, Cause> {
        if depth == NESTED {
            return Err(Cause::TooDeep);
        }
        let mut parts = Vec::new();
        for _ in 0..count {
            parts.push(self.geometry(depth + 1)?.0);
        }
        let wrong = |part: Shape| Cause::Invalid(format!("a {} inside a multi-geometry of another kind", part.name()));
        let parts_of = |parts: Vec<Geometry>| parts.into_iter().map(|part| part.shape);
        Ok(match kind {
            4 => {
                let point = |part| if let Shape::Point(point) = part { Ok(point) } else { Err(wrong(part)) };
                Shape::MultiPoint(parts_of(parts).map(point).collect::<Result<_, _>>()?)
            }
            5 => {
                let line = |part| if let Shape::Line(line) = part { Ok(line) } else { Err(wrong(part)) };
                Shape::MultiLine(parts_of(parts).map(line).collect::<Result<_, _>>()?)
            }
            6 => {
                let polygon = |part| if let Shape::Polygon(rings) = part { Ok(rings) } else { Err(wrong(part)) };
                Shape::MultiPolygon(parts_of(parts).map(polygon).collect::<Result<_, _>>()?)
            }
            _ => Shape::Collection(parts),
        })
    }

    fn number(&mut self, form: Form) -> Result<f64, Cause> {
        let bytes = self.take("a coordinate")?;
        Ok(if form.is_little { f64::from_le_bytes(bytes) } else { f64::from_be_bytes(bytes) })
    }

    /// Reads a position; `None` for NaN as x and y, as in empty points.
    fn point(&mut self, form: Form) -> Result<Option<Position>, Cause> {
        let (x, y) = (self.number(form)?, self.number(form)?);
        let more = (0..form.dimensions.more()).map(|_| self.number(form)).collect::<Result<_, _>>()?;
        if x.is_nan() && y.is_nan() {
            return Ok(None);
        }
        if !(x.is_finite() && y.is_finite()) {
            return Err(Cause::Invalid(format!("the coordinates ({x}, {y}) are not finite")));
        }
        Ok(Some(Position { x, y, more }))
    }

    fn line(&mut self, form: Form) -> Result<Line, Cause> {
        let count = self.count(form, "positions", form.position_bytes())?;
        let not_a_number = || Cause::Invalid("a coordinate of a line is not a number".to_owned());
        (0..count).map(|_| self.point(form)?.ok_or_else(not_a_number)).collect()
    }

    fn polygon(&mut self, form: Form) -> Result<Vec<Line>, Cause> {
        let count = self.count(form, "rings", 4)?;
        (0..count).map(|_| self.line(form)).collect()
    }
}

/// Writes a geometry per line, in hexadecimal digits; a feature without one is an empty collection.
pub(super) fn write(layer: &Layer, out: &mut dyn Write) -> Result<(), WriteError> {
    let empty = Geometry::new(Dimensions::Xy, Shape::Collection(Vec::new()));
    let mut bytes = Vec::new();
    for feature in &layer.features {
        bytes.clear();
        append(feature.geometry.as_ref().unwrap_or(&empty), &mut bytes);
        writeln!(out, "{}", hex(&bytes))?;
    }
    Ok(())
}

/// Appends a geometry in the form of ISO, little-endian. O(positions).
pub(super) fn append(geometry: &Geometry, out: &mut Vec<u8>) {
    let dimensions = geometry.dimensions;
    match &geometry.shape {
        Shape::Point(point) => append_point(point.as_ref(), dimensions, out),
        Shape::Line(line) => {
            head(2, dimensions, out);
            append_line(line, dimensions, out);
        }
        Shape::Polygon(rings) => append_polygon(rings, dimensions, out),
        Shape::MultiPoint(points) => {
            head(4, dimensions, out);
            count(points.len(), out);
            for point in points {
                append_point(point.as_ref(), dimensions, out);
            }
        }
        Shape::MultiLine(lines) => {
            head(5, dimensions, out);
            count(lines.len(), out);
            for line in lines {
                head(2, dimensions, out);
                append_line(line, dimensions, out);
            }
        }
        Shape::MultiPolygon(polygons) => {
            head(6, dimensions, out);
            count(polygons.len(), out);
            for rings in polygons {
                append_polygon(rings, dimensions, out);
            }
        }
        Shape::Collection(geometries) => {
            head(7, dimensions, out);
            count(geometries.len(), out);
            for geometry in geometries {
                append(geometry, out);
            }
        }
    }
}

fn head(kind: u32, dimensions: Dimensions, out: &mut Vec<u8>) {
    let thousands = match dimensions {
        Dimensions::Xy => 0,
        Dimensions::Xyz => 1,
        Dimensions::Xym => 2,
        Dimensions::Xyzm => 3,
    };
    out.push(1);
    out.extend((1000 * thousands + kind).to_le_bytes());
}

/// Counts are below 2³², as each item takes at least four bytes of memory.
fn count(n: usize, out: &mut Vec<u8>) {
    out.extend((n as u32).to_le_bytes());
}

fn append_point(point: Option<&Position>, dimensions: Dimensions, out: &mut Vec<u8>) {
    head(1, dimensions, out);
    let nowhere = Position { x: f64::NAN, y: f64::NAN, more: Box::from([f64::NAN; 2]) };
    append_position(point.unwrap_or(&nowhere), dimensions, out);
}

fn append_position(position: &Position, dimensions: Dimensions, out: &mut Vec<u8>) {
    out.extend(position.x.to_le_bytes());
    out.extend(position.y.to_le_bytes());
    for i in 0..dimensions.more() {
        out.extend(position.more.get(i).copied().unwrap_or_default().to_le_bytes());
    }
}

fn append_line(line: &[Position], dimensions: Dimensions, out: &mut Vec<u8>) {
    count(line.len(), out);
    for position in line {
        append_position(position, dimensions, out);
    }
}

fn append_polygon(rings: &[Line], dimensions: Dimensions, out: &mut Vec<u8>) {
    head(3, dimensions, out);
    count(rings.len(), out);
    for ring in rings {
        append_line(ring, dimensions, out);
    }
}
