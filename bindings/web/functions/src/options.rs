//! Options, as the package spells them.

use crate::error::CallError;
use serde::Deserialize;
use serde_json::Value;
use twinedge_coverage::Limits;
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_meshes::HalfEdgeMesh;
use twinedge_report::{Accepted, CoverageOptions, MapOptions, Options};

/// A grid: `"auto"`, or the greatest width of its cells.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub(crate) enum Grid {
    Size(f64),
    Word(String),
}

/// Returns the requested grid.
pub(crate) fn snap(grid: Option<&Grid>) -> Result<Option<Snap>, CallError> {
    match grid {
        None => Ok(None),
        Some(Grid::Size(size)) if *size > 0.0 && size.is_finite() => Ok(Some(Snap::Size(*size))),
        Some(Grid::Word(word)) if word == "auto" => Ok(Some(Snap::Auto)),
        Some(_) => Err(CallError::option("snap: neither \"auto\" nor a positive number")),
    }
}

/// The limits of a coverage.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
#[allow(clippy::struct_field_names, reason = "the names are those of the options")]
pub(crate) struct Gaps {
    pub(crate) gap_width: Option<f64>,
    pub(crate) lake_width: Option<f64>,
    pub(crate) accept_gaps: Vec<[f64; 2]>,
    pub(crate) sliver: Option<f64>,
}

impl Gaps {
    /// Refuses limits that are not positive numbers.
    pub(crate) fn checked(&self) -> Result<(), CallError> {
        let all = [("gapWidth", self.gap_width), ("lakeWidth", self.lake_width), ("sliver", self.sliver)];
        match all
            .iter()
            .find(|(_, limit)| limit.is_some_and(|limit| limit.is_nan() || limit <= 0.0 || limit.is_infinite()))
        {
            None => Ok(()),
            Some((name, _)) => Err(CallError::option(format!("{name}: not a positive number"))),
        }
    }

    pub(crate) fn accepted(&self) -> Vec<Point> {
        self.accept_gaps.iter().copied().map(Point::from).collect()
    }
}

/// The options of an audit, and of every function that reads a map.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", deny_unknown_fields)]
#[allow(clippy::struct_excessive_bools, reason = "they are independent switches of JavaScript")]
pub(crate) struct AuditOptions {
    pub(crate) layer: Option<String>,
    pub(crate) list: Option<usize>,
    pub(crate) explain: bool,
    pub(crate) snap: Option<Grid>,
    pub(crate) name_from: Option<String>,
    pub(crate) allow_empty: bool,
    pub(crate) coverage: bool,
    pub(crate) gap_width: Option<f64>,
    pub(crate) lake_width: Option<f64>,
    pub(crate) accept_gaps: Vec<[f64; 2]>,
    pub(crate) sliver: Option<f64>,
    pub(crate) accept: Option<Value>,
    pub(crate) reason: Option<String>,
    pub(crate) geodesic: bool,
    pub(crate) arcs: bool,
    pub(crate) postgis: bool,
    pub(crate) closed: bool,
    pub(crate) borders: Option<usize>,
    pub(crate) genus: Option<usize>,
    pub(crate) components: Option<usize>,
    pub(crate) triangles: bool,
    pub(crate) sides: Option<usize>,
    pub(crate) no_unused_vertices: bool,
}

impl AuditOptions {
    pub(crate) fn map(&self) -> Result<MapOptions, CallError> {
        Ok(MapOptions {
            snap: snap(self.snap.as_ref())?,
            name_from: self.name_from.clone(),
            allow_empty: self.allow_empty,
        })
    }

    fn accepted(&self) -> Result<Option<Accepted>, CallError> {
        let read = |list: &Value| Accepted::read(&list.to_string());
        self.accept.as_ref().map(read).transpose().map_err(|error| CallError::option(format!("accept: {error}")))
    }

    pub(crate) fn options(&self) -> Result<Options, CallError> {
        let gaps = Gaps {
            gap_width: self.gap_width,
            lake_width: self.lake_width,
            accept_gaps: self.accept_gaps.clone(),
            sliver: self.sliver,
        };
        gaps.checked()?;
        let limits = Limits {
            gap_width: gaps.gap_width,
            lake_width: gaps.lake_width,
            accepted_gaps: gaps.accepted(),
            sliver_area: gaps.sliver,
            ..Limits::default()
        };
        let mut mesh = HalfEdgeMesh::expectation();
        if self.closed {
            mesh = mesh.closed();
        }
        if let Some(borders) = self.borders {
            mesh = mesh.borders(borders);
        }
        if let Some(genus) = self.genus {
            mesh = mesh.genus(genus);
        }
        if let Some(components) = self.components {
            mesh = mesh.components(components);
        }
        if let Some(sides) = self.sides.or(self.triangles.then_some(3)) {
            mesh = mesh.sides(sides);
        }
        if self.no_unused_vertices {
            mesh = mesh.no_unused_vertices();
        }
        Ok(Options {
            list: self.list,
            accepted: self.accepted()?,
            explain: self.explain,
            map: self.map()?,
            coverage: CoverageOptions { is_rule: self.coverage, limits },
            geodesic: self.geodesic,
            mesh,
            ..Options::default()
        })
    }
}
