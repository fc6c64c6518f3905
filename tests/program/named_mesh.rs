//! Meshes that move half-edges and store none on the border, tested through stable names.

use crate::support::erased::validate;
use crate::support::triangles::{Bug, Triangles};
use proptest::strategy::ValueTree;
use twinedge::program::choose::Random;
use twinedge::program::conformance::{Conformance, Counterexample, Coverage, Difference, End, NotCompared};
use twinedge::program::mesh::Named;
use twinedge::program::{conformance, *};
use twinedge::validate::{Collect, Expectation, Part, Parts, View};

const MESH: Expectation = Expectation::surface().open().simple().triangles();

const OCTAHEDRON: [[usize; 3]; 8] =
    [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [5, 2, 1], [5, 3, 2], [5, 4, 3], [5, 1, 4]];
const PYRAMID: [[usize; 3]; 4] = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];

fn named(vertices: usize, triangles: &[[usize; 3]], bug: Bug) -> Named<Triangles> {
    Named::new(Triangles::new(vertices, triangles, bug))
        .flip_edge(Triangles::flip)
        .split_edge(Triangles::split)
        .collapse_edge(Triangles::collapse)
}

#[test]
fn a_right_mesh_agrees_with_the_reference() {
    for (vertices, triangles) in [(6, &OCTAHEDRON[..]), (5, &PYRAMID), (3, &[[0, 1, 2]])] {
        let settings = Conformance::of(&MESH).coverage(conformance::Coverage::SomeOperator).programs(100, 30);
        let summary = settings.check(|| named(vertices, triangles, Bug::None)).unwrap();
        let splits = summary.of("mesh_split_edge").unwrap();
        assert!(splits.applied > 500 && splits.refused > 0, "{summary}");
        let collapses = summary.of("mesh_collapse_edge").unwrap();
        assert!(collapses.applied > 300 && collapses.refused > 100, "{summary}");
        assert_eq!(summary.of("mesh_split_face").unwrap().applied, 0);
    }
}

/// The operators of the program of a counterexample, without the numbers.
fn operators(found: &Counterexample) -> Vec<&str> {
    found.program.0.iter().map(|op| op.name()).collect()
}

/// Every bug is found on the disc, and its program shrinks from there: no number exceeds the existing half-edges, and every
/// remaining operator is necessary.
#[test]
fn bugs_are_found_and_their_programs_are_small() {
    for (bug, most) in [(Bug::StaleLeaving, 1), (Bug::ForgetsFan, 4), (Bug::Pinches, 4), (Bug::Panics, 3)] {
        for seed in 0..4 {
            let settings = Conformance::of(&MESH).seed(seed);
            let found = settings.check(|| named(5, &PYRAMID, bug)).unwrap_err();
            let operators = operators(&found);
            assert!(operators.len() <= most, "{bug:?} {found}");
            let last = if bug == Bug::Panics { "mesh_split_edge" } else { "mesh_collapse_edge" };
            assert_eq!(operators.last(), Some(&last), "{bug:?} {found}");
            // A split adds at most six half-edges.
            assert!(numbers(&found.program).into_iter().all(|number| number < 16 + 6 * most), "{bug:?} {found}");
        }
    }
}

/// Regression: advice to use `Named` was given for a flip that did nothing under `Named`.
#[test]
fn a_flip_that_does_nothing_is_not_told_of_names() {
    let found = conformance::check(|| named(5, &PYRAMID, Bug::FlipsNothing), &MESH).unwrap_err();
    assert_eq!(operators(&found), ["mesh_flip_edge"]);
    let text = found.to_string();
    assert!(text.contains("in the view, Next of half-edge") && !text.contains("Named"), "{text}");
}

/// Regression: a kernel that loses the data of vertices passed, since the survivor of a collapse was not compared.
#[test]
fn the_vertex_that_survives_a_collapse_is_compared() {
    let settings = Conformance::of(&MESH);
    let right = |end| settings.collapse_keeps(end).check(|| named(5, &PYRAMID, Bug::None));
    right(End::Origin).unwrap();
    let found = right(End::Target).unwrap_err();
    assert_eq!(operators(&found), ["mesh_collapse_edge"]);
    assert!(matches!(&found.failure.difference, Difference::Vertex { expected, .. } if expected.len() == 1), "{found}");
    // By default either end may survive, but a new vertex may not.
    settings.check(|| named(5, &PYRAMID, Bug::KeepsEither)).unwrap();
    for end in [End::Origin, End::Target] {
        assert!(settings.collapse_keeps(end).check(|| named(5, &PYRAMID, Bug::KeepsEither)).is_err());
    }
    let found = settings.check(|| named(5, &PYRAMID, Bug::MakesVertex)).unwrap_err();
    assert_eq!(operators(&found), ["mesh_collapse_edge"]);
    assert!(found.to_string().contains(" and is 5, so what is kept by its handle is lost"), "{found}");
}

/// Regression: kernels that renumber vertices could not be tested.
#[test]
fn vertices_may_get_other_handles_if_that_is_said() {
    let settings = Conformance::of(&MESH).without_vertex_handles();
    let summary = settings.check(|| named(5, &PYRAMID, Bug::MakesVertex)).unwrap();
    assert!(summary.of("mesh_collapse_edge").unwrap().applied > 0, "{summary}");
    assert!(summary.not_compared().any(|part| part == NotCompared::VertexHandles), "{summary}");
    // Everything else is still compared.
    assert!(settings.check(|| named(5, &PYRAMID, Bug::ForgetsFan)).is_err());
}

/// The numbers of the half-edges in a program.
fn numbers(program: &Program) -> Vec<usize> {
    let text = program.to_string();
    let words = text.split_whitespace().filter_map(|word| word.strip_prefix('h'));
    words.map(|number| number.parse().expect("is a number")).collect()
}

/// Regression: engines that did not know the start left more operators, and numbers such as `h208` on a mesh of 16 half-edges.
#[test]
fn every_engine_shrinks_by_the_start() {
    let make = || named(5, &PYRAMID, Bug::ForgetsFan);
    let settings = Conformance::of(&MESH).coverage(Coverage::Nothing);
    let mesh = [OpKind::MeshFlipEdge, OpKind::MeshSplitEdge, OpKind::MeshCollapseEdge];
    let generator = Program::generator().only(&mesh).length(20..=40).beginning_with(&make(), &MESH).unwrap();
    let fails = |program: &Program| settings.run(program, make()).is_err();
    let mut noise = Random::seeded(1);
    let programs = core::iter::repeat_with(|| generator.generate(&mut noise)).filter(|program| fails(program));
    let most = 4;
    for program in programs.take(10) {
        let small = [
            // Fuzz targets; quickcheck's `shrink`, which repeats the candidates; and proptest's tree.
            settings.run_and_shrink(&program, make).unwrap_err().program,
            generator.shrink(&program, fails),
            shrunk_by_tree(&program, &generator, fails),
        ];
        for small in small {
            assert!(small.0.len() <= most && fails(&small), "{small}");
            assert!(numbers(&small).into_iter().all(|number| number < 16 + 6 * most), "{small}");
        }
    }
}

fn shrunk_by_tree(program: &Program, generator: &Generator, fails: impl Fn(&Program) -> bool) -> Program {
    let mut tree = ProgramTree::new(program.clone(), generator);
    let mut more = tree.simplify();
    while more {
        more = if fails(&tree.current()) { tree.simplify() } else { tree.complicate() };
    }
    tree.current()
}

#[test]
fn a_counterexample_says_which_vertices_a_half_edge_joins() {
    let found = Conformance::of(&MESH).check(|| named(5, &PYRAMID, Bug::StaleLeaving)).unwrap_err();
    let text = found.to_string();
    let [Op::MeshCollapseEdge { half_edge: HalfEdgePick::Live(k) }] = found.program.0[..] else { panic!("{text}") };
    let mesh = named(5, &PYRAMID, Bug::None);
    let start = PointerModel::from_view(&mesh, &MESH).unwrap();
    let (h, _) = start.half_edges[k as usize];
    let [origin, target] = [h, mesh.twin(h).unwrap()].map(|h| mesh.origin(h).unwrap());
    assert!(text.contains(&format!("\nmesh_collapse_edge h{k} # {h} ({origin} to {target})\n")), "{text}");
    // The printed program can be parsed.
    let (_, shown) = text.split_once("choose:\n").unwrap();
    assert_eq!(shown.parse(), Ok(found.program));
}

/// A kernel may turn an edge either way: in two triangles the results are equal.
#[test]
fn a_flip_may_turn_either_way() {
    struct Clockwise(PointerModel);
    impl View for Clockwise {
        twinedge::delegate_view!(|this| &this.0);
    }
    impl Subject for Clockwise {
        twinedge::delegate_subject!(PointerModel, |this| &this.0);

        fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
            let Call::MeshFlipEdge { half_edge } = call else { return self.0.apply(call) };
            // Two turns forward and one back amount to one clockwise turn, with the refusals of the first.
            self.0.apply(call)?;
            let back = Call::FlipEdge { half_edge, turn: Turn::Clockwise };
            self.0.apply(back.clone())?;
            self.0.apply(back)
        }
    }
    let summary = conformance::check(|| Clockwise(PointerModel::new()), &Expectation::plane()).unwrap();
    assert!(summary.of("mesh_flip_edge").unwrap().applied > 0);
}

/// Without names, the first flip is a difference although the mesh is valid, and the message contains advice.
#[test]
fn a_mesh_that_moves_half_edges_is_told_of_names() {
    struct ByIndex(Named<Triangles>, Vec<usize>);
    impl View for ByIndex {
        twinedge::delegate_view!(|this| &this.0; except half_edge_slots, is_half_edge, origin, twin, next, face, leaving, outer_half_edge);
        fn half_edge_slots(&self) -> usize {
            self.1.len()
        }
        fn is_half_edge(&self, h: usize) -> bool {
            self.0.is_half_edge(self.1[h])
        }
        fn origin(&self, h: usize) -> Option<usize> {
            self.0.origin(self.1[h])
        }
        fn twin(&self, h: usize) -> Option<usize> {
            self.at(self.0.twin(self.1[h]))
        }
        fn next(&self, h: usize) -> Option<usize> {
            self.at(self.0.next(self.1[h]))
        }
        fn face(&self, h: usize) -> Option<usize> {
            self.0.face(self.1[h])
        }
        fn leaving(&self, v: usize) -> Option<usize> {
            self.at(self.0.leaving(v))
        }
        fn outer_half_edge(&self, f: usize) -> Option<usize> {
            self.at(self.0.outer_half_edge(f))
        }
    }
    impl ByIndex {
        fn at(&self, link: Option<usize>) -> Option<usize> {
            self.1.iter().position(|n| Some(*n) == link)
        }
        /// Splits, and exchanges the first half-edge with the last.
        fn split(&mut self, h: usize) -> Result<(), Refusal> {
            self.0.apply(Call::MeshSplitEdge { half_edge: self.1[h] })?;
            self.1 = (0..self.0.half_edge_slots()).collect();
            let last = self.1.len() - 1;
            self.1.swap(0, last);
            Ok(())
        }
    }
    impl Subject for ByIndex {
        twinedge::subject_by_index!(MeshSplitEdge => Self::split);
    }
    let make = || {
        let named = named(6, &OCTAHEDRON, Bug::None);
        let all = (0..named.half_edge_slots()).collect();
        ByIndex(named, all)
    };
    let found = conformance::check(make, &MESH).unwrap_err();
    assert_eq!(operators(&found), ["mesh_split_edge"]);
    assert!(found.to_string().contains("the mesh needs program::mesh::Named"), "{found}");
}

/// Half-edges that are not stored exist, without face and next, and each half-edge keeps its identity.
#[test]
fn names_stay() {
    let mut mesh = named(5, &PYRAMID, Bug::None);
    let live =
        |mesh: &Named<Triangles>| (0..mesh.half_edge_slots()).filter(|n| mesh.is_half_edge(*n)).collect::<Vec<_>>();
    assert_eq!(live(&mesh).len(), 16);
    let ends = |mesh: &Named<Triangles>, n: usize| [mesh.origin(n), mesh.origin(mesh.twin(n).unwrap())];
    let border: Vec<usize> = live(&mesh).into_iter().filter(|n| mesh.face(*n).is_none()).collect();
    assert_eq!(border.len(), 4);
    for n in &border {
        assert_eq!(
            (mesh.next(*n), mesh.apply(Call::MeshSplitFace { half_edge: *n })),
            (None, Err(Refusal::Unsupported))
        );
        assert_eq!(
            (mesh.face_of(Corner::At(*n)), mesh.apply(Call::MeshFlipEdge { half_edge: *n })),
            (Err(Refusal::Border), Err(Refusal::Border))
        );
    }
    let before: Vec<_> = live(&mesh).into_iter().map(|n| (n, ends(&mesh, n))).collect();
    // The edge from 0 to the apex is turned: two half-edges are new, all others keep their ends.
    let spoke = before.iter().find(|(_, ends)| *ends == [Some(0), Some(4)]).unwrap().0;
    assert_eq!(mesh.apply(Call::MeshFlipEdge { half_edge: spoke }), Ok(None));
    let turned: Vec<usize> = live(&mesh).into_iter().filter(|n| *n >= 16).collect();
    assert_eq!(
        (live(&mesh).len(), turned.len(), mesh.apply(Call::MeshFlipEdge { half_edge: spoke })),
        (16, 2, Err(Refusal::Stale))
    );
    for (n, ends_before) in &before {
        let is_turned = matches!(ends_before, [Some(0), Some(4)] | [Some(4), Some(0)]);
        assert!(is_turned != mesh.is_half_edge(*n));
        assert!(is_turned || ends(&mesh, *n) == *ends_before);
    }
    // A border edge collapses, given by the half-edge that is not stored; half-edges that started at one end now start at the other.
    let n = border[0];
    let [from, to] = ends(&mesh, n);
    assert_eq!(mesh.apply(Call::MeshCollapseEdge { half_edge: n }), Ok(None));
    assert_eq!(live(&mesh).len(), 16 - 4);
    assert!(live(&mesh).into_iter().all(|n| n < 18), "no half-edge is new");
    assert_ne!(mesh.is_vertex(from.unwrap()), mesh.is_vertex(to.unwrap()));
    assert!(validate(&twinedge::validate::adapt::Borders::of(&mesh).unwrap(), &MESH, Collect::All).is_valid());
    // The numbers lead back to the mesh.
    for n in live(&mesh) {
        let [start, end] = ends(&mesh, n);
        let h = mesh.in_mesh(n).unwrap();
        assert_eq!(mesh.mesh().origin(h), if mesh.face(n).is_some() { start } else { end });
    }
    assert_eq!((mesh.in_mesh(spoke), mesh.in_mesh(usize::MAX)), (None, None));
    assert!(!mesh.is_half_edge(usize::MAX) && mesh.twin(usize::MAX).is_none() && mesh.origin(usize::MAX).is_none());
}

/// A link that still leads to a removed half-edge leads to its former number.
#[test]
fn a_link_to_a_removed_half_edge_has_its_number() {
    let found = Conformance::of(&MESH).check(|| named(5, &PYRAMID, Bug::StaleLeaving)).unwrap_err();
    let mut steps = Conformance::of(&MESH).begin(named(5, &PYRAMID, Bug::StaleLeaving)).unwrap();
    assert!(found.program.0.iter().any(|op| steps.step(*op).is_err()));
    let mesh = steps.subject().subject();
    let stale = (0..mesh.vertex_slots()).filter(|v| mesh.is_vertex(*v)).find_map(|v| {
        let n = mesh.leaving(v).filter(|n| !mesh.is_half_edge(*n))?;
        Some((v, n))
    });
    let (v, n) = stale.unwrap();
    assert!(n < mesh.half_edge_slots() && mesh.in_mesh(n).is_none());
    assert!(found.to_string().contains(&format!("the leaving half-edge of vertex {v} is {n}")), "{found}");
}

/// Two half-edges whose links lead nowhere.
struct Dangling;
impl View for Dangling {
    twinedge::view_answers! { |_m|
        parts => Parts::NONE.with(Part::Leaving),
        vertex_slots => 2,
        half_edge_slots => 2,
        origin(h) => Some(h),
        twin(_h) => Some(7),
        next(_h) => Some(usize::MAX),
        leaving(_v) => Some(5),
    }
}

/// An operator that the mesh does not have, and links that lead nowhere.
#[test]
fn a_broken_mesh_stays_broken() {
    let mut bare = Named::new(Triangles::new(3, &[[0, 1, 2]], Bug::None));
    assert_eq!(bare.apply(Call::MeshFlipEdge { half_edge: 0 }), Err(Refusal::Unsupported));
    assert_eq!(
        (bare.apply(Call::MeshFlipEdge { half_edge: 99 }), bare.apply(Call::MeshSplitFace { half_edge: 99 })),
        (Err(Refusal::Stale), Err(Refusal::Stale))
    );
    let named = Named::new(Dangling);
    assert_eq!(
        (named.twin(0), named.next(1), named.leaving(0)),
        (Some(usize::MAX), Some(usize::MAX), Some(usize::MAX))
    );
    let report = validate(&named, &Expectation::surface(), Collect::All);
    assert!(!report.is_valid());
}
