//! Values that follow edits, are undone with them, and are as they were where an edit is refused halfway.

use crate::rewound::change;
use crate::support::tokens::{Handles, Mints};
use quickcheck::{Gen, QuickCheck, Testable};
use std::panic::{AssertUnwindSafe, catch_unwind};
use twinedge::algorithm::area::face_area;
use twinedge::dcel::{HalfEdge, HalfEdgeKey, OperatorError, Policy};
use twinedge::geometry::Point;
use twinedge::map::edit::EditError;
use twinedge::map::program::{EditOutcome, EditProgram, EditRunner};
use twinedge::map::{Audited, History, Located, PlanarMap};

fn check(tests: u64, size: usize, law: impl Testable) {
    QuickCheck::new().rng(Gen::from_size_and_seed(size, 2026)).tests(tests).quickcheck(law);
}

#[test]
fn no_token_is_lost_or_doubled_by_any_edit_undone_or_not() {
    fn law(program: EditProgram) {
        let (mints, mut map) = (Mints::default(), PlanarMap::new());
        let handles = Handles::of_map(&mut map, &mints, 0);
        let mut history = History::new(map);
        let mut states = vec![handles.values(history.get().dcel())];
        for op in &program.0 {
            let before = history.mark();
            change(&mut history, op);
            handles.check(history.get().dcel(), &mints);
            if history.mark() != before {
                states.push(handles.values(history.get().dcel()));
            }
        }
        while history.undo() {
            let after = states.pop().unwrap();
            assert_ne!(history.redo_name(), None);
            assert!(history.redo());
            assert_eq!(handles.values(history.get().dcel()), after);
            assert!(history.undo());
            assert_eq!(Some(&handles.values(history.get().dcel())), states.last());
        }
        assert_eq!(states.len(), 1);
    }
    check(60, 40, law as fn(EditProgram));
}

#[test]
fn an_edit_that_is_refused_halfway_leaves_everything_as_it_was() {
    fn run(program: &EditProgram) -> usize {
        let (mints, mut map) = (Mints::default(), PlanarMap::new());
        let handles = Handles::of_map(&mut map, &mints, 13);
        let _ = map.locate(Point::new(0.5, 0.5));
        let mut audited = Audited::new(map).unwrap();
        let mut refused = 0;
        for op in &program.0 {
            let before = audited.map().clone();
            let outcome = audited.change(|map| {
                let mut runner = EditRunner::new(std::mem::take(map));
                let outcome = runner.step(op);
                *map = runner.into_map();
                outcome
            });
            let map = audited.map();
            if matches!(outcome, Ok(EditOutcome::Refused(EditError::Operator(OperatorError::Refused(_))))) {
                assert!(*map == before, "{op}");
                assert_eq!(handles.values(map.dcel()), handles.values(before.dcel()));
                refused += 1;
            }
            let p = Point::new(0.75, 0.5);
            let walked = map.locate_from(p, map.dcel().unbounded_face().key());
            let place = |located: Located| Some(located).filter(|located| !matches!(located, Located::Edge(_)));
            assert_eq!(map.locate(p).map(place), walked.map(place));
            assert!(outcome.is_ok());
        }
        refused
    }
    let mut programs = Gen::from_size_and_seed(50, 2026);
    let refused: usize = (0..60).map(|_| run(&quickcheck::Arbitrary::arbitrary(&mut programs))).sum();
    assert!(refused > 100, "{refused}");
}

/// A square of four cells, whose middle vertex and whose edges from there are named, and its owners.
fn four_cells() -> (PlanarMap, twinedge::dcel::Attribute<twinedge::dcel::Faces, u32>, Vec<HalfEdgeKey>) {
    let mut map = PlanarMap::new();
    let owner = map.add_attribute(Policy::of_faces().split_copy().merge_equal());
    map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]).unwrap();
    let middle = map.insert_point([2.0, 2.0]).unwrap().vertices[0];
    let spokes: Vec<HalfEdgeKey> = [[2.0, 0.0], [4.0, 2.0], [2.0, 4.0], [0.0, 2.0]]
        .map(|end| map.insert_segment(middle, end).unwrap().way[0])
        .into();
    for h in &spokes {
        let face = map.dcel().half_edge(*h).unwrap().face().key();
        map.set_value(owner, face, 1).unwrap();
    }
    (map, owner, spokes)
}

#[test]
fn a_refused_edit_inside_of_a_change_leaves_the_rest_of_the_change() {
    let (mut map, owner, spokes) = four_cells();
    let sides =
        [map.dcel().half_edge(spokes[0]).unwrap().face().key(), map.dcel().half_edge(spokes[2]).unwrap().face().key()];
    let middle = map.dcel().half_edge(spokes[0]).unwrap().origin().key();
    // The last of the edges that are erased would merge two owners.
    map.set_value(owner, sides[1], 2).unwrap();
    let original = map.clone();
    let mut history = History::new(map);
    let seen = history.change("several", |map| {
        map.insert_point([1.0, 1.0])?;
        map.set_value(owner, sides[0], 3)?;
        map.set_value(owner, sides[0], 1)?;
        let (before, values) = (map.clone(), map.values(owner).cloned());
        assert!(matches!(map.remove_vertex(middle), Err(EditError::Operator(OperatorError::Refused(_)))));
        assert!(*map == before);
        let same = map.values(owner).unwrap().iter().eq(values.as_ref().unwrap().iter());
        map.insert_point([3.0, 3.0])?;
        Ok::<_, EditError>(same)
    });
    assert_eq!(seen, Ok(true));
    assert_eq!(history.get().dcel().vertex_count(), original.dcel().vertex_count() + 2);
    assert!(history.get().validate().is_valid());
    assert!(history.undo());
    assert!(*history.get() == original);
    assert_eq!(history.get().value(owner, sides[1]), Some(&2));
    assert!(history.redo());
    // Once all are of one owner, the vertex goes.
    history.change("sell", |map| map.set_value(owner, sides[1], 1)).unwrap();
    let removed = history.change("erase", |map| map.remove_vertex(middle)).unwrap();
    assert_eq!((removed.faces_merged.len(), history.get().values(owner).unwrap().len()), (3, 1));
}

#[test]
fn a_policy_that_panics_leaves_the_history_usable() {
    let (mut map, _, spokes) = four_cells();
    let strict = map.add_attribute(Policy::of_faces().merge_with(|_: Option<u8>, _| panic!("a fault")));
    let before = map.clone();
    let mut history = History::new(map);
    let outcome = catch_unwind(AssertUnwindSafe(|| history.change("erase", |map| map.remove_edge(spokes[0]))));
    assert!(outcome.is_err());
    assert!(*history.get() == before);
    assert!(history.get().values(strict).unwrap().is_empty());
    history.change("draw", |map| map.insert_point([1.0, 1.0])).unwrap();
    assert!(history.undo() && *history.get() == before);
}

#[test]
fn shares_are_areas_and_lengths_and_vertices_on_edges_lie_between() {
    fn law(points: Vec<(u8, u8)>, erased: Vec<u8>) {
        let mut map = PlanarMap::new();
        let area = map.add_attribute::<_, f64>(Policy::of_faces().split_share().merge_sum());
        let length = map.add_attribute::<_, f64>(Policy::of_edges().split_share().merge_sum());
        let side = map.add_attribute::<_, f64>(Policy::of_half_edges().split_share());
        let height = map.add_attribute::<_, f64>(Policy::of_vertices().interpolate());
        let square = map.insert_ring([[0.0, 0.0], [16.0, 0.0], [16.0, 16.0], [0.0, 16.0]]).unwrap();
        map.set_value(area, square.faces_split[0].1, 256.0).unwrap();
        let at = |(x, y): (u8, u8)| [f64::from(x % 17), f64::from(y % 17)];
        let mut points = points.into_iter();
        let mut erased = erased.into_iter();
        loop {
            // New records, other than parts of those that were there, get their values.
            let measure = |map: &PlanarMap, h: HalfEdgeKey| {
                let h = map.dcel().half_edge(h).unwrap();
                let [a, b] = [h.origin(), h.target()].map(|v| map.position(v.key()).unwrap());
                (a.x - b.x).hypot(a.y - b.y)
            };
            let linear = |Point { x, y }: Point| 3.0 * x - y;
            let vertices: Vec<_> = map.dcel().vertices().map(|v| v.key()).collect();
            for v in vertices {
                let exact = linear(map.position(v).unwrap());
                match map.value(height, v) {
                    Some(found) => assert!((found - exact).abs() < 1e-9, "{found} is not {exact}"),
                    None => assert_eq!(map.set_value(height, v, exact), Ok(None)),
                }
            }
            let half_edges: Vec<_> = map.dcel().half_edges().map(|h| h.key()).collect();
            for h in half_edges {
                let exact = measure(&map, h);
                for found in [map.value(length, h), map.value(side, h)] {
                    assert!(found.is_none_or(|found| (found - exact).abs() < 1e-9));
                }
                map.set_value(length, h, exact).unwrap();
                map.set_value(side, h, exact).unwrap();
            }
            for f in map.dcel().faces().filter(|f| !f.is_unbounded()) {
                let (found, exact) = (map.value(area, f.key()).unwrap(), face_area(&map, f.key()).unwrap());
                assert!((found - exact).abs() < 1e-9, "{found} is not {exact}");
            }
            let (Some(from), Some(to)) = (points.next(), points.next()) else { return };
            let _ = map.insert_segment(at(from), at(to));
            let inside = |h: &HalfEdge<'_>| !h.face().is_unbounded() && !h.twin().face().is_unbounded();
            let inner: Vec<_> = map.dcel().edges().filter(inside).map(|h| h.key()).collect();
            if let (Some(which), false) = (erased.next().filter(|which| which % 3 == 0), inner.is_empty()) {
                let h = inner[usize::from(which) % inner.len()];
                map.remove_edge(h).unwrap();
            }
        }
    }
    check(60, 60, law as fn(Vec<(u8, u8)>, Vec<u8>));
}

#[test]
fn of_merged_faces_the_larger_one_may_name_both() {
    for x in [1.0, 3.0] {
        for turned in [false, true] {
            let mut map = PlanarMap::new();
            let name = map.add_attribute(Policy::of_faces().merge_larger());
            map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 1.0]]).unwrap();
            let fence = map.insert_segment([x, 0.0], [x, 1.0]).unwrap().way[0];
            let h = map.dcel().half_edge(fence).unwrap();
            let [west, east] = [h.face().key(), h.twin().face().key()];
            let erased = if turned { h.twin().key() } else { h.key() };
            map.set_value(name, west, "west").unwrap();
            map.set_value(name, east, "east").unwrap();
            let kept = map.remove_edge(erased).unwrap().faces_merged[0].0;
            assert_eq!(map.value(name, kept), Some(if x < 2.0 { &"east" } else { &"west" }));
        }
    }
}
