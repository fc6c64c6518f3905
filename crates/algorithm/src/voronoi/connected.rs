//! Converting a connected drawing with convex faces to a map.

use super::error::VoronoiError;
use twinedge::dcel::extend::{Assembly, AssemblyError, BoundaryStart, VertexLink};
use twinedge::dcel::{HalfEdge, RecordKind, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_angle, compare_lexicographic, orientation};
use twinedge_map::PlanarMap;

/// Makes a map of distinct points and of segments that connect all points. `None` unless the drawing is plane and convex: every
/// bounded face is convex, and the outside surrounds a convex polygon or, if the segments enclose nothing, a chain along a line.
///
/// This implies that the drawing is plane. Euler's formula makes the topology planar. Each face covers its part once, next to the
/// faces across its edges, so they cover the inside of the polygon evenly. The border is covered once, so all of it is.
///
/// Vertices and segments keep their order. O(n log n).
pub(super) fn connected(points: Vec<Point>, segments: &[[u32; 2]]) -> Result<Option<PlanarMap>, VoronoiError> {
    let Some(first) = points.first() else { return Ok(Some(PlanarMap::new())) };
    if segments.is_empty() {
        let mut map = PlanarMap::new();
        // A point in range, in an empty map.
        let _ = map.insert_point(*first);
        return Ok((points.len() == 1).then_some(map));
    }
    let origin: Vec<u32> = segments.iter().flatten().copied().collect();
    let Some((leaving, next)) = rotations(&points, &origin) else { return Ok(None) };

    let mut boundary = vec![u32::MAX; origin.len()];
    let (mut starts, mut outer, mut outside) = (Vec::new(), Vec::new(), Vec::new());
    for start in 0..origin.len() {
        if boundary[start] != u32::MAX {
            continue;
        }
        let number = starts.len() as u32;
        let mut h = start;
        while boundary[h] == u32::MAX {
            boundary[h] = number;
            h = next[h] as usize;
        }
        starts.push(BoundaryStart::HalfEdge(start as u32));
        let corners = || around(&points, &origin, &next, start);
        if turns_once(corners(), Orientation::CounterClockwise) {
            outer.push(number);
        } else if turns_once(corners(), Orientation::Clockwise) || is_chain(corners(), &points, &origin) {
            outside.push((0, number));
        } else {
            return Ok(None);
        }
    }
    if outside.len() != 1 || points.len() + starts.len() != segments.len() + 2 {
        return Ok(None);
    }
    let vertices: Vec<VertexLink<u32, u32>> = leaving.into_iter().map(VertexLink::Leaving).collect();
    let assembly = Assembly {
        vertices: &vertices,
        origin: &origin,
        next: &next,
        boundary: &boundary,
        starts: &starts,
        outer: &outer,
        inner: &outside,
    };
    let dcel = assembly.assemble().map_err(|error| match error {
        AssemblyError::Full(kind) => VoronoiError::Full(kind),
        // These columns are valid by construction.
        _ => VoronoiError::Full(RecordKind::Vertex),
    })?;
    let mut by_index = vec![Point::default(); Assembly::vertex_index(0) as usize];
    by_index.extend(points);
    Ok(PlanarMap::assembled(dcel, by_index))
}

/// Returns a half-edge that leaves each point, and the half-edge that follows each half-edge. Returns `None` if a point has no
/// half-edge, or two of them point in the same direction.
fn rotations(points: &[Point], origin: &[u32]) -> Option<(Vec<u32>, Vec<u32>)> {
    let mut first = vec![0_u32; points.len() + 1];
    for v in origin {
        first[*v as usize + 1] += 1;
    }
    for i in 1..first.len() {
        first[i] += first[i - 1];
    }
    let mut free = first.clone();
    let mut sorted = vec![0_u32; origin.len()];
    for (h, v) in (0..).zip(origin) {
        let place = &mut free[*v as usize];
        sorted[*place as usize] = h;
        *place += 1;
    }
    let head = |h: u32| points[origin[h as usize ^ 1] as usize];
    let mut leaving = Vec::with_capacity(points.len());
    let mut next = vec![0; origin.len()];
    for (v, point) in points.iter().enumerate() {
        let around = &mut sorted[first[v] as usize..first[v + 1] as usize];
        around.sort_by(|a, b| compare_angle(*point, head(*a), head(*b)));
        if around.windows(2).any(|pair| compare_angle(*point, head(pair[0]), head(pair[1])).is_eq()) {
            return None;
        }
        // An arriving half-edge is followed by the next one clockwise from its twin.
        let mut clockwise = *around.last()?;
        for h in around.iter() {
            next[*h as usize ^ 1] = clockwise;
            clockwise = *h;
        }
        leaving.push(clockwise);
    }
    Some((leaving, next))
}

/// Returns the corners of a cycle, each as three points.
fn around<'a>(
    points: &'a [Point],
    origin: &'a [u32],
    next: &'a [u32],
    start: usize,
) -> impl Iterator<Item = [Point; 3]> + 'a {
    let mut at = Some(start);
    core::iter::from_fn(move || {
        let h = at?;
        let after = next[h] as usize;
        at = (after != start).then_some(after);
        Some([h, after, next[after] as usize].map(|h| points[origin[h] as usize]))
    })
}

/// Returns true if no corner turns the other way or straight back, and the turns add up to one.
fn turns_once(corners: impl Iterator<Item = [Point; 3]>, way: Orientation) -> bool {
    let mut lowest = 0;
    for [a, b, c] in corners {
        match orientation(a, b, c) {
            Orientation::Collinear if compare_angle(b, a, c).is_eq() => return false,
            Orientation::Collinear => {}
            turn if turn != way => return false,
            _ => {}
        }
        lowest += usize::from(compare_lexicographic(b, a).is_lt() && compare_lexicographic(b, c).is_lt());
    }
    lowest == 1
}

/// Returns true if the cycle runs along a line and back.
fn is_chain(mut corners: impl Iterator<Item = [Point; 3]>, points: &[Point], origin: &[u32]) -> bool {
    origin.len() == 2 * (points.len() - 1) && corners.all(|[a, b, c]| orientation(a, b, c) == Orientation::Collinear)
}

pub(super) fn vertex(map: &PlanarMap, number: u32) -> Option<VertexKey> {
    let index = if map.dcel().edge_count() == 0 {
        map.dcel().vertices().next()?.index() as u32
    } else {
        Assembly::vertex_index(number)
    };
    map.dcel().vertex_at(index as usize).map(|v| v.key())
}

/// Returns the half-edge of a segment, from its first point to its second.
pub(super) fn half_edge(map: &PlanarMap, segment: u32) -> Option<HalfEdge<'_>> {
    map.dcel().half_edge_at(Assembly::half_edge_index(2 * segment) as usize)
}
