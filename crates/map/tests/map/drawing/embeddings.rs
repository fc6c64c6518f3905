//! G1 … G5: each broken alone, if possible, and named correctly.

use crate::support::drawn::{Drawn, points_of, validate_embedding};
use crate::support::inconsistent::Inconsistent;
use crate::support::nested::{nested, nested_textbook};
use crate::support::tables::Without;
use serde_json::{from_value, to_value};
use twinedge::dcel::{Dcel, HalfEdge};
use twinedge::delegate_view;
use twinedge::validate::{
    Collect, Expectation, Link, Part, Parts, Record, Report, Rule, Table, Unchecked, View, Violation,
};
use twinedge_geometry::Point;
use twinedge_map::{Builder, Embedding, PlanarMap, places};

const PLANE: Expectation = Expectation::plane();

/// A structure with other coordinates than its map.
type Redrawn = Drawn<Dcel>;

fn redrawn(map: &PlanarMap) -> Redrawn {
    Drawn::new(map.dcel().clone(), points_of(map))
}

impl Redrawn {
    /// The index of the vertex at this point.
    fn at(&self, x: f64, y: f64) -> usize {
        let found = (0..self.points.len()).find(|v| self.is_vertex(*v) && self.points[*v] == Point::new(x, y));
        found.expect("there is a vertex at this point")
    }

    fn moved(mut self, from: [f64; 2], to: [f64; 2]) -> Self {
        let v = self.at(from[0], from[1]);
        self.points[v] = to.into();
        self
    }

    /// The broken rules, each once.
    fn broken(&self) -> Vec<Rule> {
        self.report(&PLANE).outcomes().filter(|(_, outcome)| outcome.violations > 0).map(|(rule, _)| rule).collect()
    }
}

fn map(segments: &[[[f64; 2]; 2]]) -> PlanarMap {
    let mut builder = Builder::new();
    for [from, to] in segments {
        builder.segment(*from, *to).expect("small numbers are in range");
    }
    builder.build().expect("a small map fits")
}

fn square(x: f64, y: f64, side: f64) -> Vec<[[f64; 2]; 2]> {
    let corners = [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
    (0..4).map(|i| [corners[i], corners[(i + 1) % 4]]).collect()
}

/// Four edges from the origin, one in each direction.
fn star() -> PlanarMap {
    map(&[[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]].map(|end| [[0.0, 0.0], end]))
}

#[test]
fn g1_a_coordinate_that_is_not_finite() {
    for bad in [f64::NAN, f64::INFINITY, 1e300, 1e-300] {
        let drawn = redrawn(&star()).moved([1.0, 0.0], [bad, 0.0]);
        let report = drawn.report(&PLANE);
        assert_eq!(drawn.broken(), [Rule::G1], "{bad}");
        assert!(matches!(report.violations(), [Violation::NotFinite { .. }]));
        for rule in [Rule::G2, Rule::G3, Rule::G4, Rule::G5] {
            assert_eq!(report.outcome(rule).and_then(|o| o.unchecked), Some(Unchecked::Broken(Rule::G1)));
        }
    }
}

#[test]
fn g1_an_edge_of_zero_length() {
    let drawn = redrawn(&star()).moved([1.0, 0.0], [0.0, 0.0]);
    assert_eq!(drawn.broken(), [Rule::G1]);
    assert!(matches!(drawn.report(&PLANE).violations(), [Violation::ZeroLength { .. }]));
}

#[test]
fn g2_two_leaves_of_a_star_have_changed_places() {
    let drawn =
        redrawn(&star()).moved([1.0, 0.0], [9.0, 9.0]).moved([0.0, 1.0], [1.0, 0.0]).moved([9.0, 9.0], [0.0, 1.0]);
    assert_eq!(drawn.broken(), [Rule::G2]);
    let center = drawn.at(0.0, 0.0);
    let report = drawn.report(&PLANE);
    assert!(matches!(report.violations(), [Violation::OutOfOrder { vertex, .. }] if *vertex == center));
    assert_eq!(report.outcome(Rule::G5).and_then(|o| o.unchecked), Some(Unchecked::Broken(Rule::G2)));
}

#[test]
fn g3_a_square_seen_in_a_mirror() {
    let mut drawn = redrawn(&map(&square(0.0, 0.0, 1.0)));
    for point in &mut drawn.points {
        point.x = -point.x;
    }
    assert_eq!(drawn.broken(), [Rule::G3]);
    let report = drawn.report(&PLANE);
    assert!(report.violations().iter().any(|v| matches!(v, Violation::OuterClockwise { .. })));
    assert!(report.violations().iter().any(|v| matches!(v, Violation::InnerCounterClockwise { .. })));
}

#[test]
fn g4_a_square_twisted_into_a_bow_tie() {
    let drawn = redrawn(&map(&square(0.0, 0.0, 1.0)));
    let drawn = drawn.moved([1.0, 1.0], [9.0, 9.0]).moved([0.0, 1.0], [1.0, 1.0]).moved([9.0, 9.0], [0.0, 1.0]);
    assert_eq!(drawn.broken(), [Rule::G4]);
    let report = drawn.report(&PLANE);
    let [cross @ Violation::Cross { .. }] = report.violations() else { panic!("{report}") };
    assert_eq!(places(&drawn, cross).len(), 4);
    assert_eq!(report.outcome(Rule::G3).and_then(|o| o.unchecked), Some(Unchecked::Broken(Rule::G4)));
}

#[test]
fn g4_a_vertex_inside_an_edge_an_overlap_and_two_vertices_at_one_point() {
    let two = || map(&[[[0.0, 0.0], [4.0, 0.0]], [[1.0, 1.0], [2.0, 2.0]]]);
    let touch = redrawn(&two()).moved([1.0, 1.0], [1.0, 0.0]);
    assert_eq!(touch.broken(), [Rule::G4]);
    let at = touch.at(1.0, 0.0);
    assert!(matches!(touch.report(&PLANE).violations(), [Violation::Touch { vertex, .. }] if *vertex == at));

    let overlap = redrawn(&two()).moved([1.0, 1.0], [1.0, 0.0]).moved([2.0, 2.0], [6.0, 0.0]);
    assert_eq!(overlap.broken(), [Rule::G4]);
    assert!(matches!(overlap.report(&PLANE).violations(), [Violation::Overlap { .. }]));

    let same = redrawn(&two()).moved([1.0, 1.0], [4.0, 0.0]);
    assert_eq!(same.broken(), [Rule::G4]);
    assert!(matches!(same.report(&PLANE).violations(), [Violation::SamePlace { .. }]));
}

#[test]
fn g4_an_isolated_vertex_on_an_edge() {
    let mut builder = Builder::new();
    builder.segment([0.0, 0.0], [4.0, 0.0]).expect("in range");
    builder.shape(&twinedge_map::Shape::Point(Point::new(1.0, 1.0))).expect("in range");
    let drawn = redrawn(&builder.build().expect("fits")).moved([1.0, 1.0], [1.0, 0.0]);
    assert_eq!(drawn.broken(), [Rule::G4]);
}

#[test]
fn g5_an_island_listed_by_the_face_next_door() {
    let segments = [square(0.0, 0.0, 10.0), square(20.0, 0.0, 10.0), square(2.0, 2.0, 1.0)].concat();
    let mut drawn = redrawn(&map(&segments));
    assert_eq!(drawn.broken(), []);
    let island = drawn.structure.vertex_at(drawn.at(2.0, 2.0)).expect("it is there");
    let inner = island.rotation().map(HalfEdge::boundary).find(|b| !b.is_outer()).expect("it has an outside").key();
    let next_door = drawn.structure.vertex_at(drawn.at(20.0, 0.0)).expect("it is there");
    let face = next_door.rotation().map(HalfEdge::face).find(|f| !f.is_unbounded()).expect("it has an inside").key();
    drawn.structure.move_inner(inner, face).expect("topology does not mind");
    assert_eq!(drawn.broken(), [Rule::G5]);
    let boundary = drawn.structure.boundary(inner).expect("it is there").index();
    let report = drawn.report(&PLANE);
    assert!(
        matches!(report.violations(), [Violation::WrongFace { boundary: Record::Boundary(b), .. }] if *b == boundary)
    );
}

#[test]
fn crossings_are_counted_beyond_those_that_are_kept() {
    // Ten edges across ten others.
    let line = |i: u32, across: bool| {
        let i = f64::from(i);
        if across { [[i, -1.0], [i, 10.0]] } else { [[-1.0, i], [10.0, i]] }
    };
    let segments: Vec<_> = (0..10).flat_map(|i| [line(i, false), line(i, true)]).collect();
    let map = map(&segments);
    assert!(!map.is_plane());
    let report = validate_embedding(&map, &PLANE, Collect::AtMost(7));
    assert_eq!(report.violations().len(), 7);
    assert_eq!(report.outcome(Rule::G4).map(|o| o.violations), Some(100));
    assert_eq!(validate_embedding(&map, &PLANE, Collect::First).violations().len(), 1);
}

#[test]
fn each_rule_of_coordinates_says_how_much_it_checked() {
    let report = redrawn(&map(&square(0.0, 0.0, 2.0))).report(&PLANE);
    for rule in [Rule::G1, Rule::G2, Rule::G3, Rule::G4, Rule::G5] {
        assert!(report.outcome(rule).is_some_and(|outcome| outcome.checked > 0), "{rule}");
    }
}

#[test]
fn topology_that_is_broken_leaves_geometry_unchecked() {
    struct Tables(Table, fn(usize) -> Link);
    impl Embedding for Tables {
        fn point(&self, _: usize) -> Point {
            Point::default()
        }
    }
    impl View for Tables {
        delegate_view!(|this| &this.0; except twin);
        fn twin(&self, half_edge: usize) -> Link {
            (self.1)(half_edge)
        }
    }
    let table = Table { parts: Parts::NONE, ..Table::copy_of(star().dcel()).expect("a star fits") };
    let twins: [fn(usize) -> Link; 2] = [|_| None, Some];
    for (twin, broken) in twins.into_iter().zip([Rule::R1, Rule::L1]) {
        let tables = Tables(table.clone(), twin);
        for (collect, why) in [(Collect::All, Unchecked::Broken(broken)), (Collect::First, Unchecked::Stopped)] {
            let report = validate_embedding(&tables, &PLANE, collect);
            for rule in [Rule::G1, Rule::G2, Rule::G3, Rule::G4, Rule::G5] {
                assert_eq!(report.outcome(rule).and_then(|o| o.unchecked), Some(why), "{rule}");
            }
        }
    }
}

/// The coordinates of the vertices of the nested triangles, while answers are consistent.
const POINTS: [[f64; 2]; 7] = [[0.0, 0.0], [10.0, 0.0], [5.0, 10.0], [4.0, 1.0], [6.0, 1.0], [5.0, 3.0], [7.0, 3.0]];

impl Embedding for Inconsistent<'_> {
    fn point(&self, vertex: usize) -> Point {
        let strange = [f64::NAN, f64::INFINITY, 0.0, -0.0, 1e300, f64::MIN_POSITIVE, 5.0];
        match self.noise() {
            Some(u64::MAX) => POINTS[vertex].into(),
            Some(noise) => Point::new(strange[noise as usize % 7], strange[noise as usize / 7 % 7]),
            None => Point::new(f64::NAN, f64::NAN),
        }
    }
}

#[test]
fn answers_may_change_from_call_to_call() {
    for table in [nested(), nested_textbook()] {
        let consistent = Inconsistent::new(&table, u64::MAX, 0);
        assert!(validate_embedding(&consistent, &PLANE, Collect::All).is_valid());
        let questions = consistent.questions.get();
        let without = table.without(Part::UnboundedFace);
        for (table, expectation) in [(&table, PLANE), (&table, PLANE.open()), (&without, PLANE.open())] {
            for consistent_answers in 0..questions {
                for seed in 0..15 {
                    let view = Inconsistent::new(table, consistent_answers, seed);
                    let report = validate_embedding(&view, &expectation, Collect::All);
                    let asked = view.questions.get();
                    // The fast path may read nearly everything before it fails, and then every rule reads again.
                    assert!(asked <= 5 * questions, "{asked} questions, {questions} if consistent\n{report}");
                    for violation in report.violations() {
                        assert!(places(&view, violation).len() <= 4);
                    }
                }
            }
        }
    }
}

fn read_again(report: &Report) -> Report {
    from_value(to_value(report).unwrap()).unwrap()
}

/// Coordinates are checked by all five rules or by none.
#[test]
fn a_report_with_some_of_the_rules_of_coordinates_is_refused() {
    let report = PlanarMap::new().validate();
    assert_eq!(read_again(&report), report);
    let geometric: Vec<Rule> = Rule::ALL.iter().copied().filter(|rule| rule.is_geometric()).collect();
    for left in 0..1_usize << geometric.len() {
        let is_left = |rule: Rule| geometric.iter().position(|g| *g == rule).is_none_or(|i| left >> i & 1 == 1);
        let mut value = to_value(&report).unwrap();
        value["rules"].as_array_mut().unwrap().retain(|entry| is_left(from_value(entry["id"].clone()).unwrap()));
        let missing = geometric.iter().find(|rule| !is_left(**rule)).filter(|_| left > 0);
        let found = from_value::<Report>(value).err().map(|error| error.to_string());
        assert_eq!(found, missing.map(|rule| format!("{rule} has no outcome")));
    }
}
