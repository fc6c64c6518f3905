//! Changing a program without changing what the rest of it chooses, in any language.
//!
//! An operator chooses by numbers, and these count in lists that hold something else once an earlier operator is gone.
//! Here everything on such a list has a name, that of the operator that put it there, and the numbers follow the names.

use super::choose::Choose;
use alloc::vec::Vec;
use core::fmt::Debug;
use core::ops::Range;

/// The operator that put something on a list, by its place in the program, and which of its things.
pub(crate) type Name = (usize, usize);

/// A sequence of operators.
pub trait Sequence: Clone + PartialEq + Debug + 'static {
    /// Its operators.
    type Op: Clone + PartialEq + Debug + 'static;

    /// The operators of a program.
    fn ops(&self) -> &[Self::Op];

    /// The program of these operators.
    fn from_ops(ops: Vec<Self::Op>) -> Self;

    /// An operator with one argument simplified, in every way there is.
    fn simpler(op: &Self::Op) -> Vec<Self::Op>;
}

/// A language that runs: what shrinking needs of it.
pub trait Scripted: Sequence {
    /// The structure with which programs begin; by default the empty one.
    type Start: Clone + Debug + Default + 'static;

    /// The run of its operators.
    type Stage: Stage<Op = Self::Op, Start = Self::Start>;
}

/// A language of programs: [`Program`](crate::program::Program), for the topology, and with the feature `map` also
#[cfg_attr(feature = "map", doc = "[`EditProgram`](crate::map::program::EditProgram),")]
#[cfg_attr(not(feature = "map"), doc = "`map::program::EditProgram`,")]
/// for the edits of a planar map. No other type can have this trait.
///
/// Each can be [generated](crate::program::Generator), [shrunk](crate::program::shrink()), written down and read.
pub trait Language: Scripted {
    /// The kinds of its operators.
    type Kind: Copy + PartialEq + core::fmt::Debug + 'static;

    /// Every kind, and how often it is chosen unless a [`Generator`](crate::program::Generator) says otherwise.
    const KINDS: &'static [(Self::Kind, u32)];

    /// An operator of this kind, with arguments that the source chooses.
    fn op(kind: Self::Kind, source: &mut impl Choose) -> Self::Op;

    /// The first operator of a generated program if this kind is generated at all: without it there is nothing to be done.
    #[must_use]
    fn first() -> Option<(Self::Kind, Self::Op)> {
        None
    }
}

/// A run of a program, with the names of what is on each list.
pub trait Stage {
    /// The operators that it runs.
    type Op;
    /// The structure with which it begins.
    type Start;

    /// The run before the first operator.
    fn new(start: &Self::Start) -> Self;

    /// The operator with other numbers. `number` is given the names in the list in which each number counts.
    fn rewrite(&self, op: &Self::Op, number: &mut impl FnMut(&[Name], u32) -> u32) -> Self::Op;

    /// Runs an operator.
    fn step(&mut self, op: &Self::Op, place: usize);
}

/// An operator with the names of what it chose, in order of its arguments.
#[derive(Clone, Debug)]
struct Line<O> {
    place: usize,
    op: O,
    chosen: Vec<Option<Name>>,
}

/// A program that remembers what each of its operators chose when it was run, and how each run begins.
pub(super) struct Script<P: Scripted> {
    lines: Vec<Line<P::Op>>,
    start: P::Start,
}

impl<P: Scripted> Script<P> {
    /// Runs a program to see what it chooses.
    pub(super) fn of(program: &P, start: &P::Start) -> Self {
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

    /// The program without some operators.
    pub(super) fn without(&self, places: &Range<usize>) -> P {
        self.play(self.lines.iter().filter(|line| !places.contains(&line.place)).cloned())
    }

    /// The program with another operator in one place.
    pub(super) fn with(&self, place: usize, op: &P::Op) -> P {
        let other = |line: &Line<P::Op>| {
            if line.place == place { Line { place, op: op.clone(), chosen: Vec::new() } } else { line.clone() }
        };
        self.play(self.lines.iter().map(other))
    }

    /// Writes down a program that chooses what the lines did, as far as it is still there.
    fn play(&self, lines: impl Iterator<Item = Line<P::Op>>) -> P {
        let mut stage = P::Stage::new(&self.start);
        let rewrite = |line: Line<P::Op>| {
            let mut chosen = line.chosen.into_iter();
            let op = stage.rewrite(&line.op, &mut |names, k| {
                let name = chosen.next().flatten();
                let position = name.and_then(|name| names.iter().position(|other| *other == name));
                // A record that is gone has no number: any number that there is will do.
                let position = position.or_else(|| (k as usize).checked_rem(names.len()));
                position.and_then(|position| u32::try_from(position).ok()).unwrap_or(k)
            });
            stage.step(&op, line.place);
            op
        };
        P::from_ops(lines.map(rewrite).collect())
    }
}

/// Keeps the names of what stayed on a list, in order, and names what came to its end.
pub(crate) fn follow<T: PartialEq>(names: &mut Vec<Name>, before: &[T], after: &[T], place: usize) {
    let mut stayed = after.iter().peekable();
    let mut left = before.iter();
    names.retain(|_| left.next().is_some_and(|old| stayed.next_if_eq(&old).is_some()));
    extend(names, after.len(), place);
}

/// Names what came to the end of a list.
pub(crate) fn extend(names: &mut Vec<Name>, len: usize, place: usize) {
    let more = len.saturating_sub(names.len());
    names.extend((0..more).map(|which| (place, which)));
}
