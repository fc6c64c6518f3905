//! Arbitrary input, compared with the oracle.

use crate::noding::check::{Segment, cells, check, is_plane, segment};
use crate::noding::oracle::{self, Whole};
use quickcheck::{Gen, QuickCheck, Testable};
use std::collections::BTreeSet;
use twinedge_geometry::Point;
use twinedge_geometry::noding::{Snap, node};

fn quickcheck(size: usize, tests: u64, property: impl Testable) {
    QuickCheck::new().rng(Gen::from_size_and_seed(size, 1)).tests(tests).quickcheck(property);
}

/// Numbers are eighths, and cells range from an eighth to four.
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
    // Arbitrary bits, except infinities and NaN.
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

/// Whole numbers of cells are noded on a decimal grid as on whole numbers, and then written as decimals; even in doubles, edges
/// meet only at common ends. Points of the grid do not move, and noding again changes nothing.
#[test]
fn on_a_decimal_grid_everything_is_as_on_whole_numbers() {
    fn agrees(raw: Vec<(i16, i16, i16, i16)>, grid: u8, far: bool) -> bool {
        let (size, cells, scale) =
            [(0.001, 1, 1e3), (0.3, 3, 10.0), (2.5, 25, 10.0), (1e-7, 1, 1e7)][usize::from(grid % 4)];
        let [x, y] = if far { [2_600_000_123, 1_200_000_789] } else { [0, 0] };
        let whole = |a: i16, b: i16| [x + i64::from(a), y + i64::from(b)];
        let lattice = |[a, b]: [i64; 2]| Point::new(a as f64, b as f64);
        let decimal = |[a, b]: [i64; 2]| Point::new((cells * a) as f64 / scale, (cells * b) as f64 / scale);
        let ends = raw.iter().map(|&(a, b, c, d)| [whole(a, b), whole(c, d)]);
        let segments: Vec<Segment> = ends.clone().map(|ends| ends.map(decimal)).collect();
        let noded = node(&segments, &[], Snap::Size(size)).expect("in reach");
        let expected =
            node(&ends.map(|ends| ends.map(lattice)).collect::<Vec<_>>(), &[], Snap::Size(1.0)).expect("in reach");
        let as_decimals = |p: &Point| decimal([p.x as i64, p.y as i64]);
        assert_eq!(noded.points, expected.points.iter().map(as_decimals).collect::<Vec<_>>());
        assert_eq!((&noded.segments, noded.summary.largest_move), (&expected.segments, [0.0; 2]));
        assert!((0..raw.len()).all(|i| noded.chain(i).unwrap().eq(expected.chain(i).unwrap())));

        let edges: Vec<Segment> = noded.segments.iter().map(|ends| ends.map(|v| noded.points[v as usize])).collect();
        let again = node(&edges, &noded.points, Snap::Size(size)).expect("in reach");
        assert_eq!((&again.points, &again.segments), (&noded.points, &noded.segments));
        assert!(noded.points.iter().all(|p| noded.summary.snapped(*p) == *p));
        is_plane(&noded)
    }
    quickcheck(12, 100, agrees as fn(_, _, _) -> bool);
    quickcheck(200, 50, agrees as fn(_, _, _) -> bool);
}

/// Points off the grid move to the nearest grid point, and nothing crosses afterwards.
#[test]
fn any_numbers_are_noded_on_a_decimal_grid() {
    fn any(raw: Vec<(u16, u16, u16, u16)>, grid: u8) -> bool {
        let size = [0.001, 0.3, 2.5, 1e-7, 7.0, 0.015][usize::from(grid % 6)];
        let number = |bits: u16| 2_600_000.0 + f64::from(bits) / 300.0;
        let segments: Vec<Segment> =
            raw.iter().map(|&(a, b, c, d)| segment([number(a), number(b)], [number(c), number(d)])).collect();
        let noded = node(&segments, &[], Snap::Size(size)).expect("in reach");
        let edges: Vec<Segment> = noded.segments.iter().map(|ends| ends.map(|v| noded.points[v as usize])).collect();
        let again = node(&edges, &noded.points, Snap::Size(size)).expect("in reach");
        assert_eq!((&again.points, &again.segments), (&noded.points, &noded.segments));
        assert_eq!((again.summary.rounds, again.summary.largest_move), (0, [0.0; 2]));
        let most = size / 2.0 * (1.0 + 1e-7);
        assert!(noded.summary.largest_move.iter().all(|moved| *moved <= most));
        is_plane(&noded)
    }
    quickcheck(40, 200, any as fn(_, _) -> bool);
}
