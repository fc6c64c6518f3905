//! Random programs of operators, their starts, and their runs during shrinking.

use super::arguments::{FacePick, List};
use super::choose::Choose;
use super::generator::Generator;
use super::language::{Language, Name, Stage};
use super::operators::{Op, OpKind, Program};
use super::pointer_model::{PointerModel, PointerModelStart, StartError};
use super::runner::Runner;
use super::shrink::{extend, follow};
use crate::validate::{Expectation, Table, View};
use alloc::vec::Vec;

impl Program {
    /// Returns a generator of programs, to be configured with operators, weights and length.
    #[must_use]
    pub fn generator() -> Generator {
        Generator::default()
    }
}

impl Generator {
    /// Sets the starting structure of programs, so that failing ones shrink as far as programs from the empty map. O(n²).
    ///
    /// # Errors
    /// Returns a [`StartError`] if programs cannot begin with the structure.
    pub fn beginning_with<V: View + ?Sized>(
        mut self,
        structure: &V,
        expectation: &Expectation,
    ) -> Result<Self, StartError> {
        self.start = Start::of(structure, expectation)?;
        Ok(self)
    }
}

impl Language for Program {
    type Kind = OpKind;
    type Start = Start;
    type Stage = NamedRunner;

    const KINDS: &'static [(OpKind, u32)] = OpKind::SHARES;

    fn op(kind: OpKind, source: &mut impl Choose) -> Op {
        let upper = source.choose(8) as u8;
        Op::draw(kind, source, upper)
    }

    fn first() -> Option<(OpKind, Op)> {
        Some((OpKind::AddIsolatedVertex, Op::AddIsolatedVertex { face: FacePick::Unbounded }))
    }
}

/// Programs for the crate `arbitrary`.
#[cfg(feature = "arbitrary")]
impl<'a> arbitrary::Arbitrary<'a> for Program {
    fn arbitrary(u: &mut arbitrary::Unstructured<'a>) -> arbitrary::Result<Self> {
        u.arbitrary_iter()?.collect()
    }

    /// Reads the bytes as `from_bytes` does, so both share a corpus.
    fn arbitrary_take_rest(u: arbitrary::Unstructured<'a>) -> arbitrary::Result<Self> {
        Ok(Self::from_bytes(u.take_rest()))
    }
}

/// Programs for the crate `quickcheck`.
#[cfg(feature = "quickcheck")]
impl quickcheck::Arbitrary for Program {
    /// Generates the first operator, then up to [`Gen::size`](quickcheck::Gen::size) more.
    fn arbitrary(g: &mut quickcheck::Gen) -> Self {
        Self::generator().length(1..=g.size().saturating_add(1)).generate(g)
    }

    fn shrink(&self) -> alloc::boxed::Box<dyn Iterator<Item = Self>> {
        alloc::boxed::Box::new(super::shrink::candidates(self))
    }
}

/// Programs for the crate `proptest`.
#[cfg(feature = "proptest")]
impl proptest::arbitrary::Arbitrary for Program {
    type Parameters = Generator<Self>;
    type Strategy = Generator<Self>;

    fn arbitrary_with(generator: Generator<Self>) -> Generator<Self> {
        generator
    }
}

#[cfg(feature = "arbitrary")]
impl<'a> arbitrary::Arbitrary<'a> for Op {
    fn arbitrary(u: &mut arbitrary::Unstructured<'a>) -> arbitrary::Result<Self> {
        let mut bytes = core::iter::from_fn(|| u.arbitrary().ok());
        Self::from_bytes(&mut bytes).ok_or(arbitrary::Error::NotEnoughData)
    }

    fn size_hint(_depth: usize) -> (usize, Option<usize>) {
        (2, Some(14))
    }
}

#[cfg(feature = "quickcheck")]
impl quickcheck::Arbitrary for Op {
    fn arbitrary(g: &mut quickcheck::Gen) -> Self {
        let mut bytes = core::iter::repeat_with(|| Choose::choose(g, 256) as u8);
        Self::from_bytes(&mut bytes).unwrap_or(Self::AddIsolatedVertex { face: FacePick::Unbounded })
    }

    fn shrink(&self) -> alloc::boxed::Box<dyn Iterator<Item = Self>> {
        alloc::boxed::Box::new(self.simpler().into_iter())
    }
}

/// The result of a random program on the empty map. Shrinks as the program does.
#[cfg(feature = "proptest")]
impl proptest::arbitrary::Arbitrary for crate::dcel::Dcel {
    type Parameters = Generator;
    type Strategy = proptest::strategy::BoxedStrategy<Self>;

    fn arbitrary_with(generator: Generator) -> proptest::strategy::BoxedStrategy<Self> {
        use proptest::strategy::Strategy;
        let made = |program| {
            let mut runner = Runner::new(Self::default());
            runner.run(&program);
            runner.into_subject()
        };
        generator.prop_map(made).boxed()
    }
}

/// The starting structure of programs. The default is the empty map.
#[derive(Clone, Debug, Default)]
pub struct Start(Option<(Table, Expectation)>);

impl Start {
    pub(super) fn of<V: View + ?Sized>(view: &V, expectation: &Expectation) -> Result<Self, StartError> {
        PointerModel::from_view(view, expectation)?;
        Ok(Self(Table::copy_of(view).map(|table| (table, *expectation))))
    }

    fn runner(&self) -> Runner<PointerModel> {
        let Some((table, expectation)) = &self.0 else { return Runner::new(PointerModel::new()) };
        PointerModel::from_view(table, expectation).map_or_else(|_| Runner::new(PointerModel::new()), Runner::of_start)
    }
}

impl Runner<PointerModel> {
    /// Starts with the model of a structure and the handles of its elements.
    fn of_start(start: PointerModelStart) -> Self {
        let half_edges = start.half_edges.into_iter().map(|(_, half_edge)| half_edge).collect();
        let isolated = start.isolated.into_iter().map(|(_, vertex)| vertex).collect();
        Self::starting_with(start.model, half_edges, isolated)
    }
}

/// A runner of the reference, with the name of each entry of its lists.
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

    /// Entries of the start get a name that no operator has.
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
                let from = self.runner.corner(from);
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
