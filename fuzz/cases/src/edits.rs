//! Targets that edit maps with coordinates.

#[path = "../../../crates/map/tests/map/edit/follow.rs"]
mod follow;

use follow::Shadow;
use std::collections::BTreeSet;
use twinedge::dcel::{Boundary, Face, Vertex};
use twinedge::program::choose::Bytes;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, in_range, on_segment, orientation};
use twinedge_map::program::{AtPick, EditKind, EditOp, EditOutcome, EditProgram, EditRunner};
use twinedge_map::{Builder, Located, PlanarMap, Shape};

/// Longer programs are cut off.
const LONGEST: usize = 60;

/// The number of edits between two checks of the whole map.
const PERIOD: usize = 16;

type Bits = [u64; 2];

/// Decodes the program: as text, skipping lines that are no edit, or else as choices.
fn program(bytes: &[u8]) -> EditProgram {
    let text = std::str::from_utf8(bytes).ok().filter(|text| text.starts_with("twinedge edits"));
    let mut program = match text {
        Some(text) => text.lines().filter_map(|line| line.parse::<EditOp>().ok()).collect(),
        None => EditProgram::from_bytes(bytes),
    };
    program.0.truncate(LONGEST);
    program
}

/// Returns a point from choices of its own.
fn point(source: &mut Bytes<'_>) -> Point {
    let one = EditProgram::generator().only(&[EditKind::InsertPoint]).length(1..=1);
    match one.generate(source).0.pop() {
        Some(EditOp::InsertPoint { at: AtPick::Point(spot) | AtPick::Near(spot, _) }) => spot.point(),
        _ => Point::default(),
    }
}

/// Runs a program of edits, with points on a small grid, close to it and anywhere, and with keys that may be stale.
/// After each edit the map is valid, by the reported writes, and data kept alongside can follow the edit's report; or
/// the edit was refused, and nothing was written. Every so often, and at the end, the whole map is valid, the data is
/// correct, the same points and segments, built at once, make the same faces, and the index finds a point in the same
/// place.
///
/// # Panics
/// If the map, a report or the data is not as expected.
pub fn edits(bytes: &[u8]) {
    let program = program(bytes);
    let mut places = Bytes::new(bytes);
    let mut runner = EditRunner::audited(PlanarMap::new()).expect("the empty map is valid");
    let mut shadow = Shadow::of(runner.map());
    for (i, op) in (1..).zip(&program.0) {
        // These edits do not report their effects.
        let relabels = matches!(op, EditOp::SetFeaturesOf { .. } | EditOp::SetFeaturesAlong { .. });
        if relabels {
            assert_eq!(shadow, Shadow::of(runner.map()), "before edit {i} of {program}");
        }
        match runner.step_checked(op).unwrap_or_else(|failure| panic!("{failure}\nof {program}")) {
            EditOutcome::Applied(_) if relabels => shadow = Shadow::of(runner.map()),
            EditOutcome::Applied(edited) => shadow.follow(runner.map(), &edited),
            _ => {}
        }
        if i % PERIOD == 0 || i == program.0.len() {
            let map = runner.map();
            assert_eq!(shadow, Shadow::of(map), "edit {i} of {program}");
            let report = map.validate();
            assert!(report.is_valid(), "only found by full validation after edit {i} of {program}\n{report}");
            assert_eq!(walls(&rebuilt(map)), walls(map), "edit {i} of {program}");
            located(&mut places, map);
        }
    }
}

/// Checks that the map's index finds a point where a scan of all half-edges finds it.
fn located(places: &mut Bytes<'_>, map: &PlanarMap) {
    let p = point(places);
    let found = map.locate(p);
    assert_eq!(found.is_err(), !in_range(p), "{p:?}: {found:?}");
    if let Ok(found) = found {
        assert_eq!(found, scanned(map, p), "{p:?} of {map:?}");
    }
}

/// The record at a point, or the bounded face whose boundary a ray straight up crosses an odd number of times.
fn scanned(map: &PlanarMap, p: Point) -> Located {
    let at = |v: Vertex<'_>| map.position(v.key()).expect("of this map");
    if let Some(v) = map.dcel().vertices().find(|v| at(*v) == p) {
        return Located::Vertex(v.key());
    }
    let mut odd = BTreeSet::new();
    for h in map.dcel().half_edges() {
        let (a, b) = (at(h.origin()), at(h.target()));
        if compare_lexicographic(a, b).is_lt() && on_segment(p, a, b) {
            return Located::Edge(h.key());
        }
        let below = if a.x < b.x { Orientation::Clockwise } else { Orientation::CounterClockwise };
        let crosses = (a.x < p.x) != (b.x < p.x) && orientation(a, b, p) == below;
        if crosses && !odd.remove(&h.face().key()) {
            odd.insert(h.face().key());
        }
    }
    let unbounded = map.dcel().unbounded_face().key();
    Located::Face(odd.into_iter().find(|f| *f != unbounded).unwrap_or(unbounded))
}

/// Builds the map of these points and segments at once.
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
