//! The faults that only a file of TopoJSON can have.

use twinedge_diagnosis::{Diagnosis, Position, Records, Trace, middle};

/// The rules: id, name, unit, statement.
pub(super) const RULES: [[&str; 4]; 4] = [
    ["A0", "size", "arcs", "every arc has two different positions, and every ring encloses something"],
    ["A1", "ends", "indices", "every index is that of an arc, arcs join end to end, rings close"],
    [
        "A2",
        "sides",
        "sides of arcs",
        "each side of an arc has one polygon at most, and not the same one as the other side",
    ],
    ["A3", "used", "arcs", "some object uses the arc"],
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
    const fn new(rule: usize, name: &'static str, cause: &'static str, remedy: &'static str) -> Self {
        Self { rule, name, cause, remedy }
    }

    pub(super) const ARC_WITHOUT_LENGTH: Self = Self::new(
        0,
        "arc_without_length",
        "the map was simplified or quantised until nothing was left of the arc",
        "remove it, and the rings that are made of it alone",
    );
    pub(super) const NO_SUCH_ARC: Self = Self::new(
        1,
        "no_such_arc",
        "arcs were removed or filtered, and the objects were not renumbered",
        "write the file again from its source",
    );
    pub(super) const NOT_JOINED: Self = Self::new(
        1,
        "not_joined",
        "an arc was moved or simplified together with its ends, or an index has the wrong sign",
        "restore the arc; `~i` is arc i backwards",
    );
    pub(super) const NOT_CLOSED: Self =
        Self::new(1, "not_closed", "an index is missing, or an arc was moved", "add the missing arc to the ring");
    pub(super) const RING_WITHOUT_AREA: Self = Self::new(
        0,
        "ring_without_area",
        "the map was simplified or quantised until nothing was left inside the ring",
        "remove the ring",
    );
    pub(super) const SAME_SIDE: Self = Self::new(
        2,
        "same_side",
        "two polygons overlap, or a polygon is in the object twice",
        "let one of the polygons go the other way around, along its own border",
    );
    pub(super) const BOTH_SIDES: Self =
        Self::new(2, "both_sides", "a ring goes forth and back along an arc", "remove both indices from the ring");
    pub(super) const UNUSED: Self =
        Self::new(3, "unused_arc", "an object or a polygon was removed, and its arcs were not", "remove the arc");
}

/// The findings: the number for each rule, and the kept ones.
#[derive(Clone, Debug, Default)]
pub(super) struct Findings {
    pub(super) kept: Vec<Diagnosis>,
    pub(super) counts: [u64; 4],
    cap: usize,
}

impl Findings {
    /// Keeps up to `cap` findings of each rule.
    pub(super) fn new(cap: usize) -> Self {
        Self { cap, ..Self::default() }
    }

    pub(super) fn add(&mut self, kind: Kind, message: impl FnOnce() -> String, at: &[Position]) {
        let count = &mut self.counts[kind.rule];
        *count += 1;
        if *count <= self.cap as u64 {
            let found = Diagnosis {
                rule: Some(RULES[kind.rule][0]),
                kind: twinedge_diagnosis::Kind::Named { kind: kind.name },
                message: message(),
                cause: Some(kind.cause),
                remedy: Some(kind.remedy),
                is_violation: true,
                ..Diagnosis::default()
            };
            self.kept.push(placed(found, Vec::new(), at.to_vec()));
        }
    }
}

/// Returns the same diagnosis with the names of its records and its places.
pub(super) fn placed(diagnosis: Diagnosis, records: Vec<String>, places: Vec<Position>) -> Diagnosis {
    Diagnosis {
        records: Records::Names { records },
        look: middle(&places),
        trace: Trace { points: places.clone(), ..Trace::default() },
        places: Some(places),
        ..diagnosis
    }
}
