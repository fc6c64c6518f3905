//! Files of accepted findings, and `twinedge diff`.

use crate::shared::has;
use crate::support::Folder;
use serde_json::{Value, json};

/// Two fields that overlap, and a lake of this width.
fn layer(lake: u32) -> String {
    let hole = if lake == 0 { String::new() } else { format!(",(10 10,{0} 10,{0} 14,10 14,10 10)", 10 + lake) };
    format!("POLYGON((0 0,40 0,40 40,0 40,0 0){hole})\nPOLYGON((39 0,60 0,60 40,39 40,39 0))\n")
}

const JUDGED: &str = "--snap auto --coverage --format json --quiet";

#[test]
fn findings_are_accepted_by_a_file_and_the_file_is_updated() {
    let folder = Folder::new(&[("may.wkt", &layer(4)), ("june.wkt", &layer(5))]);
    let audit = |words: &str| folder.json(&format!("audit {words} {JUDGED}"));
    let list = || serde_json::from_slice::<Value>(&folder.read("list.json")).unwrap();
    assert_eq!(audit("may.wkt --accept-all list.json --reason 'a lake, and a quarrel'").0, Some(1));
    let entry = json!({"reason": "a lake, and a quarrel"});
    has(&list(), &json!({"schema": "twinedge-accepted/1", "accepted": [entry, entry]}));
    // A day.
    assert_eq!(list()["accepted"][0]["date"].as_str().unwrap().len(), 10);
    let (status, found) = audit("may.wkt --accept list.json");
    assert_eq!((status, &found["accepted"]["count"]), (Some(0), &json!(2)));
    assert_eq!(audit("june.wkt --accept list.json").0, Some(1));
    audit("june.wkt --accept list.json --accept-all list.json --reason grown");
    has(&list(), &json!({"accepted": [entry, {"reason": "grown"}]}));
    assert_eq!(audit("june.wkt --accept list.json").0, Some(0));
    let alone = folder.run("audit may.wkt --reason x");
    assert_eq!(alone.status, Some(2), "{alone:?}");
}

#[test]
fn reports_are_compared() {
    let folder = Folder::new(&[("may.wkt", &layer(4)), ("dry.wkt", &layer(0)), ("none.json", "{}")]);
    for name in ["may", "dry"] {
        folder.run(&format!("audit {name}.wkt -o {name}.json --snap auto"));
    }
    let may: Value = serde_json::from_slice(&folder.read("may.json")).unwrap();
    let lake = may["coverage"]["findings"][1]["id"].as_str().unwrap();
    folder.transcript(&format!(
        "
diff may.json may.json => 0 0 new, 0 gone, 0 changed, 2 the same
diff may.json dry.json => 0 gone {lake} gap: feature 0; area 16.0000 ++ 0 new, 1 gone, 0 changed, 1 the same
diff dry.json may.json => 1 new {lake} gap: feature 0; area 16.0000 ++ 1 new, 0 gone, 0 changed, 1 the same
diff none.json none.json => 2 none.json: no report of `twinedge audit --format json`: it has no counts
diff may.wkt may.json => 2 may.wkt: expected value
diff may.json lost.json => 2 lost.json: No such file
"
    ));
    let (status, found) = folder.json("diff dry.json may.json --format json");
    assert_eq!((status, found), (Some(1), json!({"new": [lake], "gone": [], "changed": [], "same": 1})));
}
