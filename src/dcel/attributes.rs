//! Attributes of a structure: values that follow its operators.

use super::access::{OperatorError, StaleKey};
use super::import::Keys;
use super::structure::Dcel;
use crate::store::attributes::{Attribute, Attributed, Attributes, Edges, Kind, Policy, Value};
use crate::store::{FaceKey, HalfEdgeKey, VertexKey};
use alloc::vec::Vec;
use slotmap::{Key, KeyData, SecondaryMap};

/// # Attributes
///
/// Values attached to records. Operators update them by a [`Policy`] per attribute: when faces are split and merged, edges made and
/// dropped.
///
/// ```
/// use twinedge::dcel::{Dcel, Faces, OperatorError, Policy, Split};
///
/// let mut map = Dcel::new();
/// let owner = map.add_attribute(Policy::<Faces, &str>::of_faces().split_copy().merge_equal());
/// let outside = map.unbounded_face().key();
/// // A loop with another vertex on it, and its face.
/// let v = map.add_isolated_vertex(outside)?.vertex;
/// let ring = map.connect(v, v, Split::default())?;
/// let (h, inside) = (ring.half_edge, ring.new_face().unwrap());
/// map.split_edge(h)?;
/// map.set_value(owner, inside, "Ada")?;
///
/// // Both parts of a face that is split are hers.
/// let next = map.half_edge(h)?.next().key();
/// let fence = map.connect(h, next, Split::default())?;
/// assert_eq!(map.value(owner, fence.new_face().unwrap()), Some(&"Ada"));
/// // Other parts are not merged.
/// map.set_value(owner, inside, "Bob")?;
/// assert!(matches!(map.remove_edge(fence.half_edge), Err(OperatorError::Refused(_))));
/// assert_eq!(map.face_count(), 3);
/// # Ok::<(), OperatorError>(())
/// ```
///
/// All operators carry attributes, and so do [`retain`](Dcel::retain) and [`compact`](Dcel::compact). A [`History`](super::History)
/// undoes and redoes them with the structure. A clone has the same attributes and values. They are neither compared nor saved with the
/// structure: save the [`values`](Dcel::values) alongside, and assign them to the same keys after loading.
///
/// A structure without attributes pays nothing for them. For each attribute, an operator takes O(1) per record that it makes, splits,
/// merges or drops, plus the time of the policy's functions.
impl Dcel {
    /// Returns the value of a record, if it has one. O(1).
    #[must_use]
    pub fn value<K: Attributed, T: Value>(&self, of: Attribute<K, T>, key: K::Key) -> Option<&T> {
        self.values(of)?.get(self.record_key::<K>(key).ok()?)
    }

    /// Returns all values of an attribute by key; `None` if the attribute belongs to another structure. O(attributes).
    #[must_use]
    pub fn values<K: Attributed, T: Value>(&self, of: Attribute<K, T>) -> Option<&SecondaryMap<K::Key, T>> {
        self.store.attributes()?.values(of)
    }

    /// Returns the record with this value, if the policy [indexes](Policy::identified_by) values. O(1), expected. For an example see
    /// [`Policy::ids`].
    #[must_use]
    pub fn find<K: Attributed, T: Value>(&self, of: Attribute<K, T>, value: &T) -> Option<K::Key> {
        self.store.attributes()?.find(of, value)
    }

    /// Returns the next number that [`Policy::ids`] will assign; `None` if the attribute assigns no ids. O(attributes).
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, OperatorError, Policy};
    ///
    /// let mut map = Dcel::new();
    /// let id = map.add_attribute(Policy::of_vertices().ids(7));
    /// let v = map.add_isolated_vertex(map.unbounded_face().key())?.vertex;
    /// map.remove_isolated_vertex(v)?;
    /// assert_eq!(map.next_id(id), Some(8));
    /// # Ok::<(), OperatorError>(())
    /// ```
    #[must_use]
    pub fn next_id<K: Attributed>(&self, of: Attribute<K, u64>) -> Option<u64> {
        self.store.attributes()?.next_id(of)
    }

    fn record_key<K: Attributed>(&self, key: K::Key) -> Result<K::Key, StaleKey> {
        let data = key.data();
        match K::KIND {
            Kind::Vertex => self.vertex(VertexKey::from(data)).map(|_| key),
            Kind::Face => self.face(FaceKey::from(data)).map(|_| key),
            Kind::HalfEdge | Kind::Corner => self.half_edge(HalfEdgeKey::from(data)).map(|_| key),
            Kind::Edge => self.half_edge(HalfEdgeKey::from(data)).map(|h| {
                let twin = h.twin();
                if twin.index() < h.index() { twin.key().data().into() } else { key }
            }),
            // The wrapping structure checks it.
            Kind::Other => Ok(key),
        }
    }
}

impl Dcel {
    /// Adds an attribute. Records get values by [`set_value`](Self::set_value), and from then on by the policy. O(1), amortised; O(n)
    /// if the policy assigns [ids](Policy::ids), which all n existing records except the unbounded face get at once.
    ///
    /// Undoing the change of a history that added an attribute removes the ids that it assigned, but not the attribute.
    pub fn add_attribute<K: Attributed, T: Value>(&mut self, policy: Policy<K, T>) -> Attribute<K, T> {
        self.add_attribute_with(policy, SecondaryMap::new())
    }

    /// Adds an attribute with the [`values`](Self::values) of a saved structure. Values under stale keys are omitted. O(values), plus
    /// the cost of [`add_attribute`](Self::add_attribute).
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, Policy};
    ///
    /// let mut map = Dcel::new();
    /// let v = map.add_isolated_vertex(map.unbounded_face().key())?.vertex;
    /// let id = map.add_attribute(Policy::of_vertices().ids(7));
    /// assert_eq!(map.value(id, v), Some(&7));
    ///
    /// // A number that was given by hand, as if it had been saved.
    /// let mut numbers = map.values(id).cloned().unwrap_or_default();
    /// numbers.insert(v, 3);
    /// let id = map.add_attribute_with(Policy::of_vertices().ids(20), numbers);
    /// assert_eq!((map.value(id, v), map.next_id(id)), (Some(&3), Some(20)));
    /// # Ok::<(), twinedge::dcel::OperatorError>(())
    /// ```
    pub fn add_attribute_with<K: Attributed, T: Value>(
        &mut self,
        policy: Policy<K, T>,
        values: SecondaryMap<K::Key, T>,
    ) -> Attribute<K, T> {
        let records = if policy.counts() { self.record_keys::<K>() } else { Vec::new() };
        let values: Vec<_> =
            values.into_iter().filter_map(|(key, value)| Some((self.record_key::<K>(key).ok()?, value))).collect();
        self.attributes_to_change();
        self.store.kept_attributes().add(policy, values, records)
    }

    /// The keys of records that can have values: all but the unbounded face.
    pub(crate) fn record_keys<K: Attributed>(&self) -> Vec<KeyData> {
        match K::KIND {
            Kind::Vertex => self.vertices().map(|v| v.key().data()).collect(),
            Kind::Face => self.faces().filter(|f| !f.is_unbounded()).map(|f| f.key().data()).collect(),
            Kind::HalfEdge | Kind::Corner => self.half_edges().map(|h| h.key().data()).collect(),
            Kind::Edge => self.edges().map(|h| h.key().data()).collect(),
            // The wrapping structure knows its records.
            Kind::Other => Vec::new(),
        }
    }

    /// Sets the value of a record, and returns the previous one. O(1).
    ///
    /// The value converts to the type of the attribute: `"Ada"` is a value of an attribute of `String`s.
    ///
    /// # Errors
    /// A stale key; [`OperatorError::NoSuchAttribute`], for example for an attribute of [other records](Kind::Other).
    pub fn set_value<K: Attributed, T: Value>(
        &mut self,
        of: Attribute<K, T>,
        key: K::Key,
        value: impl Into<T>,
    ) -> Result<Option<T>, OperatorError> {
        self.put_value(of, key, Some(value.into()))
    }

    /// Removes and returns the value of a record. O(1).
    ///
    /// # Errors
    /// The errors of [`set_value`](Self::set_value).
    pub fn remove_value<K: Attributed, T: Value>(
        &mut self,
        of: Attribute<K, T>,
        key: K::Key,
    ) -> Result<Option<T>, OperatorError> {
        self.put_value(of, key, None)
    }

    pub(crate) fn put_value<K: Attributed, T: Value>(
        &mut self,
        of: Attribute<K, T>,
        key: K::Key,
        value: Option<T>,
    ) -> Result<Option<T>, OperatorError> {
        if K::KIND == Kind::Other {
            return Err(OperatorError::NoSuchAttribute);
        }
        let key = self.record_key::<K>(key)?;
        let attributes = self.attributes_to_change().ok_or(OperatorError::NoSuchAttribute)?;
        attributes.put(of, key, value).map_err(|()| OperatorError::NoSuchAttribute)
    }

    /// Adds the attributes of another structure, with their policies but without values. O(attributes).
    ///
    /// Use it to assign saved values to a loaded structure, or to compare two structures loaded separately.
    pub fn add_attributes_of(&mut self, other: &Self) {
        if let Some(mut all) = other.store.attributes().cloned() {
            all.rename(&|_, _| None);
            self.store.kept_attributes().extend(all);
        }
    }

    /// Copies the attributes and values of the structure from which this one was [made](Dcel::from_view). `keys` are the keys returned
    /// by that call. Records keep the values that they already have for the same attribute. O(values).
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, Outside, Policy};
    /// use twinedge::validate::Expectation;
    ///
    /// let (mut old, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let owner = old.add_attribute(Policy::of_faces());
    /// old.set_value(owner, keys.face(0).unwrap(), "Ada")?;
    /// let (mut new, keys) = Dcel::from_view(&old, &Expectation::plane(), Outside::Given)?;
    /// new.carry_values(&old, &keys);
    /// let inside = new.faces().find(|face| !face.is_unbounded()).unwrap();
    /// assert_eq!(new.value(owner, inside.key()), Some(&"Ada"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn carry_values(&mut self, other: &Self, keys: &Keys) {
        self.carry_all_values(other, keys, |_| None);
    }

    /// Copies attributes as [`carry_values`](Self::carry_values) does, including attributes of [other records](Kind::Other):
    /// `other_key` returns the key of such a record here, or `None`. O(values).
    pub fn carry_all_values(&mut self, other: &Self, keys: &Keys, other_key: impl Fn(KeyData) -> Option<KeyData>) {
        let Some(mut all) = other.store.attributes().cloned() else { return };
        let half_edge = |old: KeyData| keys.half_edge(other.half_edge(old.into()).ok()?.index());
        all.rename(&|kind, old| match kind {
            Kind::Vertex => keys.vertex(other.vertex(old.into()).ok()?.index()).map(|key| key.data()),
            Kind::HalfEdge | Kind::Corner => half_edge(old).map(|key| key.data()),
            Kind::Edge => self.record_key::<Edges>(half_edge(old)?).ok().map(|key| key.data()),
            Kind::Face => keys.face(other.face(old.into()).ok()?.index()).map(|key| key.data()),
            Kind::Other => other_key(old),
        });
        self.add_attributes(all);
    }

    /// Returns the attributes, if there are any. O(1).
    #[must_use]
    pub fn attributes(&self) -> Option<&Attributes> {
        self.store.attributes()
    }

    /// Returns the attributes, if there are any, during a change begun by [`attributes_to_change`](Self::attributes_to_change). O(1).
    pub fn attributes_mut(&mut self) -> Option<&mut Attributes> {
        self.store.attributes_mut()
    }

    /// Adds attributes with their values, for example of a structure that this one was cut out of. Where both have the same attribute,
    /// records keep their own values. O(values).
    pub fn add_attributes(&mut self, more: Attributes) {
        self.store.kept_attributes().extend(more);
        self.attributes_to_change();
    }

    /// Adds an attribute of [other records](Kind::Other), with these values. If the policy assigns ids, the other `records` get ids.
    /// O(values + records).
    pub fn add_other_attribute<K: Attributed, T: Value>(
        &mut self,
        policy: Policy<K, T>,
        values: impl IntoIterator<Item = (K::Key, T)>,
        records: Vec<KeyData>,
    ) -> Attribute<K, T> {
        self.attributes_to_change();
        self.store.kept_attributes().add(policy, values, records)
    }

    /// Sets or removes the value of an [other record](Kind::Other), and returns the previous value. O(1).
    ///
    /// # Errors
    /// [`OperatorError::NoSuchAttribute`].
    pub fn put_other_value<K: Attributed, T: Value>(
        &mut self,
        of: Attribute<K, T>,
        key: K::Key,
        value: Option<T>,
    ) -> Result<Option<T>, OperatorError> {
        let attributes = self.attributes_to_change().ok_or(OperatorError::NoSuchAttribute)?;
        attributes.put(of, key, value).map_err(|()| OperatorError::NoSuchAttribute)
    }

    /// Returns the attributes, if there are any, at the beginning of a change. Unless the change is logged, the log of earlier values
    /// is cleared. O(1), amortised.
    pub fn attributes_to_change(&mut self) -> Option<&mut Attributes> {
        let is_logged = self.store.is_logged();
        let attributes = self.store.attributes_mut()?;
        if !is_logged {
            attributes.clear_log();
        }
        Some(attributes)
    }
}
