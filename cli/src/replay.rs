//! `twinedge replay`: a saved program, step by step.

use crate::caught::caught;
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, print, print_json};
use crate::subjects::{Indexed, SubjectName, Task};
use crate::trial::Trial;
use crate::{Failure, Verdict};
use clap::ValueEnum;
use serde::Serialize;
use std::fmt::{self, Write as _};
use std::io::Read as _;
use std::path::PathBuf;
use twinedge::program::{Call, CallOf, Corner, CornerOf, Program, Runner};
use twinedge::validate::{BoundaryPlace, Collect, Expectation, Start, View, validate};

/// Run a saved program and print the structure after each step.
///
/// The names in a step count what there is, in order of creation; below it stands what they came to, by the names of the
/// table. Then the program is run once more in step with the textbook's structure, as `twinedge soak` does it.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge replay failing.program
  twinedge replay failing.program --on pointers
  printf 'twinedge program 1\\nadd_isolated_vertex unbounded\\n' | twinedge replay -

Exit status: 0 every step is valid and in step with the textbook's structure; 1 not so, or a step panicked; 2 the file could not be read.")]
pub(crate) struct Replay {
    /// The program, as `twinedge soak` saves it, or `-` for standard input.
    file: PathBuf,

    /// On what to run it; on what it failed on, if the file says so, unless said otherwise.
    #[arg(long, value_enum, value_name = "STRUCTURE")]
    on: Option<SubjectName>,

    /// For whom to print.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// No program is longer, in bytes, than this.
const LONGEST: u64 = 16 << 20;

#[derive(Debug, Serialize)]
struct Outcome {
    on: SubjectName,
    steps: Vec<Step>,
    /// In what the structure differs from the textbook's.
    difference: Option<String>,
    ok: bool,
}

#[derive(Debug, Serialize)]
struct Step {
    op: String,
    /// The arguments that it chose, by their names in `structure`; none if there was nothing to choose from.
    chosen: Option<String>,
    outcome: String,
    /// None if it panicked: no step comes after that.
    #[serde(flatten)]
    after: Option<After>,
}

/// The structure after a step.
#[derive(Debug, Serialize)]
struct After {
    valid: bool,
    vertices: usize,
    edges: usize,
    faces: usize,
    components: Option<usize>,
    violations: Vec<String>,
    structure: String,
}

impl Replay {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let name = if self.is_standard_input() { "standard input".into() } else { self.file.display().to_string() };
        let text = self.read().map_err(|error| Failure(format!("{name}: {error}")))?;
        let program: Program = text.parse().map_err(|error| Failure(format!("{name}: {error}")))?;
        let on = self.on.or_else(|| named_in(&text)).unwrap_or_default();
        let steps = on.run(Steps(&program));
        let difference = on.run(Trial(&program)).failure();
        let ok = difference.is_none() && steps.iter().all(|step| step.after.as_ref().is_some_and(|after| after.valid));
        let outcome = Outcome { on, steps, difference, ok };
        match self.format {
            Format::Text => print(&outcome.to_string())?,
            Format::Json => print_json(&outcome)?,
        }
        Ok(if ok { Verdict::Sound } else { Verdict::Wrong })
    }

    fn is_standard_input(&self) -> bool {
        self.file.as_os_str() == "-"
    }

    fn read(&self) -> std::io::Result<String> {
        let mut text = String::new();
        if self.is_standard_input() {
            std::io::stdin().lock().take(LONGEST).read_to_string(&mut text)?;
        } else {
            std::fs::File::open(&self.file)?.take(LONGEST).read_to_string(&mut text)?;
        }
        Ok(text)
    }
}

/// The structure that a saved file names in its comments.
fn named_in(text: &str) -> Option<SubjectName> {
    let comments = text.lines().map_while(|line| line.strip_prefix('#'));
    let mut names = comments.filter_map(|line| line.split_once("on: ").map(|(_, name)| name.trim()));
    names.find_map(|name| SubjectName::from_str(name, false).ok())
}

/// Running a program and writing down each step, up to one that panics.
struct Steps<'a>(&'a Program);

impl Task for Steps<'_> {
    type Result = Vec<Step>;

    fn run<K: Indexed>(self, make: fn() -> K, expectation: Expectation) -> Vec<Step> {
        let mut runner = Runner::new(make());
        let mut steps = Vec::new();
        for op in &self.0.0 {
            let chosen = caught(|| runner.resolve(*op).ok().map(|call| in_words(runner.subject(), &call)));
            let done = caught(|| {
                let outcome = runner.step(*op);
                (outcome.to_string(), After::of(runner.subject(), expectation))
            });
            let (outcome, after) = match done {
                Ok((outcome, after)) => (outcome, Some(after)),
                Err(panic) => (format!("panicked: {panic}"), None),
            };
            let is_last = after.is_none();
            steps.push(Step { op: op.to_string(), chosen: chosen.ok().flatten(), outcome, after });
            if is_last {
                break;
            }
        }
        steps
    }
}

impl After {
    fn of<V: View>(view: &V, expectation: Expectation) -> Self {
        let report = validate(view, &expectation, Collect::All);
        let counts = report.counts();
        Self {
            valid: report.is_valid(),
            vertices: counts.vertices,
            edges: counts.edges,
            faces: counts.faces,
            components: counts.components,
            violations: report.violations().iter().map(|v| format!("{}: {v}", v.rule())).collect(),
            structure: Tables(view).to_string(),
        }
    }
}

/// The arguments of an operator by their names in the tables.
fn in_words<K: Indexed>(subject: &K, call: &CallOf<K>) -> String {
    let named =
        |letter: char, index: Option<usize>| index.map_or_else(|| "gone".to_owned(), |i| format!("{letter}{i}"));
    let vertex = |v: &K::Vertex| named('v', subject.vertex_index(*v));
    let half_edge = |h: &K::HalfEdge| named('h', subject.half_edge_index(*h));
    let face = |f: &K::Face| named('f', subject.face_index(*f));
    let corner = |corner: &CornerOf<K>| match corner {
        Corner::At(h) => half_edge(h),
        Corner::Isolated(v) => vertex(v),
    };
    match call {
        Call::AddIsolatedVertex { face: f } => format!("in {}", face(f)),
        Call::RemoveIsolatedVertex { vertex: v } => vertex(v),
        Call::Connect { from, to, inner, .. } => {
            let inner: Vec<String> = inner.iter().map(corner).collect();
            let inner = if inner.is_empty() { String::new() } else { format!(", inner {}", inner.join(" ")) };
            format!("{} to {}{inner}", corner(from), corner(to))
        }
        Call::SplitVertex { from, to } => format!("{} to {}", corner(from), corner(to)),
        Call::RemoveEdge { half_edge: h }
        | Call::SplitEdge { half_edge: h }
        | Call::JoinEdges { half_edge: h }
        | Call::ContractEdge { half_edge: h }
        | Call::FlipEdge { half_edge: h, .. } => half_edge(h),
        Call::MoveInner { inner, face: f } => format!("{} to {}", corner(inner), face(f)),
    }
}

/// A structure as tables, a line for each record.
struct Tables<'a, V>(&'a V);

/// A link with the letter of what it leads to.
fn link(letter: char, link: Option<usize>) -> String {
    link.map_or_else(|| "nil".to_owned(), |i| format!("{letter}{i}"))
}

fn start(start: Option<Start>) -> String {
    match start {
        Some(Start::HalfEdge(h)) => format!("h{h}"),
        Some(Start::Vertex(v)) => format!("v{v}"),
        None => "nil".to_owned(),
    }
}

impl<V: View> fmt::Display for Tables<'_, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let view = self.0;
        for v in (0..view.vertex_slots()).filter(|v| view.is_vertex(*v)) {
            match (view.leaving(v), view.isolated(v)) {
                (None, None) => writeln!(f, "  v{v}  isolated")?,
                (None, isolated) => writeln!(f, "  v{v}  isolated {}", link('b', isolated))?,
                (leaving, _) => writeln!(f, "  v{v}  leaving {}", link('h', leaving))?,
            }
        }
        for h in (0..view.half_edge_slots()).filter(|h| view.is_half_edge(*h)) {
            write!(f, "  h{h}  origin {}  twin {}", link('v', view.origin(h)), link('h', view.twin(h)))?;
            write!(f, "  next {}  prev {}", link('h', view.next(h)), link('h', view.prev(h)))?;
            match view.boundary(h) {
                None => writeln!(f, "  face {}", link('f', view.face(h)))?,
                boundary => writeln!(f, "  boundary {}", link('b', boundary))?,
            }
        }
        for b in (0..view.boundary_slots()).filter(|b| view.is_boundary(*b)) {
            write!(f, "  b{b}  face {}  start {}", link('f', view.boundary_face(b)), start(view.boundary_start(b)))?;
            match view.boundary_place(b) {
                Some(BoundaryPlace::Outer) => writeln!(f, "  outer")?,
                Some(BoundaryPlace::Inner(i)) => writeln!(f, "  inner, place {i}")?,
                None => writeln!(f, "  place nil")?,
            }
        }
        for face in (0..view.face_slots()).filter(|face| view.is_face(*face)) {
            let outer = match view.outer(face) {
                None => link('h', view.outer_half_edge(face)),
                outer => link('b', outer),
            };
            write!(f, "  f{face}  outer {outer}  inner [")?;
            for i in 0..view.inner_count(face) {
                let entry = match view.inner(face, i) {
                    None => start(view.inner_start(face, i)),
                    inner => link('b', inner),
                };
                write!(f, "{}{entry}", if i == 0 { "" } else { " " })?;
            }
            writeln!(f, "]")?;
        }
        Ok(())
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, step) in self.steps.iter().enumerate() {
            let Step { op, chosen, outcome, after } = step;
            writeln!(f, "{}. {op}: {outcome}", number + 1)?;
            if let Some(chosen) = chosen {
                writeln!(f, "{QUIET}   that is: {chosen}{QUIET:#}")?;
            }
            let Some(After { vertices, edges, faces, components, violations, structure, .. }) = after else { break };
            let components = components.map_or_else(|| "unknown".to_owned(), |components| components.to_string());
            writeln!(f, "{QUIET}   V {vertices}  E {edges}  F {faces}  C {components}{QUIET:#}")?;
            f.write_str(structure)?;
            for violation in violations {
                writeln!(f, "   {BAD}{violation}{BAD:#}")?;
            }
        }
        let mut verdict = String::new();
        match &self.difference {
            Some(difference) => write!(verdict, "{BAD}{} differs{BAD:#} {difference}", self.on.name())?,
            None if self.ok => {
                write!(verdict, "{GOOD}in step{GOOD:#}: {} did as the textbook's structure does", self.on.name())?;
            }
            None => write!(verdict, "{BAD}not valid{BAD:#}")?,
        }
        writeln!(f, "{verdict}")
    }
}
