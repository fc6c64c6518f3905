//! `convert`: a layer in another format.

use crate::error::CallError;
use crate::source::{Buffer, NamedFile, layer, stem};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::borrow::Cow;
use std::path::Path;
use twinedge_layers::{Format, Layer, Loss, losses, refuse_losses, write_files, zip};
use twinedge_web_bridge::Buffers;

#[derive(Deserialize)]
pub(crate) struct Request {
    files: Vec<NamedFile>,
    options: ConvertOptions,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
struct ConvertOptions {
    #[serde(default)]
    layer: Option<String>,
    to: Target,
    #[serde(default)]
    id_column: Option<String>,
    #[serde(default)]
    lossy: bool,
}

#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Target {
    #[default]
    Geojson,
    Geojsonl,
    Wkt,
    Wkb,
    Shapefile,
    Flatgeobuf,
}

impl Target {
    const fn format(self) -> Format {
        match self {
            Self::Geojson => Format::GeoJson,
            Self::Geojsonl => Format::GeoJsonSeq,
            Self::Wkt => Format::Wkt,
            Self::Wkb => Format::Wkb,
            Self::Shapefile => Format::Shapefile,
            Self::Flatgeobuf => Format::FlatGeobuf,
        }
    }

    const fn extension(self) -> &'static str {
        match self {
            Self::Geojson => "geojson",
            Self::Geojsonl => "geojsonl",
            Self::Wkt => "wkt",
            Self::Wkb => "wkb",
            Self::Shapefile => "shp",
            Self::Flatgeobuf => "fgb",
        }
    }
}

#[derive(Serialize)]
pub(crate) struct Written {
    pub(crate) file: NamedFile,
    pub(crate) losses: Vec<String>,
}

/// Writes a layer; a Shapefile as a zip archive of its files. Content that the format cannot hold is an error, unless
/// losses are allowed.
pub(crate) fn write(
    layer: &Layer,
    stem: &str,
    to: Target,
    id_column: Option<&str>,
    lossy: bool,
    buffers: &mut Buffers,
) -> Result<Written, CallError> {
    let format = to.format();
    let mut layer = Cow::Borrowed(layer);
    let loses_ids = losses(&layer, format).iter().any(|loss| matches!(loss, Loss::Ids(_)));
    if let Some(column) = id_column.filter(|_| loses_ids) {
        layer.to_mut().move_ids(column).map_err(|error| CallError::option(format!("idColumn: {error}")))?;
    }
    if !lossy {
        refuse_losses(&layer, format).map_err(|error| CallError::new("loss", error))?;
    }
    let path = Path::new(stem).with_extension(to.extension());
    let files = write_files(&layer, &path, format)?;
    let (name, bytes) = match files.get(&path).filter(|_| to != Target::Shapefile) {
        Some(bytes) => (path, bytes.to_vec()),
        None => (path.with_extension("zip"), zip(&files)?),
    };
    let losses = losses(&layer, format).iter().map(ToString::to_string).collect();
    let file = NamedFile { name: name.display().to_string(), bytes: Buffer::put(buffers, bytes) };
    Ok(Written { file, losses })
}

pub(crate) fn answer(asked: Request, buffers: &mut Buffers) -> Result<Value, CallError> {
    let ConvertOptions { layer: wanted, to, id_column, lossy } = asked.options;
    let (name, layer) = layer(asked.files, wanted.as_deref(), buffers)?;
    let stem = stem(&name, &layer.header);
    let written = write(&layer, &stem, to, id_column.as_deref(), lossy, buffers).map_err(|error| error.of(&name))?;
    Ok(json!(written))
}
