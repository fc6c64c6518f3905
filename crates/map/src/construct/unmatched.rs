//! Vertices of polygons that lie on a border without a vertex there, of another feature or of another ring of the same feature.

use super::builder::Builder;
use super::gathered::origin;
use crate::FeatureId;
use rustc_hash::FxHashMap;
use twinedge_geometry::Point;
use twinedge_geometry::bounds::Bounds;
use twinedge_geometry::boxes::Boxes;
use twinedge_geometry::predicates::{compare_lexicographic, on_segment};

/// A vertex of a feature's polygon inside a segment of another feature's polygon, or of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct UnmatchedVertex {
    /// The coordinates.
    pub at: Point,
    /// The feature that has the vertex.
    pub of: FeatureId,
    /// The feature that lacks it.
    pub lacked_by: FeatureId,
    /// The segment of that feature that contains the vertex, the end with the smaller coordinates first.
    pub segment: [Point; 2],
}

impl Builder {
    /// Returns the vertices of polygons that lie exactly on the border of a feature, between two of its vertices. Such borders
    /// coincide or touch but are noded differently. Sorted by the two features, then by coordinates. If the feature that has the
    /// vertex also uses the segment, it lacks its own vertex, and other users of the segment are not reported again.
    ///
    /// O(n log n + k) for n segments and k pairs of a vertex and a bounding box around it, but not in the worst case.
    ///
    /// ```
    /// use twinedge_geometry::Point;
    /// use twinedge_map::{Builder, Shape};
    ///
    /// let mut builder = Builder::new();
    /// let west = builder.shape(&Shape::polygon([[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0]]))?;
    /// let east = builder.shape(&Shape::polygon([[2.0, 0.0], [4.0, 0.0], [2.0, 2.0]]))?;
    /// let [found] = builder.unmatched()[..] else { unreachable!("the others are matched") };
    /// assert_eq!((found.at, found.of, found.lacked_by), (Point::new(2.0, 1.0), west, east));
    /// # Ok::<(), twinedge_map::BuildError>(())
    /// ```
    #[must_use]
    pub fn unmatched(&self) -> Vec<UnmatchedVertex> {
        let touches = self.touches();
        if touches.is_empty() {
            return Vec::new();
        }
        let mut having: FxHashMap<u32, Vec<FeatureId>> = touches.iter().map(|(p, _)| (*p, Vec::new())).collect();
        let mut along: FxHashMap<u32, Vec<FeatureId>> = touches.iter().map(|(_, s)| (*s, Vec::new())).collect();
        for (number, polygon) in self.features.polygons() {
            for dart in polygon {
                let at_vertex = having.get_mut(&origin(&self.segments, *dart));
                for features in at_vertex.into_iter().chain(along.get_mut(&(*dart >> 1))) {
                    if features.last() != Some(&FeatureId::new(number)) {
                        features.push(FeatureId::new(number));
                    }
                }
            }
        }
        let mut found = Vec::new();
        for (point, segment) in touches {
            let along = &along[&segment];
            for of in &having[&point] {
                let lacking = match along.binary_search(of) {
                    Ok(own) => &along[own..=own],
                    Err(_) => along,
                };
                found.extend(lacking.iter().map(|lacked_by| UnmatchedVertex {
                    at: self.points[point as usize],
                    of: *of,
                    lacked_by: *lacked_by,
                    segment: self.ends(segment),
                }));
            }
        }
        found.sort_by(|a, b| {
            let by_place = || compare_lexicographic(a.at, b.at).then(compare_lexicographic(a.segment[0], b.segment[0]));
            (a.of, a.lacked_by).cmp(&(b.of, b.lacked_by)).then_with(by_place)
        });
        found
    }

    /// Returns the ends of polygons' segments that lie inside another such segment, by their numbers.
    fn touches(&self) -> Vec<(u32, u32)> {
        let mut of_polygons = vec![false; self.segments.len()];
        for dart in self.features.polygons().flat_map(|(_, polygon)| polygon) {
            of_polygons[*dart as usize >> 1] = true;
        }
        let segments = (0..self.segments.len() as u32).filter(|segment| of_polygons[*segment as usize]);
        let bounds = |segment: u32| {
            let [a, b] = self.segments[segment as usize].map(|end| Bounds::one(self.points[end as usize]));
            a.joined(b)
        };
        let each = |found: &mut Vec<(u32, u32)>, segment: u32, others: &[u32]| {
            let [a, b] = self.ends(segment);
            let is_inside = |point: &u32| {
                let p = self.points[*point as usize];
                let is_end = self.segments[segment as usize].contains(point);
                !is_end && on_segment(p, a, b)
            };
            let ends = others.iter().flat_map(|other| self.segments[*other as usize]);
            let mut inside: Vec<u32> = ends.filter(is_inside).collect();
            inside.sort_unstable();
            inside.dedup();
            found.extend(inside.into_iter().map(|point| (point, segment)));
        };
        let merge = |mut one: Vec<_>, mut other: Vec<_>| {
            one.append(&mut other);
            one
        };
        let mut found = Boxes::new(segments, &bounds).pairs(0.0, &Vec::new, &each, &merge);
        found.sort_unstable();
        found
    }

    /// Returns the ends of a segment, the end with the smaller coordinates first.
    fn ends(&self, segment: u32) -> [Point; 2] {
        let mut ends = self.segments[segment as usize].map(|point| self.points[point as usize]);
        ends.sort_by(|a, b| compare_lexicographic(*a, *b));
        ends
    }
}
