//! The options of an audit.

use crate::accepted::Accepted;
use crate::coverage::CoverageOptions;
use crate::imported::MapOptions;
use crate::parent_column::ParentColumn;
use twinedge::validate::{Collect, Expectation};
use twinedge_formats::mesh::{HalfEdgeMesh, SpaceRule};

/// The options of an audit. Those that are for other kinds of inputs are not looked at.
#[derive(Clone, Debug)]
pub struct Options {
    /// Greatest number of violations to list, and of findings of each rule C1 … C7; all are counted. None: 1000, and in the text 3 findings
    /// of each of C1 … C7.
    pub list: Option<usize>,
    /// Causes and remedies are kept.
    pub explain: bool,
    /// The way to build a map.
    pub map: MapOptions,
    /// The limits by which a coverage is judged.
    pub coverage: CoverageOptions,
    /// The findings of the coverage that are accepted. Those that are not listed are not.
    pub accepted: Option<Accepted>,
    /// The column by which parts name their parents, if parents are to be made up by their parts.
    pub parent: Option<ParentColumn>,
    /// Lengths in metres along geodesics.
    pub geodesic: bool,
    /// The properties that a mesh must have.
    pub mesh: Expectation,
    /// The rules about the places of its points that are checked.
    pub space: Vec<SpaceRule>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            list: None,
            explain: false,
            map: MapOptions::default(),
            coverage: CoverageOptions::default(),
            accepted: None,
            parent: None,
            geodesic: false,
            mesh: HalfEdgeMesh::expectation(),
            space: Vec::new(),
        }
    }
}

impl Options {
    /// Greatest number of violations to list.
    pub(crate) fn most(&self) -> usize {
        self.list.unwrap_or(Collect::DEFAULT_CAP)
    }
}
