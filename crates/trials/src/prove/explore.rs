//! Trying every operator with every argument on every map of a scope.

use super::grow::{Codes, Exploration, Size, grow, play};
use crate::canonical::Canonizer;
use crate::census::Scope;
use crate::run::Run;
use crate::structure::Structure;
use crate::verdict::judge;
use twinedge::program::panics::catch;
use twinedge::program::{Op, Program, Refusal, Runner, StepOutcome, Subject, every_op};
use twinedge::validate::{Counts, Report, View};

/// Explores all maps of a scope that belong to this part of the work. After each applied operator, the map is validated and its
/// counts are compared with those before; after each refused one, the map must be unchanged, link by link.
pub(super) fn explore<K: Subject + Clone>(
    structure: &Structure<K>,
    scope: Scope,
    run: &Run<'_>,
    maps: &str,
) -> Exploration {
    let grown = grow(structure, scope, run, maps);
    let stage = format!("operators on {maps}");
    let worker = || Worker {
        structure,
        scope,
        codes: &grown.codes,
        canonizer: Canonizer::new(),
        explored: Exploration::default(),
    };
    let workers = run.each(&stage, grown.maps.len(), worker, |worker, number| worker.visit(&grown.maps[number]));
    let found: Vec<Exploration> = workers.into_iter().map(|worker| worker.explored).collect();
    let mut explored = grown.explored;
    for found in found {
        explored.add(found);
    }
    explored
}

struct Worker<'a, K> {
    structure: &'a Structure<K>,
    scope: Scope,
    codes: &'a Codes,
    canonizer: Canonizer,
    explored: Exploration,
}

enum Trial {
    /// Applied, with the report on the map after it.
    Applied(Report),
    /// Refused or skipped, with true if the map is unchanged.
    Refused(StepOutcome, bool),
}

impl<K: Subject + Clone> Worker<'_, K> {
    fn visit(&mut self, program: &Program) {
        let validated = play(self.structure, program).and_then(|map| {
            let report = catch(|| judge(map.subject(), &self.structure.expectation()))?;
            Ok((map, report))
        });
        let (map, report) = match validated {
            Ok(validated) => validated,
            Err(panic) => return self.explored.note((0, 0), program, None, format!("panicked: {panic}")),
        };
        let before = *report.counts();
        let size = (before.edges, before.vertices);
        if !report.is_valid() {
            self.explored.note(size, program, None, "the map itself is not valid".to_owned());
        }
        self.explored.tally(size).maps += 1;
        let expectation = self.structure.expectation();
        try_every_op(
            &map,
            |outcome, result| match outcome {
                StepOutcome::Applied => Trial::Applied(judge(result.subject(), &expectation)),
                outcome => Trial::Refused(outcome, same(map.subject(), result.subject())),
            },
            |op, tried, result| self.judge(program, op, &before, tried, result),
        );
    }

    fn judge(&mut self, program: &Program, op: Op, before: &Counts, tried: Result<Trial, String>, result: &Runner<K>) {
        let size: Size = (before.edges, before.vertices);
        let wrong = match tried {
            Err(panic) => Some(format!("panicked: {panic}")),
            Ok(Trial::Applied(report)) => {
                self.explored.tally(size).applied += 1;
                self.after(op, before, &report, result)
            }
            Ok(Trial::Refused(outcome, is_same)) => {
                self.explored.tally(size).refused += 1;
                if outcome == StepOutcome::Refused(Refusal::Unsupported) {
                    self.explored.unsupported.insert(op.name());
                }
                (!is_same).then(|| format!("{outcome}, but the map is not as it was"))
            }
        };
        if let Some(message) = wrong {
            self.explored.note(size, program, Some(op), message);
        }
    }

    fn after(&mut self, op: Op, before: &Counts, report: &Report, result: &Runner<K>) -> Option<String> {
        if let Some(violation) = report.violations().first() {
            return Some(format!("breaks {violation}"));
        }
        let counts = report.counts();
        if !report.is_valid() || !as_promised(op, before, counts) {
            return Some(format!("makes {counts:?} of {before:?}"));
        }
        if !is_in_scope(self.scope, counts) {
            return None;
        }
        match catch(|| self.canonizer.subdivision(result.subject())) {
            Ok(Some(code)) if self.codes.contains(&code) => None,
            Ok(Some(_)) => Some("makes a map that does not grow from the first one".to_owned()),
            Ok(None) => Some("makes a map without canonical form".to_owned()),
            Err(panic) => Some(format!("panicked: {panic}")),
        }
    }
}

/// Returns true if a valid map with these counts is in the scope.
fn is_in_scope(scope: Scope, counts: &Counts) -> bool {
    match scope {
        Scope::Connected { edges } => counts.edges <= edges && counts.components == Some(1),
        Scope::Subdivisions { edges, vertices } => counts.edges <= edges && counts.vertices <= vertices,
    }
}

/// Applies every operator with every argument to the given map, one at a time. `look` examines each result; a panic of the
/// operator or of `look` is caught. `visit` receives the result.
fn try_every_op<K: Subject + Clone, T>(
    map: &Runner<K>,
    look: impl Fn(StepOutcome, &Runner<K>) -> T,
    mut visit: impl FnMut(Op, Result<T, String>, &Runner<K>),
) {
    let mut trial = map.clone();
    for op in every_op(map) {
        let mut refused = false;
        let looked = catch(|| {
            let outcome = trial.step(op);
            refused = outcome != StepOutcome::Applied;
            look(outcome, &trial)
        });
        // A panic may leave the map in any state.
        let is_spent = looked.is_err() || !refused;
        visit(op, looked, &trial);
        if is_spent {
            trial = map.clone();
        }
    }
}

/// Returns true if the counts changed as the operator promises.
fn as_promised(op: Op, before: &Counts, after: &Counts) -> bool {
    let change = |before: usize, after: usize| after.cast_signed() - before.cast_signed();
    let components = change(before.components.unwrap_or(0), after.components.unwrap_or(0));
    let now = (
        change(before.vertices, after.vertices),
        change(before.edges, after.edges),
        change(before.faces, after.faces),
        components,
    );
    op.kind().changes().iter().any(|promised| {
        let of = |count: i8| isize::from(count);
        now == (of(promised.vertices), of(promised.edges), of(promised.faces), of(promised.components))
    })
}

/// Returns true if two structures agree on every slot.
fn same<V: View>(one: &V, other: &V) -> bool {
    let slots = |map: &V| (map.vertex_slots(), map.half_edge_slots(), map.boundary_slots(), map.face_slots());
    let (vertices, half_edges, boundaries, faces) = slots(one);
    slots(other) == (vertices, half_edges, boundaries, faces)
        && (0..half_edges).all(|h| {
            let row = |map: &V| {
                let links = || (map.origin(h), map.twin(h), map.next(h), map.prev(h), map.boundary(h), map.face(h));
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
            let row = |map: &V| map.is_face(f).then(|| (map.outer(f), map.outer_half_edge(f), map.inner_count(f)));
            let entry = |map: &V, i| (map.inner(f, i), map.inner_start(f, i));
            row(one) == row(other)
                && (!one.is_face(f) || (0..one.inner_count(f)).all(|i| entry(one, i) == entry(other, i)))
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planted::Planted;

    #[test]
    fn an_operator_that_panics_is_reported_and_the_others_are_tried() {
        const LOOP: &str = "twinedge program 1\nadd_isolated_vertex unbounded\nconnect i0 i0 left\n";
        fn outcomes<const PANICS: bool>() -> Vec<(Op, Result<StepOutcome, String>)> {
            let mut map = Runner::new(Planted::<PANICS>::default());
            map.run(&LOOP.parse().unwrap());
            let mut outcomes = Vec::new();
            try_every_op(&map, |outcome, _| outcome, |op, outcome, _| outcomes.push((op, outcome)));
            outcomes
        }
        let mut panics = 0;
        for ((op, sound), (same, outcome)) in outcomes::<false>().into_iter().zip(outcomes::<true>()) {
            assert_eq!(op, same);
            if matches!((op, &sound), (Op::MoveInner { .. }, Ok(StepOutcome::Applied))) {
                let said = outcome.unwrap_err();
                assert!(said.starts_with("a planted panic (") && said.contains("planted.rs:"), "{said}");
                panics += 1;
            } else {
                assert_eq!(outcome, sound);
            }
        }
        // The loop can be moved only to the face in which it lies.
        assert_eq!(panics, 1);
    }
}
