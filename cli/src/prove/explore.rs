//! Growing all maps of a scope, and trying every operator with every argument on each.

use super::Finding;
use crate::caught::caught;
use crate::work;
use std::collections::{BTreeMap, HashSet};
use std::hash::{BuildHasher, RandomState};
use std::sync::Mutex;
use twinedge::dcel::Dcel;
use twinedge::program::canonical::{Canonizer, Code};
use twinedge::program::census::Scope;
use twinedge::program::{Op, Program, Runner, StepOutcome, Subject, every_op};
use twinedge::validate::{Collect, Counts, Expectation, View, validate};

/// What was found of maps of one size.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    /// Different maps, by their canonical form.
    pub(super) maps: u64,
    /// Operators applied to them.
    pub(super) applied: u64,
    /// Operators that were refused.
    pub(super) refused: u64,
    /// Different maps when no face is distinguished as the outside, and their rootings. Of connected maps only.
    pub(super) sensed: u64,
    pub(super) rooted: u64,
    /// What went wrong.
    pub(super) violations: u64,
}

impl Tally {
    pub(super) const fn add(&mut self, other: &Self) {
        self.maps += other.maps;
        self.applied += other.applied;
        self.refused += other.refused;
        self.sensed += other.sensed;
        self.rooted += other.rooted;
        self.violations += other.violations;
    }
}

/// What was found, by the numbers of edges and vertices.
#[derive(Debug, Default)]
pub(super) struct Explored {
    pub(super) tallies: BTreeMap<(usize, usize), Tally>,
    /// The first of the violations.
    pub(super) findings: Vec<Finding>,
}

impl Explored {
    const MOST_FINDINGS: usize = 10;

    fn note(&mut self, program: &Program, op: Option<Op>, message: String) {
        if self.findings.len() < Self::MOST_FINDINGS {
            let program = program.0.iter().copied().chain(op).collect::<Program>();
            let operator = op.map(|op| op.to_string());
            self.findings.push(Finding { program: program.to_string(), operator, message });
        }
    }

    fn add(&mut self, other: Self) {
        for (size, tally) in other.tallies {
            self.tallies.entry(size).or_default().add(&tally);
        }
        self.findings.extend(other.findings);
        self.findings.truncate(Self::MOST_FINDINGS);
    }
}

/// Codes that all threads add to.
#[derive(Default)]
struct Codes {
    hasher: RandomState,
    shards: [Mutex<HashSet<Code>>; 32],
}

impl Codes {
    /// Whether the code is new.
    fn insert(&self, code: Code) -> bool {
        let shard = &self.shards[self.hasher.hash_one(&code) as usize % self.shards.len()];
        shard.lock().unwrap_or_else(std::sync::PoisonError::into_inner).insert(code)
    }
}

/// What each thread has for itself.
struct Worker {
    canonizer: Canonizer,
    explored: Explored,
    /// The maps that it met first.
    fresh: Vec<Program>,
}

/// Explores all maps of a scope. After each operator that is applied, the map is validated and its counts compared with those
/// before; after each that is refused, the map must be as it was, link by link.
pub(super) fn explore(scope: Scope, threads: usize, what: &str) -> Explored {
    let (seen, sensed) = (Codes::default(), Codes::default());
    let mut explored = Explored::default();
    let mut generation = vec![scope.start()];
    let first = play(&generation[0]);
    if let Some(code) = Canonizer::new().subdivision(first.subject()) {
        seen.insert(code);
    }
    let mut step = 0;
    while !generation.is_empty() && !work::stopped() {
        let bar = work::bar(generation.len(), format!("{what}, step {step}"));
        let worker = || Worker { canonizer: Canonizer::new(), explored: Explored::default(), fresh: Vec::new() };
        let workers = work::share(threads, generation.len(), &bar, worker, |worker, number| {
            worker.visit(scope, &generation[number], &seen, &sensed);
        });
        generation = Vec::new();
        for worker in workers {
            explored.add(worker.explored);
            generation.extend(worker.fresh);
        }
        step += 1;
    }
    explored
}

fn play(program: &Program) -> Runner<Dcel> {
    let mut runner = Runner::new(Dcel::new());
    runner.run(program);
    runner
}

impl Worker {
    fn visit(&mut self, scope: Scope, program: &Program, seen: &Codes, sensed: &Codes) {
        let map = play(program);
        let report = validate(map.subject(), &Expectation::plane(), Collect::First);
        let before = *report.counts();
        let mut tally = Tally { maps: 1, ..Tally::default() };
        let mut wrong = |op, message| {
            tally.violations += 1;
            self.explored.note(program, op, message);
        };
        if !report.is_valid() {
            wrong(None, "the map itself is not valid".to_owned());
        }
        if matches!(scope, Scope::Connected { .. }) {
            match self.canonizer.unrooted(map.subject()) {
                Some(unrooted) if sensed.insert(unrooted.code.clone()) => {
                    tally.sensed = 1;
                    tally.rooted = unrooted.rootings as u64;
                }
                Some(_) => {}
                None => wrong(None, "a connected map has no canonical form".to_owned()),
            }
        }
        try_every_op(&map, |op, outcome, result| match outcome {
            Err(panic) => wrong(Some(op), format!("panicked: {panic}")),
            Ok(StepOutcome::Applied) => {
                tally.applied += 1;
                let report = validate(result.subject(), &Expectation::plane(), Collect::First);
                if let Some(violation) = report.violations().first() {
                    wrong(Some(op), format!("breaks {}: {violation}", violation.rule()));
                } else if !report.is_valid() || !as_promised(op, &before, report.counts()) {
                    wrong(Some(op), format!("makes {:?} of {before:?}", report.counts()));
                } else if scope.takes_in(result.subject()) {
                    let Some(code) = self.canonizer.subdivision(result.subject()) else {
                        return wrong(Some(op), "a map has no canonical form".to_owned());
                    };
                    if seen.insert(code) {
                        self.fresh.push(program.0.iter().copied().chain([op]).collect());
                    }
                }
            }
            Ok(outcome @ (StepOutcome::Refused(_) | StepOutcome::Skipped)) => {
                tally.refused += 1;
                if !same(map.subject(), result.subject()) {
                    wrong(Some(op), format!("{outcome}, but the map is not as it was"));
                }
            }
        });
        self.explored.tallies.entry((before.edges, before.vertices)).or_default().add(&tally);
    }
}

/// Applies every operator with every argument to the map as it is, one at a time, and shows what came of each: the outcome and
/// the map, or how it panics.
fn try_every_op<K: Subject + Clone>(
    map: &Runner<K>,
    mut visit: impl FnMut(Op, Result<StepOutcome, String>, &Runner<K>),
) {
    let mut trial = map.clone();
    for op in every_op(map) {
        let outcome = caught(|| trial.step(op));
        // What a panic leaves behind may be anything.
        let spent = matches!(outcome, Ok(StepOutcome::Applied) | Err(_));
        visit(op, outcome, &trial);
        if spent {
            trial = map.clone();
        }
    }
}

/// Whether the counts changed as the operator says.
fn as_promised(op: Op, before: &Counts, after: &Counts) -> bool {
    let change = |before: usize, after: usize| after.cast_signed() - before.cast_signed();
    let components = change(before.components.unwrap_or(0), after.components.unwrap_or(0));
    let changes = (
        change(before.vertices, after.vertices),
        change(before.edges, after.edges),
        change(before.faces, after.faces),
        components,
    );
    match op {
        Op::AddIsolatedVertex { .. } => changes == (1, 0, 0, 1),
        Op::RemoveIsolatedVertex { .. } => changes == (-1, 0, 0, -1),
        Op::Connect { .. } => changes == (0, 1, 1, 0) || changes == (0, 1, 0, -1),
        Op::RemoveEdge { .. } => changes == (0, -1, -1, 0) || changes == (0, -1, 0, 1),
        Op::SplitEdge { .. } | Op::SplitVertex { .. } => changes == (1, 1, 0, 0),
        Op::JoinEdges { .. } | Op::ContractEdge { .. } => changes == (-1, -1, 0, 0),
        Op::FlipEdge { .. } | Op::MoveInner { .. } => changes == (0, 0, 0, 0),
    }
}

/// Whether two structures say the same of every slot.
fn same<V: View>(one: &V, other: &V) -> bool {
    let slots = |map: &V| (map.vertex_slots(), map.half_edge_slots(), map.boundary_slots(), map.face_slots());
    let (vertices, half_edges, boundaries, faces) = slots(one);
    slots(other) == (vertices, half_edges, boundaries, faces)
        && (0..half_edges).all(|h| {
            let row = |map: &V| {
                let links = || (map.origin(h), map.twin(h), map.next(h), map.prev(h), map.boundary(h));
                map.is_half_edge(h).then(links)
            };
            row(one) == row(other)
        })
        && (0..vertices).all(|v| {
            let row = |map: &V| map.is_vertex(v).then(|| (map.leaving(v), map.isolated(v)));
            row(one) == row(other)
        })
        && (0..boundaries).all(|b| {
            let row = |map: &V| {
                map.is_boundary(b).then(|| (map.boundary_face(b), map.boundary_start(b), map.boundary_place(b)))
            };
            row(one) == row(other)
        })
        && (0..faces).all(|f| {
            let row = |map: &V| map.is_face(f).then(|| (map.outer(f), map.inner_count(f)));
            row(one) == row(other) && (0..one.inner_count(f)).all(|i| one.inner(f, i) == other.inner(f, i))
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::subjects::Planted;

    #[test]
    fn an_operator_that_panics_is_told_of_and_the_others_go_on() {
        const LOOP: &str = "twinedge program 1\nadd_isolated_vertex unbounded\nconnect i0 i0 left\n";
        fn outcomes<const PANICS: bool>() -> Vec<(Op, Result<StepOutcome, String>)> {
            let mut map = Runner::new(Planted::<PANICS>::default());
            map.run(&LOOP.parse().unwrap());
            let mut outcomes = Vec::new();
            try_every_op(&map, |op, outcome, _| outcomes.push((op, outcome)));
            outcomes
        }
        let mut panics = 0;
        for ((op, sound), (same, outcome)) in outcomes::<false>().into_iter().zip(outcomes::<true>()) {
            assert_eq!(op, same);
            if matches!((op, &sound), (Op::MoveInner { .. }, Ok(StepOutcome::Applied))) {
                let told = outcome.unwrap_err();
                assert!(told.starts_with("a planted panic (") && told.contains("planted.rs:"), "{told}");
                panics += 1;
            } else {
                assert_eq!(outcome, sound);
            }
        }
        // The loop can be moved only to the face in which it lies.
        assert_eq!(panics, 1);
    }
}
