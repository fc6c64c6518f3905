//! Reads the text of a program: lines, words, and the expected words in errors.

use alloc::vec::Vec;
use thiserror::Error;

/// The word expected in a program's text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Error)]
#[non_exhaustive]
pub enum Expected {
    /// The first line.
    #[error("the line `twinedge program 1`")]
    Header,
    /// The first line of a program of edits.
    #[error("the line `twinedge edits 1`")]
    EditsHeader,
    /// The name of an operator.
    #[error("the name of an operator")]
    Operator,
    /// A half-edge.
    #[error("a half-edge (`h0` or `!h0`)")]
    HalfEdge,
    /// A vertex.
    #[error("an isolated vertex (`i0`, `o0` or `!v0`)")]
    Vertex,
    /// A corner.
    #[error("a corner (`h0`, `i0`, `o0`, `!h0` or `!v0`)")]
    Corner,
    /// The second of two corners.
    #[error("a second corner (`~0`, or as the first)")]
    SecondCorner,
    /// A face.
    #[error("a face (`unbounded`, a corner, or `!f0`)")]
    Face,
    /// A side.
    #[error("a side (`left` or `right`)")]
    Side,
    /// A turn.
    #[error("a turn (`ccw` or `cw`)")]
    Turn,
    /// Numbers of inner boundary components.
    #[error("numbers below 16 in rising order, with commas between them")]
    Inner,
    /// A vertex of a map.
    #[error("a vertex (`v0` or `!v0`)")]
    MapVertex,
    /// A face of a map.
    #[error("a face (`f0` or `!f0`)")]
    MapFace,
    /// A point.
    #[error("a point (`1.5,2`)")]
    Point,
    /// A point of a map, or a point near a half-edge.
    #[error("a point (`1.5,2`, `1.5,2@h0`, `v0` or `!v0`)")]
    At,
    /// The rounding grid.
    #[error("a grid (`auto`, or the width of a cell)")]
    Grid,
    /// Features.
    #[error("numbers of features below 16 in rising order, with commas between them, or `none`")]
    Features,
    /// The end of the line.
    #[error("the end of the line")]
    End,
}

/// An error in the text of a program, with its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Error)]
#[error("line {line}, column {column}: expected {expected}")]
pub struct ParseError {
    /// The line, counted from 1.
    pub line: usize,
    /// The column in characters, counted from 1.
    pub column: usize,
    /// The word that should stand there.
    pub expected: Expected,
}

/// The rest of one line.
pub struct Words<'a> {
    text: &'a str,
    rest: &'a str,
    line: usize,
}

impl<'a> Words<'a> {
    /// Starts a line, ignoring its comment.
    #[must_use]
    pub fn new(line: usize, text: &'a str) -> Self {
        let text = text.split('#').next().unwrap_or_default();
        Self { text, rest: text.trim(), line }
    }

    /// Checks that the line has no more words.
    ///
    /// # Errors
    /// There is another word.
    pub fn end(&self) -> Result<(), ParseError> {
        if self.rest.is_empty() { Ok(()) } else { Err(self.error(Expected::End)) }
    }

    /// Returns the next word; empty if there is none.
    #[must_use]
    pub fn peek(&self) -> &'a str {
        self.rest.split_whitespace().next().unwrap_or_default()
    }

    /// Returns the error that `expected` should stand here.
    #[must_use]
    pub fn error(&self, expected: Expected) -> ParseError {
        let before = self.text.trim_end().len() - self.rest.len();
        let column = self.text.get(..before).map_or(0, |text| text.chars().count()) + 1;
        ParseError { line: self.line, column, expected }
    }

    /// Takes the next word if `read` understands it.
    ///
    /// # Errors
    /// The word is missing, or `read` refuses it.
    pub fn take<T>(&mut self, expected: Expected, read: impl FnOnce(&'a str) -> Option<T>) -> Result<T, ParseError> {
        let word = self.peek();
        let value = read(word).ok_or_else(|| self.error(expected))?;
        self.rest = self.rest.get(word.len()..).unwrap_or_default().trim_start();
        Ok(value)
    }
}

/// Parses the number after a prefix: digits only.
#[must_use]
pub fn number(word: &str, prefix: &str) -> Option<u32> {
    let digits = word.strip_prefix(prefix)?;
    digits.bytes().all(|byte| byte.is_ascii_digit()).then(|| digits.parse().ok())?
}

/// Parses a bit mask, written as the positions of its bits in rising order, separated by commas.
#[must_use]
pub fn mask(word: &str) -> Option<u16> {
    word.split(',').try_fold(0_u16, |mask, bit| {
        let bit = number(bit, "").filter(|bit| *bit < 16)?;
        (mask >> bit == 0).then_some(mask | 1 << bit)
    })
}

/// Reads the operators of a text: a header, and one operator in each non-empty line.
///
/// # Errors
/// The header is missing, or a line is invalid.
pub fn lines<'a, O>(
    text: &'a str,
    header: &str,
    expected: Expected,
    op: impl Fn(&mut Words<'a>) -> Result<O, ParseError>,
) -> Result<Vec<O>, ParseError> {
    let mut lines = text.lines().enumerate().map(|(i, line)| Words::new(i + 1, line));
    let first = lines.find(|words| !words.rest.is_empty()).unwrap_or_else(|| Words::new(1, ""));
    if !first.rest.split_whitespace().eq(header.split_whitespace()) {
        return Err(first.error(expected));
    }
    lines.filter(|words| !words.rest.is_empty()).map(|mut words| op(&mut words)).collect()
}
