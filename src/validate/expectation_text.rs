//! An expectation as a line of text: `plane`, or `surface open asking closed genus 0`.

use super::expectation::{Expectation, Surface};
use super::rule::Rule;
use alloc::string::String;
use core::fmt;
use core::str::FromStr;

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
            let found = ASKED.iter().find(|(_, name, _)| *name == word);
            let (_, name, ask) = found.ok_or_else(|| ParseExpectationError::Rule { word: word.into() })?;
            expectation = match ask {
                Ask::Plain(ask) => ask(expectation),
                Ask::Number(ask) => {
                    let number = words.next().and_then(|number| number.parse().ok());
                    ask(expectation, number.ok_or(ParseExpectationError::Number { after: name })?)
                }
            };
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

#[cfg(test)]
mod tests;
