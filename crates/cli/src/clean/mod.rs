//! `twinedge clean`: a layer of polygons without overlaps, narrow gaps and slivers.

mod patch;
mod tiles;

use crate::convert::LayerOutput;
use crate::input::{LayerFile, WithText};
use crate::output::{Failure, Format, Verdict, json, named, print, print_json};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;
use std::time::Instant;
use twinedge_coverage::clean::{Options, Winner};
use twinedge_geometry::noding::Snap;
use twinedge_layers::clean::CleanOptions;
use twinedge_report::clean::{Cleaning, Names, Repair};
use twinedge_report::{AcceptedGaps, Division, positive};

/// Repair a layer of polygons: cut borders where they meet, and resolve overlaps, small gaps and slivers.
///
/// Each place belongs to one feature afterwards. Overlaps go to one of the features that claim them. Gaps that are small, or at most
/// as wide as --gap-width, and slivers go to the neighbour with the longest common border. Spikes and repeated points are dropped,
/// and polygons are valid by the OGC. The width of a gap is its mean width: twice the area by the length of the border. A wider gap is
/// left whole, and the report says so.
///
/// Of several features that cover the same places one keeps them. The others keep their attributes and lose their geometry; a warning names
/// them.
///
/// Ids, attributes, the order of features and foreign members are kept, and so is the geometry of features in which nothing
/// changed. From GeoJSON to GeoJSON all bytes stay, except in changed geometries. Vertices keep their further dimensions; for new ones these are interpolated. Lines and points are left as they are.
///
/// No point moves, unless borders cross where there is none, or --snap asks for a grid. Cleaning the output again changes nothing.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge clean counties.shp --dry-run                         only say what would be done
  twinedge clean counties.shp -o clean.shp
  twinedge clean parcels.geojson -o parcels.gpkg --snap 0.001 --gap-width 0.05
  twinedge clean zones.gpkg -o zones.gpkg.new --to geopackage --overlap first --sliver 25
  twinedge clean lots.geojson -o clean.geojson --gap-width auto --gaps-to use=road --patch clean.patch.json
  twinedge clean cadastre.geojsonl -o clean.geojsonl --memory 2G     of any size
  twinedge clean --undo clean.patch.json clean.geojson -o lots.geojson.old --to geojson

Exit status: 0 the output is a coverage, `twinedge audit --coverage` finds nothing; 1 something is left, and the report says \
what; 2 the input could not be read, or the output not written.")]
pub(crate) struct Clean {
    #[command(flatten)]
    input: LayerFile,

    #[command(flatten)]
    output: LayerOutput,

    /// In the report, call features by this column. Default: name, NAME, Name, ADMIN, admin, title or id, the first that there is.
    #[arg(long, value_name = "COLUMN")]
    name_from: Option<String>,

    /// Only report what would be done.
    #[arg(long, conflicts_with = "output")]
    dry_run: bool,

    /// Round all points to a grid first: points within the same cell become one. SIZE is the width of the cells: with 0.001,
    /// coordinates have three decimal places, and such coordinates stay.
    #[arg(long, value_name = "auto|SIZE", value_parser = twinedge_report::snap, allow_negative_numbers = true)]
    snap: Option<Snap>,

    /// The feature that gets what several claim.
    #[arg(long, value_name = "WHICH", value_parser = winner(), default_value = "inner")]
    overlap: Winner,

    /// Greatest mean width of a gap that is filled, in the units of the coordinates, and greatest distance between two borders that
    /// face each other where the space between them is open to the outside or to a wider gap: it is filled as well. `auto` takes the widest gap
    /// that is ten times narrower than the next wider one, or than the median part of a feature, and says so. Default: only gaps smaller than
    /// --sliver are filled.
    #[arg(long, value_name = "auto|W", value_parser = gap_width)]
    gap_width: Option<GapWidth>,

    /// Give the gaps that are filled to the feature with this value: to the neighbour that has it, or else to the first feature that has it, or
    /// else to a new feature with it, behind the others. Its parts are no slivers, so none is given away.
    #[arg(long, value_name = "COLUMN=VALUE", value_parser = column_value)]
    gaps_to: Option<(String, String)>,

    #[command(flatten)]
    accepted: AcceptedGaps,

    /// Area below which gaps are filled and thin parts of features given away. A part is thin if 4π · area / perimeter² is below 0.2: a
    /// rectangle 14 times as long as wide. Default: a thousandth of the median area of all parts, measured after overlaps are resolved.
    #[arg(long, value_name = "A", value_parser = positive)]
    sliver: Option<f64>,

    /// Write the geometries of the features that changed, before and after, to this file of JSON, by which --undo takes them back.
    #[arg(long, value_name = "FILE", requires = "output", conflicts_with = "dry_run")]
    patch: Option<PathBuf>,

    /// Take back what a patch says instead: FILE is the output that was written with it, byte for byte. Of GeoJSON that was made of GeoJSON the bytes
    /// of the input come back, of other formats the geometries of the features.
    #[arg(long, value_name = "PATCH", requires = "output", conflicts_with_all = [
        "patch", "dry_run", "name_from", "snap", "overlap", "gap_width", "gaps_to", "lake_width", "accept_gap", "sliver", "format", "list",
    ])]
    undo: Option<PathBuf>,

    /// Clean a file of GeoJSON or newline-delimited GeoJSON that is larger than memory. It is judged by tiles: as many as it takes to judge each within SIZE, as 800M or
    /// 2G, in the folder for temporary files (TMPDIR). Only the neighbourhoods of faults are read and cleaned. If one does not fit into SIZE it stays as it is, and the
    /// report says so. The output has the format of the input.
    #[arg(long, value_name = "SIZE", value_parser = crate::input::size, conflicts_with_all = ["tiles", "snap", "gaps_to", "patch", "undo"])]
    memory: Option<u64>,

    /// Like --memory with N by N tiles, in memory, and neighbourhoods of any size.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024), conflicts_with_all = ["snap", "gaps_to", "patch", "undo"])]
    tiles: Option<u32>,

    /// Output format of the report.
    #[arg(long, value_enum, default_value_t)]
    format: Format,

    /// Greatest number of changes to list in the text; all are counted.
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = twinedge_report::whole, allow_negative_numbers = true)]
    list: usize,
}

/// A width of gaps on the command line.
#[derive(Clone, Copy, Debug)]
enum GapWidth {
    Auto,
    Of(f64),
}

fn gap_width(text: &str) -> Result<GapWidth, String> {
    match text {
        "auto" => Ok(GapWidth::Auto),
        _ => positive(text).map(GapWidth::Of).map_err(|_| "neither `auto` nor a positive number".to_owned()),
    }
}

fn column_value(text: &str) -> Result<(String, String), String> {
    let pair = text.split_once('=').filter(|(column, _)| !column.is_empty());
    pair.map(|(column, value)| (column.to_owned(), value.to_owned()))
        .ok_or_else(|| "not of the form COLUMN=VALUE".to_owned())
}

/// The choices of the feature that gets what several claim.
fn winner() -> impl TypedValueParser<Value = Winner> {
    let names = [
        (
            "inner",
            "One that lies inside another, but for a tenth of its area; if there is none, the one with the largest area",
        ),
        ("larger", "The one with the largest area, the first of those"),
        ("smaller", "The one with the smallest area, the first of those"),
        ("first", "The first in the file"),
        ("last", "The last in the file"),
    ];
    let values = names.map(|(name, help)| PossibleValue::new(name).help(help));
    PossibleValuesParser::new(values).map(|name| Winner::of_name(&name).unwrap_or_default())
}

impl Clean {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
        if let Some(undo) = &self.undo {
            return patch::undo(undo, &self.input, &self.output);
        }
        if !self.dry_run && !self.output.is_given() {
            return Err(Failure("neither a file to write (-o FILE) nor --dry-run was given".to_owned()));
        }
        if let Some(division) = self.memory.map(Division::Within).or(self.tiles.map(Division::Across)) {
            return self.in_tiles(division, start);
        }
        let WithText { name, mut layer, text } = self.input.read_with_text()?;
        self.output.refuse(&layer)?;
        let repair = self.repair();
        let count = layer.features.len();
        let report = repair.clean(&mut layer).map_err(named(&name))?;
        let cleaned = patch::Cleaned { count, text, after: &layer, report: &report };
        let written = cleaned.write(&self.input, &self.output, self.patch.as_deref())?;
        let patch = self.patch.as_ref().map(|path| path.display().to_string());
        let mut cleaned = Cleaning::new(&name, &repair, &layer, &report);
        cleaned.written = written.as_ref();
        cleaned.patch = patch.as_deref();
        self.say(cleaned, start)?;
        Ok(if report.left.is_none() { Verdict::Sound } else { Verdict::Wrong })
    }

    fn say(&self, mut cleaned: Cleaning<'_>, start: Instant) -> Result<(), Failure> {
        cleaned.elapsed_ms = start.elapsed().as_secs_f64() * 1000.0;
        match self.format {
            // The layer goes to standard output.
            Format::Text if self.output.is_stdout() => anstream::eprint!("{}", cleaned.text(self.list)?),
            Format::Json if self.output.is_stdout() => eprint!("{}", String::from_utf8_lossy(&json(&cleaned.json())?)),
            Format::Text => print(&cleaned.text(self.list)?)?,
            Format::Json => print_json(&cleaned.json())?,
        }
        Ok(())
    }

    fn repair(&self) -> Repair<'_> {
        let assign = Options {
            winner: self.overlap,
            gap_width: match self.gap_width {
                Some(GapWidth::Of(width)) => Some(width),
                Some(GapWidth::Auto) | None => None,
            },
            lake_width: self.accepted.lake_width,
            accepted_gaps: self.accepted.accept_gap.iter().copied().map(Into::into).collect(),
            sliver_area: self.sliver,
            ..Options::default()
        };
        let chooses_width = matches!(self.gap_width, Some(GapWidth::Auto));
        Repair {
            names: Names { from: self.name_from.as_deref() },
            options: CleanOptions { snap: self.snap, assign, chooses_width, gaps_to: None },
            gaps_to: self.gaps_to.as_ref().map(|(column, value)| (&**column, &**value)),
        }
    }
}
