//! Arbitrary input, against the oracle.

use crate::noding::check::{Segment, cells, check, is_plane, segment};
use crate::noding::oracle::{self, Whole};
use quickcheck::{Gen, QuickCheck, Testable};
use std::collections::BTreeSet;
use twinedge::geometry::Point;
use twinedge::geometry::noding::Snap;

fn quickcheck(size: usize, tests: u64, property: impl Testable) {
    QuickCheck::new().rng(Gen::from_size_and_seed(size, 1)).tests(tests).quickcheck(property);
}

/// Numbers are eighths, and cells an eighth to four.
fn agrees_with_oracle(raw: Vec<(i8, i8, i8, i8)>, single: Vec<(i8, i8)>, exponent: u8) -> bool {
    let size = 1_i128 << (exponent % 6);
    let of = |x: i8, y: i8| Point::new(f64::from(x) / 8.0, f64::from(y) / 8.0);
    let segments: Vec<Segment> = raw.iter().map(|&(a, b, c, d)| [of(a, b), of(c, d)]).collect();
    let points: Vec<Point> = single.iter().map(|&(x, y)| of(x, y)).collect();
    let noded = check(&segments, &points, Snap::Size(size as f64 / 8.0));
    assert!(is_plane(&noded));

    let whole_segments: Vec<[Whole; 2]> =
        raw.iter().map(|&(a, b, c, d)| [[a.into(), b.into()], [c.into(), d.into()]]).collect();
    let whole_points: Vec<Whole> = single.iter().map(|&(x, y)| [x.into(), y.into()]).collect();
    let ideal = oracle::node(&whole_segments, &whole_points, size);
    let cells = cells(&noded);
    assert!(cells.iter().eq(&ideal.vertices));
    let edges: BTreeSet<[Whole; 2]> =
        ideal.chains.iter().flat_map(|chain| chain.windows(2)).map(|e| [e[0].min(e[1]), e[0].max(e[1])]).collect();
    assert!(noded.segments.iter().map(|ends| ends.map(|v| cells[v as usize])).eq(edges));
    for (i, chain) in ideal.chains.iter().enumerate() {
        assert!(noded.chain(i).unwrap().map(|v| &cells[v as usize]).eq(chain));
        assert!(noded.chain(i).unwrap().rev().map(|v| &cells[v as usize]).eq(chain.iter().rev()));
    }
    let summary = noded.summary;
    assert_eq!((summary.crossings, summary.rounds), (ideal.crossings, ideal.rounds));
    assert_eq!(summary.split, ideal.chains.iter().filter(|chain| chain.len() > 2).count());
    assert_eq!(summary.collapsed, ideal.chains.iter().filter(|chain| chain.len() == 1).count());
    let distinct: BTreeSet<Whole> = whole_segments.iter().flatten().chain(&whole_points).copied().collect();
    assert_eq!(summary.merged, distinct.len() + ideal.crossings - cells.len());
    true
}

#[test]
fn every_result_is_that_of_an_oracle() {
    for (size, tests) in [(4, 400), (12, 200), (50, 25)] {
        quickcheck(size, tests, agrees_with_oracle as fn(_, _, _) -> bool);
    }
}

#[test]
fn crowded_input_agrees_with_the_oracle() {
    // All in a square of 4 by 4, so that most pixels are hot and chains are bent many times.
    fn crowded(raw: Vec<(i8, i8, i8, i8)>, exponent: u8) -> bool {
        let near = |x: i8| x % 16;
        agrees_with_oracle(
            raw.iter().map(|&(a, b, c, d)| (near(a), near(b), near(c), near(d))).collect(),
            Vec::new(),
            exponent,
        )
    }
    quickcheck(20, 200, crowded as fn(_, _) -> bool);
}

#[test]
fn any_finite_numbers_are_noded() {
    // Whatever bits, those of infinities and NaN excepted.
    fn any(raw: Vec<(u64, u64, u64, u64)>) -> bool {
        let number = |bits: u64| {
            let x = f64::from_bits(bits);
            if x.is_finite() { x } else { 0.0 }
        };
        let segments: Vec<Segment> =
            raw.iter().map(|&(a, b, c, d)| segment([number(a), number(b)], [number(c), number(d)])).collect();
        is_plane(&check(&segments, &[], Snap::Auto))
    }
    // Numbers of full length and similar size, near parallels, coarse and fine cells.
    fn long(raw: Vec<(u32, u32, u32, i8)>, exponent: u8) -> bool {
        let number = |bits: u32| f64::from(bits) / 3.0;
        let segments: Vec<Segment> = raw
            .iter()
            .map(|&(a, b, c, d)| segment([number(a), number(b)], [number(c), number(b.wrapping_add(c)) + f64::from(d)]))
            .collect();
        let coarse = Snap::Size(2.0_f64.powi(i32::from(exponent % 30)));
        is_plane(&check(&segments, &[], Snap::Auto)) && is_plane(&check(&segments, &[], coarse))
    }
    quickcheck(30, 100, any as fn(_) -> bool);
    quickcheck(30, 40, long as fn(_, _) -> bool);
}
