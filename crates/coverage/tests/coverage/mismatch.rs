//! C7: coinciding borders with different nodes, compared with an external value and, on random boxes, with plain arithmetic.

use quickcheck::QuickCheck;
use twinedge_coverage::{CoverageRule, Finding, Limits, check, insert_touches, mismatches};
use twinedge_geometry::Point;
use twinedge_map::{Builder, Feature, Noding, Shape};

use super::coverage::{area, map, parcels};

/// The findings of C7, and all others.
fn mismatched(shapes: &[Shape]) -> (Vec<Finding>, Vec<Finding>) {
    let mut builder = Builder::new();
    for shape in shapes {
        builder.shape(shape).expect("in range");
    }
    let map = map(shapes);
    let others = check(&map, &Limits::default()).expect("it is plane").findings;
    (mismatches(&map, &builder.unmatched()).expect("it is plane"), others)
}

/// The missing vertices, with the feature that lacks each.
fn lacked(found: &[Finding]) -> Vec<([f64; 2], usize)> {
    found.iter().flat_map(|one| &one.missing).map(|vertex| (vertex.at.into(), vertex.feature.index())).collect()
}

/// The input of <https://github.com/libgeos/geos/issues/1525>: `coverage_is_valid` is false, and the polygons share no area.
#[test]
fn borders_with_different_vertices_break_only_c7() {
    let one = Shape::polygon([[1.0, 0.0], [1.0, 1.0], [1.0, 3.0], [4.0, 0.0]]);
    let other = Shape::polygon([[0.0, 4.0], [1.0, 3.0], [1.0, 0.0]]);
    let (found, others) = mismatched(&[one, other]);
    assert_eq!((found.len(), others), (1, vec![]));
    assert_eq!((found[0].rule, found[0].length, found[0].at), (CoverageRule::Mismatch, 3.0, Point::new(1.0, 1.0)));
    assert_eq!(found[0].features.iter().map(|f| f.index()).collect::<Vec<_>>(), [0, 1]);
    assert_eq!(lacked(&found), [([1.0, 1.0], 1)]);
    assert_eq!(found[0].stretches, [[Point::new(1.0, 0.0), Point::new(1.0, 3.0)]]);
}

#[test]
fn a_corner_beside_the_side_of_a_neighbour_is_a_mismatch() {
    // The fourth parcel lacks the vertex at which the first two meet. Each of these two has a finding with it.
    let (found, others) = mismatched(&parcels());
    assert_eq!((lacked(&found), others), (vec![([10.0, 10.0], 3), ([10.0, 10.0], 3)], vec![]));
    let features: Vec<Vec<usize>> =
        found.iter().map(|one| one.features.iter().map(|feature| feature.index()).collect()).collect();
    assert_eq!(features, [[0, 3], [1, 3]]);
    // Borders that only touch.
    let spire = Shape::polygon([[3.0, 10.0], [6.0, 15.0], [0.0, 15.0]]);
    assert_eq!(lacked(&mismatched(&[area([0.0, 0.0], [10.0, 10.0]), spire]).0), [([3.0, 10.0], 0)]);
    // A feature that fills a hole and has more vertices than the hole, and the reverse.
    let ring = area([0.0, 0.0], [9.0, 9.0]).hole([[3.0, 3.0], [3.0, 6.0], [6.0, 6.0], [6.0, 4.0], [6.0, 3.0]]);
    let filling = Shape::polygon([[3.0, 3.0], [4.0, 3.0], [6.0, 3.0], [6.0, 6.0], [3.0, 6.0]]);
    assert_eq!(lacked(&mismatched(&[ring, filling]).0), [([4.0, 3.0], 0), ([6.0, 4.0], 1)]);
}

#[test]
fn borders_that_meet_since_features_overlap_are_no_mismatch() {
    let left = area([0.0, 0.0], [10.0, 10.0]);
    let (found, others) = mismatched(&[left.clone(), area([9.0, 0.0], [20.0, 10.0])]);
    assert_eq!((found.len(), others[0].rule), (0, CoverageRule::Overlap));
    // From inside, along a side.
    assert_eq!(mismatched(&[left.clone(), area([3.0, 0.0], [6.0, 2.0])]).0, []);
    // The square with one more vertex.
    let again = Shape::polygon([[0.0, 0.0], [5.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]);
    let (found, others) = mismatched(&[left.clone(), again]);
    assert_eq!((found.len(), others[0].rule), (0, CoverageRule::Duplicate));
    // Lines are no borders.
    assert_eq!(mismatched(&[left, Shape::line([[10.0, 5.0], [15.0, 5.0]])]).0, []);
}

#[test]
fn rings_of_one_feature_lack_vertices_too_unless_the_ogc_allows_the_touch() {
    let found = |mut shapes: Vec<Shape>| {
        insert_touches(&mut shapes);
        let mut builder = Builder::new();
        builder.feature(&Feature { shapes, ..Default::default() }).expect("in range");
        let unmatched = builder.unmatched();
        let is_plane = builder.clone().build().expect("small").is_plane();
        let map = builder.build_with(Noding::Exact).expect("nothing crosses");
        (mismatches(&map, &unmatched).expect("it is plane"), is_plane)
    };
    // Parts with a common border; one lacks the corners of the other.
    let square = area([0.0, 0.0], [10.0, 10.0]);
    let (all, is_plane) = found(vec![square.clone(), area([10.0, 2.0], [20.0, 5.0])]);
    assert_eq!(lacked(&all), [([10.0, 2.0], 0), ([10.0, 5.0], 0)]);
    assert_eq!((all[0].features.len(), is_plane), (1, false));
    // A hole that touches the middle of a side, a part that touches another one, and holes that touch each other.
    let hole = [[0.0, 5.0], [3.0, 4.0], [3.0, 6.0]];
    let second = [[3.0, 5.0], [6.0, 4.0], [6.0, 6.0]];
    assert_eq!(found(vec![square.clone().hole(hole)]), (vec![], true));
    assert_eq!(found(vec![square.clone(), Shape::polygon([[10.0, 5.0], [13.0, 4.0], [13.0, 6.0]])]), (vec![], true));
    assert_eq!(found(vec![square.clone().hole(hole).hole(second)]), (vec![], true));
    // Two touches cut the inside in two, which the OGC does not allow.
    let across = [[0.0, 5.0], [5.0, 4.0], [10.0, 5.0], [5.0, 6.0]];
    assert_eq!(lacked(&found(vec![square.clone().hole(across)]).0), [([0.0, 5.0], 0), ([10.0, 5.0], 0)]);
    // Several touches on one side, in both directions, and on the last side of an open ring.
    let open = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]].map(Point::from).to_vec();
    let teeth = |x: f64| [[x, x], [x + 1.0, x - 0.5], [x + 1.0, x]];
    for reversed in [false, true] {
        let mut shell = open.clone();
        if reversed {
            shell.reverse();
        }
        let Shape::Polygon(rings) = Shape::Polygon(vec![shell]).hole(teeth(7.0)).hole(teeth(2.0)).hole(teeth(4.0))
        else {
            unreachable!("it is a polygon")
        };
        let mut shapes = vec![Shape::Polygon(rings)];
        assert!(insert_touches(&mut shapes));
        let Shape::Polygon(rings) = &shapes[0] else { unreachable!("it is a polygon") };
        let on_diagonal = rings[0].iter().filter(|p| p.x.total_cmp(&p.y).is_eq()).map(|p| p.x).collect::<Vec<_>>();
        let expected = if reversed { [10.0, 0.0, 2.0, 4.0, 7.0] } else { [0.0, 10.0, 7.0, 4.0, 2.0] };
        assert_eq!(on_diagonal, expected);
        assert_eq!(found(shapes), (vec![], true));
    }
}

/// A vertex rounded to a grid is still identified with its input point, even if coordinates have all their digits.
#[test]
fn an_overlap_beside_a_crossing_is_no_mismatch_on_a_grid() {
    let x = 0.1;
    let left = area([x, 0.3], [10.7, 10.3]);
    // Its corners (9.1, 0.3) and (9.1, 10.3) lie on sides of the first one, and the third one crosses both.
    let right = area([9.1, 0.3], [20.3, 10.3]);
    let across = Shape::polygon([[5.3, -1.7], [15.9, 12.1], [15.9, 12.3], [5.3, 12.9]]);
    let (found, others) = mismatched(&[left, right, across]);
    assert!(others.iter().any(|one| one.rule == CoverageRule::Overlap));
    assert_eq!(found, []);
}

#[test]
fn mismatches_are_those_of_plain_arithmetic() {
    /// A rectangle, and further vertices on its border.
    #[derive(Clone, Debug)]
    struct Box {
        low: [i32; 2],
        high: [i32; 2],
        vertices: Vec<[i32; 2]>,
    }
    /// The points of the border, in order.
    fn around([x0, y0]: [i32; 2], [x1, y1]: [i32; 2]) -> Vec<[i32; 2]> {
        let south = (x0..x1).map(|x| [x, y0]);
        let east = (y0..y1).map(|y| [x1, y]);
        let north = (x0 + 1..=x1).rev().map(|x| [x, y1]);
        let west = (y0 + 1..=y1).rev().map(|y| [x0, y]);
        south.chain(east).chain(north).chain(west).collect()
    }
    fn boxes(seeds: &[(u8, u8, u8)]) -> Vec<Box> {
        let of = |(place, size, kept): &(u8, u8, u8)| {
            let low = [i32::from(place % 5) * 2, i32::from(place / 5 % 5) * 2];
            let high = [low[0] + 1 + i32::from(size % 4), low[1] + 1 + i32::from(size / 4 % 4)];
            let is_corner = |p: &[i32; 2]| (0..2).all(|i| p[i] == low[i] || p[i] == high[i]);
            let mut vertices = around(low, high);
            let mut n = 0;
            vertices.retain(|p| {
                n += 1;
                is_corner(p) || kept >> (n % 8) & 1 == 1
            });
            Box { low, high, vertices }
        };
        seeds.iter().take(8).map(of).collect()
    }
    fn agrees(seeds: Vec<(u8, u8, u8)>) -> bool {
        let boxes = boxes(&seeds);
        let ring = |one: &Box| one.vertices.iter().map(|p| p.map(f64::from)).collect::<Vec<_>>();
        let shapes: Vec<Shape> = boxes.iter().map(|one| Shape::polygon(ring(one))).collect();
        // The four quarters around a point; a quarter lies in a box if its middle does.
        let quarters = |p: [i32; 2]| [[-1, -1], [-1, 1], [1, -1], [1, 1]].map(|d| [2 * p[0] + d[0], 2 * p[1] + d[1]]);
        let has = |one: &Box, q: [i32; 2]| (0..2).all(|i| 2 * one.low[i] < q[i] && q[i] < 2 * one.high[i]);
        let mut expected = Vec::new();
        for (i, one) in boxes.iter().enumerate() {
            for (j, other) in boxes.iter().enumerate() {
                let border = around(other.low, other.high);
                let missing = |p: &&[i32; 2]| border.contains(p) && !other.vertices.contains(p);
                let apart = |p: &&[i32; 2]| !quarters(**p).iter().any(|q| has(one, *q) && has(other, *q));
                let found = one.vertices.iter().filter(missing).filter(apart);
                expected.extend(found.map(|p| ([i.min(j), i.max(j)], p.map(f64::from), j)));
            }
        }
        let mut found = Vec::new();
        for one in mismatched(&shapes).0 {
            let pair = [one.features[0].index(), one.features[1].index()];
            found.extend(one.missing.iter().map(|v| (pair, <[f64; 2]>::from(v.at), v.feature.index())));
        }
        let order = |a: &([usize; 2], [f64; 2], usize), b: &([usize; 2], [f64; 2], usize)| a.partial_cmp(b).unwrap();
        expected.sort_by(order);
        found.sort_by(order);
        found == expected
    }
    QuickCheck::new().tests(500).quickcheck(agrees as fn(Vec<(u8, u8, u8)>) -> bool);
}
