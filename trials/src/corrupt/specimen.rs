//! The tables of small maps, and how they are corrupted.

use crate::panics::catch;
use crate::structure::Structure;
use std::fmt;
use twinedge::program::{Program, Runner, StepOutcome, Subject};
use twinedge::validate::enumerate::{Cell, Value};
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{Expectation, Link, Part, Start, Table};

/// How the tables of a map keep its faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "lowercase"))]
pub enum Form {
    /// With records for boundary components.
    Records,
    /// Without, as in textbooks: half-edges name their face, and faces name half-edges.
    Textbook,
}

impl Form {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Records => "records",
            Self::Textbook => "textbook",
        }
    }
}

/// One map in one form.
#[derive(Clone, Debug)]
pub(super) struct Specimen {
    pub(super) form: Form,
    pub(super) expectation: Expectation,
    pub(super) table: Table,
    program: String,
    /// Whether it has at most one edge and two vertices.
    pub(super) is_smallest: bool,
}

impl Specimen {
    /// The tables of the map that a program makes, each with a vacant row: in both forms, or in the textbook's if the structure
    /// has no records for boundary components. What is wrong, if the structure does not make the map.
    pub(super) fn all<K: Subject>(structure: &Structure<K>, program: &Program) -> Result<Vec<Self>, String> {
        let table = catch(|| copy(structure, program)).unwrap_or_else(|panic| Err(format!("panicked: {panic}")));
        let table = table.map_err(|why| format!("{why}, by\n{program}"))?;
        let expectation = structure.expectation();
        let textbook = expectation.without(Part::BoundaryComponents);
        let forms = if expectation.has(Part::BoundaryComponents) {
            let mut dropped = table.clone();
            drop_boundaries(&mut dropped);
            vec![(Form::Records, expectation, table), (Form::Textbook, textbook, dropped)]
        } else {
            vec![(Form::Textbook, textbook, table)]
        };
        Ok(forms.into_iter().map(|(form, expectation, table)| Self::new(form, expectation, table, program)).collect())
    }

    fn new(form: Form, expectation: Expectation, mut table: Table, program: &Program) -> Self {
        let (half_edges, vertices) =
            (table.half_edges.iter().flatten().count(), table.vertices.iter().flatten().count());
        table.vertices.push(None);
        table.half_edges.push(None);
        table.boundaries.push(None);
        table.faces.push(None);
        let is_smallest = half_edges <= 2 && vertices <= 2;
        Self { form, expectation, table, program: program.to_string(), is_smallest }
    }
}

/// The table of the map that a program makes.
fn copy<K: Subject>(structure: &Structure<K>, program: &Program) -> Result<Table, String> {
    let mut runner = Runner::new(structure.make());
    for op in &program.0 {
        let outcome = runner.step(*op);
        if outcome != StepOutcome::Applied {
            return Err(format!("`{op}` should be applied, but is {outcome}"));
        }
    }
    let table = Table::copy_of(runner.subject()).ok_or("there is not enough memory for the table")?;
    match first_broken_rule(&table, &structure.expectation()) {
        Some(rule) => Err(format!("the map breaks {rule}")),
        None => Ok(table),
    }
}

/// Takes the records for boundary components away: half-edges name their face instead, and faces where their cycles start.
fn drop_boundaries(table: &mut Table) {
    let boundaries = std::mem::take(&mut table.boundaries);
    let record = |b: Link| boundaries.get(b?).copied().flatten();
    for half_edge in table.half_edges.iter_mut().flatten() {
        half_edge.face = record(half_edge.boundary.take()).and_then(|b| b.face);
    }
    for vertex in table.vertices.iter_mut().flatten() {
        vertex.isolated = None;
    }
    for face in table.faces.iter_mut().flatten() {
        face.outer_half_edge = match record(face.outer.take()).and_then(|b| b.start) {
            Some(Start::HalfEdge(h)) => Some(h),
            _ => None,
        };
        face.inner_starts = std::mem::take(&mut face.inner).into_iter().map(|b| record(b)?.start).collect();
    }
}

/// Some changed cells of a specimen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corruption<'a> {
    pub(super) specimen: &'a Specimen,
    changes: [Option<(Cell, Value)>; 2],
}

impl<'a> Corruption<'a> {
    /// The first two changes are kept.
    pub(super) fn new(specimen: &'a Specimen, changes: &[(Cell, Value)]) -> Self {
        Self { specimen, changes: [0, 1].map(|i| changes.get(i).copied()) }
    }
}

impl fmt::Display for Corruption<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (cell, value)) in self.changes.iter().flatten().enumerate() {
            write!(f, "{}{cell:?} = {value:?}", if i == 0 { "" } else { " and " })?;
        }
        write!(f, ", in the {} of\n{}", self.specimen.form.name(), self.specimen.program)
    }
}
