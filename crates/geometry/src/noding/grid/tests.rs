//! Tests of `grid`.

use super::{Cell, Grid, Input, Point, Snap, exponent_above, power_of_two};

fn grid(snap: Snap, largest: f64) -> Grid {
    Grid::new(snap, largest, Input::Point(0)).unwrap()
}

#[test]
fn powers_of_two_have_their_own_exponent() {
    for e in -1074..=1023 {
        let x = power_of_two(e);
        assert_eq!((Cell::of(x).exponent, exponent_above(x)), (e, Some(e)));
    }
    for e in -1021..=1023 {
        let below = power_of_two(e).next_down();
        assert_eq!(exponent_above(below), Some(e));
    }
    assert_eq!(exponent_above(f64::MAX), Some(1024));
    assert_eq!(exponent_above(0.0), None);
}

#[test]
fn the_automatic_grid_has_2_to_the_50_cells_for_the_largest_coordinate() {
    for (x, cell) in [(180.0, -42), (128.0, -43), (1.0, -50), (0.1, -53), (1e-300, -1046)] {
        assert_eq!(grid(Snap::Auto, x).cell.exponent, cell, "{x}");
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
    // Once with cells of one step, and once with cells of many.
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

/// Holds even next to the borders of pixels, which are half-open.
#[test]
fn opposite_points_have_opposite_positions() {
    for (cell, largest) in [(power_of_two(-50), 1.0), (power_of_two(-52), 1.0), (power_of_two(-30), 1e6)] {
        let grid = grid(Snap::Size(cell), largest);
        let step = cell / f64::from(1_u32 << grid.pixels.shift);
        for quarters in 0..400 {
            let x = f64::from(quarters) * step / 4.0;
            let [[p, q], [r, s]] = [Point::new(x, -x), Point::new(-x, x)].map(|p| grid.steps(p));
            assert_eq!([p, q], [-r, -s], "{quarters} quarters of a step");
            assert!((p as f64 * step - x).abs() < step);
            // The pixel is the pixel of the point itself.
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

/// A coordinate of a decimal grid is the double parsed from its text, and its position is the centre of its pixel.
#[test]
fn a_decimal_grid_has_the_doubles_of_its_decimals() {
    for (size, places, cells) in [(0.001, 3, 1), (0.3, 1, 3), (2.5, 1, 25), (1e-7, 7, 1), (20.0, 0, 20), (0.015, 3, 15)]
    {
        let grid = grid(Snap::Size(size), 3e6);
        for number in (0..200).flat_map(|n| [n, 86_573_211 + n, 123_456_789 - 7_919 * n]) {
            let units = i128::from(number) * cells;
            let ten = 10_i128.pow(places);
            let text = format!("{}.{:0places$}", units / ten, units % ten, places = places as usize);
            let x: f64 = text.trim_end_matches('.').parse().unwrap();
            for (x, number) in [(x, number), (-x, -number)].into_iter().filter(|(x, _)| x.abs() < 3e6) {
                let at = grid.steps(Point::new(x, x));
                assert_eq!(at, [number << grid.pixels.shift; 2], "{x} on a grid of {size}");
                assert_eq!(grid.point(grid.pixels.at(at)), Point::new(x, x));
                assert_eq!(grid.cell.nearest(x + size * 0.49), number);
            }
        }
    }
}

/// A width that is neither a power of two nor a short decimal is used exactly.
#[test]
fn other_widths_are_exact() {
    let third = 1.0 / 3.0;
    for width in [third, std::f64::consts::PI, 1e300 / 7.0, f64::MIN_POSITIVE * 3.0] {
        let cell = Cell::of(width);
        for cells in [0, 1, -1, 5, 1000] {
            assert_eq!(cell.coordinate(cells).to_bits(), (cells as f64 * width).to_bits());
            assert_eq!(cell.nearest(cell.coordinate(cells)), cells);
        }
    }
}
