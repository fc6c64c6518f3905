//! An issuer as it was when its generations were saved.
//!
//! Slotmap has one way to make a map with given versions: to deserialize it. So the versions are handed to it as what a
//! format would have read.

use super::issuer::Issuer;
use alloc::vec::Vec;
use serde::de::value::{Error, SeqDeserializer};
use serde::de::{DeserializeSeed, Deserializer, IntoDeserializer, SeqAccess, Visitor};
use serde::{Deserialize, forward_to_deserialize_any};
use slotmap::{Key, SlotMap};

impl<K: Key> Issuer<K> {
    /// By slot, the generations that [`Issuer::restored`] needs.
    pub(super) fn generations(&self) -> &[u32] {
        &self.generations
    }

    /// What is added to the versions of slotmap.
    pub(super) fn offset(&self) -> u32 {
        self.offset
    }

    /// An issuer with these generations by slot, the live ones odd. None if slot 0 is missing or live.
    pub(super) fn restored(generations: Vec<u32>, offset: u32) -> Option<Self> {
        let versions = generations.iter().map(|generation| Version(generation.wrapping_sub(offset)));
        let slots = SlotMap::deserialize(SeqDeserializer::<_, Error>::new(versions)).ok()?;
        Some(Self { slots, generations, offset })
    }
}

/// The version of a slot that holds nothing but its being there.
struct Version(u32);

impl IntoDeserializer<'_> for Version {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

/// The two fields of slotmap's slots, one after the other.
impl<'de> Deserializer<'de> for Version {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_seq(Fields { version: self.0, given: 0 })
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

struct Fields {
    version: u32,
    given: u8,
}

impl<'de> SeqAccess<'de> for Fields {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Error> {
        self.given += 1;
        match self.given {
            1 => seed.deserialize(Value(self.version % 2 == 1)).map(Some),
            2 => seed.deserialize(self.version.into_deserializer()).map(Some),
            _ => Ok(None),
        }
    }
}

/// The value of a slot: there or not.
struct Value(bool);

impl<'de> Deserializer<'de> for Value {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        if self.0 { visitor.visit_some(().into_deserializer()) } else { visitor.visit_none() }
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}
