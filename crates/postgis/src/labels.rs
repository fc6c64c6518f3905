//! Compares the faces that half-edges name with the lines: a label fits if the lines around its face close.

use super::lines::Lines;
use super::topology::Topology;
use std::collections::{BTreeMap, BTreeSet};
use twinedge::validate::View;

/// The lines around each face: the ends at which they do not close, and the enclosed area.
pub(super) struct Labels<'a> {
    topology: &'a Topology,
    lines: &'a Lines<'a>,
    odd: BTreeMap<u32, BTreeSet<u32>>,
    /// Twice the area of each face, negative for the unbounded one. It is rounded.
    areas: Vec<f64>,
}

impl<'a> Labels<'a> {
    /// O(n log n) for n edges and bends.
    pub(super) fn of(topology: &'a Topology, lines: &'a Lines<'a>) -> Self {
        let mut areas = vec![0.0; topology.faces.len()];
        for half_edge in 0..topology.half_edge_slots() {
            if let Some(area) = topology.face(half_edge).and_then(|face| areas.get_mut(face)) {
                *area += swept(topology, half_edge);
            }
        }
        Self { topology, lines, odd: lines.odd_ends(), areas }
    }

    /// Returns true if naming this face instead would close the lines around it and around the face that the half-edge names now,
    /// and enclose an area: a positive one, or for the unbounded face a negative one.
    pub(super) fn fits(&self, half_edge: usize, face: usize) -> bool {
        let named = self.topology.face(half_edge).filter(|named| *named < self.areas.len());
        let ends = [half_edge, half_edge ^ 1].map(|h| self.lines.origin(h).unwrap_or_default() as u32);
        let open: BTreeSet<u32> = if ends[0] == ends[1] { BTreeSet::new() } else { ends.into() };
        let closes = |face: usize| self.odd.get(&(face as u32)).map_or(open.is_empty(), |odd| *odd == open);
        let encloses = |face: usize, sign: f64| {
            let area = self.areas[face] + sign * swept(self.topology, half_edge);
            if self.topology.universe() == Some(face) { area < 0.0 } else { area > 0.0 }
        };
        named != Some(face)
            && [(Some(face), 1.0), (named, -1.0)]
                .into_iter()
                .all(|(face, sign)| face.is_none_or(|face| closes(face) && encloses(face, sign)))
    }
}

/// Returns twice the area that a half-edge sweeps, seen from the first node.
fn swept(topology: &Topology, half_edge: usize) -> f64 {
    let Some(center) = topology.points.first() else { return 0.0 };
    let points = topology.line_points(half_edge / 2);
    let segment = |pair: &[_]| -> f64 {
        let [a, b]: [twinedge_geometry::Point; 2] = [pair[0], pair[1]];
        (a.x - center.x) * (b.y - center.y) - (b.x - center.x) * (a.y - center.y)
    };
    let forwards: f64 = points.windows(2).map(segment).sum();
    if half_edge.is_multiple_of(2) { forwards } else { -forwards }
}
