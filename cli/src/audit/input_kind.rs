//! The kinds of inputs, and the options that each takes.

use super::arguments::Run;
use super::destination::ReportFormat;
use super::table_file::is_table_file;
use super::textbook::is_textbook;
use crate::input::Input;
use crate::status::Failure;
use twinedge_formats::mesh::Format as MeshFormat;
use twinedge_formats::postgis::is_copy;

/// The kind of an input.
#[derive(Clone, Copy, Debug)]
pub(crate) enum InputKind {
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

/// Options that only some kinds of inputs take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Options {
    /// `--snap`.
    Snap,
    /// Those under "Coverage", and `--geodesic`.
    Coverage,
    /// Those under "Meshes".
    Mesh,
    /// `--format geojson` and `html`.
    Picture,
    /// `--tiles`.
    Tiles,
}

impl Options {
    const ALL: [Self; 5] = [Self::Snap, Self::Coverage, Self::Mesh, Self::Picture, Self::Tiles];

    fn are_given(self, run: &Run<'_>) -> bool {
        match self {
            Self::Snap => run.asked.map.is_snapped(),
            Self::Coverage => run.asked.coverage.is_any() || run.asked.measured.is_geodesic(),
            Self::Mesh => run.asked.mesh.is_any(),
            Self::Picture => matches!(run.to.format, ReportFormat::Geojson | ReportFormat::Html),
            Self::Tiles => run.asked.tiles.is_some(),
        }
    }

    /// The words by which they are refused for a kind of input.
    fn refusal(self, what: &str) -> String {
        match self {
            Self::Snap => format!("--snap is for maps, and this is {what}"),
            Self::Coverage => format!("--coverage, its limits and --geodesic are for maps, and this is {what}"),
            Self::Mesh => "is no mesh file (OBJ, OFF, PLY, STL), and the options say what a mesh must be".to_owned(),
            Self::Tiles => format!("--tiles is for maps, and this is {what}"),
            Self::Picture => format!(
                "the formats geojson and html are for maps, topologies of PostGIS and the tables of a textbook, and this is {what}"
            ),
        }
    }
}

impl InputKind {
    /// By what was asked for, `--postgis` or `--arcs`, or else by how the input begins.
    pub(crate) fn of(postgis: bool, arcs: bool, input: &mut Input) -> Result<Self, Failure> {
        Ok(if postgis || is_copy(input.beginning()?) {
            Self::Postgis
        } else if arcs {
            Self::Arcs
        } else if is_textbook(input.beginning()?) {
            Self::Textbook
        } else if is_table_file(input.beginning()?) {
            Self::Tables
        } else {
            input.mesh_format()?.map_or(Self::Map, Self::Mesh)
        })
    }

    /// The kind in words.
    pub(crate) const fn words(self) -> &'static str {
        self.options().0
    }

    /// The kind in words, and the options that it takes.
    const fn options(self) -> (&'static str, &'static [Options]) {
        match self {
            Self::Map => ("a map", &[Options::Snap, Options::Coverage, Options::Picture, Options::Tiles]),
            Self::Mesh(_) => ("a mesh", &[Options::Mesh]),
            Self::Textbook => ("a textbook's tables", &[Options::Picture]),
            Self::Tables => ("a file of tables", &[]),
            Self::Postgis => ("a topology of PostGIS", &[Options::Picture]),
            Self::Arcs => ("audited arc by arc", &[Options::Picture]),
        }
    }

    /// Refuses options that were given and are for other kinds.
    pub(super) fn refuse_options(self, run: &Run<'_>, input: &Input) -> Result<(), Failure> {
        let (what, taken) = self.options();
        // The formats of maps differ.
        if !matches!(self, Self::Map | Self::Arcs) {
            input.refuse_layer(what)?;
        }
        let refused = Options::ALL.into_iter().find(|options| !taken.contains(options) && options.are_given(run));
        let with_tiles = if run.asked.tiles.is_none() {
            None
        } else if Options::Snap.are_given(run) {
            Some("--snap")
        } else if Options::Picture.are_given(run) {
            Some("the formats geojson and html")
        } else {
            Some("--geodesic").filter(|_| run.asked.measured.is_geodesic())
        };
        if let Some(other) = with_tiles.filter(|_| refused.is_none()) {
            return Err(Failure(format!("{}: {other} and --tiles do not go together", input.name)));
        }
        refused.map_or(Ok(()), |options| Err(Failure(format!("{}: {}", input.name, options.refusal(what)))))
    }
}
