//! One link as an integer.

use twinedge::validate::Link;

mod sealed {
    pub trait Sealed: Sized {
        /// These cells, if they hold links as the columns that a [`View`](twinedge::validate::View) lends.
        fn numbers(_: &[Self]) -> Option<&[u32]> {
            None
        }
    }
}

/// An integer that holds a link: `i32`, `i64`, `u32` or `u64`, or an atomic one of these.
///
/// Nil is −1 for signed types, and the largest value for unsigned ones. Any other negative number dangles.
///
/// Atomic integers are read with `Relaxed`, once per query. They are for memory that others may write during the validation: each
/// answer may then reflect a different moment, but nothing is undefined.
///
/// ```
/// use twinedge_columns::Cell;
/// assert_eq!((7_i32.link(), (-1_i32).link(), (-2_i64).link()), (Some(7), None, Some(usize::MAX)));
/// assert_eq!((7_u64.link(), u32::MAX.link(), u64::MAX.link()), (Some(7), None, None));
/// ```
pub trait Cell: sealed::Sealed {
    /// Returns the link.
    fn link(&self) -> Link;
}

macro_rules! cells {
    ($($type:ty, $value:expr, $nil:expr $(, $numbers:expr)?;)*) => {
        $(
            impl sealed::Sealed for $type {
                $(
                    fn numbers(cells: &[Self]) -> Option<&[u32]> {
                        $numbers(cells)
                    }
                )?
            }

            impl Cell for $type {
                #[inline]
                fn link(&self) -> Link {
                    let value = $value(self);
                    if value == $nil { None } else { Some(usize::try_from(value).unwrap_or(usize::MAX)) }
                }
            }
        )*
    };
}

cells! {
    i32, |cell: &Self| *cell, -1;
    i64, |cell: &Self| *cell, -1;
    u32, |cell: &Self| *cell, u32::MAX, Some;
    u64, |cell: &Self| *cell, u64::MAX;
}

#[cfg(target_has_atomic = "32")]
mod of_32_bits {
    use super::{Cell, Link, sealed};
    use core::sync::atomic::{AtomicI32, AtomicU32, Ordering::Relaxed};

    cells! {
        AtomicI32, |cell: &Self| cell.load(Relaxed), -1;
        AtomicU32, |cell: &Self| cell.load(Relaxed), u32::MAX;
    }
}

#[cfg(target_has_atomic = "64")]
mod of_64_bits {
    use super::{Cell, Link, sealed};
    use core::sync::atomic::{AtomicI64, AtomicU64, Ordering::Relaxed};

    cells! {
        AtomicI64, |cell: &Self| cell.load(Relaxed), -1;
        AtomicU64, |cell: &Self| cell.load(Relaxed), u64::MAX;
    }
}
