//! Names for the keys that edits count, so that numbers can follow what they chose.

use super::arguments::List;
use super::edits::{EditOp, EditProgram};
use super::keys::Keys;
use super::runner::EditRunner;
use crate::map::PlanarMap;
use crate::program::language::script::{Name, Scripted, Stage, extend, follow};
use slotmap::Key;

impl Scripted for EditProgram {
    type Start = ();
    type Stage = NamedEditRunner;
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
    fn follow<K: Key>(&mut self, before: &[K], keys: &Keys<K>, place: usize) {
        follow(&mut self.live, before, &keys.live(), place);
        extend(&mut self.retired, keys.retired.len(), place);
    }
}

impl Stage for NamedEditRunner {
    type Op = EditOp;
    type Start = ();

    fn new((): &()) -> Self {
        let runner = EditRunner::new(PlanarMap::new());
        let mut faces = Names::default();
        // The unbounded face, which no edit made.
        extend(&mut faces.live, runner.faces.len(), usize::MAX);
        Self { runner, vertices: Names::default(), half_edges: Names::default(), faces }
    }

    fn rewrite(&self, op: &EditOp, number: &mut impl FnMut(&[Name], u32) -> u32) -> EditOp {
        op.renumber(&mut |list, k| {
            let names = match list {
                List::Vertices => &self.vertices.live,
                List::HalfEdges => &self.half_edges.live,
                List::Faces => &self.faces.live,
                List::RetiredVertices => &self.vertices.retired,
                List::RetiredHalfEdges => &self.half_edges.retired,
                List::RetiredFaces => &self.faces.retired,
            };
            number(names, k)
        })
    }

    fn step(&mut self, op: &EditOp, place: usize) {
        let vertices = self.runner.vertices.live();
        let half_edges = self.runner.half_edges.live();
        let faces = self.runner.faces.live();
        self.runner.step(op);
        self.vertices.follow(&vertices, &self.runner.vertices, place);
        self.half_edges.follow(&half_edges, &self.runner.half_edges, place);
        self.faces.follow(&faces, &self.runner.faces, place);
    }
}
