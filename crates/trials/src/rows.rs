//! Rows of counts, as parts of outcomes: each column is declared once.
//!
//! The declaration defines the field and its JSON, the addition of the rows of parts, and the printing and comparison of a row.

/// A row of an outcome.
pub trait Row {
    /// The columns, in the order of [`cells`](Self::cells).
    const COLUMNS: &'static [Column];

    /// Returns the cells of this row.
    fn cells(&self) -> Vec<Cell>;

    /// Adds the counts of the same row of another part.
    #[doc(hidden)]
    fn add(&mut self, other: &Self);

    /// Returns the unexpected counts: the name of the column, the count, and the expected one.
    fn differences(&self) -> impl Iterator<Item = (&'static str, u64, u64)> {
        Self::COLUMNS.iter().zip(self.cells()).filter_map(|(column, cell)| match cell {
            Cell::Count { found, expected: Some(expected) } if found != expected => {
                Some((column.name, found, expected))
            }
            _ => None,
        })
    }
}

/// A column of a [`Row`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Column {
    /// The name in the head.
    pub name: &'static str,
    /// The width in characters. With 0 it is compared and not printed.
    pub width: usize,
    /// True for a name of the row, which is aligned to the left.
    pub is_label: bool,
}

/// A cell of a [`Row`].
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Cell {
    /// A part of the name of the row.
    Text(String),
    /// A count, and the expected one, if there is one.
    Count {
        /// The count.
        found: u64,
        /// The expected one.
        expected: Option<u64>,
    },
    /// A count with the expected value 0.
    Zero(u64),
}

/// Defines rows. Each field begins with its role:
///
/// | role | parts add up | cell |
/// | --- | --- | --- |
/// | `key`, `label` | to the same | text, aligned to the right or left |
/// | `given` | to the same | a count |
/// | `count` | to the sum | a count |
/// | `zero` | to the sum | a count that should be 0 |
/// | `slowest` | to the largest | a time |
///
/// The field follows, with the name and width of its column, if it has one, and the field with which it `is` equal.
macro_rules! rows {
    ($(
        $(#[$doc:meta])*
        pub struct $name:ident {$(
            $(#[$field_doc:meta])*
            $role:ident $field:ident: $type:ty $(= $title:literal $width:literal $(is $expected:ident)?)?;
        )*}
    )*) => {$(
        $(#[$doc])*
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $type,)*
        }

        impl $crate::rows::Row for $name {
            const COLUMNS: &'static [$crate::rows::Column] = &[$($($crate::rows::Column {
                name: $title,
                width: $width,
                is_label: $crate::rows::is_label!($role),
            },)?)*];

            fn cells(&self) -> Vec<$crate::rows::Cell> {
                vec![$($($crate::rows::cell!($role, self.$field $(, self.$expected)?),)?)*]
            }

            fn add(&mut self, other: &Self) {
                $($crate::rows::add_up!($role, self.$field, other.$field);)*
            }
        }
    )*};
}
pub(crate) use rows;

macro_rules! is_label {
    (label) => {
        true
    };
    ($role:ident) => {
        false
    };
}
pub(crate) use is_label;

macro_rules! cell {
    (key, $field:expr) => {
        $crate::rows::Cell::Text($field.to_string())
    };
    (label, $field:expr) => {
        $crate::rows::Cell::Text($field.to_string())
    };
    (slowest, $field:expr) => {
        $crate::rows::Cell::Text(format!("{:.0} µs", $field.as_secs_f64() * 1e6))
    };
    (zero, $field:expr) => {
        $crate::rows::Cell::Zero($field)
    };
    ($role:ident, $field:expr) => {
        $crate::rows::Cell::Count { found: $field, expected: None }
    };
    ($role:ident, $field:expr, $expected:expr) => {
        $crate::rows::Cell::Count { found: $field, expected: $expected.into() }
    };
}
pub(crate) use cell;

macro_rules! add_up {
    (count, $field:expr, $other:expr) => {
        $field += $other
    };
    (zero, $field:expr, $other:expr) => {
        $field += $other
    };
    (slowest, $field:expr, $other:expr) => {
        $field = $field.max($other)
    };
    ($role:ident, $field:expr, $other:expr) => {
        let _ = &$other;
    };
}
pub(crate) use add_up;

pub(crate) fn add_rows<R: Row>(sum: &mut [R], rows: &[R]) {
    sum.iter_mut().zip(rows).for_each(|(sum, row)| sum.add(row));
}

/// The largest number of findings that an outcome keeps; all are counted.
pub(crate) const MOST_FINDINGS: usize = 10;

pub(crate) fn add_findings<T: Clone>(findings: &mut Vec<T>, others: &[T]) {
    findings.extend_from_slice(others);
    findings.truncate(MOST_FINDINGS);
}

/// Returns a published count, limited to 64 bits.
pub(crate) fn narrow(count: u128) -> u64 {
    u64::try_from(count).unwrap_or(u64::MAX)
}
