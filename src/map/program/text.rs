//! Programs of edits as text: to be read by people, kept in files, and read back.
//!
//! ```text
//! twinedge edits 1
//! insert_ring 0,0 4,0 4,4 0,4
//! insert_segment v0 4,4
//! insert_segment_snapped 0,3 5,1.5@h0 0.25   # a point near h0; a grid with cells of 0.25, or `auto`
//! move_vertex v1 5,0
//! remove_edge !h0                            # !v, !h, !f: a key that was removed
//! add_feature
//! set_features_of f1 0,2                     # or `none`
//! ```

use super::op::{EditOp, EditProgram};
use super::pick::{
    AtPick, FeaturesPick, GridPick, MapFacePick, MapHalfEdgePick, MapVertexPick, Number, RingPick, Spot,
};
use super::table::edits;
use crate::program::words::{Expected, ParseError, Words, lines, mask, number};
use core::fmt;
use core::str::FromStr;

/// The first line of a program's text.
const HEADER: &str = "twinedge edits 1";

/// The shortest digits that are read as this number.
impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = format!("{:?}", self.get());
        f.write_str(text.strip_suffix(".0").unwrap_or(&text))
    }
}

impl fmt::Display for Spot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{}", self.x, self.y)
    }
}

macro_rules! display_picks {
    ($($name:ident $letter:literal)*) => {$(
        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    Self::Live(k) => write!(f, concat!($letter, "{}"), k),
                    Self::Retired(k) => write!(f, concat!("!", $letter, "{}"), k),
                }
            }
        }

        impl $name {
            fn of_word(word: &str) -> Option<Self> {
                let retired = || number(word, concat!("!", $letter)).map(Self::Retired);
                number(word, $letter).map(Self::Live).or_else(retired)
            }
        }
    )*};
}
display_picks! { MapVertexPick "v" MapHalfEdgePick "h" MapFacePick "f" }

impl fmt::Display for AtPick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Point(spot) => spot.fmt(f),
            Self::Near(spot, hint) => write!(f, "{spot}@{hint}"),
            Self::Vertex(pick) => pick.fmt(f),
        }
    }
}

impl fmt::Display for GridPick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Auto => f.write_str("auto"),
            Self::Size(size) => size.fmt(f),
        }
    }
}

impl fmt::Display for FeaturesPick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut before = "";
        for bit in (0..16).filter(|bit| self.0 >> bit & 1 == 1) {
            write!(f, "{before}{bit}")?;
            before = ",";
        }
        f.write_str(if before.is_empty() { "none" } else { "" })
    }
}

fn spot(word: &str) -> Option<Spot> {
    let (x, y) = word.split_once(',')?;
    Some(Spot::new(x.parse().ok()?, y.parse().ok()?))
}

fn at(word: &str) -> Option<AtPick> {
    match word.split_once('@') {
        Some((before, hint)) => Some(AtPick::Near(spot(before)?, MapHalfEdgePick::of_word(hint)?)),
        None => MapVertexPick::of_word(word).map(AtPick::Vertex).or_else(|| spot(word).map(AtPick::Point)),
    }
}

fn grid(word: &str) -> Option<GridPick> {
    if word == "auto" { Some(GridPick::Auto) } else { Some(GridPick::Size(word.parse::<f64>().ok()?.into())) }
}

fn features(word: &str) -> Option<FeaturesPick> {
    if word == "none" { Some(FeaturesPick::default()) } else { mask(word).map(FeaturesPick) }
}

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
    MapVertexPick, MapVertex, Self::of_word;
    MapHalfEdgePick, HalfEdge, Self::of_word;
    MapFacePick, MapFace, Self::of_word;
    Spot, Point, spot;
    AtPick, At, at;
    GridPick, Grid, grid;
    FeaturesPick, Features, features;
}

impl Argument for RingPick {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.iter().try_for_each(|at| at.write(f))
    }

    /// As many as there are.
    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        let mut ring = Self::new();
        while !words.peek().is_empty() {
            ring.push(Argument::read(words)?);
        }
        Ok(ring)
    }
}

macro_rules! define_text {
    ($($variant:ident $method:ident $share:literal { $($arg:ident: $pick:ty;)* })*) => {
        /// One line of a program's text.
        impl fmt::Display for EditOp {
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

        fn op(words: &mut Words<'_>) -> Result<EditOp, ParseError> {
            let start = words.error(Expected::Operator);
            let op = match words.take(Expected::Operator, Some)? {
                $(stringify!($method) => EditOp::$variant { $($arg: Argument::read(words)?),* },)*
                _ => return Err(start),
            };
            words.end().map(|()| op)
        }
    };
}
edits!(define_text);

/// The text that [`FromStr`] reads: a header, and one edit per line.
impl fmt::Display for EditProgram {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{HEADER}")?;
        self.0.iter().try_for_each(|op| writeln!(f, "{op}"))
    }
}

impl FromStr for EditOp {
    type Err = ParseError;

    /// Reads one edit from a line of a program's text.
    fn from_str(line: &str) -> Result<Self, ParseError> {
        op(&mut Words::new(1, line))
    }
}

impl FromStr for EditProgram {
    type Err = ParseError;

    /// Reads a program from its text. Empty lines count for nothing, nor does what follows a `#`. O(length).
    fn from_str(text: &str) -> Result<Self, ParseError> {
        lines(text, HEADER, Expected::EditsHeader, op).map(Self)
    }
}
