//! `twinedge convert`: a layer in another format.

use crate::input::LayerFile;
use crate::output::style::BAD;
use crate::output::{Failure, Verdict, counted, named, plain, print, print_bytes};
use crate::output_file::{write_file, write_files};
use same_file::is_same_file;
use std::borrow::Cow;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use twinedge_layers::{Format, Layer, Loss, WriteError, files, losses, refuse_losses, write, write_path};
use twinedge_osm::TagFilter;
use twinedge_report::clean::Written;

/// Write a layer in another format, with nothing lost.
///
/// Geometries with all their dimensions, ids, attributes with their types, the order of features, foreign members and the coordinate
/// reference system are kept. Content that the other format cannot hold is an error that names it, and with `--lossy` a warning.
/// Coordinates are not transformed.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge convert counties.shp -o counties.geojson
  twinedge convert luxembourg.osm.pbf --boundaries admin_level=6 -o cantons.gpkg
  twinedge convert cadastre.gpkg --layer parcels -o parcels.shp --id-column parcel
  twinedge convert parcels.geojson -o - --to wkt | head

Exit status: 0 it is written; 2 it could not be read, or cannot be written without loss.")]
pub(crate) struct Convert {
    #[command(flatten)]
    input: LayerFile,

    /// The input is a file of `OpenStreetMap`, .osm.pbf: take the boundaries with these tags, KEY=VALUE or KEY, separated by commas.
    #[arg(long, value_name = "TAGS", conflicts_with = "layer")]
    boundaries: Option<TagFilter>,

    #[command(flatten)]
    output: LayerOutput,
}

/// The file of a layer that is written, and its format.
#[derive(Debug, clap::Args)]
pub(crate) struct LayerOutput {
    /// File to write; its extension says in which format: .geojson, .geojsonl, .wkt, .wkb, .shp, .gpkg, .fgb, .parquet. `-` is standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// The format, whatever the extension.
    #[arg(long, value_name = "FORMAT", value_enum)]
    to: Option<Target>,

    /// Write the ids of features as values of this column, where the format cannot hold them.
    #[arg(long, value_name = "NAME")]
    id_column: Option<String>,

    /// Write the rest if the format cannot hold everything, and warn.
    #[arg(long)]
    lossy: bool,
}

/// A format to write.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Target {
    Geojson,
    Geojsonl,
    Wkt,
    Wkb,
    Shapefile,
    Geopackage,
    Flatgeobuf,
    Geoparquet,
}

impl From<Target> for Format {
    fn from(target: Target) -> Self {
        match target {
            Target::Geojson => Self::GeoJson,
            Target::Geojsonl => Self::GeoJsonSeq,
            Target::Wkt => Self::Wkt,
            Target::Wkb => Self::Wkb,
            Target::Shapefile => Self::Shapefile,
            Target::Geopackage => Self::GeoPackage,
            Target::Flatgeobuf => Self::FlatGeobuf,
            Target::Geoparquet => Self::GeoParquet,
        }
    }
}

impl LayerOutput {
    /// Returns true if an output is requested.
    pub(crate) const fn is_given(&self) -> bool {
        self.output.is_some()
    }

    /// Returns true if the layer goes to standard output, which then takes nothing else.
    pub(crate) fn is_stdout(&self) -> bool {
        self.output.as_deref() == Some(Path::new("-"))
    }

    /// Refuses a layer that cannot be written as requested, before any work is done.
    pub(crate) fn refuse(&self, layer: &Layer) -> Result<(), Failure> {
        self.output.as_deref().map_or(Ok(()), |path| self.prepared(layer, path).map(drop))
    }

    /// Returns the requested path, if it is a file.
    pub(crate) fn path(&self) -> Option<&Path> {
        self.output.as_deref().filter(|path| *path != Path::new("-"))
    }

    /// Returns the format, as far as the options tell it.
    pub(crate) fn format(&self) -> Option<Format> {
        let of_path = self.output.as_deref().and_then(Format::of_path);
        self.to.map(Format::from).or(of_path).or_else(|| self.is_stdout().then_some(Format::GeoJson))
    }

    /// Returns the output file, or the main one of several.
    pub(crate) fn main_file(&self) -> Option<PathBuf> {
        self.path().map(|path| match self.format() {
            Some(Format::Shapefile) => path.with_extension("shp"),
            _ => path.to_owned(),
        })
    }

    /// Returns the layer as written to this path, and the format.
    fn prepared<'a>(&self, layer: &'a Layer, path: &Path) -> Result<(Cow<'a, Layer>, Format), Failure> {
        let name = path.display();
        let format = self
            .format()
            .ok_or_else(|| Failure(format!("{name}: the extension does not say which format to write; --to does")))?;
        let mut layer = Cow::Borrowed(layer);
        let loses_ids = |layer: &Layer| losses(layer, format).iter().any(|loss| matches!(loss, Loss::Ids(_)));
        if let Some(column) = self.id_column.as_deref().filter(|_| loses_ids(&layer)) {
            layer.to_mut().move_ids(column).map_err(|error| Failure(format!("{name}: --id-column: {error}")))?;
        }
        if !self.lossy {
            refuse_losses(&layer, format).map_err(|error| {
                let advice = match error {
                    WriteError::Loss { .. } if loses_ids(&layer) => {
                        "; --id-column NAME keeps ids, --lossy writes the rest"
                    }
                    WriteError::Loss { .. } => "; --lossy writes the rest",
                    _ => "",
                };
                Failure(format!("{name}: {error}{advice}"))
            })?;
        }
        Ok((layer, format))
    }

    pub(crate) fn refuse_input(&self, input: &Path) -> Result<(), Failure> {
        match self.output.as_deref() {
            Some(output) if is_same_file(output, input).unwrap_or(false) => {
                Err(Failure(format!("{}: this is an input, and is not overwritten", output.display())))
            }
            _ => Ok(()),
        }
    }

    /// Writes the text of a layer in this format. Returns `None` if no file is requested.
    pub(crate) fn write_text(
        &self,
        text: &str,
        format: Format,
        input: Option<&Path>,
    ) -> Result<Option<Written>, Failure> {
        let Some(path) = self.output.as_deref() else { return Ok(None) };
        match self.path() {
            Some(path) => write_file(path, input, text.as_bytes())?,
            None => print_bytes(text.as_bytes())?,
        }
        Ok(Some(Written { name: path.display().to_string(), format }))
    }

    pub(crate) fn refuse_other(&self, format: Format) -> Result<(), Failure> {
        let of_path = self.path().and_then(Format::of_path);
        match self.to.map(Format::from).or(of_path).filter(|asked| *asked != format) {
            Some(asked) => {
                let what = "--memory, --tiles: the output is in the format of the input";
                Err(Failure(format!("{what}, which is {format}, and not {asked}")))
            }
            None => Ok(()),
        }
    }

    /// Writes a layer piece by piece in this format. Returns `None` if no file is requested.
    pub(crate) fn write_with(
        &self,
        format: Format,
        input: &Path,
        write: impl FnOnce(&mut dyn Write) -> Result<(), Failure>,
    ) -> Result<Option<Written>, Failure> {
        let Some(path) = self.output.as_deref() else { return Ok(None) };
        match self.path() {
            Some(path) => write_files(path, &[path.to_owned()], [input], |path| {
                let mut out = BufWriter::new(File::create(path)?);
                write(&mut out)?;
                Ok(out.flush()?)
            })?,
            None => write(&mut BufWriter::new(std::io::stdout().lock()))?,
        }
        Ok(Some(Written { name: path.display().to_string(), format }))
    }

    /// Writes a layer, and warns about lost parts. Returns `None` if no file is requested.
    pub(crate) fn write(&self, layer: &Layer, input: Option<&Path>) -> Result<Option<Written>, Failure> {
        let Some(path) = self.output.as_deref() else { return Ok(None) };
        let (layer, format) = self.prepared(layer, path)?;
        let name = path.display().to_string();
        let failed = |error: WriteError| Failure(format!("{name}: {error}"));
        if self.is_stdout() {
            let mut out = BufWriter::new(std::io::stdout().lock());
            let written = write(&layer, &mut out, format).map_err(failed);
            match written.and_then(|()| Ok(out.flush()?)) {
                // A closed pipe is not an error.
                Err(Failure(message)) if message.contains("Broken pipe") => {}
                other => other?,
            }
        } else {
            let path = self.main_file().unwrap_or_else(|| path.to_owned());
            let all = files(&path, format);
            write_files(&path, &all, input, |path| write_path(&layer, path, format).map_err(failed))?;
        }
        for loss in losses(&layer, format) {
            anstream::eprintln!("{BAD}warning{BAD:#}: {format} does not hold {}", plain(&loss.to_string()));
        }
        Ok(Some(Written { name, format }))
    }
}

impl Convert {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        if !self.output.is_given() {
            return Err(Failure("no file to write was given: -o FILE".to_owned()));
        }
        let (name, layer) = match &self.boundaries {
            Some(tags) => self.boundaries(tags)?,
            None => self.input.read()?,
        };
        let written = self.output.write(&layer, self.input.path())?;
        if let Some(Written { name: to, format }) = written.filter(|_| !self.output.is_stdout()) {
            let count = counted(layer.features.len(), "feature");
            print(&format!("{}: {count} written to {} ({format})\n", plain(&name), plain(&to)))?;
        }
        Ok(Verdict::Sound)
    }

    /// Reads boundaries, and warns if errors in their relations make polygons invalid.
    fn boundaries(&self, tags: &TagFilter) -> Result<(String, Layer), Failure> {
        let path = self.input.path();
        let path = path.ok_or_else(|| Failure("--boundaries: a file .osm.pbf is needed".to_owned()))?;
        let name = path.display().to_string();
        let found = twinedge_osm::read(path, tags, 0).map_err(named(&name))?;
        if found.violation_count() > 0 {
            let count = counted(found.violation_count() as usize, "fault");
            anstream::eprintln!(
                "{BAD}warning{BAD:#}: the relations have {count}, which `twinedge audit --boundaries` lists"
            );
        }
        Ok((name, found.layer))
    }
}
