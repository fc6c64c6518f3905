//! Errors of calls.

use twinedge_columns::ColumnsError;

/// The result of a call: 0, or the reason why it failed.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// All is well. Of `twinedge_validate`: there is a report, whether the structure is valid or not.
    Ok,
    /// A pointer is null.
    Null,
    /// A number or a name that means nothing here: of a link, a kind of record, an expectation, a preset.
    Unknown,
    /// A column has another length than there are records, or would not fit into memory.
    Length,
    /// The cells of a column are not aligned, or its stride is no multiple of their size.
    Alignment,
    /// Columns are of different types.
    Type,
    /// A column that is needed is missing.
    Missing,
    /// Two settings contradict each other, or a record is given twice.
    Conflict,
    /// There is not enough memory, or there are more than 4,294,967,294 records of a kind.
    Memory,
    /// A defect of this library: it panicked, and the message went to the standard error. Or a callback in Rust that panicked. (An
    /// exception of C++ that leaves a callback is no error of this kind: it ends the process.)
    Panic,
}

/// An error with its message.
#[derive(Clone, Debug)]
pub(crate) struct Failure {
    pub(crate) status: Status,
    pub(crate) message: String,
}

impl Failure {
    pub(crate) fn new(status: Status, message: impl Into<String>) -> Self {
        Self { status, message: message.into() }
    }

    pub(crate) fn memory() -> Self {
        Self::new(Status::Memory, "not enough memory, or more than 4,294,967,294 records of a kind")
    }
}

impl From<ColumnsError> for Failure {
    fn from(error: ColumnsError) -> Self {
        Self::new(Status::Length, error.to_string())
    }
}
