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
use crate::textbook::Textbook;
use crate::tiles::{Division, TiledLayer};
use crate::verdict::{Judged, Verdict};
use crate::words::{counted, json, plain};
use crate::{findings_geojson, junit, map, mesh, page, sarif, sphere, tables, text, textbook_audit, tiles, topology};
use twinedge_coverage::tile::Portion;
use twinedge_diagnosis::{Diagnosis, RuleLine};
use twinedge_layers::Layer;
use twinedge_layers::topojson::ArcTopology;
use twinedge_meshes::IndexedMesh;
use twinedge_postgis::Topology;

/// An audited input.
#[derive(Debug)]
pub struct Audited(Outcome);

#[derive(Debug)]
enum Outcome {
    Report(Box<AuditReport>, Subject),
    Tables(TablesReport),
}

#[derive(Debug)]
enum Subject {
    Map(Box<Imported>),
    Textbook(Textbook),
    Postgis(Box<Topology>),
    Arcs(Box<ArcTopology>),
    Mesh(IndexedMesh),
    /// Tiles: their findings have places and no shapes.
    Tiles,
    None,
}

/// Reads an input and judges it. Calls `stage` with the name of each step that may take long.
///
/// O(n log n) for n segments that cross in O(n) places.
///
/// # Errors
/// [`Error`], if the input cannot be read, or not be judged with these options.
pub fn audit(
    mut input: Input,
    kind: InputKind,
    options: &Options,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Audited, Error> {
    let (report, subject) = match kind {
        InputKind::Map if options.parent_column.is_some() => return audit_against(input, None, options, stage),
        InputKind::Map => {
            options.refuse_with_geodesic(None)?;
            let may_say = options.may_be_said(&mut input)?;
            let is_asked = options.edges == Some(Edges::Geodesic);
            let keep = Keep { coverage: !is_asked, features: is_asked || may_say, ..Keep::default() };
            let mut imported = Imported::read(input, &options.map, keep, stage)?;
            let is_geodesic = is_asked || may_say && imported.has_great_circles();
            (judge(&mut imported, is_geodesic, options, stage)?, Subject::Map(Box::new(imported)))
        }
        InputKind::Mesh(format) => {
            let (report, mesh) = mesh::audit(input, format, options)?;
            (report, Subject::Mesh(mesh))
        }
        InputKind::Textbook => {
            let (report, tables) = textbook_audit::audit(input, options)?;
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

/// Reads a map and judges it, including the rules between it and another layer and between its parts and their parents.
///
/// O(n log n) for n segments of both that cross in O(n) places.
///
/// # Errors
/// [`Error`], if an input cannot be read, or not be judged with these options.
pub fn audit_against(
    input: Input,
    other: Option<Input>,
    options: &Options,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Audited, Error> {
    options.refuse_with_geodesic(Some("--against or --parent-column"))?;
    let columns = options.parent_column.iter().flat_map(|parent| parent.columns(other.is_some())).collect::<Vec<_>>();
    let keep = Keep { coverage: true, columns: &columns, features: true, points: true, ..Keep::default() };
    let mut imported = Imported::read(input, &options.map, keep, stage)?;
    let mut report = map::audit(&mut imported, options, stage)?;
    let other = other.map(|other| Other::read(other, options)).transpose()?;
    layers::judge(&imported, other.as_ref(), options, &mut report, stage)?;
    Ok(told(report, Subject::Map(Box::new(imported)), options, InputKind::Map))
}

/// The findings of a layer's reader.
#[derive(Clone, Debug)]
pub struct OfReader {
    /// The outcome of each of its rules.
    pub rules: Vec<RuleLine>,
    /// The listed violations.
    pub findings: Vec<Diagnosis>,
    /// The name and value of the option that selected the reader.
    pub option: (&'static str, String),
}

/// Judges a layer in memory and reports its reader's findings.
///
/// # Errors
/// [`Error`], if the layer cannot be judged with these options.
pub fn audit_layer(
    name: &str,
    layer: Layer,
    of_reader: OfReader,
    options: &Options,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Audited, Error> {
    let mut map = options.map.clone();
    // A layer without polygons is an error only if the reader found nothing.
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

/// Reads a map onto a shelf and judges it by tiles. The report equals [`audit`]'s, except that it lacks numbers of records and has the size of the
/// grid.
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
    let imported = Imported::features(input, &options.map, Keep::default(), &mut |feature| shelf.put(feature))?;
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

/// Judges a mesh in memory.
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

/// Reports the audit of all tiles of a map. Where edges meet away from vertices, the findings come from the tiles with their edges cut. If a tile
/// was made without cuts, or was missing when edges were cut, the report names the tile, and the coverage is not judged. With the layer that the
/// tiles were made of, the report is [`audit_in_tiles`]'s; the limits are those of the tiles.
///
/// # Errors
/// [`Error::Missing`] and [`Error::Tiles`]; [`Error::OtherLayer`]; [`Error::NoEdges`], unless a map may be empty.
pub fn audit_portion(portion: Portion, layer: TiledLayer, options: &Options) -> Result<Audited, Error> {
    Ok(told(tiles::audit_portion(portion, layer, options)?, Subject::Tiles, options, InputKind::Map))
}

impl Audited {
    /// Returns the report of an audit that stopped before there was an outcome: its verdict is unknown. `why` is a sentence without a full stop.
    #[must_use]
    pub fn unfinished(name: &str, kind: InputKind, options: &Options, why: &str) -> Self {
        let report =
            AuditReport { doubts: vec![why.to_owned()], options: as_json(options, kind), ..AuditReport::new(name) };
        Self(Outcome::Report(Box::new(report), Subject::None))
    }

    /// Returns the verdict.
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

    /// Records the judged bytes.
    pub fn judged(&mut self, judged: Judged) {
        if let Outcome::Report(report, _) = &mut self.0 {
            report.judged = Some(judged);
        }
    }

    /// Records the bytes of the other layer.
    pub fn judged_by(&mut self, layer: Judged) {
        if let Outcome::Report(report, _) = &mut self.0 {
            report.judged_by = Some(layer);
        }
    }

    /// Records a reason why the verdict cannot be [`Verdict::Valid`], as a sentence without a full stop.
    pub fn doubt(&mut self, why: &str) {
        if let Outcome::Report(report, _) = &mut self.0 {
            report.doubts.push(why.to_owned());
        }
    }

    /// Records the elapsed time in milliseconds.
    pub const fn took(&mut self, elapsed_ms: f64) {
        match &mut self.0 {
            Outcome::Report(report, _) => report.elapsed_ms = elapsed_ms,
            Outcome::Tables(report) => report.elapsed_ms = elapsed_ms,
        }
    }

    /// Returns the judged mesh, if the input is a mesh.
    #[must_use]
    pub const fn mesh(&self) -> Option<&IndexedMesh> {
        match &self.0 {
            Outcome::Report(_, Subject::Mesh(mesh)) => Some(mesh),
            _ => None,
        }
    }

    /// Returns the report for people, with the colours of [`words::style`](crate::words::style).
    ///
    /// # Errors
    /// Never: writing to a string does not fail.
    pub fn text(&self) -> Result<String, std::fmt::Error> {
        match &self.0 {
            Outcome::Report(report, _) => text::text(report),
            Outcome::Tables(report) => report.text(),
        }
    }

    /// Returns the report as one JSON object, described in `docs/report.md` of the library.
    ///
    /// # Errors
    /// [`Error::Json`].
    pub fn json(&self) -> Result<Vec<u8>, Error> {
        Ok(match &self.0 {
            Outcome::Report(report, _) => json(&report.json())?,
            Outcome::Tables(report) => json(report)?,
        })
    }

    /// Returns the listed findings of the coverage and between layers as a list of accepted findings, in JSON. Findings in `before` keep their reason
    /// and date.
    ///
    /// # Errors
    /// [`Error::NoReport`] for files of tables, and [`Error::Json`].
    pub fn accept_all(&self, before: Option<&Accepted>, reason: &str, date: &str) -> Result<Vec<u8>, Error> {
        let findings = self.of_structure()?.acceptable();
        Ok(json(&Accepted::all(findings, before, reason, date))?)
    }

    /// Returns the report as SARIF, which code hosts show.
    ///
    /// # Errors
    /// [`Error::NoReport`] for files of tables, and [`Error::Json`].
    pub fn sarif(&self) -> Result<Vec<u8>, Error> {
        Ok(json(&sarif::sarif(self.of_structure()?))?)
    }

    /// Returns the report as `JUnit` XML, with a test case for each rule.
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

    /// Returns the findings as a GeoJSON layer, with warnings about it.
    ///
    /// # Errors
    /// [`Error::NoPicture`] for meshes and files of tables, and [`Error::Write`].
    pub fn findings(&self) -> Result<(Vec<u8>, Vec<String>), Error> {
        findings_geojson::layer(self.drawn()?.0)
    }

    /// Returns the structure and its findings as one HTML file. A mesh is drawn along the axis of its smallest extent.
    ///
    /// # Errors
    /// [`Error::NoPicture`] for files of tables, and [`Error::Json`].
    pub fn page(&self) -> Result<String, Error> {
        let Outcome::Report(report, subject) = &self.0 else {
            return Err(Error::NoPicture(InputKind::Tables.words()));
        };
        let picture = match subject {
            Subject::Map(imported) => map::picture(imported, report),
            Subject::Textbook(tables) => textbook_audit::picture(tables, report),
            Subject::Postgis(topology) => topology::picture(&**topology, |record| topology.name(record), report),
            Subject::Arcs(topology) => topology::picture(&**topology, |record| topology.name(record), report),
            Subject::Mesh(mesh) => mesh::picture(mesh, report),
            Subject::Tiles | Subject::None => Picture::default(),
        };
        Ok(page::page(report, &picture)?)
    }

    /// Returns the verdict and the number of listed findings, in one line.
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

    const fn drawn(&self) -> Result<(&AuditReport, &Subject), Error> {
        match &self.0 {
            Outcome::Report(_, Subject::Mesh(_) | Subject::None) => Err(Error::NoPicture("a mesh")),
            Outcome::Tables(_) => Err(Error::NoPicture(InputKind::Tables.words())),
            Outcome::Report(report, subject) => Ok((report, subject)),
        }
    }
}
