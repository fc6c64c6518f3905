//! A map whose edits are undone and redone, in step with copies kept at the time.

use std::collections::VecDeque;
use std::mem;
use twinedge::dcel::History;
use twinedge::validate::Expectation;
use twinedge_map::PlanarMap;
use twinedge_map::near::{EmbeddingBaseline, validate_embedding_near};
use twinedge_map::program::{EditOp, EditOutcome, EditRunner};

/// The longest way back.
const LONGEST: usize = 8;

pub(crate) struct Rewound {
    history: History<PlanarMap>,
    baseline: EmbeddingBaseline,
    /// The map after each of the last changes, the latest last.
    copies: VecDeque<PlanarMap>,
    steps: u32,
}

/// Runs an edit as a change, which is undone if it is refused.
pub(crate) fn change(history: &mut History<PlanarMap>, op: &EditOp) -> EditOutcome {
    let outcome = history.change(op.to_string(), |map| {
        let mut runner = EditRunner::new(mem::take(map));
        let outcome = runner.step(op);
        *map = runner.into_map();
        if matches!(outcome, EditOutcome::Applied(_)) { Ok(outcome) } else { Err(Box::new(outcome)) }
    });
    outcome.unwrap_or_else(|outcome| *outcome)
}

fn baseline(map: &PlanarMap) -> EmbeddingBaseline {
    EmbeddingBaseline::new(map, &Expectation::plane()).unwrap_or_else(|error| panic!("{error}"))
}

impl Rewound {
    pub(crate) fn new(map: PlanarMap) -> Self {
        let (baseline, copies) = (baseline(&map), VecDeque::from([map.clone()]));
        Self { history: History::new(map), baseline, copies, steps: 0 }
    }

    pub(crate) const fn map(&self) -> &PlanarMap {
        self.history.get()
    }

    /// Compares the map with a copy, and validates all writes.
    fn check(&mut self, back: usize, what: &str, look: &mut impl FnMut(&PlanarMap)) {
        let map = self.history.get();
        let copy = &self.copies[self.copies.len() - 1 - back];
        assert!(map == copy, "{what}, {back} changes back: the map is not what it was");
        if let Err(report) = validate_embedding_near(&mut self.baseline, map, &self.history.written()) {
            panic!("{what}, {back} changes back: {report}");
        }
        look(map);
    }

    /// Runs an edit, undoes some, and redoes them. Calls `look` after each step.
    pub(crate) fn step(&mut self, op: &EditOp, mut look: impl FnMut(&PlanarMap)) -> EditOutcome {
        let before = self.history.mark();
        let outcome = change(&mut self.history, op);
        if self.history.mark() == before {
            self.check(0, "nothing was written", &mut look);
            return outcome;
        }
        self.copies.push_back(self.map().clone());
        if self.copies.len() > LONGEST + 1 {
            self.copies.pop_front();
        }
        self.check(0, "after an edit", &mut look);
        self.steps += 1;
        // Most ways back are short.
        let far = (2 * self.steps.trailing_zeros() as usize + 1).min(self.copies.len() - 1);
        for back in 1..=far {
            assert!(self.history.undo(), "there is a change to undo");
            self.check(back, "undone", &mut look);
        }
        let refused: Result<(), ()> = self.history.change("fail", |map| {
            let _ = map.insert_ring([[-1.0, -1.0], [20.5, -1.0], [20.5, 20.5], [-1.0, 20.5]]);
            let _ = map.insert_segment_snapped([-1.0, 0.0], [16.0, 14.0], twinedge_geometry::noding::Snap::Auto);
            map.add_feature(Some("nobody's".into()));
            Err(())
        });
        assert!(refused.is_err());
        self.check(far, "after a change that failed", &mut look);
        for back in (0..far).rev() {
            assert!(self.history.redo(), "there is a change to redo");
            self.check(back, "redone", &mut look);
        }
        assert!(!self.history.redo(), "all changes are redone");
        outcome
    }
}
