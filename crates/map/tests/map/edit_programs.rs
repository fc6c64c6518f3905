//! Programs of edits: their text, their interpretation, every edit on small maps, and shrinking.

use crate::support::drawn::crossing;
use crate::support::programs::{drawn, noise, pinned};
use arbitrary::{Arbitrary, Unstructured};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, TestCaseError, TestError, TestRunner};
use quickcheck::{Gen, QuickCheck};
use std::collections::{BTreeMap, BTreeSet};
use twinedge::program::choose::{Choose, Random};
use twinedge::program::{Expected, ParseError, Program, candidates, shrink};
use twinedge::validate::Rule;
use twinedge_map::PlanarMap;
use twinedge_map::edit::EditError;
use twinedge_map::program::*;
use twinedge_map::program::{EditKind, EditProgram};

fn random(seed: u64, bytes: usize) -> EditProgram {
    EditProgram::from_bytes(&noise(seed).take(bytes).collect::<Vec<_>>())
}

fn at(x: f64, y: f64) -> AtPick {
    AtPick::Point(Spot::new(x, y))
}

fn program(text: &str) -> EditProgram {
    format!("twinedge edits 1\n{text}").parse().expect("it is a program")
}

fn run(text: &str) -> (EditRunner, Vec<EditOutcome>) {
    let mut runner = EditRunner::new(PlanarMap::new());
    let outcomes = runner.run_checked(&program(text)).unwrap_or_else(|failure| panic!("{failure}"));
    (runner, outcomes)
}

/// One edit of each kind, with arguments of each kind.
fn sampler() -> EditProgram {
    let v = MapVertexPick::Live;
    EditProgram(vec![
        EditOp::InsertPoint { at: at(1.0, -2.5) },
        EditOp::InsertPoint { at: at(-0.0, f64::NAN) },
        EditOp::InsertSegment { from: at(1e300, 0.1), to: AtPick::Vertex(v(3)) },
        EditOp::InsertSegment {
            from: AtPick::Near(Spot::new(f64::INFINITY, f64::NEG_INFINITY), MapHalfEdgePick::Live(7)),
            to: AtPick::Near(Spot::new(0.0, 0.0), MapHalfEdgePick::Retired(0)),
        },
        EditOp::InsertSegmentSnapped { from: at(0.0, 0.0), to: at(5e-324, 1.0), snap: GridPick::Auto },
        EditOp::InsertSegmentSnapped { from: at(0.0, 0.0), to: at(3.0, 1.0), snap: GridPick::Size(0.25.into()) },
        EditOp::InsertRing {
            points: RingPick(vec![at(0.0, 0.0), AtPick::Vertex(MapVertexPick::Retired(65535)), at(2.0, 3.0)]),
        },
        EditOp::InsertRing { points: RingPick(vec![]) },
        EditOp::RemoveEdge { half_edge: MapHalfEdgePick::Retired(12) },
        EditOp::RemoveVertex { vertex: v(0) },
        EditOp::MoveVertex { vertex: v(1), to: Spot::new(4.0, 5.0) },
        EditOp::AddFeature {},
        EditOp::SetFeaturesOf { face: MapFacePick::Live(0), features: FeaturesPick(0b1000_0000_0000_0101) },
        EditOp::SetFeaturesOf { face: MapFacePick::Retired(1), features: FeaturesPick(0) },
        EditOp::SetFeaturesAlong { half_edge: MapHalfEdgePick::Live(2), features: FeaturesPick(2) },
    ])
}

#[test]
fn text_says_what_a_program_does() {
    let expected = "\
twinedge edits 1
insert_point 1,-2.5
insert_point -0,NaN
insert_segment 1e300,0.1 v3
insert_segment inf,-inf@h7 0,0@!h0
insert_segment_snapped 0,0 5e-324,1 auto
insert_segment_snapped 0,0 3,1 0.25
insert_ring 0,0 !v65535 2,3
insert_ring
remove_edge !h12
remove_vertex v0
move_vertex v1 4,5
add_feature
set_features_of f0 0,2,15
set_features_of !f1 none
set_features_along h2 1
";
    assert_eq!(sampler().to_string(), expected);
    assert_eq!(expected.parse(), Ok(sampler()));
    let kinds: BTreeSet<&str> = sampler().0.iter().map(EditOp::name).collect();
    assert_eq!(kinds, EditOp::NAMES.iter().copied().collect());
}

#[test]
fn random_programs_come_back_from_their_text() {
    for seed in 0..200 {
        let program = random(seed, 300);
        assert!(program.0.len() > 12);
        assert_eq!(program.to_string().parse(), Ok(program));
    }
}

#[test]
fn what_is_no_program_is_refused_with_its_place() {
    let cases = [
        ("", 1, 1, Expected::EditsHeader),
        ("twinedge program 1", 1, 1, Expected::EditsHeader),
        ("insert_line 0,0", 2, 1, Expected::Operator),
        ("insert_point", 2, 13, Expected::At),
        ("insert_point 0", 2, 14, Expected::At),
        ("insert_point 0,0@v0", 2, 14, Expected::At),
        ("insert_point h0", 2, 14, Expected::At),
        ("insert_point 0,0 1,1", 2, 18, Expected::End),
        ("insert_segment_snapped 0,0 1,1 fine", 2, 32, Expected::Grid),
        ("insert_ring 0,0 f0", 2, 17, Expected::At),
        ("remove_edge v0", 2, 13, Expected::HalfEdge),
        ("remove_vertex h0", 2, 15, Expected::MapVertex),
        ("move_vertex v0 v1", 2, 16, Expected::Point),
        ("set_features_of h0 1", 2, 17, Expected::MapFace),
        ("set_features_of f0 1,0", 2, 20, Expected::Features),
    ];
    for (text, line, column, expected) in cases {
        let text = if expected == Expected::EditsHeader { text.into() } else { format!("twinedge edits 1\n{text}") };
        assert_eq!(text.parse::<EditProgram>(), Err(ParseError { line, column, expected }), "{text:?}");
    }
}

#[test]
fn picks_count_in_order_of_creation_and_start_again() {
    // A triangle with edges h0 to h5 and corners v0 to v2; the first edge is removed, and a point reuses its slot.
    let (runner, outcomes) = run("insert_ring 0,0 4,0 0,4\nremove_vertex v0\ninsert_segment 9,9 8,8\nremove_vertex v2");
    assert!(outcomes.iter().all(|outcome| matches!(outcome, EditOutcome::Applied(_))));
    // The third corner after the removal of the first is the oldest end of the segment.
    let left: Vec<[f64; 2]> =
        runner.map().dcel().vertices().map(|v| runner.map().position(v.key()).expect("of this map").into()).collect();
    assert_eq!(left.len(), 3);
    assert!(left.contains(&[4.0, 0.0]) && left.contains(&[0.0, 4.0]), "{left:?}");
    let (_, outcomes) =
        run("insert_point 1,1\nremove_vertex v5\nremove_vertex v0\ninsert_point !v3\ninsert_point 2,2@h0");
    assert!(matches!(outcomes[1], EditOutcome::Applied(_)));
    assert_eq!(outcomes[2], EditOutcome::Skipped);
    assert!(matches!(outcomes[3], EditOutcome::Refused(EditError::Operator(_))));
    assert_eq!(outcomes[4], EditOutcome::Skipped);
}

/// Returns the kind of an outcome: for a refusal, the kind of its error.
fn kind(outcome: &EditOutcome) -> &'static str {
    match outcome {
        EditOutcome::Applied(_) => "applied",
        EditOutcome::Skipped => "skipped",
        EditOutcome::Refused(error) => match error {
            EditError::Operator(_) => "stale",
            EditError::NotFinite { .. } => "not finite",
            EditError::OutOfRange { .. } => "out of range",
            EditError::NoLength { .. } => "no length",
            EditError::Crosses(_) => "crosses",
            EditError::NotARing { .. } => "not a ring",
            EditError::SelfCrossing { .. } => "crosses itself",
            EditError::VertexInTheWay(_) => "vertex in the way",
            EditError::EdgeInTheWay(_) => "edge in the way",
            EditError::NotOnGrid(_) => "not on the grid",
            EditError::CellSize => "cell size",
            EditError::OutOfReach { .. } => "out of reach",
            EditError::NoSuchFeature(_) => "no such feature",
            _ => "something else",
        },
    }
}

#[test]
fn random_programs_keep_every_rule_and_are_refused_for_every_reason() {
    let mut counts = BTreeMap::new();
    let mut faces = 0;
    for seed in 0..150 {
        let program = random(seed, 900);
        let mut runner = EditRunner::new(PlanarMap::new());
        let outcomes = runner.run_checked(&program).unwrap_or_else(|failure| panic!("{failure}\n{program}"));
        for outcome in &outcomes {
            *counts.entry(kind(outcome)).or_insert(0) += 1;
        }
        faces += runner.map().dcel().face_count();
    }
    let sum: i32 = counts.values().sum();
    assert!(counts["applied"] * 3 > sum, "less than a third is applied: {counts:?}");
    assert!(counts.len() == 15 && !counts.contains_key("something else"), "{counts:?}");
    assert!(faces > 200, "{faces} faces");
}

#[test]
fn a_map_that_is_not_valid_is_found_after_the_first_edit() {
    let crossing = crossing();
    let why = crossing.not_plane().expect("the segments cross");
    let mut runner = EditRunner::new(crossing);
    let outcomes = runner.run_checked(&program("insert_point 5,5")).expect("a refusal changes nothing");
    assert_eq!(outcomes, [EditOutcome::Refused(why.into())]);
    let failure = runner.run_checked(&program("add_feature")).expect_err("the map breaks G4");
    let EditFailure::Invalid { number: 2, op: EditOp::AddFeature {}, report } = &failure else { panic!("{failure}") };
    assert_eq!(report.first().unwrap().rule(), Rule::G4);
    assert!(failure.to_string().starts_with("after edit 2 (`add_feature`):\n"), "{failure}");
}

#[test]
fn a_refusal_that_changes_the_map_would_be_said() {
    // No edit does so; a deliberately broken edit confirmed that it would be detected.
    let failure =
        EditFailure::Changed { number: 3, op: EditOp::InsertPoint { at: at(1.0, 2.0) }, error: EditError::CellSize };
    let expected = format!("edit 3 (`insert_point 1,2`) was refused ({}), but changed the map", EditError::CellSize);
    assert_eq!(failure.to_string(), expected);
}

/// All maps that `depth` edits can make of these points, by their saved form and all their keys, and the number of tried edits.
fn every(points: &[Spot], depth: usize) -> (usize, BTreeMap<&'static str, u64>) {
    let mut counts = BTreeMap::new();
    let mut level = vec![EditRunner::new(PlanarMap::new())];
    let mut seen = BTreeSet::new();
    for _ in 0..depth {
        let mut next = Vec::new();
        for map in &level {
            for op in every_edit(map, points) {
                let mut attempt = map.clone();
                let outcome = attempt.step_checked(&op).unwrap_or_else(|failure| panic!("{failure}"));
                *counts.entry(kind(&outcome)).or_insert(0) += 1;
                assert!(matches!(outcome, EditOutcome::Applied(_)) || attempt.map() == map.map(), "{op}");
                let told = format!("{attempt:?} {}", serde_json::to_value(attempt.map()).unwrap());
                if matches!(outcome, EditOutcome::Applied(_)) && seen.insert(told) {
                    next.push(attempt);
                }
            }
        }
        level = next;
    }
    (seen.len(), counts)
}

#[test]
fn every_edit_of_a_small_grid_keeps_every_rule() {
    let spots = [(0.0, 0.0), (2.0, 0.0), (1.0, 1.0), (0.0, 2.0)].map(|(x, y)| Spot::new(x, y));
    // The last two of four points are collinear with the second, and three edits are enough to make a key stale and use it.
    let (of_four, met_with_four) = every(&spots, 2);
    let (of_two, met_with_two) = every(&spots[..2], 3);
    assert!(of_four > 300 && of_two > 100, "{of_four}, {of_two} maps");
    let met: BTreeSet<&str> = met_with_four.keys().chain(met_with_two.keys()).copied().collect();
    for outcome in ["applied", "stale", "no length", "no such feature", "vertex in the way", "edge in the way"] {
        assert!(met.contains(outcome), "{outcome}: {met:?}");
    }
}

/// Returns true if a program puts something into a bounded face.
fn makes_hole(program: &EditProgram) -> bool {
    let mut runner = EditRunner::new(PlanarMap::new());
    runner.run(program);
    let map = runner.into_map();
    map.dcel().faces().any(|f| !f.is_unbounded() && f.inner_count() > 0)
}

/// Checks that dropping or simplifying anything removes the failure, and that there are few edits.
#[track_caller]
fn assert_smallest(small: &EditProgram) {
    assert!(makes_hole(small));
    assert!(candidates(small).all(|smaller| !makes_hole(&smaller)), "{small}");
    assert!(small.0.len() <= 6, "{small}");
}

#[test]
fn shrinking_goes_on_until_nothing_more_can_be_left_out() {
    let mut lengths = Vec::new();
    for seed in 0..60 {
        let program = random(seed, 600);
        if makes_hole(&program) {
            let small = shrink(&program, makes_hole);
            assert_smallest(&small);
            lengths.push(small.0.len());
        }
    }
    assert!(lengths.len() >= 3 && lengths.contains(&2), "{lengths:?}");
}

#[test]
fn numbers_come_down_to_the_simplest_that_will_do() {
    let shrunk = |number: f64, lowest: f64, highest: f64| {
        let fails = |program: &EditProgram| {
            let inside = |p: &Spot| (lowest..=highest).contains(&p.point().x);
            program.0.iter().any(|op| matches!(op, EditOp::InsertPoint { at: AtPick::Point(p) } if inside(p)))
        };
        let program = EditProgram(vec![EditOp::AddFeature {}, EditOp::InsertPoint { at: at(number, -3.0) }]);
        let small = shrink(&program, fails).to_string();
        small.strip_prefix("twinedge edits 1\ninsert_point ").expect("the point is left").trim_end().to_owned()
    };
    for (number, lowest, highest, expected) in [
        (1234.567, 5.0, 2000.0, "5,0"),
        (0.3, 0.2, 0.4, "0.25,0"),
        (-7.25, -8.0, 8.0, "0,0"),
        (-7.25, -8.0, -3.5, "-4,0"),
        (f64::INFINITY, 1.0, f64::INFINITY, "1,0"),
        // Too large to be counted down, so only bits are cleared: this is 2^996.
        (1e300, 1e299, 2e300, "6.696928794914171e299,0"),
    ] {
        assert_eq!(shrunk(number, lowest, highest), expected);
    }
}

#[test]
fn each_argument_has_its_simpler_ones() {
    let cases: [(&str, &[&str]); 9] = [
        ("insert_point -2.5,0", &["insert_point 0,0", "insert_point -1,0", "insert_point -2,0", "insert_point 2.5,0"]),
        ("insert_point 0,0@!h1", &["insert_point 0,0", "insert_point 0,0@h1", "insert_point 0,0@!h0"]),
        ("insert_ring 0,0 v1", &["insert_ring v1", "insert_ring 0,0", "insert_ring 0,0 v0"]),
        ("insert_segment_snapped 0,0 0,0 auto", &["insert_segment_snapped 0,0 0,0 1"]),
        ("insert_segment_snapped 0,0 0,0 0", &["insert_segment_snapped 0,0 0,0 1"]),
        ("set_features_of f0 0,2", &["set_features_of f0 none", "set_features_of f0 2", "set_features_of f0 0"]),
        ("remove_vertex !v0", &["remove_vertex v0"]),
        ("move_vertex v2 0,0", &["move_vertex v0 0,0", "move_vertex v1 0,0"]),
        ("add_feature", &[]),
    ];
    for (op, expected) in cases {
        let op: EditOp = op.parse().expect("it is an edit");
        let simpler: Vec<String> = op.simpler().iter().map(EditOp::to_string).collect();
        assert_eq!(simpler, expected, "{op}");
    }
}

#[test]
fn what_remains_of_a_program_goes_on_choosing_the_same() {
    let (ring, other) = ("insert_ring 9,9 8,9 8,8\n", "insert_ring 0,0 1,0 1,1\n");
    for (dropped, kept, last, followed) in [
        ("insert_point 9,9\n", "insert_segment 0,0 1,0\n", "remove_vertex v2", "remove_vertex v1"),
        ("insert_point 9,9\n", "insert_segment 0,0 1,0\n", "remove_edge h0", "remove_edge h0"),
        ("insert_point 9,9\n", "insert_segment 0,0 1,0\n", "insert_segment v2 5,5", "insert_segment v1 5,5"),
        ("insert_segment 9,9 8,8\n", "insert_segment 0,0 1,0\n", "insert_point 5,5@h2", "insert_point 5,5@h0"),
        (ring, other, "set_features_of f2 none", "set_features_of f1 none"),
        (ring, other, "set_features_of f0 none", "set_features_of f0 none"),
    ] {
        let long = program(&format!("{dropped}{kept}{last}"));
        let short = program(&format!("{kept}{followed}"));
        assert!(candidates(&long).any(|candidate| candidate == short), "{long}");
    }
}

#[test]
fn quickcheck_runs_and_shrinks_programs() {
    fn keeps_every_rule(program: EditProgram) -> bool {
        EditRunner::new(PlanarMap::new()).run_checked(&program).is_ok()
    }
    QuickCheck::new()
        .rng(Gen::from_size_and_seed(40, 2026))
        .tests(60)
        .quickcheck(keeps_every_rule as fn(EditProgram) -> bool);
}

/// A deterministic runner that writes nothing to disk.
fn runner() -> TestRunner {
    let config = Config { max_shrink_iters: 100_000, failure_persistence: None, ..Config::default() };
    let rng = proptest::test_runner::TestRng::deterministic_rng(config.rng_algorithm);
    TestRunner::new_with_rng(config, rng)
}

#[test]
fn proptest_shrinks_programs_edit_by_edit() {
    let outcome = runner().run(&EditProgram::generator(), |program| {
        if makes_hole(&program) { Err(TestCaseError::fail("a hole")) } else { Ok(()) }
    });
    let Err(TestError::Fail(_, small)) = outcome else { panic!("no program made a hole: {outcome:?}") };
    assert_smallest(&small);
}

#[test]
fn proptest_makes_maps_and_shrinks_them() {
    let maps = proptest::arbitrary::any_with::<PlanarMap>(EditProgram::generator().length(0..=80));
    let outcome = runner().run(&maps, |map| {
        assert!(map.validate().is_valid());
        if map.dcel().face_count() > 3 { Err(TestCaseError::fail("four faces")) } else { Ok(()) }
    });
    let Err(TestError::Fail(_, small)) = outcome else { panic!("no map has four faces: {outcome:?}") };
    assert_eq!(small.dcel().face_count(), 4);
    let tree = maps.new_tree(&mut runner()).expect("a map can always be made");
    let counts = |map: PlanarMap| *map.validate().counts();
    assert_eq!(counts(tree.current()), counts(tree.current()));
}

#[test]
fn proptest_chooses_every_number_below_the_bound() {
    let mut runner = runner();
    let chosen: BTreeSet<usize> = (0..200).map(|_| runner.choose(5)).collect();
    assert_eq!(chosen, (0..5).collect());
    assert_eq!(runner.choose(0), 0);
}

#[test]
fn bytes_are_the_programs_that_they_were() {
    let bytes = drawn(20_000);
    pinned(&EditProgram::from_bytes(&bytes).to_string(), 0x9070_4C81_7D47_C48C);
    pinned(&EditProgram::arbitrary(&mut Unstructured::new(&bytes)).unwrap().to_string(), 0x7B8A_3488_6836_25FA);
    pinned(&EditProgram::arbitrary_take_rest(Unstructured::new(&bytes)).unwrap().to_string(), 0x9070_4C81_7D47_C48C);
    // An edit without arguments takes no byte, but decoding still ends.
    let features = EditProgram::generator().only(&[EditKind::AddFeature]).decode(&[1, 2, 3]);
    assert_eq!(features.to_string(), "twinedge edits 1\nadd_feature\nadd_feature\nadd_feature\n");
}

#[test]
fn random_programs_are_those_that_they_were() {
    let edits = EditProgram::generator().length(300..=400);
    pinned(&edits.generate(&mut Random::seeded(1)).to_string(), 0x3701_4E6E_CE0E_31BD);
}

#[test]
fn programs_are_printed_as_they_were() {
    let bytes = drawn(5_000);
    let both = format!("{:?} {:?}", Program::from_bytes(&bytes), EditProgram::from_bytes(&bytes));
    pinned(&both, 0xD921_D5DB_06B3_5DBF);
}

#[test]
fn candidates_are_those_that_they_were() {
    let edits = EditProgram::from_bytes(&drawn(60));
    let text: String = candidates(&edits).map(|smaller| smaller.to_string()).collect();
    pinned(&text, 0xF595_6AC2_DA6C_D0E4);
}
