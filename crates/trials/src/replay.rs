//! One program, step by step.

use crate::structure::Structure;
use crate::{RawPointers, ReportAudit};
use twinedge::dcel::{Audited, Dcel};
use twinedge::program::panics::catch;
use twinedge::program::{Call, CallOf, Handle, HandleOf, Op, Program, Runner, StepOutcome, Subject};
use twinedge::validate::{Collect, Link, Report, Table, View, validate};

/// One executed operator of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// The operator.
    pub op: Op,
    /// The chosen arguments, by their indices before the step; `None` for a stale handle, and as a whole if there were none.
    pub call: Option<Call<Link, Link, Link>>,
    /// Its outcome; the message if it panicked. No step follows a panic.
    pub outcome: Result<After, String>,
}

/// The structure after a step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct After {
    /// True if the operator was applied.
    pub outcome: StepOutcome,
    /// The report of the validator.
    pub report: Report,
    /// All records; `None` without enough memory for them.
    pub table: Option<Table>,
}

/// Runs a program on a structure, and returns the outcome of each operator and the structure after it. Stops at the first panic.
///
/// O(n) for each step in addition to the operator, for n records.
///
/// ```
/// use twinedge::dcel::Dcel;
/// use twinedge::program::{Program, StepOutcome};
/// use twinedge::validate::Expectation;
/// use twinedge_trials::{Structure, replay};
/// let mine = Structure::new("mine", Dcel::new, Expectation::plane());
/// let program: Program = "twinedge program 1\nadd_isolated_vertex unbounded\nremove_edge h0\n".parse()?;
/// let steps = replay(&mine, &program);
/// assert_eq!(steps[0].outcome.as_ref().unwrap().report.counts().vertices, 1);
/// assert_eq!(steps[1].outcome.as_ref().unwrap().outcome, StepOutcome::Skipped);
/// # Ok::<(), twinedge::program::ParseError>(())
/// ```
#[must_use]
pub fn replay<K: Indexed>(structure: &Structure<K>, program: &Program) -> Vec<Step> {
    let mut steps = Vec::new();
    let mut runner = match catch(|| Runner::new(structure.make())) {
        Ok(runner) => runner,
        Err(panic) => {
            let first = program.0.first().map(|op| Step { op: *op, call: None, outcome: Err(panic) });
            return first.into_iter().collect();
        }
    };
    for op in program.0.iter().copied() {
        let call = catch(|| runner.resolve(op).ok().map(|call| by_index(runner.subject(), call)));
        let outcome = catch(|| {
            let outcome = runner.step(op);
            let report = validate(runner.subject(), &structure.expectation(), Collect::All);
            After { outcome, report, table: Table::copy_of(runner.subject()) }
        });
        let is_last = outcome.is_err();
        steps.push(Step { op, call: call.ok().flatten(), outcome });
        if is_last {
            break;
        }
    }
    steps
}

fn by_index<K: Indexed>(subject: &K, call: CallOf<K>) -> Call<Link, Link, Link> {
    let index = |handle| subject.index(handle);
    call.map(|v| index(Handle::Vertex(v)), |h| index(Handle::HalfEdge(h)), |f| index(Handle::Face(f)))
}

/// A structure with a [`View`] index for each handle.
pub trait Indexed: Subject {
    /// Returns the index of a record; `None` for a stale handle.
    fn index(&self, handle: HandleOf<Self>) -> Option<usize>;
}

impl Indexed for Dcel {
    fn index(&self, handle: HandleOf<Self>) -> Option<usize> {
        match handle {
            Handle::Vertex(vertex) => self.vertex(vertex).ok().map(|v| v.index()),
            Handle::HalfEdge(half_edge) => self.half_edge(half_edge).ok().map(|h| h.index()),
            Handle::Face(face) => self.face(face).ok().map(|f| f.index()),
        }
    }
}

impl Indexed for ReportAudit {
    fn index(&self, handle: HandleOf<Self>) -> Option<usize> {
        self.dcel().index(handle)
    }
}

impl Indexed for Audited {
    fn index(&self, handle: HandleOf<Self>) -> Option<usize> {
        self.get().index(handle)
    }
}

impl Indexed for RawPointers {
    fn index(&self, handle: HandleOf<Self>) -> Option<usize> {
        match handle {
            Handle::Vertex(vertex) => self.is_vertex(vertex).then_some(vertex),
            Handle::HalfEdge(half_edge) => self.is_half_edge(half_edge).then_some(half_edge),
            Handle::Face(face) => self.is_face(face).then_some(face),
        }
    }
}
