//! `twinedge query … neighbours`.

use super::asked::Asked;
use super::names::{find, label};
use crate::output::style::{BAD, QUIET};
use crate::output::{Format, measure, print, print_json};
use crate::status::Failure;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use twinedge::algorithm::area::face_area;
use twinedge::algorithm::coverage::faces_of;
use twinedge::algorithm::neighbours::{of_feature, touching_feature};
use twinedge::map::FeatureId;

/// The neighbours of a feature: who shares a border with it, along which lines, and how long these are in the units of the coordinates.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge query neighbours Switzerland
  twinedge query parcels.geojson neighbours '#12' --format json

Exit status: 0 there is an answer; 2 the input could not be read, or has no feature of that name.")]
pub(super) struct Neighbours {
    /// The feature.
    name: String,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Debug, Serialize)]
struct Answer<'a> {
    input: &'a str,
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
    pub(super) fn answer(&self, asked: &Asked) -> Result<(), Failure> {
        let answer = Answer::new(asked, find(asked, &self.name)?);
        match self.format {
            Format::Text => print(&answer.text()?),
            Format::Json => print_json(&answer),
        }
    }
}

impl<'a> Answer<'a> {
    fn new(Asked { input, map }: &'a Asked, feature: FeatureId) -> Self {
        let named = |feature| Named { name: label(map, feature), id: feature.index() };
        let mut shared: BTreeMap<FeatureId, (usize, f64)> = BTreeMap::new();
        for face in faces_of(map, feature) {
            let area = face_area(map, face).unwrap_or_default();
            for other in map.features_of(face).into_iter().flatten().filter(|f| *f != feature) {
                let (faces, sum) = shared.entry(other).or_default();
                *faces += 1;
                *sum += area;
            }
        }
        let neighbours = of_feature(map, feature).into_iter().map(|n| Border {
            with: named(n.neighbour),
            length: n.length,
            borders: n.borders.into_iter().map(|chain| chain.into_iter().map(Into::into).collect()).collect(),
        });
        Self {
            input,
            feature: label(map, feature),
            id: feature.index(),
            neighbours: neighbours.collect(),
            touching: touching_feature(map, feature).into_iter().map(named).collect(),
            overlaps: shared.into_iter().map(|(f, (faces, area))| Overlap { with: named(f), faces, area }).collect(),
        }
    }

    fn text(&self) -> Result<String, std::fmt::Error> {
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
        Ok(out)
    }
}
