//! Structures without some operators or parts: meshes, surfaces, borders.

use crate::support::erased::validate;
use crate::support::tables::torus;
use std::cell::Cell;
use std::rc::Rc;
use twinedge::dcel::{Audited, Dcel, Room};
use twinedge::program::conformance::{Conformance, Coverage, Difference, NotCompared, Question, check};
use twinedge::program::*;
use twinedge::validate::{Collect, Expectation, Link, Part, Parts, Table, View};
use twinedge::{delegate_view, subject_by_index, view_answers};
use twinedge_trials::{RawPointers, ReportAudit, Rewound};

#[allow(dead_code, unreachable_pub, reason = "an example has a main function of its own")]
#[path = "../../examples/mesh_conformance.rs"]
mod mesh;
use mesh::{MESH, Mesh};

const SURFACE: Expectation = Expectation::surface();

const OCTAHEDRON: [[usize; 3]; 8] =
    [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]];
/// A ring of six triangles, with two borders.
const RING: [[usize; 3]; 6] = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]];

/// The behaviour of `flip_edge`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Flip {
    Right,
    /// Turns the other way. On triangles the map is the same, but with the other half-edge.
    Reversed,
    /// Claims success, but does nothing.
    Nothing,
    /// Leaves the edge and breaks the cycles.
    Breaks,
    /// Makes another edge, with two new vertices.
    Adds,
    /// Drops the last edge.
    Drops,
}

/// A structure that can only turn edges, as in the bug report: no faces, no holes, no unbounded face, no other operators.
struct FlipOnly {
    next: Vec<usize>,
    origin: Vec<usize>,
    flip: Flip,
    called: Rc<Cell<usize>>,
}

impl FlipOnly {
    fn of(triangles: &[[usize; 3]], vertices: usize, flip: Flip) -> Self {
        let mesh = Mesh::new(vertices, triangles, false);
        let all = 0..mesh.half_edge_slots();
        let next = all.clone().map(|h| mesh.next(h).unwrap()).collect();
        Self { next, origin: all.map(|h| mesh.origin(h).unwrap()).collect(), flip, called: Rc::default() }
    }

    fn prev(&self, h: usize) -> usize {
        self.next.iter().position(|next| *next == h).unwrap()
    }
}

impl View for FlipOnly {
    view_answers! { |view|
        parts => Parts::NONE,
        vertex_slots => view.origin.iter().max().map_or(0, |v| v + 1),
        half_edge_slots => view.next.len(),
        origin(h) => Some(view.origin[h]),
        twin(h) => Some(h ^ 1),
        next(h) => Some(view.next[h]),
    }
}

impl Subject for FlipOnly {
    subject_by_index!();

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        let Call::FlipEdge { half_edge: h, turn } = call else { return Err(Refusal::Unsupported) };
        self.called.set(self.called.get() + 1);
        let mut at = self.next.get(h).copied().ok_or(Refusal::Stale)?;
        let t = h ^ 1;
        while at != h {
            if at == t {
                return Err(Refusal::NotSeparating);
            }
            at = self.next[at];
        }
        if self.next[h] == h || self.next[t] == t {
            return Err(Refusal::Unsupported);
        }
        let turn = if self.flip == Flip::Reversed { turn.reversed() } else { turn };
        let (a, b) = match turn {
            Turn::CounterClockwise => (self.next[h], self.next[t]),
            Turn::Clockwise => (self.prev(h), self.prev(t)),
        };
        match self.flip {
            Flip::Nothing => return Ok(None),
            Flip::Adds => {
                let (n, v) = (self.next.len(), self.vertex_slots());
                self.next.extend([n + 1, n]);
                self.origin.extend([v, v + 1]);
                return Ok(None);
            }
            Flip::Drops => {
                let h = self.next.len() - 2;
                let (before_h, before_t) = (self.prev(h), self.prev(h + 1));
                (self.next[before_h], self.next[before_t]) = (self.next[h + 1], self.next[h]);
                self.next.truncate(h);
                self.origin.truncate(h);
                return Ok(None);
            }
            _ => {}
        }
        // Take the edge out.
        let (before_h, before_t, after_h, after_t) = (self.prev(h), self.prev(t), self.next[h], self.next[t]);
        (self.next[before_h], self.next[before_t]) = (after_t, after_h);
        // Put it in: `h` leaves before `x`, `t` before `y`.
        let (x, y) = match turn {
            Turn::CounterClockwise => (self.next[b], self.next[a]),
            Turn::Clockwise => (a, b),
        };
        let (before_x, before_y) = (self.prev(x), self.prev(y));
        (self.next[before_x], self.next[t]) = (h, x);
        (self.next[before_y], self.next[h]) = (t, y);
        (self.origin[h], self.origin[t]) = (self.origin[x], self.origin[y]);
        if self.flip == Flip::Breaks {
            self.origin[h] = self.origin[y];
        }
        Ok(None)
    }
}

#[test]
fn the_wrong_flip_of_a_structure_that_has_nothing_else_is_called_and_caught() {
    for (triangles, vertices) in [(OCTAHEDRON.to_vec(), 6), (torus([3, 3]), 9)] {
        let called = Rc::new(Cell::new(0));
        for flip in [Flip::Reversed, Flip::Nothing, Flip::Breaks] {
            let make = || FlipOnly { called: called.clone(), ..FlipOnly::of(&triangles, vertices, flip) };
            let found = check(make, &SURFACE).unwrap_err();
            // The smallest program is one flip.
            let names: Vec<_> = found.program.0.iter().map(|op| op.name()).collect();
            assert_eq!(names, ["flip_edge"], "{flip:?}: {found}");
            let is_caught = match found.failure.difference {
                Difference::Invalid(_) => flip == Flip::Breaks,
                Difference::View { question, .. } => flip != Flip::Breaks && question == Question::Next,
                _ => false,
            };
            assert!(is_caught, "{flip:?}: {found}");
        }
        assert!(called.get() > 0);
        let summary = check(|| FlipOnly::of(&triangles, vertices, Flip::Right), &SURFACE).unwrap();
        let flips = summary.of("flip_edge").unwrap();
        assert!(flips.applied > 1000 && flips.refused > 0, "{summary}");
        let not_compared: Vec<_> = summary.not_compared().collect();
        assert_eq!(not_compared, [NotCompared::Faces, NotCompared::Holes, NotCompared::Outside]);
        let others = summary.by_operator().filter(|(name, _)| *name != "flip_edge");
        assert!(others.into_iter().all(|(_, counts)| counts.applied + counts.refused == 0), "{summary}");
    }
}

/// The initial map, without operators.
struct Inert(Table);

impl View for Inert {
    delegate_view!(|this| &this.0);
}

impl Subject for Inert {
    subject_by_index!();

    fn unbounded_face(&self) -> Option<usize> {
        (0..self.0.face_slots()).find(|f| self.0.outer(*f).is_none())
    }
}

const EDGE: &str = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0";

#[test]
fn a_run_in_which_nothing_was_applied_fails_unless_it_is_allowed_to() {
    let inert = || Inert(EDGE.parse().unwrap());
    let plane = Expectation::plane();
    for bytes in [0_u8, 7, 99, 200] {
        let program = Program::from_bytes(&[bytes; 200]);
        let failure = conformance::run(&program, inert(), &plane).unwrap_err();
        assert_eq!((failure.op, &failure.difference), (None, &Difference::NothingApplied));
        assert_eq!(
            failure.to_string(),
            format!(
                "after {} operators: no operator was applied, so nothing was tried: does the subject have any of them?",
                program.0.len()
            )
        );
        let asked = Conformance::of(&plane).coverage(Coverage::Nothing);
        assert_eq!(asked.run(&program, inert()).unwrap().total().applied, 0);
    }
    assert_eq!(check(inert, &plane).unwrap_err().failure.difference, Difference::NothingApplied);
    assert!(Conformance::of(&plane).coverage(Coverage::Nothing).check(inert).is_ok());
}

/// A model that refuses all flips that the reference refuses, and never flips: loops are removed first.
struct NeverFlips(RawPointers);

impl View for NeverFlips {
    delegate_view!(|this| &this.0);
}

impl Subject for NeverFlips {
    subject_by_index!();

    fn unbounded_face(&self) -> Option<usize> {
        self.0.unbounded_face()
    }

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        match call {
            Call::SplitEdge { .. } | Call::FlipEdge { .. } => self.0.apply(call),
            _ => Err(Refusal::Unsupported),
        }
    }
}

#[test]
fn an_operator_that_is_never_applied_is_named() {
    // A tree has nothing to flip.
    let tree = || {
        let mut runner = Runner::new(RawPointers::new());
        runner.run(&"twinedge program 1\nadd_isolated_vertex unbounded\nsplit_vertex i0 i0".parse().unwrap());
        NeverFlips(runner.into_subject())
    };
    let few = Conformance::of(&Expectation::plane()).programs(40, 40);
    let found = few.check(tree).unwrap_err();
    assert_eq!(found.failure.difference, Difference::NeverApplied(vec!["flip_edge"]));
    assert_eq!(
        found.to_string(),
        format!("after {} operators: never applied, and so not tried: flip_edge", found.failure.before)
    );
    assert!(few.coverage(Coverage::SomeOperator).check(tree).unwrap().of("split_edge").unwrap().applied > 0);
}

#[test]
fn meshes_on_every_surface_do_what_the_steps_do() {
    let ring_and_more: Vec<[usize; 3]> = RING.to_vec();
    for (triangles, vertices) in
        [(OCTAHEDRON.to_vec(), 6), (torus([3, 3]), 9), (ring_and_more, 6), (vec![[0, 1, 2]], 3)]
    {
        let summary = check(|| Mesh::new(vertices, &triangles, false), &MESH).unwrap();
        for name in ["mesh_flip_edge", "mesh_split_edge", "mesh_collapse_edge"] {
            assert!(summary.of(name).unwrap().applied > 200, "{summary}");
        }
        let found = check(|| Mesh::new(vertices, &triangles, true), &MESH).unwrap_err();
        let (reference, subject) = (StepOutcome::Refused(Refusal::NotSimple), StepOutcome::Applied);
        assert_eq!(found.failure.difference, Difference::StepOutcome { reference, subject }, "{found}");
    }
}

/// Conformance compares the map after each operator, also one that is refused, with that of the reference.
#[test]
fn the_models_and_the_structure_have_every_operator_and_do_the_same() {
    let plane = Expectation::plane();
    let summary = check(RawPointers::new, &plane).unwrap();
    assert!(summary.by_operator().all(|(_, counts)| counts.applied > 0), "{summary}");
    let all = [
        check(PointerModel::new, &plane),
        check(Dcel::new, &plane),
        check(|| Audited::new(Dcel::new()).unwrap(), &plane),
        check(|| ReportAudit::new(Dcel::new()), &plane),
        check(Rewound::default, &plane),
    ];
    for other in all {
        assert_eq!(other.unwrap(), summary);
    }
    // With limits, some operators find no room.
    let most = Room { vertices: 12, edges: 16, boundaries: 12, faces: 8 };
    let crowded = Conformance::of(&plane).coverage(Coverage::SomeOperator);
    let total = crowded.check(|| ReportAudit::new(Dcel::with_limits(most))).unwrap().total();
    assert!(total.no_room > 0 && total.applied > 300, "{total:?}");
}

/// The runner's questions about an edge before its removal must not replace the operator.
#[test]
fn stale_handles_reach_the_operators_that_remove() {
    /// Claims to have removed a missing edge.
    struct Careless(RawPointers);
    impl View for Careless {
        delegate_view!(|this| &this.0);
    }
    impl Subject for Careless {
        subject_by_index!();
        fn unbounded_face(&self) -> Option<usize> {
            self.0.unbounded_face()
        }
        fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
            match call {
                Call::AddIsolatedVertex { .. } | Call::SplitVertex { .. } => self.0.apply(call),
                Call::RemoveEdge { .. } | Call::JoinEdges { .. } => self.0.apply(call).or(Ok(None)),
                Call::ContractEdge { .. } => self.0.apply(call).or(Ok(Some(Handle::Vertex(0)))),
                _ => Err(Refusal::Unsupported),
            }
        }
    }
    let begin = "twinedge program 1\nadd_isolated_vertex unbounded\nsplit_vertex i0 i0\nremove_edge h0\n";
    for name in ["remove_edge", "contract_edge", "join_edges"] {
        let program: Program = format!("{begin}{name} !h0").parse().unwrap();
        let careless = || Careless(RawPointers::new());
        let failure = conformance::run(&program, careless(), &Expectation::plane()).unwrap_err();
        assert_eq!(failure.before, 3, "{name}: {failure}");
    }
}

#[test]
fn what_is_not_written_is_not_supported() {
    let mut inert = Inert(EDGE.parse().unwrap());
    let (half_edge, at) = (0, Corner::At(0));
    for call in [Call::AddIsolatedVertex { face: 0 }, Call::connect(at, at), Call::RemoveEdge { half_edge }] {
        assert_eq!(inert.apply(call.clone()).unwrap_err(), Refusal::Unsupported);
        assert_eq!(inert.make_edge(call).unwrap_err(), Refusal::Unsupported);
    }
}

/// Counts the lines that a mesh programmer writes, including imports but not blank lines and comments.
#[test]
fn a_mesh_is_put_to_the_test_in_under_forty_lines() {
    let example = include_str!("../../examples/mesh_conformance.rs");
    let (before, rest) = example.split_once("// ---- the adapter and the test").unwrap();
    let (written, _) = rest.split_once("// ---- to here").unwrap();
    let is_code = |line: &&str| !line.trim().is_empty() && !line.trim().starts_with("//") && !line.starts_with(" -");
    let imports = before.lines().filter(|line| line.starts_with("use ")).count();
    let lines = imports + written.lines().filter(is_code).count();
    assert_eq!(lines, 39, "the example says so");
}

#[test]
fn a_map_that_exists_is_the_start_on_every_structure() {
    let program =
        Program::from_bytes(b"a map that is not empty, with holes and isolated vertices: from any bytes at all");
    let mut runner = Runner::new(twinedge::dcel::Dcel::new());
    runner.run(&program);
    let map = runner.into_subject();
    assert!(map.half_edge_count() > 0);
    check(|| map.clone(), &Expectation::plane()).unwrap();
    // The reference made from a view is the same map, and itself valid.
    let start = PointerModel::from_view(&map, &Expectation::plane()).unwrap();
    assert!(twinedge_trials::canonical::isomorphic(&start.model, &map));
    assert!(validate(&start.model, &Expectation::plane(), Collect::All).is_valid());
}

#[test]
fn a_surface_keeps_its_genus_and_a_border_is_closed_in_the_reference() {
    for (triangles, vertices, genus, faces) in [(torus([3, 3]), 9, 1, 18), (RING.to_vec(), 6, 0, 8)] {
        let mesh = Mesh::new(vertices, &triangles, false);
        let start = PointerModel::from_view(&mesh, &MESH).unwrap();
        let report = validate(&start.model, &SURFACE, Collect::All);
        let found = report.figures().expect("the model is a closed surface");
        assert_eq!((found.genus, found.faces), (genus, faces));
    }
}

#[test]
fn a_start_that_will_not_do_is_named() {
    // A half-edge without twin.
    let mut table: Table = EDGE.parse().unwrap();
    table.half_edges[0].as_mut().unwrap().twin = None;
    assert_eq!(PointerModel::from_view(&table, &MESH).unwrap_err(), StartError::NoTwin(0));
    let error = PointerModel::from_view(&table, &Expectation::plane().open()).unwrap_err();
    assert_eq!(error, StartError::OpenWithHoles);
    table.half_edges[0].as_mut().unwrap().twin = Some(0);
    let error = PointerModel::from_view(&table, &Expectation::plane()).unwrap_err();
    assert_eq!(error, StartError::Inconsistent(0));
}

/// A triangle. Its half-edges have no twins.
struct NoTwins;

impl View for NoTwins {
    view_answers! { |_triangle|
        parts => Parts::NONE.with(Part::Faces),
        vertex_slots => 3,
        half_edge_slots => 3,
        face_slots => 1,
        origin(h) => Some(h),
        twin(_h) => None,
        next(h) => Some((h + 1) % 3),
        face(_h) => Some(0),
        outer_half_edge(_f) => Some(0),
    }
}

impl Subject for NoTwins {
    subject_by_index!();
}

#[test]
fn a_structure_without_twins_is_refused_by_name() {
    assert!(validate(&NoTwins, &MESH, Collect::All).is_valid());
    let found = check(|| NoTwins, &MESH).unwrap_err();
    assert_eq!(found.failure.difference, Difference::Start(StartError::NoTwin(0)));
    assert_eq!(
        found.to_string(),
        "at the start: half-edge 0 has no twin; both half-edges of each edge are needed, those of the border included \
         (program::mesh::Named adds them to a mesh)"
    );
}

/// A structure without a handle for one of its half-edges.
struct Nameless(FlipOnly);

impl View for Nameless {
    delegate_view!(|this| &this.0);
}

impl Subject for Nameless {
    type Vertex = usize;
    type HalfEdge = usize;
    type Face = usize;

    fn half_edge_at(&self, index: usize) -> Option<usize> {
        Some(index).filter(|index| *index != 5)
    }
    fn face_of(&self, corner: Corner<usize, usize>) -> Result<usize, Refusal> {
        self.0.face_of(corner)
    }
    fn origin_of(&self, h: usize) -> Result<usize, Refusal> {
        self.0.origin_of(h)
    }
    fn twin_of(&self, h: usize) -> Result<usize, Refusal> {
        self.0.twin_of(h)
    }
    fn next_of(&self, h: usize) -> Result<usize, Refusal> {
        self.0.next_of(h)
    }
}

#[test]
fn half_edges_too_many_too_few_and_without_handle_are_named() {
    let make = |flip| FlipOnly::of(&OCTAHEDRON, 6, flip);
    let found = |flip| check(|| make(flip), &SURFACE).unwrap_err();
    for (found, difference, message) in [
        (
            found(Flip::Adds),
            Difference::Unknown { half_edge: 24, is_named: false },
            "half-edge 24 of the view should not be there",
        ),
        (found(Flip::Drops), Difference::Missing { corner: 22 }, "corner 22 is not in the view"),
        (
            check(|| Nameless(make(Flip::Right)), &SURFACE).unwrap_err(),
            Difference::NoHandle { half_edge: 5 },
            "half_edge_at gives no handle for half-edge 5",
        ),
    ] {
        assert_eq!(found.failure.difference, difference);
        assert!(found.to_string().contains(message), "{found}");
    }
}

#[test]
fn on_discs_and_borders_operators_are_refused_for_their_own_reasons() {
    let mesh = Mesh::new(5, &[[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]], false);
    let mut start = PointerModel::from_view(&mesh, &MESH).unwrap();
    let name = |index: usize| start.half_edges.iter().find(|(other, _)| *other == index).unwrap().1;
    let border = (0..mesh.half_edge_slots()).find(|h| View::face(&mesh, *h).is_none()).unwrap();
    let (border, spoke) = (name(border), name(2));
    let model = &mut start.model;
    let face = model.face_of(Corner::At(spoke)).unwrap();
    assert_eq!(model.unbounded_face(), None);
    assert_eq!(model.face_of(Corner::At(border)), Err(Refusal::Border));
    assert_eq!(model.apply(Call::AddIsolatedVertex { face }), Err(Refusal::NotDisc));
    let corner = Corner::At(border);
    assert_eq!(model.apply(Call::connect(corner, corner)), Err(Refusal::Border));
    assert_eq!(model.apply(Call::SplitVertex { from: corner, to: corner }), Err(Refusal::Border));
    assert_eq!(model.apply(Call::RemoveEdge { half_edge: border }), Err(Refusal::Border));
    assert_eq!(model.apply(Call::FlipEdge { half_edge: border, turn: Turn::Clockwise }), Err(Refusal::Border));
    assert_eq!(model.apply(Call::MeshFlipEdge { half_edge: border }), Err(Refusal::Border));
    assert_eq!(model.apply(Call::MeshSplitFace { half_edge: border }), Err(Refusal::Border));
    // A leaf inside a face cannot be removed: its vertex would be isolated.
    let leaf = model.make_edge(Call::SplitVertex { from: Corner::At(spoke), to: Corner::At(spoke) }).unwrap();
    assert_eq!(model.apply(Call::RemoveEdge { half_edge: leaf }), Err(Refusal::NotDisc));
    assert_eq!(model.apply(Call::MeshFlipEdge { half_edge: spoke }), Err(Refusal::NotTriangle));
}

#[test]
fn structures_that_use_handles_again_are_not_asked_for_stale_ones() {
    let asked = Conformance::of(&MESH).without_stale_handles();
    let summary = asked.check(|| Mesh::new(6, &OCTAHEDRON, false)).unwrap();
    assert!(summary.not_compared().any(|part| part == NotCompared::StaleHandles));
}

/// A mesh without `next` on the border, and perhaps without faces.
struct Bare {
    mesh: Mesh,
    has_faces: bool,
}

impl View for Bare {
    delegate_view!(|this| &this.mesh; except parts, next, face, face_slots);

    fn parts(&self) -> Parts {
        if self.has_faces { self.mesh.parts() } else { Parts::NONE }
    }
    fn next(&self, h: usize) -> Link {
        View::face(&self.mesh, h).and_then(|_| View::next(&self.mesh, h))
    }
    fn face(&self, h: usize) -> Link {
        View::face(&self.mesh, h).filter(|_| self.has_faces)
    }
    fn face_slots(&self) -> usize {
        if self.has_faces { self.mesh.face_slots() } else { 0 }
    }
}

impl Subject for Bare {
    subject_by_index!();

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        self.mesh.apply(call)
    }
}

#[test]
fn half_edges_on_the_border_need_no_next() {
    for has_faces in [true, false] {
        for (triangles, vertices) in [(RING.to_vec(), 6), (vec![[0, 1, 2]], 3)] {
            let make = |has_bug| Bare { mesh: Mesh::new(vertices, &triangles, has_bug), has_faces };
            let summary = check(|| make(false), &MESH).unwrap();
            for name in ["mesh_flip_edge", "mesh_split_edge", "mesh_collapse_edge"] {
                let counts = summary.of(name).unwrap();
                assert!(counts.applied > 200 && counts.refused > 0, "{summary}");
            }
            assert!(summary.not_compared().any(|part| part == NotCompared::BorderNext), "{summary}");
            assert!(check(|| make(true), &MESH).is_err());
        }
    }
    // If it is stored, it is compared.
    let summary = check(|| Mesh::new(6, &RING, false), &MESH).unwrap();
    assert!(summary.not_compared().all(|part| part != NotCompared::BorderNext), "{summary}");
}

/// Regression: a triangle with a loop was half collapsed, and then refused.
#[test]
fn a_collapse_that_is_refused_changes_nothing() {
    for (side, face) in [("left", 0), ("left", 2), ("left", 3), ("right", 0), ("right", 2), ("right", 3)] {
        let build = format!(
            "twinedge program 1\nadd_isolated_vertex unbounded\nsplit_vertex i0 i0\nconnect h0 h0 {side}\nmesh_split_face h{face}"
        );
        let mut runner = Runner::new(Dcel::new());
        runner.run(&build.parse().unwrap());
        for op in every_mesh_op(&runner) {
            let mut attempt = runner.clone();
            if attempt.step(op) != StepOutcome::Applied {
                assert_eq!(Table::copy_of(attempt.subject()), Table::copy_of(runner.subject()), "{build}\n{op}");
            }
        }
    }
}
