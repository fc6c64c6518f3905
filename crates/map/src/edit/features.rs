//! Adding and removing features, and assigning them to faces and edges.

use super::error::EditError;
use crate::FeatureId;
use crate::feature_sets::FeatureSets;
use crate::feature_tries::SetId;
use crate::notes::MapEntry;
use crate::planar_map::PlanarMap;
use slotmap::Key;
use twinedge::dcel::extend::Step;
use twinedge::dcel::{FaceKey, HalfEdgeKey};

impl PlanarMap {
    /// Adds a feature that covers nothing yet. O(1), amortised.
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
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
    /// assert_eq!(twinedge_algorithm::area::feature_area(&map, garden), 0.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn add_feature(&mut self, name: Option<String>) -> FeatureId {
        self.notes.write(|| MapEntry::Feature(None));
        let feature = FeatureId::new(self.names.len() as u32);
        self.names.push(name);
        // A feature is added even if all ids are used up.
        let _ = self.follow_feature(Step::Make(feature.data()));
        feature
    }

    /// Removes a feature from all faces and edges, and returns its name.
    ///
    /// Its number is never reused: it remains the number of an unnamed feature that covers nothing and cannot be assigned again.
    ///
    /// O((faces + edges) · log features).
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// let inside = map.insert_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])?.faces_split[0].1;
    /// let garden = map.add_feature(Some("garden".into()));
    /// map.set_features_of(inside, [garden])?;
    /// assert_eq!(map.remove_feature(garden)?.as_deref(), Some("garden"));
    /// assert_eq!(map.features_of(inside)?.count(), 0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NoSuchFeature`], also after a removal; [`EditError::Operator`] if the policy of an attribute refuses. Nothing
    /// changes then.
    pub fn remove_feature(&mut self, feature: FeatureId) -> Result<Option<String>, EditError> {
        self.checked([feature])?;
        self.follow_feature(Step::Drop(feature.data()))?;
        Ok(self.replace_feature(feature, SetId::default()))
    }

    /// Merges two features: `dropped` is [removed](Self::remove_feature), and `kept` takes its place on all faces and edges.
    ///
    /// O((faces + edges) · log features).
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// let inside = map.insert_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])?.faces_split[0].1;
    /// let [town, village] = ["town", "village"].map(|name| map.add_feature(Some(name.into())));
    /// map.set_features_of(inside, [village])?;
    /// map.merge_features(town, village)?;
    /// assert!(map.features_of(inside)?.eq([town]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As for [`remove_feature`](Self::remove_feature).
    pub fn merge_features(&mut self, kept: FeatureId, dropped: FeatureId) -> Result<(), EditError> {
        self.checked([kept, dropped])?;
        if kept != dropped {
            self.follow_feature(Step::Merge(kept.data(), dropped.data()))?;
            let kept = self.features.single(kept);
            self.replace_feature(dropped, kept);
        }
        Ok(())
    }

    /// Replaces a feature by the features of a set everywhere, and removes and returns its name.
    fn replace_feature(&mut self, feature: FeatureId, others: SetId) -> Option<String> {
        let single = self.features.single(feature);
        let faces: Vec<usize> = self.dcel.faces().map(|f| f.index()).collect();
        for face in faces {
            let set = self.features.of_face(face);
            if self.features.common(set, single) == single {
                let rest = self.features.differing(set, single);
                let set = self.features.either(rest, others);
                self.cover_face(face, set);
            }
        }
        let edges: Vec<usize> = self.dcel.edges().map(|h| h.index()).collect();
        for edge in edges {
            let set = self.features.along(edge);
            if self.features.common(set, single) == single {
                let rest = self.features.differing(set, single);
                let set = self.features.either(rest, others);
                self.cover_edge(edge, set);
            }
        }
        self.features.removed.insert(feature);
        let name = self.names[feature.index()].take();
        self.notes.write(|| MapEntry::Name(feature.number(), name.clone().map(String::into_boxed_str)));
        name
    }

    /// Sets the features that cover a face, replacing the previous ones. O(k log k) for k features.
    /// [`add_feature`](Self::add_feature) has an example.
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

    /// Sets the features that run along an edge, replacing the previous ones. O(k log k) for k features.
    /// [`add_feature`](Self::add_feature) has an example.
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

    /// Removes all features and frees their numbers. This is not logged. O(features).
    pub fn forget_features(&mut self) {
        self.names.clear();
        self.features = FeatureSets::default();
    }

    fn checked(&self, features: impl IntoIterator<Item = FeatureId>) -> Result<Vec<FeatureId>, EditError> {
        let mut set = features.into_iter().map(|feature| self.present(feature)).collect::<Result<Vec<_>, _>>()?;
        set.sort_unstable();
        set.dedup();
        Ok(set)
    }

    /// Returns the feature, unless it is not a feature of the map or was removed.
    pub(crate) fn present(&self, feature: FeatureId) -> Result<FeatureId, EditError> {
        let is_present = feature.index() < self.names.len() && !self.features.removed.contains(&feature);
        is_present.then_some(feature).ok_or(EditError::NoSuchFeature(feature))
    }
}
