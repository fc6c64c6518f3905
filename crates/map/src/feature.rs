//! Features as read from a map file, before a map is built from them.

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;

use crate::construct::BuildError;
use crate::summary::Position;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::in_range;

/// One part of a feature, as in its file.
///
/// Shapes are neither repaired nor refused here: rings may be open, wind either way, cross themselves or have no area. The
/// [`Builder`](super::Builder) handles and counts such cases.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// The outer ring, then the rings of the holes. The last point of a ring should repeat its first: C6 reports an open ring.
    Polygon(Vec<Vec<Point>>),
    /// A chain of straight segments.
    Line(Vec<Point>),
    /// A single point.
    Point(Point),
}

impl Shape {
    /// Creates a polygon with this outer ring and no holes. Repeats the first point at the end if the ring is open.
    ///
    /// ```
    /// use twinedge_map::Shape;
    ///
    /// let square = Shape::polygon([[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]]);
    /// let with_hole = square.hole([[3.0, 3.0], [3.0, 6.0], [6.0, 6.0], [6.0, 3.0]]);
    /// assert!(matches!(with_hole, Shape::Polygon(rings) if rings.len() == 2 && rings[1].len() == 5));
    /// ```
    #[must_use]
    pub fn polygon(outer: impl IntoIterator<Item = impl Into<Point>>) -> Self {
        Self::Polygon(alloc::vec![closed(outer)])
    }

    /// Adds a hole to a polygon, closed in the same way. Lines and points are unchanged.
    #[must_use]
    pub fn hole(mut self, ring: impl IntoIterator<Item = impl Into<Point>>) -> Self {
        if let Self::Polygon(rings) = &mut self {
            rings.push(closed(ring));
        }
        self
    }

    /// Creates a chain of segments through these points.
    #[must_use]
    pub fn line(along: impl IntoIterator<Item = impl Into<Point>>) -> Self {
        Self::Line(points(along))
    }
}

fn closed(ring: impl IntoIterator<Item = impl Into<Point>>) -> Vec<Point> {
    let mut ring = points(ring);
    ring.extend(ring.first().copied().filter(|first| ring.last() != Some(first)));
    ring
}

fn points(from: impl IntoIterator<Item = impl Into<Point>>) -> Vec<Point> {
    from.into_iter().map(Into::into).collect()
}

/// Shapes that belong together, such as the parts of one country.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Feature {
    /// The name.
    pub name: Option<String>,
    /// The id in the file.
    pub id: Option<String>,
    /// The parts, in the order of the file; empty if the feature has no geometry.
    pub shapes: Vec<Shape>,
}

impl Feature {
    /// Returns all points, as often as they are drawn.
    ///
    /// ```
    /// use twinedge_map::{Feature, Shape};
    ///
    /// let square = Shape::polygon([[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]]);
    /// let feature = Feature { shapes: vec![square, Shape::line([[1.0, 1.0], [2.0, 1.0]])], ..Feature::default() };
    /// assert_eq!(feature.points().count(), 7);
    /// ```
    pub fn points(&self) -> impl Iterator<Item = Point> + '_ {
        self.shapes.iter().flat_map(|shape| -> Box<dyn Iterator<Item = Point> + '_> {
            match shape {
                Shape::Polygon(rings) => Box::new(rings.iter().flatten().copied()),
                Shape::Line(points) => Box::new(points.iter().copied()),
                Shape::Point(point) => Box::new(core::iter::once(*point)),
            }
        })
    }

    /// Checks that all coordinates are in the range in which predicates are exact. `number` is the feature's number in its map. O(points).
    ///
    /// # Errors
    /// [`BuildError::NotFinite`] and [`BuildError::OutOfRange`], with the position.
    pub fn check(&self, number: usize) -> Result<(), BuildError> {
        let point = |p: &Point, position: Position| {
            let (x, y) = (p.x, p.y);
            if in_range(*p) {
                Ok(())
            } else if !x.is_finite() || !y.is_finite() {
                Err(BuildError::NotFinite { position, x, y })
            } else {
                Err(BuildError::OutOfRange { position, x, y })
            }
        };
        let chain = |points: &[Point], at: Position| {
            points.iter().enumerate().try_for_each(|(i, p)| point(p, Position { point: i, ..at }))
        };
        self.shapes.iter().enumerate().try_for_each(|(shape, what)| {
            let at = Position { feature: number, shape, ..Position::default() };
            match what {
                Shape::Polygon(rings) => {
                    rings.iter().enumerate().try_for_each(|(ring, points)| chain(points, Position { ring, ..at }))
                }
                Shape::Line(points) => chain(points, at),
                Shape::Point(p) => point(p, at),
            }
        })
    }
}
