//! Errors of requests.

use thiserror::Error;
use twinedge::dcel::{Dcel, OperatorError};
use twinedge::validate::Record;

/// The reason why a request was refused. The structure is unchanged.
#[derive(Debug, PartialEq, Eq, Error)]
pub(crate) enum LessonError {
    /// The request has the form of no operation.
    #[error("{0}")]
    Request(String),
    /// There is no record with this index.
    #[error("there is no {0}")]
    NoRecord(Record),
    #[error("{0}")]
    Operator(String),
    /// A link was set by hand.
    #[error("links were set by hand: undo that before you use an operator")]
    Touched,
    /// The record has no such field.
    #[error("a {0} has no field `{1}`")]
    NoField(&'static str, String),
    /// The value is no link to such a record.
    #[error("`{value}` is no value of {field}: {expected}")]
    Value {
        value: String,
        field: String,
        /// The form of its values.
        expected: &'static str,
    },
}

impl LessonError {
    /// Returns the error of an operator, with the records named as in the tables.
    pub(crate) fn operator(error: OperatorError, dcel: &Dcel) -> Self {
        let mut text = error.to_string();
        for (key, record) in crate::state::keys(dcel) {
            text = text.replace(&key, &crate::state::name(record));
        }
        Self::Operator(text)
    }

    /// Returns the code with which JavaScript throws the error.
    pub(crate) const fn code(&self) -> &'static str {
        match self {
            Self::Request(_) | Self::NoRecord(_) | Self::NoField(..) | Self::Value { .. } => "option",
            Self::Operator(_) | Self::Touched => "refused",
        }
    }
}
