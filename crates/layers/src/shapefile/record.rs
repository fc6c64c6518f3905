//! The records of `.shp`: one geometry each.
//!
//! ```text
//!   type, box, [parts], points, [index of the first point of each part], x y …, [z range, z …], [m range, m …]
//! ```

use super::super::error::Cause;
use super::super::model::{Dimensions, Geometry, Line, Position, Shape};
use super::columns::{Base, ShapeKind};
use super::rings::{polygons, written_rings};

/// Smaller measures mean "no data", according to the specification.
const NO_DATA: f64 = -1e38;

/// The unread part.
struct Bytes<'a> {
    rest: &'a [u8],
}

impl<'a> Bytes<'a> {
    fn take(&mut self, count: usize, what: &'static str) -> Result<&'a [u8], Cause> {
        let (first, rest) = self.rest.split_at_checked(count).ok_or(Cause::Truncated(what))?;
        self.rest = rest;
        Ok(first)
    }

    fn integer(&mut self, what: &'static str) -> Result<u32, Cause> {
        let bytes = self.take(4, what)?;
        Ok(bytes.try_into().map(u32::from_le_bytes).unwrap_or_default())
    }

    fn numbers(&mut self, count: usize, what: &'static str) -> Result<impl Iterator<Item = f64> + 'a, Cause> {
        let bytes = count.checked_mul(8).ok_or(Cause::TooMany { what, count: count as u64 })?;
        if bytes > self.rest.len() {
            return Err(Cause::TooMany { what, count: count as u64 });
        }
        let numbers = self.take(bytes, what)?.chunks_exact(8);
        Ok(numbers.map(|bytes| bytes.try_into().map(f64::from_le_bytes).unwrap_or_default()))
    }
}

/// Reads a record; none for a null shape. O(bytes).
pub(super) fn parse(record: &[u8]) -> Result<Option<Geometry>, Cause> {
    let mut bytes = Bytes { rest: record };
    let code = bytes.integer("the type of a shape")?;
    let base = match code % 10 {
        0 if code == 0 => return Ok(None),
        1 => Base::Point,
        3 => Base::Line,
        5 => Base::Polygon,
        8 => Base::MultiPoint,
        _ => return Err(Cause::Invalid(format!("{code} is a type of shapes that is not read here"))),
    };
    let (has_z, may_have_m) = match code / 10 {
        0 => (false, false),
        1 => (true, true),
        2 => (false, true),
        _ => return Err(Cause::Invalid(format!("{code} is no type of shapes"))),
    };
    let mut parts = Vec::new();
    let count = match base {
        Base::Point => 1,
        Base::MultiPoint | Base::Line | Base::Polygon => {
            bytes.take(32, "the box of a shape")?;
            let part_count = if base == Base::MultiPoint { 0 } else { bytes.integer("the number of parts")? as usize };
            let points = bytes.integer("the number of points")? as usize;
            if part_count > bytes.rest.len() / 4 {
                return Err(Cause::TooMany { what: "parts", count: part_count as u64 });
            }
            for _ in 0..part_count {
                parts.push(bytes.integer("the parts")? as usize);
            }
            points
        }
    };
    let twice = count.checked_mul(2).ok_or(Cause::TooMany { what: "points", count: count as u64 })?;
    let xy: Vec<f64> = bytes.numbers(twice, "coordinates")?.collect();
    if let Some(number) = xy.iter().find(|number| !number.is_finite()) {
        return Err(Cause::Invalid(format!("the coordinate {number} is not finite")));
    }
    let is_point = base == Base::Point;
    let mut z = Vec::new();
    if has_z {
        let range = if is_point { 0 } else { 2 };
        z.extend(bytes.numbers(range + count, "heights")?.skip(range));
    }
    let mut m = Vec::new();
    // Measures may be absent, except in a point with measure.
    if may_have_m && (!bytes.rest.is_empty() || code == 21) {
        let range = if is_point { 0 } else { 2 };
        m.extend(bytes.numbers(range + count, "measures")?.skip(range));
    }
    // If no position has a measure, the geometry has none.
    if has_z && m.iter().all(|m| *m <= NO_DATA) {
        m.clear();
    }
    let dimensions = Dimensions::with(has_z, !m.is_empty());
    let measure = |m: &f64| if *m <= NO_DATA { f64::NAN } else { *m };
    let mut positions = xy.chunks_exact(2).enumerate().map(|(i, xy)| Position {
        x: xy[0],
        y: xy[1],
        more: z.get(i).copied().into_iter().chain(m.get(i).map(measure)).collect(),
    });
    let shape = match base {
        Base::Point => Shape::Point(positions.next()),
        Base::MultiPoint => Shape::MultiPoint(positions.map(Some).collect()),
        Base::Line | Base::Polygon => {
            let mut lines = split(positions.collect(), &parts)?;
            match base {
                Base::Polygon => {
                    let mut polygons = polygons(lines);
                    match polygons.pop() {
                        Some(only) if polygons.is_empty() => Shape::Polygon(only),
                        last => {
                            polygons.extend(last);
                            Shape::MultiPolygon(polygons)
                        }
                    }
                }
                _ if lines.len() == 1 => Shape::Line(lines.pop().unwrap_or_default()),
                _ => Shape::MultiLine(lines),
            }
        }
    };
    Ok(Some(Geometry::new(dimensions, shape)))
}

/// Splits a list of positions at the starts of its parts.
fn split(mut positions: Vec<Position>, starts: &[usize]) -> Result<Vec<Line>, Cause> {
    let mut lines = Vec::with_capacity(starts.len());
    for start in starts.iter().rev() {
        if *start > positions.len() {
            return Err(Cause::Invalid(format!("a part starts at point {start}, after the end or the next part")));
        }
        lines.push(positions.split_off(*start));
    }
    if !positions.is_empty() {
        return Err(Cause::Invalid("the first part does not start at point 0".to_owned()));
    }
    lines.reverse();
    Ok(lines)
}

/// The smallest and largest coordinates, heights and measures.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bounds([Option<(f64, f64)>; 4]);

impl Bounds {
    fn take(&mut self, position: &Position, dimensions: Dimensions) {
        let more = |i: usize| position.more.get(i).copied();
        let (z, m) = match dimensions {
            Dimensions::Xy => (None, None),
            Dimensions::Xyz => (more(0), None),
            Dimensions::Xym => (None, more(0)),
            Dimensions::Xyzm => (more(0), more(1)),
        };
        let numbers = [Some(position.x), Some(position.y), z, m.filter(|m| !m.is_nan())];
        for (range, number) in self.0.iter_mut().zip(numbers) {
            if let Some(number) = number {
                let (low, high) = range.unwrap_or((number, number));
                *range = Some((low.min(number), high.max(number)));
            }
        }
    }

    fn range(&self, dimension: usize) -> [f64; 2] {
        let (low, high) = self.0[dimension].unwrap_or_default();
        [low, high]
    }

    /// Appends the box, then the ranges of heights and of measures: 0 for an absent range.
    pub(super) fn append(&self, out: &mut Vec<u8>) {
        self.append_box(out);
        for number in [self.range(2), self.range(3)].into_iter().flatten() {
            out.extend(number.to_le_bytes());
        }
    }

    fn append_box(&self, out: &mut Vec<u8>) {
        let [[x0, x1], [y0, y1]] = [self.range(0), self.range(1)];
        for number in [x0, y0, x1, y1] {
            out.extend(number.to_le_bytes());
        }
    }
}

/// Appends a record, whose geometry is of the kind of the file. A missing geometry, and one without positions, is a null shape.
pub(super) fn append(geometry: Option<&Geometry>, kind: ShapeKind, bounds: &mut Bounds, out: &mut Vec<u8>) {
    let Some(geometry) = geometry.filter(|geometry| !geometry.shape.is_empty()) else {
        out.extend(0_i32.to_le_bytes());
        return;
    };
    out.extend(kind.code().to_le_bytes());
    let lines: Vec<Line> = match &geometry.shape {
        Shape::Point(point) => vec![point.iter().cloned().collect()],
        Shape::MultiPoint(points) => vec![points.iter().flatten().cloned().collect()],
        Shape::Line(line) => vec![line.clone()],
        Shape::MultiLine(lines) => lines.clone(),
        Shape::Polygon(rings) => written_rings([rings.as_slice()]),
        Shape::MultiPolygon(polygons) => written_rings(polygons.iter().map(Vec::as_slice)),
        // The kind of the file excludes collections.
        Shape::Collection(_) => Vec::new(),
    };
    let count: usize = lines.iter().map(Vec::len).sum();
    let mut own = Bounds::default();
    for position in lines.iter().flatten() {
        own.take(position, geometry.dimensions);
        bounds.take(position, geometry.dimensions);
    }
    if kind.base != Base::Point {
        own.append_box(out);
        if kind.base != Base::MultiPoint {
            out.extend((lines.len() as u32).to_le_bytes());
        }
        out.extend((count as u32).to_le_bytes());
        if kind.base != Base::MultiPoint {
            let mut start = 0_u32;
            for line in &lines {
                out.extend(start.to_le_bytes());
                start += line.len() as u32;
            }
        }
    }
    for position in lines.iter().flatten() {
        out.extend(position.x.to_le_bytes());
        out.extend(position.y.to_le_bytes());
    }
    let has_z = matches!(geometry.dimensions, Dimensions::Xyz | Dimensions::Xyzm);
    let m_at = usize::from(has_z);
    let has_m = matches!(geometry.dimensions, Dimensions::Xym | Dimensions::Xyzm);
    let mut column = |range: [f64; 2], value: &dyn Fn(&Position) -> f64| {
        if kind.base != Base::Point {
            for number in range {
                out.extend(number.to_le_bytes());
            }
        }
        for position in lines.iter().flatten() {
            out.extend(value(position).to_le_bytes());
        }
    };
    if kind.has_z {
        column(own.range(2), &|p| p.more.first().copied().filter(|_| has_z).unwrap_or_default());
    }
    if kind.has_m || kind.has_z {
        // Below the smallest measure.
        let none = 10.0 * NO_DATA;
        let measure = |p: &Position| p.more.get(m_at).copied().filter(|m| has_m && !m.is_nan());
        let range = if has_m { own.range(3) } else { [none; 2] };
        column(range, &|p| measure(p).unwrap_or(none));
    }
}
