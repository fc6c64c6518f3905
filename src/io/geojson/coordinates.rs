//! Nested arrays of numbers.

use serde::de::SeqAccess;
use serde_json::Number;

use super::error::{Fault, Place};
use super::json::{Any, Value, skip_array};
use super::scan::Scan;
use crate::geometry::{Point, Shape};

/// The kinds of geometry that have coordinates.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Point,
    MultiPoint,
    Line,
    MultiLine,
    Polygon,
    MultiPolygon,
}

impl Kind {
    /// The level of brackets at which the positions stand.
    fn level(self) -> usize {
        match self {
            Self::Point => 1,
            Self::MultiPoint | Self::Line => 2,
            Self::MultiLine | Self::Polygon => 3,
            Self::MultiPolygon => DEEPEST,
        }
    }
}

/// The level at which the positions of a multi-polygon stand.
const DEEPEST: usize = 4;

/// The coordinates of one geometry of a kind not yet known, since `"type"` may come after `"coordinates"`.
///
/// All positions lie in one row. Arrays that are not positions are only kept as their ends in that row:
///
/// ```text
///     level 1 [                                                 ]
///     level 2  [            ] [        ]    groups: ends of these
///     level 3   [    ] [   ]   [      ]     rings:  ends of these, unless they are the positions
/// ```
#[derive(Default)]
pub(super) struct Coordinates {
    points: Vec<Point>,
    /// The level and place of the first position; all others stand at the same level.
    level: Option<(usize, Place)>,
    /// How many points and how many rings there were at the end of each array of level 2.
    groups: Vec<(usize, usize)>,
    /// How many points there were at the end of each array of level 3.
    rings: Vec<usize>,
    /// The place of the first empty array of each level. It may be a position without numbers or a ring without
    /// positions: the kind of the geometry decides.
    empty: [Option<Place>; DEEPEST],
}

impl Coordinates {
    /// How deep arrays may lie, as far as is known.
    fn limit(&self) -> usize {
        self.level.map_or(DEEPEST, |(level, _)| level)
    }

    /// Ends an array of this level that is no position.
    fn close(&mut self, level: usize) {
        match level {
            2 => self.groups.push((self.points.len(), self.rings.len())),
            3 => self.rings.push(self.points.len()),
            _ => {}
        }
    }

    /// Appends the shapes that a geometry of this kind draws with these coordinates, and nothing if it draws nothing.
    /// O(positions).
    pub(super) fn draw(self, kind: Kind, shapes: &mut Vec<Shape>) -> Result<(), (Place, Fault)> {
        let expected = kind.level();
        if let Some((found, at)) = self.level
            && found != expected
        {
            return Err((at, Fault::Nesting { expected, found }));
        }
        for (found, at) in (1..).zip(self.empty) {
            let Some(at) = at else { continue };
            if found > expected {
                return Err((at, Fault::Nesting { expected, found }));
            }
            // A point without numbers is an empty geometry, and RFC 7946 (3.1) lets us take it as none.
            if found == expected && kind != Kind::Point {
                return Err((at, Fault::ShortPosition { numbers: 0 }));
            }
        }
        let Self { points, groups, rings, .. } = self;
        match kind {
            Kind::Point | Kind::MultiPoint => shapes.extend(points.into_iter().map(Shape::Point)),
            Kind::Line => shapes.extend(Some(points).filter(|line| !line.is_empty()).map(Shape::Line)),
            Kind::MultiLine => {
                let lines = split(&points, groups.iter().map(|&(end, _)| end));
                shapes.extend(lines.filter(|line| !line.is_empty()).map(<[Point]>::to_vec).map(Shape::Line));
            }
            Kind::Polygon => {
                let rings: Vec<_> = split(&points, groups.iter().map(|&(end, _)| end)).map(<[Point]>::to_vec).collect();
                shapes.extend(Some(rings).filter(|rings| !rings.is_empty()).map(Shape::Polygon));
            }
            Kind::MultiPolygon => {
                let mut all = split(&points, rings.iter().copied()).map(<[Point]>::to_vec);
                let mut start = 0;
                for (_, end) in groups {
                    let rings: Vec<_> = all.by_ref().take(end - start).collect();
                    start = end;
                    shapes.extend(Some(rings).filter(|rings| !rings.is_empty()).map(Shape::Polygon));
                }
            }
        }
        Ok(())
    }
}

/// Cuts a row of points at these ends, which never fall and never pass its length.
fn split(points: &[Point], ends: impl Iterator<Item = usize>) -> impl Iterator<Item = &[Point]> {
    let mut start = 0;
    ends.map(move |end| {
        let part = &points[start..end];
        start = end;
        part
    })
}

/// What stands at one place of the coordinates; a number is handed back, as it may be the x of a position.
struct Element<'s, 'p> {
    scan: &'s mut Scan<'p>,
    out: &'s mut Coordinates,
    /// The level that an array found here has.
    level: usize,
}

impl Value for Element<'_, '_> {
    type Out = Option<f64>;

    fn other(self) -> Option<f64> {
        self.scan.fail(self.scan.here(), Fault::NotANumber);
        None
    }

    fn number(self, number: &Number) -> Option<f64> {
        let finite = number.as_f64().filter(|value| value.is_finite());
        if finite.is_none() {
            self.scan.fail(self.scan.here(), Fault::OutOfRange);
        }
        finite
    }

    fn array<'de, A: SeqAccess<'de>>(self, mut array: A) -> Result<Option<f64>, A::Error> {
        let Self { scan, out, level } = self;
        let at = scan.here();
        let expected = out.limit();
        if level > expected {
            scan.fail(at, Fault::Nesting { expected, found: level });
        }
        // From here on `level` is at most `DEEPEST`, which bounds the recursion.
        if scan.failed() {
            skip_array(&mut array)?;
            return Ok(None);
        }
        let level_below = level + 1;
        match array.next_element_seed(Any(Element { scan, out, level: level_below }))? {
            None => {
                out.empty[level - 1].get_or_insert(at);
                out.close(level);
            }
            Some(Some(x)) => {
                if out.level.is_none() {
                    out.level = Some((level, at));
                }
                let expected = out.limit();
                if level != expected {
                    scan.fail(at, Fault::Nesting { expected, found: level });
                }
                let mut numbers = 1;
                let mut y = None;
                while let Some(number) = array.next_element_seed(Any(Element { scan, out, level: level_below }))? {
                    numbers += 1;
                    if numbers == 2 {
                        y = number;
                    }
                }
                match y {
                    Some(y) => out.points.push(Point { x, y }),
                    None => scan.fail(at, Fault::ShortPosition { numbers }),
                }
                scan.with_extra_dimensions += usize::from(numbers > 2);
            }
            Some(None) => {
                while let Some(number) = array.next_element_seed(Any(Element { scan, out, level: level_below }))? {
                    if number.is_some() {
                        let expected = out.limit();
                        scan.fail(scan.here(), Fault::Nesting { expected, found: level });
                    }
                }
                out.close(level);
            }
        }
        Ok(None)
    }
}

/// The value of a member `"coordinates"`.
pub(super) struct Whole<'s, 'p> {
    pub(super) scan: &'s mut Scan<'p>,
    pub(super) out: &'s mut Coordinates,
}

impl Value for Whole<'_, '_> {
    type Out = ();

    fn other(self) {
        self.scan.fail(self.scan.here(), Fault::NotAnArray { member: "coordinates" });
    }

    fn array<'de, A: SeqAccess<'de>>(self, array: A) -> Result<(), A::Error> {
        Element { scan: self.scan, out: self.out, level: 1 }.array(array).map(drop)
    }
}
