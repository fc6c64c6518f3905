//! Numbers and points of edits: compared by their bits, drawn, and made simpler.

use crate::geometry::Point;
use crate::program::choose::Choose;
use core::fmt;

/// A number that is equal to itself, NaN included: two are equal if their bits are, and all NaNs are one.
#[derive(Clone, Copy, Debug, Default)]
pub struct Number(f64);

impl Number {
    /// The number.
    #[must_use]
    pub const fn get(self) -> f64 {
        self.0
    }

    /// Mostly of a small grid, where points coincide and segments cross; else close to it, near the ends of the range, or any bits
    /// at all.
    pub(super) fn draw(source: &mut impl Choose) -> Self {
        let grid = source.choose(8) as f64;
        Self::from(match source.choose(64) {
            1 => f64::from_bits((0..8).fold(0, |bits, _| bits << 8 | source.choose(256) as u64)),
            2 => grid.next_up(),
            3 => grid.next_down(),
            4 => grid / 3.0,
            5 => grid * 2.0_f64.powi(495),
            6 => grid * 2.0_f64.powi(-399),
            7 => -grid,
            8 => grid + 0.5,
            9 => [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][source.choose(3)],
            _ => grid,
        })
    }

    /// The number in every way in which it is simpler, the simplest first. Every step goes down in (whether it is whole and small, how
    /// many bits it takes, magnitude, sign), so shrinking ends.
    pub(super) fn simpler(self) -> Vec<Self> {
        let x = self.get();
        if x.to_bits() == 0 {
            return Vec::new();
        }
        let mut all = vec![0.0];
        if x.is_nan() {
            return vec![Self::default()];
        }
        let small = x.abs() < 2.0_f64.powi(53);
        if small && x.fract() == 0.0 {
            if x.abs() > 1.0 {
                all.extend([(x / 2.0).trunc(), x - 1.0_f64.copysign(x)]);
            }
        } else {
            all.push(1.0_f64.copysign(x));
            if small {
                all.extend([x.trunc(), (2.0 * x).trunc() / 2.0]);
            }
            // Half of the bits.
            let bits = x.to_bits();
            let mantissa = bits & ((1 << 52) - 1);
            if x.is_finite() && mantissa != 0 {
                let zeros = mantissa.trailing_zeros();
                let cleared = zeros + (52 - zeros).div_ceil(2);
                all.push(f64::from_bits(bits >> cleared << cleared));
            }
        }
        if x.is_sign_negative() {
            all.push(-x);
        }
        let mut seen: Vec<Self> = vec![self];
        for number in all.into_iter().map(Self::from) {
            if !seen.contains(&number) {
                seen.push(number);
            }
        }
        seen.remove(0);
        seen
    }
}

/// The shortest digits that are read as this number.
impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = format!("{:?}", self.get());
        f.write_str(text.strip_suffix(".0").unwrap_or(&text))
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

impl fmt::Display for Spot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{}", self.x, self.y)
    }
}
