//! Comments that begin with a question word: nouns that a reader has to unpack ("What is found", "How many there are").

/// The words with which no comment begins.
pub const QUESTIONS: [&str; 5] = ["What", "Which", "How", "Where", "Whether"];

/// The number of documentation comments in a source, and those that begin with a question word.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Openings {
    /// The number of comments. Lines of documentation that follow one another are one comment.
    pub comments: usize,
    /// The line of each that begins with one of [`QUESTIONS`].
    pub questions: Vec<usize>,
}

/// The documentation comments of a source. O(n).
#[must_use]
pub fn openings(source: &str) -> Openings {
    let mut found = Openings::default();
    let mut is_inside = false;
    for (number, line) in (1..).zip(source.lines()) {
        let text = documentation(line);
        if let Some(text) = text.filter(|_| !is_inside) {
            found.comments += 1;
            let word = text.split(|letter: char| !letter.is_ascii_alphabetic()).next();
            if word.is_some_and(|word| QUESTIONS.contains(&word)) {
                found.questions.push(number);
            }
        }
        is_inside = text.is_some();
    }
    found
}

fn documentation(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let text = line.strip_prefix("///").or_else(|| line.strip_prefix("//!"))?;
    (!text.starts_with('/')).then(|| text.trim_start())
}
