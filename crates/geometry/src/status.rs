//! The segments that a sweep line currently crosses, from the bottom up.

use super::point::Point;
use super::predicates::{Orientation, orientation};
use crate::NIL;
use crate::steps::count_step;

/// A segment under the sweep line, running from `low` to `high` in lexicographic order.
#[derive(Clone, Copy)]
pub(super) struct Strand {
    pub(super) low: Point,
    pub(super) high: Point,
    pub(super) segment: u32,
    pub(super) end: u32,
    /// Another node whose strand ends there, so that an event can find all of them.
    pub(super) companion: u32,
}

/// A place between two neighbours.
#[derive(Clone, Copy)]
pub(super) struct Gap {
    pub(super) below: u32,
    pub(super) above: u32,
}

/// The strands under the sweep line, in order: a balanced search tree and a list in one, with handles valid until removal.
///
/// Only [`locate`](Self::locate) compares. All other methods use handles, so they also work if the strands are out of order, as
/// after a crossing.
///
/// The tree is a treap (Seidel and Aragon, "Randomized search trees", Algorithmica 16 (1996) 464-497): a search tree by position
/// that is a heap by a priority. The priority is a hash of the handle, so nothing is stored, nothing is random, and the expected
/// depth is O(log n) for every input not constructed against this hash.
pub(super) struct Status {
    nodes: std::vec::Vec<Node>,
    root: u32,
    /// Free nodes, chained through `above`.
    free: u32,
}

/// One cache line.
#[derive(Clone, Copy)]
#[repr(align(64))]
struct Node {
    strand: Strand,
    left: u32,
    right: u32,
    parent: u32,
    below: u32,
    above: u32,
}

impl Status {
    pub(super) const fn new() -> Self {
        Self { nodes: std::vec::Vec::new(), root: NIL, free: NIL }
    }

    pub(super) fn strand(&self, handle: u32) -> &Strand {
        &self.nodes[handle as usize].strand
    }

    /// Returns the neighbour below. O(1).
    pub(super) fn below(&self, handle: u32) -> u32 {
        self.nodes[handle as usize].below
    }

    /// Returns the neighbour above. O(1).
    pub(super) fn above(&self, handle: u32) -> u32 {
        self.nodes[handle as usize].above
    }

    /// Returns the neighbours of a point that is not yet under the sweep line, and a strand that contains the point, or NIL. Such
    /// a strand counts as below. O(log n).
    pub(super) fn locate(&self, p: Point) -> (Gap, u32) {
        let (mut gap, mut on) = (Gap { below: NIL, above: NIL }, NIL);
        let mut at = self.root;
        while at != NIL {
            let node = &self.nodes[at as usize];
            let side = orientation(node.strand.low, node.strand.high, p);
            if side == Orientation::Clockwise {
                gap.above = at;
                at = node.left;
            } else {
                if side == Orientation::Collinear {
                    on = at;
                }
                gap.below = at;
                at = node.right;
            }
        }
        (gap, on)
    }

    /// Inserts a strand between two neighbours. O(1) expected, after the search.
    pub(super) fn insert(&mut self, gap: Gap, strand: Strand) -> u32 {
        // In a search tree, the lower of two neighbours has no right child, or the upper has no left child.
        let Gap { below, above } = gap;
        let under_lower = below != NIL && self.nodes[below as usize].right == NIL;
        let parent = if under_lower { below } else { above };
        let node = Node { strand, left: NIL, right: NIL, parent, below, above };
        let handle = if self.free == NIL {
            self.nodes.push(node);
            self.nodes.len() as u32 - 1
        } else {
            let handle = self.free;
            self.free = self.nodes[handle as usize].above;
            self.nodes[handle as usize] = node;
            handle
        };
        if below != NIL {
            self.nodes[below as usize].above = handle;
        }
        if above != NIL {
            self.nodes[above as usize].below = handle;
        }
        if parent == NIL {
            self.root = handle;
        } else if under_lower {
            self.nodes[parent as usize].right = handle;
        } else {
            self.nodes[parent as usize].left = handle;
        }
        loop {
            let parent = self.nodes[handle as usize].parent;
            if parent == NIL || priority(parent) > priority(handle) {
                return handle;
            }
            self.rotate_up(handle);
        }
    }

    /// Replaces a strand. O(1).
    pub(super) fn replace(&mut self, handle: u32, strand: Strand) {
        self.nodes[handle as usize].strand = strand;
    }

    /// Removes a strand. O(1) expected.
    pub(super) fn remove(&mut self, handle: u32) {
        let child = loop {
            let Node { left, right, .. } = self.nodes[handle as usize];
            if left == NIL {
                break right;
            }
            if right == NIL {
                break left;
            }
            self.rotate_up(if priority(left) > priority(right) { left } else { right });
        };
        let Node { parent, below, above, .. } = self.nodes[handle as usize];
        if child != NIL {
            self.nodes[child as usize].parent = parent;
        }
        self.hang(parent, handle, child);
        if below != NIL {
            self.nodes[below as usize].above = above;
        }
        if above != NIL {
            self.nodes[above as usize].below = below;
        }
        let node = &mut self.nodes[handle as usize];
        node.strand.end = NIL;
        node.above = self.free;
        self.free = handle;
    }

    /// Exchanges a node with its parent, keeping the order.
    ///
    /// ```text
    ///        parent           node
    ///        /    \           /  \
    ///     node     c   <->   a   parent
    ///     /  \                   /    \
    ///    a    b                 b      c
    /// ```
    fn rotate_up(&mut self, handle: u32) {
        count_step();
        let parent = self.nodes[handle as usize].parent;
        let grandparent = self.nodes[parent as usize].parent;
        let was_left = self.nodes[parent as usize].left == handle;
        let node = &mut self.nodes[handle as usize];
        node.parent = grandparent;
        let moved = core::mem::replace(if was_left { &mut node.right } else { &mut node.left }, parent);
        if moved != NIL {
            self.nodes[moved as usize].parent = parent;
        }
        let lowered = &mut self.nodes[parent as usize];
        lowered.parent = handle;
        *(if was_left { &mut lowered.left } else { &mut lowered.right }) = moved;
        self.hang(grandparent, parent, handle);
    }

    /// Replaces the child `old` of `parent` (or the root) by `new`.
    fn hang(&mut self, parent: u32, old: u32, new: u32) {
        if parent == NIL {
            self.root = new;
        } else {
            let parent = &mut self.nodes[parent as usize];
            *(if parent.left == old { &mut parent.left } else { &mut parent.right }) = new;
        }
    }
}

/// A node's priority: its handle, multiplied by the golden ratio (times 2^32, odd) and folded, twice. Injective, so without ties.
fn priority(handle: u32) -> u32 {
    let fold = |x: u32| (x ^ (x >> 16)).wrapping_mul(0x9e37_79b1);
    let x = fold(fold(handle));
    x ^ (x >> 16)
}

#[cfg(test)]
mod tests;
