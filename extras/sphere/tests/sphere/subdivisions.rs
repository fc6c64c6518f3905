//! The half-edge structure of maps on the sphere.

use crate::support::{Numbers, at, feature};
use twinedge::validate::{Collect, Expectation, validate};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Meeting, Orientation};
use twinedge_map::{Feature, Shape};
use twinedge_sphere::predicates::{meeting, side};
use twinedge_sphere::{Clash, Cover, Drawing, Inside, Place, Subdivision, SubdivisionError, Unresolved};

/// Builds the structure, and checks every rule on it.
fn valid(drawing: &Drawing) -> (Vec<Clash>, Subdivision) {
    let (clashes, map) = Subdivision::new(drawing);
    let map = map.expect("it can be cut");
    let report = validate(map.dcel(), &Expectation::plane(), Collect::All);
    assert!(report.is_valid(), "{report}");
    assert_eq!((map.out_of_order(), map.misplaced()), (0, 0));
    (clashes, map)
}

/// The faces of an octahedron with its corners at the poles and on the equator.
fn octants() -> Vec<Feature> {
    let octant =
        |(west, pole): (f64, f64)| feature(Shape::polygon([[west, 0.0], [west + 90.0, 0.0], [west + 45.0, pole]]));
    [0.0, 90.0, 180.0, 270.0].into_iter().flat_map(|west| [(west, 90.0), (west, -90.0)]).map(octant).collect()
}

#[test]
fn an_octahedron_is_drawn_without_an_outside() {
    let drawing = Drawing::new(&octants()).expect("places");
    let (clashes, map) = valid(&drawing);
    assert_eq!(clashes, []);
    let dcel = map.dcel();
    assert_eq!((dcel.vertex_count(), dcel.edge_count(), dcel.face_count()), (6, 12, 8));
    let cover = Cover::new(&map, &drawing, Inside::Smaller);
    let eighth = 4.0 * std::f64::consts::PI * twinedge_sphere::RADIUS.powi(2) / 8.0;
    for feature in 0..8 {
        assert!((cover.area_of(feature) / eighth - 1.0).abs() < 1e-14);
    }
    assert_eq!(cover.features_at(at(100.0, -3.0)), [3]);
}

#[test]
fn components_lie_in_the_faces_around_them() {
    let ring = |at: [f64; 2], size: f64| {
        let [x, y] = at;
        Shape::polygon([[x - size, y - size], [x + size, y - size], [x + size, y + size], [x - size, y + size]])
    };
    // Rings around the antimeridian, within each other, and around both poles.
    let rings: Vec<Feature> = [10.0, 5.0, 2.0, 1.0].map(|size| feature(ring([180.0, 20.0], size))).into();
    let cap = |latitude: f64| feature(Shape::polygon([0.0, 90.0, 180.0, -90.0].map(|x| [x, latitude])));
    let all: Vec<Feature> = rings.into_iter().chain([cap(80.0), cap(85.0), cap(-80.0), cap(-85.0)]).collect();
    let drawing = Drawing::new(&all).expect("places");
    let (clashes, map) = valid(&drawing);
    assert_eq!((clashes.len(), map.dcel().face_count()), (0, 9));
    let cover = Cover::new(&map, &drawing, Inside::Smaller);
    assert_eq!(cover.features_at(at(180.0, 20.5)), [0, 1, 2, 3]);
    assert_eq!(cover.features_at(at(-178.5, 20.0)), [0, 1, 2]);
    assert_eq!(cover.features_at(at(-169.0, 20.0)), [0_u32; 0]);
    assert_eq!((cover.features_at(Place::NORTH), cover.features_at(Place::SOUTH)), (&[4, 5][..], &[6, 7][..]));
    assert_eq!(cover.features_at(at(33.0, 83.0)), [4]);
}

#[test]
fn an_arc_over_the_pole_is_cut_there() {
    // Its ends lie on opposite meridians: the shortest path leads over the pole.
    let lune = Shape::polygon([[0.0, 80.0], [60.0, 70.0], [180.0, 70.0]]);
    let drawing = Drawing::new(&[feature(lune)]).expect("places");
    let (clashes, map) = valid(&drawing);
    assert_eq!((clashes.len(), map.dcel().edge_count()), (0, 4));
    let cover = Cover::new(&map, &drawing, Inside::Smaller);
    assert_eq!((cover.features_at(at(90.0, 85.0)), cover.features_at(at(-90.0, 85.0))), (&[0][..], &[][..]));
}

/// Borders that coincide up to some last digits cross in rounded places, and so do their parts: cutting still terminates, with a map or an error.
#[test]
fn cutting_borders_that_differ_by_roundings_ends() {
    let mut numbers = Numbers(8);
    for _ in 0..20 {
        let base: Vec<[f64; 2]> =
            (0..5).map(|_| [numbers.fraction() * 40.0 + 160.0, numbers.fraction() * 30.0 + 60.0]).collect();
        let mut jittered = || {
            let mut digits = |x: f64| x + (numbers.below(9) as f64 - 4.0) * f64::EPSILON * 64.0;
            feature(Shape::polygon(base.iter().map(|[x, y]| [digits(*x), digits(*y)]).collect::<Vec<_>>()))
        };
        let drawing = Drawing::new(&[jittered(), jittered(), jittered()]).expect("places");
        let (clashes, map) = Subdivision::new(&drawing);
        assert!(!clashes.is_empty());
        match map {
            Ok(map) => assert!(validate(map.dcel(), &Expectation::plane(), Collect::All).is_valid()),
            Err(error) => assert_eq!(error, SubdivisionError::Unresolved(Unresolved)),
        }
    }
}

/// Lines with free ends, alone or at a border, do not change the areas of faces.
#[test]
fn lines_change_no_area() {
    let field = feature(Shape::polygon([[10.0, 40.0], [20.0, 40.0], [20.0, 50.0], [10.0, 50.0]]));
    let star = |at: [f64; 2]| {
        let ray = |i: u32| {
            let angle = f64::from(i) * 0.7;
            Shape::line([at, [at[0] + angle.cos(), at[1] + angle.sin()]])
        };
        Feature { shapes: (0..8).map(ray).collect(), ..Feature::default() }
    };
    let area = |features: &[Feature]| {
        let drawing = Drawing::new(features).expect("places");
        let (clashes, map) = valid(&drawing);
        assert_eq!(clashes, []);
        Cover::new(&map, &drawing, Inside::Smaller).area_of(0)
    };
    let alone = area(std::slice::from_ref(&field));
    let dangling = feature(Shape::line([[10.0, 50.0], [12.0, 48.0], [12.5, 47.0]]));
    for lines in [star([15.0, 45.0]), star([100.0, -45.0]), star([20.0, 40.0]), dangling] {
        let with_lines = area(&[field.clone(), lines]);
        assert!((with_lines / alone - 1.0).abs() < 1e-12, "{with_lines} {alone}");
    }
}

/// Random polygons between a few places, many of which coincide.
fn polygons(numbers: &mut Numbers) -> Vec<Feature> {
    let coordinates = |numbers: &mut Numbers| {
        let longitudes = [-180.0, -120.0, -90.0, -45.0, 0.0, 30.0, 90.0, 100.0, 180.0];
        let latitudes = [-90.0, -60.0, -20.0, 0.0, 10.0, 45.0, 70.0, 90.0];
        [longitudes[numbers.below(longitudes.len())], latitudes[numbers.below(latitudes.len())]]
    };
    let polygon = |numbers: &mut Numbers| {
        let corners = 3 + numbers.below(3);
        feature(Shape::polygon((0..corners).map(|_| coordinates(numbers)).collect::<Vec<_>>()))
    };
    (0..=numbers.below(4)).map(|_| polygon(numbers)).collect()
}

/// Returns true if an arc crosses the arcs of a feature an odd number of times; `None` if it meets a vertex.
fn parity(drawing: &Drawing, feature: &Feature, from: Place, to: Place) -> Option<bool> {
    let Shape::Polygon(rings) = &feature.shapes[0] else { return None };
    let mut is_odd = false;
    for ring in rings {
        let places: Vec<Place> = ring.iter().map(|p: &Point| at(p.x, p.y)).collect();
        for (i, a) in places.iter().enumerate() {
            let b = places[(i + 1) % places.len()];
            if *a == b || drawing.undrawn().iter().any(|_| a.antipode() == b) {
                continue;
            }
            match meeting(*a, b, from, to) {
                Meeting::Cross => is_odd = !is_odd,
                Meeting::Disjoint => {}
                _ => return None,
            }
        }
    }
    Some(is_odd)
}

/// The even-odd rule: two places are on the same side of a feature if a path between them crosses its border an even number of times. This uses no
/// half-edges, components or areas.
#[test]
fn features_cover_what_even_and_odd_crossings_say() {
    let (mut numbers, mut asked, mut crossed, mut several) = (Numbers(6), 0, 0, 0);
    for _ in 0..250 {
        let features = polygons(&mut numbers);
        let drawing = Drawing::new(&features).expect("places");
        if !drawing.undrawn().is_empty() {
            continue;
        }
        let (clashes, map) = valid(&drawing);
        crossed += clashes.len();
        let dcel = map.dcel();
        several += usize::from(dcel.vertex_count() + dcel.face_count() > dcel.edge_count() + 2);
        let cover = Cover::new(&map, &drawing, Inside::Smaller);
        let mut place = || at(numbers.fraction() * 360.0 - 180.0, (numbers.fraction() * 2.0 - 1.0).asin().to_degrees());
        for _ in 0..8 {
            let (from, to) = (place(), place());
            for (number, feature) in (0..).zip(&features) {
                let Some(is_odd) = parity(&drawing, feature, from, to) else { continue };
                let covers = |place: Place| cover.features_at(place).contains(&number);
                assert_eq!(covers(from) != covers(to), is_odd, "{feature:?} {from:?} {to:?}");
                asked += 1;
            }
        }
        // No polygon is larger than half the sphere, and a triangle lies on the inner side of its three arcs.
        for (number, feature) in (0..).zip(&features) {
            let half = 2.0 * std::f64::consts::PI * twinedge_sphere::RADIUS.powi(2);
            assert!(cover.area_of(number) <= half * (1.0 + 1e-12), "{} {feature:?}", cover.area_of(number) / half);
            let Shape::Polygon(rings) = &feature.shapes[0] else { continue };
            let corners: Vec<Place> = rings[0].iter().map(|p| at(p.x, p.y)).collect();
            if let [a, b, c] = corners[..]
                && side(a, b, c) != Orientation::Collinear
            {
                let turn = side(a, b, c);
                let p = place();
                let is_inside = [(a, b), (b, c), (c, a)].into_iter().all(|(a, b)| side(a, b, p) == turn);
                assert_eq!(cover.features_at(p).contains(&number), is_inside);
            }
        }
    }
    assert!(asked > 2_000 && crossed > 200 && several > 5, "{asked} {crossed} {several}");
}
