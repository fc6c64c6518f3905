//! Esri Shapefile: geometries in `.shp`, index in `.shx`, attributes in `.dbf`, reference system in `.prj`, character set in
//! `.cpg`.
//!
//! Read and written here because the crate `shapefile` 0.9 cannot write features without geometry, among others, and the crate
//! `dbase` 0.8 reads columns of type `F` with 32 bits and whole numbers as floating-point numbers.
//!
//! Sources: "ESRI Shapefile Technical Description" (1998); the description of dBASE III files by the Library of Congress
//! (fdd000326).

mod charset;
mod columns;
mod dbf;
mod failed;
mod record;
mod rings;
mod storage;

use super::crs::Crs;
use super::each::Each;
use super::error::{Cause, Place, ReadError, WriteError};
use super::files::Files;
use super::model::{Feature, Field, Geometry, Header, Layer};
use crate::io::Format;
use columns::{ShapeKind, shape_kind};
use dbf::Table;
use failed::{content, truncated};
use std::io::{self, BufReader, Read, Seek as _, SeekFrom};
use std::path::{Path, PathBuf};
use storage::ReadSeek;

pub(super) use columns::losses;
pub(super) use storage::Storage;

const HEADER: usize = 100;

const FILE_CODE: [u8; 4] = 9_994_i32.to_be_bytes();

const VERSION: i32 = 1_000;

/// Returns the file of the same name with another extension, in lower or upper case, if it exists.
fn beside(storage: Storage<'_>, path: &Path, extension: &str) -> Option<PathBuf> {
    let all = [extension.to_owned(), extension.to_ascii_uppercase()];
    all.iter().map(|extension| path.with_extension(extension)).find(|path| storage.has(path))
}

/// Returns the text of a small file of the same name.
fn text_beside(storage: Storage<'_>, path: &Path, extension: &str) -> io::Result<Option<String>> {
    const LARGEST: u64 = 1 << 20;
    let Some(path) = beside(storage, path, extension) else { return Ok(None) };
    let mut bytes = Vec::new();
    storage.open(&path)?.0.take(LARGEST).read_to_end(&mut bytes)?;
    let text = String::from_utf8_lossy(&bytes);
    Ok(Some(text.trim_start_matches('\u{FEFF}').trim().to_owned()))
}

/// Reads the Shapefile to which `path` belongs. The index, if any, locates records. Records marked as deleted are left out.
pub(super) fn read(storage: Storage<'_>, path: &Path, each: &mut Each<'_>) -> Result<Header, ReadError> {
    let missing =
        |extension: &str| content(Place::Header, Cause::Missing(path.with_extension(extension).display().to_string()));
    let shp = beside(storage, path, "shp").ok_or_else(|| missing("shp"))?;
    let charset = text_beside(storage, path, "cpg")?;
    let wkt = text_beside(storage, path, "prj")?.filter(|text| !text.is_empty());
    let mut table = match beside(storage, path, "dbf") {
        None => None,
        Some(dbf) => Some(Table::open(BufReader::new(storage.open(&dbf)?.0), charset.as_deref())?),
    };
    let mut shapes = Shapes::open(storage, &shp, beside(storage, path, "shx").as_deref())?;
    let mut number = 0;
    while let Some(Record { geometry }) = shapes.next(number)? {
        let mut feature = Feature { geometry, ..Feature::default() };
        let mut is_deleted = false;
        if let Some(table) = &mut table {
            let row = table.next(number)?;
            let (deleted, attributes) = row.ok_or_else(|| {
                content(
                    Place::Feature(number),
                    Cause::Invalid("the table has fewer records than there are shapes".into()),
                )
            })?;
            feature.attributes = attributes;
            is_deleted = deleted;
        }
        number += 1;
        if !is_deleted {
            each(feature)?;
        }
    }
    if let Some(count) = table.as_ref().map(|table| table.count).filter(|count| *count != number) {
        let message = format!("the table has {count} records, and there are {number} shapes");
        return Err(content(Place::Header, Cause::Invalid(message)));
    }
    Ok(Header {
        name: shp.file_stem().map(|stem| stem.to_string_lossy().into_owned()),
        crs: wkt.map(Crs::of_wkt),
        fields: table.map(|table| table.fields()).unwrap_or_default(),
        charset,
        ..Header::default()
    })
}

struct Record {
    /// None for a null shape.
    geometry: Option<Geometry>,
}

struct Shapes {
    file: BufReader<Box<dyn ReadSeek>>,
    length: u64,
    at: u64,
    index: Option<Vec<u64>>,
    buffer: Vec<u8>,
}

impl Shapes {
    fn open(storage: Storage<'_>, shp: &Path, shx: Option<&Path>) -> Result<Self, ReadError> {
        let (file, length) = storage.open(shp)?;
        let mut file = BufReader::new(file);
        check_header(&mut file)?;
        let index = shx.map(|shx| read_index(storage, shx)).transpose()?;
        Ok(Self { file, length, at: HEADER as u64, index, buffer: Vec::new() })
    }

    fn next(&mut self, number: usize) -> Result<Option<Record>, ReadError> {
        let failed = |cause| content(Place::Feature(number), cause);
        let start = match &self.index {
            Some(index) => match index.get(number) {
                Some(start) => *start,
                None => return Ok(None),
            },
            None if self.at >= self.length => return Ok(None),
            None => self.at,
        };
        if start != self.at {
            self.file.seek(SeekFrom::Start(start))?;
        }
        let mut head = [0; 8];
        self.file.read_exact(&mut head).map_err(|error| truncated(error, "a record", failed))?;
        let [_, _, _, _, a, b, c, d] = head;
        let words = u32::from_be_bytes([a, b, c, d]);
        let bytes = u64::from(words) * 2;
        if start.saturating_add(8).saturating_add(bytes) > self.length {
            return Err(failed(Cause::TooMany { what: "bytes of a record", count: bytes }));
        }
        self.at = start + 8 + bytes;
        self.buffer.resize(bytes as usize, 0);
        self.file.read_exact(&mut self.buffer).map_err(|error| truncated(error, "a record", failed))?;
        record::parse(&self.buffer).map(|geometry| Some(Record { geometry })).map_err(failed)
    }
}

fn check_header(file: &mut impl Read) -> Result<(), ReadError> {
    let mut header = [0; HEADER];
    let failed = |cause| content(Place::Header, cause);
    file.read_exact(&mut header).map_err(|error| truncated(error, "the header", failed))?;
    if header.starts_with(&FILE_CODE) {
        Ok(())
    } else {
        Err(failed(Cause::Invalid("this is not the beginning of a Shapefile".to_owned())))
    }
}

fn read_index(storage: Storage<'_>, shx: &Path) -> Result<Vec<u64>, ReadError> {
    let mut file = BufReader::new(storage.open(shx)?.0);
    check_header(&mut file)?;
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    let start = |entry: &[u8]| match *entry {
        [a, b, c, d, ..] => u64::from(u32::from_be_bytes([a, b, c, d])) * 2,
        _ => 0,
    };
    Ok(bytes.chunks_exact(8).map(start).collect())
}

/// Makes the files of a Shapefile: `.shp` at the path, and the others next to it.
pub(super) fn write(layer: &Layer, path: &Path) -> Result<Files, WriteError> {
    let impossible = |what| WriteError::Impossible { format: Format::Shapefile, what };
    let kind = shape_kind(layer).map_err(impossible)?;
    let fields: Vec<Field> = layer.fields();
    let (columns, _) = columns::plan(layer, &fields);
    dbf::check_size(&columns).map_err(impossible)?;
    let [shp, shx] = write_shapes(layer, kind)?;
    let mut table = Vec::new();
    dbf::write(layer, &columns, &mut table)?;
    let mut files = Files::default();
    for (extension, bytes) in [("shp", shp), ("shx", shx), ("dbf", table), ("cpg", b"UTF-8\n".to_vec())] {
        files.insert(path.with_extension(extension), bytes);
    }
    if let Some(wkt) = layer.header.crs.as_ref().and_then(Crs::wkt1) {
        files.insert(path.with_extension("prj"), wkt.into_bytes());
    }
    Ok(files)
}

fn write_shapes(layer: &Layer, kind: ShapeKind) -> Result<[Vec<u8>; 2], WriteError> {
    let too_large =
        || WriteError::Impossible { format: Format::Shapefile, what: "more than 4 gigabytes of geometries".to_owned() };
    let mut records = Vec::new();
    let mut index = Vec::new();
    let mut bounds = record::Bounds::default();
    for (feature, number) in layer.features.iter().zip(1_i32..) {
        let start = records.len();
        records.extend(number.to_be_bytes());
        records.extend([0; 4]);
        record::append(feature.geometry.as_ref(), kind, &mut bounds, &mut records);
        let words = i32::try_from((records.len() - start - 8) / 2).map_err(|_| too_large())?;
        records[start + 4..start + 8].copy_from_slice(&words.to_be_bytes());
        let offset = i32::try_from(HEADER / 2 + start / 2).map_err(|_| too_large())?;
        index.extend(offset.to_be_bytes());
        index.extend(words.to_be_bytes());
    }
    let with_header = |body: Vec<u8>| -> Result<Vec<u8>, WriteError> {
        let words = i32::try_from(HEADER / 2 + body.len() / 2).map_err(|_| too_large())?;
        Ok([header(words, kind, &bounds), body].concat())
    };
    Ok([with_header(records)?, with_header(index)?])
}

fn header(words: i32, kind: ShapeKind, bounds: &record::Bounds) -> Vec<u8> {
    let mut header = FILE_CODE.to_vec();
    header.extend([0; 20]);
    header.extend(words.to_be_bytes());
    header.extend(VERSION.to_le_bytes());
    header.extend(kind.code().to_le_bytes());
    bounds.append(&mut header);
    header
}

/// The extensions of the files of a Shapefile that are read and written here.
pub(super) const EXTENSIONS: [&str; 5] = ["shp", "shx", "dbf", "prj", "cpg"];
