//! The claims about a structure (its surface, open boundaries, and the rules M1 … M8), and their text: `plane`, or `surface open asking closed
//! genus 0`.

use super::rule::Rule;
use super::structure::{Part, Parts};
use alloc::string::String;
use core::fmt;
use core::str::FromStr;

/// The surface on which the structure should lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Surface {
    /// The plane: every component has genus 0 and containment is a tree rooted at the unbounded face.
    Plane,
    /// Orientable surfaces of any genus, one per component.
    Any,
}

/// The claims about a structure. The stored parts are the answer of [`View::parts`](super::View::parts).
///
/// ```
/// use twinedge::validate::Expectation;
/// // A mesh with a border, whose half-edges have no face or no twin.
/// let mesh = Expectation::surface().open();
/// assert!(mesh.is_open());
/// // The same, and a disc of triangles.
/// let disc = mesh.triangles().components(1).borders(1).genus(0);
/// ```
///
/// # Optional rules
///
/// A structure that breaks one of R1 … T4 is invalid. M1 … M8 are further claims. Each is checked, and part of the report, only on
/// request. An optional rule relies on earlier rules; if they are broken, it is reported as not checked.
///
/// | rule | requested by |
/// | --- | --- |
/// | M1 used | [`no_unused_vertices`](Self::no_unused_vertices) |
/// | M2 simple | [`simple`](Self::simple) |
/// | M3 sides | [`sides`](Self::sides), [`triangles`](Self::triangles) |
/// | M4 closed | [`closed`](Self::closed) |
/// | M5 connected | [`components`](Self::components) |
/// | M6 borders | [`borders`](Self::borders) |
/// | M7 genus | [`genus`](Self::genus) |
/// | M8 kept | [`border_kept`](Self::border_kept) |
///
/// Most programs for triangle meshes assume `surface().no_unused_vertices().simple().triangles()`, with `.open().borders(n)` for a mesh
/// with `n` border loops. Some libraries promise M8, and others do not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Expectation {
    surface: Surface,
    open: bool,
    asked: u32,
    /// The numbers of M3, M5, M6 and M7; 0 if not requested.
    numbers: [usize; NUMBERS],
}

const NUMBERS: usize = 4;

impl Expectation {
    /// A planar subdivision. If no unbounded face is stored ([`Part::UnboundedFace`]), a sphere also qualifies: any of its faces can be
    /// the unbounded one.
    #[must_use]
    pub const fn plane() -> Self {
        Self { surface: Surface::Plane, open: false, asked: 0, numbers: [0; NUMBERS] }
    }

    /// A subdivision of closed orientable surfaces, in which each face has one cycle. A stored unbounded face and lists of holes are
    /// ignored.
    #[must_use]
    pub const fn surface() -> Self {
        Self { surface: Surface::Any, open: false, asked: 0, numbers: [0; NUMBERS] }
    }

    /// Allows open boundaries. At an edge of an open boundary one side is missing, in one of two ways:
    ///
    /// - There is one half-edge. It has a face, and no twin.
    /// - There are two half-edges, twins of each other. The one along the boundary has no face (or no boundary component, if these are
    ///   records).
    ///
    /// Both half-edges of an edge may lack a face. A half-edge with neither twin nor face bounds nothing, and breaks R1. Without faces
    /// none of this is checked.
    ///
    /// If the outside of a component is an open boundary, the component has no inner boundary component.
    #[must_use]
    pub const fn open(mut self) -> Self {
        self.open = true;
        self
    }

    /// Requests that some half-edge leaves every vertex (M1).
    #[must_use]
    pub const fn no_unused_vertices(self) -> Self {
        self.ask(Rule::M1, 0)
    }

    /// Requests that there are no loops or parallel edges (M2).
    #[must_use]
    pub const fn simple(self) -> Self {
        self.ask(Rule::M2, 0)
    }

    /// Requests that every bounded face has `count` sides (M3).
    #[must_use]
    pub const fn sides(self, count: usize) -> Self {
        self.ask(Rule::M3, count)
    }

    /// Requests that every bounded face has three sides (M3).
    #[must_use]
    pub const fn triangles(self) -> Self {
        self.sides(3)
    }

    /// Requests that there is no border (M4). With [`open`](Self::open), M4 reports each half-edge at a border; without, missing links
    /// break R1.
    ///
    /// ```
    /// use twinedge::validate::{Collect, Expectation, Table, Violation, validate};
    /// // A triangle of three half-edges.
    /// let table: Table = "P 3 prev leaving faces V 3 0 - 1 - 2 - H 3 0 - 1 2 - 1 - 2 0 - 2 - 0 1 - B 0 F 1 - 0 HF 3 0 0 0 FH 1 0 0".parse()?;
    /// let expectation = Expectation::surface().open().closed();
    /// let report = validate(&table, &expectation, Collect::All);
    /// assert_eq!(report.violations().len(), 3);
    /// assert_eq!(
    ///     report.violations()[0].to_string(),
    ///     "M4: half-edge 0, from vertex 0 to vertex 1, has no twin: the surface has a border there"
    /// );
    /// # Ok::<(), twinedge::validate::ParseTableError>(())
    /// ```
    #[must_use]
    pub const fn closed(self) -> Self {
        self.ask(Rule::M4, 0)
    }

    /// Requests `count` components with an edge (M5).
    #[must_use]
    pub const fn components(self, count: usize) -> Self {
        self.ask(Rule::M5, count)
    }

    /// Requests `count` border loops in all components together (M6). Only an [`open`](Self::open) structure has border loops. A count
    /// of 0 is equivalent to [`closed`](Self::closed), but counts loops instead of naming half-edges.
    #[must_use]
    pub const fn borders(self, count: usize) -> Self {
        self.ask(Rule::M6, count)
    }

    /// Requests this genus, the number of handles of all components together (M7).
    #[must_use]
    pub const fn genus(self, genus: usize) -> Self {
        self.ask(Rule::M7, genus)
    }

    /// Requests that every border vertex keeps a half-edge of the border (M8): one without face, or, if border edges have only one
    /// half-edge, one without twin. Libraries that recognise border vertices by the kept half-edge rely on this.
    ///
    /// ```
    /// use twinedge::validate::{Collect, Expectation, Table, Violation, validate};
    /// // A triangle of which the twins 3, 4 and 5 have no face. Vertex 0 keeps half-edge 0, which has one.
    /// let table: Table = "P 3 prev leaving faces V 3 0 - 3 - 4 - H 6 0 3 1 2 - 1 4 2 0 - 2 5 0 1 - 1 0 5 4 - 2 1 3 5 - 0 2 4 3 - B 0 F 1 - 0 \
    ///     HF 6 0 0 0 - - - FH 1 0 0".parse()?;
    /// let expectation = Expectation::surface().open();
    /// assert!(validate(&table, &expectation, Collect::All).is_valid());
    /// let report = validate(&table, &expectation.border_kept(), Collect::All);
    /// assert_eq!(report.violations(), [Violation::KeptInside { vertex: 0, half_edge: 0, border: 5 }]);
    /// # Ok::<(), twinedge::validate::ParseTableError>(())
    /// ```
    #[must_use]
    pub const fn border_kept(self) -> Self {
        self.ask(Rule::M8, 0)
    }

    const fn ask(mut self, rule: Rule, number: usize) -> Self {
        self.asked |= Self::bit(rule);
        if let Some(place) = Self::place(rule) {
            self.numbers[place] = number;
        }
        self
    }

    const fn bit(rule: Rule) -> u32 {
        1 << (rule.index() - Rule::M1.index())
    }

    const fn place(rule: Rule) -> Option<usize> {
        match rule {
            Rule::M3 => Some(0),
            Rule::M5 => Some(1),
            Rule::M6 => Some(2),
            Rule::M7 => Some(3),
            _ => None,
        }
    }

    /// Requests an optional rule by its word in the text of an expectation, such as `closed`, or `genus` with a number.
    ///
    /// ```
    /// use twinedge::validate::Expectation;
    /// let expectation = Expectation::surface().asking("closed", None)?.asking("genus", Some(1))?;
    /// assert_eq!(expectation.to_string(), "surface asking closed genus 1");
    /// # Ok::<(), twinedge::validate::ParseExpectationError>(())
    /// ```
    ///
    /// # Errors
    /// If no rule has this word, if the rule requires a number and none is given, or if one is given and the rule takes none.
    pub fn asking(self, word: &str, number: Option<usize>) -> Result<Self, ParseExpectationError> {
        let found = ASKED.iter().find(|(_, name, _)| *name == word);
        let (_, name, ask) = found.ok_or_else(|| ParseExpectationError::Rule { word: word.into() })?;
        match (ask, number) {
            (Ask::Plain(ask), None) => Ok(ask(self)),
            (Ask::Number(ask), Some(number)) => Ok(ask(self, number)),
            (Ask::Number(_), None) => Err(ParseExpectationError::Number { after: name }),
            (Ask::Plain(_), Some(number)) => Err(ParseExpectationError::Rule { word: alloc::format!("{number}") }),
        }
    }

    /// Returns true if the rule is requested. A rule that is not [optional](Rule::is_optional) always is.
    ///
    /// ```
    /// use twinedge::validate::{Expectation, Rule};
    /// let expectation = Expectation::surface().sides(4);
    /// assert!(expectation.asks_for(Rule::M3) && !expectation.asks_for(Rule::M7));
    /// assert_eq!(expectation.expected_count(Rule::M3), Some(4));
    /// ```
    #[must_use]
    pub const fn asks_for(&self, rule: Rule) -> bool {
        !rule.is_optional() || self.asked & Self::bit(rule) != 0
    }

    /// Returns the requested number of M3, M5, M6 or M7; `None` for other rules, or without a request.
    #[must_use]
    pub const fn expected_count(&self, rule: Rule) -> Option<usize> {
        match Self::place(rule) {
            Some(place) if self.asks_for(rule) => Some(self.numbers[place]),
            _ => None,
        }
    }

    /// Returns the surface on which the structure should lie.
    #[must_use]
    pub const fn surface_kind(&self) -> Surface {
        self.surface
    }

    /// Returns true if open boundaries are allowed.
    #[must_use]
    pub const fn is_open(&self) -> bool {
        self.open
    }

    /// Returns the parts considered, of the stored ones: all parts in the plane; on surfaces neither lists of holes nor an unbounded
    /// face.
    #[must_use]
    pub const fn looks_at(&self, stored: Parts) -> Parts {
        match self.surface {
            Surface::Plane => stored,
            Surface::Any => stored.without(Part::Holes),
        }
    }
}

/// Every optional rule has a bit, and the rules with numbers have indices.
const _: () = {
    let mut i = 0;
    while i < Rule::ALL.len() {
        assert!(matches!(Expectation::place(Rule::ALL[i]), None | Some(0..NUMBERS)));
        assert!(!Rule::ALL[i].is_optional() || Rule::ALL[i].index() - Rule::M1.index() < u32::BITS as usize);
        i += 1;
    }
};

/// The form of a request: a word alone, or with a number.
#[derive(Clone, Copy)]
enum Ask {
    Plain(fn(Expectation) -> Expectation),
    Number(fn(Expectation, usize) -> Expectation),
}

/// The optional rules, with the word for each.
const ASKED: [(Rule, &str, Ask); 8] = [
    (Rule::M1, "no-unused-vertices", Ask::Plain(Expectation::no_unused_vertices)),
    (Rule::M2, "simple", Ask::Plain(Expectation::simple)),
    (Rule::M3, "sides", Ask::Number(Expectation::sides)),
    (Rule::M4, "closed", Ask::Plain(Expectation::closed)),
    (Rule::M5, "components", Ask::Number(Expectation::components)),
    (Rule::M6, "borders", Ask::Number(Expectation::borders)),
    (Rule::M7, "genus", Ask::Number(Expectation::genus)),
    (Rule::M8, "border-kept", Ask::Plain(Expectation::border_kept)),
];

/// An error in the text of an [`Expectation`].
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ParseExpectationError {
    /// The text does not begin with `plane` or `surface`.
    Surface,
    /// Another word in place of `open` or `asking`.
    Claim {
        /// The word.
        word: String,
    },
    /// The word names no optional rule.
    Rule {
        /// The word.
        word: String,
    },
    /// No number follows the word of a rule that requires one.
    Number {
        /// The word before it.
        after: &'static str,
    },
}

impl fmt::Display for ParseExpectationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Surface => f.write_str("expected `plane` or `surface`"),
            Self::Claim { word } => write!(f, "expected `open` or `asking` in place of `{word}`"),
            Self::Rule { word } => {
                write!(f, "`{word}` cannot be asked for, but")?;
                let mut comma = "";
                ASKED
                    .iter()
                    .try_for_each(|(_, name, _)| write!(f, "{} {name}", core::mem::replace(&mut comma, ",")))?;
                f.write_str(" can")
            }
            Self::Number { after } => write!(f, "expected a number after `{after}`"),
        }
    }
}

impl core::error::Error for ParseExpectationError {}

impl fmt::Display for Expectation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.surface_kind() == Surface::Plane { "plane" } else { "surface" })?;
        if self.is_open() {
            f.write_str(" open")?;
        }
        let mut asked = ASKED.iter().filter(|(rule, ..)| self.asks_for(*rule)).peekable();
        if asked.peek().is_some() {
            f.write_str(" asking")?;
        }
        asked.try_for_each(|(rule, word, _)| match self.expected_count(*rule) {
            None => write!(f, " {word}"),
            Some(number) => write!(f, " {word} {number}"),
        })
    }
}

impl FromStr for Expectation {
    type Err = ParseExpectationError;

    fn from_str(text: &str) -> Result<Self, ParseExpectationError> {
        let mut words = text.split_whitespace().peekable();
        let mut expectation = match words.next() {
            Some("plane") => Self::plane(),
            Some("surface") => Self::surface(),
            _ => return Err(ParseExpectationError::Surface),
        };
        if words.next_if_eq(&"open").is_some() {
            expectation = expectation.open();
        }
        match words.next() {
            None => return Ok(expectation),
            Some("asking") => {}
            Some(word) => return Err(ParseExpectationError::Claim { word: word.into() }),
        }
        while let Some(word) = words.next() {
            let number = words.peek().and_then(|number| number.parse().ok());
            expectation = expectation.asking(word, number)?;
            if number.is_some() {
                words.next();
            }
        }
        Ok(expectation)
    }
}

/// Serializes the text.
#[cfg(feature = "serde")]
impl serde::Serialize for Expectation {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Expectation {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
    }
}
