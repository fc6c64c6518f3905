//! The number of questions that the validator asks: for a valid structure with all parts, only the questions of the fast
//! path. These bounds on work do not depend on a clock.

use crate::support::erased::validate;
use crate::support::nested::{PLANE, nested, nested_textbook};
use crate::support::opinions::{agree, broken};
use crate::support::renumbered::renumbered;
use crate::support::tables::{Without, half_edge, k7, map, mesh};
use crate::support::watched::Watched;
use twinedge::validate::{Collect, Expectation, Part, Rule, Start, Table, Violation};

/// Returns the numbers of questions about the twin, next and prev of half-edges of a valid table.
fn questions(table: &Table, expectation: Expectation) -> [usize; 3] {
    let view = Watched::new(table);
    let report = validate(&view, &expectation, Collect::All);
    assert!(report.is_valid(), "{report}");
    assert_eq!(report.to_string(), validate(table, &expectation, Collect::All).to_string());
    [view.twin.get(), view.next.get(), view.prev.get()]
}

/// Moves the second half of the vertices, edges, boundary components and faces, with all links to them, up by one slot,
/// which is vacant.
fn with_vacant_slots(table: &Table) -> Table {
    let counts = [table.vertices.len(), table.half_edges.len(), table.boundaries.len(), table.faces.len()];
    let slots = |count: usize| (0..count).map(|i| i + usize::from(i >= count / 2)).chain([count / 2]).collect();
    renumbered(table, &counts.map(slots))
}

/// In a valid map, the validator asks for each twin twice, as a step and as the answer to it, and for each next and each
/// prev once.
#[test]
fn a_valid_map_is_walked_around_once() {
    use Start::{HalfEdge, Vertex};
    let triangle = [(0, 2), (1, 5), (1, 4), (2, 1), (2, 0), (0, 3)];
    let mut two_triangles = triangle.to_vec();
    two_triangles.extend(triangle.map(|(origin, next)| (origin + 3, next + 6)));
    let all: [(&str, Table); 11] = [
        ("the empty map", map(0, &[], &[(None, &[])])),
        ("an isolated vertex", map(1, &[], &[(None, &[Vertex(0)])])),
        ("an edge", map(2, &[(0, 1), (1, 0)], &[(None, &[HalfEdge(0)])])),
        ("a loop", map(1, &[(0, 0), (0, 1)], &[(None, &[HalfEdge(0)]), (Some(1), &[])])),
        ("a triangle", map(3, &triangle, &[(None, &[HalfEdge(1)]), (Some(0), &[])])),
        (
            "a triangle, and isolated vertices on both sides",
            map(5, &triangle, &[(None, &[HalfEdge(1), Vertex(4)]), (Some(0), &[Vertex(3)])]),
        ),
        (
            "two triangles side by side",
            map(6, &two_triangles, &[(None, &[HalfEdge(1), HalfEdge(7)]), (Some(0), &[]), (Some(6), &[])]),
        ),
        (
            "a triangle in the hole of another",
            map(6, &two_triangles, &[(None, &[HalfEdge(1)]), (Some(0), &[HalfEdge(7)]), (Some(6), &[])]),
        ),
        (
            "three edges and three isolated vertices",
            map(
                9,
                &[(0, 1), (1, 0), (3, 3), (4, 2), (6, 5), (7, 4)],
                &[(None, &[HalfEdge(0), Vertex(2), HalfEdge(2), Vertex(5), HalfEdge(4), Vertex(8)])],
            ),
        ),
        ("two parallel edges", map(2, &[(0, 3), (1, 2), (0, 1), (1, 0)], &[(None, &[HalfEdge(1)]), (Some(0), &[])])),
        (
            "two loops at a vertex",
            map(1, &[(0, 0), (0, 3), (0, 2), (0, 1)], &[(None, &[HalfEdge(1)]), (Some(0), &[]), (Some(2), &[])]),
        ),
    ];
    for (name, table) in all {
        for table in [with_vacant_slots(&table), table] {
            let n = table.half_edges.iter().flatten().count();
            assert_eq!(questions(&table, PLANE), [2 * n, n, n], "{name}");
        }
    }
}

/// On a torus the cycles are also counted: each triangle by three questions from each half-edge.
#[test]
fn a_valid_surface_is_walked_around_once() {
    let tetrahedron = mesh(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]);
    for (table, nexts) in [(&tetrahedron, 1), (&k7(), 4), (&with_vacant_slots(&k7()), 4)] {
        let n = table.half_edges.iter().flatten().count();
        assert_eq!(questions(table, Expectation::surface()), [2 * n, nexts * n, n]);
    }
}

/// A missing part does not increase other questions, and vacant slots make no difference.
#[test]
fn what_lacks_parts_is_not_asked_more_often() {
    let edge = map(2, &[(0, 1), (1, 0)], &[(None, &[Start::HalfEdge(0)])]);
    for table in [edge, nested()] {
        let vacant = with_vacant_slots(&table);
        let n = table.half_edges.len();
        for part in [Part::Prev, Part::Leaving, Part::Places] {
            let (table, vacant) = (table.without(part), vacant.without(part));
            let prev = if part == Part::Prev { 0 } else { n };
            assert_eq!(questions(&table, PLANE), [2 * n, n, prev], "{part:?}");
            assert_eq!(questions(&vacant, PLANE), [2 * n, n, prev], "{part:?}");
            let counts = |table: &Table| *validate(table, &PLANE, Collect::All).counts();
            assert_eq!(counts(&vacant), counts(&table));
        }
    }
}

/// No list is read much beyond twice the number of records, whatever its face claims.
#[test]
fn a_list_that_never_ends_is_cut_short() {
    let table = map(1, &[(0, 0), (0, 1)], &[(None, &[Start::HalfEdge(1)]), (Some(0), &[])]);
    let table = table.without(Part::Prev).without(Part::Leaving).without(Part::Places);
    let view = Watched::claiming(&table, |_| Some(usize::MAX));
    let report = validate(&view, &PLANE, Collect::All);
    assert!(report.violations().contains(&Violation::ListTooLong { face: 0, claimed: usize::MAX }));
    assert_eq!(broken(&report), [Rule::R1, Rule::F2]);
    // Two records: 2 · 2 + 16 entries, once for R1 and once for F2.
    assert_eq!(view.inner.get(), 2 * 20);
}

/// Each rule that reads the lists keeps this bound, even if a list grows after another rule has read it.
#[test]
fn a_list_that_grows_is_cut_short() {
    for (table, records) in [(nested().without(Part::Places), 5), (nested_textbook(), 12 + 7)] {
        let honest = Watched::new(&table);
        assert!(validate(&honest, &PLANE, Collect::All).is_valid());
        for honest_answers in 0..=honest.inner_count.get() {
            let view = Watched::claiming(&table, |asked| (asked > honest_answers).then_some(usize::MAX));
            let _ = validate(&view, &PLANE, Collect::All);
            // The fast path, R1, B (without records for boundary components), F2 and T1 read the lists.
            let most = records + 4 * (2 * records + 16);
            assert!(view.inner.get() <= most, "{honest_answers}: {}", view.inner.get());
        }
    }
}

/// Half-edges that each leave their own vertex, although turning around any of these meets them all.
fn one_rotation(half_edges: usize) -> Table {
    let starts: Vec<(usize, usize)> = (0..half_edges).map(|h| (h, ((h ^ 1) + 1) % half_edges)).collect();
    map(half_edges, &starts, &[(None, &[Start::HalfEdge(0)])])
}

#[test]
fn one_rotation_is_not_walked_around_from_every_vertex() {
    let table = one_rotation(200);
    let view = Watched::new(&table);
    let report = validate(&view, &PLANE, Collect::All);
    assert!(!report.is_valid());
    assert!(view.twin.get() + view.next.get() <= 20 * 200, "{} + {}", view.twin.get(), view.next.get());
}

/// Vertices 0 and 1 claim the same rotation of two half-edges, out of three.
#[test]
fn a_rotation_that_two_vertices_claim_leaves_room_for_no_third() {
    let mut table = map(3, &[(0, 0), (1, 1), (2, 2)], &[(None, &[Start::HalfEdge(0)])]);
    half_edge(&mut table, 2).twin = Some(2);
    // Two half-edges also lack a boundary component.
    assert_eq!(agree(&table, PLANE), Some(Rule::R1));
}
