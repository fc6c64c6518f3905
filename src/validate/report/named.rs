//! Reports and violations with the owner's names for records.

use super::Report;
use super::names::Names;
use super::record::Record;
use super::text;
use super::violation::{Sentence, Violation};
use alloc::string::{String, ToString};
use core::fmt;

/// A report or a violation that prints names of records instead of indices: see [`Report::named`] and
/// [`Violation::named`].
pub struct Named<'a, T: ?Sized, F> {
    what: &'a T,
    names: F,
}

impl Report {
    /// Returns the report with the owner's names for records: `names` returns the name of a record, without its kind.
    ///
    /// A value that leads to no live record has no name, and stays the number that the view answered.
    ///
    /// ```
    /// use twinedge::validate::{Collect, Expectation, Record, Table, validate};
    /// // A loop that is its own twin.
    /// let table: Table = "V 1 0 - H 1 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
    /// let report = validate(&table, &Expectation::plane(), Collect::All);
    /// let named = report.named(|record| match record {
    ///     Record::HalfEdge(_) => "the loop",
    ///     _ => "the only one",
    /// });
    /// assert!(named.to_string().contains("L1: half-edge the loop is its own twin"));
    /// # Ok::<(), twinedge::validate::ParseTableError>(())
    /// ```
    pub const fn named<N: fmt::Display, F: Fn(Record) -> N>(&self, names: F) -> Named<'_, Self, F> {
        Named { what: self, names }
    }
}

impl Violation {
    /// Returns the violation with the owner's names for records, like [`Report::named`].
    ///
    /// ```
    /// use twinedge::validate::Violation;
    /// let violation = Violation::NextShared { first: 0, second: 1, next: 1 };
    /// let named = violation.named(|record| ["ab", "ba"][record.index()]);
    /// assert!(named.to_string().starts_with("L2: half-edges ab and ba both have next ba"));
    /// ```
    pub const fn named<N: fmt::Display, F: Fn(Record) -> N>(&self, names: F) -> Named<'_, Self, F> {
        Named { what: self, names }
    }
}

impl<N: fmt::Display, F: Fn(Record) -> N> fmt::Display for Named<'_, Report, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let write_name = |record, f: &mut fmt::Formatter<'_>| write!(f, "{}", (self.names)(record));
        text::write(self.what, Names(Some(&write_name)), f)
    }
}

impl<N: fmt::Display, F: Fn(Record) -> N> fmt::Display for Named<'_, Violation, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.what.rule(), self.message())
    }
}

impl<N: fmt::Display, F: Fn(Record) -> N> Named<'_, Violation, F> {
    /// Returns the sentence alone, without the id of the rule.
    #[must_use]
    pub fn message(&self) -> String {
        let write_name = |record, f: &mut fmt::Formatter<'_>| write!(f, "{}", (self.names)(record));
        Sentence(self.what, Names(Some(&write_name))).to_string()
    }
}

impl<T: ?Sized, F> fmt::Debug for Named<'_, T, F>
where
    Self: fmt::Display,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
