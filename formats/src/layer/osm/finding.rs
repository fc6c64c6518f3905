//! The faults that only relations can have.

use crate::diagnosis::{self, Diagnosis, FeatureName, Position, Records, RuleLine, Trace, middle};

/// The rules: id, name, unit, statement.
pub(super) const RULES: [[&str; 4]; 5] = [
    ["O1", "members", "members", "every way of a relation is in the file, with all of its nodes"],
    ["O2", "rings", "relations", "the ways of a relation make closed rings"],
    ["O3", "once", "members", "a way is a member of a relation once"],
    ["O4", "sides", "sides of ways", "each side of a way has one relation at most"],
    ["O5", "roles", "rings", "the ways of an outer ring are outer, those of a hole inner, or have no role"],
];

/// A way to break a rule: the rule, the name, the usual cause, the remedy.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kind {
    rule: usize,
    name: &'static str,
    cause: &'static str,
    remedy: &'static str,
}

impl Kind {
    pub(super) const WAY_MISSING: Self = Self {
        rule: 0,
        name: "way_missing",
        cause: "the file is an extract, and the relation crosses its border",
        remedy: "cut the extract with complete relations, or ask for those that lie in it",
    };
    pub(super) const NODE_MISSING: Self = Self {
        rule: 0,
        name: "node_missing",
        cause: "the file is an extract, and the way crosses its border",
        remedy: "cut the extract with complete ways",
    };
    pub(super) const OPEN: Self = Self {
        rule: 1,
        name: "open_ring",
        cause: "a way was split or removed, and the relation does not have all of its parts",
        remedy: "add the way that leads from one of these nodes to another one",
    };
    pub(super) const NO_WAYS: Self = Self {
        rule: 1,
        name: "no_ways",
        cause: "all members were removed, or have roles that are none of a border",
        remedy: "add the ways of the border, or remove the relation",
    };
    pub(super) const REPEATED: Self = Self {
        rule: 2,
        name: "way_repeated",
        cause: "two relations were merged, or a way was added twice",
        remedy: "remove one of the members",
    };
    pub(super) const SAME_SIDE: Self = Self {
        rule: 3,
        name: "same_side",
        cause: "the relations overlap, or one is a copy of the other",
        remedy: "give the relation that does not lie there the way along its own border",
    };
    pub(super) const ROLE: Self = Self {
        rule: 4,
        name: "wrong_role",
        cause: "a ring was added with the role of another one",
        remedy: "change the roles of the ways of the ring",
    };
}

/// The findings: the number for each rule, and the kept ones.
#[derive(Clone, Debug, Default)]
pub(super) struct Findings {
    pub(super) kept: Vec<Diagnosis>,
    pub(super) checked: [u64; 5],
    counts: [u64; 5],
    cap: usize,
}

impl Findings {
    /// Keeps up to `cap` findings of each rule.
    pub(super) fn new(cap: usize) -> Self {
        Self { cap, ..Self::default() }
    }

    pub(super) fn add(&mut self, kind: Kind, found: impl FnOnce() -> Found) {
        let count = &mut self.counts[kind.rule];
        *count += 1;
        if *count > self.cap as u64 {
            return;
        }
        let Found { message, features, records, places, lines, follows_from } = found();
        self.kept.push(Diagnosis {
            rule: Some(RULES[kind.rule][0]),
            kind: diagnosis::Kind::Named { kind: kind.name },
            message,
            cause: Some(kind.cause),
            remedy: Some(kind.remedy),
            records: Records::Names { records },
            features: Some(features),
            look: middle(&places),
            trace: Trace { points: places.clone(), lines, ..Trace::default() },
            places: Some(places),
            follows_from,
            is_violation: true,
            ..Diagnosis::default()
        });
    }

    pub(super) fn rules(&self) -> Vec<RuleLine> {
        let line = |(i, [id, name, unit, statement]): (usize, [&'static str; 4])| {
            let (checked, violations) = (self.checked[i], self.counts[i]);
            RuleLine { id, name, statement, checked, unit, violations, unchecked: None, left_out: None }
        };
        RULES.into_iter().enumerate().map(line).collect()
    }
}

#[derive(Default)]
pub(super) struct Found {
    pub(super) message: String,
    pub(super) features: Vec<FeatureName>,
    pub(super) records: Vec<String>,
    pub(super) places: Vec<Position>,
    pub(super) lines: Vec<Vec<Position>>,
    pub(super) follows_from: Option<&'static str>,
}

impl Found {
    pub(super) fn of(features: impl Into<Vec<FeatureName>>) -> Self {
        Self { features: features.into(), ..Self::default() }
    }
}
