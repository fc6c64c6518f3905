//! The three tables of the textbooks: writing, reading, and errors in a text.
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

use quickcheck::QuickCheck;
use twinedge::dcel::Dcel;
use twinedge::program::{Program, Runner};
use twinedge::validate::{Collect, Expectation, Record, Rule, Table, View, validate};
use twinedge_geometry::Point;
use twinedge_map::{PlanarMap, validate_embedding};
use twinedge_report::textbook::{TablesError, Textbook};

const DANGLING_EDGE: &str = include_str!("../../../../examples/tables/dangling_edge.txt");
const FIVE_FACES: &str = include_str!("../../../../examples/tables/five_faces.txt");

fn read(text: &str) -> Textbook {
    text.parse().unwrap()
}

fn without_comments(text: &str) -> String {
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with('#')).collect();
    format!("{}\n", lines.join("\n").trim())
}

#[test]
fn the_golden_tables_are_read_and_written_as_they_are() {
    for (text, counts) in [(DANGLING_EDGE, (4, 4, 2)), (FIVE_FACES, (6, 9, 5))] {
        let tables = read(text);
        let report = validate(&tables, &Expectation::plane(), Collect::All);
        let found = report.figures().unwrap();
        assert_eq!((found.vertices, found.edges, found.faces), counts);
        assert_eq!(tables.to_string(), without_comments(text));
        assert_eq!(read(&tables.to_string()), tables);
        assert!(!tables.has_coordinates());
    }
}

#[test]
fn records_have_the_names_of_the_book() {
    let tables = read(FIVE_FACES);
    assert_eq!(tables.name(Record::Vertex(3)), Some("V4"));
    assert_eq!(tables.name(Record::HalfEdge(17)), Some("e9,2"));
    assert_eq!(tables.name(Record::Face(4)), Some("f5"));
    assert_eq!((tables.name(Record::Face(5)), tables.name(Record::Boundary(0))), (None, None));
    assert_eq!(tables.table().half_edges.len(), 18);
    assert_eq!((tables.next(0), tables.outer_half_edge(4), tables.inner_count(4)), (Some(2), None, 1));
}

/// Bars, commas, dashes, capitals and order do not matter.
#[test]
fn tables_are_read_however_they_are_set() {
    let plain = "
        v1  e1,1
        v2  e1,2
        v3  nil
        f1  nil  e1,1 v3
        e1,1  v1  e1,2  f1  e1,2  e1,2
        e1,2  v2  e1,1  f1  e1,1  e1,1";
    let set = "
        | Half-edge | Origin | Twin | IncidentFace | Next | Prev |
        |-----------|--------|------|--------------|------|------|
        | e1,1 | V1 | E1,2 | f1 | e1,2 | e1,2 |
        | e1,2 | v2 | e1,1 | F1 | e1,1 | e1,1 |
        Face OuterComponent InnerComponents
        f1 - e1,1, v3
        Vertex IncidentEdge   # a comment
        v1 e1,1
        v2 e1,2
        v3 NIL";
    assert_eq!(read(plain), read(set));
    assert!(validate(&read(plain), &Expectation::plane(), Collect::All).is_valid());
}

#[test]
fn a_wrong_table_is_read_and_judged() {
    // The twin of e2,2 is changed to e3,1.
    let text = FIVE_FACES.replace("e2,2       V2      e2,1", "e2,2       V2      e3,1");
    let report = validate(&read(&text), &Expectation::plane(), Collect::All);
    assert_eq!(report.first().unwrap().rule(), Rule::L1);
    // A link to a missing record.
    let text = FIVE_FACES.replace("V1      e2,1", "V1      ?");
    let report = validate(&read(&text), &Expectation::plane(), Collect::All);
    assert_eq!(report.first().unwrap().rule(), Rule::R1);
    assert_eq!(read(&read(&text).to_string()), read(&text));
}

#[test]
fn coordinates_are_checked_with_the_links() {
    let mut map = PlanarMap::new();
    map.insert_ring([[0.0, 0.0], [4.0, 0.5], [1.0, 1e100]]).unwrap();
    map.insert_point([9.0, -0.1]).unwrap();
    let tables = Textbook::of_embedding(&map);
    assert!(tables.has_coordinates());
    assert_eq!((tables.name(Record::Vertex(0)), tables.name(Record::HalfEdge(5))), (Some("v1"), Some("e3,2")));
    assert_eq!(tables.name(Record::Face(1)), Some("f2"));
    let back = read(&tables.to_string());
    assert_eq!(back, tables);
    assert!(validate_embedding(&back, &Expectation::plane(), Collect::All).is_valid());
    // Mirrored: the face is clockwise.
    let turned = tables.to_string().replace("(4, 0.5)", "(-4, 0.5)");
    let report = validate_embedding(&read(&turned), &Expectation::plane(), Collect::All);
    assert!(report.violations().iter().any(|violation| violation.rule() == Rule::G3));
    let unknown = tables.to_string().replace("(4, 0.5)", "?");
    assert!(!read(&unknown).has_coordinates());
    let report = validate_embedding(&read(&unknown), &Expectation::plane(), Collect::All);
    assert_eq!(report.first().unwrap().rule(), Rule::G1);
}

/// The tables of any program's result are valid, and are read back.
fn maps_come_back(program: Program) -> bool {
    let mut runner = Runner::new(Dcel::new());
    runner.run(&program);
    let dcel = runner.into_subject();
    let tables = Textbook::of(&dcel, |_| None);
    let places = Textbook::of(&dcel, |v| Some(Point::new(v as f64 / 3.0, -1e-7 * v as f64)));
    validate(&tables, &Expectation::plane(), Collect::All).is_valid()
        && read(&tables.to_string()) == tables
        && read(&places.to_string()) == places
        && tables.vertex_slots() == dcel.vertex_count()
        && tables.half_edge_slots() == dcel.half_edge_count()
}

#[test]
fn random_maps() {
    QuickCheck::new().tests(300).quickcheck(maps_come_back as fn(Program) -> bool);
}

/// Half-edges whose twins are not adjacent are numbered in order.
#[test]
fn half_edges_of_any_numbering_have_names() {
    let mut table: Table = read(DANGLING_EDGE).table().clone();
    // e1,2 and e2,1 change places.
    let swap = |link: &mut Option<usize>| {
        *link = link.map(|h| match h {
            1 => 2,
            2 => 1,
            h => h,
        });
    };
    table.half_edges.swap(1, 2);
    for row in table.half_edges.iter_mut().flatten() {
        [&mut row.twin, &mut row.next, &mut row.prev].into_iter().for_each(swap);
    }
    table.vertices.iter_mut().flatten().for_each(|row| swap(&mut row.leaving));
    let tables = Textbook::of(&table, |_| None);
    let names: Vec<&str> = (0..8).filter_map(|h| tables.name(Record::HalfEdge(h))).collect();
    assert_eq!(names, ["e1,1", "e2,1", "e1,2", "e2,2", "e3,1", "e3,2", "e4,1", "e4,2"]);
    assert!(validate(&tables, &Expectation::plane(), Collect::All).is_valid());
}

#[test]
fn what_is_wrong_with_a_text_is_said_with_its_line() {
    let error = |text: &str| text.parse::<Textbook>().unwrap_err();
    assert_eq!(error("v1 nil\nx2 nil"), TablesError::UnknownRow { line: 2, word: "x2".into() });
    assert!(matches!(error("v1"), TablesError::Columns { line: 1, found: 0, .. }));
    assert!(matches!(error("f1"), TablesError::Columns { line: 1, found: 0, .. }));
    assert!(matches!(error("\ne1,1 v1 e1,2 f1 e1,2"), TablesError::Columns { line: 2, found: 4, .. }));
    assert_eq!(error("v1 nil\n\nV1 nil"), TablesError::Repeated { line: 3, name: "V1".into() });
    let unknown = TablesError::UnknownName { line: 1, kind: "half-edge", name: "e7,1".into() };
    assert_eq!(error("v1 e7,1"), unknown);
    assert_eq!(unknown.to_string(), "line 1: there is no half-edge `e7,1`");
    assert!(matches!(error("f1 nil v9"), TablesError::UnknownName { line: 1, kind: "vertex", .. }));
    for text in ["(1)", "(1, x)", "(1, 2, 3)", "1,2"] {
        assert_eq!(error(&format!("v1 {text} nil")), TablesError::Coordinates { line: 1, text: text.into() });
    }
}
