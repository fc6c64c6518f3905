//! An input, opened.

use crate::error::Error;
use std::any::Any;
use std::ffi::OsStr;
use std::fmt::Display;
use std::io::BufRead;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use twinedge_layers::{Files, Format, ReadOptions, format_of};
use twinedge_meshes::Format as MeshFormat;

/// An input, opened.
pub struct Input {
    /// The name of the input in the report.
    pub name: String,
    /// Its bytes.
    pub reader: Box<dyn BufRead>,
    /// The path, if it is a file.
    pub path: Option<PathBuf>,
    /// The requested layer, for files with several.
    pub layer: Option<String>,
    /// The format, if the caller named it.
    pub format: Option<Format>,
    /// The numbers of the features, in order, whose geometry was left out because a coordinate is not finite.
    pub not_finite: Vec<usize>,
    /// The files that `path` refers to, if they are in memory.
    pub files: Option<Arc<Files>>,
    /// A value kept until the input is read, such as a folder of unpacked files.
    pub kept: Option<Box<dyn Any>>,
}

impl Input {
    /// Creates an input. Its path tells the format if the content does not, and some formats are read by path.
    pub fn new(name: impl Into<String>, reader: Box<dyn BufRead>, path: Option<&Path>) -> Self {
        Self {
            name: name.into(),
            reader,
            path: path.map(Path::to_owned),
            layer: None,
            format: None,
            not_finite: Vec::new(),
            files: None,
            kept: None,
        }
    }

    /// Returns the options for reading its layer.
    #[must_use]
    pub fn options(&self) -> ReadOptions {
        ReadOptions { format: self.format, layer: self.layer.clone(), files: self.files.clone() }
    }

    /// Returns its first bytes without consuming them.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn beginning(&mut self) -> Result<&[u8], Error> {
        Ok(self.reader.fill_buf()?)
    }

    /// Returns the format if the input is a map.
    ///
    /// # Errors
    /// [`Error::NoLayer`], if a layer is requested from a format with one layer per file, and [`Error::Io`].
    pub fn map_format(&mut self) -> Result<Option<Format>, Error> {
        let options = self.options();
        let Ok(format) = format_of(self.reader.fill_buf()?, self.path.as_deref(), &options) else { return Ok(None) };
        if !matches!(format, Format::GeoPackage | Format::TopoJson) {
            self.refuse_layer(format)?;
        }
        Ok(Some(format))
    }

    /// Refuses a requested layer, unless it has the name of the file.
    ///
    /// # Errors
    /// [`Error::NoLayer`].
    pub fn refuse_layer(&self, what: impl Display) -> Result<(), Error> {
        let of_file = self.path.as_deref().and_then(Path::file_stem);
        match self.layer.as_deref().filter(|layer| of_file != Some(OsStr::new(layer))) {
            None => Ok(()),
            Some(layer) => Err(Error::NoLayer { layer: layer.to_owned(), what: what.to_string() }),
        }
    }

    /// Returns the format if the input is a mesh, by its name or else by its beginning.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn mesh_format(&mut self) -> Result<Option<MeshFormat>, Error> {
        let path = self.path.as_deref();
        match (path.and_then(MeshFormat::of_name), path.and_then(Format::of_path)) {
            (None, None) => Ok(MeshFormat::of_content(self.beginning()?)),
            (by_name, _) => Ok(by_name),
        }
    }
}
