//! Tests of `bounds`.

use crate::Point;
use crate::bounds::Bounds;
use crate::predicates::{Orientation, compare_lexicographic, orientation};

#[test]
fn a_side_that_is_said_is_that_of_all_corners() {
    let coordinates = || (0..4).map(f64::from);
    let points: Vec<Point> = coordinates().flat_map(|x| coordinates().map(move |y| Point::new(x, y))).collect();
    let mut said = [0; 4];
    for (a, b) in points.iter().flat_map(|a| points.iter().map(move |b| (*a, *b))) {
        let Some(bounds) = Bounds::around([a, b]) else { unreachable!("there are two points") };
        let Bounds { low, high } = bounds;
        let corners = [low, high, Point::new(low.x, high.y), Point::new(high.x, low.y)];
        for p in &points {
            let sides = corners.map(|corner| compare_lexicographic(corner, *p));
            let all = [sides.iter().all(|side| side.is_gt()), sides.iter().all(|side| side.is_lt())];
            assert_eq!(bounds.after(*p).map(|after| [after, !after]), all.contains(&true).then_some(all));
            said[usize::from(all[0])] += usize::from(all.contains(&true));
        }
        let ends = points.iter().flat_map(|p| points.iter().map(move |q| [*p, *q]));
        for [p, q] in ends.filter(|[p, q]| compare_lexicographic(*p, *q).is_lt()) {
            let sides = corners.map(|corner| orientation(p, q, corner));
            let all = [Orientation::CounterClockwise, Orientation::Clockwise]
                .map(|side| sides.iter().all(|of_corner| *of_corner == side));
            assert_eq!(bounds.above([p, q]).map(|above| [above, !above]), all.contains(&true).then_some(all));
            said[2 + usize::from(all[0])] += usize::from(all.contains(&true));
        }
    }
    assert!(said.iter().all(|times| *times > 100), "{said:?}");
    assert!(Bounds::around([]).is_none());
}
