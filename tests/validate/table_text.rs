//! Tables as lines of text: written tables can be read, and other texts are refused at the right position.

use crate::support::nested::{nested, nested_textbook};
use quickcheck::{Arbitrary, Gen, quickcheck};
use twinedge::validate::{
    BoundaryPlace, BoundaryRow, FaceRow, HalfEdgeRow, Link, ParseTableError, Part, Parts, Start, Table, VertexRow,
};

/// Any table: vacant rows, dangling links, lists of any length.
#[derive(Clone, Debug)]
struct AnyTable(Table);

fn link(g: &mut Gen) -> Link {
    *g.choose(&[None, Some(0), Some(1), Some(2), Some(usize::MAX)]).unwrap()
}

fn start(g: &mut Gen) -> Option<Start> {
    let index = link(g)?;
    Some(if bool::arbitrary(g) { Start::HalfEdge(index) } else { Start::Vertex(index) })
}

fn list<T>(g: &mut Gen, entry: fn(&mut Gen) -> T) -> Vec<T> {
    (0..u8::arbitrary(g) % 4).map(|_| entry(g)).collect()
}

fn rows<T>(g: &mut Gen, row: fn(&mut Gen) -> T) -> Vec<Option<T>> {
    (0..u8::arbitrary(g) % 4).map(|_| (u8::arbitrary(g) % 4 > 0).then(|| row(g))).collect()
}

impl Arbitrary for AnyTable {
    fn arbitrary(g: &mut Gen) -> Self {
        let with_faces_of_half_edges = bool::arbitrary(g);
        let mut table = Table {
            parts: Part::ALL.into_iter().filter(|_| bool::arbitrary(g)).collect(),
            vertices: rows(g, |g| VertexRow { leaving: link(g), isolated: link(g) }),
            half_edges: rows(g, |g| HalfEdgeRow {
                origin: link(g),
                twin: link(g),
                next: link(g),
                prev: link(g),
                boundary: link(g),
                face: link(g),
            }),
            boundaries: rows(g, |g| BoundaryRow {
                face: link(g),
                start: start(g),
                place: link(g).map(|i| if i == 0 { BoundaryPlace::Outer } else { BoundaryPlace::Inner(i) }),
            }),
            faces: rows(g, |g| FaceRow {
                outer: link(g),
                inner: list(g, link),
                outer_half_edge: link(g),
                inner_starts: list(g, start),
            }),
        };
        if !with_faces_of_half_edges {
            table.half_edges.iter_mut().flatten().for_each(|row| row.face = None);
        }
        Self(table)
    }
}

quickcheck! {
    fn any_table_is_read_as_it_was_written(any: AnyTable) -> bool {
        let text = any.0.to_string();
        !text.contains('\n') && text.parse() == Ok(any.0)
    }

    fn any_prefix_of_a_text_is_refused_or_a_table(any: AnyTable, length: usize) -> bool {
        let text = any.0.to_string();
        let prefix = &text[..length % (text.len() + 1)];
        match prefix.parse::<Table>() {
            Ok(table) => table.to_string() == prefix.trim_end(),
            Err(error) => error.position() <= prefix.len(),
        }
    }
}

#[test]
fn a_table_is_a_section_for_each_kind_of_record_and_each_column_that_not_all_tables_have() {
    let vacant = Table {
        vertices: vec![None, Some(VertexRow::default())],
        half_edges: vec![None, Some(HalfEdgeRow { face: Some(1), ..HalfEdgeRow::default() })],
        boundaries: vec![None],
        faces: vec![None, Some(FaceRow { outer_half_edge: Some(3), ..FaceRow::default() })],
        ..Table::default()
    };
    let textbook = Table { parts: Parts::ALL, ..nested_textbook() };
    for (table, text) in [
        (Table::default(), "V 0 H 0 B 0 F 0"),
        (vacant, "V 2 x - - H 2 x - - - - - B 1 x F 2 x - 0 HF 2 x 1 FH 2 x 3 0"),
        (
            nested(),
            "V 7 0 - 1 - 3 - 6 - 7 - 9 - - 3 H 12 0 1 2 4 1 1 0 5 3 0 1 3 4 0 1 2 2 1 5 0 2 5 0 2 1 0 4 3 1 0 \
             3 7 8 10 4 4 6 11 9 2 4 9 10 6 4 5 8 7 11 2 5 11 6 8 4 3 10 9 7 2 \
             B 5 0 h1 i0 1 h0 o 1 h7 i0 1 v6 i1 2 h6 o F 3 - 1 0 1 2 2 3 4 0",
        ),
        (
            textbook,
            "V 7 0 - 1 - 3 - 6 - 7 - 9 - - - H 12 0 1 2 4 - 1 0 5 3 - 1 3 4 0 - 2 2 1 5 - 2 5 0 2 - 0 4 3 1 - \
             3 7 8 10 - 4 6 11 9 - 4 9 10 6 - 5 8 7 11 - 5 11 6 8 - 3 10 9 7 - \
             B 0 F 3 - 0 - 0 - 0 HF 12 1 0 1 0 1 0 2 1 2 1 2 1 FH 3 - 1 h1 0 2 h7 v6 6 0",
        ),
    ] {
        assert_eq!(table.to_string(), text);
        assert_eq!(text.parse(), Ok(table));
    }
}

/// A part implies its dependencies; with all parts, the section is omitted.
#[test]
fn the_parts_that_are_stored_come_first() {
    let parsed = |text: &str| text.parse::<Table>().unwrap();
    let table = Table { parts: Parts::NONE.with(Part::Places), ..Table::default() };
    let text = "P 3 faces boundary_components places V 0 H 0 B 0 F 0";
    assert_eq!(table.to_string(), text);
    assert_eq!([parsed(text), parsed("P 1 places V 0 H 0 B 0 F 0")], [table.clone(), table]);
    assert_eq!(parsed("P 0 V 0 H 0 B 0 F 0"), Table { parts: Parts::NONE, ..Table::default() });
    assert_eq!(parsed("P 5 prev leaving places places unbounded_face V 0 H 0 B 0 F 0"), Table::default());
}

#[test]
fn white_space_of_any_kind_separates() {
    assert_eq!("\n V\t0  H 0\nB 0\r\nF 0 \n".parse(), Ok(Table::default()));
}

fn refused(text: &str) -> ParseTableError {
    text.parse::<Table>().unwrap_err()
}

#[test]
fn a_text_that_ends_early_is_refused_at_its_end() {
    for text in
        ["", "P", "P 2 prev", "P 0", "V", "V 1", "V 1 -", "V 0 H 0 B 0", "V 0 H 0 B 0 F 1 - 2 0", "V 0 H 0 B 0 F 0 HF"]
    {
        assert!(
            matches!(refused(text), ParseTableError::UnexpectedEnd { position, .. } if position == text.len()),
            "{text}"
        );
    }
}

#[test]
fn a_token_that_is_not_expected_is_refused_where_it_stands() {
    for (text, at) in [
        ("W 0", 0),
        ("P V 0", 2),
        ("P 1 next V 0", 4),
        ("P 2 prev V 0", 9),
        ("V -", 2),
        ("V 1 ? -", 4),
        ("V 1 +1 -", 4),
        ("V 0 F 0", 4),
        ("V 0 H 0 B 1 - 0 -", 14),
        ("V 0 H 0 B 1 - h -", 14),
        ("V 0 H 0 B 1 - - u", 16),
        ("V 0 H 0 B 1 - - i", 16),
        ("V 0 H 0 B 0 F 1 - 1 h0", 20),
        ("V 0 H 0 B 0 F 0 V", 16),
        ("V 0 H 0 B 0 F 0 FH 0 HF 0", 21),
        ("V 0 H 1 x B 0 F 0 HF 1 0", 23),
    ] {
        let error = refused(text);
        assert!(matches!(error, ParseTableError::UnexpectedToken { .. }), "{text}: {error}");
        assert_eq!(error.position(), at, "{text}: {error}");
    }
}

#[test]
fn an_error_says_what_is_wrong_and_where() {
    let too_large = ParseTableError::NumberTooLarge { position: 4 };
    assert_eq!(refused("V 1 99999999999999999999 -"), too_large);
    for (text, told) in [
        ("hello", "the section of the vertices (`V`) is expected at byte 0"),
        ("V 0 H 0", "the text ends at byte 7, where the section of the boundary components (`B`) is expected"),
        ("V 1 99999999999999999999 -", "the number at byte 4 is too large"),
    ] {
        assert_eq!(refused(text).to_string(), told);
    }
    for (text, position, expected, found) in
        [("V 0 H 0 B 0 F 0 HF 1 0", 19, 0, 1), ("V 0 H 0 B 0 F 1 - 0 FH 2 - 0 - 0", 23, 1, 2)]
    {
        assert_eq!(refused(text), ParseTableError::RowCount { position, expected, found });
    }
    // A text may claim any number of rows, but missing rows take no memory.
    let text = format!("V {} - -", usize::MAX);
    assert!(matches!(refused(&text), ParseTableError::UnexpectedEnd { .. }));
}
