//! The kinds of records that have attributes.

use crate::store::keys::{FaceKey, HalfEdgeKey, VertexKey};
use core::fmt::Debug;
use slotmap::Key;

/// A kind of record with attributes.
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
    /// Records of a structure around the [`Dcel`](crate::dcel::Dcel), such as the features of a map. No operator writes to them.
    Other,
}

/// A kind of record with [attributes](super::Attribute): [`Vertices`], [`HalfEdges`], [`Edges`], [`Corners`], [`Faces`], or a kind
/// defined by a structure around a [`Dcel`](crate::dcel::Dcel), which is [`Kind::Other`].
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
    /// Attributes of vertices.
    Vertices Vertex VertexKey;
    /// Attributes of half-edges: each side of an edge has its own value.
    HalfEdges HalfEdge HalfEdgeKey;
    /// Attributes of edges. Either half-edge names the edge; values are stored under the one with the smaller index.
    Edges Edge HalfEdgeKey;
    /// Attributes of [corners](crate::dcel::Corner), each named by the half-edge at whose origin and to whose left it lies. The corner
    /// of an isolated vertex has no attributes.
    Corners Corner HalfEdgeKey;
    /// Attributes of faces, including the unbounded face.
    Faces Face FaceKey;
}
