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

/// The slot that a key names, and the generation in which it does.
///
/// `slotmap` promises only that its 64-bit form gives the key back. That the slot stands in the low half and the
/// generation in the high one has held since its first release; a test of this crate says so if it ever changes.
#[inline]
pub(crate) fn parts(key: impl Key) -> (u32, u32) {
    let bits = key.data().as_ffi();
    (bits as u32, (bits >> 32) as u32)
}

/// The key for a slot and a generation, which must be odd, as all generations of live slots are.
#[inline]
pub(crate) fn key<K: Key>(slot: u32, generation: u32) -> K {
    KeyData::from_ffi(u64::from(generation) << 32 | u64::from(slot)).into()
}

#[cfg(test)]
mod tests;
