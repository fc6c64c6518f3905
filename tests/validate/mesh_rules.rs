//! The optional rules, M1 … M8, and the counts that do not depend on the representation of borders.

use crate::support::erased::validate;
use crate::support::nested::{PLANE, nested, nested_textbook};
use crate::support::opinions::{agree, agree_on_first, broken, only};
use crate::support::tables::{
    TETRAHEDRON, TEXTBOOK, Without, digon, face, half_edge, map, one_loop, textbook_map, vertex,
    with_boundary_components,
};
use std::collections::HashMap;
use twinedge::validate::{
    Collect, Expectation, FaceRow, Field, Figures, HalfEdgeRow, Part, Parts, Record, Report, Rule, Start, Table,
    Unchecked, VertexRow, Violation,
};
use twinedge_trials::enumerate::{Cell, TableCells, Value, for_each_assignment, for_each_corruption};

const MESH: Expectation = Expectation::surface().open();

/// The representation of a border.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Border {
    /// Its edges have one half-edge, without twin.
    OneHalfEdge,
    /// Its edges have two half-edges, one of them without face.
    NoFace,
}

const BORDERS: [Border; 2] = [Border::OneHalfEdge, Border::NoFace];

/// A mesh of these faces in the form of the textbook. Each vertex lies on at most one border.
fn faces<F: AsRef<[usize]>>(vertices: usize, faces: &[F], border: Border) -> Table {
    let vertices = vec![Some(VertexRow::default()); vertices];
    let mut table = Table { parts: TEXTBOOK, vertices, ..Table::default() };
    let mut sides: HashMap<(usize, usize), usize> = HashMap::new();
    for (f, face) in faces.iter().map(AsRef::as_ref).enumerate() {
        let (first, n) = (table.half_edges.len(), face.len());
        table.faces.push(Some(FaceRow { outer_half_edge: Some(first), ..FaceRow::default() }));
        for (i, v) in face.iter().enumerate() {
            sides.insert((*v, face[(i + 1) % n]), first + i);
            vertex(&mut table, *v).leaving = Some(first + i);
            let (next, prev) = (Some(first + (i + 1) % n), Some(first + (i + n - 1) % n));
            table.half_edges.push(Some(HalfEdgeRow {
                origin: Some(*v),
                next,
                prev,
                face: Some(f),
                ..HalfEdgeRow::default()
            }));
        }
    }
    let mut alone: Vec<(usize, usize)> =
        sides.keys().filter(|(u, v)| !sides.contains_key(&(*v, *u))).copied().collect();
    alone.sort_unstable();
    for (u, v) in alone.iter().filter(|_| border == Border::NoFace) {
        sides.insert((*v, *u), table.half_edges.len());
        table.half_edges.push(Some(HalfEdgeRow { origin: Some(*v), ..HalfEdgeRow::default() }));
    }
    for ((u, v), h) in &sides {
        half_edge(&mut table, *h).twin = sides.get(&(*v, *u)).copied();
    }
    for (u, v) in alone.iter().filter(|_| border == Border::NoFace) {
        let follows = alone.iter().find(|(_, to)| to == u).expect("a border is a loop");
        let (h, next) = (sides[&(*v, *u)], sides[&(follows.1, follows.0)]);
        half_edge(&mut table, h).next = Some(next);
        half_edge(&mut table, next).prev = Some(h);
    }
    table
}

/// The squares of a grid, closed to a ring in each direction if `around` says so, without the holes.
fn grid([columns, rows]: [usize; 2], around: [bool; 2], holes: &[[usize; 2]]) -> (usize, Vec<[usize; 4]>) {
    let size = [columns + usize::from(!around[0]), rows + usize::from(!around[1])];
    let at = |x: usize, y: usize| x % size[0] + y % size[1] * size[0];
    let cells = (0..columns * rows).map(|i| [i % columns, i / columns]).filter(|cell| !holes.contains(cell));
    let square = |[x, y]: [usize; 2]| [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
    (size[0] * size[1], cells.map(square).collect())
}

/// Name, vertices, faces, border loops, Euler characteristic and genus.
type Surface = (&'static str, usize, Vec<[usize; 4]>, [isize; 3]);

/// Surfaces with their numbers from the classification of surfaces: `χ = 2 − 2g − b`.
fn surfaces() -> Vec<Surface> {
    let surface = |name, (vertices, faces), numbers| (name, vertices, faces, numbers);
    vec![
        surface("disc", grid([2, 2], [false, false], &[]), [1, 1, 0]),
        surface("annulus", grid([4, 2], [true, false], &[]), [2, 0, 0]),
        surface("annulus of 18 cycles", grid([4, 4], [true, false], &[]), [2, 0, 0]),
        surface("pair of pants", grid([5, 3], [false, false], &[[1, 1], [3, 1]]), [3, -1, 0]),
        surface("torus", grid([3, 3], [true, true], &[]), [0, 0, 1]),
        surface("torus with a border", grid([3, 3], [true, true], &[[1, 1]]), [1, -1, 1]),
        surface("torus with two borders", grid([5, 3], [true, true], &[[1, 1], [3, 1]]), [2, -2, 1]),
    ]
}

fn figures(table: &Table, expectation: Expectation) -> Figures {
    validate(table, &expectation, Collect::All).into_result().unwrap_or_else(|report| panic!("{report}"))
}

/// The counts common to both representations of a border.
fn numbers(found: &Figures) -> [usize; 8] {
    let Figures { vertices, edges, faces, components, cycles, borders, isolated_vertices, genus, .. } = *found;
    [vertices, edges, faces, components, cycles, borders, isolated_vertices, genus]
}

#[test]
fn the_figures_do_not_depend_on_the_way_in_which_a_border_is_kept() {
    for (name, vertices, squares, [borders, euler, genus]) in surfaces() {
        let mut all = vec![];
        for border in BORDERS {
            let textbook = faces(vertices, &squares, border);
            let records = with_boundary_components(&textbook);
            for whole in [textbook, records] {
                for table in [whole.without(Part::Prev), whole.without(Part::Leaving), whole] {
                    let found = figures(&table, MESH);
                    assert_eq!(found.euler_characteristic, euler, "{name}, {border:?}");
                    assert_eq!(isize::try_from(found.borders), Ok(borders), "{name}, {border:?}");
                    assert_eq!(isize::try_from(found.genus), Ok(genus), "{name}, {border:?}");
                    assert_eq!((found.faces, found.cycles), (squares.len(), squares.len()), "{name}, {border:?}");
                    let asked = MESH.components(1).sides(4).simple().no_unused_vertices();
                    let asked = asked.borders(found.borders).genus(found.genus);
                    assert!(validate(&table, &asked, Collect::All).is_valid(), "{name}, {border:?}");
                    assert_eq!(broken(&validate(&table, &asked.closed(), Collect::All)).is_empty(), borders == 0);
                    all.push(numbers(&found));
                }
            }
        }
        assert!(all.iter().all(|numbers| *numbers == all[0]), "{name}: {all:?}");
    }
}

/// The sum of T3 is `χ = 2C − I − 2g − B` if each face has one cycle, over several components, one of them a vertex.
#[test]
fn the_euler_characteristic_is_that_of_the_whole() {
    for border in BORDERS {
        let ([pants, pants_faces], [torus, torus_faces]) = ([24, 13], [9, 8]);
        let (_, mut squares) = grid([5, 3], [false, false], &[[1, 1], [3, 1]]);
        let (_, others) = grid([3, 3], [true, true], &[[1, 1]]);
        squares.extend(others.iter().map(|square| square.map(|v| v + pants)));
        let table = faces(pants + torus + 1, &squares, border);
        assert_eq!(agree_on_first(&table, MESH), None);
        let found = figures(&table, MESH);
        assert_eq!((found.components, found.isolated_vertices, found.borders, found.genus), (3, 1, 4, 1));
        assert_eq!((found.faces, found.cycles), (pants_faces + torus_faces, pants_faces + torus_faces));
        assert_eq!(found.euler_characteristic, 2 * 3 - 1 - 2 - 4);
        let [v, e, f] = [found.vertices, found.edges, found.faces].map(|n| isize::try_from(n).unwrap());
        assert_eq!(found.euler_characteristic, v - e + f);
        // M5 does not count vertices without edges.
        let asked = MESH.components(2).genus(1).borders(4).sides(4).simple();
        assert_eq!(agree_on_first(&table, asked), None);
        assert_eq!(agree_on_first(&table, asked.components(3)), Some(Rule::M5));
    }
}

/// In the plane: a triangle in a triangle, with a vertex between them. F counts faces, whose boundaries may have several
/// cycles.
#[test]
fn the_euler_characteristic_in_the_plane_is_one_more_than_the_components() {
    let found = figures(&nested(), PLANE);
    assert_eq!((found.components, found.faces, found.cycles, found.euler_characteristic), (3, 3, 4, 4));
    // Without faces, each cycle counts as one.
    let found = figures(&nested().without(Part::Faces), PLANE);
    assert_eq!((found.faces, found.cycles, found.euler_characteristic), (0, 4, 2 * 3 - 1));
}

/// An annulus: its two border loops have different representations.
#[test]
fn both_ways_of_keeping_borders_in_one_mesh() {
    let (vertices, squares) = grid([4, 2], [true, false], &[]);
    let mut table = faces(vertices, &squares, Border::NoFace);
    // Remove the half-edges of one of the two loops.
    let start = table.half_edges.iter().position(|row| row.unwrap().face.is_none()).unwrap();
    let mut h = start;
    for _ in 0..4 {
        let row = table.half_edges[h].take().unwrap();
        half_edge(&mut table, row.twin.unwrap()).twin = None;
        h = row.next.unwrap();
    }
    assert_eq!(h, start);
    assert_eq!(agree(&table, MESH.borders(2).closed()), Some(Rule::M4));
    let found = figures(&table, MESH.borders(2));
    assert_eq!((found.cycles, found.borders, found.euler_characteristic), (8, 2, 0));
}

fn disc(border: Border) -> Table {
    let (vertices, squares) = grid([2, 1], [false, false], &[]);
    faces(vertices, &squares, border)
}

/// The claims that two adjacent squares keep.
const DISC: Expectation = MESH.no_unused_vertices().simple().sides(4).components(1).borders(1).genus(0);

#[test]
fn what_is_changed_below_is_right_before() {
    for border in BORDERS {
        assert_eq!(agree(&disc(border), DISC), None);
        assert_eq!(agree(&with_boundary_components(&disc(border)), MESH.sides(4).borders(1)), None);
    }
}

#[test]
fn m1_a_vertex_is_unused() {
    for border in BORDERS {
        let mut table = disc(border);
        table.vertices.extend([None, Some(VertexRow::default())]);
        only(Rule::M1, &table, DISC, &[Violation::UnusedVertex { vertex: 7 }]);
    }
    // Also with every part stored: the isolated vertex between the nested triangles.
    let plane = PLANE.no_unused_vertices();
    only(Rule::M1, &nested(), plane, &[Violation::UnusedVertex { vertex: 6 }]);
}

#[test]
fn m2_an_edge_is_a_loop_or_parallel_to_another() {
    // A loop in the plane, and two edges between two vertices.
    let plane = PLANE.simple();
    only(Rule::M2, &one_loop(), plane, &[Violation::LoopEdge { half_edge: 0, vertex: 0 }]);
    let digon = digon();
    let parallel = |first, second| Violation::ParallelEdges { first, second, vertices: [0, 1] };
    assert!(parallel(0, 2).message().contains("that both join vertices 0 and 1: "));
    only(Rule::M2, &digon, plane, &[parallel(0, 2)]);
    only(Rule::M2, &digon.without(Part::Prev), plane, &[parallel(0, 2)]);
    // Two triangles not joined along their common edge.
    let mut slit = faces(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]], Border::OneHalfEdge);
    let h = half_edge(&mut slit, 0).twin.unwrap();
    half_edge(&mut slit, 0).twin = None;
    half_edge(&mut slit, h).twin = None;
    only(Rule::M2, &slit, MESH.simple(), &[parallel(0, h)]);
    // Two faces back to back, with one half-edge per edge.
    let pillow = faces(3, &[[0, 1, 2], [2, 1, 0]], Border::OneHalfEdge);
    assert_eq!(agree(&pillow, MESH.simple()), None);
}

#[test]
fn m3_a_face_has_a_side_too_many() {
    for border in BORDERS {
        let table = faces(6, &[vec![0, 1, 4, 3], vec![1, 2, 4], vec![2, 5, 4]], border);
        let wrong = |record, sides, expected| Violation::WrongSides { record, sides, expected };
        let quad = wrong(Record::Face(0), 4, 3);
        only(Rule::M3, &table, MESH.triangles(), &[quad]);
        only(Rule::M3, &with_boundary_components(&table), MESH.triangles(), &[quad]);
        let triangles = [1, 2].map(|f| wrong(Record::Face(f), 3, 4));
        only(Rule::M3, &table, MESH.sides(4), &triangles);
    }
    // Without faces, each cycle is a face, named by its first half-edge.
    let table = textbook_map(3, &[(0, 2), (1, 5), (1, 4), (2, 1), (2, 0), (0, 3)], &[]).without(Part::Faces);
    let cycles = [0, 1].map(|h| Violation::WrongSides { record: Record::HalfEdge(h), sides: 3, expected: 2 });
    only(Rule::M3, &table, MESH.sides(2), &cycles);
    assert_eq!(agree(&table, MESH.triangles()), None);
    // A square with a diagonal, in the plane: the unbounded face may have any number.
    let half_edges = [(0, 2), (1, 9), (1, 4), (2, 1), (2, 0), (0, 6), (2, 8), (3, 3), (3, 5), (0, 7)];
    let square = map(4, &half_edges, &[(None, &[Start::HalfEdge(1)]), (Some(0), &[]), (Some(5), &[])]);
    assert_eq!(agree(&square, PLANE.triangles()), None);
    // Holes count: 3 half-edges around the face between two triangles, 3 in it.
    let between = Violation::WrongSides { record: Record::Face(1), sides: 6, expected: 3 };
    only(Rule::M3, &nested(), PLANE.triangles(), &[between]);
    only(Rule::M3, &nested_textbook(), PLANE.triangles(), &[between]);
}

#[test]
fn m4_a_mesh_has_a_border() {
    let triangle = |border| faces(3, &[[0, 1, 2]], border);
    let at = |half_edge, vertices, lacks| Violation::OnBorder { half_edge, vertices, lacks };
    let no_twin = [(0, [0, 1]), (1, [1, 2]), (2, [2, 0])].map(|(h, ends)| at(h, ends, Field::Twin));
    only(Rule::M4, &triangle(Border::OneHalfEdge), MESH.closed(), &no_twin);
    let no_face = [(3, [1, 0]), (4, [2, 1]), (5, [0, 2])];
    only(Rule::M4, &triangle(Border::NoFace), MESH.closed(), &no_face.map(|(h, ends)| at(h, ends, Field::Face)));
    let records = with_boundary_components(&triangle(Border::NoFace));
    only(Rule::M4, &records, MESH.closed(), &no_face.map(|(h, ends)| at(h, ends, Field::Boundary)));
    // Without faces, a missing face cannot be noticed.
    let bare = |border| triangle(border).without(Part::Faces);
    assert_eq!(agree(&bare(Border::NoFace), MESH.closed()), None);
    only(Rule::M4, &bare(Border::OneHalfEdge), MESH.closed(), &no_twin);
    // If borders are not legal, R1 has reported them.
    let closed = Expectation::surface().closed();
    let report = validate(&triangle(Border::OneHalfEdge), &closed, Collect::All);
    assert_eq!(broken(&report), [Rule::R1]);
    assert_eq!(report.outcome(Rule::M4).unwrap().unchecked, Some(Unchecked::Broken(Rule::R1)));
}

#[test]
fn m5_there_is_a_second_component() {
    for border in BORDERS {
        let table = faces(6, &[[0, 1, 2], [3, 4, 5]], border);
        let wrong = |expected| [Violation::WrongComponents { found: 2, expected }];
        only(Rule::M5, &table, MESH.components(1), &wrong(1));
        only(Rule::M5, &table, MESH.components(0), &wrong(0));
    }
    // A drawn map has three components, including a vertex.
    only(Rule::M5, &nested(), PLANE.components(3), &[Violation::WrongComponents { found: 2, expected: 3 }]);
}

#[test]
fn m6_there_is_a_second_border() {
    let (vertices, squares) = grid([3, 1], [true, false], &[]);
    for border in BORDERS {
        let table = faces(vertices, &squares, border);
        let wrong = |expected| [Violation::WrongBorders { found: 2, expected }];
        only(Rule::M6, &table, MESH.borders(1), &wrong(1));
        only(Rule::M6, &table, MESH.borders(0), &wrong(0));
        only(Rule::M6, &with_boundary_components(&table), MESH.borders(3), &wrong(3));
    }
    only(Rule::M6, &nested(), PLANE.borders(1), &[Violation::WrongBorders { found: 0, expected: 1 }]);
}

#[test]
fn m7_a_sphere_is_no_torus() {
    let tetrahedron = faces(4, &TETRAHEDRON, Border::OneHalfEdge);
    only(Rule::M7, &tetrahedron, MESH.genus(1), &[Violation::WrongGenus { found: 0, expected: 1 }]);
    let (vertices, squares) = grid([3, 3], [true, true], &[[0, 0]]);
    for border in BORDERS {
        let torus = faces(vertices, &squares, border);
        only(Rule::M7, &torus, MESH.genus(0), &[Violation::WrongGenus { found: 1, expected: 0 }]);
        only(Rule::M7, &torus, MESH.genus(2), &[Violation::WrongGenus { found: 1, expected: 2 }]);
    }
}

#[test]
fn m8_a_border_vertex_keeps_an_inner_half_edge() {
    let wrong = |vertex, half_edge, border| Violation::KeptInside { vertex, half_edge, border };
    // Two triangles. Half-edges 2 and 3 are their diagonal.
    let mut alone = faces(4, &[[0, 1, 2], [0, 2, 3]], Border::OneHalfEdge);
    for (v, h) in [(0, 0), (1, 1), (2, 4), (3, 5)] {
        vertex(&mut alone, v).leaving = Some(h);
    }
    assert_eq!(agree(&alone, MESH.border_kept()), None);
    vertex(&mut alone, 0).leaving = Some(3);
    only(Rule::M8, &alone, MESH.border_kept(), &[wrong(0, 3, 0)]);
    only(Rule::M8, &alone.without(Part::Faces), MESH.border_kept(), &[wrong(0, 3, 0)]);
    // Now half-edges 6 … 9 have no face.
    let mut twins = faces(4, &[[0, 1, 2], [0, 2, 3]], Border::NoFace);
    for h in 6..10 {
        let v = half_edge(&mut twins, h).origin.unwrap();
        vertex(&mut twins, v).leaving = Some(h);
    }
    assert_eq!(agree(&twins, MESH.border_kept()), None);
    assert_eq!(agree(&with_boundary_components(&twins), MESH.border_kept()), None);
    let v = half_edge(&mut twins, 2).origin.unwrap();
    let border = vertex(&mut twins, v).leaving.replace(2).unwrap();
    only(Rule::M8, &twins, MESH.border_kept(), &[wrong(v, 2, border)]);
    only(Rule::M8, &with_boundary_components(&twins), MESH.border_kept(), &[wrong(v, 2, border)]);
    // Without faces this cannot be decided; vertices that store nothing break no promise; a closed surface has no border.
    assert_eq!(agree(&twins.without(Part::Faces), MESH.border_kept()), None);
    let report = validate(&twins.without(Part::Leaving), &MESH.border_kept(), Collect::All);
    assert_eq!(report.outcome(Rule::M8).unwrap().unchecked, Some(Unchecked::Lacks(Part::Leaving)));
    assert!(report.is_valid());
    let pillow = faces(3, &[[0, 1, 2], [2, 1, 0]], Border::OneHalfEdge);
    assert_eq!(agree(&pillow, Expectation::surface().border_kept()), None);
    // A violation of V1 is not reported again.
    vertex(&mut twins, 0).leaving = Some(1);
    let report = validate(&twins, &MESH.border_kept(), Collect::All);
    assert_eq!(report.outcome(Rule::M8).unwrap().unchecked, Some(Unchecked::Broken(Rule::V1)));
}

const OPTIONAL: [Rule; 8] = [Rule::M1, Rule::M2, Rule::M3, Rule::M4, Rule::M5, Rule::M6, Rule::M7, Rule::M8];

/// The expectation with every optional rule.
const fn everything(expectation: Expectation) -> Expectation {
    expectation.no_unused_vertices().simple().sides(3).closed().components(1).borders(0).genus(0).border_kept()
}

#[test]
fn a_rule_is_in_the_report_if_and_only_if_it_is_asked_for() {
    let none = Expectation::surface();
    let single = [
        (Rule::M1, none.no_unused_vertices(), None),
        (Rule::M2, none.simple(), None),
        (Rule::M3, none.sides(7), Some(7)),
        (Rule::M4, none.closed(), None),
        (Rule::M5, none.components(0), Some(0)),
        (Rule::M6, none.borders(usize::MAX), Some(usize::MAX)),
        (Rule::M7, none.genus(2), Some(2)),
        (Rule::M8, none.border_kept(), None),
    ];
    let rules = |expectation: &Expectation| -> Vec<Rule> {
        let report = validate(&Table::default(), expectation, Collect::All);
        report.outcomes().map(|(rule, _)| rule).collect()
    };
    let topology: Vec<Rule> = Rule::ALL.iter().copied().filter(|r| !r.is_geometric() && !r.is_optional()).collect();
    assert_eq!(topology.len(), 14);
    assert_eq!(rules(&none), topology);
    for (rule, expectation, number) in single {
        assert_eq!(rules(&expectation), [&topology[..], &[rule]].concat());
        for other in Rule::ALL {
            assert_eq!(expectation.asks_for(*other), !other.is_optional() || *other == rule);
            assert_eq!(expectation.expected_count(*other), number.filter(|_| *other == rule));
        }
    }
    assert_eq!(rules(&everything(none)), [&topology[..], &OPTIONAL].concat());
    let names = |report: &Report| report.to_string().lines().filter(|line| line.starts_with('M')).count();
    assert_eq!(names(&validate(&Table::default(), &none, Collect::All)), 0);
    assert!(Rule::ALL.iter().all(|rule| rule.is_optional() == OPTIONAL.contains(rule)));
    // The last number counts.
    assert_eq!(none.triangles().sides(5), none.sides(5));
    assert_ne!(none.genus(0), none);
}

/// If a rule before M is broken, some rules are not checked, and the report says why.
#[test]
fn what_cannot_be_known_is_not_checked() {
    let expectation = everything(MESH);
    let unchecked = |change: &dyn Fn(&mut Table)| -> Vec<(Rule, Rule)> {
        let mut table = disc(Border::OneHalfEdge);
        change(&mut table);
        agree(&table, expectation);
        let report = validate(&table, &expectation, Collect::All);
        assert!(!report.is_valid());
        let why = |rule: &Rule| match report.outcome(*rule)?.unchecked? {
            Unchecked::Broken(broken) => Some((*rule, broken)),
            other => panic!("{rule}: {other}"),
        };
        OPTIONAL.iter().filter_map(why).collect()
    };
    let because = |broken: Rule, rules: &[Rule]| rules.iter().map(|rule| (*rule, broken)).collect::<Vec<_>>();
    let [_, m2, m3, _, m5, m6, m7, _] = OPTIONAL;
    assert_eq!(unchecked(&|_| ()), []);
    assert_eq!(unchecked(&|t| half_edge(t, 0).origin = Some(99)), because(Rule::R1, &OPTIONAL));
    // Of the links from faces, only M3 needs any.
    assert_eq!(unchecked(&|t| face(t, 0).outer_half_edge = Some(99)), because(Rule::R1, &[m3]));
    assert_eq!(unchecked(&|t| face(t, 0).outer_half_edge = None), because(Rule::F1, &[m3]));
    assert_eq!(unchecked(&|t| half_edge(t, 0).twin = Some(0)), because(Rule::L1, &[m2, m5, m6, m7]));
    assert_eq!(unchecked(&|t| half_edge(t, 0).next = Some(2)), because(Rule::L2, &[m2, m3, m5, m6, m7]));
    // The second fan at vertex 1.
    let two_fans = |t: &mut Table| {
        *t = faces(5, &[[0, 1, 2], [1, 3, 4]], Border::OneHalfEdge);
    };
    assert_eq!(unchecked(&two_fans), because(Rule::V2, &[m5, m6, m7]));
    let face_changes = |t: &mut Table| half_edge(t, 0).face = Some(1);
    assert_eq!(unchecked(&face_changes), because(Rule::B1, &[m3, m6]));
    let torus = {
        let (vertices, squares) = grid([3, 3], [true, true], &[]);
        faces(vertices, &squares, Border::OneHalfEdge)
    };
    let report = validate(&torus.without(Part::Holes), &PLANE.genus(0), Collect::All);
    assert_eq!(report.outcome(Rule::M7).unwrap().unchecked, Some(Unchecked::Broken(Rule::T3)));
}

#[test]
fn what_a_border_is_cannot_be_counted_where_a_face_changes_along_a_cycle() {
    let mut table = disc(Border::NoFace);
    half_edge(&mut table, 0).face = None;
    let counts = |table: &Table| *validate(table, &MESH, Collect::All).counts();
    let found = counts(&table);
    assert_eq!((found.cycles, found.borders, found.genus), (None, None, Some(0)));
    let bare = counts(&table.without(Part::Faces));
    assert_eq!((bare.cycles, bare.borders), (Some(3), Some(0)));
}

#[test]
fn the_first_violation_is_of_the_first_rule_that_is_asked_for() {
    let mut table = disc(Border::NoFace);
    table.vertices.push(Some(VertexRow::default()));
    let expectation = everything(MESH.genus(3)).genus(4).components(7);
    let all = validate(&table, &expectation, Collect::All);
    assert_eq!(broken(&all), [Rule::M1, Rule::M3, Rule::M4, Rule::M5, Rule::M6, Rule::M7, Rule::M8]);
    let first = validate(&table, &expectation, Collect::First);
    assert_eq!(first.violations(), &all.violations()[..1]);
    for rule in &OPTIONAL[1..] {
        assert_eq!(first.outcome(*rule).unwrap().unchecked, Some(Unchecked::Stopped));
    }
}

/// Every change of one cell of a few surfaces, in both forms, under expectations that hold and others that do not. The
/// reference takes long for the tetrahedron, which is only changed in its whole forms, under all expectations at once.
#[test]
fn both_validators_agree_on_every_corruption() {
    let two = faces(7, &[[0, 1, 2], [3, 4, 5]], Border::NoFace);
    let tetrahedron = faces(4, &TETRAHEDRON, Border::OneHalfEdge);
    let tables = [(disc(Border::OneHalfEdge), 3), (disc(Border::NoFace), 3), (two, 3), (tetrahedron, 1)];
    let (mut met, mut optional) = (0, 0);
    for (textbook, forms) in &tables {
        let records = with_boundary_components(textbook);
        for whole in [textbook, &records] {
            let reduced = [whole.clone(), whole.without(Part::Prev), whole.without(Part::Faces)];
            for mut table in reduced.into_iter().take(*forms) {
                let some = MESH.sides(4).components(1).borders(1).genus(0).simple();
                for expectation in [everything(MESH), some, MESH.border_kept()].into_iter().take(*forms) {
                    let parts = expectation.looks_at(table.parts);
                    for_each_corruption(&mut table, parts, |changed, _, _| match agree(changed, expectation) {
                        None => met += 1,
                        Some(rule) if rule.is_optional() => optional += 1,
                        Some(_) => {}
                    });
                }
            }
        }
    }
    assert!(met > 0 && optional > 100, "{met} {optional}");
}

/// Every twin or nil, next and origin of three half-edges on three vertices. Each rule is requested alone; both validators
/// find that some tables keep it and others break it.
#[test]
fn both_validators_agree_on_all_small_open_maps() {
    let asked = [
        MESH.no_unused_vertices(),
        MESH.simple(),
        MESH.sides(3),
        MESH.closed(),
        MESH.components(1),
        MESH.borders(1),
        MESH.genus(1),
        MESH.no_unused_vertices().simple().sides(3).components(1).borders(1).genus(0),
    ];
    let mut blank = Table { parts: Parts::NONE, ..Table::default() };
    blank.vertices.resize(3, Some(VertexRow::default()));
    blank.half_edges.resize(3, Some(HalfEdgeRow::default()));
    let cells = blank.cells(Parts::NONE).into_iter().map(|cell| {
        let values = blank.values(cell).into_iter().filter(|value| match value {
            Value::Link(Some(i)) => *i < 3,
            _ => matches!(cell, Cell::Twin(_)),
        });
        (cell, values.collect::<Vec<_>>())
    });
    let cells: Vec<_> = cells.collect();
    let mut found = [[0_u32; 2]; 8];
    for_each_assignment(&mut blank.clone(), &cells, |table| {
        for (expectation, found) in asked.iter().zip(&mut found) {
            match agree_on_first(table, *expectation) {
                None => found[0] += 1,
                Some(rule) if rule.is_optional() => found[1] += 1,
                Some(_) => {}
            }
        }
    });
    // Three half-edges cannot all have a twin, and form no handle.
    let met = [true, true, true, false, true, true, false, true];
    assert_eq!(found.map(|[met, _]| met > 0), met, "{found:?}");
    assert!(found.iter().all(|[_, broken]| *broken > 0), "{found:?}");
}

/// A triangle that breaks every requested rule and R1: rules that need links are not checked and not mentioned.
#[test]
fn what_is_asked_for_is_not_checked_where_links_are_broken() {
    for border in BORDERS {
        let mut table = faces(5, &[[0, 1, 2]], border);
        let expectation =
            MESH.no_unused_vertices().simple().sides(4).closed().components(2).borders(0).genus(1).border_kept();
        assert!(validate(&table, &expectation, Collect::All).broken_rules().count() >= 5);
        half_edge(&mut table, 0).next = Some(99);
        let report = validate(&table, &expectation, Collect::All);
        assert!(report.violations().iter().all(|violation| violation.rule() == Rule::R1), "{report}");
        for rule in OPTIONAL {
            let unchecked = report.outcome(rule).and_then(|outcome| outcome.unchecked);
            assert_eq!(unchecked, Some(Unchecked::Broken(Rule::R1)), "{rule} {report}");
        }
    }
}
