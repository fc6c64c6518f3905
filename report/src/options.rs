//! The options of an audit.

use crate::accepted::Accepted;
use crate::coverage::CoverageOptions;
use crate::error::Error;
use crate::imported::MapOptions;
use crate::input::Input;
use crate::parent_column::ParentColumn;
use twinedge::validate::{Collect, Expectation};
use twinedge_formats::layer::Format;
use twinedge_formats::mesh::{HalfEdgeMesh, SpaceRule};

/// The shape of the edges of a map of longitudes and latitudes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edges {
    /// Straight on the map.
    Straight,
    /// Arcs of great circles.
    Geodesic,
}

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
    /// The shape of edges. None: great circles, if a file of longitudes and latitudes says that its edges are not planar, or else straight.
    pub edges: Option<Edges>,
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
            edges: None,
            mesh: HalfEdgeMesh::expectation(),
            space: Vec::new(),
        }
    }
}

impl Options {
    /// Refuses what does not go with edges along great circles. `beside` is another option of that kind that is given.
    pub(crate) fn refuse_with_geodesic(&self, beside: Option<&'static str>) -> Result<(), Error> {
        let given = [(self.geodesic, "--geodesic"), (self.map.snap.is_some(), "--snap")];
        let own = given.into_iter().find(|(is_given, _)| *is_given).map(|(_, option)| option);
        match beside.or(own).filter(|_| self.edges == Some(Edges::Geodesic)) {
            Some(option) => Err(Error::NotGeodesic(option)),
            None => Ok(()),
        }
    }

    /// Returns true if edges are great circles if the file says so: if it may, and nothing else is asked for.
    pub(crate) fn may_be_said(&self, input: &mut Input) -> Result<bool, Error> {
        let is_asked = self.edges.is_some() || self.geodesic || self.map.snap.is_some();
        Ok(!is_asked && input.map_format()? == Some(Format::GeoParquet))
    }

    /// Greatest number of violations to list.
    pub(crate) fn most(&self) -> usize {
        self.list.unwrap_or(Collect::DEFAULT_CAP)
    }
}
