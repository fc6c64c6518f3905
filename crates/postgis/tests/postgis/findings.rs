//! Every finding, made from the map that PostGIS wrote, with its message.

use crate::support::{ABS_NEXT_LEFT, Change, EDGE, FACE, GEOM, LEFT_FACE, NEXT_LEFT, NODE, Rows, START, TOWN};
use crate::support::{int, line, point, polygon};
use std::collections::BTreeSet;
use twinedge_postgis::TopologyAudit;

/// Audits the town after a change.
fn changed(change: impl FnOnce(&mut Rows)) -> TopologyAudit {
    let mut rows = Rows::of(TOWN);
    change(&mut rows);
    rows.audit()
}

fn broken(audit: &TopologyAudit) -> Vec<&'static str> {
    audit.rules().iter().filter(|rule| rule.violations > 0).map(|rule| rule.id).collect()
}

#[test]
fn a_topology_without_a_row_for_face_0_has_no_unbounded_face() {
    let audit = changed(|rows| rows.0.iter_mut().for_each(Vec::clear));
    assert_eq!(broken(&audit), ["F1"], "{audit}");
}

/// A change, the rules that it breaks, and the message of one of the violations.
type Case = (&'static str, fn(&mut Rows), &'static [&'static str], &'static str);

const CASES: &[Case] = &[
    ("id_missing", |rows| rows.row(NODE, 13)[0] = None, &["P0"], "row 13 of table node has no id"),
    (
        "id_repeated",
        |rows| {
            let copy = rows.row(EDGE, 5).clone();
            rows.0[EDGE].push(copy);
        },
        &["P0"],
        "two rows of table edge_data have the id 5",
    ),
    (
        "edge_id_not_positive",
        |rows| rows.row(EDGE, 10)[0] = int(-10),
        &["P0", "R1", "B2"],
        "edge -10 has an id that is not positive",
    ),
    ("node_without_point", |rows| rows.row(NODE, 13)[2] = None, &["P1"], "node 13 has no point"),
    ("node_without_point", |rows| rows.row(NODE, 3)[2] = point(f64::NAN, f64::NAN), &["P1"], "node 3 has no point"),
    (
        "node_not_point",
        |rows| rows.row(NODE, 13)[2] = line(&[[0.0, 0.0], [1.0, 0.0]]),
        &["P1"],
        "the geometry of node 13 is a line, no point",
    ),
    ("edge_without_curve", |rows| rows.row(EDGE, 5)[GEOM] = None, &["P1"], "edge 5 has no line of two points or more"),
    (
        "edge_not_curve",
        |rows| rows.row(EDGE, 5)[GEOM] = Some(vec![1, 8, 0, 0, 0, 0, 0, 0, 0]),
        &["P1"],
        "the geometry of edge 5 is a circular string, no line",
    ),
    (
        "starts_elsewhere",
        |rows| rows.row(EDGE, 5)[GEOM] = line(&[[41.0, 60.0], [40.0, 100.0]]),
        &["P1"],
        "the line of edge 5 starts elsewhere than at its start node 3",
    ),
    (
        "ends_elsewhere",
        |rows| rows.row(EDGE, 5)[GEOM] = line(&[[40.0, 60.0], [40.0, 99.0]]),
        &["P1"],
        "the line of edge 5 ends elsewhere than at its end node 4",
    ),
    (
        "other_reference_system",
        |rows| {
            let geom = rows.row(EDGE, 5)[GEOM].as_mut().unwrap();
            geom[4] = 0x20;
            geom.splice(5..5, 4326_u32.to_le_bytes());
        },
        &["P1"],
        "geom of edge_data 5 has the reference system 4326, where the first geometry has 0",
    ),
    (
        "connected_has_containing_face",
        |rows| rows.row(NODE, 3)[1] = int(2),
        &["P2"],
        "node 3 has edges, but its containing_face is 2 instead of null",
    ),
    (
        "no_such_containing_face",
        |rows| rows.row(NODE, 13)[1] = int(99),
        &["P2", "B2"],
        "the containing_face of node 13 is 99, and there is no such face with edges",
    ),
    (
        "isolated_unclaimed",
        |rows| rows.row(NODE, 13)[1] = None,
        &["B2"],
        "node 13 has no edges, and no face contains it",
    ),
    (
        "face_without_edges",
        |rows| rows.0[FACE].push(vec![int(99), None]),
        &["P3"],
        "no edge names face 99 as its left or right face",
    ),
    ("mbr_missing", |rows| rows.row(FACE, 3)[1] = None, &["P4"], "the mbr of face 3 is null"),
    (
        "mbr_not_box",
        |rows| rows.row(FACE, 6)[1] = polygon(&[[200.0, 0.0], [210.0, 0.0], [205.0, 10.0], [200.0, 0.0]]),
        &["P4"],
        "the mbr of face 6 is no rectangle along the axes",
    ),
    (
        "mbr_wrong",
        |rows| {
            let ring = [[200.0, 0.0], [200.0, 10.0], [211.0, 10.0], [211.0, 0.0], [200.0, 0.0]];
            rows.row(FACE, 6)[1] = polygon(&ring);
        },
        &["P4"],
        "the mbr of face 6 is not the box around its edges",
    ),
    (
        "universe_has_mbr",
        |rows| rows.row(FACE, 0)[1] = polygon(&[[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]]),
        &["P4"],
        "the mbr of face 0, which has no outside, is not null",
    ),
    (
        "abs_next_differs",
        |rows| rows.row(EDGE, 1)[ABS_NEXT_LEFT] = int(-3),
        &["P4"],
        "abs_next_left_edge of edge 1 is -3, not the absolute value of the link beside it",
    ),
    (
        "dangling",
        |rows| rows.row(EDGE, 1)[NEXT_LEFT] = int(-99),
        &["P4", "R1"],
        "next_left_edge of edge 1 is -99, and there is no such edge",
    ),
    (
        "dangling",
        |rows| rows.row(EDGE, 1)[START] = int(99),
        &["R1"],
        "start_node of edge 1 is 99, and there is no such node",
    ),
    (
        "dangling",
        |rows| rows.row(EDGE, 1)[LEFT_FACE] = int(99),
        &["R1"],
        "left_face of edge 1 is 99, and there is no such face",
    ),
    ("nil", |rows| rows.row(EDGE, 1)[START] = None, &["R1"], "start_node of edge 1 is null"),
    (
        "next_shared",
        |rows| {
            rows.row(EDGE, 1)[NEXT_LEFT] = int(2);
            rows.row(EDGE, 1)[ABS_NEXT_LEFT] = int(2);
        },
        &["L2", "B1"],
        "next_left_edge of edge 1 and next_right_edge of edge 3 are both 2, so one of their rings never closes",
    ),
    (
        "face_changes",
        |rows| rows.row(EDGE, 1)[LEFT_FACE] = int(3),
        &["B1"],
        "left_face of edge 6 is 2, but left_face of edge 1, which follows it, is 3: the face changes along a ring",
    ),
    (
        "segments_cross",
        |rows| rows.row(EDGE, 3)[GEOM] = line(&[[40.0, 0.0], [-5.0, 30.0], [40.0, 60.0]]),
        &["P4", "G4"],
        "segment 0 of edge +6 and segment 0 of edge +3 cross where no node is: the map is not plane",
    ),
    (
        "bend_not_finite",
        |rows| rows.row(EDGE, 3)[GEOM] = line(&[[40.0, 0.0], [f64::INFINITY, 30.0], [40.0, 60.0]]),
        &["P4", "G1"],
        "bend 0 of edge +3 has a coordinate that is not finite, or out of range",
    ),
    (
        "lies_elsewhere",
        |rows| {
            rows.row(EDGE, 1)[NEXT_LEFT] = int(5);
            rows.row(NODE, 13)[1] = int(3);
        },
        &["P2", "P4", "L2", "L3", "B1", "F1"],
        "node 13 lies in face 2 by the lines around it, and its containing_face is 3",
    ),
    (
        "wrong_face",
        |rows| rows.row(NODE, 13)[1] = int(3),
        &["G5"],
        "the inner boundary component at node 13 is listed by face 3, but lies in face 2",
    ),
];

#[test]
fn each_change_breaks_its_rules_and_is_named_by_ids() {
    let mut kinds = BTreeSet::new();
    for (kind, change, rules, sentence) in CASES {
        let audit = changed(*change);
        assert_eq!(broken(&audit), *rules, "{kind}\n{audit}");
        assert!(!audit.is_valid());
        let found = audit.violations().iter().find(|one| one.kind.name() == *kind && one.message.starts_with(sentence));
        assert!(found.is_some(), "{kind}: {sentence}\n{audit}");
        assert!(audit.to_string().contains(sentence));
        kinds.insert(*kind);
    }
    // All kinds of the rules P0 … P4, as listed in the source.
    let source = include_str!("../../src/finding.rs");
    let list = source.split("\nfindings! {").nth(1).and_then(|rest| rest.split("\n}").next()).expect("there is a list");
    for row in list.lines().filter(|row| row.starts_with("    \"P")) {
        let kind = row.split('"').nth(3).expect("a row names its kind");
        assert!(kinds.contains(kind), "no case for {kind}");
    }
}

#[test]
fn places_are_those_of_the_records_and_bends() {
    let audit = changed(|rows| rows.row(EDGE, 3)[GEOM] = line(&[[40.0, 0.0], [-5.0, 30.0], [40.0, 60.0]]));
    let cross = audit.violations().iter().find(|one| one.kind.name() == "segments_cross").expect("they cross");
    assert_eq!(cross.places.as_deref(), Some(&[[0.0, 50.0], [0.0, 0.0], [40.0, 0.0], [-5.0, 30.0]][..]));
    let audit = changed(|rows| rows.row(NODE, 3)[1] = int(2));
    assert_eq!(audit.violations()[0].places.as_deref(), Some(&[[40.0, 60.0]][..]));
}

#[test]
fn rules_that_need_a_broken_one_are_not_checked() {
    let audit = changed(|rows| rows.row(EDGE, 5)[GEOM] = None);
    let unchecked = |id: &str| {
        audit.rules().iter().find(|rule| rule.id == id).and_then(|rule| rule.unchecked).map(|why| why.to_string())
    };
    for id in ["G1", "G2", "G3", "G4", "G5"] {
        assert_eq!(unchecked(id).as_deref(), Some("needs P1, which is broken"));
    }
    let audit = changed(|rows| rows.row(EDGE, 1)[LEFT_FACE] = int(3));
    let p4 = audit.rules().iter().find(|rule| rule.id == "P4").expect("it is listed");
    let why = "not checked on 2 of 36 values: for mbr: the lines around these faces do not close";
    assert_eq!(p4.not_checked().as_deref(), Some(why));
}

/// Changes to links and lines after which the validator skips most rules.
const BROKEN: [Change; 5] = [
    ("node 12 deleted", |rows| rows.0[NODE].retain(|row| row[0] != int(12))),
    ("next_left_edge of edge 14 with the other sign", |rows| {
        let next = &mut rows.row(EDGE, 14)[NEXT_LEFT];
        *next = next.take().map(|id| (-i32::from_be_bytes(id.try_into().unwrap())).to_be_bytes().to_vec());
    }),
    ("left_face of edge 14 names no face", |rows| rows.row(EDGE, 14)[LEFT_FACE] = int(777)),
    ("edge 14 deleted", |rows| rows.0[EDGE].retain(|row| row[0] != int(14))),
    ("edge 14 without line", |rows| rows.row(EDGE, 14)[GEOM] = None),
];

/// Faults in records with valid links.
const APART: &[Change] = &[
    ("mbr_missing", |rows| rows.row(FACE, 3)[1] = None),
    ("mbr_wrong", |rows| {
        rows.row(FACE, 2)[1] = polygon(&[[0.0, 0.0], [0.0, 50.0], [40.0, 50.0], [40.0, 0.0], [0.0, 0.0]]);
    }),
    ("not_finite", |rows| rows.row(NODE, 13)[2] = point(f64::INFINITY, 3.0)),
    ("bend_not_finite", |rows| rows.row(EDGE, 3)[GEOM] = line(&[[40.0, 0.0], [f64::INFINITY, 30.0], [40.0, 60.0]])),
    ("segments_cross", |rows| rows.row(EDGE, 3)[GEOM] = line(&[[40.0, 0.0], [-5.0, 30.0], [40.0, 60.0]])),
    ("bend_at_vertex", |rows| rows.row(EDGE, 3)[GEOM] = line(&[[40.0, 0.0], [0.0, 50.0], [40.0, 60.0]])),
    ("touch", |rows| rows.row(NODE, 13)[2] = point(40.0, 80.0)),
    ("same_place", |rows| rows.row(NODE, 13)[2] = point(40.0, 60.0)),
    ("lies_elsewhere", |rows| rows.row(NODE, 13)[1] = int(3)),
    ("isolated_unclaimed", |rows| rows.row(NODE, 13)[1] = None),
    ("face_changes", |rows| rows.row(EDGE, 1)[LEFT_FACE] = int(3)),
    ("next_shared", |rows| rows.row(EDGE, 1)[NEXT_LEFT] = int(2)),
];

#[test]
fn one_broken_link_hides_no_fault_elsewhere() {
    for (name, break_link) in BROKEN {
        let alone = changed(break_link);
        assert!(!alone.is_valid(), "{name}");
        for (kind, change) in APART {
            let kinds =
                |audit: &TopologyAudit| audit.violations().iter().filter(|one| one.kind.name() == *kind).count();
            let both = changed(|rows| {
                change(rows);
                break_link(rows);
            });
            // If only a line is missing, the validator has already reported the links.
            let is_said =
                *kind == "lies_elsewhere" && both.violations().iter().any(|one| one.kind.name() == "wrong_face");
            assert!(kinds(&both) > kinds(&alone) || is_said, "{kind} beside {name}\n{both}");
        }
    }
}

/// A broken link does not make lines appear to cross.
#[test]
fn a_broken_link_is_no_fault_of_the_lines() {
    for (name, break_link) in BROKEN {
        let audit = changed(break_link);
        let of_lines = audit.rules().iter().filter(|rule| ["P2", "P4", "G1", "G4"].contains(&rule.id));
        assert_eq!(of_lines.map(|rule| rule.violations).sum::<u64>(), 0, "{name}\n{audit}");
    }
}

#[test]
fn the_records_that_are_left_out_are_counted() {
    let not_checked = |audit: &TopologyAudit, id: &str| {
        audit.rules().iter().find(|rule| rule.id == id).and_then(twinedge_diagnosis::RuleLine::not_checked)
    };
    let audit = changed(BROKEN[0].1);
    // Four signed edges leave the node, and four arrive. L1 and L2 do not depend on nodes.
    assert_eq!(
        not_checked(&audit, "L3").as_deref(),
        Some("not checked on 4 of 28 signed edges: needs R1, which is broken")
    );
    assert_eq!(not_checked(&audit, "V2").as_deref(), Some("not checked on 15 of 15 nodes: needs R1, which is broken"));
    for id in ["L1", "L2", "G1", "G4", "P2", "P4"] {
        assert_eq!(not_checked(&audit, id), None, "{id}\n{audit}");
    }
    let audit = changed(BROKEN[4].1);
    assert_eq!(not_checked(&audit, "G4").as_deref(), Some("not checked on 1 of 14 edges: needs P1, which is broken"));
    let shown = audit.to_string();
    assert!(shown.contains("\nG4 disjoint   ok, 13 edges; not checked on 1 of 14 edges: needs P1"), "{shown}");
}

/// One invalid link disables G5. Lines and points still locate isolated nodes.
#[test]
fn isolated_nodes_are_placed_without_links() {
    let outcome = |audit: &TopologyAudit| audit.rules().iter().find(|rule| rule.id == "P2").cloned().expect("listed");
    let messages = |audit: &TopologyAudit| {
        let of_p2 = audit.violations().iter().filter(|one| one.rule == Some("P2"));
        of_p2.map(|one| one.message.clone()).collect::<Vec<_>>()
    };
    let wrong_link = |rows: &mut Rows| rows.row(EDGE, 1)[NEXT_LEFT] = int(5);
    let right = changed(wrong_link);
    let g5 = right.rules().iter().find(|rule| rule.id == "G5").expect("listed");
    assert!(g5.unchecked.is_some());
    assert_eq!((outcome(&right).violations, outcome(&right).unchecked), (0, None));
    // Each isolated node in each face other than its own.
    let rows = Rows::of(TOWN);
    let faces: Vec<_> = rows.0[FACE].iter().map(|row| row[0].clone()).collect();
    let isolated: Vec<_> = rows.0[NODE].iter().filter(|row| row[1].is_some()).cloned().collect();
    assert!(isolated.len() >= 4);
    let number = |bytes: &Option<Vec<u8>>| i32::from_be_bytes(bytes.clone().unwrap().try_into().unwrap());
    for row in &isolated {
        for face in faces.iter().filter(|face| **face != row[1]) {
            let audit = changed(|rows| {
                wrong_link(rows);
                rows.row(NODE, number(&row[0]))[1].clone_from(face);
            });
            let [node, own, named] = [&row[0], &row[1], face].map(number);
            let place = match own {
                0 => format!("does not lie in face {named}"),
                own => format!("lies in face {own}"),
            };
            let message = format!("node {node} {place} by the lines around it, and its containing_face is {named}");
            assert_eq!(messages(&audit), [message]);
        }
    }
    // If the lines around a face do not close, its contents are unknown, so P2 is not checked.
    let unknown = changed(|rows| {
        wrong_link(rows);
        rows.row(EDGE, 1)[LEFT_FACE] = int(3);
    });
    assert_eq!(outcome(&unknown).violations, 0);
    let why = outcome(&unknown).unchecked.expect("the lines around a face do not close").to_string();
    assert!(why.starts_with("in which face "), "{why}");
    assert!(unknown.unchecked_count() > 5);
}

#[test]
fn all_are_counted_and_as_many_kept_as_asked() {
    let mut rows = Rows::of(TOWN);
    for row in &mut rows.0[EDGE] {
        row[ABS_NEXT_LEFT] = None;
    }
    let topology = twinedge_postgis::read(&*rows.bytes(), 3).unwrap();
    let audit = twinedge_postgis::audit(&topology, 3).unwrap();
    assert_eq!((audit.violations().len(), audit.violation_count()), (3, 14));
    assert!(audit.to_string().contains("… and 11 more"));
}

#[test]
#[cfg(feature = "serde")]
fn an_audit_is_one_object() {
    let audit = changed(|rows| rows.row(EDGE, 1)[NEXT_LEFT] = int(-99));
    let value = serde_json::to_value(&audit).unwrap();
    assert_eq!((&value["schema"], &value["valid"]), (&"twinedge-report/1".into(), &false.into()));
    assert_eq!((&value["counts"]["edges"], &value["counts"]["vertices"]), (&14.into(), &value["counts"]["nodes"]));
    assert_eq!(
        value["rules"][0],
        serde_json::json!({
            "id": "P0", "name": "ids", "checked": 38, "unit": "rows", "violations": 0, "unchecked": null
        })
    );
    let dangling = value["violations"].as_array().unwrap().iter().find(|one| one["rule"] == "R1").unwrap();
    assert_eq!(dangling["message"], "next_left_edge of edge 1 is -99, and there is no such edge");
    assert_eq!(dangling["at"], serde_json::json!([[0.0, 0.0], [40.0, 0.0]]));
}
