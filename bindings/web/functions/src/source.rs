//! The files of an input.

use crate::error::CallError;
use serde::{Deserialize, Serialize};
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use twinedge_layers::{Files, Format, Header, Layer, read_layer, unpack_bytes};
use twinedge_meshes::Format as MeshFormat;
use twinedge_report::Input;
use twinedge_web_bridge::{Buffers, Id};

/// A buffer, as it appears in JSON.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub(crate) struct Buffer {
    buffer: Id,
}

impl Buffer {
    pub(crate) fn put(buffers: &mut Buffers, bytes: Vec<u8>) -> Self {
        Self { buffer: buffers.add(bytes) }
    }

    pub(crate) fn take(self, buffers: &mut Buffers) -> Vec<u8> {
        buffers.take(self.buffer)
    }
}

#[derive(Debug, Deserialize, Serialize)]
pub(crate) struct NamedFile {
    pub(crate) name: String,
    pub(crate) bytes: Buffer,
}

/// The parts of layers and meshes that are read with another file.
const PARTS: [&str; 13] = ["dbf", "shx", "prj", "cpg", "sbn", "sbx", "qix", "qpj", "qmd", "xml", "mtl", "bin", "lyr"];

/// Returns the main file of several: the one that is no part of another, or the only map or mesh among these. Among
/// several maps, `layer` may name the one to use.
fn main_of<'a>(names: &'a [PathBuf], layer: Option<&str>) -> Result<&'a PathBuf, CallError> {
    let is_part = |path: &&PathBuf| {
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        PARTS.contains(&extension.as_deref().unwrap_or_default())
    };
    let is_known = |path: &&PathBuf| Format::of_path(path).is_some() || MeshFormat::of_name(path).is_some();
    let mains: Vec<&PathBuf> = names.iter().filter(|path| !is_part(path)).collect();
    let known: Vec<&PathBuf> = mains.iter().copied().filter(is_known).collect();
    let several = match (&mains[..], &known[..]) {
        ([one], _) | (_, [one]) => return Ok(one),
        ([], _) => return names.first().ok_or_else(|| CallError::option("there are no files")),
        (_, []) => mains,
        _ => known,
    };
    let is_meant = |path: &&&PathBuf| layer.is_some_and(|layer| path.as_os_str() == layer);
    several.iter().find(is_meant).copied().ok_or_else(|| CallError::several(&several))
}

/// Returns the input that these files form: one of them, with the files that belong to it. Archives are unpacked.
pub(crate) fn input(files: Vec<NamedFile>, layer: Option<&str>, buffers: &mut Buffers) -> Result<Input, CallError> {
    let names: Vec<PathBuf> = files.iter().map(|file| PathBuf::from(&file.name)).collect();
    let main = main_of(&names, layer)?.clone();
    let name = main.display().to_string();
    let layer = layer.filter(|layer| *layer != name);
    let mut all: Files = files.into_iter().map(|file| (file.name.into(), file.bytes.take(buffers))).collect();
    let (mut path, mut wanted) = (main, layer.map(str::to_owned));
    let packed = all.get(&path).unwrap_or_default();
    let unpacked = unpack_bytes(packed, Some(&path), layer).map_err(|error| CallError::from(error).of(&name))?;
    if let Some(unpacked) = unpacked {
        (all, path, wanted) = (unpacked.files, unpacked.path, unpacked.layer);
    }
    let bytes = all.share(&path).unwrap_or_default();
    // A Shapefile is read by its name; nothing else needs the files afterwards.
    let is_several = Format::of_path(&path) == Some(Format::Shapefile);
    let input = Input::new(name, Box::new(Cursor::new(bytes)), Some(&path));
    Ok(Input { layer: wanted, files: is_several.then(|| Arc::new(all)), ..input })
}

/// Reads a whole layer. Returns it with the name of the input.
pub(crate) fn layer(
    files: Vec<NamedFile>,
    layer: Option<&str>,
    buffers: &mut Buffers,
) -> Result<(String, Layer), CallError> {
    let mut input = input(files, layer, buffers)?;
    let name = input.name.clone();
    input.map_format().map_err(|error| CallError::from(error).of(&name))?;
    let options = input.options();
    let read = read_layer(&mut input.reader, input.path.as_deref(), &options);
    Ok((name.clone(), read.map_err(|error| CallError::from(error).of(&name))?))
}

/// Returns the name of an input without folders and extension.
pub(crate) fn stem(name: &str, header: &Header) -> String {
    let stem = Path::new(name).file_stem().map(|stem| stem.to_string_lossy().into_owned());
    stem.or_else(|| header.name.clone()).unwrap_or_else(|| "layer".to_owned())
}
