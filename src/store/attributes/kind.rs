//! The kinds of records that have attributes.

#[cfg(feature = "map")]
use crate::store::keys::FeatureId;
use crate::store::keys::{FaceKey, HalfEdgeKey, VertexKey};
use core::fmt::Debug;
use slotmap::Key;

/// A kind of record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Vertex,
    HalfEdge,
    Edge,
    Corner,
    Face,
    #[cfg(feature = "map")]
    Feature,
}

mod sealed {
    use super::Kind;

    pub trait Sealed {
        const KIND: Kind;
    }
}

pub(crate) use sealed::Sealed;

/// A kind of record that has [attributes](super::Attribute): [`Vertices`], [`HalfEdges`], [`Edges`], [`Corners`], [`Faces`] or, on
/// maps, `Features`.
pub trait Attributed: sealed::Sealed + Debug + Send + Sync + 'static {
    /// The keys of these records.
    type Key: Key + Send + Sync;
}

macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident $kind:ident $key:ident $(if $feature:literal)?;)*) => {$(
        $(#[$doc])*
        $(#[cfg(feature = $feature)])?
        #[derive(Clone, Copy, Debug)]
        pub enum $name {}

        $(#[cfg(feature = $feature)])?
        impl sealed::Sealed for $name {
            const KIND: Kind = Kind::$kind;
        }

        $(#[cfg(feature = $feature)])?
        impl Attributed for $name {
            type Key = $key;
        }
    )*};
}

kinds! {
    /// Vertices have the attribute.
    Vertices Vertex VertexKey;
    /// Half-edges have the attribute: each side of an edge a value of its own.
    HalfEdges HalfEdge HalfEdgeKey;
    /// Edges have the attribute. Either half-edge names the edge; values are kept under the one with the smaller index.
    Edges Edge HalfEdgeKey;
    /// [Corners](crate::dcel::Corner) between half-edges have the attribute, each by the half-edge to whose left it is, at its origin. The
    /// corner of an isolated vertex has none.
    Corners Corner HalfEdgeKey;
    /// Faces have the attribute, and the unbounded one may have a value, too.
    Faces Face FaceKey;
    /// Features have the attribute. Only a [`PlanarMap`](crate::map::PlanarMap) has some, and gives them values.
    Features Feature FeatureId if "map";
}
