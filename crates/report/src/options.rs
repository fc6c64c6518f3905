//! The options of an audit.

use crate::accepted::Accepted;
use crate::coverage::CoverageOptions;
use crate::error::Error;
use crate::imported::MapOptions;
use crate::input::Input;
use std::str::FromStr;
use twinedge::validate::{Collect, Expectation};
use twinedge_layers::Format;
use twinedge_meshes::{HalfEdgeMesh, SpaceRule};

/// The shape of the edges of a map of longitudes and latitudes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edges {
    /// Straight on the map.
    Straight,
    /// Arcs of great circles.
    Geodesic,
}

/// The options of an audit. Options for other kinds of input are ignored.
#[derive(Clone, Debug)]
pub struct Options {
    /// The greatest number of violations to list, and of findings of each rule C1 … C7; all are counted. `None` lists 1000, and 3 findings of each of
    /// C1 … C7 in text.
    pub list: Option<usize>,
    /// True to keep causes and remedies.
    pub explain: bool,
    /// The options for building a map.
    pub map: MapOptions,
    /// The limits by which a coverage is judged.
    pub coverage: CoverageOptions,
    /// The accepted findings of the coverage.
    pub accepted: Option<Accepted>,
    /// The column by which parts name their parents, to check that parents consist of their parts.
    pub parent: Option<ParentColumn>,
    /// True to measure lengths in metres along geodesics.
    pub geodesic: bool,
    /// The shape of edges. `None`: great circles if a file of longitudes and latitudes declares edges that are not planar, otherwise straight.
    pub edges: Option<Edges>,
    /// The properties that a mesh must have.
    pub mesh: Expectation,
    /// The rules to check about the places of a mesh's points.
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
    /// Refuses options that edges along great circles exclude. The parameter names another given option of that kind.
    pub(crate) fn refuse_with_geodesic(&self, beside: Option<&'static str>) -> Result<(), Error> {
        let given = [(self.geodesic, "--geodesic"), (self.map.snap.is_some(), "--snap")];
        let own = given.into_iter().find(|(is_given, _)| *is_given).map(|(_, option)| option);
        match beside.or(own).filter(|_| self.edges == Some(Edges::Geodesic)) {
            Some(option) => Err(Error::NotGeodesic(option)),
            None => Ok(()),
        }
    }

    /// Returns true if the file decides the shape of edges: its format can, and no option contradicts.
    pub(crate) fn may_be_said(&self, input: &mut Input) -> Result<bool, Error> {
        let is_asked = self.edges.is_some() || self.geodesic || self.map.snap.is_some();
        Ok(!is_asked && input.map_format()? == Some(Format::GeoParquet))
    }

    pub(crate) fn most(&self) -> usize {
        self.list.unwrap_or(Collect::DEFAULT_CAP)
    }
}

/// The column in which parts name their parents, and the column with this value in the parents. By default, that is the column of the same name in
/// the other layer, or else the ids, or else the names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParentColumn {
    /// The column of the parts.
    pub column: String,
    /// The column of the parents.
    pub key: Option<String>,
}

impl FromStr for ParentColumn {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (column, key) = text.split_once('=').map_or((text, None), |(column, key)| (column, Some(key)));
        if column.is_empty() || key == Some("") {
            return Err("neither COLUMN nor COLUMN=KEY");
        }
        Ok(Self { column: column.to_owned(), key: key.map(str::to_owned) })
    }
}

impl ParentColumn {
    pub(crate) fn columns(&self, has_other: bool) -> Vec<String> {
        let key = self.key.iter().filter(|_| !has_other);
        std::iter::once(&self.column).chain(key).cloned().collect()
    }
}
