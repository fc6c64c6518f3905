//! Prints the effect of the operators of `Dcel`, a line per call: the operator with its arguments, the table before and the table
//! after. `proofs/coq/compare --operators` reads this and compares it with the proved operators.
//!
//! ```text
//! connect v0 v1 left = h0 ; V 2 - 0 - 1 H 0 B 2 … ; V 2 0 - 1 - H 2 …
//! refused contract_edge h0 ; V 1 0 - H 2 … ; V 1 0 - H 2 …
//! ```
//!
//! A corner is `h3` (of half-edge 3) or `v3` (of the isolated vertex 3), and so are the inner boundary components that
//! move to a new face. After `=` comes the new half-edge, if there is one.
#![allow(clippy::print_stderr, reason = "it is a program")]

use std::collections::{HashSet, VecDeque};
use std::error::Error;
use std::io::{BufWriter, Write};
use twinedge::dcel::{Corner, Dcel, Side, Turn};
use twinedge::dcel::{FaceKey, HalfEdgeKey, VertexKey};
use twinedge::program::{Call, CallOf, Handle, HandleOf, Refusal, Runner, StepOutcome, Subject, try_every_op};
use twinedge::validate::{Table, View};
use twinedge::{delegate_subject, delegate_view};
use twinedge_trials::canonical::Canonizer;
use twinedge_trials::soak::SoakWork;

const USAGE: &str =
    "usage: steps small EDGES VERTICES     every operator with every argument on every small subdivision
       steps random PROGRAMS STEPS SEED  the operators of random programs";

#[derive(Clone, Default)]
struct Recorder {
    dcel: Dcel,
    line: String,
}

impl Recorder {
    fn table(&self) -> String {
        Table::copy_of(&self.dcel).map(|table| table.to_string()).unwrap_or_default()
    }

    fn half_edge(&self, key: HalfEdgeKey) -> String {
        self.dcel.half_edge(key).map_or_else(|_| "stale".to_owned(), |h| format!("h{}", h.index()))
    }

    fn vertex(&self, key: VertexKey) -> String {
        self.dcel.vertex(key).map_or_else(|_| "stale".to_owned(), |v| format!("v{}", v.index()))
    }

    fn face(&self, key: FaceKey) -> String {
        self.dcel.face(key).map_or_else(|_| "stale".to_owned(), |f| format!("f{}", f.index()))
    }

    fn arguments(&self, call: &CallOf<Self>) -> String {
        let word = |corner| match corner {
            Corner::At(h) => h,
            Corner::Isolated(v) => v,
        };
        match call.clone().map(|v| self.vertex(v), |h| self.half_edge(h), |f| self.face(f)) {
            Call::AddIsolatedVertex { face } => face,
            Call::RemoveIsolatedVertex { vertex } => vertex,
            Call::Connect { from, to, new_face, inner } => {
                let side = if new_face == Side::Left { "left" } else { "right" };
                let words = format!("{} {} {side}", word(from), word(to));
                inner.into_iter().fold(words, |words, corner| words + " " + &word(corner))
            }
            Call::SplitVertex { from, to } => format!("{} {}", word(from), word(to)),
            Call::FlipEdge { half_edge, turn } => {
                let way = if turn == Turn::Clockwise { "clockwise" } else { "counter_clockwise" };
                format!("{half_edge} {way}")
            }
            Call::MoveInner { inner, face } => format!("{} {face}", word(inner)),
            Call::RemoveEdge { half_edge }
            | Call::SplitEdge { half_edge }
            | Call::JoinEdges { half_edge }
            | Call::ContractEdge { half_edge }
            | Call::MeshFlipEdge { half_edge }
            | Call::MeshSplitEdge { half_edge }
            | Call::MeshSplitFace { half_edge }
            | Call::MeshCollapseEdge { half_edge } => half_edge,
        }
    }
}

impl View for Recorder {
    delegate_view!(|this| &this.dcel);
}

impl Subject for Recorder {
    delegate_subject!(Dcel, |this| &this.dcel);

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        let before = self.table();
        let words = format!("{} {}", call.kind().name(), self.arguments(&call));
        let given = self.dcel.apply(call);
        let refused = if given.is_ok() { "" } else { "refused " };
        let new = match given {
            Ok(Some(Handle::HalfEdge(h))) => format!(" = {}", self.half_edge(h)),
            _ => String::new(),
        };
        self.line = format!("{refused}{words}{new} ; {before} ; {}", self.table());
        given
    }
}

/// Returns true if the record is comparable with the proved operator, which has no keys: a call without stale keys.
fn comparable(outcome: StepOutcome, recorder: &Recorder) -> bool {
    outcome != StepOutcome::Skipped && !recorder.line.contains("stale")
}

/// Tries every operator with every argument on every subdivision up to a size, starting with the empty one.
fn small(edges: usize, vertices: usize, out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    let mut canonizer = Canonizer::new();
    let first = Runner::new(Recorder::default());
    let mut met: HashSet<_> = canonizer.subdivision(first.subject()).into_iter().collect();
    let mut waiting = VecDeque::from([first]);
    let mut written = Ok(());
    while let Some(map) = waiting.pop_front() {
        try_every_op(&map, |_, outcome, result| {
            let recorder = result.subject();
            if !comparable(outcome, recorder) || written.is_err() {
                return;
            }
            written = writeln!(out, "{}", recorder.line);
            let dcel = &recorder.dcel;
            let fits = dcel.edge_count() <= edges && dcel.vertex_count() <= vertices;
            if fits && canonizer.subdivision(recorder).is_some_and(|code| met.insert(code)) {
                waiting.push_back(result.clone());
            }
        });
    }
    eprintln!("{} subdivisions", met.len());
    Ok(written?)
}

fn random(work: SoakWork, out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    for number in 0..work.programs {
        let mut map = Runner::new(Recorder::default());
        for op in work.program(number).0 {
            if comparable(map.step(op), map.subject()) {
                writeln!(out, "{}", map.subject().line)?;
            }
        }
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let mut out = BufWriter::new(std::io::stdout().lock());
    match words[..] {
        ["small", edges, vertices] => small(edges.parse()?, vertices.parse()?, &mut out)?,
        ["random", programs, steps, seed] => {
            let work = SoakWork { programs: programs.parse()?, steps: steps.parse()?, seed: seed.parse()? };
            random(work, &mut out)?;
        }
        _ => return Err(USAGE.into()),
    }
    Ok(out.flush()?)
}
