//! Families of input that break noders.

use crate::noding::check::{Segment, auto, check, counts, is_plane, segment};
use std::f64::consts::TAU;
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;

#[test]
fn a_star_through_one_point_has_one_crossing() {
    let n = 10_000_i32;
    let ray = |i: i32| [f64::from(i), f64::from(n - i)];
    let star: Vec<Segment> = (0..n).map(|i| segment(ray(i).map(|x| -x), ray(i))).collect();
    let noded = check(&star, &[], Snap::Auto);
    assert_eq!(counts(&noded), [20_001, 20_000, 1]);
    assert_eq!((noded.summary.crossings, noded.summary.split), (1, 10_000));
}

/// The ends of a diameter are opposite to the last digit, and are read as opposite.
#[test]
fn diameters_of_a_circle_around_the_origin_meet_in_one_point() {
    let n = 1000_i32;
    let ends = (0..n).map(|i| (TAU * f64::from(i) / f64::from(2 * n)).sin_cos());
    let diameters: Vec<Segment> = ends.map(|(s, c)| segment([-c, -s], [c, s])).collect();
    let noded = check(&diameters, &[], Snap::Auto);
    assert_eq!(counts(&noded), [2001, 2000, 1]);
}

#[test]
fn a_star_whose_lines_nearly_meet_is_plane() {
    // Sines and cosines are not exact, and neither is the intended common point of the lines.
    let star = |n: i32, [x, y]: [f64; 2]| -> Vec<Segment> {
        let ray = |i: i32| (TAU * f64::from(i) / f64::from(n) / 2.0).sin_cos();
        (0..n).map(|i| (i, ray(i))).map(|(_, (s, c))| segment([x - c, y - s], [x + c, y + s])).collect()
    };
    assert!(is_plane(&check(&star(500, [0.1, 0.7]), &[], Snap::Auto)));
    let noded = check(&star(3000, [0.1, 0.7]), &[], Snap::Size(1e-9));
    assert_eq!(counts(&noded), [6001, 6000, 1]);
}

#[test]
fn overlaps_on_the_lines_of_a_grid_become_unit_edges() {
    let piece = |line: i32, from: i32, across: bool| {
        let [y, x, to] = [line, from, from + 3].map(f64::from);
        if across { segment([y, to], [y, x]) } else { segment([x, y], [to, y]) }
    };
    let pieces =
        (0..40).flat_map(|line| (0..50).flat_map(move |from| [false, true].map(|across| piece(line, from, across))));
    let noded = check(&pieces.collect::<Vec<_>>(), &[], Snap::Auto);
    // 40 lines each way, from 0 to 52.
    assert_eq!(counts(&noded), [2 * 40 * 53 - 40 * 40, 2 * 40 * 52, 1]);
    assert!(is_plane(&noded));
}

#[test]
fn thousands_of_segments_on_one_line_cost_and_give_thousands_of_edges() {
    let n = 5000_i32;
    let at = |i: i32| [3.0 * f64::from(i), 5.0 * f64::from(i)];
    // Nested: the chains have 25 million edges in total.
    let nested: Vec<Segment> = (0..n).map(|i| segment(at(i), at(2 * n - 1 - i))).collect();
    let noded = auto(&nested);
    assert_eq!(counts(&noded), [10_000, 9_999, 1]);
    assert_eq!((noded.summary.split, noded.summary.duplicates), (4_999, 0));
    assert!((0..5000).all(|i| noded.chain(i).unwrap().len() == 10_000 - 2 * i));
    assert!(noded.chain(4_000).unwrap().eq(4_000..6_000));
    // Overlapping in both directions, with repetitions.
    let overlapping: Vec<Segment> =
        (0..n).flat_map(|i| [segment(at(i), at(i + 3)), segment(at(i + 3), at(i))]).collect();
    let noded = check(&overlapping, &[], Snap::Auto);
    assert_eq!(counts(&noded), [5_003, 5_002, 1]);
    assert_eq!((noded.summary.split, noded.summary.duplicates), (10_000, 5_000));
}

#[test]
fn a_fan_of_near_parallels_keeps_its_blades() {
    let n = 3000_i32;
    let fan: Vec<Segment> = (0..n).map(|i| segment([0.0, 0.0], [1000.0, 1000.0 + f64::from(i) * 1e-7])).collect();
    let noded = check(&fan, &[], Snap::Auto);
    assert_eq!((counts(&noded), noded.summary.rounds), ([3001, 3000, 1], 0));
    // A cell is far wider than the distance of two blades, all the way.
    let coarse = check(&fan, &[], Snap::Size(1.0));
    assert_eq!(counts(&coarse), [2, 1, 1]);
    // Blades with ends at different lengths cut each other's corners.
    let ragged: Vec<Segment> =
        (0..600).map(|i| segment([0.0, 0.0], [1000.0 + f64::from(i * 37 % 100), 1000.0 + f64::from(i)])).collect();
    assert!(is_plane(&check(&ragged, &[], Snap::Size(4.0))));
}

#[test]
fn a_bundle_of_parallels_stays_apart_from_what_is_between() {
    // Long, slanted, adjacent lines, with short segments strewn between them over the whole length.
    let n = 2000_i32;
    let mut bundle: Vec<Segment> = (0..n).map(f64::from).map(|i| segment([i, -i], [1e9 + i, 1e9 - i])).collect();
    let strewn = (0..n).map(|i| (1e9 * (f64::from(i) + 0.5) / f64::from(n), f64::from(i * 7 % n) + 0.3));
    bundle.extend(strewn.clone().map(|(t, o)| segment([t + o, t - o], [t + o + 0.2, t - o + 0.1])));
    let noded = check(&bundle, &[], Snap::Auto);
    assert_eq!(counts(&noded), [8000, 4000, 4000]);
    // Each longer segment crosses one line, at the next whole number, or none.
    bundle.retain(|[a, b]| b.x - a.x > 1e8);
    bundle.extend(strewn.map(|(t, o)| segment([t + o, t - o], [t + o + 1.0, t - o - 1.0])));
    let noded = check(&bundle, &[], Snap::Auto);
    // All cross except the one beyond the last line.
    assert_eq!(counts(&noded), [8000 + 1999, 4000 + 2 * 1999, 2000 + 1]);
}

#[test]
fn spirals_stay_as_they_are_and_cross_as_often_as_they_should() {
    let corner = |i: i32, turn: f64| {
        let (s, c) = (TAU / 4.0 * (f64::from(i) + turn)).sin_cos();
        let r = f64::from(i) + 1.0;
        Point::new(c * r, s * r)
    };
    let spiral = |turn: f64| -> Vec<Segment> { (0..4000).map(|i| [corner(i, turn), corner(i + 1, turn)]).collect() };
    let noded = check(&spiral(0.2), &[], Snap::Auto);
    assert_eq!(counts(&noded), [4001, 4000, 1]);
    // Two of them, one turned by an eighth.
    let both: Vec<Segment> = spiral(0.2)[..300].iter().chain(&spiral(0.7)[..300]).copied().collect();
    assert!(is_plane(&check(&both, &[], Snap::Auto)));
    assert!(is_plane(&check(&both, &[], Snap::Size(2.0))));
}

#[test]
fn nested_squares_stay_apart_or_touch_at_corners() {
    let square = |corners: [[f64; 2]; 4]| [0, 1, 2, 3].map(|i| segment(corners[i], corners[(i + 1) % 4]));
    let upright = |r: f64| [[r, r], [-r, r], [-r, -r], [r, -r]];
    let slanted = |r: f64| [[r, 0.0], [0.0, r], [-r, 0.0], [0.0, -r]];
    for nest in [upright, slanted] {
        let squares: Vec<Segment> = (1..=1000).flat_map(|r| square(nest(f64::from(r) / 3.0))).collect();
        assert_eq!(counts(&check(&squares, &[], Snap::Auto)), [4000, 4000, 1000]);
    }
    // Each square is inscribed in the previous one, with its corners on the middles of the sides.
    let inscribed: Vec<Segment> = (0..40)
        .flat_map(|i| {
            let r = 2.0_f64.powi(45 - i);
            square(upright(r)).into_iter().chain(square(slanted(r)))
        })
        .collect();
    let noded = check(&inscribed, &[], Snap::Size(1.0));
    assert_eq!(counts(&noded), [4 * 80, 4 * 80 + 4 * 79, 1]);
    assert_eq!(noded.summary.crossings, 0);
}
