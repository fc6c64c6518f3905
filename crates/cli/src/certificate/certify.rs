//! `twinedge certify` writes a certificate.

use super::check::lines;
use super::folder::{Claim, Folder, Notes};
use super::output;
use super::source::{self, LIST, Source};
use super::sql::Engine;
use crate::input::MapFile;
use crate::output::{Failure, Verdict, counted, named, print};
use crate::progress::busy;
use std::path::PathBuf;
use twinedge::validate::{Collect, Expectation, View, validate};
use twinedge_certificate::{Certificate, Drawing, Labels, LabelsError, SurfaceCertificate, check};
use twinedge_map::certificate;
use twinedge_map::certificate::DrawingError;
use twinedge_report::{Input, InputKind, Keep};

/// Write a certificate: labels by which anyone can check that a map is a planar subdivision, and drawn without crossings; or that a mesh is a
/// surface.
///
/// It takes what `twinedge audit` takes, but the arcs of TopoJSON: maps, meshes, topologies of PostGIS, and tables. `twinedge check`
/// checks it, and so does a program that is proved in Coq: `proofs/coq/certified`. Neither has to trust what wrote it.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge certify parcels.geojson -o parcels.cert
  twinedge certify world.geojson --snap auto -o world.cert        coordinates in decimals lie on a grid once they are snapped
  twinedge certify parcels.geojson --topology-only -o parcels.cert
  twinedge certify parcels.geojson --sql duckdb -o parcels.cert
  twinedge certify bunny.obj -o bunny.cert                        a mesh: its genus, components and holes
  twinedge postgis --sql city_data | psql -X mydatabase | twinedge certify --postgis - -o city.cert
  twinedge certify --table map.txt -o map.cert                    a table as `twinedge audit` reads it: the first one

Exit status: 0 the certificate is written; 1 the input is not valid, and the tests that fail and what is wrong are printed; 2 it could not be \
read, or has no certificate.")]
pub(crate) struct Certify {
    #[command(flatten)]
    map: MapFile,

    /// Folder to write. A certificate that is there is replaced, with all its files; a folder with other files is refused.
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,

    /// Leave the coordinates out: the certificate says that the structure is a planar subdivision. Only maps have them in their
    /// certificates.
    #[arg(long)]
    topology_only: bool,

    /// Write tables, too, and `check.sql`, which has each test as a query in this dialect. Tables are in Parquet, or in CSV
    /// for `PostgreSQL`.
    #[arg(long, value_name = "ENGINE", value_enum)]
    sql: Option<Engine>,

    /// The input is a topology of PostGIS, as `psql` writes it after `twinedge postgis --sql NAME`. (It is also recognised without this;
    /// with it nothing else is accepted.)
    #[arg(long, conflicts_with_all = ["layer", "snap", "table"])]
    postgis: bool,

    /// The input is a table, and has no coordinates. (It is also recognised without this.)
    #[arg(long, conflicts_with_all = ["layer", "snap"])]
    table: bool,
}

impl Certify {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let mut input = self.map.open()?;
        let name = input.name.clone();
        let kind = if self.table {
            InputKind::Tables
        } else {
            InputKind::of(self.postgis, false, &mut input).map_err(named(&name))?
        };
        if matches!(kind, InputKind::Map) {
            return self.certify_map(input);
        }
        if self.map.options.snap.is_some() {
            return Err(Failure(format!("{name}: --snap is for maps, and this is {}", kind.words())));
        }
        source::read(input, kind, &|source| match source {
            Source::Plane(view) => self.certify_plane(&name, view, None),
            Source::Surface(view) => self.certify_surface(&name, view),
            Source::Wrong(lines) => refuse(&name, &lines),
        })
    }

    fn certify_map(&self, input: Input) -> Result<Verdict, Failure> {
        let imported = self.map.build_from(input, Keep::default())?;
        let (name, map) = (imported.name, imported.map);
        if self.topology_only {
            return self.certify_plane(&name, &map, None);
        }
        let drawing = busy(|stage| {
            stage("triangulating the map");
            certificate::draw(&map)
        });
        let drawing = drawing.map_err(|error| Failure(format!("{name}: {error}; {}", remedy(error))))?;
        self.certify_plane(&name, &map, Some(drawing))
    }

    fn certify_plane(&self, name: &str, view: &dyn View, drawing: Option<Drawing>) -> Result<Verdict, Failure> {
        let labels = Labels::new(view).map_err(|error| no_labels(name, error))?;
        if let Err(failures) = check(view, &labels) {
            let report = validate(view, &Expectation::plane(), Collect::AtMost(LIST));
            let violations = report.violations().iter().map(|violation| format!("{violation}\n"));
            return refuse(name, &(lines(&failures) + &violations.collect::<String>()));
        }
        let certificate = Certificate::new(view, &labels).map_err(|error| no_labels(name, error))?;
        let counts = [
            counted((0..view.vertex_slots()).filter(|v| view.is_vertex(*v)).count(), "vertex"),
            counted((0..view.half_edge_slots()).filter(|h| view.is_half_edge(*h)).count(), "half-edge"),
            counted((0..certificate.face_slots()).filter(|f| certificate.is_face(*f)).count(), "face"),
        ]
        .join(", ");
        let exponent = drawing.as_ref().map(|drawing| drawing.exponent);
        self.write(name, &Claim::Plane(Box::new(Folder { certificate, drawing })), &counts, exponent)
    }

    fn certify_surface(&self, name: &str, view: &dyn View) -> Result<Verdict, Failure> {
        let certificate = SurfaceCertificate::new(view).map_err(|error| no_labels(name, error))?;
        let counts = certificate.check().map_or_else(
            |_| String::new(),
            |counts| {
                let numbers = [(counts.vertices, "vertex"), (counts.edges, "edge"), (counts.faces, "face")];
                numbers.map(|(count, name)| counted(count, name)).join(", ")
            },
        );
        self.write(name, &Claim::Surface(Box::new(certificate)), &counts, None)
    }

    /// Checks the certificate, and writes it if it is valid.
    fn write(&self, name: &str, claim: &Claim, counts: &str, exponent: Option<i32>) -> Result<Verdict, Failure> {
        let words = match claim.check() {
            Ok(words) => words,
            Err(failures) => return refuse(name, &lines(&failures)),
        };
        let notes = Notes::new(name, self.map.judged()?.map(|judged| judged.sha256), counts, exponent);
        output::write(&self.output, claim, &notes, self.sql)?;
        print(&format!("{}: certificate that {name} is {words}: {counts}\n", self.output.display()))?;
        Ok(Verdict::Sound)
    }
}

const fn remedy(error: DrawingError) -> &'static str {
    match error {
        DrawingError::NoGrid => {
            "--snap auto rounds them to the finest grid that they allow, and --topology-only leaves them out of the certificate"
        }
        DrawingError::NotPlane => "`twinedge audit` says where, and --snap auto cuts edges where they meet",
        _ => "--topology-only leaves coordinates out of the certificate",
    }
}

fn no_labels(name: &str, error: LabelsError) -> Failure {
    Failure(format!("{name}: {error}"))
}

/// Prints an input's findings line by line.
fn refuse(name: &str, lines: &str) -> Result<Verdict, Failure> {
    print(&format!("{name}: not valid, nothing is written\n{lines}"))?;
    Ok(Verdict::Wrong)
}
