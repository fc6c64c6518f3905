//! The names of features.

use super::frame::Frame;
use super::label_spot::{LabelSpot, widest, widest_within};
use super::text::{put, text};
use core::f64::consts::TAU;
use twinedge_algorithm::claims::faces_by_feature;
use twinedge_geometry::Point;
use twinedge_map::PlanarMap;

/// The width of a letter and the height of a name, in pixels.
const LETTER: f64 = 5.2;
const HEIGHT: f64 = 11.0;
/// One name stands next to its feature per `ROOM` square pixels; none with less than `ROOM / ONE_IN` square pixels per feature.
const ROOM: f64 = 20_000.0;
const ONE_IN: f64 = 8.0;
/// The distances from its feature at which a name may be placed.
const DISTANCES: [f64; 5] = [16.0, 26.0, 38.0, 52.0, 70.0];
const DIRECTIONS: u32 = 12;

/// Writes the name of each feature into the widest of its faces, or next to it with a line that leads there. Wider features come
/// first; names without room are left out. O(n log n + m²) for m names.
///
/// On a map that is not plane, features have these outlines instead of faces.
pub(super) fn draw(out: &mut String, map: &PlanarMap, frame: &Frame, outlines: &[Vec<Vec<Point>>]) {
    let mut named: Vec<(LabelSpot, &str)> = Vec::new();
    for (feature, faces) in map.features().zip(faces_by_feature(map)) {
        let Some(name) = map.name(feature).filter(|name| !name.is_empty()) else { continue };
        let in_faces = faces.into_iter().filter_map(|f| widest(map, frame, map.dcel().face(f).ok()?));
        let in_outline = outlines.get(feature.index()).and_then(|rings| widest_within(frame, rings));
        let spots: Vec<LabelSpot> =
            if outlines.is_empty() { in_faces.collect() } else { in_outline.into_iter().collect() };
        let shown = spots.into_iter().filter(|spot| frame.holds(spot.middle));
        named.extend(shown.max_by(|a, b| a.width.total_cmp(&b.width)).map(|spot| (spot, name)));
    }
    named.sort_by(|a, b| b.0.width.total_cmp(&a.0.width));
    let mut taken: Vec<Area> = Vec::new();
    let mut beside = Vec::new();
    for (spot, name) in named {
        let area = Area::of(name, spot.middle);
        if spot.width > area.width && taken.iter().all(|other| !other.meets(&area)) {
            text(out, "name", [spot.middle[0], spot.middle[1] + 3.0], name);
            taken.push(area);
        } else {
            beside.push((spot.middle, name));
        }
    }
    let pixels = frame.size[0] * frame.size[1];
    if beside.len() as f64 * ROOM > ONE_IN * pixels {
        return;
    }
    for ((from, name), _) in beside.into_iter().zip(1..).take_while(|(_, n)| f64::from(*n) * ROOM < pixels) {
        let free = |area: &Area| {
            area.corners().iter().all(|corner| frame.holds(*corner)) && taken.iter().all(|other| !other.meets(area))
        };
        let around = |distance: f64| {
            (0..DIRECTIONS).map(move |i| {
                let angle = TAU * f64::from(i) / f64::from(DIRECTIONS);
                let reach = distance + angle.cos().abs() * Area::of(name, from).width / 2.0;
                Area::of(name, [from[0] + angle.cos() * reach, from[1] - angle.sin() * distance])
            })
        };
        let Some(area) = DISTANCES.into_iter().flat_map(around).find(free) else { continue };
        let to = area.nearest(from);
        put(
            out,
            format_args!("<path class=\"leader\" d=\"M{:.1} {:.1}L{:.1} {:.1}\"/>\n", from[0], from[1], to[0], to[1]),
        );
        text(out, "name", [area.middle[0], area.middle[1] + 3.0], name);
        taken.push(area);
    }
}

struct Area {
    middle: [f64; 2],
    width: f64,
}

impl Area {
    fn of(name: &str, middle: [f64; 2]) -> Self {
        Self { middle, width: LETTER * name.chars().count() as f64 }
    }

    fn meets(&self, other: &Self) -> bool {
        let apart = [0, 1].map(|i| (self.middle[i] - other.middle[i]).abs());
        apart[0] < f64::midpoint(self.width, other.width) + 2.0 && apart[1] < HEIGHT
    }

    fn corners(&self) -> [[f64; 2]; 2] {
        let half = [self.width / 2.0, HEIGHT / 2.0];
        [[0, 1].map(|i| self.middle[i] - half[i]), [0, 1].map(|i| self.middle[i] + half[i])]
    }

    /// Returns its nearest point to another point.
    fn nearest(&self, p: [f64; 2]) -> [f64; 2] {
        let [low, high] = self.corners();
        [0, 1].map(|i| p[i].clamp(low[i], high[i]))
    }
}
