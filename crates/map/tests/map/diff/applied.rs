//! Comparing maps, and applying diffs.

use super::{Named, draw, edited, erase, two_squares};
use quickcheck::{Gen, QuickCheck, Testable};
use slotmap::SecondaryMap;
use twinedge::dcel::{Attribute, Attributed, History, Value};
use twinedge_map::diff::{ApplyError, Change, Diff, DiffError, MergeError, Record, diff};
use twinedge_map::edit::EditError;
use twinedge_map::program::EditProgram;
use twinedge_map::{Builder, PlanarMap};

fn check(tests: u64, size: usize, law: impl Testable) {
    QuickCheck::new().rng(Gen::from_size_and_seed(size, 2026)).tests(tests).quickcheck(law);
}

#[test]
fn a_diff_applied_to_the_first_map_gives_the_second() {
    fn law(before: EditProgram, after: EditProgram) {
        let mut map = PlanarMap::new();
        let by = Named::of(&mut map);
        let a = edited(map, by, &before);
        let b = edited(a.clone(), by, &after);
        let found = diff(&a, &b, &by.ids()).unwrap();
        assert_eq!(found.is_empty(), by.told(&a) == by.told(&b), "{found}");

        let mut history = History::new(a.clone());
        let _ = history.get().locate([0.5, 0.5].into());
        history.change("apply", |map| found.apply(map, &by.ids())).unwrap();
        assert!(history.get().validate().is_valid());
        assert_eq!(by.told(history.get()), by.told(&b), "{found}");
        assert!(diff(history.get(), &b, &by.ids()).unwrap().is_empty());
        // It is undone and redone like any other change.
        history.undo();
        assert!(*history.get() == a);
        assert_eq!(by.told(history.get()), by.told(&a));
        history.redo();
        assert_eq!(by.told(history.get()), by.told(&b));
        // And back again.
        let mut map = history.into_inner();
        let back = diff(&b, &a, &by.ids());
        if a.features().count() == b.features().count() {
            back.unwrap().apply(&mut map, &by.ids()).unwrap();
            assert_eq!(by.told(&map), by.told(&a));
        } else {
            assert_eq!(back, Err(DiffError::Features(a.features().count())));
        }
        let text = serde_json::to_string(&found).unwrap();
        assert_eq!(serde_json::from_str::<Diff>(&text).unwrap(), found);
    }
    check(80, 30, law as fn(EditProgram, EditProgram));
}

#[test]
fn vertices_that_change_places_are_drawn_anew_and_keep_what_they_have() {
    let (mut a, by) = two_squares();
    let w = a.insert_point([9.0, 1.0]).unwrap().vertices[0];
    let fence = a.dcel().vertex(by.v(&a, 5)).unwrap().leaving().unwrap().key();
    a.set_value(by.fence, fence, 6_u32).unwrap();
    a.set_value(by.note, by.f(&a, 2), 5_u32).unwrap();
    let wood = a.feature(0);
    a.set_features_of(by.f(&a, 2), wood).unwrap();
    a.set_features_along(fence, wood).unwrap();
    let mut b = a.clone();
    // Corner 5 moves through the place of vertex 7, which then takes the corner's old place.
    b.move_vertex(w, [20.0, 0.0]).unwrap();
    b.move_vertex(by.v(&b, 5), [10.0, 2.0]).unwrap();
    b.move_vertex(w, [8.0, -1.0]).unwrap();
    b.move_vertex(w, [8.0, 0.0]).unwrap();
    let found = diff(&a, &b, &by.ids()).unwrap();
    assert_eq!(found.changes().len(), 2, "{found}");
    let before = by.v(&a, 5);
    found.apply(&mut a, &by.ids()).unwrap();
    assert_eq!(by.told(&a), by.told(&b));
    assert!(a.dcel().vertex(before).is_err(), "it was not drawn anew");
    assert_eq!(a.value(by.note, by.f(&a, 2)), Some(&5));
}

#[test]
fn maps_without_ids_are_refused() {
    let (map, by) = two_squares();
    let without = |change: &dyn Fn(&mut PlanarMap) -> Result<bool, EditError>| {
        let mut other = map.clone();
        assert_eq!(change(&mut other), Ok(true));
        diff(&map, &other, &by.ids()).unwrap_err()
    };
    let (v, f) = (by.v(&map, 1), by.f(&map, 1));
    assert_eq!(without(&|map| Ok(map.remove_value(by.corner, v)?.is_some())), DiffError::VertexWithoutId(v));
    assert_eq!(without(&|map| Ok(map.remove_value(by.parcel, f)?.is_some())), DiffError::FaceWithoutId(f));
    assert_eq!(without(&|map| Ok(map.set_value(by.corner, v, 2_u64)?.is_some())), DiffError::SameId(Record::Vertex(2)));
    assert_eq!(without(&|map| Ok(map.set_value(by.parcel, f, 2_u128)?.is_some())), DiffError::SameId(Record::Face(2)));
    let mut crossing = Builder::new();
    for [from, to] in [[[0.0, 0.0], [1.0, 1.0]], [[0.0, 1.0], [1.0, 0.0]]] {
        crossing.segment(from, to).unwrap();
    }
    assert!(matches!(diff(&map, &crossing.build().unwrap(), &by.ids()), Err(DiffError::NotPlane(_))));
    let mut more = map.clone();
    more.add_feature(None);
    assert_eq!(diff(&more, &map, &by.ids()), Err(DiffError::Features(1)));
    let mut other = map.clone();
    other.add_feature(Some("lake".into()));
    assert_eq!(diff(&more, &other, &by.ids()), Err(DiffError::Features(1)));
    let (one, two) = (diff(&map, &map, &by.ids()).unwrap(), diff(&more, &more, &by.ids()).unwrap());
    assert_eq!(one.merge(&two), Err(MergeError::DifferentMaps));
    assert_eq!(one.apply(&mut more, &by.ids()), Err(ApplyError::Diff(DiffError::Features(1))));
}

#[test]
fn a_diff_of_another_map_is_refused_and_nothing_changes() {
    let (map, by) = two_squares();
    let apply = |changes: serde_json::Value| {
        let mut copy = map.clone();
        let saved = serde_json::json!({"features": 1, "names": [], "changes": changes});
        let refused = serde_json::from_value::<Diff>(saved).unwrap().apply(&mut copy, &by.ids());
        assert!(refused.is_ok() || (copy == map && by.told(&copy) == by.told(&map)));
        refused
    };
    let json = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
    for (record, text) in [
        (Record::Vertex(9), r#"[[{"Vertex": 9}, "dropped"]]"#),
        (Record::Vertex(1), r#"[[{"Vertex": 1}, "dropped"]]"#),
        (Record::Vertex(1), r#"[[{"Vertex": 1}, {"moved": {"from": [1, 0], "to": [2, 2]}}]]"#),
        (Record::Vertex(1), r#"[[{"Vertex": 1}, {"added": [1, 1]}]]"#),
        (Record::Vertex(9), r#"[[{"Vertex": 9}, {"added": [1, 1]}], [{"Vertex": 9}, {"added": [2, 1]}]]"#),
        (Record::Edge(1, 2), r#"[[{"Edge": [1, 2]}, "drawn"]]"#),
        (Record::Edge(1, 3), r#"[[{"Edge": [1, 3]}, "dropped"]]"#),
        (Record::Vertex(9), r#"[[{"Edge": [1, 9]}, "drawn"]]"#),
        (Record::Face(1), r#"[[{"Face": 1}, {"made": [1, 2]}]]"#),
        (Record::Face(9), r#"[[{"Face": 9}, {"reshaped": [1, 2]}]]"#),
        (Record::Face(9), r#"[[{"Face": 9}, "dropped"]]"#),
        (Record::Unbounded, r#"[["Unbounded", "dropped"]]"#),
        (Record::Edge(1, 2), r#"[[{"Edge": [1, 2]}, {"moved": {"from": [0, 0], "to": [2, 2]}}]]"#),
        (Record::Face(9), r#"[[{"Face": 9}, "drawn"]]"#),
        (Record::Face(1), r#"[[{"Face": 1}, {"features": {"from": [0], "to": []}}]]"#),
        (Record::Face(1), r#"[[{"Face": 1}, {"value": {"name": "owner", "from": "Eve", "to": null}}]]"#),
    ] {
        assert_eq!(apply(json(text)), Err(ApplyError::AnotherMap(record)), "{text}");
    }
    let value = |name: &str| {
        json(&format!(r#"[[{{"Vertex": 1}}, {{"value": {{"name": "{name}", "from": "0", "to": "high"}}}}]]"#))
    };
    let refused = ApplyError::Value { record: Record::Vertex(1), name: "height".into() };
    assert_eq!(apply(value("height")), Err(refused));
    let far = r#"[[{"Vertex": 9}, {"added": [1e300, 0]}]]"#;
    assert!(matches!(apply(json(far)), Err(ApplyError::Edit(EditError::OutOfRange { .. }))));
    // Faces that differ from the drawing.
    let drawn = |more: &str| json(&format!(r#"[[{{"Edge": [1, 3]}}, "drawn"]{more}]"#));
    assert!(matches!(apply(drawn("")), Err(ApplyError::Unnamed(Record::Edge(..)))));
    let made = r#", [{"Face": 9}, {"made": [1, 2, 3]}], [{"Face": 1}, {"reshaped": [1, 3, 4]}]"#;
    assert_eq!(apply(drawn(made)), Ok(()));
    let one = r#", [{"Face": 9}, {"made": [2, 3, 1]}], [{"Face": 1}, {"reshaped": [1, 2, 3]}]"#;
    assert_eq!(apply(drawn(one)), Err(ApplyError::OneFace(Record::Face(1), Record::Face(9))));
    let two = r#", [{"Face": 9}, {"made": [1, 2, 3]}], [{"Face": 9}, {"made": [1, 3, 4]}]"#;
    assert_eq!(apply(drawn(two)), Err(ApplyError::NotOneFace(Record::Face(9))));
    let lost = r#", [{"Face": 9}, {"made": []}]"#;
    assert_eq!(apply(drawn(lost)), Err(ApplyError::NotOneFace(Record::Face(9))));
}

#[test]
fn ids_of_128_bits_are_saved_as_they_are() {
    let (a, by) = two_squares();
    let mut b = a.clone();
    draw(&mut b, by, 1, 3);
    let made = by.f(&b, 3);
    b.set_value(by.parcel, made, u128::MAX).unwrap();
    let text = serde_json::to_string(&diff(&a, &b, &by.ids()).unwrap()).unwrap();
    assert!(text.contains("340282366920938463463374607431768211455"), "{text}");
    let mut again = a;
    serde_json::from_str::<Diff>(&text).unwrap().apply(&mut again, &by.ids()).unwrap();
    assert_eq!(by.told(&again), by.told(&b));
}

#[test]
fn attributes_that_are_not_compared_stay_with_their_records() {
    let (mut a, by) = two_squares();
    for face in [1, 2] {
        let key = by.f(&a, face);
        a.set_value(by.note, key, u32::try_from(face).unwrap()).unwrap();
    }
    // The ids of the two faces are swapped, so each is drawn in the place of the other.
    let mut b = a.clone();
    let faces = [1, 2].map(|face| by.f(&a, face));
    for (face, id) in [(faces[0], 2_u128), (faces[1], 1)] {
        b.set_value(by.parcel, face, id).unwrap();
    }
    diff(&a, &b, &by.ids()).unwrap().apply(&mut a, &by.ids()).unwrap();
    assert_eq!([by.f(&a, 1), by.f(&a, 2)], [faces[1], faces[0]]);
    assert_eq!([1, 2].map(|face| a.value(by.note, by.f(&a, face))), [Some(&1), Some(&2)]);
    // A dropped face takes its value with it.
    let mut c = a.clone();
    erase(&mut c, by, 2, 3);
    let found = diff(&a, &c, &by.ids()).unwrap();
    assert!(found.changes().iter().any(|(_, change)| matches!(change, Change::Reshaped(_))), "{found}");
    found.apply(&mut a, &by.ids()).unwrap();
    assert_eq!(a.values(by.note).unwrap().len(), 1);
}

/// Loaded maps are distinct from saved ones: their attributes are added, and then their values.
#[test]
fn maps_that_were_loaded_apart_are_compared() {
    fn give<K: Attributed, T: Value>(of: Attribute<K, T>, from: &PlanarMap, to: &mut PlanarMap) {
        for (key, value) in from.values(of).unwrap() {
            to.set_value(of, key, value.clone()).unwrap();
        }
    }
    let (map, by) = two_squares();
    let mut loaded: PlanarMap = serde_json::from_str(&serde_json::to_string(&map).unwrap()).unwrap();
    assert_eq!(diff(&map, &loaded, &by.ids()), Err(DiffError::NoSuchAttribute));
    loaded.add_attributes_of(&map);
    assert_eq!(loaded.values(by.owner).map(SecondaryMap::len), Some(0));
    give(by.corner, &map, &mut loaded);
    give(by.parcel, &map, &mut loaded);
    give(by.height, &map, &mut loaded);
    give(by.owner, &map, &mut loaded);
    give(by.fence, &map, &mut loaded);
    give(by.note, &map, &mut loaded);
    assert!(diff(&map, &loaded, &by.ids()).unwrap().is_empty());
    assert_eq!(loaded.next_id(by.corner), map.next_id(by.corner));
}
