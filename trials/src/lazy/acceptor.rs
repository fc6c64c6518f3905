//! Validators that answer yes or no: the one under test, and the reference.

use super::labels::LazyLabels;
use super::open_table::OpenTable;
use super::work::Claim;
use crate::verdict::Validator;
use twinedge::validate::reference::first_broken_of;
use twinedge::validate::{Expectation, Rule, View, accepts};
use twinedge_certificate::{passes, passes_surface};

/// A validator under test that answers yes or no: [`lazy()`](crate::lazy()) compares it with the reference.
pub trait Acceptor: Sync {
    /// Returns true if the structure keeps all rules.
    ///
    /// The fewer records it reads of an invalid structure, the fewer runs are needed.
    fn accepts(&self, view: &dyn View, expectation: &Expectation) -> bool;

    /// Returns true if the labels show that the structure keeps all rules. The expectation claims only what certificates can
    /// claim: the plane, or closed surfaces of a genus.
    ///
    /// The default is the checker of the library: [`passes`] and [`passes_surface`].
    fn passes(&self, view: &dyn View, labels: LazyLabels<'_>, expectation: &Expectation) -> bool {
        match Claim::of(expectation) {
            Some(Claim::Plane) => passes(view, &labels),
            Some(Claim::Surface(genus)) => passes_surface(view, &labels, genus),
            None => false,
        }
    }
}

/// The fast path of the library: [`accepts`].
impl Acceptor for Validator {
    fn accepts(&self, view: &dyn View, expectation: &Expectation) -> bool {
        accepts(view, expectation)
    }
}

/// The sentences of the reference, in an order that reads few cells of invalid tables: rules that link cells to one another come
/// before R1, which reads all of them.
const ORDER: [Rule; 22] = [
    Rule::L2,
    Rule::L1,
    Rule::L3,
    Rule::V1,
    Rule::V2,
    Rule::T3,
    Rule::M1,
    Rule::M2,
    Rule::M4,
    Rule::M5,
    Rule::B1,
    Rule::B2,
    Rule::R1,
    Rule::F1,
    Rule::F2,
    Rule::T1,
    Rule::T2,
    Rule::T4,
    Rule::M3,
    Rule::M6,
    Rule::M7,
    Rule::M8,
];

/// Returns true if the reference finds no broken rule.
pub(super) fn is_right(table: &OpenTable, expectation: &Expectation) -> bool {
    table.all_hold(ORDER.len(), |rule| first_broken_of(table, expectation, &ORDER[rule..=rule]).is_none())
}
