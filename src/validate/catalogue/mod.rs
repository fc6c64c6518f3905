//! Every rule with its violations: the table from which [`Rule`](super::Rule) and [`Violation`](super::Violation) are generated.
//!
//! A rule is a row: documentation, id and name, the noun for the checked records, its statement, the file of its check, and the test
//! that breaks only it. Its violations follow: variant and fields, kind, sentence, usual cause and remedy. The kinds of fields are
//! listed in `violation.rs`; `with` names further words of the sentence.

pub(super) mod drawing;
pub(super) mod faces;
pub(super) mod links;
pub(super) mod mesh;
pub(super) mod whole;

/// Passes all rows, in the order of the rules, to the macro of this name.
macro_rules! catalogue {
    ($define:ident) => {
        $crate::validate::catalogue::links::links_rules! { $define }
    };
}

pub(super) use catalogue;
