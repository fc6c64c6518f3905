//! The features that cover each face, and the features that run along each edge.
//!
//! A map contains few distinct sets of features, mostly shared by many faces or edges: a country on each of its faces, two
//! countries along their border. So every set is stored once, permanently, and a face or an edge holds its number. Copying the
//! features of a face, the most common step of edits, copies one number.

use super::feature_tries::{FeatureTries, Members, SetId, SetOperation};
use crate::FeatureId;
use std::collections::BTreeSet;

/// The sets of features of the faces and edges of a map, by index.
#[derive(Clone, Debug, Default)]
pub(super) struct FeatureSets {
    sets: FeatureTries,
    faces: Vec<SetId>,
    /// Indexed by half the index of either half-edge.
    edges: Vec<SetId>,
    /// The removed features, whose numbers are not reused.
    pub(super) removed: BTreeSet<FeatureId>,
}

impl FeatureSets {
    /// Returns the number of the set of one feature. O(1), expected.
    pub(super) fn single(&mut self, feature: FeatureId) -> SetId {
        self.sets.single(feature)
    }

    /// Returns the number of the set of these features. O(features · log), expected.
    pub(super) fn number(&mut self, features: impl IntoIterator<Item = FeatureId>) -> SetId {
        self.sets.number(features)
    }

    /// Returns the features of a set, in order. O(log features) for the first, O(1) on average for each other.
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

    /// Returns the intersection. O(log features) for each feature in only one set, as for the next two operations.
    pub(super) fn common(&mut self, a: SetId, b: SetId) -> SetId {
        self.sets.combined(SetOperation::Common, a, b)
    }

    pub(super) fn either(&mut self, a: SetId, b: SetId) -> SetId {
        self.sets.combined(SetOperation::Either, a, b)
    }

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
