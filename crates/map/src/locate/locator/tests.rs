//! The work of the search graph, counted in steps instead of seconds.

use super::*;
use crate::{Builder, Shape};
use twinedge_geometry::steps::steps_of;

type Segments = Vec<[[f64; 2]; 2]>;

fn map(segments: &[[[f64; 2]; 2]], isolated: &[[f64; 2]]) -> PlanarMap {
    let mut builder = Builder::new();
    for [from, to] in segments {
        builder.segment(*from, *to).unwrap();
    }
    for p in isolated {
        builder.shape(&Shape::Point(Point::from(*p))).unwrap();
    }
    builder.build().unwrap()
}

/// Builds the index, and locates every vertex and nearby points. Both must take O(n log n) in all, the index O(n) memory, and no
/// single search may take much more than the average.
fn check(name: &str, map: &PlanarMap) {
    // Steps are counted per thread, so one thread must do all.
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let (locator, building) = one.install(|| steps_of(|| Locator::new(map).unwrap()));
    let n = (map.dcel().vertex_count() + map.dcel().edge_count()) as f64;
    let questions = locator.graph.questions() as f64;
    let mut most = 0;
    for v in map.dcel().vertices() {
        let p = map.point(v.index());
        for q in [p, Point::new(p.x, p.y + 0.25), Point::new(p.x - 0.25, p.y)] {
            most = most.max(steps_of(|| locator.graph.find(locator.graph.root(), q)).1);
        }
    }
    let log = n.log2();
    let figures = [questions / n, building as f64 / (n * log), most as f64 / log];
    println!("{name}: {figures:.2?}");
    assert!(figures[0] <= 3.0 && figures[1] <= 8.0 && figures[2] <= 6.5, "{name}: {figures:?}");
}

#[test]
fn no_drawing_is_hard() {
    const N: i32 = 3000;
    let of = |segment: &dyn Fn(f64) -> [[f64; 2]; 2]| -> Segments { (0..N).map(|i| segment(i.into())).collect() };
    check("fan to the right", &map(&of(&|i| [[0.0, 0.0], [1.0, i]]), &[]));
    check("fan to the left", &map(&of(&|i| [[0.0, 0.0], [-1.0, i]]), &[]));
    check("slanted parallels", &map(&of(&|i| [[i, 0.0], [i + 1e6, 1e6]]), &[]));
    check("near parallels", &map(&of(&|i| [[0.0, i], [1e9, i + 0.5]]), &[]));
    check("upright parallels", &map(&of(&|i| [[i, 0.0], [i, 1e9]]), &[]));
    check("nested", &map(&of(&|i| [[-i, i], [i + 1.0, i]]), &[]));
    check("stairs", &map(&of(&|i| [[i, i], [i, i + 1e5]]), &[]));
    check("chain", &map(&of(&|i| [[i, i % 2.0], [i + 1.0, (i + 1.0) % 2.0]]), &[]));
    check("spiral", &{
        let at = |i: f64| [i * (i * 0.05).cos(), i * (i * 0.05).sin()];
        map(&of(&|i| [at(i), at(i + 1.0)]), &[])
    });
    let island = |i: f64| [3.0 * (i % 60.0), 3.0 * (i / 60.0).floor()];
    let islands: Segments = (0..N)
        .flat_map(|i| {
            let [x, y] = island(i.into());
            [[[x, y], [x + 1.0, y]], [[x + 1.0, y], [x, y + 1.0]], [[x, y + 1.0], [x, y]]]
        })
        .collect();
    check("islands", &map(&islands, &[]));
    let points: Vec<[f64; 2]> = (0..N).map(|i| island(i.into())).collect();
    check("isolated vertices", &map(&[], &points));
    let column: Vec<[f64; 2]> = (0..N).map(|i| [0.0, i.into()]).collect();
    check("isolated vertices on a line", &map(&[], &column));
}

#[test]
fn most_of_a_map_needs_no_question() {
    // A square of 64 by 64 in a sea of 1024 by 1024 that four islands span.
    let mut segments = Segments::new();
    for i in 0..64 {
        let i = f64::from(i);
        segments.extend([[[i, 0.0], [i + 1.0, 0.0]], [[i, 64.0], [i + 1.0, 64.0]]]);
        segments.extend([[[0.0, i], [0.0, i + 1.0]], [[64.0, i], [64.0, i + 1.0]]]);
    }
    let corners = [[-480.0, -480.0], [544.0, -480.0], [-480.0, 544.0], [544.0, 544.0]];
    let map = map(&segments, &corners);
    let locator = Locator::new(&map).unwrap();
    let mut asked = 0;
    for x in -480..544 {
        for y in -480..544 {
            let p = Point::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            asked += usize::from(steps_of(|| locator.locate(p)).1 > 0);
        }
    }
    assert!(asked < 1024 * 1024 / 8, "{asked}");
}
