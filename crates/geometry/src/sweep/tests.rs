//! Tests of `sweep`.

use super::*;
use crate::steps::steps_of;

const N: u32 = 100_000;

/// A drawing with n segments without common points.
fn apart(ends: impl Iterator<Item = [(f64, f64); 2]>) -> (Vec<Point>, Vec<[u32; 2]>) {
    let points: Vec<Point> = ends.flatten().map(|(x, y)| Point::new(x, y)).collect();
    let segments = (0..points.len() as u32 / 2).map(|i| [2 * i, 2 * i + 1]).collect();
    (points, segments)
}

/// A drawing with segments from point 0 to all others.
fn star(tips: impl Iterator<Item = (f64, f64)>) -> (Vec<Point>, Vec<[u32; 2]>) {
    let points: Vec<Point> = core::iter::once((0.0, 0.0)).chain(tips).map(|(x, y)| Point::new(x, y)).collect();
    let segments = (1..points.len() as u32).map(|i| [i, 0]).collect();
    (points, segments)
}

/// 0 .. N as coordinates, in an irregular order.
fn shuffled() -> impl Iterator<Item = f64> {
    (0..N).map(|i| f64::from((i * 7919) % N))
}

/// Runs the sweep and checks that its work, counted in orientations and steps in the tree, is at most 3 n log n.
#[track_caller]
fn work_is_bounded((points, segments): &(Vec<Point>, Vec<[u32; 2]>)) -> Sweep {
    let (swept, steps) = steps_of(|| sweep(points, segments, &[]).unwrap());
    let n = points.len().max(segments.len()) as u64;
    assert!(steps <= 3 * n * u64::from(n.ilog2()), "{steps} steps for {n}");
    swept
}

#[test]
fn long_parallels_cost_n_log_n() {
    let n = f64::from(N);
    let rising = apart(shuffled().map(|k| [(k, -k), (k + n, n - k)]));
    let nested = apart(shuffled().map(|k| [(k, k), (2.0 * n - k, k)]));
    let mixed = apart(shuffled().zip(0..N).map(|(k, i)| [(i.into(), k), (n + k, k)]));
    for parallels in [rising, nested, mixed] {
        assert_eq!(work_is_bounded(&parallels).clash, None);
    }
}

#[test]
fn segments_that_start_on_one_vertical_line_cost_n_log_n() {
    let level = apart(shuffled().map(|k| [(0.0, k), (1.0, k)]));
    let upright = apart(shuffled().map(|k| [(0.0, 2.0 * k), (0.0, 2.0 * k + 1.0)]));
    assert_eq!(work_is_bounded(&level).clash, None);
    assert_eq!(work_is_bounded(&upright).clash, None);
}

#[test]
fn stars_cost_n_log_n() {
    let n = f64::from(N);
    let opening = star(shuffled().map(|k| (n, k)));
    let closing = star(shuffled().map(|k| (-n, k)));
    let through = star(shuffled().map(|k| if k < n / 2.0 { (n, k) } else { (-n, k) }));
    for star in [opening, closing, through] {
        assert_eq!(work_is_bounded(&star).clash, None);
    }
}

#[test]
fn combs_cost_n_log_n() {
    // Point 2k is on the back of the comb, point 2k + 1 is the tip of its tooth.
    let points = (0..N).map(|i| (f64::from(i / 2), f64::from(i % 2)));
    let back = (0..N - 2).step_by(2).map(|i| [i, i + 2]);
    let segments: Vec<[u32; 2]> = (0..N).step_by(2).map(|i| [i + 1, i]).chain(back).collect();
    let lying: Vec<Point> = points.clone().map(|(x, y)| Point::new(x, y)).collect();
    let standing = points.map(|(x, y)| Point::new(y, x)).collect();
    assert_eq!(work_is_bounded(&(lying, segments.clone())).clash, None);
    assert_eq!(work_is_bounded(&(standing, segments)).clash, None);
}

#[test]
fn zigzags_cost_n_log_n() {
    // One chain that alternates between right and left, so that all of it is in the status at once.
    let points: Vec<Point> = (0..N).map(|i| Point::new(f64::from(i % 2), f64::from(i))).collect();
    let segments = (1..N).map(|i| [i - 1, i]).collect();
    assert_eq!(work_is_bounded(&(points, segments)).clash, None);
}

#[test]
fn clashes_cost_n_log_n() {
    let n = f64::from(N);
    let grid = apart(shuffled().map(|k| if k % 2.0 == 0.0 { [(k, -1.0), (k, n)] } else { [(-1.0, k), (n, k)] }));
    let pencil = apart(shuffled().map(|k| [(-n, -k), (n, k)]));
    let pile = apart(shuffled().map(|k| [(-1.0 - k, 0.0), (1.0 + k, 0.0)]));
    let tangle = apart(shuffled().zip(shuffled().skip(1)).map(|(k, l)| [(k, l), (n - l, k)]));
    let knot = (vec![Point::new(1.0, 1.0); N as usize], Vec::new());
    for drawing in [grid, pencil, pile, tangle, knot] {
        assert_ne!(work_is_bounded(&drawing).clash, None);
    }
}
