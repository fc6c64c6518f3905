//! Parts of features that are too large to be part of a sliver, so their regions need no further data.

use super::bounds::Bounds;
use super::ends::Ends;
use super::faces::Faces;
use super::local::{Local, Segment};
use super::side::Side;
use twinedge_geometry::Point;

/// Returns an area that each part of a face has at least, 0 if it extends to infinity: crossings of edges and the border are rounded. O(n).
pub(super) fn least_areas(local: &Local, faces: &Faces) -> Vec<f64> {
    // Twice the area of each part, and a bound on the error of that, divided by the rounding of a number.
    let mut twice = vec![(0.0, 0.0); faces.all.len()];
    let origin = local.segments.first().map_or_else(|| local.bounds.any_point(), |segment| segment.ends[0]);
    let mut add = |part: u32, p: Point, q: Point| {
        let (from, way) = ([p.x - origin.x, p.y - origin.y], [q.x - p.x, q.y - p.y]);
        let size = |[x, y]: [f64; 2]| x.abs() + y.abs();
        // Points are rounded as far as they lie from 0, and so is what follows from them.
        let reach = size([p.x, p.y]) + size([q.x, q.y]) + size(from);
        let (area, error) = &mut twice[part as usize];
        *area += from[0] * way[1] - way[0] * from[1];
        *error += reach * size(way) + reach * reach * f64::EPSILON;
    };
    for (number, segment) in (0..).zip(&local.segments) {
        let [p, q] = clipped(local, segment);
        let [left, right] = faces.beside(number);
        add(left, p, q);
        add(right, q, p);
    }
    let place = |contact: usize| {
        let (side, segment, _) = local.contacts[contact];
        (side as usize, Some(passage(&local.bounds, side, local.segments[segment as usize].ends)))
    };
    let count = local.contacts.len();
    for (contact, part) in faces.after.iter().enumerate() {
        let ((from, first), (to, last)) = match count {
            0 => ((0, None), (4, None)),
            _ if contact + 1 == count => (place(contact), (place(0).0 + 4, place(0).1)),
            _ => (place(contact), place(contact + 1)),
        };
        // Around the corners between two contacts.
        let corners = (from..to).map(|side| corner(&local.bounds, Side::ALL[side % 4]));
        let mut way: Vec<Point> = first.into_iter().chain(corners).chain(last).collect();
        if count == 0 {
            way.extend(way.first().copied());
        }
        if way.iter().any(|p| p.x.is_infinite() || p.y.is_infinite()) {
            continue;
        }
        for pair in way.windows(2) {
            add(*part, pair[0], pair[1]);
        }
    }
    let least = |(area, error): (f64, f64)| (area / 2.0 - 16.0 * f64::EPSILON * error).max(0.0);
    twice.into_iter().map(least).collect()
}

/// Returns the corner at the end of a side, counter-clockwise.
const fn corner(Bounds { low, high }: &Bounds, side: Side) -> Point {
    match side {
        Side::Bottom => Point { x: high.x, y: low.y },
        Side::Right => *high,
        Side::Top => Point { x: low.x, y: high.y },
        Side::Left => *low,
    }
}

/// Returns the ends of the part of an edge in the tile, rounded.
fn clipped(local: &Local, segment: &Segment) -> Ends {
    let at = |contact: Option<u32>, end: Point| {
        contact.map_or(end, |contact| passage(&local.bounds, local.contacts[contact as usize].0, segment.ends))
    };
    [at(segment.entry, segment.ends[0]), at(segment.exit, segment.ends[1])]
}

/// Returns the point where an edge passes a side, rounded.
fn passage(Bounds { low, high }: &Bounds, side: Side, [a, b]: Ends) -> Point {
    let along = |from: f64, to: f64, part: f64| from + (to - from) * part.clamp(0.0, 1.0);
    match side {
        Side::Left | Side::Right => {
            let x = if side == Side::Left { low.x } else { high.x };
            Point::new(x, along(a.y, b.y, (x - a.x) / (b.x - a.x)))
        }
        Side::Bottom | Side::Top => {
            let y = if side == Side::Bottom { low.y } else { high.y };
            Point::new(along(a.x, b.x, (y - a.y) / (b.y - a.y)), y)
        }
    }
}
