//! Faults to plant in the library, as data: `proofs/faults/*.txt`.
//!
//! A fault replaces one expression by an invalid one. All are planted in one copy of the sources, each behind a switch,
//! so that one build serves them all. The lines of a fault:
//!
//! ```text
//! fault  a description of the fault
//! file   the file, from the root of the workspace
//! in     a line of it, if the text alone also occurs elsewhere
//! text   the right expression
//! wrong  the wrong expression
//! ```

use std::fmt::{self, Write as _};

/// One fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// A description of the fault, in words.
    pub what: String,
    /// The file, from the root of the workspace.
    pub file: String,
    /// A line of the file, without indentation; empty if the text occurs once in the file.
    pub line: String,
    /// The right expression.
    pub text: String,
    /// The wrong expression.
    pub wrong: String,
}

/// An error in the list of faults, or in planting one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FaultError {
    /// A line that belongs to no fault.
    Line(String),
    /// A fault lacks one of its lines.
    Incomplete(String),
    /// The text does not occur exactly once.
    Stale {
        /// The fault.
        what: String,
        /// The number of times that the text occurs.
        found: usize,
    },
    /// Two faults replace texts that overlap but differ.
    Overlap(String),
}

impl fmt::Display for FaultError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "this is no line of a fault: {line}"),
            Self::Incomplete(what) => write!(f, "the fault lacks a line: {what}"),
            Self::Stale { what, found } => write!(f, "the text occurs {found} times, not once: {what}"),
            Self::Overlap(what) => write!(f, "the text overlaps that of another fault: {what}"),
        }
    }
}

impl std::error::Error for FaultError {}

/// Reads faults. Empty lines separate them; what follows `#` is a comment.
///
/// # Errors
/// [`FaultError::Line`], [`FaultError::Incomplete`].
pub fn parse(text: &str) -> Result<Vec<Fault>, FaultError> {
    let lines = |block: &str| {
        let lines = block.lines().filter(|line| !line.starts_with('#') && !line.trim().is_empty());
        lines.map(str::to_owned).collect::<Vec<_>>()
    };
    let blocks = text.split("\n\n").map(lines).filter(|lines| !lines.is_empty());
    blocks.map(|lines| fault(&lines)).collect()
}

fn fault(lines: &[String]) -> Result<Fault, FaultError> {
    let mut fields = [const { String::new() }; 5];
    for line in lines {
        let unknown = || FaultError::Line(line.clone());
        let (name, value) = line.split_once(' ').ok_or_else(unknown)?;
        let field = ["fault", "file", "in", "text", "wrong"].iter().position(|field| *field == name);
        value.trim().clone_into(&mut fields[field.ok_or_else(unknown)?]);
    }
    let [what, file, line, text, wrong] = fields;
    if [&what, &file, &text, &wrong].iter().any(|field| field.is_empty()) {
        return Err(FaultError::Incomplete(lines.join("; ")));
    }
    Ok(Fault { what, file, line, text, wrong })
}

impl Fault {
    /// Returns the position of the text in its file.
    ///
    /// # Errors
    /// [`FaultError::Stale`] unless it occurs exactly once.
    pub fn place(&self, source: &str) -> Result<usize, FaultError> {
        let stale = |found| FaultError::Stale { what: self.what.clone(), found };
        let once = |text: &str, within: &str| {
            let places: Vec<usize> = text.match_indices(within).map(|(place, _)| place).collect();
            if let [place] = places[..] { Ok(place) } else { Err(stale(places.len())) }
        };
        if self.line.is_empty() {
            return once(source, &self.text);
        }
        Ok(once(source, &self.line)? + once(&self.line, &self.text)?)
    }
}

/// Returns a file with these faults planted, each with the number of its switch.
///
/// # Errors
/// [`FaultError::Stale`], [`FaultError::Overlap`].
pub fn plant(source: &str, faults: &[(usize, &Fault)]) -> Result<String, FaultError> {
    let mut placed =
        faults.iter().map(|(n, fault)| Ok((fault.place(source)?, *n, *fault))).collect::<Result<Vec<_>, _>>()?;
    placed.sort_by_key(|(place, n, _)| (*place, *n));
    let (mut planted, mut done) = (String::new(), 0);
    let mut rest = &placed[..];
    while let Some((place, _, first)) = rest.first() {
        if *place < done {
            return Err(FaultError::Overlap(first.what.clone()));
        }
        let same = rest.iter().take_while(|(other, _, fault)| other == place && fault.text == first.text).count();
        planted.push_str(&source[done..*place]);
        planted.push('(');
        for (_, n, fault) in &rest[..same] {
            let _ = write!(planted, "if crate::planted_fault({n}) {{ {} }} else ", fault.wrong);
        }
        let _ = write!(planted, "{{ {} }})", first.text);
        done = place + first.text.len();
        rest = &rest[same..];
    }
    planted.push_str(&source[done..]);
    Ok(planted)
}

/// The text to append to the root file of the library: the function that reads the switch, once, from the
/// environment variable `PLANTED_FAULT`.
pub const SWITCH: &str = r#"
pub(crate) fn planted_fault(number: usize) -> bool {
    extern crate std;
    static CHOSEN: std::sync::OnceLock<usize> = std::sync::OnceLock::new();
    let read = || std::env::var("PLANTED_FAULT").ok()?.parse().ok();
    *CHOSEN.get_or_init(|| read().unwrap_or(usize::MAX)) == number
}
"#;
