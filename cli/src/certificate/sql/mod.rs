//! A certificate for SQL: its records as tables, and `check.sql`, which has each test as a view of the records that fail it.
//!
//! The tables are in Parquet, which keeps columns apart and says which are never NULL; in CSV for `PostgreSQL`, which does not read
//! Parquet.

mod csv_file;
mod parquet_file;
mod tables;

use super::folder::Folder;
use super::notes::Notes;
use crate::status::Failure;
use std::fmt::Write as _;
use std::path::Path;
use tables::{Table, tables};

/// An engine for which `check.sql` is written.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(super) enum Engine {
    Duckdb,
    Postgres,
    Spark,
}

/// The version of the tables and their columns, as `docs/certificate.md` lists them.
const SCHEMA_VERSION: &str = "1";

/// The views that have the records that fail, in order.
const PLANE: &str = include_str!("plane.sql");
const DRAWING: &str = include_str!("drawing.sql");

/// Writes the tables and `check.sql`.
pub(super) fn write(folder: &Path, certificate: &Folder, notes: &Notes, engine: Engine) -> Result<(), Failure> {
    let mut sql = format!(
        "-- Run in this folder. The last statement prints the verdict: each test, and how many records fail it.\n{}",
        hint(engine)
    );
    let metadata: Vec<(&str, &str)> = [("schema", SCHEMA_VERSION), ("claim", certificate.claim().trim_end())]
        .into_iter()
        .chain(notes.entries())
        .collect();
    for table in tables(certificate) {
        sql += &header(engine, &table);
        match engine {
            Engine::Postgres => csv_file::write(folder, table)?,
            Engine::Duckdb | Engine::Spark => parquet_file::write(folder, table, &metadata)?,
        }
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
        Engine::Spark => "-- spark-sql -f check.sql\n\nSET spark.sql.parquet.filterPushdown = false;\n",
    }
}

/// The statement that makes a table, or a view of its file, of integers of 64 bits. All rows are read: the statistics of a Parquet file,
/// by which engines skip some, may be false.
fn header(engine: Engine, table: &Table<'_>) -> String {
    let name = table.name;
    let columns = |form: &dyn Fn(&str) -> String| {
        let columns: Vec<String> = table.columns.iter().map(|column| form(column.name)).collect();
        columns.join(", ")
    };
    let typed = columns(&|column| format!("{column} BIGINT"));
    match engine {
        Engine::Duckdb => {
            let cast = columns(&|column| format!("CAST({column} AS BIGINT) AS {column}"));
            format!("CREATE TEMPORARY TABLE {name} AS SELECT {cast} FROM read_parquet('{name}.parquet');\n")
        }
        Engine::Postgres => {
            format!(
                "CREATE TEMPORARY TABLE {name} ({typed});\n\\copy {name} FROM '{name}.csv' CSV HEADER\nANALYZE {name};\n"
            )
        }
        Engine::Spark => {
            format!("CREATE TEMPORARY VIEW {name} ({typed}) USING parquet OPTIONS (path '{name}.parquet');\n")
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
    // Tests that fail come first: some engines print no more than the beginning.
    verdict + ";\n\nSELECT * FROM verdict ORDER BY violations DESC, test;\n"
}
