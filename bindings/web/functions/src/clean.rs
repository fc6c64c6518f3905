//! `clean`: a layer of polygons, repaired.

use crate::convert::{Target, write};
use crate::error::CallError;
use crate::source::{Buffer, NamedFile, layer, stem};
use serde::Deserialize;
use serde_json::{Map, Value, json};
use twinedge_coverage::clean::{Options, Winner};
use twinedge_layers::clean::CleanOptions;
use twinedge_report::clean::{Cleaning, Names, Repair};
use twinedge_report::words::json as json_bytes;
use twinedge_web_bridge::Buffers;

#[derive(Deserialize)]
pub(crate) struct Request {
    files: Vec<NamedFile>,
    options: Asked,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct Asked {
    layer: Option<String>,
    to: Option<Target>,
    id_column: Option<String>,
    lossy: bool,
    overlap: Option<String>,
    /// The grid, the name of features and the limits.
    #[serde(flatten)]
    others: Map<String, Value>,
}

/// The options of an audit that `clean` takes.
const TAKEN: [&str; 6] = ["snap", "nameFrom", "gapWidth", "lakeWidth", "acceptGaps", "sliver"];

pub(crate) fn answer(
    asked: Request,
    buffers: &mut Buffers,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Value, CallError> {
    let Request { files, options } = asked;
    if let Some(name) = options.others.keys().find(|name| !TAKEN.contains(&name.as_str())) {
        return Err(CallError::option(format!("{name}: there is no such option")));
    }
    let asked = twinedge_report::Options::from_json(options.others).map_err(CallError::option)?;
    let limits = asked.coverage.limits.limits();
    stage("reading");
    let (name, mut layer) = layer(files, options.layer.as_deref(), buffers)?;
    let winner = options.overlap.as_deref().map_or(Some(Winner::default()), Winner::of_name);
    let assign = Options {
        winner: winner.ok_or_else(|| CallError::option("overlap: none of inner, larger, smaller, first, last"))?,
        gap_width: limits.gap_width,
        lake_width: limits.lake_width,
        accepted_gaps: limits.accepted_gaps,
        sliver_area: limits.sliver_area,
        ..Options::default()
    };
    stage("cleaning");
    let repair = Repair {
        names: Names { from: asked.map.name_from.as_deref() },
        options: CleanOptions { snap: asked.map.snap, assign, ..CleanOptions::default() },
        ..Repair::default()
    };
    let report = repair.clean(&mut layer).map_err(|error| CallError::from(error).of(&name))?;
    stage("writing");
    let report = json_bytes(&Cleaning::new(&name, &repair, &layer, &report).json())?;
    let stem = stem(&name, &layer.header);
    let to = options.to.unwrap_or_default();
    let written = write(&layer, &stem, to, options.id_column.as_deref(), options.lossy, buffers)
        .map_err(|error| error.of(&name))?;
    let report = Buffer::put(buffers, report);
    Ok(json!({ "report": report, "file": written.file, "losses": written.losses, "isLayer": options.to.is_none() }))
}
