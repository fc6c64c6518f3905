//! Quantities, which can be shared and summed.

/// A value that can be shared between the parts of a split record, and summed when records merge.
///
/// Implemented for the usual numbers; you can implement it for your own types.
///
/// ```
/// use twinedge::dcel::Quantity;
///
/// assert_eq!(8.0_f64.share(0.25), [6.0, 2.0]);
/// // Nothing is lost by rounding.
/// assert_eq!(7_u32.share(0.5), [3, 4]);
/// ```
pub trait Quantity: Sized {
    /// Returns the shares of the remaining part and of the other part, which gets the fraction `part`, from 0 to 1.
    #[must_use]
    fn share(&self, part: f64) -> [Self; 2];

    /// Returns the sum. Integers saturate.
    #[must_use]
    fn sum(&self, other: &Self) -> Self;

    /// Returns the value at the fraction `part`, from 0 to 1, of the way to another value.
    #[must_use]
    fn between(&self, other: &Self, part: f64) -> Self {
        self.share(part)[0].sum(&other.share(part)[1])
    }
}

macro_rules! floats {
    ($($name:ident)*) => {$(
        impl Quantity for $name {
            fn share(&self, part: f64) -> [Self; 2] {
                let given = self * part as $name;
                [self - given, given]
            }

            fn sum(&self, other: &Self) -> Self {
                self + other
            }
        }
    )*};
}

macro_rules! integers {
    ($($name:ident)*) => {$(
        impl Quantity for $name {
            #[allow(clippy::cast_lossless, clippy::cast_sign_loss, reason = "for all integers; the share of a number without sign has none")]
            fn share(&self, part: f64) -> [Self; 2] {
                // The cast saturates; adding a half rounds, without the standard library.
                let given = (*self as f64 * part + if *self < 0 as $name { -0.5 } else { 0.5 }) as $name;
                let given = if part >= 1.0 { *self } else if part <= 0.0 { 0 } else { given };
                [self.saturating_sub(given), given]
            }

            fn sum(&self, other: &Self) -> Self {
                self.saturating_add(*other)
            }
        }
    )*};
}

floats! { f32 f64 }
integers! { u32 u64 usize i32 i64 }
