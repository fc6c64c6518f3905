//! Where the records live. A [`Dcel`](crate::dcel::Dcel) is written once, over any of these.
//!
//! | store | links are | grows | choose it |
//! | --- | --- | --- | --- |
//! | [`SlotStore`] | 32-bit slots in columns, twins implicit | yes | always, unless you know why not |
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
mod slots;

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
