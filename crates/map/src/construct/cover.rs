//! The features that cover each face, and the features that run along each edge.
//!
//! A point belongs to a polygon if a ray from it crosses the rings an odd number of times. So crossing an edge enters or leaves
//! exactly the polygons that use the edge an odd number of times. One walk over all faces finds the features of each, starting
//! from the unbounded face, which nothing covers:
//!
//! ```text
//!   ┌─────────────┐     outside            nothing
//!   │ a  ┌────────┼──┐  across a           a
//!   │    │ ab   b │  │  across b           a, b
//!   └────┼────────┘  │  across a again     b
//!        └───────────┘
//! ```
//!
//! The walk returns the way it came, so one state suffices: for each polygon, whether the walk is inside it, and for each
//! feature, the number of such polygons. O(segments of all features · log features), expected.

use super::arrange::half_edge;
use super::gathered::{GatheredFeatures, Part};
use crate::FeatureId;
use crate::feature_sets::FeatureSets;
use crate::feature_tries::SetId;
use twinedge::dcel::Dcel;

/// The parts that use each segment, in order, once for each use.
struct Uses {
    first: Vec<usize>,
    parts: Vec<u32>,
}

impl Uses {
    fn of(&self, segment: usize) -> &[u32] {
        &self.parts[self.first[segment]..self.first[segment + 1]]
    }
}

enum Step {
    /// Into the face of the half-edge with this index, unless its features are known.
    Enter(usize),
    /// Back across this segment.
    Leave(usize),
}

/// The state of the walk: the polygons that contain the current face, and their number for each feature.
struct State {
    inside: Vec<bool>,
    polygons: Vec<u32>,
}

/// Computes the features of the faces and edges of a map made of `segments` segments.
pub(super) fn cover(dcel: &Dcel, segments: usize, gathered: &GatheredFeatures) -> FeatureSets {
    let GatheredFeatures { names, parts, .. } = gathered;
    let uses = uses(segments, gathered);
    let mut sets = FeatureSets::default();
    let singles: Vec<SetId> = (0..names.len() as u32).map(|feature| sets.single(FeatureId::new(feature))).collect();
    // Neighbours mostly have the same features.
    let (mut features, mut last, mut set) = (Vec::new(), &[][..], SetId::default());
    for segment in 0..segments {
        let uses = uses.of(segment);
        if uses != last {
            features.clear();
            features.extend(uses.iter().map(|part| parts[*part as usize].feature));
            features.dedup();
            let either = |set, feature: &u32| sets.either(set, singles[*feature as usize]);
            (last, set) = (uses, features.iter().fold(SetId::default(), either));
        }
        if !uses.is_empty() {
            sets.put_along(first_half_edge(segment), set);
        }
    }
    walk(dcel, &uses, parts, &mut sets, &singles);
    sets
}

fn uses(segments: usize, gathered: &GatheredFeatures) -> Uses {
    // After summation, `first[s + 1]` is the start of segment s; filing moves it to the end of the segment.
    let mut first = vec![0; segments + 2];
    for dart in &gathered.darts {
        first[(dart >> 1) as usize + 2] += 1;
    }
    for i in 1..first.len() {
        first[i] += first[i - 1];
    }
    let mut filed = vec![0; first[segments + 1]];
    for ((_, darts), part) in gathered.all().zip(0..) {
        for dart in darts {
            let place = &mut first[(dart >> 1) as usize + 1];
            filed[*place] = part;
            *place += 1;
        }
    }
    Uses { first, parts: filed }
}

const fn first_half_edge(segment: usize) -> usize {
    half_edge((segment << 1) as u32) as usize
}

fn walk(dcel: &Dcel, uses: &Uses, parts: &[Part], sets: &mut FeatureSets, singles: &[SetId]) {
    let mut state = State { inside: vec![false; parts.len()], polygons: vec![0; singles.len()] };
    let mut known = vec![false; dcel.faces().last().map_or(0, |face| face.index() + 1)];
    let unbounded = dcel.unbounded_face();
    known[unbounded.index()] = true;
    let mut steps: Vec<Step> = unbounded.half_edges().map(|h| Step::Enter(h.twin().index())).collect();
    while let Some(step) = steps.pop() {
        let entered = match step {
            Step::Leave(segment) => {
                state.cross(uses.of(segment), parts, |_, _| {});
                continue;
            }
            Step::Enter(h) => dcel.half_edge_at(h),
        };
        let Some(h) = entered else { continue };
        let face = h.face();
        if std::mem::replace(&mut known[face.index()], true) {
            continue;
        }
        let segment = (h.index() - first_half_edge(0)) / 2;
        // Beginning features are added last: most faces have one feature, so this avoids looking up sets of two in between.
        let (mut set, mut begun) = (sets.of_face(h.twin().face().index()), SetId::default());
        state.cross(uses.of(segment), parts, |feature, begins| {
            let changed = if begins { &mut begun } else { &mut set };
            *changed = sets.differing(*changed, singles[feature as usize]);
        });
        let set = sets.differing(set, begun);
        sets.put_face(face.index(), set);
        steps.push(Step::Leave(segment));
        steps.extend(
            face.half_edges().map(|h| h.twin()).filter(|h| !known[h.face().index()]).map(|h| Step::Enter(h.index())),
        );
    }
}

impl State {
    /// Crosses a segment. Reports the features that begin (true) or end (false) there; a feature may do both.
    fn cross(&mut self, uses: &[u32], parts: &[Part], mut changes: impl FnMut(u32, bool)) {
        for same in uses.chunk_by(|a, b| a == b) {
            let part = parts[same[0] as usize];
            if !part.is_polygon || same.len() % 2 == 0 {
                continue;
            }
            let inside = &mut self.inside[same[0] as usize];
            *inside = !*inside;
            let polygons = &mut self.polygons[part.feature as usize];
            let before = *polygons;
            *polygons = if *inside { before + 1 } else { before - 1 };
            if before == 0 || *polygons == 0 {
                changes(part.feature, before == 0);
            }
        }
    }
}
