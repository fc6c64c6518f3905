//! Reports and tables with serde: what is written is read again, and a report that no validation gives is refused.

use crate::support::erased::validate;
use crate::support::nested::{PLANE, TEXTBOOK, nested, nested_textbook};
use crate::support::tables::half_edge;
use serde_json::{Value, from_value, json, to_value};
use twinedge::validate::enumerate::for_each_corruption;
use twinedge::validate::{Certificate, Collect, Expectation, Part, Report, Rule, Table, Violation};

fn read_again(report: &Report) -> Report {
    from_value(to_value(report).unwrap()).unwrap()
}

#[test]
fn the_report_of_every_corruption_is_read_as_it_was_written() {
    let mut kinds = std::collections::BTreeSet::new();
    for (mut table, expectation) in [(nested(), PLANE), (nested_textbook(), TEXTBOOK.open())] {
        for_each_corruption(&mut table, &expectation, |corrupt, _, _| {
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
fn tables_and_certificates_are_read_as_they_were_written() {
    for (table, expectation) in [(nested(), PLANE), (nested_textbook(), TEXTBOOK)] {
        assert_eq!(from_value::<Table>(to_value(&table).unwrap()).unwrap(), table);
        let certificate = validate(&table, &expectation, Collect::All).into_result().unwrap();
        assert_eq!(from_value::<Certificate>(to_value(&certificate).unwrap()).unwrap(), certificate);
    }
}

/// The names are those of [`Violation::kind`], which do not change.
#[test]
fn a_violation_is_named_by_its_kind() {
    let violation = Violation::TwinNotMutual { half_edge: 3, twin: 2, found: None };
    let written = to_value(violation).unwrap();
    assert_eq!(written, json!({ "kind": "twin_not_mutual", "fields": { "half_edge": 3, "twin": 2, "found": null } }));
    assert_eq!(from_value::<Violation>(written).unwrap(), violation);
    assert_eq!(to_value(Rule::L1).unwrap(), json!("L1"));
    // Each name is one that serde knows: what it misses then are the fields.
    let unknown = |kind: &str| from_value::<Violation>(json!({ "kind": kind, "fields": {} })).unwrap_err().to_string();
    assert!(unknown("no_such_kind").contains("unknown variant"));
    for kind in Violation::KINDS.iter().filter(|kind| **kind != "no_unbounded_face") {
        assert!(unknown(kind).contains("missing field"), "{kind}: {}", unknown(kind));
    }
    assert_eq!(from_value::<Violation>(json!({ "kind": "no_unbounded_face" })).unwrap(), Violation::NoUnboundedFace);
}

/// A report with one violation of L1, and then with one value replaced.
fn refused(change: impl FnOnce(&mut Value)) -> String {
    let mut table = nested();
    half_edge(&mut table, 0).twin = Some(0);
    let report = validate(&table, &PLANE, Collect::All);
    let of_l1 = report.violations().iter().filter(|violation| violation.rule() == Rule::L1);
    assert_eq!((of_l1.count(), report.violations()[0].rule()), (2, Rule::L1));
    let mut value = to_value(&report).unwrap();
    change(&mut value);
    from_value::<Report>(value).unwrap_err().to_string()
}

#[test]
fn a_report_with_rules_out_of_order_is_refused() {
    let error = refused(|report| report["rules"].as_array_mut().unwrap().swap(0, 1));
    assert_eq!(error, "the outcome of R1 is not in the order of the rules");
}

#[test]
fn a_report_with_violations_out_of_order_is_refused() {
    let error = refused(|report| {
        report["rules"][6]["violations"] = json!(1);
        let other =
            json!({ "rule": "B1", "kind": "second_cycle", "fields": { "boundary": 0, "cycle": 1, "half_edges": 2 } });
        report["violations"].as_array_mut().unwrap().insert(0, other);
    });
    assert_eq!(error, "a violation of L1 is not in the order of the rules");
}

#[test]
fn a_report_that_contradicts_itself_is_refused() {
    assert_eq!(refused(|report| report["valid"] = json!(true)), "`valid` contradicts the outcomes of the rules");
    assert_eq!(
        refused(|report| report["schema"] = json!("twinedge-report/2")),
        "expected the schema twinedge-report/1"
    );
    let error = refused(|report| report["violations"][0]["rule"] = json!("L2"));
    assert_eq!(error, "a violation of L1 names another rule");
}

#[test]
fn a_report_with_violations_that_are_not_counted_is_refused() {
    let error = refused(|report| report["rules"][1]["violations"] = json!(1));
    assert_eq!(error, "more violations of L1 than its outcome counts");
}

#[test]
fn a_report_that_blames_a_rule_that_holds_is_refused() {
    let error = refused(|report| report["rules"][13]["unchecked"] = json!({ "broken": "V1" }));
    assert_eq!(error, "a rule was not checked because V1 is broken, which it is not");
}

#[test]
fn a_valid_report_with_impossible_counts_is_refused() {
    let mut value = to_value(validate(&nested(), &PLANE, Collect::All)).unwrap();
    value["counts"]["isolated_vertices"] = json!(8);
    let error = from_value::<Report>(value).unwrap_err().to_string();
    assert_eq!(error, "the counts contradict each other");
}

#[test]
fn a_valid_report_without_its_counts_is_refused() {
    let mut value = to_value(validate(&nested(), &PLANE, Collect::All)).unwrap();
    value["counts"]["genus"] = Value::Null;
    let error = from_value::<Report>(value).unwrap_err().to_string();
    assert_eq!(error, "every rule holds, but components, cycles, borders or genus are missing");
}

#[test]
fn reasons_are_written_by_name() {
    let expectation = Expectation::surface().without(Part::Faces);
    let report = to_value(validate(&Table::default(), &expectation, Collect::All)).unwrap();
    assert_eq!(
        report["rules"][6],
        json!({ "id": "B1", "checked": 0, "violations": 0, "unchecked": { "lacks": "faces" } })
    );
    assert_eq!(report["rules"][10]["unchecked"], json!("plane_only"));
}
