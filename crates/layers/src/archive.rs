//! Layers in zip archives and in gzip data, unpacked to a temporary folder or in memory.

use super::error::{ArchiveError, ReadError};
use super::files::Files;
use crate::io::{ForeignFormat, Format};
use flate2::bufread::MultiGzDecoder;
use std::cell::{Cell, RefCell};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, ErrorKind, Read, Seek, Write as _};
use std::path::{Path, PathBuf};
use tempfile::TempDir;
use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

/// The size in bytes to which any archive may expand.
const SMALL: u64 = 64 << 20;

/// The factor by which an archive may expand beyond that. Zeros shrink by a factor of 1,000, layers by 5 to 50.
const RATIO: u64 = 200;

impl From<ZipError> for ReadError {
    fn from(error: ZipError) -> Self {
        match error {
            ZipError::Io(error) => error.into(),
            other => ArchiveError::Damaged(other.to_string()).into(),
        }
    }
}

/// An unpacked layer. The folder is removed when this is dropped.
#[derive(Debug)]
pub struct Unpacked {
    /// The path of the layer.
    pub path: PathBuf,
    /// The layer to read from the file, if one must still be chosen.
    pub layer: Option<String>,
    _folder: TempDir,
}

/// Unpacks the layer of a zip archive or of gzip data, which begins with these bytes. Returns `None` for other data, without
/// reading anything. In a zip archive with several layers, `wanted` selects the file with this name, with or without extension.
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
    let Some(packing) = Packing::of(head) else { return Ok(None) };
    let mut packed = tempfile::tempfile()?;
    let size = io::copy(reader, &mut packed)?;
    packed.rewind()?;
    let folder = TempDir::new()?;
    let target = Target { place: Place::Folder(folder.path()), room: Cell::new(room(size)) };
    let (name, layer) = packing.unpack(BufReader::new(packed), path, wanted, &target)?;
    Ok(Some(Unpacked { path: folder.path().join(name), layer, _folder: folder }))
}

/// A layer unpacked in memory.
#[derive(Clone, Debug)]
pub struct UnpackedFiles {
    /// The files of the layer, without folders.
    pub files: Files,
    /// The main file.
    pub path: PathBuf,
    /// The layer to read from the file, if one must still be chosen.
    pub layer: Option<String>,
}

/// Unpacks like [`unpack`], from memory to memory.
///
/// # Errors
/// [`ReadError::Archive`] and [`ReadError::Layers`].
pub fn unpack_bytes(
    packed: &[u8],
    path: Option<&Path>,
    wanted: Option<&str>,
) -> Result<Option<UnpackedFiles>, ReadError> {
    let Some(packing) = Packing::of(packed) else { return Ok(None) };
    let files = RefCell::new(Files::default());
    let target = Target { place: Place::Memory(&files), room: Cell::new(room(packed.len() as u64)) };
    let (path, layer) = packing.unpack(Cursor::new(packed), path, wanted, &target)?;
    Ok(Some(UnpackedFiles { files: files.into_inner(), path, layer }))
}

/// Packs files into a zip archive.
///
/// # Errors
/// The errors of [`zip::ZipWriter`], for too many files or bytes.
pub fn zip(files: &Files) -> io::Result<Vec<u8>> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    for (path, bytes) in files.iter() {
        archive.start_file(path.to_string_lossy(), options)?;
        archive.write_all(bytes)?;
    }
    Ok(archive.finish()?.into_inner())
}

#[derive(Clone, Copy)]
enum Packing {
    Zip,
    Gzip,
}

impl Packing {
    fn of(head: &[u8]) -> Option<Self> {
        match ForeignFormat::of_content(head) {
            Some(ForeignFormat::Zip) => Some(Self::Zip),
            Some(ForeignFormat::Gzip) => Some(Self::Gzip),
            _ => None,
        }
    }

    fn unpack(
        self,
        packed: impl BufRead + Seek,
        path: Option<&Path>,
        wanted: Option<&str>,
        target: &Target<'_>,
    ) -> Result<Main, ReadError> {
        match self {
            Self::Zip => unpack_zip(packed, wanted, target),
            Self::Gzip => unpack_gzip(packed, path, wanted, target),
        }
    }
}

/// The name of the main file, and the layer in it that must still be chosen.
type Main = (PathBuf, Option<String>);

/// Returns the size in bytes to which an archive of this size may expand.
const fn room(size: u64) -> u64 {
    SMALL + RATIO.saturating_mul(size)
}

struct Target<'a> {
    place: Place<'a>,
    room: Cell<u64>,
}

enum Place<'a> {
    Folder(&'a Path),
    Memory(&'a RefCell<Files>),
}

impl Target<'_> {
    fn put(&self, name: &Path, mut content: impl Read) -> Result<(), ReadError> {
        let room = self.room.get();
        let mut limited = content.by_ref().take(room);
        let written = match self.place {
            Place::Folder(folder) => io::copy(&mut limited, &mut File::create(folder.join(name))?).map_err(damaged)?,
            Place::Memory(files) => {
                let mut bytes = Vec::new();
                let written = limited.read_to_end(&mut bytes).map_err(damaged)?;
                files.borrow_mut().insert(name, bytes);
                written as u64
            }
        };
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

fn unpack_gzip(
    packed: impl BufRead,
    path: Option<&Path>,
    wanted: Option<&str>,
    target: &Target<'_>,
) -> Result<Main, ReadError> {
    // The content determines the format of a stream.
    let name: PathBuf = path.and_then(Path::file_stem).unwrap_or("layer".as_ref()).into();
    target.put(&name, MultiGzDecoder::new(packed))?;
    Ok((name, wanted.map(str::to_owned)))
}

fn unpack_zip(packed: impl Read + Seek, wanted: Option<&str>, target: &Target<'_>) -> Result<Main, ReadError> {
    let mut archive = ZipArchive::new(packed)?;
    let mut files: Vec<(usize, PathBuf)> = Vec::new();
    for number in 0..archive.len() {
        let entry = archive.by_index(number)?;
        // The macOS Finder adds files of its own.
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

/// Returns true if the name belongs to a layer, and not to a part of one.
fn is_main(path: &Path) -> bool {
    let has = |extension: &str| path.extension().is_some_and(|found| found.eq_ignore_ascii_case(extension));
    match Format::of_path(path) {
        Some(Format::Shapefile) => has("shp"),
        Some(_) => true,
        None => has("json"),
    }
}
