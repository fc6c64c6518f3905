//! Tests of `curve`.

use super::{Bounds, Curve};
use crate::Point;

#[test]
fn neighbours_on_the_curve_are_neighbours_in_the_plane() {
    let side = 1_u32 << 16;
    let through = |low: f64, high: f64| Curve::through(Bounds { low: [low; 2].into(), high: [high; 2].into() });
    let curve = through(0.0, f64::from(side - 1));
    let mut cells: Vec<(u32, [u32; 2])> = (0..64)
        .flat_map(|x| (0..64).map(move |y| [x, y]))
        .map(|[x, y]| (curve.place(Point::new(x.into(), y.into())), [x, y]))
        .collect();
    cells.sort_unstable();
    assert!((0..).zip(&cells).all(|(place, cell)| cell.0 == place));
    assert!(cells.windows(2).all(|pair| {
        let [[a, b], [c, d]] = [pair[0].1, pair[1].1];
        a.abs_diff(c) + b.abs_diff(d) == 1
    }));
    assert_eq!(through(1.0, 1.0).place(Point::new(1.0, 1.0)), 0);
}
