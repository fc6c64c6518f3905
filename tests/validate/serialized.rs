//! Reports and tables with serde: written documents can be read, and reports that no validation produces are refused.

use crate::support::erased::validate;
use crate::support::nested::{PLANE, nested, nested_textbook};
use crate::support::tables::{half_edge, textbook_mesh, torus};
use serde_json::{Value, from_value, json, to_value};
use twinedge::validate::{Collect, Expectation, Figures, Part, Parts, Report, Rule, Table, Violation};
use twinedge_trials::enumerate::for_each_corruption;

fn read_again(report: &Report) -> Report {
    from_value(to_value(report).unwrap()).unwrap()
}

#[test]
fn the_report_of_every_corruption_is_read_as_it_was_written() {
    let mut kinds = std::collections::BTreeSet::new();
    for (mut table, expectation) in [(nested(), PLANE), (nested_textbook(), PLANE.open())] {
        let parts = table.parts;
        for_each_corruption(&mut table, parts, |corrupt, _, _| {
            for collect in [Collect::All, Collect::First, Collect::AtMost(1)] {
                let report = validate(corrupt, &expectation, collect);
                assert_eq!(read_again(&report), report);
                kinds.extend(report.violations().iter().map(Violation::kind));
            }
        });
    }
    assert!(kinds.len() > 15, "{kinds:?}");
}

#[test]
fn the_report_of_a_torus_is_read_as_it_was_written() {
    let report = validate(&textbook_mesh(12, &torus([3, 4])), &Expectation::surface(), Collect::All);
    assert_eq!(report.counts().genus, Some(1));
    assert_eq!(read_again(&report), report);
}

#[test]
fn tables_and_figures_are_read_as_they_were_written() {
    for table in [nested(), nested_textbook()] {
        assert_eq!(from_value::<Table>(to_value(&table).unwrap()).unwrap(), table);
        let figures = validate(&table, &PLANE, Collect::All).into_result().unwrap();
        assert_eq!(from_value::<Figures>(to_value(&figures).unwrap()).unwrap(), figures);
    }
}

/// The names are the values of [`Violation::kind`], which do not change.
#[test]
fn a_violation_is_named_by_its_kind() {
    let violation = Violation::TwinNotMutual { half_edge: 3, twin: 2, found: None };
    let written = to_value(violation).unwrap();
    assert_eq!(written, json!({ "kind": "twin_not_mutual", "fields": { "half_edge": 3, "twin": 2, "found": null } }));
    assert_eq!(from_value::<Violation>(written).unwrap(), violation);
    assert_eq!(to_value(Rule::L1).unwrap(), json!("L1"));
    // Serde knows each name, and only misses the fields.
    let unknown = |kind: &str| from_value::<Violation>(json!({ "kind": kind, "fields": {} })).unwrap_err().to_string();
    assert!(unknown("no_such_kind").contains("unknown variant"));
    for kind in Violation::KINDS.iter().filter(|kind| **kind != "no_unbounded_face") {
        assert!(unknown(kind).contains("missing field"), "{kind}: {}", unknown(kind));
    }
    assert_eq!(from_value::<Violation>(json!({ "kind": "no_unbounded_face" })).unwrap(), Violation::NoUnboundedFace);
}

/// Reads a report with one violation of L1 after a change, and returns the refusal.
fn refused(change: impl FnOnce(&mut Value)) -> String {
    let mut table = nested();
    half_edge(&mut table, 0).twin = Some(0);
    let report = validate(&table, &PLANE, Collect::All);
    let of_l1 = report.violations().iter().filter(|violation| violation.rule() == Rule::L1);
    assert_eq!((of_l1.count(), report.first().unwrap().rule()), (2, Rule::L1));
    let mut value = to_value(&report).unwrap();
    change(&mut value);
    from_value::<Report>(value).unwrap_err().to_string()
}

#[test]
fn a_report_that_contradicts_itself_is_refused() {
    type Change = fn(&mut Value);
    let second_cycle = |report: &mut Value| {
        report["rules"][6]["violations"] = json!(1);
        let other =
            json!({ "rule": "B1", "kind": "second_cycle", "fields": { "boundary": 0, "cycle": 1, "half_edges": 2 } });
        report["violations"].as_array_mut().unwrap().insert(0, other);
    };
    let too_many = |report: &mut Value| {
        for rule in [1, 2] {
            report["rules"][rule]["violations"] = json!(u64::MAX);
        }
    };
    let cases: [(Change, &str); 8] = [
        (
            |report| report["rules"].as_array_mut().unwrap().swap(0, 1),
            "the outcome of R1 is not in the order of the rules",
        ),
        (second_cycle, "a violation of L1 is not in the order of the rules"),
        (|report| report["valid"] = json!(true), "`valid` contradicts the outcomes of the rules"),
        (|report| report["schema"] = json!("twinedge-report/2"), "expected the schema twinedge-report/1"),
        (|report| report["violations"][0]["rule"] = json!("L2"), "a violation of L1 names another rule"),
        (|report| report["rules"][1]["violations"] = json!(1), "more violations of L1 than its outcome counts"),
        (
            |report| report["rules"][13]["unchecked"] = json!({ "broken": "V1" }),
            "a rule was not checked because V1 is broken, which it is not",
        ),
        (too_many, "the numbers of violations add up to more than can be counted"),
    ];
    for (change, expected) in cases {
        assert_eq!(refused(change), expected);
    }
}

/// Changes the report of the nested triangles, which is valid, and returns the refusal.
fn refused_though_valid(change: impl FnOnce(&mut Value)) -> String {
    let mut value = to_value(validate(&nested(), &PLANE, Collect::All)).unwrap();
    change(&mut value);
    from_value::<Report>(value).unwrap_err().to_string()
}

#[test]
fn a_report_without_a_rule_is_refused() {
    assert_eq!(refused_though_valid(|report| report["rules"] = json!([])), "R1 has no outcome");
    let topology = Rule::ALL.iter().filter(|rule| !rule.is_geometric() && !rule.is_optional());
    for (place, rule) in topology.enumerate() {
        let without = |report: &mut Value| drop(report["rules"].as_array_mut().unwrap().remove(place));
        assert_eq!(refused_though_valid(without), format!("{rule} has no outcome"));
    }
}

#[test]
fn a_valid_report_with_impossible_counts_is_refused() {
    const EULER: &str = "every rule holds, but the counts break Euler's formula";
    const CONTRADICT: &str = "the counts contradict each other";
    let huge = usize::MAX;
    for (expected, count, values) in [
        (CONTRADICT, "isolated_vertices", &[8][..]),
        (CONTRADICT, "components", &[99]),
        (CONTRADICT, "edges", &[99]),
        (CONTRADICT, "half_edges", &[99, 0]),
        (CONTRADICT, "cycles", &[99, huge]),
        (EULER, "vertices", &[8, huge]),
        (EULER, "edges", &[7]),
        (EULER, "components", &[2]),
        (EULER, "cycles", &[3]),
        (EULER, "borders", &[1, huge]),
        (EULER, "isolated_vertices", &[0]),
        (EULER, "genus", &[1, huge]),
    ] {
        for value in values {
            let error = refused_though_valid(|report| report["counts"][count] = json!(value));
            assert_eq!(error, expected, "{count} {value}");
        }
    }
    // The sum is correct, but a handle cannot lie in the plane.
    let torus = |report: &mut Value| {
        let counts = &mut report["counts"];
        (counts["genus"], counts["components"]) = (json!(1), json!(4));
    };
    assert_eq!(refused_though_valid(torus), EULER);
    for count in ["components", "cycles", "borders", "genus"] {
        let error = refused_though_valid(|report| report["counts"][count] = Value::Null);
        assert_eq!(error, "every rule holds, but components, cycles, borders or genus are missing", "{count}");
    }
}

#[test]
fn a_valid_report_with_other_bounds_than_those_of_t4_is_refused() {
    let expected = "the bounds are not those of T4";
    assert_eq!(refused_though_valid(|report| report["bounds"] = Value::Null), expected);
    for bound in ["most_edges", "most_faces"] {
        for other in [0, 1, usize::MAX] {
            assert_eq!(refused_though_valid(|report| report["bounds"][bound] = json!(other)), expected);
        }
    }
    // T4 does not apply, or no number of vertices allows this number of edges.
    let unchecked = |report: &mut Value| report["rules"][13]["unchecked"] = json!("not_simple");
    assert_eq!(refused_though_valid(unchecked), expected);
    let too_many_edges = |report: &mut Value| {
        let counts = &mut report["counts"];
        (counts["edges"], counts["half_edges"], counts["cycles"]) = (json!(16), json!(32), json!(14));
    };
    assert_eq!(refused_though_valid(too_many_edges), expected);
    let too_many_faces = |report: &mut Value| report["counts"]["faces"] = json!(11);
    assert_eq!(refused_though_valid(too_many_faces), expected);
}

#[test]
fn parts_are_read_as_they_were_written() {
    for without in Part::ALL {
        let parts = Parts::ALL.without(without);
        assert_eq!(to_value(parts).unwrap(), parts.iter().map(Part::word).collect::<Value>());
        assert_eq!(from_value::<Parts>(to_value(parts).unwrap()).unwrap(), parts);
        assert_eq!(from_value::<Part>(json!(without.word())).unwrap(), without);
    }
    assert_eq!(from_value::<Parts>(json!([])).unwrap(), Parts::NONE);
    // A part implies its dependencies.
    assert_eq!(from_value::<Parts>(json!(["places"])).unwrap(), Parts::NONE.with(Part::Places));
    assert!(from_value::<Parts>(json!(["next"])).unwrap_err().to_string().contains("unknown variant `next`"));
}

#[test]
fn a_table_that_says_nothing_of_its_parts_has_all() {
    for table in [nested(), nested_textbook()] {
        let mut value = to_value(&table).unwrap();
        assert_eq!(from_value::<Table>(value.clone()).unwrap(), table);
        value.as_object_mut().unwrap().remove("parts").unwrap();
        assert_eq!(from_value::<Table>(value).unwrap(), Table { parts: Parts::ALL, ..table });
    }
}

#[test]
fn reasons_are_written_by_name() {
    let table = Table { parts: Parts::ALL.without(Part::Faces), ..Table::default() };
    let report = to_value(validate(&table, &Expectation::surface(), Collect::All)).unwrap();
    assert_eq!(
        report["rules"][6],
        json!({ "id": "B1", "checked": 0, "violations": 0, "unchecked": { "lacks": "faces" } })
    );
    assert_eq!(report["rules"][10]["unchecked"], json!("plane_only"));
}
