//! Inputs, from files and from memory.

use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use std::fmt::Display;
use std::fs::File;
use std::io::{BufReader, Cursor};
use std::path::{Path, PathBuf};
use twinedge_geometry::noding::Snap;
use twinedge_layers::io::ForeignFormat;
use twinedge_layers::{Format, Layer, ReadError, read_layer};
use twinedge_report::{Error, Input, Judged};

/// The reason for a missing answer.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A file could not be read.
    Os(String),
    /// Its content is invalid, or an argument is.
    Value(String),
}

impl Failure {
    pub(crate) fn value(why: impl Display) -> Self {
        Self::Value(why.to_string())
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        match error {
            Error::Io(error) => Self::Os(error.to_string()),
            error => Self::value(error),
        }
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Os(why) => PyOSError::new_err(why),
            Failure::Value(why) => PyValueError::new_err(why),
        }
    }
}

/// An input: a path, or a text in memory.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Source {
    name: String,
    path: Option<PathBuf>,
    text: Option<PyBackedBytes>,
    /// The extension of files of its format.
    format: Option<String>,
    layer: Option<String>,
    /// The features that are left out because a coordinate is not finite, in order.
    not_finite: Vec<usize>,
}

impl Source {
    /// True if it is in memory, where an empty layer is still a layer.
    pub(crate) const fn is_in_memory(&self) -> bool {
        self.text.is_some()
    }

    /// Returns the name of the layer in messages.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// Opens the input, after counting its bytes.
    pub(crate) fn open(self) -> Result<(Input, Option<Judged>), Failure> {
        let format = match &self.format {
            None => None,
            Some(name) => Some(
                Format::of_path(Path::new("layer").with_extension(name))
                    .ok_or_else(|| Failure::Value(format!("format: there is none named {name:?}")))?,
            ),
        };
        let Self { name, path, text, layer, not_finite, .. } = self;
        let failed = |error: std::io::Error| Failure::Os(format!("{name}: {error}"));
        let (input, judged) = match (text, path) {
            (Some(text), _) => {
                let judged = Judged::of(&text[..]).map_err(failed)?;
                (Input::new(name, Box::new(Cursor::new(text)), None), judged)
            }
            (None, path) => {
                let path = path.unwrap_or_default();
                if let Some(foreign) = ForeignFormat::of_folder(&path).filter(|_| path.is_dir()) {
                    return Err(Failure::Value(format!("{name}: {}", ReadError::Foreign(foreign))));
                }
                let judged = Judged::of(BufReader::new(File::open(&path).map_err(failed)?)).map_err(failed)?;
                let file = File::open(&path).map_err(failed)?;
                (Input::new(name, Box::new(BufReader::new(file)), Some(&path)), judged)
            }
        };
        Ok((Input { format, layer, not_finite, ..input }, Some(judged)))
    }

    pub(crate) fn read(self) -> Result<Layer, Failure> {
        let (mut input, _) = self.open()?;
        let options = input.options();
        let read = read_layer(&mut input.reader, input.path.as_deref(), &options);
        read.map_err(|error| Failure::Value(format!("{}: {error}", input.name)))
    }
}

/// A grid: none, a size of cells, or 0 to choose one.
pub(crate) fn snap(size: Option<f64>) -> Option<Snap> {
    size.map(|size| if size > 0.0 { Snap::Size(size) } else { Snap::Auto })
}
