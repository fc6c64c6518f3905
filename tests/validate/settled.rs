//! The fast path does not change reports, and accepts valid structures.

use crate::support::erased::{first_broken_rule, validate};
use crate::support::only_live::OnlyLive;
use crate::support::programs::{built, random};
use crate::support::renumbered::renumbered;
use crate::support::rotations::each_rotation_system;
use crate::support::small::small_maps;
use crate::support::tables::{Without, textbook_mesh, torus, without_border};
use crate::support::watched::Watched;
use twinedge::validate::reference::rule_by_rule;
use twinedge::validate::{
    Collect, Expectation, HalfEdgeRow, Part, Parts, Rule, Table, VertexRow, View, Violation, accepts,
};
use twinedge_trials::corrupt::CorruptWork;
use twinedge_trials::enumerate::for_each_corruption;
use twinedge_trials::forms::{forms, projections};
use twinedge_trials::sample::SampleWork;
use twinedge_trials::tables::TablesWork;
use twinedge_trials::{FastPath, RawPointers, Run, Structure, corrupt, sample, tables};

const PLANE: Expectation = Expectation::plane();

/// Asserts that the report equals the rule-by-rule report, for any number of collected violations, and that neither reads vacant
/// slots.
#[track_caller]
fn assert_same(view: &impl View, expectation: &Expectation, what: impl std::fmt::Display) {
    for collect in COLLECTED {
        assert_same_collected(view, expectation, collect, &what);
    }
}

const COLLECTED: [Collect; 3] = [Collect::All, Collect::First, Collect::AtMost(1)];

/// Asserts this for one number of collected violations.
#[track_caller]
fn assert_same_collected(view: &impl View, expectation: &Expectation, collect: Collect, what: &impl std::fmt::Display) {
    let view = OnlyLive(view);
    let report = validate(&view, expectation, collect);
    let by_the_rules = rule_by_rule(&view, expectation, collect);
    assert_eq!(report, by_the_rules, "{what}\n{expectation:?}\n{collect:?}\n{report}\n{by_the_rules}");
}

#[test]
fn what_is_right_in_any_form_is_not_left_to_the_rules() {
    let run = Run::default();
    tables(TablesWork { half_edges: 2 }, &FastPath, &run).into_result().unwrap();
    sample(SampleWork { tables: 8_000, seed: 1 }, &FastPath, &run).into_result().unwrap();
    let structure = Structure::new("second model", RawPointers::new, PLANE);
    corrupt(&structure, CorruptWork { edges: 2, pairs: 800, seed: 1 }, &FastPath, &run, &|_| {})
        .unwrap()
        .into_result()
        .unwrap();
}

/// With at least four edges there are surfaces with more handles than components.
#[test]
fn every_rotation_system_of_up_to_four_edges_is_accepted_with_its_genus() {
    let mut by_genus = [0; 3];
    for edges in 0..=4 {
        each_rotation_system(edges, |table| {
            let surface = Expectation::surface();
            let genus = validate(table, &surface, Collect::First).into_result().unwrap().genus;
            by_genus[genus] += 1;
            assert!(accepts(table, &surface.open()) && accepts(table, &surface.genus(genus)), "{table}");
            assert!(!accepts(table, &surface.genus(genus + 1)), "{table}");
            let bare = table.without(Part::Faces).without(Part::Prev).without(Part::Leaving);
            assert!(accepts(&bare, &surface) && accepts(&bare, &PLANE) == (genus == 0), "{bare}");
        });
    }
    assert_eq!(by_genus, [23_593, 16_454, 1_020]);
}

/// Every projection of every small map is valid.
#[test]
fn right_maps_in_every_form() {
    let (mut opened, mut turn) = ([0; 2], 0);
    for table in small_maps(3, 3) {
        for form in forms() {
            let all = projections(&table, &form);
            opened[usize::from(form.expectation.is_open())] += all.len() - 1;
            for projection in all {
                assert!(accepts(&projection, &form.expectation), "{table}\n{projection}\n{form:?}");
                assert_eq!(first_broken_rule(&projection, &form.expectation), None, "{projection}\n{form:?}");
                // All violations, the first ones, and one in turn.
                turn += 1;
                let collect = COLLECTED[turn % COLLECTED.len()];
                assert_same_collected(&projection, &form.expectation, collect, &projection);
            }
        }
    }
    assert!(opened[0] == 0 && opened[1] > 10_000, "{opened:?}");
}

/// Collects in turn all violations, the first ones, and one.
#[test]
fn every_corruption_of_small_maps_in_every_form() {
    let mut corruptions = 0;
    for table in small_maps(2, 2) {
        for form in forms() {
            for mut projection in projections(&table, &form) {
                for_each_corruption(&mut projection, form.parts, |corrupt, _, _| {
                    let collect = COLLECTED[corruptions % COLLECTED.len()];
                    corruptions += 1;
                    assert_same_collected(corrupt, &form.expectation, collect, corrupt);
                });
            }
        }
    }
    assert!(corruptions > 100_000, "{corruptions}");
}

/// One edge. The wrong next belongs to the half-edge that ends at vertex 1. So no next leaves this vertex, which names a boundary
/// component, as only isolated vertices may.
#[test]
fn a_vertex_that_no_next_leaves() {
    let table: Table = "V 2 0 - 1 1 H 2 0 1 0 1 0 1 0 0 0 0 B 2 0 h0 i0 0 v1 i1 F 1 - 2 0 1".parse().unwrap();
    let table = table.without(Part::Leaving);
    assert!(validate(&table, &PLANE, Collect::All).broken_rules().any(|rule| rule == Rule::B2));
    assert_same(&table, &PLANE, &table);
}

/// Two edges and an isolated vertex. The half-edges of the second edge consistently name the boundary component of the vertex, and
/// a wrong prev at the first edge prevents walks along cycles.
#[test]
fn half_edges_on_the_boundary_component_of_a_vertex_where_prev_is_wrong_elsewhere() {
    let table = "V 5 0 - 1 - 2 - 3 - - 1 H 4 0 1 1 0 0 1 0 0 0 0 2 3 3 3 1 3 2 2 2 1 B 2 0 h0 i0 0 v4 i1 F 1 - 2 0 1";
    let table: Table = table.parse().unwrap();
    let report = validate(&table, &PLANE, Collect::All);
    let second = Violation::SecondCycle { boundary: 1, cycle: 0, half_edges: 2 };
    assert!(report.violations().contains(&second), "{report}");
    assert_same(&table, &PLANE, &table);
}

/// A torus with a border, without `prev`, where the plane is expected. Only T3 is broken, so the components are found again by
/// walks around the vertices, which at the border go back along the cycles.
#[test]
fn an_open_torus_in_the_plane_where_there_is_no_prev() {
    let mut triangles = torus([3, 4]);
    triangles.pop();
    let table = without_border(&textbook_mesh(12, &triangles)).without(Part::Prev);
    for table in [Part::Faces, Part::UnboundedFace].map(|part| table.without(part)) {
        let report = validate(&table, &PLANE.open(), Collect::All);
        assert_eq!(report.broken_rules().next(), Some(Rule::T3), "{report}");
        assert_same(&table, &PLANE.open(), &table);
    }
}

/// This number of loops, each at its own vertex.
fn loops(count: usize) -> Table {
    let half_edge = |h: usize| HalfEdgeRow {
        origin: Some(h / 2),
        twin: Some(h ^ 1),
        next: Some(h),
        prev: Some(h),
        ..HalfEdgeRow::default()
    };
    Table {
        parts: Parts::ALL.without(Part::Faces),
        vertices: (0..count).map(|v| Some(VertexRow { leaving: Some(2 * v), ..VertexRow::default() })).collect(),
        half_edges: (0..2 * count).map(|h| Some(half_edge(h))).collect(),
        ..Table::default()
    }
}

#[test]
fn any_number_of_wrong_half_edges() {
    for wrong in [0, 1, 2, 500, 1023, 1024, 1025, 3000] {
        let mut twins = loops(3000);
        let mut prevs = loops(3000);
        for v in 0..wrong {
            twins.half_edges[2 * v].as_mut().unwrap().twin = Some(2 * v);
            prevs.half_edges[2 * v].as_mut().unwrap().prev = Some(2 * v + 1);
        }
        for table in [twins, prevs] {
            assert_same(&table, &PLANE, wrong);
        }
    }
}

/// The fast path reads a link once for each rule that uses it, and where walks follow it.
#[test]
fn one_wrong_link_does_not_make_the_rules_ask_on_and_on() {
    let count = 1000;
    let n = 2 * count;
    let asked = |table: &Table| {
        let view = Watched::new(table);
        let _ = validate(&view, &PLANE, Collect::All);
        [view.twin.get(), view.next.get(), view.prev.get()]
    };
    // Without faces the cycles are counted, each half-edge with the three that follow.
    assert_eq!(asked(&loops(count)), [2 * n, 4 * n, n]);
    let wrong: [fn(&mut HalfEdgeRow); 3] = [|row| row.twin = None, |row| row.next = None, |row| row.prev = None];
    for wrong in wrong {
        let mut table = loops(count);
        wrong(table.half_edges[count].as_mut().unwrap());
        let [twin, next, prev] = asked(&table);
        assert!(twin < 5 * n + 20 && next < 5 * n + 20 && prev < 4 * n + 20, "{twin} {next} {prev}");
    }
}

/// Pseudorandom numbers below a bound, always the same for a seed.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % end.max(1)
    }

    /// Distinct slots for `count` records, and two more.
    fn slots(&mut self, count: usize) -> Vec<usize> {
        let mut slots: Vec<usize> = (0..count + 2).collect();
        for i in (1..slots.len()).rev() {
            slots.swap(i, self.below(i + 1));
        }
        slots
    }

    /// The structure with its records in another order, and vacant slots among them.
    fn renumber(&mut self, table: &Table) -> Table {
        let counts = [table.vertices.len(), table.half_edges.len(), table.boundaries.len(), table.faces.len()];
        renumbered(table, &counts.map(|count| self.slots(count)))
    }
}

/// Asserts equal reports, for the table and after changing some of its links to other half-edges.
#[track_caller]
fn assert_same_with_wrong_links(table: &Table, expectation: &Expectation, numbers: &mut Numbers) {
    assert_same(table, expectation, table);
    for _ in 0..4 {
        let mut wrong = table.clone();
        let (at, to) = (numbers.below(table.half_edges.len()), numbers.below(table.half_edges.len()));
        if let Some(row) = &mut wrong.half_edges[at] {
            *[&mut row.next, &mut row.prev, &mut row.twin][numbers.below(3)] = Some(to);
        }
        assert_same(&wrong, expectation, &wrong);
    }
}

/// Maps with tens of edges, in every form. With three edges no cycle is long, and each component has only one vertex smaller than
/// its neighbours.
#[test]
fn larger_maps_with_their_records_in_any_order() {
    for seed in 0..12 {
        let mut numbers = Numbers(seed);
        let table = numbers.renumber(&Table::copy_of(&built(&random(seed, 600))).unwrap());
        for form in forms() {
            let all = projections(&table, &form);
            for _ in 0..3 {
                let projection = &all[numbers.below(all.len())];
                assert!(validate(projection, &form.expectation, Collect::First).is_valid(), "{projection}");
                assert_same_with_wrong_links(projection, &form.expectation, &mut numbers);
            }
        }
    }
}

/// Meshes of any genus, with and without border, with border half-edges stored and not.
#[test]
fn larger_meshes_with_their_records_in_any_order() {
    let mesh = Expectation::surface();
    for seed in 0..60 {
        let mut numbers = Numbers(seed);
        // Up to three of them side by side, with some triangles removed.
        let mut triangles = Vec::new();
        let parts = 1 + numbers.below(3);
        for part in 0..parts {
            triangles.extend(torus([3, 4]).into_iter().map(|triangle| triangle.map(|v| v + 12 * part)));
        }
        let vertices = triangles.len() / 2;
        let taken_out = numbers.below(4);
        for _ in 0..taken_out {
            triangles.swap_remove(numbers.below(triangles.len()));
        }
        let paired = textbook_mesh(vertices, &triangles);
        let bare = without_border(&paired);
        for table in [paired, bare].map(|table| numbers.renumber(&table)) {
            let lacking = [Part::Prev, Part::Leaving, Part::Faces].map(|part| table.without(part));
            for table in lacking.iter().chain([&table]) {
                for expectation in [mesh, mesh.open()] {
                    assert_same_with_wrong_links(table, &expectation, &mut numbers);
                    if taken_out == 0 {
                        let figures = validate(table, &expectation, Collect::All).into_result().unwrap();
                        assert_eq!((figures.components, figures.genus), (parts, parts));
                    }
                }
            }
        }
    }
}
