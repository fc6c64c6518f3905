//! Options of pictures.

use twinedge::validate::Violation;
use twinedge_geometry::Point;

/// The contents of a picture, and its size.
#[derive(Clone, Copy, Debug)]
pub struct Options<'a> {
    /// The longer side of the picture in pixels; at least 100, at most 100,000.
    pub size: f64,
    /// True to draw half-edges with their names and links, and the names of vertices and faces. Legible from 50 pixels per edge.
    pub detail: bool,
    /// Two opposite corners of the part to draw. Without a window, or for one without area, everything is drawn.
    pub window: Option<[Point; 2]>,
    /// True to draw distant parts in insets, if everything would be small otherwise. A picture of a window, or in detail, has
    /// none.
    pub insets: bool,
    /// The violations to mark, and to list below the map.
    pub violations: &'a [Violation],
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self { size: 1000.0, detail: false, window: None, insets: true, violations: &[] }
    }
}
