//! `twinedge audit`: builds a map and validates it, or validates a mesh, a file of tables or a topology of PostGIS.

mod audited;
mod destination;
mod document;
mod findings_geojson;
mod map_document;
mod map_json;
mod map_text;
mod mesh_file;
mod packed;
mod page;
mod remedies;
mod table_file;
mod textbook;
mod topology_file;
mod write;

use crate::coverage::{Asked, Coverage, SHOWN};
use crate::input::MapFile;
use crate::noted::Keep;
use crate::progress::busy;
use crate::status::{Failure, Verdict};
use crate::units::Units;
use audited::Audited;
use destination::ReportFormat;
use map_json::Json;
use map_text::Shown;
use std::time::Instant;
use twinedge::validate::{Collect, Expectation, validate_embedding};
use twinedge_formats::postgis::is_copy;

/// Check a map (GeoJSON, TopoJSON, WKT, WKB, Shapefile, GeoPackage, FlatGeobuf) or a mesh (OBJ, OFF, PLY, STL) for everything that can be wrong.
///
/// Of a map the planar subdivision is built, and every rule is checked on it.
///
/// The three tables of a textbook, of vertices, faces and half-edges, are read as the book prints them and audited by their names.
///
/// A mesh file (OBJ, OFF, PLY, STL) is joined to half-edges along shared edges. What cannot be joined is reported by its faces
/// and vertices, and the options under "Meshes" say what else must hold.
///
/// A topology of PostGIS is judged by the links that the database keeps, and named by its ids. `twinedge postgis` prints what `psql`
/// needs to write it.
///
/// The arcs of TopoJSON are edges that polygons share. `--arcs` judges them as they are, and names them by their numbers.
///
/// A file of tables is judged line by line instead. `twinedge tables --print` and `twinedge corrupt --print` write such files.
/// Each line is one structure as plain tables, in the text form of `twinedge::validate::Table`; a verdict may follow, `= ok` or
/// the first broken rule, as in `= R1`, and is compared with that of the validator. The line `# expect: plane without prev`, or
/// `# expect: surface open asking closed genus 0 sides 3`, says what the tables below it are held to; other lines that begin with `#` are comments.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge audit                          the built-in map of the world
  twinedge audit parcels.geojson
  twinedge audit --snap auto drawn-by-hand.geojson
  twinedge audit --format json - < parcels.geojson | jq .valid
  twinedge audit parcels.geojson -o findings.geojson     what was found as a layer, for QGIS
  twinedge audit counties.shp -o report.html             the map and what was found, for a browser
  twinedge audit bunny.obj --closed --genus 0 --triangles
  twinedge audit --arcs counties.topojson --layer counties
  twinedge postgis --sql city_data | psql -X mydatabase | twinedge audit --postgis -
  twinedge tables --half-edges 2 --print | twinedge audit -
  twinedge audit examples/tables/five_faces.txt

Exit status: 0 the map or mesh is valid, or all tables are valid and all verdicts agree; 1 something is invalid (a file of tables that are wrong on purpose, even if its verdicts agree), or a verdict differs; 2 the input could not be read.")]
pub(crate) struct Audit {
    #[command(flatten)]
    map: MapFile,

    #[command(flatten)]
    destination: destination::Arguments,

    /// Greatest number of violations to list, and of findings of each rule C1 … C6; all are counted. Default: 1000, and in the text 3
    /// findings of each of C1 … C6.
    #[arg(long, value_name = "N")]
    list: Option<usize>,

    /// Say of each kind of violation or finding what usually causes it and what mends it. In JSON these are the keys `cause` and
    /// `remedy`.
    #[arg(long)]
    explain: bool,

    /// The input is a topology of PostGIS, as `psql` writes it after `twinedge postgis --sql NAME`. (It is recognised without this, too;
    /// with it nothing else is accepted.)
    #[arg(long)]
    postgis: bool,

    /// Judge the arcs of TopoJSON as they are shared, instead of the map that the features draw: that they join, that each side of an
    /// arc has one polygon at most, that they meet at their ends only, and that polygons lie where their arcs lead around.
    #[arg(long, conflicts_with = "postgis")]
    arcs: bool,

    #[command(flatten)]
    coverage: Asked,

    #[command(flatten)]
    mesh: mesh_file::Expected,
}

impl Audit {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
        let list = self.list.unwrap_or(Collect::DEFAULT_CAP);
        let mut input = self.map.open()?;
        let to = self.destination.destination(self.map.path());
        if self.postgis || is_copy(input.beginning()?) {
            self.map.refuse_snap(&input.name, "a topology of PostGIS")?;
            self.refuse_mesh_options(&input.name)?;
            return topology_file::audit_postgis(input, list, self.explain, to);
        }
        if self.arcs {
            self.map.refuse_snap(&input.name, "audited arc by arc")?;
            self.refuse_coverage(&input.name, "audited arc by arc")?;
            self.refuse_mesh_options(&input.name)?;
            return topology_file::audit_arcs(input, self.map.layer(), list, self.explain, to);
        }
        if textbook::is_textbook(input.beginning()?) {
            self.refuse_coverage(&input.name, "a textbook's tables")?;
            return textbook::audit(&input.name, input.reader, list, self.explain, to);
        }
        if table_file::is_table_file(input.beginning()?) {
            self.map.refuse_snap(&input.name, "a file of tables")?;
            self.refuse_coverage(&input.name, "a file of tables")?;
            self.refuse_mesh_options(&input.name)?;
            return table_file::audit(&input.name, input.reader, list, self.explain, to);
        }
        if let Some(format) = input.mesh_format()? {
            self.map.refuse_snap(&input.name, "a mesh")?;
            self.refuse_coverage(&input.name, "a mesh")?;
            return mesh_file::audit(input, format, self.mesh.expectation(), list, self.explain, to);
        }
        self.refuse_mesh_options(&input.name)?;
        let imported = self.map.build_from(input, Keep { coverage: true, condition: None })?;
        let map = &imported.map;
        let report = busy("validating", || validate_embedding(map, &Expectation::plane(), Collect::AtMost(list)));
        let units = Units::Plane { degrees: imported.noted.look_like_degrees(&imported.read) };
        let mut coverage = Coverage::new(&imported, &self.coverage, &units, list);
        if self.explain {
            coverage.explain();
        }
        let elapsed = start.elapsed().as_secs_f64() * 1000.0;
        let of_coverage = if self.coverage.is_rule() { coverage.total() } else { 0 };
        // What cannot be checked is not known to hold.
        let is_valid =
            report.is_valid() && of_coverage == 0 && (!self.coverage.is_rule() || coverage.not_checked().is_none());
        let is_coverage_rule = self.coverage.is_rule();
        let audited = Audited { imported: &imported, report: &report, coverage, is_coverage_rule, is_valid, elapsed };
        match to.format {
            ReportFormat::Text => {
                let worst = self.list.unwrap_or(SHOWN);
                let shown = Shown { coverage: &self.coverage, worst, explain: self.explain };
                to.text(&shown.text(&audited)?)?;
            }
            ReportFormat::Json => to.json(&Json::new(audited, self.explain))?,
            ReportFormat::Geojson | ReportFormat::Html => {
                let document = map_document::document(&audited, self.explain);
                write::write(&document, &to, || map_document::packed(&audited, &document))?;
            }
        }
        Ok(if is_valid { Verdict::Sound } else { Verdict::Wrong })
    }

    /// Refuses the options about coverages for what is no map.
    fn refuse_coverage(&self, name: &str, what: &str) -> Result<(), Failure> {
        if self.coverage.is_any() {
            return Err(Failure(format!(
                "{name}: --coverage, --gap-width and --sliver are for maps, and this is {what}"
            )));
        }
        Ok(())
    }

    fn refuse_mesh_options(&self, name: &str) -> Result<(), Failure> {
        if self.mesh.is_any() {
            let why = "is no mesh file (OBJ, OFF, PLY, STL), and the options say what a mesh must be";
            return Err(Failure(format!("{name}: {why}")));
        }
        Ok(())
    }
}
