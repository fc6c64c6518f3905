//! The audit of an input of any kind.

use crate::accepted::Accepted;
use crate::error::Error;
use crate::imported::Imported;
use crate::input::Input;
use crate::input_kind::InputKind;
use crate::layers::{self, Other};
use crate::noted::Keep;
use crate::options::{Edges, Options};
use crate::options_json::{as_json, of_mesh};
use crate::packed::Picture;
use crate::report::AuditReport;
use crate::shelf::Shelf;
use crate::tables::TablesReport;
use crate::tiles::Division;
use crate::verdict::{Judged, Verdict};
use crate::words::{counted, json, plain};
use crate::{findings_geojson, junit, map, mesh, page, sarif, sphere, tables, text, textbook, tiles, topology};
use twinedge_coverage::tile::Summary;
use twinedge_formats::diagnosis::{Diagnosis, RuleLine};
use twinedge_formats::layer::topojson::ArcTopology;
use twinedge_formats::layer::{Crs, Layer};
use twinedge_formats::mesh::IndexedMesh;
use twinedge_formats::postgis::Topology;
use twinedge_formats::textbook::Textbook;

/// An input that was audited.
#[derive(Debug)]
pub struct Audited(Outcome);

#[derive(Debug)]
enum Outcome {
    Report(Box<AuditReport>, Subject),
    Tables(TablesReport),
}

/// The structure that a page shows.
#[derive(Debug)]
enum Subject {
    Map(Box<Imported>),
    Textbook(Textbook),
    Postgis(Box<Topology>),
    Arcs(Box<ArcTopology>),
    Mesh(IndexedMesh),
    /// Tiles, of which findings have places, and no shapes.
    Tiles,
    None,
}

/// Reads an input and judges it. `stage` is told what begins, before work that may take long.
///
/// O(n log n) for n segments that cross in O(n) places.
///
/// # Errors
/// [`Error`], if the input could not be read, or cannot be judged as was asked.
pub fn audit(
    input: Input,
    kind: InputKind,
    options: &Options,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Audited, Error> {
    match kind {
        InputKind::Map => {}
        InputKind::Mesh(format) => {
            let (report, mesh) = mesh::audit(input, format, options, mesh::in_space)?;
            return Ok(told(report, Subject::Mesh(mesh), options, kind));
        }
        _ => return audit_plainly(input, kind, options, stage),
    }
    options.refuse_with_geodesic(None)?;
    let mut input = input;
    let may_say = options.may_be_said(&mut input)?;
    let is_asked = options.edges == Some(Edges::Geodesic);
    let keep = Keep { coverage: !is_asked, features: is_asked || may_say, ..Keep::default() };
    let mut imported = Imported::read(input, &options.map, keep, stage)?;
    let is_geodesic = is_asked || may_say && imported.has_great_circles();
    let report = judge(&mut imported, is_geodesic, options, stage)?;
    Ok(told(report, Subject::Map(Box::new(imported)), options, kind))
}

/// As [`audit`], with straight edges and without M9 … M11, whatever is asked for: programs that never ask for these are smaller by this.
///
/// # Errors
/// As for [`audit`].
pub fn audit_plainly(
    input: Input,
    kind: InputKind,
    options: &Options,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Audited, Error> {
    let (report, subject) = match kind {
        InputKind::Map => {
            let mut imported = Imported::read(input, &options.map, Keep { coverage: true, ..Keep::default() }, stage)?;
            (map::audit(&mut imported, options, stage)?, Subject::Map(Box::new(imported)))
        }
        InputKind::Mesh(format) => {
            let (report, mesh) = mesh::audit(input, format, options, mesh::plainly)?;
            (report, Subject::Mesh(mesh))
        }
        InputKind::Textbook => {
            let (report, tables) = textbook::audit(input, options)?;
            (report, Subject::Textbook(tables))
        }
        InputKind::Postgis => {
            let (report, topology) = topology::audit_postgis(input, options)?;
            (report, Subject::Postgis(Box::new(topology)))
        }
        InputKind::Arcs => {
            let (report, topology) = topology::audit_arcs(input, options)?;
            (report, Subject::Arcs(Box::new(topology)))
        }
        InputKind::Tables => {
            let report = tables::audit(input, options)?;
            return Ok(Audited(Outcome::Tables(if options.explain { report } else { report.unexplained() })));
        }
    };
    Ok(told(report, subject, options, kind))
}

/// Reads a map and judges it, also by the rules between it and another layer, and between its parts and their parents.
///
/// O(n log n) for n segments of both that cross in O(n) places.
///
/// # Errors
/// [`Error`], if an input could not be read, or cannot be judged as was asked.
pub fn audit_against(
    input: Input,
    other: Option<Input>,
    options: &Options,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Audited, Error> {
    options.refuse_with_geodesic(Some("--against or --parent-column"))?;
    let columns = options.parent.iter().flat_map(|parent| parent.columns(other.is_some())).collect::<Vec<_>>();
    let keep = Keep { coverage: true, columns: &columns, features: true, points: true, ..Keep::default() };
    let mut imported = Imported::read(input, &options.map, keep, stage)?;
    let mut report = map::audit(&mut imported, options, stage)?;
    let other = other.map(|other| Other::read(other, options)).transpose()?;
    layers::judge(&imported, other.as_ref(), options, &mut report, stage)?;
    Ok(told(report, Subject::Map(Box::new(imported)), options, InputKind::Map))
}

/// The findings of whoever read a layer.
#[derive(Clone, Debug)]
pub struct OfReader {
    /// The outcome of each of its rules.
    pub rules: Vec<RuleLine>,
    /// The violations that are listed.
    pub findings: Vec<Diagnosis>,
    /// The name of the option by which it was read, and its value.
    pub option: (&'static str, String),
}

/// Judges a layer that is in memory, and says what its reader found.
///
/// # Errors
/// [`Error`], if it cannot be judged as was asked.
pub fn audit_layer(
    name: &str,
    layer: Layer,
    of_reader: OfReader,
    options: &Options,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Audited, Error> {
    let mut map = options.map.clone();
    // If the reader found something, a layer without polygons is no other input.
    let OfReader { rules, findings, option: (option, value) } = of_reader;
    let found = rules.iter().map(|rule| rule.violations).sum::<u64>();
    map.allow_empty |= found > 0;
    options.refuse_with_geodesic(None)?;
    let is_geodesic = options.edges == Some(Edges::Geodesic);
    let keep = Keep { coverage: !is_geodesic, features: is_geodesic, ..Keep::default() };
    let mut imported = Imported::of_layer(name, layer, &map, keep, stage)?;
    let mut report = judge(&mut imported, is_geodesic, options, stage)?;
    report.rules.splice(0..0, rules);
    report.findings.extend(findings);
    report.finding_count += found;
    report.json.has_findings = true;
    report.options.insert(option.to_owned(), value.into());
    Ok(told(report, Subject::Map(Box::new(imported)), options, InputKind::Map))
}

/// Reads a map onto a shelf, and judges it by its tiles: what [`audit`] says of it, but for the numbers of records, and with the size
/// of the grid.
///
/// # Errors
/// [`Error`].
pub fn audit_in_tiles(
    input: Input,
    options: &Options,
    division: Division,
    shelf: &mut dyn Shelf,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Audited, Error> {
    options.refuse_with_geodesic(Some("--tiles or --memory"))?;
    let mut input = input;
    let may_say = options.may_be_said(&mut input)?;
    let imported = Imported::features(input, &options.map, Keep::default(), shelf)?;
    if may_say {
        tiles::refuse_edges(imported.edges.as_deref(), imported.crs.as_ref(), imported.noted.corners())?;
    }
    let report = tiles::audit(imported, options, division, shelf, stage)?;
    Ok(told(report, Subject::Tiles, options, InputKind::Map))
}

fn judge(
    imported: &mut Imported,
    is_geodesic: bool,
    options: &Options,
    stage: &mut dyn FnMut(&'static str),
) -> Result<AuditReport, Error> {
    if is_geodesic { sphere::audit(imported, options, stage) } else { map::audit(imported, options, stage) }
}

/// A report as it was asked for.
fn told(report: AuditReport, subject: Subject, options: &Options, kind: InputKind) -> Audited {
    let mut report = if options.explain { report } else { report.unexplained() };
    report.options.extend(as_json(options, kind));
    report.identify();
    report.settle(options.accepted.as_ref());
    if let Subject::Mesh(mesh) = &subject {
        mesh::trace(&mut report, mesh);
    }
    Audited(Outcome::Report(Box::new(report), subject))
}

/// Judges a mesh that is in memory.
///
/// # Errors
/// [`Error::Json`].
pub fn audit_mesh(name: &str, mesh: IndexedMesh, options: &Options) -> Result<Audited, Error> {
    let report = mesh::of_mesh(name, 0, &mesh::in_space(&mesh, options))?;
    let mut report = if options.explain { report } else { report.unexplained() };
    report.options = of_mesh(options);
    report.identify();
    report.settle(None);
    Ok(Audited(Outcome::Report(Box::new(report), Subject::Mesh(mesh))))
}

/// Says what the summary of all tiles of a map says, in the words of an audit; where edges meet elsewhere than at vertices, with the findings of the
/// summary of the same tiles with their edges cut. Features are known by their numbers. If tiles are left out of that summary, or were when their edges
/// were cut, the report names them, and does not say what features cover.
///
/// `crs` is the coordinate reference system of the map, if it is another one than longitude and latitude on WGS 84.
///
/// # Errors
/// [`Error::Missing`] and [`Error::Tiles`]; [`Error::NoEdges`], unless a map may be empty.
pub fn audit_summary(
    summary: Summary,
    cut: Option<Summary>,
    crs: Option<Crs>,
    options: &Options,
) -> Result<Audited, Error> {
    let mut report = tiles::audit_summary(summary, cut, crs, options)?.unexplained();
    report.identify();
    report.settle(options.accepted.as_ref());
    Ok(Audited(Outcome::Report(Box::new(report), Subject::Tiles)))
}

impl Audited {
    /// The report of an audit that ended before there was an outcome: its verdict is not known. `why` is a sentence without full stop.
    #[must_use]
    pub fn unfinished(name: &str, kind: InputKind, options: &Options, why: &str) -> Self {
        let report =
            AuditReport { doubts: vec![why.to_owned()], options: as_json(options, kind), ..AuditReport::new(name) };
        Self(Outcome::Report(Box::new(report), Subject::None))
    }

    /// The verdict.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match &self.0 {
            Outcome::Report(report, _) => report.verdict(),
            Outcome::Tables(report) => report.verdict(),
        }
    }

    /// Returns true if the verdict is [`Verdict::Valid`].
    #[must_use]
    pub fn is_valid(&self) -> bool {
        self.verdict() == Verdict::Valid
    }

    /// Notes the bytes that were judged.
    pub fn judged(&mut self, judged: Judged) {
        if let Outcome::Report(report, _) = &mut self.0 {
            report.judged = Some(judged);
        }
    }

    /// Notes the bytes of the layer by which it was judged.
    pub fn judged_by(&mut self, layer: Judged) {
        if let Outcome::Report(report, _) = &mut self.0 {
            report.judged_by = Some(layer);
        }
    }

    /// Notes a reason for which the verdict cannot be [`Verdict::Valid`], a sentence without full stop.
    pub fn doubt(&mut self, why: &str) {
        if let Outcome::Report(report, _) = &mut self.0 {
            report.doubts.push(why.to_owned());
        }
    }

    /// Notes the time that it took, in milliseconds.
    pub const fn took(&mut self, elapsed_ms: f64) {
        match &mut self.0 {
            Outcome::Report(report, _) => report.elapsed_ms = elapsed_ms,
            Outcome::Tables(report) => report.elapsed_ms = elapsed_ms,
        }
    }

    /// The mesh that was judged, if it was one.
    #[must_use]
    pub const fn mesh(&self) -> Option<&IndexedMesh> {
        match &self.0 {
            Outcome::Report(_, Subject::Mesh(mesh)) => Some(mesh),
            _ => None,
        }
    }

    /// The report for people, with the colours of [`words::style`](crate::words::style).
    ///
    /// # Errors
    /// None that happens: writing to a string does not fail.
    pub fn text(&self) -> Result<String, std::fmt::Error> {
        match &self.0 {
            Outcome::Report(report, _) => text::text(report),
            Outcome::Tables(report) => report.text(),
        }
    }

    /// The report as one JSON object, as `docs/report.md` of the library describes it.
    ///
    /// # Errors
    /// [`Error::Json`].
    pub fn json(&self) -> Result<Vec<u8>, Error> {
        Ok(match &self.0 {
            Outcome::Report(report, _) => json(&report.json())?,
            Outcome::Tables(report) => json(report)?,
        })
    }

    /// The findings of the coverage and those between layers that are listed, as a list of accepted ones, in JSON. Those that `before` has keep their reason and date.
    ///
    /// # Errors
    /// [`Error::NoReport`] for files of tables, and [`Error::Json`].
    pub fn accept_all(&self, before: Option<&Accepted>, reason: &str, date: &str) -> Result<Vec<u8>, Error> {
        let findings = self.of_structure()?.acceptable();
        Ok(json(&Accepted::all(findings, before, reason, date))?)
    }

    /// The report as SARIF, which code hosts show.
    ///
    /// # Errors
    /// [`Error::NoReport`] for files of tables, and [`Error::Json`].
    pub fn sarif(&self) -> Result<Vec<u8>, Error> {
        Ok(json(&sarif::sarif(self.of_structure()?))?)
    }

    /// The report as XML in the form of `JUnit`: a test case for each rule.
    ///
    /// # Errors
    /// [`Error::NoReport`] for files of tables.
    pub fn junit(&self) -> Result<String, Error> {
        // Writing to a string does not fail.
        Ok(junit::junit(self.of_structure()?).unwrap_or_default())
    }

    /// The report of a single structure.
    const fn of_structure(&self) -> Result<&AuditReport, Error> {
        match &self.0 {
            Outcome::Report(report, _) => Ok(report),
            Outcome::Tables(_) => Err(Error::NoReport),
        }
    }

    /// The findings as a layer of GeoJSON, and warnings about it.
    ///
    /// # Errors
    /// [`Error::NoPicture`] for meshes and files of tables, and [`Error::Write`].
    pub fn findings(&self) -> Result<(Vec<u8>, Vec<String>), Error> {
        findings_geojson::layer(self.drawn()?.0)
    }

    /// The structure and what was found in one file, which a browser shows. A mesh is drawn as it is seen along the axis in which it extends least.
    ///
    /// # Errors
    /// [`Error::NoPicture`] for files of tables, and [`Error::Json`].
    pub fn page(&self) -> Result<String, Error> {
        let Outcome::Report(report, subject) = &self.0 else {
            return Err(Error::NoPicture(InputKind::Tables.words()));
        };
        let picture = match subject {
            Subject::Map(imported) => map::picture(imported, report),
            Subject::Textbook(tables) => textbook::picture(tables, report),
            Subject::Postgis(topology) => topology::picture(&**topology, |record| topology.name(record), report),
            Subject::Arcs(topology) => topology::picture(&**topology, |record| topology.name(record), report),
            Subject::Mesh(mesh) => mesh::picture(mesh, report),
            Subject::Tiles | Subject::None => Picture::default(),
        };
        Ok(page::page(report, &picture)?)
    }

    /// The verdict, and how many findings are listed, in a line.
    ///
    /// # Errors
    /// [`Error::NoReport`] for files of tables.
    pub fn summary(&self) -> Result<String, Error> {
        let report = self.of_structure()?;
        let listed = match (report.listed().count(), report.total()) {
            (listed, total) if listed as u64 == total => counted(listed, "finding"),
            (listed, total) => format!("{listed} of {}", counted(total as usize, "finding")),
        };
        Ok(format!("{}: {}; {listed}", plain(&report.input), plain(&report.sentence())))
    }

    /// The report of a structure that can be drawn.
    const fn drawn(&self) -> Result<(&AuditReport, &Subject), Error> {
        match &self.0 {
            Outcome::Report(_, Subject::Mesh(_) | Subject::None) => Err(Error::NoPicture("a mesh")),
            Outcome::Tables(_) => Err(Error::NoPicture(InputKind::Tables.words())),
            Outcome::Report(report, subject) => Ok((report, subject)),
        }
    }
}
