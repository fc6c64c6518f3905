//! Arguments by the choices of a source.

use super::pick::{
    AtPick, FeaturesPick, GridPick, MapFacePick, MapHalfEdgePick, MapVertexPick, Number, RingPick, Spot,
};
use crate::program::choose::Choose;

/// An argument that a source of choices draws.
pub(super) trait Draw {
    fn draw(source: &mut impl Choose) -> Self;
}

impl Draw for Number {
    /// Mostly of a small grid, where points coincide and segments cross; else close to it, near the ends of the range, or any bits
    /// at all.
    fn draw(source: &mut impl Choose) -> Self {
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
}

impl Draw for Spot {
    fn draw(source: &mut impl Choose) -> Self {
        Self { x: Draw::draw(source), y: Draw::draw(source) }
    }
}

macro_rules! draw_picks {
    ($($name:ident)*) => {$(
        impl Draw for $name {
            fn draw(source: &mut impl Choose) -> Self {
                let k = source.choose(256) as u16;
                if source.choose(16) == 15 { Self::Retired(k) } else { Self::Live(k) }
            }
        }
    )*};
}
draw_picks! { MapVertexPick MapHalfEdgePick MapFacePick }

impl Draw for AtPick {
    fn draw(source: &mut impl Choose) -> Self {
        match source.choose(8) {
            5 => Self::Near(Draw::draw(source), Draw::draw(source)),
            6 | 7 => Self::Vertex(Draw::draw(source)),
            _ => Self::Point(Draw::draw(source)),
        }
    }
}

impl Draw for RingPick {
    fn draw(source: &mut impl Choose) -> Self {
        (0..2 + source.choose(5)).map(|_| Draw::draw(source)).collect()
    }
}

impl Draw for GridPick {
    fn draw(source: &mut impl Choose) -> Self {
        match source.choose(8) {
            5 => Self::Auto,
            6 => Self::Size(Number::from(0.25)),
            7 => Self::Size(Draw::draw(source)),
            _ => Self::Size(Number::from(1.0)),
        }
    }
}

impl Draw for FeaturesPick {
    /// Mostly of the first two, so that most exist.
    fn draw(source: &mut impl Choose) -> Self {
        Self(match source.choose(8) {
            7 => source.choose(1 << 16) as u16,
            _ => source.choose(4) as u16,
        })
    }
}
