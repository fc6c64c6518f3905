//! Tests of `pixel`.

use super::{Pixels, Segment, scale};

fn segment(a: [i64; 2], b: [i64; 2]) -> Segment {
    Segment { a, b, ends: [0, 1] }
}

#[test]
fn long_division_agrees_with_short_division() {
    for d in [-54_321, -7, -1, 0, 1, 2, 3, 1 << 20, (1 << 20) - 1] {
        for whole in [2_u128, 3, 7, 1 << 40, (1 << 40) + 1] {
            for part in [0, 1, whole / 2, whole - 1] {
                let product = i128::from(d) * part.cast_signed();
                let (floor, rest) = scale(d, part, whole);
                assert_eq!(i128::from(floor), product.div_euclid(whole.cast_signed()));
                assert_eq!(rest.cast_signed(), product.rem_euclid(whole.cast_signed()));
            }
        }
    }
}

#[test]
fn long_division_holds_the_largest_numbers() {
    let d = 1_i64 << 54;
    let whole = (1_u128 << 111) - 1;
    // d * (w - 1) / w = d - d / w, which lies below d by less than one.
    assert_eq!(scale(d, whole - 1, whole), (d - 1, whole - (1 << 54)));
    assert_eq!(scale(-d, whole - 1, whole), (-d, 1 << 54));
}

#[test]
fn a_pixel_owns_its_left_and_lower_side() {
    let pixels = Pixels { shift: 1 };
    // Pixel [0, 0] is [-1, 1) in steps.
    let on_left = segment([-1, -5], [-1, 5]);
    let on_right = segment([1, -5], [1, 5]);
    assert!(pixels.visits(&on_left, [0, 0]) && !pixels.visits(&on_left, [-1, 0]));
    assert!(!pixels.visits(&on_right, [0, 0]) && pixels.visits(&on_right, [1, 0]));
    let through_lower_left = segment([-2, 0], [0, -2]);
    let through_upper_left = segment([-2, 0], [0, 2]);
    assert!(pixels.visits(&through_lower_left, [0, 0]));
    assert!(!pixels.visits(&through_upper_left, [0, 0]));
}

#[test]
fn a_crossing_on_a_border_falls_to_the_right_and_upwards() {
    let pixels = Pixels { shift: 0 };
    let [s, t] = [segment([0, 0], [1, 1]), segment([0, 1], [1, 0])];
    assert_eq!(pixels.crossing(&s, &t), Some([1, 1]));
    assert_eq!(pixels.crossing(&t, &s), Some([1, 1]));
    let [s, t] = [segment([-1, -1], [0, 0]), segment([-1, 0], [0, -1])];
    assert_eq!(pixels.crossing(&s, &t), Some([0, 0]));
    assert_eq!(pixels.crossing(&t, &s), Some([0, 0]));
}
