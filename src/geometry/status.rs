//! The segments that a sweep line crosses at present, from the bottom up.

use super::point::Point;
use super::predicates::{Orientation, count_step, orientation};
use crate::slots::NIL;

/// A segment under the sweep line, running from `low` to `high` in lexicographic order.
#[derive(Clone, Copy)]
pub(super) struct Strand {
    pub(super) low: Point,
    pub(super) high: Point,
    /// The number of the segment.
    pub(super) segment: u32,
    /// At which event it ends.
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

/// The strands under the sweep line, in order: a balanced search tree and a list in one, named by handles that stay
/// valid until their strand is removed.
///
/// Only [`locate`](Self::locate) compares. Everything else goes by handles, so it also works if the strands
/// are in no order, as they are after a crossing.
///
/// The tree is a treap (Seidel and Aragon, "Randomized search trees", Algorithmica 16 (1996) 464-497): a search tree
/// by position that is a heap by a priority. The priority is a hash of the handle, so nothing is stored, nothing is
/// random, and the expected depth is O(log n) for every input that was not constructed against this hash.
pub(super) struct Status {
    nodes: alloc::vec::Vec<Node>,
    root: u32,
    /// Nodes to use again, chained through `above`.
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
    /// The neighbours in the list.
    below: u32,
    above: u32,
}

impl Status {
    pub(super) const fn new() -> Self {
        Self { nodes: alloc::vec::Vec::new(), root: NIL, free: NIL }
    }

    /// O(1).
    pub(super) fn strand(&self, handle: u32) -> &Strand {
        &self.nodes[handle as usize].strand
    }

    /// The neighbour below. O(1).
    pub(super) fn below(&self, handle: u32) -> u32 {
        self.nodes[handle as usize].below
    }

    /// The neighbour above. O(1).
    pub(super) fn above(&self, handle: u32) -> u32 {
        self.nodes[handle as usize].above
    }

    /// The neighbours of a point that is not under the sweep line yet, and a strand on which the point lies, or NIL.
    /// Such a strand counts as below. O(log n).
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

    /// Puts a strand between two neighbours. O(1) expected, the search having been done.
    pub(super) fn insert(&mut self, gap: Gap, strand: Strand) -> u32 {
        // In a search tree, of two neighbours the lower has no right child, or else the upper has no left child.
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

    /// Puts a strand in the place of another. O(1).
    pub(super) fn replace(&mut self, handle: u32, strand: Strand) {
        self.nodes[handle as usize].strand = strand;
    }

    /// Takes a strand out. O(1) expected.
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

    /// Makes `parent` (or the root) have `new` where it had `old`.
    fn hang(&mut self, parent: u32, old: u32, new: u32) {
        if parent == NIL {
            self.root = new;
        } else {
            let parent = &mut self.nodes[parent as usize];
            *(if parent.left == old { &mut parent.left } else { &mut parent.right }) = new;
        }
    }
}

/// The priority of a node: its handle, multiplied by the golden ratio (times 2^32, made odd) and folded, twice. One
/// to one, so that there are no ties.
fn priority(handle: u32) -> u32 {
    let fold = |x: u32| (x ^ (x >> 16)).wrapping_mul(0x9e37_79b1);
    let x = fold(fold(handle));
    x ^ (x >> 16)
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::*;

    /// A level strand at this height, under the point `beside(height)`.
    fn level(height: u32) -> Strand {
        let [low, high] = [0.0, 2.0].map(|x| Point::new(x, height.into()));
        Strand { low, high, segment: height, end: 0, companion: NIL }
    }

    fn beside(height: f64) -> Point {
        Point::new(1.0, height)
    }

    /// The handles from the bottom up, as the tree has them. The tree is checked to have the right parents and
    /// priorities, and to be the same as the list.
    fn in_order(status: &Status) -> Vec<u32> {
        let node = |handle: u32| &status.nodes[handle as usize];
        let (mut order, mut path, mut next) = (Vec::new(), Vec::new(), status.root);
        loop {
            while next != NIL {
                for child in [node(next).left, node(next).right] {
                    assert!(child == NIL || node(child).parent == next && priority(child) < priority(next));
                }
                path.push(next);
                next = node(next).left;
            }
            let Some(handle) = path.pop() else { break };
            order.push(handle);
            next = node(handle).right;
        }
        assert!(status.root == NIL || node(status.root).parent == NIL);
        for pair in order.windows(2) {
            assert_eq!((status.above(pair[0]), status.below(pair[1])), (pair[1], pair[0]));
        }
        assert!(order.first().is_none_or(|&lowest| status.below(lowest) == NIL));
        assert!(order.last().is_none_or(|&highest| status.above(highest) == NIL));
        order
    }

    #[test]
    fn keeps_the_order_of_a_sorted_vector() {
        let (mut status, mut model) = (Status::new(), Vec::<(u32, u32)>::new());
        let (mut random, mut most) = (1_u32, 0);
        for _ in 0..3000 {
            // Insert what is not in the list, remove what is.
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let height = (random >> 16) % 509;
            match model.binary_search_by_key(&height, |&(height, _)| height) {
                Ok(i) => {
                    let (gap, on) = status.locate(beside(height.into()));
                    assert_eq!((gap.below, on), (model[i].1, model[i].1));
                    status.remove(model.remove(i).1);
                }
                Err(i) => {
                    let (gap, on) = status.locate(beside(height.into()));
                    let neighbour = |i: usize| model.get(i).map_or(NIL, |&(_, handle)| handle);
                    assert_eq!((gap.below, gap.above, on), (neighbour(i.wrapping_sub(1)), neighbour(i), NIL));
                    model.insert(i, (height, status.insert(gap, level(height))));
                }
            }
            most = most.max(model.len());
            let (order, expected) = (in_order(&status), model.iter().map(|&(_, handle)| handle));
            assert!(order.into_iter().eq(expected));
            for &(height, handle) in &model {
                assert_eq!(status.strand(handle).segment, height);
            }
        }
        assert_eq!(status.nodes.len(), most, "nodes are used again");
    }

    #[test]
    fn stays_shallow() {
        const N: u32 = 1 << 16;
        let rising = (0..N).collect();
        let falling = (0..N).rev().collect();
        let inwards = (0..N).map(|i| if i % 2 == 0 { i / 2 } else { N - 1 - i / 2 }).collect();
        let outwards = (0..N).rev().map(|i| if i % 2 == 0 { i / 2 } else { N - 1 - i / 2 }).collect();
        let mixed = (0..N).map(|i| i * 7919 % N).collect();
        let orders: [Vec<u32>; 5] = [rising, falling, inwards, outwards, mixed];
        for order in orders {
            let mut status = Status::new();
            for height in order {
                let (gap, _) = status.locate(beside(height.into()));
                status.insert(gap, level(height));
            }
            let depth = |mut handle: u32| {
                let mut depth = 0;
                while handle != NIL {
                    depth += 1;
                    handle = status.nodes[handle as usize].parent;
                }
                depth
            };
            let depths: Vec<u32> = in_order(&status).into_iter().map(depth).collect();
            let deepest = *depths.iter().max().unwrap();
            let mean = f64::from(depths.iter().sum::<u32>()) / f64::from(N);
            // A random search tree has a mean of 2 ln n - 3 or so, here 20, and hardly ever a depth beyond 4.3 ln n,
            // here 48.
            assert!(deepest <= 48 && mean <= 24.0, "depth {deepest}, mean {mean}");
        }
    }
}
