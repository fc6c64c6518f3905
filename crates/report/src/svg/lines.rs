//! Edges and isolated vertices.

use super::frame::{Frame, path};
use super::text::put;
use twinedge::dcel::HalfEdge;
use twinedge_map::{Embedding, PlanarMap};

/// The width of lines in pixels, unless they would cover more than the fraction `COVERED` of the panel.
const WIDTH: f64 = 0.6;
const COVERED: f64 = 0.08;
const THINNEST: f64 = 0.05;

/// Draws every edge once, with one stroke through vertices of degree 2, and isolated vertices. The more lines, the thinner they
/// are.
pub(super) fn draw(out: &mut String, map: &PlanarMap, frame: &Frame) {
    let slots = map.dcel().half_edges().map(HalfEdge::index).max().map_or(0, |last| last + 1);
    let mut drawn = vec![false; slots];
    let through = |h: HalfEdge<'_>| h.next().twin().next() == h.twin();
    let mut outline = String::new();
    let mut length = 0.0;
    // Chains with ends first; the rest are closed.
    let ends = map.dcel().half_edges().filter(|h| !through(h.prev()));
    for start in ends.chain(map.dcel().half_edges()) {
        let mut chain = Vec::new();
        let mut h = start;
        while !drawn[h.index()] {
            drawn[h.index()] = true;
            drawn[h.twin().index()] = true;
            if chain.is_empty() {
                chain.push(map.point(h.origin().index()));
            }
            chain.push(map.point(h.target().index()));
            if !through(h) {
                break;
            }
            h = h.next();
        }
        if frame.shows(chain.iter().copied()) {
            let pixels: Vec<[f64; 2]> = chain.iter().map(|p| frame.at(*p)).collect();
            length +=
                pixels.windows(2).map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1])).sum::<f64>();
            path(&mut outline, pixels.into_iter(), false);
        }
    }
    let [width, height] = frame.size;
    let thin = COVERED * width * height / length.max(1.0);
    let style = if thin < WIDTH { format!(" style=\"stroke-width:{:.2}\"", thin.max(THINNEST)) } else { String::new() };
    put(out, format_args!("<path class=\"edges\"{style} d=\"{outline}\"/>\n"));
    for v in map.dcel().vertices().filter(|v| v.leaving().is_none()) {
        let [x, y] = frame.at(map.point(v.index()));
        put(out, format_args!("<circle class=\"point\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"1.5\"/>\n"));
    }
}
