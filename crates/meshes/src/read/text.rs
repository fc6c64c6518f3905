//! Words and lines of a text file.

use super::error::{Cause, Failure, Position, excerpt};

/// Walks over the words of a text, and counts its lines. Any bytes are words or blanks.
#[derive(Debug)]
pub(super) struct Text<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u64,
    /// The byte that starts a comment to the end of the line.
    comment: Option<u8>,
    /// True if a line that ends with a backslash continues in the next one.
    continued: bool,
}

impl<'a> Text<'a> {
    /// Starts after the byte order mark, if there is one.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let at = if bytes.starts_with("\u{feff}".as_bytes()) { 3 } else { 0 };
        Self { bytes, at, line: 1, comment: None, continued: false }
    }

    pub(super) fn with_comments(self, start: u8) -> Self {
        Self { comment: Some(start), ..self }
    }

    pub(super) fn with_continued_lines(self) -> Self {
        Self { continued: true, ..self }
    }

    pub(super) fn starting_at(self, at: usize, line: u64) -> Self {
        Self { at, line, ..self }
    }

    pub(super) fn position(&self) -> Position {
        Position::Line(self.line)
    }

    pub(super) fn left(&self) -> usize {
        self.bytes.len() - self.at
    }

    #[inline]
    pub(super) fn word(&mut self) -> Option<&'a [u8]> {
        loop {
            match *self.bytes.get(self.at)? {
                b'\n' | b'\r' => return None,
                b'\\' if self.continued && self.continues() => {
                    self.at += 1;
                    self.step_over_line_end();
                }
                byte if byte.is_ascii_whitespace() => self.at += 1,
                byte if Some(byte) == self.comment => {
                    self.skip_to_line_end();
                    return None;
                }
                _ => break,
            }
        }
        let rest = &self.bytes[self.at..];
        let mut length = 1;
        while length < rest.len()
            && !rest[length].is_ascii_whitespace()
            && Some(rest[length]) != self.comment
            && !(rest[length] == b'\\' && self.continued)
        {
            length += 1;
        }
        self.at += length;
        Some(&rest[..length])
    }

    /// Returns the next word of this line or a later one.
    #[inline]
    pub(super) fn any_word(&mut self) -> Option<&'a [u8]> {
        loop {
            if let Some(word) = self.word() {
                return Some(word);
            }
            if !self.next_line() {
                return None;
            }
        }
    }

    /// Goes to the next line; false at the end of the text.
    pub(super) fn next_line(&mut self) -> bool {
        self.skip_to_line_end();
        self.step_over_line_end()
    }

    pub(super) fn skip_words(&mut self) -> usize {
        std::iter::from_fn(|| self.word()).count()
    }

    fn skip_to_line_end(&mut self) {
        let rest = &self.bytes[self.at..];
        self.at += rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
    }

    fn step_over_line_end(&mut self) -> bool {
        self.at += match self.bytes[self.at..] {
            [b'\r', b'\n', ..] => 2,
            [b'\r' | b'\n', ..] => 1,
            _ => return false,
        };
        self.line += 1;
        true
    }

    /// Returns true if the line ends right after the backslash here.
    fn continues(&self) -> bool {
        matches!(self.bytes.get(self.at + 1), Some(b'\n' | b'\r'))
    }

    pub(super) fn failed(&self, cause: Cause) -> Failure {
        Failure::new(self.position(), cause)
    }

    /// Returns an error about this word, or about its absence.
    pub(super) fn expected(&self, what: &'static str, found: Option<&[u8]>) -> Failure {
        self.failed(match found {
            Some(word) => Cause::Expected { what, found: excerpt(word) },
            None => Cause::Truncated { what },
        })
    }

    #[inline]
    pub(super) fn coordinate(&self, word: Option<&[u8]>) -> Result<f64, Failure> {
        let number = self.number(word, "a coordinate")?;
        if number.is_finite() { Ok(number) } else { Err(self.failed(Cause::NotFinite { found: number })) }
    }

    #[inline]
    pub(super) fn number(&self, word: Option<&[u8]>, what: &'static str) -> Result<f64, Failure> {
        let parsed = word.and_then(|word| std::str::from_utf8(word).ok()).and_then(|word| word.parse().ok());
        parsed.ok_or_else(|| self.expected(what, word))
    }

    #[inline]
    pub(super) fn integer<T: std::str::FromStr>(&self, word: Option<&[u8]>, what: &'static str) -> Result<T, Failure> {
        let parsed = word.and_then(|word| std::str::from_utf8(word).ok()).and_then(|word| word.parse().ok());
        parsed.ok_or_else(|| self.expected(what, word))
    }
}

/// Returns the text of a file in UTF-16 with a byte order mark, or `None`. Invalid characters are replaced. O(bytes).
pub(super) fn of_utf16(bytes: &[u8]) -> Option<String> {
    let is_big = match bytes {
        [0xFE, 0xFF, ..] => true,
        [0xFF, 0xFE, ..] => false,
        _ => return None,
    };
    let unit = |pair: &[u8]| {
        let pair = [pair[0], pair[1]];
        if is_big { u16::from_be_bytes(pair) } else { u16::from_le_bytes(pair) }
    };
    let units = bytes[2..].chunks_exact(2).map(unit);
    Some(char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect())
}
