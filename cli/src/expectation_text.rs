//! An expectation as one line of text: what the tables in a file are held to.

use std::fmt;
use twinedge::validate::{Expectation, Part, Surface};

/// The parts by name.
const PARTS: [(Part, &str); 7] = [
    (Part::Prev, "prev"),
    (Part::Leaving, "leaving"),
    (Part::Faces, "faces"),
    (Part::BoundaryComponents, "boundaries"),
    (Part::Places, "places"),
    (Part::Holes, "holes"),
    (Part::UnboundedFace, "unbounded-face"),
];

/// An expectation in words: `plane`, or `surface open without prev places`.
pub(crate) struct ExpectationText(pub(crate) Expectation);

impl fmt::Display for ExpectationText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(expectation) = self;
        f.write_str(if expectation.surface_kind() == Surface::Plane { "plane" } else { "surface" })?;
        if expectation.is_open() {
            f.write_str(" open")?;
        }
        let mut lacks = PARTS.iter().filter(|(part, _)| !expectation.has(*part)).map(|(_, name)| *name).peekable();
        if lacks.peek().is_some() {
            f.write_str(" without")?;
        }
        lacks.try_for_each(|name| write!(f, " {name}"))
    }
}

/// Reads an expectation in words. What is wrong otherwise.
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
        Some("without") => {}
        Some(word) => return Err(format!("expected `open` or `without` in place of `{word}`")),
    }
    for word in words {
        let (part, _) = PARTS.iter().find(|(_, name)| *name == word).ok_or_else(|| {
            let names: Vec<&str> = PARTS.iter().map(|(_, name)| *name).collect();
            format!("there is no part `{word}`; the parts are {}", names.join(", "))
        })?;
        expectation = expectation.without(*part);
    }
    Ok(expectation)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_expectation_is_read_as_it_was_written() {
        for (part, _) in PARTS {
            for expectation in [Expectation::plane(), Expectation::surface(), Expectation::surface().open()] {
                for expectation in
                    [expectation, expectation.without(part), expectation.without(part).without(Part::Prev)]
                {
                    assert_eq!(parse(&ExpectationText(expectation).to_string()), Ok(expectation));
                }
            }
        }
        assert_eq!(ExpectationText(Expectation::plane()).to_string(), "plane");
    }

    #[test]
    fn other_words_are_errors() {
        for (text, told) in [
            ("", "`plane` or `surface`"),
            ("sphere", "`plane` or `surface`"),
            ("plane closed", "`closed`"),
            ("plane without handles", "no part `handles`; the parts are prev,"),
        ] {
            assert!(parse(text).unwrap_err().contains(told), "{text}");
        }
    }
}
