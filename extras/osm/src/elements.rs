//! The selected relations of a file, with their ways and nodes.

use crate::filter::TagFilter;
use rustc_hash::FxHashMap;
use std::io;
use twinedge_geometry::Point;

/// The error of reading a file of `OpenStreetMap`.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OsmError {
    /// The file could not be read.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// The content is not valid in the format.
    #[error("this is no .osm.pbf file, or a damaged one: {0}")]
    Content(String),
    /// The file needs an unsupported capability, such as reading several versions of an element.
    #[error("the file needs readers that know of {0}, which is not read here")]
    Needs(String),
    /// No relation has these tags.
    #[error("no relation of the type boundary or multipolygon has the tags {0}")]
    None(TagFilter),
    /// The crate was built without the feature that reads these files.
    #[error(
        ".osm.pbf is read with the feature `pbf` of twinedge-osm, which is off (the program has it with `--features full`)"
    )]
    FeatureOff,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Relation {
    pub(crate) id: i64,
    pub(crate) tags: Vec<(String, String)>,
    /// The ways that are members as borders, in order.
    pub(crate) members: Vec<Member>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Member {
    pub(crate) way: i64,
    pub(crate) role: Role,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// No role is stated.
    Any,
    Outer,
    Inner,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Elements {
    pub(crate) relations: Vec<Relation>,
    pub(crate) ways: FxHashMap<i64, Vec<i64>>,
    pub(crate) nodes: FxHashMap<i64, Point>,
}

#[cfg(not(feature = "pbf"))]
impl Elements {
    pub(crate) fn read(_: &std::path::Path, _: &TagFilter) -> Result<Self, OsmError> {
        Err(OsmError::FeatureOff)
    }
}
