//! A [`Table`] as one line of text: [`Display`](fmt::Display) writes it, [`FromStr`] reads it.
//!
//! # The form
//!
//! Sections in this order, tokens separated by white space. Each section is a letter, the number of rows, and the rows, one
//! per slot. `P` may be omitted; then every part is stored.
//!
//! | section | fields of a row |
//! | --- | --- |
//! | `P` | the [word](Part::word) for a stored part |
//! | `V` | leaving, isolated |
//! | `H` | origin, twin, next, prev, boundary |
//! | `B` | face, start, place |
//! | `F` | outer, the number of inner boundary components, the inner boundary components |
//!
//! A link is an index or `-` for nil. A start is `h3` (half-edge 3), `v3` (vertex 3) or `-`. A place is `o` (outer), `i3`
//! (inner position 3) or `-`. The row of a vacant slot is `x`.
//!
//! Two more sections follow, in this order, if half-edges name faces or faces store half-edges. Each has the same number of
//! rows as the section that it extends, with the same vacant rows.
//!
//! | section | fields of a row |
//! | --- | --- |
//! | `HF` | for each half-edge: face |
//! | `FH` | for each face: outer half-edge, the number of inner starts, the inner starts |
//!
//! ```
//! use twinedge::validate::{Collect, Expectation, Table, validate};
//! // One edge between two vertices. Its two half-edges make one cycle, an inner boundary component of the unbounded face.
//! let text = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0";
//! let table: Table = text.parse()?;
//! assert!(validate(&table, &Expectation::plane(), Collect::All).is_valid());
//! assert_eq!(table.to_string(), text);
//!
//! // The same without records for boundary components: half-edges name their face, faces keep half-edges.
//! let text = "P 5 prev leaving faces holes unbounded_face \
//!     V 2 0 - 1 - H 2 0 1 1 1 - 1 0 0 0 - B 0 F 1 - 0 HF 2 0 0 FH 1 - 1 h0";
//! let textbook: Table = text.parse()?;
//! assert!(validate(&textbook, &Expectation::plane(), Collect::All).is_valid());
//! assert_eq!(textbook.to_string(), text);
//! # Ok::<(), twinedge::validate::ParseTableError>(())
//! ```

use super::{BoundaryRow, FaceRow, HalfEdgeRow, Table, VertexRow};
use crate::validate::structure::{BoundaryPlace, Link, Part, Parts, Start};
use alloc::vec::Vec;
use core::fmt;
use core::str::FromStr;

/// An error in the text of a [`Table`]. Positions are in bytes from the start of the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ParseTableError {
    /// The text ends before the table does.
    UnexpectedEnd {
        /// The length of the text.
        position: usize,
        /// The missing token.
        expected: &'static str,
    },
    /// Another token stands where this one is expected.
    UnexpectedToken {
        /// The position of the token.
        position: usize,
        /// The token expected there.
        expected: &'static str,
    },
    /// A number is too large for `usize`.
    NumberTooLarge {
        /// The position of the number.
        position: usize,
    },
    /// The number of rows of `HF` differs from `H`, or of `FH` from `F`.
    RowCount {
        /// The position of the number.
        position: usize,
        /// The number of rows of the extended section.
        expected: usize,
        /// The number found.
        found: usize,
    },
}

impl ParseTableError {
    /// Returns the position in the text, in bytes from its start.
    #[must_use]
    pub const fn position(&self) -> usize {
        match *self {
            Self::UnexpectedEnd { position, .. }
            | Self::UnexpectedToken { position, .. }
            | Self::NumberTooLarge { position }
            | Self::RowCount { position, .. } => position,
        }
    }
}

impl fmt::Display for ParseTableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnexpectedEnd { position, expected } => {
                write!(f, "the text ends at byte {position}, where {expected} is expected")
            }
            Self::UnexpectedToken { position, expected } => write!(f, "{expected} is expected at byte {position}"),
            Self::NumberTooLarge { position } => write!(f, "the number at byte {position} is too large"),
            Self::RowCount { position, expected, found } => {
                write!(f, "the section at byte {position} has {found} rows, but the one that it extends has {expected}")
            }
        }
    }
}

impl core::error::Error for ParseTableError {}

struct LinkText(Link);

impl fmt::Display for LinkText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(i) => write!(f, "{i}"),
            None => f.write_str("-"),
        }
    }
}

struct StartText(Option<Start>);

impl fmt::Display for StartText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(Start::HalfEdge(h)) => write!(f, "h{h}"),
            Some(Start::Vertex(v)) => write!(f, "v{v}"),
            None => f.write_str("-"),
        }
    }
}

struct PlaceText(Option<BoundaryPlace>);

impl fmt::Display for PlaceText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(BoundaryPlace::Outer) => f.write_str("o"),
            Some(BoundaryPlace::Inner(i)) => write!(f, "i{i}"),
            None => f.write_str("-"),
        }
    }
}

/// Writes a section: its name, the number of its rows, and each row, `x` if vacant.
fn write_section<T>(
    f: &mut fmt::Formatter<'_>,
    name: &str,
    rows: &[Option<T>],
    mut write_row: impl FnMut(&mut fmt::Formatter<'_>, &T) -> fmt::Result,
) -> fmt::Result {
    write!(f, "{name} {}", rows.len())?;
    for row in rows {
        f.write_str(" ")?;
        match row {
            Some(row) => write_row(f, row)?,
            None => f.write_str("x")?,
        }
    }
    Ok(())
}

/// The text form: see [`FromStr`](#impl-FromStr-for-Table).
impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.parts != Parts::ALL {
            write!(f, "P {} ", self.parts.iter().count())?;
            self.parts.iter().try_for_each(|part| write!(f, "{} ", part.word()))?;
        }
        write_section(f, "V", &self.vertices, |f, row| {
            write!(f, "{} {}", LinkText(row.leaving), LinkText(row.isolated))
        })?;
        write_section(f, " H", &self.half_edges, |f, row| {
            let [origin, twin, next, prev, boundary] =
                [row.origin, row.twin, row.next, row.prev, row.boundary].map(LinkText);
            write!(f, "{origin} {twin} {next} {prev} {boundary}")
        })?;
        write_section(f, " B", &self.boundaries, |f, row| {
            write!(f, "{} {} {}", LinkText(row.face), StartText(row.start), PlaceText(row.place))
        })?;
        write_section(f, " F", &self.faces, |f, row| {
            write!(f, "{} {}", LinkText(row.outer), row.inner.len())?;
            row.inner.iter().try_for_each(|b| write!(f, " {}", LinkText(*b)))
        })?;
        if self.half_edges.iter().flatten().any(|row| row.face.is_some()) {
            write_section(f, " HF", &self.half_edges, |f, row| write!(f, "{}", LinkText(row.face)))?;
        }
        if self.faces.iter().flatten().any(|row| row.outer_half_edge.is_some() || !row.inner_starts.is_empty()) {
            write_section(f, " FH", &self.faces, |f, row| {
                write!(f, "{} {}", LinkText(row.outer_half_edge), row.inner_starts.len())?;
                row.inner_starts.iter().try_for_each(|start| write!(f, " {}", StartText(*start)))
            })?;
        }
        Ok(())
    }
}

struct Tokens<'a> {
    text: &'a str,
    position: usize,
}

impl<'a> Tokens<'a> {
    /// Returns the next token and its position, without consuming it; `None` at the end.
    fn peek(&self) -> Option<(&'a str, usize)> {
        let rest = self.text[self.position..].trim_ascii_start();
        let token = rest.split_ascii_whitespace().next()?;
        Some((token, self.text.len() - rest.len()))
    }

    fn token(&mut self, expected: &'static str) -> Result<(&'a str, usize), ParseTableError> {
        let end = ParseTableError::UnexpectedEnd { position: self.text.len(), expected };
        let (token, position) = self.peek().ok_or(end)?;
        self.position = position + token.len();
        Ok((token, position))
    }

    fn name(&mut self, name: &'static str, expected: &'static str) -> Result<(), ParseTableError> {
        match self.token(expected)? {
            (token, _) if token == name => Ok(()),
            (_, position) => Err(ParseTableError::UnexpectedToken { position, expected }),
        }
    }

    fn count(&mut self) -> Result<usize, ParseTableError> {
        let (token, position) = self.token(COUNT)?;
        number(token, position, COUNT)
    }

    fn link(&mut self) -> Result<Link, ParseTableError> {
        match self.token(LINK)? {
            ("-", _) => Ok(None),
            (token, position) => number(token, position, LINK).map(Some),
        }
    }

    fn start(&mut self) -> Result<Option<Start>, ParseTableError> {
        let (token, position) = self.token(START)?;
        if token == "-" {
            return Ok(None);
        }
        match (token.strip_prefix('h'), token.strip_prefix('v')) {
            (Some(index), _) => number(index, position, START).map(|h| Some(Start::HalfEdge(h))),
            (_, Some(index)) => number(index, position, START).map(|v| Some(Start::Vertex(v))),
            _ => Err(ParseTableError::UnexpectedToken { position, expected: START }),
        }
    }

    fn place(&mut self) -> Result<Option<BoundaryPlace>, ParseTableError> {
        match self.token(PLACE)? {
            ("-", _) => Ok(None),
            ("o", _) => Ok(Some(BoundaryPlace::Outer)),
            (token, position) => {
                let other = ParseTableError::UnexpectedToken { position, expected: PLACE };
                let index = token.strip_prefix('i').ok_or(other)?;
                number(index, position, PLACE).map(|i| Some(BoundaryPlace::Inner(i)))
            }
        }
    }

    fn part(&mut self) -> Result<Part, ParseTableError> {
        let (token, position) = self.token(PART)?;
        Part::from_word(token).ok_or(ParseTableError::UnexpectedToken { position, expected: PART })
    }

    /// Reads a list: the number of entries, then the entries.
    fn list<T>(
        &mut self,
        mut entry: impl FnMut(&mut Self) -> Result<T, ParseTableError>,
    ) -> Result<Vec<T>, ParseTableError> {
        // Collecting without a capacity: the text may claim any number.
        let mut list = Vec::new();
        for _ in 0..self.count()? {
            list.push(entry(self)?);
        }
        Ok(list)
    }

    fn vacant(&mut self) -> bool {
        let Some(("x", position)) = self.peek() else { return false };
        self.position = position + 1;
        true
    }

    fn rows<T>(
        &mut self,
        mut row: impl FnMut(&mut Self) -> Result<T, ParseTableError>,
    ) -> Result<Vec<Option<T>>, ParseTableError> {
        self.list(|tokens| if tokens.vacant() { Ok(None) } else { row(tokens).map(Some) })
    }

    /// Reads a section that extends these rows, if present.
    fn extension<T>(
        &mut self,
        name: &str,
        rows: &mut [Option<T>],
        mut extend: impl FnMut(&mut Self, &mut T) -> Result<(), ParseTableError>,
    ) -> Result<(), ParseTableError> {
        let Some((token, at)) = self.peek().filter(|(token, _)| *token == name) else { return Ok(()) };
        self.position = at + token.len();
        let (token, position) = self.token(COUNT)?;
        let found = number(token, position, COUNT)?;
        if found != rows.len() {
            return Err(ParseTableError::RowCount { position, expected: rows.len(), found });
        }
        for row in rows {
            match row {
                Some(row) => extend(self, row)?,
                None => self.name("x", "`x` for a vacant slot")?,
            }
        }
        Ok(())
    }
}

const PART: &str = "a part (`prev`, `leaving`, `faces`, `boundary_components`, `places`, `holes`, `unbounded_face`)";
const COUNT: &str = "a number of entries";
const LINK: &str = "a link (an index or `-`)";
const START: &str = "a start (`h` or `v` and an index, or `-`)";
const PLACE: &str = "a place (`o`, `i` and a position, or `-`)";

fn number(digits: &str, position: usize, expected: &'static str) -> Result<usize, ParseTableError> {
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(ParseTableError::UnexpectedToken { position, expected });
    }
    digits.parse().map_err(|_| ParseTableError::NumberTooLarge { position })
}

/// Reads the text form. O(n) for n bytes.
///
/// Sections are `P` (optional), `V`, `H`, `B` and `F`, then `HF` and `FH` if half-edges name faces or faces store
/// half-edges. Each is followed by the number of its rows and the rows: `P` a stored part; `V` leaving, isolated; `H`
/// origin, twin, next, prev, boundary; `B` face, start (`h3`, `v3`), place (`o`, `i3`); `F` outer, the number of inner
/// boundary components, the components; `HF` face; `FH` outer half-edge, the number of inner starts, the starts. `-` is
/// nil, `x` the row of a vacant slot.
///
/// # Errors
/// [`ParseTableError`], with the position, if the text has another form. Links may lead anywhere or nowhere:
/// [`validate`](crate::validate::validate) judges the table.
///
/// ```
/// use twinedge::validate::{ParseTableError, Table};
/// let table: Table = "V 1 - 0 H 0 B 1 0 v0 i0 F 1 - 1 0".parse()?;
/// assert_eq!(table.vertices[0].unwrap().isolated, Some(0));
/// let error = "V 1 - zero".parse::<Table>().unwrap_err();
/// assert!(matches!(error, ParseTableError::UnexpectedToken { position: 6, .. }));
/// # Ok::<(), ParseTableError>(())
/// ```
impl FromStr for Table {
    type Err = ParseTableError;

    fn from_str(text: &str) -> Result<Self, ParseTableError> {
        let mut tokens = Tokens { text, position: 0 };
        let mut parts = Parts::ALL;
        if let Some(("P", position)) = tokens.peek() {
            tokens.position = position + 1;
            parts = tokens.list(Tokens::part)?.into_iter().collect();
        }
        tokens.name("V", "the section of the vertices (`V`)")?;
        let vertices = tokens.rows(|tokens| Ok(VertexRow { leaving: tokens.link()?, isolated: tokens.link()? }))?;
        tokens.name("H", "the section of the half-edges (`H`)")?;
        let mut half_edges = tokens.rows(|tokens| {
            Ok(HalfEdgeRow {
                origin: tokens.link()?,
                twin: tokens.link()?,
                next: tokens.link()?,
                prev: tokens.link()?,
                boundary: tokens.link()?,
                face: None,
            })
        })?;
        tokens.name("B", "the section of the boundary components (`B`)")?;
        let boundaries = tokens
            .rows(|tokens| Ok(BoundaryRow { face: tokens.link()?, start: tokens.start()?, place: tokens.place()? }))?;
        tokens.name("F", "the section of the faces (`F`)")?;
        let mut faces = tokens.rows(|tokens| {
            Ok(FaceRow { outer: tokens.link()?, inner: tokens.list(Tokens::link)?, ..FaceRow::default() })
        })?;
        tokens.extension("HF", &mut half_edges, |tokens, row| {
            row.face = tokens.link()?;
            Ok(())
        })?;
        tokens.extension("FH", &mut faces, |tokens, row| {
            row.outer_half_edge = tokens.link()?;
            row.inner_starts = tokens.list(Tokens::start)?;
            Ok(())
        })?;
        match tokens.peek() {
            None => Ok(Self { parts, vertices, half_edges, boundaries, faces }),
            Some((_, position)) => {
                Err(ParseTableError::UnexpectedToken { position, expected: "`HF`, `FH` or the end of the text" })
            }
        }
    }
}
