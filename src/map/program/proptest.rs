//! Planar maps for the crate `proptest`, which shrink as their programs do.

use super::edits::EditProgram;
use super::runner::EditRunner;
use crate::map::PlanarMap;
use crate::program::Generator;
use proptest::arbitrary::Arbitrary;
use proptest::strategy::{BoxedStrategy, Strategy};

/// The map that a program makes of the empty one. Shrinks as the program does.
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
