//! The language: operators whose arguments are small numbers, so that any bytes are a program that runs.

use super::subject::Corner;
use crate::dcel::{Side, Turn};
use alloc::vec::Vec;

/// Chooses a half-edge. Counting is in order of creation and starts again where the list ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum HalfEdgePick {
    /// Of those there are. The two of an edge stand side by side.
    Live(u16),
    /// Of those that are gone: a stale handle, on purpose.
    Retired(u16),
}

/// Chooses a vertex that is to be an isolated one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum VertexPick {
    /// Of the isolated vertices.
    Isolated(u16),
    /// The origin of this half-edge, of those there are: not isolated, on purpose.
    OriginOf(u16),
    /// Of the vertices that are gone: a stale handle, on purpose.
    Retired(u16),
}

/// Chooses a corner, or what lies on it: a boundary component, or a face.
pub type CornerPick = Corner<HalfEdgePick, VertexPick>;

/// Chooses the second of two corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SecondPick {
    /// Of the corners that fit the first one, itself among them: those in the same face, or those at the same vertex.
    /// Half-edges come before isolated vertices.
    Fitting(u16),
    /// Whichever, fitting or not.
    Any(CornerPick),
}

/// Chooses a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FacePick {
    /// The unbounded one.
    Unbounded,
    /// The one in which this corner lies.
    Of(CornerPick),
    /// Of those that are gone: a stale handle, on purpose.
    Retired(u16),
}

/// Chooses the boundary components that go to the new face when a face is split.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct InnerPick {
    /// The boundary components of the face but the one that is split are counted as their first corners were made; the
    /// `i`-th goes if bit `i % 16` is set.
    pub mask: u16,
    /// One more, whether it may go there or not.
    pub also: Option<CornerPick>,
}

/// One operator with its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the arguments are those of the methods of `Subject` of the same names")]
pub enum Op {
    /// [`Subject::add_isolated_vertex`](super::Subject::add_isolated_vertex).
    AddIsolatedVertex { face: FacePick },
    /// [`Subject::remove_isolated_vertex`](super::Subject::remove_isolated_vertex).
    RemoveIsolatedVertex { vertex: VertexPick },
    /// [`Subject::connect`](super::Subject::connect).
    Connect { from: CornerPick, to: SecondPick, new_face: Side, inner: InnerPick },
    /// [`Subject::remove_edge`](super::Subject::remove_edge).
    RemoveEdge { half_edge: HalfEdgePick },
    /// [`Subject::split_edge`](super::Subject::split_edge).
    SplitEdge { half_edge: HalfEdgePick },
    /// [`Subject::join_edges`](super::Subject::join_edges).
    JoinEdges { half_edge: HalfEdgePick },
    /// [`Subject::split_vertex`](super::Subject::split_vertex).
    SplitVertex { from: CornerPick, to: SecondPick },
    /// [`Subject::contract_edge`](super::Subject::contract_edge).
    ContractEdge { half_edge: HalfEdgePick },
    /// [`Subject::flip_edge`](super::Subject::flip_edge).
    FlipEdge { half_edge: HalfEdgePick, turn: Turn },
    /// [`Subject::move_inner`](super::Subject::move_inner).
    MoveInner { inner: CornerPick, face: FacePick },
}

/// A sequence of operators, to be run by a [`Runner`](super::Runner) from the empty map.
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
pub struct Program(pub Vec<Op>);

impl Program {
    /// The program that these bytes are. What remains at the end and is less than an operator is left out. O(bytes).
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

impl Op {
    /// The operator with which these bytes begin, and how likely random ones make it: those that make something come
    /// more often than those that remove it, those that fit more often than those that will be refused.
    ///
    /// None if they end too early. At most 14 bytes are taken.
    pub fn from_bytes(bytes: &mut impl Iterator<Item = u8>) -> Option<Self> {
        let kind = bytes.next()?;
        let upper = kind >> 5;
        Some(match kind & 31 {
            0..=4 => Self::AddIsolatedVertex { face: face(bytes)? },
            5 => Self::RemoveIsolatedVertex { vertex: vertex(bytes)? },
            6..=14 => Self::Connect {
                from: corner(bytes)?,
                to: second(bytes)?,
                new_face: if upper & 1 == 0 { Side::Left } else { Side::Right },
                inner: if upper & 6 == 0 { inner(bytes)? } else { InnerPick::default() },
            },
            15..=17 => Self::RemoveEdge { half_edge: half_edge(bytes)? },
            18 | 19 => Self::SplitEdge { half_edge: half_edge(bytes)? },
            20 => Self::JoinEdges { half_edge: half_edge(bytes)? },
            21..=23 => Self::SplitVertex { from: corner(bytes)?, to: second(bytes)? },
            24 | 25 => Self::ContractEdge { half_edge: half_edge(bytes)? },
            26..=28 => Self::FlipEdge {
                half_edge: half_edge(bytes)?,
                turn: if upper & 1 == 0 { Turn::CounterClockwise } else { Turn::Clockwise },
            },
            _ => Self::MoveInner { inner: corner(bytes)?, face: face(bytes)? },
        })
    }
}

/// One byte for numbers below 240, two for those below 4,096.
fn number(bytes: &mut impl Iterator<Item = u8>) -> Option<u16> {
    match bytes.next()? {
        byte @ 0..=0xEF => Some(byte.into()),
        byte => Some(u16::from(byte & 0x0F) << 8 | u16::from(bytes.next()?)),
    }
}

fn half_edge(bytes: &mut impl Iterator<Item = u8>) -> Option<HalfEdgePick> {
    Some(match bytes.next()? & 15 {
        0..=14 => HalfEdgePick::Live(number(bytes)?),
        _ => HalfEdgePick::Retired(number(bytes)?),
    })
}

fn vertex(bytes: &mut impl Iterator<Item = u8>) -> Option<VertexPick> {
    Some(match bytes.next()? & 15 {
        0..=12 => VertexPick::Isolated(number(bytes)?),
        13 => VertexPick::OriginOf(number(bytes)?),
        _ => VertexPick::Retired(number(bytes)?),
    })
}

fn corner(bytes: &mut impl Iterator<Item = u8>) -> Option<CornerPick> {
    Some(match bytes.next()? & 31 {
        0..=23 => Corner::At(HalfEdgePick::Live(number(bytes)?)),
        24..=28 => Corner::Isolated(VertexPick::Isolated(number(bytes)?)),
        29 => Corner::Isolated(VertexPick::OriginOf(number(bytes)?)),
        30 => Corner::Isolated(VertexPick::Retired(number(bytes)?)),
        _ => Corner::At(HalfEdgePick::Retired(number(bytes)?)),
    })
}

fn second(bytes: &mut impl Iterator<Item = u8>) -> Option<SecondPick> {
    Some(match bytes.next()? & 7 {
        0..=6 => SecondPick::Fitting(number(bytes)?),
        _ => SecondPick::Any(corner(bytes)?),
    })
}

fn face(bytes: &mut impl Iterator<Item = u8>) -> Option<FacePick> {
    Some(match bytes.next()? & 15 {
        0..=7 => FacePick::Unbounded,
        8..=14 => FacePick::Of(corner(bytes)?),
        _ => FacePick::Retired(number(bytes)?),
    })
}

fn inner(bytes: &mut impl Iterator<Item = u8>) -> Option<InnerPick> {
    let mask = u16::from_le_bytes([bytes.next()?, bytes.next()?]);
    let also = match bytes.next()? & 7 {
        0 => Some(corner(bytes)?),
        _ => None,
    };
    Some(InnerPick { mask, also })
}
