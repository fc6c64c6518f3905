//! Reading a map from a file or from standard input, or using the built-in map.

use crate::output::{Failure, named};
use crate::progress::busy;
use indicatif::{ProgressBar, ProgressStyle};
use std::ffi::OsString;
use std::fs::{File, Metadata};
use std::io::{self, BufReader, IsTerminal as _, Read as _};
use std::path::{Path, PathBuf};
use std::sync::mpsc::sync_channel;
use std::time::{Duration, SystemTime};
use twinedge_layers::io::ForeignFormat;
use twinedge_layers::{Format, Layer, ReadError, read_layer, unpack};
use twinedge_report::{Counted, Counter, Imported, Input, Judged, Keep, MapOptions};

/// The built-in map of the world; see `data/README.md`.
const EMBEDDED: &[u8] = include_bytes!("../data/world-110m.geojson");
const EMBEDDED_NAME: &str = "world-110m.geojson (built in)";

/// The number of bytes that identify an archive.
const MAGIC: usize = 4;

/// Opens a file, standard input if the path is `-`, or the built-in map without a path. If the file is an archive, opens its content.
pub(crate) fn open(path: Option<&Path>, layer: Option<&str>) -> Result<Input, Failure> {
    let mut input = open_as_it_is(path, layer)?;
    let head: Vec<u8> = input.beginning()?.iter().copied().take(MAGIC).collect();
    let unpacked = unpack(&head, &mut input.reader, input.path.as_deref(), layer);
    let Some(unpacked) = unpacked.map_err(named(&input.name))? else {
        return Ok(input);
    };
    let inner = open_as_it_is(Some(&unpacked.path), unpacked.layer.as_deref())?;
    // Dropping this deletes the folder.
    Ok(Input { name: input.name, kept: Some(Box::new(unpacked)), ..inner })
}

fn open_as_it_is(path: Option<&Path>, layer: Option<&str>) -> Result<Input, Failure> {
    let input = match path {
        None => {
            refuse_piped()?;
            Input::new(EMBEDDED_NAME, Box::new(EMBEDDED), None)
        }
        Some(path) if path == Path::new("-") => {
            Input::new("standard input", Box::new(BufReader::new(io::stdin())), None)
        }
        Some(path) => {
            let name = path.display().to_string();
            let file = File::open(path).map_err(named(&name))?;
            if path.is_dir() {
                let foreign = ForeignFormat::of_folder(path).map(|foreign| ReadError::Foreign(foreign).to_string());
                let what = foreign.unwrap_or_else(|| "this is a folder, and a file is needed".to_owned());
                return Err(Failure(format!("{name}: {what}")));
            }
            let length = file.metadata().map_or(0, |metadata| metadata.len());
            Input::new(name, Box::new(BufReader::new(progress(length).wrap_read(file))), Some(path))
        }
    };
    Ok(Input { layer: layer.map(str::to_owned), ..input })
}

/// Refuses data on standard input, which would be ignored: a map in a pipe must not get the verdict on the built-in map. Another argument may name
/// standard input, as in `twinedge query overlay -`.
fn refuse_piped() -> Result<(), Failure> {
    /// The time in which data arrive, if there are any. A pipe may be open with nothing in it.
    const PATIENCE: Duration = Duration::from_millis(200);
    let is_named = |arg: OsString| {
        let text = arg.to_string_lossy();
        ["-", "/dev/stdin"].contains(&text.rsplit('=').next().unwrap_or_default())
    };
    if io::stdin().is_terminal() || std::env::args_os().skip(1).any(is_named) {
        return Ok(());
    }
    let (sender, receiver) = sync_channel(1);
    let look = move || {
        let has_data = matches!(io::stdin().read(&mut [0]), Ok(1));
        // Nobody waits for it any more if it comes late.
        let _ = sender.send(has_data);
    };
    // Without a thread nothing is known about standard input.
    let looks = std::thread::Builder::new().spawn(look).is_ok();
    if looks && receiver.recv_timeout(PATIENCE) == Ok(true) {
        return Err(Failure("there are data on standard input: give `-` as the file to read them".to_owned()));
    }
    Ok(())
}

/// A progress bar on standard error, if that is a terminal.
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
    pub(crate) options: MapOptions,
}

type State = (u64, Option<SystemTime>);

/// Identifies the bytes of an input while it is read.
pub(crate) struct Watch {
    before: Option<State>,
    counter: Option<Counter>,
}

impl Watch {
    /// Returns the number and SHA-256 of the bytes, once they are read, and whether the file is the same as before.
    pub(crate) fn judged(self, map: &MapFile) -> Result<(Option<Judged>, bool), Failure> {
        let judged = match self.counter {
            Some(counter) => Some(counter.judged()),
            None => map.judged()?,
        };
        Ok((judged, map.state() == self.before))
    }
}

pub(crate) struct WithText {
    pub(crate) name: String,
    pub(crate) layer: Layer,
    /// The text and its format, if the layer is GeoJSON.
    pub(crate) text: Option<(String, Format)>,
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
    pub(crate) fn path(&self) -> Option<&Path> {
        Some(self.file.as_path()).filter(|path| *path != Path::new("-"))
    }

    /// Returns the format of the file, if it is a layer and not an archive.
    pub(crate) fn format(&self) -> Result<Option<Format>, Failure> {
        let mut input = open_as_it_is(Some(&self.file), self.layer.as_deref())?;
        input.map_format().map_err(named(&input.name.clone()))
    }

    /// Reads the whole layer. Returns it with the name of the input.
    pub(crate) fn read(&self) -> Result<(String, Layer), Failure> {
        read_file(&self.file, self.layer.as_deref())
    }

    /// Reads the whole layer, and keeps its text if it is GeoJSON.
    pub(crate) fn read_with_text(&self) -> Result<WithText, Failure> {
        let mut input = open(Some(&self.file), self.layer.as_deref())?;
        let format = input.map_format().map_err(named(&input.name.clone()))?;
        let format =
            format.filter(|format| matches!(format, Format::GeoJson | Format::GeoJsonSeq) && input.kept.is_none());
        let Some(format) = format else {
            let (name, layer) = read_input(input)?;
            return Ok(WithText { name, layer, text: None });
        };
        let mut bytes = Vec::new();
        input.reader.read_to_end(&mut bytes).map_err(named(&input.name))?;
        let layer = read_layer(&mut &*bytes, input.path.as_deref(), &input.options()).map_err(named(&input.name))?;
        let text = String::from_utf8(bytes).ok().map(|text| (text, format));
        Ok(WithText { name: input.name, layer, text })
    }

    pub(crate) fn bytes(&self) -> Result<Vec<u8>, Failure> {
        let mut input = open_as_it_is(Some(&self.file), None)?;
        let mut bytes = Vec::new();
        input.reader.read_to_end(&mut bytes).map_err(named(&input.name))?;
        Ok(bytes)
    }
}

/// Reads a whole layer. Returns it with the name of the input.
pub(crate) fn read_file(path: &Path, layer: Option<&str>) -> Result<(String, Layer), Failure> {
    read_input(open(Some(path), layer)?)
}

fn read_input(mut input: Input) -> Result<(String, Layer), Failure> {
    input.map_format().map_err(named(&input.name.clone()))?;
    let options = input.options();
    let layer = read_layer(&mut input.reader, input.path.as_deref(), &options).map_err(named(&input.name))?;
    Ok((input.name, layer))
}

impl MapFile {
    pub(crate) fn path(&self) -> Option<&Path> {
        self.file.as_deref().filter(|path| *path != Path::new("-"))
    }

    /// Returns the number and SHA-256 of the bytes of the file or of the built-in map; `None` for an input that can only be read once.
    ///
    /// This reads the file again: some formats are read by path and not sequentially, and others may leave bytes after the last record unread.
    pub(crate) fn judged(&self) -> Result<Option<Judged>, Failure> {
        Ok(match &self.file {
            None => Some(Judged::of(EMBEDDED)?),
            Some(_) => match self.path().filter(|path| path.is_file()) {
                Some(path) => Some(Judged::of(BufReader::new(File::open(path)?))?),
                None => None,
            },
        })
    }

    pub(crate) fn layer(&self) -> Option<&str> {
        self.layer.as_deref()
    }

    /// Opens the input to read it once, and watches its bytes.
    pub(crate) fn open_watched(&self) -> Result<(Input, Watch), Failure> {
        let before = self.state();
        let mut input = self.open()?;
        let mut counter = None;
        // What was unpacked is another file, with a path.
        if self.file.is_some() && !self.path().is_some_and(Path::is_file) && input.kept.is_none() {
            let (reader, counted) = Counted::new(input.reader);
            input.reader = Box::new(reader);
            counter = Some(counted);
        }
        Ok((input, Watch { before, counter }))
    }

    /// Returns the length of the file and the time of its last change.
    fn state(&self) -> Option<State> {
        let metadata = std::fs::metadata(self.path()?).ok().filter(Metadata::is_file)?;
        Some((metadata.len(), metadata.modified().ok()))
    }

    pub(crate) fn open(&self) -> Result<Input, Failure> {
        open(self.file.as_deref(), self.layer())
    }

    /// Reads the map and builds it. Refuses a mesh.
    pub(crate) fn build(&self) -> Result<Imported, Failure> {
        self.build_keeping(Keep::default())
    }

    /// Reads the map, builds it and keeps the requested notes. Refuses a mesh.
    pub(crate) fn build_keeping(&self, keep: Keep<'_>) -> Result<Imported, Failure> {
        let mut input = self.open()?;
        let name = input.name.clone();
        if let Some(format) = input.mesh_format().map_err(named(&name))? {
            return Err(Failure(format!(
                "{name}: this is a mesh ({format}); only `twinedge audit` and `twinedge certify` take meshes"
            )));
        }
        self.build_from(input, keep)
    }

    /// Builds the map of an open input.
    pub(crate) fn build_from(&self, input: Input, keep: Keep<'_>) -> Result<Imported, Failure> {
        let name = input.name.clone();
        busy(|stage| Imported::read(input, &self.options, keep, stage)).map_err(named(&name))
    }
}

/// Parses a number of bytes, such as `4096`, `64K`, `256M` or `2G`.
pub(crate) fn size(text: &str) -> Result<u64, String> {
    let in_units =
        [("K", 10), ("M", 20), ("G", 30)].into_iter().find_map(|(unit, shift)| Some((text.strip_suffix(unit)?, shift)));
    let (number, shift) = in_units.unwrap_or((text, 0));
    let bytes = number.parse::<u64>().ok().and_then(|number| number.checked_mul(1 << shift));
    bytes.ok_or_else(|| "a number, or one with K, M or G behind it, as in 256M".to_owned())
}
