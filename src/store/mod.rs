//! Stores of records. A [`Dcel`](crate::dcel::Dcel) is written once, over any of these.
//!
//! | store | links are | grows | choose it |
//! | --- | --- | --- | --- |
//! | [`SlotStore`] | 32-bit slots in columns, twins implicit | yes | unless you have a reason for another |
//! | `PointerStore` (feature `pointer-store`) | raw pointers between boxed records | yes | to measure against the structure that the literature draws |
//! | [`FixedStore`] | 8-bit slots in fixed arrays, twins implicit | no: what does not fit is an error | for a model checker, or for small maps without heap |
//!
//! Measured on a square grid of a million vertices (4 million half-edges, one thread), and on one of 49:
//!
//! | store | bytes per half-edge | face loops, ns per half-edge | vertex rotations | the same, small |
//! | --- | --- | --- | --- | --- |
//! | [`SlotStore`] | 29 | 3.0 | 2.1 | 1.7, 0.8 |
//! | `PointerStore` | 113 | 29 | 19 | 2.0, 0.7 |
//! | [`FixedStore`] | | | | 2.4, 1.1 |
//!
//! As long as a map fits into the cache, pointers cost memory only. Once it does not, they take ten times the time.
//!
//! # Keys and slots
//!
//! A *key* is what users hold. It names one record: once that was removed, the key is an error and never another record. A
//! *slot* is what the links are made of: a bare number, which means nothing once its record is removed. Keys are checked where
//! they enter, and from there on slots are followed unchecked. That is right because nothing can be removed while a
//! structure is borrowed for reading, and because an operator keeps no slot after its end.
//!
//! # Unsafe code
//!
//! Without the feature `pointer-store` there is none but the expansion of slotmap's `new_key_type!`, in one file: every
//! other module of the crate forbids it.

#[cfg(feature = "near")]
#[forbid(unsafe_code)]
pub(crate) mod attributes;
#[forbid(unsafe_code)]
mod fixed;
#[forbid(unsafe_code)]
mod issuer;
mod keys;
#[forbid(unsafe_code)]
pub(crate) mod links;
#[forbid(unsafe_code)]
pub(crate) mod place;
#[cfg(feature = "pointer-store")]
mod pointers;
#[forbid(unsafe_code)]
pub(crate) mod slots;
#[forbid(unsafe_code)]
#[cfg(feature = "near")]
mod watch;

pub use fixed::FixedStore;
#[cfg(feature = "map")]
pub use keys::FeatureId;
pub use keys::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};
#[cfg(feature = "near")]
pub use links::AttributeStore;
pub use links::Store;
#[cfg(feature = "pointer-store")]
pub use pointers::PointerStore;
pub use slots::SlotStore;
#[cfg(feature = "near")]
pub(crate) use slots::{Entry, Journal, Way};
#[cfg(feature = "near")]
pub(crate) use watch::Watch;
