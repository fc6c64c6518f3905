//! Convex pieces: they are convex and within the bound of the theorem, nothing is lost, and no diagonal is superfluous. Compared
//! with the minimum number of pieces, found by trying everything, on small polygons.

use crate::planar::{self, noded};
use quickcheck::QuickCheck;
use std::collections::BTreeSet;
use twinedge::dcel::{Face, FaceKey, HalfEdge, StaleKey};
use twinedge_algorithm::area::face_area;
use twinedge_algorithm::convex::{
    ConvexError, Decomposition, decompose, is_essential, remove_inessential, triangulate,
};
use twinedge_geometry::predicates::{Meeting, Orientation, compare_angle, meeting, orientation};
use twinedge_geometry::{MAX_COORDINATE, Point};
use twinedge_map::edit::EditError;
use twinedge_map::{Builder, PlanarMap, Shape};

/// Returns true if a corner inside a face is at most a straight angle: exactly, and by another method than the library.
fn is_convex_at(map: &PlanarMap, h: HalfEdge<'_>) -> bool {
    let at = |h: HalfEdge<'_>| map.position(h.origin().key()).unwrap();
    let (before, here, after) = (at(h.prev()), at(h), at(h.next()));
    match orientation(before, here, after) {
        Orientation::CounterClockwise => true,
        Orientation::Clockwise => false,
        Orientation::Collinear => {
            (before.x - here.x) * (after.x - here.x) + (before.y - here.y) * (after.y - here.y) < 0.0
        }
    }
}

fn bounded(map: &PlanarMap) -> Vec<FaceKey> {
    map.dcel().faces().filter(|face| !face.is_unbounded()).map(Face::key).collect()
}

struct Before {
    area: f64,
    reflex: usize,
    isolated: usize,
    inner: usize,
    sides: usize,
    features: Vec<usize>,
}

fn features(map: &PlanarMap, face: FaceKey) -> Vec<usize> {
    map.features_of(face).unwrap().map(|feature| feature.index()).collect()
}

fn look(map: &PlanarMap, key: FaceKey) -> Before {
    let face = map.dcel().face(key).unwrap();
    let isolated = face.inner().filter(|b| b.isolated_vertex().is_some()).count();
    Before {
        area: face_area(map, key).unwrap(),
        reflex: face.half_edges().filter(|h| !is_convex_at(map, *h)).count() + isolated,
        isolated,
        inner: face.inner_count(),
        sides: face.half_edges().count(),
        features: features(map, key),
    }
}

/// Decomposes faces and checks all promises about the result.
fn checked(map: &mut PlanarMap, faces: &[FaceKey]) -> Vec<Decomposition> {
    let before: Vec<Before> = faces.iter().map(|face| look(map, *face)).collect();
    let edges: BTreeSet<usize> = map.dcel().edges().map(|h| h.index()).collect();
    let (vertices, components) = (map.dcel().vertex_count(), map.dcel().face_count());
    let found = decompose(map, faces.iter().copied()).unwrap();
    assert!(map.validate().is_valid(), "{}", map.validate());
    assert_eq!(map.dcel().vertex_count(), vertices);
    assert!(edges.iter().all(|h| map.dcel().half_edge_at(*h).is_some()));
    let mut faces_now = components;
    for ((decomposition, before), face) in found.iter().zip(&before).zip(faces) {
        let Decomposition { pieces, kept, triangles, diagonals, reflex, .. } = decomposition;
        assert_eq!(decomposition.face, *face);
        assert_eq!(*reflex, before.reflex);
        // From Euler's formula, with the triangles counted by their sides.
        assert_eq!(*triangles + 2, before.sides + 2 * before.inner);
        assert_eq!(*diagonals + 1, triangles + before.inner);
        assert_eq!(pieces.len() + before.inner, kept.len() + 1);
        assert!(pieces.len() + before.inner <= 2 * (reflex - before.isolated) + 3 * before.isolated + 1);
        let mut area = 0.0;
        for piece in pieces {
            let face = map.dcel().face(*piece).unwrap();
            assert!(face.inner_count() == 0 && face.half_edges().all(|h| is_convex_at(map, h)));
            assert_eq!(features(map, *piece), before.features);
            area += face_area(map, *piece).unwrap();
        }
        assert!((area - before.area).abs() <= 1e-12 * before.area.max(1e-6), "{area} {}", before.area);
        assert!(kept.iter().all(|h| is_essential(map, *h).unwrap()));
        assert!(kept.iter().all(|h| map.features_along(*h).unwrap().next().is_none()));
        faces_now += pieces.len() - 1;
    }
    assert_eq!(map.dcel().face_count(), faces_now);
    found
}

fn of_rings(rings: &[&[[f64; 2]]]) -> PlanarMap {
    let rings = rings.iter().map(|ring| ring.iter().map(|p| Point::from(*p)).collect()).collect();
    let mut builder = Builder::new();
    builder.shape(&Shape::Polygon(rings)).unwrap();
    builder.build().unwrap()
}

fn pieces(rings: &[&[[f64; 2]]]) -> usize {
    let mut map = of_rings(rings);
    let covered: Vec<FaceKey> = bounded(&map).into_iter().filter(|face| !features(&map, *face).is_empty()).collect();
    assert_eq!(covered.len(), 1);
    checked(&mut map, &covered)[0].pieces.len()
}

/// The minimum number of convex pieces, without new vertices, of a simple polygon: tries every set of diagonals, smallest first.
fn least(ring: &[Point]) -> usize {
    let n = ring.len();
    let next = |i: usize| (i + 1) % n;
    let turn = |a: Point, b: Point, c: Point| orientation(a, b, c);
    // True if the direction from a vertex to a point lies strictly inside its corner.
    let inside = |i: usize, p: Point| {
        let (before, v, after) = (ring[(i + n - 1) % n], ring[i], ring[next(i)]);
        let (left, right) =
            (turn(v, after, p) == Orientation::CounterClockwise, turn(v, before, p) == Orientation::Clockwise);
        match turn(before, v, after) {
            Orientation::CounterClockwise => left && right,
            Orientation::Collinear => left,
            Orientation::Clockwise => {
                let on = |q: Point| compare_angle(v, p, q).is_eq();
                (left || right) && !on(before) && !on(after)
            }
        }
    };
    let mut diagonals = Vec::new();
    for i in 0..n {
        for j in i + 2..n {
            let sides = (0..n).filter(|k| ![i, j].contains(k) && ![i, j].contains(&next(*k)));
            let clear = { sides }.all(|k| meeting(ring[i], ring[j], ring[k], ring[next(k)]) == Meeting::Disjoint);
            // Sides at its ends share only the end.
            let ends = [(i, j), (j, i)].iter().all(|(a, b)| inside(*a, ring[*b]));
            if next(j) != i && clear && ends {
                diagonals.push((i, j));
            }
        }
    }
    let convex = |chosen: &[(usize, usize)]| {
        (0..n).all(|i| {
            // The directions at a vertex, from the side after it to the side before it.
            let mut at: Vec<Point> = chosen
                .iter()
                .filter_map(|(a, b)| if *a == i { Some(ring[*b]) } else { (*b == i).then(|| ring[*a]) })
                .collect();
            let (v, after) = (ring[i], ring[next(i)]);
            let from_after = |p: Point| match turn(v, after, p) {
                Orientation::CounterClockwise => 0,
                Orientation::Collinear => 1,
                Orientation::Clockwise => 2,
            };
            at.sort_by(|p, q| {
                from_after(*p).cmp(&from_after(*q)).then_with(|| match turn(v, *p, *q) {
                    Orientation::CounterClockwise => std::cmp::Ordering::Less,
                    Orientation::Collinear => std::cmp::Ordering::Equal,
                    Orientation::Clockwise => std::cmp::Ordering::Greater,
                })
            });
            at.insert(0, after);
            at.push(ring[(i + n - 1) % n]);
            at.windows(2).all(|w| turn(v, w[0], w[1]) != Orientation::Clockwise)
        })
    };
    let crosses = |(a, b): (usize, usize), (c, d): (usize, usize)| {
        matches!(meeting(ring[a], ring[b], ring[c], ring[d]), Meeting::Cross | Meeting::Touch(_) | Meeting::Overlap)
    };
    let mut sets: Vec<(Vec<(usize, usize)>, usize)> = vec![(Vec::new(), 0)];
    loop {
        if let Some((best, _)) = sets.iter().find(|(set, _)| convex(set)) {
            return best.len() + 1;
        }
        let mut larger = Vec::new();
        for (set, from) in &sets {
            for (k, diagonal) in diagonals.iter().enumerate().skip(*from) {
                if set.iter().all(|other| !crosses(*other, *diagonal)) {
                    let mut set = set.clone();
                    set.push(*diagonal);
                    larger.push((set, k + 1));
                }
            }
        }
        assert!(!larger.is_empty(), "a triangulation is convex");
        sets = larger;
    }
}

fn at_most_four_times_the_least(ring: &[[f64; 2]]) -> (usize, usize) {
    let points: Vec<Point> = ring.iter().map(|p| Point::from(*p)).collect();
    let (found, least) = (pieces(&[ring]), least(&points));
    assert!(least <= found && found <= 4 * least, "{found} pieces, and {least} would do");
    (found, least)
}

/// The minimum numbers are known: a convex polygon is one piece, and r reflex corners need ⌈r / 2⌉ + 1 pieces (B. Chazelle and D.
/// Dobkin, "Optimal convex decompositions", in Computational Geometry, 1985, 63-133), which suffice for these.
#[test]
fn golden_polygons_have_the_known_least_numbers() {
    let triangle = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let square = [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let l = [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [3.0, 2.0], [3.0, 3.0], [0.0, 3.0]];
    let t = [[0.0, 2.0], [2.0, 2.0], [2.0, 0.0], [3.0, 0.0], [3.0, 2.0], [5.0, 2.0], [5.0, 3.0], [0.0, 3.0]];
    let dart = [[0.0, 0.0], [4.0, 2.0], [0.0, 4.0], [1.0, 2.0]];
    let cross = [[1, 0], [2, 0], [2, 1], [3, 1], [3, 2], [2, 2], [2, 3], [1, 3], [1, 2], [0, 2], [0, 1], [1, 1]]
        .map(|p: [i32; 2]| p.map(f64::from));
    // The five-pointed star: five reflex corners, so at least four pieces.
    let star = [[0, 10], [-2, 3], [-10, 3], [-4, -2], [-6, -10], [0, -5], [6, -10], [4, -2], [10, 3], [2, 3]]
        .map(|p: [i32; 2]| p.map(f64::from));
    assert_eq!(at_most_four_times_the_least(&triangle), (1, 1));
    assert_eq!(at_most_four_times_the_least(&square), (1, 1));
    assert_eq!(at_most_four_times_the_least(&l), (2, 2));
    assert_eq!(at_most_four_times_the_least(&dart), (2, 2));
    assert_eq!(at_most_four_times_the_least(&t).1, 2);
    assert_eq!(at_most_four_times_the_least(&cross).1, 3);
    assert_eq!(at_most_four_times_the_least(&star).1, 4);
}

/// A comb with k teeth has 2 (k − 1) reflex corners, and at least k pieces: the base joins a tooth, by diagonals between gaps.
#[test]
fn combs_stars_and_spirals_keep_the_bounds() {
    for teeth in [2, 3, 10, 200] {
        let mut ring = vec![[0.0, 0.0], [f64::from(2 * teeth - 1), 0.0]];
        for tooth in (0..teeth).rev() {
            let x = f64::from(2 * tooth);
            ring.extend([[x + 1.0, 5.0], [x, 5.0]]);
            if tooth > 0 {
                ring.extend([[x, 1.0], [x - 1.0, 1.0]]);
            }
        }
        let found = pieces(&[&ring]);
        assert!(found as u32 >= teeth && found as u32 <= 4 * teeth - 3, "{found} pieces for {teeth} teeth");
    }
    for points in [5, 50, 1_000] {
        let mut ring = Vec::new();
        for i in 0..2 * points {
            let angle = std::f64::consts::PI * f64::from(i) / f64::from(points);
            let radius = if i % 2 == 0 { 10.0 } else { 2.0 };
            ring.push([radius * angle.cos(), radius * angle.sin()]);
        }
        let found = pieces(&[&ring]);
        assert!(found as u32 > points / 2 && found as u32 <= 2 * points + 1);
    }
    for turns in [1, 5, 50] {
        let (mut outer, mut inner) = (Vec::new(), Vec::new());
        for i in 0..16 * turns {
            let (angle, radius) = (std::f64::consts::TAU * f64::from(i) / 16.0, 1.0 + f64::from(i) / 16.0);
            outer.push([radius * angle.cos(), radius * angle.sin()]);
            inner.push([(radius - 0.4) * angle.cos(), (radius - 0.4) * angle.sin()]);
        }
        inner.reverse();
        outer.append(&mut inner);
        let _ = pieces(&[&outer]);
    }
}

/// One vertex sees all others, so that all diagonals leave one corner.
#[test]
fn a_fan_around_one_corner_is_attached_in_order() {
    let mut ring = vec![[0.0, 0.0]];
    for i in 0..=2_000 {
        // An arc that bulges towards the vertex: its points see only their neighbours and the vertex.
        let x = f64::from(i) / 1_000.0 - 1.0;
        ring.push([-x * 100.0, 100.0 + x * x * 50.0 - 0.01 * f64::from(i % 2)]);
    }
    let _ = pieces(&[&ring]);
}

#[test]
fn holes_that_touch_dangling_edges_and_points_bound_the_pieces() {
    let square: &[[f64; 2]] = &[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
    let hole: &[[f64; 2]] = &[[2.0, 2.0], [2.0, 4.0], [4.0, 4.0], [4.0, 2.0]];
    let touching: &[[f64; 2]] = &[[4.0, 4.0], [4.0, 6.0], [6.0, 6.0], [6.0, 4.0]];
    let at_border: &[[f64; 2]] = &[[0.0, 8.0], [2.0, 9.0], [2.0, 7.0]];
    assert!(pieces(&[square, hole]) >= 4);
    assert!(pieces(&[square, hole, touching]) >= 5);
    let with_corner: &[[f64; 2]] = &[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [0.0, 8.0]];
    assert!(pieces(&[with_corner, hole, touching, at_border]) >= 5);

    let mut map = of_rings(&[square]);
    let inside = bounded(&map)[0];
    // From corner to corner through the point.
    map.insert_point([5.0, 5.0]).unwrap();
    assert_eq!(checked(&mut map, &[inside])[0].pieces.len(), 2);

    // Here three diagonals are essential at the point.
    let mut map = of_rings(&[&[[0.0, 0.0], [9.0, 0.0], [0.0, 9.0]]]);
    let inside = bounded(&map)[0];
    map.insert_point([2.0, 3.0]).unwrap();
    assert_eq!(checked(&mut map, &[inside])[0].pieces.len(), 3);

    let mut map = of_rings(&[square]);
    let inside = bounded(&map)[0];
    map.insert_segment([5.0, 0.0], [5.0, 5.0]).unwrap();
    assert_eq!(checked(&mut map, &[inside])[0].pieces.len(), 3);

    let mut map = of_rings(&[square]);
    let inside = bounded(&map)[0];
    // On the way from corner to corner.
    map.insert_segment([3.0, 3.0], [5.0, 5.0]).unwrap();
    assert_eq!(checked(&mut map, &[inside])[0].pieces.len(), 2);
}

fn random_maps_fall_into_convex_pieces(shapes: planar::Scribble) -> bool {
    let mut map = noded(&shapes);
    let faces = bounded(&map);
    checked(&mut map, &faces).len() == faces.len()
}

fn one_face_is_as_all_together(shapes: planar::Scribble) -> bool {
    let mut all = noded(&shapes);
    let faces = bounded(&all);
    let mut single = all.clone();
    let together = decompose(&mut all, faces.iter().copied()).unwrap();
    let apart: Vec<Decomposition> = faces.iter().flat_map(|face| checked(&mut single, &[*face])).collect();
    together.iter().zip(&apart).all(|(a, b)| (a.triangles, a.reflex) == (b.triangles, b.reflex))
}

#[test]
fn random_maps() {
    QuickCheck::new().tests(400).quickcheck(random_maps_fall_into_convex_pieces as fn(planar::Scribble) -> bool);
    QuickCheck::new().tests(60).quickcheck(one_face_is_as_all_together as fn(planar::Scribble) -> bool);
}

/// Simple polygons with up to nine vertices, compared with the minimum.
fn small_polygons_are_within_four_times_the_least(turns: Vec<u8>) -> bool {
    // Points around the origin at growing angles form a simple polygon; points at equal angles are dropped.
    let mut corners: Vec<[f64; 2]> =
        turns.iter().take(9).map(|t| [f64::from(t % 11) - 5.0, f64::from(t / 11 % 11) - 5.0]).collect();
    corners.retain(|p| *p != [0.0, 0.0]);
    let origin = Point::new(0.0, 0.0);
    corners.sort_by(|p, q| compare_angle(origin, (*p).into(), (*q).into()));
    corners.dedup_by(|p, q| compare_angle(origin, (*p).into(), (*q).into()).is_eq());
    let around = |i: usize| {
        let (a, b) = (Point::from(corners[i]), Point::from(corners[(i + 1) % corners.len()]));
        orientation(origin, a, b) == Orientation::CounterClockwise
    };
    if corners.len() < 3 || !(0..corners.len()).all(around) {
        return true;
    }
    let (found, least) = at_most_four_times_the_least(&corners);
    least <= found
}

#[test]
fn small_polygons() {
    QuickCheck::new().tests(400).quickcheck(small_polygons_are_within_four_times_the_least as fn(Vec<u8>) -> bool);
}

#[test]
fn every_face_of_the_three_maps() {
    for mut map in planar::world_maps() {
        let faces: Vec<FaceKey> = bounded(&map).into_iter().filter(|face| !features(&map, *face).is_empty()).collect();
        let found = checked(&mut map, &faces);
        let count = |f: fn(&Decomposition) -> usize| found.iter().map(f).sum::<usize>();
        assert!(count(|d| d.pieces.len()) <= 2 * count(|d| d.reflex) + faces.len());
        assert!(count(|d| d.pieces.len()) >= count(|d| d.reflex) / 2);
    }
}

#[test]
fn triangles_are_triangles_and_one_pass_is_enough() {
    let mut map = planar::world_maps().next().unwrap();
    let faces: Vec<FaceKey> = bounded(&map);
    let triangulations = triangulate(&mut map, faces).unwrap();
    assert!(
        map.dcel().faces().filter(|f| !f.is_unbounded()).all(|f| f.half_edges().count() == 3 && f.inner_count() == 0)
    );
    for triangulation in triangulations {
        let first = remove_inessential(&mut map, &triangulation.diagonals).unwrap();
        assert_eq!(remove_inessential(&mut map, &first).unwrap(), first);
    }
}

/// No vertex that sees a triangle's side lies inside its circle: checked across each diagonal, in whole numbers.
fn triangulations_are_constrained_delaunay(shapes: planar::Scribble) -> bool {
    let mut map = noded(&shapes);
    let faces = bounded(&map);
    let diagonals: Vec<_> = { triangulate(&mut map, faces).unwrap() }.into_iter().flat_map(|t| t.diagonals).collect();
    diagonals.into_iter().all(|h| {
        let h = map.dcel().half_edge(h).unwrap();
        let at = |h: HalfEdge<'_>| {
            let p = map.position(h.origin().key()).unwrap();
            (p.x as i128, p.y as i128)
        };
        let d = at(h.twin().prev());
        let row = |h: HalfEdge<'_>| {
            let (x, y) = at(h);
            let (x, y) = (x - d.0, y - d.1);
            [x, y, x * x + y * y]
        };
        let [a, b, c] = [h, h.next(), h.prev()].map(row);
        let det = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
        det <= 0
    })
}

#[test]
fn triangulations() {
    QuickCheck::new().tests(200).quickcheck(triangulations_are_constrained_delaunay as fn(planar::Scribble) -> bool);
}

#[test]
fn what_cannot_be_decomposed_is_refused_and_nothing_changes() {
    let square: &[[f64; 2]] = &[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
    let mut map = of_rings(&[square]);
    let outside = map.dcel().unbounded_face().key();
    let inside = bounded(&map)[0];
    assert_eq!(decompose(&mut map, [inside, outside]), Err(ConvexError::Unbounded));
    assert_eq!(map.dcel().edge_count(), 4);

    let stale = bounded(&of_rings(&[square]))[0];
    assert_eq!(decompose(&mut map, [stale]), Err(StaleKey::Face(stale).into()));
    let h = { of_rings(&[square]) }.dcel().half_edges().next().unwrap().key();
    assert_eq!(is_essential(&map, h), Err(StaleKey::HalfEdge(h)));
    assert!(matches!(remove_inessential(&mut map, &[h]), Err(EditError::Operator(_))));

    let mut builder = Builder::new();
    for (from, to) in [([0.0, 0.0], [2.0, 2.0]), ([0.0, 2.0], [2.0, 0.0]), ([0.0, 0.0], [0.0, 2.0])] {
        builder.segment(from, to).unwrap();
    }
    let mut crossing = builder.build().unwrap();
    let faces: Vec<FaceKey> = crossing.dcel().faces().map(Face::key).collect();
    let why = EditError::NotPlane(crossing.not_plane().unwrap());
    assert_eq!(decompose(&mut crossing, faces), Err(why.into()));

    let far = MAX_COORDINATE;
    let mut large = of_rings(&[&[[0.0, 0.0], [far, 0.0], [far, far], [0.0, far]]]);
    let inside = bounded(&large)[0];
    assert!(matches!(decompose(&mut large, [inside]), Err(ConvexError::OutOfRange { .. })));
    let near = 2_f64.powi(-200);
    let mut small = of_rings(&[&[[0.0, 0.0], [near, 0.0], [near, near]]]);
    let inside = bounded(&small)[0];
    assert!(matches!(decompose(&mut small, [inside]), Err(ConvexError::OutOfRange { .. })));
}

#[test]
fn naming_no_face_or_one_twice_changes_nothing() {
    let mut map = of_rings(&[&[[0.0, 0.0], [4.0, 2.0], [0.0, 4.0], [1.0, 2.0]]]);
    assert_eq!(decompose(&mut map, []), Ok(Vec::new()));
    let face = bounded(&map)[0];
    assert_eq!(decompose(&mut map, [face, face]).unwrap().len(), 1);
}
