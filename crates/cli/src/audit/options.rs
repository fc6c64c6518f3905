//! The options that each kind of input accepts.

use super::arguments::Audit;
use super::destination::{Destination, ReportFormat};
use crate::output::{Failure, named};
use twinedge_report::{CoverageOptions, Input, InputKind, MeshOptions};

/// Options that only some kinds of input accept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Options {
    /// `--snap`.
    Snap,
    /// The options under "Coverage", `--edges`, `--geodesic`, and lists of accepted findings.
    Coverage,
    /// The options under "Meshes".
    Mesh,
    /// `--format html`.
    Page,
    /// `--format geojson`.
    Findings,
    /// `--tiles` and `--memory`.
    Tiles,
    /// `--against` and `--parent-column`.
    Layers,
}

impl Options {
    const ALL: [Self; 7] =
        [Self::Snap, Self::Coverage, Self::Mesh, Self::Page, Self::Findings, Self::Tiles, Self::Layers];

    const fn of(kind: InputKind) -> &'static [Self] {
        match kind {
            InputKind::Map => &[Self::Snap, Self::Coverage, Self::Page, Self::Findings, Self::Tiles, Self::Layers],
            InputKind::Mesh(_) => &[Self::Mesh, Self::Page],
            InputKind::Textbook | InputKind::Postgis | InputKind::Arcs => &[Self::Page, Self::Findings],
            InputKind::Tables => &[],
        }
    }

    fn are_given(self, asked: &Audit, to: &Destination<'_>) -> bool {
        match self {
            Self::Snap => asked.map.options.snap.is_some(),
            Self::Coverage => {
                asked.coverage != CoverageOptions::default()
                    || asked.measured.geodesic
                    || asked.edges.is_some()
                    || asked.report.has_lists()
            }
            Self::Mesh => asked.mesh != MeshOptions::default(),
            Self::Page => to.format == ReportFormat::Html,
            Self::Findings => to.format == ReportFormat::Geojson,
            Self::Tiles => asked.tiles.is_some() || asked.memory.is_some(),
            Self::Layers => asked.against.is_some() || asked.parent_column.is_some(),
        }
    }

    /// The message that refuses these options for a kind of input.
    fn refusal(self, what: &str) -> String {
        match self {
            Self::Snap => format!("--snap is for maps, and this is {what}"),
            Self::Coverage => format!(
                "--coverage, its limits, --accept, --accept-all, --edges and --geodesic are for maps, and this is {what}"
            ),
            Self::Mesh => "is no mesh file (OBJ, OFF, PLY, STL), and the options say what a mesh must be".to_owned(),
            Self::Tiles => format!("--tiles and --memory are for maps, and this is {what}"),
            Self::Layers => format!("--against and --parent-column are for maps, and this is {what}"),
            Self::Page => format!("the format html is for what can be drawn, and this is {what}"),
            Self::Findings => format!(
                "the format geojson is for maps, topologies of PostGIS and the tables of a textbook, and this is {what}"
            ),
        }
    }
}

impl Audit {
    pub(super) fn refuse_options(&self, kind: InputKind, to: &Destination<'_>, input: &Input) -> Result<(), Failure> {
        // Map formats differ in their options.
        if !matches!(kind, InputKind::Map | InputKind::Arcs) {
            input.refuse_layer(kind.words()).map_err(named(&input.name))?;
        }
        let taken = Options::of(kind);
        let refused = Options::ALL.into_iter().find(|options| !taken.contains(options) && options.are_given(self, to));
        if refused.is_none() && Options::Tiles.are_given(self, to) {
            self.refuse_with_tiles(to, input)?;
        }
        refused.map_or(Ok(()), |options| Err(Failure(format!("{}: {}", input.name, options.refusal(kind.words())))))
    }

    /// Refuses options that need the whole map.
    fn refuse_with_tiles(&self, to: &Destination<'_>, input: &Input) -> Result<(), Failure> {
        let is_geodesic = self.measured.geodesic;
        let needs = [
            (Options::Snap.are_given(self, to), "--snap"),
            (to.format == ReportFormat::Html, "the format html"),
            (is_geodesic, "--geodesic"),
        ];
        match needs.into_iter().find(|(is_given, _)| *is_given) {
            Some((_, other)) => {
                let tiles = if self.tiles.is_some() { "--tiles" } else { "--memory" };
                Err(Failure(format!("{}: {other} and {tiles} do not go together", input.name)))
            }
            None => Ok(()),
        }
    }
}
