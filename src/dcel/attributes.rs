//! Attributes of a structure: values that follow its operators.

use super::error::{OperatorError, StaleKey};
use super::structure::Dcel;
use crate::store::attributes::{Attribute, Attributed, Kind, Policy, Sealed, Value};
use crate::store::{AttributeStore, FaceKey, HalfEdgeKey, Store, VertexKey};
use slotmap::{Key, SecondaryMap};

/// # Attributes
///
/// Values beside the structure that follow what operators do, by a [`Policy`] each: when faces are split and merged, edges made and dropped.
///
/// ```
/// use twinedge::dcel::{Dcel, OperatorError, Policy, Split};
///
/// let mut map = Dcel::new();
/// let owner = map.add_attribute(Policy::of_faces().split_copy().merge_equal());
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
/// All operators carry them, and so do [`retain`](Dcel::retain) and [`compact`](Dcel::compact). In a [`History`](super::History) they
/// are undone and redone with the structure. A clone of the structure has them, too. They are neither compared nor saved with
/// it: [`values`](Dcel::values) has what to save, and the keys stay the same.
///
/// A structure without attributes pays nothing for them. For each attribute, an operator takes O(1) for each record that it makes, splits,
/// merges or drops, beside the functions of the policy.
impl<S: Store> Dcel<S> {
    /// Returns the value that a record has, if it has one. O(1).
    #[must_use]
    pub fn value<K: Attributed, T: Value>(&self, of: Attribute<K, T>, key: K::Key) -> Option<&T> {
        self.values(of)?.get(self.record_key::<K>(key).ok()?)
    }

    /// Returns all values of an attribute by key; none if it is one of another structure. O(attributes).
    #[must_use]
    pub fn values<K: Attributed, T: Value>(&self, of: Attribute<K, T>) -> Option<&SecondaryMap<K::Key, T>> {
        self.store.attributes()?.values(of)
    }

    /// The key under which the value of a record is kept.
    fn record_key<K: Attributed>(&self, key: K::Key) -> Result<K::Key, StaleKey> {
        let data = key.data();
        match <K as Sealed>::KIND {
            Kind::Vertex => self.vertex(VertexKey::from(data)).map(|_| key),
            Kind::Face => self.face(FaceKey::from(data)).map(|_| key),
            Kind::HalfEdge | Kind::Corner => self.half_edge(HalfEdgeKey::from(data)).map(|_| key),
            Kind::Edge => self.half_edge(HalfEdgeKey::from(data)).map(|h| {
                let twin = h.twin();
                if twin.index() < h.index() { twin.key().data().into() } else { key }
            }),
        }
    }
}

impl<S: AttributeStore> Dcel<S> {
    /// Adds an attribute: records get values by [`set_value`](Self::set_value), and from then on by the policy. O(1), amortised.
    ///
    /// It stays for good: also where the change of a history that added it is undone.
    pub fn add_attribute<K: Attributed, T: Value>(&mut self, policy: Policy<K, T>) -> Attribute<K, T> {
        self.store.kept_attributes().add(policy)
    }

    /// Gives a value to a record, or takes it away. Returns the one that it had. O(1).
    ///
    /// # Errors
    /// A stale key; [`OperatorError::NoSuchAttribute`].
    pub fn set_value<K: Attributed, T: Value>(
        &mut self,
        of: Attribute<K, T>,
        key: K::Key,
        value: impl Into<Option<T>>,
    ) -> Result<Option<T>, OperatorError> {
        let key = self.record_key::<K>(key)?;
        let attributes = self.store.attributes_mut().ok_or(OperatorError::NoSuchAttribute)?;
        if !S::RECORDS {
            attributes.clear_log();
        }
        attributes.put(of, key, value.into()).map_err(|()| OperatorError::NoSuchAttribute)
    }
}
