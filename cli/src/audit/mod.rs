//! `twinedge audit`: builds a map and validates it, or validates a mesh, a file of tables or a topology of PostGIS.

mod mesh_file;
mod table_file;
mod textbook;
mod topology_file;

use crate::coverage::{Asked, Coverage};
use crate::input::{Imported, MapFile};
use crate::noted::Keep;
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, counted, grouped, plain, print, print_json};
use crate::query::label;
use crate::status::{Failure, Verdict};
use crate::units::Units;
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::time::Instant;
use twinedge::dcel::{Boundary, Face, Vertex};
use twinedge::geometry::noding;
use twinedge::io::ReadSummary;
use twinedge::map::{BuildSummary, Irregularity, IrregularityKind, PlanarMap, Position};
use twinedge::validate::{
    Bounds, Collect, Counts, Described, Expectation, REPORT_SCHEMA, Record, Report, Rule, RuleOutcome, Violation,
};
use twinedge::validate::{places, validate_embedding};
use twinedge_formats::postgis::is_copy;

/// Check a map (GeoJSON, WKT) or a mesh (OBJ, OFF, PLY, STL) for everything that can be wrong.
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
  twinedge audit bunny.obj --closed --genus 0 --triangles
  twinedge postgis --sql city_data | psql -X mydatabase | twinedge audit --postgis -
  twinedge tables --half-edges 2 --print | twinedge audit -
  twinedge audit examples/tables/five_faces.txt

Exit status: 0 the map or mesh is valid, or all tables are valid and all verdicts agree; 1 something is invalid (a file of tables that are wrong on purpose, even if its verdicts agree), or a verdict differs; 2 the input could not be read.")]
pub(crate) struct Audit {
    #[command(flatten)]
    map: MapFile,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,

    /// Greatest number of violations to list; all are counted.
    #[arg(long, value_name = "N", default_value_t = Collect::DEFAULT_CAP)]
    list: usize,

    /// Say of each kind of violation or finding what usually causes it and what mends it. In JSON these are the keys `cause` and
    /// `remedy`.
    #[arg(long)]
    explain: bool,

    /// The input is a topology of PostGIS, as `psql` writes it after `twinedge postgis --sql NAME`. (It is recognised without this, too;
    /// with it nothing else is accepted.)
    #[arg(long)]
    postgis: bool,

    #[command(flatten)]
    coverage: Asked,

    #[command(flatten)]
    mesh: mesh_file::Expected,
}

impl Audit {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
        let mut input = self.map.open()?;
        if self.postgis || is_copy(input.beginning()?) {
            self.map.refuse_snap(&input.name, "a topology of PostGIS")?;
            self.refuse_mesh_options(&input.name)?;
            return topology_file::audit(input, self.list, self.explain, self.format);
        }
        if textbook::is_textbook(input.beginning()?) {
            self.refuse_coverage(&input.name, "a textbook's tables")?;
            return textbook::audit(&input.name, input.reader, self.list, self.format);
        }
        if table_file::is_table_file(input.beginning()?) {
            self.map.refuse_snap(&input.name, "a file of tables")?;
            self.refuse_coverage(&input.name, "a file of tables")?;
            self.refuse_mesh_options(&input.name)?;
            return table_file::audit(&input.name, input.reader, self.list, self.explain, self.format);
        }
        if let Some(format) = input.mesh_format()? {
            self.map.refuse_snap(&input.name, "a mesh")?;
            self.refuse_coverage(&input.name, "a mesh")?;
            return mesh_file::audit(input, format, self.mesh.expectation(), self.list, self.explain, self.format);
        }
        self.refuse_mesh_options(&input.name)?;
        let imported = self.map.build_from(input, Keep { coverage: true, condition: None })?;
        let map = &imported.map;
        let report = validate_embedding(map, &Expectation::plane(), Collect::AtMost(self.list));
        let units = Units::Plane { degrees: imported.noted.look_like_degrees(&imported.read) };
        let coverage = Coverage::new(&imported, &self.coverage, &units, self.list);
        let elapsed = start.elapsed().as_secs_f64() * 1000.0;
        let of_coverage = if self.coverage.is_rule() { coverage.total() } else { 0 };
        // What cannot be checked is not known to hold.
        let is_valid =
            report.is_valid() && of_coverage == 0 && (!self.coverage.is_rule() || coverage.not_checked().is_none());
        let audited = Audited { imported: &imported, report: &report, coverage, is_valid, elapsed };
        match self.format {
            Format::Text => print(&self.text(&audited)?)?,
            Format::Json => print_json(&Json::new(audited, self.explain))?,
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

/// A map, audited.
struct Audited<'a> {
    imported: &'a Imported,
    report: &'a Report,
    coverage: Coverage,
    is_valid: bool,
    elapsed: f64,
}

/// The names of the features that a violation touches; numbers, counted from 0, for those without name.
fn features(map: &PlanarMap, violation: &Violation) -> Vec<String> {
    let dcel = map.dcel();
    let mut found = BTreeSet::new();
    for record in violation.records().into_iter().flatten() {
        let half_edges: Vec<_> = match record {
            Record::HalfEdge(h) => dcel.half_edge_at(h).into_iter().collect(),
            Record::Vertex(v) => dcel.vertex_at(v).into_iter().flat_map(Vertex::rotation).collect(),
            Record::Boundary(b) => dcel.boundary_at(b).and_then(Boundary::start).into_iter().collect(),
            Record::Face(f) => {
                let face = dcel.face_at(f).map(Face::key);
                found.extend(face.and_then(|f| map.features_of(f).ok()).into_iter().flatten());
                Vec::new()
            }
        };
        for h in half_edges {
            found.extend(map.features_along(h.key()).into_iter().flatten());
        }
    }
    found.into_iter().map(|feature| label(map, feature)).collect()
}

impl Audit {
    fn text(&self, audited: &Audited<'_>) -> Result<String, std::fmt::Error> {
        let Audited { imported, report, coverage, .. } = audited;
        let Imported { name, read, map, noted, .. } = imported;
        let explain = self.explain;
        let mut out = String::new();
        writeln!(out, "{name}")?;
        writeln!(out, "{QUIET}{}{QUIET:#}", input_line(map.summary()))?;
        if let Some(dropped) = dropped_line(read) {
            writeln!(out, "{QUIET}{dropped}{QUIET:#}")?;
        }
        if let Some(noding) = map.noding() {
            writeln!(out, "{QUIET}{}{QUIET:#}", noding_line(noding))?;
        }
        for warning in noted.warnings(read) {
            writeln!(out, "{BAD}warning{BAD:#}: {warning}")?;
        }
        out.push_str(&irregularities(map));
        out.push('\n');
        let counts = report.counts();
        let or_unknown = |n: Option<usize>| n.map_or_else(|| "unknown".to_owned(), grouped);
        for (what, count) in [
            ("vertices (V)", grouped(counts.vertices)),
            ("edges (E)", grouped(counts.edges)),
            ("half-edges", grouped(counts.half_edges)),
            ("faces (F), the unbounded one included", grouped(counts.faces)),
            ("components (C)", or_unknown(counts.components)),
            ("outer boundary components", grouped(counts.outer_boundaries)),
            ("inner boundary components", grouped(counts.inner_boundaries)),
            ("isolated vertices", grouped(counts.isolated_vertices)),
            ("genus", or_unknown(counts.genus)),
        ] {
            writeln!(out, "  {what:38} {count:>12}")?;
        }
        out.push('\n');
        for (rule, outcome) in report.outcomes() {
            write!(out, "  {:2}  {:10} ", rule.id(), rule.name())?;
            match (outcome.violations, outcome.unchecked) {
                (0, None) => {
                    write!(out, "{GOOD}ok{GOOD:#}      {} {}", grouped(outcome.checked), rule.unit(outcome.checked))?;
                }
                (0, Some(why)) => write!(out, "{QUIET}not checked: {why}{QUIET:#}")?,
                (n, _) => {
                    let of = grouped(outcome.checked);
                    write!(
                        out,
                        "{BAD}BROKEN{BAD:#}  {} in {of} {}",
                        counted(n as usize, "violation"),
                        rule.unit(outcome.checked)
                    )?;
                }
            }
            out.push('\n');
        }
        if coverage.has_polygons() {
            out.push('\n');
            coverage.write_rules(&mut out, &self.coverage)?;
        }
        out.push('\n');
        for violation in report.violations() {
            writeln!(out, "{BAD}{}{BAD:#} {violation}", violation.rule())?;
            let at: Vec<_> = places(map, violation).iter().map(|p| format!("({}, {})", p.x, p.y)).collect();
            if !at.is_empty() {
                writeln!(out, "   at {}", at.join(" "))?;
            }
            let features = features(map, violation);
            if !features.is_empty() {
                writeln!(out, "   on the border of {}", features.join(", "))?;
            }
        }
        let more = report.violation_count().saturating_sub(report.violations().len() as u64);
        if more > 0 {
            writeln!(out, "… and {} more; see --list", grouped(more))?;
        }
        if explain {
            let mut kinds = BTreeSet::new();
            for violation in report.violations().iter().filter(|violation| kinds.insert(violation.kind())) {
                writeln!(
                    out,
                    "{}: usual cause: {}; remedy: {}",
                    violation.rule(),
                    violation.cause(),
                    violation.remedy()
                )?;
            }
        }
        if coverage.has_polygons() {
            coverage.write_worst(&mut out, self.list)?;
        }
        self.write_verdict(&mut out, audited)?;
        Ok(out)
    }

    /// The last line: whether the map is valid.
    fn write_verdict(&self, out: &mut String, audited: &Audited<'_>) -> std::fmt::Result {
        let Audited { report, coverage, is_valid, elapsed, .. } = audited;
        let found = coverage.total();
        if *is_valid {
            let beside = match found {
                0 => String::new(),
                n => format!("; C1 to C6 have {}, which --coverage counts as violations", counted(n, "finding")),
            };
            return writeln!(out, "{GOOD}valid{GOOD:#}: every rule that applies holds{beside} ({elapsed:.0} ms)");
        }
        let of_coverage = if self.coverage.is_rule() { found } else { 0 };
        let all = counted(report.violation_count() as usize + of_coverage, "violation");
        let is_unknown = self.coverage.is_rule() && coverage.not_checked().is_some();
        let beside = if is_unknown { ", and C1 to C5 could not be checked" } else { "" };
        writeln!(out, "{BAD}not valid{BAD:#}: {all}{beside} ({elapsed:.0} ms)")
    }
}

/// What the reader dropped, except for properties, which every file has.
fn dropped_line(read: &ReadSummary) -> Option<String> {
    let mut dropped = Vec::new();
    if read.with_extra_dimensions > 0 {
        dropped.push(format!("the dimensions beyond x and y of {}", counted(read.with_extra_dimensions, "position")));
    }
    if read.dropped_empty > 0 {
        dropped.push(counted(read.dropped_empty, "empty shape"));
    }
    (!dropped.is_empty()).then(|| format!("dropped: {}", dropped.join(", ")))
}

fn input_line(summary: &BuildSummary) -> String {
    let (features, segments) = (summary.features, summary.segments);
    let mut line = format!("{}, {}", counted(features, "feature"), counted(segments, "segment"));
    for (count, what) in [
        (summary.duplicate_segments, "repeated and merged"),
        (summary.zero_length_segments, "of zero length and dropped"),
        (summary.open_rings, "added to close open rings"),
    ] {
        if count > 0 {
            let _ = write!(line, ", {} {what}", grouped(count));
        }
    }
    let mut mark = ';';
    for (count, one, several) in [
        (summary.degenerate_rings, "ring encloses nothing", "rings enclose nothing"),
        (summary.rings_wound_wrongly, "ring is wound the wrong way", "rings are wound the wrong way"),
        (summary.self_touching_rings, "ring touches itself", "rings touch themselves"),
        (summary.spikes, "spike", "spikes"),
    ] {
        if count > 0 {
            let what = if count == 1 { one } else { several };
            let _ = write!(line, "{mark} {} {what}", grouped(count));
            mark = ',';
        }
    }
    line
}

/// How many irregularities of each kind the text shows. Rings wound the wrong way are not shown: usually all or none are.
const SHOWN: usize = 3;

fn irregularities(map: &PlanarMap) -> String {
    let mut out = String::new();
    let found = &map.summary().irregularities;
    let kinds: BTreeSet<_> =
        found.iter().map(|one| one.kind).filter(|kind| *kind != IrregularityKind::WoundWrongly).collect();
    for kind in kinds {
        for one in found.iter().filter(|one| one.kind == kind).take(SHOWN) {
            let (at, position) = (one.at, one.position);
            let _ = write!(out, "{QUIET}  {kind} at ({}, {}): {position}", at.x, at.y);
            if let Some(name) = map.features().nth(position.feature).and_then(|feature| map.name(feature)) {
                let _ = write!(out, " ({})", plain(name));
            }
            let _ = writeln!(out, "{QUIET:#}");
        }
    }
    out
}

fn noding_line(noding: &noding::NodingSummary) -> String {
    let cut = counted(noding.split, "segment");
    let mut line = format!("snapped to a grid of 2^{}: {cut} cut", noding.cell.log2());
    for (count, name, what) in [
        (noding.crossings, "vertex", "made at crossings"),
        (noding.merged, "point", "merged with others"),
        (noding.collapsed, "segment", "collapsed"),
        (noding.duplicates, "segment", "repeated"),
    ] {
        if count > 0 {
            let _ = write!(line, ", {} {what}", counted(count, name));
        }
    }
    let [x, y] = noding.largest_move;
    let _ = write!(line, "; points moved by at most {x:.2e} in x and {y:.2e} in y");
    line
}

#[derive(Debug, Serialize)]
struct Json<'a> {
    input: &'a str,
    import: JsonImport,
    #[serde(skip_serializing_if = "Option::is_none")]
    noding: Option<JsonNoding>,
    schema: &'static str,
    valid: bool,
    counts: Counts,
    bounds: Option<Bounds>,
    rules: Vec<JsonRule>,
    violation_count: u64,
    violations: Vec<JsonViolation<'a>>,
    coverage: Coverage,
    warnings: Vec<String>,
    elapsed_ms: f64,
}

#[derive(Debug, Serialize)]
struct JsonImport {
    features: usize,
    segments: usize,
    repeated_segments: usize,
    repeated_points: usize,
    open_rings: usize,
    degenerate_rings: usize,
    rings_wound_wrongly: usize,
    self_touching_rings: usize,
    spikes: usize,
    with_extra_dimensions: usize,
    dropped_properties: usize,
    dropped_empty: usize,
    irregularities: Vec<JsonIrregularity>,
}

#[derive(Debug, Serialize)]
struct JsonIrregularity {
    kind: String,
    at: [f64; 2],
    feature: usize,
    name: Option<String>,
    shape: usize,
    ring: usize,
    point: usize,
}

impl JsonImport {
    fn new(map: &PlanarMap, read: &ReadSummary) -> Self {
        let summary = map.summary();
        let irregularity = |one: &Irregularity| {
            let Position { feature, shape, ring, point } = one.position;
            let name = map.features().nth(feature).and_then(|f| map.name(f)).map(str::to_owned);
            JsonIrregularity { kind: one.kind.to_string(), at: one.at.into(), feature, name, shape, ring, point }
        };
        Self {
            features: summary.features,
            segments: summary.segments,
            repeated_segments: summary.duplicate_segments,
            repeated_points: summary.zero_length_segments,
            open_rings: summary.open_rings,
            degenerate_rings: summary.degenerate_rings,
            rings_wound_wrongly: summary.rings_wound_wrongly,
            self_touching_rings: summary.self_touching_rings,
            spikes: summary.spikes,
            with_extra_dimensions: read.with_extra_dimensions,
            dropped_properties: read.dropped_properties,
            dropped_empty: read.dropped_empty,
            irregularities: summary.irregularities.iter().map(irregularity).collect(),
        }
    }
}

#[derive(Debug, Serialize)]
struct JsonNoding {
    cell: f64,
    segments_cut: usize,
    crossings: usize,
    points_merged: usize,
    segments_collapsed: usize,
    segments_repeated: usize,
    largest_move: [f64; 2],
}

impl From<&noding::NodingSummary> for JsonNoding {
    fn from(summary: &noding::NodingSummary) -> Self {
        Self {
            cell: summary.cell,
            segments_cut: summary.split,
            crossings: summary.crossings,
            points_merged: summary.merged,
            segments_collapsed: summary.collapsed,
            segments_repeated: summary.duplicates,
            largest_move: summary.largest_move,
        }
    }
}

#[derive(Debug, Serialize)]
struct JsonRule {
    id: Rule,
    #[serde(flatten)]
    outcome: RuleOutcome,
}

#[derive(Debug, Serialize)]
struct JsonViolation<'a> {
    #[serde(flatten)]
    described: Described<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cause: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    remedy: Option<&'static str>,
    at: Vec<[f64; 2]>,
    features: Vec<String>,
}

impl<'a> Json<'a> {
    fn new(audited: Audited<'a>, explain: bool) -> Self {
        let Audited { imported, report, coverage, is_valid, elapsed } = audited;
        let Imported { name, read, map, noted, .. } = imported;
        Self {
            input: name,
            import: JsonImport::new(map, read),
            noding: map.noding().map(JsonNoding::from),
            schema: REPORT_SCHEMA,
            valid: is_valid,
            counts: *report.counts(),
            bounds: report.certificate().and_then(|certificate| certificate.bounds),
            rules: report.outcomes().map(|(id, outcome)| JsonRule { id, outcome }).collect(),
            violation_count: report.violation_count(),
            violations: report
                .violations()
                .iter()
                .map(|violation| JsonViolation {
                    described: Described(violation),
                    cause: explain.then(|| violation.cause()),
                    remedy: explain.then(|| violation.remedy()),
                    at: places(map, violation).into_iter().map(Into::into).collect(),
                    features: features(map, violation),
                })
                .collect(),
            coverage,
            warnings: noted.warnings(read),
            elapsed_ms: elapsed,
        }
    }
}
