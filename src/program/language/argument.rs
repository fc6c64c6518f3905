//! Arguments of operators: their words, how they are drawn, what is simpler, and the numbers in them.

use super::choose::Choose;
use super::words::{ParseError, Words};
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

/// An argument of an operator.
pub(crate) trait Argument: Clone {
    /// The lists in which its numbers count.
    type List;
    /// The arguments before it on which it depends.
    type Context;

    /// Draws one by the choices of a source. `upper` is a number below 8 that all arguments of an operator share.
    fn draw(source: &mut impl Choose, upper: u8) -> Self;

    /// Writes its words, with a space before each.
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result;

    /// Reads its words.
    fn read(words: &mut Words<'_>) -> Result<Self, ParseError>;

    /// The argument in every way in which it is simpler, the simplest first.
    fn simpler(&self) -> Vec<Self>;

    /// The argument with other numbers. One without numbers stays as it is.
    fn renumber(&self, context: Self::Context, number: &mut impl FnMut(Self::List, u32) -> u32) -> Self {
        let _ = (context, number);
        self.clone()
    }
}

/// Writes the two methods of an argument that is one word, by `Display` and a function that reads the word.
macro_rules! one_word {
    ($expected:ident, $read:expr) => {
        fn write(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
            write!(f, " {self}")
        }

        fn read(
            words: &mut $crate::program::language::words::Words<'_>,
        ) -> Result<Self, $crate::program::language::words::ParseError> {
            words.take($crate::program::language::words::Expected::$expected, $read)
        }
    };
}
pub(crate) use one_word;

/// Defines arguments that choose from one list or another by a number: for each list a variant, the prefix of its word, and the list.
/// The first list is the simplest. `|source| …` draws one.
macro_rules! numbered {
    ($lists:ident; $(
        $(#[$doc:meta])*
        $name:ident $expected:ident |$source:ident| $draw:expr;
        $(#[$first_doc:meta])* $first:ident $first_prefix:literal $first_list:ident
        $(, $(#[$variant_doc:meta])* $variant:ident $prefix:literal $list:ident)*;
    )*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $name {
            $(#[$first_doc])*
            $first(u32),
            $($(#[$variant_doc])* $variant(u32),)*
        }

        impl core::fmt::Display for $name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                match self {
                    Self::$first(k) => write!(f, concat!($first_prefix, "{}"), k),
                    $(Self::$variant(k) => write!(f, concat!($prefix, "{}"), k),)*
                }
            }
        }

        impl $name {
            /// Reads the word that `Display` writes.
            pub(crate) fn of_word(word: &str) -> Option<Self> {
                use $crate::program::language::words::number;
                let first = number(word, $first_prefix).map(Self::$first);
                first$(.or_else(|| number(word, $prefix).map(Self::$variant)))*
            }
        }

        impl $crate::program::language::argument::Argument for $name {
            type List = $lists;
            type Context = ();

            $crate::program::language::argument::one_word!($expected, Self::of_word);

            fn draw($source: &mut impl $crate::program::language::choose::Choose, _: u8) -> Self {
                $draw
            }

            fn simpler(&self) -> alloc::vec::Vec<Self> {
                use $crate::program::language::argument::smaller;
                match *self {
                    Self::$first(k) => smaller(k).map(Self::$first).collect(),
                    $(Self::$variant(k) => core::iter::once(Self::$first(k)).chain(smaller(k).map(Self::$variant)).collect(),)*
                }
            }

            fn renumber(&self, (): (), number: &mut impl FnMut($lists, u32) -> u32) -> Self {
                match *self {
                    Self::$first(k) => Self::$first(number($lists::$first_list, k)),
                    $(Self::$variant(k) => Self::$variant(number($lists::$list, k)),)*
                }
            }
        }
    )*};
}
pub(crate) use numbered;

/// Smaller numbers, the smallest first. Two less keeps the side of an edge, which one less and the half may not.
pub(crate) fn smaller(k: u32) -> impl Iterator<Item = u32> {
    let mut all = vec![0, 1, k / 2, k.saturating_sub(2), k.saturating_sub(1)];
    all.sort_unstable();
    all.dedup();
    all.into_iter().filter(move |smaller| *smaller < k)
}

/// Writes the places of the bits of a mask, with commas between them. Nothing if there are none.
pub(crate) fn write_mask(f: &mut fmt::Formatter<'_>, mask: u16) -> fmt::Result {
    let mut before = "";
    for bit in (0..16).filter(|bit| mask >> bit & 1 == 1) {
        write!(f, "{before}{bit}")?;
        before = ",";
    }
    Ok(())
}

/// Masks without one bit or more, the simplest first.
pub(crate) fn smaller_masks(mask: u16) -> impl Iterator<Item = u16> {
    let bits = (0..16).map(|bit| 1 << bit).filter(move |bit| mask & bit != 0 && *bit != mask);
    (mask != 0).then_some(0).into_iter().chain(bits.map(move |bit| mask & !bit))
}

/// The same operator with one argument replaced.
pub(crate) fn replaced<O: Clone>(op: &O, replace: impl FnOnce(&mut O)) -> O {
    let mut other = op.clone();
    replace(&mut other);
    other
}
