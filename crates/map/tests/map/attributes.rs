//! Values that follow edits, are undone with them, and are unchanged by an edit refused halfway.

use crate::rewound::change;
use crate::support::programs::check;
use crate::support::tokens::{Handles, Mint, Mints, Tokens, handles};
use quickcheck::Gen;
use std::panic::{AssertUnwindSafe, catch_unwind};
use twinedge::dcel::{
    Audited, FaceKey, HalfEdge, HalfEdgeKey, History, OperatorError, Outside, Policy, SecondaryMap, VertexKey,
};
use twinedge::validate::Expectation;
use twinedge::validate::near::WriteSet;
use twinedge_algorithm::area::face_area;
use twinedge_geometry::Point;
use twinedge_map::edit::EditError;
use twinedge_map::program::{EditOutcome, EditProgram, EditRunner};
use twinedge_map::{FeatureId, Features, Located, PlanarMap};

/// Attributes of the empty map.
fn tokens_of(map: &mut PlanarMap, mints: &Mints, refuses: u64) -> Handles {
    let handles = handles!(map, mints, refuses);
    map.set_value(handles.faces, map.dcel().unbounded_face().key(), mints[4].purse()).unwrap();
    handles
}

#[test]
fn no_token_is_lost_or_doubled_by_any_edit_undone_or_not() {
    fn law(program: EditProgram) {
        let (mints, mut map) = (Mints::default(), PlanarMap::new());
        let handles = tokens_of(&mut map, &mints, 0);
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

/// Occasionally adds, merges or removes features, as a separate change.
fn shuffle_features(history: &mut History<PlanarMap>, step: usize) {
    let count = history.get().features().count();
    let feature = |map: &PlanarMap, i: usize| map.feature(i % count.max(1)).unwrap();
    let outcome = match step % 5 {
        0 => history.change("add", |map| {
            map.add_feature(Some(step.to_string()));
            Ok(())
        }),
        _ if count == 0 => return,
        1 => history.change("merge", |map| map.merge_features(feature(map, step), feature(map, step / 5))),
        3 if count > 4 => history.change("remove", |map| map.remove_feature(feature(map, step / 5)).map(drop)),
        _ => return,
    };
    // Only a policy refuses, or the feature no longer exists.
    let refused = |error| matches!(error, EditError::Operator(OperatorError::Refused(_)) | EditError::NoSuchFeature(_));
    assert!(outcome.is_ok() || outcome.is_err_and(refused));
}

#[test]
fn no_token_of_a_feature_is_lost_or_doubled_undone_or_not() {
    fn law(program: EditProgram, refuses: bool) {
        let (mint, mut map) = (Mint::default(), PlanarMap::new());
        let of = map.add_attribute(mint.policy(Policy::<Features, _>::new(), if refuses { 7 } else { 0 }));
        let values = |history: &History<PlanarMap>| {
            history.get().values(of).unwrap().iter().map(|(k, all)| (k, all.clone())).collect::<Vec<_>>()
        };
        let mut history = History::new(map);
        let mut states = vec![(history.get().clone(), values(&history))];
        for (i, op) in program.0.iter().enumerate() {
            for edit in [false, true] {
                let before = (history.mark(), history.get().clone(), values(&history));
                if edit {
                    change(&mut history, op);
                } else {
                    shuffle_features(&mut history, i);
                }
                let after = values(&history);
                mint.check(after.iter().flat_map(|(_, tokens)| tokens.clone()).collect());
                if history.mark() == before.0 {
                    assert!(*history.get() == before.1 && after == before.2);
                } else {
                    states.push((history.get().clone(), after));
                }
            }
        }
        while states.len() > 1 {
            let (map, tokens) = states.pop().unwrap();
            assert!(*history.get() == map && values(&history) == tokens);
            assert!(history.undo());
            let (map, tokens) = states.last().unwrap();
            assert!(history.get() == map && values(&history) == *tokens);
        }
        while history.redo() {}
        mint.check(values(&history).into_iter().flat_map(|(_, tokens)| tokens).collect());
    }
    check(60, 60, law as fn(EditProgram, bool));
}

#[test]
fn a_merged_feature_is_where_both_were_and_a_removed_one_is_nowhere() {
    let mut map = PlanarMap::new();
    let name = map.add_attribute(
        Policy::<Features, _>::new()
            .merge_equal()
            .drop_with(|kept: &bool| if *kept { Err("this one stays") } else { Ok(()) }),
    );
    map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]]).unwrap();
    let fence = map.insert_segment([2.0, 0.0], [2.0, 2.0]).unwrap();
    let (west, east) = fence.faces_split[0];
    let [a, b, c] = ["a", "b", "c"].map(|name| map.add_feature(Some(name.into())));
    map.set_features_of(west, [a, c]).unwrap();
    map.set_features_of(east, [b, c]).unwrap();
    map.set_features_along(fence.way[0], [b]).unwrap();
    map.set_value(name, c, true).unwrap();
    let size = map.add_attribute(Policy::<Features, _>::new().merge_sum());
    map.set_value(size, a, 1).unwrap();
    map.set_value(size, b, 2).unwrap();
    let before = map.clone();
    assert!(matches!(map.remove_feature(c), Err(EditError::Operator(OperatorError::Refused(_)))));
    assert!(matches!(map.merge_features(a, c), Err(EditError::Operator(OperatorError::Refused(_)))));
    let mut other = map.clone();
    let unknown = other.add_feature(None);
    assert!(matches!(map.remove_feature(unknown), Err(EditError::NoSuchFeature(of)) if of == unknown));
    assert!(matches!(map.merge_features(a, unknown), Err(EditError::NoSuchFeature(_))));
    assert!(matches!(map.set_value(name, unknown, true), Err(EditError::NoSuchFeature(_))));
    assert!(map == before);

    map.merge_features(a, a).unwrap();
    assert!(map == before);
    map.merge_features(a, b).unwrap();
    assert!(map.features_of(west).unwrap().eq([a, c]) && map.features_of(east).unwrap().eq([a, c]));
    assert!(map.features_along(fence.way[0]).unwrap().eq([a]));
    assert_eq!([a, b].map(|f| map.value(size, f)), [Some(&3), None]);
    map.set_value(name, c, false).unwrap();
    assert_eq!(map.remove_feature(c).unwrap().as_deref(), Some("c"));
    assert!(map.features_of(west).unwrap().eq([a]) && map.value(name, c).is_none());
    // The numbers of the others are unchanged.
    assert_eq!(map.features().map(|f| map.name(f)).collect::<Vec<_>>(), [Some("a"), None, None]);
}

#[test]
fn a_map_made_of_another_one_takes_over_every_value() {
    fn law(program: EditProgram) {
        let (mints, mut map) = (Mints::default(), PlanarMap::new());
        let handles = tokens_of(&mut map, &mints, 0);
        let of_feature = map.add_attribute(Policy::<Features, _>::new().ids(5));
        let mut runner = EditRunner::new(map);
        runner.run(&program);
        let old = runner.into_map();
        let (mut new, keys) = PlanarMap::from_view(&old, &Expectation::plane(), Outside::Given).unwrap();
        let features: Vec<_> = old.features().map(|f| new.add_feature(old.name(f).map(Into::into))).collect();
        new.carry_values(&old, &keys);
        handles.check(new.dcel(), &mints);
        // A feature with a value keeps it.
        if let Some(feature) = new.feature(0) {
            new.set_value(of_feature, feature, 3_u64).unwrap();
            new.carry_values(&old, &keys);
            let value = old.value(of_feature, feature).copied();
            let had = match value {
                Some(value) => new.set_value(of_feature, feature, value),
                None => new.remove_value(of_feature, feature),
            };
            assert_eq!(had, Ok(Some(3)));
        }
        for h in old.dcel().half_edges() {
            let key = keys.half_edge(h.index()).unwrap();
            assert_eq!(new.value(handles.half_edges, key), old.value(handles.half_edges, h.key()));
            assert_eq!(new.value(handles.edges, key), old.value(handles.edges, h.key()));
            assert_eq!(new.value(handles.corners, key), old.value(handles.corners, h.key()));
        }
        for (v, tokens) in old.values(handles.vertices).unwrap() {
            let v = old.dcel().vertex(v).unwrap().index();
            assert_eq!(new.value(handles.vertices, keys.vertex(v).unwrap()), Some(tokens));
        }
        for (f, tokens) in old.values(handles.faces).unwrap() {
            let f = old.dcel().face(f).unwrap().index();
            assert_eq!(new.value(handles.faces, keys.face(f).unwrap()), Some(tokens));
        }
        assert!(features.iter().all(|f| new.value(of_feature, *f) == old.value(of_feature, *f)));
        assert!(features.iter().all(|f| new.find(of_feature, new.value(of_feature, *f).unwrap()) == Some(*f)));
    }
    check(60, 60, law as fn(EditProgram));
}

/// A map, with the values of its faces and features.
type Saved = (PlanarMap, SecondaryMap<FaceKey, Tokens>, SecondaryMap<FeatureId, u64>);

#[test]
fn values_saved_beside_a_map_find_their_records_when_both_are_loaded() {
    fn law(program: EditProgram) {
        let (mints, mut map) = (Mints::default(), PlanarMap::new());
        let handles = tokens_of(&mut map, &mints, 0);
        let ids = map.add_attribute(Policy::<Features, _>::new().ids(100));
        let mut runner = EditRunner::new(map);
        runner.run(&program);
        let map = runner.into_map();
        let text = serde_json::to_string(&(&map, map.values(handles.faces), map.values(ids))).unwrap();
        let (mut loaded, faces, features) = serde_json::from_str::<Saved>(&text).unwrap();
        let next = features.values().max().map_or(100, |last| last + 1);
        let of_face = loaded.add_attribute_with(Policy::of_faces(), faces);
        let again = loaded.add_attribute_with(Policy::<Features, _>::new().ids(next), features);
        assert!(loaded == map);
        assert!(loaded.values(of_face).unwrap().iter().eq(map.values(handles.faces).unwrap()));
        assert!(loaded.values(again).unwrap().iter().eq(map.values(ids).unwrap()));
        let added = loaded.add_feature(None);
        assert_eq!(loaded.find(again, &next), Some(added));
    }
    check(40, 40, law as fn(EditProgram));
}

#[test]
fn an_edit_that_is_refused_halfway_leaves_everything_as_it_was() {
    fn run(program: &EditProgram) -> usize {
        let (mints, mut map) = (Mints::default(), PlanarMap::new());
        let handles = tokens_of(&mut map, &mints, 13);
        let _ = map.locate(Point::new(0.5, 0.5));
        // Each edit is validated by its writes, including undone edits.
        let mut runner = EditRunner::audited(map).unwrap();
        let mut refused = 0;
        for op in &program.0 {
            let before = runner.map().clone();
            let outcome = runner.step_checked(op).unwrap();
            let map = runner.map();
            if matches!(outcome, EditOutcome::Refused(EditError::Operator(OperatorError::Refused(_)))) {
                assert!(*map == before, "{op}");
                assert_eq!(handles.values(map.dcel()), handles.values(before.dcel()));
                refused += 1;
            }
            let p = Point::new(0.75, 0.5);
            let saved = serde_json::to_string(map).unwrap();
            let searched = serde_json::from_str::<PlanarMap>(&saved).unwrap().locate(p);
            let place = |located: Located| Some(located).filter(|located| !matches!(located, Located::Edge(_)));
            assert_eq!(map.locate(p).map(place), searched.map(place));
        }
        refused
    }
    let mut programs = Gen::from_size_and_seed(50, 2026);
    let refused: usize = (0..60).map(|_| run(&quickcheck::Arbitrary::arbitrary(&mut programs))).sum();
    assert!(refused > 100, "{refused}");
}

#[test]
fn an_audited_map_with_attributes_notes_what_one_without_notes() {
    let plain = PlanarMap::new();
    let mut map = plain.clone();
    map.add_attribute::<_, u8>(Policy::of_faces().split_copy());
    let mut both = [plain, map].map(|map| Audited::new(map).unwrap());
    let mut step = |edit: &dyn Fn(&mut PlanarMap)| {
        let written = both.each_mut().map(|audited| {
            audited.change(|map| edit(map)).unwrap();
            let WriteSet { mut vertices, mut half_edges, mut faces, .. } = audited.written().clone();
            for list in [&mut vertices, &mut half_edges, &mut faces] {
                list.sort_unstable();
                list.dedup();
            }
            [vertices, half_edges, faces]
        });
        assert_eq!(written[0], written[1]);
        assert!(!written[0][0].is_empty());
    };
    step(&|map| drop(map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]).unwrap()));
    step(&|map| drop(map.insert_segment([1.0, 0.0], [1.0, 4.0]).unwrap()));
    let first = |map: &PlanarMap| map.dcel().vertices().next().unwrap().key();
    step(&|map| map.move_vertex(first(map), [-1.0, 0.0]).unwrap());
    step(&|map| drop(map.remove_vertex(first(map)).unwrap()));
}

/// A square of four cells with owners, with its middle vertex and the edges from there.
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
        map.set_value(owner, face, 1_u32).unwrap();
    }
    (map, owner, spokes)
}

#[test]
fn a_refused_edit_inside_of_a_change_leaves_the_rest_of_the_change() {
    let (mut map, owner, spokes) = four_cells();
    let sides =
        [map.dcel().half_edge(spokes[0]).unwrap().face().key(), map.dcel().half_edge(spokes[2]).unwrap().face().key()];
    let middle = map.dcel().half_edge(spokes[0]).unwrap().origin().key();
    // The last of the erased edges would merge two owners.
    map.set_value(owner, sides[1], 2_u32).unwrap();
    let original = map.clone();
    let mut history = History::new(map);
    let seen = history.change("several", |map| {
        map.insert_point([1.0, 1.0])?;
        map.set_value(owner, sides[0], 3_u32)?;
        map.set_value(owner, sides[0], 1_u32)?;
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
    // Once all have one owner, the vertex is removed.
    history.change("sell", |map| map.set_value(owner, sides[1], 1_u32)).unwrap();
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
            // New records, other than parts of existing ones, get their values.
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

/// The value of a feature unknown to the map is dropped, and is not kept under a number beyond its features.
#[test]
fn a_feature_of_another_map_gets_no_value() {
    let mut old = PlanarMap::new();
    let note = old.add_attribute(Policy::<Features, u32>::new());
    let features = [0, 1].map(|i| old.add_feature(Some(format!("feature {i}"))));
    old.set_value(note, features[1], 5_u32).unwrap();
    let mut new = PlanarMap::new();
    new.add_feature(None);
    new.carry_parts(&old, |_| None, Some).unwrap();
    assert_eq!(new.values(note).map(SecondaryMap::len), Some(0));
}

#[test]
fn values_that_are_carried_over_in_a_change_are_taken_back_with_it() {
    let (old, owner, _) = four_cells();
    let history = || {
        let mut map = PlanarMap::new();
        map.insert_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();
        History::new(map)
    };
    let carry = |map: &mut PlanarMap| {
        let cell = old.values(owner).unwrap().keys().next();
        map.carry_parts(&old, |face| cell.filter(|_| !face.is_unbounded()), |_| None)
    };
    let values = |history: &History<PlanarMap>| history.get().values(owner).map_or(0, SecondaryMap::len);
    let mut failed = history();
    let refused: Result<(), EditError> = failed.change("carry", |map| {
        carry(map)?;
        map.remove_vertex(VertexKey::default()).map(drop)
    });
    assert!(refused.is_err());
    assert_eq!((values(&failed), failed.undo()), (0, false));
    let mut history = history();
    history.change("carry", carry).unwrap();
    assert_eq!(values(&history), 1);
    assert!(history.undo());
    assert_eq!(values(&history), 0);
    assert!(history.redo());
    assert_eq!(values(&history), 1);
}
