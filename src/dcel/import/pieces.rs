//! The components of a structure in columns, found by walking around its vertices.

use crate::slots::NIL;
use crate::store::BoundaryStart;
use alloc::vec;
use alloc::vec::Vec;

/// The components of a structure whose half-edges have the numbers `2e` and `2e + 1`.
pub(in crate::dcel) struct Pieces {
    /// By vertex: its component. Components are numbered in the order of their first vertices.
    pub(in crate::dcel) of: Vec<u32>,
    pub(in crate::dcel) first: Vec<u32>,
    /// The number of half-edges visited: smaller than the number of half-edges if a vertex has several rotations.
    pub(super) visited: usize,
}

impl Pieces {
    /// Finds the components from columns: origin and next by half-edge, and a leaving half-edge (or [`NIL`]) by vertex.
    ///
    /// `next` must be a permutation that keeps rule L3, so that every walk around a vertex returns. O(n).
    pub(in crate::dcel) fn find(origin: &[u32], next: &[u32], leaving: &[u32]) -> Self {
        let mut pieces = Self { of: vec![NIL; leaving.len()], first: Vec::new(), visited: 0 };
        let mut queue = Vec::new();
        for v in 0..leaving.len() as u32 {
            if pieces.of[v as usize] != NIL {
                continue;
            }
            let piece = pieces.first.len() as u32;
            pieces.first.push(v);
            pieces.of[v as usize] = piece;
            queue.push(v);
            while let Some(v) = queue.pop() {
                let start = leaving[v as usize];
                let mut h = start;
                while h != NIL {
                    pieces.visited += 1;
                    let target = origin[h as usize ^ 1];
                    if pieces.of[target as usize] == NIL {
                        pieces.of[target as usize] = piece;
                        queue.push(target);
                    }
                    h = next[h as usize ^ 1];
                    if h == start {
                        break;
                    }
                }
            }
        }
        pieces
    }

    /// Returns the genus of each component, given the origins of half-edges and the starts of cycles: `V − E + cycles =
    /// 2 − 2g`, where an isolated vertex has one cycle. O(n).
    pub(super) fn genera(&self, origin: &[u32], starts: &[BoundaryStart<u32, u32>]) -> Vec<usize> {
        let mut edges = vec![0_usize; self.first.len()];
        for v in origin.iter().step_by(2) {
            edges[self.of[*v as usize] as usize] += 1;
        }
        let mut others = vec![0_usize; self.first.len()];
        let vertices = 0..self.of.len() as u32;
        let cycles = starts.iter().filter_map(|start| match start {
            BoundaryStart::HalfEdge(h) => Some(origin[*h as usize]),
            BoundaryStart::Vertex(_) => None,
        });
        for v in vertices.chain(cycles) {
            others[self.of[v as usize] as usize] += 1;
        }
        edges.into_iter().zip(others).map(|(edges, others)| (edges + 2).saturating_sub(others) / 2).collect()
    }
}
