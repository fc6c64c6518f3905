//! The kinds of records that have attributes.

use crate::store::keys::{FaceKey, HalfEdgeKey, VertexKey};
use core::fmt::Debug;
use slotmap::Key;

/// A kind of record that has attributes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// Vertices.
    Vertex,
    /// Half-edges.
    HalfEdge,
    /// Edges.
    Edge,
    /// Corners.
    Corner,
    /// Faces.
    Face,
    /// Records that a structure around the [`Dcel`](crate::dcel::Dcel) has, such as the features of a map. No operator writes to them.
    Other,
}

/// A kind of record that has [attributes](super::Attribute): [`Vertices`], [`HalfEdges`], [`Edges`], [`Corners`], [`Faces`], or a kind of
/// a structure around a [`Dcel`](crate::dcel::Dcel), which is [`Kind::Other`].
pub trait Attributed: Debug + Send + Sync + 'static {
    /// The keys of these records.
    type Key: Key + Send + Sync;

    /// The kind.
    const KIND: Kind = Kind::Other;
}

macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident $kind:ident $key:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub enum $name {}

        impl Attributed for $name {
            type Key = $key;

            const KIND: Kind = Kind::$kind;
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
