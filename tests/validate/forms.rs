//! Small maps in every form are valid.

use crate::support::erased::{first_broken_rule, validate};
use twinedge::validate::{Collect, Expectation, FaceRow, Part, Table};
use twinedge_trials::census::{Census, Scope};
use twinedge_trials::forms::{forms, projections};

#[test]
fn there_are_112_forms() {
    let all = forms();
    // The parts of the faces: none, or three ways to store boundary components, times three to store holes and the
    // unbounded face; surfaces have neither. Then prev and leaving, and open boundaries.
    let of_the_plane = 2 * 4 * (1 + 3 * 3);
    let of_surfaces = 2 * 4 * (1 + 3);
    assert_eq!(all.len(), of_the_plane + of_surfaces);
    assert_eq!(all.len(), 112);
    for (i, one) in all.iter().enumerate() {
        assert!(!all[..i].contains(one), "{one:?} is there twice");
    }
    let surfaces = all.iter().filter(|one| one.expectation.surface_kind() == Expectation::surface().surface_kind());
    assert_eq!(surfaces.count(), of_surfaces);
}

/// Both validators accept every projection of every small map.
#[test]
fn every_projection_of_a_small_map_is_right() {
    let mut opened = [0; 2];
    for map in Census::new(Scope::Subdivisions { edges: 3, vertices: 3 }) {
        let table = Table::copy_of(map.runner.subject()).unwrap();
        for form in forms() {
            let all = projections(&table, &form);
            opened[usize::from(form.expectation.is_open())] += all.len() - 1;
            for projection in all {
                let broken = first_broken_rule(&projection, &form.expectation);
                assert_eq!(broken, None, "{table}\n{projection}\n{form:?}");
                let report = validate(&projection, &form.expectation, Collect::First);
                assert!(report.is_valid(), "{table}\n{projection}\n{form:?}\n{report}");
            }
        }
    }
    assert!(opened[0] == 0 && opened[1] > 10_000, "{opened:?}");
}

/// A part missing in a form is nil, so a validator that reads it would fail.
#[test]
fn what_is_left_out_is_nil() {
    for map in Census::new(Scope::Subdivisions { edges: 2, vertices: 3 }) {
        let table = Table::copy_of(map.runner.subject()).unwrap();
        for form in forms() {
            for projection in projections(&table, &form) {
                let lacks = |part| !form.parts.has(part);
                assert_eq!(projection.parts, form.parts);
                let half_edges = || projection.half_edges.iter().flatten();
                let vertices = || projection.vertices.iter().flatten();
                assert!(!lacks(Part::Prev) || half_edges().all(|row| row.prev.is_none()));
                assert!(!lacks(Part::Leaving) || vertices().all(|row| row.leaving.is_none()));
                assert!(!lacks(Part::Faces) || half_edges().all(|row| row.face.is_none()));
                assert!(!lacks(Part::BoundaryComponents) || half_edges().all(|row| row.boundary.is_none()));
                assert!(!lacks(Part::BoundaryComponents) || projection.boundaries.iter().flatten().count() == 0);
                assert!(!lacks(Part::Places) || projection.boundaries.iter().flatten().all(|row| row.place.is_none()));
                let faces = || projection.faces.iter().flatten();
                assert!(!lacks(Part::Faces) || faces().count() == 0);
                assert!(!lacks(Part::Holes) || faces().all(|row| row.inner.is_empty() && row.inner_starts.is_empty()));
                let bounded = |row: &FaceRow| row.outer.is_some() || row.outer_half_edge.is_some();
                assert!(!lacks(Part::UnboundedFace) || faces().all(bounded));
            }
        }
    }
}
