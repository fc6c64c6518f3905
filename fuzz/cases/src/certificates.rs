//! The target that passes arbitrary certificates to the checkers.

use crate::tables::{Fickle, Source};
use arbitrary::Unstructured;
use twinedge::validate::{
    BoundaryPlace, BoundaryRow, Collect, Expectation, FaceRow, HalfEdgeRow, Part, Parts, Start, Surface, Table,
    VertexRow, View, validate,
};
use twinedge_certificate::{
    Certificate, Column, Drawing, Labels, SurfaceCertificate, VACANT, check, check_drawing, check_surface,
};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::certificate::draw;
use twinedge_map::{Builder, Embedding, Noding, Shape, validate_embedding};
use twinedge_trials::enumerate::TableCells;

const PLANE: Expectation = Expectation::plane();
const SURFACE: Expectation = Expectation::surface();

/// Changes of numbers of a certificate.
struct Changes(Vec<[usize; 3]>);

impl Changes {
    fn new(source: &mut Source<'_>) -> Self {
        Self((0..source.below(4)).map(|_| [(); 3].map(|()| source.below(0x1_0000))).collect())
    }

    /// Changes numbers in the non-empty columns among these. One in sixteen changes shortens a column.
    fn make(&self, columns: &mut Labels, among: &[Column]) {
        for [column, at, value] in &self.0 {
            let filled: Vec<Column> =
                among.iter().copied().filter(|column| !columns.column(*column).is_empty()).collect();
            let Some(column) = filled.get(column % filled.len().max(1)) else { return };
            let numbers = columns.column_mut(*column);
            let at = at % numbers.len();
            if value % 16 == 15 {
                numbers.truncate(at);
                continue;
            }
            let value = value / 16 % (numbers.len() + 4);
            let beyond = value.saturating_sub(numbers.len());
            // One past the end, and the three numbers with special meanings.
            let number = if beyond > 0 { u32::MAX as usize - (beyond - 1) } else { value };
            numbers[at] = u32::try_from(number).unwrap_or(u32::MAX);
        }
    }
}

/// A table with coordinates.
struct Drawn {
    table: Table,
    points: Vec<Point>,
}

impl View for Drawn {
    twinedge::delegate_view!(|this| &this.table);
}

impl Embedding for Drawn {
    fn point(&self, vertex: usize) -> Point {
        self.points.get(vertex).copied().unwrap_or_default()
    }
}

impl Drawn {
    /// The table whose vertices lie where the drawing has them.
    fn at(self, drawing: &Drawing) -> Self {
        let points = drawing.points.iter().map(|[x, y]| Point::new(*x as f64, *y as f64)).collect();
        Self { points, ..self }
    }
}

/// Makes certificates for any table, for a valid map with a few cells changed, for a structure that changes its
/// answers, and for a drawing; then changes some of their numbers. A certificate that passes keeps the rules, and a
/// structure that keeps them passes with the labels made for it.
///
/// # Panics
/// If a checker disagrees with the rules.
pub fn certificates(bytes: &[u8]) {
    let mut source = Source(Unstructured::new(bytes));
    let mode = source.below(5);
    let changes = Changes::new(&mut source);
    if mode == 4 {
        return drawing(&mut source, &changes);
    }
    let form = source.form();
    if mode == 3 {
        return returns(&Fickle::new(form.parts, source), &changes);
    }
    let table = if mode == 0 { Table { parts: form.parts, ..source.table() } } else { source.corrupt_map(form) };
    match form.expectation.surface_kind() {
        Surface::Plane => subdivision(&table, &changes),
        _ => surface(&table, &changes),
    }
}

fn keeps(view: &impl View, expectation: &Expectation) -> bool {
    validate(view, expectation, Collect::First).is_valid()
}

fn subdivision(table: &Table, changes: &Changes) {
    let Ok(mut labels) = Labels::new(table) else { return };
    let valid = keeps(table, &PLANE);
    assert_eq!(check(table, &labels).is_ok(), valid, "{table}");
    let made = Certificate::new(table, &labels);
    assert_eq!(made.as_ref().is_ok_and(|certificate| certificate.check().is_ok()), valid, "{table}");

    changes.make(&mut labels, &Column::ALL);
    assert!(valid || check(table, &labels).is_err(), "{table}\n{labels:?}");
    let Ok(mut certificate) = made else { return };
    let mut columns = certificate.columns().clone();
    changes.make(&mut columns, Column::of_subdivision());
    if let Some(changed) = Certificate::from_columns(columns) {
        certificate = changed;
    }
    assert!(certificate.check().is_err() || keeps(&certificate, &PLANE), "{certificate:?}");
}

fn surface(table: &Table, changes: &Changes) {
    let Ok((mut labels, genus)) = Labels::of_surface(table) else { return };
    let valid = keeps(table, &SURFACE);
    assert_eq!(check_surface(table, &labels, genus).is_ok(), valid, "{table}");
    let certificate = SurfaceCertificate::new(table).expect("a small table");
    match certificate.check() {
        Ok(counts) => {
            let expectation = if counts.holes > 0 { SURFACE.open() } else { SURFACE };
            assert!(keeps(table, &expectation), "{table}");
        }
        Err(failures) => assert!(!valid, "{table}\n{failures:?}"),
    }

    changes.make(&mut labels, &Column::ALL);
    let passes = (0..=genus + 1).any(|genus| check_surface(table, &labels, genus).is_ok());
    assert!(valid || !passes, "{table}\n{labels:?}");
    let mut columns = certificate.columns().clone();
    changes.make(&mut columns, Column::of_surface());
    if let Some(changed) = SurfaceCertificate::from_columns(columns.clone())
        && let Ok(counts) = changed.check()
    {
        let structure = without_holes(&columns);
        let expectation = if counts.holes > 0 { SURFACE.open() } else { SURFACE };
        assert!(keeps(&structure, &expectation), "{columns:?}");
    }
}

/// Makes certificates of a structure that changes its answers, unless they are refused, and checks them.
fn returns(view: &Fickle<'_>, changes: &Changes) {
    if let Ok(mut labels) = Labels::new(view) {
        changes.make(&mut labels, &Column::ALL);
        let _ = check(view, &labels);
        let _ = Certificate::new(view, &labels).map(|certificate| certificate.check());
    }
    if let Ok((labels, genus)) = Labels::of_surface(view) {
        let _ = check_surface(view, &labels, genus);
    }
    let _ = SurfaceCertificate::new(view).map(|certificate| certificate.check());
}

/// The open surface of a certificate: removes the half-edges of holes, which the certificate adds.
fn without_holes(columns: &Labels) -> Table {
    let number = |column, i: usize| columns.column(column).get(i).map(|number| *number as usize);
    let link = |column, i: usize| number(column, i).filter(|to| *to != u32::MAX as usize);
    let live = |column, i: usize| number(column, i).is_some_and(|number| number != VACANT as usize);
    let is_hole = |b| live(Column::BoundaryFace, b) && link(Column::BoundaryFace, b).is_none();
    let is_border = |h| link(Column::HalfEdgeBoundary, h).is_some_and(is_hole);
    // A vertex at the border keeps the half-edge without twin: in the certificate, the twin of the half-edge of the
    // hole that arrives at the vertex. The column is ignored for other vertices.
    let on_border =
        |v| link(Column::VertexBorder, v).filter(|h| is_border(*h) && link(Column::HalfEdgeOrigin, *h) == Some(v));
    let leaving = |v| match on_border(v).and_then(|h| link(Column::HalfEdgePrev, h)) {
        Some(arrives) => link(Column::HalfEdgeTwin, arrives),
        None => link(Column::VertexLeaving, v),
    };
    let slots = |column| 0..columns.column(column).len();
    Table {
        parts: Parts::ALL.without(Part::Holes).without(Part::UnboundedFace),
        vertices: slots(Column::VertexLeaving)
            .map(|v| live(Column::VertexLeaving, v).then(|| VertexRow { leaving: leaving(v), isolated: None }))
            .collect(),
        half_edges: slots(Column::HalfEdgeOrigin)
            .map(|h| {
                (live(Column::HalfEdgeOrigin, h) && !is_border(h)).then(|| HalfEdgeRow {
                    origin: link(Column::HalfEdgeOrigin, h),
                    twin: link(Column::HalfEdgeTwin, h).filter(|twin| !is_border(*twin)),
                    next: link(Column::HalfEdgeNext, h),
                    prev: link(Column::HalfEdgePrev, h),
                    boundary: link(Column::HalfEdgeBoundary, h),
                    face: None,
                })
            })
            .collect(),
        boundaries: slots(Column::BoundaryFace)
            .map(|b| {
                (live(Column::BoundaryFace, b) && !is_hole(b)).then(|| BoundaryRow {
                    face: link(Column::BoundaryFace, b),
                    start: link(Column::BoundaryStart, b).map(Start::HalfEdge),
                    place: Some(BoundaryPlace::Outer),
                })
            })
            .collect(),
        faces: slots(Column::FaceOuter)
            .map(|f| {
                live(Column::FaceOuter, f).then(|| FaceRow {
                    outer: link(Column::FaceOuter, f),
                    inner: Vec::new(),
                    outer_half_edge: None,
                    inner_starts: Vec::new(),
                })
            })
            .collect(),
    }
}

/// Draws a map of a few segments and points, then changes links, coordinates or numbers of the drawing.
fn drawing(source: &mut Source<'_>, changes: &Changes) {
    let mut builder = Builder::new();
    let point = |source: &mut Source<'_>| [(); 2].map(|()| source.below(5) as f64);
    for _ in 0..source.below(6) {
        let [from, to] = [point(source), point(source)].map(Point::from);
        let _ = if from == to { builder.shape(&Shape::Point(from)) } else { builder.segment(from, to) };
    }
    let map = builder.build_with(Noding::Snap(Snap::Size(1.0))).expect("points on a small grid");
    let points = (0..map.vertex_slots()).map(|v| map.point(v)).collect();
    let mut drawn = Drawn { table: Table::copy_of(&map).expect("a small map"), points };
    let labels = Labels::new(&drawn).expect("all parts");
    let mut certificate = draw(&drawn).expect("the map is plane, on a grid");
    assert_eq!(check_drawing(&drawn, &labels, &certificate), Ok(()), "{}", drawn.table);

    // Another structure: its drawing, made anew or unchanged, passes if it is valid.
    for _ in 0..source.below(3) {
        if let Some(v) = source.below(2 * drawn.points.len().max(1)).checked_sub(drawn.points.len())
            && let Some(moved) = drawn.points.get_mut(v)
        {
            *moved = Point::from(point(source));
        } else {
            let cells = drawn.table.cells(drawn.table.parts);
            if let Some(cell) = cells.get(source.below(cells.len().max(1))) {
                let values = drawn.table.values(*cell);
                drawn.table.set(*cell, values[source.below(values.len())]);
            }
        }
    }
    let valid = validate_embedding(&drawn, &PLANE, Collect::First).is_valid();
    if let Ok(labels) = Labels::new(&drawn) {
        let anew = draw(&drawn).map(|anew| check_drawing(&drawn, &labels, &anew));
        assert_eq!(anew == Ok(Ok(())), valid, "{anew:?} {:?}\n{}", drawn.points, drawn.table);
    }
    changes.make(&mut certificate.columns, Column::of_drawing());
    for [at, x, y] in &changes.0 {
        if at % 2 == 0 {
            let at = at / 2 % certificate.points.len();
            certificate.points[at] = [x, y].map(|x| i64::try_from(x % 11).unwrap_or_default() - 5);
        }
    }
    let drawn = drawn.at(&certificate);
    let valid = validate_embedding(&drawn, &PLANE, Collect::First).is_valid();
    let passes = check_drawing(&drawn, &labels, &certificate).is_ok();
    assert!(valid || !passes, "{:?}\n{}\n{certificate:?}", drawn.points, drawn.table);
}
