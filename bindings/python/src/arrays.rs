//! Arrays of numpy as columns of atomic integers. The only unsafe code of the package.
//!
//! # Why it is sound
//!
//! The memory of an array belongs to numpy. While the interpreter lock is released, another thread may write to it from
//! Python, and even while the lock is held, a numpy function that has released it may write. No lock and no flag of
//! numpy excludes this (the base of a read-only array may be writable), so no `&[i64]` may ever lead there: it would
//! promise that the memory does not change. Here it is read as atomic integers, which promise nothing: each read is one
//! load of an aligned integer, and the compiler assumes no earlier value. During a write, a load returns the old value
//! or the new one. The validator trusts no value: any answers, even changing ones, end in a report, without a panic or
//! a read outside of the slice.
//!
//! - *Alive*: a column keeps a reference to its array. numpy frees or moves the memory of an array only with its last
//!   reference, or in `ndarray.resize(…, refcheck=False)`, which turns off numpy's own check for this and must not be
//!   called meanwhile, as with any other use of the array.
//! - *In bounds, aligned*: pointer, shape and strides are read under the lock, and the slice spans exactly the elements
//!   between the first and the last. numpy guarantees that all of them exist (except for arrays made by `as_strided` of
//!   `numpy.lib.stride_tricks`, which break every user of such an array). An array that is unaligned or not in whole
//!   steps is refused.
//! - *Initialised*: numpy's integers have no invalid bit pattern, and `numpy.empty` hands out memory that has some bit
//!   pattern.
//! - *Types*: an atomic integer has the size, alignment and bit pattern of the integer. Atomic loads need no write
//!   access on the targets that have these types, so read-only memory (a mapped file) is fine.

use numpy::{Element, PyArray1, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use std::sync::atomic::{AtomicI32, AtomicI64, Ordering::Relaxed};
use twinedge_columns::{Cell, Column};

/// An integer type of numpy, with the atomic integer to read it as.
pub(crate) trait Atomic: Element {
    /// Of the same size, alignment and bits. Only this file implements it.
    type As: Cell + Sync;
    /// The bits of a cell.
    fn bits(cell: &Self::As) -> u64;
}

macro_rules! atomic {
    ($($integer:ty, $atomic:ty;)*) => {
        $(
            impl Atomic for $integer {
                type As = $atomic;
                fn bits(cell: &$atomic) -> u64 {
                    let mut bytes = [0; 8];
                    bytes[..size_of::<$integer>()].copy_from_slice(&cell.load(Relaxed).to_ne_bytes());
                    u64::from_ne_bytes(bytes)
                }
            }
        )*
    };
}

atomic! {
    i32, AtomicI32;
    i64, AtomicI64;
}

/// One array, with the memory that its elements span.
pub(crate) struct Array<'py, T: Atomic> {
    name: &'static str,
    array: Bound<'py, PyArray1<T>>,
}

/// The cells of an array, while it is kept.
pub(crate) struct Cells<'a, T: Atomic> {
    span: &'a [T::As],
    first: usize,
    stride: isize,
    len: usize,
}

impl<T: Atomic> Clone for Cells<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Atomic> Copy for Cells<'_, T> {}

impl<'py, T: Atomic> Array<'py, T> {
    /// Returns the array, if it is one-dimensional and of this type.
    pub(crate) fn new(name: &'static str, array: &Bound<'py, PyAny>) -> PyResult<Self> {
        let array = array.cast::<PyArray1<T>>().map_err(|_| {
            PyTypeError::new_err(format!("{name}: expected a one-dimensional array of the same type as the others"))
        })?;
        Ok(Self { name, array: array.clone() })
    }

    /// Returns the cells of the array.
    #[allow(unsafe_code, reason = "the one place, argued at the head of the file")]
    pub(crate) fn cells(&self) -> PyResult<Cells<'_, T>> {
        let refused = |why| PyValueError::new_err(format!("{}: {why}", self.name));
        let size = size_of::<T>();
        let (len, bytes) = (self.array.len(), self.array.strides()[0]);
        if len == 0 {
            return Ok(Cells { span: &[], first: 0, stride: 1, len: 0 });
        }
        let start = self.array.data();
        let whole = isize::try_from(size).ok().filter(|size| bytes % size == 0);
        let (Some(step), true) = (whole, start.cast::<T::As>().is_aligned()) else {
            return Err(refused("the elements are not aligned"));
        };
        let stride = bytes / step;
        let steps = (len - 1).checked_mul(stride.unsigned_abs());
        let steps =
            steps.filter(|steps| steps.checked_mul(size).is_some_and(|bytes| bytes <= isize::MAX as usize - size));
        let Some(steps) = steps else { return Err(refused("the array spans too much memory")) };
        let first = if stride < 0 { steps } else { 0 };
        // SAFETY: `start` leads to element 0, and element `len - 1` lies `steps` integers after it, or before it if the
        // stride is negative. Both are in one allocation, which `self.array` keeps. Everything between them is
        // initialised memory of that allocation, aligned like element 0. See the head of the file for writes by others.
        let span = unsafe { std::slice::from_raw_parts(start.cast::<T::As>().cast_const().sub(first), steps + 1) };
        Ok(Cells { span, first, stride, len })
    }
}

impl<'a, T: Atomic> Cells<'a, T> {
    /// Returns the column of links.
    pub(crate) fn column(&self) -> PyResult<Column<'a, T::As>> {
        Column::strided(self.span, self.first, self.stride, self.len).map_err(|e| PyValueError::new_err(e.to_string()))
    }

    /// Returns a number that differs after nearly every change of the array.
    pub(crate) fn sum(&self) -> u64 {
        let (mut at, mut sum, mut weight) = (self.first, 0_u64, 1_u64);
        for _ in 0..self.len {
            sum = sum.wrapping_add(T::bits(&self.span[at]).wrapping_mul(weight));
            weight = weight.wrapping_add(0x9E37_79B9_7F4A_7C16);
            at = at.wrapping_add_signed(self.stride);
        }
        sum
    }
}
