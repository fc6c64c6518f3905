//! Features: what a map file says, before anything is built from it, and their numbers on a map.

use alloc::string::String;
use alloc::vec::Vec;

use twinedge_geometry::Point;

/// One part of a feature, as its file gives it.
///
/// Nothing is repaired or refused here: rings may be open, wind either way, cross themselves or have no area. The
/// [`Builder`](super::Builder) handles and counts that.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// The outer ring, then the rings of the holes. The last point of a ring should repeat its first: C6 reports an open ring.
    Polygon(Vec<Vec<Point>>),
    /// A chain of straight segments.
    Line(Vec<Point>),
    /// A point alone.
    Point(Point),
}

impl Shape {
    /// The polygon with this outer ring, and no holes. The ring is closed if its last point does not repeat the first.
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

    /// The same polygon with one more hole, closed in the same way. Lines and points stay as they are.
    #[must_use]
    pub fn hole(mut self, ring: impl IntoIterator<Item = impl Into<Point>>) -> Self {
        if let Self::Polygon(rings) = &mut self {
            rings.push(closed(ring));
        }
        self
    }

    /// The chain of segments through these points.
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
    /// Its name.
    pub name: Option<String>,
    /// Its id in the file.
    pub id: Option<String>,
    /// Its parts, in the order of the file; none if it has no place on the map.
    pub shapes: Vec<Shape>,
}
