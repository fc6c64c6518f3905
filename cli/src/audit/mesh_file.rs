//! Auditing a mesh file.

use super::destination::Destination;
use crate::input::Input;
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, counted};
use crate::status::{Failure, Verdict};
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::time::Instant;
use twinedge::validate::{Collect, Expectation};
use twinedge_formats::mesh::{self, Finding, Format as MeshFormat, HalfEdgeMesh, Kind, MeshAudit, MeshFile};

/// What a mesh must be.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Meshes")]
pub(super) struct Expected {
    /// The mesh has no border.
    #[arg(long, conflicts_with = "borders")]
    closed: bool,

    /// The mesh has exactly N border loops.
    #[arg(long, value_name = "N")]
    borders: Option<usize>,

    /// The genus of the whole mesh is N: 0 for spheres and discs, 1 for a torus.
    #[arg(long, value_name = "N")]
    genus: Option<usize>,

    /// The mesh has exactly N components.
    #[arg(long, value_name = "N")]
    components: Option<usize>,

    /// Every face has three sides.
    #[arg(long, conflicts_with = "sides")]
    triangles: bool,

    /// Every face has N sides.
    #[arg(long, value_name = "N")]
    sides: Option<usize>,

    /// Every vertex is a corner of a face.
    #[arg(long)]
    no_unused_vertices: bool,
}

impl Expected {
    /// Whether anything is expected.
    pub(super) fn is_any(&self) -> bool {
        self.expectation() != HalfEdgeMesh::expectation()
    }

    pub(super) fn expectation(&self) -> Expectation {
        let mut expectation = HalfEdgeMesh::expectation();
        if self.closed {
            expectation = expectation.closed();
        }
        if let Some(borders) = self.borders {
            expectation = expectation.borders(borders);
        }
        if let Some(genus) = self.genus {
            expectation = expectation.genus(genus);
        }
        if let Some(components) = self.components {
            expectation = expectation.components(components);
        }
        if let Some(sides) = self.sides.or(self.triangles.then_some(3)) {
            expectation = expectation.sides(sides);
        }
        if self.no_unused_vertices {
            expectation = expectation.no_unused_vertices();
        }
        expectation
    }
}

#[derive(Debug, Serialize)]
struct Json<'a> {
    input: &'a str,
    format: &'static str,
    dropped: &'a [mesh::Dropped],
    #[serde(flatten)]
    audit: &'a MeshAudit,
    elapsed_ms: f64,
}

/// Reads a mesh, joins its faces, and prints what was found. At most `list` findings of each kind are listed.
pub(super) fn audit(
    Input { name, reader, .. }: Input,
    format: MeshFormat,
    expectation: Expectation,
    list: usize,
    explain: bool,
    to: Destination<'_>,
) -> Result<Verdict, Failure> {
    let start = Instant::now();
    let output = to.without_map(&name, "a mesh")?;
    let file = mesh::read(reader, Some(format)).map_err(|error| Failure(format!("{name}: {error}")))?;
    let audit = mesh::audit(&file.mesh, &expectation, Collect::AtMost(list));
    let elapsed_ms = start.elapsed().as_secs_f64() * 1000.0;
    match output {
        Format::Text => to.text(&text(&name, &file, &audit, explain, elapsed_ms)?)?,
        Format::Json => {
            let json = Json { input: &name, format: format.name(), dropped: &file.dropped, audit: &audit, elapsed_ms };
            if explain { to.json(&explained(&json)?)? } else { to.json(&json)? }
        }
    }
    Ok(if audit.is_valid() { Verdict::Sound } else { Verdict::Wrong })
}

/// The same, with the usual cause and the remedy of each finding and each violation.
fn explained(json: &Json<'_>) -> Result<serde_json::Value, Failure> {
    let mut value = serde_json::to_value(json)?;
    let listed = value["findings"].as_array_mut().into_iter().flatten();
    for (object, finding) in listed.zip(json.audit.findings().list()) {
        object["cause"] = finding.kind().cause().into();
        object["remedy"] = finding.kind().remedy().into();
    }
    let listed = value["violations"].as_array_mut().into_iter().flatten();
    for (object, violation) in listed.zip(json.audit.report().violations()) {
        object["cause"] = violation.cause().into();
        object["remedy"] = violation.remedy().into();
    }
    Ok(value)
}

fn text(
    name: &str,
    file: &MeshFile,
    audit: &MeshAudit,
    explain: bool,
    elapsed_ms: f64,
) -> Result<String, std::fmt::Error> {
    let mut out = String::new();
    writeln!(out, "{name}")?;
    let (points, faces) = (file.mesh.points().len(), file.mesh.face_count());
    write!(out, "{QUIET}{}, {}, {}", file.format, counted(points, "point"), counted(faces, "face"))?;
    for dropped in &file.dropped {
        write!(out, "; not used: {} {}", dropped.count, dropped.what)?;
    }
    let from_one = if file.format.name() == "obj" { " (the file counts points from 1)" } else { "" };
    writeln!(out, "\nvertices and faces are counted from 0 here{from_one}{QUIET:#}\n")?;
    let body = audit.to_string();
    let (body, _) = body.rsplit_once('\n').unwrap_or((&body, ""));
    writeln!(out, "{body}\n")?;
    if explain {
        let kinds: BTreeSet<Kind> = audit.findings().list().iter().map(Finding::kind).collect();
        for kind in kinds {
            writeln!(out, "{kind}: usual cause: {}; remedy: {}", kind.cause(), kind.remedy())?;
        }
        let violations = audit.report().violations().iter();
        let explained: BTreeSet<_> = violations.map(|v| (v.rule(), v.cause(), v.remedy())).collect();
        for (rule, cause, remedy) in explained {
            writeln!(out, "{rule}: usual cause: {cause}; remedy: {remedy}")?;
        }
    }
    if audit.is_valid() {
        writeln!(out, "{GOOD}valid{GOOD:#}: every rule that applies holds ({elapsed_ms:.0} ms)")?;
    } else {
        let (findings, violations) = (audit.findings().total(), audit.report().violation_count());
        let (findings, violations) = (counted(findings, "finding"), counted(violations as usize, "violation"));
        writeln!(out, "{BAD}not valid{BAD:#}: {findings}, {violations} ({elapsed_ms:.0} ms)")?;
    }
    Ok(out)
}
