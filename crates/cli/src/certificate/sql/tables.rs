//! The tables of a certificate. Vacant slots have no rows, and nil is NULL.

use crate::certificate::folder::{Claim, Folder};
use crate::output::Failure;
use std::fs::File;
use std::io::{BufWriter, Write as _};
use std::path::Path;
use twinedge::validate::View;
use twinedge_certificate::{Certificate, Column, Drawing, Labels, VACANT};
use twinedge_layers::IntegerColumn;

pub(super) struct Table<'a> {
    pub(super) name: &'static str,
    pub(super) columns: Vec<IntegerColumn<'a>>,
}

/// A column of the certificate, with its name in a table.
struct Source {
    name: &'static str,
    column: Column,
    is_nullable: bool,
}

const fn numbers(name: &'static str, column: Column) -> Source {
    Source { name, column, is_nullable: false }
}

/// A column that may contain nil in a valid certificate.
const fn links(name: &'static str, column: Column) -> Source {
    Source { name, column, is_nullable: true }
}

/// A table with a row for each live record of a kind. The first column tells vacant slots.
struct RecordTable {
    name: &'static str,
    key: &'static str,
    columns: &'static [Source],
    /// The dart of the record, in a drawing.
    dart: Option<Column>,
}

pub(super) const NAMES: [&str; 7] = ["half_edges", "vertices", "boundaries", "faces", "entries", "sides", "points"];

const OF_SUBDIVISION: [RecordTable; 4] = [
    RecordTable {
        name: "half_edges",
        key: "half_edge",
        columns: &[
            numbers("origin", Column::HalfEdgeOrigin),
            numbers("twin", Column::HalfEdgeTwin),
            numbers("next_half_edge", Column::HalfEdgeNext),
            numbers("prev_half_edge", Column::HalfEdgePrev),
            numbers("boundary", Column::HalfEdgeBoundary),
            numbers("half_edge_rank", Column::HalfEdgeRank),
        ],
        dart: Some(Column::HalfEdgeDart),
    },
    RecordTable {
        name: "vertices",
        key: "vertex",
        columns: &[links("leaving", Column::VertexLeaving), links("isolated", Column::VertexIsolated)],
        dart: Some(Column::VertexDart),
    },
    RecordTable {
        name: "boundaries",
        key: "boundary",
        columns: &[
            numbers("face", Column::BoundaryFace),
            links("start_half_edge", Column::BoundaryStart),
            links("vertex", Column::BoundaryVertex),
            links("place", Column::BoundaryPlace),
        ],
        dart: None,
    },
    RecordTable {
        name: "faces",
        key: "face",
        columns: &[links("outer_boundary", Column::FaceOuter)],
        dart: Some(Column::FaceDart),
    },
];

const OF_SURFACE: [RecordTable; 4] = [
    RecordTable {
        name: "half_edges",
        key: "half_edge",
        columns: &[
            numbers("origin", Column::HalfEdgeOrigin),
            numbers("twin", Column::HalfEdgeTwin),
            numbers("next_half_edge", Column::HalfEdgeNext),
            numbers("prev_half_edge", Column::HalfEdgePrev),
            numbers("boundary", Column::HalfEdgeBoundary),
            numbers("half_edge_rank", Column::HalfEdgeRank),
            numbers("turn", Column::HalfEdgeTurn),
            numbers("step", Column::HalfEdgeStep),
            numbers("component", Column::HalfEdgeComponent),
        ],
        dart: None,
    },
    RecordTable {
        name: "vertices",
        key: "vertex",
        columns: &[links("leaving", Column::VertexLeaving), links("border", Column::VertexBorder)],
        dart: None,
    },
    RecordTable {
        name: "boundaries",
        key: "boundary",
        columns: &[links("face", Column::BoundaryFace), numbers("start_half_edge", Column::BoundaryStart)],
        dart: None,
    },
    RecordTable { name: "faces", key: "face", columns: &[numbers("outer_boundary", Column::FaceOuter)], dart: None },
];

const SIDES: [Source; 6] = [
    numbers("twin", Column::DartTwin),
    numbers("point", Column::DartPoint),
    links("half_edge", Column::DartHalfEdge),
    numbers("ahead", Column::DartAhead),
    numbers("face", Column::DartFace),
    numbers("dart_rank", Column::DartRank),
];

pub(super) fn tables(claim: &Claim) -> Vec<Table<'_>> {
    let folder = match claim {
        Claim::Surface(surface) => {
            return OF_SURFACE.iter().map(|records| of_records(records, surface.columns(), None)).collect();
        }
        Claim::Plane(folder) => folder,
    };
    let Folder { certificate, drawing } = &**folder;
    let records = |records| of_records(records, certificate.columns(), drawing.as_ref());
    let mut tables: Vec<_> = OF_SUBDIVISION.iter().map(records).collect();
    tables.push(entries(certificate));
    tables.extend(drawing.iter().flat_map(|drawing| [sides(drawing), points(drawing)]));
    tables
}

fn of_records<'a>(table: &'static RecordTable, labels: &'a Labels, drawing: Option<&'a Drawing>) -> Table<'a> {
    let first = table.columns.first().map_or(&[][..], |source| labels.column(source.column));
    let records = || (0..first.len()).filter(move |i| first[*i] != VACANT);
    let mut columns = vec![required(table.key, records())];
    columns.extend(table.columns.iter().map(|source| of(labels, source, records())));
    let dart = drawing.zip(table.dart).map(|(drawing, dart)| of(&drawing.columns, &numbers("dart", dart), records()));
    columns.extend(dart);
    Table { name: table.name, columns }
}

/// The entries in the lists of faces.
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
    columns.extend(SIDES.iter().map(|source| of(&drawing.columns, source, darts.clone())));
    Table { name: "sides", columns }
}

fn points(drawing: &Drawing) -> Table<'_> {
    let axis = |name, axis: usize| IntegerColumn {
        name,
        is_nullable: false,
        values: Box::new(drawing.points.iter().map(move |point| Some(point[axis]))),
    };
    Table { name: "points", columns: vec![required("point", 0..drawing.points.len()), axis("x", 0), axis("y", 1)] }
}

/// A column of numbers of records or places.
fn required<'a>(name: &'static str, numbers: impl Iterator<Item = usize> + 'a) -> IntegerColumn<'a> {
    IntegerColumn { name, is_nullable: false, values: Box::new(numbers.map(|number| i64::try_from(number).ok())) }
}

/// The entries of these records in a column of the certificate.
fn of<'a>(labels: &'a Labels, source: &Source, records: impl Iterator<Item = usize> + 'a) -> IntegerColumn<'a> {
    let Source { name, column, is_nullable } = *source;
    let numbers = labels.column(column);
    let value = move |i: usize| Some(numbers[i]).filter(|number| !is_nullable || *number != u32::MAX).map(i64::from);
    IntegerColumn { name, is_nullable, values: Box::new(records.map(value)) }
}

/// Writes a table in CSV; NULL is empty.
pub(super) fn write_csv(folder: &Path, mut table: Table<'_>) -> Result<(), Failure> {
    let mut file = BufWriter::new(File::create(folder.join(format!("{}.csv", table.name)))?);
    let names: Vec<&str> = table.columns.iter().map(|column| column.name).collect();
    writeln!(file, "{}", names.join(","))?;
    loop {
        let row: Option<Vec<_>> = table.columns.iter_mut().map(|column| column.values.next()).collect();
        let Some(row) = row else { break };
        let fields: Vec<String> = row.iter().map(|field| field.map_or_else(String::new, |n| n.to_string())).collect();
        writeln!(file, "{}", fields.join(","))?;
    }
    file.flush()?;
    Ok(())
}
