//! Delaunay triangulations and Voronoi diagrams of points, as maps.
//!
//! ```text
//!   sites            Delaunay              Voronoi, closed by a box
//!
//!                                          ┌─────────┬─────────┐
//!   ·       ·        ·───────·             │    ·    │    ·    │
//!                    │ ╲   ╱ │             │       ╱   ╲       │
//!       ·            │   ·   │             ├─────╱  ·  ╲───────┤
//!                    │ ╱   ╲ │             │     ╲     ╱       │
//!   ·       ·        ·───────·             │    ·  ╲ ╱    ·    │
//!                                          └────────┴──────────┘
//! ```
//!
//! [`delaunay`] makes a vertex of each site and [`voronoi`] a face. Equal sites are merged, and every result is a valid
//! [`PlanarMap`]: R1 … T4 and G1 … G5 hold. The two are dual: two cells have a common border if the sites are joined by an edge
//! whose border lies inside the box, and each vertex of the diagram inside the box is the circumcentre of a triangle.
//!
//! # Rounding
//!
//! The triangulation is exact. The vertices of the Voronoi diagram are circumcentres, rounded to the nearest doubles, or nearly.
//! Centres of triangles with a common circle are merged, by an exact test. The diagram is assembled from the rounded centres, and
//! then *checked*: every cell must be convex, which implies that the diagram is plane, since the cells have the correct
//! orientation, their number equals the number of sites, and they fill the box. If that fails, the ends of the shortest borders
//! are merged, up to a length of 2^-38 times the coordinates of the box. (Points nearly on a circle need this.) If a site still
//! has no cell of its own, it is too close to others for doubles to distinguish their cells: an error,
//! [`VoronoiError::TooClose`]. [`voronoi_merging`] lets it share the cell of a neighbour.
//!
//! # Why `spade`
//!
//! The triangulation comes from the crate `spade` rather than `delaunator`; both were measured. `delaunator` (1.1) is faster, 70
//! against 90 ms for 10^5 random points, but rounds its tests of circles, so its result is not always Delaunay; drops points that
//! differ by at most 2^-51; and for collinear points returns their order. `spade` (2.15) decides exactly and keeps all.
//!
//! Sources: M. de Berg et al., "Computational Geometry", 3rd edition, chapters 7 and 9; G. Voronoï, "Nouvelles applications
//! des paramètres continus à la théorie des formes quadratiques", Journal für die reine und angewandte Mathematik 134 (1908)
//! 198-287; B. Delaunay, "Sur la sphère vide", Bulletin de l'Académie des Sciences de l'URSS (1934) 793-800.
//!
//! ```
//! use twinedge_algorithm::voronoi::{delaunay, voronoi};
//! use twinedge_geometry::Point;
//!
//! let sites = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [4.0, 4.0], [2.0, 2.0]].map(Point::from);
//! let triangles = delaunay(&sites)?;
//! assert_eq!((triangles.map.dcel().vertex_count(), triangles.map.dcel().face_count()), (5, 4 + 1));
//!
//! let cells = voronoi(&sites, None)?;
//! assert_eq!(cells.map.dcel().face_count(), 5 + 1);
//! // The cell of the site in the middle is the square through the middles of the sides.
//! assert_eq!(twinedge_algorithm::area::face_area(&cells.map, cells.cells[4])?, 8.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bounds;
mod cells;
mod centre;
mod connected;
mod error;
mod sites;

pub use error::VoronoiError;

use connected::{connected, half_edge, vertex};
use petgraph::unionfind::UnionFind;
use sites::Sites;
use spade::Triangulation as _;
use twinedge::dcel::{FaceKey, VertexKey};
use twinedge_geometry::Point;
use twinedge_map::PlanarMap;

/// A Delaunay triangulation.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Delaunay {
    /// The triangulation of the convex hull of the sites. If all sites lie on a line, it is the chain of them.
    pub map: PlanarMap,
    /// The vertex of each site, in order of the sites. Equal sites have the same vertex.
    pub vertices: Vec<VertexKey>,
}

/// A Voronoi diagram.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Voronoi {
    /// The diagram. Its bounded faces are the cells.
    pub map: PlanarMap,
    /// The cell of each site, in order of the sites. Equal sites have the same cell.
    pub cells: Vec<FaceKey>,
    /// The lower left and the upper right corner of the box that closes the unbounded cells.
    pub bounds: [Point; 2],
    /// Sites without a cell, each with the site whose cell it shares: only from [`voronoi_merging`]. Equal sites are not listed.
    pub merged: Vec<[usize; 2]>,
}

/// Computes the Delaunay triangulation of some sites: no site lies inside the circumcircle of a triangle. If more than three
/// sites lie on such a circle, the triangulation is one of several.
///
/// O(n log n) time for n sites in practice; O(n²) at worst, for collinear sites.
///
/// # Errors
/// [`VoronoiError::NotFinite`], [`VoronoiError::OutOfRange`] and [`VoronoiError::Full`].
pub fn delaunay(sites: &[Point]) -> Result<Delaunay, VoronoiError> {
    let placed = Sites::new(sites)?;
    let Sites { triangulation, numbers } = &placed;
    let points: Vec<Point> = triangulation.vertices().map(|v| v.data().point()).collect();
    let segments: Vec<[u32; 2]> =
        triangulation.undirected_edges().map(|e| e.vertices().map(|v| v.index() as u32)).collect();
    let map = connected(points, &segments)?.ok_or_else(|| placed.too_close())?;
    let vertices = numbers.iter().map(|number| vertex(&map, *number)).collect::<Option<_>>();
    Ok(Delaunay { vertices: vertices.unwrap_or_default(), map })
}

/// Computes the Voronoi diagram of some sites: each point of a cell is at least as near to its site as to all others.
///
/// Cells are cut off at a box, whose corners are returned: the given box, which must contain the sites; or by default one a tenth
/// wider on each side than the sites need.
///
/// O(n log n) time for n sites in practice; O(n²) at worst, for collinear sites.
///
/// # Errors
/// [`VoronoiError`].
pub fn voronoi(sites: &[Point], bounds: Option<[Point; 2]>) -> Result<Voronoi, VoronoiError> {
    let placed = Sites::new(sites)?;
    diagram(&placed, bounds::bounds(sites, bounds)?)?.ok_or_else(|| placed.too_close())
}

/// Computes a Voronoi diagram in which sites share a cell if doubles cannot distinguish their cells. [`Voronoi::merged`] names
/// them.
///
/// Neighbouring sites are merged, the closest first, up to twice the distance each time, until there is a diagram: no site is
/// merged with one much farther away than necessary.
///
/// The cost of [`voronoi`], for each round of merging.
///
/// ```
/// use twinedge_algorithm::voronoi::{VoronoiError, voronoi, voronoi_merging};
/// use twinedge_geometry::Point;
///
/// // Three numbers next to each other: the borders between them would be rounded to the same number.
/// let next = |steps: u64| Point::new(f64::from_bits(1.0_f64.to_bits() + steps), 0.0);
/// let sites = [Point::new(5.0, 0.0), next(0), next(1), next(2), next(3)];
/// assert!(matches!(voronoi(&sites, None), Err(VoronoiError::TooClose { .. })));
/// let cells = voronoi_merging(&sites, None)?;
/// assert_eq!(cells.merged, [[2, 1], [3, 1], [4, 1]]);
/// assert_eq!((cells.map.dcel().face_count(), cells.cells[1]), (2 + 1, cells.cells[4]));
/// # Ok::<(), VoronoiError>(())
/// ```
///
/// # Errors
/// As for [`voronoi`], except [`VoronoiError::TooClose`].
pub fn voronoi_merging(sites: &[Point], bounds: Option<[Point; 2]>) -> Result<Voronoi, VoronoiError> {
    let mut placed = Sites::new(sites)?;
    let bounds = bounds::bounds(sites, bounds)?;
    // For each site, the first site with the same coordinates.
    let first = placed.first();
    let mut with: Vec<usize> = placed.numbers.iter().map(|number| first[*number as usize]).collect();
    let mut length = 0.0;
    loop {
        if let Some(found) = diagram(&placed, bounds)? {
            let merged = with.into_iter().enumerate().filter(|(site, with)| sites[*site] != sites[*with]);
            return Ok(Voronoi { merged: merged.map(<[usize; 2]>::from).collect(), ..found });
        }
        let shortest = placed.pairs().map(|(_, distance)| distance).min_by(f64::total_cmp);
        length = shortest.map_or(f64::INFINITY, |shortest| shortest.max(2.0 * length));
        let mut sets = UnionFind::<u32>::new(sites.len());
        let close = placed.pairs().filter(|(_, distance)| *distance <= length);
        close.for_each(|([a, b], _)| {
            sets.union(a as u32, b as u32);
        });
        if shortest.is_none() {
            return Err(placed.too_close());
        }
        let mut first: Vec<Option<usize>> = vec![None; sites.len()];
        for (site, with) in with.iter_mut().enumerate() {
            *with = *first[sets.find_mut(*with as u32) as usize].get_or_insert(site);
        }
        placed = Sites::new(&with.iter().map(|site| sites[*site]).collect::<Vec<_>>())?;
    }
}

/// Computes the diagram in a box; `None` if doubles cannot distinguish the cells.
fn diagram(placed: &Sites, bounds: [Point; 2]) -> Result<Option<Voronoi>, VoronoiError> {
    let Sites { triangulation, numbers } = placed;
    let largest = bounds.iter().flat_map(|p| [p.x.abs(), p.y.abs()]).fold(0.0, f64::max);
    for shortest in [0.0, 2_f64.powi(-50), 2_f64.powi(-46), 2_f64.powi(-42), 2_f64.powi(-38)] {
        let mut drawing = cells::draw(triangulation, bounds, shortest * largest);
        let points = core::mem::take(&mut drawing.points);
        let Some(map) = connected(points, &drawing.segments)? else { continue };
        if let Some(cells) = cells_of(&map, &drawing, numbers, triangulation.num_vertices()) {
            return Ok(Some(Voronoi { map, cells, bounds, merged: Vec::new() }));
        }
    }
    Ok(None)
}

/// Returns the cell of each site, if every distinct site has its own cell.
fn cells_of(map: &PlanarMap, drawing: &cells::Drawing, numbers: &[u32], different: usize) -> Option<Vec<FaceKey>> {
    let dcel = map.dcel();
    if dcel.face_count() != different + 1 {
        return None;
    }
    let mut cells = vec![None; different];
    for (segment, of) in drawing.sites.iter().enumerate() {
        let h = half_edge(map, segment as u32)?;
        for (h, site) in [h, h.twin()].into_iter().zip(of) {
            if let Some(cell) = cells.get_mut(*site as usize) {
                let face = h.face().key();
                if *cell.get_or_insert(face) != face {
                    return None;
                }
            }
        }
    }
    if different == 1 {
        cells[0] = dcel.faces().find(|face| !face.is_unbounded()).map(|face| face.key());
    }
    numbers.iter().map(|number| cells[*number as usize]).collect()
}
