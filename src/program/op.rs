//! The language: operators whose arguments are small numbers, so that any bytes are a program that runs.

use super::table::operators;
use crate::dcel::{Corner, Side, Turn};
use alloc::vec::Vec;

/// Chooses a half-edge by its position in order of creation, modulo their number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum HalfEdgePick {
    /// Of those there are. The two of an edge stand side by side.
    Live(u16),
    /// Of those that were removed: a stale handle, on purpose.
    Retired(u16),
}

/// Chooses a vertex that is to be an isolated one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum VertexPick {
    /// Of the isolated vertices.
    Isolated(u16),
    /// The origin of this half-edge, of those there are: not isolated, on purpose.
    OriginOf(u16),
    /// Of the vertices that were removed: a stale handle, on purpose.
    Retired(u16),
}

/// Chooses a corner, or what lies on it: a boundary component, or a face.
pub type CornerPick = Corner<HalfEdgePick, VertexPick>;

/// Chooses the second of two corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum SecondPick {
    /// Of the corners that fit the first one, itself among them: those in the same face, or those at the same vertex.
    /// Half-edges come before isolated vertices.
    Fitting(u16),
    /// Whichever, fitting or not.
    Any(CornerPick),
}

/// Chooses a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FacePick {
    /// The unbounded one.
    Unbounded,
    /// The one in which this corner lies.
    Of(CornerPick),
    /// Of those that were removed: a stale handle, on purpose.
    Retired(u16),
}

/// Chooses the boundary components that go to the new face when a face is split.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct InnerPick {
    /// The boundary components of the face, without the one that is split, are counted in order of their first corners. The
    /// `i`-th one goes if bit `i % 16` is set.
    pub mask: u16,
    /// One more, whether it may go there or not.
    pub also: Option<CornerPick>,
}

macro_rules! define_op {
    ($($variant:ident $method:ident $share:literal {
        changes [$($change:expr),+]
        $($arg:ident: $pick:ty => $handle:ty, $depends:tt;)*
    })*) => {
        /// One operator with its arguments.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[allow(missing_docs, reason = "the arguments are those of the methods of `Subject` of the same names")]
        pub enum Op {
            $(
                #[doc = concat!("[`Subject::", stringify!($method), "`](super::Subject::", stringify!($method), ").")]
                $variant { $($arg: $pick),* },
            )*
        }

        /// The kinds of operators, for a [`Generator`](super::Generator).
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum OpKind {
            $(
                #[doc = concat!("[`Op::", stringify!($variant), "`].")]
                $variant,
            )*
        }

        impl OpKind {
            /// All kinds, each with how many of 32 random operators are of this kind. Those for meshes are drawn only if they
            /// are given a weight.
            pub const SHARES: &[(Self, u32)] = &[$((Self::$variant, $share)),*];

            /// The name of the operator, as texts have it.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => stringify!($method),)*
                }
            }
        }

        const _: () = assert!(0 $(+ $share)* == 32, "the first byte of an operator chooses among 32");

        impl Op {
            /// The names of all operators, as texts have them.
            pub const NAMES: &[&str] = &[$(stringify!($method)),*];

            /// The name of the operator.
            #[must_use]
            pub const fn name(self) -> &'static str {
                self.kind().name()
            }

            /// The operator with which these bytes begin. None if they end too early. At most 14 bytes are taken.
            ///
            /// In random bytes, operators that make something are more frequent than those that remove it, and arguments
            /// that fit are more frequent than those that are refused.
            pub fn from_bytes(bytes: &mut impl Iterator<Item = u8>) -> Option<Self> {
                let first = bytes.next()?;
                let mut kind = first & 31;
                $(
                    #[allow(unused_comparisons, clippy::absurd_extreme_comparisons, reason = "a share may be 0")]
                    if kind < $share {
                        return Self::of_kind(OpKind::$variant, first >> 5, bytes);
                    }
                    kind -= $share;
                )*
                None
            }

            /// An operator of this kind, with arguments from bytes. `upper` is a number below 8.
            pub(super) fn of_kind(kind: OpKind, upper: u8, bytes: &mut impl Iterator<Item = u8>) -> Option<Self> {
                Some(match kind {
                    $(OpKind::$variant => Self::$variant { $($arg: FromBytes::from_bytes(upper, bytes)?),* },)*
                })
            }

            /// The operator without its arguments.
            #[must_use]
            pub const fn kind(self) -> OpKind {
                match self {
                    $(Self::$variant { .. } => OpKind::$variant,)*
                }
            }

            /// What the operator may add to the counts of a map, if it is applied.
            #[must_use]
            pub const fn changes(self) -> &'static [CountChange] {
                match self {
                    $(Self::$variant { .. } => const { &[$(CountChange::of($change)),+] },)*
                }
            }
        }
    };
}
operators!(define_op);

/// How the counts of a map change.
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

/// A sequence of operators, to be run by a [`Runner`](super::Runner) from the empty map or any other start.
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
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Program(pub Vec<Op>);

impl Program {
    /// The program that these bytes encode. An incomplete operator at the end is ignored. O(bytes).
    #[must_use]
    pub fn from_bytes(bytes: &[u8]) -> Self {
        let mut bytes = bytes.iter().copied();
        Self(core::iter::from_fn(|| Op::from_bytes(&mut bytes)).collect())
    }
}

impl FromIterator<Op> for Program {
    fn from_iter<I: IntoIterator<Item = Op>>(ops: I) -> Self {
        Self(ops.into_iter().collect())
    }
}

/// An argument from bytes. `upper` is what the first byte of the operator has left.
trait FromBytes: Sized {
    fn from_bytes(upper: u8, bytes: &mut impl Iterator<Item = u8>) -> Option<Self>;
}

/// One byte for numbers below 240, two for those below 4,096.
fn number(bytes: &mut impl Iterator<Item = u8>) -> Option<u16> {
    match bytes.next()? {
        byte @ 0..=0xEF => Some(byte.into()),
        byte => Some(u16::from(byte & 0x0F) << 8 | u16::from(bytes.next()?)),
    }
}

impl FromBytes for HalfEdgePick {
    fn from_bytes(_: u8, bytes: &mut impl Iterator<Item = u8>) -> Option<Self> {
        Some(match bytes.next()? & 15 {
            0..=14 => Self::Live(number(bytes)?),
            _ => Self::Retired(number(bytes)?),
        })
    }
}

impl FromBytes for VertexPick {
    fn from_bytes(_: u8, bytes: &mut impl Iterator<Item = u8>) -> Option<Self> {
        Some(match bytes.next()? & 15 {
            0..=12 => Self::Isolated(number(bytes)?),
            13 => Self::OriginOf(number(bytes)?),
            _ => Self::Retired(number(bytes)?),
        })
    }
}

impl FromBytes for CornerPick {
    fn from_bytes(_: u8, bytes: &mut impl Iterator<Item = u8>) -> Option<Self> {
        Some(match bytes.next()? & 31 {
            0..=23 => Self::At(HalfEdgePick::Live(number(bytes)?)),
            24..=28 => Self::Isolated(VertexPick::Isolated(number(bytes)?)),
            29 => Self::Isolated(VertexPick::OriginOf(number(bytes)?)),
            30 => Self::Isolated(VertexPick::Retired(number(bytes)?)),
            _ => Self::At(HalfEdgePick::Retired(number(bytes)?)),
        })
    }
}

impl FromBytes for SecondPick {
    fn from_bytes(upper: u8, bytes: &mut impl Iterator<Item = u8>) -> Option<Self> {
        Some(match bytes.next()? & 7 {
            0..=6 => Self::Fitting(number(bytes)?),
            _ => Self::Any(FromBytes::from_bytes(upper, bytes)?),
        })
    }
}

impl FromBytes for FacePick {
    fn from_bytes(upper: u8, bytes: &mut impl Iterator<Item = u8>) -> Option<Self> {
        Some(match bytes.next()? & 15 {
            0..=7 => Self::Unbounded,
            8..=14 => Self::Of(FromBytes::from_bytes(upper, bytes)?),
            _ => Self::Retired(number(bytes)?),
        })
    }
}

impl FromBytes for InnerPick {
    fn from_bytes(upper: u8, bytes: &mut impl Iterator<Item = u8>) -> Option<Self> {
        if upper & 6 != 0 {
            return Some(Self::default());
        }
        let mask = u16::from_le_bytes([bytes.next()?, bytes.next()?]);
        let also = match bytes.next()? & 7 {
            0 => Some(FromBytes::from_bytes(upper, bytes)?),
            _ => None,
        };
        Some(Self { mask, also })
    }
}

impl FromBytes for Side {
    fn from_bytes(upper: u8, _: &mut impl Iterator<Item = u8>) -> Option<Self> {
        Some(if upper & 1 == 0 { Self::Left } else { Self::Right })
    }
}

impl FromBytes for Turn {
    fn from_bytes(upper: u8, _: &mut impl Iterator<Item = u8>) -> Option<Self> {
        Some(if upper & 1 == 0 { Self::CounterClockwise } else { Self::Clockwise })
    }
}
