//! `neighbours`: all pairs of features with a border or an overlap.

use crate::error::CallError;
use crate::options::AuditOptions;
use crate::source::{Buffer, NamedFile, input};
use serde::Deserialize;
use serde_json::{Value, json};
use twinedge_report::words::json as json_bytes;
use twinedge_report::{Imported, Keep, Units, borders};
use twinedge_web_bridge::Buffers;

#[derive(Deserialize)]
pub(crate) struct Request {
    files: Vec<NamedFile>,
    options: AuditOptions,
}

pub(crate) fn answer(
    asked: Request,
    buffers: &mut Buffers,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Value, CallError> {
    let Request { files, options } = asked;
    let asked = options.options()?;
    stage("reading");
    let input = input(files, options.layer.as_deref(), buffers)?;
    let name = input.name.clone();
    let failed = |error: CallError| error.of(&name);
    let imported = Imported::read(input, &asked.map, Keep::default(), stage).map_err(|error| failed(error.into()))?;
    if !imported.map.is_plane() {
        let why = "borders cross, touch or overlap, so places are not well defined: snap \"auto\" cuts them, and audit says where they are";
        return Err(failed(CallError::new("not-plane", why)));
    }
    let units = Units::of(&imported, asked.measured.geodesic).map_err(|error| failed(error.into()))?;
    let pairs = borders(&imported.map, &imported.noted, &units);
    let answer = json!({ "input": name, "unit": units.name(), "pairs": pairs });
    let bytes = json_bytes(&answer)?;
    Ok(json!({ "answer": Buffer::put(buffers, bytes) }))
}
