//! `twinedge postgis`: the commands with which `psql` writes a topology.

use crate::output::{Failure, Verdict, print_answer};
use twinedge_postgis::sql;

/// Print what `psql` needs to write a topology of PostGIS for `twinedge audit --postgis`.
///
/// The commands copy nodes, faces and edges as they are, in one transaction that reads only, on one snapshot. They need the right to
/// SELECT from the three tables, and run on replicas. `psql` connects, so passwords and certificates stay where they are.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge postgis --sql city_data | psql -X mydatabase | twinedge audit --postgis -
  twinedge postgis --sql city_data | psql -X -h db.example.org -U reader mydatabase > city.copy
  twinedge audit --postgis city.copy --format json | jq '.violations[].message'

Exit status: 0 the commands were printed; 2 the command was misused.")]
pub(crate) struct Postgis {
    /// The topology: the schema with its tables `node`, `face` and `edge_data`.
    #[arg(long, value_name = "NAME")]
    sql: String,
}

impl Postgis {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        print_answer(&sql(&self.sql))?;
        Ok(Verdict::Sound)
    }
}
