//! Prints what the operators of `Dcel` do, a line for each that is called: the operator with its arguments, the table before and the
//! table after. `proofs/coq/compare --operators` reads this, and holds it against the operators that are proved.
//!
//! ```text
//! connect v0 v1 left = h0 ; V 2 - 0 - 1 H 0 B 2 … ; V 2 0 - 1 - H 2 …
//! refused contract_edge h0 ; V 1 0 - H 2 … ; V 1 0 - H 2 …
//! ```
//!
//! A corner is `h3` (that of half-edge 3) or `v3` (that of the isolated vertex 3), as the inner boundary components are that go to a
//! new face. After `=` stands the half-edge that is new, if there is one.
#![allow(clippy::print_stderr, reason = "it is a program")]

use std::collections::{HashSet, VecDeque};
use std::error::Error;
use std::fmt::Write as _;
use std::io::{BufWriter, Write};
use twinedge::dcel::{Corner, Dcel, Side, Turn};
use twinedge::dcel::{FaceKey, HalfEdgeKey, VertexKey};
use twinedge::program::canonical::Canonizer;
use twinedge::program::{Refusal, Runner, StepOutcome, Subject, try_every_op};
use twinedge::validate::{Table, View};
use twinedge::{delegate_subject, delegate_view};
use twinedge_trials::soak::SoakWork;

const USAGE: &str =
    "usage: steps small EDGES VERTICES     every operator with every argument on every small subdivision
       steps random PROGRAMS STEPS SEED  the operators of random programs";

/// A `Dcel` that writes down its last operator.
#[derive(Clone, Default)]
struct Recorder {
    dcel: Dcel,
    line: String,
}

impl Recorder {
    const fn dcel(&self) -> &Dcel {
        &self.dcel
    }

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

    fn corner(&self, corner: Corner) -> String {
        match corner {
            Corner::At(h) => self.half_edge(h),
            Corner::Isolated(v) => self.vertex(v),
        }
    }

    /// Runs an operator, and writes it down with these words.
    fn run<T>(&mut self, words: &str, operator: impl FnOnce(&mut Dcel) -> Result<T, Refusal>) -> Result<T, Refusal> {
        let before = self.table();
        let answer = operator(&mut self.dcel);
        let refused = if answer.is_ok() { "" } else { "refused " };
        self.line = format!("{refused}{words} ; {before} ; {}", self.table());
        answer
    }

    /// The same for an operator that makes an edge.
    fn run_new(
        &mut self,
        mut words: String,
        operator: impl FnOnce(&mut Dcel) -> Result<HalfEdgeKey, Refusal>,
    ) -> Result<HalfEdgeKey, Refusal> {
        let mut copy = self.dcel.clone();
        let made = operator(&mut copy);
        if let Some(h) = made.as_ref().ok().and_then(|key| copy.half_edge(*key).ok()) {
            let _ = write!(words, " = h{}", h.index());
        }
        self.run(&words, |dcel| {
            *dcel = copy;
            made
        })
    }
}

impl View for Recorder {
    delegate_view!(|this| &this.dcel);
}

impl Subject for Recorder {
    delegate_subject!(Dcel, Self::dcel);

    fn add_isolated_vertex(&mut self, face: FaceKey) -> Result<VertexKey, Refusal> {
        let words = format!("add_isolated_vertex {}", self.face(face));
        self.run(&words, |dcel| Subject::add_isolated_vertex(dcel, face))
    }

    fn remove_isolated_vertex(&mut self, vertex: VertexKey) -> Result<(), Refusal> {
        let words = format!("remove_isolated_vertex {}", self.vertex(vertex));
        self.run(&words, |dcel| Subject::remove_isolated_vertex(dcel, vertex))
    }

    fn connect(&mut self, from: Corner, to: Corner, new_face: Side, inner: &[Corner]) -> Result<HalfEdgeKey, Refusal> {
        let side = if new_face == Side::Left { "left" } else { "right" };
        let mut words = format!("connect {} {} {side}", self.corner(from), self.corner(to));
        for corner in inner {
            let _ = write!(words, " {}", self.corner(*corner));
        }
        self.run_new(words, |dcel| Subject::connect(dcel, from, to, new_face, inner))
    }

    fn remove_edge(&mut self, half_edge: HalfEdgeKey) -> Result<Option<FaceKey>, Refusal> {
        let words = format!("remove_edge {}", self.half_edge(half_edge));
        self.run(&words, |dcel| Subject::remove_edge(dcel, half_edge))
    }

    fn split_edge(&mut self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, Refusal> {
        let words = format!("split_edge {}", self.half_edge(half_edge));
        self.run_new(words, |dcel| Subject::split_edge(dcel, half_edge))
    }

    fn join_edges(&mut self, half_edge: HalfEdgeKey) -> Result<(), Refusal> {
        let words = format!("join_edges {}", self.half_edge(half_edge));
        self.run(&words, |dcel| Subject::join_edges(dcel, half_edge))
    }

    fn split_vertex(&mut self, from: Corner, to: Corner) -> Result<HalfEdgeKey, Refusal> {
        let words = format!("split_vertex {} {}", self.corner(from), self.corner(to));
        self.run_new(words, |dcel| Subject::split_vertex(dcel, from, to))
    }

    fn contract_edge(&mut self, half_edge: HalfEdgeKey) -> Result<VertexKey, Refusal> {
        let words = format!("contract_edge {}", self.half_edge(half_edge));
        self.run(&words, |dcel| Subject::contract_edge(dcel, half_edge))
    }

    fn flip_edge(&mut self, half_edge: HalfEdgeKey, turn: Turn) -> Result<(), Refusal> {
        let way = if turn == Turn::Clockwise { "clockwise" } else { "counter_clockwise" };
        let words = format!("flip_edge {} {way}", self.half_edge(half_edge));
        self.run(&words, |dcel| Subject::flip_edge(dcel, half_edge, turn))
    }

    fn move_inner(&mut self, inner: Corner, face: FaceKey) -> Result<(), Refusal> {
        let words = format!("move_inner {} {}", self.corner(inner), self.face(face));
        self.run(&words, |dcel| Subject::move_inner(dcel, inner, face))
    }
}

/// Says if the proved operator, which knows no keys, can be held against what was recorded: an operator was called, with no stale key.
fn comparable(outcome: StepOutcome, recorder: &Recorder) -> bool {
    outcome != StepOutcome::Skipped && !recorder.line.contains("stale")
}

/// Tries every operator with every argument on every subdivision up to a size, from the empty one on.
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

/// Runs random programs, those of `soak`.
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
