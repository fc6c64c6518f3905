//! The outlines of features, on a map that does not know their faces.

use std::collections::BTreeMap;
use twinedge::dcel::HalfEdge;
use twinedge_geometry::Point;
use twinedge_map::{Embedding, PlanarMap};

/// Returns the rings that the edges of each feature form, by its index, without its spikes. O(n log n).
pub(super) fn outlines(map: &PlanarMap) -> Vec<Vec<Vec<Point>>> {
    let mut edges: Vec<Vec<HalfEdge<'_>>> = vec![Vec::new(); map.features().count()];
    for edge in map.dcel().edges() {
        for feature in map.features_along(edge.key()).into_iter().flatten() {
            edges[feature.index()].push(edge);
        }
    }
    edges.into_iter().map(|edges| closed(map, &edges)).collect()
}

/// The edges at each vertex, with the vertex at the other end.
type Around = BTreeMap<usize, Vec<(usize, usize)>>;

/// Returns closed walks that use each of these edges once, except edges that a ring follows in both directions.
fn closed(map: &PlanarMap, edges: &[HalfEdge<'_>]) -> Vec<Vec<Point>> {
    let mut at = Around::new();
    for (i, edge) in edges.iter().enumerate() {
        let [from, to] = [edge.origin().index(), edge.target().index()];
        at.entry(from).or_default().push((i, to));
        at.entry(to).or_default().push((i, from));
    }
    let mut passed = spikes(&at, edges.len());
    let mut walks = Vec::new();
    for (first, edge) in edges.iter().enumerate() {
        if passed[first] {
            continue;
        }
        let mut walk = Vec::new();
        let mut v = edge.origin().index();
        while let Some((next, to)) = at.get_mut(&v).and_then(|here| {
            while here.last().is_some_and(|(i, _)| passed[*i]) {
                here.pop();
            }
            here.pop()
        }) {
            passed[next] = true;
            walk.push(map.point(v));
            v = to;
        }
        walks.push(walk);
    }
    walks
}

/// Marks edges without which an even number of the others meets at each vertex. They always include spikes and bridges between
/// two rings: a ring follows such an edge in both directions, and it is one edge of the map.
///
/// The search runs from the leaves of a spanning forest inwards: where an odd number meets, the edge towards the root is dropped.
fn spikes(at: &Around, edges: usize) -> Vec<bool> {
    let mut dropped = vec![false; edges];
    // Each vertex with the edge and the vertex from which it was reached.
    let mut reached: BTreeMap<usize, Option<(usize, usize)>> = BTreeMap::new();
    let mut order = Vec::new();
    for root in at.keys() {
        if reached.contains_key(root) {
            continue;
        }
        reached.insert(*root, None);
        let mut next = vec![*root];
        while let Some(v) = next.pop() {
            order.push(v);
            for (edge, to) in at.get(&v).into_iter().flatten() {
                if !reached.contains_key(to) {
                    reached.insert(*to, Some((*edge, v)));
                    next.push(*to);
                }
            }
        }
    }
    let mut is_odd: BTreeMap<usize, bool> = at.iter().map(|(v, here)| (*v, here.len() % 2 == 1)).collect();
    for v in order.iter().rev() {
        if let (Some(true), Some(Some((edge, inner)))) = (is_odd.get(v), reached.get(v)) {
            dropped[*edge] = true;
            is_odd.entry(*inner).and_modify(|odd| *odd = !*odd);
        }
    }
    dropped
}
