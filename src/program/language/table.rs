//! From a table of operators to a language.

/// Defines a language from its table: operators and their kinds, programs, their text, and what is simpler. A row reads: variant,
/// method, how often it is drawn, and its arguments, each with the earlier ones that it depends on.
macro_rules! language {
    (
        header $header:literal $expected:ident,
        methods of $subject:literal $path:literal,
        $(#[$op_doc:meta])* op $op:ident over $list:ty,
        $(#[$kind_doc:meta])* kind $kind:ident,
        $(#[$program_doc:meta])* program $program:ident,
        $($variant:ident $method:ident $share:literal { $($arg:ident: $pick:ty, $depends:tt;)* })*
    ) => {
        $(#[$op_doc])*
        #[derive(Clone, Debug, PartialEq, Eq, Hash)]
        pub enum $op {
            $(
                #[doc = concat!("[`", $subject, "::", stringify!($method), "`](", $path, "::", stringify!($method), ").")]
                $variant { $($arg: $pick),* },
            )*
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
                match self {
                    $(Self::$variant => stringify!($method),)*
                }
            }
        }

        impl $op {
            /// All names, as texts have them.
            pub const NAMES: &[&str] = &[$(stringify!($method)),*];

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

            /// The same with one argument simplified, in every way there is.
            #[must_use]
            pub fn simpler(&self) -> alloc::vec::Vec<Self> {
                use $crate::program::language::argument::{Argument, replaced};
                let mut all = alloc::vec::Vec::new();
                match self {
                    $(Self::$variant { $($arg),* } => {
                        $(for simpler in Argument::simpler($arg) {
                            all.push(replaced(self, |op| if let Self::$variant { $arg, .. } = op { *$arg = simpler }));
                        })*
                    })*
                }
                all
            }

            /// Draws the arguments by the choices of a source.
            pub(in $crate) fn draw(kind: $kind, source: &mut impl $crate::program::choose::Choose, upper: u8) -> Self {
                use $crate::program::language::argument::Argument;
                match kind {
                    $($kind::$variant => Self::$variant { $($arg: Argument::draw(source, upper)),* },)*
                }
            }

            /// The same with other numbers.
            pub(in $crate) fn renumber(&self, number: &mut impl FnMut($list, u32) -> u32) -> Self {
                use $crate::program::language::argument::Argument;
                match self.clone() {
                    $(Self::$variant { $($arg),* } => {
                        $(let $arg = Argument::renumber(&$arg, $depends, number);)*
                        Self::$variant { $($arg),* }
                    })*
                }
            }

            fn read(
                words: &mut $crate::program::language::words::Words<'_>,
            ) -> Result<Self, $crate::program::ParseError> {
                use $crate::program::language::{argument::Argument, words::Expected};
                let start = words.error(Expected::Operator);
                let op = match words.take(Expected::Operator, Some)? {
                    $(stringify!($method) => Self::$variant { $($arg: Argument::read(words)?),* },)*
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
                        $($crate::program::language::argument::Argument::write($arg, f)?;)*
                    })*
                }
                Ok(())
            }
        }

        impl core::str::FromStr for $op {
            type Err = $crate::program::ParseError;

            /// Reads one line of a program's text.
            fn from_str(line: &str) -> Result<Self, Self::Err> {
                Self::read(&mut $crate::program::language::words::Words::new(1, line))
            }
        }

        $(#[$program_doc])*
        #[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
        pub struct $program(pub alloc::vec::Vec<$op>);

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
                use $crate::program::language::words::{Expected, lines};
                lines(text, $header, Expected::$expected, $op::read).map(Self)
            }
        }

        impl $crate::program::language::script::Sequence for $program {
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
    };
}
pub(crate) use language;
