//! Pieces of features that are too large to be part of a sliver, so their regions need no further data.

use super::clip::Bounds;
use super::ends::Ends;
use super::local::{Local, Part};
use super::pieces::Pieces;
use super::side::Side;
use twinedge_geometry::Point;

/// Returns the approximate area of each piece not extending to infinity: crossings of edges and the border are rounded. O(n).
pub(super) fn areas(local: &Local<'_>, pieces: &Pieces) -> Vec<f64> {
    let mut twice = vec![0.0; pieces.faces.len()];
    let origin = local.parts.first().map_or_else(|| local.bounds.any_point(), |part| part.ends[0]);
    let mut add = |piece: u32, p: Point, q: Point| {
        let cross = (p.x - origin.x) * (q.y - origin.y) - (q.x - origin.x) * (p.y - origin.y);
        twice[piece as usize] += cross;
    };
    for part in &local.parts {
        let [p, q] = clipped(local, part);
        let [left, right] = pieces.beside(part);
        add(left, p, q);
        add(right, q, p);
    }
    let place = |contact: usize| {
        let (side, part, _) = local.contacts[contact];
        (side as usize, passage(&local.bounds, side, local.parts[part as usize].ends))
    };
    let count = local.contacts.len();
    for (contact, piece) in pieces.after.iter().enumerate() {
        let ((from, first), (to, last)) = match count {
            0 => ((0, None), (4, None)),
            _ if contact + 1 == count => (place(contact), (place(0).0 + 4, place(0).1)),
            _ => (place(contact), place(contact + 1)),
        };
        // Around the corners between two contacts.
        let corners = (from..to).map(|side| corner(&local.bounds, Side::ALL[side % 4]));
        let around: Option<Vec<Point>> = corners.collect();
        let Some(around) = around else { continue };
        let mut way: Vec<Point> = first.into_iter().chain(around).chain(last).collect();
        if count == 0 {
            way.extend(way.first().copied());
        }
        for pair in way.windows(2) {
            add(*piece, pair[0], pair[1]);
        }
    }
    twice.into_iter().map(|twice| twice / 2.0).collect()
}

/// Returns the corner at the end of a side, counter-clockwise.
fn corner(bounds: &Bounds, side: Side) -> Option<Point> {
    let (x, y) = match side {
        Side::Bottom => (bounds.right, bounds.bottom),
        Side::Right => (bounds.right, bounds.top),
        Side::Top => (bounds.left, bounds.top),
        Side::Left => (bounds.left, bounds.bottom),
    };
    Some(Point::new(x?, y?))
}

/// Returns the ends of the part of an edge in the tile, rounded.
fn clipped(local: &Local<'_>, part: &Part) -> Ends {
    let at = |contact: Option<u32>, end: Point| {
        let side = contact.map(|contact| local.contacts[contact as usize].0);
        side.and_then(|side| passage(&local.bounds, side, part.ends)).unwrap_or(end)
    };
    [at(part.entry, part.ends[0]), at(part.exit, part.ends[1])]
}

/// Returns the point where an edge passes a side, rounded.
fn passage(bounds: &Bounds, side: Side, [a, b]: Ends) -> Option<Point> {
    let along = |from: f64, to: f64, part: f64| from + (to - from) * part.clamp(0.0, 1.0);
    Some(match side {
        Side::Left | Side::Right => {
            let x = if side == Side::Left { bounds.left } else { bounds.right }?;
            Point::new(x, along(a.y, b.y, (x - a.x) / (b.x - a.x)))
        }
        Side::Bottom | Side::Top => {
            let y = if side == Side::Bottom { bounds.bottom } else { bounds.top }?;
            Point::new(along(a.x, b.x, (y - a.y) / (b.y - a.y)), y)
        }
    })
}
