//! Programs as text: to be read by people, kept in files, and read back. The notation is explained at [`Program`].

use super::op::{CornerPick, FacePick, HalfEdgePick, InnerPick, Op, Program, SecondPick, VertexPick};
use super::table::operators;
use super::words::{Expected, ParseError, Words, lines, mask, number};
use crate::dcel::{Corner, Side, Turn};
use core::fmt;
use core::str::FromStr;

/// The first line of a program's text.
const HEADER: &str = "twinedge program 1";

impl fmt::Display for HalfEdgePick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Live(k) => write!(f, "h{k}"),
            Self::Retired(k) => write!(f, "!h{k}"),
        }
    }
}

impl fmt::Display for VertexPick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Isolated(k) => write!(f, "i{k}"),
            Self::OriginOf(k) => write!(f, "o{k}"),
            Self::Retired(k) => write!(f, "!v{k}"),
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

impl fmt::Display for SecondPick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fitting(k) => write!(f, "~{k}"),
            Self::Any(pick) => pick.fmt(f),
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

impl fmt::Display for InnerPick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut before = " inner ";
        for bit in (0..16).filter(|bit| self.mask >> bit & 1 == 1) {
            write!(f, "{before}{bit}")?;
            before = ",";
        }
        self.also.map_or(Ok(()), |pick| write!(f, " also {pick}"))
    }
}

macro_rules! define_text {
    ($($variant:ident $method:ident $share:literal {
        changes [$($change:expr),+]
        $($arg:ident: $pick:ty => $handle:ty, $depends:tt;)*
    })*) => {
        /// One line of a program's text.
        impl fmt::Display for Op {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $(Self::$variant { $($arg),* } => {
                        f.write_str(stringify!($method))?;
                        $($arg.write(f)?;)*
                    })*
                }
                Ok(())
            }
        }

        impl Words<'_> {
            fn op(&mut self) -> Result<Op, ParseError> {
                let start = self.error(Expected::Operator);
                let op = match self.take(Expected::Operator, Some)? {
                    $(stringify!($method) => Op::$variant { $($arg: Argument::read(self)?),* },)*
                    _ => return Err(start),
                };
                self.end().map(|()| op)
            }
        }
    };
}
operators!(define_text);

/// An argument as words of a line.
trait Argument: Sized {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result;
    fn read(words: &mut Words<'_>) -> Result<Self, ParseError>;
}

macro_rules! one_word {
    ($($pick:ty, $expected:ident, $read:expr;)*) => {$(
        impl Argument for $pick {
            fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, " {self}")
            }

            fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
                words.take(Expected::$expected, $read)
            }
        }
    )*};
}

one_word! {
    HalfEdgePick, HalfEdge, half_edge;
    VertexPick, Vertex, vertex;
    CornerPick, Corner, corner;
    SecondPick, SecondCorner, second;
    FacePick, Face, face;
}

impl Argument for Side {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Left => " left",
            Self::Right => " right",
        })
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        words.take(Expected::Side, |word| match word {
            "left" => Some(Self::Left),
            "right" => Some(Self::Right),
            _ => None,
        })
    }
}

impl Argument for Turn {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::CounterClockwise => " ccw",
            Self::Clockwise => " cw",
        })
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        words.take(Expected::Turn, |word| match word {
            "ccw" => Some(Self::CounterClockwise),
            "cw" => Some(Self::Clockwise),
            _ => None,
        })
    }
}

impl Argument for InnerPick {
    /// Nothing where nothing is chosen.
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
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
}

/// The text that [`FromStr`] reads: a header, and one operator per line.
impl fmt::Display for Program {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{HEADER}")?;
        self.0.iter().try_for_each(|op| writeln!(f, "{op}"))
    }
}

fn half_edge(word: &str) -> Option<HalfEdgePick> {
    number(word, "h").map(HalfEdgePick::Live).or_else(|| number(word, "!h").map(HalfEdgePick::Retired))
}

fn vertex(word: &str) -> Option<VertexPick> {
    let live = number(word, "i").map(VertexPick::Isolated).or_else(|| number(word, "o").map(VertexPick::OriginOf));
    live.or_else(|| number(word, "!v").map(VertexPick::Retired))
}

fn corner(word: &str) -> Option<CornerPick> {
    half_edge(word).map(Corner::At).or_else(|| vertex(word).map(Corner::Isolated))
}

fn second(word: &str) -> Option<SecondPick> {
    number(word, "~").map(SecondPick::Fitting).or_else(|| corner(word).map(SecondPick::Any))
}

fn face(word: &str) -> Option<FacePick> {
    match number(word, "!f") {
        Some(k) => Some(FacePick::Retired(k)),
        None if word == "unbounded" => Some(FacePick::Unbounded),
        None => corner(word).map(FacePick::Of),
    }
}

impl FromStr for Program {
    type Err = ParseError;

    /// Reads a program from its text. Empty lines count for nothing, nor does what follows a `#`. O(length).
    fn from_str(text: &str) -> Result<Self, ParseError> {
        lines(text, HEADER, Expected::Header, Words::op).map(Self)
    }
}
