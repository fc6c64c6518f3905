//! Comments that begin with a question word: nouns that a reader has to unpack ("What is found", "How many there are").

/// The words with which no comment begins.
pub const QUESTIONS: [&str; 5] = ["What", "Which", "How", "Where", "Whether"];

/// The signs that begin a line of a comment: of Rust and JavaScript (the longer ones first), of Coq, and of shells and tables.
const SIGNS: [&str; 6] = ["///", "//!", "//", "(**", "(*", "#"];

/// The line of each comment that begins with one of [`QUESTIONS`]. Lines of a comment that follow one another are one comment. O(n).
#[must_use]
pub fn questions(source: &str) -> Vec<usize> {
    let mut found = Vec::new();
    let mut before = None;
    for (number, line) in (1..).zip(source.lines()) {
        let line = line.trim_start();
        let sign = SIGNS.into_iter().find(|sign| line.starts_with(sign));
        if let Some(sign) = sign.filter(|_| sign != before) {
            let word = line[sign.len()..].trim_start().split(|letter: char| !letter.is_ascii_alphabetic()).next();
            if word.is_some_and(|word| QUESTIONS.contains(&word)) {
                found.push(number);
            }
        }
        before = sign;
    }
    found
}
