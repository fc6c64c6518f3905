//! Features as read from a map file, before a map is built from them.

use alloc::string::String;
use alloc::vec::Vec;

use twinedge_geometry::Point;

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
