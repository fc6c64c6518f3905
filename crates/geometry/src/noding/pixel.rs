//! Integer geometry: segments in whole steps, square pixels whose size is a power of two of steps, and exact tests between them.
//!
//! # Sizes
//!
//! A coordinate is at most 2^53 steps, so a difference of two is at most 2^54, and the difference of a doubled coordinate and a
//! doubled corner or centre of a block of pixels at most 2^56. Every product below multiplies one of these by a difference, at
//! most 2^110, and every sum of two products is at most 2^111: all fit in `i128`.

use core::cmp::Ordering;

pub(super) type Steps = [i64; 2];

/// A pixel, by its coordinates in the grid.
pub(super) type Pixel = [i64; 2];

/// A segment of positive length. `a` is the lexicographically smaller end, so the segment never leads to the left.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    pub(super) a: Steps,
    pub(super) b: Steps,
    pub(super) ends: [u32; 2],
}

impl Segment {
    /// Creates the segment between the centres of two pixels, in steps of one pixel.
    pub(super) fn between(vertices: &[Pixel], [p, q]: [u32; 2]) -> Self {
        let (at_p, at_q) = (vertices[p as usize], vertices[q as usize]);
        if at_p < at_q { Self { a: at_p, b: at_q, ends: [p, q] } } else { Self { a: at_q, b: at_p, ends: [q, p] } }
    }

    pub(super) fn direction(&self) -> [i64; 2] {
        minus(self.b, self.a)
    }

    /// Returns a number that orders vertices along the way from `a` to `b`, if the segment visits their pixels.
    ///
    /// A segment is monotone in both coordinates, and so is the pixel of a point moving along it. So among two pixels that it
    /// visits, the later one is at least as far in both directions, and farther in one.
    pub(super) fn progress(&self, pixel: Pixel) -> i64 {
        let [dx, dy] = self.direction();
        dx.signum() * pixel[0] + dy.signum() * pixel[1]
    }
}

pub(super) fn minus(p: [i64; 2], q: [i64; 2]) -> [i64; 2] {
    [p[0] - q[0], p[1] - q[1]]
}

/// Returns the cross product: positive if `e` points to the left of `d`.
pub(super) fn cross(d: [i64; 2], e: [i64; 2]) -> i128 {
    i128::from(d[0]) * i128::from(e[1]) - i128::from(d[1]) * i128::from(e[0])
}

/// A rectangle of pixels, both corners included.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    pub(super) low: Pixel,
    pub(super) high: Pixel,
}

impl Block {
    pub(super) fn one(pixel: Pixel) -> Self {
        Self { low: pixel, high: pixel }
    }

    #[expect(
        clippy::needless_bitwise_bool,
        reason = "which condition fails is unforeseeable, so there are no branches"
    )]
    pub(super) fn contains(&self, [x, y]: Pixel) -> bool {
        (self.low[0] <= x) & (x <= self.high[0]) & (self.low[1] <= y) & (y <= self.high[1])
    }

    pub(super) fn includes(&self, other: &Self) -> bool {
        self.contains(other.low) && self.contains(other.high)
    }

    #[expect(
        clippy::needless_bitwise_bool,
        reason = "which condition fails is unforeseeable, so there are no branches"
    )]
    pub(super) fn overlaps(&self, other: &Self) -> bool {
        let along = |axis: usize| (self.low[axis] <= other.high[axis]) & (other.low[axis] <= self.high[axis]);
        along(0) & along(1)
    }

    pub(super) fn join(&self, other: &Self) -> Self {
        Self {
            low: [self.low[0].min(other.low[0]), self.low[1].min(other.low[1])],
            high: [self.high[0].max(other.high[0]), self.high[1].max(other.high[1])],
        }
    }

    pub(super) fn meet(&self, other: &Self) -> Self {
        Self {
            low: [self.low[0].max(other.low[0]), self.low[1].max(other.low[1])],
            high: [self.high[0].min(other.high[0]), self.high[1].min(other.high[1])],
        }
    }
}

/// The grid that assigns positions to pixels: pixel `c` holds the positions from `c − 1/2` to below `c + 1/2` pixels, in each
/// direction. Every position is in one pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pixels {
    /// A pixel is 2^shift steps wide.
    pub(super) shift: u32,
}

impl Pixels {
    /// Pixels one step wide, each centred on the step of its name.
    pub(super) const ONE_STEP: Self = Self { shift: 0 };

    fn size(self) -> i64 {
        1 << self.shift
    }

    pub(super) fn at(self, position: Steps) -> Pixel {
        position.map(|p| self.along(p))
    }

    /// Returns the coordinate of the pixel that contains a position's coordinate.
    pub(super) fn along(self, position: i64) -> i64 {
        (position + (self.size() >> 1)) >> self.shift
    }

    /// Returns true if a coordinate is on the border of two pixels of more than a step.
    pub(super) fn is_border(self, position: i64) -> bool {
        (position + (self.size() >> 1)) & (self.size() - 1) == 0
    }

    pub(super) fn centre(self, pixel: Pixel) -> Steps {
        pixel.map(|c| c << self.shift)
    }

    pub(super) fn around(self, s: &Segment) -> Block {
        let (a, b) = (self.at(s.a), self.at(s.b));
        Block { low: [a[0], a[1].min(b[1])], high: [b[0], a[1].max(b[1])] }
    }

    /// Returns the corners of a block in doubled steps: left, lower, right, upper.
    pub(super) fn sides(self, block: &Block) -> [i64; 4] {
        let Block { low, high } = block;
        let size = self.size();
        [(2 * low[0] - 1) * size, (2 * low[1] - 1) * size, (2 * high[0] + 1) * size, (2 * high[1] + 1) * size]
    }

    /// Returns true if the line of a segment comes within half a pixel of the block, in each direction.
    ///
    /// This is the case if it meets the block, or if the line between the centres of the segment's end pixels meets it.
    pub(super) fn line_nears(self, s: &Segment, block: &Block) -> bool {
        let [left, lower, right, upper] = self.sides(block);
        let [dx, dy] = s.direction();
        // Twice the centre and twice the half extents are the sum and the difference of the doubled sides, halved.
        let centre = [i64::midpoint(left, right), i64::midpoint(lower, upper)];
        let (wide, tall) = ((right - left) / 2 + self.size(), (upper - lower) / 2 + self.size());
        let offset = cross([dx, dy], minus(centre, s.a.map(|c| 2 * c)));
        offset.abs() <= i128::from(wide) * i128::from(dy.abs()) + i128::from(tall) * i128::from(dx.abs())
    }

    /// Returns true if the segment visits the pixel.
    ///
    /// If the two overlap in each coordinate (with the half-open borders), the segment visits the pixel if its line enters the
    /// inside, that is, if the centre is nearer to the line than the farthest corner; or if it touches the lower left corner, the
    /// only one that belongs to the pixel. The same formula is valid for a segment along the left or lower side.
    pub(super) fn visits(self, s: &Segment, pixel: Pixel) -> bool {
        if !self.around(s).contains(pixel) {
            return false;
        }
        let [dx, dy] = s.direction();
        let offset = 2 * cross([dx, dy], minus(self.centre(pixel), s.a));
        let size = i128::from(self.size());
        offset.abs() < size * i128::from(dx.abs() + dy.abs()) || offset == size * i128::from(dx - dy)
    }

    pub(super) fn between_centres(self, s: &Segment) -> Segment {
        Segment { a: self.at(s.a), b: self.at(s.b), ends: s.ends }
    }

    /// Returns the pixel in which two segments cross, each in the interior of the other: `None` if they do not cross, if one ends
    /// on the other, or if they are collinear.
    pub(super) fn crossing(self, s: &Segment, t: &Segment) -> Option<Pixel> {
        let apart = |axis: usize| {
            s.a[axis].max(s.b[axis]) < t.a[axis].min(t.b[axis]) || t.a[axis].max(t.b[axis]) < s.a[axis].min(s.b[axis])
        };
        if apart(0) || apart(1) || s.a == t.a || s.b == t.b || s.a == t.b || s.b == t.a {
            return None;
        }
        let (d, e) = (s.direction(), t.direction());
        let (t_from, t_to) = (cross(d, minus(t.a, s.a)), cross(d, minus(t.b, s.a)));
        if t_from.signum() * t_to.signum() >= 0 {
            return None;
        }
        let (s_from, s_to) = (cross(e, minus(s.a, t.a)), cross(e, minus(s.b, t.a)));
        if s_from.signum() * s_to.signum() >= 0 {
            return None;
        }
        // The crossing divides `s` in the ratio of the distances of its ends from `t`.
        let (part, whole) = (s_from.unsigned_abs(), s_from.abs_diff(s_to));
        Some([0, 1].map(|axis| {
            let (floor, rest) = scale(d[axis], part, whole);
            let position = s.a[axis] + floor;
            if self.shift == 0 {
                position + i64::from(rest >= whole - rest)
            } else {
                // The border of a pixel is a whole step, so the fraction does not matter.
                self.along(position)
            }
        }))
    }
}

/// Returns `d * part / whole`, rounded down, and the remainder over `whole`. Requires `part < whole <= 2^111` and `|d| <= 2^54`.
///
/// Long division: consumes `d` from the top, using the number of bits for which the remainder has room.
fn scale(d: i64, part: u128, whole: u128) -> (i64, u128) {
    let digits = (whole.leading_zeros() - 1).min(32);
    let (mut quotient, mut rest) = (0_u128, 0_u128);
    let magnitude = d.unsigned_abs();
    let mut left = 64 - magnitude.leading_zeros();
    while left > 0 {
        let take = left.min(digits);
        left -= take;
        let digit = (magnitude >> left) & ((1 << take) - 1);
        let fed = (rest << take) + part * u128::from(digit);
        quotient = (quotient << take) + fed / whole;
        rest = fed % whole;
    }
    // `part < whole`, so the quotient is at most `|d|`.
    let quotient = quotient as i64;
    match (d < 0, rest) {
        (false, _) => (quotient, rest),
        (true, 0) => (-quotient, 0),
        (true, _) => (-quotient - 1, whole - rest),
    }
}

/// Compares fractions with positive denominators.
pub(super) fn compare((p, q): (i64, i64), (r, s): (i64, i64)) -> Ordering {
    (i128::from(p) * i128::from(s)).cmp(&(i128::from(r) * i128::from(q)))
}

#[cfg(test)]
mod tests;
