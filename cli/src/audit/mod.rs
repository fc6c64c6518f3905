//! `twinedge audit`: builds a map and validates it, or validates a mesh, a file of tables or a topology of PostGIS.

mod arguments;
mod destination;
mod findings_geojson;
mod input_kind;
mod map;
mod map_json;
mod map_notes;
mod mesh_file;
mod mesh_options;
mod packed;
mod page;
mod reader_words;
mod report;
mod table_file;
mod text;
mod textbook;
mod tiles;
mod topology_file;
mod write;

pub(crate) use arguments::Audit;
pub(crate) use input_kind::InputKind;
pub(crate) use tiles::sum as sum_tiles;

use crate::status::{Failure, Verdict};
use arguments::Run;
use std::time::Instant;

impl Audit {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
        let mut input = self.map.open()?;
        let kind = InputKind::of(self.postgis, self.arcs, &mut input)?;
        let run = &Run { asked: self, to: self.destination.destination(self.map.path())?, start };
        kind.refuse_options(run, &input)?;
        match kind {
            InputKind::Map => match self.tiles {
                Some(across) => tiles::audit(run, input, across),
                None => map::audit(run, input),
            },
            InputKind::Mesh(format) => mesh_file::audit(run, input, format),
            InputKind::Textbook => textbook::audit(run, input),
            InputKind::Tables => table_file::audit(run, input),
            InputKind::Postgis => topology_file::audit_postgis(run, input),
            InputKind::Arcs => topology_file::audit_arcs(run, input),
        }
    }
}
