//! Structures that are certified without a map: meshes, topologies of PostGIS, and tables.

use crate::output::{Failure, Verdict};
use std::fmt::Display;
use std::io::{BufRead, Read};
use twinedge::validate::{Collect, Expectation, Surface, Table, View, validate};
use twinedge_meshes::{Format, HalfEdgeMesh};
use twinedge_postgis::Listed;
use twinedge_report::textbook::Textbook;
use twinedge_report::{EXPECT, Input, InputKind};

/// A structure with its expectation, or the findings line by line.
pub(super) enum Source<'a> {
    Plane(&'a dyn View),
    Surface(&'a dyn View),
    Wrong(String),
}

pub(super) const LIST: usize = 10;

/// Uses the structure in an input that is not a map.
pub(super) type Use<'a> = &'a dyn Fn(Source<'_>) -> Result<Verdict, Failure>;

pub(super) fn read(input: Input, kind: InputKind, certify: Use<'_>) -> Result<Verdict, Failure> {
    match kind {
        InputKind::Mesh(format) => read_mesh(input, format, certify),
        InputKind::Postgis => read_topology(input, certify),
        InputKind::Textbook => read_textbook(input, certify),
        InputKind::Tables => read_table(input, certify),
        InputKind::Map | InputKind::Arcs => {
            Err(Failure(format!("{}: this is {}, and is not certified as it is", input.name, kind.words())))
        }
    }
}

fn read_mesh(Input { name, reader, .. }: Input, format: Format, certify: Use<'_>) -> Result<Verdict, Failure> {
    let file = twinedge_meshes::read(reader, Some(format)).map_err(|error| Failure(format!("{name}: {error}")))?;
    let (half_edges, findings) = HalfEdgeMesh::link(&file.mesh, Collect::AtMost(LIST));
    if !findings.is_faultless() {
        let faults = findings.list().iter().filter(|finding| finding.kind().is_fault());
        return certify(wrong(faults.map(|finding| finding.counted_from(format.first_number()))));
    }
    certify(Source::Surface(&half_edges))
}

fn read_topology(Input { name, reader, .. }: Input, certify: Use<'_>) -> Result<Verdict, Failure> {
    let failed = |error| Failure(format!("{name}: {error}"));
    let topology = twinedge_postgis::read(reader, LIST).map_err(failed)?;
    let audit = twinedge_postgis::audit(&topology, LIST).map_err(failed)?;
    if !audit.is_valid() {
        return certify(wrong(audit.violations().iter().map(|violation| &violation.message)));
    }
    certify(Source::Plane(&Listed::of(&topology).map_err(failed)?))
}

fn read_textbook(Input { name, mut reader, .. }: Input, certify: Use<'_>) -> Result<Verdict, Failure> {
    let mut text = String::new();
    reader.read_to_string(&mut text).map_err(|error| Failure(format!("{name}: {error}")))?;
    let tables: Textbook = text.parse().map_err(|error| Failure(format!("{name}: {error}")))?;
    certify(Source::Plane(&tables))
}

/// Reads the first table of a file, and its expectation.
fn read_table(Input { name, reader, .. }: Input, certify: Use<'_>) -> Result<Verdict, Failure> {
    let failed = |error: &dyn Display| Failure(format!("{name}: {error}"));
    let mut expectation = Expectation::plane();
    for line in reader.lines() {
        let line = line.map_err(|error| failed(&error))?;
        let text = line.trim();
        if let Some(expect) = text.strip_prefix(EXPECT) {
            expectation = expect.parse().map_err(|error| failed(&error))?;
        } else if !text.is_empty() && !text.starts_with('#') {
            // A verdict may follow the table.
            let text = text.split_once('=').map_or(text, |(table, _)| table);
            let table: Table = text.trim().parse().map_err(|error| failed(&error))?;
            let is_plane = expectation.surface_kind() == Surface::Plane;
            if is_plane && expectation.is_open() {
                return Err(failed(&"planar subdivisions with an open boundary have no certificates"));
            }
            let report = validate(&table, &expectation, Collect::AtMost(LIST));
            // For a subdivision, the tests describe what fails.
            return certify(match report.is_valid() {
                false if expectation != Expectation::plane() => wrong(report.violations()),
                _ if is_plane => Source::Plane(&table),
                _ => Source::Surface(&table),
            });
        }
    }
    Err(failed(&"no table"))
}

fn wrong(lines: impl IntoIterator<Item = impl Display>) -> Source<'static> {
    Source::Wrong(lines.into_iter().fold(String::new(), |lines, line| format!("{lines}{line}\n")))
}
