//! A `Dcel` with a history as a subject, whose changes are undone and redone.

use crate::replay::Indexed;
use std::collections::VecDeque;
use twinedge::dcel::{Dcel, FaceKey, HalfEdgeKey, History, OperatorError, Split, VertexKey};
use twinedge::program::{CallOf, HandleOf, Refusal, Subject};
use twinedge::validate::near::{Baseline, validate_near};
use twinedge::validate::{Expectation, View};
use twinedge::{delegate_subject, delegate_view};

/// The largest number of changes to undo.
const LONGEST: usize = 12;

/// A [`History`] as a subject: after each operator, some changes are undone and redone, and compared with earlier copies.
///
/// After each of these steps the written records are validated. At the end of each way back, a change fails on purpose: nothing
/// of it remains, undone changes can be redone, and its keys never name anything.
///
/// In addition to the operator, each step costs O(n) for n records, several times.
///
/// # Panics
/// The operators panic if the structure differs from the copy, a rule is broken, or a key names something else.
///
/// ```
/// use twinedge::program::{Program, conformance};
/// use twinedge::validate::Expectation;
/// use twinedge_trials::Rewound;
///
/// let program = Program::from_bytes(b"some bytes that came from a fuzzer");
/// conformance::run(&program, Rewound::default(), &Expectation::plane())?;
/// # Ok::<(), conformance::Failure>(())
/// ```
#[derive(Clone, Debug)]
pub struct Rewound {
    history: History,
    baseline: Baseline,
    /// The structure after each of the last changes, the latest last.
    copies: VecDeque<Dcel>,
    steps: u32,
    /// The keys from failed changes.
    lost: VecDeque<(VertexKey, HalfEdgeKey, FaceKey)>,
}

impl Default for Rewound {
    fn default() -> Self {
        Self::new(Dcel::new())
    }
}

impl Rewound {
    /// Starts with a structure. O(n).
    ///
    /// # Panics
    /// Panics for an invalid structure.
    #[must_use]
    pub fn new(dcel: Dcel) -> Self {
        let baseline = Baseline::new(&dcel, &Expectation::plane()).unwrap_or_else(|error| panic!("{error}"));
        let copies = VecDeque::from([dcel.clone()]);
        Self { history: History::new(dcel), baseline, copies, steps: 0, lost: VecDeque::new() }
    }

    const fn dcel(&self) -> &Dcel {
        self.history.get()
    }

    /// Compares the structure with a copy, and validates the written records.
    fn check(&mut self, back: usize, what: &str) {
        let dcel = self.history.get();
        let copy = &self.copies[self.copies.len() - 1 - back];
        assert!(dcel == copy, "{what}, {back} changes back: the structure is not what it was");
        let written = self.history.written();
        if let Err(report) = validate_near(&mut self.baseline, dcel, &written) {
            panic!("{what}, {back} changes back: {report}");
        }
        for (v, h, f) in &self.lost {
            let names = dcel.vertex(*v).is_ok() || dcel.half_edge(*h).is_ok() || dcel.face(*f).is_ok();
            assert!(!names, "{what}: a key of a change that was taken back names something");
        }
    }

    fn fail(&mut self, back: usize) {
        let mut keys = None;
        let refused = self.history.change("fail", |dcel| {
            let vertex = dcel.add_isolated_vertex(dcel.unbounded_face().key())?.vertex;
            let connected = dcel.connect(vertex, vertex, Split::default())?;
            keys = connected.new_face().map(|face| (vertex, connected.half_edge, face));
            dcel.remove_isolated_vertex(vertex)
        });
        assert!(matches!(refused, Err(OperatorError::NotIsolated(_))), "{refused:?}");
        self.lost.extend(keys);
        if self.lost.len() > LONGEST {
            self.lost.pop_front();
        }
        self.check(back, "after a change that failed");
    }

    fn run<T>(&mut self, operator: impl FnOnce(&mut Dcel) -> Result<T, Refusal>) -> Result<T, Refusal> {
        let answer = self.history.change("operator", operator);
        let written = self.history.written();
        if answer.is_err() || written.is_empty() {
            assert!(written.is_empty(), "what is refused writes something");
            self.check(0, "after an operator that changes nothing");
            return answer;
        }
        self.copies.push_back(self.history.get().clone());
        if self.copies.len() > LONGEST + 1 {
            self.copies.pop_front();
        }
        self.check(0, "after an operator");
        self.steps += 1;
        // Most ways back are short.
        let far = (2 * self.steps.trailing_zeros() as usize + 1).min(self.copies.len() - 1);
        let mark = self.history.mark();
        for back in 1..=far {
            assert!(self.history.undo(), "there is a change to undo");
            self.check(back, "undone");
        }
        assert!(!self.history.undo_to(mark), "what is undone is not on the way back");
        self.fail(far);
        let middle = self.history.mark();
        for back in (0..far).rev() {
            assert!(self.history.redo(), "there is a change to redo");
            self.check(back, "redone");
        }
        assert!(!self.history.redo(), "all changes are redone");
        assert!(self.history.undo_to(middle), "the state is on the way back");
        self.check(far, "undone at once");
        while self.history.redo() {}
        self.baseline = Baseline::new(self.history.get(), &Expectation::plane()).unwrap_or_else(|e| panic!("{e}"));
        assert!(self.dcel() == self.copies.back().unwrap_or(self.dcel()), "redone at once");
        answer
    }
}

impl View for Rewound {
    delegate_view!(|this| this.dcel());
}

impl Subject for Rewound {
    delegate_subject!(Dcel, |this| this.dcel());

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        self.run(|dcel| dcel.apply(call))
    }
}

impl Indexed for Rewound {
    fn index(&self, handle: HandleOf<Self>) -> Option<usize> {
        self.dcel().index(handle)
    }
}
