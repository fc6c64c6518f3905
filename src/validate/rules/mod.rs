//! The rules in four files, each with its table of rules and violations: [`links`], [`faces`], [`whole`], [`mesh`]. R1 stands
//! in [`live`]. G1 … G5 have their table in [`drawing`], and a file each.
//!
//! A row of a table is a rule: its documentation, id and name, the noun for the records on which it is checked, its statement, the file of
//! its check, and the test that breaks it alone. Its violations follow: variant and fields, kind, sentence, usual cause and remedy. A field
//! is of one of the kinds that `violation.rs` lists; `with` names what else the sentence says.

pub(super) mod drawing;
pub(super) mod faces;
pub(super) mod links;
pub(super) mod live;
pub(super) mod mesh;
pub(super) mod whole;

#[cfg(feature = "geometry")]
pub(super) mod angles;
#[cfg(feature = "geometry")]
pub(super) mod disjoint;
#[cfg(feature = "geometry")]
pub(super) mod finite;
#[cfg(feature = "geometry")]
pub(super) mod inside;
#[cfg(feature = "geometry")]
pub(super) mod winding;

/// Hands all rows, in the order of the rules, to the macro of this name.
macro_rules! catalogue {
    ($define:ident) => {
        $crate::validate::rules::links::links_rules! { $define }
    };
}

pub(super) use catalogue;
