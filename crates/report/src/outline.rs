//! Faces as rings of coordinates.

use twinedge::dcel::{FaceKey, StaleKey};
use twinedge_map::PlanarMap;

/// Returns the outer boundary of a face, closed: the last position repeats the first. O(its length).
///
/// # Errors
/// [`StaleKey`], if there is no such face.
pub fn ring(map: &PlanarMap, face: FaceKey) -> Result<Vec<[f64; 2]>, StaleKey> {
    let mut ring = Vec::new();
    for h in map.dcel().face(face)?.outer().into_iter().flat_map(|boundary| boundary.half_edges()) {
        ring.push(map.position(h.origin().key())?.into());
    }
    ring.extend(ring.first().copied());
    Ok(ring)
}
