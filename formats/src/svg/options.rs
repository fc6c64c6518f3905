//! Options of pictures.

use twinedge::validate::Violation;
use twinedge_geometry::Point;

/// The contents of a picture, and its size.
#[derive(Clone, Copy, Debug)]
pub struct Options<'a> {
    /// The longer side of the picture in pixels; at least 100, at most 100,000.
    pub size: f64,
    /// True to draw half-edges with their names and links, and the names of vertices and faces. It takes some 50 pixels to an
    /// edge to be legible.
    pub detail: bool,
    /// Two opposite corners of the part to draw; none for everything, and so is a window without area.
    pub window: Option<[Point; 2]>,
    /// True to draw parts that lie far from all others in insets, where everything would be small else. With a window, and in
    /// detail, there are none.
    pub insets: bool,
    /// The violations to mark, and to list below the map.
    pub violations: &'a [Violation],
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self { size: 1000.0, detail: false, window: None, insets: true, violations: &[] }
    }
}
