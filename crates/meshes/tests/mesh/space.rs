//! M9 … M11: the places of the points. Each rule is broken alone, and valid meshes break none.

use crate::support::shapes::{CUBE, OCTAHEDRON, TETRAHEDRON};
use quickcheck::quickcheck;
use twinedge::validate::Collect;
use twinedge_meshes::{Finding, HalfEdgeMesh, IndexedMesh, Kind, MeshAudit, SpaceRule, audit_in_space};

fn audited<F: AsRef<[u32]>>(points: &[[f64; 3]], faces: impl IntoIterator<Item = F>) -> MeshAudit {
    let mesh = IndexedMesh::from_faces(points.to_vec(), faces).unwrap();
    audit_in_space(&mesh, &HalfEdgeMesh::expectation(), &SpaceRule::ALL, Collect::All)
}

/// Returns the findings, which must all belong to M9 … M11.
fn found<F: AsRef<[u32]>>(points: &[[f64; 3]], faces: impl IntoIterator<Item = F>) -> Vec<Finding> {
    let audit = audited(points, faces);
    assert!(audit.report().is_valid(), "{audit}");
    let of_space: Vec<Finding> =
        audit.findings().list().iter().filter(|one| one.kind().rule().is_some()).cloned().collect();
    assert_eq!(audit.is_valid(), of_space.is_empty() && audit.rules().iter().all(|rule| rule.left_out.is_none()));
    of_space
}

const AT_TETRAHEDRON: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Tetrahedra with a right angle at these places, of these sizes, oriented outwards or inwards.
fn tetrahedra(all: &[([f64; 3], f64, bool)]) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for (at, size, is_outward) in all {
        let first = points.len() as u32;
        points.extend(AT_TETRAHEDRON.map(|p| [0, 1, 2].map(|i| at[i] + size * p[i])));
        let outward = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|face| face.map(|corner| corner + first));
        faces.extend(outward.map(|[a, b, c]| if *is_outward { [a, b, c] } else { [a, c, b] }));
    }
    (points, faces)
}

fn kinds(all: &[([f64; 3], f64, bool)]) -> Vec<Finding> {
    let (points, faces) = tetrahedra(all);
    found(&points, faces)
}

#[test]
fn solids_of_the_literature_break_nothing() {
    assert_eq!(kinds(&[([0.0; 3], 1.0, true)]), []);
    let cube: Vec<[f64; 3]> = (0..8).map(|i| [f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)]).collect();
    let audit =
        audited(&cube, [[0_u32, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]);
    assert!(audit.is_valid(), "{audit}");
    let ids: Vec<(&str, u64)> = audit.rules().iter().rev().take(3).map(|rule| (rule.id, rule.checked)).collect();
    assert_eq!(ids, [("M11", 1), ("M10", 6), ("M9", 6)]);
    assert_eq!((TETRAHEDRON.len(), CUBE.len(), OCTAHEDRON.len()), (4, 6, 8));
    // The report only has requested rules.
    let mesh = IndexedMesh::from_faces(cube, CUBE).unwrap();
    let plain = audit_in_space(&mesh, &HalfEdgeMesh::expectation(), &[SpaceRule::Area, SpaceRule::Area], Collect::All);
    assert_eq!(plain.rules().iter().filter(|rule| ["M9", "M10", "M11"].contains(&rule.id)).count(), 1);
}

#[test]
fn a_face_on_a_line_breaks_m9_alone() {
    // Two triangles, and a third one without area: its third corner is the middle of its longest side, which is a border.
    let points = [[0.0, 0.0, 0.0], [2.0, 2.0, 2.0], [1.0, 1.0, 1.0], [0.0, 0.0, 3.0]];
    let faces = [[0, 1, 2], [0, 2, 3], [2, 1, 3]];
    assert_eq!(found(&points, faces), [Finding::ZeroArea { face: 0 }]);
    // Moving a corner by one unit in the last place gives it an area.
    let mut beside = points;
    beside[2][0] = 1.0_f64.next_up();
    assert_eq!(found(&beside, [[0, 1, 2]]), []);
    assert_eq!(found(&points, [[0, 1, 2]]), [Finding::ZeroArea { face: 0 }]);
    // The corners are distinct points at one place.
    let same = [[0.0, -0.0, 0.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
    assert_eq!(found(&same, [[0, 1, 2]]), [Finding::ZeroArea { face: 0 }]);
    let square = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0]];
    assert_eq!(found(&square, [[0, 1, 2, 3]]), []);
}

#[test]
fn faces_that_cross_break_m10_alone() {
    // Two faces that share only a corner also break V2.
    let crossing = |points: &[[f64; 3]], faces: &[[u32; 3]]| {
        let audit = audited(points, faces);
        let of_space: Vec<&Finding> =
            audit.findings().list().iter().filter(|one| one.kind().rule().is_some()).collect();
        assert!(of_space.iter().all(|one| **one == Finding::CrossingFaces { faces: [0, 1] }), "{audit}");
        !of_space.is_empty()
    };
    let flat = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let with = |others: [[f64; 3]; 3]| crossing(&[flat, others].concat(), &[[0, 1, 2], [3, 4, 5]]);
    let piercing = [[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [9.0, 9.0, 1.0]];
    assert!(with(piercing), "an edge through the inside");
    assert!(with([[1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [2.0, 1.0, 1.0]]), "a corner on the inside");
    assert!(with([[-1.0, 0.0, -1.0], [-1.0, 0.0, 1.0], [9.0, 0.0, 0.0]]), "an edge of the first through the other");
    assert!(with([[1.0, 1.0, 0.0], [2.0, 1.0, 0.0], [1.0, 2.0, 0.0]]), "one inside the other, in one plane");
    assert!(with([[3.0, 3.0, 0.0], [-1.0, 1.0, 0.0], [1.0, -1.0, 0.0]]), "edges that cross, in one plane");
    assert!(with([[4.0, 0.0, 1.0], [4.0, 0.0, -1.0], [6.0, 0.0, 0.0]]), "a corner on an edge");
    assert!(!with([[4.5, 0.0, 1.0], [4.5, 0.0, -1.0], [6.0, 0.0, 0.0]]), "beside");
    assert!(!with([[1.0, 1.0, 0.5], [2.0, 1.0, 0.5], [1.0, 2.0, 0.5]]), "above");
    assert!(!with([[3.0, 3.0, 0.0], [4.0, 3.0, 0.0], [3.0, 4.0, 0.0]]), "in one plane, with boxes that meet");
    // Half a unit in the last place decides.
    let low = f64::from_bits(1);
    assert!(!with([[1.0, 1.0, low], [1.0, 1.0, 1.0], [2.0, 1.0, 1.0]]));

    // A common corner.
    let corner = |c: [f64; 3], d: [f64; 3]| crossing(&[flat[0], flat[1], flat[2], c, d], &[[0, 1, 2], [0, 3, 4]]);
    assert!(!corner([-1.0, 0.0, 1.0], [-1.0, 0.0, -1.0]), "only that");
    assert!(corner([1.0, 1.0, 1.0], [1.0, 1.0, -1.0]), "and more");
    assert!(corner([8.0, 8.0, 1.0], [8.0, 8.0, -1.0]), "and the first's opposite side in the other");
    assert!(corner([1.0, 2.0, 0.0], [2.0, 1.0, 0.0]), "and all of the other");
    // A common edge.
    let edge = |d: [f64; 3]| crossing(&[flat[0], flat[1], flat[2], d], &[[0, 1, 2], [1, 0, 3]]);
    assert!(!edge([0.0, -1.0, 0.0]) && !edge([1.0, 1.0, 1.0]));
    assert!(edge([1.0, 1.0, 0.0]), "folded onto the first");
    // The common edge has separate points in each face, as in files with seams.
    let seam = |d: [f64; 3]| crossing(&[flat[0], flat[1], flat[2], flat[1], flat[0], d], &[[0, 1, 2], [3, 4, 5]]);
    assert!(!seam([0.0, -1.0, 0.0]) && seam([1.0, 1.0, 0.0]));
    let signed = [flat[0], flat[1], flat[2], [4.0, -0.0, 0.0], [-0.0, 0.0, -0.0], [0.0, -1.0, 0.0]];
    assert!(!crossing(&signed, &[[0, 1, 2], [3, 4, 5]]), "zero and minus zero are one place");
    assert!(crossing(&[flat, flat].concat(), &[[0, 1, 2], [3, 4, 5]]), "the same face twice, of other points");
}

#[test]
fn quadrangles_are_judged_if_they_are_convex_and_left_out_otherwise() {
    let square = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 0.0]];
    // Through the half of the square away from its first side.
    let needle = [[1.0, 3.0, -1.0], [1.0, 3.0, 1.0], [1.0, 9.0, 1.0]];
    let both = [square.as_slice(), needle.as_slice()].concat();
    assert_eq!(found(&both, [vec![0, 1, 2, 3], vec![4, 5, 6]]), [Finding::CrossingFaces { faces: [0, 1] }]);
    // An arrow whose first corner lies opposite the notch.
    let arrow = [[0.0, 0.0, 0.0], [4.0, -4.0, 0.0], [1.0, 0.0, 0.0], [4.0, 4.0, 0.0]];
    let audit = audited(
        &[arrow.as_slice(), &[[3.0, 0.0, -1.0], [3.0, 0.0, 1.0], [9.0, 0.0, 1.0]]].concat(),
        [vec![0, 1, 2, 3], vec![4, 5, 6]],
    );
    let rule = audit.rules().into_iter().find(|rule| rule.id == "M10").unwrap();
    assert_eq!((rule.checked, rule.left_out, audit.findings().total(), audit.is_valid()), (1, Some(1), 0, false));
    assert!(rule.not_checked().unwrap().contains("not convex"), "{rule}");
}

#[test]
fn a_component_that_faces_inwards_breaks_m11_alone() {
    let inside_out = |face| Finding::InsideOut { face, faces: 4 };
    assert_eq!(kinds(&[([0.0; 3], 1.0, false)]), [inside_out(0)]);
    // Far from the origin, where rounded numbers do not determine the sign.
    for at in [[1e9, 1e9, 1e9], [-1e12, 1e12, 3e11]] {
        assert_eq!(kinds(&[(at, 1.0, true)]), []);
        assert_eq!(kinds(&[(at, 1.0, false)]), [inside_out(0)]);
    }
    // Side by side, the second one is inverted.
    assert_eq!(kinds(&[([0.0; 3], 1.0, true), ([5.0; 3], 1.0, false)]), [inside_out(4)]);
    // A cavity, a body in it, and an inverted body in it.
    let hollow = [([0.0; 3], 100.0, true), ([5.0; 3], 60.0, false)];
    assert_eq!(kinds(&hollow), []);
    assert_eq!(kinds(&[hollow[0], hollow[1], ([9.0; 3], 9.0, true)]), []);
    assert_eq!(kinds(&[hollow[0], hollow[1], ([9.0; 3], 9.0, false)]), [inside_out(8)]);
    // A surface with a border has no inside.
    assert_eq!(found(&AT_TETRAHEDRON, [[0_u32, 1, 2], [0, 3, 1], [1, 3, 2]]), []);
    // A sheet with two sides encloses nothing.
    let sheet = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.5, 0.0]];
    let faces = [vec![0, 1, 2, 3], vec![1, 0, 4], vec![2, 1, 4], vec![3, 2, 4], vec![0, 3, 4]];
    let audit = audited(&sheet, faces);
    assert_eq!(audit.findings().count(Kind::InsideOut), 1, "{audit}");
}

quickcheck! {
    /// Rotations and shifts by integers on a grid are exact and change nothing; a mirror image faces inwards.
    fn findings_follow_turns_and_shifts(places: Vec<(i8, i8, i8)>, shift: (i16, i16, i16)) -> bool {
        let points: Vec<[f64; 3]> = places.iter().take(12).map(|p| [p.0, p.1, p.2].map(|x| f64::from(x % 5))).collect();
        let faces: Vec<[u32; 3]> = (0..points.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let moved: Vec<[f64; 3]> = points
            .iter()
            .map(|[x, y, z]| [z + f64::from(shift.0), x + f64::from(shift.1), y + f64::from(shift.2)])
            .collect();
        let mirrored: Vec<[f64; 3]> = points.iter().map(|[x, y, z]| [*x, *y, -z]).collect();
        let of = |points: &[[f64; 3]]| audited(points, &faces).findings().clone();
        of(&points) == of(&moved) && of(&points) == of(&mirrored)
    }

    /// Compared with sums of fractions: triangles on a small grid cross if and only if a point of a fine barycentric grid shows it, or they touch
    /// away from its points. The rule finds everything that the grid finds.
    fn what_points_of_triangles_show_is_found(numbers: Vec<i8>) -> bool {
        let coordinate = |i: usize| f64::from(numbers.get(i).copied().unwrap_or_default() % 3);
        let points: Vec<[f64; 3]> = (0..6).map(|i| [0, 1, 2].map(|axis| coordinate(3 * i + axis))).collect();
        let audit = audited(&points, [[0, 1, 2], [3, 4, 5]]);
        if audit.findings().count(Kind::ZeroArea) > 0 {
            return true;
        }
        let shared = (0..3).filter(|i| points[3..].contains(&points[*i])).count();
        // Six times each point, so that all numbers are integers.
        let of = |start: usize| {
            let weights = (0..=6_u8).flat_map(|a| (0..=6 - a).map(move |b| [a, b, 6 - a - b].map(f64::from)));
            weights.map(|w| [0, 1, 2].map(|axis| (0..3).map(|i| w[i] * points[start + i][axis]).sum::<f64>())).collect::<Vec<_>>()
        };
        let (one, other) = (of(0), of(3));
        let common = one.iter().filter(|at| other.contains(at)).count();
        // A common edge has seven of these points, and a common corner has one.
        let expected = [0, 1, 7][shared.min(2)];
        shared == 3 || common <= expected || audit.findings().count(Kind::CrossingFaces) == 1
    }
}
