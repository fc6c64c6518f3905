//! Certificates, record by record: a vacant slot is never read, and each failing record is counted.

use crate::only_live::OnlyLive;
use crate::tables::{TETRAHEDRON, half_edge, textbook_mesh};
use twinedge::validate::{Start, Table, View};
use twinedge_certificate::{Certificate, Column, Failure, Labels, SurfaceCertificate, Test, check, check_surface};

fn failures(result: Result<(), Vec<Failure>>) -> Vec<String> {
    result.unwrap_err().iter().map(ToString::to_string).collect()
}

fn tests(result: Result<(), Vec<Failure>>) -> Vec<Test> {
    result.unwrap_err().iter().map(|failure| failure.test()).collect()
}

#[test]
fn a_boundary_component_that_starts_at_a_vacant_vertex_is_wrong() {
    let table: Table = "V 1 x H 0 B 1 0 v0 i0 F 1 - 1 0".parse().unwrap();
    assert!(tests(check(&OnlyLive(&table), &Labels::default())).contains(&Test::StartOk));
}

#[test]
fn half_edges_of_a_vacant_face_or_before_a_vacant_one_are_wrong() {
    let table = textbook_mesh(4, &TETRAHEDRON);
    let (labels, genus) = Labels::of_surface(&table).unwrap();
    assert_eq!(check_surface(&OnlyLive(&table), &labels, genus), Ok(()));
    let (mut face, mut before) = (table.clone(), table);
    face.faces[3] = None;
    before.half_edges[0] = None;
    for table in [face, before] {
        assert!(tests(check_surface(&OnlyLive(&table), &labels, genus)).contains(&Test::CycleOk));
    }
}

/// The component of the last half-edge applies to all later ones, but to no number beyond them.
#[test]
fn a_next_beyond_the_last_half_edge_is_of_no_component() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    let (labels, genus) = Labels::of_surface(&table).unwrap();
    half_edge(&mut table, 5).next = Some(12);
    let found = failures(check_surface(&table, &labels, genus));
    assert!(found.contains(&"component_ok: 1 of the half-edges, the first is 5".to_owned()), "{found:?}");
}

/// One of them alone has no neighbour of lower rank. The others have the missing component of their neighbours.
#[test]
fn all_half_edges_of_no_component_are_counted() {
    let table = textbook_mesh(4, &TETRAHEDRON);
    let (mut labels, genus) = Labels::of_surface(&table).unwrap();
    *labels.column_mut(Column::HalfEdgeComponent) = vec![u32::MAX; table.half_edges.len()];
    let result = check_surface(&table, &labels, genus);
    let numbers = |failure: &Failure| (failure.test(), failure.count(), failure.first());
    assert!(result.as_ref().unwrap_err().iter().map(numbers).any(|found| found == (Test::ComponentOk, 12, Some(0))));
    let found = failures(result);
    assert!(found.contains(&"component_ok: 12 of the half-edges, the first is 0".to_owned()), "{found:?}");
}

#[test]
fn a_surface_is_counted_and_the_counts_are_said_in_words() {
    let certificate = SurfaceCertificate::new(&textbook_mesh(4, &TETRAHEDRON)).unwrap();
    let mut counts = certificate.check().unwrap();
    assert_eq!((counts.vertices, counts.edges, counts.faces), (4, 6, 4));
    assert_eq!(counts.to_string(), "a surface of genus 0 with 1 component, closed");
    (counts.genus, counts.components, counts.holes) = (2, 3, 1);
    assert_eq!(counts.to_string(), "a surface of genus 2 with 3 components, open at 1 hole");
    (counts.components, counts.holes) = (0, 2);
    assert_eq!(counts.to_string(), "a surface of genus 2 with 0 components, open at 2 holes");
}

#[test]
fn labels_of_another_structure_are_not_readable() {
    let edge: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse().unwrap();
    let none = Labels::default();
    assert!(tests(check(&edge, &none)).contains(&Test::Readable));
    assert!(tests(check_surface(&edge, &none, 0)).contains(&Test::Readable));
}

/// A loop, whose unbounded face is the last record.
#[test]
fn the_unbounded_face_is_counted_where_it_is_the_last_record() {
    let table = "V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 0 h0 o 1 h1 i0 F 2 0 0 - 1 1";
    let table: Table = table.parse().unwrap();
    let labels = Labels::new(&table).unwrap();
    assert_eq!(check(&table, &labels), Ok(()));
}

/// A certificate made from its own columns is equal, and inconsistent columns make none.
#[test]
fn a_certificate_is_made_of_columns() {
    let vertex: Table = "V 1 - 0 H 0 B 1 0 v0 i0 F 1 - 1 0".parse().unwrap();
    let certificate = Certificate::new(&vertex, &Labels::new(&vertex).unwrap()).unwrap();
    assert_eq!(certificate.check(), Ok(()));
    assert_eq!((certificate.isolated(0), certificate.boundary_start(0)), (Some(0), Some(Start::Vertex(0))));
    let mut columns = certificate.columns().clone();
    assert_eq!(Certificate::from_columns(columns.clone()), Some(certificate));
    columns.column_mut(Column::BoundaryPlace).clear();
    assert_eq!(Certificate::from_columns(columns), None);
}
