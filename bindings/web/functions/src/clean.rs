//! `clean`: a layer of polygons, repaired.

use crate::convert::{Target, write};
use crate::error::CallError;
use crate::options::{Gaps, Grid, snap};
use crate::source::{Buffer, NamedFile, layer, stem};
use serde::Deserialize;
use serde_json::{Value, json};
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
#[serde(default, rename_all = "camelCase", deny_unknown_fields)]
struct Asked {
    layer: Option<String>,
    to: Option<Target>,
    id_column: Option<String>,
    lossy: bool,
    snap: Option<Grid>,
    name_from: Option<String>,
    overlap: Option<String>,
    gap_width: Option<f64>,
    lake_width: Option<f64>,
    accept_gaps: Vec<[f64; 2]>,
    sliver: Option<f64>,
}

pub(crate) fn answer(
    asked: Request,
    buffers: &mut Buffers,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Value, CallError> {
    let Request { files, options } = asked;
    let gaps = Gaps {
        gap_width: options.gap_width,
        lake_width: options.lake_width,
        accept_gaps: options.accept_gaps,
        sliver: options.sliver,
    };
    gaps.checked()?;
    stage("reading");
    let (name, mut layer) = layer(files, options.layer.as_deref(), buffers)?;
    let winner = options.overlap.as_deref().map_or(Some(Winner::default()), Winner::of_name);
    let assign = Options {
        winner: winner.ok_or_else(|| CallError::option("overlap: none of inner, larger, smaller, first, last"))?,
        gap_width: gaps.gap_width,
        lake_width: gaps.lake_width,
        accepted_gaps: gaps.accepted(),
        sliver_area: gaps.sliver,
        ..Options::default()
    };
    stage("cleaning");
    let repair = Repair {
        names: Names { from: options.name_from.as_deref() },
        options: CleanOptions { snap: snap(options.snap.as_ref())?, assign, ..CleanOptions::default() },
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
