//! Certificates of surfaces with a border: a certificate that passes is a surface with the counted genus, components and holes.

use crate::tables::{TETRAHEDRON, Without, half_edge, textbook_mesh, torus, with_boundary_components, without_border};
use std::collections::BTreeSet;
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{Expectation, FaceRow, Part, Rule, Table};
use twinedge_certificate::{Column, Failure, Labels, SurfaceCertificate, SurfaceCounts, Test};
use twinedge_trials::enumerate::for_each_corruption;

const OPEN: Expectation = Expectation::surface().open();

/// The way in which a side is missing at the border.
#[derive(Clone, Copy)]
enum Border {
    /// There is no half-edge.
    NoTwin,
    /// The half-edge has no face.
    NoFace,
}

/// Removes these faces from a mesh. Faces of the mesh name their half-edges.
fn opened(mesh: &Table, faces: &[usize], border: Border) -> Table {
    let mut table = mesh.clone();
    let gone = table.half_edges.iter_mut().flatten().filter(|row| row.face.is_some_and(|f| faces.contains(&f)));
    gone.for_each(|row| row.face = None);
    for f in faces {
        table.faces[*f] = None;
    }
    match border {
        Border::NoFace => table,
        Border::NoTwin => without_border(&table),
    }
}

fn by_record(table: &Table) -> Table {
    let vacant: Vec<usize> = (0..table.faces.len()).filter(|f| table.faces[*f].is_none()).collect();
    let mut filled = table.clone();
    for f in &vacant {
        filled.faces[*f] = Some(FaceRow::default());
    }
    let mut recorded = with_boundary_components(&filled);
    for f in vacant {
        recorded.faces[f] = None;
    }
    recorded
}

fn check(table: &Table) -> Result<SurfaceCounts, Vec<Failure>> {
    SurfaceCertificate::new(table).unwrap().check()
}

fn tests(table: &Table) -> Vec<Test> {
    check(table).unwrap_err().iter().map(|failure| failure.test()).collect()
}

/// Returns true if the structure is an open surface with these counts, by the reference.
fn is_confirmed(table: &Table, counts: &SurfaceCounts) -> bool {
    let asked = OPEN.genus(counts.genus).components(counts.components).borders(counts.holes);
    first_broken_rule(table, &asked).is_none()
}

/// Returns true if the origins of the half-edges along the border differ, and each edge has a face.
fn has_simple_border(table: &Table) -> bool {
    let row = |h: usize| table.half_edges.get(h).copied().flatten();
    let mut origins = BTreeSet::new();
    (0..table.half_edges.len()).filter_map(row).all(|half_edge| {
        let bounds = |row: twinedge::validate::HalfEdgeRow| row.face.or(row.boundary).is_some();
        let added = half_edge.twin.is_none().then(|| half_edge.next.and_then(row).and_then(|next| next.origin));
        let hole = (table.parts.has(Part::Faces) && !bounds(half_edge)).then_some(half_edge.origin);
        let twin_bounds = || half_edge.twin.and_then(row).is_some_and(bounds);
        [added, hole].into_iter().flatten().all(|origin| origins.insert(origin)) && (hole.is_none() || twin_bounds())
    })
}

/// Every mesh made by removing faces from a tetrahedron and from a small torus, in each form.
fn open_meshes() -> Vec<Table> {
    let subsets = |count: u32, faces: usize| {
        (0..1_u32 << count).map(move |set| (0..faces).filter(|f| f < &32 && set >> f & 1 == 1).collect::<Vec<_>>())
    };
    let tetrahedron = textbook_mesh(4, &TETRAHEDRON);
    let torus = textbook_mesh(9, &torus([3, 3]));
    let all = subsets(4, 4).map(|faces| (&tetrahedron, faces)).chain(subsets(6, 18).map(|faces| (&torus, faces)));
    all.flat_map(|(mesh, faces)| [Border::NoTwin, Border::NoFace].map(|border| opened(mesh, &faces, border)))
        .flat_map(|table| {
            let bare = [table.without(Part::Prev).without(Part::Leaving), table.without(Part::Faces)];
            bare.into_iter().chain([by_record(&table), table])
        })
        .collect()
}

#[test]
fn an_open_mesh_is_certified_if_and_only_if_its_border_is_simple() {
    let (mut certified, mut refused, mut holes) = (0, 0, BTreeSet::new());
    for table in open_meshes() {
        let is_right = first_broken_rule(&table, &OPEN).is_none() && has_simple_border(&table);
        let checked = check(&table);
        assert_eq!(checked.is_ok(), is_right, "{table}");
        if let Ok(counts) = checked {
            assert!(is_confirmed(&table, &counts), "{table}");
            holes.insert(counts.holes);
        }
        *if is_right { &mut certified } else { &mut refused } += 1;
    }
    // Without faces a mesh is open only where twins are missing: 45 of 80 are valid then, and all 80 where none is.
    assert_eq!((certified, refused, holes.len()), (180 + 45 + 80, 300 + 35, 3));
}

#[test]
fn a_corruption_of_an_open_mesh_passes_only_if_the_rules_hold() {
    let tetrahedron = textbook_mesh(4, &TETRAHEDRON);
    let (mut wrong, mut right) = (0, 0);
    for (faces, border) in
        [(&[][..], Border::NoFace), (&[1], Border::NoFace), (&[1], Border::NoTwin), (&[0, 2], Border::NoTwin)]
    {
        let mesh = opened(&tetrahedron, faces, border);
        for mut table in [by_record(&mesh), mesh] {
            let parts = OPEN.looks_at(table.parts);
            for_each_corruption(&mut table, parts, |corrupt, cell, value| {
                let holds = first_broken_rule(corrupt, &OPEN).is_none();
                let checked = check(corrupt);
                assert_eq!(checked.is_ok(), holds && has_simple_border(corrupt), "{cell:?} = {value:?}: {corrupt}");
                assert!(
                    checked.is_err() || is_confirmed(corrupt, &checked.unwrap()),
                    "{cell:?} = {value:?}: {corrupt}"
                );
                *if holds { &mut right } else { &mut wrong } += 1;
            });
        }
    }
    assert_eq!((wrong, right), (5111, 94));
}

/// Two triangles with a common vertex, and a border through it twice: the rules hold, as each rotation is one orbit, but it is no
/// surface.
#[test]
fn a_border_that_passes_a_vertex_twice_is_refused() {
    let mut table = opened(&textbook_mesh(5, &[[0, 1, 2], [0, 3, 4]]), &[], Border::NoFace);
    assert_eq!(table.half_edges.len(), 12);
    // For the sides 0→1, 1→2, 2→0, 0→3, 3→4, 4→0, the twins form the border: 1, 3, 5, 7, 9, 11.
    for (h, origin, next) in [(1, 1, 11), (11, 0, 9), (9, 4, 7), (7, 3, 5), (5, 0, 3), (3, 2, 1)] {
        half_edge(&mut table, h).origin = Some(origin);
        half_edge(&mut table, h).next = Some(next);
    }
    let table = table.without(Part::Prev);
    // So is an edge without faces.
    let edge = "P 3 prev leaving faces V 2 0 - 1 - H 2 0 1 1 1 - 1 0 0 0 - B 0 F 0 HF 2 - - FH 0".parse().unwrap();
    for table in [table, edge] {
        assert_eq!(first_broken_rule(&table, &OPEN), None);
        assert_eq!(tests(&table), [Test::BorderOk]);
    }
}

/// A stored boundary component is no hole, even if it names no face.
#[test]
fn a_record_without_face_is_no_hole() {
    let mut table = by_record(&textbook_mesh(4, &TETRAHEDRON));
    table.boundaries[0].as_mut().unwrap().face = None;
    table.faces[0] = None;
    assert_eq!(first_broken_rule(&table, &OPEN), Some(Rule::R1));
    assert_eq!(tests(&table), [Test::SurfaceBoundaryOk]);
}

/// Changes single numbers of the certificate of an open mesh: if it passes, the counts are the same, except for values that a
/// whole column determines.
#[test]
fn a_changed_number_is_found_or_is_as_good() {
    let table = opened(&textbook_mesh(9, &torus([3, 3])), &[4, 5, 11], Border::NoTwin);
    let certificate = SurfaceCertificate::new(&table).unwrap();
    let counts = certificate.check().unwrap();
    let (mut found, mut as_good) = (BTreeSet::new(), 0);
    for column in Column::of_surface() {
        for i in 0..certificate.columns().column(*column).len() {
            for value in (0..60).chain([u32::MAX - 1, u32::MAX]) {
                let mut columns = certificate.columns().clone();
                columns.column_mut(*column)[i] = value;
                match SurfaceCertificate::from_columns(columns).unwrap().check() {
                    Ok(others) => {
                        assert_eq!(others, counts, "{} {i} = {value}", column.name());
                        as_good += 1;
                    }
                    Err(failures) => found.extend(failures.iter().map(|failure| failure.test())),
                }
            }
        }
    }
    assert!(as_good > 1000, "{as_good}");
    let of_surfaces = Test::ALL.into_iter().filter(|test| *test >= Test::TurnOk);
    let links = [Test::TwinOk, Test::NextOk, Test::TargetOk, Test::OriginOk, Test::CycleOk];
    assert_eq!(found, links.into_iter().chain(of_surfaces).collect());
}

#[test]
fn columns_of_different_lengths_are_no_certificate() {
    let certificate = SurfaceCertificate::new(&textbook_mesh(4, &TETRAHEDRON)).unwrap();
    for column in Column::of_surface().iter().filter(|column| **column != Column::FaceOuter) {
        let mut columns = certificate.columns().clone();
        columns.column_mut(*column).push(0);
        assert_eq!(SurfaceCertificate::from_columns(columns), None, "{}", column.name());
    }
}

/// The tests that fail once columns of the certificate of a closed mesh are changed.
fn changed(mesh: &Table, change: impl Fn(&mut Labels)) -> Vec<Test> {
    let certificate = SurfaceCertificate::new(&with_boundary_components(mesh)).unwrap();
    assert!(certificate.check().is_ok());
    let mut columns = certificate.columns().clone();
    change(&mut columns);
    let failures = SurfaceCertificate::from_columns(columns).unwrap().check().unwrap_err();
    failures.iter().map(|failure| failure.test()).collect()
}

#[test]
fn each_change_of_columns_that_balances_the_sums_fails_one_test() {
    type Change = fn(&mut Labels);
    let tetrahedron = textbook_mesh(4, &TETRAHEDRON);
    let tori: Vec<_> =
        (0..2).flat_map(|part| torus([3, 3]).into_iter().map(move |triangle| triangle.map(|v| v + 9 * part))).collect();
    let (one, two) = (textbook_mesh(9, &torus([3, 3])), textbook_mesh(18, &tori));
    let cases: [(&str, &Table, Change, Test); 4] = [
        (
            "a face is its own component, which makes one component and one handle too many",
            &one,
            |columns| {
                let boundary = columns.column(Column::HalfEdgeBoundary);
                let apart: Vec<usize> = (0..boundary.len()).filter(|h| boundary[*h] == 1).collect();
                for h in &apart {
                    columns.column_mut(Column::HalfEdgeComponent)[*h] = apart[0] as u32;
                }
            },
            Test::ComponentOk,
        ),
        (
            "two tori are one component, with one handle by the sums",
            &two,
            |columns| {
                let component = columns.column_mut(Column::HalfEdgeComponent);
                let first = component[0];
                component.fill(first);
            },
            Test::ComponentOk,
        ),
        (
            "two holes without half-edges make a torus a sphere",
            &one,
            |columns| {
                columns.column_mut(Column::BoundaryFace).extend([u32::MAX; 2]);
                columns.column_mut(Column::BoundaryStart).extend([0; 2]);
            },
            Test::SurfaceBoundaryOk,
        ),
        (
            "a boundary component is the outer one of two faces",
            &tetrahedron,
            |columns| columns.column_mut(Column::FaceOuter).push(0),
            Test::SurfaceFaceOk,
        ),
    ];
    for (name, mesh, change, test) in cases {
        assert_eq!(changed(mesh, change), [test], "{name}");
    }
}

/// Two spheres with a common vertex have too few rotations for any genus, and with two common vertices as many as for genus 1, but no positions.
#[test]
fn spheres_need_no_positions_and_what_is_no_sphere_does() {
    let two: Vec<_> = (0..2).flat_map(|part| TETRAHEDRON.map(move |triangle| triangle.map(|v| v + 4 * part))).collect();
    let certificate = SurfaceCertificate::new(&with_boundary_components(&textbook_mesh(8, &two))).unwrap();
    for column in [Column::HalfEdgeTurn, Column::HalfEdgeStep] {
        assert!(certificate.columns().column(column).iter().all(|position| *position == 0));
    }
    let counts = certificate.check().unwrap();
    assert_eq!((counts.genus, counts.components), (0, 2));
    let mut columns = certificate.columns().clone();
    let mut failing = |common: u32| {
        for origin in columns.column_mut(Column::HalfEdgeOrigin).iter_mut().filter(|origin| **origin == 4 + common) {
            *origin = common;
        }
        columns.column_mut(Column::VertexLeaving)[4 + common as usize] = u32::MAX;
        let failures = SurfaceCertificate::from_columns(columns.clone()).unwrap().check().unwrap_err();
        failures.iter().map(|failure| failure.test()).collect::<BTreeSet<_>>()
    };
    assert_eq!(failing(0), BTreeSet::from([Test::GenusOk]));
    assert!(failing(1).is_superset(&BTreeSet::from([Test::TurnOk, Test::StepOk])));
}
