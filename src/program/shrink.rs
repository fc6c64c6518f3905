//! Shrinks failing programs without changing the choices of the remaining operators.
//!
//! Operators choose by numbers in lists, and dropping an earlier operator changes these lists. So every list entry is named after
//! the operator that added it, and numbers follow the names.

use super::language::{Language, Name, Stage};
use alloc::vec::Vec;
use core::ops::Range;

/// Shrinks a program as long as it fails: drops ever smaller runs of operators, then simplifies the rest. If `program` fails, so
/// does the result, but it passes when any one operator is dropped or simplified.
///
/// Implements Zeller and Hildebrandt's delta debugging (*Simplifying and Isolating Failure-Inducing Input*, 2002), with one
/// addition: the remaining operators keep choosing the same half-edges and vertices although the lists have changed. Every step
/// makes the program smaller, so the function terminates.
///
/// For programs with a non-empty start, such as a mesh, use [`Generator::shrink`](crate::program::Generator::shrink) or
/// [`Conformance::run_and_shrink`](crate::program::conformance::Conformance::run_and_shrink).
pub fn shrink<P: Language>(program: &P, fails: impl FnMut(&P) -> bool) -> P {
    shrink_from(program, &P::Start::default(), fails)
}

pub(in crate::program) fn shrink_from<P: Language>(
    program: &P,
    start: &P::Start,
    mut fails: impl FnMut(&P) -> bool,
) -> P {
    let mut smallest = program.clone();
    while let Some(smaller) = candidates_from(&smallest, start).find(&mut fails) {
        smallest = smaller;
    }
    smallest
}

/// Returns slightly smaller programs, the smallest first.
///
/// `quickcheck` and `proptest` shrink with these candidates; [`shrink`] repeats the step as often as it helps. Finding each takes
/// a run of the program, on a [`PointerModel`](crate::program::PointerModel) or, for edits, a planar map.
pub fn candidates<P: Language>(program: &P) -> impl Iterator<Item = P> + use<P> {
    candidates_from(program, &P::Start::default())
}

pub(super) fn candidates_from<P: Language>(program: &P, start: &P::Start) -> impl Iterator<Item = P> + use<P> {
    let script: Script<P> = Script::of(program, start);
    let ops = program.ops().to_vec();
    let count = ops.len();
    let lengths = core::iter::successors(Some(count), |length| (*length > 1).then(|| length.div_ceil(2)));
    let lengths = lengths.filter(|length| *length > 0);
    let dropped = lengths.flat_map(move |length| {
        (0..count).step_by(length).map(move |begin| Edit::Drop(begin..(begin + length).min(count)))
    });
    let simpler = |(place, op): (usize, &P::Op)| P::simpler(op).into_iter().map(move |op| Edit::Replace(place, op));
    let simpler: Vec<Edit<P::Op>> = ops.iter().enumerate().flat_map(simpler).collect();
    // Rewriting reduces numbers beyond the ends of their lists at once.
    let anew = Some(script.without(&(0..0))).filter(|anew| anew != program);
    let edited = dropped.chain(simpler).flat_map(move |edit| {
        // On a subject that does less than `Dcel`, the same numbers may preserve more choices than the same names.
        let mut plain = ops.clone();
        let followed = match edit {
            Edit::Drop(places) => {
                plain.drain(places.clone());
                script.without(&places)
            }
            Edit::Replace(place, op) => {
                plain[place] = op.clone();
                script.with(place, &op)
            }
        };
        let plain = Some(P::from_ops(plain)).filter(|plain| *plain != followed);
        core::iter::once(followed).chain(plain)
    });
    anew.into_iter().chain(edited)
}

enum Edit<O> {
    Drop(Range<usize>),
    Replace(usize, O),
}

/// An operator with the names of its choices, in order of its arguments.
#[derive(Clone, Debug)]
struct Line<O> {
    place: usize,
    op: O,
    chosen: Vec<Option<Name>>,
}

/// A program with the names of the choices that its operators made when it ran, and its start.
struct Script<P: Language> {
    lines: Vec<Line<P::Op>>,
    start: P::Start,
}

impl<P: Language> Script<P> {
    fn of(program: &P, start: &P::Start) -> Self {
        let mut stage = P::Stage::new(start);
        let line = |(place, op): (usize, &P::Op)| {
            let mut chosen = Vec::new();
            stage.rewrite(op, &mut |names, k| {
                chosen.push((k as usize).checked_rem(names.len()).map(|position| names[position]));
                k
            });
            stage.step(op, place);
            Line { place, op: op.clone(), chosen }
        };
        Self { lines: program.ops().iter().enumerate().map(line).collect(), start: start.clone() }
    }

    fn without(&self, places: &Range<usize>) -> P {
        self.play(self.lines.iter().filter(|line| !places.contains(&line.place)).cloned())
    }

    fn with(&self, place: usize, op: &P::Op) -> P {
        let other = |line: &Line<P::Op>| {
            if line.place == place { Line { place, op: op.clone(), chosen: Vec::new() } } else { line.clone() }
        };
        self.play(self.lines.iter().map(other))
    }

    /// Writes a program that makes the choices of the lines, as far as they still exist.
    fn play(&self, lines: impl Iterator<Item = Line<P::Op>>) -> P {
        let mut stage = P::Stage::new(&self.start);
        let rewrite = |line: Line<P::Op>| {
            let mut chosen = line.chosen.into_iter();
            let op = stage.rewrite(&line.op, &mut |names, k| {
                let name = chosen.next().flatten();
                let position = name.and_then(|name| names.iter().position(|other| *other == name));
                // A removed record has no number: any valid number will do.
                let position = position.or_else(|| (k as usize).checked_rem(names.len()));
                position.and_then(|position| u32::try_from(position).ok()).unwrap_or(k)
            });
            stage.step(&op, line.place);
            op
        };
        P::from_ops(lines.map(rewrite).collect())
    }
}

/// Keeps the names of entries still on the list, in order, and names the new entries at its end.
pub fn follow<T: PartialEq>(names: &mut Vec<Name>, before: &[T], after: &[T], place: usize) {
    let mut stayed = after.iter().peekable();
    let mut left = before.iter();
    names.retain(|_| left.next().is_some_and(|old| stayed.next_if_eq(&old).is_some()));
    extend(names, after.len(), place);
}

/// Names the new entries at the end of a list.
pub fn extend(names: &mut Vec<Name>, len: usize, place: usize) {
    let more = len.saturating_sub(names.len());
    names.extend((0..more).map(|which| (place, which)));
}
