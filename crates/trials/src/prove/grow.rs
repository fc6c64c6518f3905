//! Growing all maps of a scope, from the smallest one, by the operators that add something.

use super::outcome::Finding;
use crate::canonical::{Canonizer, Code};
use crate::census::Scope;
use crate::rows::{MOST_FINDINGS, add_findings};
use crate::run::Run;
use crate::shard::Shard;
use crate::structure::Structure;
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::hash::{BuildHasher, RandomState};
use std::sync::{Mutex, MutexGuard, PoisonError};
use twinedge::program::panics::catch;
use twinedge::program::{Op, Program, Runner, StepOutcome, Subject, every_op};

/// Canonical forms, shared by all threads.
#[derive(Default)]
pub(super) struct Codes {
    hasher: RandomState,
    sets: [Mutex<HashSet<Code>>; 32],
}

impl Codes {
    fn set(&self, code: &Code) -> MutexGuard<'_, HashSet<Code>> {
        let set = &self.sets[self.hasher.hash_one(code) as usize % self.sets.len()];
        set.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn insert(&self, code: Code) -> bool {
        self.set(&code).insert(code)
    }

    pub(super) fn contains(&self, code: &Code) -> bool {
        self.set(code).contains(code)
    }
}

#[derive(Default)]
pub(super) struct Growth {
    pub(super) codes: Codes,
    pub(super) maps: Vec<Program>,
    /// The maps without root of this part of the work, and the faults.
    pub(super) explored: Exploration,
}

/// A map that was first found here.
struct Found {
    program: Program,
    size: Size,
    is_ours: bool,
}

#[derive(Default)]
struct Worker {
    canonizer: Canonizer,
    explored: Exploration,
    fresh: Vec<Found>,
}

struct SharedState<'a> {
    scope: Scope,
    shard: Shard,
    codes: &'a Codes,
    unrooted: Codes,
}

/// Runs a program on a new structure. If the structure panics, returns the message.
pub(super) fn play<K: Subject>(structure: &Structure<K>, program: &Program) -> Result<Runner<K>, String> {
    catch(|| {
        let mut runner = Runner::new(structure.make());
        runner.run(program);
        runner
    })
}

/// Returns the size of a map of the scope after an operator that adds something, if the result is in the scope.
fn grown_by(scope: Scope, op: Op, (edges, vertices): Size) -> Option<Size> {
    let size = match op {
        Op::AddIsolatedVertex { .. } => (edges, vertices + 1),
        Op::Connect { .. } => (edges + 1, vertices),
        Op::SplitVertex { .. } => (edges + 1, vertices + 1),
        _ => return None,
    };
    let is_in_scope = match scope {
        Scope::Connected { edges } => size.0 <= edges && !matches!(op, Op::AddIsolatedVertex { .. }),
        Scope::Subdivisions { edges, vertices } => size.0 <= edges && size.1 <= vertices,
    };
    is_in_scope.then_some(size)
}

/// Grows all maps of a scope. All parts of the work grow all of them, which takes about a tenth of the time for trying every
/// operator on them: nine tenths of the maps have the largest number of edges, and are not grown further.
pub(super) fn grow<K: Subject + Clone>(structure: &Structure<K>, scope: Scope, run: &Run<'_>, maps: &str) -> Growth {
    let mut grown = Growth::default();
    let shared = SharedState { scope, shard: run.part(), codes: &grown.codes, unrooted: Codes::default() };
    let mut first = Worker::default();
    let (start, size) = (scope.start(), start_size(scope));
    match play(structure, &start) {
        Ok(map) if !first.meet(&shared, &map, &start, size) => {
            first.explored.note(size, &start, None, "the first map has no canonical form".to_owned());
        }
        Ok(_) => {}
        Err(panic) => first.explored.note(size, &start, None, format!("panicked: {panic}")),
    }
    let mut workers = vec![first];
    let (mut ours, mut explored) = (Vec::new(), Exploration::default());
    for step in 0.. {
        let mut generation = Vec::new();
        for worker in workers {
            explored.add(worker.explored);
            for found in worker.fresh {
                if found.is_ours {
                    ours.push(found.program.clone());
                }
                generation.push((found.program, found.size));
            }
        }
        generation.retain(|(_, (edges, vertices))| match scope {
            Scope::Connected { edges: most } => *edges < most,
            Scope::Subdivisions { edges: most, vertices: most_vertices } => *edges < most || *vertices < most_vertices,
        });
        if generation.is_empty() || run.is_stopped() {
            break;
        }
        let stage = format!("growing {maps}, step {step}");
        workers = run.each(&stage, generation.len(), Worker::default, |worker, number| {
            let (program, size) = &generation[number];
            worker.grow(structure, &shared, program, *size);
        });
    }
    grown.maps = ours;
    grown.explored = explored;
    grown
}

const fn start_size(scope: Scope) -> Size {
    match scope {
        Scope::Connected { .. } => (0, 1),
        Scope::Subdivisions { .. } => (0, 0),
    }
}

impl Worker {
    /// Applies every operator that adds something. One that panics is skipped here: it is reported when every operator is tried.
    fn grow<K: Subject + Clone>(
        &mut self,
        structure: &Structure<K>,
        shared: &SharedState<'_>,
        program: &Program,
        size: Size,
    ) {
        let Ok(map) = play(structure, program) else { return };
        for op in every_op(&map) {
            let Some(size) = grown_by(shared.scope, op, size) else { continue };
            let mut trial = map.clone();
            if catch(|| trial.step(op)) == Ok(StepOutcome::Applied) {
                let program = || program.0.iter().copied().chain([op]).collect();
                self.meet_as(shared, &trial, program, size);
            }
        }
    }

    fn meet<K: Subject>(&mut self, shared: &SharedState<'_>, map: &Runner<K>, program: &Program, size: Size) -> bool {
        self.meet_as(shared, map, || program.clone(), size)
    }

    /// Keeps a map if it is new. Returns whether it has a canonical form.
    fn meet_as<K: Subject>(
        &mut self,
        shared: &SharedState<'_>,
        map: &Runner<K>,
        program: impl FnOnce() -> Program,
        size: Size,
    ) -> bool {
        let Ok(Some(code)) = catch(|| self.canonizer.subdivision(map.subject())) else { return false };
        let is_ours = shared.shard.has_name(code.as_bytes());
        if !shared.codes.insert(code) {
            return true;
        }
        let program = program();
        if matches!(shared.scope, Scope::Connected { .. }) {
            self.count_unrooted(shared, map, &program, size, is_ours);
        }
        self.fresh.push(Found { program, size, is_ours });
        true
    }

    /// Counts a connected map without root, in the part of the work to which its own canonical form belongs: maps that differ
    /// only in the outside may belong to different parts.
    fn count_unrooted<K: Subject>(
        &mut self,
        shared: &SharedState<'_>,
        map: &Runner<K>,
        program: &Program,
        size: Size,
        is_ours: bool,
    ) {
        match catch(|| self.canonizer.unrooted(map.subject())) {
            Ok(Some(unrooted)) => {
                let rootings = unrooted.rootings as u64;
                if shared.shard.has_name(unrooted.code.as_bytes()) && shared.unrooted.insert(unrooted.code) {
                    let tally = self.explored.tally(size);
                    tally.sensed += 1;
                    tally.rooted += rootings;
                }
            }
            _ if is_ours => {
                self.explored.note(size, program, None, "a connected map has no canonical form".to_owned());
            }
            _ => {}
        }
    }
}

pub(super) type Size = (usize, usize);

#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    /// Distinct maps, by their canonical form.
    pub(super) maps: u64,
    pub(super) applied: u64,
    pub(super) refused: u64,
    /// Distinct maps when no face is distinguished as the outside. Of connected maps only.
    pub(super) sensed: u64,
    pub(super) rooted: u64,
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

#[derive(Debug, Default)]
pub(super) struct Exploration {
    pub(super) tallies: BTreeMap<Size, Tally>,
    /// The operators that were refused as unsupported.
    pub(super) unsupported: BTreeSet<&'static str>,
    pub(super) findings: Vec<Finding>,
}

impl Exploration {
    pub(super) fn tally(&mut self, size: Size) -> &mut Tally {
        self.tallies.entry(size).or_default()
    }

    /// Counts a fault on a map of this size, made by a program, with an operator or without.
    pub(super) fn note(&mut self, size: Size, program: &Program, op: Option<Op>, message: String) {
        self.tally(size).violations += 1;
        if self.findings.len() < MOST_FINDINGS {
            let program = program.0.iter().copied().chain(op).collect::<Program>();
            let operator = op.map(|op| op.to_string());
            self.findings.push(Finding { program: program.to_string(), operator, message });
        }
    }

    pub(super) fn add(&mut self, other: Self) {
        for (size, tally) in other.tallies {
            self.tally(size).add(&tally);
        }
        self.unsupported.extend(other.unsupported);
        add_findings(&mut self.findings, &other.findings);
    }
}
