//! Tests of `grid`.

use super::{Grid, Input, Point, Snap, exponent_above, exponent_below, power_of_two};

fn grid(snap: Snap, largest: f64) -> Grid {
    Grid::new(snap, largest, Input::Point(0)).unwrap()
}

#[test]
fn powers_of_two_have_their_own_exponent() {
    for e in -1074..=1023 {
        let x = power_of_two(e);
        assert_eq!((exponent_below(x), exponent_above(x)), (e, Some(e)));
    }
    for e in -1021..=1023 {
        let below = power_of_two(e).next_down();
        assert_eq!((exponent_below(below), exponent_above(below)), (e - 1, Some(e)));
    }
    assert_eq!(exponent_above(f64::MAX), Some(1024));
    assert_eq!(exponent_above(0.0), None);
}

#[test]
fn the_automatic_grid_has_2_to_the_50_cells_for_the_largest_coordinate() {
    for (x, cell) in [(180.0, -42), (128.0, -43), (1.0, -50), (0.1, -53), (1e-300, -1046)] {
        assert_eq!(grid(Snap::Auto, x).cell, cell, "{x}");
    }
}

#[test]
fn the_automatic_grid_never_rounds_to_infinity() {
    for x in [f64::MAX, f64::MAX.next_down(), f64::MIN_POSITIVE, f64::MIN_POSITIVE.next_down(), 5e-324] {
        let grid = grid(Snap::Auto, x);
        for p in [Point::new(x, -x), Point::new(-x, x)] {
            let to = grid.point(grid.pixels.at(grid.steps(p)));
            assert!((to.x - p.x).abs() <= grid.cell() / 2.0 && (to.y - p.y).abs() <= grid.cell() / 2.0);
        }
    }
}

#[test]
fn halves_go_up() {
    // Once where a cell is a step, and once where it is many.
    for largest in [power_of_two(53), 4.0] {
        let grid = grid(Snap::Size(1.0), largest);
        let rounded = |x: f64| grid.pixels.at(grid.steps(Point::new(x, x)));
        for (x, to) in [(0.5, 1), (-0.5, 0), (1.5, 2), (-1.5, -1), (0.5_f64.next_down(), 0), ((-0.5_f64).next_up(), 0)]
        {
            assert_eq!(rounded(x), [to, to], "{x}");
        }
        assert_eq!(rounded((-0.5_f64).next_down()), [-1, -1]);
        assert_eq!(rounded(-1e-300), [0, 0]);
    }
}

/// Also next to the borders of pixels, which are half-open.
#[test]
fn opposite_points_have_opposite_positions() {
    for (cell, largest) in [(power_of_two(-50), 1.0), (power_of_two(-52), 1.0), (power_of_two(-30), 1e6)] {
        let grid = grid(Snap::Size(cell), largest);
        let step = power_of_two(grid.step);
        for quarters in 0..400 {
            let x = f64::from(quarters) * step / 4.0;
            let [[p, q], [r, s]] = [Point::new(x, -x), Point::new(-x, x)].map(|p| grid.steps(p));
            assert_eq!([p, q], [-r, -s], "{quarters} quarters of a step");
            assert!((p as f64 * step - x).abs() < step);
            // The pixel is that of the point itself.
            for (at, x) in [(p, x), (q, -x)] {
                let pixel = (x / cell + 0.5).floor();
                assert!((grid.pixels.along(at) as f64 - pixel).abs() < 0.5, "{x} in {cell}");
            }
        }
    }
}

#[test]
fn a_cell_far_larger_than_the_input_is_one_pixel() {
    let grid = grid(Snap::Size(1e300), 1.0);
    assert_eq!(grid.pixels.at(grid.steps(Point::new(-1.0, 1.0))), [0, 0]);
}
