//! A point of the plane.

/// A point of the plane.
///
/// Equality is that of the coordinates, so `-0.0` equals `0.0` and a point with a NaN equals nothing, itself included. The
/// builders of this crate refuse coordinates that are not finite and turn `-0.0` into `0.0`.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(from = "[f64; 2]", into = "[f64; 2]"))]
pub struct Point {
    /// The first coordinate, growing to the right.
    pub x: f64,
    /// The second coordinate, growing upwards.
    pub y: f64,
}

impl Point {
    /// The point with these coordinates.
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }
}

impl From<[f64; 2]> for Point {
    fn from([x, y]: [f64; 2]) -> Self {
        Self { x, y }
    }
}

impl From<Point> for [f64; 2] {
    fn from(p: Point) -> Self {
        [p.x, p.y]
    }
}
