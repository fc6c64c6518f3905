//! Where is it? Point location by an index, and without one.
//!
//! | | builds | answers in | for |
//! | --- | --- | --- | --- |
//! | [`Locator`] | O(n log n) | O(log n) | many questions about one map |
//! | [`PlanarMap::locate_from`] | nothing | the boundaries of the faces on the way | few questions, or a map that changes between them |
//!
//! Both are exact: a point is at a vertex, inside an edge or in a face, and there is no tolerance.
//!
//! ```
//! use twinedge::geometry::Point;
//! use twinedge::map::{Builder, Located, Locator, Shape};
//!
//! let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(Point::from).to_vec();
//! let lake = [[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]].map(Point::from).to_vec();
//! let mut builder = Builder::new();
//! let land = builder.shape(&Shape::Polygon(vec![square, lake]))?;
//! let map = builder.build()?;
//!
//! let locator = Locator::new(&map)?;
//! let Located::Face(face) = locator.locate(Point::new(3.0, 3.0))? else { panic!("it is inside") };
//! assert!(map.features_of(face)?.eq([land]));
//! // From one answer to the next question, without the index.
//! let Located::Face(lake) = map.locate_from(Point::new(1.25, 1.25), face)? else { panic!("it is inside") };
//! assert_eq!(map.features_of(lake)?.count(), 0);
//! assert!(matches!(locator.locate(Point::new(1.5, 1.5))?, Located::Edge(_)));
//! assert!(matches!(locator.locate(Point::new(4.0, 4.0))?, Located::Vertex(_)));
//! assert_eq!(locator.locate(Point::new(5.0, 4.0))?, Located::Face(map.dcel().unbounded_face().key()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # How
//!
//! The index is the search graph of a trapezoidal map (see `trapezoids.rs`): O(n) memory and O(log n) questions, whatever
//! the drawing. In front of it stands a grid of about one cell per edge. A cell that no edge meets knows its face, so most
//! searches on a map end where they begin; and the worst is still the worst of the graph, since the grid has one number per
//! cell and no lists.

mod cells;
mod graph;
mod look;
mod trapezoids;

use super::PlanarMap;
use super::zone::Boxes;
use crate::dcel::{FaceKey, HalfEdgeKey, StaleKey, VertexKey};
use crate::geometry::Point;
use crate::geometry::predicates::{compare_lexicographic, in_range};
use crate::validate::Embedding;
use cells::Cells;
use graph::{Found, Graph};
pub(super) use look::look;
use thiserror::Error;
use trapezoids::{Drawn, Failure};

/// Where a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Located {
    /// In this face, and not on its boundary.
    Face(FaceKey),
    /// Inside the edge of this half-edge.
    Edge(HalfEdgeKey),
    /// At this vertex.
    Vertex(VertexKey),
}

impl From<FaceKey> for Located {
    fn from(face: FaceKey) -> Self {
        Self::Face(face)
    }
}

impl From<HalfEdgeKey> for Located {
    fn from(half_edge: HalfEdgeKey) -> Self {
        Self::Edge(half_edge)
    }
}

impl From<VertexKey> for Located {
    fn from(vertex: VertexKey) -> Self {
        Self::Vertex(vertex)
    }
}

/// Why there is no answer.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum LocateError {
    /// A coordinate of the point is NaN or infinite, or beyond the range in which the predicates are exact; see
    /// [`in_range`].
    #[error("the point ({:?}, {:?}) is not in the range of exact arithmetic", .0.x, .0.y)]
    OutOfRange(Point),
    /// The two points that should give a direction are this same one.
    #[error("there is no direction from ({}, {}) to itself", .0.x, .0.y)]
    NoDirection(Point),
    /// The line does not meet the edge of this half-edge in a point.
    #[error("the line does not meet the edge of {0:?}")]
    NotMet(HalfEdgeKey),
    /// The map is not plane.
    #[error("the map is not plane")]
    NotPlane,
    /// There are more edges than the index can number.
    #[error("the map is too large for an index")]
    TooLarge,
    /// A key names nothing.
    #[error(transparent)]
    Stale(#[from] StaleKey),
}

/// Refuses a point beyond the range of exact arithmetic.
pub(super) fn check(p: Point) -> Result<(), LocateError> {
    if in_range(p) { Ok(()) } else { Err(LocateError::OutOfRange(p)) }
}

/// An index of a map: where points lie, and what lines meet.
///
/// It borrows the map, so the map cannot change under it. See the [module](self) for an example.
pub struct Locator<'m> {
    pub(super) map: &'m PlanarMap,
    graph: Graph,
    /// Nothing, if the map has no vertex.
    cells: Option<Cells>,
    /// The vertex of each point of the graph.
    vertices: Vec<u32>,
    /// For each segment of the graph, the half-edge that runs from its lower end to its higher.
    rising: Vec<u32>,
    pub(super) boxes: Boxes,
}

impl core::fmt::Debug for Locator<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Locator").field("vertices", &self.vertices.len()).field("edges", &self.rising.len()).finish()
    }
}

impl<'m> Locator<'m> {
    /// Builds the index. Expected time O(n log n) and expected memory O(n), some 200 bytes for each edge. The
    /// expectation is over the orders in which edges may be put in, and not over the maps: fans, combs, long parallels
    /// and thousands of islands are no worse than others. The order is that of a fixed pseudo-random sequence, so equal
    /// maps have equal indices.
    ///
    /// # Errors
    /// [`LocateError::NotPlane`], if [`PlanarMap::is_plane`] says no. [`LocateError::TooLarge`] beyond some hundred
    /// million edges.
    pub fn new(map: &'m PlanarMap) -> Result<Self, LocateError> {
        if !map.is_plane() {
            return Err(LocateError::NotPlane);
        }
        let dcel = map.dcel();
        let mut vertices: Vec<u32> = dcel.vertices().map(|v| v.index() as u32).collect();
        let point = |v: &u32| map.point(*v as usize);
        vertices.sort_unstable_by(|a, b| compare_lexicographic(point(a), point(b)));
        let slots = vertices.iter().max().map_or(0, |last| *last as usize + 1);
        let mut places = vec![0_u32; slots];
        for (place, vertex) in (0..).zip(&vertices) {
            places[*vertex as usize] = place;
        }
        let mut drawn = Drawn { points: vertices.iter().map(point).collect(), segments: Vec::new() };
        let mut rising = Vec::with_capacity(dcel.edge_count());
        for h in dcel.half_edges() {
            let ends = [h.origin(), h.target()].map(|v| places[v.index()]);
            if ends[0] < ends[1] {
                drawn.segments.push(ends);
                rising.push(h.index() as u32);
            }
        }
        let bounds = bounds(&drawn.points);
        let boxes = Boxes::new(map);
        let face_above = |segment: Option<u32>| {
            let edge = segment.and_then(|segment| dcel.half_edge_at(rising[segment as usize] as usize));
            edge.map_or(dcel.unbounded_face(), |h| h.face()).index() as u32
        };
        let graph = Graph::new(drawn, face_above).map_err(|failure| match failure {
            Failure::TooLarge => LocateError::TooLarge,
            Failure::Clash => LocateError::NotPlane,
        })?;
        let cells = bounds.map(|bounds| Cells::new(&graph, bounds));
        Ok(Self { map, graph, cells, vertices, rising, boxes })
    }

    /// The map.
    #[must_use]
    pub const fn map(&self) -> &'m PlanarMap {
        self.map
    }

    /// Where a point lies. An edge is named by the half-edge that runs to the right, or straight up. O(log n) expected.
    ///
    /// # Errors
    /// [`LocateError::OutOfRange`].
    pub fn locate(&self, p: Point) -> Result<Located, LocateError> {
        check(p)?;
        let dcel = self.map.dcel();
        let Some(stage) = self.cells.as_ref().and_then(|cells| cells.stage(p)) else {
            return Ok(Located::Face(dcel.unbounded_face().key()));
        };
        let located = match self.graph.find(stage, p) {
            Found::Face(face) => dcel.face_at(face as usize).map(|f| Located::Face(f.key())),
            Found::Point(point) => {
                dcel.vertex_at(self.vertices[point as usize] as usize).map(|v| Located::Vertex(v.key()))
            }
            Found::Segment(segment) => {
                dcel.half_edge_at(self.rising[segment as usize] as usize).map(|h| Located::Edge(h.key()))
            }
        };
        // The map is borrowed: all that was there is there.
        Ok(located.unwrap_or(Located::Face(dcel.unbounded_face().key())))
    }
}

/// The smallest box around points.
fn bounds(points: &[Point]) -> Option<[Point; 2]> {
    let first = *points.first()?;
    Some(points.iter().fold([first, first], |[min, max], p| {
        [Point::new(min.x.min(p.x), min.y.min(p.y)), Point::new(max.x.max(p.x), max.y.max(p.y))]
    }))
}

#[cfg(test)]
mod tests;
