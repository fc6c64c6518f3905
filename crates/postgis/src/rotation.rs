//! The order of lines around their nodes, which determines the links between edges.

use super::lines::Lines;
use std::cmp::Ordering;
use twinedge::validate::View;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{compare_angle, in_range};
use twinedge_map::Embedding;

/// For each vertex, the half-edges that leave it, according to the lines.
pub(super) struct Rotations<'a> {
    lines: &'a Lines<'a>,
    begin: Vec<u32>,
    leaving: Vec<u32>,
}

impl<'a> Rotations<'a> {
    /// O(n) for n nodes and edges.
    pub(super) fn of(lines: &'a Lines<'a>) -> Self {
        let vertices = lines.vertex_slots();
        let origins =
            || (0..lines.half_edge_slots()).filter_map(|h| lines.origin(h).filter(|v| *v < vertices).map(|v| (h, v)));
        let mut begin = vec![0; vertices + 1];
        origins().for_each(|(_, vertex)| begin[vertex + 1] += 1);
        for vertex in 0..vertices {
            begin[vertex + 1] += begin[vertex];
        }
        let mut at = begin.clone();
        let mut leaving = vec![0; begin[vertices] as usize];
        for (half_edge, vertex) in origins() {
            leaving[at[vertex] as usize] = half_edge as u32;
            at[vertex] += 1;
        }
        Self { lines, begin, leaving }
    }

    fn leaving(&self, vertex: usize) -> impl Iterator<Item = usize> + '_ {
        let bound = |vertex: usize| self.begin.get(vertex).map_or(self.leaving.len(), |place| *place as usize);
        self.leaving[bound(vertex)..bound(vertex + 1)].iter().map(|h| *h as usize)
    }

    /// Returns the links at a vertex according to the lines: each half-edge that arrives, and its next one, the first clockwise.
    /// `None` where lines are missing or leave in the same direction. O(d log d) for d edges at the vertex.
    pub(super) fn links(&self, vertex: usize) -> Option<Vec<[usize; 2]>> {
        let toward = |h: usize| Some((h, self.lines.first_segment(h)?));
        let mut around: Vec<(usize, [Point; 2])> = self.leaving(vertex).map(toward).collect::<Option<_>>()?;
        let compare = |a: &[Point; 2], b: &[Point; 2]| compare_angle(a[0], a[1], b[1]);
        around.sort_by(|(_, a), (_, b)| compare(a, b));
        if around.windows(2).any(|pair| compare(&pair[0].1, &pair[1].1) == Ordering::Equal) {
            return None;
        }
        let clockwise = around.iter().skip(1).chain(around.first());
        Some(clockwise.zip(&around).map(|((from, _), (next, _))| [from ^ 1, *next]).collect())
    }
}

impl Lines<'_> {
    /// Returns the first two points of the line of a half-edge; `None` without such a line, or without a direction.
    fn first_segment(&self, half_edge: usize) -> Option<[Point; 2]> {
        if !self.is_half_edge(half_edge) {
            return None;
        }
        let end = |h: usize| Some(self.point(self.origin(h)?));
        let second = if self.bends(half_edge) > 0 { self.bend(half_edge, 0) } else { end(half_edge ^ 1)? };
        let pair = [end(half_edge)?, second];
        (pair.iter().all(|p| in_range(*p)) && pair[0] != pair[1]).then_some(pair)
    }
}
