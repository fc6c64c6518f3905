//! `audit`, `auditPage`, `acceptAll`, `findings`.

use crate::error::CallError;
use crate::options::AuditOptions;
use crate::source::{Buffer, NamedFile, input};
use serde::Deserialize;
use serde_json::{Map, Value, to_value};
use twinedge_report::{InputKind, audit};
use twinedge_web_bridge::Buffers;

#[derive(Deserialize)]
pub(crate) struct Request {
    files: Vec<NamedFile>,
    options: AuditOptions,
    want: Vec<Output>,
    /// Today's date, for newly accepted findings.
    #[serde(default)]
    date: String,
}

/// A form of the report.
#[derive(Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Output {
    Report,
    Page,
    Findings,
    AcceptAll,
}

pub(crate) fn answer(
    asked: Request,
    buffers: &mut Buffers,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Value, CallError> {
    stage("reading");
    let mut options = asked.options.options()?;
    // A finding that is not listed would be neither accepted nor written.
    if options.accepted.is_some() || asked.want == [Output::AcceptAll] {
        options.list = Some(usize::MAX);
    }
    let mut input = input(asked.files, asked.options.layer.as_deref(), buffers)?;
    let name = input.name.clone();
    let of_input = |error: CallError| error.of(&name);
    let kind = InputKind::of(asked.options.postgis, asked.options.arcs, &mut input).map_err(|e| of_input(e.into()))?;
    if !matches!(kind, InputKind::Map | InputKind::Arcs) {
        input.refuse_layer(kind.words()).map_err(|error| of_input(error.into()))?;
    }
    let audited = audit(input, kind, &options, stage).map_err(|error| of_input(error.into()))?;
    stage("writing the report");
    let mut answer = Map::new();
    for want in asked.want {
        let (key, bytes) = match want {
            Output::Report => ("report", audited.json()?),
            Output::Page => ("page", audited.page()?.into_bytes()),
            Output::AcceptAll => {
                let reason = asked.options.reason.as_deref().unwrap_or("accepted as it is");
                ("accept_all", audited.accept_all(options.accepted.as_ref(), reason, &asked.date)?)
            }
            Output::Findings => {
                let (layer, warnings) = audited.findings()?;
                answer.insert("warnings".to_owned(), warnings.into());
                ("findings", layer)
            }
        };
        answer.insert(key.to_owned(), to_value(Buffer::put(buffers, bytes))?);
    }
    Ok(answer.into())
}
