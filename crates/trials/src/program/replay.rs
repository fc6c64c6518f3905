//! `twinedge-trials replay`: a saved program, step by step.

use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Failure, Format, Verdict, named};
use crate::replay_map;
use crate::structures::{StructureName, Task};
use clap::ValueEnum;
use serde::Serialize;
use std::fmt::{self, Write as _};
use std::io::Read as _;
use std::path::PathBuf;
use twinedge::program::{Call, Program};
use twinedge::validate::{BoundaryPlace, Link, Report, Start, Table, View};
use twinedge_trials::replay::Indexed;
use twinedge_trials::soak::Comparable;
use twinedge_trials::{Silent, Structure, replay};

/// Run a saved program and print the structure after each step.
///
/// The names in a step count what there is, in order of creation. The line below a step shows the records that they chose, by
/// their names in the table. Then the program is run once more in step with the reference, as `twinedge-trials soak` does it.
///
/// With --map it is a journal of edits of a map, which begins with the line `twinedge edits 1`: `insert_point`, `insert_segment`,
/// `insert_segment_snapped`, `insert_ring`, `remove_edge`, `remove_vertex`, `move_vertex`, `add_feature`, `set_features_of`, `set_features_along`, in the
/// words of `twinedge_map::program`. Each step is validated, and has to be done. The output of --format json is also a journal. An editor in
/// Rust writes each edit as a line: an `EditOp`, which shows itself so. Undone edits are left out. An edit that names a number past the last record is skipped, and the report says so.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge-trials replay failing.program
  twinedge-trials replay failing.program --on pointers
  printf 'twinedge program 1\\nadd_isolated_vertex unbounded\\n' | twinedge-trials replay -
  twinedge-trials replay --map monday.edits --format json > monday.json
  printf 'twinedge edits 1\\ninsert_ring 0,0 4,0 4,4\\nmove_vertex v1 5,0\\n' | twinedge-trials replay --map -

Exit status: 0 every step is valid, and in step with the reference or, with --map, was done; 1 otherwise, or a step panicked; \
2 the file could not be read.")]
pub(crate) struct Replay {
    /// The program, as `twinedge-trials soak` saves it, or the journal; `-` for standard input.
    file: PathBuf,

    /// Replay a journal of edits, from an empty map on. Vertices, half-edges and faces are counted in order of creation: v0, h0, f0.
    #[arg(long, conflicts_with = "on")]
    map: bool,

    /// The structure to run it on. Default: the structure that the file names, or slots.
    #[arg(long, value_enum, value_name = "STRUCTURE")]
    on: Option<StructureName>,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// The maximal length of a program in bytes; the rest is cut off.
const LONGEST: u64 = 16 << 20;

#[derive(Debug, Serialize)]
struct Outcome {
    on: &'static str,
    steps: Vec<Step>,
    /// The difference between the structure and the reference.
    difference: Option<String>,
    ok: bool,
}

#[derive(Debug, Serialize)]
struct Step {
    op: String,
    /// The chosen arguments, by their names in the structure before the step; `None` if there was nothing to choose from.
    chosen: Option<String>,
    outcome: String,
    /// The structure afterwards; `None` if the operator panicked, which ends the program.
    #[serde(flatten)]
    after: Option<After>,
}

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
        let text = self.read().map_err(named(&name))?;
        if self.map {
            return replay_map::run(&text, self.format).map_err(|Failure(error)| named(&name)(error));
        }
        let program: Program = text.parse().map_err(named(&name))?;
        let on = self.on.or_else(|| named_in(&text)).unwrap_or_default();
        let (steps, difference) = on.with(Replaying(&program));
        let ok = difference.is_none() && steps.iter().all(|step| step.after.as_ref().is_some_and(|after| after.valid));
        let outcome = Outcome { on: on.name(), steps, difference, ok };
        self.format.print(&outcome)?;
        Ok(Verdict::of(ok))
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

/// Returns the structure named in the comments of a saved file.
fn named_in(text: &str) -> Option<StructureName> {
    let comments = text.lines().map_while(|line| line.strip_prefix('#'));
    let mut names = comments.filter_map(|line| line.split_once("on: ").map(|(_, name)| name.trim()));
    names.find_map(|name| StructureName::from_str(name, false).ok())
}

/// Runs a program step by step, and then in step with the reference.
struct Replaying<'a>(&'a Program);

impl Task for Replaying<'_> {
    type Result = (Vec<Step>, Option<String>);

    fn run<K: Indexed + Clone>(self, structure: Structure<K>) -> Self::Result {
        let Self(program) = self;
        let steps = replay(&structure, program).into_iter().map(Step::from).collect();
        let comparison = structure.compare(program, &Silent);
        (steps, comparison.failure().map(str::to_owned))
    }
}

impl From<twinedge_trials::replay::Step> for Step {
    fn from(step: twinedge_trials::replay::Step) -> Self {
        let (outcome, after) = match step.outcome {
            Ok(after) => (after.outcome.to_string(), Some(After::of(&after.report, after.table.as_ref()))),
            Err(panic) => (format!("panicked: {panic}"), None),
        };
        Self { op: step.op.to_string(), chosen: step.call.map(in_words), outcome, after }
    }
}

impl After {
    fn of(report: &Report, table: Option<&Table>) -> Self {
        let counts = report.counts();
        Self {
            valid: report.is_valid(),
            vertices: counts.vertices,
            edges: counts.edges,
            faces: counts.faces,
            components: counts.components,
            violations: report.violations().iter().map(ToString::to_string).collect(),
            structure: table.map(|table| Tables(table).to_string()).unwrap_or_default(),
        }
    }
}

fn in_words(call: Call<Link, Link, Link>) -> String {
    let named = |letter: char| move |index: Link| index.map_or_else(|| "stale".to_owned(), |i| format!("{letter}{i}"));
    call.map(named('v'), named('h'), named('f')).to_string()
}

/// A structure as tables, with a line for each record.
struct Tables<'a>(&'a Table);

/// A link, prefixed with the letter of its kind of record.
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

impl fmt::Display for Tables<'_> {
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
                writeln!(f, "{QUIET}   records: {chosen}{QUIET:#}")?;
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
            Some(difference) => write!(verdict, "{BAD}{} differs{BAD:#} {difference}", self.on)?,
            None if self.ok => {
                write!(verdict, "{GOOD}in step{GOOD:#}: {} did as the reference does", self.on)?;
            }
            None => write!(verdict, "{BAD}not valid{BAD:#}")?,
        }
        writeln!(f, "{verdict}")
    }
}
