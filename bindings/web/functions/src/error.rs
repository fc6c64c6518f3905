//! Errors as JavaScript throws them.

use serde_json::{Map, Value, json};
use std::fmt::Display;
use std::path::PathBuf;
use twinedge_layers::io::ForeignFormat;
use twinedge_report as report;

/// An error with its code and its place in the input.
#[derive(Debug)]
pub(crate) struct CallError {
    code: &'static str,
    message: String,
    place: Map<String, Value>,
}

impl CallError {
    pub(crate) fn new(code: &'static str, message: impl Display) -> Self {
        Self { code, message: message.to_string(), place: Map::new() }
    }

    /// An invalid option.
    pub(crate) fn option(message: impl Display) -> Self {
        Self::new("option", message)
    }

    /// Several files, where only one can be read.
    pub(crate) fn several(files: &[&PathBuf]) -> Self {
        let names: Vec<String> = files.iter().map(|path| path.display().to_string()).collect();
        let message = format!("these are {} maps, and one is read at a time: {}", names.len(), names.join(", "));
        Self::new("layer", message).at([("layers", names.into())])
    }

    fn at(mut self, places: impl IntoIterator<Item = (&'static str, Value)>) -> Self {
        self.place.extend(places.into_iter().map(|(key, value)| (key.to_owned(), value)));
        self
    }

    /// Returns the error with the name of the input.
    pub(crate) fn of(mut self, name: &str) -> Self {
        self.message = format!("{name}: {}", self.message);
        self.at([("input", name.into())])
    }

    pub(crate) fn json(&self) -> Value {
        let place = (!self.place.is_empty()).then_some(&self.place);
        json!({ "code": self.code, "message": self.message, "place": place })
    }
}

fn of_layer_place(place: twinedge_layers::Place) -> Vec<(&'static str, Value)> {
    match place {
        twinedge_layers::Place::Feature(number) => vec![("feature", number.into())],
        twinedge_layers::Place::Line(number) => vec![("line", number.into())],
        twinedge_layers::Place::Text(place) => vec![("line", place.line.into()), ("column", place.column.into())],
        twinedge_layers::Place::Arc(number) => vec![("arc", number.into())],
        _ => vec![("header", true.into())],
    }
}

impl From<twinedge_layers::ReadError> for CallError {
    fn from(error: twinedge_layers::ReadError) -> Self {
        let place = match &error {
            twinedge_layers::ReadError::Content { place, .. } => of_layer_place(*place),
            twinedge_layers::ReadError::Text(error) => {
                let at = error.place;
                let feature = error.feature.map(|feature| ("feature", feature.into()));
                [("line", at.line.into()), ("column", at.column.into())].into_iter().chain(feature).collect()
            }
            twinedge_layers::ReadError::Layers { layers, .. } => vec![("layers", layers.clone().into())],
            _ => Vec::new(),
        };
        let code = match &error {
            // Only the program reads it.
            twinedge_layers::ReadError::FeatureOff(_)
            | twinedge_layers::ReadError::NeedsFile(_)
            | twinedge_layers::ReadError::Foreign(ForeignFormat::Sqlite) => "needs-program",
            twinedge_layers::ReadError::Foreign(_) | twinedge_layers::ReadError::Unrecognised => "format",
            twinedge_layers::ReadError::Layers { .. } => "layer",
            twinedge_layers::ReadError::Empty => "empty",
            _ => "content",
        };
        Self::new(code, &error).at(place)
    }
}

impl From<twinedge_meshes::ReadError> for CallError {
    fn from(error: twinedge_meshes::ReadError) -> Self {
        let place = match &error {
            twinedge_meshes::ReadError::Content { position: twinedge_meshes::Position::Line(line), .. } => {
                Some(("line", (*line).into()))
            }
            twinedge_meshes::ReadError::Content { position: twinedge_meshes::Position::Byte(byte), .. } => {
                Some(("byte", (*byte).into()))
            }
            _ => None,
        };
        Self::new("content", &error).at(place)
    }
}

impl From<twinedge_postgis::ReadError> for CallError {
    fn from(error: twinedge_postgis::ReadError) -> Self {
        let place = match &error {
            twinedge_postgis::ReadError::Content { byte, place, .. } => {
                vec![("byte", (*byte).into()), ("table", place.table.to_string().into()), ("row", place.row.into())]
            }
            _ => Vec::new(),
        };
        Self::new("content", &error).at(place)
    }
}

impl From<report::Error> for CallError {
    fn from(error: report::Error) -> Self {
        match error {
            report::Error::Layer(error) => error.into(),
            report::Error::Mesh(error) => error.into(),
            report::Error::Postgis(error) => error.into(),
            report::Error::Table { line, .. } => Self::new("content", &error).at([("line", line.into())]),
            report::Error::NoColumn { .. } | report::Error::NotDegrees | report::Error::NoPicture(_) => {
                Self::option(error)
            }
            report::Error::NoLayer { .. } => Self::new("layer", error),
            report::Error::NoMap(_) => Self::new("empty", error),
            error => Self::new("content", error),
        }
    }
}

/// Errors that are only a message.
macro_rules! contents {
    ($($error:ty),*) => {
        $(impl From<$error> for CallError {
            fn from(error: $error) -> Self {
                Self::new("content", error)
            }
        })*
    };
}

contents!(
    twinedge_layers::WriteError,
    twinedge_layers::ColumnTaken,
    report::voronoi::OtherGeometry,
    serde_json::Error,
    std::fmt::Error,
    std::io::Error,
    twinedge_algorithm::voronoi::VoronoiError,
    twinedge::dcel::StaleKey
);
