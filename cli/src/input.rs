//! Reading a map from a file or from standard input, or the built-in map.

use crate::noted::{Keep, Noted};
use crate::output::counted;
use crate::progress::busy;
use crate::status::Failure;
use indicatif::{ProgressBar, ProgressStyle};
use sha2::{Digest as _, Sha256};
use std::ffi::OsStr;
use std::fmt::Display;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use twinedge::geometry::noding::Snap;
use twinedge::io::ReadSummary;
use twinedge::map::{BuildError, BuildSummary, Builder, Feature, Noding, PlanarMap};
use twinedge_formats::layer::{
    Crs, Format, Layer, ReadError, ReadOptions, Unpacked, format_of, read, read_layer, to_map, unpack,
};
use twinedge_formats::mesh::Format as MeshFormat;

/// The built-in map of the world; see `data/README.md`.
const EMBEDDED: &[u8] = include_bytes!("../data/world-110m.geojson");
const EMBEDDED_NAME: &str = "world-110m.geojson (built in)";

/// The bytes that tell an archive.
const MAGIC: usize = 4;

/// Why a map could not be read or built.
#[derive(Debug, thiserror::Error)]
enum InputError {
    #[error(transparent)]
    Read(#[from] ReadError),
    #[error(transparent)]
    Build(#[from] BuildError),
}

/// An input, opened.
pub(crate) struct Input {
    pub(crate) name: String,
    pub(crate) reader: Box<dyn BufRead>,
    /// The path, if it is a file.
    path: Option<PathBuf>,
    /// The format that the name tells.
    format: Option<Format>,
    /// The format of meshes that the name tells.
    mesh_format: Option<MeshFormat>,
    /// The layer that was asked for, if the file may have several.
    pub(crate) layer: Option<String>,
    /// The file that was in an archive; it goes when this is dropped.
    unpacked: Option<Unpacked>,
}

/// A map that was read and built.
pub(crate) struct Imported {
    /// The name of the input.
    pub(crate) name: String,
    /// The numbers of what was read and dropped.
    pub(crate) read: ReadSummary,
    pub(crate) map: PlanarMap,
    /// What was found while it was gathered.
    pub(crate) summary: BuildSummary,
    /// The notes on the features.
    pub(crate) noted: Noted,
    /// The builder of the map, if it was kept and the map is not plane or was snapped to a grid that was asked for.
    pub(crate) builder: Option<Builder>,
    /// The coordinate reference system, if the file names one.
    pub(crate) crs: Option<Crs>,
    /// True if the format says which way rings turn.
    pub(crate) orients_rings: bool,
}

impl Input {
    /// Opens a file, standard input where the path is `-`, or the built-in map where there is none. Of an archive, what is in it is
    /// opened.
    fn open(path: Option<&Path>, layer: Option<&str>) -> Result<Self, Failure> {
        let mut input = Self::open_as_it_is(path, layer)?;
        let head: Vec<u8> = input.beginning()?.iter().copied().take(MAGIC).collect();
        let path = input.path.as_deref();
        let unpacked = unpack(&head, &mut input.reader, path, layer);
        let Some(unpacked) = unpacked.map_err(|error| Failure(format!("{}: {error}", input.name)))? else {
            return Ok(input);
        };
        let inner = Self::open_as_it_is(Some(&unpacked.path), unpacked.layer.as_deref())?;
        Ok(Self { name: input.name, unpacked: Some(unpacked), ..inner })
    }

    fn open_as_it_is(path: Option<&Path>, layer: Option<&str>) -> Result<Self, Failure> {
        let (name, reader): (_, Box<dyn BufRead>) = match path {
            None => (EMBEDDED_NAME.to_owned(), Box::new(EMBEDDED)),
            Some(path) if path == Path::new("-") => {
                ("standard input".to_owned(), Box::new(BufReader::new(io::stdin())))
            }
            Some(path) => {
                let name = path.display().to_string();
                let file = File::open(path).map_err(|error| Failure(format!("{name}: {error}")))?;
                let length = file.metadata().map_or(0, |metadata| metadata.len());
                (name, Box::new(BufReader::new(progress(length).wrap_read(file))))
            }
        };
        let (format, mesh_format) = (path.and_then(Format::of_path), path.and_then(MeshFormat::of_name));
        let path = path.filter(|path| *path != Path::new("-")).map(Path::to_owned);
        Ok(Self { name, reader, path, format, mesh_format, layer: layer.map(str::to_owned), unpacked: None })
    }

    /// The way to read its layer.
    fn options(&self) -> ReadOptions {
        ReadOptions { layer: self.layer.clone(), ..ReadOptions::default() }
    }

    /// Its first bytes, without reading them.
    pub(crate) fn beginning(&mut self) -> Result<&[u8], Failure> {
        self.reader.fill_buf().map_err(|error| Failure(format!("{}: {error}", self.name)))
    }

    /// The format if it is a map. A layer that is asked of a format whose files have one is refused.
    fn map_format(&mut self) -> Result<Option<Format>, Failure> {
        let options = self.options();
        let head = self.reader.fill_buf().map_err(|error| Failure(format!("{}: {error}", self.name)))?;
        let Ok(format) = format_of(head, self.path.as_deref(), &options) else { return Ok(None) };
        if !matches!(format, Format::GeoPackage | Format::TopoJson) {
            self.refuse_layer(format)?;
        }
        Ok(Some(format))
    }

    /// Refuses a layer that was asked for, unless it has the name of the file.
    pub(crate) fn refuse_layer(&self, what: impl Display) -> Result<(), Failure> {
        let of_file = self.path.as_deref().and_then(Path::file_stem);
        match self.layer.as_deref().filter(|layer| of_file != Some(OsStr::new(layer))) {
            None => Ok(()),
            Some(layer) => Err(Failure(format!(
                "{}: there is no layer {layer:?}: this is {what}, and --layer is for files with several layers: GeoPackage, TopoJSON, and \
                 zip archives",
                self.name
            ))),
        }
    }

    /// The format if it is a mesh: by its name, or else by how it begins.
    pub(crate) fn mesh_format(&mut self) -> Result<Option<MeshFormat>, Failure> {
        match (self.mesh_format, self.format) {
            (None, None) => Ok(MeshFormat::of_content(self.beginning()?)),
            (by_name, _) => Ok(by_name),
        }
    }
}

/// What was gathered of a file.
struct Gathered {
    name: String,
    builder: Builder,
    read: ReadSummary,
    noted: Noted,
    crs: Option<Crs>,
    orients_rings: bool,
}

/// Reads features into a builder, and hands each on.
fn gather(
    reader: &mut dyn Read,
    path: Option<&Path>,
    options: &ReadOptions,
    noted: &mut Noted,
    keep: Keep<'_>,
    each: &mut dyn FnMut(Feature),
) -> Result<(Builder, ReadSummary, Option<Crs>), InputError> {
    let mut builder = Builder::new();
    let mut summary = ReadSummary::default();
    let header = read(reader, path, options, &mut |feature| {
        let mut of_map = to_map(&feature, &mut summary);
        noted.note(&mut of_map, &feature, keep);
        builder.feature(&of_map).map_err(ReadError::refused)?;
        each(of_map);
        Ok(())
    })?;
    summary.other_crs += usize::from(header.crs.as_ref().is_some_and(Crs::is_other));
    Ok((builder, summary, header.crs))
}

/// The SHA-256 in hexadecimal digits.
fn sha256(mut reader: impl BufRead) -> Result<String, Failure> {
    let mut digest = Sha256::new();
    loop {
        let bytes = reader.fill_buf()?;
        if bytes.is_empty() {
            return Ok(digest.finalize().iter().fold(String::new(), |digits, byte| format!("{digits}{byte:02x}")));
        }
        digest.update(bytes);
        let length = bytes.len();
        reader.consume(length);
    }
}

/// A bar on standard error, if that is a terminal.
fn progress(bytes: u64) -> ProgressBar {
    let bar = ProgressBar::new(bytes);
    if let Ok(style) = ProgressStyle::with_template("reading {bar:40} {bytes}/{total_bytes}, {eta} left") {
        bar.set_style(style);
    }
    bar
}

/// The file that is named on the command line.
#[derive(Debug, clap::Args)]
pub(crate) struct MapFile {
    /// A file of GeoJSON, newline-delimited GeoJSON, TopoJSON, well-known text or binary, a Shapefile, a GeoPackage, GeoParquet or FlatGeobuf,
    /// or `-` for standard input; also in a zip archive or as gzip data. `audit` and `certify` take meshes as well: OBJ, OFF, PLY, STL. Default: the
    /// built-in map of the world.
    file: Option<PathBuf>,

    /// The layer to read of a file with several: the table of a GeoPackage, the object of a TopoJSON, the file of a zip archive.
    #[arg(long, value_name = "NAME")]
    layer: Option<String>,

    #[command(flatten)]
    cutting: Cutting,

    /// Take the names of features from this column (property). Default: name, NAME, Name, ADMIN, admin, title or id, the first
    /// that there is.
    #[arg(long, value_name = "COLUMN", global = true)]
    name_from: Option<String>,

    /// Accept a file without lines and polygons, such as an empty layer or one of points.
    #[arg(long)]
    allow_empty: bool,
}

/// A layer that is named on the command line.
#[derive(Debug, clap::Args)]
pub(crate) struct LayerFile {
    /// The file to read, or `-` for standard input: GeoJSON, newline-delimited GeoJSON, TopoJSON, well-known text or binary, a
    /// Shapefile, a GeoPackage, GeoParquet or FlatGeobuf; also in a zip archive or as gzip data.
    file: PathBuf,

    /// The layer to read of a file with several: the table of a GeoPackage, the object of a TopoJSON, the file of a zip archive.
    #[arg(long, value_name = "NAME")]
    layer: Option<String>,
}

impl LayerFile {
    /// The path of the input, if it is a file.
    pub(crate) fn path(&self) -> Option<&Path> {
        Some(self.file.as_path()).filter(|path| *path != Path::new("-"))
    }

    /// Reads all of it: the name of the input, and the layer.
    pub(crate) fn read(&self) -> Result<(String, Layer), Failure> {
        let mut input = Input::open(Some(&self.file), self.layer.as_deref())?;
        input.map_format()?;
        let options = input.options();
        let layer = read_layer(&mut input.reader, input.path.as_deref(), &options)
            .map_err(|error| Failure(format!("{}: {error}", input.name)))?;
        Ok((input.name, layer))
    }
}

/// The treatment of segments that cross, touch or overlap.
#[derive(Debug, clap::Args)]
pub(crate) struct Cutting {
    /// Cut segments wherever they cross, touch or overlap, and round all points to a grid. `auto` chooses the finest grid that
    /// the coordinates allow. SIZE is the greatest width of its cells: the width is the largest power of two up to it.
    #[arg(long, value_name = "auto|SIZE", value_parser = snap, allow_negative_numbers = true)]
    snap: Option<Snap>,
}

impl MapFile {
    /// The path of the input, if it is a file.
    pub(crate) fn path(&self) -> Option<&Path> {
        self.file.as_deref().filter(|path| *path != Path::new("-"))
    }

    /// The SHA-256 of the file as it is, or of the built-in map, in hexadecimal digits; none of what can be read but once.
    ///
    /// The file is read once more for it: some formats are read by their path and not from the start to the end, and of others what
    /// follows the last record may be left unread.
    pub(crate) fn sha256(&self) -> Result<Option<String>, Failure> {
        match &self.file {
            None => sha256(EMBEDDED).map(Some),
            Some(_) => match self.path().filter(|path| path.is_file()) {
                Some(path) => sha256(BufReader::new(File::open(path)?)).map(Some),
                None => Ok(None),
            },
        }
    }

    /// The layer that was asked for.
    pub(crate) fn layer(&self) -> Option<&str> {
        self.layer.as_deref()
    }

    /// Opens the input.
    pub(crate) fn open(&self) -> Result<Input, Failure> {
        Input::open(self.file.as_deref(), self.layer())
    }

    /// Reads the map and builds it. A mesh is refused.
    pub(crate) fn build(&self) -> Result<Imported, Failure> {
        self.build_keeping(Keep::default())
    }

    /// Reads the map, builds it and keeps what is asked for. A mesh is refused.
    pub(crate) fn build_keeping(&self, keep: Keep<'_>) -> Result<Imported, Failure> {
        let mut input = self.open()?;
        if let Some(format) = input.mesh_format()? {
            return Err(Failure(format!(
                "{}: this is a mesh ({format}); only `twinedge audit` and `twinedge certify` take meshes",
                input.name
            )));
        }
        self.build_from(input, keep)
    }

    /// Returns true if segments are to be cut.
    pub(crate) const fn is_snapped(&self) -> bool {
        self.cutting.snap.is_some()
    }

    fn gather(&self, mut input: Input, keep: Keep<'_>, each: &mut dyn FnMut(Feature)) -> Result<Gathered, Failure> {
        let orients_rings = input.map_format()?.is_some_and(Format::orients_rings);
        let options = input.options();
        let Input { name, mut reader, path, unpacked: _folder, .. } = input;
        let mut noted = Noted::new(self.name_from.clone());
        let (builder, read, crs) = gather(&mut reader, path.as_deref(), &options, &mut noted, keep, each)
            .map_err(|error| Failure(format!("{name}: {error}")))?;
        self.refuse_empty(&name, &read)?;
        noted.refuse_unknown_columns(&name, keep)?;
        Ok(Gathered { name, builder, read, noted, crs, orients_rings })
    }

    /// Reads the features that were opened, and builds no map of them: it has only their names.
    pub(crate) fn features_from(&self, input: Input, keep: Keep<'_>) -> Result<(Imported, Vec<Feature>), Failure> {
        let mut features = Vec::new();
        let gathered = self.gather(input, keep, &mut |feature| features.push(feature))?;
        let Gathered { name, builder, read, noted, crs, orients_rings } = gathered;
        let summary = builder.summary().clone();
        drop(builder);
        let mut names = Builder::new();
        for feature in &features {
            names.feature(&Feature { name: feature.name.clone(), ..Feature::default() })?;
        }
        let map = names.build()?;
        Ok((Imported { name, read, map, summary, noted, builder: None, crs, orients_rings }, features))
    }

    /// Builds the map that was opened.
    pub(crate) fn build_from(&self, input: Input, keep: Keep<'_>) -> Result<Imported, Failure> {
        let gathered = self.gather(input, keep, &mut drop)?;
        let Gathered { name, builder, read, noted, crs, orients_rings } = gathered;
        let failed = |error: InputError| Failure(format!("{name}: {error}"));
        let built = busy("building the map", || match self.cutting.snap {
            None if keep.coverage => builder.build_keeping(),
            None => Ok((builder.build()?, None)),
            // What a grid that was asked for removed or made is found by comparing.
            Some(snap @ Snap::Size(_)) if keep.coverage => {
                let map = builder.clone().build_with(Noding::Snap(snap))?;
                Ok((map, Some(builder)))
            }
            Some(snap) => Ok((builder.build_with(Noding::Snap(snap))?, None)),
        });
        let (map, builder) = built.map_err(|error| failed(error.into()))?;
        let summary = map.summary().clone();
        Ok(Imported { name, read, map, summary, noted, builder, crs, orients_rings })
    }

    /// Refuses a file of which no map can be built.
    fn refuse_empty(&self, name: &str, read: &ReadSummary) -> Result<(), Failure> {
        if self.allow_empty || read.polygons + read.lines > 0 {
            return Ok(());
        }
        let features = counted(read.features, "feature");
        let found = match (read.features, read.points) {
            (0, _) => "no features".to_owned(),
            (_, 0) => format!("{features}, none with a geometry"),
            (_, points) => format!("{features} with {} and nothing else", counted(points, "point")),
        };
        Err(Failure(format!(
            "{name}: a map is made of lines and polygons, and this file has {found}; --allow-empty accepts it"
        )))
    }
}

/// The argument of `--list` and the like.
pub(crate) fn whole(text: &str) -> Result<usize, String> {
    text.parse().map_err(|_| "not a whole number".to_owned())
}

/// The argument of `--snap`.
pub(crate) fn snap(text: &str) -> Result<Snap, String> {
    if text == "auto" {
        return Ok(Snap::Auto);
    }
    match text.parse() {
        Ok(size) if size > 0.0 && f64::is_finite(size) => Ok(Snap::Size(size)),
        _ => Err("neither `auto` nor a positive number".to_owned()),
    }
}
