//! Contours: their rings, polygons and holes, valid by the rules of the OGC.
#![allow(clippy::float_cmp, reason = "areas on a grid of whole numbers are exact")]

use quickcheck::QuickCheck;
use std::collections::BTreeSet;
use twinedge::dcel::{Face, FaceKey, StaleKey, Vertex};
use twinedge_algorithm::area::{face_area, feature_area, ring_area};
use twinedge_algorithm::claims::{faces_by_feature, faces_of, overlaps};
use twinedge_algorithm::contour::{Contour, ContourError, Polygon, of_face, of_faces, of_feature, of_features};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, orientation};
use twinedge_map::{Builder, Feature, PlanarMap, Shape};

type Cell = (i32, i32);

fn at(x: i32, y: i32) -> Point {
    Point::new(f64::from(x), f64::from(y))
}

/// A feature that covers the unit squares with these lower left corners.
fn of_cells<'a>(cells: impl IntoIterator<Item = &'a Cell>) -> Feature {
    let square = |(x, y): &Cell| Shape::Polygon(vec![vec![at(*x, *y), at(x + 1, *y), at(x + 1, y + 1), at(*x, y + 1)]]);
    Feature { shapes: cells.into_iter().map(square).collect(), ..Feature::default() }
}

fn built(features: &[Feature]) -> PlanarMap {
    let mut builder = Builder::new();
    for feature in features {
        builder.feature(feature).expect("in range");
    }
    builder.build().expect("fits")
}

/// The contour of these cells on a board of 7 × 7 with all edges drawn.
fn on_a_board(cells: &BTreeSet<Cell>) -> Contour {
    let board: Vec<Cell> = (0..7).flat_map(|x| (0..7).map(move |y| (x, y))).collect();
    let map = built(&[of_cells(&board), of_cells(cells)]);
    let feature = map.features().nth(1).expect("there are two");
    of_feature(&map, feature).expect("the map is plane")
}

fn cells(picture: &[&str]) -> BTreeSet<Cell> {
    let rows = picture.iter().rev().zip(0..);
    rows.flat_map(|(row, y)| row.chars().zip(0..).filter(|(c, _)| *c == '#').map(move |(_, x)| (x, y))).collect()
}

/// The number of points of each ring, the outer ring first, without the repeated point.
fn shape(contour: &Contour) -> Vec<Vec<usize>> {
    contour.polygons.iter().map(|p| p.rings().map(|ring| ring.len() - 1).collect()).collect()
}

#[test]
fn rings_are_polygons_and_holes_by_what_they_enclose() {
    for (picture, expected) in [
        // Edges inside vanish, and vertices on the contour stay.
        (&["##", "##"][..], vec![vec![8]]),
        // Parts that touch at a vertex are apart.
        (&["#.", ".#"], vec![vec![4], vec![4]]),
        // Inside, the part is connected around the hole; at the upper right of the hole the outside begins.
        (&["##.", "#.#", "###"], vec![vec![12, 4]]),
        (&["####", "#.##", "##.#", "####"], vec![vec![16, 4, 4]]),
        // Holes in a necklace are one hole with a polygon inside.
        (&["#####", "##.##", "#.#.#", "##.##", "#####"], vec![vec![20, 12], vec![4]]),
    ] {
        assert_eq!(shape(&on_a_board(&cells(picture))), expected, "{picture:?}");
    }
    // Counter-clockwise from the smallest point, and closed; holes clockwise.
    let outer = vec![at(0, 1), at(1, 1), at(1, 2), at(0, 2), at(0, 1)];
    let polygon = Polygon { outer, holes: Vec::new() };
    assert!(on_a_board(&cells(&["#.", ".#"])).polygons.contains(&polygon));
    let hole = &on_a_board(&cells(&["##.", "#.#", "###"])).polygons[0].holes[0];
    assert_eq!(*hole, [at(1, 1), at(1, 2), at(2, 2), at(2, 1), at(1, 1)]);
}

#[test]
fn lines_and_points_inside_are_not_on_the_contour() {
    let square = Shape::Polygon(vec![vec![at(0, 0), at(9, 0), at(9, 9), at(0, 9)]]);
    let inside = [
        Shape::Line(vec![at(0, 0), at(2, 2), at(3, 2)]),
        Shape::Line(vec![at(5, 5), at(6, 6)]),
        Shape::Point(at(4, 1)),
    ];
    let map = built(&[Feature { shapes: [square].into_iter().chain(inside).collect(), ..Feature::default() }]);
    assert!(map.is_plane());
    let contour = of_feature(&map, map.features().next().expect("one")).expect("plane");
    assert_eq!(shape(&contour), [[4]]);
    assert_eq!(contour.area(), 81.0);
}

#[test]
fn a_feature_that_covers_nothing_has_no_polygon() {
    let map = built(&[Feature { shapes: vec![Shape::Line(vec![at(0, 0), at(1, 0)])], ..Feature::default() }]);
    assert_eq!(of_features(&map).expect("plane"), [Contour::default()]);
}

#[test]
fn faces_that_have_no_contour_are_refused() {
    let map = built(&[of_cells(&[(0, 0)])]);
    let unbounded = map.dcel().unbounded_face().key();
    assert_eq!(of_faces(&map, [unbounded]), Err(ContourError::Unbounded));
    let other = built(&[of_cells(&[(0, 0)])]);
    let stale = other.dcel().faces().last().expect("two faces").key();
    assert_eq!(of_face(&map, stale), Err(ContourError::Stale(StaleKey::Face(stale))));
    assert_eq!(face_area(&map, stale), Err(StaleKey::Face(stale)));
}

fn inside(ring: &[Point], p: Point) -> bool {
    let crossed = ring.windows(2).filter(|e| {
        let (low, high) = if e[0].y <= e[1].y { (e[0], e[1]) } else { (e[1], e[0]) };
        low.y <= p.y && p.y < high.y && orientation(low, high, p) == Orientation::CounterClockwise
    });
    crossed.count() % 2 == 1
}

/// Returns the sets, connected across edges, of the cells of a window of 10 × 10 for which `is` holds.
fn connected(is: impl Fn(Cell) -> bool) -> Vec<BTreeSet<Cell>> {
    let mut left: BTreeSet<Cell> = (-1..9).flat_map(|x| (-1..9).map(move |y| (x, y))).filter(|c| is(*c)).collect();
    let mut found = Vec::new();
    while let Some(start) = left.pop_first() {
        let mut set = BTreeSet::from([start]);
        let mut stack = vec![start];
        while let Some((x, y)) = stack.pop() {
            for next in [(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)] {
                if left.remove(&next) {
                    set.insert(next);
                    stack.push(next);
                }
            }
        }
        found.push(set);
    }
    found
}

fn valid(polygon: &Polygon) -> bool {
    let simple = polygon.rings().all(|ring| {
        let different: BTreeSet<_> = ring.iter().map(|p| (p.x.to_bits(), p.y.to_bits())).collect();
        ring.first() == ring.last() && different.len() == ring.len() - 1 && ring.len() > 4
    });
    let turns = ring_area(polygon.outer.iter().copied()) > 0.0
        && polygon.holes.iter().all(|hole| ring_area(hole.iter().copied()) < 0.0);
    let held = |hole: &Vec<Point>| {
        let on = |p: &Point| polygon.outer.contains(p);
        hole.iter().all(|p| on(p) || inside(&polygon.outer, *p))
    };
    simple && turns && polygon.holes.iter().all(held)
}

fn polygons_are_valid_and_cover_the_cells(chosen: Vec<(u8, u8)>, most: bool) -> bool {
    let mut set: BTreeSet<Cell> = chosen.into_iter().map(|(x, y)| (i32::from(x % 7), i32::from(y % 7))).collect();
    if most {
        set = (0..7).flat_map(|x| (0..7).map(move |y| (x, y))).filter(|c| !set.contains(c)).collect();
    }
    let contour = on_a_board(&set);
    let covered = |polygon: &Polygon, (x, y): Cell| {
        let middle = Point::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        polygon.rings().filter(|ring| inside(ring, middle)).count() % 2 == 1
    };
    // One polygon for each part that is connected across edges, and one hole for each bounded part of the complement.
    let parts = connected(|c| set.contains(&c));
    let as_they_should_be = parts.iter().all(|part| {
        let mut its = contour.polygons.iter().filter(|polygon| covered(polygon, *part.first().expect("not empty")));
        let (Some(polygon), None) = (its.next(), its.next()) else { return false };
        let cells: BTreeSet<Cell> =
            (0..7).flat_map(|x| (0..7).map(move |y| (x, y))).filter(|c| covered(polygon, *c)).collect();
        cells == *part && polygon.holes.len() == connected(|c| !part.contains(&c)).len() - 1
    });
    as_they_should_be
        && contour.polygons.len() == parts.len()
        && contour.polygons.iter().all(valid)
        && contour.area() == f64::from(set.len() as u32)
}

#[test]
fn any_set_of_cells_has_valid_polygons() {
    QuickCheck::new().tests(600).quickcheck(polygons_are_valid_and_cover_the_cells as fn(Vec<(u8, u8)>, bool) -> bool);
}

#[test]
fn the_order_and_number_of_times_that_faces_are_named_does_not_matter() {
    let map = built(&[of_cells(&cells(&["##.", "#.#", "###"]))]);
    let faces: Vec<FaceKey> = faces_of(&map, map.features().next().expect("one"));
    let again = faces.iter().rev().chain(&faces).copied();
    assert_eq!(of_faces(&map, again), of_faces(&map, faces.iter().copied()));
}

#[test]
fn areas_and_coverage_agree() {
    let map = built(&[of_cells(&cells(&["##", "##"])), of_cells(&cells(&[".#", "##"]))]);
    let ids: Vec<_> = map.features().collect();
    assert_eq!(ids.iter().map(|f| feature_area(&map, *f)).collect::<Vec<_>>(), [4.0, 3.0]);
    assert_eq!(faces_by_feature(&map), ids.iter().map(|f| faces_of(&map, *f)).collect::<Vec<_>>());
    assert_eq!(overlaps(&map), faces_of(&map, ids[1]));
    let bounded: f64 =
        map.dcel().faces().filter(|f| !f.is_unbounded()).map(|f| face_area(&map, f.key()).expect("live")).sum();
    assert_eq!(bounded, 4.0);
    assert_eq!(face_area(&map, map.dcel().unbounded_face().key()), Ok(f64::INFINITY));
}

#[test]
fn areas_lose_nothing_far_from_the_origin_nor_by_length() {
    // All in whole numbers, so exact: a comb with a hundred thousand teeth, 2^30 away,
    let far = f64::from(1 << 30);
    let teeth = 100_000;
    let lower = (0..=2 * teeth).map(|i| Point::new(far + f64::from(i), far + f64::from(i % 2)));
    let upper = [Point::new(far + f64::from(2 * teeth), far + 3.0), Point::new(far, far + 3.0)];
    assert_eq!(ring_area(lower.chain(upper)), f64::from(2 * teeth) * 2.5);
    // and a triangle of area 2^53 with a thousand others of area 1/2, which a plain sum would lose.
    let side = f64::from(1 << 27);
    let triangle = [at(0, 0), Point::new(side, 0.0), Point::new(side, side)];
    let ring = triangle.into_iter().chain((1..=1001).map(|y| at(1, y)));
    assert_eq!(ring_area(ring), side * side / 2.0 + 500.0);
    assert_eq!(ring_area([]), 0.0);
}

#[test]
fn where_no_ring_encloses_a_face_that_is_said() {
    // A triangle with collinear corners.
    let map = built(&[Feature {
        shapes: vec![Shape::Polygon(vec![vec![at(1, 1), at(1, 2), at(1, 3)]])],
        ..Feature::default()
    }]);
    let face = map.dcel().faces().last().map(Face::key).expect("two faces");
    assert!(!map.is_plane());
    assert_eq!(of_face(&map, face), Err(ContourError::NotPlane(face)));
}

/// The contour of a face of any map, plane or not, has the edges with this face on one side only, each once, or is refused.
fn contours_have_the_edges_of_the_face(segments: Vec<((u8, u8), (u8, u8))>) -> bool {
    let mut builder = Builder::new();
    for ((a, b), (c, d)) in segments {
        let [a, b, c, d] = [a, b, c, d].map(|i| f64::from(i % 5));
        builder.segment([a, b], [c, d]).expect("in range");
    }
    let map = builder.build().expect("fits");
    let bits = |p: Point| (p.x.to_bits(), p.y.to_bits());
    let position = |v: Vertex<'_>| bits(map.position(v.key()).expect("live"));
    map.dcel().faces().all(|face| match of_face(&map, face.key()) {
        Err(ContourError::Unbounded) => face.is_unbounded(),
        Err(_) => !map.is_plane(),
        Ok(polygon) => {
            let mut found: Vec<_> =
                polygon.rings().flat_map(|ring| ring.windows(2)).map(|e| (bits(e[0]), bits(e[1]))).collect();
            let own = face.half_edges().filter(|h| h.twin().face() != face);
            let mut expected: Vec<_> = own.map(|h| (position(h.origin()), position(h.target()))).collect();
            found.sort_unstable();
            expected.sort_unstable();
            found == expected
        }
    })
}

#[test]
fn contours_of_faces_are_made_of_their_edges() {
    QuickCheck::new()
        .tests(3000)
        .quickcheck(contours_have_the_edges_of_the_face as fn(Vec<((u8, u8), (u8, u8))>) -> bool);
}
