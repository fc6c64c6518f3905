//! The kinds of records that have attributes.

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
}

mod sealed {
    use super::Kind;

    pub trait Sealed {
        const KIND: Kind;
    }
}

pub(crate) use sealed::Sealed;

/// A kind of record that has [attributes](super::Attribute): [`Vertices`], [`HalfEdges`], [`Edges`], [`Corners`] or [`Faces`].
pub trait Attributed: sealed::Sealed + Debug + Send + Sync + 'static {
    /// The keys of these records.
    type Key: Key + Send + Sync;
}

macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident $kind:ident $key:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub enum $name {}

        impl sealed::Sealed for $name {
            const KIND: Kind = Kind::$kind;
        }

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
}
