//! Options, as the package spells them.

use crate::error::CallError;
use serde::Deserialize;
use serde_json::{Map, Value};
use twinedge_report::{Accepted, Options};

/// The options of an audit, and of every function that reads a map.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default)]
pub(crate) struct AuditOptions {
    pub(crate) layer: Option<String>,
    accept: Option<Value>,
    pub(crate) reason: Option<String>,
    pub(crate) arcs: bool,
    pub(crate) postgis: bool,
    #[serde(flatten)]
    others: Map<String, Value>,
}

impl AuditOptions {
    pub(crate) fn options(&self) -> Result<Options, CallError> {
        let read = |list: &Value| Accepted::read(&list.to_string());
        let accepted = self.accept.as_ref().map(read).transpose();
        let accepted = accepted.map_err(|error| CallError::option(format!("accept: {error}")))?;
        let options = Options::from_json(self.others.clone()).map_err(CallError::option)?;
        Ok(Options { accepted, ..options })
    }
}
