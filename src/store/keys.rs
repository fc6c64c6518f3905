//! The keys: generational handles to records.

#![allow(unsafe_code, reason = "slotmap's macro implements its unsafe `Key` trait, whose contract it keeps itself")]

use slotmap::{Key, KeyData, new_key_type};

new_key_type! {
    /// The key of a vertex.
    pub struct VertexKey;
    /// The key of a half-edge.
    pub struct HalfEdgeKey;
    /// The key of a boundary component.
    pub struct BoundaryKey;
    /// The key of a face.
    pub struct FaceKey;
}

/// The slot and the generation of a key.
///
/// `slotmap` only promises that converting the 64-bit form returns the same key. The slot has been in the low half, and
/// the generation in the high half, since the first release; a test of this crate would notice a change.
#[inline]
pub(crate) fn parts(key: impl Key) -> (u32, u32) {
    let bits = key.data().as_ffi();
    (bits as u32, (bits >> 32) as u32)
}

/// The key of a slot with a generation, which must be odd, as for all live slots.
#[inline]
pub(crate) fn key<K: Key>(slot: u32, generation: u32) -> K {
    KeyData::from_ffi(u64::from(generation) << 32 | u64::from(slot)).into()
}

#[cfg(test)]
mod tests {
    use super::{VertexKey, key, parts};
    use slotmap::SlotMap;

    #[test]
    fn slot_and_generation_stand_where_this_crate_looks_for_them() {
        let mut map: SlotMap<VertexKey, ()> = SlotMap::with_key();
        let first = map.insert(());
        let second = map.insert(());
        assert_eq!((parts(first), parts(second)), ((1, 1), (2, 1)));
        map.remove(first);
        let again = map.insert(());
        assert_eq!(parts(again).0, 1);
        assert!(parts(again).1 > 1 && parts(again).1 % 2 == 1);
        assert_eq!(key::<VertexKey>(parts(again).0, parts(again).1), again);
    }
}
