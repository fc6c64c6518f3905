//! The arguments of `twinedge audit`.

use super::report::Report;
use crate::input::MapFile;
use std::path::PathBuf;
use twinedge_osm::TagFilter;
use twinedge_report::{Accepted, CoverageOptions, Edges, Measured, MeshOptions, Options, ParentColumn, positive};

/// Check a map (GeoJSON, TopoJSON, WKT, WKB, Shapefile, GeoPackage, GeoParquet, FlatGeobuf) or a mesh (OBJ, OFF, PLY, STL) for everything that can be wrong.
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
/// A file of tables is judged line by line instead. `twinedge-trials tables --print` and `twinedge-trials corrupt --print` write such files.
/// Each line is one structure as plain tables, in the text form of `twinedge::validate::Table`; a verdict may follow, `= ok` or
/// the first broken rule, as in `= R1`, and is compared with the validator's. The line `# expect: plane without prev`, or
/// `# expect: surface open asking closed genus 0 sides 3`, is the expectation of the tables below it; other lines that begin with `#` are comments.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge audit                          the built-in map of the world
  twinedge audit parcels.geojson
  twinedge audit --snap auto drawn-by-hand.geojson
  twinedge audit --format json - < parcels.geojson | jq .valid
  twinedge audit parcels.geojson -o findings.geojson     what was found as a layer, for QGIS
  twinedge audit counties.shp -o report.html             the map and what was found, for a browser
  twinedge audit countries.geojson --edges geodesic       borders as great circles, as geography types have them
  twinedge audit counties.shp --against states.shp --parent-column STATE
  twinedge audit bunny.obj --closed --genus 0 --triangles
  twinedge audit --arcs counties.topojson --layer counties
  twinedge audit luxembourg.osm.pbf --boundaries boundary=administrative,admin_level=6
  twinedge postgis --sql city_data | psql -X mydatabase | twinedge audit --postgis -
  twinedge-trials tables --half-edges 2 --print | twinedge audit -
  twinedge audit examples/tables/five_faces.txt

Exit status: 0 the map or mesh is valid, or all tables are valid and all verdicts agree; 1 something is invalid (a file of tables that are wrong on purpose, even if its verdicts agree), or a verdict differs; 2 the input could not be read.")]
pub(crate) struct Audit {
    #[command(flatten)]
    pub(super) map: MapFile,

    #[command(flatten)]
    pub(super) report: Report,

    /// Give up after this number of seconds: the verdict is then `unknown`, and the exit status 1. The report says so; a layer or a page is
    /// not written.
    #[arg(long, value_name = "SECONDS", value_parser = positive)]
    pub(super) timeout: Option<f64>,

    /// The input is a topology of PostGIS, as `psql` writes it after `twinedge postgis --sql NAME`. (It is also recognised without this;
    /// with it nothing else is accepted.)
    #[arg(long)]
    pub(super) postgis: bool,

    /// Judge the arcs of TopoJSON as they are shared, instead of the map that the features draw: that they join, that each side of an
    /// arc has one polygon at most, that they meet at their ends only, and that polygons lie where their arcs lead around.
    #[arg(long, conflicts_with = "postgis")]
    pub(super) arcs: bool,

    /// The input is a file of `OpenStreetMap`, .osm.pbf: judge the boundaries with these tags, KEY=VALUE or KEY, separated by commas, as a coverage. Their
    /// relations are judged, too (O1 … O5): ways or nodes that are missing, rings that are open, ways that are members twice, two relations on the
    /// same side of a way, wrong roles.
    #[arg(long, value_name = "TAGS", conflicts_with_all = ["tiles", "memory", "arcs", "postgis", "against", "parent_column"])]
    pub(super) boundaries: Option<TagFilter>,

    /// Cut the map into N by N tiles, judge each alone, and merge the results: the same report, but violations do not name records.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub(super) tiles: Option<u32>,

    /// Judge the map by another layer, too (X1 … X6): each feature lies within one of the other layer, both cover the same places, the
    /// borders of the other layer run along borders of this one, lines run along its borders, and points lie inside its features. `--snap`
    /// applies to both layers together; without it, borders that cross or touch are cut on the finest grid.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["tiles", "memory", "arcs", "postgis"])]
    pub(super) against: Option<PathBuf>,

    /// The layer to read of the file of --against, if it has several.
    #[arg(long, value_name = "NAME", requires = "against")]
    pub(super) against_layer: Option<String>,

    /// Parts make up their parents exactly (X4): this column names the parent of each part. Parents are the features of --against, or
    /// of the map itself where levels are in one file. They are known by their column KEY; without it by the column of the same name in the other
    /// layer, or else by their ids, or else by their names.
    #[arg(long, value_name = "COLUMN[=KEY]", conflicts_with_all = ["tiles", "memory"])]
    pub(super) parent_column: Option<ParentColumn>,

    /// Judge a map that is larger than memory, by tiles: as many as it takes to judge each within SIZE, as 800M or 2G. `FlatGeobuf` with an index and
    /// `GeoParquet` with boxes are read tile by tile. Other files are copied into the folder for temporary files (TMPDIR). Names and ids of features, and what
    /// tiles found, come on top.
    #[arg(long, value_name = "SIZE", value_parser = crate::input::size, conflicts_with = "tiles")]
    pub(super) memory: Option<u64>,

    /// The shape of edges between longitudes and latitudes: straight on the map, or arcs of great circles, the shortest ways on a sphere. Then
    /// limits, lengths and areas are in metres and square metres, antimeridian and poles are places like others, a polygon is on the smaller side of its
    /// rings, and C6 is not asked. Default: geodesic, if a GeoParquet file says that its edges are not planar; else straight.
    #[arg(long, value_enum, value_name = "SHAPE")]
    pub(super) edges: Option<Edges>,

    #[command(flatten)]
    pub(super) coverage: CoverageOptions,

    #[command(flatten)]
    pub(super) measured: Measured,

    #[command(flatten)]
    pub(super) mesh: MeshOptions,
}

impl Audit {
    pub(super) fn options(&self, accepted: Option<Accepted>) -> Options {
        let options = Options {
            parent_column: self.parent_column.clone(),
            map: self.map.options.clone(),
            coverage: self.coverage.clone(),
            measured: self.measured,
            edges: self.edges,
            mesh: self.mesh.clone(),
            ..Options::default()
        };
        self.report.options(accepted, options)
    }
}
