//! `twinedge query … neighbours`.

use super::borders::{SortBy, print_all};
use super::list::{Limit, TableFormat};
use super::which::{Source, Which};
use crate::output::style::{BAD, QUIET};
use crate::output::{Failure, measure, named, print_answer, print_json};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use twinedge_algorithm::claims::faces_of;
use twinedge_algorithm::neighbours::{of_feature, touching_feature};
use twinedge_map::FeatureId;
use twinedge_report::names::label;
use twinedge_report::{Condition, Imported, Measured, Units};

/// The neighbours of a feature: who shares a border with it, along which lines, and how long these are.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge query neighbours Switzerland
  twinedge query parcels.geojson neighbours '#12' --format json
  twinedge query parcels.geojson neighbours --id A-1
  twinedge query parcels.geojson neighbours --where owner=Meier
  twinedge query neighbours --all --geodesic --sort length --limit 20

Exit status: 0 there is an answer; 2 the input could not be read, or has no feature of that name.")]
pub(super) struct Neighbours {
    #[command(flatten)]
    which: Which,

    /// All pairs of neighbours, as a table: the border of one with the other, the part of it on which one ends and the other
    /// begins, and the area that both cover. With --geodesic that part is taken in proportion, where features overlap.
    #[arg(long)]
    all: bool,

    #[command(flatten)]
    measured: Measured,

    /// With --all: what to sort by.
    #[arg(long, value_enum, default_value_t, requires = "all")]
    sort: SortBy,

    #[command(flatten)]
    limit: Limit,

    /// Output format; csv with --all only.
    #[arg(long, value_enum, default_value_t)]
    format: TableFormat,
}

#[derive(Debug, Serialize)]
struct NeighboursAnswer<'a> {
    input: &'a str,
    unit: &'static str,
    feature: String,
    id: usize,
    neighbours: Vec<Border>,
    touching: Vec<Named>,
    overlaps: Vec<Overlap>,
}

#[derive(Debug, Serialize)]
struct Border {
    #[serde(flatten)]
    with: Named,
    length: f64,
    borders: Vec<Vec<[f64; 2]>>,
}

#[derive(Debug, Serialize)]
struct Named {
    name: String,
    id: usize,
}

#[derive(Debug, Serialize)]
struct Overlap {
    #[serde(flatten)]
    with: Named,
    faces: usize,
    area: f64,
}

impl Neighbours {
    pub(super) const fn condition(&self) -> Option<&Condition> {
        self.which.condition()
    }

    pub(super) fn units(&self, imported: &Imported) -> Result<Units, Failure> {
        Units::of(imported, self.measured.geodesic).map_err(named(&imported.name))
    }

    pub(super) fn answer(&self, asked: &Source, units: &Units) -> Result<(), Failure> {
        match (self.all, self.which.is_given()) {
            (true, false) => return print_all(asked, units, self.sort, &self.limit, self.format),
            (true, true) => return Err(Failure("--all is about all features: ask for none".to_owned())),
            (false, _) => {}
        }
        let mut answer = NeighboursAnswer::new(asked, units, self.which.find(asked)?);
        self.limit.cut(&mut answer.neighbours);
        match self.format {
            TableFormat::Text => print_answer(&answer.text(units)?),
            TableFormat::Csv => Err(Failure("--format csv is for the table of --all".to_owned())),
            TableFormat::Json => print_json(&answer),
        }
    }
}

impl<'a> NeighboursAnswer<'a> {
    fn new(Source { input, map, .. }: &'a Source, units: &Units, feature: FeatureId) -> Self {
        let named = |feature| Named { name: label(map, feature), id: feature.index() };
        let mut shared: BTreeMap<FeatureId, (usize, f64)> = BTreeMap::new();
        for face in faces_of(map, feature) {
            let area = map.dcel().face(face).map_or(0.0, |face| units.area(map, face));
            for other in map.features_of(face).into_iter().flatten().filter(|f| *f != feature) {
                let (faces, sum) = shared.entry(other).or_default();
                *faces += 1;
                *sum += area;
            }
        }
        let neighbours = of_feature(map, feature).into_iter().map(|n| Border {
            with: named(n.neighbour),
            length: match units {
                Units::Plane(_) => n.length,
                Units::Geodesic(_) => n.borders.iter().map(|chain| units.length(chain)).sum(),
            },
            borders: n.borders.into_iter().map(|chain| chain.into_iter().map(Into::into).collect()).collect(),
        });
        Self {
            input,
            unit: units.name(),
            feature: label(map, feature),
            id: feature.index(),
            neighbours: neighbours.collect(),
            touching: touching_feature(map, feature).into_iter().map(named).collect(),
            overlaps: shared.into_iter().map(|(f, (faces, area))| Overlap { with: named(f), faces, area }).collect(),
        }
    }

    fn text(&self, units: &Units) -> Result<String, std::fmt::Error> {
        let mut out = String::new();
        let Self { input, feature, .. } = self;
        writeln!(out, "{feature}\n{QUIET}{input}{QUIET:#}\n")?;
        let width = self.neighbours.iter().map(|n| n.with.name.chars().count()).max().unwrap_or(0);
        for Border { with, length, borders } in &self.neighbours {
            let lines = if borders.len() == 1 { "line" } else { "lines" };
            writeln!(out, "  {:width$}  {:>10} in {} {lines}", with.name, measure(*length), borders.len())?;
        }
        if self.neighbours.is_empty() {
            writeln!(out, "  no neighbours across an edge")?;
        }
        for Named { name, .. } in &self.touching {
            writeln!(out, "  touches {name} at a vertex only")?;
        }
        for Overlap { with, faces, area } in &self.overlaps {
            let name = &with.name;
            writeln!(
                out,
                "  {BAD}overlap{BAD:#}: {faces} face(s) of area {} are claimed by {name} too",
                measure(*area)
            )?;
        }
        writeln!(out, "\n{QUIET}{}{QUIET:#}", units.sentence())?;
        Ok(out)
    }
}
