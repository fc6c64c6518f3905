//! Sets of features, each stored once, with common parts shared.
//!
//! A set is a binary trie over the numbers of its features, with 64 numbers per leaf. Equal parts of sets are one node
//! (hash-consing), so sets are equal if their nodes are, and adding a set that differs from another in one feature costs O(log
//! features) nodes, independent of its size. So even with ten thousand nested polygons, each face has its own set.
//!
//! Source: Okasaki and Gill, "Fast mergeable integer maps", 1998.

use super::number_table::{NumberTable, hash};
use crate::FeatureId;

/// The number of a set of features.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct SetId(u32);

const EMPTY: SetId = SetId(0);

/// The low bits of a feature's number, which select one of the 64 features of a leaf.
const LEAF_BITS: u32 = 6;

/// The maximum depth: one node for each remaining bit, and the leaf.
const DEPTH: usize = (u32::BITS - LEAF_BITS) as usize + 1;

/// Part of a set. All its features share the upper bits of `prefix`.
#[derive(Clone, Copy, Debug)]
enum Node {
    Leaf {
        prefix: u32,
        /// One bit for each of the 64 features; 0 only in the empty set.
        bits: u64,
    },
    Branch {
        prefix: u32,
        /// The bit in which the features of the two sides differ.
        bit: u32,
        sides: [SetId; 2],
    },
}

impl Node {
    const fn prefix(self) -> u32 {
        match self {
            Self::Leaf { prefix, .. } | Self::Branch { prefix, .. } => prefix,
        }
    }

    /// Returns the number of lower bits in which the node's features may differ.
    const fn width(self) -> u32 {
        match self {
            Self::Leaf { .. } => LEAF_BITS,
            Self::Branch { bit, .. } => bit + 1,
        }
    }
}

/// A node as it is stored. Maps have about one for each edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Packed {
    /// The prefix. Its lower bits, which are 0, hold the bit of a branch, and [`LEAF`](Self::LEAF) in a leaf.
    head: u32,
    /// The halves of the bits of a leaf, or the sides of a branch.
    body: [u32; 2],
}

impl Packed {
    /// More than any bit.
    const LEAF: u32 = (1 << LEAF_BITS) - 1;

    const fn new(node: Node) -> Self {
        match node {
            Node::Leaf { prefix, bits } => Self { head: prefix | Self::LEAF, body: [bits as u32, (bits >> 32) as u32] },
            Node::Branch { prefix, bit, sides: [low, high] } => Self { head: prefix | bit, body: [low.0, high.0] },
        }
    }

    fn node(self) -> Node {
        let [a, b] = self.body;
        let prefix = above(self.head, LEAF_BITS);
        match self.head & Self::LEAF {
            Self::LEAF => Node::Leaf { prefix, bits: u64::from(b) << 32 | u64::from(a) },
            bit => Node::Branch { prefix, bit, sides: [SetId(a), SetId(b)] },
        }
    }

    fn hash(self) -> u64 {
        let [a, b] = self.body;
        hash([self.head.into(), u64::from(b) << 32 | u64::from(a)])
    }
}

#[derive(Clone, Copy)]
pub(super) enum SetOperation {
    Common,
    Either,
    Differing,
}

#[derive(Clone, Debug)]
pub(super) struct FeatureTries {
    /// Indexed by the number of the set.
    nodes: Vec<Packed>,
    numbers: NumberTable,
}

impl Default for FeatureTries {
    fn default() -> Self {
        Self { nodes: vec![Packed::new(Node::Leaf { prefix: 0, bits: 0 })], numbers: NumberTable::default() }
    }
}

/// Clears the bits of a number below `width`.
const fn above(number: u32, width: u32) -> u32 {
    if width >= u32::BITS { 0 } else { number >> width << width }
}

impl FeatureTries {
    /// Returns the set of one feature. O(1), expected.
    pub(super) fn single(&mut self, feature: FeatureId) -> SetId {
        let number = feature.number();
        let prefix = above(number, LEAF_BITS);
        self.leaf(prefix, 1 << (number - prefix))
    }

    /// Returns the set of these features. O(features · log), expected.
    pub(super) fn number(&mut self, features: impl IntoIterator<Item = FeatureId>) -> SetId {
        features.into_iter().fold(EMPTY, |set, feature| {
            let single = self.single(feature);
            self.combined(SetOperation::Either, set, single)
        })
    }

    /// Returns the features of a set, in order. O(log features) for the first, O(1) on average for each other.
    pub(super) fn members(&self, set: SetId) -> Members<'_> {
        let mut rest = [EMPTY; DEPTH];
        rest[0] = set;
        Members { nodes: &self.nodes, rest, left: 1, prefix: 0, bits: 0 }
    }

    /// Returns the features in both sets, in either, or in only one of them. O(log features) for each feature in only one set.
    pub(super) fn combined(&mut self, operation: SetOperation, a: SetId, b: SetId) -> SetId {
        let all = !matches!(operation, SetOperation::Common);
        if a == b {
            return if matches!(operation, SetOperation::Differing) { EMPTY } else { a };
        }
        if a == EMPTY || b == EMPTY {
            return match (all, a == EMPTY) {
                (false, _) => EMPTY,
                (true, true) => b,
                (true, false) => a,
            };
        }
        let [one, other] = [a, b].map(|set| self.nodes[set.0 as usize].node());
        let width = one.width().max(other.width());
        if above(one.prefix(), width) != above(other.prefix(), width) {
            return if all { self.side_by_side(a, b) } else { EMPTY };
        }
        // The recursion ends, as the widths fall with each step.
        match (one, other) {
            (Node::Leaf { prefix, bits }, Node::Leaf { bits: others, .. }) => {
                let bits = match operation {
                    SetOperation::Common => bits & others,
                    SetOperation::Either => bits | others,
                    SetOperation::Differing => bits ^ others,
                };
                self.leaf(prefix, bits)
            }
            (Node::Branch { prefix, bit, sides }, Node::Branch { bit: other_bit, sides: others, .. })
                if bit == other_bit =>
            {
                let sides = [0, 1].map(|side| self.combined(operation, sides[side], others[side]));
                self.branch(prefix, bit, sides)
            }
            (Node::Branch { prefix, bit, sides }, inside) if bit + 1 > inside.width() => {
                self.inside(operation, (prefix, bit, sides), b, inside)
            }
            (inside, Node::Branch { prefix, bit, sides }) => self.inside(operation, (prefix, bit, sides), a, inside),
            // A leaf is narrowest, so a branch on the left is the wider node.
            (Node::Branch { .. }, Node::Leaf { .. }) => EMPTY,
        }
    }

    /// Applies the operation to a branch and a set that lies on one side of it.
    fn inside(
        &mut self,
        operation: SetOperation,
        (prefix, bit, mut sides): (u32, u32, [SetId; 2]),
        set: SetId,
        node: Node,
    ) -> SetId {
        let side = (node.prefix() >> bit & 1) as usize;
        let combined = self.combined(operation, sides[side], set);
        if matches!(operation, SetOperation::Common) {
            return combined;
        }
        sides[side] = combined;
        self.branch(prefix, bit, sides)
    }

    /// Returns the union of two sets whose prefixes differ.
    fn side_by_side(&mut self, a: SetId, b: SetId) -> SetId {
        let [one, other] = [a, b].map(|set| self.nodes[set.0 as usize].node().prefix());
        let bit = (one ^ other).ilog2();
        let sides = if one < other { [a, b] } else { [b, a] };
        self.branch(above(one, bit + 1), bit, sides)
    }

    fn leaf(&mut self, prefix: u32, bits: u64) -> SetId {
        if bits == 0 { EMPTY } else { self.intern(Node::Leaf { prefix, bits }) }
    }

    fn branch(&mut self, prefix: u32, bit: u32, sides: [SetId; 2]) -> SetId {
        match sides {
            [EMPTY, set] | [set, EMPTY] => set,
            _ => self.intern(Node::Branch { prefix, bit, sides }),
        }
    }

    fn intern(&mut self, node: Node) -> SetId {
        let Self { nodes, numbers } = self;
        let node = Packed::new(node);
        if let Ok(known) = numbers.find(node.hash(), |number| nodes[number as usize] == node) {
            return SetId(known);
        }
        nodes.push(node);
        numbers.extend(nodes.len(), |number| nodes[number as usize].hash());
        SetId(nodes.len() as u32 - 1)
    }
}

/// An iterator over the features of a set, in order.
#[derive(Clone)]
pub(super) struct Members<'a> {
    nodes: &'a [Packed],
    /// The nodes after the current leaf, the next one last.
    rest: [SetId; DEPTH],
    /// The number of entries of `rest` in use.
    left: usize,
    /// The upper bits of the features of the current leaf.
    prefix: u32,
    bits: u64,
}

impl Iterator for Members<'_> {
    type Item = FeatureId;

    fn next(&mut self) -> Option<FeatureId> {
        while self.bits == 0 {
            self.left = self.left.checked_sub(1)?;
            match self.nodes[self.rest[self.left].0 as usize].node() {
                Node::Leaf { prefix, bits } => (self.prefix, self.bits) = (prefix, bits),
                Node::Branch { sides: [low, high], .. } => {
                    self.rest[self.left] = high;
                    self.rest[self.left + 1] = low;
                    self.left += 2;
                }
            }
        }
        let lowest = self.bits.trailing_zeros();
        self.bits &= self.bits - 1;
        Some(FeatureId::new(self.prefix + lowest))
    }
}

#[cfg(test)]
mod tests;
