//! A map put together by an algorithm that knows it to be right.

use super::planar_map::PlanarMap;
use crate::dcel::Dcel;
use twinedge_geometry::Point;

impl PlanarMap {
    /// The map of a structure and the coordinates of its vertices, by index. The caller knows that they draw it.
    pub(crate) fn assembled(dcel: Dcel, points: Vec<Point>) -> Self {
        Self { dcel, points, ..Self::default() }
    }
}
