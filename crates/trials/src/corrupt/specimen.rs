//! The tables of small maps, and their corruptions.

use super::exchange::Exchange;
use crate::enumerate::{Cell, Value};
use crate::forms::{Form, forms, projected, projections};
use crate::structure::Structure;
use std::fmt;
use twinedge::program::panics::catch;
use twinedge::program::{Program, Runner, StepOutcome, Subject};
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{Expectation, Part, Parts, Rule, Surface, Table};

/// The largest number of edges of maps that are brought into every form; they have up to two vertices.
pub(super) const EDGES_OF_EVERY_FORM: usize = 2;

/// The form in which the tables of a map keep its faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "lowercase"))]
pub enum Family {
    /// With records for boundary components.
    Records,
    /// Without, as in textbooks: half-edges name their face, and faces name half-edges.
    Textbook,
    /// All forms together, with closed and open boundaries, and three more with M1 … M8.
    Every,
}

impl Family {
    /// Returns its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Records => "records",
            Self::Textbook => "textbook",
            Self::Every => "every",
        }
    }
}

#[derive(Clone, Debug)]
pub(super) struct Specimen {
    pub(super) form: Family,
    pub(super) expectation: Expectation,
    pub(super) table: Table,
    program: String,
    /// True for at most one edge and two vertices.
    pub(super) is_smallest: bool,
    /// The number of the form in [`held_to`], if it is one of [`Family::Every`].
    pub(super) number: Option<usize>,
}

impl Specimen {
    /// Returns the tables of the map that a program makes, each with a vacant row: in both forms, or in the textbook's if the
    /// structure has no records for boundary components; and in every form, if the map is small and the structure has every part.
    /// Returns the fault if the structure does not make the map.
    pub(super) fn all<K: Subject>(structure: &Structure<K>, program: &Program) -> Result<Vec<Self>, String> {
        let table = catch(|| copy(structure, program)).unwrap_or_else(|panic| Err(format!("panicked: {panic}")));
        let table = table.map_err(|why| format!("{why}, by\n{program}"))?;
        let expectation = structure.expectation();
        let stored = expectation.looks_at(table.parts);
        let mut all = Vec::new();
        if stored.has(Part::BoundaryComponents) {
            let textbook = Form::new(expectation, stored.without(Part::BoundaryComponents));
            all.push(Self::new(Family::Records, expectation, table.clone(), program));
            all.push(Self::new(Family::Textbook, expectation, projected(&table, &textbook), program));
        } else {
            all.push(Self::new(Family::Textbook, expectation, table.clone(), program));
        }
        let (edges, vertices) =
            (table.half_edges.iter().flatten().count() / 2, table.vertices.iter().flatten().count());
        let has_every_part = expectation == Expectation::plane() && stored == Parts::ALL;
        if has_every_part && edges <= EDGES_OF_EVERY_FORM && vertices <= 2 {
            for (number, form) in held_to().into_iter().enumerate() {
                for table in projections(&table, &form) {
                    let specimen = Self::new(Family::Every, form.expectation, table, program);
                    let is_smallest = edges <= 1;
                    all.push(Self { number: Some(number), is_smallest, ..specimen });
                }
            }
        }
        Ok(all)
    }

    pub(super) fn parts(&self) -> Parts {
        self.expectation.looks_at(self.table.parts)
    }

    fn new(form: Family, expectation: Expectation, mut table: Table, program: &Program) -> Self {
        let (half_edges, vertices) =
            (table.half_edges.iter().flatten().count(), table.vertices.iter().flatten().count());
        table.vertices.push(None);
        table.half_edges.push(None);
        table.boundaries.push(None);
        table.faces.push(None);
        let is_smallest = half_edges <= 2 && vertices <= 2;
        Self { form, expectation, table, program: program.to_string(), is_smallest, number: None }
    }
}

/// Returns the table of the map that a program makes.
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

#[derive(Clone, Copy, Debug)]
enum Change {
    Cells([Option<(Cell, Value)>; 2]),
    Exchange(Exchange),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Corruption<'a> {
    pub(super) specimen: &'a Specimen,
    change: Change,
}

impl<'a> Corruption<'a> {
    /// Returns a corruption of some cells. The first two changes are kept.
    pub(super) fn new(specimen: &'a Specimen, changes: &[(Cell, Value)]) -> Self {
        Self { specimen, change: Change::Cells([0, 1].map(|i| changes.get(i).copied())) }
    }

    pub(super) const fn exchanged(specimen: &'a Specimen, exchange: Exchange) -> Self {
        Self { specimen, change: Change::Exchange(exchange) }
    }
}

impl fmt::Display for Corruption<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.change {
            Change::Cells(changes) => {
                for (i, (cell, value)) in changes.iter().flatten().enumerate() {
                    write!(f, "{}{cell:?} = {value:?}", if i == 0 { "" } else { " and " })?;
                }
            }
            Change::Exchange(exchange) => write!(f, "exchanged: {exchange:?}")?,
        }
        let Specimen { form, expectation, program, table, .. } = self.specimen;
        match form {
            Family::Every => write!(f, ", in {table}\nheld to {expectation:?}, of\n{program}"),
            Family::Records | Family::Textbook => write!(f, ", in the {} of\n{program}", form.name()),
        }
    }
}

/// Returns the forms in which tables are judged: the distinct ones, and three with more claims.
pub(super) fn held_to() -> Vec<Form> {
    let open = Expectation::surface().open();
    // If M1 … M4 are claimed, small maps break one of them first.
    let sphere = open.components(1).borders(0).genus(0);
    let of_triangles = sphere.no_unused_vertices().simple().triangles().closed();
    let asking = [of_triangles, sphere, open.border_kept()].map(|expectation| Form::new(expectation, Parts::ALL));
    forms().into_iter().chain(asking).collect()
}

pub(super) fn in_words(form: Form) -> String {
    let Form { expectation, parts } = form;
    let surface = if expectation.surface_kind() == Surface::Plane { "plane" } else { "surface" };
    let open = if expectation.is_open() { ", open" } else { "" };
    let lacks: Vec<&str> = Part::ALL.iter().filter(|part| !parts.has(**part)).map(|part| part.name()).collect();
    let without = if lacks.is_empty() { String::new() } else { format!(", without {}", lacks.join(", ")) };
    let asked: Vec<&str> = asked_for(expectation).map(Rule::id).collect();
    let asking = if asked.is_empty() { String::new() } else { format!(", asking for {}", asked.join(", ")) };
    format!("{surface}{open}{without}{asking}")
}

fn asked_for(expectation: Expectation) -> impl Iterator<Item = Rule> {
    Rule::ALL.iter().copied().filter(move |rule| rule.is_optional() && expectation.asks_for(*rule))
}

/// Returns the rules that are checked in the form and not implied by earlier ones. T4 is always implied, and T3 where any genus
/// is allowed. Where M1 … M4 are claimed, only larger maps break M5 … M7 first.
pub(super) fn independent_rules(form: Form) -> Vec<Rule> {
    let Form { expectation, parts } = form;
    let (faces, holes) = (parts.has(Part::Faces), parts.has(Part::Holes));
    let plane = expectation.surface_kind() == Surface::Plane;
    let is_checked = |rule: &Rule| match *rule {
        Rule::R1 | Rule::L1 | Rule::L2 | Rule::L3 | Rule::V2 => true,
        Rule::V1 => parts.has(Part::Leaving),
        Rule::B1 | Rule::F1 | Rule::F2 => faces,
        Rule::B2 => faces && holes,
        Rule::T1 | Rule::T2 => faces && holes && plane,
        Rule::T3 => plane,
        Rule::M1 | Rule::M2 | Rule::M3 | Rule::M4 => expectation.asks_for(*rule),
        Rule::M5 | Rule::M6 | Rule::M7 => expectation.asks_for(*rule) && !expectation.asks_for(Rule::M4),
        Rule::M8 => expectation.asks_for(*rule) && parts.has(Part::Leaving),
        _ => false,
    };
    Rule::ALL.iter().copied().filter(is_checked).collect()
}
