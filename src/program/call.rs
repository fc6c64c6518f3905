//! What an operator of a program comes to: the operator with handles in place of numbers.

use super::kernel::{Corner, Kernel};
use crate::dcel::{Side, Turn};
use alloc::vec::Vec;

/// An operator with the handles that it chose, as [`Runner::resolve`](super::Runner::resolve) tells. They may be stale.
#[derive(Clone, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the arguments are those of the methods of `Kernel` of the same names")]
pub enum Call<V, H, F> {
    /// [`Kernel::add_isolated_vertex`].
    AddIsolatedVertex { face: F },
    /// [`Kernel::remove_isolated_vertex`].
    RemoveIsolatedVertex { vertex: V },
    /// [`Kernel::connect`].
    Connect { from: Corner<H, V>, to: Corner<H, V>, new_face: Side, inner: Vec<Corner<H, V>> },
    /// [`Kernel::remove_edge`].
    RemoveEdge { half_edge: H },
    /// [`Kernel::split_edge`].
    SplitEdge { half_edge: H },
    /// [`Kernel::join_edges`].
    JoinEdges { half_edge: H },
    /// [`Kernel::split_vertex`].
    SplitVertex { from: Corner<H, V>, to: Corner<H, V> },
    /// [`Kernel::contract_edge`].
    ContractEdge { half_edge: H },
    /// [`Kernel::flip_edge`].
    FlipEdge { half_edge: H, turn: Turn },
    /// [`Kernel::move_inner`].
    MoveInner { inner: Corner<H, V>, face: F },
}

/// A call of the kernel `K`.
pub type CallOf<K> = Call<<K as Kernel>::Vertex, <K as Kernel>::HalfEdge, <K as Kernel>::Face>;
