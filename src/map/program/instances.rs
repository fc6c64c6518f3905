//! Programs of edits for the crates `arbitrary`, `quickcheck` and `proptest`.

#[cfg(feature = "arbitrary")]
mod for_arbitrary {
    use crate::map::program::op::{EditOp, EditProgram};
    use arbitrary::{Arbitrary, Error, Result, Unstructured};

    impl<'a> Arbitrary<'a> for EditOp {
        fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
            if u.is_empty() {
                return Err(Error::NotEnoughData);
            }
            EditProgram::generator().length(1..=1).generate(u).0.pop().ok_or(Error::NotEnoughData)
        }
    }

    /// Where a program is all that is wanted, the bytes are read as by [`EditProgram::from_bytes`].
    impl<'a> Arbitrary<'a> for EditProgram {
        fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
            u.arbitrary_iter()?.collect()
        }

        fn arbitrary_take_rest(u: Unstructured<'a>) -> Result<Self> {
            Ok(Self::from_bytes(u.take_rest()))
        }
    }
}

#[cfg(feature = "quickcheck")]
mod for_quickcheck {
    use crate::map::program::op::EditProgram;
    use crate::program::candidates;
    use quickcheck::{Arbitrary, Gen};

    impl Arbitrary for EditProgram {
        /// Up to [`Gen::size`] edits.
        fn arbitrary(g: &mut Gen) -> Self {
            Self::generator().length(0..=g.size()).generate(g)
        }

        fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
            Box::new(candidates(self))
        }
    }
}

#[cfg(feature = "proptest")]
mod for_proptest {
    use crate::map::PlanarMap;
    use crate::map::program::op::EditProgram;
    use crate::map::program::runner::EditRunner;
    use crate::program::Generator;
    use proptest::arbitrary::Arbitrary;
    use proptest::strategy::{BoxedStrategy, Strategy};

    impl Arbitrary for EditProgram {
        type Parameters = Generator<Self>;
        type Strategy = Generator<Self>;

        fn arbitrary_with(generator: Generator<Self>) -> Generator<Self> {
            generator
        }
    }

    /// What a program makes of the empty map. Shrinks as the program does.
    impl Arbitrary for PlanarMap {
        type Parameters = Generator<EditProgram>;
        type Strategy = BoxedStrategy<Self>;

        fn arbitrary_with(generator: Generator<EditProgram>) -> BoxedStrategy<Self> {
            let made = |program| {
                let mut runner = EditRunner::new(Self::new());
                runner.run(&program);
                runner.into_map()
            };
            generator.prop_map(made).boxed()
        }
    }
}
