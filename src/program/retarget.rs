//! Changing a program without changing what the rest of it chooses.
//!
//! An operator chooses by numbers, and these count in lists that hold something else once an earlier operator is gone.
//! Here every half-edge and vertex has a name, that of the operator that made it, and the numbers follow the names.

use super::op::{CornerPick, FacePick, HalfEdgePick, InnerPick, Op, Program, SecondPick, VertexPick};
use super::resolve::{Choose, Fit};
use super::runner::Runner;
use super::table::operators;
use crate::dcel::{Dcel, Side, Turn};
use alloc::vec::Vec;
use core::iter::repeat;

/// The operator that put something on a list, by its place in the program, and which of its things.
type Name = (usize, usize);

/// An operator with the names of what it chose, in order of its arguments.
#[derive(Clone, Copy, Debug)]
struct Line {
    place: usize,
    op: Op,
    chosen: [Option<Name>; 3],
}

/// A program that remembers what each of its operators chose when it was run.
#[derive(Clone, Debug)]
pub(super) struct Script(Vec<Line>);

impl Script {
    /// Runs a program to see what it chooses.
    pub(super) fn of(program: &Program) -> Self {
        let mut stage = Stage::new();
        let line = |(place, op): (usize, &Op)| {
            let mut chosen = [None; 3];
            let mut slots = chosen.iter_mut();
            stage.rewrite(*op, &mut |names, k| {
                let name = usize::from(k).checked_rem(names.len()).map(|position| names[position]);
                if let Some(slot) = slots.next() {
                    *slot = name;
                }
                k
            });
            stage.step(*op, place);
            Line { place, op: *op, chosen }
        };
        Self(program.0.iter().enumerate().map(line).collect())
    }

    /// The program without some operators.
    pub(super) fn without(&self, places: &core::ops::Range<usize>) -> Program {
        Self::play(self.0.iter().copied().filter(|line| !places.contains(&line.place)))
    }

    /// The program with another operator in one place.
    pub(super) fn with(&self, place: usize, op: Op) -> Program {
        let other = Line { place, op, chosen: [None; 3] };
        Self::play(self.0.iter().map(|line| if line.place == place { other } else { *line }))
    }

    /// Writes down a program that chooses what the lines did, as far as it is still there.
    fn play(lines: impl Iterator<Item = Line>) -> Program {
        let mut stage = Stage::new();
        let rewrite = |line: Line| {
            let mut chosen = line.chosen.into_iter().chain(repeat(None));
            let op = stage.rewrite(line.op, &mut |names, k| {
                let name = chosen.next().flatten();
                let position = name.and_then(|name| names.iter().position(|other| *other == name));
                position.and_then(|position| u16::try_from(position).ok()).unwrap_or(k)
            });
            stage.step(op, line.place);
            op
        };
        lines.map(rewrite).collect()
    }
}

/// A runner, and beside each of its lists the names of what is on it.
struct Stage {
    runner: Runner<Dcel>,
    half_edges: Vec<Name>,
    isolated: Vec<Name>,
    retired_half_edges: Vec<Name>,
    retired_vertices: Vec<Name>,
    retired_faces: Vec<Name>,
}

impl Stage {
    fn new() -> Self {
        Self {
            runner: Runner::new(Dcel::new()),
            half_edges: Vec::new(),
            isolated: Vec::new(),
            retired_half_edges: Vec::new(),
            retired_vertices: Vec::new(),
            retired_faces: Vec::new(),
        }
    }

    fn step(&mut self, op: Op, place: usize) {
        let half_edges = self.runner.half_edges().to_vec();
        let isolated = self.runner.isolated().to_vec();
        self.runner.step(op);
        follow(&mut self.half_edges, &half_edges, self.runner.half_edges(), place);
        follow(&mut self.isolated, &isolated, self.runner.isolated(), place);
        extend(&mut self.retired_half_edges, self.runner.retired_half_edges().len(), place);
        extend(&mut self.retired_vertices, self.runner.retired_vertices().len(), place);
        extend(&mut self.retired_faces, self.runner.retired_faces().len(), place);
    }
}

macro_rules! define_rewrite {
    ($($variant:ident $method:ident $share:literal {
        changes [$($change:expr),+]
        $($arg:ident: $pick:ty => $handle:ty, $depends:tt;)*
    })*) => {
        impl Stage {
            /// The operator with other numbers. `number` is given the names in the list in which each number counts.
            fn rewrite(&self, op: Op, number: &mut impl FnMut(&[Name], u16) -> u16) -> Op {
                match op {
                    $(Op::$variant { $($arg),* } => {
                        $(let $arg = $arg.renumber(self, $depends, number);)*
                        Op::$variant { $($arg),* }
                    })*
                }
            }
        }
    };
}
operators!(define_rewrite);

/// An argument with other numbers, after those that it depends on.
trait Renumber: Choose {
    fn renumber(
        self,
        stage: &Stage,
        context: Self::Context<CornerPick>,
        number: &mut impl FnMut(&[Name], u16) -> u16,
    ) -> Self;
}

impl Renumber for HalfEdgePick {
    fn renumber(self, stage: &Stage, (): (), number: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        match self {
            Self::Live(k) => Self::Live(number(&stage.half_edges, k)),
            Self::Retired(k) => Self::Retired(number(&stage.retired_half_edges, k)),
        }
    }
}

impl Renumber for VertexPick {
    fn renumber(self, stage: &Stage, (): (), number: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        match self {
            Self::Isolated(k) => Self::Isolated(number(&stage.isolated, k)),
            Self::OriginOf(k) => Self::OriginOf(number(&stage.half_edges, k)),
            Self::Retired(k) => Self::Retired(number(&stage.retired_vertices, k)),
        }
    }
}

impl Renumber for CornerPick {
    fn renumber(self, stage: &Stage, (): (), number: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        match self {
            Self::At(pick) => Self::At(pick.renumber(stage, (), number)),
            Self::Isolated(pick) => Self::Isolated(pick.renumber(stage, (), number)),
        }
    }
}

impl Renumber for SecondPick {
    fn renumber(
        self,
        stage: &Stage,
        (from, fit): (CornerPick, Fit),
        number: &mut impl FnMut(&[Name], u16) -> u16,
    ) -> Self {
        match self {
            Self::Any(pick) => Self::Any(pick.renumber(stage, (), number)),
            Self::Fitting(k) => {
                let from = from.choose(&stage.runner, ());
                let places = from.and_then(|from| stage.runner.fitting(from, fit)).unwrap_or_default();
                let names = stage.half_edges.iter().chain(&stage.isolated).enumerate();
                let names: Vec<Name> =
                    names.filter(|(place, _)| places.binary_search(place).is_ok()).map(|(_, name)| *name).collect();
                Self::Fitting(number(&names, k))
            }
        }
    }
}

impl Renumber for InnerPick {
    fn renumber(self, stage: &Stage, _: CornerPick, number: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        Self { also: self.also.map(|pick| pick.renumber(stage, (), number)), ..self }
    }
}

impl Renumber for FacePick {
    fn renumber(self, stage: &Stage, (): (), number: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        match self {
            Self::Unbounded => Self::Unbounded,
            Self::Of(pick) => Self::Of(pick.renumber(stage, (), number)),
            Self::Retired(k) => Self::Retired(number(&stage.retired_faces, k)),
        }
    }
}

impl Renumber for Side {
    fn renumber(self, _: &Stage, (): (), _: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        self
    }
}

impl Renumber for Turn {
    fn renumber(self, _: &Stage, (): (), _: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        self
    }
}

/// Keeps the names of what stayed on a list, in order, and names what came to its end.
fn follow<T: PartialEq>(names: &mut Vec<Name>, before: &[T], after: &[T], place: usize) {
    let mut stayed = after.iter().peekable();
    let mut left = before.iter();
    names.retain(|_| left.next().is_some_and(|old| stayed.next_if_eq(&old).is_some()));
    extend(names, after.len(), place);
}

/// Names what came to the end of a list.
fn extend(names: &mut Vec<Name>, len: usize, place: usize) {
    let more = len.saturating_sub(names.len());
    names.extend((0..more).map(|which| (place, which)));
}
