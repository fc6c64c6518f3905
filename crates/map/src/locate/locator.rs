//! The index: a search graph, and a grid in front of it.

use super::cells::Cells;
use super::graph::{Graph, GraphHit};
use super::located::{LocateError, Located, check_range};
use super::trapezoids::{Drawing, GraphError};
use crate::Embedding;
use crate::not_plane::NotPlane;
use crate::planar_map::PlanarMap;
use twinedge::dcel::Vertex;
use twinedge_geometry::bounds::Bounds;
use twinedge_geometry::curve::Curve;
use twinedge_geometry::predicates::compare_lexicographic;
use twinedge_geometry::{Point, threads};

/// An index of a map: point location, and the elements along lines.
///
/// It borrows the map, so the map cannot change meanwhile. The [module](crate::locate) has an example.
pub struct Locator<'m> {
    pub(crate) map: &'m PlanarMap,
    graph: Graph,
    /// `None` if the map has no vertex.
    cells: Option<Cells>,
    vertices: Vec<u32>,
    /// For each segment of the graph, the half-edge that runs from its lower end to its higher.
    rising: Vec<u32>,
}

impl core::fmt::Debug for Locator<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Locator").field("vertices", &self.vertices.len()).field("edges", &self.rising.len()).finish()
    }
}

impl<'m> Locator<'m> {
    /// Builds the index. Expected time O(n log n) and expected memory O(n), some 200 bytes for each edge. The expectation is over
    /// the random insertion order of edges, not over maps: fans, combs, long parallels and thousands of islands are no worse than
    /// other maps. The order comes from a fixed pseudo-random sequence, so equal maps have equal indices. With the feature
    /// `rayon`, slabs of the map are divided among the threads of the current pool.
    ///
    /// Lines also use the index kept by the map; the first [`zone`](Self::zone) builds it.
    ///
    /// # Errors
    /// [`LocateError::NotPlane`] unless [`PlanarMap::is_plane`]. [`LocateError::TooLarge`] beyond some hundred million edges.
    pub fn new(map: &'m PlanarMap) -> Result<Self, LocateError> {
        map.plane()?;
        let dcel = map.dcel();
        // Points and segments are numbered along a curve, so that neighbours are near each other in memory.
        let bounds = Bounds::around(dcel.vertices().map(|v| map.point(v.index())));
        let mut along: Vec<u64> = Vec::with_capacity(dcel.vertex_count());
        if let Some(curve) = bounds.map(Curve::through) {
            let place = |v: Vertex<'_>| u64::from(curve.place(map.point(v.index())));
            along.extend(dcel.vertices().map(|v| place(v) << 32 | v.index() as u64));
        }
        threads::sort_unstable_by(&mut along, Ord::cmp);
        let vertices: Vec<u32> = along.into_iter().map(|key| key as u32).collect();
        let points: Vec<Point> = vertices.iter().map(|v| map.point(*v as usize)).collect();
        let slots = vertices.iter().max().map_or(0, |last| *last as usize + 1);
        let mut numbers = vec![0_u32; slots];
        for (number, vertex) in (0..).zip(&vertices) {
            numbers[*vertex as usize] = number;
        }
        let edges = dcel.edge_count();
        let (mut segments, mut rising, mut faces) =
            (Vec::with_capacity(edges), Vec::with_capacity(edges), Vec::with_capacity(edges));
        for (low, from) in (0..).zip(&points) {
            let around = dcel.vertex_at(vertices[low as usize] as usize).into_iter().flat_map(|v| v.rotation());
            for h in around {
                let high = numbers[h.target().index()];
                if compare_lexicographic(*from, points[high as usize]).is_lt() {
                    segments.push([low, high]);
                    rising.push(h.index() as u32);
                    faces.push(h.face().index() as u32);
                }
            }
        }
        let ends = segments.iter().map(|ends| ends.map(|end| points[end as usize])).collect();
        let drawn = Drawing { points, segments, ends };
        let graph =
            Graph::new(drawn, &faces, dcel.unbounded_face().index() as u32).map_err(|failure| match failure {
                GraphError::TooLarge => LocateError::TooLarge,
                GraphError::Clash => NotPlane::default().into(),
            })?;
        let cells = bounds.map(|bounds| Cells::new(&graph, bounds));
        Ok(Self { map, graph, cells, vertices, rising })
    }

    /// Returns the map.
    #[must_use]
    pub const fn map(&self) -> &'m PlanarMap {
        self.map
    }

    /// Returns the location of a point. An edge is named by the half-edge that runs to the right, or straight up. O(log n)
    /// expected.
    ///
    /// ```
    /// use twinedge_geometry::Point;
    /// use twinedge_map::{Located, Locator, PlanarMap};
    ///
    /// let mut map = PlanarMap::new();
    /// let ring = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])?;
    /// let locator = Locator::new(&map)?;
    /// assert_eq!(locator.locate(Point::new(1.0, 1.0))?, Located::Face(ring.faces_split[0].1));
    /// assert_eq!(locator.locate(Point::new(1.0, 0.0))?, Located::Edge(ring.way[0]));
    /// assert_eq!(locator.locate(Point::new(4.0, 0.0))?, Located::Vertex(ring.vertices[1]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`LocateError::OutOfRange`].
    pub fn locate(&self, p: Point) -> Result<Located, LocateError> {
        check_range(p)?;
        let dcel = self.map.dcel();
        let Some(stage) = self.cells.as_ref().and_then(|cells| cells.stage(p)) else {
            return Ok(Located::Face(dcel.unbounded_face().key()));
        };
        let located = match self.graph.find(stage, p) {
            GraphHit::Face(face) => dcel.face_at(face as usize).map(|f| Located::Face(f.key())),
            GraphHit::Point(point) => {
                dcel.vertex_at(self.vertices[point as usize] as usize).map(|v| Located::Vertex(v.key()))
            }
            GraphHit::Segment(segment) => {
                dcel.half_edge_at(self.rising[segment as usize] as usize).map(|h| Located::Edge(h.key()))
            }
        };
        // The map is borrowed, so every record of the index is live.
        Ok(located.unwrap_or(Located::Face(dcel.unbounded_face().key())))
    }

    /// Returns the locations of some points, in order, as [`locate`](Self::locate) does. O(log n) expected for each; with the
    /// feature `rayon`, the points are divided among the threads of the current pool.
    ///
    /// ```
    /// use twinedge_map::{Located, Locator, PlanarMap};
    ///
    /// let mut map = PlanarMap::new();
    /// let ring = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])?;
    /// let (outside, inside) = ring.faces_split[0];
    /// let places = Locator::new(&map)?.locate_all(&[[1.0, 1.0], [9.0, 9.0]].map(Into::into));
    /// assert_eq!(places, [Ok(Located::Face(inside)), Ok(Located::Face(outside))]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`LocateError::OutOfRange`] in place of each point that is out of range.
    #[must_use]
    pub fn locate_all(&self, points: &[Point]) -> Vec<Result<Located, LocateError>> {
        threads::map(points, |p| self.locate(*p))
    }
}

#[cfg(test)]
mod tests;
