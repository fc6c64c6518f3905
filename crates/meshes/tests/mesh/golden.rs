//! Meshes with counts from the literature, or counted by hand.

use crate::support::shapes::{
    CUBE, OCTAHEDRON, TETRAHEDRON, grid, mesh, moebius_strip, moebius_strip_with_a_seam, seven_vertex_torus,
};
use twinedge::validate::{Collect, Record, Rule, Unchecked, Violation};
use twinedge_meshes::{Finding, HalfEdgeMesh, Kind, MeshAudit, audit};

fn audited<F: AsRef<[u32]>>(points: usize, faces: impl IntoIterator<Item = F>) -> MeshAudit {
    audit(&mesh(points, faces), &HalfEdgeMesh::expectation(), Collect::All)
}

/// V, E, F, components, borders, Euler characteristic, genus.
type Numbers = (usize, usize, usize, usize, Option<usize>, isize, Option<usize>);

fn numbers(audit: &MeshAudit) -> Numbers {
    let c = audit.counts();
    (c.vertices, c.edges, c.faces, c.components, c.borders, c.euler_characteristic, c.genus)
}

#[test]
fn surfaces_have_the_counts_of_the_literature() {
    // The Platonic solids: Euclid, Elements XIII; V − E + F = 2: Euler 1758.
    let found = audited(4, TETRAHEDRON);
    assert!(found.is_valid());
    assert_eq!(numbers(&found), (4, 6, 4, 1, Some(0), 2, Some(0)));
    let found = audited(8, CUBE);
    assert!(found.is_valid());
    assert_eq!(numbers(&found), (8, 12, 6, 1, Some(0), 2, Some(0)));
    let found = audited(6, OCTAHEDRON);
    assert!(found.is_valid());
    assert_eq!(numbers(&found), (6, 12, 8, 1, Some(0), 2, Some(0)));
    // Möbius 1886, Császár 1949: the complete graph of seven vertices on the torus.
    let found = audited(7, seven_vertex_torus());
    assert!(found.is_valid());
    assert_eq!(numbers(&found), (7, 21, 14, 1, Some(0), 0, Some(1)));
}

#[test]
fn grids_keep_the_euler_characteristic_of_their_surface() {
    for (columns, rows) in [(3, 3), (3, 4), (5, 3), (8, 7)] {
        let cells = (columns * rows) as usize;
        // Torus: V = F = E/2, χ = 0.
        let (points, faces) = grid(columns, rows, true, true);
        let found = audited(points, faces);
        assert!(found.is_valid());
        assert_eq!(numbers(&found), (cells, 2 * cells, cells, 1, Some(0), 0, Some(1)));
        // Annulus: χ = 0, two borders.
        let (points, faces) = grid(columns, rows, true, false);
        let found = audited(points, faces);
        assert!(found.is_valid());
        assert_eq!(numbers(&found), (points, points + cells, cells, 1, Some(2), 0, Some(0)));
        assert_eq!(found.counts().border_edges, 2 * columns as usize);
        // Disc: χ = 1, one border.
        let (points, faces) = grid(columns, rows, false, false);
        let found = audited(points, faces);
        assert!(found.is_valid());
        assert_eq!(numbers(&found), (points, points + cells - 1, cells, 1, Some(1), 1, Some(0)));
        assert_eq!(found.counts().border_edges, 2 * (columns + rows) as usize);
    }
}

#[test]
fn components_add_up() {
    let second = seven_vertex_torus().into_iter().map(|face| face.map(|v| v + 4));
    let found = audited(11, TETRAHEDRON.into_iter().chain(second));
    assert!(found.is_valid());
    assert_eq!(numbers(&found), (11, 27, 18, 2, Some(0), 2, Some(1)));
    assert_eq!(found.counts().triangles, 18);
}

#[test]
fn a_moebius_strip_is_refused_as_flipped() {
    // V = 5, E = 10, F = 5, χ = 0.
    let found = audited(5, moebius_strip());
    assert!(!found.is_valid());
    assert_eq!(numbers(&found), (5, 10, 5, 1, None, 0, None));
    assert_eq!(found.findings().count(Kind::FlippedFaces), 5);
    assert_eq!(found.findings().total(), 5);
    assert!(!found.counts().orientable);

    let found = audited(5, moebius_strip_with_a_seam());
    assert!(!found.is_valid());
    let seam = Finding::FlippedFaces { vertices: [0, 1], faces: [0, 4] };
    assert_eq!(found.findings().list(), [seam]);
    assert!(!found.counts().orientable);
}

#[test]
fn a_flipped_face_is_flipped_and_can_be_turned_back() {
    let mut faces = CUBE;
    faces[3].reverse();
    let found = audited(8, faces);
    assert!(!found.is_valid());
    assert_eq!(found.findings().count(Kind::FlippedFaces), 4);
    assert_eq!(found.findings().total(), 4);
    assert!(found.findings().list().iter().all(|finding| finding.faces().contains(&3)));
    assert!(found.counts().orientable);
}

#[test]
fn two_tetrahedra_at_a_vertex_are_two_fans() {
    let second = TETRAHEDRON.map(|face| face.map(|v| if v == 0 { 0 } else { v + 3 }));
    let found = audited(7, TETRAHEDRON.into_iter().chain(second));
    assert!(!found.is_valid());
    assert_eq!(found.findings().list(), [Finding::NonManifoldVertex { vertex: 0, faces: vec![0, 4] }]);
    // Two spheres with a common point: χ = 2 + 2 − 1.
    assert_eq!(numbers(&found), (7, 12, 8, 1, Some(0), 3, None));
    assert!(found.report().outcome(Rule::V2).is_some_and(|outcome| outcome.violations == 1));
}

#[test]
fn three_triangles_at_an_edge_are_named() {
    let found = audited(5, [[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
    assert!(!found.is_valid());
    assert_eq!(found.findings().list(), [Finding::NonManifoldEdge { vertices: [0, 1], faces: vec![0, 1, 2] }]);
    assert_eq!(numbers(&found), (5, 7, 3, 1, None, 1, None));
    assert!(found.counts().orientable);
}

#[test]
fn faces_that_cannot_bound_anything_are_left_out_and_the_rest_is_joined() {
    let extra: [&[u32]; 7] = [&[], &[2], &[1, 2], &[3, 3, 3], &[0, 1, 0], &[0, 1, 2, 0], &[3, 2, 1]];
    let faces = TETRAHEDRON.iter().map(|face| &face[..]).chain(extra);
    let found = audited(4, faces);
    assert!(!found.is_valid());
    assert_eq!(
        found.findings().list(),
        [
            Finding::DegenerateFace { face: 4, vertices: vec![] },
            Finding::DegenerateFace { face: 5, vertices: vec![2] },
            Finding::DegenerateFace { face: 6, vertices: vec![1, 2] },
            Finding::DegenerateFace { face: 7, vertices: vec![3] },
            Finding::DegenerateFace { face: 8, vertices: vec![0, 1] },
            Finding::RepeatedVertex { face: 9, vertex: 0 },
            Finding::RepeatedFace { face: 10, first: 2, reversed: true, vertices: vec![3, 2, 1] },
        ]
    );
    // The rest is the tetrahedron.
    assert_eq!(numbers(&found), (4, 6, 11, 1, Some(0), 2, Some(0)));
    assert_eq!(found.counts().left_out_faces, 7);
    assert!(found.report().is_valid());
}

#[test]
fn repeats_are_found_among_many_faces_at_one_vertex() {
    // More faces than are compared in pairs.
    let mut faces: Vec<[u32; 3]> = (1..30).map(|i| [0, i, i + 1]).collect();
    faces.push([20, 21, 0]);
    faces.push([5, 4, 0]);
    let found = audited(31, faces);
    assert_eq!(
        found.findings().list(),
        [
            Finding::RepeatedFace { face: 29, first: 19, reversed: false, vertices: vec![20, 21, 0] },
            Finding::RepeatedFace { face: 30, first: 3, reversed: true, vertices: vec![5, 4, 0] },
        ]
    );
}

#[test]
fn unused_vertices_are_told_and_are_no_fault_unless_expected() {
    let tetrahedron = mesh(6, TETRAHEDRON);
    let found = audit(&tetrahedron, &HalfEdgeMesh::expectation(), Collect::All);
    assert!(found.is_valid());
    assert_eq!(found.findings().list(), [Finding::UnusedVertex { vertex: 4 }, Finding::UnusedVertex { vertex: 5 }]);
    assert_eq!(numbers(&found), (6, 6, 4, 1, Some(0), 2, Some(0)));
    let found = audit(&tetrahedron, &HalfEdgeMesh::expectation().no_unused_vertices(), Collect::All);
    assert!(!found.is_valid());
    assert_eq!(found.report().violations(), [4, 5].map(|vertex| Violation::UnusedVertex { vertex }));
}

#[test]
fn points_without_faces_are_no_mesh() {
    for points in [0, 3] {
        let found = audited(points, [] as [[u32; 3]; 0]);
        assert!(!found.is_valid(), "{found}");
        assert_eq!(found.findings().list()[0], Finding::NoFaces);
        assert_eq!(numbers(&found), (points, 0, 0, 0, Some(0), 0, Some(0)));
    }
}

#[test]
fn each_expectation_is_met_by_the_right_number_only() {
    let none = HalfEdgeMesh::expectation();
    let (points, faces) = grid(4, 2, true, false);
    let annulus = mesh(points, faces);
    let violations = |expectation| audit(&annulus, &expectation, Collect::All).report().violations().to_vec();
    assert_eq!(violations(none), []);
    let good = none.borders(2).genus(0).components(1).sides(4).no_unused_vertices().simple();
    assert_eq!(violations(good), []);
    let at_border = violations(none.closed());
    assert!(at_border.iter().all(|violation| violation.rule() == Rule::M4));
    assert_eq!(at_border.len(), 8);
    assert_eq!(violations(none.borders(1)), [Violation::WrongBorders { found: 2, expected: 1 }]);
    assert_eq!(violations(none.genus(1)), [Violation::WrongGenus { found: 0, expected: 1 }]);
    assert_eq!(violations(none.components(2)), [Violation::WrongComponents { found: 1, expected: 2 }]);
    assert_eq!(violations(none.components(0)), [Violation::WrongComponents { found: 1, expected: 0 }]);
    let sides = |expected| (0..8).map(move |f| Violation::WrongSides { record: Record::Face(f), sides: 4, expected });
    assert_eq!(violations(none.triangles()), sides(3).collect::<Vec<_>>());
    assert_eq!(violations(none.sides(5)), sides(5).collect::<Vec<_>>());
}

/// An unused vertex is a component of the map, but does not count for expectations.
#[test]
fn unused_vertices_are_no_components() {
    let found = audit(&mesh(6, TETRAHEDRON), &HalfEdgeMesh::expectation().components(1).closed(), Collect::All);
    assert!(found.is_valid(), "{found}");
    assert_eq!((found.counts().components, found.report().counts().components), (1, Some(3)));
}

#[test]
fn what_is_not_known_is_not_checked() {
    let strip = mesh(5, moebius_strip());
    let expectation = HalfEdgeMesh::expectation().borders(1).genus(0).components(1).triangles();
    let found = audit(&strip, &expectation, Collect::All);
    assert!(!found.is_valid());
    let unchecked = |rule| found.report().outcome(rule).expect("asked for").unchecked;
    for rule in [Rule::M5, Rule::M6, Rule::M7] {
        assert_eq!(unchecked(rule), Some(Unchecked::Broken(Rule::V2)), "{rule}");
    }
    assert_eq!(unchecked(Rule::M3), None);
}

#[test]
fn faces_that_are_left_out_need_not_have_the_expected_sides() {
    let faces = TETRAHEDRON.iter().map(|face| &face[..]).chain([&[0, 1][..]]);
    let found = audit(&mesh(4, faces), &HalfEdgeMesh::expectation().triangles(), Collect::All);
    assert!(found.report().is_valid());
    assert!(!found.is_valid());
}

#[test]
fn faces_that_are_left_out_are_vacant_slots() {
    use twinedge::validate::View;
    let mesh = mesh(4, [[0, 1, 2], [3, 3, 3]]);
    let (half_edges, _) = HalfEdgeMesh::link(&mesh, Collect::All);
    assert_eq!((half_edges.face_slots(), half_edges.half_edge_slots()), (2, 6));
    assert!(half_edges.is_face(0) && half_edges.is_half_edge(2) && !half_edges.is_left_out(0));
    assert!(!half_edges.is_face(1) && !half_edges.is_half_edge(3) && half_edges.is_left_out(1));
    assert!(!half_edges.is_face(2) && !half_edges.is_half_edge(6));
    assert_eq!((half_edges.outer_half_edge(0), half_edges.outer_half_edge(1)), (Some(0), None));
    assert_eq!((half_edges.next(2), half_edges.prev(0), half_edges.face(2)), (Some(0), Some(2), Some(0)));
    assert_eq!((half_edges.next(3), half_edges.prev(3), half_edges.face(3)), (None, None, None));
    assert_eq!((half_edges.leaving(2), half_edges.leaving(3)), (Some(2), None));
}

#[test]
fn all_findings_are_counted_and_as_many_kept_as_asked() {
    let faces: Vec<Vec<u32>> = (0..40).map(|i| vec![i, i]).collect();
    let soup = mesh(50, faces);
    let kept = |collect| {
        let found = audit(&soup, &HalfEdgeMesh::expectation(), collect);
        assert_eq!(found.findings().count(Kind::DegenerateFace), 40);
        assert_eq!(found.findings().count(Kind::UnusedVertex), 50);
        found.findings().list().len()
    };
    assert_eq!(kept(Collect::AtMost(0)), 0);
    assert_eq!(kept(Collect::First), 2);
    assert_eq!(kept(Collect::AtMost(7)), 14);
    assert_eq!(kept(Collect::All), 90);
}
