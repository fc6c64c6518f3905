//! The layout of a picture: a panel for the main part of a map, and insets for the others.
//!
//! If distant islands would make everything else small, the part with the most vertices is large, and others in insets below.
//!
//! ```text
//!   ┌────────────────┐
//!   │ ▒▒▒▒▒▒▒▒▒▒▒▒▒▒ │
//!   │ ▒▒▒▒▒▒▒▒▒▒▒▒▒▒ │
//!   ├─────┬─────┬────┘
//!   │  ▒  │  ▒▒ │
//!   └─────┴─────┘
//! ```

use super::frame::{Bounds, Frame};
use super::options::Options;
use twinedge_geometry::Point;
use twinedge_map::{Embedding, PlanarMap};

/// The smallest width of an empty strip between two parts, as a fraction of the longer side of both together.
const STRIP: f64 = 0.1;
/// Insets are used if everything would be drawn smaller by this factor without them.
const GAIN: f64 = 1.5;
const INSETS: usize = 6;
const DEPTH: usize = 8;
/// The width of an inset, and its height as a fraction of the width.
const WIDTH: f64 = 200.0;
const HEIGHT: f64 = 0.75;
pub(super) const SPACE: f64 = 12.0;

pub(super) struct Layout {
    pub(super) main: Frame,
    pub(super) insets: Vec<Frame>,
    /// The number of distant parts without inset.
    pub(super) left_out: usize,
}

impl Layout {
    /// O(n log n) for n half-edges.
    pub(super) fn new(map: &PlanarMap, options: &Options<'_>) -> Self {
        let margin = if options.detail { 40.0 } else { 12.0 };
        let size = if options.size.is_nan() { 1000.0 } else { options.size.clamp(100.0, 1e5) };
        if let Some(window) = options.window.and_then(Bounds::of_window) {
            return Self { main: Frame::new(window, size, margin, false), insets: Vec::new(), left_out: 0 };
        }
        let all = Bounds::around(map.dcel().vertices().map(|v| map.point(v.index())));
        let all = if all.is_empty() { Bounds::UNIT } else { all };
        let mut parts = if options.insets && !options.detail { parts(map, &all) } else { Vec::new() };
        let main = parts.first().copied().filter(|part| all.longer() >= GAIN * part.longer());
        let Some(main) = main else {
            return Self { main: Frame::new(all, size, margin, true), insets: Vec::new(), left_out: 0 };
        };
        let left_out = parts.len().saturating_sub(1 + INSETS);
        parts.truncate(1 + INSETS);
        let main = Frame::new(main, size, margin, false);
        let count = (parts.len() - 1) as f64;
        let width = ((main.size[0] - SPACE) / count - SPACE).clamp(WIDTH / 3.0, WIDTH);
        let insets = parts[1..].iter().map(|part| Frame::within(*part, [width, width * HEIGHT], margin)).collect();
        Self { main, insets, left_out }
    }
}

/// Returns the distant parts of a map, the one with the most vertices first. None if the list of the unbounded face is
/// incomplete, as on maps that are not plane.
fn parts(map: &PlanarMap, all: &Bounds) -> Vec<Bounds> {
    let boxes: Vec<Bounds> = map
        .dcel()
        .unbounded_face()
        .boundaries()
        .map(|b| match (b.start(), b.isolated_vertex()) {
            (Some(_), _) => Bounds::around(b.half_edges().map(|h| map.point(h.origin().index()))),
            (None, v) => Bounds::around(v.map(|v| map.point(v.index()))),
        })
        .collect();
    let listed = boxes.iter().fold(Bounds::EMPTY, |bounds, other| bounds.with(*other));
    if listed.low != all.low || listed.high != all.high {
        return Vec::new();
    }
    let mut found = Vec::new();
    part(boxes, DEPTH, &mut found);
    let mut vertices = vec![0_usize; found.len()];
    for v in map.dcel().vertices() {
        let p = map.point(v.index());
        let at = Bounds { low: p, high: p };
        if let Some(part) = found.iter().position(|bounds| bounds.meets(&at)) {
            vertices[part] += 1;
        }
    }
    let mut parts: Vec<(usize, Bounds)> = vertices.into_iter().zip(found).collect();
    parts.sort_by_key(|(vertices, _)| std::cmp::Reverse(*vertices));
    parts.into_iter().map(|(_, bounds)| bounds).collect()
}

/// Splits boxes along the widest empty strip, recursively; returns the box around each part.
fn part(mut boxes: Vec<Bounds>, depth: usize, found: &mut Vec<Bounds>) {
    let along = |axis: usize, p: Point| if axis == 0 { p.x } else { p.y };
    let all = boxes.iter().fold(Bounds::EMPTY, |bounds, other| bounds.with(*other));
    let mut widest = (STRIP * all.longer(), 0, 0);
    for axis in [0, 1] {
        boxes.sort_by(|a, b| along(axis, a.low).total_cmp(&along(axis, b.low)));
        let mut reached = f64::INFINITY;
        for (i, one) in boxes.iter().enumerate() {
            let strip = along(axis, one.low) - reached;
            if strip > widest.0 {
                widest = (strip, axis, i);
            }
            reached = if i == 0 { along(axis, one.high) } else { reached.max(along(axis, one.high)) };
        }
    }
    let (_, axis, first) = widest;
    if depth == 0 || first == 0 {
        found.push(all);
        return;
    }
    boxes.sort_by(|a, b| along(axis, a.low).total_cmp(&along(axis, b.low)));
    let rest = boxes.split_off(first);
    part(boxes, depth - 1, found);
    part(rest, depth - 1, found);
}
