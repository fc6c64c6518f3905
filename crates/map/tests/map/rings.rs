//! The irregularities of rings, against definitions applied word by word.

use quickcheck::quickcheck;
use twinedge_geometry::Point;
use twinedge_map::{Builder, Irregularity, IrregularityKind, Shape};

type Corner = [i32; 2];

fn cross([a, b, c]: [Corner; 3]) -> i32 {
    (a[0] - b[0]) * (c[1] - b[1]) - (a[1] - b[1]) * (c[0] - b[0])
}

fn dot([a, b, c]: [Corner; 3]) -> i32 {
    (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1])
}

/// The irregularities of a ring: the positions of spikes, whether it visits a point twice apart from spikes, and whether it
/// turns clockwise at its lowest corner, if it has neither.
fn irregularities(ring: &[Corner]) -> (Vec<usize>, bool, bool) {
    let starts: Vec<usize> = (0..ring.len()).filter(|i| ring[*i] != ring[(i + 1) % ring.len()]).collect();
    let count = starts.len();
    if count < 3 {
        return (Vec::new(), false, false);
    }
    let around = |i: usize| [i + count - 1, i, i + 1].map(|i| ring[starts[i % count]]);
    let is_spike = |i: &usize| cross(around(*i)) == 0 && dot(around(*i)) > 0;
    let spikes: Vec<usize> = (1..count).chain([0]).filter(is_spike).map(|i| starts[i]).collect();

    let mut trimmed: Vec<Corner> = starts.iter().map(|start| ring[*start]).collect();
    while let Some(i) =
        (0..trimmed.len()).find(|i| trimmed[*i] == trimmed[(i + 2) % trimmed.len()] && trimmed.len() > 3)
    {
        trimmed.rotate_left(i);
        trimmed.drain(1..3);
    }
    let touches = (0..trimmed.len()).any(|i| trimmed[..i].contains(&trimmed[i]));

    let lowest = (0..count).min_by_key(|i| ring[starts[*i]]).expect("three corners");
    let is_clockwise = !touches && spikes.is_empty() && cross(around(lowest)) > 0;
    (spikes, touches, is_clockwise)
}

quickcheck! {
    /// The rings share points, and turn and cross wherever they like; some are open.
    fn rings_are_irregular_where_the_definitions_say(rings: Vec<Vec<(u8, u8)>>, side: u8) -> bool {
        let side = i32::from(side % 5) + 2;
        let mut builder = Builder::new();
        rings.iter().all(|ring| {
            let ring: Vec<Corner> = ring.iter().map(|(x, y)| [i32::from(*x) % side, i32::from(*y) % side]).collect();
            let points = ring.iter().map(|[x, y]| Point::new(f64::from(*x), f64::from(*y))).collect();
            let before = builder.summary().clone();
            let feature = builder.shape(&Shape::Polygon(vec![points])).expect("in range").index();
            let after = builder.summary();
            let is_spike = |one: &&Irregularity| one.kind == IrregularityKind::Spike && one.position.feature == feature;
            let listed: Vec<usize> =
                after.irregularities.iter().filter(is_spike).map(|one| one.position.point).collect();
            let (spikes, touches, is_clockwise) = irregularities(&ring);
            let is_simple = spikes.is_empty() && !touches;
            after.spikes == before.spikes + spikes.len()
                && spikes.starts_with(&listed)
                && after.self_touching_rings == before.self_touching_rings + usize::from(touches)
                && (!is_simple || after.rings_wound_wrongly == before.rings_wound_wrongly + usize::from(is_clockwise))
        })
    }
}
