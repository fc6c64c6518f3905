//! Edits validated one by one: the verdict, the recorded writes, and the reads.

use crate::support::changes::difference;
use crate::support::drawn::crossing;
use crate::support::edits::EvenEdits;
use quickcheck::{Arbitrary, Gen};
use std::cell::Cell;
use std::collections::BTreeSet;
use twinedge::dcel::Audited;
use twinedge::delegate_view;
use twinedge::validate::near::BaselineError;
use twinedge::validate::{Expectation, Rule, Table, View};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::edit::EditError;
use twinedge_map::near::{EmbeddingBaseline, validate_embedding_near};
use twinedge_map::program::EditRunner;
use twinedge_map::{Builder, Embedding, PlanarMap};

#[test]
fn an_audited_runner_does_what_another_does() {
    for seed in 0..100 {
        let EvenEdits(program) = EvenEdits::arbitrary(&mut Gen::from_size_and_seed(40, seed));
        // A clone issues the same keys as the original.
        let empty = PlanarMap::new();
        let mut plain = EditRunner::new(empty.clone());
        let mut audited = EditRunner::audited(empty).unwrap();
        for op in &program.0 {
            assert_eq!(plain.step_checked(op), audited.step_checked(op), "{op} of {program}");
        }
        // A clone continues like the original.
        let mut clone = audited.clone();
        for op in &program.0 {
            assert_eq!(clone.step_checked(op), audited.step_checked(op), "{op} of {program}");
        }
        let [clone, original] = [clone, audited].map(EditRunner::into_map);
        let saved = [&clone, &original].map(|map| serde_json::to_value(map).unwrap());
        assert!(clone == original && saved[0] == saved[1], "{program}");
    }
}

fn is_within<T: Ord + Copy>(some: &[T], all: &[T]) -> bool {
    let all: BTreeSet<T> = all.iter().copied().collect();
    some.iter().all(|one| all.contains(one))
}

/// An arbitrary edit.
fn edit(map: &mut PlanarMap, g: &mut Gen) -> Result<(), EditError> {
    let mut number = |most: usize| usize::arbitrary(g) % most.max(1);
    let mut place = || Point::new((number(9) * 2) as f64, (number(9) * 2) as f64);
    let places = [place(), place(), place()];
    let vertex = map.dcel().vertices().nth(number(map.dcel().vertex_count())).map(|v| v.key());
    let edge = map.dcel().half_edges().nth(number(map.dcel().half_edge_count())).map(|h| h.key());
    match (number(9), vertex, edge) {
        (0, Some(v), _) => map.remove_vertex(v).map(|_| ()),
        (1 | 2, _, Some(h)) => map.remove_edge(h).map(|_| ()),
        (3 | 4, Some(v), _) => map.move_vertex(v, places[0]),
        (5, ..) => map.insert_point(places[0]).map(|_| ()),
        (6, ..) => map.insert_ring(places).map(|_| ()),
        (7, ..) => map.insert_segment_snapped(places[0], places[1], Snap::Size(2.0)).map(|_| ()),
        _ => map.insert_segment(places[0], places[1]).map(|_| ()),
    }
}

/// Every changed record and every moved vertex was recorded.
#[test]
fn what_is_written_is_noted() {
    let (mut applied, mut refused) = (0, 0);
    for seed in 0..60 {
        let mut g = Gen::from_size_and_seed(40, seed);
        let mut audited = Audited::new(PlanarMap::new()).unwrap();
        for _ in 0..30 {
            let before = audited.get().clone();
            let outcome = audited.change(|map| edit(map, &mut g)).unwrap();
            let written = audited.written();
            if outcome.is_err() {
                assert!(written.is_empty());
                refused += 1;
                continue;
            }
            applied += 1;
            let rows = |map: &PlanarMap| Table::copy_of(map.dcel()).unwrap();
            let differ = difference(&rows(&before), &rows(audited.get()));
            let listed: Vec<usize> = written.listed.iter().map(|(f, _)| *f).collect();
            assert!(is_within(&differ.vertices, &written.vertices));
            assert!(is_within(&differ.half_edges, &written.half_edges));
            assert!(is_within(&differ.boundaries, &written.boundaries));
            assert!(is_within(&differ.faces, &[written.faces.as_slice(), &listed].concat()));
            let moved =
                |v: &usize| before.dcel().vertex_at(*v).is_some() && before.point(*v) != audited.get().point(*v);
            let moved: Vec<usize> = (0..before.vertex_slots()).filter(moved).collect();
            assert!(is_within(&moved, &written.vertices));
        }
        assert!(audited.into_inner().validate().is_valid());
    }
    assert!(applied > 800 && refused > 100, "{applied}, {refused}");
}

#[test]
fn another_map_in_its_place_is_validated_in_full() {
    assert!(matches!(Audited::new(crossing()), Err(BaselineError::Invalid(_))));
    let mut audited = Audited::new(PlanarMap::new()).unwrap();
    audited.change(|map| map.insert_segment([0.0, 0.0], [1.0, 0.0])).unwrap().unwrap();
    for _ in 0..2 {
        let report = audited.change(|map| *map = crossing()).unwrap_err();
        assert_eq!(report.broken_rules().collect::<Vec<_>>(), [Rule::G4]);
        // It stays invalid until it is fixed.
        assert_eq!(audited.change(|_| ()), Err(report));
    }
    let mut other = PlanarMap::new();
    other.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]]).unwrap();
    audited.change(|map| *map = other).unwrap();
    audited.change(|map| map.insert_point([1.0, 1.0])).unwrap().unwrap();
    assert!(!audited.written().is_empty());
}

/// Two maps are swapped, each with the log of its own edits.
#[test]
fn audited_maps_that_change_places_are_validated_in_full() {
    let mut one = Audited::new(PlanarMap::new()).unwrap();
    let mut other = Audited::new(PlanarMap::new()).unwrap();
    one.change(|map| map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])).unwrap().unwrap();
    one.change(|a| other.change(|b| core::mem::swap(a, b)).unwrap()).unwrap();
    assert_eq!((one.get().dcel().edge_count(), other.get().dcel().edge_count()), (0, 3));
    for audited in [&mut one, &mut other] {
        audited.change(|map| map.insert_segment([0.0, 0.0], [1.0, 1.0])).unwrap().unwrap();
        assert!(audited.get().validate().is_valid());
    }
}

/// A map that counts its reads.
struct Asked<'a> {
    map: &'a PlanarMap,
    questions: Cell<usize>,
}

impl Asked<'_> {
    fn count(&self) -> &PlanarMap {
        self.questions.set(self.questions.get() + 1);
        self.map
    }
}

impl View for Asked<'_> {
    delegate_view!(|this| this.count());
}

impl Embedding for Asked<'_> {
    fn point(&self, vertex: usize) -> Point {
        self.count().point(vertex)
    }
}

/// Islands in a row, each a square of side 2 with a square of side 1 in it, in a large frame.
fn islands(count: usize) -> PlanarMap {
    let mut builder = Builder::new();
    let mut ring = |x: f64, y: f64, width: f64, height: f64| {
        let corners = [[x, y], [x + width, y], [x + width, y + height], [x, y + height]];
        for i in 0..4 {
            builder.segment(corners[i], corners[(i + 1) % 4]).unwrap();
        }
    };
    for i in 0..count {
        let x = 4.0 * i as f64;
        ring(x, 0.0, 2.0, 2.0);
        ring(x + 0.5, 0.5, 1.0, 1.0);
    }
    ring(-10.0, -10.0, 4.0 * count as f64 + 20.0, 20.0);
    builder.build().unwrap()
}

/// The number of reads does not grow with the map, nor with the number of islands in the changed face.
#[test]
fn what_is_asked_depends_on_the_edit_only() {
    type Edit = fn(&mut PlanarMap, f64);
    let edits: [(&str, Edit); 9] = [
        ("insert_point in a face", |map, x| drop(map.insert_point([x + 3.0, 1.0]).unwrap())),
        ("insert_point on an edge", |map, x| drop(map.insert_point([x + 1.0, 0.0]).unwrap())),
        ("insert_point on the frame", |map, x| drop(map.insert_point([x, -10.0]).unwrap())),
        ("insert_segment, a bridge", |map, x| drop(map.insert_segment([x + 2.0, 1.0], [x + 4.0, 1.0]).unwrap())),
        ("insert_segment, across an island", |map, x| {
            drop(map.insert_segment([x + 0.25, 0.0], [x + 0.25, 2.0]).unwrap());
        }),
        ("insert_ring around an island", |map, x| {
            let ring = [[x - 1.0, -1.0], [x + 3.0, -1.0], [x + 3.0, 3.0], [x - 1.0, 3.0]];
            drop(map.insert_ring(ring).unwrap());
        }),
        ("remove_edge of an island", |map, x| {
            let v = map.insert_point([x, 0.0]).unwrap().vertices[0];
            let h = map.dcel().vertex(v).unwrap().leaving().unwrap().key();
            drop(map.remove_edge(h).unwrap());
        }),
        ("move_vertex", |map, x| {
            let v = map.insert_point([x, 0.0]).unwrap().vertices[0];
            map.move_vertex(v, [x - 0.5, -0.5]).unwrap();
        }),
        ("remove_vertex", |map, x| {
            let v = map.insert_point([x, 0.0]).unwrap().vertices[0];
            drop(map.remove_vertex(v).unwrap());
        }),
    ];
    for (name, edit) in edits {
        let asked = [8, 800].map(|count| {
            let mut audited = Audited::new(islands(count)).unwrap();
            let mut baseline = EmbeddingBaseline::new(audited.get(), &Expectation::plane()).unwrap();
            audited.change(|map| edit(map, 4.0 * (count / 2) as f64)).unwrap();
            let asked = Asked { map: audited.get(), questions: Cell::new(0) };
            validate_embedding_near(&mut baseline, &asked, audited.written()).unwrap();
            asked.questions.get()
        });
        assert!(asked[1] <= asked[0] + 8 && asked[1] < 2_500, "{name}: {asked:?}");
    }
}
