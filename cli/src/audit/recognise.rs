//! The kinds of inputs, and the options that each takes.

use super::Audit;
use super::destination::ReportFormat;
use super::table_file::is_table_file;
use super::textbook::is_textbook;
use crate::input::Input;
use crate::status::Failure;
use twinedge_formats::mesh::Format as MeshFormat;
use twinedge_formats::postgis::is_copy;

/// The kind of an input.
#[derive(Clone, Copy, Debug)]
pub(super) enum Recognised {
    Map,
    Mesh(MeshFormat),
    /// The three tables of a textbook.
    Textbook,
    /// A table on each line.
    Tables,
    /// A topology of PostGIS.
    Postgis,
    /// The arcs of TopoJSON.
    Arcs,
}

/// The options that a kind of input takes, beside those that all take.
struct Options {
    /// The kind, in words.
    what: &'static str,
    /// `--snap`.
    snap: bool,
    /// `--coverage`, `--gap-width`, `--sliver`.
    coverage: bool,
    /// The options under "Meshes".
    mesh: bool,
    /// `--format geojson` and `html`.
    drawn: bool,
}

impl Recognised {
    /// By what was asked for, or else by how the input begins.
    pub(super) fn of(asked: &Audit, input: &mut Input) -> Result<Self, Failure> {
        Ok(if asked.postgis || is_copy(input.beginning()?) {
            Self::Postgis
        } else if asked.arcs {
            Self::Arcs
        } else if is_textbook(input.beginning()?) {
            Self::Textbook
        } else if is_table_file(input.beginning()?) {
            Self::Tables
        } else {
            input.mesh_format()?.map_or(Self::Map, Self::Mesh)
        })
    }

    const fn options(self) -> Options {
        let (what, [snap, coverage, mesh, drawn]) = match self {
            Self::Map => ("a map", [true, true, false, true]),
            Self::Mesh(_) => ("a mesh", [false, false, true, false]),
            Self::Textbook => ("a textbook's tables", [false, false, false, true]),
            Self::Tables => ("a file of tables", [false; 4]),
            Self::Postgis => ("a topology of PostGIS", [false, false, false, true]),
            Self::Arcs => ("audited arc by arc", [false, false, false, true]),
        };
        Options { what, snap, coverage, mesh, drawn }
    }

    /// Refuses options that were given and are for other kinds.
    pub(super) fn refuse_options(self, asked: &Audit, format: ReportFormat, name: &str) -> Result<(), Failure> {
        let Options { what, snap, coverage, mesh, drawn } = self.options();
        let is_drawn = matches!(format, ReportFormat::Geojson | ReportFormat::Html);
        let maps = format!("for maps, and this is {what}");
        let refused = [
            (!snap && asked.map.is_snapped(), format!("--snap is {maps}")),
            (!coverage && asked.coverage.is_any(), format!("--coverage, --gap-width and --sliver are {maps}")),
            (
                !mesh && asked.mesh.is_any(),
                "is no mesh file (OBJ, OFF, PLY, STL), and the options say what a mesh must be".to_owned(),
            ),
            (
                !drawn && is_drawn,
                format!(
                    "the formats geojson and html are for maps, topologies of PostGIS and the tables of a textbook, and this is {what}"
                ),
            ),
        ];
        let first = refused.into_iter().find(|(is_refused, _)| *is_refused);
        first.map_or(Ok(()), |(_, why)| Err(Failure(format!("{name}: {why}"))))
    }
}
