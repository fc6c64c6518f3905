//! A structure with limits only differs from an unlimited one by refusing records that do not fit, without a trace, for each
//! kind of record.

use crate::support::erased::validate_plane;
use crate::support::programs::check;
use twinedge::dcel::{Dcel, HalfEdgeKey, OperatorError, RecordKind, Room, Side, Split};
use twinedge::program::{Program, Refusal, Runner, StepOutcome};
use twinedge::validate::Table;

/// An empty structure limited to these numbers of vertices, edges, boundary components and faces.
fn limited([vertices, edges, boundaries, faces]: [usize; 4]) -> Dcel {
    Dcel::with_limits(Room { vertices, edges, boundaries, faces })
}

/// Puts an edge with two vertices in the unbounded face. Takes only one boundary component.
fn an_edge(dcel: &mut Dcel) -> HalfEdgeKey {
    let v = dcel.add_isolated_vertex(dcel.unbounded_face().key()).unwrap().vertex;
    dcel.split_vertex(v, v).unwrap().half_edge
}

/// V, E, boundary components, F.
fn counts(dcel: &Dcel) -> [usize; 4] {
    [dcel.vertex_count(), dcel.edge_count(), dcel.boundary_count(), dcel.face_count()]
}

/// The same operators make the same rows, step by step, and what is refused for want of room exceeds the limits.
#[test]
fn what_does_not_fit_is_refused_without_a_trace_and_what_fits_is_not() {
    fn law(program: Program) {
        let most = [3, 4, 4, 3];
        let (mut free, mut limited) = (Runner::new(Dcel::new()), Runner::new(limited(most)));
        for (i, op) in program.0.into_iter().enumerate() {
            let before = Table::copy_of(limited.subject());
            let outcome = limited.step(op);
            if outcome == StepOutcome::Refused(Refusal::Full) {
                assert_eq!(Table::copy_of(limited.subject()), before, "{op}");
                assert!(counts(limited.subject()).iter().zip(most).any(|(count, most)| *count == most), "{op}");
                // Arguments may be wrong too.
                let mut more = free.clone();
                if more.step(op) == StepOutcome::Applied {
                    assert!(counts(more.subject()).iter().zip(most).any(|(count, most)| *count > most), "{op}");
                }
                continue;
            }
            assert_eq!(outcome, free.step(op), "{op}");
            assert_eq!(Table::copy_of(limited.subject()), Table::copy_of(free.subject()), "{op}");
            assert!(validate_plane(limited.subject()).is_valid(), "{op}");
            if i % 16 == 15 {
                limited = limited.clone();
            }
        }
    }
    check(1000, 100, law as fn(Program));
}

fn refused<T: std::fmt::Debug + PartialEq>(
    dcel: &mut Dcel,
    kind: RecordKind,
    operator: impl FnOnce(&mut Dcel) -> Result<T, OperatorError>,
) {
    let before = Table::copy_of(dcel);
    assert_eq!(operator(dcel), Err(OperatorError::Full(kind)));
    assert_eq!(Table::copy_of(dcel), before);
    assert!(validate_plane(&*dcel).is_valid());
}

#[test]
fn full_of_vertices() {
    let mut dcel = limited([2, 9, 9, 9]);
    let h = an_edge(&mut dcel);
    let outside = dcel.unbounded_face().key();
    refused(&mut dcel, RecordKind::Vertex, |dcel| dcel.add_isolated_vertex(outside));
    refused(&mut dcel, RecordKind::Vertex, |dcel| dcel.split_edge(h));
    refused(&mut dcel, RecordKind::Vertex, |dcel| dcel.split_vertex(h, h));
    let kept = dcel.contract_edge(h).unwrap().kept;
    assert!(dcel.split_vertex(kept, kept).is_ok());
}

#[test]
fn full_of_edges() {
    let mut dcel = limited([9, 1, 9, 9]);
    let h = an_edge(&mut dcel);
    let v = dcel.add_isolated_vertex(dcel.unbounded_face().key()).unwrap().vertex;
    refused(&mut dcel, RecordKind::Edge, |dcel| dcel.connect(h, v, Split::default()));
    refused(&mut dcel, RecordKind::Edge, |dcel| dcel.connect(h, h, Split::default()));
    refused(&mut dcel, RecordKind::Edge, |dcel| dcel.split_edge(h));
    refused(&mut dcel, RecordKind::Edge, |dcel| dcel.split_vertex(v, v));
    dcel.remove_edge(h).unwrap();
    assert!(dcel.split_vertex(v, v).is_ok());
}

#[test]
fn full_of_boundary_components() {
    let mut dcel = limited([9, 9, 1, 9]);
    let h = an_edge(&mut dcel);
    let outside = dcel.unbounded_face().key();
    refused(&mut dcel, RecordKind::Boundary, |dcel| dcel.add_isolated_vertex(outside));
    refused(&mut dcel, RecordKind::Boundary, |dcel| dcel.connect(h, h, Split::default()));
    refused(&mut dcel, RecordKind::Boundary, |dcel| dcel.remove_edge(h));
    let kept = dcel.contract_edge(h).unwrap().kept;
    dcel.remove_isolated_vertex(kept).unwrap();
    assert!(dcel.add_isolated_vertex(outside).is_ok());
}

#[test]
fn full_of_faces() {
    let mut dcel = limited([9, 9, 9, 1]);
    let h = an_edge(&mut dcel);
    refused(&mut dcel, RecordKind::Face, |dcel| dcel.connect(h, h, Split::default()));
    let mut dcel = limited([9, 9, 9, 2]);
    let h = an_edge(&mut dcel);
    let n = dcel.connect(h, h, Split::default()).unwrap().half_edge;
    refused(&mut dcel, RecordKind::Face, |dcel| dcel.connect(h, h, Split::default()));
    dcel.remove_edge(n).unwrap();
    assert!(dcel.connect(h, h, Split::default()).is_ok());
}

#[test]
fn a_structure_holds_as_many_records_as_its_limits_say() {
    let mut dcel = limited([255, 127, 255, 255]);
    let outside = dcel.unbounded_face().key();
    let vertices: Vec<_> = (0..255).map(|_| dcel.add_isolated_vertex(outside).unwrap().vertex).collect();
    refused(&mut dcel, RecordKind::Vertex, |dcel| dcel.add_isolated_vertex(outside));
    let first = dcel.connect(vertices[0], vertices[1], Split::default()).unwrap().half_edge;
    for v in &vertices[2..128] {
        dcel.connect(first, *v, Split::default()).unwrap();
    }
    assert_eq!((dcel.vertex_count(), dcel.edge_count(), dcel.boundary_count()), (255, 127, 128));
    refused(&mut dcel, RecordKind::Edge, |dcel| dcel.connect(first, vertices[200], Split::default()));
    assert_eq!(dcel.vertex(vertices[0]).unwrap().degree(), 127);

    let mut dcel = limited([255, 127, 255, 128]);
    let v = dcel.add_isolated_vertex(dcel.unbounded_face().key()).unwrap().vertex;
    let first = dcel.connect(v, v, Split::default()).unwrap().half_edge;
    for _ in 1..127 {
        dcel.connect(first, first, Split { new_face: Side::Right, inner: &[] }).unwrap();
    }
    assert_eq!((dcel.edge_count(), dcel.face_count(), dcel.boundary_count()), (127, 128, 128));
    assert!(validate_plane(&dcel).is_valid());
}

#[test]
fn compacting_and_cloning_keep_the_limits() {
    let mut dcel = limited([2, 1, 2, 1]);
    let h = an_edge(&mut dcel);
    dcel.contract_edge(h).unwrap();
    dcel.compact();
    for mut dcel in [dcel.clone(), dcel] {
        let outside = dcel.unbounded_face().key();
        dcel.add_isolated_vertex(outside).unwrap();
        refused(&mut dcel, RecordKind::Vertex, |dcel| dcel.add_isolated_vertex(outside));
    }
}

/// The unbounded face always has room.
#[test]
fn a_limit_of_no_faces_is_one_of_one() {
    let mut dcel = limited([2, 1, 1, 0]);
    let h = an_edge(&mut dcel);
    assert_eq!((dcel.edge_count(), dcel.face_count()), (1, 1));
    refused(&mut dcel, RecordKind::Vertex, |dcel| dcel.split_edge(h));
}
