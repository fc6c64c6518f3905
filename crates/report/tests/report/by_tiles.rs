//! An audit by tiles reports what the audit of the whole map does.

use crate::shared::FAULTY;
use crate::support::{audited, crossing, json, world};
use serde_json::Value;

/// Two fields whose common border has a vertex only in the west, on the line between two tiles.
const UNMATCHED: &str = "POLYGON((0 0,2 0,2 2,2 4,0 4,0 0))\nPOLYGON((2 0,4 0,4 4,2 4,2 0))\n";

/// Removes the parts specific to tiles and the names of records, which have no numbers in tiles. Rounds measures.
fn compared(mut value: Value) -> Value {
    let without = |one: &mut Value, keys: &[&str]| {
        let object = one.as_object_mut().unwrap();
        object.retain(|key, _| !keys.contains(&key.as_str()));
    };
    // Without shapes, no finding is known to follow from another.
    without(&mut value, &["elapsed_ms", "tiles", "headline", "causes", "consequences", "first"]);
    round(&mut value);
    for finding in value["coverage"]["findings"].as_array_mut().unwrap() {
        without(finding, &["follows_from", "follows_from_id"]);
    }
    for violation in value["violations"].as_array_mut().unwrap() {
        without(violation, &["message", "records", "follows_from", "follows_from_id"]);
        if violation["rule"] == "G4" {
            without(violation, &["fields"]);
            violation["at"].as_array_mut().unwrap().sort_by_key(ToString::to_string);
        } else {
            // A component is named by any of its vertices.
            without(violation, &["at", "features", "feature_numbers"]);
            without(&mut violation["fields"], &["vertex"]);
        }
    }
    value
}

/// Rounds numbers to nine digits.
fn round(value: &mut Value) {
    match value {
        Value::Number(number) if number.is_f64() => {
            let rounded: f64 = format!("{:.9e}", number.as_f64().unwrap()).parse().unwrap();
            *value = rounded.into();
        }
        Value::Array(items) => items.iter_mut().for_each(round),
        Value::Object(members) => members.values_mut().for_each(round),
        _ => {}
    }
}

#[test]
fn an_audit_by_tiles_is_that_of_the_whole() {
    let (crossing, world) = (crossing(), world());
    for (input, all_words, numbers) in [
        (
            FAULTY,
            &["", "--coverage", "--gap-width 0.4 --sliver 0.1", "--explain --list 2"][..],
            &["--tiles 1", "--tiles 2", "--tiles 5", "--memory 1000000000", "--memory 32768"][..],
        ),
        (UNMATCHED, &["", "--coverage --explain"], &["--tiles 1", "--tiles 3"]),
        (&crossing, &[""], &["--tiles 1", "--memory 64000000", "--memory 1"]),
        (&crossing, &["--coverage --explain"], &["--tiles 1", "--tiles 3"]),
        (&world, &[""], &["--tiles 5"]),
    ] {
        for words in all_words {
            let whole = compared(json(input, words));
            let mut counts = Vec::new();
            for tiles in numbers {
                let by_tiles = json(input, &format!("{words} {tiles}"));
                counts.push((tiles, by_tiles["tiles"]["count"].as_u64().unwrap()));
                let columns = by_tiles["tiles"]["columns"].to_string();
                assert!(tiles.strip_prefix("--tiles ").is_none_or(|tiles| *tiles == columns), "{tiles} {columns}");
                assert_eq!(compared(by_tiles), whole, "{words} {tiles}");
            }
            let [.., (large, few), (small, many)] = &counts[..] else { continue };
            assert!(!large.contains("memory") || !small.contains("memory") || few < many, "{few} {many}");
        }
    }
    let coverage = &json(FAULTY, "")["coverage"];
    for count in ["overlaps", "gaps", "slivers", "duplicates", "ogc_invalid"] {
        assert!(coverage[count].as_u64() > Some(0), "{count}: {coverage}");
    }
    for input in [UNMATCHED, &crossing] {
        assert_eq!(json(input, "")["verdict"], "invalid");
    }
}

#[test]
fn findings_of_tiles_are_a_layer_of_places() {
    let layer = |words: &str| {
        let (layer, _) = audited(FAULTY, words).findings().unwrap();
        let layer: Value = serde_json::from_slice(&layer).unwrap();
        let features = layer["features"].as_array().unwrap().iter();
        let key = |one: &Value| ["rule", "message", "x", "y"].map(|key| one["properties"][key].to_string());
        let mut found: Vec<_> = features.clone().map(key).collect();
        found.sort();
        (found, features.map(|one| one["geometry"]["type"].as_str().unwrap().to_owned()).collect::<Vec<_>>())
    };
    let ((whole, shapes), (by_tiles, points)) = (layer("--coverage"), layer("--coverage --tiles 2"));
    assert!(whole.len() > 4 && shapes.contains(&"Polygon".to_owned()), "{shapes:?}");
    assert_eq!(by_tiles, whole);
    assert!(points.iter().all(|kind| kind.ends_with("Point")), "{points:?}");
}
