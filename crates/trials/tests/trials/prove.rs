//! `prove`.

use super::incomplete::Partial;
use super::{limited, panics, pointers, slots};
use twinedge::validate::{Expectation, Part};
use twinedge_trials::prove::{ProveResults, ProveWork};
use twinedge_trials::{Outcome, Progress, Run, Structure, StructureError, prove};

fn counts(outcome: &Outcome<ProveResults>) -> Vec<[u64; 5]> {
    let rows = outcome.edges.iter();
    rows.map(|row| [row.rooted, row.sensed, row.plane, row.applications, row.refused]).collect()
}

#[test]
fn the_maps_of_up_to_four_edges_are_as_many_as_published() {
    let outcome = prove(&slots(), ProveWork { edges: 4 }, &Run::default()).unwrap().into_result().unwrap();
    let column = |i: usize| counts(&outcome).iter().map(|row| row[i]).collect::<Vec<_>>();
    // OEIS A000168, A006384 and A103937.
    assert_eq!([column(0), column(1)], [[1, 2, 9, 54, 378], [1, 2, 4, 14, 57]]);
    assert_eq!(column(2), [1, 2, 6, 26, 150]);
    assert!(counts(&outcome).iter().all(|row| row[3] > 0 && row[4] > 0));
    // A000168, A006300 and A006298.
    let by_genus: Vec<_> = outcome.genus.iter().map(|row| row.by_genus.clone()).collect();
    assert_eq!(by_genus, [vec![1], vec![2], vec![9, 1], vec![54, 20], vec![378, 307, 21]]);
    // Two edges on three vertices, or a loop with two more: counted by hand.
    let maps = |edges, vertices| {
        outcome.nested.iter().find(|row| (row.edges, row.vertices) == (edges, vertices)).map(|row| row.maps)
    };
    assert_eq!([maps(0, 3), maps(1, 2), maps(1, 3)], [Some(1), Some(3), Some(4)]);
}

#[test]
fn every_structure_does_the_same() {
    let work = ProveWork { edges: 2 };
    let expected = prove(&slots(), work, &Run::default()).unwrap();
    let model = pointers();
    let roomy = Structure::new("limited", || limited([24, 40, 40, 24]), Expectation::plane());
    for found in [prove(&model, work, &Run::default()).unwrap(), prove(&roomy, work, &Run::default()).unwrap()] {
        assert!(found.is_ok(), "{}: {:?}", found.on, found.reasons());
        assert_eq!(counts(&found), counts(&expected), "{}", found.on);
        assert_eq!(found.nested, expected.nested, "{}", found.on);
    }
}

#[test]
fn a_structure_without_room_falls_short_of_the_counts() {
    // Room for 2 half-edges fewer than the maps of 2 edges have.
    let small = Structure::new("small", || limited([3, 1, 3, 3]), Expectation::plane());
    let outcome = prove(&small, ProveWork { edges: 2 }, &Run::default()).unwrap();
    assert!(outcome.edges[1].is_as_published() && !outcome.edges[2].is_as_published(), "{:?}", outcome.edges);
    let reasons = outcome.into_result().unwrap_err().to_string();
    assert!(reasons.contains("connected maps of 2 edges, rooted: grown "), "{reasons}");
    assert!(reasons.contains(", published 9"), "{reasons}");
}

#[test]
fn a_panic_is_a_finding() {
    let panics = panics();
    let outcome = prove(&panics, ProveWork { edges: 1 }, &Run::default()).unwrap();
    let finding = &outcome.findings[0];
    assert!(finding.message.starts_with("panicked: a planted panic ("), "{finding}");
    assert!(finding.operator.as_ref().unwrap().starts_with("move_inner"), "{finding}");
    // The program ends with the operator at fault.
    assert!(finding.program.trim_end().ends_with(finding.operator.as_deref().unwrap()), "{finding}");
}

#[test]
fn a_structure_whose_maps_cannot_be_told_apart_is_an_error() {
    let less: [(Part, fn() -> Partial); 3] = [
        (Part::Faces, || Partial::without(Part::Faces)),
        (Part::Holes, || Partial::without(Part::Holes)),
        (Part::UnboundedFace, || Partial::without(Part::UnboundedFace)),
    ];
    for (part, make) in less {
        let structure = Structure::new("less", make, Expectation::plane());
        let error = prove(&structure, ProveWork { edges: 0 }, &Run::default()).unwrap_err();
        assert_eq!(error, StructureError::Lacks(part));
        assert!(error.to_string().contains(part.name()), "{error}");
    }
}

/// Stops as soon as a stage with this name begins.
struct StopAt(&'static str, std::sync::atomic::AtomicBool);

impl Progress for StopAt {
    fn begin(&self, stage: &str, _: Option<usize>) {
        if stage.contains(self.0) {
            self.1.store(true, std::sync::atomic::Ordering::Relaxed);
        }
    }

    fn is_stopped(&self) -> bool {
        self.1.load(std::sync::atomic::Ordering::Relaxed)
    }
}

#[test]
fn a_run_stops_when_it_is_told_to() {
    for stage in ["growing connected maps", "operators on all subdivisions", "rotation systems"] {
        let progress = StopAt(stage, false.into());
        let outcome = prove(&slots(), ProveWork { edges: 2 }, &Run::default().progress(&progress)).unwrap();
        assert!(outcome.interrupted && !outcome.is_ok(), "{stage}");
        let is_later = !stage.contains("growing");
        assert_eq!(outcome.edges.iter().all(|row| row.is_as_published()), is_later, "{stage}");
    }
}
