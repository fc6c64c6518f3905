//! Maps that are edited between queries: every slot may have belonged to another record.

use crate::location::maps::{point, quickcheck};
use crate::support::edits::{EvenEdits, Place, SIDE};
use crate::support::oracle::{Plain, whole};
use twinedge_geometry::Point;
use twinedge_map::program::EditRunner;
use twinedge_map::{Located, PlanarMap, QueryLine};

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
    quickcheck(600, program as fn(EvenEdits, Vec<(Place, Place)>) -> bool);
}

#[test]
fn a_point_just_beside_an_edge_is_not_placed_by_records_that_lie_behind_it() {
    let mut map = PlanarMap::new();
    map.insert_ring([[0.0, 5.0], [5.0, 0.0], [3.0, 3.0]]).unwrap();
    // Its distance from (4.5, 4.5) is so small that the mirrored point does not lie across.
    map.insert_segment([0.0, 6.0], [6.000_000_000_000_001, 4.0]).unwrap();
    assert_eq!(map.locate(Point::new(4.5, 4.5)), Ok(Located::Face(map.dcel().unbounded_face().key())));
}
