//! Maps as plain sets of points and segments on whole numbers, with naive edits.

use crate::support::exact::{Grid, Meets, area, lies_on, meets};
use std::collections::BTreeSet;

#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Model {
    pub(crate) vertices: BTreeSet<Grid>,
    pub(crate) edges: BTreeSet<[Grid; 2]>,
}

pub(crate) fn sorted(a: Grid, b: Grid) -> [Grid; 2] {
    [a.min(b), a.max(b)]
}

fn strictly_inside(p: Grid, [a, b]: [Grid; 2]) -> bool {
    p != a && p != b && lies_on(p, a, b)
}

impl Model {
    pub(crate) fn insert_point(&mut self, p: Grid) {
        if let Some(edge) = self.edges.iter().copied().find(|edge| strictly_inside(p, *edge)) {
            self.edges.remove(&edge);
            self.edges.extend(edge.map(|end| sorted(end, p)));
        }
        self.vertices.insert(p);
    }

    pub(crate) fn crosses(&self, a: Grid, b: Grid) -> bool {
        self.edges.iter().any(|[c, d]| meets(a, b, *c, *d) == Meets::Cross)
    }

    /// Draws a segment that crosses nothing.
    pub(crate) fn insert_segment(&mut self, a: Grid, b: Grid) {
        self.insert_point(a);
        self.insert_point(b);
        // In order from one end to the other, like the points.
        let on: Vec<Grid> = self.vertices.iter().copied().filter(|p| lies_on(*p, a, b)).collect();
        self.edges.extend(on.windows(2).map(|pair| [pair[0], pair[1]]));
    }

    pub(crate) fn remove_vertex(&mut self, p: Grid) {
        self.edges.retain(|ends| !ends.contains(&p));
        self.vertices.remove(&p);
    }

    /// Returns true if a vertex can go straight to another point with nothing of the whole map in the way of it and its edges.
    pub(crate) fn way_is_free(&self, from: Grid, to: Grid) -> bool {
        let stars: Vec<Grid> =
            self.edges.iter().filter(|ends| ends.contains(&from)).map(|e| other_end(e, from)).collect();
        let others = || self.vertices.iter().copied().filter(|w| *w != from);
        let vertex_in_the_way = others()
            .any(|w| lies_on(w, from, to) || stars.iter().any(|end| *end != w && in_triangle(w, from, to, *end)));
        let static_edges = || self.edges.iter().filter(|ends| !ends.contains(&from));
        let edge_in_the_way = from != to && static_edges().any(|[c, d]| meets(from, to, *c, *d) != Meets::No);
        !vertex_in_the_way && !edge_in_the_way
    }

    pub(crate) fn move_vertex(&mut self, from: Grid, to: Grid) {
        let moved = |p: Grid| if p == from { to } else { p };
        self.edges = self.edges.iter().map(|[a, b]| sorted(moved(*a), moved(*b))).collect();
        self.vertices = self.vertices.iter().map(|p| moved(*p)).collect();
    }
}

fn other_end([a, b]: &[Grid; 2], end: Grid) -> Grid {
    if *a == end { *b } else { *a }
}

/// Returns true if p lies in the closed triangle, which may be flat: it cuts it into three of no more area in all.
fn in_triangle(p: Grid, a: Grid, b: Grid, c: Grid) -> bool {
    let whole = area(a, b, c).abs();
    let parts = area(a, b, p).abs() + area(b, c, p).abs() + area(c, a, p).abs();
    parts == whole && (whole > 0 || lies_on(p, a, b) || lies_on(p, b, c) || lies_on(p, c, a))
}
