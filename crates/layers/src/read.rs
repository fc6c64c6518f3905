//! Reading a layer in any of the formats.

use super::each::Each;
use super::error::ReadError;
use super::files::Files;
use super::model::{Header, Layer};
use crate::io::{ForeignFormat, Format};
use std::fs::File;
use std::io::{BufReader, Cursor, Read};
use std::path::Path;
use std::sync::Arc;

/// The number of bytes that are examined to detect the format.
const HEAD: u64 = 1 << 16;

/// Options for reading a layer.
#[derive(Clone, Debug, Default)]
pub struct ReadOptions {
    /// The format. Without one, the content decides, and then the extension of the file.
    pub format: Option<Format>,
    /// The name of the layer to read from a file with several. The layers of TopoJSON are its objects.
    pub layer: Option<String>,
    /// The files to which paths refer, in memory. Otherwise paths refer to the disk, as always for `GeoPackage` and `GeoParquet`.
    pub files: Option<Arc<Files>>,
}

/// Reads a layer and passes on its features in the order of the file. A format with several files is read from `path`, any other
/// from `reader`.
///
/// Features are passed on as they are read, so an error may follow some of them. Memory O(largest feature), plus the index of a
/// Shapefile.
///
/// # Errors
/// [`ReadError`], and any error that `each` returns.
///
/// ```
/// use twinedge_layers::{ReadOptions, read};
///
/// # #[cfg(feature = "geojson")] {
/// let text = r#"{"type": "Feature", "id": 7, "geometry": null, "properties": {"owner": "Meier"}}"#;
/// read(&mut text.as_bytes(), None, &ReadOptions::default(), &mut |feature| {
///     assert_eq!(feature.get("owner").and_then(|owner| owner.text()).as_deref(), Some("Meier"));
///     Ok(())
/// })?;
/// # }
/// # Ok::<_, twinedge_layers::ReadError>(())
/// ```
pub fn read(
    reader: &mut dyn Read,
    path: Option<&Path>,
    options: &ReadOptions,
    each: &mut Each<'_>,
) -> Result<Header, ReadError> {
    let head = beginning(reader)?;
    if let Some(unpacked) =
        super::archive::unpack(&head, &mut head.as_slice().chain(&mut *reader), path, options.layer.as_deref())?
    {
        let options = ReadOptions { layer: unpacked.layer.clone(), ..options.clone() };
        return read_unpacked(&unpacked.path, &options, each);
    }
    let format = format_of(&head, path, options)?;
    let mut all = Cursor::new(head).chain(reader);
    match format {
        #[cfg(feature = "geojson")]
        Format::GeoJson => super::geojson::read(&mut all, crate::io::geojson::Documents::One, each),
        #[cfg(feature = "geojson")]
        Format::GeoJsonSeq => super::geojson::read(&mut all, crate::io::geojson::Documents::Many, each),
        #[cfg(feature = "wkt")]
        Format::Wkt => super::wkt::read(&mut all, each),
        #[cfg(feature = "wkb")]
        Format::Wkb => super::wkb::read(&mut all, each),
        #[cfg(feature = "topojson")]
        Format::TopoJson => super::topojson::read_features(&mut all, options.layer.as_deref(), each),
        #[cfg(feature = "flatgeobuf")]
        Format::FlatGeobuf => super::flatgeobuf::read(&mut all, each),
        #[cfg(feature = "shapefile")]
        Format::Shapefile => {
            let path = path.ok_or(ReadError::NeedsFile(format))?;
            let storage = super::shapefile::Storage::of(options.files.as_deref());
            super::shapefile::read(storage, path, each)
        }
        #[cfg(feature = "geopackage")]
        Format::GeoPackage => {
            let path = path.ok_or(ReadError::NeedsFile(format))?;
            super::geopackage::read(path, options.layer.as_deref(), each)
        }
        #[cfg(feature = "geoparquet")]
        Format::GeoParquet => super::geoparquet::read(path.ok_or(ReadError::NeedsFile(format))?, each),
        #[allow(unreachable_patterns, reason = "with all features on, nothing is left")]
        off => {
            let _ = (&mut all, each);
            Err(ReadError::FeatureOff(off))
        }
    }
}

/// Reads a file from an archive. An archive inside it is not unpacked.
fn read_unpacked(path: &Path, options: &ReadOptions, each: &mut Each<'_>) -> Result<Header, ReadError> {
    let mut file = BufReader::new(File::open(path)?);
    let head = beginning(&mut file)?;
    format_of(&head, Some(path), options)?;
    read(&mut head.as_slice().chain(file), Some(path), options, each)
}

/// Returns the first bytes, from which the format is detected.
pub(super) fn beginning(reader: &mut dyn Read) -> Result<Vec<u8>, ReadError> {
    let mut head = Vec::new();
    reader.take(HEAD).read_to_end(&mut head)?;
    Ok(head)
}

/// Returns the format that [`read`] uses for content with these first bytes. O(bytes).
///
/// # Errors
/// [`ReadError::Foreign`], [`ReadError::Empty`] and [`ReadError::Unrecognised`].
///
/// ```
/// use twinedge_layers::{Format, ReadOptions, format_of};
///
/// let format = format_of(b"POINT(1 2)", None, &ReadOptions::default())?;
/// assert_eq!(format, Format::Wkt);
/// # Ok::<_, twinedge_layers::ReadError>(())
/// ```
pub fn format_of(head: &[u8], path: Option<&Path>, options: &ReadOptions) -> Result<Format, ReadError> {
    if let Some(foreign) = ForeignFormat::of_content(head) {
        return Err(ReadError::Foreign(foreign));
    }
    let of_content = Format::of_content(head);
    let by_name = options.format.or_else(|| path.and_then(Format::of_path));
    let nothing = if is_blank(head) { ReadError::Empty } else { ReadError::Unrecognised };
    Format::of_file(of_content, by_name).ok_or(nothing)
}

fn is_blank(head: &[u8]) -> bool {
    head.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(head).trim_ascii().is_empty()
}

/// Reads a whole layer from a file.
///
/// # Errors
/// As for [`read`].
pub fn read_path(path: impl AsRef<Path>, options: &ReadOptions) -> Result<Layer, ReadError> {
    let path = path.as_ref();
    let mut file = BufReader::new(File::open(path)?);
    read_layer(&mut file, Some(path), options)
}

/// Reads a whole layer.
///
/// # Errors
/// As for [`read`].
pub fn read_layer(reader: &mut dyn Read, path: Option<&Path>, options: &ReadOptions) -> Result<Layer, ReadError> {
    let mut features = Vec::new();
    let header = read(reader, path, options, &mut |feature| {
        features.push(feature);
        Ok(())
    })?;
    Ok(Layer { header, features })
}
