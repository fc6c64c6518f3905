//! The border: handles become references, panics become errors.
//!
//! # Why it is sound
//!
//! A handle is the pointer of a `Box` that this library has made, or null, which is checked. The caller promises the
//! rest, as the head of the crate says. A reference lives only while `run` does: no callback of the caller runs
//! meanwhile, as [`crate::structure::twinedge_validate`] copies the plan first. So a callback that uses the handle
//! again meets no other reference.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// Returns the result of `run`, or `otherwise` if it panics.
pub(crate) fn guarded<R>(otherwise: R, run: impl FnOnce() -> R) -> R {
    // A panic leaves a structure or a report half done. These have no invariants between their fields.
    catch_unwind(AssertUnwindSafe(run)).unwrap_or(otherwise)
}

/// Returns the result of `run` for the object of the handle, or `otherwise` if the handle is null or `run` panics.
///
/// # Safety
/// The handle is null, or leads to an object that this library has made, and that no other call uses meanwhile.
pub(crate) unsafe fn with_mut<T, R>(handle: *mut T, otherwise: R, run: impl FnOnce(&mut T) -> R) -> R {
    if handle.is_null() {
        return otherwise;
    }
    // SAFETY: not null, so as the caller promises.
    let object = unsafe { &mut *handle };
    guarded(otherwise, || run(object))
}

/// Returns the result of `run` for an object that others may read meanwhile, or `otherwise` if the handle is null or
/// `run` panics. The result may borrow from the object, and then lives as long as it.
///
/// # Safety
/// The handle is null, or leads to an object that this library has made, and that no call changes meanwhile.
pub(crate) unsafe fn with<'a, T: 'a, R>(handle: *const T, otherwise: R, run: impl FnOnce(&'a T) -> R) -> R {
    if handle.is_null() {
        return otherwise;
    }
    // SAFETY: not null, so as the caller promises.
    let object = unsafe { &*handle };
    guarded(otherwise, || run(object))
}

/// Returns the handle of an object.
pub(crate) fn handle<T>(object: T) -> *mut T {
    Box::into_raw(Box::new(object))
}

/// Frees the object of the handle, if it is not null.
///
/// # Safety
/// The handle is null, or comes from [`handle`], and is not used afterwards.
pub(crate) unsafe fn free<T>(handle: *mut T) {
    if !handle.is_null() {
        // SAFETY: not null, so it comes from `Box::into_raw`, once.
        let object = unsafe { Box::from_raw(handle) };
        guarded((), || drop(object));
    }
}
