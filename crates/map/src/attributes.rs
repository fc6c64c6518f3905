//! Attributes of a map: values that follow its edits.

use super::edit::EditError;
use super::notes::MapEntry;
use super::planar_map::PlanarMap;
use crate::FeatureId;
use slotmap::{Key, KeyData, SecondaryMap};
use twinedge::dcel::extend::{Attributes, Kind, LogPlace, Recorder as _, Step};
use twinedge::dcel::{
    Attribute, Attributed, Connected, Face, FaceKey, HalfEdge, HalfEdgeKey, Keys, OperatorError, Policy, SplitEdge,
    StaleKey, Value,
};
use twinedge_geometry::Point;

/// # Attributes
///
/// Values that follow edits, each by a [`Policy`]: owners of parcels, their taxes, heights of vertices.
///
/// ```
/// use twinedge::dcel::{Attribute, Faces, History, Policy};
/// use twinedge_map::PlanarMap;
///
/// let mut map = PlanarMap::new();
/// let owner: Attribute<Faces, String> = map.add_attribute(Policy::of_faces().split_copy().merge_equal());
/// let tax: Attribute<Faces, f64> = map.add_attribute(Policy::of_faces().split_share().merge_sum());
/// let parcel = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?.faces_split[0].1;
/// map.set_value(owner, parcel, "Ada")?;
/// map.set_value(tax, parcel, 80.0)?;
///
/// // Both parts are hers, and the tax is shared out by area.
/// let mut history = History::new(map);
/// let fence = history.change("divide", |map| map.insert_segment([1.0, 0.0], [1.0, 4.0]))?;
/// let (kept, made) = fence.faces_split[0];
/// let of = |history: &History<PlanarMap>, face| (history.get().value(owner, face).cloned(), history.get().value(tax, face).copied());
/// assert_eq!([of(&history, kept), of(&history, made)].map(|(owner, _)| owner), [Some("Ada".to_owned()), Some("Ada".to_owned())]);
/// let mut taxes = [kept, made].map(|face| of(&history, face).1.unwrap());
/// taxes.sort_by(f64::total_cmp);
/// assert_eq!(taxes, [20.0, 60.0]);
///
/// // Once a part is sold, the fence stays: the policy refuses, and nothing has changed.
/// history.change("sell a part", |map| map.set_value(owner, made, "Bob"))?;
/// assert!(history.change("open", |map| map.remove_edge(fence.way[0])).is_err());
/// history.undo();
/// let opened = history.change("open", |map| map.remove_edge(fence.way[0]))?;
/// assert_eq!(of(&history, opened.faces_merged[0].0), (Some("Ada".to_owned()), Some(80.0)));
/// # Ok::<(), twinedge_map::edit::EditError>(())
/// ```
///
/// All edits carry values. So do overlays and convex decomposition for faces and features. See
/// [`Dcel`](twinedge::dcel::Dcel#attributes) for the general rules. A map made [from another structure](Self::from_view)
/// [takes over](Self::carry_values) its values.
///
/// [`Edited`](super::edit::Edited) names the records, for data stored in another way.
/// [`insert_segment_snapped`](PlanarMap::insert_segment_snapped) splits, drops and redraws edges that rounding moves. Values
/// follow these steps, also when an edge comes to lie on existing vertices.
///
/// A map with attributes keeps a log of overwritten links, like a [`History`](twinedge::dcel::History), to undo half-done edits.
impl PlanarMap {
    /// Adds an attribute. Records get values by [`set_value`](Self::set_value), and from then on by the policy. O(1), amortised.
    /// If the policy assigns [ids](Policy::ids), the n existing records get theirs at once, except the unbounded face, in O(n).
    ///
    /// ```
    /// use twinedge::dcel::Policy;
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// let parcel = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?.faces_split[0].1;
    /// let number = map.add_attribute(Policy::of_faces().ids(1));
    /// assert_eq!(map.value(number, parcel), Some(&1));
    /// let fence = map.insert_segment([0.0, 0.0], [4.0, 4.0])?;
    /// assert_eq!(map.value(number, fence.faces_split[0].1), Some(&2));
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    pub fn add_attribute<K: Attributed, T: Value>(&mut self, policy: Policy<K, T>) -> Attribute<K, T> {
        self.add_attribute_with(policy, SecondaryMap::new())
    }

    /// Adds an attribute with the [`values`](Self::values) of a saved map; [saving](#impl-Serialize-for-PlanarMap) has an
    /// example. Values under stale keys are left out. O(values), plus the cost of [`add_attribute`](Self::add_attribute).
    pub fn add_attribute_with<K: Attributed, T: Value>(
        &mut self,
        policy: Policy<K, T>,
        values: SecondaryMap<K::Key, T>,
    ) -> Attribute<K, T> {
        if K::KIND == Kind::Other {
            let feature = |key: KeyData| self.present(FeatureId::new(FeatureId::from(key).number())).ok();
            let values: Vec<_> =
                values.into_iter().filter_map(|(k, value)| Some((feature(k.data())?, value))).collect();
            let values = values.into_iter().map(|(feature, value)| (feature.data().into(), value));
            let features =
                if policy.counts() { self.features().filter_map(|f| feature(f.data())).collect() } else { vec![] };
            let features = features.into_iter().map(|feature: FeatureId| feature.data()).collect();
            return self.dcel.add_other_attribute(policy, values, features);
        }
        self.dcel.add_attribute_with(policy, values)
    }

    /// Returns the value of a record, if it has one. O(1).
    #[must_use]
    pub fn value<K: Attributed, T: Value>(&self, of: Attribute<K, T>, key: K::Key) -> Option<&T> {
        self.dcel.value(of, key)
    }

    /// Returns all values of an attribute by key, or `None` for an attribute of another map. O(attributes).
    #[must_use]
    pub fn values<K: Attributed, T: Value>(&self, of: Attribute<K, T>) -> Option<&SecondaryMap<K::Key, T>> {
        self.dcel.values(of)
    }

    /// Returns the record with this value, if the policy [identifies](Policy::identified_by) records by it. O(1), expected.
    #[must_use]
    pub fn find<K: Attributed, T: Value>(&self, of: Attribute<K, T>, value: &T) -> Option<K::Key> {
        self.dcel.find(of, value)
    }

    /// Returns the number that [`Policy::ids`] assigns to the next record, or `None` without such ids. O(attributes).
    #[must_use]
    pub fn next_id<K: Attributed>(&self, of: Attribute<K, u64>) -> Option<u64> {
        self.dcel.next_id(of)
    }

    /// Sets the value of a record and returns the previous one. O(1).
    ///
    /// The value converts to the type of the attribute: `"Ada"` is a value of an attribute of `String`s.
    ///
    /// ```
    /// use twinedge::dcel::{Attribute, Faces, Policy};
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// let owner: Attribute<Faces, String> = map.add_attribute(Policy::of_faces());
    /// let sea = map.dcel().unbounded_face().key();
    /// assert_eq!(map.set_value(owner, sea, "Neptune")?, None);
    /// assert_eq!(map.remove_value(owner, sea)?.as_deref(), Some("Neptune"));
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// A stale key; [`EditError::NoSuchFeature`]; [`OperatorError::NoSuchAttribute`].
    pub fn set_value<K: Attributed, T: Value>(
        &mut self,
        of: Attribute<K, T>,
        key: K::Key,
        value: impl Into<T>,
    ) -> Result<Option<T>, EditError> {
        self.put_value(of, key, Some(value.into()))
    }

    /// Removes and returns the value of a record. O(1).
    ///
    /// # Errors
    /// As for [`set_value`](Self::set_value).
    pub fn remove_value<K: Attributed, T: Value>(
        &mut self,
        of: Attribute<K, T>,
        key: K::Key,
    ) -> Result<Option<T>, EditError> {
        self.put_value(of, key, None)
    }

    pub(super) fn put_value<K: Attributed, T: Value>(
        &mut self,
        of: Attribute<K, T>,
        key: K::Key,
        value: Option<T>,
    ) -> Result<Option<T>, EditError> {
        if K::KIND == Kind::Other {
            // Versions of keys are ignored: only the number counts.
            let known = self.present(FeatureId::new(FeatureId::from(key.data()).number()))?;
            return Ok(self.dcel.put_other_value(of, known.data().into(), value)?);
        }
        Ok(match value {
            Some(value) => self.dcel.set_value(of, key, value)?,
            None => self.dcel.remove_value(of, key)?,
        })
    }

    /// Adds the attributes of another map, with their identities and policies but without values. O(attributes).
    ///
    /// Gives values to a [loaded](#impl-Serialize-for-PlanarMap) map.
    pub fn add_attributes_of(&mut self, other: &Self) {
        self.dcel.add_attributes_of(&other.dcel);
    }

    /// Takes over the attributes, with values, of the map from which this one was [made](Self::from_view). `keys` are the keys
    /// returned then. Features keep their values if both maps have equally many. Existing values of the same attribute stay.
    ///
    /// O(values). [`Dcel::carry_values`](twinedge::dcel::Dcel::carry_values) has an example.
    pub fn carry_values(&mut self, other: &Self, keys: &Keys) {
        let count = self.names.len();
        let feature = |old: KeyData| (FeatureId::from(old).index() < count).then_some(old);
        self.dcel.carry_all_values(&other.dcel, keys, feature);
    }

    /// Takes over the attributes of another map, with the values of its features and faces, where this map cuts each of its faces
    /// into parts. `within` returns the other map's face that contains a face of this map, if any does. `feature` returns this
    /// map's feature for a feature of the other map.
    ///
    /// The largest part inherits a face's value; the policy splits the other parts off it. Values of faces without parts and of
    /// features unknown to this map are dropped. Existing values of the same attribute stay. This serves maps that are built
    /// anew, such as overlays (`twinedge_algorithm::overlay`). O(n log n).
    ///
    /// ```
    /// use twinedge::dcel::{Faces, Policy};
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut old = PlanarMap::new();
    /// let tax = old.add_attribute(Policy::<Faces, f64>::of_faces().split_share());
    /// let ring = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    /// let parcel = old.insert_ring(ring)?.faces_split[0].1;
    /// old.set_value(tax, parcel, 80.0)?;
    ///
    /// let mut new = PlanarMap::new();
    /// new.insert_ring(ring)?;
    /// new.insert_segment([1.0, 0.0], [1.0, 4.0])?;
    /// let inside: Vec<_> = new.dcel().faces().filter(|f| !f.is_unbounded()).map(|f| f.key()).collect();
    /// new.carry_parts(&old, |face| inside.contains(&face.key()).then_some(parcel), |_| None)?;
    /// let mut taxes: Vec<f64> = inside.iter().map(|face| *new.value(tax, *face).unwrap()).collect();
    /// taxes.sort_by(f64::total_cmp);
    /// assert_eq!(taxes, [20.0, 60.0]);
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`Refused`](OperatorError::Refused), with nothing taken over.
    pub fn carry_parts(
        &mut self,
        other: &Self,
        within: impl Fn(Face<'_>) -> Option<FaceKey>,
        feature: impl Fn(FeatureId) -> Option<FeatureId>,
    ) -> Result<(), OperatorError> {
        let Some(attributes) = other.attributes() else { return Ok(()) };
        let old = other.dcel.faces().map(|f| (f.key(), Vec::new()));
        let mut parts: SecondaryMap<FaceKey, Vec<(KeyData, f64)>> = old.collect();
        for face in self.dcel.faces() {
            if let Some(parts) = within(face).and_then(|old| parts.get_mut(old)) {
                parts.push((face.key().data(), self.area(face)));
            }
        }
        let mut faces: Vec<_> = parts.into_iter().map(|(old, parts)| (old.data(), parts)).collect();
        for (_, parts) in &mut faces {
            largest_first(parts);
        }
        let known = |new: FeatureId| self.feature(new.index());
        let features: Vec<_> =
            other.features().map(|old| (old.data(), feature(old).and_then(known).map(|new| new.data()))).collect();
        let cut = attributes.cut(&faces, &features).map_err(OperatorError::Refused)?;
        self.dcel.add_attributes(cut);
        Ok(())
    }

    fn attributes(&self) -> Option<&Attributes> {
        self.dcel.attributes()
    }

    /// Applies a step to the values of features, before the features themselves change.
    pub(super) fn follow_feature(&mut self, step: Step) -> Result<(), OperatorError> {
        let Some(attributes) = self.dcel.attributes_to_change() else { return Ok(()) };
        attributes.follow(&[(Kind::Other, step)]).map_err(OperatorError::Refused)
    }

    /// Runs several edits as one. If a policy refuses one, the earlier ones are undone. A map without attributes undoes nothing.
    ///
    /// # Errors
    /// Returns the error of the closure.
    pub fn atomically<T, E>(&mut self, edit: impl FnOnce(&mut Self) -> Result<T, E>) -> Result<T, E> {
        if self.attributes().is_some() { self.rewinding(edit) } else { edit(self) }
    }

    /// Runs an edit and undoes it on error, on a map with or without attributes.
    #[cold]
    pub(super) fn rewinding<T, E>(&mut self, edit: impl FnOnce(&mut Self) -> Result<T, E>) -> Result<T, E> {
        let is_logged = self.dcel.log_place().is_some();
        if !is_logged {
            self.begin_logs();
        }
        let values = self.attributes().map_or(0, Attributes::log_len);
        let (links, entries) = (self.dcel.log_place(), self.notes.len());
        let outcome = edit(self);
        if let (Err(_), Some(links)) = (&outcome, links) {
            self.rewind(links, entries, values);
        }
        if !is_logged {
            self.end_logs();
        }
        outcome
    }

    /// Undoes all writes since a place in the log of links, and all but the first entries of the logs of features and values.
    fn rewind(&mut self, links: LogPlace, entries: usize, values: usize) {
        let mut others = self.notes.split_off(entries);
        if let Some(attributes) = self.dcel.attributes_mut() {
            others.extend(attributes.split_log(values).into_iter().map(MapEntry::Value));
        }
        let links = self.dcel.roll_back(links);
        self.rewrite(links, &mut others);
    }

    /// Divides the value of a split edge between its two parts by length, and interpolates a value for the new vertex.
    pub(super) fn measure_split_edge(&mut self, h: HalfEdgeKey, made: SplitEdge) -> Result<(), StaleKey> {
        let Some(attributes) = self.attributes() else { return Ok(()) };
        let is_measured =
            attributes.interpolates() || [Kind::Edge, Kind::HalfEdge].iter().any(|kind| attributes.shares(*kind));
        if !is_measured {
            return Ok(());
        }
        let (h, n) = (self.dcel.half_edge(h)?, self.dcel.half_edge(made.half_edge)?);
        let length = |h: HalfEdge<'_>| {
            let [Point { x, y }, to] = [h.origin(), h.target()].map(|v| self.points[v.index()]);
            (to.x - x).hypot(to.y - y)
        };
        let part = fraction(length(n), length(h));
        let ends = [h.origin(), n.target()].map(|v| v.key().data());
        let edges = [h, n].map(|h| if h.index() < h.twin().index() { h } else { h.twin() }.key().data());
        let sides = [[h, n].map(|h| h.key().data()), [h, n].map(|h| h.twin().key().data())];
        let Some(attributes) = self.dcel.attributes_mut() else { return Ok(()) };
        attributes.share(Kind::Edge, edges, part);
        for side in sides {
            attributes.share(Kind::HalfEdge, side, part);
        }
        attributes.interpolate(made.vertex.data(), ends, 1.0 - part);
        Ok(())
    }

    /// Divides the value of a split face between its two parts by area.
    pub(super) fn measure_connected(&mut self, connected: Connected) -> Result<(), StaleKey> {
        let Some(made) = connected.new_face().filter(|_| self.attributes().is_some_and(|all| all.shares(Kind::Face)))
        else {
            return Ok(());
        };
        let h = self.dcel.half_edge(connected.half_edge)?;
        let sides = [h, h.twin()].map(|h| h.face());
        let old = if sides[0].key() == made { sides[1] } else { sides[0] };
        let part = fraction(self.area(self.dcel.face(made)?), self.area(old));
        let parts = [old.key().data(), made.data()];
        if let Some(attributes) = self.dcel.attributes_mut() {
            attributes.share(Kind::Face, parts, part);
        }
        Ok(())
    }

    /// Records which of the two faces of an edge is larger, if either is.
    pub(super) fn measure_beside(&mut self, h: HalfEdgeKey) -> Result<(), StaleKey> {
        if !self.attributes().is_some_and(Attributes::is_by_area) {
            return Ok(());
        }
        let h = self.dcel.half_edge(h)?;
        let [left, right] = [h, h.twin()].map(|h| (self.area(h.face()), h.face().key().data()));
        let larger: Option<KeyData> =
            if left.0 > right.0 { Some(left.1) } else { (left.0 < right.0).then_some(right.1) };
        if let Some(attributes) = self.dcel.attributes_mut() {
            attributes.set_larger(larger);
        }
        Ok(())
    }

    /// The area of a face, by the shoelace formula over triangles that share a point. The unbounded face has an infinite area.
    fn area(&self, face: Face<'_>) -> f64 {
        let Some(first) = face.outer_half_edge() else { return f64::INFINITY };
        let o = self.points[first.origin().index()];
        let twice = face.half_edges().map(|h| {
            let [a, b] = [h.origin(), h.target()].map(|v| self.points[v.index()]);
            (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y)
        });
        twice.sum::<f64>() / 2.0
    }
}

fn largest_first(parts: &mut [(KeyData, f64)]) {
    parts.sort_by(|a, b| b.1.total_cmp(&a.1));
}

/// Returns `one / (one + other)`, or 0 if the quotient is not finite.
fn fraction(one: f64, other: f64) -> f64 {
    let part = one / (one + other);
    if part.is_finite() { part.clamp(0.0, 1.0) } else { 0.0 }
}
