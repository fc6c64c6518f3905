//! The work of `lazy`.

use thiserror::Error;
use twinedge::validate::{Expectation, Parts};

/// The tables that are judged, all of one size: every cell is free.
///
/// A link can be nil, each slot, or the one past the end. The list of a face has up to as many entries as there are vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LazyWork {
    /// The claims to which the tables are held.
    pub expectation: Expectation,
    /// The parts that they store.
    pub parts: Parts,
    /// The number of slots for vertices.
    pub vertices: usize,
    /// The number of slots for half-edges.
    pub half_edges: usize,
    /// The number of slots for boundary components, where there are records for these.
    pub boundaries: usize,
    /// The number of slots for faces, where there are faces.
    pub faces: usize,
    /// True if each slot can also be vacant.
    pub vacant: bool,
}

/// The most slots of a kind.
pub(super) const MOST_SLOTS: usize = 15;

/// There are more tables than can be counted, about 10^38, or more than 15 slots of a kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("there are more than 10^38 tables of this size, or more than {MOST_SLOTS} slots of a kind")]
pub struct TooManyTables;
