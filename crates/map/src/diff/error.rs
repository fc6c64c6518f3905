//! Errors of comparing, applying and merging.

use super::record::{Change, Record};
use crate::NotPlane;
use crate::edit::EditError;
use std::fmt;
use thiserror::Error;
use twinedge::dcel::{FaceKey, StaleKey, VertexKey};

/// The error of a map whose records cannot be identified.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum DiffError {
    /// A map is not plane.
    #[error(transparent)]
    NotPlane(#[from] NotPlane),
    /// A map lacks an attribute: the ids, or an attribute whose values are compared.
    #[error("a map lacks an attribute of the ids or of the values: `add_attributes_of` adds those of another map")]
    NoSuchAttribute,
    /// A vertex has no id.
    #[error("{0:?} has no id")]
    VertexWithoutId(VertexKey),
    /// A bounded face has no id.
    #[error("{0:?} has no id")]
    FaceWithoutId(FaceKey),
    /// Two records of a map have the same id.
    #[error("{0} is there twice")]
    SameId(Record),
    /// The second map doesn't begin with the features of the first. A feature must keep its number, and its name unless removed.
    #[error("the maps differ in feature {0}")]
    Features(usize),
}

/// The error of a diff that cannot be applied to a map. The map is unchanged.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ApplyError {
    /// The records of the map cannot be identified.
    #[error(transparent)]
    Diff(#[from] DiffError),
    /// The diff belongs to another map: this record differs from its state there.
    #[error("the diff is of another map: {0} is not as it was there")]
    AnotherMap(Record),
    /// The map has no attribute of this name, or the text is not a valid value.
    #[error("{record} cannot have the value of {name}")]
    Value {
        /// The record.
        record: Record,
        /// The name of the attribute.
        name: String,
    },
    /// A vertex or an edge would lie on another one, or cross it.
    #[error("{drawn} would meet {with}")]
    Overlap {
        /// The moved, added or drawn record.
        drawn: Record,
        /// The existing record.
        with: Record,
    },
    /// Two faces would become one.
    #[error("{0} and {1} would be one face")]
    OneFace(Record, Record),
    /// The outline of a face would bound several faces.
    #[error("the outline of {0} would not be that of one face")]
    NotOneFace(Record),
    /// An edge would bound a face that has no id.
    #[error("{0} would bound a face without id")]
    Unnamed(Record),
    /// An edit was refused.
    #[error(transparent)]
    Edit(#[from] EditError),
}

impl From<StaleKey> for ApplyError {
    fn from(key: StaleKey) -> Self {
        Self::Edit(key.into())
    }
}

/// The error of a merge.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum MergeError {
    /// The records of a map cannot be identified.
    #[error(transparent)]
    Diff(#[from] DiffError),
    /// The two diffs are not of the same map.
    #[error("the diffs are of different maps")]
    DifferentMaps,
    /// Both sides changed the same things.
    #[error("conflicts: {}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))]
    Conflicts(Vec<Conflict>),
    /// No record was changed on both sides, but the combined changes draw no map with these faces.
    #[error("the changes of both sides do not fit: {0}")]
    Together(ApplyError),
}

/// Two conflicting changes, one from each side.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Conflict {
    /// The record that our side changed, and the change.
    pub ours: (Record, Change),
    /// The record that their side changed, and the change.
    pub theirs: (Record, Change),
}

impl fmt::Display for Conflict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { ours, theirs } = self;
        write!(f, "ours: {} {}, theirs: {} {}", ours.0, ours.1, theirs.0, theirs.1)
    }
}
