//! What an operator of a program comes to: the operator with handles in place of numbers.

use super::subject::{Corner, Subject};
use crate::dcel::{Side, Turn};
use alloc::vec::Vec;

/// An operator with the handles that it chose, as [`Runner::resolve`](super::Runner::resolve) tells. They may be stale.
#[derive(Clone, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the arguments are those of the methods of `Subject` of the same names")]
pub enum Call<V, H, F> {
    /// [`Subject::add_isolated_vertex`].
    AddIsolatedVertex { face: F },
    /// [`Subject::remove_isolated_vertex`].
    RemoveIsolatedVertex { vertex: V },
    /// [`Subject::connect`].
    Connect { from: Corner<H, V>, to: Corner<H, V>, new_face: Side, inner: Vec<Corner<H, V>> },
    /// [`Subject::remove_edge`].
    RemoveEdge { half_edge: H },
    /// [`Subject::split_edge`].
    SplitEdge { half_edge: H },
    /// [`Subject::join_edges`].
    JoinEdges { half_edge: H },
    /// [`Subject::split_vertex`].
    SplitVertex { from: Corner<H, V>, to: Corner<H, V> },
    /// [`Subject::contract_edge`].
    ContractEdge { half_edge: H },
    /// [`Subject::flip_edge`].
    FlipEdge { half_edge: H, turn: Turn },
    /// [`Subject::move_inner`].
    MoveInner { inner: Corner<H, V>, face: F },
}

/// A call of the subject `K`.
pub type CallOf<K> = Call<<K as Subject>::Vertex, <K as Subject>::HalfEdge, <K as Subject>::Face>;
