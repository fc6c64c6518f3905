//! The language of programs: its text, its Rust source, and its interpretation.

use crate::support::programs::{noise, random};
use arbitrary::{Arbitrary, Unstructured};
use quickcheck::Gen;
use twinedge::dcel::Dcel;
use twinedge::program::*;
use twinedge::validate::Table;
use twinedge_trials::RawPointers;

/// One operator of each kind, with picks of each kind.
fn sampler() -> Program {
    let corner = Corner::At(HalfEdgePick::Live(3));
    Program(vec![
        Op::AddIsolatedVertex { face: FacePick::Unbounded },
        Op::AddIsolatedVertex { face: FacePick::Of(corner) },
        Op::AddIsolatedVertex { face: FacePick::Retired(2) },
        Op::RemoveIsolatedVertex { vertex: VertexPick::Isolated(0) },
        Op::RemoveIsolatedVertex { vertex: VertexPick::OriginOf(7) },
        Op::RemoveIsolatedVertex { vertex: VertexPick::Retired(65535) },
        Op::Connect { from: corner, to: SecondPick::Fitting(1), new_face: Side::Left, inner: InnerPick::default() },
        Op::Connect {
            from: Corner::Isolated(VertexPick::Isolated(0)),
            to: SecondPick::Any(corner),
            new_face: Side::Right,
            inner: InnerPick { mask: 0b1000_0000_0000_0101, also: Some(Corner::At(HalfEdgePick::Retired(4))) },
        },
        Op::RemoveEdge { half_edge: HalfEdgePick::Live(0) },
        Op::SplitEdge { half_edge: HalfEdgePick::Retired(0) },
        Op::JoinEdges { half_edge: HalfEdgePick::Live(1) },
        Op::SplitVertex { from: corner, to: SecondPick::Fitting(0) },
        Op::ContractEdge { half_edge: HalfEdgePick::Live(2) },
        Op::FlipEdge { half_edge: HalfEdgePick::Live(0), turn: Turn::CounterClockwise },
        Op::FlipEdge { half_edge: HalfEdgePick::Live(0), turn: Turn::Clockwise },
        Op::MoveInner { inner: Corner::Isolated(VertexPick::OriginOf(1)), face: FacePick::Unbounded },
    ])
}

#[test]
fn text_says_what_a_program_does() {
    let expected = "\
twinedge program 1
add_isolated_vertex unbounded
add_isolated_vertex h3
add_isolated_vertex !f2
remove_isolated_vertex i0
remove_isolated_vertex o7
remove_isolated_vertex !v65535
connect h3 ~1 left
connect i0 h3 right inner 0,2,15 also !h4
remove_edge h0
split_edge !h0
join_edges h1
split_vertex h3 ~0
contract_edge h2
flip_edge h0 ccw
flip_edge h0 cw
move_inner o1 unbounded
";
    assert_eq!(sampler().to_string(), expected);
    assert_eq!(expected.parse(), Ok(sampler()));
}

#[test]
fn text_may_have_comments_blanks_and_any_line_ends() {
    let text =
        "# found by a fuzzer\r\n\n  twinedge  program 1 # version\r\n\tremove_edge\th0   # why\r\n\n#\nsplit_edge h1";
    let expected =
        [Op::RemoveEdge { half_edge: HalfEdgePick::Live(0) }, Op::SplitEdge { half_edge: HalfEdgePick::Live(1) }];
    assert_eq!(text.parse(), Ok(expected.into_iter().collect::<Program>()));
}

#[test]
fn random_programs_come_back_from_their_text() {
    for seed in 0..200 {
        let program = random(seed, 200);
        assert!(program.0.len() > 12);
        assert_eq!(program.to_string().parse(), Ok(program));
    }
}

#[test]
fn what_is_no_program_is_refused_with_its_place() {
    let cases = [
        ("", 1, 1, Expected::Header),
        ("\n\nremove_edge h0", 3, 1, Expected::Header),
        ("twinedge program 2", 1, 1, Expected::Header),
        ("remove_face h0", 2, 1, Expected::Operator),
        ("  remove_edge", 2, 14, Expected::HalfEdge),
        ("remove_edge i0", 2, 13, Expected::HalfEdge),
        ("remove_edge h4294967296", 2, 13, Expected::HalfEdge),
        ("remove_edge h+1", 2, 13, Expected::HalfEdge),
        ("remove_edge h", 2, 13, Expected::HalfEdge),
        ("remove_edge h0 h1", 2, 16, Expected::End),
        ("remove_isolated_vertex h0", 2, 24, Expected::Vertex),
        ("connect ~0 ~1 left", 2, 9, Expected::Corner),
        ("connect h0 unbounded left", 2, 12, Expected::SecondCorner),
        ("connect h0 ~1 over", 2, 15, Expected::Side),
        ("connect h0 ~1 left inner 1,0", 2, 26, Expected::Inner),
        ("connect h0 ~1 left inner 16", 2, 26, Expected::Inner),
        ("connect h0 ~1 left inner", 2, 25, Expected::Inner),
        ("connect h0 ~1 left also", 2, 24, Expected::Corner),
        ("connect h0 ~1 left äöü also h0", 2, 20, Expected::End),
        ("flip_edge h0", 2, 13, Expected::Turn),
        ("add_isolated_vertex !h", 2, 21, Expected::Face),
    ];
    for (text, line, column, expected) in cases {
        let text = if expected == Expected::Header { text.into() } else { format!("twinedge program 1\n{text}") };
        assert_eq!(text.parse::<Program>(), Err(ParseError { line, column, expected }), "{text:?}");
    }
    let error = "twinedge program 1\nflip_edge h0 left".parse::<Program>().unwrap_err();
    assert_eq!(error.to_string(), "line 2, column 14: expected a turn (`ccw` or `cw`)");
}

#[test]
fn rust_source_is_the_program() {
    // Pasted from the output, so it is known to compile.
    let pasted = "twinedge program 1
    add_isolated_vertex h3
    connect i0 h3 right inner 0,2,15 also !h4
    split_vertex h3 ~0
    flip_edge h0 cw
"
    .parse::<Program>()
    .unwrap();
    let sample = sampler();
    let chosen: Program = [1, 7, 11, 14].into_iter().map(|i| sample.0[i]).collect();
    assert_eq!(chosen, pasted);
    assert_eq!(
        chosen.to_rust(),
        "\
\"twinedge program 1
    add_isolated_vertex h3
    connect i0 h3 right inner 0,2,15 also !h4
    split_vertex h3 ~0
    flip_edge h0 cw
\".parse::<Program>().unwrap()"
    );
}

fn run(text: &str) -> (Runner<Dcel>, Vec<StepOutcome>) {
    let mut runner = Runner::new(Dcel::new());
    let program: Program = format!("twinedge program 1\n{text}").parse().unwrap();
    let outcomes = runner.run(&program);
    assert!(runner.subject().validate().is_valid());
    (runner, outcomes)
}

#[test]
fn picks_count_in_order_of_creation_and_start_again() {
    let (runner, outcomes) = run("\
        add_isolated_vertex unbounded\n\
        split_vertex i5 ~9\n\
        split_edge h4\n\
        split_edge h0\n");
    assert_eq!(outcomes, [StepOutcome::Applied; 4]);
    let map = runner.subject();
    let h = runner.half_edges();
    assert_eq!(h.len(), 6);
    for pair in h.chunks(2) {
        assert_eq!(map.half_edge(pair[0]).unwrap().twin().key(), pair[1]);
    }
    // `h4` was `h0` then; the newest half-edge follows it, and the older one comes after that.
    assert_eq!(map.half_edge(h[0]).unwrap().next().key(), h[4]);
    assert_eq!(map.half_edge(h[4]).unwrap().next().key(), h[2]);
}

#[test]
fn where_there_is_nothing_to_choose_from_the_subject_is_not_asked() {
    let (_, outcomes) = run("\
        remove_isolated_vertex i0\nremove_isolated_vertex o0\nremove_isolated_vertex !v0\n\
        connect h0 ~0 left\nconnect i0 ~0 left\nremove_edge h0\nremove_edge !h0\nadd_isolated_vertex !f0\n\
        add_isolated_vertex h0\nmove_inner i0 unbounded\n");
    assert!(outcomes.iter().all(|outcome| *outcome == StepOutcome::Skipped));
}

#[test]
fn everything_that_is_gone_can_be_asked_for_again_and_is_stale() {
    let (runner, outcomes) = run("\
        add_isolated_vertex unbounded\n\
        add_isolated_vertex unbounded\n\
        connect i0 i0 left\n\
        remove_edge h0\n\
        remove_isolated_vertex i0\n\
        split_vertex i0 i0\n\
        contract_edge h0\n");
    assert_eq!(outcomes, [StepOutcome::Applied; 7]);
    assert_eq!(runner.retired_half_edges().len(), 4);
    assert_eq!((runner.retired_vertices().len(), runner.retired_faces().len()), (2, 1));
    assert_eq!((runner.half_edges().len(), runner.isolated().len()), (0, 1));
    let mut runner = runner;
    let again = "\
        remove_edge !h3\nsplit_edge !h2\njoin_edges !h1\ncontract_edge !h0\nflip_edge !h0 cw\n\
        remove_isolated_vertex !v0\nremove_isolated_vertex !v1\nadd_isolated_vertex !f0\nadd_isolated_vertex !h0\n\
        connect !h0 ~0 left\nconnect i0 !v0 left\nconnect i0 i0 left also !h0\n\
        split_vertex !h0 ~0\nsplit_vertex i0 !v1\nmove_inner !v0 unbounded\nmove_inner !h0 unbounded\nmove_inner i0 !f0\n";
    let before = Table::copy_of(runner.subject());
    for op in format!("twinedge program 1\n{again}").parse::<Program>().unwrap().0 {
        assert_eq!(runner.step(op), StepOutcome::Refused(Refusal::Stale), "{op}");
        assert_eq!(Table::copy_of(runner.subject()), before, "{op}");
    }
}

#[test]
fn every_refusal_can_be_met() {
    // An edge with a loop at its end that contains an isolated vertex; another vertex outside.
    let (runner, _) = run("\
        add_isolated_vertex unbounded\n\
        add_isolated_vertex unbounded\n\
        add_isolated_vertex unbounded\n\
        split_vertex i0 ~0\n\
        connect h1 h1 right inner 0\n");
    let cases = [
        ("remove_isolated_vertex o0", Refusal::NotIsolated),
        ("connect o0 i0 left", Refusal::NotIsolated),
        ("connect h0 h3 left", Refusal::FacesDiffer),
        ("connect h0 h0 left also h1", Refusal::NotInner),
        ("split_vertex h0 h1", Refusal::VerticesDiffer),
        ("move_inner h3 unbounded", Refusal::IsOuter),
        ("move_inner h0 h3", Refusal::InsideItself),
        ("join_edges h0", Refusal::DegreeNotTwo),
        ("contract_edge h2", Refusal::Loop),
        ("flip_edge h0 cw", Refusal::NotSeparating),
    ];
    for (line, refusal) in cases {
        let mut runner = runner.clone();
        let program: Program = format!("twinedge program 1\n{line}").parse().unwrap();
        assert_eq!(runner.run(&program), [StepOutcome::Refused(refusal)], "{line}");
    }
    let (mut runner, _) = run("add_isolated_vertex unbounded\nconnect i0 i0 left\n");
    let join = Op::JoinEdges { half_edge: HalfEdgePick::Live(0) };
    assert_eq!(runner.step(join), StepOutcome::Refused(Refusal::Loop));
}

#[test]
fn inner_boundary_components_are_counted_as_their_first_corners_were_made() {
    // A loop around everything, split off with every choice of moved components.
    let setup = "\
        add_isolated_vertex unbounded\n\
        add_isolated_vertex unbounded\n\
        add_isolated_vertex unbounded\n\
        split_vertex i1 i1\n\
        add_isolated_vertex unbounded\n";
    // The edge comes first, because half-edges come before isolated vertices; `from` itself is not counted.
    for mask in 0_u16..8 {
        let (mut runner, _) = run(setup);
        let from = Corner::Isolated(VertexPick::Isolated(0));
        let inner = InnerPick { mask, also: None };
        runner.step(Op::Connect { from, to: SecondPick::Any(from), new_face: Side::Left, inner });
        let map = runner.subject();
        let inside = |corner| map.face_of(corner).ok() != Subject::unbounded_face(map);
        let edge = inside(Corner::At(runner.half_edges()[0]));
        let vertices = [0, 1].map(|i| inside(Corner::Isolated(runner.isolated()[i])));
        assert_eq!([edge, vertices[0], vertices[1]], [0, 1, 2].map(|bit| mask >> bit & 1 == 1));
        assert!(map.validate().is_valid());
    }
}

#[test]
fn a_fuzzer_gets_the_program_that_its_bytes_are() {
    for seed in 0..50 {
        let bytes: Vec<u8> = noise(seed).take(100).collect();
        let program = Program::from_bytes(&bytes);
        assert_eq!(<Program as Arbitrary>::arbitrary_take_rest(Unstructured::new(&bytes)), Ok(program.clone()));
        assert_eq!(<Op as Arbitrary>::arbitrary(&mut Unstructured::new(&bytes)), Ok(program.0[0]));
    }
    // One operator that takes the maximum number of bytes.
    let longest = [0x06, 0, 0xF1, 0, 7, 0, 0xF1, 0, 1, 0, 0, 31, 0xF1, 0];
    assert_eq!(Program::from_bytes(&longest).0.len(), 1);
    assert_eq!(Program::from_bytes(&longest[..13]).0.len(), 0);
    assert_eq!(<Op as Arbitrary>::size_hint(0).1, Some(longest.len()));
}

#[test]
fn random_programs_do_much_and_are_refused_for_every_reason() {
    let mut g = Gen::from_size_and_seed(200, 1);
    let mut counts = std::collections::BTreeMap::new();
    let (mut edges, mut nested) = (0, 0);
    for _ in 0..100 {
        let program = <Program as quickcheck::Arbitrary>::arbitrary(&mut g);
        let mut runner = Runner::new(Dcel::new());
        for outcome in runner.run(&program) {
            *counts.entry(outcome).or_insert(0) += 1;
        }
        edges += runner.subject().edge_count();
        nested += runner.subject().faces().filter(|f| !f.is_unbounded() && f.inner_count() > 0).count();
    }
    let sum: i32 = counts.values().sum();
    assert!(counts[&StepOutcome::Applied] * 2 > sum, "less than half is applied: {counts:?}");
    assert!(counts.len() == 12, "all outcomes but those of small stores: {counts:?}");
    assert!(edges > 1000 && nested > 100, "{edges} edges, {nested} faces with something in them");
}

#[test]
fn shrinking_goes_on_until_nothing_more_can_be_left_out() {
    // True if some bounded face has a hole that is a cycle.
    let has_hole = |program: &Program| {
        let mut runner = Runner::new(Dcel::new());
        runner.run(program);
        let map = runner.into_subject();
        map.faces().any(|f| !f.is_unbounded() && f.inner().any(|b| b.start().is_some()))
    };
    let mut lengths = Vec::new();
    for seed in 0..20 {
        let program = random(seed, 800);
        if has_hole(&program) {
            let small = shrink(&program, has_hole);
            assert!(has_hole(&small));
            assert!(candidates(&small).all(|smaller| !has_hole(&smaller)), "{small}");
            lengths.push(small.0.len());
        }
    }
    // Four operators are enough: two vertices, an edge at one of them, and a loop around that.
    assert!(lengths.len() > 5 && lengths.contains(&4), "{lengths:?}");
    assert!(lengths.iter().all(|length| *length <= 8), "{lengths:?}");
}

#[test]
fn what_remains_of_a_program_goes_on_choosing_the_same() {
    // The third operator makes `h4`. Without the second operator it is `h2`, and larger numbers are reduced to it.
    let long: Program = "twinedge program 1\nadd_isolated_vertex unbounded\nsplit_vertex i0 ~0\nsplit_edge h0\n\
                         split_edge h1\nremove_edge h10"
        .parse()
        .unwrap();
    let short: Program =
        "twinedge program 1\nadd_isolated_vertex unbounded\nsplit_vertex i0 ~0\nsplit_edge h1\nremove_edge h2"
            .parse()
            .unwrap();
    assert!(candidates(&long).any(|candidate| candidate == short), "{long}");
}

#[test]
fn what_an_operator_would_choose_can_be_asked() {
    let program: Program = "twinedge program 1
        add_isolated_vertex unbounded
        connect i0 ~0 left
        add_isolated_vertex h0
        add_isolated_vertex h0
        connect h0 ~0 right inner 1
        remove_edge h2
        flip_edge !h1 cw
        remove_isolated_vertex !v0"
        .parse()
        .unwrap();
    let op = |i: usize| program.0[i];
    let mut runner = Runner::new(RawPointers::new());
    assert_eq!(runner.resolve(op(1)), Err(StepOutcome::Skipped));
    runner.step(op(0));
    let (v, new_face) = (Corner::Isolated(0), Side::Left);
    assert_eq!(runner.resolve(op(1)), Ok(Call::Connect { from: v, to: v, new_face, inner: vec![] }));
    for i in 1..4 {
        runner.step(op(i));
    }
    let (h, new_face) = (Corner::At(0), Side::Right);
    let call = Call::Connect { from: h, to: h, new_face, inner: vec![Corner::Isolated(2)] };
    assert_eq!(runner.resolve(op(4)), Ok(call));
    runner.step(op(4));
    runner.step(op(5));
    // A stale handle is chosen like any other.
    assert_eq!(runner.resolve(op(6)), Ok(Call::FlipEdge { half_edge: 3, turn: Turn::Clockwise }));
    assert_eq!(runner.resolve(op(7)), Err(StepOutcome::Skipped));
}
