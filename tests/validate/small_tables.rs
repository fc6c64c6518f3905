//! All small tables: every assignment of the named cells, valid or not. Both validators judge each alike, and the
//! number of valid ones is the number of labelled maps.

use crate::support::erased::validate;
use crate::support::nested::PLANE;
use crate::support::opinions::{agree, agree_on_first};
use crate::support::tables::{TEXTBOOK, Without, map, textbook_map};
use twinedge::validate::{
    BoundaryPlace, BoundaryRow, Collect, Expectation, FaceRow, HalfEdgeRow, Part, Parts, Rule, Start, Table, VertexRow,
};
use twinedge_trials::enumerate::{Cell, TableCells, Value, for_each_assignment};

/// The values that a cell takes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum To {
    /// The live records.
    Live,
    /// The live records and nil.
    OrNil,
    /// The live records and the slot past the end.
    OrPastTheEnd,
}

fn choices(table: &Table, cell: Cell, to: To) -> (Cell, Vec<Value>) {
    let values = table.values(cell);
    // Nil, the slots, one past the end and the largest number.
    let slots = values.len() - 3;
    let wanted = |value: &Value| match *value {
        Value::Link(None) | Value::Start(None) | Value::BoundaryPlace(None) => to >= To::OrNil,
        Value::Link(Some(i)) => i < slots || i == slots && to == To::OrPastTheEnd,
        Value::Start(Some(Start::HalfEdge(h))) => h < table.half_edges.len(),
        Value::Start(Some(Start::Vertex(v))) => v < table.vertices.len(),
        Value::BoundaryPlace(Some(BoundaryPlace::Outer)) => true,
        Value::BoundaryPlace(Some(BoundaryPlace::Inner(i))) => i < usize::MAX,
    };
    (cell, values.into_iter().filter(wanted).collect())
}

/// A table of this size, all nil, with list lengths for the faces.
fn blank(vertices: usize, half_edges: usize, boundaries: usize, lists: &[usize]) -> Table {
    let face = |listed: &usize| FaceRow {
        inner: if boundaries > 0 { vec![None; *listed] } else { vec![] },
        inner_starts: if boundaries > 0 { vec![] } else { vec![None; *listed] },
        ..FaceRow::default()
    };
    Table {
        parts: if boundaries > 0 { Parts::ALL } else { TEXTBOOK },
        vertices: vec![Some(VertexRow::default()); vertices],
        half_edges: vec![Some(HalfEdgeRow::default()); half_edges],
        boundaries: vec![Some(BoundaryRow::default()); boundaries],
        faces: lists.iter().map(|listed| Some(face(listed))).collect(),
    }
}

/// A blank table without faces.
fn bare(vertices: usize, half_edges: usize) -> Table {
    blank(vertices, half_edges, 0, &[]).without(Part::Faces)
}

/// Sets all relevant, selected cells to every value; returns the numbers of tables and of valid ones.
fn judge_all(
    mut table: Table,
    expectation: Expectation,
    wanted: impl Fn(&Cell) -> bool,
    to: impl Fn(&Cell) -> To,
) -> (u64, u64) {
    let cells = table.cells(expectation.looks_at(table.parts)).into_iter().filter(wanted);
    let choices: Vec<_> = cells.map(|cell| choices(&table, cell, to(&cell))).collect();
    let mut right = 0;
    let all = for_each_assignment(&mut table, &choices, |table| {
        right += u64::from(agree_on_first(table, expectation).is_none());
    });
    (all, right)
}

fn factorial(n: u64) -> u64 {
    (1..=n).product()
}

fn binomial(n: u64, k: u64) -> u64 {
    if k > n { 0 } else { factorial(n) / factorial(k) / factorial(n - k) }
}

/// The permutations of n things with k orbits: unsigned Stirling numbers of the first kind.
fn permutations_with_orbits(n: u64, k: u64) -> u64 {
    match (n, k) {
        (0, 0) => 1,
        (0, _) | (_, 0) => 0,
        _ => permutations_with_orbits(n - 1, k - 1) + (n - 1) * permutations_with_orbits(n - 1, k),
    }
}

/// The number of ways to pair off 2n half-edges as twins: (2n − 1)!!.
fn count_pairings(edges: u64) -> u64 {
    (1..=edges).map(|i| 2 * i - 1).product()
}

/// The maps of n edges on labelled half-edges: k of m vertices label the rotations, the orbits of any permutation
/// `next∘twin`. The other vertices are isolated.
fn labelled_maps(edges: u64, vertices: u64) -> u64 {
    let labelled = |k| factorial(k) * binomial(vertices, k) * permutations_with_orbits(2 * edges, k);
    count_pairings(edges) * (0..=vertices).map(labelled).sum::<u64>()
}

/// The labelled maps with a half-edge chosen from each rotation, for `leaving`: k orbits of n things in a row, each
/// with a first thing, correspond to the things in a row with k − 1 separators.
fn labelled_maps_with_leaving(edges: u64, vertices: u64) -> u64 {
    let labelled = |k| binomial(vertices, k) * factorial(2 * edges) * binomial(2 * edges - 1, k - 1);
    count_pairings(edges) * (1..=vertices).map(labelled).sum::<u64>()
}

const SURFACE: Expectation = Expectation::surface();

/// Every link between two half-edges and two vertices, including nil and dangling ones.
#[test]
fn two_half_edges_and_two_vertices() {
    assert_eq!((labelled_maps_with_leaving(1, 2), labelled_maps(1, 2)), (2 * 2 + 2, 2 + 2));
    let dangling = |_: &Cell| To::OrPastTheEnd;
    let found = judge_all(bare(2, 2), SURFACE, |_| true, dangling);
    assert_eq!(found, (4_u64.pow(10), labelled_maps_with_leaving(1, 2)));
    let found = judge_all(bare(2, 2).without(Part::Leaving), SURFACE, |_| true, dangling);
    assert_eq!(found, (4_u64.pow(8), labelled_maps(1, 2)));
}

/// Every twin, next and origin of four half-edges on two vertices.
#[test]
fn four_half_edges_and_two_vertices() {
    assert_eq!(labelled_maps(2, 2), 3 * (2 * 6 + 2 * 11));
    let table = Table { parts: Parts::NONE, ..bare(2, 4) };
    let found = judge_all(table, SURFACE, |_| true, |_| To::Live);
    assert_eq!(found, (4_u64.pow(8) * 2_u64.pow(4), labelled_maps(2, 2)));
}

/// Sets these cells to every value, derives the origins, and counts the tables valid on any surface and in the plane.
fn judge_with_origins(mut table: Table, expectation: Expectation, cells: &[(Cell, Vec<Value>)]) -> (u64, u64, u64) {
    let plane = if expectation.is_open() { PLANE.open() } else { PLANE };
    let (mut right, mut planar) = (0, 0);
    let all = for_each_assignment(&mut table, cells, |table| {
        let mut table = table.clone();
        table.derive_origins();
        right += u64::from(agree_on_first(&table, expectation).is_none());
        planar += u64::from(agree_on_first(&table, plane).is_none());
    });
    (all, right, planar)
}

/// Rooted maps with n edges on a surface have no symmetry, so each can be labelled in (2n − 1)! ways, with its root
/// first. There are 2, 9, 54 of them in the plane (Tutte; A000168) and 0, 1, 20 on the torus (A006300) for n = 1, 2, 3.
const fn connected(rooted: u64, edges: u64) -> u64 {
    let mut labelled = rooted;
    let mut i = 2 * edges - 1;
    while i > 1 {
        labelled *= i;
        i -= 1;
    }
    labelled
}

/// Every twin and next of four half-edges: in the plane a connected map of two edges, or two maps of one.
#[test]
fn the_maps_of_two_edges_are_those_of_the_plane_and_of_the_torus() {
    let table = Table { parts: Parts::NONE, ..bare(0, 4) };
    let is_twin_or_next = |cell: &Cell| matches!(cell, Cell::Twin(_) | Cell::Next(_));
    let cells: Vec<_> = table.cells(table.parts).into_iter().filter(is_twin_or_next).collect();
    let cells: Vec<_> = cells.into_iter().map(|cell| choices(&table, cell, To::Live)).collect();
    let planar = connected(9, 2) + 3 * connected(2, 1) * connected(2, 1);
    let right = count_pairings(2) * factorial(4);
    assert_eq!(right, planar + connected(1, 2));
    assert_eq!(judge_with_origins(table, SURFACE, &cells), (4_u64.pow(8), right, planar));
}

/// This number of half-edges, with 2i and 2i + 1 as twins.
fn paired(half_edges: usize) -> Table {
    let mut table = Table { parts: Parts::NONE, ..bare(0, half_edges) };
    for h in 0..half_edges {
        table.set(Cell::Twin(h), Value::Link(Some(h ^ 1)));
    }
    table
}

/// Every next of six half-edges with fixed twins, one of fifteen ways to pair them.
#[test]
fn the_maps_of_three_edges_are_those_of_the_plane_and_of_the_torus() {
    let table = paired(6);
    let cells: Vec<_> = (0..6).map(|h| choices(&table, Cell::Next(h), To::Live)).collect();
    let one = connected(2, 1);
    let planar = connected(54, 3) + 15 * one * connected(9, 2) + 15 * one * one * one;
    let torus = connected(20, 3) + 15 * one * connected(1, 2);
    assert_eq!(count_pairings(3) * factorial(6), planar + torus);
    assert_eq!(judge_with_origins(table, SURFACE, &cells), (6_u64.pow(6), factorial(6), planar / 15));
}

/// Every next and prev of four half-edges with fixed twins: each permutation has one inverse.
#[test]
fn each_next_has_one_prev() {
    let table = Table { parts: Parts::NONE.with(Part::Prev), ..paired(4) };
    let cells: Vec<_> = (0..4).flat_map(|h| [Cell::Next(h), Cell::Prev(h)]).collect();
    let cells: Vec<_> = cells.into_iter().map(|cell| choices(&table, cell, To::Live)).collect();
    let planar = (connected(9, 2) + 3 * connected(2, 1) * connected(2, 1)) / 3;
    assert_eq!(judge_with_origins(table, SURFACE, &cells), (4_u64.pow(8), factorial(4), planar));
}

/// Every twin, or none, and next of four half-edges: 0, 1 or 2 pairs of twins. Closing each border by a cycle always
/// yields a surface.
#[test]
fn open_maps_of_four_half_edges() {
    let table = Table { parts: Parts::NONE, ..bare(0, 4) };
    let twins = (0..4).map(|h| choices(&table, Cell::Twin(h), To::OrNil));
    let cells: Vec<_> = twins.chain((0..4).map(|h| choices(&table, Cell::Next(h), To::Live))).collect();
    let (all, right, planar) = judge_with_origins(table, SURFACE.open(), &cells);
    assert_eq!((all, right), (5_u64.pow(4) * 4_u64.pow(4), (1 + 6 + 3) * factorial(4)));
    // Two pairs of twins cross in six maps of the torus; fewer twins form no handle.
    assert_eq!(planar, right - connected(1, 2));
}

/// Visits every map of two edges, with the twins 0 and 1, 2 and 3.
fn each_map_of_two_edges(mut visit: impl FnMut(&Table, usize)) {
    let mut table = paired(4);
    let cells: Vec<_> = (0..4).map(|h| choices(&table, Cell::Next(h), To::Live)).collect();
    for_each_assignment(&mut table, &cells, |table| {
        let mut table = table.clone();
        table.derive_origins();
        if agree(&table, SURFACE).is_none() {
            visit(&table, validate(&table, &SURFACE, Collect::All).counts().cycles.unwrap());
        }
    });
}

/// Every face of each half-edge and half-edge of each face, for each map of two edges: faces correspond to cycles, in
/// any order, and each face stores any half-edge of its cycle.
#[test]
fn the_faces_of_a_mesh() {
    let parts = Parts::NONE.with(Part::Faces);
    let is_about_faces = |cell: &Cell| matches!(cell, Cell::Face(_) | Cell::OuterHalfEdge(_));
    let (mut right, mut open) = (0, 0);
    each_map_of_two_edges(|map, cycles| {
        let faces = vec![0; cycles];
        let table = Table { parts, faces: blank(0, 0, 0, &faces).faces, ..map.clone() };
        right += judge_all(table, SURFACE, is_about_faces, |_| To::Live).1;
        let table = Table { parts, faces: blank(0, 0, 0, &[0]).faces, ..map.clone() };
        open += judge_all(table, SURFACE.open(), is_about_faces, |_| To::OrNil).1;
    });
    // The cycles in a row, each with a first half-edge, as above.
    assert_eq!(right, (1..=4).map(|c| factorial(4) * binomial(3, c - 1)).sum::<u64>());
    // One face, stored with any half-edge of any map; all other half-edges bound nothing.
    assert_eq!(open, factorial(4) * 4);
}

/// One edge between two vertices in one face, every cell nil or live: the vertices can be swapped and the start chosen.
#[test]
fn an_edge_in_the_form_of_the_textbook() {
    let half_edges = 3_u64.pow(8) * 2_u64.pow(2);
    let nil = |_: &Cell| To::OrNil;
    let judge = |listed| judge_all(blank(2, 2, 0, &[listed]).without(Part::Leaving), PLANE, |_| true, nil);
    assert_eq!(judge(1), (half_edges * 3 * 5, 2 * 2));
    assert_eq!(judge(0), (half_edges * 3, 0));
}

/// A loop and two faces: either half-edge may be outside, and either face, unless only one has room for it.
#[test]
fn a_loop_in_the_form_of_the_textbook() {
    let tables = 2_u64.pow(2) * 3_u64.pow(4) * 3_u64.pow(2) * 3_u64.pow(2);
    for (lists, right) in [([0, 0], 0), ([1, 0], 2), ([0, 1], 2), ([1, 1], 0)] {
        let table = blank(1, 2, 0, &lists).without(Part::Leaving).without(Part::Prev);
        let found = judge_all(table, PLANE, |_| true, |_| To::OrNil);
        assert_eq!(found, (tables * 4_u64.pow((lists[0] + lists[1]) as u32), right));
    }
}

/// A loop with two boundary components and two faces: either half-edge may be outside, with either face and either
/// component.
#[test]
fn a_loop_with_boundary_components() {
    let loop_alone = map(1, &[(0, 0), (0, 1)], &[]);
    let of_the_map = |cell: &Cell| {
        matches!(cell, Cell::Origin(_) | Cell::Twin(_) | Cell::Next(_) | Cell::Prev(_) | Cell::Leaving(_))
    };
    let never_nil = |cell: &Cell| matches!(cell, Cell::Boundary(_) | Cell::BoundaryFace(_) | Cell::BoundaryStart(_));
    for (lists, places, right) in [([0, 0], 3, 0), ([1, 0], 4, 4), ([0, 1], 4, 4), ([1, 1], 4, 0)] {
        let Table { boundaries, faces, .. } = blank(0, 0, 2, &lists);
        let table = Table { boundaries, faces, ..loop_alone.clone() };
        let to = |cell: &Cell| if never_nil(cell) { To::Live } else { To::OrNil };
        let found = judge_all(table, PLANE, |cell| !of_the_map(cell), to);
        let boundary: u64 = 2 * 3 * places;
        let listed = (lists[0] + lists[1]) as u32;
        assert_eq!(found, (2_u64.pow(2) * 3 * boundary.pow(2) * 3_u64.pow(2 + listed), right));
    }
}

/// Two isolated vertices in one face: boundary components and vertices correspond in any way, listed in any order.
#[test]
fn two_isolated_vertices() {
    for (listed, right) in [(0, 0), (1, 0), (2, 2 * 2)] {
        let found = judge_all(blank(2, 0, 2, &[listed]).without(Part::Leaving), PLANE, |_| true, |_| To::OrNil);
        let boundary = 2 * 3 * (3 + listed as u64);
        assert_eq!(found, (3_u64.pow(2) * boundary.pow(2) * 3_u64.pow(1 + listed as u32), right));
    }
}

/// Two loops and three faces, the first of them unbounded. Choices: the outside half-edge of each loop, the face inside
/// each, and nesting: one in the other, or both side by side in any order.
#[test]
fn two_loops_and_how_they_nest() {
    let loops = textbook_map(2, &[(0, 0), (0, 1), (1, 2), (1, 3)], &[]).without(Part::Leaving).without(Part::Prev);
    let is_free = |cell: &Cell| matches!(cell, Cell::Face(_) | Cell::OuterHalfEdge(1 | 2) | Cell::InnerStart(..));
    let mut right = 0;
    for lists in [[2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 1, 0], [1, 0, 1], [0, 1, 1]] {
        let mut table = Table { faces: blank(0, 0, 0, &lists).faces, ..loops.clone() };
        let cells = table.cells(table.parts).into_iter().filter(is_free);
        let half_edges_only = |cell| {
            let is_outer = matches!(cell, Cell::OuterHalfEdge(_));
            let (cell, mut values) = choices(&table, cell, if is_outer { To::OrNil } else { To::Live });
            values.retain(|value| !matches!(value, Value::Start(Some(Start::Vertex(_)))));
            (cell, values)
        };
        let cells: Vec<_> = cells.map(half_edges_only).collect();
        let all = for_each_assignment(&mut table, &cells, |table| {
            right += u64::from(agree_on_first(table, PLANE).is_none());
        });
        assert_eq!(all, 3_u64.pow(4) * 5_u64.pow(2) * 4_u64.pow(2));
    }
    assert_eq!(right, 2 * 2 * factorial(2) * (2 + 1 + 1));
}

/// Loops that each lie in the unbounded face or in another loop, or, incorrectly, in themselves or in a ring of loops.
/// By Cayley's formula (k + 1)^(k − 1) of the (k + 1)^k ways for k loops are trees.
#[test]
fn loops_nest_as_trees() {
    for loops in 1..=5_u32 {
        let k = loops as usize;
        let half_edges: Vec<(usize, usize)> = (0..2 * k).map(|h| (h / 2, h)).collect();
        let mut right = 0;
        for code in 0..(k + 1).pow(loops) {
            let lies_in = |i: usize| code / (k + 1).pow(i as u32) % (k + 1);
            let outside = |i: usize| Start::HalfEdge(2 * i + 1);
            let lists: Vec<Vec<Start>> =
                (0..=k).map(|f| (0..k).filter(|i| lies_in(*i) == f).map(outside).collect()).collect();
            let faces: Vec<(Option<usize>, &[Start])> =
                lists.iter().enumerate().map(|(f, list)| (f.checked_sub(1).map(|i| 2 * i), list.as_slice())).collect();
            let broken = agree_on_first(&map(k, &half_edges, &faces), PLANE);
            assert!(broken.is_none_or(|rule| rule == Rule::T2));
            right += u64::from(broken.is_none());
        }
        assert_eq!(right, (u64::from(loops) + 1).pow(loops - 1));
    }
}

/// Every change of two fields of two nested loops and a vertex. Two changes are harmless: both vertices store the other
/// half-edge that leaves them; and, if boundary components store no places, the two in the unbounded face are listed in
/// the opposite order.
#[test]
fn two_fields_at_once() {
    let (outside, between) = ([Start::HalfEdge(1), Start::Vertex(2)], [Start::HalfEdge(3)]);
    let half_edges = [(0, 0), (0, 1), (1, 2), (1, 3)];
    let faces: [(Option<usize>, &[Start]); 3] = [(None, &outside), (Some(0), &between), (Some(2), &[])];
    let records = map(3, &half_edges, &faces);
    let textbook = textbook_map(3, &half_edges, &faces);
    for (table, expectation, expected) in [
        (&records, PLANE, 1),
        (&records.without(Part::Places), PLANE.open(), 2),
        (&textbook, PLANE, 2),
        (&textbook.without(Part::Prev), PLANE.open(), 2),
    ] {
        let others: Vec<(Cell, Vec<Value>)> = table
            .cells(table.parts)
            .into_iter()
            .map(|cell| {
                let (cell, mut values) = choices(table, cell, To::OrNil);
                let present = table.clone().set(cell, values[0]).unwrap();
                values.retain(|value| *value != present);
                (cell, values)
            })
            .collect();
        let mut harmless = 0;
        for (i, first) in others.iter().enumerate() {
            for second in &others[i + 1..] {
                for_each_assignment(&mut table.clone(), &[first.clone(), second.clone()], |changed| {
                    harmless += u64::from(agree(changed, expectation).is_none());
                });
            }
        }
        assert_eq!(harmless, expected, "{table}\n{expectation:?}");
    }
}
