//! The predicates compared with whole-number arithmetic.

use std::cmp::Ordering;

use crate::exact::{Grid, Meets, area, lies_on, meets, point};
use quickcheck::{Arbitrary, Gen, QuickCheck, TestResult, Testable};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{
    Endpoint, MAX_COORDINATE, MIN_COORDINATE, Meeting, Orientation, compare_angle, compare_lexicographic, in_range,
    meeting, on_segment, orientation,
};

fn check(tests: u64, property: impl Testable) {
    let generator = Gen::from_size_and_seed(50, 1975);
    let quickcheck = QuickCheck::new().rng(generator).tests(tests).max_tests(20 * tests);
    quickcheck.min_tests_passed(tests).quickcheck(property);
}

/// A point of a grid so small that most things coincide, are collinear, or touch.
#[derive(Clone, Copy, Debug)]
struct Near(Grid);

impl Arbitrary for Near {
    fn arbitrary(g: &mut Gen) -> Self {
        let mut coordinate = || i32::from(u8::arbitrary(g) % 5) - 2;
        Self((coordinate(), coordinate()))
    }
}

/// A number with 53 random bits, near either end of the range of exact arithmetic or anywhere in it, or zero.
#[derive(Clone, Copy, Debug)]
struct Wild(f64);

impl Arbitrary for Wild {
    fn arbitrary(g: &mut Gen) -> Self {
        let exponent = match u8::arbitrary(g) % 4 {
            0 => 0,
            1 => u64::from(u8::arbitrary(g) % 4) + 623,
            2 => 1522 - u64::from(u8::arbitrary(g) % 4),
            _ => 623 + u64::from(u16::arbitrary(g)) % 900,
        };
        let fraction = match u8::arbitrary(g) % 3 {
            0 => 0,
            1 => u64::arbitrary(g) % 4,
            _ => u64::arbitrary(g) >> 12,
        };
        if exponent == 0 {
            return Self(0.0);
        }
        Self(f64::from_bits((u64::from(bool::arbitrary(g)) << 63) | (exponent << 52) | fraction))
    }
}

/// A whole number of any size: `limbs[i]` times 2^(32 i - 2148), each of either sign and any size.
struct Sum {
    limbs: [i128; 140],
}

impl Sum {
    fn add(&mut self, a: f64, b: f64, sign: i128) {
        let parts = |c: f64| {
            let (bits, exponent) = (c.abs().to_bits(), (c.abs().to_bits() >> 52) as usize);
            let mantissa = (bits & ((1 << 52) - 1)) | (u64::from(exponent > 0) << 52);
            (i128::from(mantissa) * if c < 0.0 { -1 } else { 1 }, exponent.max(1))
        };
        let ((m, e), (n, f)) = (parts(a), parts(b));
        // m and n count units of 2^(exponent - 1075), so the product counts units of 2^(e + f - 2150).
        let shift = e + f - 2;
        let product = m * n * sign;
        let (limb, bits) = (shift / 32, shift % 32);
        // 106 bits: taken apart, so that shifting does not push any out.
        let (low, high) = (product & 0xffff_ffff, product >> 32);
        self.limbs[limb] += low << bits;
        self.limbs[limb + 1] += (high & 0xffff_ffff) << bits;
        self.limbs[limb + 2] += (high >> 32) << bits;
    }

    fn sign(mut self) -> Ordering {
        let mut any = false;
        for i in 0..self.limbs.len() - 1 {
            let carry = self.limbs[i] >> 32;
            any |= self.limbs[i] != carry << 32;
            self.limbs[i + 1] += carry;
        }
        // All limbs except the last are now from 0 to 2^32.
        self.limbs[self.limbs.len() - 1].cmp(&0).then(if any { Ordering::Greater } else { Ordering::Equal })
    }
}

fn exact_orientation(a: Point, b: Point, c: Point) -> Orientation {
    let mut sum = Sum { limbs: [0; 140] };
    for (p, q) in [(a, b), (b, c), (c, a)] {
        sum.add(p.x, q.y, 1);
        sum.add(p.y, q.x, -1);
    }
    side(sum.sign())
}

fn side(sign: Ordering) -> Orientation {
    match sign {
        Ordering::Greater => Orientation::CounterClockwise,
        Ordering::Equal => Orientation::Collinear,
        Ordering::Less => Orientation::Clockwise,
    }
}

#[test]
fn the_bounds_are_the_powers_of_two_that_are_promised() {
    assert_eq!(MAX_COORDINATE.to_bits(), 2_f64.powi(500).to_bits());
    assert_eq!(MIN_COORDINATE.to_bits(), 2_f64.powi(-400).to_bits());
    for good in [0.0, -0.0, 1.0, -MAX_COORDINATE, MAX_COORDINATE, MIN_COORDINATE, -MIN_COORDINATE] {
        assert!(in_range(Point::new(good, 1.0)) && in_range(Point::new(1.0, good)), "{good}");
    }
    let beyond =
        [f64::NAN, f64::INFINITY, MAX_COORDINATE.next_up(), -MAX_COORDINATE.next_up(), MIN_COORDINATE.next_down()];
    for bad in beyond {
        assert!(!in_range(Point::new(bad, 1.0)) && !in_range(Point::new(1.0, bad)), "{bad}");
    }
}

#[test]
fn orientation_is_exact_at_both_ends_of_the_range() {
    fn property(a: (Wild, Wild), b: (Wild, Wild), c: (Wild, Wild)) -> bool {
        let [a, b, c] = [a, b, c].map(|(x, y)| Point::new(x.0, y.0));
        assert!([a, b, c].into_iter().all(in_range));
        orientation(a, b, c) == exact_orientation(a, b, c)
    }
    check(50_000, property as fn((Wild, Wild), (Wild, Wild), (Wild, Wild)) -> bool);
}

#[test]
fn orientation_is_exact_for_nearly_collinear_points() {
    /// Points in a row, each moved by a few units in the last place, scaled to difficult magnitudes.
    fn property(start: Wild, steps: (i16, i16), stretch: (u8, u8), nudges: [i8; 3], scale: i16) -> TestResult {
        let scale = 2_f64.powi(i32::from(scale % 490));
        let start = start.0.clamp(-1.0, 1.0);
        let at = |k: u8, nudge: i8| {
            let along = |step: i16| start + f64::from(step) * f64::from(k) / 7.0;
            let moved = |c: f64| f64::from_bits(c.to_bits().wrapping_add_signed(i64::from(nudge % 3)));
            Point::new(along(steps.0) * scale, moved(along(steps.1) * scale))
        };
        let [a, b, c] = [at(0, nudges[0]), at(stretch.0, nudges[1]), at(stretch.1, nudges[2])];
        if ![a, b, c].into_iter().all(in_range) {
            return TestResult::discard();
        }
        TestResult::from_bool(orientation(a, b, c) == exact_orientation(a, b, c))
    }
    check(50_000, property as fn(Wild, (i16, i16), (u8, u8), [i8; 3], i16) -> TestResult);
}

#[test]
fn points_on_a_grid_turn_as_whole_numbers_say() {
    fn property(a: Near, b: Near, c: Near) -> bool {
        let turn = side(area(a.0, b.0, c.0).cmp(&0));
        let [a, b, c] = [a, b, c].map(|p| point(p.0));
        orientation(a, b, c) == turn && exact_orientation(a, b, c) == turn
    }
    check(5000, property as fn(Near, Near, Near) -> bool);
}

#[test]
fn lexicographic_order_is_that_of_pairs() {
    fn property(a: Near, b: Near) -> bool {
        compare_lexicographic(point(a.0), point(b.0)) == a.0.cmp(&b.0)
    }
    check(2000, property as fn(Near, Near) -> bool);
}

#[test]
fn angles_are_ordered_as_the_arc_tangent_orders_them() {
    /// The angle in a full turn. On this grid different directions differ by more than 0.05, so rounding cannot matter.
    fn angle(center: Grid, a: Grid) -> Option<f64> {
        let (dx, dy) = (a.0 - center.0, a.1 - center.1);
        let angle = f64::from(dy).atan2(f64::from(dx));
        ((dx, dy) != (0, 0)).then_some(if angle < 0.0 { angle + std::f64::consts::TAU } else { angle })
    }
    fn property(center: Near, a: Near, b: Near) -> bool {
        let expected = match (angle(center.0, a.0), angle(center.0, b.0)) {
            (Some(a), Some(b)) if (a - b).abs() < 1e-9 => Ordering::Equal,
            (a, b) => a.partial_cmp(&b).unwrap(),
        };
        compare_angle(point(center.0), point(a.0), point(b.0)) == expected
    }
    check(5000, property as fn(Near, Near, Near) -> bool);
}

#[test]
fn points_lie_on_segments_where_whole_numbers_say() {
    fn property(p: Near, a: Near, b: Near) -> bool {
        on_segment(point(p.0), point(a.0), point(b.0)) == lies_on(p.0, a.0, b.0)
    }
    check(5000, property as fn(Near, Near, Near) -> bool);
}

#[test]
fn segments_meet_as_whole_numbers_say() {
    fn property(a: Near, b: Near, c: Near, d: Near) -> bool {
        let found = meeting(point(a.0), point(b.0), point(c.0), point(d.0));
        let ends = [Endpoint::A, Endpoint::B, Endpoint::C, Endpoint::D];
        let at_point = |end: usize, p: Grid, q: Grid, r: Grid| {
            if p == q || p == r {
                Meeting::SharedEndpoint
            } else if lies_on(p, q, r) {
                Meeting::Touch(ends[end])
            } else {
                Meeting::Disjoint
            }
        };
        let expected = if a.0 == b.0 {
            at_point(0, a.0, c.0, d.0)
        } else if c.0 == d.0 {
            at_point(2, c.0, a.0, b.0)
        } else {
            match meets(a.0, b.0, c.0, d.0) {
                Meets::No => Meeting::Disjoint,
                Meets::AtEnds => Meeting::SharedEndpoint,
                Meets::Cross => Meeting::Cross,
                Meets::Touch(end) => Meeting::Touch(ends[end]),
                Meets::Overlap => Meeting::Overlap,
            }
        };
        found == expected
    }
    check(20_000, property as fn(Near, Near, Near, Near) -> bool);
}
