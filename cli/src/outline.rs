//! Faces as rings of coordinates.

use crate::status::Failure;
use twinedge::dcel::FaceKey;
use twinedge::map::PlanarMap;

/// The outer boundary of a face, closed: the last position repeats the first.
pub(crate) fn ring(map: &PlanarMap, face: FaceKey) -> Result<Vec<[f64; 2]>, Failure> {
    let mut ring = Vec::new();
    for h in map.dcel().face(face)?.outer().into_iter().flat_map(|boundary| boundary.half_edges()) {
        ring.push(map.position(h.origin().key())?.into());
    }
    ring.extend(ring.first().copied());
    Ok(ring)
}
