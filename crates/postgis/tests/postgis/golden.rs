//! Topologies written by PostGIS are read unchanged, and are valid.

use crate::support::{DECIMAL, EDGE, END, GEOM, LARGE_IDS, NODE, OLD_TOWN, Row, Rows, START, TOWN, int, line};
use twinedge::validate::{Record, View};
use twinedge_map::Embedding;
use twinedge_postgis::{audit, is_copy, read};

#[test]
fn what_postgis_wrote_is_valid() {
    for (bytes, nodes, edges, faces, repeated) in
        [(TOWN, 16, 14, 8, 0), (DECIMAL, 2, 3, 3, 2), (LARGE_IDS, 4, 5, 4, 0), (OLD_TOWN, 3, 4, 3, 0)]
    {
        assert!(is_copy(bytes));
        let audit = audit(&read(bytes, 100).unwrap(), 100).unwrap();
        assert!(audit.is_valid(), "{audit}");
        let counts = audit.counts();
        assert_eq!((counts.edges, counts.faces, counts.repeated_points), (edges, faces, repeated), "{audit}");
        assert!(counts.nodes >= nodes, "{audit}");
        assert_eq!(Rows::of(bytes).bytes(), bytes);
    }
}

#[test]
fn half_edges_are_edges_with_a_sign() {
    let town = read(TOWN, 100).unwrap();
    // Edge 1 of the table, from (0, 0) to (40, 0): its next edges are 3 and -6, its faces 2 and 0.
    let h = (0..town.half_edge_slots()).find(|h| town.name(Record::HalfEdge(*h)) == "+1").unwrap();
    let name = |link: Option<usize>, of: fn(usize) -> Record| town.name(of(link.unwrap()));
    assert_eq!(name(town.next(h), Record::HalfEdge), "+3");
    assert_eq!(name(town.next(h ^ 1), Record::HalfEdge), "-6");
    assert_eq!([h, h ^ 1].map(|h| name(town.origin(h), Record::Vertex)), ["1", "2"]);
    assert_eq!([h, h ^ 1].map(|h| name(town.face(h), Record::Face)), ["2", "0"]);
    // Edge 2 has two bends.
    let h = (0..town.half_edge_slots()).find(|h| town.name(Record::HalfEdge(*h)) == "-2").unwrap();
    assert_eq!([0, 1].map(|i| <[f64; 2]>::from(town.bend(h, i))), [[100.0, 100.0], [100.0, 0.0]]);
    assert_eq!([0, 1].map(|i| town.bend(h ^ 1, 1 - i)), [0, 1].map(|i| town.bend(h, i)));
}

/// The town with geometries in the other byte order, and with ISO's numbers for a third dimension.
#[test]
fn geometries_may_be_written_otherwise() {
    let mut rows = Rows::of(TOWN);
    for row in &mut rows.0[EDGE] {
        let Some(bytes) = &mut row[GEOM] else { panic!("edges have lines") };
        let mut other = vec![0];
        other.extend(1002_u32.to_be_bytes());
        other.extend(bytes[5..9].iter().rev());
        for point in bytes[9..].chunks(16) {
            other.extend(point[..8].iter().rev().chain(point[8..].iter().rev()));
            other.extend(7.5_f64.to_be_bytes());
        }
        *bytes = other;
    }
    let audit = rows.audit();
    assert!(audit.is_valid(), "{audit}");
    assert_eq!(audit.counts().bends, 16);
}

#[test]
fn repeated_points_are_no_bends() {
    let mut rows = Rows::of(TOWN);
    let repeated = [[40.0, 60.0], [40.0, 60.0], [40.0, 80.0], [40.0, 80.0], [40.0, 100.0], [40.0, 100.0]];
    rows.row(EDGE, 5)[GEOM] = line(&repeated);
    let audit = rows.audit();
    assert!(audit.is_valid(), "{audit}");
    assert_eq!((audit.counts().bends, audit.counts().repeated_points), (17, 3));
}

/// Rows come in the database's order.
#[test]
fn the_order_of_rows_does_not_matter() {
    let mut rows = Rows::of(TOWN);
    for table in &mut rows.0 {
        table.reverse();
        table.rotate_left(3);
    }
    let audit = rows.audit();
    assert!(audit.is_valid(), "{audit}");
}

#[test]
fn a_node_may_lie_in_the_universe() {
    let rows = Rows::of(TOWN);
    assert!(rows.0[NODE].iter().any(|row| row[1] == Some(vec![0; 4])));
}

/// Renumbers the nodes, keeping the order of the rows.
fn numbered(rows: &mut Rows, number: impl Fn(i32) -> i32) {
    let change = |row: &mut Row, column: usize| {
        let id = i32::from_be_bytes(row[column].as_deref().unwrap().try_into().unwrap());
        row[column] = int(number(id));
    };
    rows.0[NODE].iter_mut().for_each(|row| change(row, 0));
    for row in &mut rows.0[EDGE] {
        change(row, START);
        change(row, END);
    }
}

#[test]
fn ids_are_found_however_far_apart_they_are() {
    let far = |id: i32| if id % 2 == 0 { i32::MAX - id } else { i32::MIN + id };
    let numberings: [fn(i32) -> i32; 5] = [|id| id + 7, |id| -id, |id| 2 * id, |id| 1_000_003 * id, far];
    let counts = *Rows::of(TOWN).audit().counts();
    for numbering in numberings {
        let mut rows = Rows::of(TOWN);
        numbered(&mut rows, numbering);
        let audit = rows.audit();
        assert!(audit.is_valid(), "{audit}");
        assert_eq!(*audit.counts(), counts);
        // An edge at a node that no row has.
        for lost in [numbering(3) + 1, numbering(3) - 1, 100_000, i32::MIN, i32::MAX, 0] {
            if rows.0[NODE].iter().all(|row| row[0] != int(lost)) {
                let mut rows = rows.clone();
                rows.row(EDGE, 5)[START] = int(lost);
                let audit = rows.audit();
                assert!(audit.violations().iter().any(|one| one.rule == Some("R1")), "{lost}\n{audit}");
            }
        }
    }
}

#[test]
fn the_first_row_with_an_id_has_it() {
    for numbering in [|id: i32| id, |id: i32| 1_000_003 * id] {
        let mut rows = Rows::of(TOWN);
        numbered(&mut rows, numbering);
        let second = rows.0[NODE][1][0].clone();
        rows.0[NODE].extend([2, 3].map(|at| {
            let mut row = Rows::of(TOWN).0[NODE][at].clone();
            row[0].clone_from(&second);
            row
        }));
        let audit = rows.audit();
        let rules: Vec<_> = audit.violations().iter().map(|one| one.rule).collect();
        assert_eq!(rules, [Some("P0"), Some("P0")], "{audit}");
    }
}
