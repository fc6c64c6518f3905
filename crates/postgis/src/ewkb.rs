//! Geometries in the extended well-known binary form, in which PostGIS sends them; the form of ISO 13249-3 is read as well.
//!
//! Only points, lines and polygons are decoded, and only their first two coordinates.

use super::error::Cause;
use twinedge_geometry::Point;

const Z: u32 = 0x8000_0000;
const M: u32 = 0x4000_0000;
const SRID: u32 = 0x2000_0000;

pub(super) enum Geometry<'a> {
    /// A point; an empty one has no coordinates, or NaN.
    Point(Point),
    Line(Points<'a>),
    /// The outer ring of a polygon, and its number of rings.
    Polygon(Points<'a>, u32),
    /// Any other type, by its number: 5 is a multi-line, 8 a circular string.
    Other(u32),
}

#[derive(Clone, Copy)]
pub(super) struct Points<'a> {
    bytes: &'a [u8],
    stride: usize,
    big_endian: bool,
}

impl<'a> Points<'a> {
    pub(super) fn iter(self) -> impl DoubleEndedIterator<Item = Point> + ExactSizeIterator + 'a {
        self.bytes.chunks_exact(self.stride).map(move |bytes| {
            let coordinate = |at: usize| {
                let mut eight = [0; 8];
                eight.copy_from_slice(&bytes[at..at + 8]);
                if self.big_endian { f64::from_be_bytes(eight) } else { f64::from_le_bytes(eight) }
            };
            Point::new(coordinate(0), coordinate(8))
        })
    }
}

struct Rest<'a> {
    bytes: &'a [u8],
    big_endian: bool,
}

impl<'a> Rest<'a> {
    fn take(&mut self, count: usize) -> Result<&'a [u8], Cause> {
        let (taken, rest) = self.bytes.split_at_checked(count).ok_or(Cause::GeometryTruncated)?;
        self.bytes = rest;
        Ok(taken)
    }

    fn number(&mut self) -> Result<u32, Cause> {
        let mut four = [0; 4];
        four.copy_from_slice(self.take(4)?);
        Ok(if self.big_endian { u32::from_be_bytes(four) } else { u32::from_le_bytes(four) })
    }

    fn points(&mut self, count: u32, stride: usize) -> Result<Points<'a>, Cause> {
        let length = (count as usize).checked_mul(stride).ok_or(Cause::GeometryTruncated)?;
        Ok(Points { bytes: self.take(length)?, stride, big_endian: self.big_endian })
    }
}

/// Reads a geometry, and the number of its reference system, which is 0 if absent. O(rings).
pub(super) fn parse(bytes: &[u8]) -> Result<(Geometry<'_>, u32), Cause> {
    let mut rest = Rest { bytes, big_endian: false };
    rest.big_endian = match rest.take(1)?[0] {
        0 => true,
        1 => false,
        order => return Err(Cause::ByteOrder(order)),
    };
    let kind = rest.number()?;
    let srid = if kind & SRID == 0 { 0 } else { rest.number()? };
    let (number, iso) = (kind & !(Z | M | SRID), (kind & 0xffff) / 1000);
    let dimensions = 2 + usize::from(kind & Z != 0) + usize::from(kind & M != 0);
    let dimensions = match iso {
        0 => dimensions,
        1 | 2 => 3,
        _ => 4,
    };
    let stride = 8 * dimensions;
    let geometry = match number % 1000 {
        1 => {
            let points = rest.points(1, stride)?;
            Geometry::Point(points.iter().next().unwrap_or(Point::new(f64::NAN, f64::NAN)))
        }
        2 => {
            let count = rest.number()?;
            Geometry::Line(rest.points(count, stride)?)
        }
        3 => {
            let rings = rest.number()?;
            let mut outer = Points { bytes: &[], stride, big_endian: rest.big_endian };
            for ring in 0..rings {
                let count = rest.number()?;
                let points = rest.points(count, stride)?;
                if ring == 0 {
                    outer = points;
                }
            }
            Geometry::Polygon(outer, rings)
        }
        _ => return Ok((Geometry::Other(number), srid)),
    };
    match rest.bytes.len() {
        0 => Ok((geometry, srid)),
        more => Err(Cause::GeometryTrailing(more)),
    }
}

pub(super) fn kind_name(number: u32) -> &'static str {
    match number % 1000 {
        1 => "a point",
        2 => "a line",
        3 => "a polygon",
        4 => "a multi-point",
        5 => "a multi-line",
        6 => "a multi-polygon",
        7 => "a collection",
        8 => "a circular string",
        9 => "a compound curve",
        _ => "no point, line or polygon",
    }
}
