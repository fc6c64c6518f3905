//! Texts of expectations, written and read.

use super::*;
use alloc::string::ToString as _;

#[test]
fn every_expectation_is_read_as_it_was_written() {
    let mut all = Expectation::surface().open();
    for (rule, word, ask) in ASKED {
        let [one, more] = [Expectation::plane(), all].map(|expectation| match ask {
            Ask::Plain(ask) => ask(expectation),
            Ask::Number(ask) => ask(expectation, 7),
        });
        assert!(one.asks_for(rule) && !Expectation::plane().asks_for(rule));
        assert!(one.to_string().starts_with(&["plane asking ", word].concat()));
        for expectation in [one, more] {
            assert_eq!(expectation.to_string().parse(), Ok(expectation));
        }
        all = more;
    }
    assert_eq!(
        all.to_string(),
        "surface open asking no-unused-vertices simple sides 7 closed components 7 \
         borders 7 genus 7 border-kept"
    );
    assert_eq!("plane open asking closed".parse(), Ok(Expectation::plane().open().closed()));
    assert_eq!("surface".parse(), Ok(Expectation::surface()));
}

#[test]
fn other_words_are_errors() {
    for (text, error, told) in [
        ("", ParseExpectationError::Surface, "expected `plane` or `surface`"),
        ("sphere", ParseExpectationError::Surface, "expected `plane` or `surface`"),
        (
            "plane closed",
            ParseExpectationError::Claim { word: "closed".into() },
            "expected `open` or `asking` in place of `closed`",
        ),
        (
            "plane asking handles",
            ParseExpectationError::Rule { word: "handles".into() },
            "`handles` cannot be asked for, but no-unused-vertices, simple, sides, closed, components, borders, genus, \
             border-kept can",
        ),
        ("plane asking genus", ParseExpectationError::Number { after: "genus" }, "expected a number after `genus`"),
        (
            "plane asking sides three",
            ParseExpectationError::Number { after: "sides" },
            "expected a number after `sides`",
        ),
    ] {
        assert_eq!(error.to_string(), told);
        assert_eq!(text.parse::<Expectation>(), Err(error), "{text}");
    }
}
