//! The faults that only relations can have.

use twinedge_diagnosis::{Diagnosis, FeatureName, Position, Records, RuleLine, Trace, middle};

/// The rules: id, name, unit, statement.
pub(crate) const RULES: [[&str; 4]; 5] = [
    ["O1", "members", "members", "every way of a relation is in the file, with all of its nodes"],
    ["O2", "rings", "relations", "the ways of a relation make closed rings"],
    ["O3", "once", "members", "a way is a member of a relation once"],
    ["O4", "sides", "sides of ways", "each side of a way has one relation at most"],
    ["O5", "roles", "rings", "the ways of an outer ring are outer, those of a hole inner, or have no role"],
];

/// A way to break a rule: the rule, the name, the usual cause, the remedy.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kind {
    rule: usize,
    name: &'static str,
    cause: &'static str,
    remedy: &'static str,
}

impl Kind {
    pub(crate) const WAY_MISSING: Self = Self {
        rule: 0,
        name: "way_missing",
        cause: "the file is an extract, and the relation crosses its border",
        remedy: "cut the extract with complete relations, or ask for those that lie in it",
    };
    pub(crate) const NODE_MISSING: Self = Self {
        rule: 0,
        name: "node_missing",
        cause: "the file is an extract, and the way crosses its border",
        remedy: "cut the extract with complete ways",
    };
    pub(crate) const OPEN: Self = Self {
        rule: 1,
        name: "open_ring",
        cause: "a way was split or removed, and the relation does not have all of its parts",
        remedy: "add the way that leads from one of these nodes to another one",
    };
    pub(crate) const NO_WAYS: Self = Self {
        rule: 1,
        name: "no_ways",
        cause: "all members were removed, or have roles that are none of a border",
        remedy: "add the ways of the border, or remove the relation",
    };
    pub(crate) const REPEATED: Self = Self {
        rule: 2,
        name: "way_repeated",
        cause: "two relations were merged, or a way was added twice",
        remedy: "remove one of the members",
    };
    pub(crate) const SAME_SIDE: Self = Self {
        rule: 3,
        name: "same_side",
        cause: "the relations overlap, or one is a copy of the other",
        remedy: "give the relation that does not lie there the way along its own border",
    };
    pub(crate) const ROLE: Self = Self {
        rule: 4,
        name: "wrong_role",
        cause: "a ring was added with the role of another one",
        remedy: "change the roles of the ways of the ring",
    };
}

/// The findings: the number for each rule, and the kept ones.
#[derive(Clone, Debug, Default)]
pub(crate) struct Findings {
    pub(crate) kept: Vec<Diagnosis>,
    pub(crate) checked: [u64; 5],
    counts: [u64; 5],
    cap: usize,
}

impl Findings {
    /// Keeps up to `cap` findings of each rule.
    pub(crate) fn new(cap: usize) -> Self {
        Self { cap, ..Self::default() }
    }

    pub(crate) fn add(&mut self, kind: Kind, found: impl FnOnce() -> Found) {
        let count = &mut self.counts[kind.rule];
        *count += 1;
        if *count > self.cap as u64 {
            return;
        }
        let Found { message, features, records, places, lines, follows_from } = found();
        self.kept.push(Diagnosis {
            rule: Some(RULES[kind.rule][0]),
            kind: twinedge_diagnosis::Kind::Named { kind: kind.name },
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

    pub(crate) fn rules(&self) -> Vec<RuleLine> {
        let line = |(i, [id, name, unit, statement]): (usize, [&'static str; 4])| {
            let (checked, violations) = (self.checked[i], self.counts[i]);
            RuleLine { id, name, statement, checked, unit, violations, unchecked: None, left_out: None }
        };
        RULES.into_iter().enumerate().map(line).collect()
    }
}

#[derive(Default)]
pub(crate) struct Found {
    pub(crate) message: String,
    pub(crate) features: Vec<FeatureName>,
    pub(crate) records: Vec<String>,
    pub(crate) places: Vec<Position>,
    pub(crate) lines: Vec<Vec<Position>>,
    pub(crate) follows_from: Option<&'static str>,
}

impl Found {
    pub(crate) fn of(features: impl Into<Vec<FeatureName>>) -> Self {
        Self { features: features.into(), ..Self::default() }
    }
}
