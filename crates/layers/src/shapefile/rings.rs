//! Polygons of a Shapefile: a list of rings, outer ones clockwise and holes counter-clockwise, in any order.

use super::super::model::Line;
use super::super::nesting::{Extent, area, direction, lies_in};
use std::cmp::Ordering;

/// Returns the polygons of a list of rings, reversed: outer rings become counter-clockwise and holes clockwise, as GeoJSON
/// requires, if the file follows its format. Each ring keeps its first point.
pub(super) fn polygons(rings: Vec<Line>) -> Vec<Vec<Line>> {
    let mut polygons = grouped(rings);
    for ring in polygons.iter_mut().flatten() {
        // Rings without area have no direction, and are written as they are read.
        if direction(ring) != Ordering::Equal {
            ring.reverse();
        }
    }
    polygons
}

/// Returns the polygons of a list of rings: one for each outer ring, in order, with the holes that lie in it and in no smaller
/// one. A hole that lies in no outer ring is a polygon of its own, and so is every ring if none is an outer one. At worst
/// O(rings² · points), if boxes lie inside each other.
fn grouped(rings: Vec<Line>) -> Vec<Vec<Line>> {
    let (outer, inner): (Vec<Line>, Vec<Line>) =
        rings.into_iter().partition(|ring| direction(ring) != Ordering::Greater);
    let mut polygons: Vec<Vec<Line>> = outer.into_iter().map(|ring| vec![ring]).collect();
    match &mut polygons[..] {
        [] => return inner.into_iter().map(|ring| vec![ring]).collect(),
        [only] => {
            let extent = Extent::of(&only[0]);
            if inner.iter().all(|hole| extent.contains(&Extent::of(hole))) {
                only.extend(inner);
                return polygons;
            }
        }
        _ => {}
    }
    let shells: Vec<(Extent, f64)> =
        polygons.iter().map(|polygon| (Extent::of(&polygon[0]), area(&polygon[0]).abs())).collect();
    let mut orphans = Vec::new();
    for hole in inner {
        let extent = Extent::of(&hole);
        let around = shells.iter().enumerate().filter(|(_, (shell, _))| shell.contains(&extent));
        let around = around.filter(|(number, _)| lies_in(&hole, &polygons[*number][0]));
        match around.min_by(|a, b| a.1.1.total_cmp(&b.1.1)) {
            Some((number, _)) => polygons[number].push(hole),
            None => orphans.push(vec![hole]),
        }
    }
    polygons.extend(orphans);
    polygons
}

/// Returns the rings of polygons, outer ones clockwise and holes counter-clockwise. Rings without points are left out.
pub(super) fn written_rings<'a>(polygons: impl IntoIterator<Item = &'a [Line]>) -> Vec<Line> {
    let mut written = Vec::new();
    for rings in polygons {
        for (number, ring) in rings.iter().enumerate().filter(|(_, ring)| !ring.is_empty()) {
            let mut ring = ring.clone();
            let is_counter_clockwise = direction(&ring) == Ordering::Greater;
            if is_counter_clockwise == (number == 0) {
                ring.reverse();
            }
            written.push(ring);
        }
    }
    written
}
