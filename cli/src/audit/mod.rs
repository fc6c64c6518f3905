//! `twinedge audit`: builds a map and validates it, or validates a mesh, a file of tables or a topology of PostGIS.

mod arguments;
mod destination;
mod mesh_options;
mod options;
mod write;

pub(crate) use arguments::Audit;

use crate::progress::busy;
use crate::status::{Failure, Verdict, named};
use std::time::Instant;
use twinedge_report::{InputKind, audit};
use write::write;

impl Audit {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
        let mut input = self.map.open()?;
        let name = input.name.clone();
        let kind = InputKind::of(self.postgis, self.arcs, &mut input).map_err(named(&name))?;
        let to = self.destination.destination(self.map.path())?;
        self.refuse_options(kind, &to, &input)?;
        let mut audited = busy(|stage| audit(input, kind, &self.options(), stage)).map_err(named(&name))?;
        audited.took(start.elapsed().as_secs_f64() * 1000.0);
        write(&audited, &to)?;
        Ok(if audited.is_valid() { Verdict::Sound } else { Verdict::Wrong })
    }
}
