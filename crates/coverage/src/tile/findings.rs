//! The findings of C1 … C5 and C7, from the regions of a whole map and its unmatched vertices.

use super::claimed::first_like;
use super::ends::compare_edges;
use super::region::{Claim, Drawing, Region};
use super::summary::Summary;
use crate::check::Found;
use crate::gap::{Gaps, accepted_faces};
use crate::mismatch::by_pairs;
use crate::near_miss::{near_misses_beside, width_by};
use crate::sliver::chosen_area;
use crate::{Coverage, CoverageRule, Finding};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;
use twinedge_map::FeatureId;

/// Returns the findings of a plane map whose tiles are all merged.
pub(super) fn coverage(summary: &Summary) -> Coverage {
    let Summary { limits, lengths, areas, closed, .. } = summary;
    let gap_width = limits.gap_width.unwrap_or_else(|| width_by(lengths.clone()));
    let sliver_area = limits.sliver_area.unwrap_or_else(|| chosen_area(areas.clone()));
    let slivers = summary.slivers.iter().filter(|sliver| sliver.area < sliver_area).map(|sliver| Finding {
        rule: CoverageRule::Sliver,
        features: vec![FeatureId::new(sliver.feature)],
        area: sliver.area,
        width: sliver.width,
        length: sliver.length,
        at: sliver.at,
        corner: sliver.corner,
        faces: Vec::new(),
        stretches: Vec::new(),
        missing: Vec::new(),
    });
    let mut gaps = Gaps::default();
    let mut searched = Vec::new();
    for region in closed.iter().filter(|region| region.claim == Claim::Unclaimed) {
        if region.is_unbounded {
            searched.push(region);
            continue;
        }
        let Some(drawing) = Drawing::new(region) else { continue };
        let is_of = |features: &[u32]| features.is_empty();
        let gap = drawing.finding(CoverageRule::Gap, &region.around(), &is_of);
        let accepted = accepted_faces(&drawing.map, &limits.accepted_gaps);
        let is_accepted = drawing.faces(&is_of).iter().any(|face| accepted.contains(&face.index()));
        if gaps.take(gap, is_accepted, limits, gap_width) {
            searched.push(region);
        }
    }
    let first_like = first_like(&summary.claimed);
    let found = Found {
        overlaps: overlaps(closed, &first_like),
        gaps,
        near_misses: near_misses(&searched, gap_width),
        slivers: slivers.collect(),
        duplicates: duplicates(closed, &first_like),
        gap_width,
        sliver_area,
    };
    let mut found = found.sorted();
    found.findings.extend(by_pairs(summary.unmatched.iter().copied()));
    found
}

/// Returns the near misses between the borders of some unclaimed regions.
fn near_misses(spaces: &[&Region], width: f64) -> Vec<Finding> {
    let Some(all) = Region::joined(spaces.iter().copied()) else { return Vec::new() };
    let Some(drawing) = Drawing::new(&all) else { return Vec::new() };
    let edges = &all.edges;
    // An edge belongs to a single unclaimed region.
    let mut space_of = vec![0; edges.len()];
    for (space, region) in spaces.iter().enumerate() {
        for edge in &region.edges {
            if let Ok(place) = edges.binary_search_by(|other| compare_edges(&other.ends, &edge.ends)) {
                space_of[place] = space;
            }
        }
    }
    let dcel = drawing.map.dcel();
    let mut of_faces: FxHashMap<usize, usize> = FxHashMap::default();
    let mut beyond: Vec<Vec<FeatureId>> = Vec::new();
    for h in dcel.half_edges() {
        let (Some((edge, left)), Some((_, right))) = (drawing.left(h), drawing.left(h.twin())) else { continue };
        beyond.resize(h.index(), Vec::new());
        beyond.push(right.iter().copied().map(FeatureId::new).collect());
        if left.is_empty() {
            of_faces.insert(h.face().index(), space_of[edge]);
        }
    }
    near_misses_beside(&drawing.map, &of_faces, &|h| beyond.get(h.index()).map_or(&[], Vec::as_slice), width)
}

fn overlaps(closed: &[Region], first_like: &FxHashMap<u32, u32>) -> Vec<Finding> {
    let of = |region: &Region| {
        let Claim::Overlap(features) = &region.claim else { return None };
        let first = |feature: &u32| first_like.get(feature).unwrap_or(feature).to_owned();
        let is_overlap = features.iter().any(|feature| first(feature) != first(&features[0]));
        let drawing = Some(()).filter(|()| is_overlap).and_then(|()| Drawing::new(region))?;
        Some(drawing.finding(CoverageRule::Overlap, features, &|other| other == features))
    };
    closed.iter().filter_map(of).collect()
}

fn duplicates(closed: &[Region], first_like: &FxHashMap<u32, u32>) -> Vec<Finding> {
    // Grouped by first feature, with its overlaps.
    let mut sets: BTreeMap<u32, (Vec<u32>, Vec<&Region>)> = BTreeMap::new();
    for (feature, first) in first_like {
        sets.entry(*first).or_default().0.push(*feature);
    }
    for region in closed {
        let Claim::Overlap(features) = &region.claim else { continue };
        for feature in features {
            if let Some((_, regions)) = sets.get_mut(feature) {
                regions.push(region);
            }
        }
    }
    let of = |(mut set, regions): (Vec<u32>, Vec<&Region>)| {
        set.sort_unstable();
        let is_of = |features: &[u32]| features.binary_search(&set[0]).is_ok();
        let all = Region::joined(regions)?;
        Some(Drawing::new(&all)?.finding(CoverageRule::Duplicate, &set, &is_of))
    };
    sets.into_values().filter(|(set, _)| set.len() > 1).filter_map(of).collect()
}
