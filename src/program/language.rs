//! Languages of programs, whatever their operators: arguments, text, and what generation and shrinking need.
//!
//! A table of operators becomes a language by the macro [`language`](crate::language): that of operators is in `program::operators`.

use super::choose::Choose;
use super::text::{Expected, ParseError, Words, number};
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

/// A sequence of operators.
pub trait Sequence: Clone + PartialEq + fmt::Debug + 'static {
    /// Its operators.
    type Op: Clone + PartialEq + fmt::Debug + 'static;

    /// The operators of a program.
    fn ops(&self) -> &[Self::Op];

    /// The program of these operators.
    fn from_ops(ops: Vec<Self::Op>) -> Self;

    /// An operator with one argument simplified, in every way there is.
    fn simpler(op: &Self::Op) -> Vec<Self::Op>;
}

/// A language of programs, such as [`Program`](crate::program::Program) for the operators of a [`Dcel`](crate::dcel::Dcel).
///
/// Each can be [generated](crate::program::Generator), [shrunk](crate::program::shrink()), written down and read.
pub trait Language: Sequence {
    /// The kinds of its operators.
    type Kind: Copy + PartialEq + fmt::Debug + 'static;

    /// The structure with which programs begin; by default the empty one.
    type Start: Clone + fmt::Debug + Default + 'static;

    /// The run of its operators.
    type Stage: Stage<Op = Self::Op, Start = Self::Start>;

    /// Every kind, and how often it is chosen unless a [`Generator`](crate::program::Generator) says otherwise.
    const KINDS: &'static [(Self::Kind, u32)];

    /// An operator of this kind, with arguments that the source chooses.
    fn op(kind: Self::Kind, source: &mut impl Choose) -> Self::Op;

    /// The first operator of a generated program if this kind is generated at all: without it there is nothing to be done.
    #[must_use]
    fn first() -> Option<(Self::Kind, Self::Op)> {
        None
    }
}

/// The operator that put something on a list, by its place in the program, and which of its things.
pub type Name = (usize, usize);

/// A run of a program, with names for the entries of each list.
pub trait Stage {
    /// The operators that it runs.
    type Op;
    /// The structure with which it begins.
    type Start;

    /// The run before the first operator.
    fn new(start: &Self::Start) -> Self;

    /// The operator with other numbers. `number` is given the names in the list in which each number counts.
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

    /// Draws one by the choices of a source. `upper` is a number below 8 that all arguments of an operator share.
    fn draw(source: &mut impl Choose, upper: u8) -> Self;

    /// Writes its words, with a space before each.
    ///
    /// # Errors
    /// Those of the formatter.
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result;

    /// Reads its words.
    ///
    /// # Errors
    /// The words are not those of such an argument.
    fn read(words: &mut Words<'_>) -> Result<Self, ParseError>;

    /// The argument in every way in which it is simpler, the simplest first.
    fn simpler(&self) -> Vec<Self>;

    /// The argument with other numbers. One without numbers stays as it is.
    #[must_use]
    fn renumber(&self, context: Self::Context, number: &mut impl FnMut(Self::List, u32) -> u32) -> Self {
        let _ = (context, number);
        self.clone()
    }
}

/// A variant of an argument: the prefix of its word, the variant, and the list.
pub type Variant<P, L> = (&'static str, fn(u32) -> P, L);

/// An argument that chooses from one list or another by a number: a variant for each list.
pub trait Numbered: Copy + 'static {
    /// The lists.
    type List: Copy + 'static;

    /// Its words, as errors call them.
    const EXPECTED: Expected;

    /// The variants, the simplest first.
    const VARIANTS: &'static [Variant<Self, Self::List>];

    /// The place of the variant in `VARIANTS`, and the number.
    fn number(self) -> (usize, u32);

    /// Draws one by the choices of a source.
    fn choose(source: &mut impl Choose) -> Self;

    /// Reads the word that [`write_word`](Self::write_word) writes.
    fn of_word(word: &str) -> Option<Self> {
        Self::VARIANTS.iter().find_map(|(prefix, variant, _)| number(word, prefix).map(variant))
    }

    /// Writes the prefix and the number.
    ///
    /// # Errors
    /// Those of the formatter.
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

/// Smaller numbers, the smallest first. Two less keeps the side of an edge, which one less and the half may not.
pub fn smaller(k: u32) -> impl Iterator<Item = u32> {
    let mut all = vec![0, 1, k / 2, k.saturating_sub(2), k.saturating_sub(1)];
    all.sort_unstable();
    all.dedup();
    all.into_iter().filter(move |smaller| *smaller < k)
}

/// Writes the places of the bits of a mask, with commas between them.
///
/// # Errors
/// Those of the formatter.
pub fn write_mask(f: &mut fmt::Formatter<'_>, mask: u16) -> fmt::Result {
    let mut before = "";
    for bit in (0..16).filter(|bit| mask >> bit & 1 == 1) {
        write!(f, "{before}{bit}")?;
        before = ",";
    }
    Ok(())
}

/// Masks without one bit or more, the simplest first.
pub fn smaller_masks(mask: u16) -> impl Iterator<Item = u16> {
    let bits = (0..16).map(|bit| 1 << bit).filter(move |bit| mask & bit != 0 && *bit != mask);
    (mask != 0).then_some(0).into_iter().chain(bits.map(move |bit| mask & !bit))
}

/// Defines a language from its table: operators and their kinds, programs, their text, and what is simpler. A row reads: variant,
/// name, how often it is drawn, and its arguments, each with the earlier ones that it depends on in brackets.
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
            /// All kinds, each with how often it is drawn, in proportion to the others.
            pub const SHARES: &[(Self, u32)] = &[$((Self::$variant, $share)),*];

            /// The name, as texts have it.
            #[must_use]
            pub const fn name(self) -> &'static str {
                $op::NAMES[self as usize]
            }
        }

        impl $op {
            /// All names, as texts have them, in the order of the kinds.
            pub const NAMES: &[&str] = &[$(stringify!($name)),*];

            /// The kind: all but the arguments.
            #[must_use]
            pub const fn kind(&self) -> $kind {
                match self {
                    $(Self::$variant { .. } => $kind::$variant,)*
                }
            }

            /// The name, as texts have it.
            #[must_use]
            pub const fn name(&self) -> &'static str {
                self.kind().name()
            }

            /// All operators with one argument simplified.
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

            /// Draws the arguments by the choices of a source.
            pub fn draw(kind: $kind, source: &mut impl $crate::program::choose::Choose, upper: u8) -> Self {
                use $crate::program::language::Argument;
                match kind {
                    $($kind::$variant => Self::$variant { $($arg: Argument::draw(source, upper)),* },)*
                }
            }

            /// The operator with other numbers.
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

        /// The text that `FromStr` reads: a header, and one operator per line.
        impl core::fmt::Display for $program {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                writeln!(f, $header)?;
                self.0.iter().try_for_each(|op| writeln!(f, "{op}"))
            }
        }

        impl core::str::FromStr for $program {
            type Err = $crate::program::ParseError;

            /// Reads a program from its text. Empty lines count for nothing, nor does what follows a `#`. O(length).
            fn from_str(text: &str) -> Result<Self, Self::Err> {
                use $crate::program::text::{Expected, lines};
                lines(text, $header, Expected::$expected, $op::read).map(Self)
            }
        }
    };
}
