//! Undoing and redoing edits: links, keys, positions, features, and located records.

use crate::rewound::{Rewound, change};
use crate::support::edits::EvenEdits;
use crate::support::programs::check;
use twinedge::dcel::History;
use twinedge_geometry::Point;
use twinedge_map::edit::EditError;
use twinedge_map::program::{EditOutcome, EditProgram, EditRunner};
use twinedge_map::{Builder, Located, PlanarMap, Shape};

#[test]
fn edits_are_undone_and_redone_in_step_with_copies() {
    fn law(program: EditProgram) {
        let mut rewound = Rewound::new(PlanarMap::new());
        // The index exists from the start.
        let _ = rewound.map().locate(Point::new(0.5, 0.5));
        for op in &program.0 {
            rewound.step(op, |map| {
                let p = Point::new(0.75, 0.5);
                let saved = serde_json::to_string(map).unwrap();
                let anew: PlanarMap = serde_json::from_str(&saved).unwrap();
                let [found, searched] = [map.locate(p), anew.locate(p)];
                assert_eq!(found.map(place), searched.map(place));
            });
        }
    }
    check(40, 50, law as fn(EditProgram));
}

/// A location, without the side of an edge.
fn place(located: Located) -> Option<Located> {
    Some(located).filter(|located| !matches!(located, Located::Edge(_)))
}

#[test]
fn a_program_undone_and_redone_gives_the_bytes_of_the_program() {
    fn law(EvenEdits(program): EvenEdits) {
        let empty = PlanarMap::new();
        // A clone issues the same keys as the original.
        let mut plain = empty.clone();
        let mut history = History::new(empty);
        let (mut applied, mut states) = (0, vec![serde_json::to_string(&plain).unwrap()]);
        for op in &program.0 {
            let mut runner = EditRunner::new(plain.clone());
            let outcome = runner.step(op);
            assert_eq!(outcome, change(&mut history, op));
            if matches!(outcome, EditOutcome::Applied(_)) {
                plain = runner.into_map();
                let now = serde_json::to_string(&plain).unwrap();
                if states.last() != Some(&now) {
                    states.push(now);
                }
                applied += 1;
            }
        }
        assert!(states.len() <= applied + 1);
        let walk = |history: &mut History<PlanarMap>, step: fn(&mut History<PlanarMap>) -> bool| {
            let mut passed = vec![serde_json::to_string(history.get()).unwrap()];
            while step(history) {
                passed.push(serde_json::to_string(history.get()).unwrap());
            }
            passed.dedup();
            passed
        };
        let mut back = walk(&mut history, History::undo);
        back.reverse();
        assert!(back == states, "{program}");
        assert!(walk(&mut history, History::redo) == states, "{program}");
    }
    check(60, 40, law as fn(EvenEdits));
}

#[test]
fn features_their_names_and_the_summary_are_what_they_were() {
    let mut builder = Builder::new();
    builder.shape(&Shape::polygon([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])).unwrap();
    let mut history = History::new(builder.build().unwrap());
    let (before, summary) = (history.get().clone(), format!("{:?}", history.get().summary()));
    let face = before.dcel().faces().find(|f| !f.is_unbounded()).unwrap().key();
    let garden = history
        .change("plant a garden", |map| {
            let garden = map.add_feature(Some("garden".into()));
            map.set_features_of(face, [garden])?;
            let h = map.dcel().half_edges().next().map(|h| h.key());
            h.map_or(Ok(()), |h| map.set_features_along(h, [garden]))?;
            Ok::<_, EditError>(garden)
        })
        .unwrap();
    let planted = history.get().clone();
    assert!(history.undo());
    assert_eq!(*history.get(), before);
    assert_eq!((history.get().features().count(), history.get().name(garden)), (1, None));
    assert!(history.redo());
    assert_eq!(*history.get(), planted);
    assert_eq!(history.get().name(garden), Some("garden"));
    assert!(history.get().features_of(face).unwrap().eq([garden]));
    assert_eq!(format!("{:?}", history.get().summary()), summary);
}

#[test]
fn another_map_begins_another_history() {
    let mut history = History::new(PlanarMap::new());
    history.change("point", |map| map.insert_point([0.0, 0.0])).unwrap();
    let mut other = PlanarMap::new();
    other.insert_point([1.0, 1.0]).unwrap();
    let replaced: Result<(), ()> = history.change("replace", |map| {
        *map = other;
        Ok(())
    });
    assert!(replaced.is_ok());
    assert!(!history.undo());
    history.change("point", |map| map.insert_point([2.0, 2.0])).unwrap();
    assert!(history.undo() && !history.undo());
    assert_eq!(history.get().dcel().vertex_count(), 1);
    // A clone continues separately.
    assert!(history.redo());
    let mut clone = history.clone();
    clone.change("point", |map| map.insert_point([3.0, 3.0])).unwrap();
    assert!(clone.undo() && clone.undo() && !clone.undo());
    assert!(history.undo() && !history.undo());
    assert_eq!(clone.get(), history.get());
    // Taken out of the history, the map keeps no log.
    let mut map = history.into_inner();
    map.insert_point([5.0, 5.0]).unwrap();
    assert!(map.validate().is_valid());
}
