//! Features whose edges are arcs between places.

use crate::place::{Place, PlaceError};
use rustc_hash::FxHashMap;
use std::collections::hash_map::Entry;
use thiserror::Error;
use twinedge_geometry::Point;
use twinedge_map::{Feature, Shape};

/// The features of a map with arcs of great circles as edges. Features share places and arcs.
///
/// Coordinates are longitudes and latitudes in degrees. Open rings are closed. Points alone are left out.
///
/// ```
/// use twinedge_map::{Feature, Shape};
/// use twinedge_sphere::Drawing;
///
/// // Fiji's halves on both sides of the antimeridian have an arc in common.
/// let half = |x: f64| Shape::polygon([[180.0, -17.0], [180.0, -16.0], [x, -16.0], [x, -17.0]]);
/// let fiji = Feature { shapes: vec![half(178.0), half(-179.0)], ..Feature::default() };
/// let antipodes = Feature { shapes: vec![Shape::line([[0.0, 10.0], [180.0, -10.0]])], ..Feature::default() };
/// let drawing = Drawing::new(&[fiji, antipodes])?;
/// assert_eq!(drawing.arcs().len(), 7);
/// assert_eq!(drawing.undrawn().len(), 1);
/// # Ok::<(), twinedge_sphere::DrawingError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    places: Vec<Place>,
    /// The first coordinates given for each place.
    degrees: Vec<Point>,
    arcs: Vec<Arc>,
    polygons: Vec<Polygon>,
    undrawn: Vec<Undrawn>,
    repeated_points: usize,
    repeated_arcs: usize,
}

/// An arc, and its features.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arc {
    /// The ends of the arc.
    pub ends: [u32; 2],
    /// The features with this arc, in order.
    pub features: Vec<u32>,
    /// The polygons on only one side of the arc, in order: their rings contain the arc an odd number of times.
    pub(crate) polygons: Vec<u32>,
}

#[derive(Clone, Debug)]
pub(crate) struct Polygon {
    pub(crate) feature: u32,
    /// The places around each ring, the outer ring first.
    pub(crate) rings: Vec<Vec<u32>>,
}

/// An edge that is not an arc: its ends are antipodes, so there is no shortest path between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Undrawn {
    /// The feature with this edge.
    pub feature: u32,
    /// The ends of the edge, in degrees.
    pub ends: [Point; 2],
    /// True if the edge belongs to a polygon, which is not closed without it.
    pub of_polygon: bool,
}

/// The error of [`Drawing::new`].
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum DrawingError {
    /// A point is not on the sphere.
    #[error("feature {feature}: {why}")]
    NoPlace {
        /// The feature, counted from 0.
        feature: usize,
        /// The reason.
        why: PlaceError,
    },
    /// There are more than 2^30 points.
    #[error("there are more points than fit")]
    TooMany,
}

/// Half-edge numbers have 32 bits, which more points may exceed.
const MOST: usize = 1 << 30;

impl Drawing {
    /// Creates the drawing of these features. O(n) for n points, expected.
    ///
    /// # Errors
    /// [`DrawingError`].
    pub fn new(features: &[Feature]) -> Result<Self, DrawingError> {
        let mut making = Making::default();
        for (feature, of) in features.iter().enumerate() {
            for shape in &of.shapes {
                making.shape(feature, shape)?;
            }
        }
        Ok(making.drawing)
    }

    /// Returns the places.
    #[must_use]
    pub fn places(&self) -> &[Place] {
        &self.places
    }

    /// Returns the first coordinates given for a place, in degrees.
    ///
    /// # Panics
    /// Panics if there is no such place.
    #[must_use]
    pub fn degrees(&self, place: u32) -> Point {
        self.degrees[place as usize]
    }

    /// Returns the arcs.
    #[must_use]
    pub fn arcs(&self) -> &[Arc] {
        &self.arcs
    }

    /// Returns the edges that are not arcs.
    #[must_use]
    pub fn undrawn(&self) -> &[Undrawn] {
        &self.undrawn
    }

    /// Returns the number of points at the same place as their predecessor.
    #[must_use]
    pub const fn repeated_points(&self) -> usize {
        self.repeated_points
    }

    /// Returns the number of edges whose arc was already there.
    #[must_use]
    pub const fn repeated_arcs(&self) -> usize {
        self.repeated_arcs
    }

    pub(crate) fn polygons(&self) -> &[Polygon] {
        &self.polygons
    }
}

#[derive(Default)]
struct Making {
    drawing: Drawing,
    places: FxHashMap<[u64; 3], u32>,
    arcs: FxHashMap<[u32; 2], u32>,
}

impl Making {
    fn shape(&mut self, feature: usize, shape: &Shape) -> Result<(), DrawingError> {
        match shape {
            Shape::Polygon(rings) => {
                let number = self.drawing.polygons.len() as u32;
                let mut polygon = Polygon { feature: feature as u32, rings: Vec::new() };
                for ring in rings {
                    let mut places = self.chain(feature, ring)?;
                    if let (Some(first), Some(last)) = (places.first(), places.last())
                        && first != last
                    {
                        places.push(*first);
                    }
                    self.arcs(feature, &places, Some(number));
                    places.pop();
                    polygon.rings.push(places);
                }
                self.drawing.polygons.push(polygon);
            }
            Shape::Line(points) => {
                let places = self.chain(feature, points)?;
                self.arcs(feature, &places, None);
            }
            Shape::Point(_) => {}
        }
        Ok(())
    }

    /// Returns the places along a chain, without consecutive duplicates.
    fn chain(&mut self, feature: usize, points: &[Point]) -> Result<Vec<u32>, DrawingError> {
        let mut chain = Vec::with_capacity(points.len());
        for point in points {
            let place = self.place(*point).map_err(|why| DrawingError::NoPlace { feature, why })?;
            if chain.last() == Some(&place) {
                self.drawing.repeated_points += 1;
            } else {
                chain.push(place);
            }
        }
        if self.drawing.places.len().max(self.drawing.arcs.len()) + points.len() > MOST {
            return Err(DrawingError::TooMany);
        }
        Ok(chain)
    }

    fn place(&mut self, point: Point) -> Result<u32, PlaceError> {
        let place = Place::new(point.x, point.y)?;
        let next = self.drawing.places.len() as u32;
        Ok(match self.places.entry(place.key()) {
            Entry::Occupied(known) => *known.get(),
            Entry::Vacant(new) => {
                self.drawing.places.push(place);
                self.drawing.degrees.push(point);
                *new.insert(next)
            }
        })
    }

    fn arcs(&mut self, feature: usize, chain: &[u32], polygon: Option<u32>) {
        let feature = feature as u32;
        for pair in chain.windows(2) {
            let ends = [pair[0], pair[1]];
            let drawing = &mut self.drawing;
            let [a, b] = ends.map(|end| drawing.places[end as usize]);
            if a.antipode() == b {
                let ends = ends.map(|end| drawing.degrees[end as usize]);
                drawing.undrawn.push(Undrawn { feature, ends, of_polygon: polygon.is_some() });
                continue;
            }
            let next = drawing.arcs.len() as u32;
            let number = *self.arcs.entry(sorted(ends)).or_insert(next);
            if number == next {
                drawing.arcs.push(Arc { ends, ..Arc::default() });
            } else {
                drawing.repeated_arcs += 1;
            }
            let arc = &mut drawing.arcs[number as usize];
            if arc.features.last() != Some(&feature) {
                arc.features.push(feature);
            }
            if let Some(polygon) = polygon {
                toggle(&mut arc.polygons, polygon);
            }
        }
    }
}

pub(crate) fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// Adds a number to a sorted set, or removes it if present.
pub(crate) fn toggle(set: &mut Vec<u32>, number: u32) {
    match set.binary_search(&number) {
        Ok(place) => {
            set.remove(place);
        }
        Err(place) => set.insert(place, number),
    }
}
