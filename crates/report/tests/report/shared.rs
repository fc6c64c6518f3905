//! Inputs, and comparisons of JSON with what is expected of it: for these tests and those of the program.

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

/// Three parcels: the second begins half a unit inside the first, and a narrow gap separates both from the third.
pub(crate) const PARCELS: &str = r#"{"type":"FeatureCollection",
"source":"survey",
"features":[
{"type":"Feature","id":"A-1","properties":{"owner":"Meier","since":"2020-01-31"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[10,0],[10,10],[0,10],[0,0]]]}},
{"type":"Feature","id":"A-2","properties":{"owner":"Müller"},"geometry":{"type":"Polygon","coordinates":[[[9.5,0],[20,0],[20,10],[9.5,10],[9.5,0]]]}},
{"type":"Feature","id":"A-3","properties":{"owner":"Huber"},"geometry":{"type":"Polygon","coordinates":[[[0,10],[10,10.05],[20,10],[20,20],[0,20],[0,10]]]}}
]}
"#;

/// A layer of parcels with a gap, an overlap, a sliver, a duplicate and a polygon with a spike, each cut by lines between tiles.
pub(crate) const FAULTY: &str = "POLYGON((0 0,4 0,3 2,4 4,0 4,0 0))
POLYGON((4 0,8 0,8 4,4 4,5 2,4 0))
POLYGON((0 4,4 4,8 4,8 8,4 8,0 8,0 4))
POLYGON((4 4,8 4,8 8,4 8,4 4))
POLYGON((8 0,8.0001 0,8.0001 8,8 8,8 4,8 0))
POLYGON((10 3,12 3,12 5,10 5,10 3))
POLYGON((10 3,12 3,12 5,10 5,10 3))
POLYGON((13 3,15 3,14 4,15 5,13 5,14 4,13 3))
";

/// The faces of a cube, counted from 1, outward.
pub(crate) const CUBE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
    f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// Two adjacent unit squares with a common arc, and a town.
pub(crate) const TOPOLOGY: &str = r#"{"type": "Topology",
"arcs": [[[1, 0], [1, 1]], [[1, 1], [0, 1], [0, 0], [1, 0]], [[1, 0], [2, 0], [2, 1], [1, 1]]],
"objects": {
  "squares": {"type": "GeometryCollection", "geometries": [
    {"type": "Polygon", "id": "a", "properties": {"name": "left"}, "arcs": [[0, 1]]},
    {"type": "Polygon", "id": "b", "properties": {"name": "right"}, "arcs": [[2, -1]]}]},
  "town": {"type": "Point", "coordinates": [0.5, 0.5]}}}"#;

/// A topology of PostGIS.
pub(crate) const TOWN: &[u8] = include_bytes!("../../../postgis/tests/postgis/data/town.copy");

/// The town with a wrong `next_left_edge` of edge 1.
pub(crate) fn broken_town() -> Vec<u8> {
    let mut bytes = TOWN.to_vec();
    // The ids of edge 1: itself, its nodes, and its next edges 3 and −6.
    let row: Vec<u8> =
        [1, 1, 2, 3, 3, -6, 6, 2, 0].iter().flat_map(|id: &i32| [4_i32, *id]).flat_map(i32::to_be_bytes).collect();
    let at = bytes.windows(row.len()).position(|window| window == row).expect("edge 1 is there");
    // Two values of eight bytes precede it, each with its length.
    for column in [3, 4] {
        bytes[at + 8 * column + 7] = 99;
    }
    bytes
}
