//! A certificate for SQL: its records as tables in CSV, and `check.sql`, which has each test as a view of the records that fail it.
//!
//! CSV and not Parquet: `DuckDB`, `PostgreSQL` and Spark read it without extensions, and writing it needs no dependency.

use super::folder::Folder;
use crate::status::Failure;
use std::fmt::Write as _;
use std::fs::File;
use std::io::{BufWriter, Write as _};
use std::path::Path;
use twinedge::validate::View;
use twinedge::validate::certificate::{Column, Drawing, Labels};

/// An engine for which `check.sql` is written.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(super) enum Engine {
    Duckdb,
    Postgres,
    Spark,
}

/// A table: its name, its columns, and its rows.
struct Table<'a> {
    name: &'static str,
    columns: Vec<&'static str>,
    rows: Box<dyn Iterator<Item = Vec<Option<i128>>> + 'a>,
}

/// The views that have the records that fail, in order.
const PLANE: &str = include_str!("sql/plane.sql");
const DRAWING: &str = include_str!("sql/drawing.sql");

/// Writes the tables and `check.sql`.
pub(super) fn write(folder: &Path, certificate: &Folder, engine: Engine) -> Result<(), Failure> {
    let mut sql = format!(
        "-- Run in this folder. The last statement prints the verdict: each test, and how many records fail it.\n{}",
        hint(engine)
    );
    for table in tables(certificate) {
        sql += &header(engine, table.name, &table.columns);
        write_table(folder, table)?;
    }
    sql += PLANE;
    if certificate.drawing.is_some() {
        sql += DRAWING;
    }
    let verdict = verdict(&sql);
    sql += &verdict;
    std::fs::write(folder.join("check.sql"), sql)?;
    Ok(())
}

const fn hint(engine: Engine) -> &'static str {
    match engine {
        Engine::Duckdb => "-- duckdb < check.sql\n\n",
        Engine::Postgres => "-- psql -f check.sql\n\n",
        Engine::Spark => "-- spark-sql -f check.sql\n\n",
    }
}

/// The statement that makes a table, or a view of its file.
fn header(engine: Engine, name: &str, columns: &[&str]) -> String {
    let typed = |separator: &str| {
        let columns: Vec<String> = columns.iter().map(|column| format!("{column}{separator}")).collect();
        columns.join(", ")
    };
    match engine {
        Engine::Duckdb => {
            let columns = typed(": 'BIGINT'");
            format!(
                "CREATE TEMPORARY VIEW {name} AS SELECT * FROM read_csv('{name}.csv', header = true, columns = {{{columns}}});\n"
            )
        }
        Engine::Postgres => {
            format!(
                "CREATE TEMPORARY TABLE {name} ({});\n\\copy {name} FROM '{name}.csv' CSV HEADER\nANALYZE {name};\n",
                typed(" BIGINT")
            )
        }
        Engine::Spark => {
            format!(
                "CREATE TEMPORARY VIEW {name} ({}) USING csv OPTIONS (path '{name}.csv', header 'true');\n",
                typed(" BIGINT")
            )
        }
    }
}

/// The view `verdict`: a row for each view of records that fail.
fn verdict(sql: &str) -> String {
    let views = sql.lines().filter_map(|line| line.strip_prefix("CREATE TEMPORARY VIEW ")?.split(' ').next());
    let tests = views.filter(|view| view.ends_with("_ok") || view.ends_with("readable") || *view == "one_unbounded");
    let mut verdict = "\nCREATE TEMPORARY VIEW verdict AS\n".to_owned();
    for (i, test) in tests.enumerate() {
        let also = if i == 0 { "" } else { "UNION ALL " };
        let _ = writeln!(verdict, "{also}SELECT '{test}' AS test, count(*) AS violations FROM {test}");
    }
    verdict + ";\n\nSELECT * FROM verdict;\n"
}

fn write_table(folder: &Path, table: Table<'_>) -> Result<(), Failure> {
    let mut file = BufWriter::new(File::create(folder.join(format!("{}.csv", table.name)))?);
    writeln!(file, "{}", table.columns.join(","))?;
    for row in table.rows {
        let fields: Vec<String> = row.iter().map(|field| field.map_or_else(String::new, |n| n.to_string())).collect();
        writeln!(file, "{}", fields.join(","))?;
    }
    file.flush()?;
    Ok(())
}

/// The tables of a certificate. Vacant slots have no rows, and nil is empty.
fn tables(folder: &Folder) -> Vec<Table<'_>> {
    let (certificate, columns) = (&folder.certificate, folder.certificate.columns());
    let drawing = folder.drawing.as_ref();
    let of = |column: Column, i: usize| link(columns, column, i);
    let dart = move |column: Column, i: usize| drawing.map(|drawing| number(&drawing.columns, column, i));
    let with_dart = |names: &[&'static str]| -> Vec<&'static str> {
        names.iter().copied().chain(drawing.map(|_| "dart")).collect()
    };
    let row = |i: usize, links: Vec<Option<i128>>, dart: Option<i128>| -> Vec<Option<i128>> {
        [Some(i as i128)].into_iter().chain(links).chain(dart.map(Some)).collect()
    };
    let mut tables = vec![
        Table {
            name: "half_edges",
            columns: with_dart(&[
                "half_edge",
                "origin",
                "twin",
                "next_half_edge",
                "prev_half_edge",
                "boundary",
                "half_edge_rank",
            ]),
            rows: Box::new((0..certificate.half_edge_slots()).filter(|h| certificate.is_half_edge(*h)).map(move |h| {
                let links = [
                    Column::HalfEdgeOrigin,
                    Column::HalfEdgeTwin,
                    Column::HalfEdgeNext,
                    Column::HalfEdgePrev,
                    Column::HalfEdgeBoundary,
                ];
                let rank = number(columns, Column::HalfEdgeRank, h);
                let links = links.iter().map(|column| of(*column, h)).chain([Some(rank)]).collect();
                row(h, links, dart(Column::HalfEdgeDart, h))
            })),
        },
        Table {
            name: "vertices",
            columns: with_dart(&["vertex", "leaving", "isolated"]),
            rows: Box::new((0..certificate.vertex_slots()).filter(|v| certificate.is_vertex(*v)).map(move |v| {
                row(v, vec![of(Column::VertexLeaving, v), of(Column::VertexIsolated, v)], dart(Column::VertexDart, v))
            })),
        },
        Table {
            name: "boundaries",
            columns: vec!["boundary", "face", "start_half_edge", "vertex", "place"],
            rows: Box::new((0..certificate.boundary_slots()).filter(|b| certificate.is_boundary(*b)).map(move |b| {
                let links =
                    [Column::BoundaryFace, Column::BoundaryStart, Column::BoundaryVertex, Column::BoundaryPlace];
                row(b, links.iter().map(|column| of(*column, b)).collect(), None)
            })),
        },
        Table {
            name: "faces",
            columns: with_dart(&["face", "outer_boundary"]),
            rows: Box::new(
                (0..certificate.face_slots())
                    .filter(|f| certificate.is_face(*f))
                    .map(move |f| row(f, vec![of(Column::FaceOuter, f)], dart(Column::FaceDart, f))),
            ),
        },
        Table {
            name: "entries",
            columns: vec!["face", "place", "boundary"],
            rows: Box::new((0..certificate.face_slots()).filter(|f| certificate.is_face(*f)).flat_map(move |f| {
                let entry =
                    move |i: usize| vec![Some(f as i128), Some(i as i128), certificate.inner(f, i).map(|b| b as i128)];
                (0..certificate.inner_count(f)).map(entry)
            })),
        },
    ];
    if let Some(drawing) = drawing {
        tables.extend(drawing_tables(drawing));
    }
    tables
}

fn drawing_tables(drawing: &Drawing) -> [Table<'_>; 2] {
    let side = |d: usize| {
        let of = |column| Some(number(&drawing.columns, column, d));
        vec![
            Some(d as i128 / 3),
            Some(d as i128 % 3),
            of(Column::DartTwin),
            of(Column::DartPoint),
            link(&drawing.columns, Column::DartHalfEdge, d),
            of(Column::DartAhead),
            of(Column::DartFace),
            of(Column::DartRank),
        ]
    };
    let point = |(i, [x, y]): (usize, &[i64; 2])| vec![Some(i as i128), Some(i128::from(*x)), Some(i128::from(*y))];
    [
        Table {
            name: "sides",
            columns: vec!["triangle", "side", "twin", "point", "half_edge", "ahead", "face", "dart_rank"],
            rows: Box::new((0..drawing.columns.column(Column::DartTwin).len()).map(side)),
        },
        Table {
            name: "points",
            columns: vec!["point", "x", "y"],
            rows: Box::new(drawing.points.iter().enumerate().map(point)),
        },
    ]
}

fn number(columns: &Labels, column: Column, i: usize) -> i128 {
    columns.column(column)[i].into()
}

/// The same, without nil.
fn link(columns: &Labels, column: Column, i: usize) -> Option<i128> {
    Some(number(columns, column, i)).filter(|number| *number != i128::from(u32::MAX))
}
