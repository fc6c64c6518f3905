//! Zones of lines.

use crate::location::maps::{Drawing, Random, point, quickcheck, world, world_110m};
use crate::support::oracle::Plain;
use twinedge_geometry::Point;
use twinedge_map::{Builder, LocateError, PlanarMap, QueryLine, Shape, ZoneElement};

/// Returns an end for a query, mostly on the grid of the vertices.
fn place(x: u8, y: u8) -> Point {
    let on_grid = |c: u8| {
        let c = i32::from(c) % (2 * Drawing::SIDE);
        if c <= Drawing::SIDE { c / Drawing::STEP * Drawing::STEP } else { c - Drawing::SIDE - 2 }
    };
    point(on_grid(x), on_grid(y))
}

fn zones(drawing: Drawing, queries: Vec<(u8, u8, u8, u8)>) -> bool {
    let map = drawing.map();
    let plain = Plain::new(&map);
    queries.into_iter().all(|(a, b, c, d)| {
        let (from, to) = (place(a, b), place(c, d));
        [QueryLine::Segment(from, to), QueryLine::Ray(from, to), QueryLine::Line(from, to)].iter().all(|stretch| {
            let expected = if from == to { Err(LocateError::NoDirection(from)) } else { Ok(plain.zone(stretch)) };
            map.zone(stretch) == expected
        })
    })
}

#[test]
fn the_zone_agrees_with_the_oracle() {
    quickcheck(600, zones as fn(Drawing, Vec<(u8, u8, u8, u8)>) -> bool);
}

/// Returns the elements met, for the opposite direction.
fn turned(map: &PlanarMap, met: &[ZoneElement]) -> Vec<ZoneElement> {
    let twin = |h| map.dcel().half_edge(h).unwrap().twin().key();
    let turn = |met: &ZoneElement| match *met {
        ZoneElement::Edge(h) => ZoneElement::Edge(twin(h)),
        ZoneElement::Along(h) => ZoneElement::Along(twin(h)),
        other => other,
    };
    met.iter().rev().map(turn).collect()
}

/// Faces and stretches along edges alternate with edges and vertices, and successive elements touch.
fn is_a_way(map: &PlanarMap, met: &[ZoneElement]) -> bool {
    let half_edge = |h| map.dcel().half_edge(h).unwrap();
    met.windows(2).all(|pair| match (pair[0], pair[1]) {
        (ZoneElement::Face(f), ZoneElement::Edge(h)) => half_edge(h).twin().face().key() == f,
        (ZoneElement::Edge(h), ZoneElement::Face(f)) => half_edge(h).face().key() == f,
        (ZoneElement::Face(f), ZoneElement::Vertex(v)) | (ZoneElement::Vertex(v), ZoneElement::Face(f)) => {
            let vertex = map.dcel().vertex(v).unwrap();
            vertex.rotation().any(|h| h.face().key() == f) || vertex.isolated().is_some_and(|b| b.face().key() == f)
        }
        (ZoneElement::Along(h), ZoneElement::Vertex(v)) => half_edge(h).target().key() == v,
        (ZoneElement::Vertex(v), ZoneElement::Along(h)) => half_edge(h).origin().key() == v,
        _ => false,
    })
}

#[test]
fn across_the_world_and_back() {
    let map = world_110m();
    let vertices: Vec<_> = map.dcel().vertices().collect();
    let mut random = Random(1);
    let mut most = 0;
    for i in 0..400 {
        let v = vertices[random.index(vertices.len())];
        let w = vertices[random.index(vertices.len())];
        let (from, w) = (map.position(v.key()).unwrap(), map.position(w.key()).unwrap());
        let anywhere = Point::new(random.between(-181.0, 191.0), random.between(-91.0, 84.0));
        let to = [w, anywhere, Point::new(w.x, from.y), Point::new(from.x, w.y)][i % 4];
        let there = map.zone(&QueryLine::Segment(from, to)).unwrap();
        assert!(is_a_way(&map, &there));
        assert_eq!(there[0], ZoneElement::Vertex(v.key()));
        assert_eq!(map.zone(&QueryLine::Segment(to, from)).unwrap(), turned(&map, &there));
        // The line is the common part of the two rays, plus the rest of each.
        let line = map.zone(&QueryLine::Line(from, to)).unwrap();
        let onwards = map.zone(&QueryLine::Ray(from, to)).unwrap();
        let back = map.zone(&QueryLine::Ray(to, from)).unwrap();
        assert!(is_a_way(&map, &line) && onwards.starts_with(&there));
        assert!(line.ends_with(&onwards) && line.starts_with(&turned(&map, &back)));
        most = most.max(there.len());
    }
    assert!(most > 80, "{most}");
}

#[test]
fn a_parallel_crosses_the_countries_of_the_atlas() {
    // Along 1.5 degrees north, from the Atlantic to the Indian Ocean.
    let map = world(include_bytes!("../../../../../tests/data/world-50m.geojson"));
    let met = map.zone(&QueryLine::Segment(Point::new(5.0, 1.5), Point::new(50.0, 1.5))).unwrap();
    let mut countries = Vec::new();
    for met in met {
        if let ZoneElement::Face(face) = met {
            countries.extend(map.features_of(face).unwrap().filter_map(|f| map.name(f)));
        }
    }
    countries.dedup();
    assert_eq!(countries, ["Eq. Guinea", "Gabon", "Congo", "Dem. Rep. Congo", "Uganda", "Kenya", "Somalia"]);
}

#[test]
fn lines_that_miss_touch_and_end_inside() {
    let map = Drawing::square().map();
    let unbounded = ZoneElement::Face(map.dcel().unbounded_face().key());
    let zone = |stretch| map.zone(&stretch).unwrap();
    // Past the square, and through one of its corners only.
    assert_eq!(zone(QueryLine::Line(point(-9, 50), point(9, 50))), [unbounded]);
    assert_eq!(zone(QueryLine::Segment(point(-9, 50), point(9, 60))), [unbounded]);
    assert_eq!(zone(QueryLine::Ray(point(50, 1), point(51, 1))), [unbounded]);
    let tangent = zone(QueryLine::Line(point(-4, 4), point(4, -4)));
    assert!(matches!(tangent[..], [a, ZoneElement::Vertex(_), b] if a == unbounded && b == unbounded));
    // Along the whole side of length 4, from before it to beyond it, and along a part.
    let along = zone(QueryLine::Line(point(-1, 0), point(1, 0)));
    assert!(matches!(along[..], [_, ZoneElement::Vertex(_), ZoneElement::Along(_), ZoneElement::Vertex(_), _]));
    let [ZoneElement::Along(h)] = zone(QueryLine::Segment(point(3, 0), point(1, 0)))[..] else {
        panic!("it lies in the side")
    };
    assert_eq!(map.position(map.dcel().half_edge(h).unwrap().target().key()), Ok(point(0, 0)));
    // From the inside of one side to the inside of another, from a side to the interior, and inside.
    let inside = map.dcel().faces().find(|f| !f.is_unbounded()).unwrap().key();
    let across = zone(QueryLine::Segment(point(0, 2), point(4, 3)));
    assert!(matches!(across[..], [ZoneElement::Edge(_), ZoneElement::Face(f), ZoneElement::Edge(_)] if f == inside));
    let into = zone(QueryLine::Segment(point(0, 2), point(1, 3)));
    assert!(matches!(into[..], [ZoneElement::Edge(h), ZoneElement::Face(f)]
        if f == inside && map.dcel().half_edge(h).unwrap().face().key() == inside));
    assert_eq!(zone(QueryLine::Segment(point(1, 2), point(1, 3))), [ZoneElement::Face(inside)]);
    // Away from a side: the outside is ahead.
    let away = zone(QueryLine::Ray(point(0, 2), point(-1, 2)));
    assert!(matches!(away[..], [ZoneElement::Edge(h), a]
        if a == unbounded && map.dcel().half_edge(h).unwrap().twin().face().key() == inside));
}

#[test]
fn what_cannot_be_asked_is_an_error() {
    let map = Drawing::square().map();
    let (p, bad) = (point(1, 1), Point::new(1e200, 0.0));
    for stretch in [QueryLine::Segment(p, bad), QueryLine::Ray(bad, p), QueryLine::Line(p, bad)] {
        assert_eq!(map.zone(&stretch), Err(LocateError::OutOfRange(bad)));
    }
    assert_eq!(map.zone(&QueryLine::Line(p, p)), Err(LocateError::NoDirection(p)));

    // Two triangles that overlap.
    let mut builder = Builder::new();
    for corners in [[(0, 0), (8, 0), (0, 8)], [(1, 1), (9, 1), (1, 9)]] {
        let ring = corners.map(|(x, y)| point(x, y)).to_vec();
        builder.shape(&Shape::Polygon(vec![ring])).unwrap();
    }
    let map = builder.build().unwrap();
    let line = QueryLine::Segment(point(0, 0), point(7, 6));
    assert_eq!(map.zone(&line), Err(map.not_plane().unwrap().into()));
}

#[test]
fn a_vertex_one_unit_in_the_last_place_beside_a_line_is_not_met() {
    // Rounded arithmetic would put it on the line.
    let beside = Point::new(0.5, 0.5 + f64::EPSILON / 2.0);
    let mut builder = Builder::new();
    builder.shape(&Shape::Point(beside)).expect("in range");
    builder.shape(&Shape::Point(Point::new(18.0, 18.0))).expect("in range");
    let map = builder.build().expect("fits");
    let line = QueryLine::Line(Point::new(12.0, 12.0), Point::new(24.0, 24.0));
    let met = map.zone(&line).expect("in range");
    let vertices = met.iter().filter_map(|met| match met {
        ZoneElement::Vertex(v) => map.position(*v).ok(),
        _ => None,
    });
    assert_eq!(vertices.collect::<Vec<_>>(), [Point::new(18.0, 18.0)]);
}
