//! The pointer model owns each record once, and its cyclic links keep nothing alive.

use quickcheck::{Gen, QuickCheck};
use std::rc::Weak;
use twinedge::program::{Call, Handle, PointerModel, Program, Runner, Subject};
use twinedge::validate::View;

/// Returns the number of links from record to record, as the structure itself reports them.
fn links(pointers: &PointerModel) -> usize {
    let half_edges = pointers.half_edge_slots();
    let isolated = (0..pointers.vertex_slots()).filter(|v| pointers.isolated(*v).is_some()).count();
    let listed: usize =
        (0..pointers.face_slots()).map(|f| pointers.inner_count(f) + usize::from(pointers.outer(f).is_some())).sum();
    // Half-edges: origin, twin, next, prev, face, boundary component. Vertices: leaving, or isolated and the face.
    // Boundary components: face and start. Faces: their lists.
    6 * half_edges + pointers.vertex_slots() + isolated + 2 * pointers.boundary_slots() + listed
}

#[allow(clippy::needless_pass_by_value, reason = "what quickcheck hands over")]
fn records_are_freed(program: Program) -> bool {
    let mut runner = Runner::new(PointerModel::new());
    for op in &program.0 {
        let before = runner.subject().records();
        runner.step(*op);
        let now = runner.subject().records();
        // Each record is owned only by its list.
        if now.iter().any(|record| record.strong_count() != 1) {
            return false;
        }
        // Links lead to existing records, and each record has the number of links that it reports.
        let watched: usize = before.iter().filter(|record| record.strong_count() > 0).count() + now.len();
        if now.iter().map(Weak::weak_count).sum::<usize>() != watched + links(runner.subject()) {
            return false;
        }
        // Removed records are freed: of the earlier records, only current ones remain.
        let remain = before.iter().filter(|old| old.strong_count() > 0);
        if !remain.clone().all(|old| now.iter().any(|new| old.ptr_eq(new))) {
            return false;
        }
    }
    let watched = runner.subject().records();
    let pointers = runner.into_subject();
    let faces = pointers.face_slots();
    drop(pointers);
    faces >= 1 && watched.iter().all(|record| record.strong_count() == 0 && record.weak_count() == 0)
}

#[test]
fn every_record_is_freed_when_it_is_removed_and_all_when_the_structure_is_dropped() {
    let generator = Gen::from_size_and_seed(100, 3);
    QuickCheck::new().rng(generator).tests(1000).quickcheck(records_are_freed as fn(Program) -> bool);
}

#[test]
fn a_record_that_is_removed_is_freed_at_once() {
    let mut pointers = PointerModel::new();
    let face = pointers.unbounded_face().unwrap();
    let empty = pointers.records();
    let given = pointers.apply(Call::AddIsolatedVertex { face }).unwrap();
    let Some(Handle::Vertex(vertex)) = given else { panic!("it gives {given:?}") };
    let with_vertex = pointers.records();
    pointers.apply(Call::RemoveIsolatedVertex { vertex }).unwrap();
    let alive = with_vertex.iter().filter(|record| record.strong_count() > 0).count();
    assert_eq!((empty.len(), with_vertex.len(), alive), (1, 3, 1));
}
