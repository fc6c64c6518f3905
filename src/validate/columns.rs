//! Columns of 32-bit numbers: the working memory of the rules.

use super::findings::Halt;
use crate::slots;
use alloc::vec::Vec;

pub(crate) use crate::slots::NIL;

/// A column of `n` entries.
///
/// # Errors
/// [`Halt::OutOfMemory`] if memory runs out.
pub(crate) fn column<T: Clone>(n: u32, value: T) -> Result<Vec<T>, Halt> {
    slots::column(n as usize, value).ok_or(Halt::OutOfMemory)
}

#[derive(Clone, Copy)]
pub(crate) struct Component {
    /// Its first vertex, which names it in reports.
    pub(crate) vertex: u32,
    pub(crate) vertices: u32,
    /// Half-edges with and without a twin: there are `paired / 2 + unpaired` edges.
    pub(crate) paired: u32,
    pub(crate) unpaired: u32,
    /// The number of its cycles of `next`, plus one for an isolated vertex, plus one for each open boundary.
    pub(crate) cycles: u32,
    /// True if some half-edge lacks its twin or its face, so the outside of the component may be there.
    pub(crate) open: bool,
}

impl Component {
    pub(crate) const fn at(vertex: u32) -> Self {
        Self { vertex, vertices: 0, paired: 0, unpaired: 0, cycles: 0, open: false }
    }

    pub(crate) const fn edges(&self) -> usize {
        self.paired as usize / 2 + self.unpaired as usize
    }
}

pub(crate) struct Components {
    /// By vertex: the number of its component; nil if not live.
    pub(crate) of: Vec<u32>,
    pub(crate) all: Vec<Component>,
    /// True if there are neither loops nor parallel edges.
    pub(crate) simple: bool,
}
