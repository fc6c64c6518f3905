//! The options of an audit as JSON.

use crate::input_kind::InputKind;
use crate::options::Options;
use serde_json::{Map, Value, json, to_value};

/// Returns the options that determine the audit: the given ones, and the required properties of a mesh.
pub(crate) fn as_json(options: &Options, kind: InputKind) -> Map<String, Value> {
    match kind {
        InputKind::Map => of_map(options),
        InputKind::Mesh(_) => of_mesh(options),
        _ => Map::new(),
    }
}

fn of_map(options: &Options) -> Map<String, Value> {
    let of_mesh = to_value(&options.mesh).unwrap_or_default();
    let is_elsewhere = |name: &str| matches!(name, "list" | "explain") || of_mesh.get(name).is_some();
    let is_given = |value: &Value| ![Value::Null, json!(false), json!([])].contains(value);
    match to_value(options) {
        Ok(Value::Object(members)) => {
            members.into_iter().filter(|(name, value)| is_given(value) && !is_elsewhere(name)).collect()
        }
        _ => Map::new(),
    }
}

pub(crate) fn of_mesh(options: &Options) -> Map<String, Value> {
    let space: Vec<&str> = options.mesh.space().iter().map(|rule| rule.id()).collect();
    let expected = [("expected", json!(options.mesh.expectation().to_string()))].into_iter();
    let all = expected.chain((!space.is_empty()).then(|| ("space", json!(space))));
    all.map(|(key, value)| (key.to_owned(), value)).collect()
}
