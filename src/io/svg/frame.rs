//! From coordinates to pixels.

use super::options::Options;
use super::text::put;
use crate::dcel::Face;
use crate::geometry::Point;
use crate::map::PlanarMap;
use crate::validate::Embedding;

/// Where in the picture points are.
pub(super) struct Frame {
    low: Point,
    high: Point,
    scale: f64,
    margin: f64,
    whole: bool,
}

impl Frame {
    pub(super) fn new(map: &PlanarMap, options: &Options<'_>) -> Self {
        let margin = if options.detail { 40.0 } else { 12.0 };
        let all = Bounds::around(map.dcel().vertices().map(|v| map.point(v.index())));
        let window = options.window.and_then(Bounds::of_window);
        let Bounds { low, high } =
            *window.as_ref().unwrap_or(if all.low.x <= all.high.x { &all } else { &Bounds::UNIT });
        let size = if options.size.is_nan() { 1000.0 } else { options.size.clamp(100.0, 1e5) };
        let span = (high.x - low.x).max(high.y - low.y);
        let scale = if span > 0.0 { (size - 2.0 * margin) / span } else { 1.0 };
        Self { low, high, scale, margin, whole: window.is_none() }
    }

    /// Whether it shows everything.
    pub(super) const fn is_whole(&self) -> bool {
        self.whole
    }

    /// The width and height of the picture.
    pub(super) fn size(&self) -> [f64; 2] {
        [self.high.x - self.low.x, self.high.y - self.low.y].map(|side| (side * self.scale + 2.0 * self.margin).ceil())
    }

    pub(super) fn at(&self, p: Point) -> [f64; 2] {
        let [x, y] = [p.x - self.low.x, self.high.y - p.y].map(|c| c * self.scale + self.margin);
        [x, y]
    }

    /// Whether the box around these points meets the picture.
    pub(super) fn shows(&self, points: impl IntoIterator<Item = Point>) -> bool {
        Bounds::around(points).meets(&Bounds { low: self.low, high: self.high })
    }
}

/// No window is smaller: coordinates of the smallest magnitude that differ in the last bit only are further apart.
const SMALLEST_WINDOW: f64 = 1e-140;

struct Bounds {
    low: Point,
    high: Point,
}

impl Bounds {
    const EMPTY: Self =
        Self { low: Point::new(f64::INFINITY, f64::INFINITY), high: Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY) };
    const UNIT: Self = Self { low: Point::new(0.0, 0.0), high: Point::new(1.0, 1.0) };

    /// None for one without area, or that is not finite, or so small that coordinates in pixels could overflow.
    fn of_window(corners: [Point; 2]) -> Option<Self> {
        let window = Self::around(corners);
        let sides = [window.high.x - window.low.x, window.high.y - window.low.y];
        let finite = corners.iter().all(|p| p.x.is_finite() && p.y.is_finite());
        (finite && sides.iter().all(|side| side.is_finite() && *side >= SMALLEST_WINDOW)).then_some(window)
    }

    fn around(points: impl IntoIterator<Item = Point>) -> Self {
        points.into_iter().fold(Self::EMPTY, |Self { low, high }, p| Self {
            low: Point::new(low.x.min(p.x), low.y.min(p.y)),
            high: Point::new(high.x.max(p.x), high.y.max(p.y)),
        })
    }

    fn meets(&self, other: &Self) -> bool {
        self.low.x <= other.high.x
            && other.low.x <= self.high.x
            && self.low.y <= other.high.y
            && other.low.y <= self.high.y
    }
}

/// How many half-edges a picture of this window shows, in whole or in part, judging by the boxes around them; all of them
/// without a window. O(half-edges).
///
/// ```
/// use twinedge::io::svg::half_edges_in;
/// use twinedge::map::PlanarMap;
///
/// let mut map = PlanarMap::new();
/// map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?;
/// let corner = [[3.0, 3.0], [5.0, 5.0]].map(Into::into);
/// assert_eq!((half_edges_in(&map, Some(corner)), half_edges_in(&map, None)), (4, 8));
/// # Ok::<(), twinedge::map::edit::EditError>(())
/// ```
#[must_use]
pub fn half_edges_in(map: &PlanarMap, window: Option<[Point; 2]>) -> usize {
    let Some(window) = window.and_then(Bounds::of_window) else { return map.dcel().half_edge_count() };
    let seen = |h: &crate::dcel::HalfEdge<'_>| {
        Bounds::around([h.origin(), h.target()].map(|v| map.point(v.index()))).meets(&window)
    };
    map.dcel().half_edges().filter(seen).count()
}

/// All half-edges of a face as pairs of points in the picture.
pub(super) fn sides<'a>(
    map: &'a PlanarMap,
    frame: &'a Frame,
    face: Face<'a>,
) -> impl Iterator<Item = [[f64; 2]; 2]> + 'a {
    face.half_edges().map(|h| [h.origin(), h.target()].map(|v| frame.at(map.point(v.index()))))
}

/// Adds a line through these points to a path, without those that fall on the one before.
pub(super) fn path(out: &mut String, points: impl Iterator<Item = [f64; 2]>, closed: bool) {
    let mut last = None;
    for [x, y] in points {
        let rounded = [x, y].map(|c| (c * 100.0).round() / 100.0);
        let command = if last.is_none() { 'M' } else { 'L' };
        if last.replace(rounded) != Some(rounded) {
            put(out, format_args!("{command}{} {}", rounded[0], rounded[1]));
        }
    }
    if closed {
        out.push('Z');
    }
}
