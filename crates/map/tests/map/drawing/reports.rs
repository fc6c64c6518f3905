//! Saving and loading reports of maps.

use serde_json::{from_value, to_value};
use twinedge::validate::{Report, Rule};
use twinedge_map::PlanarMap;

fn read_again(report: &Report) -> Report {
    from_value(to_value(report).unwrap()).unwrap()
}

/// Coordinates are checked by all five rules or by none.
#[test]
fn a_report_with_some_of_the_rules_of_coordinates_is_refused() {
    let report = PlanarMap::new().validate();
    assert_eq!(read_again(&report), report);
    let geometric: Vec<Rule> = Rule::ALL.iter().copied().filter(|rule| rule.is_geometric()).collect();
    for left in 0..1_usize << geometric.len() {
        let is_left = |rule: Rule| geometric.iter().position(|g| *g == rule).is_none_or(|i| left >> i & 1 == 1);
        let mut value = to_value(&report).unwrap();
        value["rules"].as_array_mut().unwrap().retain(|entry| is_left(from_value(entry["id"].clone()).unwrap()));
        let missing = geometric.iter().find(|rule| !is_left(**rule)).filter(|_| left > 0);
        let found = from_value::<Report>(value).err().map(|error| error.to_string());
        assert_eq!(found, missing.map(|rule| format!("{rule} has no outcome")));
    }
}
