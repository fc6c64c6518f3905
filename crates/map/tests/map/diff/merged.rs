//! Merging the changes of two sides.

use super::{Named, draw, edited, erase, two_squares};
use quickcheck::Gen;
use std::collections::BTreeMap;
use twinedge::dcel::History;
use twinedge_map::diff::{ApplyError, Conflict, DiffError, MergeError, Record, diff, merge};
use twinedge_map::edit::EditError;
use twinedge_map::program::EditProgram;
use twinedge_map::{FeatureId, PlanarMap};

#[test]
fn merges_do_what_both_sides_did_in_either_order_or_refuse_in_both() {
    fn law(base: EditProgram, ours: EditProgram, theirs: EditProgram) -> bool {
        let mut map = PlanarMap::new();
        let by = Named::of(&mut map);
        let ids = by.ids();
        let base = edited(map, by, &base);
        let sides = [ours, theirs]
            .map(|program| edited(base.clone(), by, &EditProgram(program.0.into_iter().take(3).collect())));
        let [ours, theirs] = &sides;
        assert_eq!(by.told(&merge(&base, ours, &base, &ids).unwrap()), by.told(ours));
        assert_eq!(by.told(&merge(&base, &base, ours, &ids).unwrap()), by.told(ours));
        assert_eq!(by.told(&merge(&base, ours, ours, &ids).unwrap()), by.told(ours));
        let (one, other) = (merge(&base, ours, theirs, &ids), merge(&base, theirs, ours, &ids));
        match (&one, &other) {
            (Ok(one), Ok(other)) => {
                assert!(one.validate().is_valid());
                assert_eq!(by.told(one).vertices, by.told(other).vertices);
                if ours.features().count() == base.features().count() {
                    assert_eq!(by.told(one), by.told(other));
                }
            }
            (Err(_), Err(_)) => {}
            (one, other) => panic!("{one:?} but {other:?}"),
        }
        one.is_ok()
    }
    let mut programs = Gen::from_size_and_seed(12, 2026);
    let mut program = || quickcheck::Arbitrary::arbitrary(&mut programs);
    let merged = (0..150).filter(|_| law(program(), program(), program())).count();
    assert!((30..140).contains(&merged), "{merged}");
}

/// Both sides of a merge of changes to the two squares.
fn merged(
    ours: impl FnOnce(&mut PlanarMap, Named),
    theirs: impl FnOnce(&mut PlanarMap, Named),
) -> (Result<PlanarMap, MergeError>, Named) {
    let (base, by) = two_squares();
    let (mut our_side, mut their_side) = (base.clone(), base.clone());
    ours(&mut our_side, by);
    theirs(&mut their_side, by);
    (merge(&base, &our_side, &their_side, &by.ids()), by)
}

/// The conflicts of such a merge.
fn conflicts(ours: impl FnOnce(&mut PlanarMap, Named), theirs: impl FnOnce(&mut PlanarMap, Named)) -> Vec<String> {
    match merged(ours, theirs).0 {
        Err(MergeError::Conflicts(all)) => all.iter().map(Conflict::to_string).collect(),
        other => panic!("{other:?}"),
    }
}

/// The error of such a merge in which no record was changed on both sides.
fn together(ours: impl FnOnce(&mut PlanarMap, Named), theirs: impl FnOnce(&mut PlanarMap, Named)) -> ApplyError {
    match merged(ours, theirs).0 {
        Err(MergeError::Together(error)) => error,
        other => panic!("{other:?}"),
    }
}

#[test]
fn disjoint_edits_are_all_done() {
    let (merged, by) = merged(
        |map, by| {
            draw(map, by, 1, 3);
            map.set_value(by.owner, by.f(map, 1), "Ada".to_owned()).unwrap();
            let wood = map.feature(0).unwrap();
            map.set_features_of(by.f(map, 1), [wood]).unwrap();
            let lake = map.add_feature(Some("lake".into()));
            map.set_features_of(map.dcel().unbounded_face().key(), [lake]).unwrap();
        },
        |map, by| {
            map.move_vertex(by.v(map, 6), [9.0, 9.0]).unwrap();
            erase(map, by, 2, 5);
            map.set_value(by.height, by.v(map, 5), 3.0).unwrap();
            let road = map.add_feature(Some("road".into()));
            let h = map.dcel().vertex(by.v(map, 5)).unwrap().rotation().next().unwrap().key();
            map.set_features_along(h, [road]).unwrap();
        },
    );
    let map = merged.unwrap();
    assert_eq!(map.features().map(|f| map.name(f).unwrap()).collect::<Vec<_>>(), ["wood", "lake", "road"]);
    assert_eq!((map[by.v(&map, 6)], map.value(by.height, by.v(&map, 5))), ([9.0, 9.0].into(), Some(&3.0)));
    let h = map.dcel().vertex(by.v(&map, 5)).unwrap().rotation().next().unwrap().key();
    assert!(map.features_along(h).unwrap().map(FeatureId::index).eq([2]));
    assert!(map.features_of(by.f(&map, 1)).unwrap().map(FeatureId::index).eq([0]));
    assert!(map.features_of(map.dcel().unbounded_face().key()).unwrap().map(FeatureId::index).eq([1]));
    assert_eq!(by.told(&map).faces.keys().copied().collect::<Vec<_>>(), [0, 1, 3]);
}

#[test]
fn both_sides_may_cut_one_face_where_their_lines_do_not_meet() {
    let cut = |x: f64| {
        move |map: &mut PlanarMap, by: Named| {
            let ends = [[x, 1.0], [x, 3.0]].map(|p| map.insert_point(p).unwrap().vertices[0]);
            map.insert_segment(ends[0], ends[1]).unwrap();
            map.insert_segment(ends[0], [x + 0.5, 2.0]).unwrap();
            map.insert_segment(ends[1], [x + 0.5, 2.0]).unwrap();
            assert_eq!(map.dcel().face_count(), 4, "{:?}", by.told(map));
        }
    };
    let (map, by) = merged(cut(1.0), cut(2.0));
    assert_eq!(by.told(&map.unwrap()).faces.len(), 5);
    // Each side cuts off a corner of the first square: both change its outline.
    let corner = |from: [f64; 2], to: [f64; 2]| {
        move |map: &mut PlanarMap, by: Named| {
            map.insert_segment(from, to).unwrap();
            assert!(by.told(map).faces.len() == 4);
        }
    };
    let (map, by) = merged(corner([0.0, 3.0], [1.0, 4.0]), corner([3.0, 0.0], [4.0, 1.0]));
    let map = map.unwrap();
    let sizes: BTreeMap<u128, usize> = map
        .dcel()
        .faces()
        .map(|f| (*map.value(by.parcel, f.key()).unwrap(), f.outer().map_or(0, |b| b.half_edges().count())))
        .collect();
    assert_eq!(sizes, BTreeMap::from([(0, 0), (1, 6), (2, 5), (3, 3), (4, 3)]));
}

#[test]
fn a_vertex_that_both_sides_move_is_a_conflict_and_the_same_move_is_none() {
    let to = |x: f64| move |map: &mut PlanarMap, by: Named| map.move_vertex(by.v(map, 5), [x, 0.0]).unwrap();
    assert_eq!(
        conflicts(to(9.0), to(7.0)),
        ["ours: vertex 5 moved from (8, 0) to (9, 0), theirs: vertex 5 moved from (8, 0) to (7, 0)"]
    );
    let (map, by) = merged(to(9.0), to(9.0));
    let map = map.unwrap();
    assert_eq!(map[by.v(&map, 5)], [9.0, 0.0].into());
}

#[test]
fn a_vertex_that_one_side_drops_is_a_conflict_with_what_the_other_does_to_it() {
    let dropped = |map: &mut PlanarMap, by: Named| drop(map.remove_vertex(by.v(map, 5)).unwrap());
    let raised = |map: &mut PlanarMap, by: Named| {
        map.set_value(by.height, by.v(map, 5), 2.0).unwrap();
    };
    assert_eq!(conflicts(dropped, raised), ["ours: vertex 5 dropped, theirs: vertex 5 height: \"0\" -> \"2\""]);
    let moved = |map: &mut PlanarMap, by: Named| map.move_vertex(by.v(map, 5), [9.0, 0.0]).unwrap();
    assert_eq!(conflicts(moved, dropped), ["ours: vertex 5 moved from (8, 0) to (9, 0), theirs: vertex 5 dropped"]);
}

#[test]
fn an_edge_that_one_side_draws_to_a_vertex_that_the_other_drops_is_a_conflict() {
    let (mut base, by) = two_squares();
    base.insert_point([20.0, 0.0]).unwrap();
    let (mut drawn, mut dropped) = (base.clone(), base.clone());
    draw(&mut drawn, by, 5, 7);
    dropped.remove_vertex(by.v(&base, 7)).unwrap();
    let text = |ours, theirs| merge(&base, ours, theirs, &by.ids()).unwrap_err().to_string();
    assert_eq!(text(&drawn, &dropped), "conflicts: ours: edge 5-7 drawn, theirs: vertex 7 dropped");
    assert_eq!(text(&dropped, &drawn), "conflicts: ours: vertex 7 dropped, theirs: edge 5-7 drawn");
}

#[test]
fn an_edge_that_one_side_erases_does_not_come_back_with_the_vertex_that_the_other_puts_on_it() {
    let (mut base, by) = two_squares();
    base.insert_point([20.0, 0.0]).unwrap();
    draw(&mut base, by, 5, 7);
    let (mut erased, mut divided, mut both) = (base.clone(), base.clone(), base.clone());
    erase(&mut erased, by, 5, 7);
    divided.insert_point([12.0, 0.0]).unwrap();
    let text = |ours, theirs| merge(&base, ours, theirs, &by.ids()).unwrap_err().to_string();
    assert_eq!(text(&erased, &divided), "conflicts: ours: edge 5-7 dropped, theirs: edge 5-8 drawn");
    assert_eq!(text(&divided, &erased), "conflicts: ours: edge 5-8 drawn, theirs: edge 5-7 dropped");
    // Lines that end elsewhere are no path between its ends.
    erase(&mut both, by, 5, 7);
    let end = both.insert_point([20.0, 4.0]).unwrap().vertices[0];
    both.insert_segment(by.v(&both, 7), end).unwrap();
    assert!(!merge(&base, &erased, &both, &by.ids()).unwrap().dcel().edges().any(|h| {
        let ends = [h.origin().key(), h.target().key()].map(|v| base.value(by.corner, v));
        ends.contains(&Some(&5)) && ends.contains(&Some(&7))
    }));
}

#[test]
fn edges_and_faces_that_one_side_drops_are_conflicts_with_what_the_other_does_to_them() {
    let erased = |map: &mut PlanarMap, by: Named| erase(map, by, 2, 3);
    let fenced = |map: &mut PlanarMap, by: Named| {
        let h = map.dcel().vertex(by.v(map, 2)).unwrap().rotation().find(|h| h.target().key() == by.v(map, 3));
        map.set_value(by.fence, h.unwrap().key(), 4_u32).unwrap();
    };
    assert_eq!(conflicts(erased, fenced), ["ours: edge 2-3 dropped, theirs: edge 2-3 fence: none -> \"4\""]);
    let dropped_face =
        |map: &PlanarMap, by: Named| [1, 2].into_iter().find(|f| map.find(by.parcel, f).is_none()).unwrap();
    let (mut map, by) = two_squares();
    erased(&mut map, by);
    let gone = dropped_face(&map, by);
    let owned =
        move |map: &mut PlanarMap, by: Named| drop(map.set_value(by.owner, by.f(map, gone), "Eve".to_owned()).unwrap());
    assert_eq!(
        conflicts(owned, erased),
        [format!("ours: face {gone} owner: none -> \"Eve\", theirs: face {gone} dropped")]
    );
}

#[test]
fn values_and_features_that_both_sides_set_are_conflicts() {
    let owned = |owner: &'static str| {
        move |map: &mut PlanarMap, by: Named| drop(map.set_value(by.owner, by.f(map, 1), owner.to_owned()).unwrap())
    };
    assert_eq!(
        conflicts(owned("Ada"), owned("Bob")),
        ["ours: face 1 owner: none -> \"Ada\", theirs: face 1 owner: none -> \"Bob\""]
    );
    let covered = |name: &'static str| {
        move |map: &mut PlanarMap, by: Named| {
            let lake = map.add_feature(Some(name.into()));
            map.set_features_of(by.f(map, 1), [lake]).unwrap();
        }
    };
    assert_eq!(
        conflicts(covered("lake"), covered("pond")),
        ["ours: face 1 features: [] -> [1], theirs: face 1 features: [] -> [2]"]
    );
}

#[test]
fn a_feature_that_one_side_drops_is_dropped_unless_the_other_gives_it_to_a_record() {
    let dropped =
        |map: &mut PlanarMap, _: Named| assert!(map.remove_feature(map.feature(0).unwrap()).unwrap().is_some());
    let (map, by) = merged(dropped, |map, by| draw(map, by, 1, 3));
    let map = map.unwrap();
    assert_eq!((map.name(map.feature(0).unwrap()), by.told(&map).faces.len()), (None, 4));
    let given = |map: &mut PlanarMap, by: Named| map.set_features_of(by.f(map, 1), map.feature(0)).unwrap();
    assert_eq!(conflicts(dropped, given), ["ours: feature 0 dropped, theirs: face 1 features: [] -> [0]"]);
    assert_eq!(conflicts(given, dropped), ["ours: face 1 features: [] -> [0], theirs: feature 0 dropped"]);
}

#[test]
fn sides_that_did_the_same_are_merged_to_the_same() {
    let (base, by) = two_squares();
    let mut side = base.clone();
    let (wood, lake) = (side.feature(0).unwrap(), side.add_feature(Some("lake".into())));
    side.set_features_of(by.f(&side, 1), [lake]).unwrap();
    side.remove_feature(wood).unwrap();
    draw(&mut side, by, 1, 3);
    assert_eq!(by.told(&merge(&base, &side, &side, &by.ids()).unwrap()), by.told(&side));
}

/// Otherwise a diff that drops the feature would remove the new one from its faces.
#[test]
fn the_number_of_a_removed_feature_is_not_used_again() {
    let (base, by) = two_squares();
    let wood = base.feature(0).unwrap();
    let mut history = History::new(base.clone());
    history.change("remove", |map| map.remove_feature(wood)).unwrap();
    let mut map = history.get().clone();
    let edge = map.dcel().edges().next().unwrap().key();
    let gone = EditError::NoSuchFeature(wood);
    let inside = by.f(&map, 1);
    assert_eq!(map.set_features_of(inside, [wood]), Err(gone));
    assert_eq!(map.set_features_along(edge, [wood]), Err(gone));
    assert_eq!(map.remove_feature(wood), Err(gone));
    assert_eq!(map.merge_features(wood, wood), Err(gone));
    assert_eq!(diff(&base, &map, &by.ids()).unwrap().to_string(), "feature 0 dropped\n");
    assert!(matches!(diff(&map, &base, &by.ids()), Err(DiffError::Features(0))));
    let loaded: PlanarMap = serde_json::from_str(&serde_json::to_string(&map).unwrap()).unwrap();
    assert_eq!((loaded.clone().set_features_of(inside, [wood]), loaded == map), (Err(gone), true));
    // An unnamed feature is not a removed one.
    let unnamed = map.add_feature(None);
    map.set_features_of(inside, [unnamed]).unwrap();
    assert!(history.undo());
    assert_eq!(history.change("cover", |map| map.set_features_of(inside, [wood])), Ok(()));
    assert!(history.undo() && history.redo() && history.undo());
    let again = history.change("remove", |map| map.remove_feature(wood));
    assert_eq!(again, Ok(Some("wood".to_owned())));
    assert!(history.undo() && history.redo());
    assert_eq!(history.change("cover", |map| map.set_features_of(inside, [wood])), Err(gone));
}

#[test]
fn records_that_both_sides_make_with_one_id_are_a_conflict() {
    let (base, by) = two_squares();
    let numbered = |p: [f64; 2]| {
        let mut map = base.clone();
        let v = map.insert_point(p).unwrap().vertices[0];
        map.set_value(by.corner, v, 50_u64).unwrap();
        map
    };
    let (ours, theirs) = (numbered([1.0, 1.0]), numbered([2.0, 1.0]));
    assert_eq!(
        merge(&base, &ours, &theirs, &by.ids()).unwrap_err().to_string(),
        "conflicts: ours: vertex 50 added at (1, 1), theirs: vertex 50 added at (2, 1)"
    );
}

#[test]
fn lines_of_both_sides_that_meet_are_named() {
    let line = |from: u64, to: u64| move |map: &mut PlanarMap, by: Named| draw(map, by, from, to);
    let point = |p: [f64; 2]| move |map: &mut PlanarMap, _: Named| drop(map.insert_point(p).unwrap());
    assert_eq!(
        together(line(1, 3), line(2, 4)),
        ApplyError::Overlap { drawn: Record::Edge(2, 4), with: Record::Edge(1, 3) }
    );
    // Vertices 7 and 8: the numbers of one side continue after the other's.
    let of_both = |p| together(point(p), point(p));
    assert_eq!(of_both([1.0, 1.0]), ApplyError::Overlap { drawn: Record::Vertex(8), with: Record::Vertex(7) });
    assert_eq!(
        together(point([2.0, 2.0]), line(1, 3)),
        ApplyError::Overlap { drawn: Record::Edge(1, 3), with: Record::Vertex(7) }
    );
    let moved = |map: &mut PlanarMap, by: Named| map.move_vertex(by.v(map, 2), [4.0, -4.0]).unwrap();
    let outside = |map: &mut PlanarMap, _: Named| drop(map.insert_point([2.0, -2.0]).unwrap());
    assert_eq!(together(moved, outside), ApplyError::Overlap { drawn: Record::Vertex(7), with: Record::Edge(1, 2) });
}

#[test]
fn faces_that_only_both_sides_together_make_are_named() {
    // Each side draws one half of a line across.
    let (mut base, by) = two_squares();
    let p = base.insert_point([1.0, 2.0]).unwrap().vertices[0];
    let side = |to: u64| {
        let mut map = base.clone();
        map.insert_segment(p, by.v(&base, to)).unwrap();
        map
    };
    let error = merge(&base, &side(1), &side(3), &by.ids()).unwrap_err();
    assert!(matches!(error, MergeError::Together(ApplyError::Unnamed(Record::Edge(..)))), "{error}");

    // One side joins the middle square to the left one, the other side to the right one.
    let (mut base, by) = two_squares();
    let far = [[12.0, 0.0], [12.0, 4.0]].map(|p| base.insert_point(p).unwrap().vertices[0]);
    for (from, to) in [(by.v(&base, 5), far[0]), (far[0], far[1]), (far[1], by.v(&base, 6))] {
        base.insert_segment(from, to).unwrap();
    }
    let join = |kept: u128| {
        let mut map = base.clone();
        let face = map.dcel().face(by.f(&map, kept)).unwrap();
        let h = face.half_edges().find(|h| h.twin().face().key() == by.f(&base, 2)).unwrap().key();
        map.remove_edge(h).unwrap();
        map
    };
    let error = merge(&base, &join(1), &join(3), &by.ids()).unwrap_err();
    assert_eq!(error, MergeError::Together(ApplyError::OneFace(Record::Face(1), Record::Face(3))));
}

/// Values are merged record by record: the part that keeps the id is sold, the other one is not.
#[test]
fn of_a_face_that_one_side_splits_and_the_other_sells_the_part_with_the_id_is_sold() {
    let (merged, by) = merged(
        |map, by| {
            map.set_value(by.owner, by.f(map, 1), "Ada".to_owned()).unwrap();
            draw(map, by, 1, 3);
            map.remove_value(by.owner, by.f(map, 1)).unwrap();
        },
        |map, by| assert_eq!(map.set_value(by.owner, by.f(map, 1), "Cy".to_owned()), Ok(None)),
    );
    let map = merged.unwrap();
    let owners = [1, 3].map(|id| map.value(by.owner, by.f(&map, id)).map(String::as_str));
    assert_eq!(owners, [Some("Cy"), Some("Ada")]);
}
