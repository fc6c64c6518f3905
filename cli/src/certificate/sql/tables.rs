//! The tables of a certificate. Vacant slots have no rows, and nil is NULL.

use crate::certificate::folder::Folder;
use twinedge::validate::View;
use twinedge::validate::certificate::{Certificate, Column, Drawing, Labels};

/// A table: its name, and its columns, all of the same length.
pub(super) struct Table<'a> {
    pub(super) name: &'static str,
    pub(super) columns: Vec<TableColumn<'a>>,
}

/// A column of a table, from the first row to the last.
pub(super) struct TableColumn<'a> {
    pub(super) name: &'static str,
    /// True if the column holds links that may be nil.
    pub(super) is_nullable: bool,
    pub(super) values: Box<dyn Iterator<Item = Option<i64>> + 'a>,
}

/// A table with a row for each live record of a kind.
struct RecordTable {
    name: &'static str,
    key: &'static str,
    columns: &'static [(&'static str, Column)],
    /// The dart of the record, in a drawing.
    dart: Option<Column>,
    slots: fn(&Certificate) -> usize,
    is_live: fn(&Certificate, usize) -> bool,
}

const RECORDS: [RecordTable; 4] = [
    RecordTable {
        name: "half_edges",
        key: "half_edge",
        columns: &[
            ("origin", Column::HalfEdgeOrigin),
            ("twin", Column::HalfEdgeTwin),
            ("next_half_edge", Column::HalfEdgeNext),
            ("prev_half_edge", Column::HalfEdgePrev),
            ("boundary", Column::HalfEdgeBoundary),
            ("half_edge_rank", Column::HalfEdgeRank),
        ],
        dart: Some(Column::HalfEdgeDart),
        slots: Certificate::half_edge_slots,
        is_live: Certificate::is_half_edge,
    },
    RecordTable {
        name: "vertices",
        key: "vertex",
        columns: &[("leaving", Column::VertexLeaving), ("isolated", Column::VertexIsolated)],
        dart: Some(Column::VertexDart),
        slots: Certificate::vertex_slots,
        is_live: Certificate::is_vertex,
    },
    RecordTable {
        name: "boundaries",
        key: "boundary",
        columns: &[
            ("face", Column::BoundaryFace),
            ("start_half_edge", Column::BoundaryStart),
            ("vertex", Column::BoundaryVertex),
            ("place", Column::BoundaryPlace),
        ],
        dart: None,
        slots: Certificate::boundary_slots,
        is_live: Certificate::is_boundary,
    },
    RecordTable {
        name: "faces",
        key: "face",
        columns: &[("outer_boundary", Column::FaceOuter)],
        dart: Some(Column::FaceDart),
        slots: Certificate::face_slots,
        is_live: Certificate::is_face,
    },
];

const SIDES: [(&str, Column); 6] = [
    ("twin", Column::DartTwin),
    ("point", Column::DartPoint),
    ("half_edge", Column::DartHalfEdge),
    ("ahead", Column::DartAhead),
    ("face", Column::DartFace),
    ("dart_rank", Column::DartRank),
];

/// The tables of a certificate.
pub(super) fn tables(folder: &Folder) -> Vec<Table<'_>> {
    let (certificate, drawing) = (&folder.certificate, folder.drawing.as_ref());
    let mut tables: Vec<_> = RECORDS.iter().map(|records| of_records(records, certificate, drawing)).collect();
    tables.push(entries(certificate));
    tables.extend(drawing.into_iter().flat_map(|drawing| [sides(drawing), points(drawing)]));
    tables
}

fn of_records<'a>(table: &RecordTable, certificate: &'a Certificate, drawing: Option<&'a Drawing>) -> Table<'a> {
    let is_live = table.is_live;
    let records = || (0..(table.slots)(certificate)).filter(move |i| is_live(certificate, *i));
    let mut columns = vec![required(table.key, records())];
    columns.extend(table.columns.iter().map(|(name, column)| of(certificate.columns(), name, *column, records())));
    let dart = drawing.zip(table.dart).map(|(drawing, column)| of(&drawing.columns, "dart", column, records()));
    columns.extend(dart);
    Table { name: table.name, columns }
}

/// The entries of the lists of faces.
fn entries(certificate: &Certificate) -> Table<'_> {
    let faces = || (0..certificate.face_slots()).filter(|f| certificate.is_face(*f));
    let entries = || faces().flat_map(|f| (0..certificate.inner_count(f)).map(move |i| (f, i)));
    let boundaries = entries().filter_map(|(f, i)| certificate.inner(f, i));
    let columns = vec![
        required("face", entries().map(|(f, _)| f)),
        required("place", entries().map(|(_, i)| i)),
        required("boundary", boundaries),
    ];
    Table { name: "entries", columns }
}

fn sides(drawing: &Drawing) -> Table<'_> {
    let darts = 0..drawing.columns.column(Column::DartTwin).len();
    let mut columns =
        vec![required("triangle", darts.clone().map(|d| d / 3)), required("side", darts.clone().map(|d| d % 3))];
    columns.extend(SIDES.iter().map(|(name, column)| of(&drawing.columns, name, *column, darts.clone())));
    Table { name: "sides", columns }
}

fn points(drawing: &Drawing) -> Table<'_> {
    let axis = |name, axis: usize| TableColumn {
        name,
        is_nullable: false,
        values: Box::new(drawing.points.iter().map(move |point| Some(point[axis]))),
    };
    Table { name: "points", columns: vec![required("point", 0..drawing.points.len()), axis("x", 0), axis("y", 1)] }
}

/// A column of numbers of records or places.
fn required<'a>(name: &'static str, numbers: impl Iterator<Item = usize> + 'a) -> TableColumn<'a> {
    TableColumn { name, is_nullable: false, values: Box::new(numbers.map(|number| i64::try_from(number).ok())) }
}

/// The entries of these records in a column of the certificate.
fn of<'a>(
    labels: &'a Labels,
    name: &'static str,
    column: Column,
    records: impl Iterator<Item = usize> + 'a,
) -> TableColumn<'a> {
    let is_nullable = may_be_nil(column);
    let numbers = labels.column(column);
    let value = move |i: usize| Some(numbers[i]).filter(|number| !is_nullable || *number != u32::MAX).map(i64::from);
    TableColumn { name, is_nullable, values: Box::new(records.map(value)) }
}

/// Returns true if a certificate that is right may have nil in the column.
const fn may_be_nil(column: Column) -> bool {
    matches!(
        column,
        Column::VertexLeaving
            | Column::VertexIsolated
            | Column::BoundaryStart
            | Column::BoundaryVertex
            | Column::BoundaryPlace
            | Column::FaceOuter
            | Column::DartHalfEdge
    )
}
