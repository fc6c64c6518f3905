//! Centroids: the centre of mass of a face, or of all faces of a feature.
//!
//! The sums run over triangles that share the first point of each boundary component, as for [areas](super::area).

use super::area::Sum;
use super::claims::faces_of;
use twinedge::dcel::{Face, FaceKey, StaleKey};
use twinedge_geometry::Point;
use twinedge_map::{Embedding, FeatureId, PlanarMap};

/// Twice the area, and six times the moments, relative to a point.
#[derive(Default)]
struct Moments {
    area: Sum,
    x: Sum,
    y: Sum,
}

impl Moments {
    fn add(&mut self, map: &PlanarMap, face: Face<'_>, o: Point) {
        for boundary in face.boundaries() {
            for h in boundary.half_edges() {
                let [a, b] = [h.origin(), h.target()].map(|v| map.point(v.index()));
                let [ax, ay, bx, by] = [a.x - o.x, a.y - o.y, b.x - o.x, b.y - o.y];
                let twice = ax * by - bx * ay;
                self.area.add(twice);
                self.x.add((ax + bx) * twice);
                self.y.add((ay + by) * twice);
            }
        }
    }

    fn centroid(&self, o: Point) -> Option<Point> {
        let triple = 3.0 * self.area.value();
        let centre = Point::new(o.x + self.x.value() / triple, o.y + self.y.value() / triple);
        (centre.x.is_finite() && centre.y.is_finite()).then_some(centre)
    }
}

/// Returns the centroid of a face without its holes; `None` for the unbounded face, and if areas overflow or underflow. The
/// centroid may lie outside the face. O(its half-edges).
///
/// # Errors
/// [`StaleKey::Face`].
///
/// ```
/// use twinedge_algorithm::centroid::face_centroid;
/// use twinedge_geometry::Point;
/// use twinedge_map::PlanarMap;
///
/// let mut map = PlanarMap::new();
/// let triangle = map.insert_ring([[0.0, 0.0], [3.0, 0.0], [0.0, 6.0]])?.faces_split[0].1;
/// assert_eq!(face_centroid(&map, triangle)?, Some(Point::new(1.0, 2.0)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn face_centroid(map: &PlanarMap, face: FaceKey) -> Result<Option<Point>, StaleKey> {
    let face = map.dcel().face(face)?;
    Ok(of_faces(map, &[face]))
}

/// Returns the centroid of all faces that a feature covers, if any. O(faces of the map · log + half-edges of those covered).
#[must_use]
pub fn feature_centroid(map: &PlanarMap, feature: FeatureId) -> Option<Point> {
    let faces: Vec<Face<'_>> = faces_of(map, feature).into_iter().filter_map(|f| map.dcel().face(f).ok()).collect();
    of_faces(map, &faces)
}

/// Returns the joint centroid of some faces; `None` if they include the unbounded face.
pub(super) fn of_faces(map: &PlanarMap, faces: &[Face<'_>]) -> Option<Point> {
    let mut starts = faces.iter().map(|face| face.outer_half_edge());
    let origin = map.point(starts.next()??.origin().index());
    let mut moments = Moments::default();
    for face in faces {
        face.outer()?;
        moments.add(map, *face, origin);
    }
    moments.centroid(origin)
}
