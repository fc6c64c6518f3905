//! From coordinates to pixels.

use super::text::put;
use twinedge::dcel::Face;
use twinedge_geometry::Point;
use twinedge_map::{Embedding, PlanarMap};

/// The mapping from points to places in a panel of the picture.
pub(super) struct Frame {
    bounds: Bounds,
    pub(super) scale: f64,
    pub(super) size: [f64; 2],
    whole: bool,
}

impl Frame {
    /// Returns a panel for these bounds, with margins, whose longer side has this length. `whole`: it shows the whole map.
    pub(super) fn new(bounds: Bounds, longer: f64, margin: f64, whole: bool) -> Self {
        let span = bounds.longer();
        let scale = if span > 0.0 { (longer - 2.0 * margin) / span } else { 1.0 };
        let size = bounds.sides().map(|side| (side * scale + 2.0 * margin).ceil());
        Self { bounds, scale, size, whole }
    }

    /// Returns a panel of this size, with the bounds in its middle.
    pub(super) fn within(bounds: Bounds, size: [f64; 2], margin: f64) -> Self {
        let sides = bounds.sides();
        let fits = [0, 1].map(|i| if sides[i] > 0.0 { (size[i] - 2.0 * margin) / sides[i] } else { f64::INFINITY });
        let scale = if fits[0].min(fits[1]).is_finite() { fits[0].min(fits[1]) } else { 1.0 };
        Self { bounds, scale, size, whole: false }
    }

    pub(super) const fn is_whole(&self) -> bool {
        self.whole
    }

    pub(super) fn at(&self, p: Point) -> [f64; 2] {
        let Bounds { low, high } = self.bounds;
        let sides = self.bounds.sides();
        let from = [p.x - low.x, high.y - p.y];
        [0, 1].map(|i| from[i] * self.scale + (self.size[i] - sides[i] * self.scale) / 2.0)
    }

    pub(super) fn shows(&self, points: impl IntoIterator<Item = Point>) -> bool {
        Bounds::around(points).meets(&self.bounds)
    }

    pub(super) fn holds(&self, at: [f64; 2]) -> bool {
        [0, 1].iter().all(|i| (0.0..=self.size[*i]).contains(&at[*i]))
    }
}

/// The smallest size of a window: even the smallest coordinates that differ only in the last bit are further apart.
const SMALLEST_WINDOW: f64 = 1e-140;

#[derive(Clone, Copy)]
pub(super) struct Bounds {
    pub(super) low: Point,
    pub(super) high: Point,
}

impl Bounds {
    pub(super) const EMPTY: Self =
        Self { low: Point::new(f64::INFINITY, f64::INFINITY), high: Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY) };
    pub(super) const UNIT: Self = Self { low: Point::new(0.0, 0.0), high: Point::new(1.0, 1.0) };

    /// None for a window that has no area, is not finite, or is so small that coordinates in pixels could overflow.
    pub(super) fn of_window(corners: [Point; 2]) -> Option<Self> {
        let window = Self::around(corners);
        let finite = corners.iter().all(|p| p.x.is_finite() && p.y.is_finite());
        let has_area = window.sides().iter().all(|side| side.is_finite() && *side >= SMALLEST_WINDOW);
        (finite && has_area).then_some(window)
    }

    pub(super) fn around(points: impl IntoIterator<Item = Point>) -> Self {
        points.into_iter().fold(Self::EMPTY, |bounds, p| bounds.with(Self { low: p, high: p }))
    }

    pub(super) fn with(self, Self { low, high }: Self) -> Self {
        Self {
            low: Point::new(self.low.x.min(low.x), self.low.y.min(low.y)),
            high: Point::new(self.high.x.max(high.x), self.high.y.max(high.y)),
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.low.x > self.high.x
    }

    pub(super) fn sides(&self) -> [f64; 2] {
        [self.high.x - self.low.x, self.high.y - self.low.y]
    }

    pub(super) fn longer(&self) -> f64 {
        let [x, y] = self.sides();
        x.max(y)
    }

    pub(super) fn meets(&self, other: &Self) -> bool {
        self.low.x <= other.high.x
            && other.low.x <= self.high.x
            && self.low.y <= other.high.y
            && other.low.y <= self.high.y
    }
}

/// Returns the number of half-edges that a picture of this window shows, in whole or in part, according to the boxes around them;
/// all of them without a window. O(half-edges).
///
/// ```
/// use twinedge_report::svg::half_edges_in;
/// use twinedge_map::PlanarMap;
///
/// let mut map = PlanarMap::new();
/// map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?;
/// let corner = [[3.0, 3.0], [5.0, 5.0]].map(Into::into);
/// assert_eq!((half_edges_in(&map, Some(corner)), half_edges_in(&map, None)), (4, 8));
/// # Ok::<(), twinedge_map::edit::EditError>(())
/// ```
#[must_use]
pub fn half_edges_in(map: &PlanarMap, window: Option<[Point; 2]>) -> usize {
    let Some(window) = window.and_then(Bounds::of_window) else { return map.dcel().half_edge_count() };
    let seen = |h: &twinedge::dcel::HalfEdge<'_>| {
        Bounds::around([h.origin(), h.target()].map(|v| map.point(v.index()))).meets(&window)
    };
    map.dcel().half_edges().filter(seen).count()
}

/// Returns all half-edges of a face as pairs of points in the panel.
pub(super) fn sides<'a>(
    map: &'a PlanarMap,
    frame: &'a Frame,
    face: Face<'a>,
) -> impl Iterator<Item = [[f64; 2]; 2]> + 'a {
    face.half_edges().map(|h| [h.origin(), h.target()].map(|v| frame.at(map.point(v.index()))))
}

/// Adds a line through these points to a path, skipping points that coincide with the one before.
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
