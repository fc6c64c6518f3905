//! What the numbers of an operator count, so that they can follow the names of what they chose.

use super::op::{CornerPick, FacePick, HalfEdgePick, InnerPick, Op, Program, SecondPick, VertexPick};
use super::resolve::{Choose, Fit};
use super::runner::Runner;
use super::script::{Name, Scripted, Stage, extend, follow};
use super::subject::Subject;
use super::table::operators;
use crate::dcel::{Dcel, Side, Turn};
use alloc::vec::Vec;

impl Scripted for Program {
    type Op = Op;
    type Stage = NamedRunner<Dcel>;

    fn ops(&self) -> &[Op] {
        &self.0
    }

    fn from_ops(ops: Vec<Op>) -> Self {
        Self(ops)
    }

    fn simpler(op: &Op) -> Vec<Op> {
        op.simpler()
    }
}

/// A runner, and beside each of its lists the names of what is on it.
pub struct NamedRunner<K: Subject> {
    runner: Runner<K>,
    half_edges: Vec<Name>,
    isolated: Vec<Name>,
    retired_half_edges: Vec<Name>,
    retired_vertices: Vec<Name>,
    retired_faces: Vec<Name>,
}

macro_rules! define_rewrite {
    ($($variant:ident $method:ident $share:literal {
        changes [$($change:expr),+]
        $($arg:ident: $pick:ty => $handle:ty, $depends:tt;)*
    })*) => {
        impl<K: Subject> NamedRunner<K> {
            fn renumbered(&self, op: Op, number: &mut impl FnMut(&[Name], u16) -> u16) -> Op {
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

impl<K: Subject> NamedRunner<K> {
    /// Begins with what a runner has; no operator made it.
    pub(super) fn beginning(runner: Runner<K>) -> Self {
        let (mut half_edges, mut isolated) = (Vec::new(), Vec::new());
        extend(&mut half_edges, runner.half_edges().len(), usize::MAX);
        extend(&mut isolated, runner.isolated().len(), usize::MAX);
        Self {
            runner,
            half_edges,
            isolated,
            retired_half_edges: Vec::new(),
            retired_vertices: Vec::new(),
            retired_faces: Vec::new(),
        }
    }
}

impl<K: Subject + Default> Stage for NamedRunner<K> {
    type Op = Op;

    fn new() -> Self {
        Self::beginning(Runner::new(K::default()))
    }

    fn rewrite(&self, op: &Op, number: &mut impl FnMut(&[Name], u16) -> u16) -> Op {
        self.renumbered(*op, number)
    }

    fn step(&mut self, op: &Op, place: usize) {
        let half_edges = self.runner.half_edges().to_vec();
        let isolated = self.runner.isolated().to_vec();
        self.runner.step(*op);
        follow(&mut self.half_edges, &half_edges, self.runner.half_edges(), place);
        follow(&mut self.isolated, &isolated, self.runner.isolated(), place);
        extend(&mut self.retired_half_edges, self.runner.retired_half_edges().len(), place);
        extend(&mut self.retired_vertices, self.runner.retired_vertices().len(), place);
        extend(&mut self.retired_faces, self.runner.retired_faces().len(), place);
    }
}

/// An argument with other numbers, after those that it depends on.
trait Renumber: Choose {
    fn renumber(
        self,
        stage: &NamedRunner<impl Subject>,
        context: Self::Context<CornerPick>,
        number: &mut impl FnMut(&[Name], u16) -> u16,
    ) -> Self;
}

impl Renumber for HalfEdgePick {
    fn renumber(self, stage: &NamedRunner<impl Subject>, (): (), number: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        match self {
            Self::Live(k) => Self::Live(number(&stage.half_edges, k)),
            Self::Retired(k) => Self::Retired(number(&stage.retired_half_edges, k)),
        }
    }
}

impl Renumber for VertexPick {
    fn renumber(self, stage: &NamedRunner<impl Subject>, (): (), number: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        match self {
            Self::Isolated(k) => Self::Isolated(number(&stage.isolated, k)),
            Self::OriginOf(k) => Self::OriginOf(number(&stage.half_edges, k)),
            Self::Retired(k) => Self::Retired(number(&stage.retired_vertices, k)),
        }
    }
}

impl Renumber for CornerPick {
    fn renumber(self, stage: &NamedRunner<impl Subject>, (): (), number: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        match self {
            Self::At(pick) => Self::At(pick.renumber(stage, (), number)),
            Self::Isolated(pick) => Self::Isolated(pick.renumber(stage, (), number)),
        }
    }
}

impl Renumber for SecondPick {
    fn renumber(
        self,
        stage: &NamedRunner<impl Subject>,
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
    fn renumber(
        self,
        stage: &NamedRunner<impl Subject>,
        _: CornerPick,
        number: &mut impl FnMut(&[Name], u16) -> u16,
    ) -> Self {
        Self { also: self.also.map(|pick| pick.renumber(stage, (), number)), ..self }
    }
}

impl Renumber for FacePick {
    fn renumber(self, stage: &NamedRunner<impl Subject>, (): (), number: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        match self {
            Self::Unbounded => Self::Unbounded,
            Self::Of(pick) => Self::Of(pick.renumber(stage, (), number)),
            Self::Retired(k) => Self::Retired(number(&stage.retired_faces, k)),
        }
    }
}

impl Renumber for Side {
    fn renumber(self, _: &NamedRunner<impl Subject>, (): (), _: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        self
    }
}

impl Renumber for Turn {
    fn renumber(self, _: &NamedRunner<impl Subject>, (): (), _: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        self
    }
}
