//! Laws of the validator: it returns, whatever the table, and agrees with the reference validator.

use twinedge::program::choose::Choose;
use twinedge::validate::{
    BoundaryPlace, BoundaryRow, Collect, Expectation, FaceRow, HalfEdgeRow, Link, Part, Parts, Rule, Start, Table,
    VertexRow, reference, validate,
};

/// The validator under test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Judge {
    /// The validator of the library.
    Fast,
    /// The validator with a planted fault: it never finds this rule broken.
    BlindTo(Rule),
}

impl Judge {
    /// Returns the first broken rule.
    ///
    /// # Panics
    /// If the validator calls a structure valid and finds something, or finds nothing and does not call it so.
    #[must_use]
    pub fn first_broken_rule(self, table: &Table, expectation: Expectation) -> Option<Rule> {
        let report = validate(table, &expectation, Collect::AtMost(1));
        let first = report.outcomes().find(|(_, outcome)| outcome.violations > 0).map(|(rule, _)| rule);
        assert!(report.is_valid() == first.is_none(), "the validators differ: this one is of two minds");
        first.filter(|rule| self != Self::BlindTo(*rule))
    }
}

/// The tables to choose from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tables {
    /// `origin`, `twin`, `next` and `prev` of this many half-edges, and `leaving` of this many vertices.
    Links {
        /// Half-edges.
        half_edges: usize,
        /// Vertices.
        vertices: usize,
    },
    /// One vertex without half-edges, one boundary component, and one face that lists at most two inner ones.
    Vertex,
    /// One loop, two boundary components, and two faces that each list at most one inner one. The links of the
    /// loop and of the boundary components to it are valid; the faces, and all links to and from them, are free.
    Loop,
}

/// Nil, each index, and the one past the end.
fn choose_link(n: usize, source: &mut impl Choose) -> Link {
    source.choose(n + 2).checked_sub(1)
}

fn choose_start(half_edges: usize, vertices: usize, source: &mut impl Choose) -> Option<Start> {
    let k = source.choose(half_edges + vertices + 3).checked_sub(1)?;
    Some(k.checked_sub(half_edges + 1).map_or(Start::HalfEdge(k), Start::Vertex))
}

fn choose_place(longest: usize, source: &mut impl Choose) -> Option<BoundaryPlace> {
    let k = source.choose(longest + 3).checked_sub(1)?;
    Some(k.checked_sub(1).map_or(BoundaryPlace::Outer, BoundaryPlace::Inner))
}

fn choose_face_row(boundaries: usize, longest: usize, source: &mut impl Choose) -> FaceRow {
    let outer = choose_link(boundaries, source);
    let inner = (0..source.choose(longest + 1)).map(|_| choose_link(boundaries, source)).collect();
    FaceRow { outer, inner, ..FaceRow::default() }
}

fn choose_table(tables: Tables, source: &mut impl Choose) -> (Table, Expectation) {
    let mut table = Table::default();
    match tables {
        Tables::Links { half_edges, vertices } => {
            for _ in 0..half_edges {
                table.half_edges.push(Some(HalfEdgeRow {
                    origin: choose_link(vertices, source),
                    twin: choose_link(half_edges, source),
                    next: choose_link(half_edges, source),
                    prev: choose_link(half_edges, source),
                    ..HalfEdgeRow::default()
                }));
            }
            for _ in 0..vertices {
                let leaving = choose_link(half_edges, source);
                table.vertices.push(Some(VertexRow { leaving, isolated: None }));
            }
            table.parts = Parts::ALL.without(Part::Faces);
            (table, Expectation::plane())
        }
        Tables::Vertex => {
            let (leaving, isolated) = (choose_link(0, source), choose_link(1, source));
            table.vertices.push(Some(VertexRow { leaving, isolated }));
            table.boundaries.push(Some(BoundaryRow {
                face: choose_link(1, source),
                start: choose_start(0, 1, source),
                place: choose_place(1, source),
            }));
            table.faces.push(Some(choose_face_row(1, 2, source)));
            (table, Expectation::plane())
        }
        Tables::Loop => {
            let row = |h: usize, boundary| HalfEdgeRow {
                origin: Some(0),
                twin: Some(h ^ 1),
                next: Some(h),
                prev: Some(h),
                boundary,
                face: None,
            };
            table.half_edges = (0..2).map(|h| Some(row(h, choose_link(2, source)))).collect();
            table.vertices.push(Some(VertexRow { leaving: Some(0), isolated: None }));
            for b in 0..2 {
                table.boundaries.push(Some(BoundaryRow {
                    face: choose_link(2, source),
                    start: Some(Start::HalfEdge(b)),
                    place: Some(if b == 0 { BoundaryPlace::Outer } else { BoundaryPlace::Inner(0) }),
                }));
            }
            table.faces = (0..2).map(|_| Some(choose_face_row(2, 1, source))).collect();
            (table, Expectation::plane())
        }
    }
}

/// Checks that a validator returns, and finds the same first broken rule as the reference validator.
///
/// The case is relevant if the table is valid or nearly so: if R1 holds.
///
/// # Panics
/// If the two differ.
pub fn agrees_with_reference(judge: Judge, tables: Tables, source: &mut impl Choose) -> bool {
    let (table, expectation) = choose_table(tables, source);
    let (here, there) =
        (judge.first_broken_rule(&table, expectation), reference::first_broken_rule(&table, &expectation));
    assert!(here == there, "the validators differ: {here:?} here, {there:?} by the reference, on {table:?}");
    there != Some(Rule::R1)
}
