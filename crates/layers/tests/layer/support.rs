//! Layers and files for the tests.

use std::path::{Path, PathBuf};
use tempfile::TempDir;
use twinedge_layers::{Format, Layer, ReadError, ReadOptions, read_layer, read_path, write, write_path};

/// Reads a layer from a text of any format.
pub(crate) fn from_text(text: &str) -> Layer {
    from_bytes(text.as_bytes()).unwrap()
}

/// Reads a layer from bytes of any format.
pub(crate) fn from_bytes(bytes: &[u8]) -> Result<Layer, ReadError> {
    let mut bytes = bytes;
    read_layer(&mut bytes, None, &ReadOptions::default())
}

pub(crate) fn to_geojson(layer: &Layer) -> String {
    let mut text = Vec::new();
    write(layer, &mut text, Format::GeoJson).unwrap();
    String::from_utf8(text).unwrap()
}

/// Creates a folder, and returns it with the path of a file in it.
pub(crate) fn scratch(name: &str) -> (TempDir, PathBuf) {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join(name);
    (folder, path)
}

/// Writes a layer in a format and reads it back.
pub(crate) fn through(layer: &Layer, format: Format) -> Layer {
    let name = match format {
        Format::GeoJson => "layer.geojson",
        Format::GeoJsonSeq => "layer.geojsonl",
        Format::Wkt => "layer.wkt",
        Format::Wkb => "layer.wkb",
        Format::Shapefile => "layer.shp",
        Format::GeoPackage => "layer.gpkg",
        Format::FlatGeobuf => "layer.fgb",
        Format::GeoParquet => "layer.parquet",
        other @ Format::TopoJson => unreachable!("{other} is not written"),
    };
    let (_folder, path) = scratch(name);
    write_as(layer, &path, format);
    read(&path).unwrap()
}

pub(crate) fn write_as(layer: &Layer, path: &Path, format: Format) {
    write_path(layer, path, format).unwrap();
}

pub(crate) fn read(path: &Path) -> Result<Layer, ReadError> {
    read_path(path, &ReadOptions::default())
}

/// The built-in map of the program: 177 countries, with holes, parts and attributes.
pub(crate) fn world() -> Layer {
    read(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../cli/data/world-110m.geojson"))).unwrap()
}
