//! Maps for queries.

use quickcheck::{Arbitrary, Gen, QuickCheck, Testable};
use twinedge_geometry::Point;
use twinedge_geometry::noding::{Snap, node};
use twinedge_layers::{ReadOptions, read_for_map};
use twinedge_map::{Builder, Feature, PlanarMap};

pub(crate) fn quickcheck(tests: u64, property: impl Testable) {
    QuickCheck::new().rng(Gen::from_size_and_seed(40, 1991)).tests(tests).quickcheck(property);
}

pub(crate) fn point(x: i32, y: i32) -> Point {
    Point::new(f64::from(x), f64::from(y))
}

/// Segments and points on a small grid, cut where they meet, and stretched: the vertices have coordinates from 0 to
/// [`Drawing::SIDE`] that are multiples of [`Drawing::STEP`].
#[derive(Clone, Debug)]
pub(crate) struct Drawing {
    segments: Vec<[(i32, i32); 2]>,
    points: Vec<(i32, i32)>,
}

impl Drawing {
    pub(crate) const STEP: i32 = 4;
    pub(crate) const SIDE: i32 = 7 * Self::STEP;

    /// A square with sides of 4.
    pub(crate) fn square() -> Self {
        let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
        Self { segments: (0..4).map(|i| [corners[i], corners[(i + 1) % 4]]).collect(), points: Vec::new() }
    }

    pub(crate) fn map(&self) -> PlanarMap {
        let at = |&(x, y): &(i32, i32)| point(x, y);
        let segments: Vec<[Point; 2]> = self.segments.iter().map(|ends| [at(&ends[0]), at(&ends[1])]).collect();
        let points: Vec<Point> = self.points.iter().map(at).collect();
        let noded = node(&segments, &points, Snap::Size(1.0)).expect("small numbers");
        let step = f64::from(Self::STEP);
        let points: Vec<Point> = noded.points.iter().map(|p| Point::new(p.x * step, p.y * step)).collect();
        build(&points, &noded.segments)
    }
}

impl Arbitrary for Drawing {
    fn arbitrary(g: &mut Gen) -> Self {
        fn number(g: &mut Gen, below: u32) -> i32 {
            (u32::arbitrary(g) % below).cast_signed()
        }
        // Few different coordinates lead to long lines of vertices.
        let (width, height) = (1 + number(g, 8), 1 + number(g, 8));
        let place = |g: &mut Gen| (number(g, width.unsigned_abs()), number(g, height.unsigned_abs()));
        let segments = (0..number(g, 14)).map(|_| [place(g), place(g)]).collect();
        let points = (0..number(g, 4)).map(|_| place(g)).collect();
        Self { segments, points }
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        let (segments, points) = (self.segments.clone(), self.points.clone());
        let fewer_points = self.points.shrink().map(move |points| Self { segments: segments.clone(), points });
        let all = self.segments.clone();
        let fewer_segments = (0..all.len()).map(move |i| {
            let mut segments = all.clone();
            segments.remove(i);
            Self { segments, points: points.clone() }
        });
        Box::new(fewer_segments.chain(fewer_points))
    }
}

/// The map of segments between points; other points are isolated.
pub(crate) fn build(points: &[Point], segments: &[[u32; 2]]) -> PlanarMap {
    let mut builder = Builder::new();
    for p in points {
        builder.shape(&twinedge_map::Shape::Point(*p)).expect("in range");
    }
    for ends in segments {
        let [from, to] = ends.map(|end| points[end as usize]);
        builder.segment(from, to).expect("in range");
    }
    builder.build().expect("fits")
}

pub(crate) fn features(mut file: &[u8]) -> Vec<Feature> {
    read_for_map(&mut file, &ReadOptions::default()).expect("the file is GeoJSON").0
}

pub(crate) fn world(file: &[u8]) -> PlanarMap {
    let mut builder = Builder::new();
    for feature in features(file) {
        builder.feature(&feature).expect("longitudes and latitudes are in range");
    }
    builder.build().expect("the world fits")
}

pub(crate) fn world_110m() -> PlanarMap {
    world(include_bytes!("../../../../cli/data/world-110m.geojson"))
}

/// Deterministic pseudo-random numbers.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((self.0 >> 33) as u32) / f64::from(1_u32 << 31)
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + self.unit() * (high - low)
    }

    pub(crate) fn index(&mut self, n: usize) -> usize {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small and positive")]
        let index = (self.unit() * n as f64) as usize;
        index.min(n - 1)
    }
}
