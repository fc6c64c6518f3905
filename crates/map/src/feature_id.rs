//! The keys of features.

#![allow(unsafe_code, reason = "slotmap's macro implements its unsafe `Key` trait, whose contract it keeps itself")]

use slotmap::{Key as _, KeyData, new_key_type};
use twinedge::dcel::Attributed;

new_key_type! {
    /// A feature of a map, such as a country, by its number in order of input.
    pub struct FeatureId;
}

impl FeatureId {
    /// Creates the key of the feature with this number, even if no map has such a feature.
    #[must_use]
    pub fn new(number: u32) -> Self {
        // Slots of other records also begin at 1.
        KeyData::from_ffi(1 << 32 | u64::from(number.wrapping_add(1))).into()
    }

    /// Returns the number in order of input, counted from 0.
    #[must_use]
    pub fn number(self) -> u32 {
        (self.data().as_ffi() as u32).wrapping_sub(1)
    }

    /// Returns the index in order of input, counted from 0.
    #[must_use]
    pub fn index(self) -> usize {
        self.number() as usize
    }
}

/// The kind of attributes of features. Only a [`PlanarMap`](crate::PlanarMap) has features.
#[derive(Clone, Copy, Debug)]
pub enum Features {}

impl Attributed for Features {
    type Key = FeatureId;
}
