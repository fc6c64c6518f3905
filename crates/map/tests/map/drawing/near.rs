//! Local validation of a drawing. The verdict equals a full validation after every edit, after every operator with every
//! argument, and after every corruption of one link or point; and only changes are read.

use crate::support::changes::{difference, note};
use crate::support::drawn::validate_embedding;
use crate::support::drawn::{moved_inner, points_of};
use crate::support::edits::EvenEdits;
use quickcheck::{Arbitrary, Gen};
use std::cell::Cell;
use twinedge::dcel::{Corner, Dcel, Side, Split, Turn};
use twinedge::delegate_view;
use twinedge::validate::near::WriteSet;
use twinedge::validate::{BoundaryPlace, Collect, Expectation, Parts, Rule, Table, View};
use twinedge_geometry::Point;
use twinedge_map::near::{EmbeddingBaseline, validate_embedding_near};
use twinedge_map::program::{EditOp, EditOutcome, EditProgram, EditRunner};
use twinedge_map::{Embedding, PlanarMap};
use twinedge_trials::enumerate::for_each_corruption;

const PLANE: Expectation = Expectation::plane();

/// A structure with coordinates that counts reads of points.
struct Scene {
    table: Table,
    points: Vec<Point>,
    /// The only bend, with the smaller half-edge of its edge.
    bend: Option<(usize, Point)>,
    asked: Cell<usize>,
}

impl View for Scene {
    delegate_view!(|this| &this.table);
}

impl Embedding for Scene {
    fn point(&self, vertex: usize) -> Point {
        self.asked.set(self.asked.get() + 1);
        self.points.get(vertex).copied().unwrap_or_default()
    }

    fn bends(&self, half_edge: usize) -> usize {
        usize::from(self.bend.is_some_and(|(h, _)| h == half_edge))
    }

    fn bend(&self, _: usize, _: usize) -> Point {
        self.bend.unwrap().1
    }
}

impl Scene {
    fn new(table: Table, points: Vec<Point>) -> Self {
        Self { table, points, bend: None, asked: Cell::new(0) }
    }

    fn of(map: &PlanarMap) -> Self {
        Self::new(Table::copy_of(map.dcel()).unwrap(), points_of(map))
    }

    fn baseline(&self) -> EmbeddingBaseline {
        EmbeddingBaseline::new(self, &PLANE).unwrap()
    }

    /// All records that differ from an earlier scene, and the moved vertices.
    fn since(&self, before: &Self) -> WriteSet {
        let mut written = difference(&before.table, &self.table);
        let moved = |v: &usize| {
            let [was, is] = [before, self].map(|scene| scene.points.get(*v).copied());
            self.table.is_vertex(*v) && was != is
        };
        written.vertices.extend((0..self.table.vertex_slots()).filter(moved));
        written
    }
}

/// Counts of verdicts.
#[derive(Default, Debug)]
struct Tally {
    judged: usize,
    right: usize,
    /// The number of violations of each geometric rule and of T1 … T4.
    broken: [usize; 9],
    /// The number of full validations of valid structures.
    in_full: usize,
}

const COUNTED: [Rule; 9] = [Rule::T1, Rule::T2, Rule::T3, Rule::T4, Rule::G1, Rule::G2, Rule::G3, Rule::G4, Rule::G5];

impl Tally {
    /// Asserts that the verdict equals a full validation. The baseline advances if the scene is valid.
    fn judge(&mut self, baseline: &mut EmbeddingBaseline, scene: &Scene, written: &WriteSet) -> bool {
        scene.asked.set(0);
        let found = validate_embedding_near(baseline, scene, written);
        let asked = scene.asked.get();
        let full = || validate_embedding(scene, &PLANE, Collect::All);
        self.judged += 1;
        let Err(found) = found else {
            let report = full();
            assert!(report.is_valid(), "{}\n{:?}\n{written:?}\n{report}", scene.table, scene.points);
            self.right += 1;
            // A full validation reads all points, and once more for the new baseline.
            self.in_full += usize::from(asked > scene.table.vertices.iter().flatten().count());
            return true;
        };
        for (count, rule) in self.broken.iter_mut().zip(COUNTED) {
            *count += usize::from(found.broken_rules().any(|broken| broken == rule));
        }
        // It must equal the report of a full validation, which is rarely run a second time.
        let is_same = !self.judged.is_multiple_of(16) || *found == full();
        assert!(!found.is_valid() && is_same, "{}\n{:?}\n{written:?}", scene.table, scene.points);
        false
    }
}

/// A deterministic generator.
fn seeded(seed: u64, size: usize) -> Gen {
    Gen::from_size_and_seed(size, seed)
}

/// Visits each state of a map during a program, with the state before it.
fn each_edit(program: &EditProgram, mut visit: impl FnMut(&PlanarMap, &PlanarMap)) {
    each_edit_of(program, |_, before, after| visit(before, after));
}

fn each_edit_of(program: &EditProgram, mut visit: impl FnMut(&EditOp, &PlanarMap, &PlanarMap)) {
    let mut runner = EditRunner::new(PlanarMap::new());
    for op in &program.0 {
        let before = runner.map().clone();
        if let EditOutcome::Applied(_) = runner.step(op) {
            visit(op, &before, runner.map());
        }
    }
}

fn programs() -> impl Iterator<Item = EditProgram> {
    (0..150).map(|seed| EvenEdits::arbitrary(&mut seeded(seed, 40)).0)
}

#[test]
fn one_baseline_follows_whole_programs() {
    let mut tally = Tally::default();
    for program in programs() {
        let mut baseline = EmbeddingBaseline::new(&PlanarMap::new(), &PLANE).unwrap();
        each_edit_of(&program, |op, before, after| {
            let (before, after) = (Scene::of(before), Scene::of(after));
            let in_full = tally.in_full;
            assert!(tally.judge(&mut baseline, &after, &after.since(&before)));
            // Rerouted edges merge faces and split them again.
            let reroutes = matches!(op, EditOp::InsertSegmentSnapped { .. });
            assert!(tally.in_full == in_full || reroutes, "{op} of {program}");
        });
    }
    assert!(tally.judged > 1_000 && tally.in_full * 100 < tally.judged, "{tally:?}");
}

/// Several edits at once, and back again.
#[test]
fn one_baseline_follows_many_edits_at_once() {
    let mut tally = Tally::default();
    for program in programs() {
        let mut scenes = vec![Scene::of(&PlanarMap::new())];
        each_edit(&program, |_, after| scenes.push(Scene::of(after)));
        for stride in [2, 3, 7] {
            let mut baseline = scenes[0].baseline();
            let there: Vec<&Scene> = scenes.iter().step_by(stride).collect();
            let back = there.iter().rev().skip(1);
            for pair in there.iter().chain(back).collect::<Vec<_>>().windows(2) {
                assert!(tally.judge(&mut baseline, pair[1], &pair[1].since(pair[0])));
            }
        }
    }
    assert!(tally.judged > 1_000, "{tally:?}");
    // The changed records do not always determine the nesting.
    assert!(tally.in_full * 20 < tally.judged, "{tally:?}");
}

/// Places for a vertex: other vertices, midpoints, a grid, and invalid ones.
fn places(scene: &Scene) -> Vec<Point> {
    let mut places: Vec<Point> = (0..8).map(|i| Point::new(f64::from(i * 5 % 16), f64::from(i * 3 % 16))).collect();
    let live: Vec<usize> = (0..scene.points.len()).filter(|v| scene.table.is_vertex(*v)).collect();
    places.extend(live.iter().map(|v| scene.points[*v]));
    let table = &scene.table;
    for h in (0..table.half_edge_slots()).step_by(2).filter(|h| table.is_half_edge(*h)) {
        let [a, b] = [table.origin(h), table.origin(h + 1)].map(|v| scene.points[v.unwrap()]);
        places.push(Point::new(f64::midpoint(a.x, b.x), f64::midpoint(a.y, b.y)));
    }
    places.extend([[f64::NAN, 0.0], [f64::INFINITY, 1.0], [1e-300, 0.0]].map(Point::from));
    places
}

#[test]
fn every_edit_with_every_vertex_elsewhere() {
    let mut tally = Tally::default();
    for program in programs().take(20) {
        each_edit(&program, |before, after| {
            let (before, mut after) = (Scene::of(before), Scene::of(after));
            let by_operator = after.since(&before);
            let baseline = before.baseline();
            for v in (0..after.points.len()).filter(|v| after.table.is_vertex(*v)).collect::<Vec<_>>() {
                let was = after.points[v];
                for place in places(&after) {
                    after.points[v] = place;
                    let mut written = by_operator.clone();
                    written.vertices.push(v);
                    tally.judge(&mut baseline.clone(), &after, &written);
                }
                after.points[v] = was;
            }
        });
    }
    assert!(tally.judged > 30_000 && tally.right > 3_000, "{tally:?}");
    assert!(tally.broken[4..].iter().all(|count| *count > 20), "{tally:?}");
    assert_eq!(tally.in_full, 0, "{tally:?}");
}

#[test]
fn every_edit_with_every_wrong_link() {
    let mut tally = Tally::default();
    for program in programs().take(14) {
        each_edit(&program, |before, after| {
            if after.dcel().edge_count() > 8 {
                return;
            }
            let (before, mut after) = (Scene::of(before), Scene::of(after));
            let by_operator = after.since(&before);
            let baseline = before.baseline();
            let points = after.points.clone();
            for_each_corruption(&mut after.table, Parts::ALL, |corrupt, cell, _| {
                let mut written = by_operator.clone();
                note(&mut written, cell);
                tally.judge(&mut baseline.clone(), &Scene::new(corrupt.clone(), points.clone()), &written);
            });
        });
    }
    assert!(tally.judged > 40_000 && tally.right * 20 < tally.judged, "{tally:?}");
}

/// The results of topological operators with every argument: most of them do not match the drawing.
fn each_operator(dcel: &Dcel, visit: impl FnMut(&Dcel)) {
    some_operators(dcel, &mut || true, visit);
}

/// The results of a selection of operators; others are not applied.
fn some_operators(dcel: &Dcel, choose: &mut dyn FnMut() -> bool, mut visit: impl FnMut(&Dcel)) {
    let mut attempt = |operator: &dyn Fn(&mut Dcel) -> bool| {
        if !choose() {
            return;
        }
        let mut changed = dcel.clone();
        if operator(&mut changed) {
            visit(&changed);
        }
    };
    let half_edges: Vec<_> = dcel.half_edges().map(|h| h.key()).collect();
    let faces: Vec<_> = dcel.faces().map(|f| f.key()).collect();
    let isolated: Vec<_> = dcel.boundaries().filter_map(|b| b.isolated_vertex()).map(|v| v.key()).collect();
    let corners: Vec<Corner> =
        half_edges.iter().map(|h| Corner::At(*h)).chain(isolated.iter().map(|v| Corner::Isolated(*v))).collect();
    let starts: Vec<_> = dcel.boundaries().filter(|b| !b.is_outer()).map(|b| b.key()).collect();
    for from in &corners {
        for to in &corners {
            for new_face in [Side::Left, Side::Right] {
                for inner in [&[][..], &starts, &starts[..starts.len() / 2], &starts[starts.len() / 2..]] {
                    attempt(&|dcel| dcel.connect(*from, *to, Split { new_face, inner }).is_ok());
                }
            }
        }
    }
    for h in &half_edges {
        attempt(&|dcel| dcel.remove_edge(*h).is_ok());
        attempt(&|dcel| dcel.split_edge(*h).is_ok());
        attempt(&|dcel| dcel.join_edges(*h).is_ok());
        attempt(&|dcel| dcel.contract_edge(*h).is_ok());
        attempt(&|dcel| dcel.flip_edge(*h, Turn::CounterClockwise).is_ok());
        attempt(&|dcel| dcel.flip_edge(*h, Turn::Clockwise).is_ok());
    }
    for face in &faces {
        attempt(&|dcel| dcel.add_isolated_vertex(*face).is_ok());
        for start in &starts {
            attempt(&|dcel| dcel.move_inner(*start, *face).is_ok());
        }
    }
    for v in &isolated {
        attempt(&|dcel| dcel.remove_isolated_vertex(*v).is_ok());
    }
}

/// A new vertex gets one of several places.
fn drawn(dcel: &Dcel, before: &Scene, mut visit: impl FnMut(&mut Scene)) {
    let mut scene = Scene::new(Table::copy_of(dcel).unwrap(), before.points.clone());
    scene.points.resize(scene.table.vertex_slots(), Point::default());
    let new = (0..scene.points.len()).find(|v| scene.table.is_vertex(*v) && !before.table.is_vertex(*v));
    let Some(v) = new else {
        return visit(&mut scene);
    };
    for place in places(before) {
        scene.points[v] = place;
        visit(&mut scene);
    }
}

#[test]
fn every_operator_with_every_argument() {
    let mut tally = Tally::default();
    for program in programs().take(24) {
        let mut maps = vec![];
        each_edit(&program, |_, after| maps.push(after.clone()));
        for map in maps.iter().filter(|map| (3..12).contains(&map.dcel().edge_count())).step_by(3) {
            let before = Scene::of(map);
            let baseline = before.baseline();
            each_operator(map.dcel(), |dcel| {
                drawn(dcel, &before, |after| {
                    let written = after.since(&before);
                    tally.judge(&mut baseline.clone(), after, &written);
                });
            });
        }
    }
    assert!(tally.judged > 50_000 && tally.right > 1_000, "{tally:?}");
    assert!(tally.broken[5..].iter().all(|count| *count > 20), "{tally:?}");
    assert!(tally.in_full * 100 < tally.right, "{tally:?}");
}

/// Returns true once in `count` calls.
fn one_in(count: usize) -> impl FnMut() -> bool {
    let mut number = 0_usize;
    move || {
        number += 1;
        number.is_multiple_of(count)
    }
}

/// Some pairs of operators, the second applied to the result of the first, judged at once.
#[test]
fn pairs_of_operators() {
    let mut tally = Tally::default();
    let (mut is_first, mut is_second) = (one_in(67), one_in(61));
    for program in programs().take(40) {
        let mut maps = vec![];
        each_edit(&program, |_, after| maps.push(after.clone()));
        for map in maps.iter().filter(|map| (3..12).contains(&map.dcel().edge_count())).step_by(4) {
            let before = Scene::of(map);
            let baseline = before.baseline();
            some_operators(map.dcel(), &mut is_first, |first| {
                some_operators(first, &mut is_second, |second| {
                    drawn(second, &before, |after| {
                        let written = after.since(&before);
                        tally.judge(&mut baseline.clone(), after, &written);
                    });
                });
            });
        }
    }
    assert!(tally.judged > 20_000 && tally.right > 100, "{tally:?}");
    assert!(tally.in_full * 20 < tally.right, "{tally:?}");
}

/// Exchanges two boundary components of different faces, or of different kinds, in their lists. All rules from R1 to F2 hold.
fn exchanged(table: &Table, one: usize, other: usize) -> Option<Table> {
    let mut table = table.clone();
    let [a, b] = [one, other].map(|b| table.boundaries.get(b).copied().flatten());
    let (a, b) = (a?, b?);
    for (label, row) in [(one, &b), (other, &a)] {
        let face = table.faces[row.face?].as_mut()?;
        match row.place? {
            BoundaryPlace::Outer => face.outer = Some(label),
            BoundaryPlace::Inner(i) => face.inner[i] = Some(label),
        }
        let own = table.boundaries[label].as_mut()?;
        (own.face, own.place) = (row.face, row.place);
    }
    Some(table)
}

/// The part of topology that geometry proves: T1 and T2 for each component.
#[test]
fn boundary_components_in_the_place_of_others() {
    let mut tally = Tally::default();
    for program in programs() {
        each_edit(&program, |before, after| {
            let (before, after) = (Scene::of(before), Scene::of(after));
            let baseline = before.baseline();
            let labels = after.table.boundary_slots();
            for one in 0..labels {
                for other in one + 1..labels {
                    let Some(table) = exchanged(&after.table, one, other) else { continue };
                    let scene = Scene::new(table, after.points.clone());
                    tally.judge(&mut baseline.clone(), &scene, &scene.since(&before));
                }
            }
        });
    }
    assert!(tally.judged > 4_000 && tally.right > 100, "{tally:?}");
    assert!(tally.broken[..2].iter().all(|count| *count > 10), "{tally:?}");
}

/// A segment splits a face, or is removed, so that two faces merge, and two of the islands are listed in arbitrary faces,
/// including islands inside discs, whose faces the segment does not meet.
#[test]
fn islands_listed_in_any_face_after_one_is_split_or_two_are_merged() {
    let mut tally = Tally::default();
    let mut map = PlanarMap::new();
    let ring = |[x, y]: [f64; 2], [width, height]: [f64; 2]| {
        [[x, y], [x + width, y], [x + width, y + height], [x, y + height]]
    };
    map.insert_ring(ring([0.0, 0.0], [20.0, 10.0])).unwrap();
    for x in [2.0, 12.0] {
        map.insert_ring(ring([x, 2.0], [5.0, 5.0])).unwrap();
        map.insert_point([x + 2.0, 4.0]).unwrap();
        map.insert_point([x + 2.0, 9.0]).unwrap();
    }
    let whole = map;
    for x in [1.0, 10.0, 19.0] {
        let mut split = whole.clone();
        split.insert_segment([x, 0.0], [x, 10.0]).unwrap();
        for (before, after) in [(&whole, &split), (&split, &whole)] {
            let (before, after) = (Scene::of(before), Scene::of(after));
            let baseline = before.baseline();
            let (labels, faces) = (after.table.boundary_slots(), after.table.face_slots());
            for (one, f) in (0..labels).flat_map(|b| (0..faces).map(move |f| (b, f))) {
                let Some(table) = moved_inner(&after.table, one, f) else { continue };
                for (other, f) in (0..labels).flat_map(|b| (0..faces).map(move |f| (b, f))) {
                    let Some(table) = moved_inner(&table, other, f) else { continue };
                    let scene = Scene::new(table, after.points.clone());
                    tally.judge(&mut baseline.clone(), &scene, &scene.since(&before));
                }
            }
        }
    }
    assert!(tally.judged > 4_000 && tally.right > 100 && tally.broken[8] > 2_000, "{tally:?}");
}

/// Moves a bounded face to a new slot after all others.
fn renumbered(table: &Table, f: usize) -> Option<Table> {
    let mut table = table.clone();
    let row = table.faces.get_mut(f)?.take_if(|row| row.outer.is_some())?;
    let number = table.faces.len();
    table.faces.push(Some(row));
    for boundary in table.boundaries.iter_mut().flatten().filter(|boundary| boundary.face == Some(f)) {
        boundary.face = Some(number);
    }
    Some(table)
}

/// Moves a boundary component to a new slot after all others.
fn relabelled(table: &Table, b: usize) -> Option<Table> {
    let mut table = table.clone();
    let row = table.boundaries.get_mut(b)?.take()?;
    let number = table.boundaries.len();
    table.boundaries.push(Some(row));
    let of_half_edges = table.half_edges.iter_mut().flatten().map(|h| &mut h.boundary);
    let of_vertices = table.vertices.iter_mut().flatten().map(|v| &mut v.isolated);
    let of_faces = table.faces.iter_mut().flatten().flat_map(|f| f.inner.iter_mut().chain([&mut f.outer]));
    for link in of_half_edges.chain(of_vertices).chain(of_faces).filter(|link| **link == Some(b)) {
        *link = Some(number);
    }
    Some(table)
}

/// A ring is drawn around an island, or removed, and the boundary components of a dropped face went to several faces. The point
/// on the island is listed in an arbitrary face: a partial check cannot determine the winding around the rest of that face.
#[test]
fn an_island_listed_in_any_face_after_one_is_no_more() {
    let mut tally = Tally::default();
    let ring = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
    let mut plain = PlanarMap::new();
    plain.insert_ring(ring(0.0, 9.0)).unwrap();
    plain.insert_ring(ring(3.0, 6.0)).unwrap();
    plain.insert_point([4.0, 4.0]).unwrap();
    let mut ringed = plain.clone();
    ringed.insert_ring(ring(2.0, 7.0)).unwrap();
    for (before, after) in [(&plain, &ringed), (&ringed, &plain)] {
        let (before, after) = (Scene::of(before), Scene::of(after));
        let (labels, faces) = (after.table.boundary_slots(), after.table.face_slots());
        let once: Vec<Table> = (0..faces).filter_map(|f| renumbered(&after.table, f)).collect();
        let twice = once.iter().flat_map(|table| (0..faces).filter_map(|f| renumbered(table, f)));
        let tables = once.iter().cloned().chain(twice);
        for (table, b) in tables.flat_map(|table| (0..labels).map(move |b| (table.clone(), b))) {
            for f in 0..table.face_slots() {
                let Some(table) = moved_inner(&table, b, f) else { continue };
                for table in [relabelled(&table, b), Some(table)].into_iter().flatten() {
                    let scene = Scene::new(table, after.points.clone());
                    tally.judge(&mut before.baseline(), &scene, &scene.since(&before));
                }
            }
        }
    }
    assert!(tally.judged > 100 && tally.right > 5 && tally.broken[8] > 20, "{tally:?}");
}

/// A map after the insertion of each segment, and the final map.
fn grown(segments: &[[[f64; 2]; 2]]) -> (Vec<Scene>, PlanarMap) {
    let mut map = PlanarMap::new();
    let mut scenes = vec![Scene::of(&map)];
    for [a, b] in segments {
        map.insert_segment(*a, *b).unwrap();
        scenes.push(Scene::of(&map));
    }
    (scenes, map)
}

/// Adds an isolated vertex to the unbounded face, and moves it to a place.
fn with_point(map: &PlanarMap, free: [f64; 2], place: [f64; 2]) -> Scene {
    let mut map = map.clone();
    let v = map.insert_point(free).unwrap().vertices[0];
    let mut scene = Scene::of(&map);
    scene.points[map.dcel().vertex(v).unwrap().index()] = place.into();
    scene
}

/// After a full validation because of unnamed records, the baseline follows from there.
#[test]
fn forgotten_records_are_caught_up_with() {
    let mut tally = Tally::default();
    let (scenes, map) = grown(&[[[0.0, 0.0], [4.0, 0.0]], [[0.0, 2.0], [4.0, 2.0]]]);
    let mut baseline = scenes[1].baseline();
    let vertices = scenes[2].since(&scenes[1]).vertices;
    assert!(tally.judge(&mut baseline, &scenes[2], &WriteSet { vertices, ..WriteSet::default() }));
    assert_eq!(tally.in_full, 1);
    for (place, is_right) in [([2.0, 1.0], true), ([2.0, 2.0], false)] {
        let after = with_point(&map, [2.0, 1.0], place);
        assert_eq!(tally.judge(&mut baseline.clone(), &after, &after.since(&scenes[2])), is_right, "{place:?}");
    }
    assert_eq!(tally.in_full, 1);
}

/// An edge that got a bend, above another one and across it.
#[test]
fn edges_with_bends_are_validated_in_full() {
    let mut tally = Tally::default();
    let (scenes, map) = grown(&[[[0.0, 0.0], [4.0, 0.0]], [[0.0, 2.0], [4.0, 2.0]]]);
    let [before, after] = [1, 2].map(|i| &scenes[i].table);
    let mut slots = 0..after.half_edge_slots();
    let new = slots.find(|h| after.is_half_edge(*h) && !before.is_half_edge(*h)).unwrap();
    for (place, is_right) in [([2.0, 1.0], true), ([2.0, -1.0], false)] {
        let mut after = Scene::of(&map);
        after.bend = Some((new, place.into()));
        assert_eq!(tally.judge(&mut scenes[1].baseline(), &after, &after.since(&scenes[1])), is_right, "{place:?}");
    }
    assert_eq!(tally.in_full, 1);
}

/// After an invalid state, the baseline still describes the state before.
#[test]
fn what_was_wrong_leaves_nothing_behind() {
    let mut tally = Tally::default();
    let (scenes, map) = grown(&[[[0.0, 0.0], [4.0, 0.0]], [[0.0, 2.0], [4.0, 2.0]]]);
    let right = &scenes[2];
    let mut baseline = right.baseline();
    // Both edges crossing, and then an isolated vertex at the old crossing and on both edges.
    let mut wrong = Scene::of(&map);
    wrong.points.swap(1, 3);
    let written = wrong.since(right);
    assert!(!tally.judge(&mut baseline, &wrong, &written), "{:?}", wrong.points);
    for (place, is_right) in [([2.0, 1.0], true), ([2.0, 2.0], false), ([2.0, 0.0], false)] {
        let after = with_point(&map, [2.0, 1.0], place);
        assert_eq!(tally.judge(&mut baseline.clone(), &after, &after.since(right)), is_right, "{place:?}");
    }
    assert_eq!(tally.in_full, 0);
}
