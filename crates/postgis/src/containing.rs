//! P2 with broken links: finds the face that contains an isolated node from the lines and their face columns alone.
//!
//! A ray from the node to the right crosses lines. The node is inside a face if the ray crosses an odd number of the lines that
//! have the face on one side only. Those lines must close, with an even number of them at every end; otherwise nothing is known.

use super::finding::{Finding, Findings};
use super::topology::Topology;
use std::collections::BTreeSet;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, on_segment, orientation};

/// Reports isolated nodes that lie in a face other than their `containing_face`, and returns the number of nodes with unknown
/// result. The lines around the open faces do not close.
///
/// O(n log k + c log k) for n points of lines, k isolated nodes, and c pairs of a node and a segment at its height.
pub(super) fn containing(topology: &Topology, open: &BTreeSet<u32>, findings: &mut Findings) -> u64 {
    let mut nodes: Vec<(Point, u32, u32)> =
        topology.contained.iter().map(|(face, node)| (topology.points[*node as usize], *face, *node)).collect();
    nodes.retain(|(point, ..)| point.x.is_finite() && point.y.is_finite());
    let mut unknown = (topology.contained.len() - nodes.len()) as u64;
    nodes.sort_by(|a, b| a.0.y.total_cmp(&b.0.y));
    // For each node, the faces with an odd number of crossed lines; none for a node on a line.
    let mut inside: Vec<Option<BTreeSet<u32>>> = vec![Some(BTreeSet::new()); nodes.len()];
    for edge in 0..topology.edges.len() {
        let [left, right] = topology.sides[edge];
        for pair in topology.line_points(edge).windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
            let from = nodes.partition_point(|(p, ..)| p.y < low.y);
            let at_height = nodes[from..].iter().take_while(|(p, ..)| p.y <= high.y).zip(&mut inside[from..]);
            for ((p, ..), faces) in at_height {
                if on_segment(*p, a, b) {
                    *faces = None;
                } else if let Some(faces) = faces
                    && left != right
                    && p.y < high.y
                    && orientation(low, high, *p) == Orientation::CounterClockwise
                {
                    for face in [left, right] {
                        if !faces.remove(&face) {
                            faces.insert(face);
                        }
                    }
                }
            }
        }
    }
    let universe = topology.universe().map(|slot| slot as u32);
    let name = |face: u32| topology.faces.id(face as usize);
    for ((_, face, node), faces) in nodes.iter().zip(&inside) {
        let Some(faces) = faces else {
            unknown += 1;
            continue;
        };
        let is_known = |face: &u32| Some(*face) != universe && !open.contains(face) && name(*face).is_some();
        let bounded = faces.iter().copied().find(is_known);
        let lies_in_own = if Some(*face) == universe {
            // The lines at face 0 are crossed on the way in and out of the map.
            if bounded.is_some() {
                Some(false)
            } else if open.contains(face) {
                None
            } else {
                Some(!faces.contains(face))
            }
        } else if !open.contains(face) {
            Some(faces.contains(face))
        } else {
            bounded.map(|_| false)
        };
        let id = topology.nodes.id(*node as usize).unwrap_or_default();
        match (lies_in_own, name(*face)) {
            (Some(false), Some(face)) => {
                findings.add(Finding::LiesElsewhere { node: id, face, lies_in: bounded.and_then(name) });
            }
            (Some(_), _) => {}
            (None, _) => unknown += 1,
        }
    }
    unknown
}
