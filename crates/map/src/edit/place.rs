//! Resolving the point argument of an edit to coordinates and a location on the map.

use super::at::At;
use super::error::EditError;
use crate::index::is_small;
use crate::locate::Located;
use crate::locate::in_face::locate_in_face;
use crate::not_plane::NotPlane;
use crate::planar_map::PlanarMap;
use twinedge::dcel::{FaceKey, HalfEdge, Vertex};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::in_range;

impl PlanarMap {
    pub(super) fn editable(&self) -> Result<(), EditError> {
        Ok(self.plane()?)
    }

    /// Returns the coordinates, in range and without −0.
    pub(super) fn point_of(&self, at: At) -> Result<Point, EditError> {
        let Point { x, y } = match at {
            At::Point(p) | At::Near(p, _) => p,
            At::Vertex(v) => self.position(v)?,
        };
        if !x.is_finite() || !y.is_finite() {
            Err(EditError::NotFinite { x, y })
        } else if !in_range(Point { x, y }) {
            Err(EditError::OutOfRange { x, y })
        } else {
            Ok(Point { x: x + 0.0, y: y + 0.0 })
        }
    }

    /// Returns the location of the point. [`At`] states the cost.
    pub(super) fn place_of(&self, at: At) -> Result<Located, EditError> {
        match at {
            At::Point(_) => self.place(self.point_of(at)?, None),
            At::Near(_, hint) => {
                // A stale hint is reported first.
                let face = self.dcel.half_edge(hint)?.face().key();
                self.place(self.point_of(at)?, Some(face))
            }
            At::Vertex(v) => Ok(Located::Vertex(self.dcel.vertex(v)?.key())),
        }
    }

    pub(super) fn at(&self, vertex: Vertex<'_>) -> Point {
        self.points[vertex.index()]
    }

    /// Returns the coordinates of the origin and the target of a half-edge of this map.
    pub(super) fn ends(&self, h: HalfEdge<'_>) -> [Point; 2] {
        [self.at(h.origin()), self.at(h.target())]
    }

    /// Returns the location of a point. Scans a likely face first if it is small; otherwise uses the index.
    pub(super) fn place(&self, p: Point, likely: Option<FaceKey>) -> Result<Located, EditError> {
        if let Some(face) = likely {
            let face = self.dcel.face(face)?;
            if let Some(located) = is_small(face).then(|| locate_in_face(self, face, p)).flatten() {
                return Ok(located);
            }
        }
        self.locate(p).map_err(|_| NotPlane::default().into())
    }
}
