//! Targets that edit maps with coordinates.

#[path = "../../tests/map/edit/follow.rs"]
mod follow;

use arbitrary::Unstructured;
use follow::Shadow;
use std::collections::BTreeSet;
use twinedge::dcel::{Boundary, Face, FaceKey, HalfEdge, HalfEdgeKey, Vertex, VertexKey};
use twinedge::geometry::Point;
use twinedge::geometry::noding::Snap;
use twinedge::geometry::predicates::in_range;
use twinedge::map::edit::{At, EditError, Edited};
use twinedge::map::{Builder, FeatureId, LocateError, Located, Locator, PlanarMap, Shape};
use twinedge::program::choose::Choose;

/// Longer programs are cut: each edit is followed by looks at the whole map.
const LONGEST: usize = 60;

/// After so many edits the map is compared with one that is built at once.
const PERIOD: usize = 4;

type Bits = [u64; 2];

/// A coordinate: mostly of a small grid, where points coincide and segments cross; else close to it, or any bits at all.
fn coordinate(source: &mut Unstructured<'_>) -> f64 {
    let grid = Choose::choose(source, 8) as f64;
    match Choose::choose(source, 32) {
        0 => f64::from_bits(source.arbitrary().unwrap_or_default()),
        1 => grid.next_up(),
        2 => grid.next_down(),
        3 => grid / 3.0,
        4 => grid * 2.0_f64.powi(495),
        5 => grid * 2.0_f64.powi(-399),
        6 => -grid,
        7 => grid + 0.5,
        _ => grid,
    }
}

fn point(source: &mut Unstructured<'_>) -> Point {
    Point::new(coordinate(source), coordinate(source))
}

/// The keys that there are, and some that were.
#[derive(Default)]
struct Keys {
    vertices: Vec<VertexKey>,
    half_edges: Vec<HalfEdgeKey>,
    faces: Vec<FaceKey>,
}

impl Keys {
    fn of(map: &PlanarMap) -> Self {
        let dcel = map.dcel();
        Self {
            vertices: dcel.vertices().map(Vertex::key).collect(),
            half_edges: dcel.half_edges().map(HalfEdge::key).collect(),
            faces: dcel.faces().map(Face::key).collect(),
        }
    }
}

fn pick<K: Copy>(source: &mut Unstructured<'_>, keys: &[K]) -> Option<K> {
    let place = Choose::choose(source, keys.len());
    keys.get(place).copied()
}

fn at(source: &mut Unstructured<'_>, keys: &Keys) -> At {
    match Choose::choose(source, 4) {
        0 => pick(source, &keys.vertices).map_or_else(|| point(source).into(), At::Vertex),
        1 => {
            let p = point(source);
            pick(source, &keys.half_edges).map_or(At::Point(p), |hint| At::Near(p, hint))
        }
        _ => point(source).into(),
    }
}

fn snap(source: &mut Unstructured<'_>) -> Snap {
    match Choose::choose(source, 6) {
        0 => Snap::Auto,
        1 => Snap::Size(0.25),
        2 => Snap::Size(f64::from_bits(source.arbitrary().unwrap_or_default())),
        _ => Snap::Size(1.0),
    }
}

fn features(source: &mut Unstructured<'_>) -> Vec<FeatureId> {
    let mut map = PlanarMap::new();
    let all: Vec<FeatureId> = (0..5).map(|_| map.add_feature(None)).collect();
    (0..Choose::choose(source, 4)).filter_map(|_| pick(source, &all)).collect()
}

/// What came of an edit; none if it said nothing but that it was done.
type Outcome = Result<Option<Edited>, EditError>;

fn edit(source: &mut Unstructured<'_>, map: &mut PlanarMap, keys: &Keys) -> Outcome {
    let done = |outcome: Result<(), EditError>| outcome.map(|()| None);
    match Choose::choose(source, 16) {
        0 | 1 => map.insert_point(at(source, keys)).map(Some),
        2..6 => map.insert_segment(at(source, keys), at(source, keys)).map(Some),
        6..8 => {
            let (from, to) = (at(source, keys), at(source, keys));
            map.insert_segment_snapped(from, to, snap(source)).map(Some)
        }
        8 | 9 => {
            let ring: Vec<At> = (0..Choose::choose(source, 7)).map(|_| at(source, keys)).collect();
            map.insert_ring(ring).map(Some)
        }
        10 | 11 => pick(source, &keys.half_edges).map_or(Ok(None), |h| map.remove_edge(h).map(Some)),
        12 => pick(source, &keys.vertices).map_or(Ok(None), |v| map.remove_vertex(v).map(Some)),
        13 => pick(source, &keys.vertices).map_or(Ok(None), |v| done(map.move_vertex(v, point(source)))),
        14 => pick(source, &keys.faces).map_or(Ok(None), |f| done(map.set_features_of(f, features(source)))),
        _ => pick(source, &keys.half_edges).map_or(Ok(None), |h| done(map.set_features_along(h, features(source)))),
    }
}

/// A program of edits, with points on a small grid, close to it and anywhere, and with keys that may be stale. After each
/// the map is valid, and data kept beside it can follow by what the edit says; or the edit was refused, and nothing changed.
/// Every so often the same points and segments, built at once, make the same faces, and points are found where the index
/// finds them.
///
/// # Panics
/// If not.
pub fn edits(bytes: &[u8]) {
    let mut source = Unstructured::new(bytes);
    let mut map = PlanarMap::new();
    for _ in 0..3 {
        map.add_feature(None);
    }
    let mut keys = Keys::of(&map);
    let mut last = Located::Face(map.dcel().unbounded_face().key());
    for i in 1..=LONGEST {
        if source.is_empty() {
            break;
        }
        let mut before = map.clone();
        let shown = format!("{map:?}");
        match edit(&mut source, &mut map, &keys) {
            Ok(edited) => {
                let report = map.validate();
                assert!(report.is_valid(), "edit {i}: {report}\nof {shown}");
                if let Some(edited) = edited {
                    let mut shadow = Shadow::of(&before);
                    shadow.follow(&map, &edited);
                    assert_eq!(shadow, Shadow::of(&map), "edit {i} of {shown}");
                }
                // Keys of what has just gone stay for one edit more.
                keys = Keys::of(if i % 2 == 0 { &before } else { &map });
            }
            Err(error) => assert_eq!(format!("{map:?}"), shown, "edit {i}: {error}"),
        }
        last = located(&mut source, &map, last);
        if i % PERIOD == 0 {
            before = rebuilt(&map);
            assert_eq!(walls(&before), walls(&map), "edit {i} of {shown}");
        }
    }
    let again = rebuilt(&map);
    assert_eq!(walls(&again), walls(&map));
}

/// A point is found where the index finds it, from where the last was.
fn located(source: &mut Unstructured<'_>, map: &PlanarMap, last: Located) -> Located {
    let p = point(source);
    let walked = match map.locate_from(p, last) {
        Err(LocateError::Stale(_)) => map.locate_from(p, map.dcel().unbounded_face().key()),
        walked => walked,
    };
    let there = Locator::new(map).expect("edits keep it plane").locate(p);
    assert_eq!(walked.is_err(), !in_range(p), "{p:?}: {walked:?}");
    let (Ok(walked), Ok(there)) = (walked, there) else {
        assert!(there.is_err() && walked.is_err(), "{p:?}: {walked:?}, {there:?}");
        return last;
    };
    let other = match walked {
        Located::Edge(h) => map.dcel().half_edge(h).map_or(walked, |h| h.twin().key().into()),
        _ => walked,
    };
    assert!(walked == there || other == there, "{p:?}: {walked:?}, {there:?} of {map:?}");
    there
}

/// The same points and segments, built at once.
fn rebuilt(map: &PlanarMap) -> PlanarMap {
    let place = |v: Vertex<'_>| map.position(v.key()).expect("of this map");
    let mut builder = Builder::new();
    for v in map.dcel().vertices() {
        builder.shape(&Shape::Point(place(v))).expect("edits keep to the range");
    }
    for h in map.dcel().edges() {
        builder.segment(place(h.origin()), place(h.target())).expect("edits keep to the range");
    }
    builder.build().expect("a small map fits")
}

/// The boundary components of each face as closed walks, each from the smallest turn on.
fn walls(map: &PlanarMap) -> BTreeSet<(bool, Vec<Vec<Bits>>)> {
    let place = |v: Vertex<'_>| {
        let p = map.position(v.key()).expect("of this map");
        [p.x.to_bits(), p.y.to_bits()]
    };
    let walk = |b: Boundary<'_>| {
        let along: Vec<Bits> = b.half_edges().map(|h| place(h.origin())).collect();
        let turned = |i: usize| -> Vec<Bits> { along[i..].iter().chain(&along[..i]).copied().collect() };
        let alone = || b.isolated_vertex().map(place).into_iter().collect();
        (0..along.len()).map(turned).min().unwrap_or_else(alone)
    };
    let of = |face: Face<'_>| {
        let mut walks: Vec<Vec<Bits>> = face.boundaries().map(walk).collect();
        walks.sort_unstable();
        (face.is_unbounded(), walks)
    };
    map.dcel().faces().map(of).collect()
}
