//! Chains of half-edges, one at a time.

use super::{Beside, Chain, Point};

fn chain(walks: &[&[[f64; 2]]]) -> super::SummedChain {
    let mut chain = Chain::default();
    for walk in walks {
        for (i, p) in walk.iter().enumerate() {
            chain.add([Point::from(*p), walk[(i + 1) % walk.len()].into()], 1);
        }
    }
    chain.summed()
}

const SQUARE: &[[f64; 2]] = &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];

#[test]
fn a_point_just_to_the_left_of_each_side_is_inside() {
    let square = chain(&[SQUARE]);
    for i in 0..4 {
        let [a, b] = [SQUARE[i], SQUARE[(i + 1) % 4]].map(Point::from);
        assert_eq!(square.around(Beside { at: a, towards: b }), 1, "{a:?}");
        assert_eq!(square.around(Beside { at: b, towards: a }), 0, "{a:?}");
    }
    for (p, times) in [([2.0, 2.0], 1), ([5.0, 2.0], 0), ([2.0, 5.0], 0), ([2.0, -1.0], 0), ([-1.0, 2.0], 0)] {
        assert_eq!(square.around(Beside::isolated(p.into())), times, "{p:?}");
    }
}

#[test]
fn what_cancels_out_is_left_out() {
    let back: Vec<[f64; 2]> = SQUARE.iter().rev().copied().collect();
    assert!(chain(&[SQUARE, &back]).envelope().is_none());
    // With each side in several pieces.
    let split = |ring: &[[f64; 2]]| -> Vec<[f64; 2]> {
        let pieces = |i: usize| {
            let ([ax, ay], [bx, by]) = (ring[i], ring[(i + 1) % ring.len()]);
            [0.0, 0.25, 0.5].map(|t| [ax + (bx - ax) * t, ay + (by - ay) * t])
        };
        (0..ring.len()).flat_map(pieces).collect()
    };
    assert!(chain(&[SQUARE, &split(&back)]).envelope().is_none());
    assert!(chain(&[&split(SQUARE), &back]).envelope().is_none());
    assert_eq!(chain(&[SQUARE, SQUARE]).around(Beside::isolated([1.0, 1.0].into())), 2);
}
