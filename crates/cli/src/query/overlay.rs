//! `twinedge query … overlay`.

use super::list::{Rows, csv, greatest_first};
use crate::input::open;
use crate::output::{Failure, measure, named, plain};
use crate::progress::busy;
use clap::ValueEnum;
use serde::Serialize;
use std::fmt::Write as _;
use std::path::PathBuf;
use twinedge_report::{Imported, MapOptions, Measured, Shared, Units, shared};

/// The area that each feature has in common with each of another layer, or with none of them.
///
/// `twinedge overlay` writes the pieces themselves.
#[derive(Debug, clap::Args)]
#[command(
    name = "overlay",
    after_help = "Examples:
  twinedge query soils.gpkg overlay parcels.gpkg
  twinedge query counties.geojson overlay lakes.geojson --geodesic --sort area --limit 10 --format csv

Exit status: 0 there is an answer; 2 a layer could not be read, or the layers cannot be compared."
)]
pub(super) struct OverlayOf {
    /// The other layer.
    second: PathBuf,

    /// The layer to read of the other file, if it has several.
    #[arg(long, value_name = "NAME")]
    second_layer: Option<String>,

    #[command(flatten)]
    measured: Measured,

    /// The column to sort by.
    #[arg(long, value_enum, default_value_t)]
    sort: SortBy,

    #[command(flatten)]
    rows: Rows,
}

/// The order of pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum SortBy {
    /// The features of the first layer in their order, then the features of the second.
    #[default]
    Features,
    /// The area, the largest first.
    Area,
}

#[derive(Debug, Serialize)]
struct OverlayAnswer<'a> {
    input: &'a str,
    other: &'a str,
    unit: &'static str,
    pairs: &'a [Shared],
}

const HEADINGS: [&str; 3] = ["first", "second", "area"];

impl OverlayOf {
    pub(super) fn answer(&self, imported: &Imported, options: &MapOptions) -> Result<(), Failure> {
        let units = Units::of(imported, self.measured.geodesic).map_err(named(&imported.name))?;
        let other = open(Some(&self.second), self.second_layer.as_deref())?;
        let name = other.name.clone();
        let found = busy(|stage| shared(imported, other, options, &units, stage));
        let mut pairs = found.map_err(named(&imported.name))?;
        if self.sort == SortBy::Area {
            greatest_first(&mut pairs, |pair| pair.area);
        }
        self.rows.cut(&mut pairs);
        let (input, other) = (&*imported.name, &*plain(&name));
        let text = || {
            let mut out = String::new();
            for Shared { first, second, area } in &pairs {
                let [first, second] = [first, second].map(|one| one.as_ref().map_or("–", |one| &one.label));
                writeln!(out, "{:>16}  {first}, {second}", measure(*area))?;
            }
            Ok(out)
        };
        let answer = OverlayAnswer { input, other, unit: units.name(), pairs: &pairs };
        self.rows.print(&units, text, || csv(pairs.iter().map(Shared::row), &HEADINGS), &answer)
    }
}
