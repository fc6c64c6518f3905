//! Laws for every program of edits.

use crate::edit::describe::{Description, built, describe, dump, ends, grid};
use crate::edit::follow::Shadow;
use crate::edit::model::{Model, sorted};
use crate::planar_map::rectangle;
use crate::support::exact::{Grid, Meets, meets, point};
use quickcheck::{Arbitrary, Gen, QuickCheck};
use twinedge::dcel::{HalfEdgeKey, VertexKey};
use twinedge_map::edit::{EditError, Edited};
use twinedge_map::{Builder, PlanarMap, Shape};

/// The number of positions in each direction: few, so that contacts are frequent.
const SIDE: u8 = 7;

/// Not `twinedge_map::program`: the model knows points but no keys, so an edit must name points instead of records.
#[derive(Clone, Debug)]
enum Edit {
    Point(Grid),
    /// If true, the edit gets the nearest available hint: the first vertex or half-edge of the map.
    Segment(Grid, Grid, bool),
    Ring(Vec<Grid>),
    RemoveEdge(u8),
    RemoveVertex(u8),
    MoveVertex(u8, Grid),
}

fn place(g: &mut Gen) -> Grid {
    let mut along = || i32::from(u8::arbitrary(g) % SIDE);
    (along(), along())
}

impl Arbitrary for Edit {
    fn arbitrary(g: &mut Gen) -> Self {
        match u8::arbitrary(g) % 16 {
            0..2 => Self::Point(place(g)),
            2..8 => Self::Segment(place(g), place(g), bool::arbitrary(g)),
            8..11 => Self::Ring((0..u8::arbitrary(g) % 6).map(|_| place(g)).collect()),
            11..13 => Self::RemoveEdge(u8::arbitrary(g)),
            13 => Self::RemoveVertex(u8::arbitrary(g)),
            _ => Self::MoveVertex(u8::arbitrary(g), place(g)),
        }
    }
}

/// Chooses a vertex or edge, if there are any.
fn choose<T>(all: impl Iterator<Item = T>, which: u8) -> Option<T> {
    let mut all: Vec<T> = all.collect();
    let place = usize::from(which).checked_rem(all.len())?;
    Some(all.swap_remove(place))
}

fn some_vertex(map: &PlanarMap, which: u8) -> Option<(VertexKey, Grid)> {
    choose(map.dcel().vertices().map(|v| (v.key(), grid(map, v))), which)
}

fn some_edge(map: &PlanarMap, which: u8) -> Option<(HalfEdgeKey, [Grid; 2])> {
    choose(map.dcel().edges().map(|h| (h.key(), ends(map, h))), which)
}

/// A map that is edited, and all data that must follow.
struct Run {
    map: PlanarMap,
    model: Model,
    shadow: Shadow,
}

impl Run {
    fn new(map: PlanarMap) -> Self {
        let Description { vertices, edges, .. } = describe(&map);
        Self { model: Model { vertices, edges }, shadow: Shadow::of(&map), map }
    }

    /// Applies an edit to the map and, if the model permits it, to the model.
    fn step(&mut self, edit: &Edit) {
        let before = dump(&self.map);
        let expected = self.expected(edit);
        let done = self.apply(edit);
        match (&done, expected) {
            (Some(Ok(_)) | None, Ok(())) => {}
            (Some(Err(error)), Err(expected)) if expected(error) => {
                assert_eq!(dump(&self.map), before, "{edit:?}");
                return;
            }
            (done, expected) => panic!("{edit:?}: {done:?}, but the model allows it: {}", expected.is_ok()),
        }
        let report = self.map.validate();
        assert!(report.is_valid(), "{edit:?}: {report}");
        let there = describe(&self.map);
        assert_eq!(there.vertices, self.model.vertices, "{edit:?}");
        assert_eq!(there.edges, self.model.edges, "{edit:?}");
        assert_eq!(there, describe(&built(&self.model.vertices, &self.model.edges)), "{edit:?}");
        if let Some(Ok(edited)) = done {
            self.shadow.follow(&self.map, &edited);
            self.the_way_is_as_told(edit, &edited);
        }
        assert_eq!(self.shadow, Shadow::of(&self.map), "{edit:?}");
    }

    /// Returns the refusal that an edit must meet, if any. Changes the model if the edit is permitted.
    fn expected(&mut self, edit: &Edit) -> Result<(), fn(&EditError) -> bool> {
        match edit {
            Edit::Point(p) => self.model.insert_point(*p),
            Edit::Segment(a, b, _) if a == b => return Err(|e| matches!(e, EditError::NoLength { .. })),
            Edit::Segment(a, b, _) if self.model.crosses(*a, *b) => {
                return Err(|e| matches!(e, EditError::Crosses(_)));
            }
            Edit::Segment(a, b, _) => self.model.insert_segment(*a, *b),
            Edit::Ring(points) => {
                let points = open(points);
                if points.len() < 3 {
                    return Err(|e| matches!(e, EditError::NotARing { .. }));
                }
                let ways: Vec<[Grid; 2]> =
                    (0..points.len()).map(|i| [points[i], points[(i + 1) % points.len()]]).collect();
                if ways.iter().any(|[a, b]| a == b) {
                    return Err(|e| matches!(e, EditError::NoLength { .. }));
                }
                if ways.iter().any(|[a, b]| self.model.crosses(*a, *b)) {
                    return Err(|e| matches!(e, EditError::Crosses(_)));
                }
                let cross = |[a, b]: &[Grid; 2]| ways.iter().any(|[c, d]| meets(*a, *b, *c, *d) == Meets::Cross);
                if ways.iter().any(cross) {
                    return Err(|e| matches!(e, EditError::SelfCrossing { .. }));
                }
                for [a, b] in ways {
                    self.model.insert_segment(a, b);
                }
            }
            Edit::RemoveEdge(which) => {
                if let Some((_, ends)) = some_edge(&self.map, *which) {
                    self.model.edges.remove(&ends);
                }
            }
            Edit::RemoveVertex(which) => {
                if let Some((_, p)) = some_vertex(&self.map, *which) {
                    self.model.remove_vertex(p);
                }
            }
            Edit::MoveVertex(which, to) => {
                if let Some((_, from)) = some_vertex(&self.map, *which) {
                    if !self.model.way_is_free(from, *to) {
                        return Err(|e| matches!(e, EditError::VertexInTheWay(_) | EditError::EdgeInTheWay(_)));
                    }
                    self.model.move_vertex(from, *to);
                }
            }
        }
        Ok(())
    }

    /// Returns the result of an edit; `None` if it had no target.
    fn apply(&mut self, edit: &Edit) -> Option<Result<Edited, EditError>> {
        let map = &mut self.map;
        Some(match edit {
            Edit::Point(p) => map.insert_point(point(*p)),
            Edit::Segment(a, b, near) => {
                let hint = map.dcel().half_edges().next().map(|h| h.key());
                let there = map.dcel().vertices().find(|v| grid(map, *v) == *a).map(|v| v.key());
                match (near, there, hint) {
                    (true, Some(v), _) => map.insert_segment(v, point(*b)),
                    (true, None, Some(h)) => map.insert_segment((point(*a), h), point(*b)),
                    _ => map.insert_segment(point(*a), point(*b)),
                }
            }
            Edit::Ring(points) => map.insert_ring(points.iter().map(|p| point(*p))),
            Edit::RemoveEdge(which) => {
                let (h, _) = some_edge(map, *which)?;
                map.remove_edge(h)
            }
            Edit::RemoveVertex(which) => {
                let (v, _) = some_vertex(map, *which)?;
                map.remove_vertex(v)
            }
            Edit::MoveVertex(which, to) => {
                let (v, _) = some_vertex(map, *which)?;
                return match map.move_vertex(v, point(*to)) {
                    Ok(()) => None,
                    Err(error) => Some(Err(error)),
                };
            }
        })
    }

    /// The vertices of an outcome are at the given points, and its way leads from each to the next.
    fn the_way_is_as_told(&self, edit: &Edit, edited: &Edited) {
        let points = match edit {
            Edit::Point(p) => vec![*p],
            Edit::Segment(a, b, _) => vec![*a, *b],
            Edit::Ring(points) => open(points).to_vec(),
            _ => Vec::new(),
        };
        let dcel = self.map.dcel();
        let at = |v: &VertexKey| grid(&self.map, dcel.vertex(*v).expect("it is there"));
        assert_eq!(edited.vertices.iter().map(at).collect::<Vec<_>>(), points);
        let way: Vec<_> = edited.way.iter().map(|h| dcel.half_edge(*h).expect("it is there")).collect();
        assert!(way.windows(2).all(|pair| pair[0].target() == pair[1].origin()));
        let mut turns: Vec<Grid> = Vec::new();
        let starts = way.iter().map(|h| h.origin()).chain(way.last().map(|h| h.target()));
        let mut expected = points.iter().peekable();
        for start in starts.map(|v| grid(&self.map, v)) {
            if expected.next_if(|p| **p == start).is_some() {
                turns.push(start);
            }
        }
        if way.is_empty() {
            assert!(points.len() < 2);
        } else {
            assert_eq!(turns, points);
        }
        let ends_in = way.last().map(|h| grid(&self.map, h.target()));
        assert!(
            ends_in
                .is_none_or(|p| Some(&p) == if matches!(edit, Edit::Ring(_)) { points.first() } else { points.last() })
        );
    }
}

/// The points of a ring without a last point that repeats the first.
fn open(points: &[Grid]) -> &[Grid] {
    match points {
        [first, rest @ .., last] if first == last => &points[..=rest.len()],
        _ => points,
    }
}

/// A map with overlapping features.
fn rectangles() -> PlanarMap {
    let mut builder = Builder::new();
    for (low, high) in [([0, 0], [4, 4]), ([2, 2], [6, 6]), ([1, 1], [2, 2]), ([4, 0], [6, 2])] {
        builder.shape(&Shape::polygon(rectangle(low, high))).expect("small integers are in range");
    }
    builder.build().expect("a small map fits")
}

fn run(map: PlanarMap, edits: &[Edit]) {
    let mut run = Run::new(map);
    for edit in edits {
        run.step(edit);
    }
}

/// Runs random programs, deterministically.
fn check(tests: u64, size: usize, law: fn(Vec<Edit>) -> bool) {
    QuickCheck::new().rng(Gen::from_size_and_seed(size, 2026)).tests(tests).quickcheck(law);
}

#[test]
fn edits_step_by_step_give_the_map_that_is_built_at_once() {
    check(250, 60, |edits| {
        run(PlanarMap::new(), &edits);
        true
    });
}

#[test]
fn features_stay_with_the_area_and_the_edges_that_they_had() {
    check(120, 40, |edits| {
        run(rectangles(), &edits);
        true
    });
}

#[test]
fn a_ring_may_touch_an_edge_from_both_sides() {
    let mut map = PlanarMap::new();
    map.insert_segment([0.0, 0.0], [6.0, 0.0]).expect("nothing is there");
    let mut run = Run::new(map);
    // The edge is split four times, twice from each side, around its right end.
    run.step(&Edit::Ring(vec![
        (1, 0),
        (2, 1),
        (3, 0),
        (8, 2),
        (8, -2),
        (4, 0),
        (3, -1),
        (2, 0),
        (1, -3),
        (-1, -3),
        (-1, 3),
    ]));
    assert_eq!((run.map.dcel().vertex_count(), run.map.dcel().face_count()), (13, 5));
}

#[test]
fn the_outside_may_pass_the_leftmost_vertex_several_times() {
    // A spike below or above two arms, the inner arm so long that the way around the outside is shorter.
    for (spike, turned) in [((1, -3), false), ((1, -3), true), ((1, 9), false), ((1, 9), true)] {
        let mut run = Run::new(PlanarMap::new());
        let line = [(0, 0), (1, 1), (2, 1), (3, 1), (4, 1), (4, 2)];
        for pair in line.windows(2) {
            run.step(&Edit::Segment(pair[0], pair[1], false));
        }
        for tip in [spike, (6, -2), (6, 7)] {
            run.step(&Edit::Segment((0, 0), tip, false));
        }
        run.step(&Edit::Point((5, 2)));
        let (from, to) = if turned { ((6, 7), (6, -2)) } else { ((6, -2), (6, 7)) };
        run.step(&Edit::Segment(from, to, false));
        assert_eq!(run.map.dcel().face_count(), 2);
    }
}

#[test]
fn segments_in_any_order_and_direction_give_the_same_map() {
    fn law(segments: Vec<((u8, u8), (u8, u8))>, turns: Vec<bool>) -> bool {
        let whole = |(x, y): (u8, u8)| (i32::from(x % SIDE), i32::from(y % SIDE));
        let mut model = Model::default();
        let mut kept: Vec<[Grid; 2]> = Vec::new();
        for (a, b) in segments {
            let [a, b] = sorted(whole(a), whole(b));
            // A vertex at a crossing would exist in only one order.
            if a != b && kept.iter().all(|[c, d]| meets(a, b, *c, *d) != Meets::Cross) {
                model.insert_segment(a, b);
                kept.push([a, b]);
            }
        }
        let mut map = PlanarMap::new();
        for ([a, b], turn) in kept.iter().rev().zip(turns.iter().chain(std::iter::repeat(&false))) {
            let (a, b) = if *turn { (*b, *a) } else { (*a, *b) };
            map.insert_segment(point(a), point(b)).expect("these cross nothing");
        }
        map.validate().is_valid() && describe(&map) == describe(&built(&model.vertices, &model.edges))
    }
    QuickCheck::new()
        .rng(Gen::from_size_and_seed(40, 2026))
        .tests(500)
        .quickcheck(law as fn(Vec<((u8, u8), (u8, u8))>, Vec<bool>) -> bool);
}
