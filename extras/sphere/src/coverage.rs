//! The rules of a coverage on the sphere.

use crate::claims::Cover;
use crate::finding::Finding;
use crate::measure::{RADIUS, WHOLE, distance};
use crate::near_miss::near_misses;
use crate::place::Place;
use core::f64::consts::PI;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;
use twinedge_coverage::{CoverageRule, Limits};
use twinedge_geometry::Point;

/// The findings of the rules of a coverage.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Coverage {
    /// The findings in order of the rules, and by decreasing area within a rule.
    pub findings: Vec<Finding>,
    /// The number of gaps wider than the limit.
    pub wider_gaps: usize,
    /// The number of gaps accepted by a place inside.
    pub accepted_gaps: usize,
    /// The given or chosen maximal width of a near miss in metres. The default is a hundredth of the median length of arcs.
    pub gap_width: f64,
    /// The given or chosen area of slivers, in square metres.
    pub sliver_area: f64,
}

/// Finds violations of C1 … C5 on the sphere. Limits are in metres and square metres, accepted places in degrees.
///
/// Faces and features are as in the [plane](twinedge_coverage), but there is no outside: a place that no feature claims is a gap, unless it is larger
/// than half of the sphere, which is possible for one place at most.
///
/// O(n log n + c log c) for n half-edges and faces, each counted once for each feature that covers it, and c pairs of arcs along unclaimed places
/// within the width of near misses.
///
/// ```
/// use twinedge_coverage::{CoverageRule, Limits};
/// use twinedge_map::{Feature, Shape};
/// use twinedge_sphere::{Cover, Drawing, Inside, Subdivision, check};
///
/// // Two states on both sides of the 49th parallel. One of them has a vertex on it, and the arc of the other one bulges to the north.
/// let feature = |shape| Feature { shapes: vec![shape], ..Feature::default() };
/// let south = Shape::polygon([[-104.0, 45.0], [-97.0, 45.0], [-97.0, 49.0], [-104.0, 49.0]]);
/// let north = Shape::polygon([[-104.0, 49.0], [-100.0, 49.0], [-97.0, 49.0], [-97.0, 53.0], [-104.0, 53.0]]);
/// let drawing = Drawing::new(&[feature(south), feature(north)])?;
/// let (clashes, map) = Subdivision::new(&drawing);
/// assert!(clashes.is_empty());
/// let map = map?;
/// let found = check(&Cover::new(&map, &drawing, Inside::Smaller), &Limits::default());
/// let [overlap] = &found.findings[..] else { unreachable!("nothing else is wrong") };
/// // Up to 5 km wide on 500 km.
/// assert_eq!((overlap.rule, &overlap.features[..]), (CoverageRule::Overlap, &[0, 1][..]));
/// assert!((1e9..2e9).contains(&overlap.area));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn check(cover: &Cover<'_>, limits: &Limits) -> Coverage {
    let judge = Judge::new(cover);
    let first_like = judge.first_like();
    let gap_width = limits.gap_width.unwrap_or_else(|| judge.chosen_width());
    let Gaps { found: gaps, wider: wider_gaps, accepted: accepted_gaps, spaces } = judge.gaps(limits, gap_width);
    let near_misses = near_misses(cover, &spaces, gap_width);
    let (slivers, sliver_area) = judge.slivers(limits);
    let mut findings = Vec::new();
    for mut found in [judge.overlaps(&first_like), gaps, near_misses, slivers, judge.duplicates(&first_like)] {
        found.sort_by(|a, b| b.area.total_cmp(&a.area).then_with(|| a.features.cmp(&b.features)));
        findings.append(&mut found);
    }
    Coverage { findings, wider_gaps, accepted_gaps, gap_width, sliver_area }
}

/// The gaps, and the unclaimed faces that are not gaps.
#[derive(Default)]
struct Gaps {
    found: Vec<Finding>,
    /// The number of gaps wider than the limit.
    wider: usize,
    /// The number of gaps accepted by a place inside.
    accepted: usize,
    /// The places to search for near misses: for each of their faces, the representative of its connected set.
    spaces: FxHashMap<u32, u32>,
}

struct Judge<'a> {
    cover: &'a Cover<'a>,
    darts: Vec<Vec<u32>>,
    faces: Vec<Vec<u32>>,
}

impl<'a> Judge<'a> {
    fn new(cover: &'a Cover<'a>) -> Self {
        let map = cover.map;
        let mut darts = vec![Vec::new(); map.face_count()];
        for dart in map.cycles().into_iter().flatten() {
            darts[map.face(dart) as usize].push(dart);
        }
        let mut faces: Vec<Vec<u32>> = Vec::new();
        for (face, features) in (0..).zip(&cover.features) {
            for feature in features {
                let least = *feature as usize + 1;
                if faces.len() < least {
                    faces.resize(least, Vec::new());
                }
                faces[*feature as usize].push(face);
            }
        }
        Self { cover, darts, faces }
    }

    /// Returns, for each feature, the first feature that covers the same faces.
    fn first_like(&self) -> Vec<u32> {
        let mut first: FxHashMap<&[u32], u32> = FxHashMap::default();
        let mut like = Vec::with_capacity(self.faces.len());
        for (feature, own) in (0..).zip(&self.faces) {
            like.push(if own.is_empty() { feature } else { *first.entry(own).or_insert(feature) });
        }
        like
    }

    /// Returns the sets of faces connected across arcs between faces of the same class. Faces without a class belong to no set.
    fn connected<C: PartialEq>(
        &self,
        faces: impl IntoIterator<Item = u32>,
        class: impl Fn(u32) -> Option<C>,
    ) -> Vec<Vec<u32>> {
        let mut seen = FxHashSet::default();
        let mut found = Vec::new();
        for start in faces {
            let Some(kind) = class(start).filter(|_| seen.insert(start)) else { continue };
            let (mut region, mut next) = (vec![start], 0);
            while let Some(face) = region.get(next).copied() {
                next += 1;
                for dart in &self.darts[face as usize] {
                    let other = self.cover.map.face(dart ^ 1);
                    if !seen.contains(&other) && class(other).as_ref() == Some(&kind) {
                        seen.insert(other);
                        region.push(other);
                    }
                }
            }
            found.push(region);
        }
        found
    }

    fn all(&self) -> std::ops::Range<u32> {
        0..self.cover.map.face_count() as u32
    }

    fn overlaps(&self, first_like: &[u32]) -> Vec<Finding> {
        let of = |face: u32| {
            let mut features: Vec<u32> =
                self.cover.features[face as usize].iter().map(|feature| first_like[*feature as usize]).collect();
            features.sort_unstable();
            features.dedup();
            Some(features).filter(|features| features.len() > 1)
        };
        let regions = self.connected(self.all(), of);
        let finding = |region: &Vec<u32>| {
            let features = self.cover.features[region[0] as usize].clone();
            self.finding(CoverageRule::Overlap, features, region)
        };
        regions.iter().map(finding).collect()
    }

    /// The default for the maximal width of near misses.
    fn chosen_width(&self) -> f64 {
        let map = self.cover.map;
        let length = |dart: u32| {
            let [a, b] = self.ends(dart);
            distance(a, b)
        };
        median((0..map.dart_count() as u32).step_by(2).map(length).collect()) / 100.0
    }

    /// Finds the gaps. Near misses are searched for in wider gaps, unless all gaps are findings, and in the place that is not a gap.
    fn gaps(&self, limits: &Limits, near_miss_width: f64) -> Gaps {
        let places = limits.accepted_gaps.iter().filter_map(|at| Place::new(at.x, at.y).ok());
        let accepted: FxHashSet<u32> = places.map(|place| self.cover.map.locate(place)).collect();
        let mut gaps = Gaps::default();
        let unclaimed = |face: u32| self.cover.features[face as usize].is_empty().then_some(());
        for region in self.connected(self.all(), unclaimed) {
            let is_gap = self.area(&region) <= WHOLE / 2.0;
            if !is_gap || self.take_gap(&mut gaps, &region, &accepted, limits, near_miss_width) {
                gaps.spaces.extend(region.iter().map(|face| (*face, region[0])));
            }
        }
        gaps
    }

    /// Takes a gap. Returns true if it must be searched for near misses.
    fn take_gap(
        &self,
        gaps: &mut Gaps,
        region: &[u32],
        accepted: &FxHashSet<u32>,
        limits: &Limits,
        near_miss_width: f64,
    ) -> bool {
        let beyond = self.border(region, &region.iter().copied().collect());
        let mut features: Vec<u32> = beyond
            .iter()
            .flat_map(|dart| self.cover.features[self.cover.map.face(dart ^ 1) as usize].iter().copied())
            .collect();
        features.sort_unstable();
        features.dedup();
        let gap = self.finding(CoverageRule::Gap, features, region);
        let is_accepted = region.iter().any(|face| accepted.contains(face));
        let is_narrow = limits.lake_width.or(limits.gap_width).is_none_or(|width| gap.width <= width);
        let is_wide = gap.width > near_miss_width;
        match (is_accepted, is_narrow) {
            (true, _) => gaps.accepted += 1,
            (false, true) => gaps.found.push(gap),
            (false, false) => gaps.wider += 1,
        }
        is_wide && (limits.gap_width.is_some() || !is_narrow || is_accepted)
    }

    /// Returns the slivers, and the area below which a thin part is a sliver.
    fn slivers(&self, limits: &Limits) -> (Vec<Finding>, f64) {
        let mut parts = Vec::new();
        for (feature, own) in (0..).zip(&self.faces) {
            let faces: FxHashSet<u32> = own.iter().copied().collect();
            let regions = self.connected(own.iter().copied(), |face| faces.contains(&face).then_some(()));
            parts.extend(regions.into_iter().map(|region| (feature, region)));
        }
        let measured: Vec<(f64, f64)> =
            parts.iter().map(|(_, region)| (self.area(region) * RADIUS * RADIUS, self.length(region))).collect();
        let limit =
            limits.sliver_area.unwrap_or_else(|| median(measured.iter().map(|(area, _)| *area).collect()) / 1_000.0);
        let is_sliver =
            |(area, length): (f64, f64)| area < limit && 4.0 * PI * area < limits.thinness * length * length;
        let slivers = parts.iter().zip(measured).filter(|(_, measures)| is_sliver(*measures));
        let found = slivers.map(|((feature, region), _)| self.finding(CoverageRule::Sliver, vec![*feature], region));
        (found.collect(), limit)
    }

    fn duplicates(&self, first_like: &[u32]) -> Vec<Finding> {
        let mut like: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (feature, first) in (0..).zip(first_like) {
            if feature != *first {
                like.entry(*first).or_insert_with(|| vec![*first]).push(feature);
            }
        }
        like.into_iter()
            .map(|(first, features)| self.finding(CoverageRule::Duplicate, features, &self.faces[first as usize]))
            .collect()
    }

    /// The area on the unit sphere.
    fn area(&self, faces: &[u32]) -> f64 {
        faces.iter().map(|face| self.cover.areas[*face as usize]).sum()
    }

    fn border(&self, faces: &[u32], inside: &FxHashSet<u32>) -> Vec<u32> {
        let around = faces.iter().flat_map(|face| self.darts[*face as usize].iter().copied());
        around.filter(|dart| !inside.contains(&self.cover.map.face(dart ^ 1))).collect()
    }

    fn length(&self, faces: &[u32]) -> f64 {
        let border = self.border(faces, &faces.iter().copied().collect());
        border.iter().map(|dart| self.ends(*dart)).map(|[a, b]| distance(a, b)).sum()
    }

    fn ends(&self, dart: u32) -> [Place; 2] {
        [dart, dart ^ 1].map(|dart| self.cover.map.place(self.cover.map.origin(dart)))
    }

    fn finding(&self, rule: CoverageRule, features: Vec<u32>, faces: &[u32]) -> Finding {
        let border = self.border(faces, &faces.iter().copied().collect());
        let (area, length) = (self.area(faces) * RADIUS * RADIUS, self.length(faces));
        let degrees = |dart: u32| self.cover.map.degrees(self.cover.map.origin(dart));
        let largest =
            faces.iter().max_by(|a, b| self.cover.areas[**a as usize].total_cmp(&self.cover.areas[**b as usize]));
        Finding {
            rule,
            features,
            area,
            width: if length > 0.0 { 2.0 * area / length } else { 0.0 },
            length,
            at: largest.map(|face| self.inside(*face)).unwrap_or_default(),
            border: border.iter().map(|dart| [degrees(*dart), degrees(dart ^ 1)]).collect(),
            missing: Vec::new(),
        }
    }

    /// Returns a place inside a face, if one of several candidates is inside.
    fn inside(&self, face: u32) -> Point {
        const TRIED: usize = 32;
        let ring: Vec<Place> = self.darts[face as usize].iter().map(|dart| self.ends(*dart)[0]).collect();
        let sum = |places: &[Place]| {
            let units = places.iter().map(|place| place.unit());
            Place::toward(units.fold([0.0; 3], |sum, unit| [0, 1, 2].map(|i| sum[i] + unit[i])))
        };
        let steps = ring.len().div_ceil(TRIED).max(1);
        let corners = (0..ring.len()).step_by(steps).map(|i| [0, 1, 2].map(|step| ring[(i + step) % ring.len()]));
        let candidates = [sum(&ring)].into_iter().chain(corners.map(|corner| sum(&corner)));
        let found = candidates.flatten().find(|place| self.cover.map.locate(*place) == face);
        let middle = || sum(&ring[..ring.len().min(2)]);
        found.or_else(middle).map(|place| place.degrees().into()).unwrap_or_default()
    }
}

/// Returns the median of some numbers; 0 if there are none. O(n), expected.
fn median(mut numbers: Vec<f64>) -> f64 {
    if numbers.is_empty() {
        return 0.0;
    }
    let middle = numbers.len() / 2;
    *numbers.select_nth_unstable_by(middle, f64::total_cmp).1
}
