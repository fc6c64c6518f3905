//! Random lists of faces, compared with the second opinion and the laws.

use crate::support::oracle::opinion;
use crate::support::shapes::{mesh, points};
use crate::support::soup::Soup;
use crate::support::write::{Kind as Written, write};
use quickcheck::{Gen, QuickCheck};
use twinedge::validate::{Collect, Rule, validate};
use twinedge_meshes::{Finding, HalfEdgeMesh, IndexedMesh, Kind, MeshAudit, audit, read_bytes};

fn audited(mesh: &IndexedMesh) -> MeshAudit {
    audit(mesh, &HalfEdgeMesh::expectation(), Collect::AtMost(usize::MAX))
}

fn check<A: quickcheck::Testable>(tests: u64, property: A) {
    QuickCheck::new().tests(tests).max_tests(tests).rng(Gen::new(60)).quickcheck(property);
}

#[test]
fn findings_and_counts_are_those_of_the_second_opinion() {
    fn agrees(soup: Soup) {
        let mesh = soup.mesh();
        let (found, expected) = (audited(&mesh), opinion(&mesh));
        let order = |finding: &Finding| {
            let (faces, vertices) = (finding.faces(), finding.vertices());
            match finding.kind() {
                Kind::NonManifoldEdge | Kind::FlippedFaces => vertices.into_iter().min(),
                Kind::NonManifoldVertex | Kind::UnusedVertex => vertices.first().copied(),
                _ => faces.first().copied(),
            }
        };
        assert!(found.findings().list().is_sorted_by_key(|finding| (finding.kind(), order(finding))));
        let sorted = |list: &[Finding]| {
            let mut list: Vec<_> = list.iter().map(|finding| format!("{finding:?}")).collect();
            list.sort();
            list
        };
        assert_eq!(sorted(found.findings().list()), sorted(&expected.findings));
        for kind in Kind::ALL {
            let listed = expected.findings.iter().filter(|finding| finding.kind() == *kind).count();
            assert_eq!(found.findings().count(*kind), listed);
        }
        let counts = found.counts();
        assert_eq!(counts.vertices, soup.points);
        assert_eq!(counts.faces, soup.faces.len());
        assert_eq!(counts.left_out_faces, soup.faces.len() - expected.kept.len());
        assert_eq!(counts.unused_vertices, soup.points - expected.used_vertices().len());
        assert_eq!(counts.edges, expected.edges.len());
        assert_eq!(counts.border_edges, expected.edges.values().filter(|sides| sides.len() == 1).count());
        assert_eq!(counts.components, expected.components());
        assert_eq!(counts.triangles, expected.kept.iter().filter(|(_, face)| face.len() == 3).count());
        let euler =
            (expected.used_vertices().len() + expected.kept.len()).cast_signed() - expected.edges.len().cast_signed();
        assert_eq!(counts.euler_characteristic, euler);
        if expected.kept.len() <= 10 {
            assert_eq!(counts.orientable, expected.orientable());
        }
        if found.findings().is_faultless() {
            // If every vertex has one fan, border loops do not touch.
            assert_eq!(counts.borders, Some(expected.border_graph_components()));
        }
    }
    check(4000, agrees as fn(Soup));
}

#[test]
fn what_has_no_fault_is_valid_and_obeys_euler() {
    fn holds(soup: Soup) {
        let mesh = soup.mesh();
        let found = audited(&mesh);
        let findings = found.findings();
        if findings.is_faultless() || mesh.face_count() == 0 {
            assert!(found.report().is_valid(), "{found}");
        }
        let counts = found.counts();
        let joined = [Kind::NonManifoldEdge, Kind::FlippedFaces, Kind::NonManifoldVertex];
        if joined.iter().all(|kind| findings.count(*kind) == 0) {
            let (borders, genus) = (counts.borders.expect("known"), counts.genus.expect("known"));
            assert_eq!(
                counts.euler_characteristic,
                2 * counts.components.cast_signed() - 2 * genus.cast_signed() - borders.cast_signed()
            );
        } else {
            assert_eq!(counts.genus, None);
            assert!(!found.is_valid());
        }
        // The validator sees the fans by itself, one vertex in place of another, if there is no other finding.
        if joined[..2].iter().all(|kind| findings.count(*kind) == 0) {
            let fans = findings.count(Kind::NonManifoldVertex) as u64;
            assert_eq!(found.report().outcome(Rule::V2).map(|outcome| outcome.violations), Some(fans));
            assert_eq!(found.report().violation_count(), fans);
        }
        assert_eq!(found.is_valid(), findings.is_faultless());
    }
    check(4000, holds as fn(Soup));
}

#[test]
fn twins_are_the_two_sides_of_an_edge_with_two_faces_in_opposite_directions() {
    fn holds(soup: Soup) {
        use twinedge::validate::View;
        let mesh = soup.mesh();
        let expected = opinion(&mesh);
        let (half_edges, _) = HalfEdgeMesh::link(&mesh, Collect::All);
        let mut pairs = 0;
        for h in (0..half_edges.half_edge_slots()).filter(|h| half_edges.is_half_edge(*h)) {
            let Some(t) = half_edges.twin(h) else { continue };
            pairs += 1;
            assert_eq!(half_edges.twin(t), Some(h));
            let target = |h| half_edges.origin(half_edges.next(h).expect("live"));
            assert_eq!((half_edges.origin(h), target(h)), (target(t), half_edges.origin(t)));
        }
        let opposite = expected.edges.values().filter(|s| s.len() == 2 && s[0].1 != s[1].1).count();
        assert_eq!(pairs, 2 * opposite);
    }
    check(2000, holds as fn(Soup));
}

#[test]
fn the_order_of_faces_and_vertices_does_not_matter() {
    fn holds(soup: Soup, seed: u64) {
        let mut state = seed | 1;
        let mut below = |limit: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % limit
        };
        let mut names: Vec<u32> = (0..soup.points as u32).collect();
        for i in (1..names.len()).rev() {
            names.swap(i, below(i + 1));
        }
        let mut faces = soup.faces.clone();
        for i in (1..faces.len()).rev() {
            faces.swap(i, below(i + 1));
        }
        for face in &mut faces {
            for v in face.iter_mut() {
                *v = names[*v as usize];
            }
            if !face.is_empty() {
                let shift = below(face.len());
                face.rotate_left(shift);
            }
        }
        let shuffled = Soup { points: soup.points, faces };
        let (a, b) = (audited(&soup.mesh()), audited(&shuffled.mesh()));
        let (mut counts, mut shuffled_counts) = (*a.counts(), *b.counts());
        let back_to_back = |finding: &Finding| matches!(finding, Finding::RepeatedFace { reversed: true, .. });
        let one_may_fit = a.findings().list().iter().any(back_to_back);
        if one_may_fit {
            // The first of two equal faces is kept, and this choice decides about joints.
            for counts in [&mut counts, &mut shuffled_counts] {
                (counts.borders, counts.genus) = (None, None);
            }
        }
        assert_eq!(counts, shuffled_counts);
        for kind in Kind::ALL.iter().filter(|kind| !(one_may_fit && **kind == Kind::FlippedFaces)) {
            assert_eq!(a.findings().count(*kind), b.findings().count(*kind), "{kind}");
        }
        assert_eq!(a.is_valid(), b.is_valid());
    }
    check(2000, holds as fn(Soup, u64));
}

#[test]
fn turning_faces_does_not_change_whether_the_surface_is_orientable() {
    fn holds(turned: u16) {
        // A band of 16 cells between the vertices 0 … 15 and 16 … 31, closed straight or with a twist.
        for twisted in [false, true] {
            let mut cells: Vec<[u32; 4]> = (0..16).map(|i| [i, i + 1, i + 17, i + 16]).collect();
            let [first, second] = if twisted { [16, 0] } else { [0, 16] };
            cells[15] = [15, first, second, 31];
            for (i, cell) in cells.iter_mut().enumerate() {
                if turned >> i & 1 == 1 {
                    cell.reverse();
                }
            }
            let found = audited(&mesh(32, cells));
            assert_eq!(found.counts().orientable, !twisted);
            assert_eq!(found.counts().border_edges, 32);
            assert_eq!(found.counts().euler_characteristic, 0);
            let changes = (0..16).filter(|i| (turned >> i ^ turned >> ((i + 1) % 16)) & 1 == 1).count();
            // The twist adds one place, where faces agree if one of them is reversed.
            let at_the_end = usize::from((turned >> 15 ^ turned) & 1 == 1);
            let flipped = if twisted { changes + 1 - 2 * at_the_end } else { changes };
            assert_eq!(found.findings().count(Kind::FlippedFaces), flipped);
        }
    }
    check(500, holds as fn(u16));
}

#[test]
fn what_was_written_is_read_again() {
    fn holds(soup: Soup, coordinates: Vec<(f64, f64, f64)>) {
        let mut at = points(soup.points);
        for (point, (x, y, z)) in at.iter_mut().zip(coordinates) {
            let finite = |x: f64| if x.is_finite() { x } else { 0.5 };
            *point = [finite(x), finite(y), finite(z)];
        }
        let mesh = IndexedMesh::from_faces(at, &soup.faces).expect("indices in range");
        for kind in Written::INDEXED {
            let file = read_bytes(&write(&mesh, kind), Some(kind.format())).expect("well-formed");
            assert_eq!(file.mesh, mesh, "{kind:?}");
            assert_eq!(file.dropped, [], "{kind:?}");
        }
    }
    check(500, holds as fn(Soup, Vec<(f64, f64, f64)>));
}

#[test]
fn triangles_come_back_from_stl_at_their_places_and_joined() {
    fn holds(soup: Soup) {
        let triangles: Vec<_> = soup.faces.iter().filter(|face| face.len() == 3).cloned().collect();
        let mesh = Soup { points: soup.points, faces: triangles }.mesh();
        let places = |mesh: &IndexedMesh| -> Vec<[f64; 3]> {
            mesh.corners().iter().map(|v| mesh.points()[*v as usize]).collect()
        };
        for kind in [Written::TextStl, Written::BinaryStl] {
            let file = read_bytes(&write(&mesh, kind), Some(kind.format())).expect("well-formed");
            assert_eq!(places(&file.mesh), places(&mesh), "{kind:?}");
            let (mut before, mut after) = (*audited(&mesh).counts(), *audited(&file.mesh).counts());
            // The file does not have the points that no triangle uses.
            before.vertices = after.vertices;
            before.unused_vertices = 0;
            after.unused_vertices = 0;
            assert_eq!(before, after, "{kind:?}");
        }
    }
    check(500, holds as fn(Soup));
}

#[test]
fn an_audit_is_what_its_parts_are() {
    fn holds(soup: Soup) {
        let mesh = soup.mesh();
        let (half_edges, findings) = HalfEdgeMesh::link(&mesh, Collect::All);
        let report = validate(&half_edges, &HalfEdgeMesh::expectation(), Collect::All);
        let audit = audit(&mesh, &HalfEdgeMesh::expectation(), Collect::All);
        assert_eq!(audit.findings(), &findings);
        assert_eq!(audit.report(), &report);
        assert_eq!(audit.counts().edges, half_edges.edge_count());
    }
    check(200, holds as fn(Soup));
}

/// Without these examples, the laws above would hold vacuously.
#[test]
fn the_random_lists_have_every_kind_of_finding_and_none() {
    use quickcheck::Arbitrary;
    let mut g = Gen::new(60);
    let (mut faultless, mut handles, mut one_sided) = (0, 0, 0);
    // Other tests cover the findings about places of points.
    let kinds: Vec<&Kind> = Kind::ALL.iter().filter(|kind| kind.rule().is_none()).collect();
    let mut with = vec![0; kinds.len()];
    for _ in 0..6000 {
        let audit = audited(&Soup::arbitrary(&mut g).mesh());
        let counts = audit.counts();
        faultless += usize::from(audit.is_valid() && counts.faces > 2);
        handles += usize::from(counts.genus.is_some_and(|genus| genus > 0));
        one_sided += usize::from(!counts.orientable);
        for (with, kind) in with.iter_mut().zip(&kinds) {
            *with += usize::from(audit.findings().count(**kind) > 0);
        }
    }
    assert!(faultless > 200 && handles > 50 && one_sided > 50, "{faultless} {handles} {one_sided}");
    assert!(with.iter().all(|count| *count > 100), "{with:?}");
}
