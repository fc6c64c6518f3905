//! Simpler operators of the same kind.

use super::op::{CornerPick, FacePick, HalfEdgePick, InnerPick, Op, SecondPick, VertexPick};
use super::table::operators;
use crate::dcel::{Corner, Side, Turn};
use alloc::vec;
use alloc::vec::Vec;

macro_rules! define_simpler {
    ($($variant:ident $method:ident $share:literal {
        changes [$($change:expr),+]
        $($arg:ident: $pick:ty => $handle:ty, $depends:tt;)*
    })*) => {
        impl Op {
            /// The same operator with one argument simplified, in every way there is.
            #[must_use]
            pub fn simpler(self) -> Vec<Self> {
                let mut all = Vec::new();
                match self {
                    $(Self::$variant { $($arg),* } => {
                        simpler_arguments!(all, $variant, [$($arg)*], $($arg)*);
                    })*
                }
                all
            }
        }
    };
}

/// Simplifies one argument after the other; the rest stay as they are.
macro_rules! simpler_arguments {
    ($all:ident, $variant:ident, $args:tt, $($arg:ident)*) => {
        $(simpler_arguments!(@one $all, $variant, $args, $arg);)*
    };
    (@one $all:ident, $variant:ident, [$($args:ident)*], $arg:ident) => {
        for $arg in $arg.simpler() {
            $all.push(Self::$variant { $($args),* });
        }
    };
}
operators!(define_simpler);

/// An argument in every way in which it is simpler, the simplest first.
trait Simpler: Sized {
    fn simpler(self) -> Vec<Self>;
}

fn map<T, U>(all: Vec<T>, f: impl FnMut(T) -> U) -> Vec<U> {
    all.into_iter().map(f).collect()
}

/// Smaller numbers, the smallest first. Two less keeps the side of an edge, which one less and the half may not.
pub(crate) fn smaller(k: u16) -> Vec<u16> {
    let mut all = vec![0, 1, k / 2, k.saturating_sub(2), k.saturating_sub(1)];
    all.sort_unstable();
    all.dedup();
    all.retain(|smaller| *smaller < k);
    all
}

impl Simpler for HalfEdgePick {
    fn simpler(self) -> Vec<Self> {
        match self {
            HalfEdgePick::Live(k) => map(smaller(k), HalfEdgePick::Live),
            HalfEdgePick::Retired(k) => {
                let mut all = vec![HalfEdgePick::Live(k)];
                all.extend(map(smaller(k), HalfEdgePick::Retired));
                all
            }
        }
    }
}

impl Simpler for VertexPick {
    fn simpler(self) -> Vec<Self> {
        let (k, same): (u16, fn(u16) -> VertexPick) = match self {
            VertexPick::Isolated(k) => return map(smaller(k), VertexPick::Isolated),
            VertexPick::OriginOf(k) => (k, VertexPick::OriginOf),
            VertexPick::Retired(k) => (k, VertexPick::Retired),
        };
        let mut all = vec![VertexPick::Isolated(k)];
        all.extend(map(smaller(k), same));
        all
    }
}

impl Simpler for CornerPick {
    fn simpler(self) -> Vec<Self> {
        match self {
            Corner::At(pick) => map(pick.simpler(), Corner::At),
            Corner::Isolated(pick) => map(pick.simpler(), Corner::Isolated),
        }
    }
}

impl Simpler for SecondPick {
    fn simpler(self) -> Vec<Self> {
        match self {
            SecondPick::Fitting(k) => map(smaller(k), SecondPick::Fitting),
            SecondPick::Any(pick) => {
                let mut all = vec![SecondPick::Fitting(0), SecondPick::Fitting(1)];
                all.extend(map(pick.simpler(), SecondPick::Any));
                all
            }
        }
    }
}

impl Simpler for FacePick {
    fn simpler(self) -> Vec<Self> {
        let mut all = vec![FacePick::Unbounded];
        match self {
            FacePick::Unbounded => all.clear(),
            FacePick::Of(pick) => all.extend(map(pick.simpler(), FacePick::Of)),
            FacePick::Retired(k) => all.extend(map(smaller(k), FacePick::Retired)),
        }
        all
    }
}

impl Simpler for InnerPick {
    fn simpler(self) -> Vec<Self> {
        let InnerPick { mask, also } = self;
        let mut all = Vec::new();
        if also.is_some() && mask != 0 {
            all.push(InnerPick::default());
        }
        if let Some(pick) = also {
            all.push(InnerPick { mask, also: None });
            all.extend(map(pick.simpler(), |pick| InnerPick { mask, also: Some(pick) }));
        }
        let bits = (0..16).map(|bit| 1 << bit).filter(|bit| mask & bit != 0 && *bit != mask);
        all.extend(
            (mask != 0)
                .then_some(0)
                .into_iter()
                .chain(bits.map(|bit| mask & !bit))
                .map(|mask| InnerPick { mask, also }),
        );
        all
    }
}

impl Simpler for Side {
    fn simpler(self) -> Vec<Self> {
        if self == Self::Right { vec![Self::Left] } else { Vec::new() }
    }
}

impl Simpler for Turn {
    fn simpler(self) -> Vec<Self> {
        if self == Self::Clockwise { vec![Self::CounterClockwise] } else { Vec::new() }
    }
}
