//! `twinedge audit`: builds a map and validates it, or validates a mesh, a file of tables or a topology of PostGIS.

mod arguments;
mod by_index;
mod destination;
mod options;
mod report;
mod timeout;

pub(crate) use arguments::Audit;
pub(crate) use destination::ReportFormat;
pub(crate) use report::Report;

use crate::input::open;
use crate::on_disk::tell_excess;
use crate::output::{Failure, Verdict, named, plain};
use crate::progress::busy;
use by_index::shelf_of;
use destination::write;
use std::fs::File;
use std::io::BufReader;
use std::time::Instant;
use timeout::Claim;
use twinedge::validate::Collect;
use twinedge_osm::{Boundaries, TagFilter};
use twinedge_report::{
    Audited, Division, Input, InputKind, Judged, OfReader, Options, audit, audit_against, audit_in_tiles, audit_layer,
};

impl Audit {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        timeout::within(self.timeout, |claim| self.judge(claim), || self.unfinished())
    }

    /// Audits the input, and writes the report unless the time is up.
    fn judge(&self, claim: &Claim) -> Result<Verdict, Failure> {
        let start = Instant::now();
        let (mut input, watch) = self.map.open_watched()?;
        let name = input.name.clone();
        let kind = match &self.boundaries {
            Some(_) => InputKind::Map,
            None => InputKind::of(self.postgis, self.arcs, &mut input).map_err(named(&name))?,
        };
        let to = self.report.destination(self.map.path())?;
        self.refuse_options(kind, &to, &input)?;
        let options = self.options(self.report.accepted()?);
        let mut audited = match &self.boundaries {
            Some(tags) => self.of_boundaries(tags, &name, &options)?,
            None => self.of_input(input, kind, &options)?,
        };
        let (judged, is_same) = watch.judged(&self.map)?;
        if let Some(judged) = judged {
            audited.judged(judged);
        }
        if let Some(path) = self.against.as_deref().filter(|path| path.is_file()) {
            audited.judged_by(Judged::of(BufReader::new(File::open(path)?))?);
        }
        if !is_same {
            audited.doubt("the file changed while it was judged");
        }
        audited.took(start.elapsed().as_secs_f64() * 1000.0);
        claim.take();
        self.report.write(&audited, &options, &name, &to)
    }

    fn of_input(&self, input: Input, kind: InputKind, options: &Options) -> Result<Audited, Failure> {
        let name = input.name.clone();
        let other = self.against.as_deref().map(|path| open(Some(path), self.against_layer.as_deref())).transpose()?;
        let division = self.memory.map(Division::Within).or(self.tiles.map(Division::Across));
        let audited = match division {
            Some(division) => {
                // A file that was unpacked is deleted after reading.
                let path = input.path.as_deref().filter(|_| input.kept.is_none());
                let mut shelf = shelf_of(path, input.options(), division).map_err(named("--memory"))?;
                let audited = busy(|stage| audit_in_tiles(input, options, division, &mut *shelf, stage));
                tell_excess(&name, division);
                audited
            }
            None if other.is_some() => busy(|stage| audit_against(input, other, options, stage)),
            None => busy(|stage| audit(input, kind, options, stage)),
        };
        audited.map_err(named(&name))
    }

    /// Reads boundaries of `OpenStreetMap`, and judges their relations and their map.
    fn of_boundaries(&self, tags: &TagFilter, name: &str, options: &Options) -> Result<Audited, Failure> {
        let path = self.map.path().ok_or_else(|| Failure("--boundaries: a file .osm.pbf is needed".to_owned()))?;
        let limit = options.list.unwrap_or(Collect::DEFAULT_CAP);
        busy(|stage| {
            stage("reading the boundaries");
            let Boundaries { layer, rules, findings, .. } =
                twinedge_osm::read(path, tags, limit).map_err(named(name))?;
            let of_reader = OfReader { rules, findings, option: ("boundaries", tags.to_string()) };
            audit_layer(name, layer, of_reader, options, stage).map_err(named(name))
        })
    }

    /// Reports that the time is up, in the formats that need only a verdict.
    fn unfinished(&self) -> Result<Verdict, Failure> {
        let name = self.map.path().map_or_else(|| "standard input".to_owned(), |path| path.display().to_string());
        let seconds = self.timeout.unwrap_or_default();
        let why = format!("time was up after {seconds} s");
        let to = self.report.destination(self.map.path())?;
        if matches!(to.format, ReportFormat::Geojson | ReportFormat::Html) {
            eprintln!("twinedge: {}: unknown: {why}; nothing is written", plain(&name));
        } else {
            write(&Audited::unfinished(&name, InputKind::Map, &self.options(None), &why), &to)?;
        }
        Ok(Verdict::Wrong)
    }
}
