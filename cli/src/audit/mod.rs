//! `twinedge audit`: builds a map and validates it, or validates a mesh, a file of tables or a topology of PostGIS.

mod arguments;
mod destination;
mod mesh_options;
mod options;
mod timeout;
mod write;

pub(crate) use arguments::Audit;

use crate::judged::Counted;
use crate::progress::busy;
use crate::status::{Failure, Verdict, named};
use std::fs::Metadata;
use std::path::Path;
use std::time::Instant;
use timeout::Claim;
use twinedge_report::{Audited, InputKind, Judged, audit};
use write::write;

impl Audit {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        timeout::within(self.timeout, |claim| self.judge(claim), || self.unfinished())
    }

    /// Audits, and writes the report unless time was up before.
    fn judge(&self, claim: &Claim) -> Result<Verdict, Failure> {
        let start = Instant::now();
        let before = self.map.path().and_then(changed);
        let mut input = self.map.open()?;
        let name = input.name.clone();
        let kind = InputKind::of(self.postgis, self.arcs, &mut input).map_err(named(&name))?;
        let to = self.destination.destination(self.map.path())?;
        self.refuse_options(kind, &to, &input)?;
        let mut counter = None;
        if self.map.is_stdin() && input.path.is_none() {
            let (reader, counted) = Counted::new(input.reader);
            input.reader = Box::new(reader);
            counter = Some(counted);
        }
        let mut audited = busy(|stage| audit(input, kind, &self.options(), stage)).map_err(named(&name))?;
        let judged: Option<Judged> = match counter {
            Some(counter) => Some(counter.judged()),
            None => self.map.judged()?,
        };
        if let Some(judged) = judged {
            audited.judged(judged);
        }
        if self.map.path().and_then(changed) != before {
            audited.doubt("the file changed while it was judged");
        }
        audited.took(start.elapsed().as_secs_f64() * 1000.0);
        claim.take();
        write(&audited, &to)?;
        Ok(if audited.is_valid() { Verdict::Sound } else { Verdict::Wrong })
    }

    /// The report that time was up, in the formats that need no more than a verdict.
    fn unfinished(&self) -> Result<Verdict, Failure> {
        let name = self.map.path().map_or_else(|| "standard input".to_owned(), |path| path.display().to_string());
        let seconds = self.timeout.unwrap_or_default();
        let why = format!("time was up after {seconds} s");
        let audited = Audited::unfinished(&name, Some(InputKind::Map), &self.options(), &why);
        write(&audited, &self.destination.destination(self.map.path())?)?;
        Ok(Verdict::Wrong)
    }
}

/// That by which one sees that a file has changed: its length, and when it was written.
fn changed(path: &Path) -> Option<(u64, Option<std::time::SystemTime>)> {
    let of = |metadata: Metadata| (metadata.len(), metadata.modified().ok());
    std::fs::metadata(path).ok().filter(Metadata::is_file).map(of)
}
