//! Structures for the crate `proptest`, which shrink as their programs do.

use super::runner::Runner;
use crate::dcel::Dcel;
use crate::program::language::generator::Generator;
use crate::store::Store;
use core::fmt;
use proptest::arbitrary::Arbitrary;
use proptest::strategy::{BoxedStrategy, Strategy};

/// What a program makes of the empty structure. Shrinks as the program does.
impl<S: Store + fmt::Debug + 'static> Arbitrary for Dcel<S> {
    type Parameters = Generator;
    type Strategy = BoxedStrategy<Self>;

    fn arbitrary_with(generator: Generator) -> BoxedStrategy<Self> {
        let made = |program| {
            let mut runner = Runner::new(Self::default());
            runner.run(&program);
            runner.into_subject()
        };
        generator.prop_map(made).boxed()
    }
}
