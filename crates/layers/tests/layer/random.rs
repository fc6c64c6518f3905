//! Laws of random layers.

use crate::support::through;
use quickcheck::{Arbitrary, Gen, quickcheck};
use twinedge_layers::{Dimensions, Feature, Format, Geometry, Layer, Position, Shape, Value};

#[derive(Clone, Debug)]
struct RandomLayer(Layer);

fn line(g: &mut Gen, more: usize) -> Vec<Position> {
    let count = usize::arbitrary(g) % 5;
    (0..count).map(|_| position(g, more)).collect()
}

fn position(g: &mut Gen, more: usize) -> Position {
    let mut number = || loop {
        let number = f64::arbitrary(g);
        if number.is_finite() {
            return number;
        }
    };
    Position { x: number(), y: number(), more: (0..more).map(|_| number()).collect() }
}

fn geometry(g: &mut Gen, dimensions: Dimensions, depth: usize) -> Geometry {
    let more = dimensions.more();
    let lines = |g: &mut Gen| (0..usize::arbitrary(g) % 3).map(|_| line(g, more)).collect::<Vec<_>>();
    let ring = |mut ring: Vec<Position>| {
        ring.extend(ring.first().cloned());
        ring
    };
    let rings = |g: &mut Gen| lines(g).into_iter().map(ring).collect::<Vec<_>>();
    let shape = match u8::arbitrary(g) % if depth < 2 { 7 } else { 6 } {
        0 => Shape::Point(bool::arbitrary(g).then(|| position(g, more))),
        1 => Shape::MultiPoint(line(g, more).into_iter().map(|one| bool::arbitrary(g).then_some(one)).collect()),
        2 => Shape::Line(line(g, more)),
        3 => Shape::MultiLine(lines(g)),
        4 => Shape::Polygon(rings(g)),
        5 => Shape::MultiPolygon((0..usize::arbitrary(g) % 3).map(|_| rings(g)).collect()),
        _ => Shape::Collection((0..usize::arbitrary(g) % 3).map(|_| geometry(g, dimensions, depth + 1)).collect()),
    };
    Geometry::new(dimensions, shape)
}

fn value(g: &mut Gen) -> Value {
    match u8::arbitrary(g) % 5 {
        0 => Value::Null,
        1 => Value::Integer(i64::arbitrary(g)),
        2 => Value::Real(f64::arbitrary(g)),
        3 => Value::Text(String::arbitrary(g)),
        _ => Value::Bool(bool::arbitrary(g)),
    }
}

impl Arbitrary for RandomLayer {
    fn arbitrary(g: &mut Gen) -> Self {
        let dimensions = [Dimensions::Xy, Dimensions::Xyz, Dimensions::Xym, Dimensions::Xyzm];
        let features = (0..usize::arbitrary(g) % 4).map(|_| {
            let dimensions = *g.choose(&dimensions).unwrap_or(&Dimensions::Xy);
            Feature {
                geometry: Some(geometry(g, dimensions, 0)),
                attributes: vec![("a".into(), value(g))],
                ..Feature::default()
            }
        });
        Self(Layer { features: features.collect(), ..Layer::default() })
    }
}

quickcheck! {
    fn binary_geometries_come_back(layer: RandomLayer) -> bool {
        let again = through(&layer.0, Format::Wkb);
        layer.0.features.iter().map(|f| &f.geometry).eq(again.features.iter().map(|f| &f.geometry))
    }

    fn attributes_of_geojson_come_back(layer: RandomLayer) -> bool {
        let mut layer = layer.0;
        for feature in &mut layer.features {
            feature.geometry = None;
            if matches!(feature.attributes[0].1, Value::Real(number) if !number.is_finite()) {
                feature.attributes[0].1 = Value::Null;
            }
        }
        through(&layer, Format::GeoJson).features == layer.features
    }
}
