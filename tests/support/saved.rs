//! Saved documents, changed in one place.

use serde_json::{Value, json};

/// Calls `visit` with the document after each change of one number, one text, or the order of two list entries, and with the place of
/// the change.
pub(crate) fn each_change(saved: &Value, mut visit: impl FnMut(&str, Value)) {
    let mut places = Vec::new();
    collect(saved, String::new(), &mut places);
    for place in &places {
        for other in others(saved.pointer(place).unwrap()) {
            let mut changed = saved.clone();
            *changed.pointer_mut(place).unwrap() = other;
            visit(place, changed);
        }
    }
}

/// Collects the places of all values in a value, including itself.
fn collect(value: &Value, place: String, places: &mut Vec<String>) {
    let entries: Vec<(String, &Value)> = match value {
        Value::Array(list) => list.iter().enumerate().map(|(i, value)| (i.to_string(), value)).collect(),
        Value::Object(map) => map.iter().map(|(key, value)| (key.clone(), value)).collect(),
        _ => vec![],
    };
    for (key, value) in entries {
        collect(value, format!("{place}/{key}"), places);
    }
    places.push(place);
}

fn others(value: &Value) -> Vec<Value> {
    match value {
        Value::Number(n) => match n.as_u64() {
            Some(n) => (0..9).chain([n + 1]).filter(|other| *other != n).map(Value::from).collect(),
            None => vec![json!(n.as_f64().unwrap() + 0.125)],
        },
        Value::String(text) => vec![json!(format!("{text}?"))],
        Value::Array(list) => {
            let pairs = (0..list.len()).flat_map(|i| (0..i).map(move |j| (i, j))).filter(|(i, j)| list[*i] != list[*j]);
            let exchanged = |(i, j)| {
                let mut list = list.clone();
                list.swap(i, j);
                Value::Array(list)
            };
            pairs.map(exchanged).collect()
        }
        _ => vec![],
    }
}
