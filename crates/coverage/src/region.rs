//! Connected sets of faces, and their measures.

use super::finding::{CoverageRule, Finding};
use rustc_hash::FxHashSet;
use twinedge::dcel::{Face, HalfEdge};
use twinedge_algorithm::area::{Sum, face_area};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_lexicographic;
use twinedge_map::{Embedding, FeatureId, PlanarMap};

pub(crate) fn length(map: &PlanarMap, h: HalfEdge<'_>) -> f64 {
    segment_length(ends(map, h))
}

pub(crate) fn segment_length([a, b]: [Point; 2]) -> f64 {
    (b.x - a.x).hypot(b.y - a.y)
}

/// Returns the coordinates of the origin and the target of a half-edge.
pub(crate) fn ends(map: &PlanarMap, h: HalfEdge<'_>) -> [Point; 2] {
    [h.origin(), h.target()].map(|v| map.point(v.index()))
}

/// Groups faces connected across edges between faces of the same class, in order of their first face; faces without a class are
/// left out. O(half-edges of the faces), expected.
pub(crate) fn connected<'a, C: PartialEq>(
    faces: impl IntoIterator<Item = Face<'a>>,
    class: impl Fn(Face<'a>) -> Option<C>,
) -> Vec<Vec<Face<'a>>> {
    let mut seen = FxHashSet::default();
    let mut found = Vec::new();
    for start in faces {
        let Some(kind) = class(start).filter(|_| seen.insert(start.index())) else { continue };
        let mut region = vec![start];
        let mut next = 0;
        while let Some(face) = region.get(next).copied() {
            next += 1;
            for other in face.neighbours() {
                if class(other).as_ref() == Some(&kind) && seen.insert(other.index()) {
                    region.push(other);
                }
            }
        }
        found.push(region);
    }
    found
}

/// Returns the half-edges of a connected set of bounded faces that border on other faces.
pub(crate) fn border<'a>(faces: &[Face<'a>]) -> Vec<HalfEdge<'a>> {
    let inside: FxHashSet<usize> = faces.iter().map(|f| f.index()).collect();
    let around = faces.iter().flat_map(|f| f.half_edges());
    around.filter(|h| !inside.contains(&h.twin().face().index())).collect()
}

/// The size and location of a set of faces.
pub(crate) struct Extent {
    pub(crate) area: f64,
    pub(crate) width: f64,
    pub(crate) length: f64,
    pub(crate) at: Point,
    pub(crate) corner: Point,
}

/// Returns the area of a set of bounded faces, and the length of its border.
pub(super) fn size(map: &PlanarMap, faces: &[Face<'_>], border: &[HalfEdge<'_>]) -> (f64, f64) {
    let area: Sum = faces.iter().map(|f| face_area(map, f.key()).unwrap_or_default()).collect();
    let length: Sum = border.iter().map(|h| length(map, *h)).collect();
    (area.value(), length.value())
}

/// Measures a set of bounded faces. Its point is in the largest face; on a tie, the rightmost such point.
pub(crate) fn extent(map: &PlanarMap, faces: &[Face<'_>]) -> Extent {
    let border = border(faces);
    let (area, length) = size(map, faces, &border);
    let corner = first_corner(border.iter().map(|h| map.point(h.origin().index())));
    let areas = faces.iter().map(|f| face_area(map, f.key()).unwrap_or_default());
    let place = |face: &Face<'_>| point_inside(map, *face).unwrap_or_default();
    let order = |a: &Face<'_>, b: &Face<'_>| compare_lexicographic(place(a), place(b));
    let largest = areas.zip(faces).max_by(|a, b| a.0.total_cmp(&b.0).then_with(|| order(a.1, b.1)));
    let at = largest.map(|(_, face)| place(face)).unwrap_or_default();
    Extent { area, width: mean_width(area, length), length, at, corner }
}

pub(crate) fn finding(map: &PlanarMap, rule: CoverageRule, features: Vec<FeatureId>, faces: &[Face<'_>]) -> Finding {
    let Extent { area, width, length, at, corner } = extent(map, faces);
    Finding {
        rule,
        features,
        area,
        width,
        length,
        at,
        corner,
        faces: faces.iter().map(|f| f.key()).collect(),
        stretches: Vec::new(),
        missing: Vec::new(),
    }
}

/// Returns the leftmost point, and the lowest on a tie.
pub(super) fn first_corner(points: impl Iterator<Item = Point>) -> Point {
    points.min_by(|a, b| compare_lexicographic(*a, *b)).unwrap_or_default()
}

/// Returns twice the area divided by the length of the border.
pub(crate) fn mean_width(area: f64, length: f64) -> f64 {
    if length > 0.0 { 2.0 * area / length } else { 0.0 }
}

/// Returns a point inside a bounded face: the rounded middle of the longest stretch at some height. O(n log n) for n half-edges.
pub(crate) fn point_inside(map: &PlanarMap, face: Face<'_>) -> Option<Point> {
    let mut heights: Vec<f64> = face.outer()?.half_edges().map(|h| map.point(h.origin().index()).y).collect();
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    // Halfway between two neighbouring heights in the middle, so that the line avoids all vertices of the outer boundary.
    let middle = heights.len() / 2;
    let y = f64::midpoint(*heights.get(middle.checked_sub(1)?)?, *heights.get(middle)?);
    let mut crossings: Vec<f64> = face
        .half_edges()
        .map(|h| ends(map, h))
        .filter(|[a, b]| (a.y > y) != (b.y > y))
        .map(|[a, b]| a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)))
        .collect();
    crossings.sort_by(f64::total_cmp);
    let stretches = crossings.chunks_exact(2).map(|pair| (pair[1] - pair[0], f64::midpoint(pair[0], pair[1])));
    let (_, x) = stretches.max_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(Point::new(x, y))
}
