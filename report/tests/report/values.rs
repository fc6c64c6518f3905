//! Comparisons of JSON with what is expected of it.

use serde_json::Value;

/// Asserts that the found value has all that is expected: the members of objects, the items of lists in their order. Null stands for an
/// absent member.
#[track_caller]
pub(crate) fn has(found: &Value, expected: &Value) {
    if let Some(why) = difference(found, expected) {
        panic!("{why}\n{found}");
    }
}

fn difference(found: &Value, expected: &Value) -> Option<String> {
    let differs = || Some(format!(": {found}, and not {expected}"));
    match (found, expected) {
        (Value::Object(found), Value::Object(expected)) => expected.iter().find_map(|(key, expected)| {
            let why = difference(found.get(key).unwrap_or(&Value::Null), expected)?;
            Some(format!(".{key}{why}"))
        }),
        (Value::Array(found), Value::Array(expected)) if found.len() == expected.len() => {
            let pairs = found.iter().zip(expected).enumerate();
            let mut differences =
                pairs.filter_map(|(i, (found, expected))| Some(format!("[{i}]{}", difference(found, expected)?)));
            differences.next()
        }
        (Value::Number(found), Value::Number(expected)) if found.as_f64() == expected.as_f64() => None,
        _ if found == expected => None,
        _ => differs(),
    }
}

/// Returns these members of the items of a list.
pub(crate) fn members(list: &Value, keys: &[&str]) -> Value {
    let of = |one: &Value| keys.iter().map(|key| one[*key].clone()).collect::<Value>();
    let of = |one: &Value| if let [key] = keys { one[*key].clone() } else { of(one) };
    list.as_array().unwrap().iter().map(of).collect()
}
