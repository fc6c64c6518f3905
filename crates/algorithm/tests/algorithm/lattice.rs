//! Lattice points: compared with counting them one by one, and with Pick's theorem.

use crate::oracle::whole;
use crate::planar::{self, noded};
use quickcheck::QuickCheck;
use twinedge::dcel::{Face, FaceKey, StaleKey};
use twinedge_algorithm::lattice::{LatticeError, of_face, of_map};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, orientation};
use twinedge_map::{Builder, Located, PlanarMap, Shape};

fn of_ring(ring: &[[f64; 2]]) -> PlanarMap {
    let mut builder = Builder::new();
    builder.shape(&Shape::Polygon(vec![ring.iter().map(|p| Point::from(*p)).collect()])).unwrap();
    builder.build().unwrap()
}

fn bounded(map: &PlanarMap) -> impl Iterator<Item = FaceKey> + '_ {
    map.dcel().faces().filter(|face| !face.is_unbounded()).map(Face::key)
}

/// Doubled area, points inside, points along the boundary, holes.
fn numbers(map: &PlanarMap, face: FaceKey) -> [i128; 4] {
    let count = of_face(map, face).unwrap();
    assert!(count.pick_holds());
    [count.area_doubled, count.interior, count.boundary, count.holes]
}

/// A polygon with I = 30 and B = 22 has the area 40: lecture notes CS60064, lecture 12. This is a polygon with these numbers.
#[test]
fn the_example_of_the_lecture() {
    let map = of_ring(&[[0.0, 0.0], [5.0, 0.0], [5.0, 4.0], [2.0, 10.0], [0.0, 9.0]]);
    let face = bounded(&map).next().unwrap();
    assert_eq!(numbers(&map, face), [80, 30, 22, 0]);
}

/// An elementary triangle, whose only lattice points are its corners, has the area 1/2 (Grünbaum and Shephard 1993). These are
/// all triangles of a lattice of 4 × 4 points.
#[test]
fn every_elementary_triangle_has_area_one_half() {
    let points: Vec<[f64; 2]> = (0..16_u8).map(|i| [f64::from(i % 4), f64::from(i / 4)]).collect();
    let (mut elementary, mut others) = (0, 0);
    for a in 0..16 {
        for b in a + 1..16 {
            for c in b + 1..16 {
                let [p, q, r] = [a, b, c].map(|i| Point::from(points[i]));
                if orientation(p, q, r) == Orientation::Collinear {
                    continue;
                }
                let map = of_ring(&[points[a], points[b], points[c]]);
                for face in bounded(&map) {
                    let [area, interior, boundary, _] = numbers(&map, face);
                    assert_eq!(area == 1, (interior, boundary) == (0, 3));
                    if area == 1 { elementary += 1 } else { others += 1 }
                }
            }
        }
    }
    // 516 triangles with an area in a lattice of 4 × 4 points: OEIS A045996.
    assert_eq!(elementary + others, 516);
    assert!(elementary > 100);
}

#[test]
fn faces_with_holes_and_with_what_dangles() {
    let mut map = of_ring(&[[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]]);
    let face = bounded(&map).next().unwrap();
    assert_eq!(numbers(&map, face), [72, 25, 24, 0]);
    // A point: one less inside, and a hole.
    map.insert_point([1.0, 1.0]).unwrap();
    assert_eq!(numbers(&map, face), [72, 24, 24, 1]);
    // A dangling edge of length 2: two points less, four steps more.
    map.insert_segment([6.0, 3.0], [4.0, 3.0]).unwrap();
    assert_eq!(numbers(&map, face), [72, 22, 28, 1]);
    // Two holes that touch are one.
    map.insert_ring([[2.0, 2.0], [3.0, 2.0], [3.0, 3.0], [2.0, 3.0]]).unwrap();
    map.insert_ring([[3.0, 3.0], [4.0, 4.0], [3.0, 4.0]]).unwrap();
    assert_eq!(numbers(&map, face), [72 - 2 - 1, 22 - 6, 28 + 4 + 3, 2]);
    assert!(of_map(&map).unwrap().pick_holds());
}

/// Counts the lattice points of each face by locating each point.
fn counts_are_those_of_single_points(shapes: planar::Scribble) -> bool {
    let map = noded(&shapes);
    let counts = of_map(&map).unwrap();
    let mut inside = vec![0; map.dcel().faces().map(|face| face.index()).max().unwrap() + 1];
    for (x, y) in (-1..=13).flat_map(|x| (-1..=13).map(move |y| (x, y))) {
        match map.locate(Point::new(f64::from(x), f64::from(y))).unwrap() {
            Located::Face(face) => inside[map.dcel().face(face).unwrap().index()] += 1,
            Located::Edge(_) | Located::Vertex(_) => {}
        }
    }
    counts.pick_holds()
        && counts.faces.len() + 1 == map.dcel().face_count()
        && counts.faces.iter().all(|(key, count)| {
            let face = map.dcel().face(*key).unwrap();
            let along: i128 = { face.half_edges() }
                .map(|h| {
                    let [[a, b], [c, d]] = [h.origin(), h.target()].map(|v| whole(map.position(v.key()).unwrap()));
                    // The number of steps is the number of lattice points on the edge, except one end.
                    (1..=i128::max((a - c).abs(), (b - d).abs()))
                        .filter(|n| (c - a) % n == 0 && (d - b) % n == 0)
                        .max()
                        .unwrap()
                })
                .sum();
            count.pick_holds() && count.interior == inside[face.index()] && count.boundary == along
        })
}

#[test]
fn random_lattice_maps() {
    QuickCheck::new().tests(600).quickcheck(counts_are_those_of_single_points as fn(planar::Scribble) -> bool);
}

/// Far from the origin, and far apart: still exact.
#[test]
fn large_coordinates_are_exact() {
    let m = 2_f64.powi(53);
    let map = of_ring(&[[-m, -m], [m, -m], [m, m], [-m, m]]);
    let face = bounded(&map).next().unwrap();
    let side = 1_i128 << 54;
    assert_eq!(numbers(&map, face), [2 * side * side, (side - 1) * (side - 1), 4 * side, 0]);
    let sliver = of_ring(&[[-m, -m], [m, m - 1.0], [m - 1.0, m - 1.0]]);
    let face = bounded(&sliver).next().unwrap();
    let _ = numbers(&sliver, face);
}

#[test]
fn what_has_no_lattice_points_is_refused() {
    let map = of_ring(&[[0.0, 0.0], [3.0, 0.0], [3.0, 2.5], [0.0, 3.0]]);
    let face = bounded(&map).next().unwrap();
    let vertex = map.dcel().vertices().find(|v| map.position(v.key()).unwrap().y.fract() > 0.0).unwrap().key();
    let error = LatticeError::NotInteger { vertex, x: 3.0, y: 2.5 };
    assert_eq!(of_face(&map, face), Err(error));
    assert_eq!(of_map(&map), Err(error));
    assert_eq!(error.to_string(), "the vertex at (3, 2.5) is not a lattice point: both coordinates must be integers");
    assert_eq!(of_face(&map, map.dcel().unbounded_face().key()), Err(LatticeError::Unbounded));

    let m = 2_f64.powi(60);
    let far = of_ring(&[[0.0, 0.0], [m, 0.0], [m, m]]);
    assert!(matches!(of_map(&far), Err(LatticeError::TooLarge { x, .. }) if x >= m));
    assert_eq!(of_face(&far, face), Err(LatticeError::Stale(StaleKey::Face(face))));

    let mut isolated = of_ring(&[[0.0, 0.0], [3.0, 0.0], [3.0, 3.0]]);
    isolated.insert_point([2.0, 0.5]).unwrap();
    assert!(matches!(of_map(&isolated), Err(LatticeError::NotInteger { x, y, .. }) if (x, y) == (2.0, 0.5)));
}
