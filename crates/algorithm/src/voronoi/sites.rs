//! The sites, and their triangulation.

use super::error::VoronoiError;
use rustc_hash::FxHashMap;
use spade::handles::UndirectedEdgeHandle;
use spade::{DelaunayTriangulation, HasPosition, Point2, Triangulation as _, validate_vertex};
use twinedge_geometry::Point;

/// A point with one or more sites.
#[derive(Clone, Copy, Debug)]
pub(super) struct Site {
    place: Point2<f64>,
    /// The rank among first sites at their points.
    first: u32,
}

impl Site {
    pub(super) const fn point(&self) -> Point {
        Point::new(self.place.x, self.place.y)
    }
}

impl HasPosition for Site {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.place
    }
}

pub(super) type Triangulation = DelaunayTriangulation<Site>;

pub(super) struct Sites {
    pub(super) triangulation: Triangulation,
    pub(super) numbers: Vec<u32>,
}

impl Sites {
    pub(super) fn new(sites: &[Point]) -> Result<Self, VoronoiError> {
        let mut places: FxHashMap<[u64; 2], u32> = FxHashMap::default();
        places.reserve(sites.len());
        let mut different = Vec::with_capacity(sites.len());
        let mut numbers = Vec::with_capacity(sites.len());
        for (site, Point { x, y }) in sites.iter().enumerate() {
            // Adding zero turns −0 into 0.
            let (x, y) = (x + 0.0, y + 0.0);
            if !x.is_finite() || !y.is_finite() {
                return Err(VoronoiError::NotFinite { site, x, y });
            }
            let place = Point2::new(x, y);
            validate_vertex(&place).map_err(|_| VoronoiError::OutOfRange { site, x, y })?;
            let first = different.len() as u32;
            let number = *places.entry([x, y].map(f64::to_bits)).or_insert(first);
            if number == first {
                different.push(Site { place, first });
            }
            numbers.push(number);
        }
        let count = different.len();
        let triangulation = Triangulation::bulk_load(different).map_err(|_| VoronoiError::OutOfRange {
            site: 0,
            x: f64::NAN,
            y: f64::NAN,
        })?;
        // Vertices may be numbered in another order.
        let mut vertices = vec![u32::MAX; count];
        for v in triangulation.vertices() {
            vertices[v.data().first as usize] = v.index() as u32;
        }
        for number in &mut numbers {
            *number = vertices[*number as usize];
        }
        Ok(Self { triangulation, numbers })
    }
}

impl Sites {
    /// Returns the first site at each point, by its vertex number.
    pub(super) fn first(&self) -> Vec<usize> {
        let mut first = vec![0; self.triangulation.num_vertices()];
        for (site, number) in self.numbers.iter().enumerate().rev() {
            first[*number as usize] = site;
        }
        first
    }

    /// Returns each pair of neighbours, by the first site at each point, with their distance.
    pub(super) fn pairs(&self) -> impl Iterator<Item = ([usize; 2], f64)> + '_ {
        let first = self.first();
        let pair = move |e: UndirectedEdgeHandle<'_, Site, (), (), ()>| {
            let mut sites = e.vertices().map(|v| first[v.index()]);
            sites.sort_unstable();
            (sites, e.length_2().sqrt())
        };
        self.triangulation.undirected_edges().map(pair)
    }

    pub(super) fn too_close(&self) -> VoronoiError {
        let closest = self.pairs().min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        VoronoiError::TooClose { sites: closest.map_or([0; 2], |(sites, _)| sites) }
    }
}
