//! Layers in zip archives and in gzip data, unpacked to a folder for temporary files.

use super::error::{ArchiveError, ReadError};
use flate2::read::MultiGzDecoder;
use std::cell::Cell;
use std::fs::File;
use std::io::{self, BufReader, ErrorKind, Read, Seek as _};
use std::path::{Path, PathBuf};
use tempfile::TempDir;
use twinedge::io::{ForeignFormat, Format};
use zip::ZipArchive;
use zip::result::ZipError;

/// Bytes to which any archive may expand.
const SMALL: u64 = 64 << 20;

/// By how much an archive may expand beyond that. Zeros shrink by a factor of 1,000, layers by one of 5 to 50.
const RATIO: u64 = 200;

impl From<ZipError> for ReadError {
    fn from(error: ZipError) -> Self {
        match error {
            ZipError::Io(error) => error.into(),
            other => ArchiveError::Damaged(other.to_string()).into(),
        }
    }
}

/// A layer that was unpacked. The folder goes when this is dropped.
#[derive(Debug)]
pub struct Unpacked {
    /// The path of the layer.
    pub path: PathBuf,
    /// The layer that is to be read of the file, if that still is to be chosen.
    pub layer: Option<String>,
    _folder: TempDir,
}

/// Unpacks the layer of a zip archive or of gzip data, which begins with these bytes; none, if it is neither, and then nothing was read.
/// Of a zip archive with several layers, the wanted one is that of the file with this name, with or without extension.
///
/// Archives that expand to more than 64 MiB and 200 times their size are refused.
///
/// # Errors
/// [`ReadError::Archive`], [`ReadError::Layers`] and [`ReadError::Io`].
pub fn unpack(
    head: &[u8],
    reader: &mut dyn Read,
    path: Option<&Path>,
    wanted: Option<&str>,
) -> Result<Option<Unpacked>, ReadError> {
    let unpack = match ForeignFormat::of_content(head) {
        Some(ForeignFormat::Zip) => unpack_zip,
        Some(ForeignFormat::Gzip) => unpack_gzip,
        _ => return Ok(None),
    };
    let mut packed = tempfile::tempfile()?;
    let size = io::copy(reader, &mut packed)?;
    packed.rewind()?;
    let target = Target { folder: TempDir::new()?, room: Cell::new(SMALL + RATIO.saturating_mul(size)) };
    let (name, layer) = unpack(packed, path, wanted, &target)?;
    Ok(Some(Unpacked { path: target.folder.path().join(name), layer, _folder: target.folder }))
}

/// The name of the main file, and the layer that is still to be chosen in it.
type Main = (PathBuf, Option<String>);

/// The folder to which files are unpacked.
struct Target {
    folder: TempDir,
    /// The number of bytes that there is room for.
    room: Cell<u64>,
}

impl Target {
    fn put(&self, name: &Path, mut content: impl Read) -> Result<(), ReadError> {
        let room = self.room.get();
        let mut file = File::create(self.folder.path().join(name))?;
        let written = io::copy(&mut content.by_ref().take(room), &mut file).map_err(damaged)?;
        self.room.set(room - written);
        if written == room && content.read(&mut [0]).map_err(damaged)? > 0 {
            return Err(ArchiveError::Expands { times: RATIO }.into());
        }
        Ok(())
    }
}

fn damaged(error: io::Error) -> ReadError {
    match error.kind() {
        ErrorKind::InvalidData | ErrorKind::InvalidInput | ErrorKind::UnexpectedEof => {
            ArchiveError::Damaged(error.to_string()).into()
        }
        _ => error.into(),
    }
}

fn unpack_gzip(packed: File, path: Option<&Path>, wanted: Option<&str>, target: &Target) -> Result<Main, ReadError> {
    // The content tells the format of a stream.
    let name: PathBuf = path.and_then(Path::file_stem).unwrap_or("layer".as_ref()).into();
    target.put(&name, MultiGzDecoder::new(BufReader::new(packed)))?;
    Ok((name, wanted.map(str::to_owned)))
}

fn unpack_zip(packed: File, _: Option<&Path>, wanted: Option<&str>, target: &Target) -> Result<Main, ReadError> {
    let mut archive = ZipArchive::new(BufReader::new(packed))?;
    let mut files: Vec<(usize, PathBuf)> = Vec::new();
    for number in 0..archive.len() {
        let entry = archive.by_index(number)?;
        // Finder of macOS adds files of its own.
        let path = entry.enclosed_name().filter(|path| entry.is_file() && !path.starts_with("__MACOSX"));
        files.extend(path.map(|path| (number, path)));
    }
    let mains: Vec<&PathBuf> = files.iter().map(|(_, path)| path).filter(|path| is_main(path)).collect();
    let is_wanted = |path: &&&PathBuf| {
        let names = [path.file_name(), path.file_stem(), Some(path.as_os_str())];
        wanted.is_some_and(|wanted| names.contains(&Some(wanted.as_ref())))
    };
    let (main, layer) = match (&mains[..], mains.iter().find(is_wanted)) {
        ([], _) => return Err(ArchiveError::NoLayer.into()),
        (_, Some(main)) => (*main, None),
        ([main], None) => (*main, wanted),
        (several, None) => {
            let layers = several.iter().map(|path| path.display().to_string()).collect();
            return Err(ReadError::Layers { wanted: wanted.map(str::to_owned), layers });
        }
    };
    for (number, path) in files.iter().filter(|(_, path)| path.with_extension("") == main.with_extension("")) {
        let name = path.file_name().map(PathBuf::from).unwrap_or_default();
        target.put(&name, archive.by_index(*number)?)?;
    }
    Ok((main.file_name().map(PathBuf::from).unwrap_or_default(), layer.map(str::to_owned)))
}

/// Returns true if the name is that of a layer, and not of a part of one.
fn is_main(path: &Path) -> bool {
    let has = |extension: &str| path.extension().is_some_and(|found| found.eq_ignore_ascii_case(extension));
    match Format::of_path(path) {
        Some(Format::Shapefile) => has("shp"),
        Some(_) => true,
        None => has("json"),
    }
}
