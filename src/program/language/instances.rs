//! Programs for the crates `arbitrary`, `quickcheck` and `proptest`.

/// Implements the traits of these crates for a language, as far as their features are on.
macro_rules! instances {
    ($program:ident) => {
        #[cfg(feature = "arbitrary")]
        impl<'a> arbitrary::Arbitrary<'a> for $program {
            fn arbitrary(u: &mut arbitrary::Unstructured<'a>) -> arbitrary::Result<Self> {
                u.arbitrary_iter()?.collect()
            }

            /// The bytes are read as by `from_bytes`, so a corpus is that of the bytes.
            fn arbitrary_take_rest(u: arbitrary::Unstructured<'a>) -> arbitrary::Result<Self> {
                Ok(Self::from_bytes(u.take_rest()))
            }
        }

        #[cfg(feature = "quickcheck")]
        impl quickcheck::Arbitrary for $program {
            /// The first operator of programs, if there is one, and up to [`Gen::size`](quickcheck::Gen::size) operators.
            fn arbitrary(g: &mut quickcheck::Gen) -> Self {
                let least = usize::from(<Self as $crate::program::Language>::first().is_some());
                $crate::program::Generator::default().length(least..=g.size().saturating_add(least)).generate(g)
            }

            fn shrink(&self) -> alloc::boxed::Box<dyn Iterator<Item = Self>> {
                alloc::boxed::Box::new($crate::program::candidates(self))
            }
        }

        #[cfg(feature = "proptest")]
        impl proptest::arbitrary::Arbitrary for $program {
            type Parameters = $crate::program::Generator<Self>;
            type Strategy = $crate::program::Generator<Self>;

            fn arbitrary_with(generator: $crate::program::Generator<Self>) -> $crate::program::Generator<Self> {
                generator
            }
        }
    };
}
pub(crate) use instances;
