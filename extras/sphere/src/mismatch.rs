//! C7 mismatch: where borders of two features meet, both have a vertex.

use crate::claims::Cover;
use crate::clash::Clash;
use crate::drawing::Drawing;
use crate::finding::{Finding, MissingVertex};
use crate::measure::distance;
use crate::predicates::on_arc;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;
use twinedge_coverage::CoverageRule;
use twinedge_geometry::Point;

/// Finds violations of C7: for each two features whose borders lack vertices of each other, a finding with all of these vertices. Findings with the
/// most missing vertices come first. A vertex around which the two features overlap is left out, because the overlap is a finding of C1.
///
/// O(n + k log k) for n half-edges and k clashes, expected.
///
/// ```
/// use twinedge_map::{Feature, Shape};
/// use twinedge_sphere::{Cover, Drawing, Inside, Subdivision, mismatches};
///
/// // Colorado has a corner of Utah's neighbour on its border along the meridian of 102.05 degrees west, and lacks it.
/// let feature = |shape| Feature { shapes: vec![shape], ..Feature::default() };
/// let colorado = Shape::polygon([[-109.05, 37.0], [-102.05, 37.0], [-102.05, 41.0], [-109.05, 41.0]]);
/// let kansas = Shape::polygon([[-102.05, 37.0], [-94.6, 37.0], [-94.6, 40.0], [-102.05, 40.0]]);
/// let drawing = Drawing::new(&[feature(colorado), feature(kansas)])?;
/// let (clashes, map) = Subdivision::new(&drawing);
/// let map = map?;
/// let found = mismatches(&Cover::new(&map, &drawing, Inside::Smaller), &drawing, &clashes);
/// assert_eq!((found.len(), found[0].missing.len(), found[0].missing[0].feature), (1, 1, 0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn mismatches(cover: &Cover<'_>, drawing: &Drawing, clashes: &[Clash]) -> Vec<Finding> {
    let contacts = contacts(drawing, clashes);
    let places: FxHashSet<u32> = contacts.iter().map(|(place, _)| *place).collect();
    let mut of: FxHashMap<u32, Vec<u32>> = places.iter().map(|place| (*place, Vec::new())).collect();
    for arc in drawing.arcs() {
        for end in arc.ends {
            if let Some(features) = of.get_mut(&end) {
                features.extend(&arc.features);
            }
        }
    }
    let around = features_around(cover, drawing, &places);
    let mut pairs: BTreeMap<[u32; 2], Vec<(u32, u32, u32)>> = BTreeMap::new();
    for (place, arc) in contacts {
        let have = &of[&place];
        for lacking in &drawing.arcs()[arc as usize].features {
            if have.contains(lacking) {
                continue;
            }
            for having in have {
                let is_overlap = around[&place].iter().any(|all| all.contains(having) && all.contains(lacking));
                if !is_overlap {
                    let pair = [*having.min(lacking), *having.max(lacking)];
                    pairs.entry(pair).or_default().push((place, *lacking, arc));
                }
            }
        }
    }
    let mut found: Vec<Finding> = pairs.into_iter().map(|(pair, all)| finding(drawing, pair, &all)).collect();
    found.sort_by_key(|one| std::cmp::Reverse(one.missing.len()));
    found
}

/// Returns the places inside arcs at which other arcs end.
fn contacts(drawing: &Drawing, clashes: &[Clash]) -> Vec<(u32, u32)> {
    let mut contacts = Vec::new();
    for clash in clashes {
        match *clash {
            Clash::Touch { place, arc } => contacts.push((place, arc)),
            Clash::Overlap { arcs: [first, second] } => {
                for (one, other) in [(first, second), (second, first)] {
                    let ends = drawing.arcs()[other as usize].ends;
                    let [a, b] = ends.map(|end| drawing.places()[end as usize]);
                    let is_inside = |end: &u32| !ends.contains(end) && on_arc(drawing.places()[*end as usize], a, b);
                    let inside = drawing.arcs()[one as usize].ends.into_iter().filter(is_inside);
                    contacts.extend(inside.map(|end| (end, other)));
                }
            }
            Clash::Cross { .. } => {}
        }
    }
    contacts.sort_unstable();
    contacts.dedup();
    contacts
}

/// Returns the features of each face around some places.
fn features_around<'a>(
    cover: &'a Cover<'_>,
    drawing: &Drawing,
    places: &FxHashSet<u32>,
) -> FxHashMap<u32, Vec<&'a [u32]>> {
    let by_key: FxHashMap<[u64; 3], u32> =
        places.iter().map(|place| (drawing.places()[*place as usize].key(), *place)).collect();
    let mut around: FxHashMap<u32, Vec<&[u32]>> = places.iter().map(|place| (*place, Vec::new())).collect();
    for dart in 0..cover.map.dart_count() as u32 {
        if let Some(place) = by_key.get(&cover.map.place(cover.map.origin(dart)).key()) {
            around.entry(*place).or_default().push(&cover.features[cover.map.face(dart) as usize]);
        }
    }
    around
}

/// Creates the finding for the missing vertices of two features.
fn finding(drawing: &Drawing, pair: [u32; 2], all: &[(u32, u32, u32)]) -> Finding {
    let mut missing: Vec<MissingVertex> = all
        .iter()
        .map(|(place, feature, _)| MissingVertex { at: drawing.degrees(*place), feature: *feature })
        .collect();
    let order = |p: Point, q: Point| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y));
    missing.sort_by(|a, b| order(a.at, b.at).then(a.feature.cmp(&b.feature)));
    missing.dedup();
    let mut arcs: Vec<u32> = all.iter().map(|(_, _, arc)| *arc).collect();
    arcs.sort_unstable();
    arcs.dedup();
    let ends = |arc: &u32| drawing.arcs()[*arc as usize].ends;
    let length = |arc: &u32| {
        let [a, b] = ends(arc).map(|end| drawing.places()[end as usize]);
        distance(a, b)
    };
    Finding {
        rule: CoverageRule::Mismatch,
        features: pair.to_vec(),
        area: 0.0,
        width: 0.0,
        length: arcs.iter().map(length).sum(),
        at: missing.first().map(|one| one.at).unwrap_or_default(),
        border: arcs.iter().map(|arc| ends(arc).map(|end| drawing.degrees(end))).collect(),
        missing,
    }
}
