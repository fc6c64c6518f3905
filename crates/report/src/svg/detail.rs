//! Half-edges in the style of textbooks.

use super::frame::Frame;
use super::label_spot::widest;
use super::text::{put, text};
use core::f64::consts::{PI, TAU};
use twinedge::dcel::HalfEdge;
use twinedge_map::{Embedding, PlanarMap};

type Pixel = [f64; 2];

/// The largest distance of an arrow from its edge; `SHORT`, the largest distance of its start and end from the ends of the edge.
const ASIDE: f64 = 6.0;
const SHORT: f64 = 15.0;

struct Arrow {
    tail: Pixel,
    head: Pixel,
    /// The place of its name.
    name: Pixel,
    aside: f64,
    short: f64,
}

fn arrow(map: &PlanarMap, frame: &Frame, h: HalfEdge<'_>) -> Arrow {
    let [a, b] = [h.origin(), h.target()].map(|v| frame.at(map.point(v.index())));
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    let along = if length > 0.0 { [(b[0] - a[0]) / length, (b[1] - a[1]) / length] } else { [0.0, 0.0] };
    // Pixels count downwards.
    let left = [along[1], -along[0]];
    let (aside, short) = (ASIDE.min(length * 0.12), SHORT.min(length * 0.25));
    let from = |p: Pixel, on: f64, off: f64| [0, 1].map(|i| p[i] + along[i] * on + left[i] * off);
    let middle = [f64::midpoint(a[0], b[0]), f64::midpoint(a[1], b[1])];
    let name = from(middle, 0.0, aside + room(&format!("h{}", h.index()), left));
    Arrow { tail: from(a, short, aside), head: from(b, -short, aside), name, aside, short }
}

/// Returns the distance from a line to the middle of a text next to it, in this direction.
fn room(text: &str, direction: Pixel) -> f64 {
    const HALF_A_LETTER: f64 = 2.7;
    (direction[1] * 7.0).hypot(direction[0] * (HALF_A_LETTER * text.len() as f64 + 3.0))
}

/// Returns the angle at which a half-edge leaves, as on the map.
fn angle(map: &PlanarMap, frame: &Frame, h: HalfEdge<'_>) -> f64 {
    let [a, b] = [h.origin(), h.target()].map(|v| frame.at(map.point(v.index())));
    (a[1] - b[1]).atan2(b[0] - a[0])
}

/// Returns the width of the corner before a half-edge, and the direction of its middle.
fn corner(map: &PlanarMap, frame: &Frame, h: HalfEdge<'_>) -> (f64, f64) {
    let from = angle(map, frame, h);
    let width = (angle(map, frame, h.prev().twin()) - from).rem_euclid(TAU);
    // At a dead end, the corner is a full turn.
    let width = if h.prev().twin() == h { TAU } else { width };
    (width, from + width / 2.0)
}

fn towards(p: Pixel, direction: f64, distance: f64) -> Pixel {
    [p[0] + direction.cos() * distance, p[1] - direction.sin() * distance]
}

/// Draws the half-edges, the links to the next ones, and the names of everything in the picture.
pub(super) fn draw(out: &mut String, map: &PlanarMap, frame: &Frame) {
    let at = |h: HalfEdge<'_>| frame.at(map.point(h.origin().index()));
    let shown = |h: &HalfEdge<'_>| frame.shows([h.origin(), h.target()].map(|v| map.point(v.index())));
    for h in map.dcel().half_edges().filter(shown) {
        let Arrow { tail, head, name, aside, short } = arrow(map, frame, h);
        put(
            out,
            format_args!(
                "<path class=\"half\" marker-end=\"url(#head)\" d=\"M{:.1} {:.1}L{:.1} {:.1}\"/>\n",
                tail[0], tail[1], head[0], head[1]
            ),
        );
        let next = h.next();
        let to = arrow(map, frame, next).tail;
        let (width, direction) = corner(map, frame, next);
        // The distance from the vertex to the chord between the two arrows, and to the intended curve: equal along a straight
        // line, nearer to the vertex than the chord inside a corner, further away around a vertex.
        let chord = short * (width / 2.0).cos() + aside * (width / 2.0).sin();
        let wanted = if chord > aside { aside + (chord - aside) * 0.6 } else { aside + (aside - chord) * 0.15 };
        let bend = towards(at(next), direction, 2.0 * wanted - chord);
        put(
            out,
            format_args!(
                "<path class=\"next\" marker-end=\"url(#tip)\" d=\"M{:.1} {:.1}Q{:.1} {:.1} {:.1} {:.1}\"/>\n",
                head[0], head[1], bend[0], bend[1], to[0], to[1]
            ),
        );
        text(out, "hname", name, &format!("h{}", h.index()));
    }
    for face in map.dcel().faces() {
        if let Some(spot) = widest(map, frame, face).filter(|spot| spot.width > 12.0) {
            text(out, "fname", spot.middle, &format!("f{}", face.index()));
        }
    }
    if frame.is_whole() {
        text(out, "fname", [16.0, 12.0], &format!("f{}", map.dcel().unbounded_face().index()));
    }
    for v in map.dcel().vertices().filter(|v| frame.shows([map.point(v.index())])) {
        let here = frame.at(map.point(v.index()));
        put(out, format_args!("<circle class=\"vertex\" cx=\"{:.1}\" cy=\"{:.1}\" r=\"3\"/>\n", here[0], here[1]));
        // In the widest corner, beyond the curve that leads through it.
        let widest = v.rotation().map(|h| corner(map, frame, h)).max_by(|a, b| a.0.total_cmp(&b.0));
        let (distance, direction) = widest.map_or((5.0, PI / 2.0), |(_, direction)| (9.0, direction));
        let name = format!("v{}", v.index());
        let distance = distance + room(&name, [direction.cos(), direction.sin()]);
        text(out, "vname", towards(here, direction, distance), &name);
    }
}
