//! Simpler edits of the same kind.

use super::op::EditOp;
use super::pick::{
    AtPick, FeaturesPick, GridPick, MapFacePick, MapHalfEdgePick, MapVertexPick, Number, RingPick, Spot,
};
use super::table::edits;
use crate::program::simpler::smaller;

/// An argument in every way in which it is simpler, the simplest first.
trait Simpler: Sized {
    fn simpler(&self) -> Vec<Self>;
}

macro_rules! define_simpler {
    ($($variant:ident $method:ident $share:literal { $($arg:ident: $pick:ty;)* })*) => {
        impl EditOp {
            /// The same edit with one argument simplified, in every way there is.
            #[must_use]
            pub fn simpler(&self) -> Vec<Self> {
                #[allow(unused_mut, reason = "an edit may have no arguments")]
                let mut all = Vec::new();
                match self {
                    $(Self::$variant { $($arg),* } => {
                        $(all.extend(Simpler::simpler($arg).into_iter().map(|simpler| {
                            let mut op = self.clone();
                            if let Self::$variant { $arg, .. } = &mut op {
                                *$arg = simpler;
                            }
                            op
                        }));)*
                    })*
                }
                all
            }
        }
    };
}
edits!(define_simpler);

fn map<T, U>(all: Vec<T>, f: impl FnMut(T) -> U) -> Vec<U> {
    all.into_iter().map(f).collect()
}

/// Every step goes down in (whether it is whole and small, how many bits it takes, magnitude, sign), so shrinking ends.
impl Simpler for Number {
    fn simpler(&self) -> Vec<Self> {
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
        let mut seen: Vec<Self> = vec![*self];
        for number in all.into_iter().map(Self::from) {
            if !seen.contains(&number) {
                seen.push(number);
            }
        }
        seen.remove(0);
        seen
    }
}

impl Simpler for Spot {
    fn simpler(&self) -> Vec<Self> {
        let mut all = map(self.x.simpler(), |x| Self { x, ..*self });
        all.extend(map(self.y.simpler(), |y| Self { y, ..*self }));
        all
    }
}

macro_rules! simpler_picks {
    ($($name:ident)*) => {$(
        impl Simpler for $name {
            fn simpler(&self) -> Vec<Self> {
                match *self {
                    Self::Live(k) => map(smaller(k), Self::Live),
                    Self::Retired(k) => {
                        let mut all = vec![Self::Live(k)];
                        all.extend(map(smaller(k), Self::Retired));
                        all
                    }
                }
            }
        }
    )*};
}
simpler_picks! { MapVertexPick MapHalfEdgePick MapFacePick }

impl Simpler for AtPick {
    fn simpler(&self) -> Vec<Self> {
        match *self {
            Self::Point(spot) => map(spot.simpler(), Self::Point),
            Self::Near(spot, hint) => {
                let mut all = vec![Self::Point(spot)];
                all.extend(map(hint.simpler(), |hint| Self::Near(spot, hint)));
                all.extend(map(spot.simpler(), |spot| Self::Near(spot, hint)));
                all
            }
            Self::Vertex(pick) => map(pick.simpler(), Self::Vertex),
        }
    }
}

impl Simpler for RingPick {
    /// Without one of its points, or with a simpler one.
    fn simpler(&self) -> Vec<Self> {
        let mut all = Vec::new();
        for i in 0..self.len() {
            let mut without = self.clone();
            without.remove(i);
            all.push(without);
        }
        for (i, at) in self.iter().enumerate() {
            all.extend(map(at.simpler(), |at| {
                let mut with = self.clone();
                with[i] = at;
                with
            }));
        }
        all
    }
}

impl Simpler for GridPick {
    fn simpler(&self) -> Vec<Self> {
        match *self {
            Self::Size(size) => {
                let one = Self::Size(Number::from(1.0));
                let mut all = map(size.simpler(), Self::Size);
                all.retain(|simpler| *simpler != one && *self != one);
                if *self != one {
                    all.insert(0, one);
                }
                all
            }
            Self::Auto => vec![Self::Size(Number::from(1.0))],
        }
    }
}

impl Simpler for FeaturesPick {
    fn simpler(&self) -> Vec<Self> {
        let mask = self.0;
        let bits = (0..16).map(|bit| 1 << bit).filter(|bit| mask & bit != 0 && *bit != mask);
        let none = (mask != 0).then_some(0);
        none.into_iter().chain(bits.map(|bit| mask & !bit)).map(Self).collect()
    }
}
