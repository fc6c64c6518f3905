//! The colours and patterns of faces.

use super::frame::{Bounds, Frame, path};
use super::outline::outlines;
use super::text::{escaped, put};
use twinedge::dcel::Boundary;
use twinedge_algorithm::colouring::feature_colours;
use twinedge_geometry::Point;
use twinedge_map::{Embedding, FeatureId, PlanarMap};

/// Fills for features, which repeat after the last.
const FILLS: [&str; 8] = ["#8ecae6", "#f4b88a", "#a8d5a2", "#f2a9bb", "#c9b8e4", "#ffe08a", "#9adbc9", "#d8c4a8"];

/// A dashed ring marks an overlap or a gap that is smaller than this, in pixels.
const TINY: f64 = 8.0;

/// The colours of the features, and whether any of them covers a face.
pub(super) struct Fills {
    colours: Vec<usize>,
    has_areas: bool,
    /// The rings of each feature, if the map is not plane.
    pub(super) outlines: Vec<Vec<Vec<Point>>>,
}

impl Fills {
    /// O(n log n).
    pub(super) fn of(map: &PlanarMap) -> Self {
        let has_areas =
            map.dcel().faces().any(|face| map.features_of(face.key()).is_ok_and(|mut all| all.next().is_some()));
        let outlines = if map.is_plane() { Vec::new() } else { outlines(map) };
        Self { colours: feature_colours(map), has_areas, outlines }
    }

    fn of_feature(&self, feature: FeatureId) -> &'static str {
        FILLS[self.colours[feature.index()] % FILLS.len()]
    }

    /// Fills the faces of a map. On a map that is not plane it fills the features, as their faces are unknown.
    pub(super) fn draw(&self, out: &mut String, map: &PlanarMap, frame: &Frame) {
        for (feature, rings) in map.features().zip(&self.outlines) {
            self.rings(out, map, frame, feature, rings);
        }
        let mut tiny = String::new();
        for face in map.dcel().faces().filter(|f| !f.is_unbounded()) {
            let bounds = Bounds::around(face.outer().into_iter().flat_map(|b| positions(map, b)));
            if !frame.shows([bounds.low, bounds.high]) {
                continue;
            }
            let mut outline = String::new();
            for boundary in face.boundaries().filter(|b| b.start().is_some()) {
                path(&mut outline, positions(map, boundary).map(|p| frame.at(p)), true);
            }
            let features: Vec<_> =
                if map.is_plane() { map.features_of(face.key()).into_iter().flatten().collect() } else { Vec::new() };
            let names: Vec<&str> = features.iter().filter_map(|f| map.name(*f)).collect();
            let title = format!("<title>f{}: {}</title>", face.index(), escaped(&names.join(", ")));
            let is_gap = features.is_empty() && self.has_areas && map.is_plane();
            let fill = match features.first() {
                Some(first) => format!("fill=\"{}\"", self.of_feature(*first)),
                None if is_gap => "class=\"gap\"".to_owned(),
                None if map.is_plane() => "class=\"free\"".to_owned(),
                None => "fill=\"none\"".to_owned(),
            };
            put(out, format_args!("<path {fill} fill-rule=\"evenodd\" d=\"{outline}\">{title}</path>\n"));
            if features.len() > 1 {
                put(out, format_args!("<path class=\"hatch\" fill-rule=\"evenodd\" d=\"{outline}\">{title}</path>\n"));
            }
            if (features.len() > 1 || is_gap) && bounds.longer() * frame.scale < TINY {
                let [low, high] = [bounds.low, bounds.high].map(|p| frame.at(p));
                let [x, y] = [0, 1].map(|i| f64::midpoint(low[i], high[i]));
                put(
                    &mut tiny,
                    format_args!("<circle class=\"tiny\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{TINY}\">{title}</circle>\n"),
                );
            }
        }
        out.push_str(&tiny);
    }

    /// Fills the inside of these rings by the even-odd rule.
    fn rings(&self, out: &mut String, map: &PlanarMap, frame: &Frame, feature: FeatureId, rings: &[Vec<Point>]) {
        if rings.is_empty() || !frame.shows(rings.iter().flatten().copied()) {
            return;
        }
        let mut outline = String::new();
        for ring in rings {
            path(&mut outline, ring.iter().map(|p| frame.at(*p)), true);
        }
        let (fill, title) = (self.of_feature(feature), escaped(map.name(feature).unwrap_or_default()));
        put(
            out,
            format_args!("<path fill=\"{fill}\" fill-rule=\"evenodd\" d=\"{outline}\"><title>{title}</title></path>\n"),
        );
    }
}

pub(super) fn positions<'a>(map: &'a PlanarMap, boundary: Boundary<'a>) -> impl Iterator<Item = Point> + 'a {
    boundary.half_edges().map(|h| map.point(h.origin().index()))
}
