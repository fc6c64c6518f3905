//! Replacing the polygons in the geometry of a feature.

use super::super::model::{Feature, Geometry, Layer, Line, Members, Position, Shape, json_number};
use super::dimensions::Further;
use std::cmp::Ordering;
use std::collections::HashMap;
use twinedge_algorithm::area::ring_area;
use twinedge_algorithm::contour::Polygon;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};

/// The rings of a polygon, the outer one first.
pub(super) type Rings = Vec<Vec<Point>>;

pub(super) fn polygons_of(geometry: &Geometry) -> Vec<Rings> {
    let mut found = Vec::new();
    // Adding zero turns −0 into 0.
    let ring = |ring: &Line| ring.iter().map(|p| Point::new(p.x + 0.0, p.y + 0.0)).collect();
    let rings = |rings: &Vec<Line>| rings.iter().map(ring).collect();
    match &geometry.shape {
        Shape::Polygon(polygon) if !polygon.is_empty() => found.push(rings(polygon)),
        Shape::MultiPolygon(polygons) => found.extend(polygons.iter().filter(|rings| !rings.is_empty()).map(rings)),
        Shape::Collection(parts) => found.extend(parts.iter().flat_map(polygons_of)),
        _ => {}
    }
    found
}

pub(super) fn rings_of(Polygon { outer, mut holes }: Polygon) -> Rings {
    holes.insert(0, outer);
    holes
}

/// Returns true if polygons are equal, up to the order of polygons and holes, and the start and direction of rings. O(n log n).
pub(super) fn is_same(before: &[Rings], after: &[Polygon]) -> bool {
    let after = after.iter().map(|polygon| polygon.rings().map(<[Point]>::to_vec).collect());
    canonical(before.to_vec()).is_some_and(|before| canonical(after.collect()).as_ref() == Some(&before))
}

/// Returns true if all rings of polygons are closed and repeat no point, like rings made by cleaning. O(n log n).
#[must_use]
pub fn is_tidy(feature: &Feature) -> bool {
    feature.geometry.as_ref().is_none_or(|geometry| canonical(polygons_of(geometry)).is_some())
}

/// Returns polygons in a canonical form; `None` if rings are open or repeat points.
fn canonical(mut polygons: Vec<Rings>) -> Option<Vec<Rings>> {
    for rings in &mut polygons {
        for (number, ring) in rings.iter_mut().enumerate() {
            let is_closed = ring.len() > 3 && ring.first() == ring.last();
            if !is_closed || ring.windows(2).any(|pair| pair[0] == pair[1]) {
                return None;
            }
            ring.pop();
            let start = first_corner(ring);
            ring.rotate_left(start);
            if is_clockwise(ring) == (number == 0) {
                ring[1..].reverse();
            }
        }
        rings[1..].sort_by(|a, b| compare_rings(a, b));
    }
    polygons.sort_by(|a, b| {
        let rings = a.iter().zip(b).map(|(a, b)| compare_rings(a, b));
        rings.fold(Ordering::Equal, Ordering::then).then(a.len().cmp(&b.len()))
    });
    Some(polygons)
}

/// Returns the index of the leftmost corner of a ring, the lowest on a tie. O(n).
fn first_corner(ring: &[Point]) -> usize {
    (0..ring.len()).min_by(|a, b| compare_lexicographic(ring[*a], ring[*b])).unwrap_or_default()
}

/// Returns true if a ring that does not cross itself turns clockwise, even with a tiny area. O(n).
fn is_clockwise(ring: &[Point]) -> bool {
    let ring = ring.strip_suffix(&ring[..ring.len().min(1)]).unwrap_or(ring);
    let (n, at) = (ring.len(), first_corner(ring));
    if n < 3 {
        return false;
    }
    match orientation(ring[(at + n - 1) % n], ring[at], ring[(at + 1) % n]) {
        Orientation::Collinear => ring_area(ring.iter().copied()) < 0.0,
        turn => turn == Orientation::Clockwise,
    }
}

fn compare_rings(a: &[Point], b: &[Point]) -> Ordering {
    let points = a.iter().zip(b).map(|(a, b)| compare_lexicographic(*a, *b));
    points.fold(Ordering::Equal, Ordering::then).then(a.len().cmp(&b.len()))
}

/// Gives rings their former direction: each follows an old ring of its kind (outer or hole) that shares a point with it, or else
/// the first of its kind. O(n).
pub(super) fn wind_as(before: &[Rings], after: &mut [Rings]) {
    let key = |point: &Point| [point.x.to_bits(), point.y.to_bits()];
    for is_hole in [false, true] {
        let of_kind = |number: usize| (number > 0) == is_hole;
        let old = || before.iter().flat_map(|rings| rings.iter().enumerate()).filter(|(number, _)| of_kind(*number));
        let first = old().next().map(|(_, ring)| is_clockwise(ring));
        let mut turns = HashMap::new();
        for (_, ring) in old() {
            let turn = is_clockwise(ring);
            for point in ring {
                turns.entry(key(point)).or_insert(turn);
            }
        }
        let new =
            after.iter_mut().flat_map(|rings| rings.iter_mut().enumerate()).filter(|(number, _)| of_kind(*number));
        for (_, ring) in new {
            let turn = ring.iter().find_map(|point| turns.get(&key(point))).copied().or(first);
            if turn.is_some_and(|turn| turn != is_clockwise(ring)) {
                ring.reverse();
            }
        }
    }
}

/// Returns the geometry with its polygons replaced by these; `None` if nothing is left. A polygon becomes a multi-polygon if
/// there are several, and a multi-polygon remains one.
pub(super) fn replace(geometry: &Geometry, polygons: &[Rings], further: &mut Further) -> Option<Geometry> {
    let dimensions = geometry.dimensions;
    further.of_feature(geometry);
    let mut polygons: Vec<Vec<Line>> =
        polygons.iter().map(|rings| rings.iter().map(|ring| further.line(ring)).collect()).collect();
    let shape = match &geometry.shape {
        Shape::Collection(parts) => {
            let mut kept: Vec<Geometry> = parts.iter().filter_map(without_polygons).collect();
            let mut made: Vec<Geometry> =
                polygons.into_iter().map(|rings| Geometry::new(dimensions, Shape::Polygon(rings))).collect();
            let mut of_polygons = parts.iter().filter(|part| without_polygons(part).is_none());
            // The correspondence of several polygons is unknown.
            if let ([one], Some(part), None) = (&mut made[..], of_polygons.next(), of_polygons.next()) {
                *one = with_members(part, std::mem::replace(&mut one.shape, Shape::Point(None)));
            }
            kept.splice(0..0, made);
            Some(Shape::Collection(kept)).filter(|shape| !shape.is_empty())
        }
        Shape::Polygon(_) if polygons.len() == 1 => polygons.pop().map(Shape::Polygon),
        _ if polygons.is_empty() => None,
        _ => Some(Shape::MultiPolygon(polygons)),
    };
    shape.map(|shape| with_members(geometry, shape))
}

fn with_members(geometry: &Geometry, shape: Shape) -> Geometry {
    let mut made = Geometry { dimensions: geometry.dimensions, shape, members: geometry.members.clone() };
    let bounds = bounds([&made].into_iter());
    update_member(&mut made.members, bounds);
    made
}

/// Returns a part of a collection without its polygons; `None` if nothing is left.
fn without_polygons(part: &Geometry) -> Option<Geometry> {
    match &part.shape {
        Shape::Polygon(_) | Shape::MultiPolygon(_) => None,
        Shape::Collection(parts) => {
            let shape = Shape::Collection(parts.iter().filter_map(without_polygons).collect());
            Some(with_members(part, shape))
        }
        _ => Some(part.clone()),
    }
}

/// The box around geometries, accumulated one by one.
#[derive(Default)]
pub(crate) struct Bounds(Option<[f64; 4]>);

impl Bounds {
    pub(crate) fn take(&mut self, geometry: &Geometry) {
        geometry.shape.visit(&mut |p: &Position| {
            let [x0, y0, x1, y1] = self.0.unwrap_or([p.x, p.y, p.x, p.y]);
            self.0 = Some([x0.min(p.x), y0.min(p.y), x1.max(p.x), y1.max(p.y)]);
        });
    }

    pub(crate) fn json(self) -> Option<serde_json::Value> {
        self.0.map(|bounds| bounds.into_iter().map(json_number).collect())
    }
}

fn bounds<'a>(geometries: impl Iterator<Item = &'a Geometry>) -> Option<serde_json::Value> {
    let mut bounds = Bounds::default();
    geometries.for_each(|geometry| bounds.take(geometry));
    bounds.json()
}

/// Updates the member `bbox` of a feature, if it has one.
pub(super) fn update_box(feature: &mut Feature) {
    update_member(&mut feature.members, bounds(feature.geometry.iter()));
}

fn update_member(members: &mut Members, bounds: Option<serde_json::Value>) {
    if members.contains_key("bbox") {
        match bounds {
            Some(bounds) => drop(members.insert("bbox".to_owned(), bounds)),
            None => drop(members.shift_remove("bbox")),
        }
    }
}

/// Updates the member `bbox` of a layer, if it has one.
pub(super) fn update_box_of_layer(layer: &mut Layer) {
    let bounds = bounds(layer.features.iter().filter_map(|feature| feature.geometry.as_ref()));
    if let (Some(member), Some(bounds)) = (layer.header.members.get_mut("bbox"), bounds) {
        *member = bounds;
    }
}
