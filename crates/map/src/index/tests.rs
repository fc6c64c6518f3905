//! The index after random edits, compared with a freshly built one and with scans of the whole map.

#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

use super::{BoxedRecord, RecordIndex, is_hub};
use crate::locate::in_face::locate_in_face;
use crate::program::{EditOutcome, EditProgram, EditRunner};
use crate::{Embedding, Located, PlanarMap};
use quickcheck::{QuickCheck, TestResult};
use twinedge::dcel::History;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Meeting, meeting};

fn records(index: &RecordIndex) -> Vec<BoxedRecord> {
    let mut records: Vec<BoxedRecord> = index.trees([None; 2]).flat_map(|tree| tree.iter()).copied().collect();
    records.sort_by_key(|record| record.record);
    records
}

fn rotations(index: &RecordIndex) -> Vec<(u32, Vec<u32>)> {
    let mut all: Vec<_> = index.hubs.iter().map(|(vertex, hub)| (*vertex, hub.rotation())).collect();
    all.sort_unstable();
    all
}

/// Returns a location with an edge named by the half-edge with the smaller index.
fn either_half(map: &PlanarMap, found: Option<Located>) -> Option<Located> {
    let smaller = |key| {
        let h = map.dcel().half_edge(key).expect("of this map");
        if h.index() < h.twin().index() { h.key() } else { h.twin().key() }
    };
    found.map(|located| if let Located::Edge(h) = located { Located::Edge(smaller(h)) } else { located })
}

fn check(map: &PlanarMap) -> Result<(), String> {
    let fresh = RecordIndex::new(map.dcel(), &map.points);
    if records(map.index()) != records(&fresh) {
        return Err(format!("kept {:?}, anew {:?}", records(map.index()), records(&fresh)));
    }
    // A hub remains one until many of its half-edges are gone.
    let hubs = rotations(map.index());
    if let Some(hub) = rotations(&fresh).into_iter().find(|hub| !hubs.contains(hub)) {
        return Err(format!("hub {hub:?} is not in {hubs:?}"));
    }
    for (vertex, fan) in hubs {
        let v = map.dcel().vertex_at(vertex as usize).ok_or("a fan of no vertex")?;
        let mut leaving: Vec<usize> = v.rotation().map(|h| h.index()).collect();
        // Both orders are counter-clockwise; the fan begins at the axis.
        let first = leaving.iter().position(|h| Some(*h as u32) == fan.first().copied()).ok_or("another first")?;
        leaving.rotate_left(first);
        if !leaving.iter().map(|h| *h as u32).eq(fan.iter().copied()) {
            return Err(format!("vertex {vertex}: {leaving:?} leave, but the fan has {fan:?}"));
        }
    }
    for i in 0..16 {
        let p = Point::new(f64::from(i % 4) * 1.5, f64::from(i / 4) * 1.5);
        let (found, scanned) = (map.locate(p), map.dcel().faces().find_map(|face| locate_in_face(map, face, p)));
        if either_half(map, found.ok()) != either_half(map, scanned) {
            return Err(format!("at {p:?}: {found:?}, by scans of the faces {scanned:?}"));
        }
    }
    Ok(())
}

fn edits_keep_the_index(program: EditProgram) -> TestResult {
    let mut runner = EditRunner::new(PlanarMap::new());
    runner.map().index();
    for (number, op) in program.0.iter().enumerate() {
        let outcome = runner.step(op);
        if let (EditOutcome::Applied(_), Err(what)) = (outcome, check(runner.map())) {
            return TestResult::error(format!("after edit {} (`{op}`): {what}", number + 1));
        }
    }
    TestResult::passed()
}

#[test]
fn edits_keep_the_index_as_it_would_be_built_anew() {
    QuickCheck::new().tests(300).quickcheck(edits_keep_the_index as fn(EditProgram) -> TestResult);
}

/// Undoes each edit, redoes every other one, and sometimes undoes several.
fn a_history_keeps_the_index(program: EditProgram) -> TestResult {
    let mut history = History::new(PlanarMap::new());
    history.get().index();
    for (number, op) in program.0.iter().enumerate() {
        let edited = history.change("edit", |map| {
            let mut runner = EditRunner::new(std::mem::take(map));
            let outcome = runner.step(op);
            *map = runner.into_map();
            if matches!(outcome, EditOutcome::Applied(_)) && number % 7 != 0 { Ok(()) } else { Err(()) }
        });
        let far = if edited.is_ok() { 1 + number % 5 } else { 1 };
        for step in 0..2 * far - number % 2 {
            if let Err(what) = check(history.get()) {
                return TestResult::error(format!("{step} steps after edit {} (`{op}`): {what}", number + 1));
            }
            let _ = if step < far { history.undo() } else { history.redo() };
        }
        if let Err(what) = check(history.get()) {
            return TestResult::error(format!("after edit {} (`{op}`): {what}", number + 1));
        }
    }
    TestResult::passed()
}

#[test]
fn a_history_keeps_the_index_as_it_would_be_built_anew() {
    QuickCheck::new().tests(200).quickcheck(a_history_keeps_the_index as fn(EditProgram) -> TestResult);
}

/// Runs the same edits on a map with an index from the start and on a map that builds it on demand.
fn an_index_changes_no_outcome(program: EditProgram) -> bool {
    // Clones, so that their keys are the same.
    let map = PlanarMap::new();
    let mut early = EditRunner::new(map.clone());
    early.map().index();
    let mut late = EditRunner::new(map);
    program.0.iter().all(|op| {
        // Compared as text, since errors may contain NaN coordinates.
        let outcomes = [early.step(op), late.step(op)].map(|outcome| format!("{outcome:?}"));
        outcomes[0] == outcomes[1] && early.map() == late.map()
    })
}

#[test]
fn whether_there_is_an_index_changes_no_outcome() {
    QuickCheck::new().tests(300).quickcheck(an_index_changes_no_outcome as fn(EditProgram) -> bool);
}

#[test]
fn a_star_that_is_drawn_moved_and_erased_has_a_fan_meanwhile() {
    const SPOKES: u32 = 40;
    let mut map = PlanarMap::new();
    let hub = map.insert_point([0.0, 0.0]).unwrap().vertices[0];
    let head = |i: u32| [f64::from(i) - 20.0, if i.is_multiple_of(2) { 50.0 } else { -50.0 }];
    for i in 0..SPOKES {
        map.insert_segment(hub, head(i)).unwrap();
        check(&map).unwrap();
        assert_eq!(rotations(map.index()).len(), usize::from(is_hub(map.dcel().vertex(hub).unwrap())));
    }
    map.move_vertex(hub, [0.5, 0.5]).unwrap();
    check(&map).unwrap();
    let mut history = History::new(map);
    history.change("move it with its spokes", |map| map.move_vertex(hub, [0.25, 0.5])).unwrap();
    history.change("erase it with its spokes", |map| map.remove_vertex(hub)).unwrap();
    for step in [History::undo, History::undo, History::redo, History::redo, History::undo, History::undo] {
        assert!(step(&mut history));
        check(history.get()).unwrap();
    }
    let mut map = history.into_inner();
    let spokes: Vec<_> = map.dcel().vertex(hub).unwrap().rotation().map(|h| h.key()).collect();
    for h in spokes {
        map.remove_edge(h).unwrap();
        check(&map).unwrap();
    }
    assert_eq!(rotations(map.index()), []);
}

#[test]
fn a_way_to_a_hub_is_found_whatever_is_on_it() {
    let mut map = PlanarMap::new();
    let hub = map.insert_point([0.0, 0.0]).unwrap().vertices[0];
    for i in 0..12_u32 {
        map.insert_segment(hub, [f64::from(i) - 6.0, -4.0]).unwrap();
    }
    // Along an existing spoke and beyond its end.
    let along = map.insert_segment([0.0, -6.0], hub).unwrap();
    assert_eq!((along.way.len(), along.edges_made.len()), (2, 1));
    // Past a vertex, and across the base of a triangle.
    map.insert_point([0.0, 3.0]).unwrap();
    let past = map.insert_segment([0.0, 5.0], hub).unwrap();
    assert_eq!((past.way.len(), past.edges_made.len()), (2, 2));
    map.insert_segment([2.0, 1.0], [2.0, 3.0]).unwrap();
    assert!(map.insert_segment([4.0, 4.0], hub).is_err());
    assert!(map.insert_segment(hub, [4.0, 4.0]).is_err());
    check(&map).unwrap();
    assert!(map.validate().is_valid());
}

#[test]
fn the_first_of_the_edges_that_are_crossed_is_named() {
    let mut map = PlanarMap::new();
    for x in 1..40_u32 {
        // In an order other than along the way.
        let x = f64::from(x * 7 % 40);
        map.insert_segment([x, -1.0], [x, 1.0]).unwrap();
    }
    for (from, first) in [([0.25, 0.0], 1.0), ([17.25, 0.0], 18.0), ([41.0, 0.0], 39.0)] {
        let to = if first < 39.0 { [41.0, 0.5] } else { [0.5, 0.5] };
        let Err(crate::edit::EditError::Crosses(h)) = map.insert_segment(from, to) else { panic!("it crosses") };
        let h = map.dcel().half_edge(h).unwrap();
        let [a, b] = [h.origin(), h.target()].map(|v| map.point(v.index()));
        assert_eq!(a.x.to_bits(), f64::to_bits(first));
        assert_eq!(meeting(from.into(), to.into(), a, b), Meeting::Cross);
    }
}

#[test]
fn a_ring_around_some_islands_takes_them_in() {
    let mut map = PlanarMap::new();
    for i in 0..100_u32 {
        let (x, y) = (f64::from(i % 10), f64::from(i / 10));
        match i % 3 {
            0 => map.insert_point([x, y]),
            1 => map.insert_segment([x, y], [x + 0.5, y]),
            _ => map.insert_ring([[x, y], [x + 0.5, y], [x, y + 0.5]]),
        }
        .unwrap();
    }
    let ring = map.insert_ring([[2.75, 2.75], [5.75, 2.75], [5.75, 5.75], [2.75, 5.75]]).unwrap();
    assert_eq!(map.dcel().face(ring.faces_split[0].1).unwrap().inner().count(), 9);
    assert!(map.validate().is_valid());
}
