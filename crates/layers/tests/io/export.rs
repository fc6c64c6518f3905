//! Maps written and read again, through every format.

use crate::read_geojson;
use quickcheck::{Gen, QuickCheck};
use std::collections::BTreeSet;
use std::io::{self, Write};
use twinedge_algorithm::contour::{of_feature, of_features};
use twinedge_geometry::Point;
use twinedge_layers::io::{WriteError, geojson, wkt};
use twinedge_layers::{Format, read_for_map};
use twinedge_map::{Builder, Feature, PlanarMap, Shape};

fn built(features: &[Feature]) -> PlanarMap {
    let mut builder = Builder::new();
    for feature in features {
        builder.feature(feature).expect("in range");
    }
    builder.build().expect("fits")
}

fn from_wkt(text: &[u8]) -> Vec<Feature> {
    read_for_map(&mut { text }, &crate::options(Format::Wkt)).expect("it is WKT").0
}

fn through_geojson(features: &[Feature]) -> Vec<Feature> {
    let mut text = Vec::new();
    geojson::write(&mut text, features).expect("finite");
    read_geojson(&text).expect("it is GeoJSON").0
}

fn through_wkt(features: &[Feature]) -> Vec<Feature> {
    let mut text = Vec::new();
    wkt::write(&mut text, features).expect("finite");
    from_wkt(&text)
}

fn through_geo_types(features: &[Feature]) -> Vec<Feature> {
    let there = |feature: &Feature| geo_types::Geometry::GeometryCollection(feature.into());
    features.iter().map(|feature| Feature::from(&there(feature))).collect()
}

type Bits = (u64, u64);

/// A half-edge: its ends, and the features to its left.
type Side = (Bits, Bits, Vec<usize>);

/// The drawing of a map: the half-edges with the features to their left, and the numbers of faces and components.
/// Isolated vertices are left out.
fn drawn(map: &PlanarMap) -> (BTreeSet<Side>, usize, usize) {
    let bits = |p: Point| (p.x.to_bits(), p.y.to_bits());
    let at = |v: twinedge::dcel::Vertex<'_>| bits(map.position(v.key()).expect("live"));
    let half_edges = map.dcel().half_edges().map(|h| {
        let left = map.features_of(h.face().key()).expect("live").map(|f| f.index()).collect();
        (at(h.origin()), at(h.target()), left)
    });
    let connected = map.dcel().vertices().filter(|v| v.leaving().is_some()).count();
    (half_edges.collect(), connected, map.dcel().face_count())
}

fn world() -> Vec<Feature> {
    read_geojson(include_bytes!("../../../cli/data/world-110m.geojson")).expect("it is GeoJSON").0
}

#[test]
fn the_contours_of_all_countries_make_the_same_world_again() {
    let map = built(&world());
    let contours = of_features(&map).expect("the world is plane");
    let mut features: Vec<Feature> = contours.iter().cloned().map(Feature::from).collect();
    for (feature, id) in features.iter_mut().zip(map.features()) {
        feature.name = map.name(id).map(str::to_owned);
    }
    let expected = drawn(&map);
    assert_eq!((expected.1, expected.2), (7_493, 288));
    assert_eq!(drawn(&built(&features)), expected);
    let read = through_geojson(&features);
    assert_eq!(read, features);
    assert_eq!(drawn(&built(&read)), expected);
    assert_eq!(drawn(&built(&through_wkt(&features))), expected);
    assert_eq!(drawn(&built(&through_geo_types(&features))), expected);
    let polygons: Vec<Feature> = contours
        .iter()
        .map(|contour| Feature::from(&geo_types::Geometry::MultiPolygon(geo_types::MultiPolygon::from(contour))))
        .collect();
    assert_eq!(drawn(&built(&polygons)), expected);
}

/// A feature of polygons, lines and points on a small grid, which may cross, overlap and turn back.
fn feature(shapes: &[(u8, Vec<(u8, u8)>)]) -> Feature {
    let shape = |(kind, points): &(u8, Vec<(u8, u8)>)| {
        let points: Vec<Point> =
            points.iter().take(8).map(|(x, y)| Point::new((x % 4).into(), (y % 4).into())).collect();
        match (kind % 3, &points[..]) {
            (0, [first, ..]) => Some(Shape::Point(*first)),
            (1, [_, ..]) => Some(Shape::Line(points)),
            (2, [_, ..]) => Some(Shape::Polygon(vec![points])),
            _ => None,
        }
    };
    Feature { shapes: shapes.iter().take(4).filter_map(shape).collect(), ..Feature::default() }
}

type Shapes = Vec<(u8, Vec<(u8, u8)>)>;

fn closed(mut features: Vec<Feature>) -> Vec<Feature> {
    for shape in features.iter_mut().flat_map(|feature| &mut feature.shapes) {
        if let Shape::Polygon(rings) = shape {
            for ring in rings.iter_mut().filter(|ring| ring.first() != ring.last()) {
                ring.extend(ring.first().copied());
            }
        }
    }
    features
}

fn shapes_come_back_as_they_were(shapes: Vec<Shapes>, exponents: Vec<i16>) -> bool {
    let mut features: Vec<Feature> = shapes.iter().take(5).map(|shapes| feature(shapes)).collect();
    // Numbers of all sizes, mostly with many digits.
    let mut scale = exponents.iter().cycle().map(|e| 10_f64.powi(i32::from(*e % 300)) / 3.0);
    for shape in features.iter_mut().flat_map(|feature| &mut feature.shapes) {
        let points = match shape {
            Shape::Polygon(rings) => &mut rings[0],
            Shape::Line(points) => points,
            Shape::Point(p) => core::slice::from_mut(p),
        };
        for p in points {
            p.x *= scale.next().unwrap_or(1.0);
        }
    }
    through_geojson(&features) == features
        && through_wkt(&features) == features
        && through_geo_types(&features) == closed(features)
}

#[test]
fn any_shapes_come_back_as_they_were() {
    QuickCheck::new()
        .rng(Gen::new(9))
        .tests(300)
        .quickcheck(shapes_come_back_as_they_were as fn(Vec<Shapes>, Vec<i16>) -> bool);
}

#[test]
fn geometries_are_written_as_what_they_are() {
    let p = |x: f64| Point::new(x, 0.5);
    let ring = vec![p(0.0), p(1.0), Point::new(0.0, 1e-7), p(0.0)];
    let (point, line, polygon) = (Shape::Point(p(1.0)), Shape::Line(vec![p(0.0), p(1.0)]), Shape::Polygon(vec![ring]));
    let nothing = [Shape::Line(vec![]), Shape::Polygon(vec![]), Shape::Polygon(vec![vec![]])];
    for (shapes, expected) in [
        (vec![point.clone()], "POINT(1 0.5)"),
        (vec![point.clone(), point.clone()], "MULTIPOINT((1 0.5),(1 0.5))"),
        (vec![line.clone()], "LINESTRING(0 0.5,1 0.5)"),
        (vec![line.clone(), line.clone()], "MULTILINESTRING((0 0.5,1 0.5),(0 0.5,1 0.5))"),
        (vec![polygon.clone()], "POLYGON((0 0.5,1 0.5,0 0.0000001,0 0.5))"),
        (
            vec![polygon.clone(), polygon.clone()],
            "MULTIPOLYGON(((0 0.5,1 0.5,0 0.0000001,0 0.5)),((0 0.5,1 0.5,0 0.0000001,0 0.5)))",
        ),
        (vec![line, point], "GEOMETRYCOLLECTION(LINESTRING(0 0.5,1 0.5),POINT(1 0.5))"),
        (nothing.to_vec(), "GEOMETRYCOLLECTION EMPTY"),
    ] {
        let feature = Feature { shapes, ..Feature::default() };
        let mut text = Vec::new();
        wkt::write(&mut text, core::slice::from_ref(&feature)).expect("finite");
        assert_eq!(String::from_utf8(text).expect("UTF-8"), format!("{expected}\n"));
    }
    let feature = Feature { name: Some("A \"b\"".into()), id: Some("7".into()), shapes: nothing.to_vec() };
    let mut text = Vec::new();
    geojson::write(&mut text, &[feature]).expect("finite");
    let value: serde_json::Value = serde_json::from_slice(&text).expect("JSON");
    let expected = serde_json::json!({"type": "FeatureCollection", "features": [
        {"type": "Feature", "id": "7", "properties": {"name": "A \"b\""}, "geometry": null}]});
    assert_eq!(value, expected);
}

#[test]
fn what_geo_types_has_beside_is_taken_too() {
    use geo_types::{Geometry, GeometryCollection, Line, Rect, Triangle, coord};
    let (a, b, c) = (coord! { x: 0.0, y: 0.0 }, coord! { x: 2.0, y: 0.0 }, coord! { x: 2.0, y: 1.0 });
    let inner = GeometryCollection(vec![Line::new(a, b).into(), Geometry::Point(c.into())]);
    let all = GeometryCollection(vec![
        Geometry::GeometryCollection(inner),
        Rect::new(a, c).into(),
        Triangle::new(a, b, c).into(),
    ]);
    let shapes = Feature::from(&Geometry::GeometryCollection(all)).shapes;
    assert_eq!(shapes[..2], [Shape::Line(vec![a.into(), b.into()]), Shape::Point(c.into())]);
    let areas: Vec<f64> = shapes[2..]
        .iter()
        .map(|shape| {
            let map = built(&[Feature { shapes: vec![shape.clone()], ..Feature::default() }]);
            of_feature(&map, map.features().next().expect("one")).expect("plane").area()
        })
        .collect();
    assert_eq!(areas, [2.0, 1.0]);
}

/// A writer that takes some bytes and then fails.
struct Full(usize);

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let taken = bytes.len().min(self.0);
        self.0 -= taken;
        if taken == 0 { Err(io::Error::new(io::ErrorKind::StorageFull, "no room")) } else { Ok(taken) }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn what_cannot_be_written_is_an_error() {
    let good =
        Feature { shapes: vec![Shape::Line(vec![Point::new(0.0, 0.0), Point::new(1.0, 1.0)])], ..Feature::default() };
    for (x, y) in [(f64::NAN, 1.0), (1.0, f64::NEG_INFINITY)] {
        let bad = Feature { shapes: vec![Shape::Point(Point::new(x, y))], ..Feature::default() };
        let features = [good.clone(), bad];
        let mut text = Vec::new();
        for outcome in [geojson::write(&mut text, &features), wkt::write(&mut text, &features)] {
            let Err(WriteError::NotFinite { feature: 1, x: a, y: b }) = outcome else { panic!("{outcome:?}") };
            assert_eq!((a.to_bits(), b.to_bits()), (x.to_bits(), y.to_bits()));
        }
        assert!(text.is_empty());
    }
    for room in [0, 10, 60] {
        let features = [good.clone(), good.clone()];
        for outcome in [geojson::write(Full(room), &features), wkt::write(Full(room / 2), &features)] {
            let Err(WriteError::Io(error)) = outcome else { panic!("{outcome:?}") };
            assert_eq!(error.kind(), io::ErrorKind::StorageFull);
        }
    }
}
