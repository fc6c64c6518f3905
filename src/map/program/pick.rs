//! What edits choose by: numbers of records, points, grids, features.

use crate::geometry::Point;
use crate::geometry::noding::Snap;

/// A number that is equal to itself, NaN included: two are equal if their bits are, and all NaNs are one.
#[derive(Clone, Copy, Debug, Default)]
pub struct Number(f64);

impl Number {
    /// The number.
    #[must_use]
    pub const fn get(self) -> f64 {
        self.0
    }
}

impl From<f64> for Number {
    fn from(number: f64) -> Self {
        Self(if number.is_nan() { f64::NAN } else { number })
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.0.to_bits() == other.0.to_bits()
    }
}

impl Eq for Number {}

impl core::hash::Hash for Number {
    fn hash<H: core::hash::Hasher>(&self, state: &mut H) {
        self.0.to_bits().hash(state);
    }
}

/// A point by its coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Spot {
    /// The first coordinate.
    pub x: Number,
    /// The second coordinate.
    pub y: Number,
}

impl Spot {
    /// The point with these coordinates.
    #[must_use]
    pub fn new(x: f64, y: f64) -> Self {
        Self { x: x.into(), y: y.into() }
    }

    /// The point.
    #[must_use]
    pub const fn point(self) -> Point {
        Point::new(self.x.get(), self.y.get())
    }
}

macro_rules! define_picks {
    ($($name:ident $what:literal)*) => {$(
        #[doc = concat!("Chooses a ", $what, " of a map by its position in order of creation, modulo their number.")]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $name {
            /// Of those there are.
            Live(u16),
            /// Of those that were removed: a stale key, on purpose.
            Retired(u16),
        }
    )*};
}
define_picks! { MapVertexPick "vertex" MapHalfEdgePick "half-edge" MapFacePick "face" }

/// Chooses a point, and what is known of where it lies: see [`At`](crate::map::edit::At).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AtPick {
    /// Anywhere.
    Point(Spot),
    /// A point, and a half-edge to search from.
    Near(Spot, MapHalfEdgePick),
    /// Where this vertex is.
    Vertex(MapVertexPick),
}

/// The points of a ring.
pub type RingPick = Vec<AtPick>;

/// Chooses a grid: see [`Snap`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum GridPick {
    /// [`Snap::Auto`].
    Auto,
    /// [`Snap::Size`].
    Size(Number),
}

impl GridPick {
    /// The grid.
    #[must_use]
    pub const fn snap(self) -> Snap {
        match self {
            Self::Auto => Snap::Auto,
            Self::Size(size) => Snap::Size(size.get()),
        }
    }
}

/// Chooses features: feature `i` if bit `i` is set, whether the map has so many or not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct FeaturesPick(pub u16);
