//! Generators and proptest: they draw operators with a weight, and failures shrink operator by operator.

use proptest::arbitrary::{any, any_with};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, TestCaseError, TestError, TestRng, TestRunner};
use quickcheck::Gen;
use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::Dcel;
use twinedge::program::choose::Bytes;
use twinedge::program::*;

/// Runs the same programs every time, and writes no file.
fn runner() -> TestRunner {
    let config = Config { max_shrink_iters: 100_000, failure_persistence: None, ..Config::default() };
    let rng = TestRng::deterministic_rng(config.rng_algorithm);
    TestRunner::new_with_rng(config, rng)
}

fn run(program: &Program) -> Dcel {
    let mut runner = Runner::new(Dcel::new());
    runner.run(program);
    runner.into_subject()
}

/// Tells whether some bounded face has a hole that is a cycle.
fn has_hole(program: &Program) -> bool {
    run(program).faces().any(|f| !f.is_unbounded() && f.inner().any(|b| b.start().is_some()))
}

#[test]
fn each_operator_comes_as_often_as_its_weight_says() {
    let mut counts = BTreeMap::new();
    let mut runner = runner();
    let mut g = Gen::from_size_and_seed(1, 2);
    let generator = Program::generator().length(100..=100);
    for _ in 0..100 {
        for program in [generator.generate(&mut runner), generator.generate(&mut g)] {
            assert_eq!(program.0[0], Op::AddIsolatedVertex { face: FacePick::Unbounded });
            for op in &program.0[1..] {
                *counts.entry(op.name()).or_insert(0) += 1;
            }
        }
    }
    let sum: u32 = counts.values().sum();
    for ((_, share), name) in OpKind::SHARES.iter().zip(Op::NAMES) {
        // Operators of meshes are only drawn on request.
        let (expected, found) = (sum * share / 32, counts.get(name).copied().unwrap_or(0));
        assert_eq!(found == 0, *share == 0, "{name}");
        assert!(found.abs_diff(expected) < 30 + expected / 10, "{name}: {found}, not {expected}");
    }
}

#[test]
fn generators_draw_what_they_are_told_and_no_more() {
    let generator = Program::generator()
        .only(&[OpKind::Connect, OpKind::FlipEdge, OpKind::SplitEdge])
        .weight(OpKind::Connect, 0)
        .weight(OpKind::FlipEdge, 1)
        .weight(OpKind::SplitEdge, 3)
        .length(5..=9);
    let mut runner = runner();
    let (mut flips, mut lengths, mut sum) = (0, BTreeMap::new(), 0);
    for _ in 0..500 {
        let program = generator.generate(&mut runner);
        *lengths.entry(program.0.len()).or_insert(0) += 1;
        sum += program.0.len();
        for op in program.0 {
            match op {
                Op::FlipEdge { .. } => flips += 1,
                Op::SplitEdge { .. } => {}
                other => panic!("{other}"),
            }
        }
    }
    assert!(lengths.keys().eq(&[5, 6, 7, 8, 9]) && lengths.values().all(|count| *count > 60), "{lengths:?}");
    assert!((sum / 5..sum * 3 / 10).contains(&flips), "{flips} of {sum}");
    for nothing in [Program::generator().only(&[]), Program::generator().length(0..=0)] {
        assert_eq!(nothing.generate(&mut runner).0, []);
    }
    // An exhausted source answers zeros, so the length is minimal.
    assert_eq!(Program::generator().length(3..=9).generate(&mut Bytes::new(&[])).0.len(), 3);
}

#[test]
fn operators_of_meshes_are_drawn_if_they_are_asked_for() {
    let mesh = [OpKind::MeshFlipEdge, OpKind::MeshSplitFace];
    let is_mesh = |op: &Op| op.name().starts_with("mesh_");
    let drawn = |generator: &Generator| generator.clone().length(60..=60).generate(&mut runner());
    assert!(!drawn(&Program::generator()).0.iter().any(is_mesh));
    let only = Program::generator().only(&mesh);
    let names: BTreeSet<&str> = drawn(&only).0.iter().map(|op| op.name()).collect();
    assert_eq!(names, BTreeSet::from(["mesh_flip_edge", "mesh_split_face"]));
    let also = drawn(&Program::generator().weight(OpKind::MeshFlipEdge, 12));
    assert!(also.0.iter().any(is_mesh) && !also.0.iter().all(is_mesh));
    assert!(!drawn(&only.weight(OpKind::MeshFlipEdge, 0)).0.iter().any(|op| op.name() == "mesh_flip_edge"));
}

#[test]
fn bytes_are_as_many_operators_as_they_are_enough_for() {
    let split = Program::generator().only(&[OpKind::SplitEdge]).weight(OpKind::SplitEdge, 1).length(1..=1);
    let text = |generator: &Generator, bytes: &[u8]| generator.decode(bytes).to_string();
    // The bound on the number applies only to `generate`.
    let three = "twinedge program 1\nsplit_edge h3\nsplit_edge !h4\nsplit_edge h0\n";
    assert_eq!(text(&split, &[0, 0, 3, 0, 15, 4, 0]), three);
    assert_eq!(text(&split, &[]), "twinedge program 1\n");
    assert_eq!(Program::generator().decode(&[]).0, [Op::AddIsolatedVertex { face: FacePick::Unbounded }]);
    assert_eq!(Program::generator().only(&[]).decode(&[1, 2, 3]).0, []);
}

#[test]
fn proptest_shrinks_programs_operator_by_operator() {
    let outcome = runner().run(&any_with::<Program>(Program::generator().length(0..=100)), |program| {
        if has_hole(&program) { Err(TestCaseError::fail("a hole")) } else { Ok(()) }
    });
    let Err(TestError::Fail(_, small)) = outcome else { panic!("no program made a hole: {outcome:?}") };
    assert!(has_hole(&small) && small.0.len() <= 8, "{small}");
    assert!(candidates(&small).all(|smaller| !has_hole(&smaller)), "{small}");
}

#[test]
fn the_tree_of_a_program_shrinks_as_shrink_does() {
    let fails = |program: &Program| run(program).face_count() > 2;
    let (mut runner, generator) = (runner(), Program::generator());
    let mut programs = std::iter::repeat_with(|| generator.generate(&mut runner)).take(100);
    let program = programs.find(|program| fails(program)).expect("some program makes three faces");
    let mut tree = ProgramTree::new(program.clone(), &generator);
    assert_eq!(tree.current(), program);
    let mut smallest = program.clone();
    let mut more = tree.simplify();
    while more {
        more = if fails(&tree.current()) {
            smallest = tree.current();
            tree.simplify()
        } else {
            tree.complicate()
        };
    }
    assert_eq!(smallest, shrink(&program, fails));
    assert_eq!(tree.current(), smallest, "it ends at what fails");
    assert!(!tree.complicate() && tree.current() == smallest);
}

#[test]
fn proptest_makes_valid_structures_and_shrinks_them() {
    let outcome = runner().run(&any::<Dcel>(), |dcel| {
        assert!(dcel.validate().is_valid());
        if dcel.face_count() > 2 { Err(TestCaseError::fail("three faces")) } else { Ok(()) }
    });
    let Err(TestError::Fail(_, small)) = outcome else { panic!("no structure has three faces: {outcome:?}") };
    // Two loops at one vertex.
    assert_eq!((small.face_count(), small.edge_count(), small.vertex_count()), (3, 2, 1));
    let few = Program::generator().length(20..=20);
    for _ in 0..20 {
        let dcel = any_with::<Dcel>(few.clone()).new_tree(&mut runner()).expect("always").current();
        assert!(dcel.validate().is_valid());
    }
}
