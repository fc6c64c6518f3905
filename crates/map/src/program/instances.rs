//! Random programs of edits, and shrinking of failing programs.

use super::arguments::List;
use super::edits::{EditKind, EditOp, EditProgram};
use super::runner::{EditRunner, Keys};
use crate::PlanarMap;
use slotmap::Key;
use twinedge::program::choose::Choose;
use twinedge::program::language::{Language, Name, Stage};
use twinedge::program::{Generator, extend, follow};

impl EditProgram {
    /// Decodes a program from bytes: every choice consumes only the bytes that it needs, and missing bytes are zeros. O(bytes).
    #[must_use]
    pub fn from_bytes(bytes: &[u8]) -> Self {
        Self::generator().decode(bytes)
    }

    /// Returns a generator of programs, with adjustable edits, frequencies and length.
    ///
    /// ```
    /// use twinedge_map::program::{EditKind, EditOp, EditProgram};
    /// use twinedge::program::choose::Bytes;
    ///
    /// let drawing = EditProgram::generator().only(&[EditKind::InsertSegment]).length(3..=3);
    /// let program = drawing.generate(&mut Bytes::new(b"choices"));
    /// assert!(program.0.iter().all(|edit| matches!(edit, EditOp::InsertSegment { .. })));
    /// assert_eq!(program.0.len(), 3);
    /// ```
    #[must_use]
    pub fn generator() -> Generator<Self> {
        Generator::default()
    }
}

impl Language for EditProgram {
    type Kind = EditKind;
    type Start = ();
    type Stage = NamedEditRunner;

    const KINDS: &'static [(EditKind, u32)] = EditKind::SHARES;

    fn op(kind: EditKind, source: &mut impl Choose) -> EditOp {
        EditOp::draw(kind, source, 0)
    }
}

#[cfg(feature = "arbitrary")]
impl<'a> arbitrary::Arbitrary<'a> for EditProgram {
    fn arbitrary(u: &mut arbitrary::Unstructured<'a>) -> arbitrary::Result<Self> {
        u.arbitrary_iter()?.collect()
    }

    /// Decodes the bytes as `from_bytes` does, so corpora are interchangeable.
    fn arbitrary_take_rest(u: arbitrary::Unstructured<'a>) -> arbitrary::Result<Self> {
        Ok(Self::from_bytes(u.take_rest()))
    }
}

#[cfg(feature = "quickcheck")]
impl quickcheck::Arbitrary for EditProgram {
    /// Up to [`Gen::size`](quickcheck::Gen::size) edits.
    fn arbitrary(g: &mut quickcheck::Gen) -> Self {
        Self::generator().length(0..=g.size()).generate(g)
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        Box::new(twinedge::program::candidates(self))
    }
}

#[cfg(feature = "proptest")]
impl proptest::arbitrary::Arbitrary for EditProgram {
    type Parameters = Generator<Self>;
    type Strategy = Generator<Self>;

    fn arbitrary_with(generator: Generator<Self>) -> Generator<Self> {
        generator
    }
}

#[cfg(feature = "arbitrary")]
impl<'a> arbitrary::Arbitrary<'a> for EditOp {
    fn arbitrary(u: &mut arbitrary::Unstructured<'a>) -> arbitrary::Result<Self> {
        if u.is_empty() {
            return Err(arbitrary::Error::NotEnoughData);
        }
        EditProgram::generator().length(1..=1).generate(u).0.pop().ok_or(arbitrary::Error::NotEnoughData)
    }
}

/// A runner, with names for the entries of each of its lists.
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

/// The map that a program makes from the empty map. Shrinks like the program.
#[cfg(feature = "proptest")]
impl proptest::arbitrary::Arbitrary for PlanarMap {
    type Parameters = Generator<EditProgram>;
    type Strategy = proptest::strategy::BoxedStrategy<Self>;

    fn arbitrary_with(generator: Self::Parameters) -> proptest::strategy::BoxedStrategy<Self> {
        use proptest::strategy::Strategy;
        let made = |program| {
            let mut runner = EditRunner::new(Self::new());
            runner.run(&program);
            runner.into_map()
        };
        generator.prop_map(made).boxed()
    }
}
