//! Edges with bends: the verdict equals that on the map with a vertex at each bend, and violations name bends.

use crate::support::drawn::{Drawn, moved_inner, validate_embedding};
use crate::support::only_live::OnlyLive;
use std::collections::BTreeMap;
use twinedge::delegate_view;
use twinedge::validate::{
    Collect, Expectation, FaceRow, HalfEdgeRow, Link, Only, Part, Parts, Record, Report, Rule, Start, Table, Unchecked,
    VertexRow, View, Violation,
};
use twinedge_geometry::noding::Snap;
use twinedge_geometry::{MAX_COORDINATE, Point};
use twinedge_map::{Builder, Embedding, Noding, PlanarMap, places};

const PLANE: Expectation = Expectation::plane();

/// A map twice: with all of its vertices, and with some vertices of degree 2 as bends.
struct Twice {
    straight: Drawn,
    bent: Drawn,
    /// The half-edges that each remaining half-edge combines.
    chains: BTreeMap<usize, Vec<usize>>,
}

/// A small deterministic generator.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    fn point(&mut self, origin: usize, size: usize) -> Point {
        let mut coordinate = || (origin + self.below(size)) as f64;
        Point::new(coordinate(), coordinate())
    }

    /// Rings and lines on a grid, cut where they cross, and points.
    fn map(&mut self) -> PlanarMap {
        let mut builder = Builder::new();
        for _ in 0..=self.below(5) {
            let (origin, size, closed) = (self.below(8), 3 + self.below(9), self.below(3) > 0);
            let line: Vec<Point> = (0..3 + self.below(5)).map(|_| self.point(origin, size)).collect();
            for i in 0..line.len() - usize::from(!closed) {
                builder.segment(line[i], line[(i + 1) % line.len()]).expect("small numbers are in range");
            }
        }
        if self.below(2) == 0 {
            builder.shape(&twinedge_map::Shape::Point(self.point(0, 16))).expect("in range");
        }
        builder.build_with(Noding::Snap(Snap::Size(1.0 / 64.0))).expect("a small map fits")
    }
}

impl Twice {
    /// Turns some of the vertices with two edges into bends, and keeps at least one vertex in each component.
    fn of(map: &PlanarMap, random: &mut Random) -> Self {
        let straight = Drawn::of(map);
        let view = &straight;
        let live = || (0..view.half_edge_slots()).filter(|h| view.is_half_edge(*h));
        let follow = |link: Link| link.expect("a right map has all links");
        let (next, prev, twin) = (|h| follow(view.next(h)), |h| follow(view.prev(h)), |h| follow(view.twin(h)));
        let origin = |h| follow(view.origin(h));
        let mut is_bend: Vec<bool> = (0..view.vertex_slots())
            .map(|v| view.is_vertex(v) && live().filter(|h| origin(*h) == v).count() == 2 && random.below(4) > 0)
            .collect();
        for start in live() {
            let mut h = start;
            while is_bend[origin(h)] {
                h = next(h);
                if h == start {
                    is_bend[origin(h)] = false;
                }
            }
        }
        let mut chains = BTreeMap::new();
        for first in live().filter(|h| !is_bend[origin(*h)]) {
            let mut chain = vec![first];
            let mut h = first;
            while is_bend[origin(next(h))] {
                h = next(h);
                chain.push(h);
            }
            chains.insert(first, chain);
        }
        let first_of = |mut h: usize| {
            while is_bend[origin(h)] {
                h = prev(h);
            }
            h
        };
        let mut bent = straight.clone();
        for h in live() {
            let row = bent.structure.half_edges[h].as_mut().expect("it is live");
            let Some(last) = chains.get(&h).and_then(|chain| chain.last()) else {
                bent.structure.half_edges[h] = None;
                continue;
            };
            row.next = Some(next(*last));
            row.prev = Some(first_of(prev(h)));
            row.twin = Some(twin(*last));
            if h < twin(*last) {
                let bends = chains[&h][1..].iter().map(|h| straight.points[origin(*h)]).collect();
                bent.bends.insert(h, bends);
            }
        }
        for boundary in bent.structure.boundaries.iter_mut().flatten() {
            if let Some(Start::HalfEdge(h)) = &mut boundary.start {
                *h = first_of(*h);
            }
        }
        for (v, _) in is_bend.iter().enumerate().filter(|(_, bend)| **bend) {
            bent.structure.vertices[v] = None;
        }
        for v in bent.structure.vertices.iter_mut().flatten() {
            v.leaving = v.leaving.map(first_of);
        }
        Self { straight, bent, chains }
    }

    fn expect_same(&self, what: &str) {
        let (straight, bent) = (self.straight.report(&PLANE), self.bent.report(&PLANE));
        let verdicts = |report: &Report| -> Vec<(Rule, bool, Option<Unchecked>)> {
            // New vertices may make a map simple, which changes T4.
            let of_maps = report.outcomes().filter(|(rule, _)| *rule != Rule::T4);
            of_maps.map(|(rule, outcome)| (rule, outcome.violations > 0, outcome.unchecked)).collect()
        };
        assert_eq!(verdicts(&straight), verdicts(&bent), "{what}\nstraight:\n{straight}\nbent:\n{bent}");
        // Only points of the drawing are named.
        for violation in bent.violations() {
            for place in places(&self.bent, violation) {
                let mut points = self.straight.points.iter();
                assert!(points.any(|p| *p == place) || place.x.is_nan() || place.y.is_nan(), "{violation}: {place:?}");
            }
        }
    }

    /// Moves a point of the drawing, vertex or bend.
    fn move_point(&mut self, from: Point, to: Point) {
        let all = self.straight.points.iter_mut().chain(&mut self.bent.points);
        for p in all.chain(self.bent.bends.values_mut().flatten()).filter(|p| **p == from) {
            *p = to;
        }
    }

    /// Sets a link of a half-edge that both have.
    fn relink(&mut self, random: &mut Random) -> String {
        let half_edges: Vec<usize> = self.chains.keys().copied().collect();
        let (h, to) = (random.of(&half_edges), random.of(&half_edges));
        let last = *self.chains[&h].last().expect("a chain has a half-edge");
        let straight = |table: &mut Table, h: usize, set: &dyn Fn(&mut twinedge::validate::HalfEdgeRow)| {
            set(table.half_edges[h].as_mut().expect("it is live"));
        };
        let (a, b) = (&mut self.straight.structure, &mut self.bent.structure);
        match random.below(5) {
            0 => {
                straight(a, last, &|row| row.next = Some(to));
                straight(b, h, &|row| row.next = Some(to));
                format!("next of {h} is {to}")
            }
            1 => {
                let end = *self.chains[&to].last().expect("a chain has a half-edge");
                straight(a, h, &|row| row.prev = Some(end));
                straight(b, h, &|row| row.prev = Some(to));
                format!("prev of {h} is {to}")
            }
            2 => {
                let origin = b.origin(to);
                straight(a, h, &|row| row.origin = origin);
                straight(b, h, &|row| row.origin = origin);
                format!("origin of {h} is {origin:?}")
            }
            3 => {
                let boundary = random.below(b.boundaries.len());
                for part in &self.chains[&h] {
                    straight(a, *part, &|row| row.boundary = Some(boundary));
                }
                straight(b, h, &|row| row.boundary = Some(boundary));
                format!("boundary of {h} is {boundary}")
            }
            _ => {
                let (boundary, face) = (random.below(b.boundaries.len()), random.below(b.faces.len()));
                for table in [a, b] {
                    if let Some(row) = &mut table.boundaries[boundary] {
                        row.face = Some(face);
                    }
                }
                format!("face of boundary component {boundary} is {face}")
            }
        }
    }

    /// Lists a hole in another face, consistently.
    fn move_hole(&mut self, random: &mut Random) {
        let choice = (random.below(64), random.below(64));
        for table in [&mut self.straight.structure, &mut self.bent.structure] {
            let holes: Vec<(usize, usize)> =
                (0..table.face_slots()).flat_map(|f| (0..table.inner_count(f)).map(move |i| (f, i))).collect();
            if holes.is_empty() {
                return;
            }
            let (from, at) = holes[choice.0 % holes.len()];
            let live: Vec<usize> = (0..table.face_slots()).filter(|f| table.is_face(*f)).collect();
            let moved = table.inner(from, at).expect("a right list has no gap");
            *table = moved_inner(table, moved, live[choice.1 % live.len()]).expect("it is an inner one");
        }
    }
}

#[test]
fn a_map_with_bends_is_judged_as_the_map_with_a_vertex_at_each() {
    let mut random = Random(1);
    let (mut bends, mut broken) = (0, [0; 5]);
    for round in 0..800 {
        let map = random.map();
        let right = Twice::of(&map, &mut random);
        bends += right.bent.bends.values().flatten().count();
        assert!(right.bent.report(&PLANE).is_valid(), "{}", right.bent.report(&PLANE));
        right.expect_same("right");
        for _ in 0..4 {
            let mut moved = Twice::of(&map, &mut random);
            for _ in 0..=random.below(2) {
                let from = random.of(&moved.straight.points);
                let to = match random.below(8) {
                    0 => Point::new(f64::NAN, 1.0),
                    1..4 => random.of(&moved.straight.points),
                    _ => random.point(0, 16),
                };
                moved.move_point(from, to);
            }
            if random.below(3) == 0 {
                moved.move_hole(&mut random);
            }
            moved.expect_same(&format!("moved in round {round}"));
            let report = moved.bent.report(&PLANE);
            for (count, rule) in broken.iter_mut().zip([Rule::G1, Rule::G2, Rule::G3, Rule::G4, Rule::G5]) {
                *count += usize::from(report.outcome(rule).is_some_and(|outcome| outcome.violations > 0));
            }
        }
        if !right.chains.is_empty() {
            let mut relinked = Twice::of(&map, &mut random);
            let what = relinked.relink(&mut random);
            relinked.expect_same(&what);
        }
    }
    assert!(bends > 5000, "{bends} bends only");
    assert!(broken.iter().all(|count| *count >= 20), "broken G1 … G5: {broken:?}");
}

/// Two edges without a common vertex, with these bends.
fn two_edges(ends: [[f64; 2]; 4], bends: [&[[f64; 2]]; 2]) -> Drawn {
    let mut builder = Builder::new();
    builder.segment([0.0, 0.0], [1.0, 0.0]).expect("in range");
    builder.segment([0.0, 1.0], [1.0, 1.0]).expect("in range");
    let map = builder.build().expect("fits");
    let table = Table::copy_of(&map).expect("fits");
    let place = |v: usize| {
        let p = map.point(v);
        let i = if p.y < 0.5 { 0 } else { 2 } + usize::from(p.x > 0.5);
        ends[i].into()
    };
    let points: Vec<Point> = (0..map.vertex_slots()).map(place).collect();
    let mut drawn = Drawn::new(table, points);
    for (i, (h, line)) in edges(&drawn.structure).into_iter().zip(bends).enumerate() {
        let at = drawn.points[drawn.origin(h).expect("it has one")];
        assert_eq!(at, ends[2 * i].into(), "the builder keeps the order and the direction of segments");
        drawn.bends.insert(h, line.iter().map(|p| (*p).into()).collect());
    }
    drawn
}

/// The half-edge of each edge that represents it in calls for bends.
fn edges(table: &Table) -> [usize; 2] {
    let asked = (0..table.half_edge_slots()).filter(|h| table.is_half_edge(*h) && table.twin(*h) > Some(*h));
    asked.collect::<Vec<_>>().try_into().expect("there are two edges")
}

const ENDS: [[f64; 2]; 4] = [[0.0, 0.0], [10.0, 0.0], [0.0, 8.0], [10.0, 8.0]];

/// The bends of an edge.
type Line = &'static [[f64; 2]];

/// The only violation, with its points.
fn only(drawn: &Drawn) -> (Violation, Vec<[f64; 2]>) {
    let report = drawn.report(&PLANE);
    let [violation] = report.violations() else { panic!("{report}") };
    (*violation, places(drawn, violation).into_iter().map(Into::into).collect())
}

#[test]
fn g1_names_the_bend() {
    let [first, second] = edges(&two_edges(ENDS, [&[], &[]]).structure);
    let (violation, at) = only(&two_edges(ENDS, [&[[5.0, f64::INFINITY]], &[]]));
    assert_eq!(violation, Violation::BendNotFinite { half_edge: first, bend: 0 });
    let sentence = format!("bend 0 of half-edge {first} has a coordinate that is not finite, or out of range");
    assert_eq!(violation.message(), sentence);
    assert_eq!(at, [[5.0, f64::INFINITY]]);
    let (violation, at) = only(&two_edges(ENDS, [&[], &[[3.0, 9.0], [3.0, 9.0]]]));
    assert_eq!(violation, Violation::SegmentZeroLength { half_edge: second, segment: 1 });
    assert_eq!(at, [[3.0, 9.0]]);
}

#[test]
fn g4_names_the_segments_and_the_bends() {
    let kinds: [(Line, Line, &str); 6] = [
        (&[[5.0, 9.0]], &[], "segments_cross"),
        (&[[5.0, 8.0]], &[], "bend_in_segment"),
        (&[[3.0, 8.0], [6.0, 8.0]], &[], "segments_overlap"),
        (&[[0.0, 8.0]], &[], "bend_at_vertex"),
        (&[[5.0, 4.0]], &[[5.0, 4.0]], "bends_at_same_place"),
        (
            &[[-5.0, 8.0], [-5.0, 9.0], [5.0, 9.0], [5.0, 4.0], [0.5, 4.0], [0.5, 2.0], [10.0, 2.0]],
            &[],
            "segments_cross",
        ),
    ];
    for (first, second, kind) in kinds {
        let drawn = two_edges(ENDS, [first, second]);
        let report = drawn.report(&PLANE);
        let broken: Vec<_> = report.outcomes().filter(|(_, outcome)| outcome.violations > 0).collect();
        assert_eq!(broken.len(), 1, "{kind}: {report}");
        let found = report.violations().iter().find(|violation| violation.kind() == kind);
        let found = found.unwrap_or_else(|| panic!("{kind}: {report}"));
        assert!(!places(&drawn, found).is_empty());
    }
    // A vertex of one inside a segment of the other.
    let ends = [[0.0, 0.0], [10.0, 0.0], [2.0, 4.0], [9.0, 9.0]];
    let (violation, at) = only(&two_edges(ends, [&[[0.0, 4.0], [10.0, 4.0]], &[]]));
    let Violation::VertexInSegment { half_edge, segment: 1, .. } = violation else { panic!("{violation}") };
    assert_eq!(at, [[2.0, 4.0]]);
    assert!(violation.to_string().contains(&format!("lies inside segment 1 of half-edge {half_edge}")), "{violation}");
}

#[test]
fn g4_numbers_the_bends_of_each_edge_from_its_first() {
    let drawn = two_edges(ENDS, [&[[1.0, 1.0], [5.0, 4.0]], &[[2.0, 7.0], [5.0, 4.0]]]);
    let [first, second] = edges(&drawn.structure);
    let same = Violation::BendsAtSamePlace { first, first_bend: 1, second, second_bend: 1 };
    assert_eq!(only(&drawn), (same, vec![[5.0, 4.0]]));
    // The places of a crossing are the ends of the segments, not of the edges.
    let crossing = Violation::SegmentsCross { first, first_segment: 1, second, second_segment: 0 };
    let at: Vec<[f64; 2]> = places(&drawn, &crossing).into_iter().map(Into::into).collect();
    assert_eq!(at, [[1.0, 1.0], [5.0, 4.0], [0.0, 8.0], [2.0, 7.0]]);
}

#[test]
fn a_drawing_is_the_same_behind_a_reference_in_a_box_and_as_what_it_stores() {
    let drawn = two_edges(ENDS, [&[[5.0, 9.0]], &[]]);
    let report = drawn.report(&PLANE);
    assert!(report.broken_rules().eq([Rule::G4]), "{report}");
    let judge = |drawn: &dyn Embedding| validate_embedding(drawn, &PLANE, Collect::All);
    assert_eq!(judge(&&drawn), report);
    assert_eq!(judge(&Only::new(&drawn, Parts::ALL)), report);
    assert_eq!(judge(&Box::new(drawn)), report);
}

/// The half-edge with the largest index represents its edge if it has no twin.
#[test]
fn bends_of_the_last_half_edge_are_read_at_an_open_boundary() {
    let row =
        |h: usize| HalfEdgeRow { origin: Some(h), next: Some((h + 1) % 3), face: Some(0), ..HalfEdgeRow::default() };
    let table = Table {
        parts: Parts::NONE.with(Part::Faces),
        vertices: vec![Some(VertexRow::default()); 3],
        half_edges: (0..3).map(|h| Some(row(h))).collect(),
        faces: vec![Some(FaceRow { outer_half_edge: Some(0), ..FaceRow::default() })],
        ..Table::default()
    };
    let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]].map(Into::into).to_vec();
    let drawn = Drawn { structure: table, points, bends: BTreeMap::from([(2, vec![Point::new(2.0, -2.0)])]) };
    let report = validate_embedding(&drawn, &PLANE.open(), Collect::All);
    assert!(report.broken_rules().eq([Rule::G4]), "{report}");
}

/// A drawing that panics on a read of a missing slot or bend.
struct Strict(Drawn);

impl View for Strict {
    delegate_view!(|this| &OnlyLive(&this.0));
}

impl Embedding for Strict {
    fn point(&self, vertex: usize) -> Point {
        assert!(self.is_vertex(vertex));
        self.0.point(vertex)
    }

    fn bends(&self, half_edge: usize) -> usize {
        assert!(self.is_half_edge(half_edge));
        self.0.bends(half_edge)
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        assert!(bend < self.bends(half_edge));
        self.0.bend(half_edge, bend)
    }
}

/// Violations may belong to another structure, or to this one before it shrank.
#[test]
fn what_is_not_there_has_no_place() {
    let drawn = Strict(two_edges(ENDS, [&[[5.0, 1.0]], &[]]));
    let [first, _] = edges(&drawn.0.structure);
    let at = |violation: Violation| places(&drawn, &violation).into_iter().map(Into::into).collect::<Vec<[f64; 2]>>();
    let (vertex, half_edge) = (drawn.vertex_slots(), drawn.half_edge_slots());
    let boundary = (0..drawn.boundary_slots()).find(|b| drawn.is_boundary(*b)).expect("each edge has one");
    let start = at(Violation::ListedTwice { record: Record::Boundary(boundary), face: 0 });
    assert!(ENDS.iter().any(|end| start == [*end]), "{start:?}");
    assert!(at(Violation::ListedTwice { record: Record::Boundary(drawn.boundary_slots()), face: 0 }).is_empty());
    assert!(at(Violation::NoOutside { vertex }).is_empty());
    assert!(at(Violation::SegmentZeroLength { half_edge, segment: 0 }).is_empty());
    assert!(at(Violation::BendNotFinite { half_edge, bend: 0 }).is_empty());
    // For an edge without such a bend, the ends are shown.
    assert_eq!(at(Violation::BendNotFinite { half_edge: first, bend: 0 }), [[5.0, 1.0]]);
    assert_eq!(at(Violation::BendNotFinite { half_edge: first, bend: 1 }), [ENDS[0], ENDS[1]]);
}

#[test]
fn points_out_of_range_are_shown_where_they_can_be_drawn() {
    let far = 1.5 * MAX_COORDINATE;
    let at = |x: f64| {
        let mut drawn = two_edges(ENDS, [&[], &[]]);
        let vertex = drawn.points.iter().position(|p| *p == ENDS[1].into()).expect("it is one of the ends");
        drawn.points[vertex] = Point::new(x, 0.0);
        let report = drawn.report(&PLANE);
        let found = report.first().copied();
        assert_eq!(found, Some(Violation::NotFinite { vertex }));
        places(&drawn, &Violation::NotFinite { vertex }).len()
    };
    assert_eq!([far, f64::INFINITY].map(at), [1, 0]);
}

#[test]
fn more_bends_than_can_be_numbered_are_not_read() {
    struct Claims(Drawn);
    impl View for Claims {
        delegate_view!(|this| &this.0.structure);
    }
    impl Embedding for Claims {
        fn point(&self, vertex: usize) -> Point {
            self.0.points[vertex]
        }
        fn bends(&self, _: usize) -> usize {
            usize::MAX
        }
    }
    let report = validate_embedding(&Claims(two_edges(ENDS, [&[], &[]])), &PLANE, Collect::All);
    assert_eq!(report.outcome(Rule::G1).and_then(|outcome| outcome.unchecked), Some(Unchecked::TooLarge));
    assert!(!report.is_valid());
}

/// Bends whose number and coordinates change from call to call.
struct Fickle {
    drawn: Drawn,
    random: std::cell::RefCell<Random>,
}

impl View for Fickle {
    delegate_view!(|this| &this.drawn.structure);
}

impl Embedding for Fickle {
    fn point(&self, vertex: usize) -> Point {
        self.drawn.points[vertex]
    }

    fn bends(&self, half_edge: usize) -> usize {
        assert!(half_edge < self.drawn.structure.half_edge_slots());
        self.random.borrow_mut().below(4)
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        assert!(half_edge < self.drawn.structure.half_edge_slots() && bend < 4);
        let mut random = self.random.borrow_mut();
        if random.below(40) == 0 { Point::new(f64::NAN, f64::INFINITY) } else { random.point(0, 16) }
    }
}

#[test]
fn bends_may_change_from_call_to_call() {
    let mut random = Random(2);
    for seed in 0..200 {
        let drawn = Twice::of(&random.map(), &mut random).bent;
        let fickle = Fickle { drawn, random: std::cell::RefCell::new(Random(seed)) };
        let report = validate_embedding(&fickle, &PLANE, Collect::All);
        for violation in report.violations() {
            assert!(places(&fickle, violation).len() <= 4, "{violation}");
            assert!(!violation.to_string().is_empty());
        }
    }
}
