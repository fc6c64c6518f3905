//! Writing a layer in any of the formats.

use super::closed::closed;
use super::error::WriteError;
use super::files::Files;
use super::losses::losses;
use super::model::Layer;
use crate::io::Format;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// Refuses a format that cannot hold all of a layer. Minor losses are accepted ([`Loss::is_minor`](super::Loss::is_minor)).
///
/// # Errors
/// [`WriteError::Loss`], and [`WriteError::ReadOnly`].
pub fn refuse_losses(layer: &Layer, format: Format) -> Result<(), WriteError> {
    if format == Format::TopoJson {
        return Err(WriteError::ReadOnly(format));
    }
    let losses: Vec<_> = losses(layer, format).into_iter().filter(|loss| !loss.is_minor()).collect();
    if losses.is_empty() { Ok(()) } else { Err(WriteError::Loss { format, losses }) }
}

/// Returns the files that are written for a path: the path itself, and for a Shapefile those next to it.
#[must_use]
pub fn files(path: &Path, format: Format) -> Vec<PathBuf> {
    #[cfg(feature = "shapefile")]
    if format == Format::Shapefile {
        return super::shapefile::EXTENSIONS.iter().map(|extension| path.with_extension(extension)).collect();
    }
    let _ = format;
    vec![path.to_owned()]
}

/// Writes a layer to a file that does not exist yet, whatever the format loses ([`losses`]). Open rings are closed.
///
/// # Errors
/// [`WriteError`]. The file may then exist in part.
pub fn write_path(layer: &Layer, path: &Path, format: Format) -> Result<(), WriteError> {
    has_writer(format)?;
    let layer = &*closed(layer);
    match format {
        Format::TopoJson => Err(WriteError::ReadOnly(format)),
        #[cfg(feature = "shapefile")]
        Format::Shapefile => {
            let files = super::shapefile::write(layer, path)?;
            Ok(files.iter().try_for_each(|(path, bytes)| std::fs::write(path, bytes))?)
        }
        #[cfg(feature = "geopackage")]
        Format::GeoPackage => super::geopackage::write(layer, path),
        #[cfg(feature = "geoparquet")]
        Format::GeoParquet => super::geoparquet::write(layer, path),
        format => {
            let mut out = BufWriter::new(File::create(path)?);
            write(layer, &mut out, format)?;
            Ok(out.flush()?)
        }
    }
}

/// Writes a layer to memory, whatever the format loses ([`losses`]): the [`files`] of this path. Open rings are closed.
///
/// # Errors
/// [`WriteError`], and [`WriteError::NeedsFile`] for `GeoPackage` and `GeoParquet`.
pub fn write_files(layer: &Layer, path: &Path, format: Format) -> Result<Files, WriteError> {
    #[cfg(feature = "shapefile")]
    if format == Format::Shapefile {
        return super::shapefile::write(&closed(layer), path);
    }
    let mut bytes = Vec::new();
    write(layer, &mut bytes, format)?;
    Ok([(path.to_owned(), bytes)].into_iter().collect())
}

/// Writes a layer to a stream. Open rings are closed. The writer is not buffered internally.
///
/// # Errors
/// [`WriteError`].
///
/// ```
/// use twinedge_layers::{Feature, Format, Layer, Value, write};
///
/// # #[cfg(feature = "geojson")] {
/// let feature = Feature { attributes: vec![("owner".into(), Value::Text("Meier".into()))], ..Feature::default() };
/// let layer = Layer { features: vec![feature], ..Layer::default() };
/// let mut text = Vec::new();
/// write(&layer, &mut text, Format::GeoJsonSeq)?;
/// assert_eq!(text, b"{\"type\":\"Feature\",\"properties\":{\"owner\":\"Meier\"},\"geometry\":null}\n");
/// # }
/// # Ok::<_, twinedge_layers::WriteError>(())
/// ```
pub fn write(layer: &Layer, out: &mut dyn Write, format: Format) -> Result<(), WriteError> {
    has_writer(format)?;
    let layer = &*closed(layer);
    match format {
        #[cfg(feature = "geojson")]
        Format::GeoJson => super::geojson::write(layer, out),
        #[cfg(feature = "geojson")]
        Format::GeoJsonSeq => super::geojson::write_sequence(layer, out),
        #[cfg(feature = "wkt")]
        Format::Wkt => super::wkt::write(layer, out),
        #[cfg(feature = "wkb")]
        Format::Wkb => super::wkb::write(layer, out),
        #[cfg(feature = "flatgeobuf")]
        Format::FlatGeobuf => super::flatgeobuf::write(layer, out),
        Format::TopoJson => Err(WriteError::ReadOnly(format)),
        format => {
            let _ = (layer, out);
            Err(WriteError::NeedsFile(format))
        }
    }
}

/// Refuses a format whose feature is off, before anything is written.
const fn has_writer(format: Format) -> Result<(), WriteError> {
    let is_on = match format {
        Format::GeoJson | Format::GeoJsonSeq => cfg!(feature = "geojson"),
        Format::Wkt => cfg!(feature = "wkt"),
        Format::Wkb => cfg!(feature = "wkb"),
        Format::FlatGeobuf => cfg!(feature = "flatgeobuf"),
        Format::Shapefile => cfg!(feature = "shapefile"),
        Format::GeoPackage => cfg!(feature = "geopackage"),
        Format::GeoParquet => cfg!(feature = "geoparquet"),
        Format::TopoJson => true,
    };
    if is_on { Ok(()) } else { Err(WriteError::FeatureOff(format)) }
}
