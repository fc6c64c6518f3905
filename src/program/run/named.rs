//! Names for the handles that operators count, so that numbers can follow what they chose.

use super::resolve::Resolve;
use super::runner::Runner;
use crate::program::language::script::{Name, Scripted, Stage, extend, follow};
use crate::program::operators::{List, Op, Program};
use crate::program::pointer_model::{PointerModel, PointerModelStart, StartError};
use crate::validate::{Expectation, Table, View};
use alloc::vec::Vec;

/// A structure with which programs begin. The default is the empty map.
#[derive(Clone, Debug, Default)]
pub struct Start(Option<(Table, Expectation)>);

impl Start {
    pub(in crate::program) fn of<V: View + ?Sized>(view: &V, expectation: &Expectation) -> Result<Self, StartError> {
        PointerModel::from_view(view, expectation)?;
        Ok(Self(Table::copy_of(view).map(|table| (table, *expectation))))
    }

    /// The reference with this structure.
    fn runner(&self) -> Runner<PointerModel> {
        let Some((table, expectation)) = &self.0 else { return Runner::new(PointerModel::new()) };
        PointerModel::from_view(table, expectation).map_or_else(|_| Runner::new(PointerModel::new()), Runner::of_start)
    }
}

impl Runner<PointerModel> {
    /// The model of a structure, with the handles of its elements.
    fn of_start(start: PointerModelStart) -> Self {
        let half_edges = start.half_edges.into_iter().map(|(_, half_edge)| half_edge).collect();
        let isolated = start.isolated.into_iter().map(|(_, vertex)| vertex).collect();
        Self::starting_with(start.model, half_edges, isolated)
    }
}

impl Scripted for Program {
    type Start = Start;
    type Stage = NamedRunner;
}

/// A runner of the reference, and beside each of its lists the names of what is on it.
pub struct NamedRunner {
    runner: Runner<PointerModel>,
    half_edges: Vec<Name>,
    isolated: Vec<Name>,
    retired_half_edges: Vec<Name>,
    retired_vertices: Vec<Name>,
    retired_faces: Vec<Name>,
}

impl Stage for NamedRunner {
    type Op = Op;
    type Start = Start;

    /// No operator made what it begins with.
    fn new(start: &Start) -> Self {
        let runner = start.runner();
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

    fn rewrite(&self, op: &Op, number: &mut impl FnMut(&[Name], u32) -> u32) -> Op {
        op.renumber(&mut |list, k| match list {
            List::HalfEdges => number(&self.half_edges, k),
            List::Isolated => number(&self.isolated, k),
            List::RetiredHalfEdges => number(&self.retired_half_edges, k),
            List::RetiredVertices => number(&self.retired_vertices, k),
            List::RetiredFaces => number(&self.retired_faces, k),
            List::Fitting(from, fit) => {
                let from = from.resolve(&self.runner, ());
                let places = from.and_then(|from| self.runner.fitting(from, fit)).unwrap_or_default();
                let names = self.half_edges.iter().chain(&self.isolated).enumerate();
                let fits = |place: &usize| places.binary_search(place).is_ok();
                let names: Vec<Name> = names.filter(|(place, _)| fits(place)).map(|(_, name)| *name).collect();
                number(&names, k)
            }
        })
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
