//! The rings that the ways of a relation make.

use super::elements::Role;
use rustc_hash::FxHashMap;

/// A way that is a member, with two or more different nodes in a row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece<'a> {
    pub(super) way: i64,
    pub(super) role: Role,
    pub(super) nodes: &'a [i64],
}

impl Piece<'_> {
    fn ends(&self) -> [i64; 2] {
        [self.nodes[0], self.nodes[self.nodes.len() - 1]]
    }
}

/// A ring: the numbers of its pieces, and for each whether it is passed from its first node to its last.
pub(super) type Ring = Vec<(usize, bool)>;

/// The pieces at each node that are not in a ring yet, those of each role from the last to the first.
struct Ends {
    at: FxHashMap<i64, [Vec<usize>; 3]>,
    used: Vec<bool>,
}

impl Ends {
    fn new(pieces: &[Piece<'_>]) -> Self {
        let mut at: FxHashMap<i64, [Vec<usize>; 3]> = FxHashMap::default();
        for (number, piece) in pieces.iter().enumerate().rev() {
            for end in piece.ends() {
                at.entry(end).or_default()[piece.role as usize].push(number);
            }
        }
        Self { at, used: vec![false; pieces.len()] }
    }

    /// Takes a piece at a node, of this role if there is one.
    fn take(&mut self, node: i64, role: Role) -> Option<usize> {
        let of_node = self.at.get_mut(&node)?;
        let order = [role as usize, 0, 1, 2];
        for role in order {
            while let Some(number) = of_node[role].pop() {
                if !self.used[number] {
                    self.used[number] = true;
                    return Some(number);
                }
            }
        }
        None
    }
}

/// The nodes at which an odd number of pieces end, in order: no rings go through all of these.
pub(super) fn open_ends(pieces: &[Piece<'_>]) -> Vec<i64> {
    let mut ends: Vec<i64> = pieces.iter().flat_map(Piece::ends).collect();
    ends.sort_unstable();
    ends.chunk_by(|a, b| a == b).filter(|same| !same.len().is_multiple_of(2)).map(|same| same[0]).collect()
}

/// The rings, none of which passes through the end of a piece twice. Pieces that lead nowhere are left out; without open ends there are none of these.
///
/// O(nodes), expected.
pub(super) fn rings(pieces: &[Piece<'_>]) -> Vec<Ring> {
    let mut ends = Ends::new(pieces);
    let mut rings = Vec::new();
    for start in 0..pieces.len() {
        if ends.used[start] {
            continue;
        }
        ends.used[start] = true;
        let [first, second] = pieces[start].ends();
        // The nodes on the way, each with its place there.
        let mut path: Ring = vec![(start, true)];
        let mut nodes = vec![first, second];
        let mut places: FxHashMap<i64, usize> = FxHashMap::from_iter([(first, 0)]);
        while let Some(&(last, _)) = path.last() {
            let at = nodes[path.len()];
            let place = *places.entry(at).or_insert(path.len());
            if place < path.len() {
                for node in nodes.drain(place + 1..).filter(|node| *node != at) {
                    places.remove(&node);
                }
                rings.push(path.split_off(place));
                continue;
            }
            if let Some(next) = ends.take(at, pieces[last].role) {
                let [first, second] = pieces[next].ends();
                path.push((next, first == at));
                nodes.push(if first == at { second } else { first });
            } else {
                path.pop();
                nodes.pop();
                places.remove(&at);
            }
        }
    }
    rings
}

/// The nodes around a ring; the last is the first.
pub(super) fn around(ring: &Ring, pieces: &[Piece<'_>]) -> Vec<i64> {
    let mut nodes: Vec<i64> = Vec::new();
    for (number, is_forward) in ring {
        let piece = pieces[*number].nodes;
        // The first node is the last one of the piece before.
        let skip = usize::from(!nodes.is_empty());
        if *is_forward {
            nodes.extend(piece.iter().skip(skip));
        } else {
            nodes.extend(piece.iter().rev().skip(skip));
        }
    }
    nodes
}
