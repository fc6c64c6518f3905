//! Every rule with its violations: the table from which [`Rule`](super::Rule) and [`Violation`](super::Violation) are made.
//!
//! A rule is a row: its documentation, id and name, the noun for what it is checked on, its statement, the file of its check, and the
//! test that breaks it alone. Its violations follow: variant and fields, kind, sentence, usual cause and remedy. A field is of one of the
//! kinds that `violation.rs` lists; `with` names what else the sentence says.

pub(super) mod drawing;
pub(super) mod faces;
pub(super) mod links;
pub(super) mod mesh;
pub(super) mod whole;

/// Hands all rows, in the order of the rules, to the macro of this name.
macro_rules! catalogue {
    ($define:ident) => {
        $crate::validate::catalogue::links::links_rules! { $define }
    };
}

pub(super) use catalogue;
