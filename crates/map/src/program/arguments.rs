//! Arguments of edits: numbers of records, points, grids, features.

use core::fmt;
use twinedge::program::choose::Choose;
use twinedge::program::language::{Argument, Numbered, Variant, smaller_masks, write_mask};
use twinedge::program::text::{Expected, ParseError, Words, mask};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;

/// The lists that numbers refer to: live and removed keys of each kind.
#[derive(Clone, Copy, Debug)]
pub enum List {
    Vertices,
    HalfEdges,
    Faces,
    RetiredVertices,
    RetiredHalfEdges,
    RetiredFaces,
}

/// A kind of record that an edit chooses: a live one, or a removed one by its stale key.
macro_rules! record_pick {
    ($(#[$doc:meta])* $pick:ident, $words:expr, $live:ident, $retired:ident, $expected:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $pick {
            /// A live record.
            Live(u32),
            /// A removed record: a stale key, on purpose.
            Retired(u32),
        }

        impl Numbered for $pick {
            type List = List;

            const EXPECTED: Expected = Expected::$expected;
            const VARIANTS: &'static [Variant<Self, List>] =
                &[($words[0], Self::Live, List::$live), ($words[1], Self::Retired, List::$retired)];

            fn number(self) -> (usize, u32) {
                match self {
                    Self::Live(k) => (0, k),
                    Self::Retired(k) => (1, k),
                }
            }

            fn choose(source: &mut impl Choose) -> Self {
                live_or_retired(source, Self::Live, Self::Retired)
            }
        }

        impl fmt::Display for $pick {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.write_word(f)
            }
        }
    };
}

record_pick!(
    /// Chooses a vertex of a map by its position in order of creation, modulo the length of the list.
    MapVertexPick, ["v", "!v"], Vertices, RetiredVertices, MapVertex
);
record_pick!(
    /// Chooses a half-edge of a map by its position in order of creation, modulo the length of the list.
    MapHalfEdgePick, ["h", "!h"], HalfEdges, RetiredHalfEdges, HalfEdge
);
record_pick!(
    /// Chooses a face of a map by its position in order of creation, modulo the length of the list.
    MapFacePick, ["f", "!f"], Faces, RetiredFaces, MapFace
);

fn live_or_retired<P>(source: &mut impl Choose, live: fn(u32) -> P, retired: fn(u32) -> P) -> P {
    let k = source.choose(256) as u32;
    if source.choose(16) == 15 { retired(k) } else { live(k) }
}

/// Chooses a point, with a hint about its location: see [`At`](crate::edit::At).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AtPick {
    /// Anywhere.
    Point(Spot),
    /// A point, and a half-edge to search from.
    Near(Spot, MapHalfEdgePick),
    /// The coordinates of this vertex.
    Vertex(MapVertexPick),
}

/// The points of a ring.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct RingPick(pub Vec<AtPick>);

impl fmt::Debug for RingPick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// Chooses a grid: see [`Snap`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum GridPick {
    /// [`Snap::Auto`].
    Auto,
    /// [`Snap::Size`].
    Size(Number),
}

impl GridPick {
    /// Returns the grid.
    #[must_use]
    pub const fn snap(self) -> Snap {
        match self {
            Self::Auto => Snap::Auto,
            Self::Size(size) => Snap::Size(size.get()),
        }
    }
}

/// Chooses features: feature `i` if bit `i` is set, even if the map has fewer features.
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

    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self}")
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        words.take(Expected::Point, spot)
    }

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

    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self}")
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        words.take(Expected::At, |word| match word.split_once('@') {
            Some((before, hint)) => Some(Self::Near(spot(before)?, MapHalfEdgePick::of_word(hint)?)),
            None => MapVertexPick::of_word(word).map(Self::Vertex).or_else(|| spot(word).map(Self::Point)),
        })
    }

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
        Self((0..2 + source.choose(5)).map(|_| Argument::draw(source, upper)).collect())
    }

    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|at| at.write(f))
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        let mut ring = Vec::new();
        while !words.peek().is_empty() {
            ring.push(Argument::read(words)?);
        }
        Ok(Self(ring))
    }

    /// Drops one of the points, or simplifies it.
    fn simpler(&self) -> Vec<Self> {
        let mut all = Vec::new();
        for i in 0..self.0.len() {
            let mut without = self.clone();
            without.0.remove(i);
            all.push(without);
        }
        for (i, at) in self.0.iter().enumerate() {
            all.extend(map(at.simpler(), |at| {
                let mut with = self.clone();
                with.0[i] = at;
                with
            }));
        }
        all
    }

    fn renumber(&self, (): (), number: &mut impl FnMut(List, u32) -> u32) -> Self {
        Self(self.0.iter().map(|at| at.renumber((), number)).collect())
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

    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self}")
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        words.take(Expected::Grid, |word| {
            if word == "auto" { Some(Self::Auto) } else { Some(Self::Size(word.parse::<f64>().ok()?.into())) }
        })
    }

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

    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self}")
    }

    fn read(words: &mut Words<'_>) -> Result<Self, ParseError> {
        words.take(Expected::Features, |word| if word == "none" { Some(Self(0)) } else { mask(word).map(Self) })
    }

    /// Mostly among the first two, so that most exist.
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

/// A number that equals itself: numbers are equal if their bits are, and all NaNs are equal.
#[derive(Clone, Copy, Debug, Default)]
pub struct Number(f64);

impl Number {
    /// Returns the number.
    #[must_use]
    pub const fn get(self) -> f64 {
        self.0
    }

    /// Mostly on a small grid, where points coincide and segments cross; otherwise close to it, at the range's ends, or random.
    fn draw(source: &mut impl Choose) -> Self {
        let grid = source.choose(8) as f64;
        Self::from(match source.choose(64) {
            1 => f64::from_bits((0..8).fold(0, |bits, _| bits << 8 | source.choose(256) as u64)),
            2 => grid.next_up(),
            3 => grid.next_down(),
            4 => grid / 3.0,
            5 => grid * 2.0_f64.powi(495),
            6 => grid * 2.0_f64.powi(-399),
            7 => -grid,
            8 => grid + 0.5,
            9 => [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][source.choose(3)],
            _ => grid,
        })
    }

    /// Returns simpler numbers. Every step lowers the tuple (small and whole, number of bits, magnitude, sign), so it ends.
    fn simpler(self) -> Vec<Self> {
        let x = self.get();
        if x.to_bits() == 0 {
            return Vec::new();
        }
        let mut all = vec![0.0];
        if x.is_nan() {
            return vec![Self::default()];
        }
        let small = x.abs() < 2.0_f64.powi(53);
        if small && x.fract() == 0.0 {
            if x.abs() > 1.0 {
                all.extend([(x / 2.0).trunc(), x - 1.0_f64.copysign(x)]);
            }
        } else {
            all.push(1.0_f64.copysign(x));
            if small {
                all.extend([x.trunc(), (2.0 * x).trunc() / 2.0]);
            }
            // Half of the bits.
            let bits = x.to_bits();
            let mantissa = bits & ((1 << 52) - 1);
            if x.is_finite() && mantissa != 0 {
                let zeros = mantissa.trailing_zeros();
                let cleared = zeros + (52 - zeros).div_ceil(2);
                all.push(f64::from_bits(bits >> cleared << cleared));
            }
        }
        if x.is_sign_negative() {
            all.push(-x);
        }
        let mut seen: Vec<Self> = vec![self];
        for number in all.into_iter().map(Self::from) {
            if !seen.contains(&number) {
                seen.push(number);
            }
        }
        seen.remove(0);
        seen
    }
}

/// Formats the shortest digits that parse to this number.
impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = format!("{:?}", self.get());
        f.write_str(text.strip_suffix(".0").unwrap_or(&text))
    }
}

impl From<f64> for Number {
    fn from(number: f64) -> Self {
        Self(if number.is_nan() { f64::NAN } else { number })
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.0.to_bits() == other.0.to_bits()
    }
}

impl Eq for Number {}

impl core::hash::Hash for Number {
    fn hash<H: core::hash::Hasher>(&self, state: &mut H) {
        self.0.to_bits().hash(state);
    }
}

/// A point by its coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Spot {
    /// The first coordinate.
    pub x: Number,
    /// The second coordinate.
    pub y: Number,
}

impl Spot {
    /// Creates the point with these coordinates.
    #[must_use]
    pub fn new(x: f64, y: f64) -> Self {
        Self { x: x.into(), y: y.into() }
    }

    /// Returns the point.
    #[must_use]
    pub const fn point(self) -> Point {
        Point::new(self.x.get(), self.y.get())
    }
}

impl fmt::Display for Spot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{}", self.x, self.y)
    }
}
