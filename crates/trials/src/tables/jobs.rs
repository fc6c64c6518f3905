//! The tables that are judged: the free cells, their values, and the number of valid tables.

use super::formulas;
use crate::enumerate::{Cell, TableCells, Value, pairings};
use crate::forms::Form;
use twinedge::validate::{
    BoundaryPlace, BoundaryRow, Expectation, FaceRow, HalfEdgeRow, Part, Parts, Start, Table, VertexRow,
};

/// All assignments of values to some cells of a table. The others keep their values.
#[derive(Clone, Debug)]
pub(super) struct Assignments {
    pub(super) table: Table,
    pub(super) cells: Vec<(Cell, Vec<Value>)>,
}

/// Tables with the same free cells, and the number of valid ones.
#[derive(Clone, Debug)]
pub(super) struct Job {
    pub(super) name: &'static str,
    pub(super) half_edges: usize,
    /// The smallest bound with which it is done: above its number of half-edges for very many tables.
    pub(super) from: usize,
    pub(super) expectation: Expectation,
    /// True if origins are not set but follow from twin and next.
    pub(super) derive_origins: bool,
    pub(super) assignments: Vec<Assignments>,
    pub(super) right: u128,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum To {
    Live,
    /// These and nil.
    OrNil,
    /// These, and the slot past the end.
    OrPastTheEnd,
}

impl Assignments {
    /// Returns all assignments of the wanted cells among the relevant ones.
    fn new(table: Table, form: Form, wanted: impl Fn(Cell) -> Option<To>) -> Self {
        let table = Table { parts: form.parts, ..table };
        let cells = table.cells(form.parts);
        let cells = cells.into_iter().filter_map(|cell| Some((cell, values(&table, cell, wanted(cell)?)))).collect();
        Self { table, cells }
    }

    pub(super) fn len(&self) -> u128 {
        self.cells.iter().map(|(_, values)| values.len() as u128).product()
    }

    /// Splits it into pieces: one for each value of the first two cells.
    pub(super) fn split(&self) -> Vec<Self> {
        let mut pieces = vec![self.clone()];
        for position in 0..self.cells.len().min(2) {
            let one_value = |piece: &Self| {
                let with = |value: &Value| {
                    let mut piece = piece.clone();
                    piece.cells[position].1 = vec![*value];
                    piece
                };
                piece.cells[position].1.iter().map(with).collect::<Vec<_>>()
            };
            pieces = pieces.iter().flat_map(one_value).collect();
        }
        pieces
    }
}

fn values(table: &Table, cell: Cell, to: To) -> Vec<Value> {
    let all = table.values(cell);
    // Nil, the slots, one past the end and the largest number.
    let slots = all.len().saturating_sub(3);
    let wanted = |value: &Value| match *value {
        Value::Link(None) | Value::Start(None) | Value::BoundaryPlace(None) => to >= To::OrNil,
        Value::Link(Some(i)) => i < slots || i == slots && to == To::OrPastTheEnd,
        Value::Start(Some(Start::HalfEdge(h))) => h < table.half_edges.len(),
        Value::Start(Some(Start::Vertex(v))) => v < table.vertices.len(),
        Value::BoundaryPlace(Some(BoundaryPlace::Outer)) => true,
        Value::BoundaryPlace(Some(BoundaryPlace::Inner(i))) => i < usize::MAX,
    };
    all.into_iter().filter(wanted).collect()
}

/// Returns a table of this size, all nil, with these numbers of inner boundary components in the lists of the faces.
fn blank(vertices: usize, half_edges: usize, boundaries: usize, lists: &[usize]) -> Table {
    let face = |listed: &usize| {
        let (inner, inner_starts) = if boundaries > 0 { (*listed, 0) } else { (0, *listed) };
        FaceRow { inner: vec![None; inner], inner_starts: vec![None; inner_starts], ..FaceRow::default() }
    };
    Table {
        vertices: vec![Some(VertexRow::default()); vertices],
        half_edges: vec![Some(HalfEdgeRow::default()); half_edges],
        boundaries: vec![Some(BoundaryRow::default()); boundaries],
        faces: lists.iter().map(|listed| Some(face(listed))).collect(),
        ..Table::default()
    }
}

fn with_twins(twins: &[usize]) -> Table {
    let mut table = blank(0, twins.len(), 0, &[]);
    for (h, twin) in twins.iter().enumerate() {
        table.set(Cell::Twin(h), Value::Link(Some(*twin)));
    }
    table
}

const MAP: Form = Form::new(Expectation::surface(), Parts::ALL.without(Part::Faces));
const BARE: Form = Form::new(Expectation::surface(), Parts::NONE);
const OPEN: Expectation = Expectation::surface().open();
const PLANE: Form = Form::new(Expectation::plane(), Parts::NONE);
const TEXTBOOK_LEAVING: Form = Form::new(Expectation::plane(), Parts::ALL.without(Part::BoundaryComponents));
const TEXTBOOK: Form = without(TEXTBOOK_LEAVING, Part::Leaving);
const RECORDS: Form = Form::new(Expectation::plane(), Parts::ALL);

/// Returns the form of a structure that does not store this part either.
const fn without(form: Form, part: Part) -> Form {
    Form::new(form.expectation, form.parts.without(part))
}

const fn is_of_the_map(cell: Cell) -> bool {
    matches!(cell, Cell::Origin(_) | Cell::Twin(_) | Cell::Next(_) | Cell::Prev(_) | Cell::Leaving(_))
}

/// Returns all jobs of up to this many half-edges.
pub(super) fn jobs(half_edges: usize) -> Vec<Job> {
    let mut jobs = vec![isolated_vertices()];
    jobs.extend([every_link(), every_link_and_dangling(), textbook_edge(), textbook_loop(), loop_with_records()]);
    jobs.extend([every_field_of_an_edge(), every_field_of_a_loop(), every_field_with_records()]);
    jobs.extend([links_of_four(), twins_of_four(), next_and_prev(), open_borders()]);
    jobs.extend([one_disc(), one_torus(), one_loop_without_face()]);
    for edges in 1..=half_edges / 2 {
        jobs.extend([
            paired("next, for all twins; surfaces", edges, BARE, formulas::maps(edges as u128)),
            paired("next, for all twins; the plane", edges, PLANE, formulas::plane_maps(edges as u128)),
        ]);
    }
    jobs.retain(|job| job.from <= half_edges);
    jobs.sort_by_key(|job| job.half_edges);
    jobs
}

fn job(name: &'static str, half_edges: usize, form: Form, assignments: Vec<Assignments>, right: u128) -> Job {
    Job { name, half_edges, from: half_edges, expectation: form.expectation, derive_origins: false, assignments, right }
}

/// Every link between two half-edges and two vertices.
fn every_link() -> Job {
    let all = Assignments::new(blank(2, 2, 0, &[]), MAP, |_| Some(To::OrNil));
    let right = formulas::maps_with_leaving(1, 2);
    job("origin, twin, next, prev, leaving; nil", 2, MAP, vec![all], right)
}

/// [`every_link`] with links to the slot past the end.
fn every_link_and_dangling() -> Job {
    let all = Assignments::new(blank(2, 2, 0, &[]), MAP, |_| Some(To::OrPastTheEnd));
    let right = formulas::maps_with_leaving(1, 2);
    Job { from: 4, ..job("origin, twin, next, prev, leaving; nil, dangling", 2, MAP, vec![all], right) }
}

fn links_of_four() -> Job {
    let all = Assignments::new(blank(2, 4, 0, &[]), BARE, |_| Some(To::Live));
    job("origin, twin, next; 2 vertices", 4, BARE, vec![all], formulas::maps_with_vertices(2, 2))
}

fn twins_of_four() -> Job {
    let is_free = |cell| matches!(cell, Cell::Twin(_) | Cell::Next(_)).then_some(To::Live);
    let all = Assignments::new(blank(0, 4, 0, &[]), BARE, is_free);
    Job { derive_origins: true, ..job("twin, next", 4, BARE, vec![all], formulas::maps(2)) }
}

/// Every `next` for every way to pair off the half-edges.
fn paired(name: &'static str, edges: usize, form: Form, right: u128) -> Job {
    let is_free = |cell| matches!(cell, Cell::Next(_)).then_some(To::Live);
    let of_pairing = |twins: &Vec<usize>| Assignments::new(with_twins(twins), form, is_free);
    let assignments = pairings(2 * edges).iter().map(of_pairing).collect();
    Job { derive_origins: true, ..job(name, 2 * edges, form, assignments, right) }
}

/// For each permutation there is exactly one inverse.
fn next_and_prev() -> Job {
    let form = without(MAP, Part::Leaving);
    let is_free = |cell| matches!(cell, Cell::Next(_) | Cell::Prev(_)).then_some(To::Live);
    let assignments = pairings(4).iter().map(|twins| Assignments::new(with_twins(twins), form, is_free)).collect();
    Job { derive_origins: true, ..job("next, prev, for all twins", 4, form, assignments, formulas::maps(2)) }
}

/// Every twin, or none: 0, 1 or 2 pairs of twins. If each border is closed by one more cycle, the result is always a surface.
fn open_borders() -> Job {
    twins_or_nil("twin or nil, next; open borders", OPEN, (1 + 6 + 3) * 24)
}

/// [`open_borders`] claimed to be a disc of one face with four sides: a square, whose half-edges can follow one another in 3!
/// ways. If two adjacent sides were one edge, the other two would join the same vertices.
fn one_disc() -> Job {
    let asked = OPEN.no_unused_vertices().simple().sides(4).components(1).borders(1).genus(0);
    twins_or_nil("twin or nil, next; asked for: a square", asked, 6)
}

/// [`open_borders`] claimed to be a torus without border: the one rooted map of genus 1 with two edges (OEIS A006300), on labels.
fn one_torus() -> Job {
    let asked = OPEN.no_unused_vertices().sides(4).closed().components(1).borders(0).genus(1);
    twins_or_nil("twin or nil, next; asked for: a torus", asked, 6)
}

fn twins_or_nil(name: &'static str, expectation: Expectation, right: u128) -> Job {
    let form = Form::new(expectation, Parts::NONE);
    let all = Assignments::new(blank(0, 4, 0, &[]), form, |cell| match cell {
        Cell::Twin(_) => Some(To::OrNil),
        Cell::Next(_) => Some(To::Live),
        _ => None,
    });
    Job { derive_origins: true, ..job(name, 4, form, vec![all], right) }
}

/// A loop with a face on one side and none on the other, which is a border: either half-edge can be inside.
fn one_loop_without_face() -> Job {
    let asked = OPEN.no_unused_vertices().sides(1).components(1).borders(1).genus(0);
    let asked = Form::new(asked, Parts::NONE.with(Part::Prev).with(Part::Faces));
    let all = Assignments::new(blank(1, 2, 0, &[0]), asked, |_| Some(To::OrNil));
    job("every field of a loop and a face; nil; asked for: a disc", 2, asked, vec![all], 2)
}

/// One edge between two vertices in one face: the vertices can be swapped and the start chosen.
fn textbook_edge() -> Job {
    let lists: [&[usize]; 2] = [&[1], &[0]];
    let assignments = lists.map(|lists| Assignments::new(blank(2, 2, 0, lists), TEXTBOOK, |_| Some(To::OrNil)));
    job("an edge in one face, as in textbooks; nil", 2, TEXTBOOK, assignments.to_vec(), 2 * 2)
}

/// The possible lengths of the lists of two faces, with two entries in total at most.
const LISTS: [[usize; 2]; 4] = [[0, 0], [1, 0], [0, 1], [1, 1]];

/// A loop and two faces: a choice of the outer half-edge, and of the outer face.
fn textbook_loop() -> Job {
    let form = without(TEXTBOOK, Part::Prev);
    let assignments = LISTS.map(|lists| Assignments::new(blank(1, 2, 0, &lists), form, |_| Some(To::OrNil)));
    Job { from: 4, ..job("a loop and two faces, as in textbooks; nil", 2, form, assignments.to_vec(), 2 * 2) }
}

/// Links of the map lead to live records, and all other fields to these or nowhere.
const fn nil_but_for_the_map(cell: Cell) -> To {
    if is_of_the_map(cell) && !matches!(cell, Cell::Leaving(_)) { To::Live } else { To::OrNil }
}

/// Two vertices and one face: an edge. The vertices can be swapped and the start chosen.
fn every_field_of_an_edge() -> Job {
    let all = Assignments::new(blank(2, 2, 0, &[1]), TEXTBOOK_LEAVING, |cell| Some(nil_but_for_the_map(cell)));
    Job { from: 4, ..job("every field of an edge, as in textbooks", 2, TEXTBOOK_LEAVING, vec![all], 2 * 2) }
}

/// A loop with one vertex and two faces: a choice of the leaving and the outer half-edge, and of the outer face, if its list has
/// room.
fn every_field_of_a_loop() -> Job {
    let assignments = LISTS.map(|lists| {
        Assignments::new(blank(1, 2, 0, &lists), TEXTBOOK_LEAVING, |cell| Some(nil_but_for_the_map(cell)))
    });
    Job {
        from: 4,
        ..job("every field of a loop, as in textbooks", 2, TEXTBOOK_LEAVING, assignments.to_vec(), 2 * (2 + 2))
    }
}

/// Two vertices, one boundary component and one face: an edge, as above.
fn every_field_with_records() -> Job {
    let all = Assignments::new(blank(2, 2, 1, &[1]), RECORDS, |cell| match cell {
        Cell::Isolated(_) | Cell::Outer(_) | Cell::Inner(..) => Some(To::OrNil),
        _ => Some(To::Live),
    });
    Job { from: 4, ..job("every field of an edge, boundary component too", 2, RECORDS, vec![all], 2 * 2) }
}

/// A loop with two boundary components and two faces: a choice of the outer half-edge, the outer face, and the component.
fn loop_with_records() -> Job {
    let assignments = LISTS.map(|lists| {
        let mut table = blank(1, 2, 2, &lists);
        for h in 0..2 {
            table.set(Cell::Origin(h), Value::Link(Some(0)));
            table.set(Cell::Twin(h), Value::Link(Some(1 - h)));
            table.set(Cell::Next(h), Value::Link(Some(h)));
            table.set(Cell::Prev(h), Value::Link(Some(h)));
        }
        table.set(Cell::Leaving(0), Value::Link(Some(0)));
        Assignments::new(table, RECORDS, |cell| match cell {
            cell if is_of_the_map(cell) => None,
            Cell::Boundary(_) | Cell::BoundaryFace(_) | Cell::BoundaryStart(_) => Some(To::Live),
            _ => Some(To::OrNil),
        })
    });
    Job { from: 4, ..job("boundary, face and vertex fields of a loop", 2, RECORDS, assignments.to_vec(), 4 + 4) }
}

/// Two isolated vertices in one face: a choice of the boundary component of each vertex, and of their order in the list.
fn isolated_vertices() -> Job {
    let form = without(RECORDS, Part::Leaving);
    let assignments = [0, 1, 2].map(|listed| Assignments::new(blank(2, 0, 2, &[listed]), form, |_| Some(To::OrNil)));
    job("boundary and face fields of two isolated vertices", 0, form, assignments.to_vec(), 2 * 2)
}
