//! The features that cover each face, and those that run along each edge.
//!
//! Few sets of features occur on a map, and most of them on many faces or edges: a country on each of its faces, two
//! countries along their border. So every set is kept once, for good, and a face or an edge holds its number. Giving a new
//! face the set of another is a copy of one number, which is what edits do most.

use super::feature_tries::{FeatureTries, Members, SetId, SetOperation};
use crate::FeatureId;
use std::collections::BTreeSet;

/// The sets of features of the faces and edges of a map, by index.
#[derive(Clone, Debug, Default)]
pub(super) struct FeatureSets {
    sets: FeatureTries,
    faces: Vec<SetId>,
    /// By half the index of either half-edge.
    edges: Vec<SetId>,
    /// The features that were removed: their numbers are not given to others.
    pub(super) removed: BTreeSet<FeatureId>,
}

impl FeatureSets {
    /// The number of the set of one feature. O(1), expected.
    pub(super) fn single(&mut self, feature: FeatureId) -> SetId {
        self.sets.single(feature)
    }

    /// The number of the set of these features. O(features · log), expected.
    pub(super) fn number(&mut self, features: impl IntoIterator<Item = FeatureId>) -> SetId {
        self.sets.number(features)
    }

    /// The features of a set, in order. O(log features) for the first, O(1) for each other on average.
    pub(super) fn set(&self, number: SetId) -> Members<'_> {
        self.sets.members(number)
    }

    /// Returns the features that cover the face with this index. O(1).
    pub(super) fn of_face(&self, face: usize) -> SetId {
        self.faces.get(face).copied().unwrap_or_default()
    }

    /// Returns the features along the edge of the half-edge with this index. O(1).
    pub(super) fn along(&self, half_edge: usize) -> SetId {
        self.edges.get(half_edge / 2).copied().unwrap_or_default()
    }

    pub(super) fn put_face(&mut self, face: usize, set: SetId) {
        put(&mut self.faces, face, set);
    }

    pub(super) fn put_along(&mut self, half_edge: usize, set: SetId) {
        put(&mut self.edges, half_edge / 2, set);
    }

    /// The set of those in both. O(log features) for each feature in one only, as for the next two.
    pub(super) fn common(&mut self, a: SetId, b: SetId) -> SetId {
        self.sets.combined(SetOperation::Common, a, b)
    }

    /// The set of those in either.
    pub(super) fn either(&mut self, a: SetId, b: SetId) -> SetId {
        self.sets.combined(SetOperation::Either, a, b)
    }

    /// The set of those in one and not in the other.
    pub(super) fn differing(&mut self, a: SetId, b: SetId) -> SetId {
        self.sets.combined(SetOperation::Differing, a, b)
    }
}

/// Writes into a column, which grows as needed.
pub(super) fn put<T: Copy + Default>(column: &mut Vec<T>, index: usize, value: T) {
    if index >= column.len() {
        column.resize(index + 1, T::default());
    }
    column[index] = value;
}
