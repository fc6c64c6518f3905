//! Overlays: nesting, and areas compared with an independent crate.
#![expect(clippy::float_cmp, reason = "areas of few whole coordinates are exact")]

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use quickcheck::QuickCheck;
use std::collections::BTreeSet;
use std::sync::{Arc, Mutex};
use twinedge::dcel::{Face, OperatorError, Policy, StaleKey};
use twinedge_algorithm::area::{face_area, feature_area, ring_area};
use twinedge_algorithm::overlay::{Operand, Operation, Overlay, OverlayError, overlay};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_layers::{ReadOptions, read_for_map};
use twinedge_map::{BuildError, Builder, Feature, FeatureId, Features, Noding, PlanarMap, Shape};

type Whole = (i8, i8);

fn at((x, y): Whole) -> Point {
    Point::new(f64::from(x), f64::from(y))
}

fn ring(corners: &[Whole]) -> Vec<Point> {
    corners.iter().copied().map(at).collect()
}

fn polygon(name: &str, corners: &[Whole]) -> Feature {
    Feature { name: Some(name.into()), shapes: vec![Shape::Polygon(vec![ring(corners)])], ..Feature::default() }
}

fn built(features: &[Feature]) -> PlanarMap {
    let mut builder = Builder::new();
    for feature in features {
        builder.feature(feature).expect("in range");
    }
    builder.build_with(Noding::Snap(Snap::Auto)).expect("in reach")
}

fn nth(map: &PlanarMap, n: usize) -> FeatureId {
    map.features().nth(n).expect("there are as many")
}

fn names(map: &PlanarMap, features: impl Iterator<Item = FeatureId>) -> Vec<&str> {
    features.map(|feature| map.name(feature).unwrap_or("nameless")).collect()
}

fn area(both: &Overlay, operation: Operation, left: FeatureId, right: FeatureId) -> f64 {
    both.faces(operation, left, right).map(|face| face_area(both.map(), face).expect("of this map")).sum()
}

/// Vertices and edges by their coordinates.
fn drawing(map: &PlanarMap) -> (BTreeSet<[u64; 2]>, BTreeSet<[[u64; 2]; 2]>) {
    let bits = |v: twinedge::dcel::Vertex<'_>| {
        let p = map.position(v.key()).expect("of this map");
        [p.x.to_bits(), p.y.to_bits()]
    };
    let ends = |h: twinedge::dcel::HalfEdge<'_>| {
        let mut ends = [bits(h.origin()), bits(h.target())];
        ends.sort_unstable();
        ends
    };
    (map.dcel().vertices().map(bits).collect(), map.dcel().half_edges().map(ends).collect())
}

/// ```text
///   5 . . +-----------+
///   4 +---|---+   r   |      left: l, with the hole h in it; right: r, and a road from (0, 1) to (6, 1)
///   3 | l |   |       |
///   2 |   | +-+ . . . |
///   1 ---------- - - - road
///   0 +---|---+-------+
///     0   2   4       8
/// ```
#[test]
fn every_face_and_edge_knows_where_it_lies_in_both() {
    let left = built(&[polygon("l", &[(0, 0), (4, 0), (4, 4), (0, 4)])]);
    let road =
        Feature { name: Some("road".into()), shapes: vec![Shape::Line(ring(&[(0, 1), (6, 1)]))], ..Feature::default() };
    let right = built(&[polygon("r", &[(2, 0), (8, 0), (8, 5), (2, 5)]), road]);
    let both = overlay(&left, &right, Snap::Auto).expect("they fit");
    let map = both.map();
    assert!(map.validate().is_valid());
    assert_eq!(names(map, map.features()), ["l", "r", "road"]);

    let mut faces: Vec<_> = map
        .dcel()
        .faces()
        .map(|face| {
            let lies_in = |operand, of: &PlanarMap| {
                let key = both.face_in(operand, face.key()).expect("of this map");
                names(of, of.features_of(key).expect("of that map")).concat()
            };
            let here = names(map, map.features_of(face.key()).expect("of this map")).concat();
            let area = face_area(map, face.key()).expect("of this map");
            (area, here, lies_in(Operand::Left, &left), lies_in(Operand::Right, &right))
        })
        .collect();
    faces.sort_by(|a, b| a.partial_cmp(b).expect("areas are numbers"));
    let row = |area: f64, here: &str, left: &str, right: &str| (area, here.into(), left.into(), right.into());
    assert_eq!(
        faces,
        [
            row(2.0, "l", "l", ""),
            row(2.0, "lr", "l", "r"),
            row(6.0, "l", "l", ""),
            row(6.0, "lr", "l", "r"),
            row(22.0, "r", "", "r"),
            row(f64::INFINITY, "", "", ""),
        ]
    );
    // The road is cut where it meets the borders of both.
    let along = |h: &twinedge::dcel::HalfEdge<'_>| names(map, map.features_along(h.key()).expect("of this map"));
    let roads = map.dcel().half_edges().filter(|h| h.index() < h.twin().index()).filter(|h| along(h).contains(&"road"));
    assert_eq!(roads.count(), 3);
    let borders: BTreeSet<_> = map.dcel().half_edges().map(|h| along(&h).concat()).collect();
    assert_eq!(borders.iter().map(String::as_str).collect::<Vec<_>>(), ["l", "lr", "r", "road"]);
    let (l, r) = (nth(&left, 0), nth(&right, 0));
    assert_eq!(both.feature_of(Operand::Right, r), map.features().nth(1));
    assert_eq!(both.feature_of(Operand::Left, nth(&right, 1)), None);
    assert_eq!(both.faces(Operation::Intersection, l, r).count(), 2);
}

#[test]
fn maps_that_are_not_plane_are_refused() {
    let cross = [((0, 0), (2, 2)), ((0, 2), (2, 0))];
    let mut builder = Builder::new();
    for (a, b) in cross {
        builder.segment(at(a), at(b)).expect("in range");
    }
    let (bad, good) = (builder.build().expect("fits"), built(&[]));
    let outcome = |left, right| overlay(left, right, Snap::Auto).map(|_| ());
    assert_eq!(outcome(&bad, &good), Err(OverlayError::NotPlane(Operand::Left, bad.not_plane().unwrap())));
    assert_eq!(outcome(&good, &bad), Err(OverlayError::NotPlane(Operand::Right, bad.not_plane().unwrap())));
    assert_eq!(overlay(&good, &good, Snap::Size(0.0)).map(|_| ()), Err(OverlayError::Build(BuildError::CellSize)));
}

#[test]
fn a_face_of_another_map_is_stale() {
    let map = built(&[polygon("l", &[(0, 0), (4, 0), (4, 4)])]);
    let both = overlay(&map, &map, Snap::Auto).expect("they fit");
    for face in map.dcel().faces().map(Face::key) {
        assert_eq!(both.face_in(Operand::Left, face), Err(StaleKey::Face(face)));
    }
}

#[test]
fn islands_in_lakes_lie_where_they_should() {
    // A lake in an island in a lake, and isolated points, over a land that ends in the middle.
    let rings = [ring(&[(0, 0), (90, 0), (90, 90), (0, 90)]), ring(&[(10, 10), (80, 10), (80, 80), (10, 80)])];
    let island = [ring(&[(20, 20), (70, 20), (70, 70), (20, 70)]), ring(&[(30, 30), (60, 30), (60, 60), (30, 60)])];
    let land = Feature {
        name: Some("land".into()),
        shapes: vec![
            Shape::Polygon(rings.to_vec()),
            Shape::Polygon(island.to_vec()),
            Shape::Point(at((40, 40))),
            Shape::Point(at((50, 50))),
        ],
        ..Feature::default()
    };
    let left = built(&[land]);
    let right = built(&[polygon("claim", &[(-10, -10), (45, -10), (45, 100), (-10, 100)])]);
    let both = overlay(&left, &right, Snap::Auto).expect("they fit");
    assert!(both.map().validate().is_valid());
    assert_eq!(both.map().validate().counts().isolated_vertices, 2);
    let (land, claim) = (nth(&left, 0), nth(&right, 0));
    let whole = 8_100.0 - 4_900.0 + 2_500.0 - 900.0;
    assert_eq!(feature_area(both.map(), both.feature_of(Operand::Left, land).expect("it is there")), whole);
    assert_eq!(area(&both, Operation::Intersection, land, claim), whole / 2.0);
    assert_eq!(area(&both, Operation::Difference, land, claim), whole / 2.0);
    assert_eq!(area(&both, Operation::Union, land, claim), whole / 2.0 + 55.0 * 110.0);
}

#[test]
fn a_map_over_itself_is_itself() {
    let mut file: &[u8] = include_bytes!("../../../cli/data/world-110m.geojson");
    let (features, _) = read_for_map(&mut file, &ReadOptions::default()).expect("it is a map");
    let map = built(&features);
    let both = overlay(&map, &map, Snap::Auto).expect("they fit");
    assert_eq!(drawing(both.map()), drawing(&map));
    assert_eq!(both.map().dcel().face_count(), map.dcel().face_count());
    let mut seen = BTreeSet::new();
    for face in both.map().dcel().faces().map(Face::key) {
        let lies_in = [Operand::Left, Operand::Right].map(|operand| both.face_in(operand, face).expect("of this map"));
        assert_eq!(lies_in[0], lies_in[1]);
        assert_eq!(face_area(both.map(), face), face_area(&map, lies_in[0]));
        seen.insert(lies_in[0]);
    }
    assert_eq!(seen.len(), map.dcel().face_count());
    // Also with an empty map.
    let alone = overlay(&built(&[]), &map, Snap::Auto).expect("they fit");
    assert_eq!(drawing(alone.map()), drawing(&map));
    for (before, after) in map.features().zip(alone.map().features()) {
        assert_eq!(map.name(before), alone.map().name(after));
        assert_eq!(feature_area(&map, before), feature_area(alone.map(), after));
    }
}

/// Returns the area of the faces of an overlay of two polygons, by the independent crate.
fn independent(left: &[Whole], right: &[Whole], rule: OverlayRule) -> f64 {
    let contour = |corners: &[Whole]| corners.iter().map(|(x, y)| [f64::from(*x), f64::from(*y)]).collect::<Vec<_>>();
    let shapes = contour(left).overlay(&contour(right), rule, FillRule::EvenOdd);
    shapes.iter().flatten().map(|ring| ring_area(ring.iter().map(|p| Point::new(p[0], p[1])))).sum()
}

#[test]
fn areas_are_those_that_an_independent_crate_finds() {
    // Polygons with arbitrary corners: most cross themselves, and are filled by parity.
    #[expect(clippy::needless_pass_by_value, reason = "quickcheck hands values over")]
    fn law(one: Vec<Whole>, other: Vec<Whole>) -> Result<(), String> {
        let (one, other) = (&one[..one.len().min(9)], &other[..other.len().min(9)]);
        let (left, right) = (built(&[polygon("", one)]), built(&[polygon("", other)]));
        let both = overlay(&left, &right, Snap::Auto).map_err(|error| error.to_string())?;
        let report = both.map().validate();
        if !report.is_valid() {
            return Err(report.to_string());
        }
        for (operation, rule) in [
            (Operation::Union, OverlayRule::Union),
            (Operation::Intersection, OverlayRule::Intersect),
            (Operation::Difference, OverlayRule::Difference),
            (Operation::SymmetricDifference, OverlayRule::Xor),
        ] {
            let ours = area(&both, operation, nth(&left, 0), nth(&right, 0));
            let theirs = independent(one, other, rule);
            // It rounds to a grid of some 2^-22 here, which moves borders up to a thousand long.
            if (ours - theirs).abs() > 1e-3 {
                return Err(format!("{operation:?}: {ours}, not {theirs}, of {one:?} and {other:?}"));
            }
        }
        Ok(())
    }
    QuickCheck::new().tests(300).quickcheck(law as fn(_, _) -> _);
}

#[test]
fn only_edges_of_a_map_part_its_faces() {
    // On a grid so coarse that much of both maps collapses.
    #[expect(clippy::needless_pass_by_value, reason = "quickcheck hands values over")]
    fn law(one: Vec<(Whole, Whole, Whole)>, other: Vec<(Whole, Whole, Whole)>) -> bool {
        let triangles = |of: &[(Whole, Whole, Whole)]| {
            built(&of.iter().take(6).map(|(a, b, c)| polygon("", &[*a, *b, *c])).collect::<Vec<_>>())
        };
        let maps = [triangles(&one), triangles(&other)];
        let both = overlay(&maps[0], &maps[1], Snap::Size(16.0)).expect("in reach");
        let noded = both.map();
        let outside = noded.dcel().unbounded_face().key();
        let operands = [Operand::Left, Operand::Right];
        noded.validate().is_valid()
            && operands.into_iter().zip(&maps).all(|(operand, map)| {
                let in_map = |face| both.face_in(operand, face).expect("of this map");
                let own: Vec<_> = map.features().map(|feature| both.feature_of(operand, feature)).collect();
                let is_own = |h| noded.features_along(h).expect("of this map").any(|f| own.contains(&Some(f)));
                in_map(outside) == map.dcel().unbounded_face().key()
                    && noded
                        .dcel()
                        .half_edges()
                        .all(|h| is_own(h.key()) || in_map(h.face().key()) == in_map(h.twin().face().key()))
            })
    }
    QuickCheck::new().tests(200).quickcheck(law as fn(_, _) -> _);
}

#[test]
fn values_of_faces_are_cut_by_their_policies_and_dropped_with_what_vanishes() {
    let ring = |x: f64, y: f64, side: f64| [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
    let lost = Arc::new(Mutex::new(Vec::new()));
    let seen = lost.clone();
    let (mut left, mut right) = (PlanarMap::new(), PlanarMap::new());
    let owner = left.add_attribute(Policy::of_faces().split_copy());
    let tax = left.add_attribute(Policy::of_faces().split_share().drop_with(move |tax: &f64| {
        seen.lock().unwrap().push(*tax);
        Ok(())
    }));
    let name = left.add_attribute(Policy::of_faces());
    let zone = right.add_attribute(Policy::of_faces().split_with(|zone: u32| Ok([Some(zone), Some(zone + 1)])));
    let parcel = left.insert_ring(ring(0.0, 0.0, 8.0)).unwrap().faces_split[0].1;
    let sliver = left.insert_ring(ring(20.0, 20.0, 0.25)).unwrap().faces_split[0].1;
    let inside = right.insert_ring(ring(-2.0, -2.0, 4.0)).unwrap().faces_split[0].1;
    // A third part of the parcel.
    right.insert_ring(ring(4.0, 4.0, 3.0)).unwrap();
    let id = left.add_attribute(Policy::of_faces().ids(1));
    let of_vertices = left.add_attribute(Policy::of_vertices().ids(1));
    let corner = left.dcel().vertices().next().unwrap().key();
    left.set_value(of_vertices, corner, 5_u64).unwrap();
    left.set_value(id, parcel, 10_u64).unwrap();
    left.set_value(id, sliver, 11_u64).unwrap();
    left.set_value(owner, parcel, "Ada").unwrap();
    left.set_value(name, parcel, "home").unwrap();
    left.set_value(tax, parcel, 64.0).unwrap();
    left.set_value(tax, sliver, 1.0).unwrap();
    right.set_value(zone, inside, 5_u32).unwrap();
    let both = overlay(&left, &right, Snap::Size(1.0)).unwrap();
    let map = both.map();
    let value = |operand, of| both.face_in(operand, of).unwrap();
    let mut found: Vec<_> =
        map.dcel().faces().map(|f| f.key()).filter(|f| value(Operand::Left, *f) == parcel).collect();
    found.sort_by(|f, g| face_area(map, *g).unwrap().total_cmp(&face_area(map, *f).unwrap()));
    let [large, middle, small] = found[..] else { panic!("{found:?}") };
    let values = [large, middle, small].map(|f| (map.value(owner, f), map.value(tax, f), map.value(name, f)));
    let ada = Some(&"Ada");
    assert_eq!(values, [(ada, Some(&51.0), Some(&"home")), (ada, Some(&9.0), None), (ada, Some(&4.0), None)]);
    assert_eq!([10, 11].map(|number| map.find(id, &number)), [Some(large), None]);
    // All parts get ids, including parts outside of the parcels.
    for f in map.dcel().faces().filter(|f| !f.is_unbounded()).map(|f| f.key()) {
        assert_eq!(map.value(id, f).and_then(|number| map.find(id, number)), Some(f));
    }
    // Values of vertices are not carried, and not found.
    assert_eq!((map.find(of_vertices, &5), map.values(of_vertices).unwrap().len()), (None, 0));
    // The rest of the zone is larger than the part inside the parcel.
    let zones: Vec<u32> = map.values(zone).unwrap().values().copied().collect();
    assert_eq!((map.value(zone, small), zones.len()), (Some(&6), 2));
    assert_eq!(*lost.lock().unwrap(), [1.0]);
    // A map laid over itself has its attributes once, and its features twice.
    let of_feature = right.add_attribute(Policy::<Features, _>::new());
    let wood = right.add_feature(Some("wood".into()));
    right.set_value(of_feature, wood, "oaks").unwrap();
    let twice = overlay(&right, &right, Snap::Size(1.0)).unwrap();
    assert_eq!(twice.map().values(zone).unwrap().len(), 1);
    let trees = twice.map().features().map(|f| twice.map().value(of_feature, f));
    assert!(trees.eq([Some(&"oaks"); 2]));

    let strict = left.add_attribute(Policy::of_faces().drop_with(|_: &u8| Err("never")));
    left.set_value(strict, sliver, 1).unwrap();
    let refused = overlay(&left, &right, Snap::Size(1.0)).map(|_| ());
    assert_eq!(refused, Err(OverlayError::Attribute(OperatorError::Refused("never"))));
}
