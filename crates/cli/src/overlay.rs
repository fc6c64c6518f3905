//! `twinedge overlay`: two layers laid over each other.

use crate::convert::LayerOutput;
use crate::input::{LayerFile, read_file};
use crate::output::{Failure, Verdict, counted, named, plain, print};
use std::path::PathBuf;
use twinedge_geometry::noding::Snap;
use twinedge_layers::{Keep, overlay};
use twinedge_report::clean::Written;

/// Lay two layers over each other: the pieces that they cut each other into, with the attributes of both.
///
/// A piece is the place that a feature of the first layer and one of the second have in common, or that one layer covers alone. Where both
/// have a column of one name, the second layer's column gets a number. Ids become columns. Lines and points are left out. `twinedge query FILE overlay SECOND`
/// prints the areas alone.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge overlay soils.gpkg parcels.gpkg -o pieces.gpkg
  twinedge overlay counties.shp lakes.shp --keep first-only -o dry.shp

Exit status: 0 it is written; 2 a layer could not be read, or the pieces cannot be written without loss.")]
pub(crate) struct Overlay {
    #[command(flatten)]
    first: LayerFile,

    /// The second layer, in any of these formats.
    second: PathBuf,

    /// The layer to read of the second file, if it has several.
    #[arg(long, value_name = "NAME")]
    second_layer: Option<String>,

    /// The pieces to write.
    #[arg(long, value_enum, default_value_t)]
    keep: Kept,

    /// Round all points to a grid with cells of this greatest width. `auto` chooses the finest grid that the coordinates allow; it is also what is
    /// taken where borders cross or touch.
    #[arg(long, value_name = "auto|SIZE", value_parser = twinedge_report::snap, allow_negative_numbers = true)]
    snap: Option<Snap>,

    #[command(flatten)]
    output: LayerOutput,
}

/// The pieces to write.
#[derive(Clone, Copy, Debug, Default, clap::ValueEnum)]
enum Kept {
    /// Those that either layer covers.
    #[default]
    Either,
    /// Those that both layers cover.
    Both,
    /// All of the first layer.
    First,
    /// Those that the first layer alone covers.
    FirstOnly,
}

impl From<Kept> for Keep {
    fn from(kept: Kept) -> Self {
        match kept {
            Kept::Either => Self::Either,
            Kept::Both => Self::Both,
            Kept::First => Self::First,
            Kept::FirstOnly => Self::FirstOnly,
        }
    }
}

impl Overlay {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        if !self.output.is_given() {
            return Err(Failure("no file to write was given: -o FILE".to_owned()));
        }
        let (name, first) = self.first.read()?;
        let (other, second) = read_file(&self.second, self.second_layer.as_deref())?;
        let both = format!("{name}, {other}");
        let pieces = overlay(&first, &second, self.keep.into(), self.snap).map_err(named(&both))?;
        self.output.refuse_input(&self.second)?;
        let written = self.output.write(&pieces, self.first.path())?;
        if let Some(Written { name: to, format }) = written.filter(|_| !self.output.is_stdout()) {
            let count = counted(pieces.features.len(), "piece");
            print(&format!("{}: {count} written to {} ({format})\n", plain(&both), plain(&to)))?;
        }
        Ok(Verdict::Sound)
    }
}
