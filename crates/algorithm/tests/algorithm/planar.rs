//! Random plane maps with holes that touch, dangling edges and isolated vertices; and maps of the world.

use quickcheck::{Arbitrary, Gen};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_layers::{ReadOptions, read_for_map};
use twinedge_map::{Builder, Noding, PlanarMap, Shape};

/// Points, segments and rings with coordinates from 0 to 12.
#[derive(Clone, Debug)]
pub(crate) struct Scribble(Vec<Shape>);

impl Arbitrary for Scribble {
    fn arbitrary(g: &mut Gen) -> Self {
        let count = u8::arbitrary(g) % 13;
        let mut point = || Point::new(f64::from(u8::arbitrary(g) % 13), f64::from(u8::arbitrary(g) % 13));
        let mut shapes = Vec::new();
        // A frame, so that most of it is in a bounded face.
        shapes.push(Shape::polygon([[0.0, 0.0], [12.0, 0.0], [12.0, 12.0], [0.0, 12.0]]));
        for kind in 0..=count {
            shapes.push(match kind % 4 {
                0 => Shape::polygon(vec![point(), point(), point()]),
                1 => Shape::Line(vec![point(), point()]),
                2 => Shape::Point(point()),
                _ => Shape::polygon((0..5).map(|_| point())),
            });
        }
        Self(shapes)
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        let shapes = self.0.clone();
        Box::new((0..shapes.len()).map(move |i| {
            let mut fewer = shapes.clone();
            fewer.remove(i);
            Self(fewer)
        }))
    }
}

/// The map of it, cut and rounded to whole numbers.
pub(crate) fn noded(Scribble(shapes): &Scribble) -> PlanarMap {
    let mut builder = Builder::new();
    for shape in shapes {
        builder.shape(shape).expect("small integers are in range");
    }
    builder.build_with(Noding::Snap(Snap::Size(1.0))).expect("it is in reach of the grid")
}

fn read(mut bytes: &[u8], noding: Noding) -> PlanarMap {
    let mut builder = Builder::new();
    for feature in read_for_map(&mut bytes, &ReadOptions::default()).expect("the file is GeoJSON").0 {
        builder.feature(&feature).expect("longitudes and latitudes are in range");
    }
    builder.build_with(noding).expect("the world fits")
}

/// The world, coarse; fine; and coarse with crossing edges, cut.
pub(crate) fn world_maps() -> impl Iterator<Item = PlanarMap> {
    let files: [(&[u8], Noding); 3] = [
        (include_bytes!("../../../cli/data/world-110m.geojson"), Noding::None),
        (include_bytes!("../../../../tests/data/world-50m.geojson"), Noding::None),
        (include_bytes!("../../../../tests/data/world-110m-crossing.geojson"), Noding::Snap(Snap::Auto)),
    ];
    files.into_iter().map(|(bytes, noding)| read(bytes, noding))
}
