//! Columns of 32-bit numbers: the memory of the validator while the rules are run.

use super::findings::Halt;
use crate::slots;
use alloc::vec::Vec;

pub(crate) use crate::slots::NIL;

/// A column of `n` entries.
///
/// # Errors
/// [`Halt::OutOfMemory`] if there is no memory for it.
pub(crate) fn column<T: Clone>(n: u32, value: T) -> Result<Vec<T>, Halt> {
    slots::column(n as usize, value).ok_or(Halt::OutOfMemory)
}

/// A connected component of vertices and edges.
#[derive(Clone, Copy)]
pub(crate) struct Component {
    /// Its first vertex, by which reports name it.
    pub(crate) vertex: u32,
    pub(crate) vertices: u32,
    /// Half-edges with and without a twin: the edges are half the former and all of the latter.
    pub(crate) paired: u32,
    pub(crate) unpaired: u32,
    /// Its cycles of `next`, one for an isolated vertex, and one for each open boundary.
    pub(crate) cycles: u32,
    /// True if some half-edge lacks its twin or its face. The outside of the component may then be there.
    pub(crate) open: bool,
}

impl Component {
    /// The component of this vertex, of which nothing else is known yet.
    pub(crate) const fn at(vertex: u32) -> Self {
        Self { vertex, vertices: 0, paired: 0, unpaired: 0, cycles: 0, open: false }
    }

    pub(crate) const fn edges(&self) -> usize {
        self.paired as usize / 2 + self.unpaired as usize
    }
}

/// The components, in order of their first vertices.
pub(crate) struct Components {
    /// For each vertex the number of its component; nil if it is not live.
    pub(crate) of: Vec<u32>,
    pub(crate) all: Vec<Component>,
    /// True if there is neither a loop nor a pair of parallel edges.
    pub(crate) simple: bool,
}
