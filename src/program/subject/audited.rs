//! An audited `Dcel` as a subject.

use super::{Refusal, Subject};
use crate::dcel::{Audited, Dcel, Watched};
use crate::store::Store;
use crate::validate::View;

impl<S: Store> View for Audited<S> {
    crate::delegate_view!(|this| this.dcel());
}

/// Runs an operator.
///
/// # Panics
/// Panics with the report if a rule is broken after it.
fn change<S: Store, T>(
    audited: &mut Audited<S>,
    operator: impl FnOnce(&mut Dcel<Watched<S>>) -> Result<T, Refusal>,
) -> Result<T, Refusal> {
    match audited.change(operator) {
        Ok(answer) => answer,
        Err(report) => panic!("{report}"),
    }
}

/// # Panics
/// The operators panic with the report if a rule is broken after them. See [`Audited::change`] for the report as an error.
impl<S: Store> Subject for Audited<S> {
    crate::delegate_subject!(Dcel<Watched<S>>, Self::dcel, change);
}
