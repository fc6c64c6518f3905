//! The memory of the caller's columns.
//!
//! # Why it is sound
//!
//! The memory belongs to the caller, who may have other threads that write to it, or callbacks. So no `&[i64]` ever
//! leads there: it would promise that the memory does not change. It is read as atomic integers, which promise nothing:
//! each read is one load of an aligned integer. During a write, a load returns the old value or the new one, and the
//! validator returns on any values.
//!
//! - *In bounds*: the slice spans the bytes from the first cell to the last, which the caller promises to be one
//!   object; a span that does not fit into the address space is refused.
//! - *Aligned*: checked. Atomic integers of 32 and 64 bits are aligned to their size here, which may be more than C's
//!   alignment.
//! - *Initialised*: between the cells of a stride lie other fields and padding, which the slice covers and nobody
//!   loads. The caller's memory is bytes that Rust did not write, and every pattern of bits is an integer.
//! - *Types*: an atomic integer has the size and the bits of the integer. Its load requires no write access.

use crate::failure::{Failure, Status};
use std::ffi::c_void;
use std::sync::atomic::{AtomicI32, AtomicI64, AtomicU8, AtomicU32, AtomicU64, Ordering::Relaxed};
use twinedge_columns::{Cell, Column};

/// The type of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Width {
    I32,
    I64,
    U32,
    U64,
}

/// An atomic integer, as which an integer is read. Only this file implements it.
pub(crate) trait Atomic: Cell {
    /// Returns the integer, with its sign.
    fn number(&self) -> i128;
}

macro_rules! atomic {
    ($($type:ty),*) => {
        $(impl Atomic for $type {
            fn number(&self) -> i128 {
                self.load(Relaxed).into()
            }
        })*
    };
}

atomic!(AtomicI32, AtomicI64, AtomicU32, AtomicU64);

/// Cells of the caller: a pointer to the first, their number, and the number of bytes from one to the next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cells {
    start: *const c_void,
    count: usize,
    stride: isize,
}

impl Cells {
    /// Cells of `size` bytes each. A stride of 0 means that they are adjacent.
    pub(crate) fn new(
        name: &str,
        cells: *const c_void,
        count: usize,
        stride: isize,
        size: usize,
    ) -> Result<Self, Failure> {
        let refused = |status, why: &str| Err(Failure::new(status, format!("{name}: {why}")));
        if count > 0 && cells.is_null() {
            return refused(Status::Null, "the pointer is null");
        }
        let stride = if stride == 0 { size.cast_signed() } else { stride };
        if stride % size.cast_signed() != 0 {
            return refused(Status::Alignment, "the stride is no multiple of the size of a cell");
        }
        if !(cells as usize).is_multiple_of(size) {
            return refused(Status::Alignment, "the cells are not aligned");
        }
        let bytes = stride.unsigned_abs().checked_mul(count.saturating_sub(1)).and_then(|span| span.checked_add(size));
        let fits = |bytes: usize| {
            let start = cells as usize;
            isize::try_from(bytes).is_ok()
                && if stride < 0 { start >= bytes - size } else { start.checked_add(bytes).is_some() }
        };
        if count > 0 && !bytes.is_some_and(fits) {
            return refused(Status::Length, "so many cells do not fit into memory");
        }
        Ok(Self { start: cells, count, stride })
    }

    /// Returns the cells as a slice of all integers between the first and the last, and the position of the first in
    /// it.
    ///
    /// # Safety
    /// The memory is there for as long as `'a`, and `T` has the size for which the cells were made.
    unsafe fn span<'a, T>(&self) -> (&'a [T], usize, isize) {
        let stride = self.stride / size_of::<T>().cast_signed();
        let Some(steps) = self.count.checked_sub(1) else { return (&[], 0, 1) };
        // No overflow: checked by `new`.
        let span = steps * stride.unsigned_abs();
        let first = if stride < 0 { span } else { 0 };
        // SAFETY: see the head of the file. `new` has checked null, alignment and size; the caller promises the memory.
        let slice = unsafe { std::slice::from_raw_parts(self.start.cast::<T>().sub(first), span + 1) };
        (slice, first, stride)
    }

    /// Returns the column of links.
    ///
    /// # Safety
    /// The memory is there for as long as `'a`, and `T` has the size for which the cells were made.
    pub(crate) unsafe fn column<'a, T: Atomic>(&self) -> Result<Column<'a, T>, Failure> {
        // SAFETY: as the caller promises.
        let (span, first, stride) = unsafe { self.span::<T>() };
        Ok(Column::strided(span, first, stride, self.count)?)
    }

    /// Returns the integer at this position, if there is one.
    ///
    /// # Safety
    /// As [`column`](Self::column).
    pub(crate) unsafe fn number<T: Atomic>(&self, position: usize) -> Option<i128> {
        if position >= self.count {
            return None;
        }
        // SAFETY: as the caller promises.
        let (span, first, stride) = unsafe { self.span::<T>() };
        // No overflow: the cell is one of the span.
        let at = first.checked_add_signed(stride * position.cast_signed())?;
        span.get(at).map(Atomic::number)
    }

    /// Returns for each byte whether it is not 0.
    ///
    /// # Safety
    /// The memory is there, and the cells were made for bytes.
    pub(crate) unsafe fn flags(&self) -> Result<Vec<bool>, Failure> {
        // SAFETY: as the caller promises.
        let (span, first, stride) = unsafe { self.span::<AtomicU8>() };
        let mut flags = Vec::new();
        flags.try_reserve_exact(self.count).map_err(|_| Failure::memory())?;
        let mut at = first;
        for _ in 0..self.count {
            flags.push(span.get(at).is_some_and(|byte| byte.load(Relaxed) != 0));
            at = at.wrapping_add_signed(stride);
        }
        Ok(flags)
    }

    pub(crate) const fn count(&self) -> usize {
        self.count
    }

    /// Returns the pointer in the cell, for cells that are pointers.
    ///
    /// # Safety
    /// The memory is there, the cells were made for pointers, and `position < count`.
    pub(crate) unsafe fn pointer(&self, position: usize) -> *const c_void {
        // SAFETY: as the caller promises; an aligned cell within the span. Pointers are read before any callback is called.
        unsafe { *self.start.cast::<*const c_void>().byte_offset(self.stride * position.cast_signed()) }
    }
}
