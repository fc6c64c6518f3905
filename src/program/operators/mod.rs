//! The language of operators: its arguments are small numbers, so that any bytes are a program that runs.

mod arguments;
mod call;
mod table;

use super::language::choose::Choose;
use super::language::table::language;
use crate::dcel::{Side, Turn};
use alloc::format;
use alloc::string::String;
use arguments::ToRust;
pub use arguments::{CornerPick, FacePick, HalfEdgePick, InnerPick, SecondPick, VertexPick};
pub(in crate::program) use arguments::{Fit, List};
pub use call::{Call, CallOf};
pub(in crate::program) use table::operators;

macro_rules! define_language {
    ($($variant:ident $method:ident $share:literal {
        changes [$($change:expr),+]
        $($arg:ident: $pick:ty => $handle:ty, $depends:tt;)*
    })*) => {
        language! {
            header "twinedge program 1" Header,
            methods of "Subject" "crate::program::Subject",
            /// One operator with its arguments.
            #[derive(Copy)]
            #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
            #[allow(missing_docs, reason = "the arguments are those of the methods of `Subject` of the same names")]
            op Op over List,
            /// The kinds of operators, for a [`Generator`](crate::program::Generator). Of 32 random operators, so many are of a kind as
            /// [`SHARES`](Self::SHARES) says. Those for meshes are drawn only if they are given a weight.
            kind OpKind,
            /// A sequence of operators, to be run by a [`Runner`](crate::program::Runner) from the empty map or any other start.
            ///
            /// # As text
            ///
            /// [`Display`](core::fmt::Display) writes an operator to a line, [`FromStr`](core::str::FromStr) reads it back, and `#` begins a comment:
            ///
            /// ```text
            /// twinedge program 1
            /// add_isolated_vertex unbounded
            /// split_vertex i0 ~0                   # the second corner is the first that fits
            /// connect h0 h1 left inner 0,2 also h5 # the new face to the left, with inner boundary components 0 and 2, and that of h5
            /// remove_edge !h0                      # a stale handle
            /// ```
            ///
            /// | word | chooses |
            /// | --- | --- |
            /// | `h3` | the half-edge with number 3 (counted from 0), and its corner |
            /// | `i3` | the isolated vertex with number 3, and its corner |
            /// | `o3` | the origin of `h3`, taken for an isolated vertex |
            /// | `!h3`, `!v3`, `!f3` | of the half-edges, vertices, faces that were removed |
            /// | `~3` | of the corners that fit the first one |
            /// | `unbounded` | the unbounded face |
            ///
            /// Numbers count from 0, modulo the length of the list: half-edges in order of creation, those of an edge side by side, those of the
            /// start first; isolated vertices in the order in which they became so.
            ///
            /// ```
            /// use twinedge::program::{StepOutcome, Program, Runner};
            /// let program = Program::from_bytes(b"any bytes are a program");
            /// let mut runner = Runner::new(twinedge::dcel::Dcel::new());
            /// for op in &program.0 {
            ///     runner.step(*op);
            ///     assert!(runner.subject().validate().is_valid());
            /// }
            /// // It can be written down, and read again.
            /// assert_eq!(program.to_string().parse(), Ok(program));
            /// ```
            #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
            program Program,
            $($variant $method $share { $($arg: $pick, $depends;)* })*
        }

        const _: () = assert!(0 $(+ $share)* == 32, "the first byte of an operator chooses among 32");

        impl OpKind {
            /// The changes that an operator of this kind may make to the counts of a map, if it is applied.
            #[must_use]
            pub const fn changes(self) -> &'static [CountChange] {
                match self {
                    $(Self::$variant => const { &[$(CountChange::of($change)),+] },)*
                }
            }
        }

        impl Op {
            /// The operator as a Rust expression, to be read where `twinedge::program::*` is in scope.
            #[must_use]
            pub fn to_rust(&self) -> String {
                match self {
                    $(Self::$variant { $($arg),* } => {
                        let arguments = [$(format!(concat!(stringify!($arg), ": {}"), $arg.to_rust())),*];
                        format!(concat!("Op::", stringify!($variant), " {{ {} }}"), arguments.join(", "))
                    })*
                }
            }
        }
    };
}
operators!(define_language);

/// A change of the counts of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CountChange {
    /// V.
    pub vertices: i8,
    /// E.
    pub edges: i8,
    /// F.
    pub faces: i8,
    /// C.
    pub components: i8,
}

impl CountChange {
    const fn of((vertices, edges, faces, components): (i8, i8, i8, i8)) -> Self {
        Self { vertices, edges, faces, components }
    }
}

/// Choices from bytes, of which it is known whether they have sufficed.
struct Finite<'a, I> {
    bytes: &'a mut I,
    is_over: bool,
}

impl<I: Iterator<Item = u8>> Choose for Finite<'_, I> {
    fn choose(&mut self, n: usize) -> usize {
        let byte = self.bytes.next();
        self.is_over |= byte.is_none();
        usize::from(byte.unwrap_or_default()) % n.max(1)
    }
}

impl Op {
    /// The operator with which these bytes begin. None if they end too early. At most 14 bytes are taken.
    ///
    /// In random bytes, operators that make something are more frequent than those that remove it, and arguments
    /// that fit are more frequent than those that are refused.
    pub fn from_bytes(bytes: &mut impl Iterator<Item = u8>) -> Option<Self> {
        let first = bytes.next()?;
        let mut place = u32::from(first & 31);
        let (kind, _) = OpKind::SHARES.iter().find(|(_, share)| {
            let is_it = place < *share;
            place = place.saturating_sub(*share);
            is_it
        })?;
        let mut source = Finite { bytes, is_over: false };
        let op = Self::draw(*kind, &mut source, first >> 5);
        (!source.is_over).then_some(op)
    }
}

impl Program {
    /// The program that these bytes encode. An incomplete operator at the end is ignored. O(bytes).
    #[must_use]
    pub fn from_bytes(bytes: &[u8]) -> Self {
        let mut bytes = bytes.iter().copied();
        Self(core::iter::from_fn(|| Op::from_bytes(&mut bytes)).collect())
    }

    /// The program as a Rust expression, to be read where `twinedge::program::*` is in scope.
    #[must_use]
    pub fn to_rust(&self) -> String {
        let lines = self.0.iter().fold(String::new(), |lines, op| lines + "    " + &op.to_rust() + ",\n");
        format!("Program(vec![\n{lines}])")
    }
}
