//! M11 outward: the faces of a closed component face outwards, or inwards if it is the wall of a cavity in another one.
//!
//! A component is closed if each of its edges is joined. It faces outwards if the volume inside is positive by the order of
//! corners. One that faces inwards is a cavity if a ray from it leaves the other components more often than it enters them.

use super::super::half_edges::NIL;
use super::super::{Finding, HalfEdgeMesh};
use super::exact::sign_of_volume;
use super::places::{Place, Places, faces, side};
use super::segment::sides_seen;
use petgraph::unionfind::UnionFind;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// The number of rays that are tried from a component until one avoids all edges and corners.
const RAYS: usize = 64;

struct Component {
    first_face: usize,
    faces: usize,
    triangles: Vec<[Place; 3]>,
}

/// Returns the number of components that were checked.
pub(super) fn check(mesh: &HalfEdgeMesh<'_>, places: &Places<'_>, found: &mut dyn FnMut(Finding)) -> usize {
    let components = closed(mesh, places);
    for (number, component) in components.iter().enumerate() {
        if sign_of_volume(&component.triangles).is_gt() {
            continue;
        }
        let others = components.iter().enumerate().filter(|(other, _)| *other != number);
        let others: Vec<&[[Place; 3]]> = others.map(|(_, other)| &*other.triangles).collect();
        if !is_inside(&component.triangles, &others) {
            found(Finding::InsideOut { face: component.first_face, faces: component.faces });
        }
    }
    components.len()
}

/// Returns the closed components, by their first faces. O(corners), up to the inverse of Ackermann's function.
fn closed(mesh: &HalfEdgeMesh<'_>, places: &Places<'_>) -> Vec<Component> {
    let mut joined = UnionFind::new(mesh.mesh().face_count());
    let mut is_open = vec![false; mesh.mesh().face_count()];
    for face in faces(mesh) {
        for corner in mesh.mesh().offsets()[face]..mesh.mesh().offsets()[face + 1] {
            match mesh.twins[corner as usize] {
                NIL => is_open[face] = true,
                twin => drop(joined.union(face, mesh.face_of[twin as usize] as usize)),
            }
        }
    }
    let mut components: BTreeMap<usize, (Component, bool)> = BTreeMap::new();
    let mut numbers: BTreeMap<usize, usize> = BTreeMap::new();
    for face in faces(mesh) {
        let first_face = *numbers.entry(joined.find(face)).or_insert(face);
        let new = || (Component { first_face, faces: 0, triangles: Vec::new() }, true);
        let (component, is_closed) = components.entry(first_face).or_insert_with(new);
        component.faces += 1;
        component.triangles.extend(places.triangles(face).iter().map(|triangle| triangle.map(|corner| corner.at)));
        *is_closed &= !is_open[face];
    }
    components.into_values().filter(|(_, is_closed)| *is_closed).map(|(component, _)| component).collect()
}

/// Returns true if a component lies inside others: the first ray past their edges and corners leaves them more often than it
/// enters.
fn is_inside(triangles: &[[Place; 3]], others: &[&[[Place; 3]]]) -> bool {
    let all = || others.iter().copied().flatten();
    let corners = all().flatten().chain(triangles.iter().flatten());
    let far = corners.fold(1.0, |far: f64, at| at.iter().fold(far, |far, x| far.max(x.abs())));
    let starts = triangles.iter().flatten().step_by(triangles.len().div_ceil(8).max(1) * 3 + 1);
    let rays = starts.take(8).flat_map(|start| (1..9).map(move |i| (*start, f64::from(i) / 27.0)));
    for (start, slope) in rays.take(RAYS) {
        let length = 4.0 * far;
        let end = [start[0] + length, start[1] + length * slope, start[2] + length * slope * slope];
        let count = all().try_fold(0_i64, |count, triangle| Some(count + passed([start, end], *triangle)?));
        if let Some(count) = count {
            return count > 0;
        }
    }
    false
}

/// 1 if a segment leaves through a triangle that faces outwards, −1 if it enters, 0 if it misses; `None` at an edge or corner.
fn passed([p, q]: [Place; 2], triangle: [Place; 3]) -> Option<i64> {
    let (from, to) = (side(triangle, p), side(triangle, q));
    if from == to && from.is_ne() {
        return Some(0);
    }
    let seen = sides_seen([p, q], triangle);
    let has = |side: Ordering| seen.contains(&side);
    match (has(Ordering::Less) && has(Ordering::Greater), has(Ordering::Equal) || from.is_eq() || to.is_eq()) {
        (true, _) => Some(0),
        (false, true) => None,
        (false, false) => Some(if from.is_gt() { 1 } else { -1 }),
    }
}
