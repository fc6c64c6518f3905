//! What the numbers of an edit count, so that they can follow the names of what they chose.

use super::op::{EditOp, EditProgram};
use super::pick::{AtPick, FeaturesPick, GridPick, MapFacePick, MapHalfEdgePick, MapVertexPick, RingPick, Spot};
use super::runner::{EditRunner, Keys};
use super::table::edits;
use crate::map::PlanarMap;
use crate::program::script::{Name, Scripted, Stage, extend, follow};

impl Scripted for EditProgram {
    type Op = EditOp;
    type Stage = NamedEditRunner;

    fn ops(&self) -> &[EditOp] {
        &self.0
    }

    fn from_ops(ops: Vec<EditOp>) -> Self {
        Self(ops)
    }

    fn simpler(op: &EditOp) -> Vec<EditOp> {
        op.simpler()
    }
}

/// A runner, and beside each of its lists the names of what is on it.
pub struct NamedEditRunner {
    runner: EditRunner,
    vertices: Names,
    half_edges: Names,
    faces: Names,
}

#[derive(Default)]
struct Names {
    live: Vec<Name>,
    retired: Vec<Name>,
}

impl Names {
    fn follow<K: PartialEq>(&mut self, before: &[K], keys: &Keys<K>, place: usize) {
        follow(&mut self.live, before, &keys.live, place);
        extend(&mut self.retired, keys.retired.len(), place);
    }
}

macro_rules! define_rewrite {
    ($($variant:ident $method:ident $share:literal { $($arg:ident: $pick:ty;)* })*) => {
        impl NamedEditRunner {
            fn renumbered(&self, op: &EditOp, number: &mut impl FnMut(&[Name], u16) -> u16) -> EditOp {
                match op {
                    $(EditOp::$variant { $($arg),* } => {
                        $(let $arg = $arg.renumber(self, number);)*
                        EditOp::$variant { $($arg),* }
                    })*
                }
            }
        }
    };
}
edits!(define_rewrite);

impl Stage for NamedEditRunner {
    type Op = EditOp;

    fn new() -> Self {
        let runner = EditRunner::new(PlanarMap::new());
        let mut faces = Names::default();
        // The unbounded face, which no edit made.
        extend(&mut faces.live, runner.faces.live.len(), usize::MAX);
        Self { runner, vertices: Names::default(), half_edges: Names::default(), faces }
    }

    fn rewrite(&self, op: &EditOp, number: &mut impl FnMut(&[Name], u16) -> u16) -> EditOp {
        self.renumbered(op, number)
    }

    fn step(&mut self, op: &EditOp, place: usize) {
        let vertices = self.runner.vertices.live.clone();
        let half_edges = self.runner.half_edges.live.clone();
        let faces = self.runner.faces.live.clone();
        self.runner.step(op);
        self.vertices.follow(&vertices, &self.runner.vertices, place);
        self.half_edges.follow(&half_edges, &self.runner.half_edges, place);
        self.faces.follow(&faces, &self.runner.faces, place);
    }
}

/// An argument with other numbers.
trait Renumber {
    fn renumber(&self, stage: &NamedEditRunner, number: &mut impl FnMut(&[Name], u16) -> u16) -> Self;
}

macro_rules! renumber_picks {
    ($($name:ident $list:ident)*) => {$(
        impl Renumber for $name {
            fn renumber(&self, stage: &NamedEditRunner, number: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
                match *self {
                    Self::Live(k) => Self::Live(number(&stage.$list.live, k)),
                    Self::Retired(k) => Self::Retired(number(&stage.$list.retired, k)),
                }
            }
        }
    )*};
}
renumber_picks! { MapVertexPick vertices MapHalfEdgePick half_edges MapFacePick faces }

impl Renumber for AtPick {
    fn renumber(&self, stage: &NamedEditRunner, number: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        match *self {
            Self::Point(spot) => Self::Point(spot),
            Self::Near(spot, hint) => Self::Near(spot, hint.renumber(stage, number)),
            Self::Vertex(pick) => Self::Vertex(pick.renumber(stage, number)),
        }
    }
}

impl Renumber for RingPick {
    fn renumber(&self, stage: &NamedEditRunner, number: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
        self.iter().map(|at| at.renumber(stage, number)).collect()
    }
}

macro_rules! without_numbers {
    ($($name:ident)*) => {$(
        impl Renumber for $name {
            fn renumber(&self, _: &NamedEditRunner, _: &mut impl FnMut(&[Name], u16) -> u16) -> Self {
                *self
            }
        }
    )*};
}
without_numbers! { Spot GridPick FeaturesPick }
