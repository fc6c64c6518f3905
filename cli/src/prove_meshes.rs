//! `twinedge prove --meshes N`: all small triangulated discs, all operators, all arguments.

use crate::document::{Document, Nothing, Printed};
use crate::effort::Effort;
use crate::output::style::{BAD, GOOD};
use crate::output::{Format, counted};
use crate::print_rows::table;
use crate::status::{Failure, Verdict};
use crate::structures::{StructureName, Task};
use std::fmt;
use std::time::Instant;
use twinedge_trials::meshes::{MeshStructure, MeshesOutcome, MeshesWork};
use twinedge_trials::replay::Indexed;
use twinedge_trials::{Outcome, Run, Structure, meshes};

struct Trying<'a>(MeshesWork, &'a Run<'a>);

impl Task for Trying<'_> {
    type Result = MeshesOutcome;

    fn run<K: Indexed + Clone + 'static>(self, structure: Structure<K>) -> MeshesOutcome {
        meshes(&MeshStructure::plane(structure), self.0, self.1)
    }
}

pub(crate) fn run(vertices: usize, on: StructureName, effort: &Effort, format: Format) -> Result<Verdict, Failure> {
    let work = MeshesWork { vertices };
    effort.refuse_too_much(work.estimate(), format)?;
    let run = effort.start()?;
    let start = Instant::now();
    let document = Document::new(on.with(Trying(work, &run)), start);
    document.print(format)?;
    Ok(document.verdict())
}

impl Printed for MeshesOutcome {
    const COMMAND: &'static str = "prove --meshes";
    type Extra = Nothing;

    fn text(&self, _: &Nothing, seconds: f64) -> String {
        Text(self, seconds).to_string()
    }
}

struct Text<'a>(&'a MeshesOutcome, f64);

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(outcome, seconds) = self;
        writeln!(f, "Structure: {}\n", outcome.on)?;
        writeln!(
            f,
            "Triangulated discs, by vertices on the border + inside. A wrong count stands beside the published one."
        )?;
        // Every part counts all triangulations.
        f.write_str(&table(&outcome.rows, true))?;
        writeln!(f)?;
        f.write_str(&table(&outcome.operators, true))?;
        writeln!(f)?;
        for finding in &outcome.findings {
            writeln!(f, "{BAD}{finding}{BAD:#}")?;
        }
        if outcome.interrupted {
            return writeln!(f, "{BAD}not finished{BAD:#} ({seconds:.1} s)");
        }
        if outcome.is_ok() {
            writeln!(
                f,
                "{GOOD}exhausted up to {}{GOOD:#}: every operator does what its definition says ({seconds:.1} s)",
                counted(outcome.work.vertices, "vertex")
            )
        } else {
            writeln!(
                f,
                "{BAD}not as defined{BAD:#}: a count or an operator differs, or nothing was applied ({seconds:.1} s)"
            )
        }
    }
}
