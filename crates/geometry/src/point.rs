//! A point of the plane.

/// A point of the plane.
///
/// Points are equal if their coordinates are, so `-0.0` equals `0.0`, and a point with a NaN equals nothing, not even itself. The
/// builder of `twinedge-map` refuses coordinates that are not finite and turns `-0.0` into `0.0`.
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
    /// Creates the point with these coordinates.
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// Returns a key for hash tables, equal for equal points: −0 counts as 0.
    #[inline]
    #[must_use]
    pub fn hash_key(self) -> (u64, u64) {
        // Adding zero turns −0 into 0.
        (folded((self.x + 0.0).to_bits()), folded((self.y + 0.0).to_bits()))
    }

    /// Returns the point with this key.
    #[must_use]
    pub fn of_hash_key((x, y): (u64, u64)) -> Self {
        // Folding is its own inverse: the upper half is unchanged.
        Self::new(f64::from_bits(folded(x)), f64::from_bits(folded(y)))
    }
}

/// Folds the upper half of the bits into the lower half. Different numbers stay different.
///
/// `FxHasher` multiplies, which carries no bit downwards. Coordinates that are small integers, or multiples of a power of two,
/// end in zeros, and most of them would share a hash.
#[inline]
pub(crate) const fn folded(bits: u64) -> u64 {
    bits ^ (bits >> 32)
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

#[cfg(test)]
mod tests;
