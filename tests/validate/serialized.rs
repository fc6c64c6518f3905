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

/// Changes the report of the nested triangles, which is valid, and returns the refusal.
fn refused_though_valid(change: impl FnOnce(&mut Value)) -> String {
    let mut value = to_value(validate(&nested(), &PLANE, Collect::All)).unwrap();
    change(&mut value);
    from_value::<Report>(value).unwrap_err().to_string()
}

#[test]
fn numbers_of_violations_that_overflow_are_refused() {
    let error = refused(|report| {
        for rule in [1, 2] {
            report["rules"][rule]["violations"] = json!(u64::MAX);
        }
    });
    assert_eq!(error, "the numbers of violations add up to more than can be counted");
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
    for (count, value) in [
        ("isolated_vertices", 8),
        ("components", 99),
        ("edges", 99),
        ("half_edges", 99),
        ("half_edges", 0),
        ("cycles", 99),
        ("cycles", usize::MAX),
    ] {
        let error = refused_though_valid(|report| report["counts"][count] = json!(value));
        assert_eq!(error, "the counts contradict each other", "{count} {value}");
    }
}

#[test]
fn a_valid_report_that_breaks_the_formula_of_euler_is_refused() {
    let expected = "every rule holds, but the counts break Euler's formula";
    for (count, value) in [
        ("vertices", 8),
        ("vertices", usize::MAX),
        ("edges", 7),
        ("components", 2),
        ("cycles", 3),
        ("borders", 1),
        ("borders", usize::MAX),
        ("isolated_vertices", 0),
        ("genus", 1),
        ("genus", usize::MAX),
    ] {
        assert_eq!(refused_though_valid(|report| report["counts"][count] = json!(value)), expected, "{count} {value}");
    }
    // The sum is correct, but a handle cannot lie in the plane.
    let torus = |report: &mut Value| {
        let counts = &mut report["counts"];
        (counts["genus"], counts["components"]) = (json!(1), json!(4));
    };
    assert_eq!(refused_though_valid(torus), expected);
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
fn a_valid_report_without_its_counts_is_refused() {
    for count in ["components", "cycles", "borders", "genus"] {
        let error = refused_though_valid(|report| report["counts"][count] = Value::Null);
        assert_eq!(error, "every rule holds, but components, cycles, borders or genus are missing", "{count}");
    }
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
