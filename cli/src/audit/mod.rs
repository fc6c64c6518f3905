//! `twinedge audit`: builds a map and validates it, or validates a mesh, a file of tables or a topology of PostGIS.

mod arguments;
mod audited;
mod destination;
mod findings_geojson;
mod map;
mod map_json;
mod map_notes;
mod mesh_file;
mod mesh_options;
mod packed;
mod page;
mod recognise;
mod table_file;
mod text;
mod textbook;
mod topology_file;
mod write;

pub(crate) use arguments::Audit;

use crate::status::{Failure, Verdict};
use arguments::Run;
use recognise::Recognised;
use std::time::Instant;

impl Audit {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
        let mut input = self.map.open()?;
        let recognised = Recognised::of(self, &mut input)?;
        let run = &Run { asked: self, to: self.destination.destination(self.map.path()), start };
        recognised.refuse_options(run, &input.name)?;
        match recognised {
            Recognised::Map => map::audit(run, input),
            Recognised::Mesh(format) => mesh_file::audit(run, input, format),
            Recognised::Textbook => textbook::audit(run, input),
            Recognised::Tables => table_file::audit(run, input),
            Recognised::Postgis => topology_file::audit_postgis(run, input),
            Recognised::Arcs => topology_file::audit_arcs(run, input),
        }
    }
}
