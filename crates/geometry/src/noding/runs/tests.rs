//! Tests of `runs`.

use super::{Segment, inverse, join, line};

fn segment(a: [i64; 2], b: [i64; 2]) -> Segment {
    Segment { a, b, ends: [0, 0] }
}

#[test]
fn inverses_are_inverses() {
    for odd in [1, 3, 5, 0xffff_ffff, u64::MAX, 0x1234_5678_9abc_def1] {
        assert_eq!(inverse(odd).wrapping_mul(odd), 1);
    }
}

#[test]
fn a_line_has_one_number_and_its_neighbours_have_others() {
    let far = (1_i64 << 53) - 1;
    for [p, q] in [[1, 0], [0, 1], [3, 5], [2, 5], [4, -6], [far, -far], [far - 1, far]] {
        let number = line(&segment([0, 0], [p, q]));
        assert_eq!(line(&segment([-p, -q], [p, q])), number);
        assert_eq!(line(&segment([-p, -q], [0, 0])), number);
        let (beside, turned) =
            (segment([-q.signum(), p.signum()], [p - q.signum(), q + p.signum()]), segment([0, 0], [p + 1, q + 2]));
        assert_ne!(line(&beside), number);
        assert_ne!(line(&turned), number);
    }
}

#[test]
fn overlapping_segments_are_joined_and_touching_ones_are_not() {
    let on_a_line = |i: i64, j: i64| segment([3 * i, 5 * i], [3 * j, 5 * j]);
    let segments = [on_a_line(4, 6), on_a_line(0, 2), on_a_line(1, 3), on_a_line(3, 4), on_a_line(0, 2)];
    let runs = join(segments.to_vec());
    assert_eq!((runs.joined.len(), runs.duplicates), (3, 1));
    assert_eq!(runs.of[1], runs.of[2]);
    assert_eq!(runs.of[1], runs.of[4]);
    let run = &runs.joined[runs.of[1] as usize];
    assert_eq!((run.a, run.b), ([0, 0], [9, 15]));
}
