//! Planning the changes of a snapped segment before any is made.

use super::error::EditError;
use super::region::Region;
use rustc_hash::{FxHashMap, FxHashSet};
use twinedge::dcel::VertexKey;
use twinedge_geometry::Point;
use twinedge_geometry::noding::Noded;
use twinedge_geometry::predicates::in_range;

/// The vertices along a segment, by their numbers in the noded drawing.
pub(super) type Chain = Vec<u32>;

pub(super) struct EdgeChange {
    /// Its index in the region.
    pub(super) edge: usize,
    pub(super) chain: Chain,
    /// True if the edge keeps its neighbours: all vertices in between are new, and are on no other edge.
    pub(super) bends: bool,
}

pub(super) struct SnapPlan {
    pub(super) region: Region,
    pub(super) points: Vec<Point>,
    /// The vertices of the noded drawing that already exist in the map.
    pub(super) vertices: FxHashMap<u32, VertexKey>,
    pub(super) changes: Vec<EdgeChange>,
    pub(super) way: Chain,
}

impl SnapPlan {
    /// Determines the existing vertices, the changed edges, and the changes that only bend an edge.
    pub(super) fn new(region: Region, noded: Noded) -> Result<Self, EditError> {
        let chain = |segment: usize| noded.chain(segment).into_iter().flatten().collect::<Chain>();
        let mut vertices = FxHashMap::default();
        let mut changes = Vec::new();
        for (segment, edge) in (1..).zip(&region.near) {
            let chain = chain(segment);
            let ends = region.edges[*edge].ends;
            vertices.extend([chain.first(), chain.last()].into_iter().flatten().copied().zip(ends));
            if chain.len() > 2 {
                changes.push(EdgeChange { edge: *edge, chain, bends: false });
            }
        }
        let isolated = region.near_isolated.iter().enumerate();
        vertices.extend(isolated.filter_map(|(i, v)| Some((noded.vertex_of_point(i)?, *v))));
        // A new vertex bends the first edge through it; others must be joined to it.
        let mut taken: FxHashSet<u32> = FxHashSet::default();
        for change in &mut changes {
            let between = &change.chain[1..change.chain.len() - 1];
            change.bends = between.iter().all(|number| !vertices.contains_key(number) && !taken.contains(number));
            if change.bends {
                taken.extend(between);
            }
        }
        let way = chain(0);
        let new = changes.iter().flat_map(|change| &change.chain).chain(&way);
        if let Some(number) = new.into_iter().find(|number| !in_range(noded.points[**number as usize])) {
            let Point { x, y } = noded.points[*number as usize];
            return Err(EditError::OutOfRange { x, y });
        }
        Ok(Self { region, points: noded.points, vertices, changes, way })
    }
}
