//! Arguments of edits: numbers of records, points, grids, features.

use super::numbers::{Number, Spot};
use crate::geometry::noding::Snap;
use crate::program::choose::Choose;
use crate::program::language::argument::{Argument, numbered, one_word, smaller_masks, write_mask};
use crate::program::language::words::{ParseError, Words, mask};
use core::fmt;

/// The lists in which numbers count: keys by kind, those that are there and those that were removed.
#[derive(Clone, Copy, Debug)]
pub(crate) enum List {
    Vertices,
    HalfEdges,
    Faces,
    RetiredVertices,
    RetiredHalfEdges,
    RetiredFaces,
}

numbered! { List;
    /// Chooses a vertex of a map by its position in order of creation, modulo their number.
    MapVertexPick MapVertex |source| live_or_retired(source, Self::Live, Self::Retired);
    /// Of those there are.
    Live "v" Vertices,
    /// Of those that were removed: a stale key, on purpose.
    Retired "!v" RetiredVertices;

    /// Chooses a half-edge of a map by its position in order of creation, modulo their number.
    MapHalfEdgePick HalfEdge |source| live_or_retired(source, Self::Live, Self::Retired);
    /// Of those there are.
    Live "h" HalfEdges,
    /// Of those that were removed: a stale key, on purpose.
    Retired "!h" RetiredHalfEdges;

    /// Chooses a face of a map by its position in order of creation, modulo their number.
    MapFacePick MapFace |source| live_or_retired(source, Self::Live, Self::Retired);
    /// Of those there are.
    Live "f" Faces,
    /// Of those that were removed: a stale key, on purpose.
    Retired "!f" RetiredFaces;
}

fn live_or_retired<P>(source: &mut impl Choose, live: fn(u32) -> P, retired: fn(u32) -> P) -> P {
    let k = source.choose(256) as u32;
    if source.choose(16) == 15 { retired(k) } else { live(k) }
}

/// Chooses a point, and what is known of where it lies: see [`At`](crate::map::edit::At).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AtPick {
    /// Anywhere.
    Point(Spot),
    /// A point, and a half-edge to search from.
    Near(Spot, MapHalfEdgePick),
    /// The place of this vertex.
    Vertex(MapVertexPick),
}

/// The points of a ring.
pub type RingPick = Vec<AtPick>;

/// Chooses a grid: see [`Snap`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum GridPick {
    /// [`Snap::Auto`].
    Auto,
    /// [`Snap::Size`].
    Size(Number),
}

impl GridPick {
    /// The grid.
    #[must_use]
    pub const fn snap(self) -> Snap {
        match self {
            Self::Auto => Snap::Auto,
            Self::Size(size) => Snap::Size(size.get()),
        }
    }
}

/// Chooses features: feature `i` if bit `i` is set, whether the map has so many or not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct FeaturesPick(pub u16);

fn map<T, U>(all: Vec<T>, f: impl FnMut(T) -> U) -> Vec<U> {
    all.into_iter().map(f).collect()
}

fn spot(word: &str) -> Option<Spot> {
    let (x, y) = word.split_once(',')?;
    Some(Spot::new(x.parse().ok()?, y.parse().ok()?))
}

impl Argument for Spot {
    type List = List;
    type Context = ();

    one_word!(Point, spot);

    fn draw(source: &mut impl Choose, _: u8) -> Self {
        Self { x: Number::draw(source), y: Number::draw(source) }
    }

    fn simpler(&self) -> Vec<Self> {
        let mut all = map(self.x.simpler(), |x| Self { x, ..*self });
        all.extend(map(self.y.simpler(), |y| Self { y, ..*self }));
        all
    }
}

impl fmt::Display for AtPick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Point(spot) => spot.fmt(f),
            Self::Near(spot, hint) => write!(f, "{spot}@{hint}"),
            Self::Vertex(pick) => pick.fmt(f),
        }
    }
}

impl Argument for AtPick {
    type List = List;
    type Context = ();

    one_word!(At, |word| match word.split_once('@') {
        Some((before, hint)) => Some(Self::Near(spot(before)?, MapHalfEdgePick::of_word(hint)?)),
        None => MapVertexPick::of_word(word).map(Self::Vertex).or_else(|| spot(word).map(Self::Point)),
    });

    fn draw(source: &mut impl Choose, upper: u8) -> Self {
        match source.choose(8) {
            5 => Self::Near(Argument::draw(source, upper), Argument::draw(source, upper)),
            6 | 7 => Self::Vertex(Argument::draw(source, upper)),
            _ => Self::Point(Argument::draw(source, upper)),
        }
    }

    fn simpler(&self) -> Vec<Self> {
        match *self {
            Self::Point(spot) => map(spot.simpler(), Self::Point),
            Self::Near(spot, hint) => {
                let mut all = vec![Self::Point(spot)];
                all.extend(map(hint.simpler(), |hint| Self::Near(spot, hint)));
                all.extend(map(spot.simpler(), |spot| Self::Near(spot, hint)));
                all
            }
            Self::Vertex(pick) => map(pick.simpler(), Self::Vertex),
        }
    }

    fn renumber(&self, (): (), number: &mut impl FnMut(List, u32) -> u32) -> Self {
        match *self {
            Self::Point(spot) => Self::Point(spot),
            Self::Near(spot, hint) => Self::Near(spot, hint.renumber((), number)),
            Self::Vertex(pick) => Self::Vertex(pick.renumber((), number)),
        }
    }
}

impl Argument for RingPick {
    type List = List;
    type Context = ();

    fn draw(source: &mut impl Choose, upper: u8) -> Self {
        (0..2 + source.choose(5)).map(|_| Argument::draw(source, upper)).collect()
    }

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

    /// Without one of its points, or with a simpler one.
    fn simpler(&self) -> Vec<Self> {
        let mut all = Vec::new();
        for i in 0..self.len() {
            let mut without = self.clone();
            without.remove(i);
            all.push(without);
        }
        for (i, at) in self.iter().enumerate() {
            all.extend(map(at.simpler(), |at| {
                let mut with = self.clone();
                with[i] = at;
                with
            }));
        }
        all
    }

    fn renumber(&self, (): (), number: &mut impl FnMut(List, u32) -> u32) -> Self {
        self.iter().map(|at| at.renumber((), number)).collect()
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

impl Argument for GridPick {
    type List = List;
    type Context = ();

    one_word!(Grid, |word| {
        if word == "auto" { Some(Self::Auto) } else { Some(Self::Size(word.parse::<f64>().ok()?.into())) }
    });

    fn draw(source: &mut impl Choose, _: u8) -> Self {
        match source.choose(8) {
            5 => Self::Auto,
            6 => Self::Size(Number::from(0.25)),
            7 => Self::Size(Number::draw(source)),
            _ => Self::Size(Number::from(1.0)),
        }
    }

    fn simpler(&self) -> Vec<Self> {
        let one = Self::Size(Number::from(1.0));
        match *self {
            Self::Size(size) => {
                let mut all = map(size.simpler(), Self::Size);
                all.retain(|simpler| *simpler != one && *self != one);
                if *self != one {
                    all.insert(0, one);
                }
                all
            }
            Self::Auto => vec![one],
        }
    }
}

impl fmt::Display for FeaturesPick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 == 0 { f.write_str("none") } else { write_mask(f, self.0) }
    }
}

impl Argument for FeaturesPick {
    type List = List;
    type Context = ();

    one_word!(Features, |word| if word == "none" { Some(Self(0)) } else { mask(word).map(Self) });

    /// Mostly of the first two, so that most exist.
    fn draw(source: &mut impl Choose, _: u8) -> Self {
        Self(match source.choose(8) {
            7 => source.choose(1 << 16) as u16,
            _ => source.choose(4) as u16,
        })
    }

    fn simpler(&self) -> Vec<Self> {
        smaller_masks(self.0).map(Self).collect()
    }
}
