//! The validator's own columns: what it remembers of a structure while the rules are run.

use super::findings::Halt;
use super::record::Record;
use alloc::vec::Vec;

/// Nil in a column.
pub(super) const NIL: u32 = u32::MAX;

/// A column of `n` entries.
///
/// # Errors
/// [`Halt::OutOfMemory`] if there is no memory for it.
pub(super) fn column<T: Clone>(n: u32, value: T) -> Result<Vec<T>, Halt> {
    let mut column = Vec::new();
    column.try_reserve_exact(n as usize).map_err(|_| Halt::OutOfMemory)?;
    column.resize(n as usize, value);
    Ok(column)
}

/// The half-edges that leave one vertex: how many there are, and one of them.
#[derive(Clone, Copy)]
pub(super) struct Fan {
    pub(super) degree: u32,
    pub(super) leaving: u32,
}

/// What a component consists of.
#[derive(Clone, Copy)]
pub(super) struct Component {
    /// Its first vertex, by which reports name it.
    pub(super) vertex: u32,
    pub(super) vertices: u32,
    /// Half-edges with and without a twin: the edges are half the former and all of the latter.
    pub(super) paired: u32,
    pub(super) unpaired: u32,
    /// Its cycles of `next`, one for an isolated vertex, and one for each open boundary.
    pub(super) cycles: u32,
    /// Whether some half-edge lacks its twin or its face: its outside may be there.
    pub(super) open: bool,
    /// The face that lists its outside, once known.
    pub(super) lies_in: u32,
    /// Its inner boundary component, once known.
    pub(super) outside: Option<Record>,
}

impl Component {
    /// The component of this vertex, of which nothing else is known yet.
    pub(super) const fn at(vertex: u32) -> Self {
        Self { vertex, vertices: 0, paired: 0, unpaired: 0, cycles: 0, open: false, lies_in: NIL, outside: None }
    }

    pub(super) const fn edges(&self) -> usize {
        self.paired as usize / 2 + self.unpaired as usize
    }
}

/// The components of the whole map.
#[derive(Default)]
pub(super) struct Components {
    /// Per vertex the number of its component.
    pub(super) of: Vec<u32>,
    pub(super) all: Vec<Component>,
    /// Whether there is neither a loop nor a pair of parallel edges.
    pub(super) simple: bool,
}
