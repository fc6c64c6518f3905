//! C1 … C6: each rule is broken alone, compared with external values; random coverages are compared with plain arithmetic.
//!
//! Values beyond plain arithmetic come from shapely 2.2 with GEOS 3.14: `is_valid_reason`, `intersection`, `union_all`.
//! `tests/shapely` compares with the library itself.

use quickcheck::QuickCheck;
use twinedge_coverage::{Coverage, CoverageRule, DefectKind, Finding, Limits, check, defects};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::{Builder, Noding, PlanarMap, Shape};

fn ring(points: &[[f64; 2]]) -> Vec<Point> {
    points.iter().copied().map(Point::from).collect()
}

pub(crate) fn area([x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) -> Shape {
    Shape::polygon([[x0, y0], [x1, y0], [x1, y1], [x0, y1]])
}

pub(crate) fn map(shapes: &[Shape]) -> PlanarMap {
    let mut builder = Builder::new();
    for shape in shapes {
        builder.shape(shape).expect("in range");
    }
    let exact = builder.clone().build_with(Noding::Exact);
    exact.or_else(|_| builder.build_with(Noding::Snap(Snap::Auto))).expect("it fits")
}

fn found(shapes: &[Shape], limits: &Limits) -> Coverage {
    check(&map(shapes), limits).expect("it is plane")
}

fn only(shapes: &[Shape], limits: &Limits) -> (Finding, Vec<usize>) {
    let [finding] = &found(shapes, limits).findings[..] else {
        panic!("{:?}", found(shapes, limits).findings);
    };
    (finding.clone(), finding.features.iter().map(|feature| feature.index()).collect())
}

/// Gaps and near misses up to this width.
fn up_to(width: f64) -> Limits {
    Limits { gap_width: Some(width), ..Limits::default() }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

/// Three parcels of 10 by 10 in a row, and a fourth above the first two.
pub(crate) fn parcels() -> Vec<Shape> {
    vec![
        area([0.0, 0.0], [10.0, 10.0]),
        area([10.0, 0.0], [20.0, 10.0]),
        area([20.0, 0.0], [30.0, 10.0]),
        area([0.0, 10.0], [20.0, 20.0]),
    ]
}

#[test]
fn parcels_side_by_side_break_nothing() {
    assert_eq!(found(&parcels(), &Limits::default()).findings, []);
    // Lines are not checked, and neither is an empty map.
    let line = Shape::line([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]]);
    let other = Shape::line([[0.0, 0.0], [9.0, 9.0]]);
    assert_eq!(found(&[line, other], &Limits::default()).findings, []);
    assert_eq!(found(&[], &Limits::default()).findings, []);
}

#[test]
fn an_overlap_breaks_only_c1() {
    let mut shapes = parcels();
    shapes[2] = area([19.5, 0.0], [30.0, 10.0]);
    let (finding, features) = only(&shapes, &Limits::default());
    assert_eq!((finding.rule, features), (CoverageRule::Overlap, vec![1, 2]));
    assert!(near(finding.area, 5.0) && near(finding.length, 21.0) && near(finding.width, 10.0 / 21.0));
    assert!((19.5..20.0).contains(&finding.at.x) && (0.0..10.0).contains(&finding.at.y), "{:?}", finding.at);
    assert_eq!(finding.faces.len(), 1);
}

#[test]
fn overlaps_of_different_features_are_different_findings() {
    let shapes = [area([0.0, 0.0], [10.0, 10.0]), area([8.0, 0.0], [20.0, 5.0]), area([8.0, 5.0], [20.0, 10.0])];
    let findings = found(&shapes, &Limits::default()).findings;
    let found: Vec<_> =
        findings.iter().map(|f| (f.rule, f.features.iter().map(|f| f.index()).collect(), f.area)).collect();
    assert_eq!(found, [(CoverageRule::Overlap, vec![0, 1], 10.0), (CoverageRule::Overlap, vec![0, 2], 10.0)]);
}

#[test]
fn an_overlap_of_slanted_borders_has_the_area_of_the_intersection() {
    // Polygon([(0, 0), (4, 0), (0, 3)]) and Polygon([(1, 1), (4, 1), (1, 4)]) have this intersection in shapely.
    let one = Shape::polygon([[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]]);
    let other = Shape::polygon([[1.0, 1.0], [4.0, 1.0], [1.0, 4.0]]);
    let (finding, _) = only(&[one, other], &Limits::default());
    // The triangle (1, 1), (8/3, 1), (1, 9/4).
    assert!(near(finding.area, 25.0 / 24.0), "{}", finding.area);
}

#[test]
fn a_gap_breaks_only_c2() {
    let mut shapes = parcels();
    shapes[3] =
        Shape::polygon([[0.0, 10.0], [9.0, 10.0], [10.0, 10.5], [11.0, 10.0], [20.0, 10.0], [20.0, 20.0], [0.0, 20.0]]);
    let (finding, features) = only(&shapes, &Limits::default());
    assert_eq!((finding.rule, features), (CoverageRule::Gap, vec![0, 1, 3]));
    assert!(near(finding.area, 0.5) && near(finding.length, 2.0 + 2.0 * 1.25_f64.sqrt()));
    // A gap wider than the limit is intended.
    let coverage = found(&shapes, &up_to(finding.width * 0.99));
    assert_eq!(coverage.findings, []);
    assert_eq!(coverage.wider_gaps.len(), 1);
    assert_eq!(found(&shapes, &up_to(finding.width * 1.01)).of(CoverageRule::Gap).count(), 1);
}

/// A spindle-shaped gap between two features comes to a point at both ends. As a whole it is wider than the limit.
#[test]
fn the_tips_of_a_wide_gap_are_no_near_misses() {
    let shapes = [
        [[0.0, -20.0], [100.0, -20.0], [100.0, 0.0], [90.0, 0.0], [50.0, -5.0], [10.0, 0.0], [0.0, 0.0]],
        [[0.0, 0.0], [10.0, 0.0], [50.0, 5.0], [90.0, 0.0], [100.0, 0.0], [100.0, 20.0], [0.0, 20.0]],
    ];
    let shapes = shapes.map(Shape::polygon);
    let coverage = found(&shapes, &up_to(1.0));
    assert_eq!(coverage.findings, []);
    assert_eq!(coverage.wider_gaps.len(), 1);
    assert!(near(coverage.wider_gaps[0].area, 400.0));
}

#[test]
fn a_line_does_not_close_a_gap_and_does_not_cut_one() {
    // A bay between three parcels, closed by a line.
    let bay = [
        area([0.0, 0.0], [30.0, 10.0]),
        area([0.0, 10.0], [10.0, 20.0]),
        area([20.0, 10.0], [30.0, 20.0]),
        Shape::line([[10.0, 20.0], [20.0, 20.0]]),
    ];
    assert_eq!(found(&bay, &Limits::default()).findings, []);
    // A lake with a line across it is one gap.
    let lake = area([0.0, 0.0], [30.0, 30.0]).hole([[10.0, 10.0], [10.0, 20.0], [20.0, 20.0], [20.0, 10.0]]);
    let ferry = Shape::line([[10.0, 10.0], [20.0, 20.0]]);
    let (finding, _) = only(&[lake, ferry], &Limits::default());
    assert_eq!((finding.rule, finding.faces.len(), finding.area), (CoverageRule::Gap, 2, 100.0));
}

#[test]
fn a_strip_open_to_the_outside_breaks_only_c3() {
    let mut shapes = parcels();
    shapes[2] = area([20.05, 0.0], [30.0, 10.0]);
    // The fourth parcel does not reach the strip, which is open at both ends.
    let (finding, features) = only(&shapes, &Limits::default());
    assert_eq!((finding.rule, features), (CoverageRule::NearMiss, vec![1, 2]));
    assert!(near(finding.area, 0.5) && near(finding.length, 20.0) && near(finding.width, 0.05), "{finding:?}");
    assert!((20.0..20.05).contains(&finding.at.x));
    for (width, count) in [(0.049, 0), (0.051, 1)] {
        assert_eq!(found(&shapes, &up_to(width)).of(CoverageRule::NearMiss).count(), count, "{width}");
    }
}

#[test]
fn a_strip_along_many_short_edges_is_one_near_miss() {
    // A winding border, and the same shifted by 0.01.
    let bends = 50;
    let winding =
        |shift: f64| (0..=bends).map(move |i| [f64::from(i % 2) * 0.3 + shift, f64::from(i)]).collect::<Vec<_>>();
    let mut west = vec![[-10.0, 50.0], [-10.0, 0.0]];
    west.extend(winding(0.0));
    let mut east = winding(0.01);
    east.extend([[20.0, 50.0], [20.0, 0.0]]);
    let shapes = [west, east].map(Shape::polygon);
    let (finding, features) = only(&shapes, &up_to(0.02));
    assert_eq!((finding.rule, features), (CoverageRule::NearMiss, vec![0, 1]));
    // Each edge lies opposite an edge of the other border, except for the shift along it.
    let (edge, shift) = (1.09_f64.sqrt(), 0.01);
    let opposite = 100.0 * (edge - shift * 0.3 / edge);
    assert!(near(finding.length, opposite) && near(finding.width, shift / edge), "{finding:?}");
    assert!(near(finding.area, opposite / 2.0 * shift / edge), "{finding:?}");
}

/// Five features around a lake of 10 by 10, two of them with a crack between.
fn around_a_lake() -> [Shape; 5] {
    let shapes = [
        vec![[0.0, 0.0], [30.0, 0.0], [30.0, 10.0], [20.0, 10.0], [10.0, 10.0], [0.0, 10.0]],
        vec![[0.0, 20.0], [10.0, 20.0], [20.0, 20.0], [30.0, 20.0], [30.0, 30.0], [0.0, 30.0]],
        vec![[0.0, 10.0], [10.0, 10.0], [10.0, 14.99], [0.0, 15.0]],
        vec![[0.0, 15.0], [10.0, 15.01], [10.0, 20.0], [0.0, 20.0]],
        vec![[20.0, 10.0], [30.0, 10.0], [30.0, 20.0], [20.0, 20.0]],
    ];
    shapes.map(Shape::polygon)
}

/// Features around a lake, and a crack between two of them that begins at the outside and ends at the lake. GEOS 3.14:
/// `coverage_invalid_edges` contains edges of both from a `gap_width` of 0.02 on.
#[test]
fn a_crack_that_opens_into_a_lake_is_a_near_miss() {
    let shapes = around_a_lake();
    for (width, count) in [(0.019, 0), (0.1, 1), (1.0, 1)] {
        let coverage = found(&shapes, &up_to(width));
        assert_eq!((coverage.findings.len(), coverage.wider_gaps.len()), (count, 1), "{width}");
    }
    let (finding, features) = only(&shapes, &up_to(0.1));
    assert_eq!((finding.rule, features), (CoverageRule::NearMiss, vec![2, 3]));
    assert!((finding.area - 0.1).abs() < 1e-6 && (finding.width - 0.01).abs() < 1e-6, "{finding:?}");
}

#[test]
fn gaps_are_accepted_by_place_and_by_width() {
    let shapes = around_a_lake();
    let counts = |limits: &Limits| {
        let coverage = found(&shapes, limits);
        let count = |rule| coverage.of(rule).count();
        let kept = [coverage.wider_gaps.len(), coverage.accepted_gaps.len()];
        ([count(CoverageRule::Gap), count(CoverageRule::NearMiss)], kept)
    };
    let limits = |gap_width, lake_width, accepted: &[[f64; 2]]| {
        let accepted_gaps = accepted.iter().copied().map(Point::from).collect();
        Limits { gap_width, lake_width, accepted_gaps, ..Limits::default() }
    };
    assert_eq!(counts(&limits(None, None, &[])), ([1, 0], [0, 0]));
    // Accepted gaps, and gaps wider than the limit, are searched for near misses.
    assert_eq!(counts(&limits(None, Some(3.0), &[])), ([0, 1], [1, 0]));
    assert_eq!(counts(&limits(Some(0.1), Some(6.0), &[])), ([1, 1], [0, 0]));
    assert_eq!(counts(&limits(None, None, &[[15.0, 15.0]])), ([0, 1], [0, 1]));
    assert_eq!(counts(&limits(Some(6.0), None, &[[15.0, 15.0], [12.0, 12.0]])), ([0, 0], [0, 1]));
    // Outside, on an edge and in a feature there is no gap.
    let none = [[-1.0, 0.0], [10.0, 10.0], [15.0, 10.0], [5.0, 5.0], [f64::NAN, 0.0]];
    assert_eq!(counts(&limits(None, None, &none)), ([1, 0], [0, 0]));
}

/// A notch between two features, 50 long and 8 wide at its mouth. GEOS 3.14 finds nothing in it at widths from 1e-6 to 7.8, and
/// both sides from 7.9 on. With many points on the sides it finds the edges that are longer than the width.
#[test]
fn a_notch_is_no_near_miss() {
    let notch = |points: i32| {
        let side = |x: f64| {
            let part = move |i: i32| f64::from(i) / f64::from(points);
            (0..=points).map(move |i| [50.0 + x * part(i), 50.0 + 50.0 * part(i)]).collect::<Vec<_>>()
        };
        let mut west = vec![[0.0, 100.0], [0.0, 0.0], [50.0, 0.0]];
        west.extend(side(-4.0));
        let mut east = side(4.0);
        east.reverse();
        east.extend([[50.0, 0.0], [100.0, 0.0], [100.0, 100.0]]);
        [west, east].map(Shape::polygon)
    };
    let count = |points, width| found(&notch(points), &up_to(width)).findings.len();
    for width in [1e-6, 1e-3, 0.1, 0.5, 1.0, 2.0, 5.0, 7.8] {
        assert_eq!(count(1, width), 0, "{width}");
    }
    assert_eq!(count(1, 7.9), 1);
    for width in [0.5, 1.0, 2.0, 5.0] {
        assert_eq!(count(400, width), 0, "{width}");
    }
}

/// A strip of 1e-9 between two features, whose corners are cut off at its ends.
#[test]
fn the_width_of_a_near_miss_is_not_that_of_its_ends() {
    let strip = 1e-9;
    for cut in [0.01, 0.3, 0.9] {
        let shapes = [
            vec![[-10.0, 0.0], [-cut, 0.0], [0.0, cut], [0.0, 10.0 - cut], [-cut, 10.0], [-10.0, 10.0]],
            vec![[strip + cut, 0.0], [10.0, 0.0], [10.0, 10.0], [strip + cut, 10.0], [strip, 10.0 - cut], [strip, cut]],
        ];
        for width in [1e-6, 1e-3, 0.1, 1.0] {
            let (finding, _) = only(&shapes.clone().map(Shape::polygon), &up_to(width));
            assert!((finding.width / strip - 1.0).abs() < 1e-3, "{cut}, {width}: {finding:?}");
            assert!((finding.area / (strip * (10.0 - 2.0 * cut)) - 1.0).abs() < 1e-3, "{cut}, {width}: {finding:?}");
        }
    }
}

/// The width is measured across slanted borders, even if their boxes overlap.
#[test]
fn slanted_borders_are_as_far_apart_as_they_are() {
    let shift = 0.15 / std::f64::consts::SQRT_2;
    let shapes = [
        [[0.0, 0.0], [10.0, 10.0], [0.0, 10.0]],
        [[shift, -shift], [10.0 + shift, -shift], [10.0 + shift, 10.0 - shift]],
    ];
    let shapes = shapes.map(Shape::polygon);
    for (width, count) in [(0.149, 0), (0.151, 1)] {
        assert_eq!(found(&shapes, &up_to(width)).of(CoverageRule::NearMiss).count(), count, "{width}");
    }
}

/// The lake of 0 and 1 has a narrow arm, and a strip between 1 and 2 is open to the outside. A feature beyond 1 is no neighbour.
///
/// ```text
///   0000 1 222222
///   0    1 222222
///   0    1           the strip
///   0    11111111
///   0               0   the arm
///   000000000000000
/// ```
#[test]
fn borders_of_different_spaces_are_no_near_miss() {
    let shapes = [
        vec![
            [-1.0, -5.0],
            [21.0, -5.0],
            [21.0, 4.3],
            [20.0, 4.3],
            [20.0, 4.0],
            [9.0, 4.0],
            [9.0, 0.0],
            [0.0, 0.0],
            [0.0, 10.0],
            [9.0, 10.0],
            [9.0, 12.0],
            [-1.0, 12.0],
        ],
        vec![[9.0, 4.3], [21.0, 4.3], [21.0, 4.6], [10.0, 4.6], [10.0, 12.0], [9.0, 12.0]],
        vec![[10.0, 4.9], [21.0, 4.9], [21.0, 12.0], [10.0, 12.0]],
    ];
    let shapes = shapes.map(Shape::polygon);
    let coverage = found(&shapes, &up_to(1.0));
    let mut pairs: Vec<Vec<usize>> = coverage
        .of(CoverageRule::NearMiss)
        .map(|finding| finding.features.iter().map(|feature| feature.index()).collect())
        .collect();
    pairs.sort_unstable();
    assert_eq!(pairs, [[0, 1], [1, 2]]);
    assert_eq!(coverage.wider_gaps.len(), 1);
}

#[test]
fn borders_that_part_at_a_vertex_are_no_near_miss() {
    let limits = up_to(0.1);
    // At 45 degrees, and at 6 degrees.
    for rise in [10.0, 1.0] {
        let low = area([0.0, -10.0], [10.0, 0.0]);
        let high = Shape::polygon([[0.0, 0.0], [10.0, rise], [10.0, 20.0], [0.0, 20.0]]);
        assert_eq!(found(&[low, high], &limits).findings, [], "{rise}");
    }
    // A strip that is shorter than the width.
    let short = [area([0.0, 0.0], [10.0, 0.09]), area([10.08, 0.0], [20.0, 0.09])];
    assert_eq!(found(&short, &limits).of(CoverageRule::NearMiss).count(), 0);
    // Two parts of one feature are no neighbours.
    let mut builder = Builder::new();
    let shapes = vec![area([0.0, 0.0], [10.0, 10.0]), area([10.05, 0.0], [20.0, 10.0])];
    builder.feature(&twinedge_map::Feature { shapes, ..Default::default() }).expect("in range");
    assert_eq!(check(&builder.build().expect("small"), &limits).expect("plane").findings, []);
}

#[test]
fn a_thin_part_breaks_only_c4() {
    let mut shapes = parcels();
    shapes.push(area([0.0, -0.01], [5.0, 0.0]));
    let (finding, features) = only(&shapes, &Limits::default());
    assert_eq!((finding.rule, features), (CoverageRule::Sliver, vec![4]));
    assert!(near(finding.area, 0.05) && near(finding.length, 10.02));
    let count = |area, thinness| {
        let limits = Limits { sliver_area: Some(area), thinness, ..Limits::default() };
        found(&shapes, &limits).of(CoverageRule::Sliver).count()
    };
    assert_eq!((count(0.04, 0.2), count(0.06, 0.2), count(0.06, 0.001)), (0, 1, 0));
}

#[test]
fn the_same_polygon_twice_breaks_only_c5() {
    let mut shapes = parcels();
    shapes.push(shapes[1].clone());
    shapes.push(shapes[1].clone());
    let (finding, features) = only(&shapes, &Limits::default());
    assert_eq!((finding.rule, features, finding.area), (CoverageRule::Duplicate, vec![1, 4, 5], 100.0));
    // An area that overlaps one of them overlaps them all, and is found once.
    shapes.push(area([19.0, 4.0], [20.0, 5.0]));
    let findings = found(&shapes, &Limits::default()).findings;
    let rules: Vec<CoverageRule> = findings.iter().map(|f| f.rule).collect();
    assert_eq!(rules, [CoverageRule::Overlap, CoverageRule::Duplicate]);
    // The finding names all of them.
    assert_eq!(findings[0].features.iter().map(|f| f.index()).collect::<Vec<_>>(), [1, 4, 5, 6]);
}

type Polygon = Vec<Vec<[f64; 2]>>;

/// The verdicts of shapely on polygons, in the terms of GEOS.
#[test]
fn polygons_are_invalid_for_the_reason_that_geos_gives() {
    use DefectKind::{
        DisconnectedInterior, HoleOutsideShell, NestedHoles, NestedShells, RingSelfIntersection, SelfIntersection,
        TooFewPoints,
    };
    let square = |low: f64, high: f64| vec![[low, low], [high, low], [high, high], [low, high], [low, low]];
    let bow_tie = vec![[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0], [0.0, 0.0]];
    let touching = vec![[0.0, 0.0], [4.0, 0.0], [2.0, 2.0], [4.0, 4.0], [0.0, 4.0], [2.0, 2.0], [0.0, 0.0]];
    let spike = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [6.0, 2.0], [4.0, 2.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]];
    let across = vec![[0.0, 2.0], [2.0, 1.0], [4.0, 2.0], [2.0, 3.0], [0.0, 2.0]];
    let inside = vec![[0.0, 2.0], [2.0, 1.0], [3.0, 2.0], [2.0, 3.0], [0.0, 2.0]];
    let low = vec![[0.0, 0.0], [2.0, -1.0], [4.0, 0.0], [2.0, 0.5], [0.0, 0.0]];
    let high = vec![[0.0, 0.0], [2.0, 1.0], [4.0, 0.0], [2.0, 3.0], [0.0, 0.0]];
    let through_corners = vec![[2.0, 2.0], [4.0, 0.0], [6.0, 2.0], [4.0, 4.0], [2.0, 2.0]];
    let notched = vec![[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [6.0, 4.0], [4.0, 2.0], [2.0, 4.0], [0.0, 8.0], [0.0, 0.0]];
    let in_the_notch = vec![[0.0, 8.0], [4.0, 2.0], [8.0, 8.0], [0.0, 8.0]];
    let cases: Vec<(&str, Vec<Polygon>, Option<DefectKind>)> = vec![
        ("polygons touch twice", vec![vec![low], vec![high]], None),
        ("hole crosses at corners", vec![vec![square(0.0, 4.0), through_corners]], Some(SelfIntersection)),
        ("in a notch", vec![vec![notched.clone()], vec![in_the_notch.clone()]], None),
        ("hole in a notch", vec![vec![notched, in_the_notch]], Some(HoleOutsideShell)),
        ("valid", vec![vec![square(0.0, 9.0), square(1.0, 2.0)]], None),
        ("hole touches the shell", vec![vec![square(0.0, 4.0), inside]], None),
        ("island in a hole", vec![vec![square(0.0, 9.0), square(1.0, 8.0)], vec![square(2.0, 7.0)]], None),
        ("bow tie", vec![vec![bow_tie]], Some(SelfIntersection)),
        ("touch", vec![vec![touching]], Some(RingSelfIntersection)),
        ("spike", vec![vec![spike]], Some(SelfIntersection)),
        ("line", vec![vec![vec![[0.0, 0.0], [1.0, 1.0], [0.0, 0.0]]]], Some(TooFewPoints)),
        ("hole outside", vec![vec![square(0.0, 4.0), square(5.0, 6.0)]], Some(HoleOutsideShell)),
        ("hole around", vec![vec![square(1.0, 2.0), square(0.0, 4.0)]], Some(HoleOutsideShell)),
        ("holes", vec![vec![square(0.0, 9.0), square(1.0, 8.0), square(2.0, 7.0)]], Some(NestedHoles)),
        ("cut in two", vec![vec![square(0.0, 4.0), across]], Some(DisconnectedInterior)),
        ("shells", vec![vec![square(0.0, 9.0)], vec![square(1.0, 2.0)]], Some(NestedShells)),
        ("crossing shells", vec![vec![square(0.0, 3.0)], vec![square(2.0, 4.0)]], Some(SelfIntersection)),
        (
            "shared border",
            vec![vec![square(0.0, 2.0)], vec![vec![[2.0, 0.0], [4.0, 0.0], [2.0, 2.0], [2.0, 0.0]]]],
            Some(SelfIntersection),
        ),
        ("same hole twice", vec![vec![square(0.0, 9.0), square(1.0, 2.0), square(1.0, 2.0)]], Some(SelfIntersection)),
    ];
    for (name, polygons, expected) in cases {
        let shapes: Vec<Shape> =
            polygons.iter().map(|rings| Shape::Polygon(rings.iter().map(|r| ring(r)).collect())).collect();
        let kinds: Vec<DefectKind> = defects(&shapes).iter().map(|defect| defect.kind).collect();
        assert_eq!(kinds.first().copied(), expected, "{name}");
        // The spike also touches its own foot.
        assert!(name == "spike" || kinds.windows(2).all(|pair| pair[0] == pair[1]), "{name}: {kinds:?}");
        // Without the points that repeat the first one, only the open rings are added.
        let open: Vec<Shape> = polygons
            .iter()
            .map(|rings| Shape::Polygon(rings.iter().map(|r| ring(&r[..r.len() - 1])).collect()))
            .collect();
        let is_other = |kind: &DefectKind| *kind != DefectKind::OpenRing;
        let of_open = defects(&open).into_iter().map(|defect| defect.kind).filter(is_other).count();
        assert_eq!(of_open, kinds.len(), "{name}");
    }
}

#[test]
fn an_open_ring_is_a_defect_with_its_gap() {
    let corners = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0]];
    let open = Shape::Polygon(vec![ring(&corners), ring(&[[6.0, 1.0], [7.0, 1.0], [7.0, 2.0], [6.0, 1.0]])]);
    let found = defects(&[open]);
    let [defect] = found[..] else { panic!("{found:?}") };
    assert_eq!((defect.kind, defect.shape, defect.ring), (DefectKind::OpenRing, 0, 0));
    assert_eq!((defect.at, defect.gap_to), (Point::new(9.0, 9.0), Some(Point::new(0.0, 0.0))));
    // A shape made from corners is closed.
    assert_eq!(defects(&[Shape::polygon(corners)]), []);
}

/// Three rings that touch at one point leave the inside in one piece.
#[test]
fn rings_that_touch_at_minus_zero_touch_at_zero() {
    let shell = [[0.0, 0.0], [10.0, -10.0], [10.0, 10.0]];
    let holes = |zero: f64| [[[zero, 0.0], [6.0, 3.0], [6.0, 1.0]], [[0.0, 0.0], [6.0, -1.0], [6.0, -3.0]]];
    let bow_tie = |zero: f64| [[zero, 0.0], [2.0, 1.0], [2.0, -1.0], [0.0, 0.0], [-2.0, -1.0], [-2.0, 1.0]];
    for zero in [0.0, -0.0] {
        let [one, other] = holes(zero);
        assert_eq!(defects(&[Shape::polygon(shell).hole(one).hole(other)]), []);
        let [defect] = defects(&[Shape::polygon(bow_tie(zero))])[..] else { panic!("a place is reported once") };
        assert_eq!((defect.kind, defect.at), (DefectKind::RingSelfIntersection, Point::new(0.0, 0.0)));
    }
}

#[test]
fn a_ring_all_points_of_which_lie_on_another_is_located() {
    // A diamond with its points on the middles of the sides of a square, as a hole and as a second shell.
    let square = [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 2.0], [4.0, 4.0], [2.0, 4.0], [0.0, 4.0], [0.0, 2.0]];
    let mut diamond = [[2.0, 0.0], [4.0, 2.0], [2.0, 4.0], [0.0, 2.0]];
    let kinds = |shapes: &[Shape]| defects(shapes).iter().map(|defect| defect.kind).collect::<Vec<_>>();
    for _ in 0..2 {
        let (in_square, in_diamond) = (Shape::polygon(square), Shape::polygon(diamond));
        assert_eq!(kinds(&[in_square.clone().hole(diamond)]), [DefectKind::DisconnectedInterior]);
        // A point of the hole on each side of a triangle around it: the hole lies outside.
        assert_eq!(kinds(&[in_diamond.clone().hole(square)]), [DefectKind::HoleOutsideShell]);
        assert_eq!(kinds(&[in_square, in_diamond]), [DefectKind::NestedShells]);
        // The diamond, turned the other way.
        diamond.reverse();
    }
}

/// On a board of 4 by 4 cells, each claimed by some of three features, overlaps and gaps have the areas of their cells.
fn areas_are_those_of_the_cells(cells: Vec<u8>) -> bool {
    let at = |x: usize, y: usize| -> u8 {
        cells.get(4 * x + y).map_or(1, |cell| [1, 2, 4, 1, 2, 4, 0, 3, 5, 7][usize::from(cell % 10)])
    };
    let mut builder = Builder::new();
    for feature in 0..3 {
        let mut shapes = Vec::new();
        for (x, y) in (0..4).flat_map(|x| (0..4).map(move |y| (x, y))) {
            if at(x, y) & 1 << feature != 0 {
                shapes.push(area([x as f64, y as f64], [x as f64 + 1.0, y as f64 + 1.0]));
            }
        }
        builder.feature(&twinedge_map::Feature { shapes, ..Default::default() }).expect("in range");
    }
    let coverage = check(&builder.build().expect("small"), &Limits::default()).expect("plane");
    let sum = |rule| coverage.of(rule).map(|finding| finding.area).sum::<f64>();
    let claimed_twice = (0..16).filter(|cell| at(cell / 4, cell % 4).count_ones() > 1).count() as f64;
    // Without features that claim the same cells, all area claimed twice is an overlap.
    let duplicates = coverage.of(CoverageRule::Duplicate).count() > 0;
    // Unclaimed cells without a path across sides to the border of the board.
    let mut open = [false; 16];
    for _ in 0..16 {
        for cell in 0..16 {
            let (x, y) = (cell / 4, cell % 4);
            let border = x == 0 || y == 0 || x == 3 || y == 3;
            let beside = || {
                [(x > 0, 4), (y > 0, 1)].into_iter().any(|(has, by)| has && open[cell - by])
                    || [(x < 3, 4), (y < 3, 1)].into_iter().any(|(has, by)| has && open[cell + by])
            };
            open[cell] = at(x, y) == 0 && (border || beside());
        }
    }
    let gaps = (0..16).filter(|cell| at(cell / 4, cell % 4) == 0 && !open[*cell]).count() as f64;
    (duplicates || near(sum(CoverageRule::Overlap), claimed_twice)) && near(sum(CoverageRule::Gap), gaps)
}

#[test]
fn overlaps_and_gaps_agree_with_the_cells() {
    QuickCheck::new().tests(1_000).quickcheck(areas_are_those_of_the_cells as fn(Vec<u8>) -> bool);
}
