//! Places, features and numbers for the tests.

use twinedge_geometry::Point;
use twinedge_map::{Feature, Shape};
use twinedge_sphere::Place;

pub(crate) fn feature(shape: Shape) -> Feature {
    Feature { shapes: vec![shape], ..Feature::default() }
}

pub(crate) fn at(longitude: f64, latitude: f64) -> Place {
    Place::new(longitude, latitude).expect("it is one")
}

/// Multiplies the longitudes and latitudes of features by 1 or -1.
pub(crate) fn mirrored(features: &[Feature], x: f64, y: f64) -> Vec<Feature> {
    let ring = |ring: &Vec<Point>| ring.iter().map(|p| Point::new(p.x * x, p.y * y)).collect();
    let shape = |shape: &Shape| match shape {
        Shape::Polygon(rings) => Shape::Polygon(rings.iter().map(ring).collect()),
        Shape::Line(line) => Shape::Line(ring(line)),
        Shape::Point(p) => Shape::Point(Point::new(p.x * x, p.y * y)),
    };
    let of = |one: &Feature| Feature { shapes: one.shapes.iter().map(shape).collect(), ..one.clone() };
    features.iter().map(of).collect()
}

/// Reproducible pseudorandom numbers (a linear congruential generator, with the constants of Knuth's MMIX).
pub(crate) struct Numbers(pub(crate) u64);

impl Numbers {
    pub(crate) fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % bound
    }

    pub(crate) fn fraction(&mut self) -> f64 {
        self.below(1 << 30) as f64 / f64::from(1 << 30)
    }
}
