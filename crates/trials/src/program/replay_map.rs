//! `twinedge-trials replay --map`: a journal of edits of a map, step by step.

use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Failure, Format, Verdict, counted};
use serde::{Deserialize, Serialize};
use std::fmt;
use twinedge::program::ParseError;
use twinedge_map::PlanarMap;
use twinedge_map::edit::Edited;
use twinedge_map::program::{EditFailure, EditOp, EditOutcome, EditProgram, EditRunner};

/// The journal in JSON: the output of `--format json`. Only the edits are read.
#[derive(Deserialize)]
struct Journal {
    steps: Vec<Entry>,
}

#[derive(Deserialize)]
struct Entry {
    op: String,
}

#[derive(Debug, Serialize)]
struct Outcome {
    steps: Vec<Step>,
    vertices: usize,
    edges: usize,
    faces: usize,
    features: usize,
    ok: bool,
}

#[derive(Debug, Serialize)]
struct Step {
    op: String,
    /// `done`, `refused`, `skipped` or `not valid`.
    outcome: &'static str,
    /// The reason for the refusal, or the violation after the edit.
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
    vertices_made: usize,
    vertices_dropped: usize,
    edges_made: usize,
    edges_split: usize,
    edges_dropped: usize,
    faces_split: usize,
    faces_merged: usize,
}

/// Reads a journal: the text of a program of edits, or JSON.
fn read(text: &str) -> Result<EditProgram, Failure> {
    if !text.trim_start().starts_with('{') {
        return Ok(text.parse()?);
    }
    let journal: Journal = serde_json::from_str(text)?;
    let edits = journal.steps.iter().enumerate().map(|(i, Entry { op })| {
        let program: EditProgram = format!("twinedge edits 1\n{op}")
            .parse()
            .map_err(|error: ParseError| Failure(format!("step {}: `{op}`: expected {}", i + 1, error.expected)))?;
        Ok(program.0)
    });
    let edits: Vec<Vec<EditOp>> = edits.collect::<Result<_, Failure>>()?;
    Ok(EditProgram(edits.into_iter().flatten().collect()))
}

/// Replays the journal on an empty map.
pub(crate) fn run(text: &str, format: Format) -> Result<Verdict, Failure> {
    let program = read(text)?;
    let mut runner = EditRunner::audited(PlanarMap::new())?;
    let mut steps = Vec::new();
    for op in &program.0 {
        let step = match runner.check_numbers(op) {
            Ok(()) => Step::new(op, runner.step_checked(op)),
            Err(past) => Step { error: Some(past.to_string()), ..Step::new(op, Ok(EditOutcome::Skipped)) },
        };
        let is_valid = step.outcome != NOT_VALID;
        steps.push(step);
        if !is_valid {
            break;
        }
    }
    let map = runner.into_map();
    let dcel = map.dcel();
    let outcome = Outcome {
        ok: steps.iter().all(|step| step.outcome == DONE),
        steps,
        vertices: dcel.vertex_count(),
        edges: dcel.edge_count(),
        faces: dcel.face_count(),
        features: map.features().count(),
    };
    format.print(&outcome)?;
    Ok(Verdict::of(outcome.ok))
}

const DONE: &str = "done";
const NOT_VALID: &str = "not valid";

impl Step {
    fn new(op: &EditOp, outcome: Result<EditOutcome, EditFailure>) -> Self {
        let mut edited = Edited::default();
        let (outcome, error) = match outcome {
            Ok(EditOutcome::Applied(done)) => {
                edited = done;
                (DONE, None)
            }
            Ok(EditOutcome::Refused(error)) => ("refused", Some(error.to_string())),
            Ok(EditOutcome::Skipped) => ("skipped", Some("there is nothing to choose from".to_owned())),
            Err(failure) => (NOT_VALID, Some(failure.to_string())),
        };
        Self {
            op: op.to_string(),
            outcome,
            error,
            vertices_made: edited.vertices_made.len(),
            vertices_dropped: edited.vertices_dropped.len(),
            edges_made: edited.edges_made.len(),
            edges_split: edited.edges_split.len(),
            edges_dropped: edited.edges_dropped.len(),
            faces_split: edited.faces_split.len(),
            faces_merged: edited.faces_merged.len(),
        }
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, step) in self.steps.iter().enumerate() {
            write!(f, "{}. {}: ", i + 1, step.op)?;
            match &step.error {
                None => writeln!(f, "{}", step.outcome)?,
                Some(error) => writeln!(f, "{BAD}{}{BAD:#}: {error}", step.outcome)?,
            }
            let counts = [
                ("vertices made", step.vertices_made),
                ("vertices dropped", step.vertices_dropped),
                ("edges made", step.edges_made),
                ("edges split", step.edges_split),
                ("edges dropped", step.edges_dropped),
                ("faces split", step.faces_split),
                ("faces merged", step.faces_merged),
            ];
            let told: Vec<_> = counts.iter().filter(|(_, n)| *n > 0).map(|(what, n)| format!("{what} {n}")).collect();
            if !told.is_empty() {
                writeln!(f, "{QUIET}   {}{QUIET:#}", told.join(", "))?;
            }
        }
        let Self { vertices, edges, faces, features, .. } = self;
        let failed = self.steps.iter().filter(|step| step.outcome != DONE).count();
        let (style, verdict) = if failed == 0 {
            (GOOD, "each edit was done".to_owned())
        } else {
            (BAD, format!("{failed} of {} edits were not done", self.steps.len()))
        };
        let counts = [(*vertices, "vertex"), (*edges, "edge"), (*faces, "face"), (*features, "feature")];
        writeln!(f, "{style}{verdict}{style:#}: {}", counts.map(|(n, name)| counted(n, name)).join(", "))
    }
}
