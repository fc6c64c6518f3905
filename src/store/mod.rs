//! The records of a [`Dcel`](crate::dcel::Dcel): slotmap keys over columns of 32-bit slots.
//!
//! ```text
//!   keys                       columns
//!   edges          [e1][e2]…   origin   [· ·][· ·]…   two half-edges per edge, side by side:
//!                              next     [· ·][· ·]…   slot 2e and 2e + 1, so that twin(h) is h ^ 1
//!                              prev     [· ·][· ·]…   and L1 holds by construction
//!                              boundary [· ·][· ·]…
//!   vertices       [v1][v2]…   link     [·][·]…       a half-edge, or (high bit) a boundary component
//!   boundaries     [b1][b2]…   row      [···][···]…   face, start and place together: operators use all of them, at places that
//!   faces          [f1][f2]…   row      [··][··]…     are not in the cache; so also the outer half-edge and the inner list
//! ```
//!
//! Bytes per record, including keys: 36 per edge, 8 per vertex, 16 per boundary component, 12 per face; 4 more for each inner
//! boundary component of a face with several, and for each removed record. A triangulated grid needs 28.7 per half-edge.
//!
//! # Keys and slots
//!
//! Users hold *keys*. A key names one record; after its removal the key is an error, and never names another record. Links are
//! *slots*: bare numbers, meaningless once the record is removed. Keys are checked where they enter, and slots are then
//! followed unchecked. This is sound because nothing can be removed while a structure is borrowed for reading, and because
//! operators keep no slot after they end.
//!
//! # Unsafe code
//!
//! The only unsafe code is the expansion of slotmap's `new_key_type!`, in one file; every other module of the crate forbids
//! it.

#[forbid(unsafe_code)]
pub(crate) mod attributes;
#[forbid(unsafe_code)]
mod columns;
#[forbid(unsafe_code)]
mod issuer;
mod keys;
#[forbid(unsafe_code)]
mod log;
#[forbid(unsafe_code)]
mod records;
#[forbid(unsafe_code)]
mod replay;
#[forbid(unsafe_code)]
mod slots;

pub(crate) use columns::{BoundarySlot, FaceSlot, HalfEdgeSlot, LAST, OUTER, VertexSlot};
pub use columns::{BoundaryStart, RecordKind, Room, VertexLink};
pub use keys::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};
pub use log::Way;
pub(crate) use log::{Entry, Log};
#[cfg(feature = "serde")]
pub(crate) use records::{Generations, Live};
pub(crate) use records::{InOrder, Numbered};
pub(crate) use slots::Store;
