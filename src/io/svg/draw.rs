//! The picture as a whole: faces, edges and names.

use super::frame::{Frame, path};
use super::label_spot::widest;
use super::options::Options;
use super::text::{escaped, put, text};
use super::{detail, marks};
use crate::algorithm::colouring::feature_colours;
use crate::algorithm::coverage::{faces_by_feature, features_of};
use crate::dcel::{Boundary, HalfEdge};
use crate::geometry::Point;
use crate::map::PlanarMap;
use crate::validate::Embedding;

/// Fills for features; more colours than these repeat.
const FILLS: [&str; 8] = ["#8ecae6", "#f4b88a", "#a8d5a2", "#f2a9bb", "#c9b8e4", "#ffe08a", "#9adbc9", "#d8c4a8"];

const STYLE: &str = "\
.sea,.free{fill:#f6f8fa}.hatch{fill:url(#hatch)}\
.edges{fill:none;stroke:#444;stroke-width:.6;stroke-linejoin:round;stroke-linecap:round}\
.point{fill:#222}.name{fill:#333;font-size:9px;text-anchor:middle}\
.detail .edges{stroke:#999;stroke-width:1.2}\
.half{fill:none;stroke:#1d4ed8;stroke-width:1}.next{fill:none;stroke:#64748b;stroke-width:.7;stroke-dasharray:2 1.5}\
.hname{fill:#1d4ed8;font-size:9px;text-anchor:middle;dominant-baseline:central}\
.vertex{fill:#fff;stroke:#111}.vname{fill:#111;font-size:10px;font-weight:bold;text-anchor:middle;dominant-baseline:central}\
.fname{fill:#57534e;font-size:12px;font-style:italic;text-anchor:middle;dominant-baseline:central}\
.bad{fill:none;stroke:#dc2626;stroke-width:1.6}.rule{fill:#dc2626;font-size:11px;font-weight:bold}\
.halo{stroke:#fff;stroke-width:3px;stroke-opacity:.85;stroke-linejoin:round}";

/// Draws a map, plane or not. O(n log n) time and O(n) text for the size n of the map, and O(v²) time for v violations.
///
/// ```
/// use twinedge::map::{Builder, Shape};
/// use twinedge::io::svg::{self, Options};
///
/// let mut builder = Builder::new();
/// builder.shape(&Shape::Polygon(vec![[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]].map(Into::into).to_vec()]))?;
/// let map = builder.build()?;
/// let picture = svg::draw(&map, &Options { detail: true, ..Options::default() });
/// assert!(picture.starts_with("<svg ") && picture.contains(">h5</text>"));
/// # Ok::<(), twinedge::map::BuildError>(())
/// ```
#[must_use]
pub fn draw(map: &PlanarMap, options: &Options<'_>) -> String {
    let frame = Frame::new(map, options);
    let [width, height] = frame.size();
    let mut out = String::new();
    put(
        &mut out,
        format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
viewBox=\"0 0 {width:.0} {height:.0}\" font-family=\"Helvetica, Arial, sans-serif\">\n<style>{STYLE}</style>\n<defs>\
<pattern id=\"hatch\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">\
<path d=\"M0 0V5\" stroke=\"#111\" stroke-width=\"1.6\" stroke-opacity=\".6\"/></pattern>\n\
<marker id=\"head\" orient=\"auto\" markerUnits=\"userSpaceOnUse\" markerWidth=\"8\" markerHeight=\"8\" refX=\"6\" refY=\"3\">\
<path d=\"M0 0L6 3L0 6L1.5 3Z\" fill=\"#1d4ed8\"/></marker>\n\
<marker id=\"tip\" orient=\"auto\" markerUnits=\"userSpaceOnUse\" markerWidth=\"6\" markerHeight=\"6\" refX=\"4\" refY=\"2\">\
<path d=\"M0 0L4 2L0 4Z\" fill=\"#64748b\"/></marker></defs>\n\
<rect class=\"sea\" width=\"100%\" height=\"100%\"/>\n"
        ),
    );
    put(&mut out, format_args!("<g class=\"{}\">\n", if options.detail { "detail" } else { "map" }));
    faces(&mut out, map, &frame);
    edges(&mut out, map, &frame);
    if options.detail {
        detail::draw(&mut out, map, &frame);
    } else {
        names(&mut out, map, &frame);
    }
    marks::draw(&mut out, map, &frame, options.violations);
    out.push_str("</g>\n</svg>\n");
    out
}

fn positions<'a>(map: &'a PlanarMap, boundary: Boundary<'a>) -> impl Iterator<Item = Point> + 'a {
    boundary.half_edges().map(|h| map.point(h.origin().index()))
}

fn faces(out: &mut String, map: &PlanarMap, frame: &Frame) {
    let colours = feature_colours(map);
    for face in map.dcel().faces().filter(|f| !f.is_unbounded()) {
        if !frame.shows(face.outer().into_iter().flat_map(|b| positions(map, b))) {
            continue;
        }
        let mut outline = String::new();
        for boundary in face.boundaries().filter(|b| b.start().is_some()) {
            path(&mut outline, positions(map, boundary).map(|p| frame.at(p)), true);
        }
        let features: Vec<_> = features_of(map, face).collect();
        let fill = features.first().map_or_else(
            || "class=\"free\"".to_owned(),
            |f| format!("fill=\"{}\"", FILLS[colours[f.index()] % FILLS.len()]),
        );
        let names: Vec<&str> = features.iter().filter_map(|f| map.name(*f)).collect();
        let title = format!("f{}: {}", face.index(), escaped(&names.join(", ")));
        put(out, format_args!("<path {fill} fill-rule=\"evenodd\" d=\"{outline}\"><title>{title}</title></path>\n"));
        if features.len() > 1 {
            put(
                out,
                format_args!(
                    "<path class=\"hatch\" fill-rule=\"evenodd\" d=\"{outline}\"><title>{title}</title></path>\n"
                ),
            );
        }
    }
}

/// Every edge once, through vertices of degree 2 without lifting the pen.
fn edges(out: &mut String, map: &PlanarMap, frame: &Frame) {
    let slots = map.dcel().half_edges().map(HalfEdge::index).max().map_or(0, |last| last + 1);
    let mut drawn = vec![false; slots];
    let through = |h: HalfEdge<'_>| h.next().twin().next() == h.twin();
    let mut outline = String::new();
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
            path(&mut outline, chain.iter().map(|p| frame.at(*p)), false);
        }
    }
    put(out, format_args!("<path class=\"edges\" d=\"{outline}\"/>\n"));
    for v in map.dcel().vertices().filter(|v| v.leaving().is_none()) {
        let [x, y] = frame.at(map.point(v.index()));
        put(out, format_args!("<circle class=\"point\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"1.5\"/>\n"));
    }
}

/// The name of each feature in the widest of its faces, where there is room for it.
fn names(out: &mut String, map: &PlanarMap, frame: &Frame) {
    const LETTER: f64 = 5.2;
    for (feature, faces) in map.features().zip(faces_by_feature(map)) {
        let Some(name) = map.name(feature) else { continue };
        let faces = faces.into_iter().filter_map(|f| map.dcel().face(f).ok());
        let spots = faces.filter_map(|face| widest(map, frame, face));
        let Some(spot) = spots.max_by(|a, b| a.width.total_cmp(&b.width)) else { continue };
        if spot.width > LETTER * name.chars().count() as f64 {
            let [x, y] = spot.middle;
            let [width, height] = frame.size();
            if (0.0..=width).contains(&x) && (0.0..=height).contains(&y) {
                text(out, "name", [x, y + 3.0], name);
            }
        }
    }
}
