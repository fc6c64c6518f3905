//! An audited `Dcel` as a subject.

use super::{Refusal, Subject};
use crate::dcel::{Audited, Dcel};
use crate::validate::View;

impl View for Audited {
    crate::delegate_view!(|this| this.get());
}

/// Runs an operator.
///
/// # Panics
/// Panics with the report if a rule is broken after it.
fn change<T>(audited: &mut Audited, operator: impl FnOnce(&mut Dcel) -> Result<T, Refusal>) -> Result<T, Refusal> {
    match audited.change(operator) {
        Ok(answer) => answer,
        Err(report) => panic!("{report}"),
    }
}

/// # Panics
/// The operators panic with the report if a rule is broken after them. See [`Audited::change`] for the report as an error.
impl Subject for Audited {
    crate::delegate_subject!(Dcel, Self::get, change);
}
