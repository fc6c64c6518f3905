//! Locating points.

use crate::location::maps::{Drawing, Random, point, quickcheck, world, world_110m};
use crate::support::edits::{EvenEdits, Place, SIDE};
use crate::support::oracle::{Plain, whole};
use std::collections::HashMap;
use twinedge::dcel::FaceKey;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, on_segment, orientation};
use twinedge_geometry::{MAX_COORDINATE, Point};
use twinedge_map::program::EditRunner;
use twinedge_map::{Builder, LocateError, Located, PlanarMap, QueryLine, Shape};

/// Every point of a grid twice as fine, and slightly beyond, is located consistently with every edge and vertex.
fn grid_maps(drawing: Drawing) -> bool {
    let map = drawing.map();
    let plain = Plain::new(&map);
    let ask = -2..=Drawing::SIDE + 2;
    ask.clone().step_by(2).all(|x| {
        ask.clone().step_by(2).all(|y| {
            let p = point(x, y);
            map.locate(p) == Ok(plain.locate(whole(p), 1))
        })
    })
}

#[test]
fn the_index_agrees_with_the_oracle() {
    quickcheck(600, grid_maps as fn(Drawing) -> bool);
}

#[test]
fn neither_scale_nor_place_matters() {
    fn property(drawing: Drawing) -> bool {
        let map = drawing.map();
        [2_f64.powi(490), 2_f64.powi(-399)].into_iter().all(|scale| {
            let scaled = |p: Point| Point::new(p.x * scale, p.y * scale);
            let mut builder = Builder::new();
            for v in map.dcel().vertices() {
                let p = scaled(map.position(v.key()).unwrap());
                builder.shape(&Shape::Point(p)).unwrap();
            }
            for h in map.dcel().edges() {
                let [from, to] = [h.origin(), h.target()].map(|v| scaled(map.position(v.key()).unwrap()));
                builder.segment(from, to).unwrap();
            }
            let other = builder.build().unwrap();
            // Keys may differ, but the kind of location and the points sharing a face may not.
            let mut faces: HashMap<FaceKey, FaceKey> = HashMap::new();
            (0..=Drawing::SIDE).all(|x| {
                (0..=Drawing::SIDE).all(|y| {
                    let p = point(x, y);
                    match (map.locate(p).unwrap(), other.locate(scaled(p)).unwrap()) {
                        (Located::Face(f), Located::Face(g)) => *faces.entry(f).or_insert(g) == g,
                        (Located::Edge(_), Located::Edge(_)) | (Located::Vertex(_), Located::Vertex(_)) => true,
                        _ => false,
                    }
                })
            })
        })
    }
    quickcheck(50, property as fn(Drawing) -> bool);
}

#[test]
fn nothing_is_around_nothing() {
    let map = Builder::new().build().unwrap();
    let unbounded = map.dcel().unbounded_face().key();
    let origin = Point::default();
    assert_eq!(map.locate(origin), Ok(Located::Face(unbounded)));
}

#[test]
fn what_cannot_be_asked_is_an_error() {
    let map = Drawing::square().map();
    for p in [Point::new(0.0, f64::INFINITY), Point::new(2.0 * MAX_COORDINATE, 0.0), Point::new(1e-200, 0.0)] {
        assert_eq!(map.locate(p), Err(LocateError::OutOfRange(p)));
    }
    assert!(matches!(map.locate(Point::new(f64::NAN, 0.0)), Err(LocateError::OutOfRange(_))));
    assert!(matches!(map.locate(Point::new(0.0, f64::NAN)), Err(LocateError::OutOfRange(_))));
}

/// The face whose boundary a ray straight up crosses an odd number of times, by trying every half-edge.
fn by_parity(map: &PlanarMap, p: Point) -> Located {
    let at = |v: twinedge::dcel::Vertex<'_>| map.position(v.key()).unwrap();
    if let Some(v) = map.dcel().vertices().find(|v| at(*v) == p) {
        return Located::Vertex(v.key());
    }
    let mut odd: HashMap<FaceKey, bool> = HashMap::new();
    for h in map.dcel().half_edges() {
        let (a, b) = (at(h.origin()), at(h.target()));
        if compare_lexicographic(a, b).is_lt() && on_segment(p, a, b) {
            return Located::Edge(h.key());
        }
        let below = if a.x < b.x { Orientation::Clockwise } else { Orientation::CounterClockwise };
        if (a.x < p.x) != (b.x < p.x) && orientation(a, b, p) == below {
            *odd.entry(h.face().key()).or_default() ^= true;
        }
    }
    let unbounded = map.dcel().unbounded_face().key();
    Located::Face(odd.into_iter().find(|(f, odd)| *odd && *f != unbounded).map_or(unbounded, |(f, _)| f))
}

#[test]
fn the_world_is_where_every_border_says() {
    let map = world_110m();
    let places: Vec<Point> = map.dcel().vertices().map(|v| map.position(v.key()).unwrap()).collect();
    let mut random = Random(110);
    for i in 0..240 {
        let p = Point::new(random.between(-181.0, 191.0), random.between(-91.0, 84.0));
        let (v, w) = (places[random.index(places.len())], places[random.index(places.len())]);
        // Anywhere, at a vertex, level with one, above or below one, and combinations.
        let p = [p, v, Point::new(p.x, v.y), Point::new(v.x, p.y), Point::new(v.x, w.y)][i % 5];
        let expected = by_parity(&map, p);
        assert_eq!(map.locate(p), Ok(expected), "{p:?}");
    }
}

#[test]
fn every_vertex_is_found_and_every_edge_of_the_large_world_has_its_faces_beside_it() {
    let map = world(include_bytes!("../../../../../tests/data/world-50m.geojson"));
    for v in map.dcel().vertices() {
        assert_eq!(map.locate(map.position(v.key()).unwrap()), Ok(Located::Vertex(v.key())));
    }
    for h in map.dcel().edges() {
        let [a, b] = [h.origin(), h.target()].map(|v| map.position(v.key()).unwrap());
        let p = Point::new(f64::midpoint(a.x, b.x), f64::midpoint(a.y, b.y));
        // Rounded, it lies on the edge or extremely close to it.
        let (half_edge, face) = match orientation(a, b, p) {
            Orientation::CounterClockwise => (h, h.face()),
            Orientation::Clockwise => (h, h.twin().face()),
            Orientation::Collinear if compare_lexicographic(a, b).is_lt() => (h, h.face()),
            Orientation::Collinear => (h.twin(), h.face()),
        };
        let expected = match map.locate(p).unwrap() {
            Located::Edge(key) => key == half_edge.key(),
            Located::Face(key) => key == face.key() && orientation(a, b, p) != Orientation::Collinear,
            Located::Vertex(_) => false,
        };
        assert!(expected, "{a:?} {b:?}");
    }
}

#[test]
fn countries_and_seas_are_where_they_are() {
    let map = world_110m();
    let unbounded = map.dcel().unbounded_face().key();
    let known: [(f64, f64, &[&str], bool); 4] = [
        (28.25, -29.5, &["Lesotho"], false),
        (24.0, -29.0, &["South Africa"], false),
        // The Caspian Sea, surrounded by countries.
        (51.0, 42.0, &[], false),
        (-30.0, 0.0, &[], true),
    ];
    for (x, y, names, at_sea) in known {
        let Ok(Located::Face(face)) = map.locate(Point::new(x, y)) else { panic!("({x}, {y}) is in a face") };
        let features: Vec<_> = map.features_of(face).unwrap().filter_map(|f| map.name(f)).collect();
        assert_eq!((features.as_slice(), face == unbounded), (names, at_sea));
    }
}

/// Runs every kind of query.
fn ask(map: &PlanarMap, from: Point, to: Point) {
    let plain = Plain::new(map);
    for p in [from, to] {
        let there = plain.locate(whole(p), 1);
        assert_eq!(map.locate(p), Ok(there), "{p:?}");
    }
    if from != to {
        for stretch in [QueryLine::Segment(from, to), QueryLine::Ray(from, to), QueryLine::Line(from, to)] {
            assert_eq!(map.zone(&stretch), Ok(plain.zone(&stretch)), "{stretch:?}");
        }
    }
}

fn program(edits: EvenEdits, asked: Vec<(Place, Place)>) -> bool {
    let mut runner = EditRunner::new(PlanarMap::new());
    let mut asked = asked.iter();
    for (i, op) in edits.0.0.iter().enumerate() {
        runner.step(op);
        if let Some((from, to)) = (i % 3 == 2).then(|| asked.next()).flatten() {
            ask(runner.map(), from.point(), to.point());
        }
    }
    ask(runner.map(), point(-1, 3), point(i32::from(SIDE) + 1, 5));
    true
}

#[test]
fn answers_are_those_of_the_map_as_it_is_after_its_edits() {
    quickcheck(300, program as fn(EvenEdits, Vec<(Place, Place)>) -> bool);
}

#[test]
fn a_point_just_beside_an_edge_is_not_placed_by_records_that_lie_behind_it() {
    let mut map = PlanarMap::new();
    map.insert_ring([[0.0, 5.0], [5.0, 0.0], [3.0, 3.0]]).unwrap();
    // Its distance from (4.5, 4.5) is so small that the mirrored point does not lie across.
    map.insert_segment([0.0, 6.0], [6.000_000_000_000_001, 4.0]).unwrap();
    assert_eq!(map.locate(Point::new(4.5, 4.5)), Ok(Located::Face(map.dcel().unbounded_face().key())));
}
