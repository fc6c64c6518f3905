//! The features that cover each face.
//!
//! A polygon lies on one side of each arc that its rings contain an odd number of times, so the polygons that begin and end from one face to the next
//! are known exactly. The remaining question is which side of its arcs is the inside, because both sides are bounded on a sphere.

use crate::drawing::{Drawing, toggle};
use crate::measure::{RADIUS, WHOLE, areas, signed_area};
use crate::place::Place;
use crate::subdivision::Subdivision;

/// The side of its rings on which a polygon lies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Inside {
    /// The smaller side, for any orientation of the rings, so no polygon is larger than half the sphere. `ST_GEOGFROMGEOJSON` and `ST_GEOGFROMTEXT`
    /// of `BigQuery` take rings like this unless told that they are oriented.
    #[default]
    Smaller,
    /// The left of the outer ring, which is counter-clockwise (RFC 7946), for any size, as in S2 and in `BigQuery` with `oriented => TRUE`.
    Left,
}

/// The features that cover each face of a map.
#[derive(Clone, Debug)]
pub struct Cover<'a> {
    pub(crate) map: &'a Subdivision,
    /// The areas on the unit sphere.
    pub(crate) areas: Vec<f64>,
    /// The features of each face, in order.
    pub(crate) features: Vec<Vec<u32>>,
}

impl<'a> Cover<'a> {
    /// Computes the features that cover each face of the map made from a drawing. O(n + c) for n half-edges and faces, each counted once for each
    /// polygon that covers it, and c points of rings.
    #[must_use]
    pub fn new(map: &'a Subdivision, drawing: &Drawing, inside: Inside) -> Self {
        let areas = areas(map);
        let mut sides = sides(map);
        let mut covered = vec![0.0; drawing.polygons().len()];
        for (side, area) in sides.iter().zip(&areas) {
            for polygon in side {
                covered[*polygon as usize] += area;
            }
        }
        let is_other = |(polygon, covered): (u32, &f64)| {
            let other = WHOLE - covered;
            let expected = match inside {
                Inside::Smaller => 0.0,
                Inside::Left => expected_area(drawing, polygon),
            };
            (other - expected).abs() < (covered - expected).abs()
        };
        let others: Vec<u32> = (0..).zip(&covered).filter(|one| is_other(*one)).map(|(polygon, _)| polygon).collect();
        for side in &mut sides {
            for polygon in &others {
                toggle(side, *polygon);
            }
        }
        let features = |side: Vec<u32>| {
            let mut features: Vec<u32> =
                side.into_iter().map(|polygon| drawing.polygons()[polygon as usize].feature).collect();
            // Features come in order, and so do their polygons.
            features.dedup();
            features
        };
        Self { map, areas, features: sides.into_iter().map(features).collect() }
    }

    /// Returns the features that cover a place, in order; on an arc, the features of one of its two faces. O(s) for s arcs within a narrow stripe of
    /// longitudes.
    #[must_use]
    pub fn features_at(&self, place: Place) -> &[u32] {
        &self.features[self.map.locate(place) as usize]
    }

    /// Returns the area covered by a feature, in square metres. O(faces).
    #[must_use]
    pub fn area_of(&self, feature: u32) -> f64 {
        let of = |(area, features): (&f64, &Vec<u32>)| features.binary_search(&feature).map_or(0.0, |_| *area);
        RADIUS * RADIUS * self.areas.iter().zip(&self.features).map(of).sum::<f64>()
    }
}

/// Returns, for each face, the polygons that lie on the other side of their rings than the first face does.
fn sides(map: &Subdivision) -> Vec<Vec<u32>> {
    let mut darts = vec![Vec::new(); map.face_count()];
    for dart in 0..map.dart_count() as u32 {
        darts[map.face(dart) as usize].push(dart);
    }
    let mut sides: Vec<Option<Vec<u32>>> = vec![None; map.face_count()];
    let mut reached = vec![0];
    sides[0] = Some(Vec::new());
    while let Some(face) = reached.pop() {
        for dart in &darts[face] {
            let beyond = map.face(dart ^ 1) as usize;
            if sides[beyond].is_none() {
                let mut side = sides[face].clone().unwrap_or_default();
                for polygon in map.polygons(*dart) {
                    toggle(&mut side, *polygon);
                }
                sides[beyond] = Some(side);
                reached.push(beyond);
            }
        }
    }
    sides.into_iter().map(Option::unwrap_or_default).collect()
}

/// The area of a polygon whose outer ring has the inside to its left, without its holes.
fn expected_area(drawing: &Drawing, polygon: u32) -> f64 {
    let area = |ring: &Vec<u32>| {
        let places: Vec<Place> = ring.iter().map(|place| drawing.places()[*place as usize]).collect();
        signed_area(&places).rem_euclid(WHOLE)
    };
    let mut rings = drawing.polygons()[polygon as usize].rings.iter().map(area);
    let outer = rings.next().unwrap_or_default();
    outer - rings.map(|hole| hole.min(WHOLE - hole)).sum::<f64>()
}
