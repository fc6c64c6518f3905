//! `twinedge query … lattice`.

use super::which::Source;
use crate::output::style::{BAD, GOOD};
use crate::output::{Failure, Format, grouped, print_answer, print_json};
use serde::Serialize;
use std::fmt::Write as _;
use twinedge_algorithm::lattice::of_map;

/// Lattice points and Pick's theorem, A = I + B / 2 - 1 + h, for every bounded face. All coordinates must be integers.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge query parcels.geojson lattice
  twinedge query - lattice --format json < polygon.geojson

Exit status: 0 there is an answer; 2 the input could not be read, or has coordinates that are no integers.")]
pub(super) struct Lattice {
    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Debug, Serialize)]
struct LatticeAnswer<'a> {
    input: &'a str,
    faces: Vec<Row>,
    ok: bool,
}

#[derive(Debug, Serialize)]
struct Row {
    face: usize,
    area_doubled: i128,
    interior: i128,
    boundary: i128,
    holes: i128,
    pick_holds: bool,
}

impl Lattice {
    pub(super) fn answer(&self, asked: &Source) -> Result<(), Failure> {
        let Source { input, map, .. } = asked;
        let found = of_map(map).map_err(|error| Failure(format!("{input}: {error}")))?;
        let mut faces = Vec::with_capacity(found.faces.len());
        for (face, count) in &found.faces {
            faces.push(Row {
                face: map.dcel().face(*face)?.index(),
                area_doubled: count.area_doubled,
                interior: count.interior,
                boundary: count.boundary,
                holes: count.holes,
                pick_holds: count.pick_holds(),
            });
        }
        let answer = LatticeAnswer { input, faces, ok: found.pick_holds() };
        match self.format {
            Format::Json => print_json(&answer),
            Format::Text => print_answer(&answer.text()?),
        }
    }
}

impl LatticeAnswer<'_> {
    fn text(&self) -> Result<String, std::fmt::Error> {
        let mut out = String::new();
        writeln!(out, "  {:>6}  {:>14}  {:>14}  {:>14}  {:>6}", "face", "2A", "I", "B", "h")?;
        for row in &self.faces {
            let [doubled, interior, boundary] = [row.area_doubled, row.interior, row.boundary].map(grouped);
            let holds = if row.pick_holds { "" } else { "  A is not I + B/2 - 1 + h" };
            let (face, holes) = (format!("f{}", row.face), row.holes);
            writeln!(out, "  {face:>6}  {doubled:>14}  {interior:>14}  {boundary:>14}  {holes:>6}{BAD}{holds}{BAD:#}")?;
        }
        if self.ok {
            writeln!(out, "\n{GOOD}A = I + B/2 - 1 + h{GOOD:#} for every face, and for their sum")?;
        } else {
            writeln!(out, "\n{BAD}A = I + B/2 - 1 + h does not hold everywhere{BAD:#}")?;
        }
        Ok(out)
    }
}
