//! Findings that follow from others: one mistake in a layer breaks several rules around one place.
//!
//! ```text
//!   a corner was moved ─┬─ C1 overlap, the largest: the cause
//!                       ├─ C1, C2, C4 overlaps, gaps and slivers that touch it
//!                       ├─ G4 borders of its features that cross
//!                       └─ T3 the genus of a map whose borders cross
//! ```
//!
//! Findings of a coverage form a group if they touch and share two features: a border that was drawn twice. A group follows from a greater group that
//! it touches if they share a feature. The cause is an invalid feature (C6), or else the largest finding. Every duplicate (C5) is a cause of its own.
//! Clashes of borders (G4) follow from the greatest finding about their features that they touch, and T3 follows from the clashes. Findings by tiles
//! have no shapes, so only missing vertices are known to touch anything.

use crate::diagnosis_text::common;
use std::cmp::Ordering;
use std::collections::HashMap;
use twinedge::validate::Rule;
use twinedge_coverage::CoverageRule;
use twinedge_diagnosis::{Diagnosis, Position};

/// Points touch if they are closer than this part of the largest coordinate: C6 computes crossings of borders differently from a map.
const NEAR: f64 = 1.0 / (1_u64 << 36) as f64;

/// The number of findings joined at one point, the greatest of each rule first.
const AT_A_POINT: usize = 8;

/// Records the cause of each listed finding and violation. `clashes` counts the clashes of borders, listed or not. A clash is accepted with its cause
/// if all findings that it touches are accepted; T3 is accepted if all clashes are. Findings of a coverage are accepted individually. O(n log n) for
/// the n corners of all findings.
pub(crate) fn trace(findings: &mut [Diagnosis], violations: &mut [Diagnosis], clashes: u64) {
    let sources = Findings::new(findings).sources();
    for (number, source) in sources.iter().enumerate() {
        let (rule, id) = source.map(|source| (findings[source].rule, findings[source].id.clone())).unzip();
        (findings[number].follows_from, findings[number].follows_from_id) = (rule.flatten(), id.flatten());
    }
    let explained: Vec<Option<usize>> = {
        let findings = Findings::new(findings);
        violations.iter().map(|one| findings.explanation(one)).collect()
    };
    let (mut first, mut listed, mut is_accepted) = (None, 0, true);
    for (clash, explained) in violations.iter_mut().zip(explained).filter(|(one, _)| is_clash(one)) {
        if let Some(greatest) = explained {
            let of = &mut findings[sources[greatest].unwrap_or(greatest)];
            (clash.follows_from, clash.follows_from_id) = (of.rule, of.id.clone());
            // It is accepted only if all that touch it are: an open finding has an open source.
            clash.accepted.clone_from(&of.accepted);
            clash.is_violation = clash.accepted.is_none();
            of.is_violation |= clash.is_violation;
        } else {
            clash.follows_from = None;
        }
        listed += 1;
        is_accepted &= clash.accepted.is_some();
        first.get_or_insert_with(|| {
            (clash.follows_from_id.clone().or_else(|| clash.id.clone()), clash.accepted.clone())
        });
    }
    let Some((source, reason)) = first else { return };
    // A clash that is not listed may be a cause.
    let reason = reason.filter(|_| is_accepted && listed == clashes);
    let follows = |one: &&mut Diagnosis| one.rule == Some(Rule::T3.id()) && one.follows_from.is_some();
    for genus in violations.iter_mut().filter(follows) {
        genus.follows_from_id.clone_from(&source);
        genus.accepted.clone_from(&reason);
        genus.is_violation = genus.accepted.is_none();
    }
}

fn is_clash(one: &Diagnosis) -> bool {
    one.rule == Some(Rule::G4.id())
}

fn is_rule(one: &Diagnosis, rule: CoverageRule) -> bool {
    one.rule == Some(rule.id())
}

fn numbers(one: &Diagnosis) -> Vec<usize> {
    let mut numbers: Vec<usize> = one.features.iter().flatten().map(|feature| feature.number).collect();
    numbers.sort_unstable();
    numbers.dedup();
    numbers
}

fn in_common(a: &[usize], b: &[usize]) -> usize {
    let [short, long] = if a.len() < b.len() { [a, b] } else { [b, a] };
    short.iter().filter(|one| long.binary_search(one).is_ok()).count()
}

/// The corners of a finding's shape, the defects of a feature, or the missing vertices. A single point of any other finding is only a place to look
/// at.
fn corners(one: &Diagnosis) -> impl Iterator<Item = Position> {
    let is_invalid = is_rule(one, CoverageRule::Validity);
    let rings = one.trace.polygons.iter().flatten().chain(&one.trace.lines).flatten();
    let points = one.trace.points.iter().filter(move |_| is_invalid);
    rings.chain(points).copied().chain(one.missing.iter().map(|vertex| vertex.at))
}

struct Findings<'a> {
    all: &'a [Diagnosis],
    features: Vec<Vec<usize>>,
    /// The findings with a corner in each cell of a grid.
    at: HashMap<[i64; 2], Vec<usize>>,
    /// Points touch if they differ by at most this in x and in y.
    cell: f64,
}

impl<'a> Findings<'a> {
    fn new(all: &'a [Diagnosis]) -> Self {
        let features: Vec<Vec<usize>> = all.iter().map(numbers).collect();
        let largest = all.iter().flat_map(corners).flatten().map(f64::abs).fold(0.0, f64::max);
        let cell = (largest * NEAR).max(f64::MIN_POSITIVE);
        let mut at: HashMap<[i64; 2], Vec<usize>> = HashMap::new();
        for (number, one) in all.iter().enumerate().filter(|(_, one)| !is_rule(one, CoverageRule::Duplicate)) {
            for corner in corners(one) {
                let here = at.entry(corner.map(|x| (x / cell).round() as i64)).or_default();
                if here.last() != Some(&number) {
                    here.push(number);
                }
            }
        }
        Self { all, features, at, cell }
    }

    fn in_cell(&self, cell: [i64; 2]) -> impl Iterator<Item = usize> {
        self.at.get(&cell).into_iter().flatten().copied()
    }

    /// The order of causes: invalid features first, then by area; missing vertices last.
    fn greater(&self, a: usize, b: usize) -> Ordering {
        let weight = |one: usize| match &self.all[one] {
            one if is_rule(one, CoverageRule::Validity) => f64::INFINITY,
            one => one.measures.area.unwrap_or(-1.0),
        };
        weight(b).total_cmp(&weight(a)).then(a.cmp(&b))
    }

    /// Returns the pairs of unaccepted findings that touch and share features, with the number of shared features.
    fn touching(&self) -> Vec<([usize; 2], usize)> {
        let joined = |cell| self.in_cell(cell).filter(|one| self.all[*one].accepted.is_none()).take(AT_A_POINT);
        let mut pairs = Vec::new();
        for [x, y] in self.at.keys().copied() {
            // Visits each pair of neighbouring cells once.
            for beside in
                [[0, 0], [1, -1], [1, 0], [1, 1], [0, 1]].map(|[dx, dy]| [x.saturating_add(dx), y.saturating_add(dy)])
            {
                let sorted = |a: usize, b: usize| if a < b { [a, b] } else { [b, a] };
                pairs.extend(joined([x, y]).flat_map(|a| joined(beside).map(move |b| sorted(a, b))));
            }
        }
        pairs.sort_unstable();
        pairs.dedup();
        let counted = |[a, b]: [usize; 2]| ([a, b], in_common(&self.features[a], &self.features[b]));
        pairs.into_iter().filter(|[a, b]| a != b).map(counted).filter(|(_, count)| *count > 0).collect()
    }

    /// Returns the source of each finding that follows from another one.
    fn sources(&self) -> Vec<Option<usize>> {
        let pairs = self.touching();
        let mut groups = Groups((0..self.all.len()).collect());
        for ([a, b], _) in pairs.iter().filter(|(_, count)| *count > 1) {
            let heads = [*a, *b].map(|one| groups.head(one));
            let [first, second] = self.sorted(heads);
            groups.0[second] = first;
        }
        let mut beside: HashMap<usize, Vec<usize>> = HashMap::new();
        for ([a, b], _) in pairs {
            let heads = [a, b].map(|one| groups.head(one));
            if heads[0] != heads[1] {
                let [first, second] = self.sorted(heads);
                beside.entry(second).or_default().push(first);
            }
        }
        let mut lesser: Vec<usize> = beside.keys().copied().collect();
        lesser.sort_by(|a, b| self.greater(*a, *b));
        let mut causes: Vec<Option<usize>> = vec![None; self.all.len()];
        for group in lesser {
            // A group that follows from another group is no cause.
            let greater = beside[&group].iter().copied().filter(|other| causes[*other].is_none());
            causes[group] = greater.min_by(|a, b| self.greater(*a, *b));
        }
        let source = |one: usize| {
            let group = groups.head(one);
            Some(causes[group].unwrap_or(group)).filter(|source| *source != one)
        };
        (0..self.all.len()).map(source).collect()
    }

    fn sorted(&self, [a, b]: [usize; 2]) -> [usize; 2] {
        if self.greater(a, b).is_le() { [a, b] } else { [b, a] }
    }

    /// Returns the greatest finding that touches a clash of borders and is about two of its features, or else an invalid one; accepted only if all that
    /// touch it are. Missing vertices explain only clashes at their places. O(findings there).
    fn explanation(&self, clash: &Diagnosis) -> Option<usize> {
        let is_at_missing_vertex = clash.follows_from == Some(CoverageRule::Mismatch.id());
        let features = numbers(clash);
        let mut about = Vec::new();
        for [x, y] in places(clash).into_iter().map(|at| at.map(|x| (x / self.cell).round() as i64)) {
            let around =
                [-1, 0, 1].into_iter().flat_map(|dx| [-1, 0, 1].map(|dy| [x.saturating_add(dx), y.saturating_add(dy)]));
            about.extend(around.flat_map(|cell| self.in_cell(cell)));
        }
        about.sort_unstable();
        about.dedup();
        about.retain(|one| in_common(&self.features[*one], &features) > 0);
        let explains = |one: &usize| {
            let (shared, one) = (in_common(&self.features[*one], &features), &self.all[*one]);
            let is_enough = shared > usize::from(!is_rule(one, CoverageRule::Validity));
            is_enough && is_rule(one, CoverageRule::Mismatch) == is_at_missing_vertex
        };
        // Two crossing borders say more than one invalid feature.
        let order = |a: &usize, b: &usize| {
            let is_of_one = |one: &usize| is_rule(&self.all[*one], CoverageRule::Validity);
            is_of_one(a).cmp(&is_of_one(b)).then(self.greater(*a, *b))
        };
        let is_accepted = about.iter().all(|one| self.all[*one].accepted.is_some());
        // An accepted finding is not reported again, so nothing that counts follows from it.
        let is_open = |one: &usize| is_accepted || self.all[*one].accepted.is_none();
        about.into_iter().filter(explains).filter(is_open).min_by(order)
    }
}

/// Returns the places where the findings caused by a clash have corners: the crossing, or both ends of an overlap.
fn places(clash: &Diagnosis) -> Vec<Position> {
    let ends = clash.places.as_deref().filter(|_| clash.kind.name().ends_with("overlap")).and_then(common);
    ends.map_or_else(|| clash.look.into_iter().collect(), |ends| ends.to_vec())
}

/// Groups of findings: each finding points to a greater one, or is the greatest of its group.
struct Groups(Vec<usize>);

impl Groups {
    fn head(&mut self, mut one: usize) -> usize {
        while self.0[one] != one {
            self.0[one] = self.0[self.0[one]];
            one = self.0[one];
        }
        one
    }
}
