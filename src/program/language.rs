//! Languages of programs for any operators: arguments, text, and the traits that generation and shrinking need.
//!
//! The macro [`language`](crate::language) turns a table of operators into a language; `program::operators` has the table of
//! topological operators.

use super::choose::Choose;
use super::text::{Expected, ParseError, Words, number};
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

/// A sequence of operators.
pub trait Sequence: Clone + PartialEq + fmt::Debug + 'static {
    /// Its operators.
    type Op: Clone + PartialEq + fmt::Debug + 'static;

    /// Returns the operators of the program.
    fn ops(&self) -> &[Self::Op];

    /// Creates the program of these operators.
    fn from_ops(ops: Vec<Self::Op>) -> Self;

    /// Returns the operator with one argument simplified, in every possible way.
    fn simpler(op: &Self::Op) -> Vec<Self::Op>;
}

/// A language of programs, such as [`Program`](crate::program::Program) for the operators of a [`Dcel`](crate::dcel::Dcel).
///
/// Programs of a language can be [generated](crate::program::Generator), [shrunk](crate::program::shrink()), written and read.
pub trait Language: Sequence {
    /// The kinds of its operators.
    type Kind: Copy + PartialEq + fmt::Debug + 'static;

    /// The starting structure of programs; the empty one by default.
    type Start: Clone + fmt::Debug + Default + 'static;

    /// Runs its operators.
    type Stage: Stage<Op = Self::Op, Start = Self::Start>;

    /// Every kind with its weight, unless a [`Generator`](crate::program::Generator) sets another.
    const KINDS: &'static [(Self::Kind, u32)];

    /// Draws the arguments of an operator of this kind.
    fn op(kind: Self::Kind, source: &mut impl Choose) -> Self::Op;

    /// The first operator of a generated program, if its kind has a positive weight: later operators need its element.
    #[must_use]
    fn first() -> Option<(Self::Kind, Self::Op)> {
        None
    }
}

/// Names a list entry: the position of the operator that added it, and a number among that operator's entries.
pub type Name = (usize, usize);

/// A run of a program, with names for the entries of each list.
pub trait Stage {
    /// The operators that it runs.
    type Op;
    /// The structure with which it begins.
    type Start;

    /// The run before the first operator.
    fn new(start: &Self::Start) -> Self;

    /// Returns the operator with other numbers. `number` gets the names in a list, and a number that counts in it.
    fn rewrite(&self, op: &Self::Op, number: &mut impl FnMut(&[Name], u32) -> u32) -> Self::Op;

    /// Runs an operator.
    fn step(&mut self, op: &Self::Op, place: usize);
}

/// An argument of an operator.
pub trait Argument: Clone {
    /// The lists in which its numbers count.
    type List;
    /// The arguments before it on which it depends.
    type Context;

    /// Draws an argument. `upper` is a number below 8 that all arguments of an operator share.
    fn draw(source: &mut impl Choose, upper: u8) -> Self;

    /// Writes its words, each preceded by a space.
    ///
    /// # Errors
    /// The errors of the formatter.
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result;

    /// Reads its words.
    ///
    /// # Errors
    /// The words are not a valid argument.
    fn read(words: &mut Words<'_>) -> Result<Self, ParseError>;

    /// Returns every simpler argument, the simplest first.
    fn simpler(&self) -> Vec<Self>;

    /// Returns the argument with other numbers. An argument without numbers is unchanged.
    #[must_use]
    fn renumber(&self, context: Self::Context, number: &mut impl FnMut(Self::List, u32) -> u32) -> Self {
        let _ = (context, number);
        self.clone()
    }
}

/// A variant of an argument: the prefix of its word, its constructor, and its list.
pub type Variant<P, L> = (&'static str, fn(u32) -> P, L);

/// An argument that is a number in one of several lists: one variant for each list.
pub trait Numbered: Copy + 'static {
    /// The lists.
    type List: Copy + 'static;

    /// Its words, as named in errors.
    const EXPECTED: Expected;

    /// The variants, the simplest first.
    const VARIANTS: &'static [Variant<Self, Self::List>];

    /// Returns the variant's position in `VARIANTS`, and the number.
    fn number(self) -> (usize, u32);

    /// Draws an argument.
    fn choose(source: &mut impl Choose) -> Self;

    /// Reads the word that [`write_word`](Self::write_word) writes.
    fn of_word(word: &str) -> Option<Self> {
        Self::VARIANTS.iter().find_map(|(prefix, variant, _)| number(word, prefix).map(variant))
    }

    /// Writes the prefix and the number.
    ///
    /// # Errors
    /// The errors of the formatter.
    fn write_word(self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (variant, k) = self.number();
        write!(f, "{}{k}", Self::VARIANTS[variant].0)
    }
}

impl<P: Numbered> Argument for P {
    type List = P::List;
    type Context = ();

    fn draw(source: &mut impl Choose, _: u8) -> Self {
        P::choose(source)
    }

    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(" ")?;
        self.write_word(f)
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        words.take(P::EXPECTED, P::of_word)
    }

    fn simpler(&self) -> Vec<Self> {
        let (variant, k) = self.number();
        let first = (variant > 0).then(|| P::VARIANTS[0].1(k));
        first.into_iter().chain(smaller(k).map(P::VARIANTS[variant].1)).collect()
    }

    fn renumber(&self, (): (), number: &mut impl FnMut(P::List, u32) -> u32) -> Self {
        let (variant, k) = self.number();
        let (_, make, list) = P::VARIANTS[variant];
        make(number(list, k))
    }
}

/// Smaller numbers, the smallest first. Subtracting two keeps the side of an edge; subtracting one or halving may not.
pub fn smaller(k: u32) -> impl Iterator<Item = u32> {
    let mut all = vec![0, 1, k / 2, k.saturating_sub(2), k.saturating_sub(1)];
    all.sort_unstable();
    all.dedup();
    all.into_iter().filter(move |smaller| *smaller < k)
}

/// Writes the positions of the bits of a mask, separated by commas.
///
/// # Errors
/// The errors of the formatter.
pub fn write_mask(f: &mut fmt::Formatter<'_>, mask: u16) -> fmt::Result {
    let mut before = "";
    for bit in (0..16).filter(|bit| mask >> bit & 1 == 1) {
        write!(f, "{before}{bit}")?;
        before = ",";
    }
    Ok(())
}

/// Masks with fewer bits, the simplest first.
pub fn smaller_masks(mask: u16) -> impl Iterator<Item = u16> {
    let bits = (0..16).map(|bit| 1 << bit).filter(move |bit| mask & bit != 0 && *bit != mask);
    (mask != 0).then_some(0).into_iter().chain(bits.map(move |bit| mask & !bit))
}

/// Defines a language from its table: operators and their kinds, programs, text, and simpler operators. A row lists the variant, the
/// name, the weight, and the arguments, each with the earlier arguments that it depends on in brackets.
#[macro_export]
macro_rules! language {
    (
        header $header:literal $expected:ident,
        $(#[$op_doc:meta])* op $op:ident over $list:ty,
        $(#[$kind_doc:meta])* kind $kind:ident,
        $(#[$program_doc:meta])* program $program:ident,
        $($(#[$doc:meta])* $variant:ident $name:ident $share:literal {
            $($arg:ident: $pick:ty $([$($depends:expr),+])?),*
        })*
    ) => {
        $(#[$op_doc])*
        #[derive(Clone, Debug, PartialEq, Eq, Hash)]
        pub enum $op {
            $($(#[$doc])* $variant { $($arg: $pick),* },)*
        }

        $(#[$kind_doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $kind {
            $(
                #[doc = concat!("[`", stringify!($op), "::", stringify!($variant), "`].")]
                $variant,
            )*
        }

        impl $kind {
            /// All kinds, each with its weight relative to the others.
            pub const SHARES: &[(Self, u32)] = &[$((Self::$variant, $share)),*];

            /// The name used in texts.
            #[must_use]
            pub const fn name(self) -> &'static str {
                $op::NAMES[self as usize]
            }
        }

        impl $op {
            /// The names used in texts, in the order of the kinds.
            pub const NAMES: &[&str] = &[$(stringify!($name)),*];

            /// The kind of this operator, without arguments.
            #[must_use]
            pub const fn kind(&self) -> $kind {
                match self {
                    $(Self::$variant { .. } => $kind::$variant,)*
                }
            }

            /// The name used in texts.
            #[must_use]
            pub const fn name(&self) -> &'static str {
                self.kind().name()
            }

            /// Returns all operators with one argument simplified.
            #[must_use]
            pub fn simpler(&self) -> alloc::vec::Vec<Self> {
                use $crate::program::language::Argument;
                let mut all = alloc::vec::Vec::new();
                match self {
                    $(Self::$variant { $($arg),* } => {
                        $(for simpler in Argument::simpler($arg) {
                            let mut other = self.clone();
                            if let Self::$variant { $arg, .. } = &mut other {
                                *$arg = simpler;
                            }
                            all.push(other);
                        })*
                    })*
                }
                all
            }

            /// Draws the arguments.
            pub fn draw(kind: $kind, source: &mut impl $crate::program::choose::Choose, upper: u8) -> Self {
                use $crate::program::language::Argument;
                match kind {
                    $($kind::$variant => Self::$variant { $($arg: Argument::draw(source, upper)),* },)*
                }
            }

            /// Returns the operator with other numbers.
            #[must_use]
            pub fn renumber(&self, number: &mut impl FnMut($list, u32) -> u32) -> Self {
                use $crate::program::language::Argument;
                match self.clone() {
                    $(Self::$variant { $($arg),* } => {
                        $(let $arg = Argument::renumber(&$arg, ($($($depends),+)?), number);)*
                        Self::$variant { $($arg),* }
                    })*
                }
            }

            fn read(words: &mut $crate::program::text::Words<'_>) -> Result<Self, $crate::program::ParseError> {
                use $crate::program::{language::Argument, text::Expected};
                let start = words.error(Expected::Operator);
                let op = match words.take(Expected::Operator, Some)? {
                    $(stringify!($name) => Self::$variant { $($arg: Argument::read(words)?),* },)*
                    _ => return Err(start),
                };
                words.end().map(|()| op)
            }
        }

        /// One line of a program's text.
        impl core::fmt::Display for $op {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.write_str(self.name())?;
                match self {
                    $(Self::$variant { $($arg),* } => {
                        $($crate::program::language::Argument::write($arg, f)?;)*
                    })*
                }
                Ok(())
            }
        }

        impl core::str::FromStr for $op {
            type Err = $crate::program::ParseError;

            /// Reads one line of a program's text.
            fn from_str(line: &str) -> Result<Self, Self::Err> {
                Self::read(&mut $crate::program::text::Words::new(1, line))
            }
        }

        $(#[$program_doc])*
        #[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
        pub struct $program(pub alloc::vec::Vec<$op>);

        impl $crate::program::language::Sequence for $program {
            type Op = $op;

            fn ops(&self) -> &[$op] {
                &self.0
            }

            fn from_ops(ops: alloc::vec::Vec<$op>) -> Self {
                Self(ops)
            }

            fn simpler(op: &$op) -> alloc::vec::Vec<$op> {
                op.simpler()
            }
        }

        impl FromIterator<$op> for $program {
            fn from_iter<I: IntoIterator<Item = $op>>(ops: I) -> Self {
                Self(ops.into_iter().collect())
            }
        }

        /// Writes the text that `FromStr` reads: a header, and one operator per line.
        impl core::fmt::Display for $program {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                writeln!(f, $header)?;
                self.0.iter().try_for_each(|op| writeln!(f, "{op}"))
            }
        }

        impl core::str::FromStr for $program {
            type Err = $crate::program::ParseError;

            /// Reads a program from its text. Empty lines and text after a `#` are ignored. O(length).
            fn from_str(text: &str) -> Result<Self, Self::Err> {
                use $crate::program::text::{Expected, lines};
                lines(text, $header, Expected::$expected, $op::read).map(Self)
            }
        }
    };
}
