//! The ends of the range of numbers, and small cases by hand.
#![expect(clippy::float_cmp, reason = "all of it is exact")]

use crate::noding::check::{Segment, auto, check, counts, segment};
use twinedge_geometry::Point;
use twinedge_geometry::noding::{Input, NodingError, Snap, node};

#[test]
fn coordinates_at_the_extremes_are_noded_or_refused() {
    // The largest and the smallest doubles, on the grid that fits them.
    for r in [f64::MAX, 2.0_f64.powi(1023), f64::MIN_POSITIVE, 5e-324] {
        let noded = check(&[segment([-r, -r], [r, r]), segment([-r, r], [r, -r])], &[], Snap::Auto);
        assert_eq!(counts(&noded), [5, 4, 1], "{r:e}");
        assert_eq!(noded.points[2], Point::new(0.0, 0.0));
    }
    // Next to the largest, the small coordinates are one point.
    let mixed = [segment([1e300, 0.0], [-1e300, 1.0]), segment([1e-300, 1.0], [-1.0, 1e100])];
    assert_eq!(counts(&check(&mixed, &[], Snap::Auto)), [3, 2, 1]);
    // 2^53 cells are in reach, but no more.
    let far = 2.0_f64.powi(53);
    let reaching = [segment([-far, far], [far, -far]), segment([-far, -far], [far, far - 1.0])];
    let noded = check(&reaching, &[], Snap::Size(1.0));
    assert_eq!(counts(&noded), [5, 4, 1]);
    let out = |at| Some(NodingError::OutOfRange { at });
    let error = |segments: &[Segment], points: &[Point], snap| node(segments, points, snap).err();
    let [inside, beyond] = [segment([0.0, 0.0], [1.0, 1.0]), segment([0.0, 0.0], [far + 2.0, 0.0])];
    assert_eq!(error(&[inside, beyond], &[], Snap::Size(1.0)), out(Input::Segment(1)));
    assert_eq!(error(&[inside], &[Point::new(0.0, -1e300)], Snap::Size(1.0)), out(Input::Point(0)));
    assert_eq!(error(&[inside], &[], Snap::Size(1e-300)), out(Input::Segment(0)));
    // The nearest multiple of 2^1000 is infinite.
    assert_eq!(
        error(&[segment([0.0, 0.0], [0.0, f64::MAX])], &[], Snap::Size(2.0_f64.powi(1000))),
        out(Input::Segment(0))
    );
    assert_eq!(error(&[segment([0.0, 0.0], [0.0, 1e300])], &[], Snap::Size(2.0_f64.powi(1000))), None);
}

#[test]
fn what_is_not_finite_is_refused_with_its_place() {
    let good = segment([0.0, 0.0], [1.0, 1.0]);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for broken in [segment([bad, 0.0], [0.0, 0.0]), segment([0.0, 0.0], [0.0, bad])] {
            let error = node(&[good, good, broken, broken], &[], Snap::Auto).unwrap_err();
            assert_eq!(error, NodingError::NotFinite { at: Input::Segment(2) });
        }
        let error = node(&[good], &[Point::default(), Point::new(1.0, bad)], Snap::Auto).unwrap_err();
        assert_eq!(error, NodingError::NotFinite { at: Input::Point(1) });
        assert_eq!(error.to_string(), "point 1 has a coordinate that is not a finite number");
        assert_eq!(node(&[good], &[], Snap::Size(bad)).unwrap_err(), NodingError::Size);
    }
    for size in [0.0, -0.0, -1.0] {
        assert_eq!(node(&[good], &[], Snap::Size(size)).unwrap_err(), NodingError::Size);
    }
}

#[test]
fn a_grid_has_the_size_that_was_asked_for() {
    let one = [segment([0.0, 0.0], [1.0, 1.0])];
    for size in [1.0, 1.9, 0.1, 3e-5, 1000.0, 1.0 / 3.0, f64::exp2(-52.0)] {
        assert_eq!(node(&one, &[], Snap::Size(size)).unwrap().summary.cell, size);
    }
    // Decimals have a smaller reach than powers of two.
    assert_eq!(node(&one, &[], Snap::Size(1e-15)).unwrap_err(), NodingError::OutOfRange { at: Input::Segment(0) });
}

#[test]
fn nothing_comes_of_nothing_and_points_of_points() {
    let nothing = auto(&[]);
    assert_eq!((counts(&nothing), nothing.summary.cell), ([0, 0, 0], 1.0));
    assert!(nothing.chain(0).is_none() && nothing.vertex_of_point(0).is_none());
    // Zero has no sign.
    let zeros = [Point::new(0.0, 1.0), Point::new(-0.0, 1.0)];
    assert_eq!(check(&[], &zeros, Snap::Auto).summary.merged, 0);
    let p = Point::new(0.25, -0.0);
    let noded = check(&[[p, p]], &[p, Point::new(0.3, 0.1), Point::new(2.0, 2.0)], Snap::Size(1.0));
    assert_eq!(noded.points, [Point::new(0.0, 0.0), Point::new(2.0, 2.0)]);
    assert!(noded.points.iter().all(|p| p.y.is_sign_positive()));
    assert_eq!([0, 1, 2, 3].map(|i| noded.vertex_of_point(i)), [Some(0), Some(0), Some(1), None]);
    assert!(noded.chain(0).unwrap().eq([0]));
    assert_eq!((noded.summary.collapsed, noded.summary.merged), (1, 1));
    assert_eq!(noded.summary.largest_move, [0.3, 0.1]);
}

#[test]
fn a_point_on_a_segment_splits_it_and_one_beside_it_bends_it() {
    let long = [segment([0.0, 0.0], [10.0, 0.0])];
    let on = check(&long, &[Point::new(4.0, 0.0)], Snap::Size(1.0));
    assert!(on.chain(0).unwrap().eq([0, 1, 2]));
    // The pixel of a vertex half a cell above a line has the line on its lower side; half a cell below, on its upper side.
    let slanted = [segment([0.0, 0.0], [2.0, 1.0])];
    let above = check(&slanted, &[Point::new(1.0, 1.0)], Snap::Size(1.0));
    assert_eq!(counts(&above), [3, 2, 1]);
    let below = check(&slanted, &[Point::new(1.0, 0.0)], Snap::Size(1.0));
    assert_eq!(counts(&below), [3, 2, 1]);
    let away = check(&slanted, &[Point::new(1.0, -1.0)], Snap::Size(1.0));
    assert_eq!(counts(&away), [3, 1, 2]);
}

#[test]
fn a_vertex_near_a_coarsely_rounded_segment_does_not_change_sides() {
    // The tip is slightly above the long side. If the ends were rounded first, it would move below, and there would be crossings.
    let long = segment([0.4, 0.4], [100.4, 33.6]);
    let tip = Point::new(50.4, 17.01);
    let spike = [long, [tip, Point::new(49.0, 30.0)], [tip, Point::new(52.0, 30.0)]];
    let noded = check(&spike, &[], Snap::Size(1.0));
    assert_eq!(noded.summary.crossings, 0);
    // The long side passes through the tip's vertex or stays below it.
    let at_tip = noded.points[noded.chain(1).unwrap().next().unwrap() as usize];
    let way: Vec<Point> = noded.chain(0).unwrap().map(|v| noded.points[v as usize]).collect();
    assert!(way.contains(&at_tip));
}
