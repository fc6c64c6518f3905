//! The parts that GeoJSON and TopoJSON share.

use super::crs::Crs;
use super::model::{Dimensions, Geometry, Members, Position, Shape};

/// A geometry whose positions say themselves how many numbers they have. A third number is a height; where positions differ in
/// how many they have, there is no such name for them.
pub(super) fn geometry(shape: Shape, members: Members) -> Geometry {
    let mut count: Option<usize> = None;
    let mut is_uniform = true;
    shape.visit(&mut |position| is_uniform &= *count.get_or_insert(position.more.len()) == position.more.len());
    let height = is_uniform && count == Some(1);
    Geometry { dimensions: Dimensions::with(height, false), shape, members }
}

/// True if all coordinates so far can be longitudes and latitudes.
#[derive(Debug, Default)]
pub(super) struct InDegrees(Option<bool>);

impl InDegrees {
    pub(super) fn look_at(&mut self, geometry: &Geometry) {
        let in_range = |p: &Position| p.x.abs() <= 180.0 && p.y.abs() <= 90.0;
        geometry.shape.visit(&mut |p| self.0 = Some(self.0 != Some(false) && in_range(p)));
    }

    /// The reference system of a file that names none: WGS 84, if there are coordinates and they can be in it.
    pub(super) fn crs(&self) -> Option<Crs> {
        (self.0 == Some(true)).then(|| Crs::epsg(4326))
    }
}
