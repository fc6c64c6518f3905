//! Where the records live. A [`Dcel`](crate::dcel::Dcel) is written once, over any of these.
//!
//! | store | links are | grows | choose it |
//! | --- | --- | --- | --- |
//! | [`SlotStore`] | 32-bit slots in columns, twins implicit | yes | always, unless you know why not |
//! | [`PointerStore`] | raw pointers between boxed records | yes | to measure against the structure that the literature draws |
//! | [`FixedStore`] | 8-bit slots in fixed arrays, twins implicit | no: what does not fit is an error | for a model checker, or for small maps without heap |
//!
//! Measured on a square grid of a million vertices (4 million half-edges, one thread), and on one of 49:
//!
//! | store | bytes per half-edge | face loops, ns per half-edge | vertex rotations | the same, small |
//! | --- | --- | --- | --- | --- |
//! | [`SlotStore`] | 40 | 3.0 | 2.1 | 1.7, 0.8 |
//! | [`PointerStore`] | 113 | 29 | 19 | 2.0, 0.7 |
//! | [`FixedStore`] | | | | 2.4, 1.1 |
//!
//! So pointers cost nothing but memory as long as a map fits into the cache, and ten times the time once it does not.
//!
//! # Keys and slots
//!
//! A *key* is what users hold: it names a record for ever, and once the record is gone the key is an error, never another
//! record. A *slot* is what the links are made of: bare, fast, and of no meaning once its record is gone. Keys are checked
//! where they enter; from there on slots are followed unchecked, which is sound because nothing can be removed while a
//! structure is borrowed for reading, and because an operator keeps no slot beyond its own end.

mod fixed;
mod issuer;
mod keys;
pub(crate) mod links;
mod pointers;
pub(crate) mod slots;

pub use fixed::FixedStore;
pub use keys::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};
pub use pointers::PointerStore;
pub use slots::SlotStore;

/// A place for records to live. The trait is sealed: the stores are those of this module, and only a
/// [`Dcel`](crate::dcel::Dcel) holds one.
///
/// ```compile_fail,E0277
/// fn bare<S: twinedge::store::Store>() -> S {
///     S::with_room(Default::default())
/// }
/// ```
pub trait Store: links::Links {}
