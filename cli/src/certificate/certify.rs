//! `twinedge certify`: a certificate is written.

use super::check::{certified, lines};
use super::folder::Folder;
use super::notes::Notes;
use super::sql::{self, Engine};
use crate::input::MapFile;
use crate::output::{counted, print};
use crate::progress::busy;
use crate::status::{Failure, Verdict};
use std::io::BufRead;
use std::path::PathBuf;
use twinedge::map::certificate;
use twinedge::validate::certificate::{Certificate, Drawing, Labels, check_drawing};
use twinedge::validate::{Table, View};

/// Write a certificate: labels by which anyone can check that a map is a planar subdivision, and drawn without crossings.
///
/// `twinedge check` checks it, and so does a program that is proved in Coq: `proofs/coq/certified`. Neither has to trust what wrote
/// it.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge certify parcels.geojson -o parcels.cert
  twinedge certify world.geojson --snap auto -o world.cert        coordinates in decimals lie on a grid once they are snapped
  twinedge certify parcels.geojson --topology-only -o parcels.cert
  twinedge certify parcels.geojson --sql duckdb -o parcels.cert
  twinedge certify --table map.txt -o map.cert                    a table as `twinedge audit` reads it: the first one

Exit status: 0 the certificate is written; 1 the input is not valid, and the tests that would fail are printed; 2 it could not be \
read, or has no certificate.")]
pub(crate) struct Certify {
    #[command(flatten)]
    map: MapFile,

    /// Folder to write.
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,

    /// Leave the coordinates out: the certificate says that the structure is that of a planar subdivision.
    #[arg(long)]
    topology_only: bool,

    /// Write tables, too, and `check.sql`, which has each test as a query in this dialect. Tables are in Parquet, or in CSV
    /// for `PostgreSQL`.
    #[arg(long, value_name = "ENGINE", value_enum)]
    sql: Option<Engine>,

    /// The input is a table, and has no coordinates.
    #[arg(long, conflicts_with_all = ["layer", "snap"])]
    table: bool,
}

impl Certify {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        if self.table {
            let (name, table) = self.read_table()?;
            return self.certify(&name, &table, None);
        }
        let imported = self.map.build()?;
        let (name, map) = (imported.name, imported.map);
        if self.topology_only {
            return self.certify(&name, &map, None);
        }
        let remedy = "`twinedge audit` says what is wrong, --snap auto puts the map on a grid, --topology-only leaves coordinates out";
        let drawing = busy("triangulating the map", || certificate::draw(&map));
        let drawing = drawing.map_err(|error| Failure(format!("{name}: {error}; {remedy}")))?;
        self.certify(&name, &map, Some(drawing))
    }

    /// Makes the labels, checks the certificate, and writes it.
    fn certify(&self, name: &str, view: &dyn View, drawing: Option<Drawing>) -> Result<Verdict, Failure> {
        let labels = Labels::new(view).map_err(|error| Failure(format!("{name}: {error}")))?;
        let certificate = Certificate::new(view, &labels).map_err(|error| Failure(format!("{name}: {error}")))?;
        let checked = match &drawing {
            Some(drawing) => check_drawing(&certificate, certificate.columns(), drawing),
            None => certificate.check(),
        };
        if let Err(failures) = checked {
            print(&format!("{name}: not valid, nothing is written\n{}", lines(&failures)))?;
            return Ok(Verdict::Wrong);
        }
        let counts = [
            counted((0..view.vertex_slots()).filter(|v| view.is_vertex(*v)).count(), "vertex"),
            counted((0..view.half_edge_slots()).filter(|h| view.is_half_edge(*h)).count(), "half-edge"),
            counted((0..certificate.face_slots()).filter(|f| certificate.is_face(*f)).count(), "face"),
        ]
        .join(", ");
        let exponent = drawing.as_ref().map(|drawing| drawing.exponent);
        let notes = Notes::new(name, self.map.sha256()?, &counts, exponent);
        let claim = certified(drawing.is_some());
        let folder = Folder { certificate, drawing };
        folder.write(&self.output, &notes)?;
        if let Some(engine) = self.sql {
            sql::write(&self.output, &folder, &notes, engine)?;
        }
        print(&format!("{}: certificate that {name} is {claim}: {counts}\n", self.output.display()))?;
        Ok(Verdict::Sound)
    }

    /// The first table of a file.
    fn read_table(&self) -> Result<(String, Table), Failure> {
        let input = self.map.open()?;
        for line in input.reader.lines() {
            let line = line.map_err(|error| Failure(format!("{}: {error}", input.name)))?;
            let text = line.trim();
            if !text.is_empty() && !text.starts_with('#') {
                // A verdict may follow the table.
                let text = text.split_once('=').map_or(text, |(table, _)| table);
                let table = text.trim().parse().map_err(|error| Failure(format!("{}: {error}", input.name)))?;
                return Ok((input.name, table));
            }
        }
        Err(Failure(format!("{}: no table", input.name)))
    }
}
