//! The builder's findings in its input: counts, and the places of irregularities.

use core::fmt;
use twinedge_geometry::Point;

/// A place in the input.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Position {
    /// The feature, counted from 0.
    pub feature: usize,
    /// The shape in the feature.
    pub shape: usize,
    /// The ring in the shape, for a polygon.
    pub ring: usize,
    /// The point in the ring or line.
    pub point: usize,
}

impl fmt::Display for Position {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "feature {}, shape {}, ring {}, point {}", self.feature, self.shape, self.ring, self.point)
    }
}

/// A kind of irregularity of a ring or a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum IrregularityKind {
    /// A point repeats the one before it.
    RepeatedPoint,
    /// The last point of a ring does not repeat the first; the ring was closed.
    OpenRing,
    /// A ring with fewer than three consecutive different points encloses nothing.
    DegenerateRing,
    /// An outer ring turns clockwise, or a hole counter-clockwise.
    WoundWrongly,
    /// A ring visits a point twice, apart from spikes.
    SelfTouching,
    /// A ring turns straight back.
    Spike,
}

impl fmt::Display for IrregularityKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::RepeatedPoint => "repeated point",
            Self::OpenRing => "open ring",
            Self::DegenerateRing => "ring that encloses nothing",
            Self::WoundWrongly => "ring wound the wrong way",
            Self::SelfTouching => "ring that touches itself",
            Self::Spike => "spike",
        })
    }
}

/// An irregularity with its location.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Irregularity {
    /// The kind.
    pub kind: IrregularityKind,
    /// The place in the input: the point that shows the irregularity, or the first point of the ring if no single point does.
    pub position: Position,
    /// The coordinates.
    pub at: Point,
}

/// Counts and irregularities that the builder found in its input.
///
/// All of this is legal input and is built as given. The counts help to find mistakes.
///
/// ```
/// use twinedge_map::{Builder, IrregularityKind, Shape};
///
/// // Clockwise, and not closed.
/// let ring = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]];
/// let mut builder = Builder::new();
/// builder.shape(&Shape::Polygon(vec![ring.map(Into::into).to_vec()]))?;
/// let map = builder.build()?;
/// assert_eq!((map.summary().open_rings, map.summary().rings_wound_wrongly), (1, 1));
/// assert_eq!(map.summary().irregularities[0].kind, IrregularityKind::OpenRing);
/// assert_eq!(map.summary().irregularities[0].position.point, 2);
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BuildSummary {
    /// Features added.
    pub features: usize,
    /// Segments of rings and lines in the input, before any was dropped.
    pub segments: usize,
    /// Segments dropped because they repeat another one, in either direction.
    pub duplicate_segments: usize,
    /// Segments dropped because both ends are the same point.
    pub zero_length_segments: usize,
    /// Rings whose last point does not repeat the first, and which were closed.
    pub open_rings: usize,
    /// Rings with fewer than three consecutive different points, which enclose nothing.
    pub degenerate_rings: usize,
    /// Outer rings that turn clockwise and holes that turn counter-clockwise; the area of a polygon does not depend on it.
    pub rings_wound_wrongly: usize,
    /// Rings that visit a point twice, apart from spikes.
    pub self_touching_rings: usize,
    /// Points at which a ring turns straight back, except in rings that enclose nothing.
    pub spikes: usize,
    /// The first [`BuildSummary::LISTED`] irregularities of each kind, in order of input.
    pub irregularities: Vec<Irregularity>,
}

impl BuildSummary {
    /// The greatest number of listed irregularities of each kind.
    pub const LISTED: usize = 20;

    pub(super) fn list(&mut self, count: usize, kind: IrregularityKind, position: Position, at: Point) {
        if count <= Self::LISTED {
            self.irregularities.push(Irregularity { kind, position, at });
        }
    }
}
