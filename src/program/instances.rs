//! Random programs of operators.

use super::language::choose::Choose;
use super::language::generator::Generator;
use super::language::instances::instances;
use super::language::script::Language;
use super::operators::{FacePick, Op, OpKind, Program};
use super::pointer_model::StartError;
use super::run::named::Start;
use crate::validate::{Expectation, View};

impl Program {
    /// A generator of programs, to be told which operators, how often, and how many.
    #[must_use]
    pub fn generator() -> Generator {
        Generator::default()
    }
}

impl Generator {
    /// The same for programs that begin with this structure: so failing ones are made as small as those of the empty map. O(n²).
    ///
    /// # Errors
    /// [`StartError`]: programs cannot begin with it.
    pub fn beginning_with<V: View + ?Sized>(
        mut self,
        structure: &V,
        expectation: &Expectation,
    ) -> Result<Self, StartError> {
        self.start = Start::of(structure, expectation)?;
        Ok(self)
    }
}

instances!(Program);

impl Language for Program {
    type Kind = OpKind;

    const KINDS: &'static [(OpKind, u32)] = OpKind::SHARES;

    fn op(kind: OpKind, source: &mut impl Choose) -> Op {
        let upper = source.choose(8) as u8;
        Op::draw(kind, source, upper)
    }

    fn first() -> Option<(OpKind, Op)> {
        Some((OpKind::AddIsolatedVertex, Op::AddIsolatedVertex { face: FacePick::Unbounded }))
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

/// The structure that a program makes of the empty one. Shrinks as the program does.
#[cfg(feature = "proptest")]
impl proptest::arbitrary::Arbitrary for crate::dcel::Dcel {
    type Parameters = Generator;
    type Strategy = proptest::strategy::BoxedStrategy<Self>;

    fn arbitrary_with(generator: Generator) -> proptest::strategy::BoxedStrategy<Self> {
        use proptest::strategy::Strategy;
        let made = |program| {
            let mut runner = crate::program::run::runner::Runner::new(Self::default());
            runner.run(&program);
            runner.into_subject()
        };
        generator.prop_map(made).boxed()
    }
}
