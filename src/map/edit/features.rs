//! Saying which features there are, what they cover, and where they run.

use super::error::EditError;
use crate::dcel::{FaceKey, HalfEdgeKey};
use crate::map::feature::FeatureId;
use crate::map::feature_sets::FeatureSets;
#[cfg(feature = "near")]
use crate::map::notes::MapEntry;
use crate::map::planar_map::PlanarMap;

impl PlanarMap {
    /// Adds a feature that covers nothing yet. O(1), amortised.
    ///
    /// ```
    /// use twinedge::map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// let ring = map.insert_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])?;
    /// let (_, inside) = ring.faces_split[0];
    /// let garden = map.add_feature(Some("garden".into()));
    /// map.set_features_of(inside, [garden])?;
    /// for edge in ring.way {
    ///     map.set_features_along(edge, [garden])?;
    /// }
    /// assert!(map.features_of(inside)?.eq([garden]));
    /// assert_eq!(twinedge::algorithm::area::feature_area(&map, garden), 0.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn add_feature(&mut self, name: Option<String>) -> FeatureId {
        #[cfg(feature = "near")]
        self.notes.write(|| MapEntry::Feature(None));
        self.names.push(name);
        FeatureId(self.names.len() as u32 - 1)
    }

    /// Says which features cover a face, in place of those that did. O(k log k) for k features. For an example see
    /// [`add_feature`](Self::add_feature).
    ///
    /// # Errors
    /// A stale key; [`EditError::NoSuchFeature`]. Nothing changes then.
    pub fn set_features_of(
        &mut self,
        face: FaceKey,
        features: impl IntoIterator<Item = FeatureId>,
    ) -> Result<(), EditError> {
        let index = self.dcel.face(face)?.index();
        let set = self.checked(features)?;
        let set = self.features.number(set);
        self.cover_face(index, set);
        Ok(())
    }

    /// Says which features run along an edge, in place of those that did. O(k log k) for k features. For an example see
    /// [`add_feature`](Self::add_feature).
    ///
    /// # Errors
    /// A stale key; [`EditError::NoSuchFeature`]. Nothing changes then.
    pub fn set_features_along(
        &mut self,
        half_edge: HalfEdgeKey,
        features: impl IntoIterator<Item = FeatureId>,
    ) -> Result<(), EditError> {
        let index = self.dcel.half_edge(half_edge)?.index();
        let set = self.checked(features)?;
        let set = self.features.number(set);
        self.cover_edge(index, set);
        Ok(())
    }

    /// Takes all features away, and the numbers that were given to them.
    pub(crate) fn forget_features(&mut self) {
        self.names.clear();
        self.features = FeatureSets::default();
    }

    /// The features in order, each once.
    fn checked(&self, features: impl IntoIterator<Item = FeatureId>) -> Result<Vec<FeatureId>, EditError> {
        let mut set: Vec<FeatureId> = features.into_iter().collect();
        if let Some(unknown) = set.iter().find(|feature| feature.index() >= self.names.len()) {
            return Err(EditError::NoSuchFeature(*unknown));
        }
        set.sort_unstable();
        set.dedup();
        Ok(set)
    }
}
