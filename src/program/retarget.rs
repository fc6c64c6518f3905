//! Changing a program without changing what the rest of it chooses.
//!
//! An operator chooses by numbers, and these count in lists that hold something else once an earlier operator is gone.
//! Here every half-edge and vertex has a name, that of the operator that made it, and the numbers follow the names.

use super::interpret::{Fit, Runner};
use super::op::{CornerPick, FacePick, HalfEdgePick, InnerPick, Op, Program, SecondPick, VertexPick};
use super::rotation_system::RotationSystem;
use super::subject::Corner;
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
    runner: Runner<RotationSystem>,
    half_edges: Vec<Name>,
    isolated: Vec<Name>,
    retired_half_edges: Vec<Name>,
    retired_vertices: Vec<Name>,
    retired_faces: Vec<Name>,
}

impl Stage {
    fn new() -> Self {
        Self {
            runner: Runner::new(RotationSystem::new()),
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

    /// The operator with other numbers. `number` is given the names in the list in which each number counts.
    fn rewrite(&self, op: Op, number: &mut impl FnMut(&[Name], u16) -> u16) -> Op {
        match op {
            Op::AddIsolatedVertex { face } => Op::AddIsolatedVertex { face: self.face(face, number) },
            Op::RemoveIsolatedVertex { vertex } => Op::RemoveIsolatedVertex { vertex: self.vertex(vertex, number) },
            Op::Connect { from, to, new_face, inner } => {
                let from = self.corner(from, number);
                let to = self.second(from, to, Fit::Face, number);
                let also = inner.also.map(|pick| self.corner(pick, number));
                Op::Connect { from, to, new_face, inner: InnerPick { also, ..inner } }
            }
            Op::RemoveEdge { half_edge } => Op::RemoveEdge { half_edge: self.half_edge(half_edge, number) },
            Op::SplitEdge { half_edge } => Op::SplitEdge { half_edge: self.half_edge(half_edge, number) },
            Op::JoinEdges { half_edge } => Op::JoinEdges { half_edge: self.half_edge(half_edge, number) },
            Op::SplitVertex { from, to } => {
                let from = self.corner(from, number);
                Op::SplitVertex { from, to: self.second(from, to, Fit::Vertex, number) }
            }
            Op::ContractEdge { half_edge } => Op::ContractEdge { half_edge: self.half_edge(half_edge, number) },
            Op::FlipEdge { half_edge, turn } => Op::FlipEdge { half_edge: self.half_edge(half_edge, number), turn },
            Op::MoveInner { inner, face } => {
                let inner = self.corner(inner, number);
                Op::MoveInner { inner, face: self.face(face, number) }
            }
        }
    }

    fn half_edge(&self, pick: HalfEdgePick, number: &mut impl FnMut(&[Name], u16) -> u16) -> HalfEdgePick {
        match pick {
            HalfEdgePick::Live(k) => HalfEdgePick::Live(number(&self.half_edges, k)),
            HalfEdgePick::Retired(k) => HalfEdgePick::Retired(number(&self.retired_half_edges, k)),
        }
    }

    fn vertex(&self, pick: VertexPick, number: &mut impl FnMut(&[Name], u16) -> u16) -> VertexPick {
        match pick {
            VertexPick::Isolated(k) => VertexPick::Isolated(number(&self.isolated, k)),
            VertexPick::OriginOf(k) => VertexPick::OriginOf(number(&self.half_edges, k)),
            VertexPick::Retired(k) => VertexPick::Retired(number(&self.retired_vertices, k)),
        }
    }

    fn corner(&self, pick: CornerPick, number: &mut impl FnMut(&[Name], u16) -> u16) -> CornerPick {
        match pick {
            Corner::At(pick) => Corner::At(self.half_edge(pick, number)),
            Corner::Isolated(pick) => Corner::Isolated(self.vertex(pick, number)),
        }
    }

    fn second(
        &self,
        from: CornerPick,
        pick: SecondPick,
        fit: Fit,
        number: &mut impl FnMut(&[Name], u16) -> u16,
    ) -> SecondPick {
        match pick {
            SecondPick::Any(pick) => SecondPick::Any(self.corner(pick, number)),
            SecondPick::Fitting(k) => {
                let places =
                    self.runner.corner(from).and_then(|from| self.runner.fitting(from, fit)).unwrap_or_default();
                let names = self.half_edges.iter().chain(&self.isolated).enumerate();
                let names: Vec<Name> =
                    names.filter(|(place, _)| places.binary_search(place).is_ok()).map(|(_, name)| *name).collect();
                SecondPick::Fitting(number(&names, k))
            }
        }
    }

    fn face(&self, pick: FacePick, number: &mut impl FnMut(&[Name], u16) -> u16) -> FacePick {
        match pick {
            FacePick::Unbounded => FacePick::Unbounded,
            FacePick::Of(pick) => FacePick::Of(self.corner(pick, number)),
            FacePick::Retired(k) => FacePick::Retired(number(&self.retired_faces, k)),
        }
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
