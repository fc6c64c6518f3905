//! A certificate for SQL: tables of its records, and `check.sql`, in which each test is a view of the records that fail it.
//!
//! The tables are in Parquet, which stores columns separately and declares columns that are never NULL, or in CSV for `PostgreSQL`, which does not
//! read Parquet.

mod tables;

use super::folder::{Claim, Notes};
use crate::output::Failure;
use std::fmt::Write as _;
use std::path::Path;
use tables::{NAMES, Table, tables};
use twinedge_layers::{IntegerColumn, write_integers, writes_integers};

/// An engine for which `check.sql` is written.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(super) enum Engine {
    Duckdb,
    Postgres,
    Spark,
}

/// The version of the tables and their columns, which `docs/certificate.md` lists.
const SCHEMA_VERSION: &str = "1";

/// The views of failing records: for all claims, and for each claim.
const LINKS: &str = include_str!("links.sql");
const PLANE: &str = include_str!("plane.sql");
const DRAWING: &str = include_str!("drawing.sql");
const SURFACE: &str = include_str!("surface.sql");
const FILE: &str = "check.sql";

pub(super) fn file_names() -> impl Iterator<Item = String> {
    let of_tables = NAMES.into_iter().flat_map(|name| [format!("{name}.parquet"), format!("{name}.csv")]);
    of_tables.chain([FILE.to_owned()])
}

/// Refuses an engine whose tables this build does not write.
pub(super) fn check(engine: Engine) -> Result<(), Failure> {
    match engine {
        Engine::Postgres => Ok(()),
        Engine::Duckdb | Engine::Spark => Ok(writes_integers()?),
    }
}

pub(super) fn write(folder: &Path, claim: &Claim, notes: &Notes, engine: Engine) -> Result<(), Failure> {
    let mut sql = format!(
        "-- Run in this folder. The last statement prints the verdict: each test, and how many records fail it.\n{}",
        hint(engine)
    );
    let metadata: Vec<(&str, &str)> =
        [("schema", SCHEMA_VERSION), ("claim", claim.line().trim_end())].into_iter().chain(notes.entries()).collect();
    let tables = tables(claim);
    for table in &tables {
        sql += &header(engine, table);
    }
    if !matches!(engine, Engine::Postgres) {
        sql += &integers(&tables);
    }
    for mut table in tables {
        match engine {
            Engine::Postgres => tables::write_csv(folder, table)?,
            Engine::Duckdb | Engine::Spark => {
                let path = folder.join(format!("{}.parquet", table.name));
                write_integers(&path, table.name, &mut table.columns, &metadata)?;
            }
        }
    }
    sql += LINKS;
    match claim {
        Claim::Surface(_) => sql += SURFACE,
        Claim::Plane(plane) => {
            sql += PLANE;
            sql += plane.drawing.as_ref().map_or("", |_| DRAWING);
        }
    }
    let verdict = verdict(&sql);
    sql += &verdict;
    std::fs::write(folder.join(FILE), sql)?;
    Ok(())
}

const fn hint(engine: Engine) -> &'static str {
    match engine {
        Engine::Duckdb => "-- duckdb < check.sql\n\nSET enable_progress_bar = false;\n",
        Engine::Postgres => "-- psql -f check.sql\n\n\\set ON_ERROR_STOP on\n",
        Engine::Spark => "-- spark-sql -f check.sql\n\nSET spark.sql.parquet.filterPushdown = false;\n",
    }
}

/// The statements that create a table of 64-bit integers, or a view of its file. All rows must be read: engines skip rows by the statistics of a
/// Parquet file, which may be false.
fn header(engine: Engine, table: &Table<'_>) -> String {
    let name = table.name;
    let columns = |form: &dyn Fn(&str) -> String| {
        let columns: Vec<String> = table.columns.iter().map(|column| form(column.name)).collect();
        columns.join(", ")
    };
    let cast = || columns(&|column| format!("CAST({column} AS BIGINT) AS {column}"));
    match engine {
        Engine::Duckdb => format!(
            "CREATE TEMPORARY VIEW {name}_file AS SELECT * FROM read_parquet('{name}.parquet');\n\
             CREATE TEMPORARY TABLE {name} AS SELECT {} FROM {name}_file;\n",
            cast()
        ),
        Engine::Postgres => {
            let typed = columns(&|column| format!("{column} BIGINT"));
            format!(
                "CREATE TEMPORARY TABLE {name} ({typed});\n\\copy {name} FROM '{name}.csv' CSV HEADER\nANALYZE {name};\n"
            )
        }
        Engine::Spark => format!(
            "CREATE TEMPORARY VIEW {name}_file USING parquet OPTIONS (path '{name}.parquet');\n\
             CREATE TEMPORARY VIEW {name} AS SELECT {} FROM {name}_file;\n",
            cast()
        ),
    }
}

/// The view of tables with columns of other types than integers, whose numbers would be rounded before the tests. `PostgreSQL` only reads integers
/// into its tables.
fn integers(tables: &[Table<'_>]) -> String {
    let of_table = |Table { name, columns }: &Table<'_>| {
        let is_integer = |column: &IntegerColumn<'_>| format!("lower(typeof({})) LIKE '%int%'", column.name);
        let all = columns.iter().map(is_integer).collect::<Vec<_>>().join("\n    AND ");
        format!("SELECT '{name}' AS record FROM (SELECT * FROM {name}_file LIMIT 1) f\nWHERE NOT ({all})")
    };
    let tables: Vec<String> = tables.iter().map(of_table).collect();
    format!(
        "\n-- Columns hold integers: other numbers would be rounded before they are judged. Intervals, whose name has these letters, cannot be read.\n\
         CREATE TEMPORARY VIEW integers_ok AS\n{};\n",
        tables.join("\nUNION ALL ")
    )
}

/// The view `verdict`, with a row for each view of failing records.
fn verdict(sql: &str) -> String {
    let views = sql.lines().filter_map(|line| line.strip_prefix("CREATE TEMPORARY VIEW ")?.split(' ').next());
    let tests = views.filter(|view| view.ends_with("_ok") || view.ends_with("readable") || *view == "one_unbounded");
    let mut verdict = "\nCREATE TEMPORARY VIEW verdict AS\n".to_owned();
    for (i, test) in tests.enumerate() {
        let also = if i == 0 { "" } else { "UNION ALL " };
        let _ = writeln!(verdict, "{also}SELECT '{test}' AS test, count(*) AS violations FROM {test}");
    }
    // Failing tests come first: some engines print only the beginning.
    verdict + ";\n\nSELECT * FROM verdict ORDER BY violations DESC, test;\n"
}
