//! Arguments of operators: numbers of half-edges, vertices and faces in order of creation.

use super::choose::Choose;
use super::language::{Argument, Numbered, Variant, smaller, smaller_masks, write_mask};
use super::text::{Expected, ParseError, Words, mask, number};
use crate::dcel::{Corner, Side, Turn};
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

/// The list in which a number counts.
#[derive(Clone, Copy, Debug)]
pub enum List {
    HalfEdges,
    Isolated,
    RetiredHalfEdges,
    RetiredVertices,
    RetiredFaces,
    /// The corners that fit the first one.
    Fitting(CornerPick, Fit),
}

/// The kind of record that two corners must have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fit {
    Face,
    Vertex,
}

/// Chooses a half-edge by its position in order of creation, modulo their number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum HalfEdgePick {
    /// A live half-edge. The two half-edges of an edge are adjacent in the list.
    Live(u32),
    /// A removed half-edge: a stale handle, on purpose.
    Retired(u32),
}

impl Numbered for HalfEdgePick {
    type List = List;

    const EXPECTED: Expected = Expected::HalfEdge;
    const VARIANTS: &'static [Variant<Self, List>] =
        &[("h", Self::Live, List::HalfEdges), ("!h", Self::Retired, List::RetiredHalfEdges)];

    fn number(self) -> (usize, u32) {
        match self {
            Self::Live(k) => (0, k),
            Self::Retired(k) => (1, k),
        }
    }

    fn choose(source: &mut impl Choose) -> Self {
        match byte(source) & 15 {
            0..=14 => Self::Live(count(source)),
            _ => Self::Retired(count(source)),
        }
    }
}

impl fmt::Display for HalfEdgePick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_word(f)
    }
}

/// Chooses an isolated vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum VertexPick {
    /// An isolated vertex.
    Isolated(u32),
    /// The origin of a live half-edge: not isolated, on purpose.
    OriginOf(u32),
    /// A removed vertex: a stale handle, on purpose.
    Retired(u32),
}

impl Numbered for VertexPick {
    type List = List;

    const EXPECTED: Expected = Expected::Vertex;
    const VARIANTS: &'static [Variant<Self, List>] = &[
        ("i", Self::Isolated, List::Isolated),
        ("o", Self::OriginOf, List::HalfEdges),
        ("!v", Self::Retired, List::RetiredVertices),
    ];

    fn number(self) -> (usize, u32) {
        match self {
            Self::Isolated(k) => (0, k),
            Self::OriginOf(k) => (1, k),
            Self::Retired(k) => (2, k),
        }
    }

    fn choose(source: &mut impl Choose) -> Self {
        match byte(source) & 15 {
            0..=12 => Self::Isolated(count(source)),
            13 => Self::OriginOf(count(source)),
            _ => Self::Retired(count(source)),
        }
    }
}

impl fmt::Display for VertexPick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_word(f)
    }
}

/// Chooses a corner, or the boundary component or face on which it lies.
pub type CornerPick = Corner<HalfEdgePick, VertexPick>;

/// Chooses the second of two corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum SecondPick {
    /// A corner that fits the first one (itself included): in the same face, or at the same vertex.
    Fitting(u32),
    /// Any corner.
    Any(CornerPick),
}

/// Chooses a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FacePick {
    /// The unbounded face.
    Unbounded,
    /// The face in which this corner lies.
    Of(CornerPick),
    /// A removed face: a stale handle, on purpose.
    Retired(u32),
}

/// Chooses the boundary components that go to the new face when a face is split.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct InnerPick {
    /// The face's boundary components, except the one being split, are counted in order of their first corners. The `i`-th
    /// one goes to the new face if bit `i % 16` is set.
    pub mask: u16,
    /// One more boundary component, whether it may go there or not.
    pub also: Option<CornerPick>,
}

fn byte(source: &mut impl Choose) -> u8 {
    source.choose(256) as u8
}

/// Draws a number: one byte for numbers below 240, two for numbers below 4,096.
fn count(source: &mut impl Choose) -> u32 {
    match byte(source) {
        low @ 0..=0xEF => low.into(),
        high => u32::from(high & 0x0F) << 8 | u32::from(byte(source)),
    }
}

impl Argument for CornerPick {
    type List = List;
    type Context = ();

    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self}")
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        words.take(Expected::Corner, corner)
    }

    fn draw(source: &mut impl Choose, _: u8) -> Self {
        match byte(source) & 31 {
            0..=23 => Self::At(HalfEdgePick::Live(count(source))),
            24..=28 => Self::Isolated(VertexPick::Isolated(count(source))),
            29 => Self::Isolated(VertexPick::OriginOf(count(source))),
            30 => Self::Isolated(VertexPick::Retired(count(source))),
            _ => Self::At(HalfEdgePick::Retired(count(source))),
        }
    }

    fn simpler(&self) -> Vec<Self> {
        match self {
            Self::At(pick) => pick.simpler().into_iter().map(Self::At).collect(),
            Self::Isolated(pick) => pick.simpler().into_iter().map(Self::Isolated).collect(),
        }
    }

    fn renumber(&self, (): (), number: &mut impl FnMut(List, u32) -> u32) -> Self {
        match self {
            Self::At(pick) => Self::At(pick.renumber((), number)),
            Self::Isolated(pick) => Self::Isolated(pick.renumber((), number)),
        }
    }
}

impl fmt::Display for CornerPick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::At(pick) => pick.fmt(f),
            Self::Isolated(pick) => pick.fmt(f),
        }
    }
}

fn corner(word: &str) -> Option<CornerPick> {
    HalfEdgePick::of_word(word).map(Corner::At).or_else(|| VertexPick::of_word(word).map(Corner::Isolated))
}

impl Argument for SecondPick {
    type List = List;
    type Context = (CornerPick, Fit);

    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self}")
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        let second = |word: &str| number(word, "~").map(Self::Fitting).or_else(|| corner(word).map(Self::Any));
        words.take(Expected::SecondCorner, second)
    }

    fn draw(source: &mut impl Choose, upper: u8) -> Self {
        match byte(source) & 7 {
            0..=6 => Self::Fitting(count(source)),
            _ => Self::Any(Argument::draw(source, upper)),
        }
    }

    fn simpler(&self) -> Vec<Self> {
        match self {
            Self::Fitting(k) => smaller(*k).map(Self::Fitting).collect(),
            Self::Any(pick) => {
                let fitting = [Self::Fitting(0), Self::Fitting(1)];
                fitting.into_iter().chain(pick.simpler().into_iter().map(Self::Any)).collect()
            }
        }
    }

    fn renumber(&self, (from, fit): (CornerPick, Fit), number: &mut impl FnMut(List, u32) -> u32) -> Self {
        match self {
            Self::Any(pick) => Self::Any(pick.renumber((), number)),
            Self::Fitting(k) => Self::Fitting(number(List::Fitting(from, fit), *k)),
        }
    }
}

impl fmt::Display for SecondPick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fitting(k) => write!(f, "~{k}"),
            Self::Any(pick) => pick.fmt(f),
        }
    }
}

impl Argument for FacePick {
    type List = List;
    type Context = ();

    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self}")
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        words.take(Expected::Face, |word| match number(word, "!f") {
            Some(k) => Some(Self::Retired(k)),
            None if word == "unbounded" => Some(Self::Unbounded),
            None => corner(word).map(Self::Of),
        })
    }

    fn draw(source: &mut impl Choose, upper: u8) -> Self {
        match byte(source) & 15 {
            0..=7 => Self::Unbounded,
            8..=14 => Self::Of(Argument::draw(source, upper)),
            _ => Self::Retired(count(source)),
        }
    }

    fn simpler(&self) -> Vec<Self> {
        let unbounded = core::iter::once(Self::Unbounded);
        match self {
            Self::Unbounded => Vec::new(),
            Self::Of(pick) => unbounded.chain(pick.simpler().into_iter().map(Self::Of)).collect(),
            Self::Retired(k) => unbounded.chain(smaller(*k).map(Self::Retired)).collect(),
        }
    }

    fn renumber(&self, (): (), number: &mut impl FnMut(List, u32) -> u32) -> Self {
        match self {
            Self::Unbounded => Self::Unbounded,
            Self::Of(pick) => Self::Of(pick.renumber((), number)),
            Self::Retired(k) => Self::Retired(number(List::RetiredFaces, *k)),
        }
    }
}

impl fmt::Display for FacePick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unbounded => f.write_str("unbounded"),
            Self::Of(pick) => pick.fmt(f),
            Self::Retired(k) => write!(f, "!f{k}"),
        }
    }
}

impl Argument for InnerPick {
    type List = List;
    type Context = ();

    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.mask != 0 {
            f.write_str(" inner ")?;
            write_mask(f, self.mask)?;
        }
        self.also.map_or(Ok(()), |pick| write!(f, " also {pick}"))
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        let mut inner = Self::default();
        if words.peek() == "inner" {
            words.take(Expected::Inner, Some)?;
            inner.mask = words.take(Expected::Inner, mask)?;
        }
        if words.peek() == "also" {
            words.take(Expected::Corner, Some)?;
            inner.also = Some(Argument::read(words)?);
        }
        Ok(inner)
    }

    fn draw(source: &mut impl Choose, upper: u8) -> Self {
        if upper & 6 != 0 {
            return Self::default();
        }
        let mask = u16::from_le_bytes([byte(source), byte(source)]);
        Self { mask, also: (byte(source) % 8 == 0).then(|| Argument::draw(source, upper)) }
    }

    fn simpler(&self) -> Vec<Self> {
        let Self { mask, also } = *self;
        let mut all = Vec::new();
        if also.is_some() && mask != 0 {
            all.push(Self::default());
        }
        if let Some(pick) = also {
            all.push(Self { mask, also: None });
            all.extend(pick.simpler().into_iter().map(|pick| Self { mask, also: Some(pick) }));
        }
        all.extend(smaller_masks(mask).map(|mask| Self { mask, also }));
        all
    }

    fn renumber(&self, (): (), number: &mut impl FnMut(List, u32) -> u32) -> Self {
        Self { also: self.also.map(|pick| pick.renumber((), number)), ..*self }
    }
}

fn read_one_of<T: Copy>(words: &mut Words<'_>, expected: Expected, values: [(&str, T); 2]) -> Result<T, ParseError> {
    words.take(expected, |word| values.iter().find(|(other, _)| *other == word).map(|(_, value)| *value))
}

impl Argument for Side {
    type List = List;
    type Context = ();

    fn draw(_: &mut impl Choose, upper: u8) -> Self {
        if upper & 1 == 0 { Self::Left } else { Self::Right }
    }

    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::Left { " left" } else { " right" })
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        read_one_of(words, Expected::Side, [("left", Self::Left), ("right", Self::Right)])
    }

    fn simpler(&self) -> Vec<Self> {
        if *self == Self::Left { Vec::new() } else { vec![Self::Left] }
    }
}

impl Argument for Turn {
    type List = List;
    type Context = ();

    fn draw(_: &mut impl Choose, upper: u8) -> Self {
        if upper & 1 == 0 { Self::CounterClockwise } else { Self::Clockwise }
    }

    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::CounterClockwise { " ccw" } else { " cw" })
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        read_one_of(words, Expected::Turn, [("ccw", Self::CounterClockwise), ("cw", Self::Clockwise)])
    }

    fn simpler(&self) -> Vec<Self> {
        if *self == Self::CounterClockwise { Vec::new() } else { vec![Self::CounterClockwise] }
    }
}
