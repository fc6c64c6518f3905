//! Hints of reports, and the rules that they omit.

use crate::support::erased::validate;
use crate::support::tables::{TETRAHEDRON, Without, half_edge, textbook_map, textbook_mesh, vertex};
use twinedge::validate::{Collect, Expectation, Part, Parts, Report, Rule, Start, Table, Unchecked, View, Violation};
use twinedge::view_answers;

const PLANE: Expectation = Expectation::plane();
const MESH: Expectation = Expectation::surface();

/// The hints of a report, which come before its violations.
fn hints(report: &Report) -> Vec<String> {
    let text = report.to_string();
    let (is_hint, first) = (|line: &str| line.starts_with("hint: "), report.first().map(ToString::to_string));
    let after = text.lines().skip_while(|line| Some(*line) != first.as_deref());
    assert!(!after.into_iter().any(is_hint), "{text}");
    text.lines().filter_map(|line| line.strip_prefix("hint: ")).map(str::to_owned).collect()
}

#[test]
fn an_unbounded_face_that_is_not_stored_is_said_to_be_one() {
    // A triangle in the plane, whose outside is a face without outer boundary component.
    let table = textbook_map(
        3,
        &[(0, 2), (1, 5), (1, 4), (2, 1), (2, 0), (0, 3)],
        &[(Some(0), &[]), (None, &[Start::HalfEdge(1)])],
    );
    assert_eq!(hints(&validate(&table, &PLANE, Collect::All)), [""; 0]);
    let without = table.without(Part::UnboundedFace);
    let report = validate(&without, &PLANE, Collect::All);
    assert_eq!(report.first(), Some(&Violation::NoOuter { face: 1 }));
    let hint = "a face has no outer boundary component; if it is the unbounded face, add `Part::UnboundedFace` to `View::parts`";
    assert_eq!(hints(&report), [hint]);
    assert_eq!(hints(&validate(&without, &MESH, Collect::All)), [""; 0]);
}

#[test]
fn a_sphere_that_passes_for_a_plane_is_said_to_be_one() {
    let table = textbook_mesh(4, &TETRAHEDRON).without(Part::Holes);
    let report = validate(&table, &PLANE, Collect::All);
    assert!(report.is_valid());
    let found = hints(&report);
    assert!(found.len() == 1 && found[0].starts_with("all faces are bounded, as those of a sphere are"), "{found:?}");
    assert_eq!(hints(&validate(&table, &MESH, Collect::All)), [""; 0]);
}

#[test]
fn rules_of_the_plane_are_not_said_to_need_others_on_a_surface() {
    struct TooMany;
    impl View for TooMany {
        view_answers! { |_many|
            parts => Parts::NONE,
            vertex_slots => usize::MAX,
            half_edge_slots => 0,
            origin(_h) => None,
            twin(_h) => None,
            next(_h) => None,
        }
    }
    let table = textbook_mesh(4, &TETRAHEDRON);
    let mut broken = table.clone();
    half_edge(&mut broken, 0).twin = Some(0);
    let stored = Table { parts: table.parts.with(Part::UnboundedFace), ..table.clone() };
    let reports = [
        validate(&table, &MESH, Collect::All),
        validate(&broken, &MESH, Collect::All),
        validate(&broken, &MESH, Collect::First),
        validate(&stored, &MESH, Collect::All),
        validate(&TooMany, &MESH, Collect::All),
    ];
    for report in reports {
        for rule in [Rule::B2, Rule::T1, Rule::T2, Rule::T4] {
            assert_eq!(report.outcome(rule).unwrap().unchecked, Some(Unchecked::PlaneOnly), "{report}");
            assert!(!report.to_string().contains(&format!("{rule} {}", rule.name())), "{report}");
        }
    }
}

/// Neither a structure without records, nor one in which the first links of a column are nil.
#[test]
fn what_is_not_missing_gets_no_hint() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    let empty = Table { parts: table.parts.without(Part::UnboundedFace), ..Table::default() };
    let report = validate(&empty, &PLANE, Collect::All);
    assert!(report.is_valid(), "{report}");
    assert_eq!(hints(&report), [""; 0]);
    for h in 0..2 {
        half_edge(&mut table, h).prev = None;
    }
    let report = validate(&table, &MESH, Collect::All);
    assert_eq!(report.violations().len() as u64, report.violation_count());
    assert_eq!(hints(&report), [""; 0]);
}

#[test]
fn a_link_that_is_nil_everywhere_is_said_to_be_no_part_of_the_structure() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    assert_eq!(hints(&validate(&table, &MESH, Collect::All)), [""; 0]);
    for h in 0..12 {
        half_edge(&mut table, h).prev = None;
        half_edge(&mut table, h).face = None;
    }
    for v in 0..4 {
        vertex(&mut table, v).leaving = None;
    }
    let nil = |what: &str, lacks: &str, part: Part| {
        format!("the {what} is nil; if the structure stores no {lacks}, leave `Part::{part:?}` out of `View::parts`")
    };
    let prev = nil("prev of all 12 half-edges", "prev links", Part::Prev);
    let leaving = nil("leaving half-edge of all 4 vertices", "leaving half-edges", Part::Leaving);
    let face = nil("face of all 12 half-edges", "faces", Part::Faces);
    assert_eq!(hints(&validate(&table, &MESH, Collect::All)), [prev.clone(), face, leaving.clone()]);
    let lacks = "boundary component records";
    let by_record = Table { parts: Parts::ALL, ..table.clone() };
    let boundary = nil("boundary component of all 12 half-edges", lacks, Part::BoundaryComponents);
    assert_eq!(hints(&validate(&by_record, &MESH, Collect::All)), [prev, boundary, leaving]);
    // Only the violations of the first half-edges are kept.
    let some = validate(&table, &MESH, Collect::AtMost(5));
    assert_eq!(hints(&some)[0], nil("prev of the first 3 half-edges", "prev links", Part::Prev));
    // With one non-nil link, the others are broken rather than missing.
    half_edge(&mut table, 0).prev = Some(2);
    assert!(!hints(&validate(&table, &MESH, Collect::All)).iter().any(|hint| hint.contains("prev")));
}

#[test]
fn half_edges_without_twin_are_said_to_be_legal_at_a_border() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    for h in [0, 5] {
        half_edge(&mut table, h).twin = None;
    }
    let hint = "a twin is nil; if the structure has a border, use `Expectation::open()`";
    assert_eq!(hints(&validate(&table, &MESH, Collect::All)), [hint]);
    assert_eq!(hints(&validate(&table, &MESH.open(), Collect::All)), [""; 0]);
}

/// A vertex listed by a textbook face, read as if there were boundary components.
#[test]
fn lists_of_the_textbook_are_said_to_be_no_boundary_components() {
    let table: Table = "V 1 - - H 0 B 0 F 1 - 1 - FH 1 - 1 v0".parse().unwrap();
    let found = hints(&validate(&table, &PLANE, Collect::All));
    assert!(
        found.iter().any(|hint| hint.ends_with("leave `Part::BoundaryComponents` out of `View::parts`")),
        "{found:?}"
    );
    assert_eq!(hints(&validate(&table.without(Part::BoundaryComponents), &PLANE, Collect::All)), [""; 0]);
}

#[test]
fn faces_that_are_named_but_not_there_are_said_to_be_missing() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    half_edge(&mut table, 0).face = Some(9);
    assert_eq!(hints(&validate(&table, &MESH, Collect::All)), [""; 0]);
    table.faces.clear();
    let report = validate(&table, &MESH, Collect::All);
    assert_eq!(hints(&report), ["half-edges name faces, but there are none; does the view implement `face_slots`?"]);
}
