//! An expectation as one line of text: the claims to which the tables in a file are held.

use std::fmt;
use twinedge::validate::{Expectation, Rule, Surface};

/// Begins a comment that says what the tables below it are held to.
pub(crate) const EXPECT: &str = "# expect:";

/// The way in which a rule is asked for: by its word alone, or with a number.
#[derive(Clone, Copy)]
enum Ask {
    Plain(fn(Expectation) -> Expectation),
    Number(fn(Expectation, usize) -> Expectation),
}

/// The rules that must be asked for, with the word for each.
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

/// An expectation in words: `plane`, or `surface open asking closed genus 0`.
pub(crate) struct ExpectationText(pub(crate) Expectation);

impl fmt::Display for ExpectationText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(expectation) = self;
        f.write_str(if expectation.surface_kind() == Surface::Plane { "plane" } else { "surface" })?;
        if expectation.is_open() {
            f.write_str(" open")?;
        }
        let mut asked = ASKED.iter().filter(|(rule, ..)| expectation.asks_for(*rule)).peekable();
        if asked.peek().is_some() {
            f.write_str(" asking")?;
        }
        asked.try_for_each(|(rule, word, _)| match expectation.expected_count(*rule) {
            None => write!(f, " {word}"),
            Some(number) => write!(f, " {word} {number}"),
        })
    }
}

/// Reads an expectation in words. The error says what is wrong.
pub(crate) fn parse(text: &str) -> Result<Expectation, String> {
    let mut words = text.split_whitespace().peekable();
    let mut expectation = match words.next() {
        Some("plane") => Expectation::plane(),
        Some("surface") => Expectation::surface(),
        _ => return Err("expected `plane` or `surface`".to_owned()),
    };
    if words.next_if_eq(&"open").is_some() {
        expectation = expectation.open();
    }
    match words.next() {
        None => return Ok(expectation),
        Some("asking") => {}
        Some(word) => return Err(format!("expected `open` or `asking` in place of `{word}`")),
    }
    while let Some(word) = words.next() {
        let (.., ask) = ASKED
            .iter()
            .find(|(_, name, _)| *name == word)
            .ok_or_else(|| format!("`{word}` cannot be asked for, but {} can", list(ASKED.map(|(_, name, _)| name))))?;
        expectation = match ask {
            Ask::Plain(ask) => ask(expectation),
            Ask::Number(ask) => {
                let number = words.next().and_then(|number| number.parse().ok());
                ask(expectation, number.ok_or_else(|| format!("expected a number after `{word}`"))?)
            }
        };
    }
    Ok(expectation)
}

fn list<const N: usize>(names: [&str; N]) -> String {
    names.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_expectation_is_read_as_it_was_written() {
        for expectation in [Expectation::plane(), Expectation::surface(), Expectation::surface().open()] {
            assert_eq!(parse(&ExpectationText(expectation).to_string()), Ok(expectation));
        }
        assert_eq!(ExpectationText(Expectation::plane()).to_string(), "plane");
    }

    #[test]
    fn what_is_asked_for_is_read_as_it_was_written() {
        let mut all = Expectation::surface().open();
        for (rule, word, ask) in ASKED {
            let [one, more] = [Expectation::plane(), all].map(|expectation| match ask {
                Ask::Plain(ask) => ask(expectation),
                Ask::Number(ask) => ask(expectation, 7),
            });
            assert!(one.asks_for(rule) && !Expectation::plane().asks_for(rule));
            assert!(ExpectationText(one).to_string().starts_with(&format!("plane asking {word}")));
            for expectation in [one, more] {
                assert_eq!(parse(&ExpectationText(expectation).to_string()), Ok(expectation));
            }
            all = more;
        }
        assert_eq!(
            ExpectationText(all).to_string(),
            "surface open asking no-unused-vertices simple sides 7 closed components 7 \
             borders 7 genus 7 border-kept"
        );
        assert_eq!(parse("plane open asking closed"), Ok(Expectation::plane().open().closed()));
    }

    #[test]
    fn other_words_are_errors() {
        for (text, told) in [
            ("", "`plane` or `surface`"),
            ("sphere", "`plane` or `surface`"),
            ("plane closed", "`closed`"),
            ("plane without faces", "`open` or `asking` in place of `without`"),
            ("plane asking handles", "`handles` cannot be asked for, but no-unused-vertices, simple,"),
            ("plane asking genus", "a number after `genus`"),
            ("plane asking sides three", "a number after `sides`"),
        ] {
            assert!(parse(text).unwrap_err().contains(told), "{text}");
        }
    }
}
