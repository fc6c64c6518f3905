//! The SQL of findings: the rows that it shows, and the only way to fix them.

use crate::support::{Change, EDGE, FACE, GEOM, LEFT_FACE, NEXT_LEFT, NODE, Rows, START, TOWN, int, line, polygon};
use twinedge_diagnosis::Sql;

/// Returns the statements for the violations of a kind after a change of the town.
fn sql(kind: &str, change: impl FnOnce(&mut Rows)) -> Vec<Sql> {
    let mut rows = Rows::of(TOWN);
    change(&mut rows);
    let audit = rows.audit();
    let of_kind = audit.violations().iter().filter(|one| one.kind.name() == kind);
    let found: Vec<Sql> = of_kind.map(|one| one.sql.clone().expect("each finding has SQL")).collect();
    assert!(!found.is_empty(), "{kind}\n{audit}");
    found
}

/// A kind of finding, a change that causes one, the query of its rows, and the statements that fix it.
type Case = (&'static str, fn(&mut Rows), &'static str, &'static [&'static str]);

const CASES: &[Case] = &[
    (
        "abs_next_differs",
        |rows| rows.row(EDGE, 1)[4] = int(-3),
        "SELECT * FROM edge_data WHERE edge_id IN (1);",
        &["UPDATE edge_data SET abs_next_left_edge = abs(next_left_edge) WHERE edge_id = 1;"],
    ),
    (
        "mbr_missing",
        |rows| rows.row(FACE, 3)[1] = None,
        "SELECT * FROM face WHERE face_id IN (3);",
        &[
            "UPDATE face SET mbr = (SELECT ST_Envelope(ST_Collect(geom)) FROM edge_data WHERE 3 IN (left_face, right_face)) WHERE face_id = 3;",
        ],
    ),
    (
        "universe_has_mbr",
        |rows| rows.row(FACE, 0)[1] = polygon(&[[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]]),
        "SELECT * FROM face WHERE face_id IN (0);",
        &["UPDATE face SET mbr = NULL WHERE face_id = 0;"],
    ),
    (
        "connected_has_containing_face",
        |rows| rows.row(NODE, 3)[1] = int(2),
        "SELECT * FROM node WHERE node_id IN (3);",
        &["UPDATE node SET containing_face = NULL WHERE node_id = 3;"],
    ),
    (
        "isolated_unclaimed",
        |rows| rows.row(NODE, 13)[1] = None,
        "SELECT * FROM node WHERE node_id IN (13);",
        &[
            "UPDATE node SET containing_face = topology.GetFaceContainingPoint(current_schema()::text, geom) WHERE node_id = 13;",
        ],
    ),
    (
        "wrong_face",
        |rows| rows.row(NODE, 13)[1] = int(3),
        "SELECT * FROM face WHERE face_id IN (3); SELECT * FROM node WHERE node_id IN (13);",
        &["UPDATE node SET containing_face = 2 WHERE node_id = 13;"],
    ),
    (
        "dangling",
        |rows| rows.row(EDGE, 1)[NEXT_LEFT] = int(-99),
        "SELECT * FROM edge_data WHERE edge_id IN (1);",
        &["UPDATE edge_data SET next_left_edge = 3, abs_next_left_edge = 3 WHERE edge_id = 1;"],
    ),
    (
        "dangling",
        |rows| rows.row(EDGE, 1)[START] = int(99),
        "SELECT * FROM edge_data WHERE edge_id IN (1);",
        &["UPDATE edge_data SET start_node = 1 WHERE edge_id = 1;"],
    ),
    (
        "dangling",
        |rows| rows.row(EDGE, 1)[LEFT_FACE] = int(99),
        "SELECT * FROM edge_data WHERE edge_id IN (1);",
        &["UPDATE edge_data SET left_face = 2 WHERE edge_id = 1;"],
    ),
    (
        "next_shared",
        |rows| rows.row(EDGE, 1)[NEXT_LEFT] = int(2),
        "SELECT * FROM edge_data WHERE edge_id IN (1, 3);",
        &["UPDATE edge_data SET next_left_edge = 3, abs_next_left_edge = 3 WHERE edge_id = 1;"],
    ),
    (
        "starts_elsewhere",
        |rows| rows.row(EDGE, 5)[START] = int(12),
        "SELECT * FROM edge_data WHERE edge_id IN (5);",
        &["UPDATE edge_data SET start_node = 3 WHERE edge_id = 5;"],
    ),
];

#[test]
fn what_can_be_mended_in_one_way_has_its_sql() {
    for (kind, change, show, mend) in CASES {
        let found = &sql(kind, change)[0];
        assert_eq!((&*found.show, &found.mend), (*show, &mend.iter().map(ToString::to_string).collect()), "{kind}");
    }
}

/// The row of a node or a face is restored once, although several edges need it.
#[test]
fn a_row_that_all_its_edges_ask_for_is_restored() {
    for found in sql("dangling", |rows| rows.0[NODE].retain(|row| row[0] != int(12))) {
        let [mend] = &found.mend[..] else { panic!("{found:?}") };
        assert!(mend.starts_with("INSERT INTO node (node_id, geom) SELECT 12, ST_"), "{mend}");
        assert!(mend.ends_with(" AND NOT EXISTS (SELECT FROM node WHERE node_id = 12);"), "{mend}");
    }
    for found in sql("dangling", |rows| rows.0[FACE].retain(|row| row[0] != int(6))) {
        let insert = "INSERT INTO face (face_id, mbr) SELECT 6, ST_Envelope(ST_Collect(geom)) FROM edge_data \
                      WHERE 6 IN (left_face, right_face) HAVING NOT EXISTS (SELECT FROM face WHERE face_id = 6);";
        assert_eq!(found.mend, [insert]);
    }
}

/// There is no proposal if the row may be the invalid one, or its neighbour.
#[test]
fn what_takes_a_choice_has_no_mend() {
    let cases: &[Change] = &[
        // The line or the node was moved.
        ("starts_elsewhere", |rows| rows.row(EDGE, 5)[GEOM] = line(&[[41.0, 60.0], [40.0, 100.0]])),
        // The edge may be restored, or the faces on its two sides merged.
        ("dangling", |rows| rows.0[EDGE].retain(|row| row[0] != int(5))),
        ("segments_cross", |rows| rows.row(EDGE, 3)[GEOM] = line(&[[40.0, 0.0], [-5.0, 30.0], [40.0, 60.0]])),
        // The box of a face whose line crosses others.
        ("mbr_wrong", |rows| rows.row(EDGE, 3)[GEOM] = line(&[[40.0, 0.0], [-5.0, 30.0], [40.0, 60.0]])),
        ("face_without_edges", |rows| rows.0[FACE].push(vec![int(99), None])),
        // Two of three edges name another face: the right one of the two faces is unknown.
        ("face_changes", |rows| {
            for (edge, column) in [(13, 8), (14, 8)] {
                assert_eq!(rows.row(EDGE, edge)[column], int(0));
                rows.row(EDGE, edge)[column] = int(6);
            }
        }),
    ];
    for (kind, change) in cases {
        for found in sql(kind, change) {
            assert!(found.mend.is_empty() && found.show.starts_with("SELECT * FROM "), "{kind}: {found:?}");
        }
    }
}

/// Nonpositive ids of edges are shown unchanged.
#[test]
fn queries_name_ids_as_the_table_has_them() {
    assert_eq!(
        sql("edge_id_not_positive", |rows| rows.row(EDGE, 10)[0] = int(-10))[0].show,
        "SELECT * FROM edge_data WHERE edge_id = -10;"
    );
    assert_eq!(
        sql("id_missing", |rows| rows.row(NODE, 13)[0] = None)[0].show,
        "SELECT * FROM node WHERE node_id IS NULL;"
    );
}

#[test]
fn nothing_speaks_of_other_structures_than_topologies() {
    for (kind, change, ..) in CASES {
        let mut rows = Rows::of(TOWN);
        change(&mut rows);
        for one in rows.audit().violations() {
            let said = [&one.message, one.cause.expect("it has a cause"), one.remedy.expect("and a remedy")].join(" ");
            for word in ["vertex", "vertices", "half-edge", "generational", "View::", "geometry::"] {
                assert!(!said.contains(word), "{kind}: {said}");
            }
        }
    }
}
