//! Adding vertices where rings of one feature touch, as the OGC allows.

use super::rings::{Contact, Ring, with_index};
use super::validity::{DefectKind, defects, rings_of};
use std::collections::BTreeMap;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_lexicographic;
use twinedge_map::Shape;

/// Adds a vertex to each ring that another ring of the same feature touches between two vertices, if the polygons are valid by
/// the rules of the OGC. Such a touch is no fault, but edges of a map must meet at their ends. The vertex lies exactly on the
/// segment, so nothing moves. Returns true if there was such a place. O(n log n), if few boxes meet; O(1) for one ring.
///
/// ```
/// use twinedge_coverage::insert_touches;
/// use twinedge_map::{Builder, Shape};
///
/// // The hole touches the left side of the square.
/// let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
/// let mut shapes = vec![Shape::polygon(square).hole([[0.0, 2.0], [2.0, 1.0], [2.0, 3.0]])];
/// assert!(insert_touches(&mut shapes));
/// let mut builder = Builder::new();
/// builder.shape(&shapes[0])?;
/// assert!(builder.build()?.is_plane());
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
pub fn insert_touches(shapes: &mut [Shape]) -> bool {
    let count = |shape: &Shape| if let Shape::Polygon(rings) = shape { rings.len() } else { 0 };
    if shapes.iter().map(count).sum::<usize>() < 2 {
        return false;
    }
    if defects(shapes).iter().any(|defect| defect.kind != DefectKind::OpenRing) {
        return false;
    }
    let (_, rings) = rings_of(shapes);
    // For each ring, the points on its segments.
    let mut touched: BTreeMap<usize, Vec<(usize, Point)>> = BTreeMap::new();
    for meet in with_index(&rings, |index| index.meets()) {
        for (ring, segment) in meet.rings.into_iter().zip(meet.segments) {
            if meet.contact == Contact::Touch && !rings[ring].segment(segment).contains(&meet.at) {
                touched.entry(ring).or_default().push((segment, meet.at));
            }
        }
    }
    for (ring, places) in &mut touched {
        let Ring { polygon, number, .. } = rings[*ring];
        if let Some(Shape::Polygon(all)) = shapes.get_mut(polygon) {
            insert(&mut all[number], places);
        }
    }
    !touched.is_empty()
}

/// Inserts points on segments of the ring. Segments are counted without zero-length ones.
fn insert(ring: &mut Vec<Point>, places: &mut [(usize, Point)]) {
    places.sort_by(|(i, p), (j, q)| i.cmp(j).then_with(|| compare_lexicographic(*p, *q)));
    let first = ring.first().copied();
    let (mut segment, mut whole) = (0, Vec::with_capacity(ring.len() + places.len()));
    // An open ring has one more segment.
    for (i, from) in ring.iter().enumerate() {
        whole.push(*from);
        let Some(to) = ring.get(i + 1).copied().or(first).filter(|to| to != from) else { continue };
        let start = whole.len();
        whole.extend(places.iter().filter(|(of, _)| *of == segment).map(|(_, at)| *at));
        if compare_lexicographic(*from, to).is_gt() {
            whole[start..].reverse();
        }
        segment += 1;
    }
    *ring = whole;
}
