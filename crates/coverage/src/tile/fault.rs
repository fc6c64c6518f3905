//! Faults of a map that was audited by its tiles.

use super::ends::{Ends, compare_edges, compare_points};
use super::grid::Tile;
use core::cmp::Ordering;
use core::fmt;
use twinedge_geometry::Point;

/// The kind of contact of edges that meet other than at a shared endpoint (rule G4).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum CrossingKind {
    /// Two edges cross where there is no vertex.
    Cross,
    /// A vertex lies inside an edge that does not end there.
    Touch,
    /// Two edges have more than a point in common.
    Overlap,
}

/// Edges that meet other than at a shared endpoint (rule G4).
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Crossing {
    /// The kind of contact.
    pub kind: CrossingKind,
    /// The ends of an edge, or twice the vertex that touches an edge.
    pub first: Ends,
    /// Another edge.
    pub second: Ends,
    /// The numbers of the features along them and along all edges at the vertex, in order.
    pub features: Vec<u32>,
}

impl Crossing {
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        self.kind
            .cmp(&other.kind)
            .then_with(|| compare_edges(&self.first, &other.first))
            .then_with(|| compare_edges(&self.second, &other.second))
    }
}

/// A component that breaks T3: `V − E + cycles` is not 2.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Uneven {
    /// The number of vertices, V.
    pub vertices: u64,
    /// The number of edges, E.
    pub edges: u64,
    /// The number of cycles.
    pub cycles: u64,
    /// The least vertex; `None` if no tile has one.
    pub at: Option<Point>,
}

impl Uneven {
    /// Returns the genus, or `None` if no surface has these numbers.
    #[must_use]
    pub const fn genus(&self) -> Option<u64> {
        match self.edges.saturating_add(2).checked_sub(self.vertices.saturating_add(self.cycles)) {
            Some(twice) if twice % 2 == 0 => Some(twice / 2),
            _ => None,
        }
    }

    pub(super) fn compare(&self, other: &Self) -> Ordering {
        let key = |one: &Self| (one.vertices, one.edges, one.cycles, one.at.is_some());
        key(self).cmp(&key(other)).then_with(|| match (self.at, other.at) {
            (Some(a), Some(b)) => compare_points(a, b),
            _ => Ordering::Equal,
        })
    }
}

/// A rule of seams: two tiles agree about the border between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum SeamRule {
    /// S1: both tiles see the same edges at their border.
    Contact,
    /// S2: both tiles see these edges in the same order.
    Order,
    /// S3: both tiles see the same features along each edge, and on each face between two.
    Features,
}

impl SeamRule {
    /// All rules, in order of their ids.
    pub const ALL: [Self; 3] = [Self::Contact, Self::Order, Self::Features];

    /// Returns the id: `S1` to `S3`.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Contact => "S1",
            Self::Order => "S2",
            Self::Features => "S3",
        }
    }

    /// Returns the name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Contact => "contact",
            Self::Order => "order",
            Self::Features => "features",
        }
    }
}

impl fmt::Display for SeamRule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.id(), self.name())
    }
}

/// A place where two tiles contradict each other.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct SeamFault {
    /// The rule.
    pub rule: SeamRule,
    /// The tile that has the edge, or the one with the lower number.
    pub tile: Tile,
    /// The tile on the other side of the border.
    pub beyond: Tile,
    /// The edge; for the features of a face, the edge before it on the border, if any.
    pub edge: Option<Ends>,
}

impl SeamFault {
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        let key = |one: &Self| (one.tile, one.beyond, one.rule, one.edge.is_some());
        key(self).cmp(&key(other)).then_with(|| match (&self.edge, &other.edge) {
            (Some(a), Some(b)) => compare_edges(a, b),
            _ => Ordering::Equal,
        })
    }
}
