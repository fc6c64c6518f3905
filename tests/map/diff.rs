//! Differences of maps by ids: applied, merged, saved.

use quickcheck::{Gen, QuickCheck, Testable};
use slotmap::SecondaryMap;
use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::{
    Attribute, Attributed, Edges, Face, FaceKey, Faces, HalfEdge, Policy, Value, VertexKey, Vertices,
};
use twinedge::map::diff::{ApplyError, Change, Conflict, Diff, DiffError, Ids, MergeError, Record, diff, merge};
use twinedge::map::edit::EditError;
use twinedge::map::program::{EditProgram, EditRunner};
use twinedge::map::{Builder, FeatureId, History, PlanarMap};

fn check(tests: u64, size: usize, law: impl Testable) {
    QuickCheck::new().rng(Gen::from_size_and_seed(size, 2026)).tests(tests).quickcheck(law);
}

/// The attributes of the maps of these tests.
#[derive(Clone, Copy)]
struct Named {
    corner: Attribute<Vertices, u64>,
    parcel: Attribute<Faces, u128>,
    height: Attribute<Vertices, f64>,
    owner: Attribute<Faces, String>,
    fence: Attribute<Edges, u32>,
    /// Not compared.
    note: Attribute<Faces, u32>,
}

impl Named {
    fn of(map: &mut PlanarMap) -> Self {
        let parcel = map.add_attribute(Policy::of_faces().identified_by(|id| *id).split_with({
            let next = std::sync::atomic::AtomicU64::new(1);
            move |id: u128| Ok([id, next.fetch_add(1, std::sync::atomic::Ordering::Relaxed).into()])
        }));
        map.set_value(parcel, map.dcel().unbounded_face().key(), 0).unwrap();
        Self {
            corner: map.add_attribute(Policy::of_vertices().ids(1)),
            parcel,
            height: map.add_attribute(Policy::of_vertices().make_default().interpolate()),
            owner: map.add_attribute(Policy::of_faces().split_copy()),
            fence: map.add_attribute(Policy::of_edges().split_copy()),
            note: map.add_attribute(Policy::of_faces()),
        }
    }

    fn ids(self) -> Ids {
        Ids::new(self.corner, self.parcel)
            .values("height", self.height, f64::to_string, |text| text.parse().ok())
            .values("owner", self.owner, String::clone, |text| Some(text.into()))
            .values("fence", self.fence, u32::to_string, |text| text.parse().ok())
    }

    fn v(self, map: &PlanarMap, id: u64) -> VertexKey {
        map.find(self.corner, &id).unwrap()
    }

    fn f(self, map: &PlanarMap, id: u128) -> FaceKey {
        map.find(self.parcel, &id).unwrap()
    }

    /// All that a map has, by ids.
    fn told(self, map: &PlanarMap) -> Told {
        let id = |v: VertexKey| *map.value(self.corner, v).unwrap();
        let vertices = map.dcel().vertices().map(|v| {
            let p = map[v.key()];
            (id(v.key()), format!("{p:?} {:?}", map.value(self.height, v.key())))
        });
        let edges = map.dcel().edges().map(|h| {
            let ends = [h.origin(), h.target()].map(|v| id(v.key()));
            let features: Vec<FeatureId> = map.features_along(h.key()).unwrap().collect();
            ((ends[0].min(ends[1]), ends[0].max(ends[1])), format!("{features:?} {:?}", map.value(self.fence, h.key())))
        });
        let faces = map.dcel().faces().map(|f| {
            let around: BTreeSet<_> = f.half_edges().map(|h| (id(h.origin().key()), id(h.target().key()))).collect();
            let isolated: BTreeSet<_> = f.inner().filter_map(|b| b.isolated_vertex()).map(|v| id(v.key())).collect();
            let features: Vec<FeatureId> = map.features_of(f.key()).unwrap().collect();
            let owner = map.value(self.owner, f.key());
            (*map.value(self.parcel, f.key()).unwrap(), format!("{around:?} {isolated:?} {features:?} {owner:?}"))
        });
        Told {
            vertices: vertices.collect(),
            edges: edges.collect(),
            faces: faces.collect(),
            features: map.features().count(),
        }
    }
}

#[derive(Debug, PartialEq)]
struct Told {
    vertices: BTreeMap<u64, String>,
    edges: BTreeMap<(u64, u64), String>,
    faces: BTreeMap<u128, String>,
    features: usize,
}

/// Runs a program, and after each edit gives values to records that the number of the edit chooses.
fn edited(map: PlanarMap, by: Named, program: &EditProgram) -> PlanarMap {
    let mut runner = EditRunner::new(map);
    for (i, op) in program.0.iter().enumerate() {
        runner.step(op);
        let mut map = runner.into_map();
        let nth = |count: usize| i * 7 % count.max(1);
        let face = map.dcel().faces().map(Face::key).nth(nth(map.dcel().face_count())).unwrap();
        map.set_value(by.owner, face, format!("owner {i}")).unwrap();
        let edge = map.dcel().edges().map(HalfEdge::key).nth(nth(map.dcel().edge_count()));
        if let Some(h) = edge {
            map.set_value(by.fence, h, u32::try_from(i).unwrap()).unwrap();
        }
        runner = EditRunner::new(map);
    }
    runner.into_map()
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
        // It is undone and redone as any other change.
        history.undo();
        assert!(*history.get() == a);
        assert_eq!(by.told(history.get()), by.told(&a));
        history.redo();
        assert_eq!(by.told(history.get()), by.told(&b));
        // And back again.
        let mut map = history.into_map();
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
        assert_eq!(by.told(&merge(&base, ours, ours, &ids).unwrap()).faces, by.told(ours).faces);
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

/// Two squares beside each other: vertices 1 2 3 4, 5 6, faces 1 and 2.
///
/// ```text
///     4 ── 3 ── 6      y = 4
///     │ 1  │ 2  │
///     1 ── 2 ── 5      y = 0
/// ```
fn two_squares() -> (PlanarMap, Named) {
    let mut map = PlanarMap::new();
    let by = Named::of(&mut map);
    let square = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]).unwrap();
    let [.., b, c, _] = square.vertices[..] else { unreachable!() };
    let [d, e] = [[8.0, 0.0], [8.0, 4.0]].map(|p| map.insert_point(p).unwrap().vertices[0]);
    for (from, to) in [(b, d), (d, e), (e, c)] {
        map.insert_segment(from, to).unwrap();
    }
    map.add_feature(Some("wood".into()));
    assert_eq!(by.told(&map).faces.keys().collect::<Vec<_>>(), [&0, &1, &2]);
    (map, by)
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

fn draw(map: &mut PlanarMap, by: Named, from: u64, to: u64) {
    map.insert_segment(by.v(map, from), by.v(map, to)).unwrap();
}

fn erase(map: &mut PlanarMap, by: Named, from: u64, to: u64) {
    let (from, to) = (by.v(map, from), by.v(map, to));
    let h = map.dcel().vertex(from).unwrap().rotation().find(|h| h.target().key() == to).unwrap().key();
    map.remove_edge(h).unwrap();
}

#[test]
fn vertices_that_change_places_are_drawn_anew_and_keep_what_they_have() {
    let (mut a, by) = two_squares();
    let w = a.insert_point([9.0, 1.0]).unwrap().vertices[0];
    let fence = a.dcel().vertex(by.v(&a, 5)).unwrap().leaving().unwrap().key();
    a.set_value(by.fence, fence, 6).unwrap();
    a.set_value(by.note, by.f(&a, 2), 5).unwrap();
    let wood = a.feature(0);
    a.set_features_of(by.f(&a, 2), wood).unwrap();
    a.set_features_along(fence, wood).unwrap();
    let mut b = a.clone();
    // Corner 5 goes through the place of vertex 7, which then is where the corner was.
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
fn edges_and_faces_that_one_side_drops_are_conflicts_with_what_the_other_does_to_them() {
    let erased = |map: &mut PlanarMap, by: Named| erase(map, by, 2, 3);
    let fenced = |map: &mut PlanarMap, by: Named| {
        let h = map.dcel().vertex(by.v(map, 2)).unwrap().rotation().find(|h| h.target().key() == by.v(map, 3));
        map.set_value(by.fence, h.unwrap().key(), 4).unwrap();
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
    let covered = |map: &mut PlanarMap, by: Named| {
        let lake = map.add_feature(Some("lake".into()));
        map.set_features_of(by.f(map, 1), [lake]).unwrap();
    };
    assert_eq!(conflicts(covered, covered), ["ours: face 1 features: [] -> [1], theirs: face 1 features: [] -> [2]"]);
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
fn records_that_both_sides_make_with_one_id_are_a_conflict() {
    let (base, by) = two_squares();
    let numbered = |p: [f64; 2]| {
        let mut map = base.clone();
        let v = map.insert_point(p).unwrap().vertices[0];
        map.set_value(by.corner, v, 50).unwrap();
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
    // Vertices 7 and 8: one side counts on from the other.
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

    // One side joins the square in the middle to that on the left, the other one to that on the right.
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

#[test]
fn maps_without_ids_are_refused() {
    let (map, by) = two_squares();
    let without = |change: &dyn Fn(&mut PlanarMap) -> Result<bool, EditError>| {
        let mut other = map.clone();
        assert_eq!(change(&mut other), Ok(true));
        diff(&map, &other, &by.ids()).unwrap_err()
    };
    let (v, f) = (by.v(&map, 1), by.f(&map, 1));
    assert_eq!(without(&|map| Ok(map.set_value(by.corner, v, None)?.is_some())), DiffError::VertexWithoutId(v));
    assert_eq!(without(&|map| Ok(map.set_value(by.parcel, f, None)?.is_some())), DiffError::FaceWithoutId(f));
    assert_eq!(without(&|map| Ok(map.set_value(by.corner, v, 2)?.is_some())), DiffError::SameId(Record::Vertex(2)));
    assert_eq!(without(&|map| Ok(map.set_value(by.parcel, f, 2)?.is_some())), DiffError::SameId(Record::Face(2)));
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
    // Faces that are not as the drawing has them.
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
    // The ids of the two faces change places, so each is drawn where the other one was.
    let mut b = a.clone();
    let faces = [1, 2].map(|face| by.f(&a, face));
    for (face, id) in [(faces[0], 2), (faces[1], 1)] {
        b.set_value(by.parcel, face, id).unwrap();
    }
    diff(&a, &b, &by.ids()).unwrap().apply(&mut a, &by.ids()).unwrap();
    assert_eq!([by.f(&a, 1), by.f(&a, 2)], [faces[1], faces[0]]);
    assert_eq!([1, 2].map(|face| a.value(by.note, by.f(&a, face))), [Some(&1), Some(&2)]);
    // A dropped face takes its value along.
    let mut c = a.clone();
    erase(&mut c, by, 2, 3);
    let found = diff(&a, &c, &by.ids()).unwrap();
    assert!(found.changes().iter().any(|(_, change)| matches!(change, Change::Reshaped(_))), "{found}");
    found.apply(&mut a, &by.ids()).unwrap();
    assert_eq!(a.values(by.note).unwrap().len(), 1);
}

/// Maps that were loaded are other maps than those that were saved: their attributes are added, and then their values.
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
