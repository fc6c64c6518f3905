//! `twinedge clean`: a layer of polygons without overlaps, narrow gaps and slivers.

mod cleaning;
mod json;
mod text;

use crate::convert::LayerOutput;
use crate::coverage_arguments::AcceptedGaps;
use crate::input::LayerFile;
use crate::output::{Format, json, print, print_json};
use crate::status::{Failure, Verdict};
use cleaning::{Cleaning, Names};
use std::collections::BTreeMap;
use std::time::Instant;
use twinedge::algorithm::clean::{Options, Winner};
use twinedge::geometry::noding::Snap;
use twinedge_formats::layer::clean::{CleanOptions, LayerChange, clean};

/// Repair a layer of polygons: cut borders where they meet, and resolve overlaps, small gaps and slivers.
///
/// Each place belongs to one feature afterwards. Overlaps go to one of the features that claim them. Gaps that are small, or at most
/// as wide as --gap-width, and slivers go to the neighbour with the longest common border. Spikes and repeated points are dropped,
/// and polygons are valid by the OGC. The width of a gap is its mean width: twice the area by the length of the border. A wider gap is
/// left whole, and the report says so.
///
/// Of several features that cover the same place one keeps it; the others keep their attributes and have no geometry any more, of
/// which a warning is given.
///
/// Ids, attributes, the order of features and foreign members are kept, and so is the geometry of features in which nothing
/// changed. Vertices keep their further dimensions; for new ones these are interpolated. Lines and points are left as they are.
///
/// No point moves, unless borders cross where there is none, or --snap asks for a grid. Cleaning the output again changes nothing.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge clean counties.shp --dry-run                         only say what would be done
  twinedge clean counties.shp -o clean.shp
  twinedge clean parcels.geojson -o parcels.gpkg --snap 0.001 --gap-width 0.05
  twinedge clean zones.gpkg -o zones.gpkg.new --to geopackage --overlap first --sliver 25

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

    /// Round all points to a grid first: points within the same cell become one. SIZE is the greatest width of the cells: the width
    /// is the largest power of two up to it.
    #[arg(long, value_name = "auto|SIZE", value_parser = crate::input::snap, allow_negative_numbers = true)]
    snap: Option<Snap>,

    /// The feature that gets what several claim.
    #[arg(long, value_name = "WHICH", value_enum, default_value_t)]
    overlap: Claim,

    /// Greatest mean width of a gap that is filled, in the units of the coordinates, and greatest distance between two borders that
    /// face each other where the space between them is open to the outside or to a wider gap: it is filled as well. Default: only gaps smaller than --sliver are.
    #[arg(long, value_name = "W", value_parser = crate::coverage_arguments::positive)]
    gap_width: Option<f64>,

    #[command(flatten)]
    accepted: AcceptedGaps,

    /// Area below which gaps are filled and thin parts of features given away. A part is thin if 4π · area / perimeter² is below 0.2: a
    /// rectangle 14 times as long as wide. Default: a thousandth of the median area of all parts, measured after overlaps are resolved.
    #[arg(long, value_name = "A", value_parser = crate::coverage_arguments::positive)]
    sliver: Option<f64>,

    /// Output format of the report.
    #[arg(long, value_enum, default_value_t)]
    format: Format,

    /// Greatest number of changes to list in the text; all are counted.
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = crate::input::whole, allow_negative_numbers = true)]
    list: usize,
}

/// The feature that gets what several claim.
#[derive(Clone, Copy, Debug, Default, clap::ValueEnum)]
enum Claim {
    /// One that lies inside another, but for a tenth of its area; if there is none, the one with the largest area.
    #[default]
    Inner,
    /// The one with the largest area, the first of those.
    Larger,
    /// The one with the smallest area, the first of those.
    Smaller,
    /// The first in the file.
    First,
    /// The last in the file.
    Last,
}

impl From<Claim> for Winner {
    fn from(claim: Claim) -> Self {
        match claim {
            Claim::Inner => Self::Inner,
            Claim::Larger => Self::Larger,
            Claim::Smaller => Self::Smaller,
            Claim::First => Self::First,
            Claim::Last => Self::Last,
        }
    }
}

impl Clean {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
        if !self.dry_run && !self.output.is_given() {
            return Err(Failure("neither a file to write (-o FILE) nor --dry-run was given".to_owned()));
        }
        let (name, mut layer) = self.input.read()?;
        let names = Names { from: self.name_from.as_deref() };
        names.refuse_unknown(&name, &layer)?;
        self.output.refuse(&layer)?;
        let assign = Options {
            winner: self.overlap.into(),
            gap_width: self.gap_width,
            lake_width: self.accepted.lake_width,
            accepted_gaps: self.accepted.accept_gap.clone(),
            sliver_area: self.sliver,
            ..Options::default()
        };
        let report = clean(&mut layer, &CleanOptions { snap: self.snap, assign })
            .map_err(|error| Failure(format!("{name}: {error}")))?;
        let written = self.output.write(&layer, self.input.path())?;
        let elapsed = start.elapsed().as_secs_f64() * 1000.0;
        let mut changes: BTreeMap<usize, Vec<&LayerChange>> = BTreeMap::new();
        for change in &report.changes {
            let won = change.to.filter(|to| !change.from.contains(to));
            for feature in change.from.iter().copied().chain(won) {
                changes.entry(feature).or_default().push(change);
            }
        }
        let cleaned = Cleaning {
            name: &name,
            names,
            layer: &layer,
            report: &report,
            written: written.as_ref(),
            greatest_gap: self.accepted.lake_width.or(self.gap_width),
            changes,
            elapsed,
        };
        match self.format {
            // Standard output has the layer.
            Format::Text if self.output.is_stdout() => anstream::eprint!("{}", cleaned.text(self.list)?),
            Format::Json if self.output.is_stdout() => eprint!("{}", String::from_utf8_lossy(&json(&cleaned.json())?)),
            Format::Text => print(&cleaned.text(self.list)?)?,
            Format::Json => print_json(&cleaned.json())?,
        }
        Ok(if report.left.is_none() { Verdict::Sound } else { Verdict::Wrong })
    }
}
