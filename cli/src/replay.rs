//! `twinedge replay`: a saved program, step by step.

use crate::kernels::{KernelName, Task};
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, print, print_json};
use crate::soak::Conform;
use crate::{Failure, Verdict};
use clap::ValueEnum;
use serde::Serialize;
use std::fmt::{self, Write as _};
use std::io::Read as _;
use std::path::PathBuf;
use twinedge::program::{Kernel, Program, Runner};
use twinedge::validate::{Collect, Expectation, Place, Start, View, validate};

/// Run a saved program and print the structure after each step.
///
/// Then it is run once more in step with the reference, as `twinedge soak` does it.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge replay failing.program
  twinedge replay failing.program --on pointers
  printf 'twinedge program 1\\nadd_isolated_vertex unbounded\\n' | twinedge replay -

Exit status: 0 every step is valid and in step with the reference; 1 not so; 2 the file could not be read.")]
pub(crate) struct Replay {
    /// The program, as `twinedge soak` saves it, or `-` for standard input.
    file: PathBuf,

    /// On what to run it; on what it failed on, if the file says so, unless said otherwise.
    #[arg(long, value_enum, value_name = "STRUCTURE")]
    on: Option<KernelName>,

    /// For whom to print.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// No program is longer, in bytes, than this.
const LONGEST: u64 = 16 << 20;

#[derive(Debug, Serialize)]
struct Outcome {
    on: KernelName,
    steps: Vec<Step>,
    /// In what the structure differs from the reference.
    difference: Option<String>,
    ok: bool,
}

#[derive(Debug, Serialize)]
struct Step {
    op: String,
    outcome: String,
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
        let name = self.file.display();
        let text = self.read().map_err(|error| Failure(format!("{name}: {error}")))?;
        let program: Program = text.parse().map_err(|error| Failure(format!("{name}: {error}")))?;
        let on = self.on.or_else(|| named_in(&text)).unwrap_or_default();
        let steps = on.run(Steps(&program));
        let difference = on.run(Conform(&program)).err().map(|failure| failure.to_string());
        let ok = difference.is_none() && steps.iter().all(|step| step.valid);
        let outcome = Outcome { on, steps, difference, ok };
        match self.format {
            Format::Text => print(&outcome.to_string())?,
            Format::Json => print_json(&outcome)?,
        }
        Ok(if ok { Verdict::Sound } else { Verdict::Wrong })
    }

    fn read(&self) -> std::io::Result<String> {
        let mut text = String::new();
        if self.file.as_os_str() == "-" {
            std::io::stdin().lock().take(LONGEST).read_to_string(&mut text)?;
        } else {
            std::fs::File::open(&self.file)?.take(LONGEST).read_to_string(&mut text)?;
        }
        Ok(text)
    }
}

/// The structure that a saved file names in its comments.
fn named_in(text: &str) -> Option<KernelName> {
    let comments = text.lines().map_while(|line| line.strip_prefix('#'));
    let mut names = comments.filter_map(|line| line.split_once("on: ").map(|(_, name)| name.trim()));
    names.find_map(|name| KernelName::from_str(name, false).ok())
}

/// Running a program and writing down each step.
struct Steps<'a>(&'a Program);

impl Task for Steps<'_> {
    type Result = Vec<Step>;

    fn run<K: Kernel>(self, make: fn() -> K, expectation: Expectation) -> Vec<Step> {
        let mut runner = Runner::new(make());
        let step = |op: &twinedge::program::Op| {
            let outcome = runner.step(*op);
            let report = validate(runner.kernel(), &expectation, Collect::All);
            let counts = report.counts();
            Step {
                op: op.to_string(),
                outcome: outcome.to_string(),
                valid: report.is_valid(),
                vertices: counts.vertices,
                edges: counts.edges,
                faces: counts.faces,
                components: counts.components,
                violations: report.violations().iter().map(|v| format!("{}: {v}", v.rule())).collect(),
                structure: Tables(runner.kernel()).to_string(),
            }
        };
        self.0.0.iter().map(step).collect()
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
                Some(Place::Outer) => writeln!(f, "  outer")?,
                Some(Place::Inner(i)) => writeln!(f, "  inner, place {i}")?,
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
            let Step { op, outcome, vertices, edges, faces, components, .. } = step;
            writeln!(f, "{}. {op}: {outcome}", number + 1)?;
            let components = components.map_or_else(|| "unknown".to_owned(), |components| components.to_string());
            writeln!(f, "{QUIET}   V {vertices}  E {edges}  F {faces}  C {components}{QUIET:#}")?;
            f.write_str(&step.structure)?;
            for violation in &step.violations {
                writeln!(f, "   {BAD}{violation}{BAD:#}")?;
            }
        }
        let mut verdict = String::new();
        match &self.difference {
            Some(difference) => write!(verdict, "{BAD}{} differs{BAD:#} {difference}", self.on.name())?,
            None if self.ok => write!(verdict, "{GOOD}in step{GOOD:#}: {} did as the reference does", self.on.name())?,
            None => write!(verdict, "{BAD}not valid{BAD:#}")?,
        }
        writeln!(f, "{verdict}")
    }
}
