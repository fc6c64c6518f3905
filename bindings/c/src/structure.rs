//! The handle of a structure: the caller's description of it.

use crate::border::{free, guarded, handle, with, with_mut};
use crate::callbacks::{Callback, InnerOf, LinkOf};
use crate::cells::{Cells, Width};
use crate::failure::{Failure, Status};
use crate::judge::judge;
use crate::names::{Expect, Link, Record};
use crate::plan::Plan;
use crate::report::Report;
use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::ptr::null_mut;

/// A half-edge structure, as the caller describes it. It holds pointers to the caller's memory, and copies nothing of it.
///
/// One thread at a time may use it.
#[derive(Debug, Default)]
pub struct Structure {
    plan: Plan,
    /// The first failure of a setter.
    failed: Option<Status>,
    message: CString,
}

impl Structure {
    fn fail(&mut self, failure: &Failure) -> Status {
        self.message = CString::new(failure.message.replace('\0', "")).unwrap_or_default();
        failure.status
    }

    /// Keeps the first failure.
    fn set(&mut self, setting: impl FnOnce(&mut Plan) -> Result<(), Failure>) -> Status {
        match setting(&mut self.plan) {
            Ok(()) => Status::Ok,
            Err(failure) => match self.failed {
                None => {
                    let status = self.fail(&failure);
                    *self.failed.insert(status)
                }
                Some(_) => failure.status,
            },
        }
    }
}

/// # Safety
/// As [`with_mut`].
unsafe fn set(structure: *mut Structure, setting: impl FnOnce(&mut Plan) -> Result<(), Failure>) -> Status {
    if structure.is_null() {
        return Status::Null;
    }
    // SAFETY: as the caller promises.
    unsafe { with_mut(structure, Status::Panic, |structure| structure.set(setting)) }
}

/// The version of this library.
#[unsafe(no_mangle)]
pub extern "C" fn twinedge_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

/// A structure without columns. By default it is to be a closed surface of any genus. Free it with `twinedge_structure_free`.
///
/// A setter that fails changes nothing else, but the structure stays failed: each `twinedge_validate` returns the first failure of a
/// setter again, so a caller may look at its status alone. Free the structure then, and start over.
#[unsafe(no_mangle)]
pub extern "C" fn twinedge_structure_new() -> *mut Structure {
    guarded(null_mut(), || handle(Structure::default()))
}

/// Frees the structure. Reports of it stay.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_structure_free(structure: *mut Structure) {
    // SAFETY: as the caller promises.
    unsafe { free(structure) }
}

/// The message of the first setter that failed; else, of the last `twinedge_validate` if it failed; else "". It belongs to the
/// structure, until the next call on it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_structure_error(structure: *const Structure) -> *const c_char {
    // SAFETY: as the caller promises.
    unsafe { with(structure, c"".as_ptr(), |structure| structure.message.as_ptr()) }
}

/// # Safety
/// As [`with_mut`].
unsafe fn column(
    structure: *mut Structure,
    link: c_int,
    width: Width,
    cells: *const c_void,
    (count, stride, size): (usize, isize, usize),
) -> Status {
    let setting = |plan: &mut Plan| {
        let link = Link::of(link)?;
        plan.column(link, width, Cells::new(link.name(), cells, count, stride, size)?)
    };
    // SAFETY: as the caller promises.
    unsafe { set(structure, setting) }
}

/// A column of `count` links of 32 bits with sign. `stride` is the number of bytes from one link to the next: `sizeof` the struct for a
/// field of an array of structs, 0 for an array of links, negative for one that is read backwards. Nil is −1. The memory is
/// read by `twinedge_validate`, and must be there until then. All columns of a structure are of one type. A column that is given again
/// takes the place of the first.
///
/// O(1). Errors: `NULL`, `UNKNOWN` (no such link), `LENGTH`, `ALIGNMENT`, `TYPE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_column_i32(
    structure: *mut Structure,
    link: c_int,
    cells: *const i32,
    count: usize,
    stride: isize,
) -> Status {
    // SAFETY: as the caller promises.
    unsafe { column(structure, link, Width::I32, cells.cast(), (count, stride, size_of::<i32>())) }
}

/// The same of 64 bits with sign; nil is −1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_column_i64(
    structure: *mut Structure,
    link: c_int,
    cells: *const i64,
    count: usize,
    stride: isize,
) -> Status {
    // SAFETY: as the caller promises.
    unsafe { column(structure, link, Width::I64, cells.cast(), (count, stride, size_of::<i64>())) }
}

/// The same of 32 bits without sign; nil is the largest number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_column_u32(
    structure: *mut Structure,
    link: c_int,
    cells: *const u32,
    count: usize,
    stride: isize,
) -> Status {
    // SAFETY: as the caller promises.
    unsafe { column(structure, link, Width::U32, cells.cast(), (count, stride, size_of::<u32>())) }
}

/// The same of 64 bits without sign; nil is the largest number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_column_u64(
    structure: *mut Structure,
    link: c_int,
    cells: *const u64,
    count: usize,
    stride: isize,
) -> Status {
    // SAFETY: as the caller promises.
    unsafe { column(structure, link, Width::U64, cells.cast(), (count, stride, size_of::<u64>())) }
}

/// Sets the number of records of a kind, for vertices, faces and boundary components that no column counts.
///
/// By default there are as many vertices as `LEAVING` or `ISOLATED` has, as many faces as `FACE_HALF_EDGE` or `OUTER` has; else as many
/// as `twinedge_live` has marks; else one more than the largest link, but at most as many as half-edges. Errors: `NULL`, `UNKNOWN`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_records(structure: *mut Structure, kind: c_int, count: usize) -> Status {
    let setting = |plan: &mut Plan| {
        plan.counts[Record::of(kind)? as usize] = Some(count);
        Ok(())
    };
    // SAFETY: as the caller promises.
    unsafe { set(structure, setting) }
}

/// Marks the live records of a kind: a byte for each, 0 for a slot that is vacant. By default all are. `stride` is the number of
/// bytes from one to the next; 0 means 1.
///
/// Errors: `NULL`, `UNKNOWN`, `LENGTH`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_live(
    structure: *mut Structure,
    kind: c_int,
    live: *const u8,
    count: usize,
    stride: isize,
) -> Status {
    let setting = |plan: &mut Plan| {
        let kind = Record::of(kind)?;
        plan.live[kind as usize] = Some(Cells::new("live", live.cast(), count, stride, 1)?);
        Ok(())
    };
    // SAFETY: as the caller promises.
    unsafe { set(structure, setting) }
}

/// The records of a kind, for a structure of pointers: an array of `count` pointers, none of them null or there twice. Reports name a
/// record by its position. A record that is not in the array is not validated, and a link to it dangles.
///
/// Errors: `NULL`, `UNKNOWN`, `LENGTH`, `ALIGNMENT`; of `twinedge_validate`: `NULL`, `CONFLICT`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_pointers(
    structure: *mut Structure,
    kind: c_int,
    records: *const *const c_void,
    count: usize,
) -> Status {
    let setting = |plan: &mut Plan| {
        let kind = Record::of(kind)?;
        let cells = Cells::new(kind.name(), records.cast(), count, 0, size_of::<*const c_void>())?;
        plan.records[kind as usize] = Some(cells);
        Ok(())
    };
    // SAFETY: as the caller promises.
    unsafe { set(structure, setting) }
}

/// The function that says where a link leads, for a structure of pointers. It is called by `twinedge_validate`, once for each record. It
/// must not free the structure, and must return: an exception of C++ that leaves it ends the process, with a message that does not
/// name the function. In C++, `follow` of `twinedge/twinedge.hpp` takes functions that may throw.
///
/// `NEXT`, `TWIN` and one of `ORIGIN` and `TARGET` are needed, and the lists of the records that have a link and to which it leads.
///
/// Errors: `NULL`, `UNKNOWN` (no such link, or one of `INNER_FIRST` and `INNER`, which are for `twinedge_follow_inner`); of
/// `twinedge_validate`: `MISSING`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_follow(
    structure: *mut Structure,
    link: c_int,
    function: LinkOf,
    context: *mut c_void,
) -> Status {
    let setting = |plan: &mut Plan| {
        let link = Link::of(link)?;
        if link.ends().is_none() {
            return Err(Failure::new(Status::Unknown, format!("{}: no link of one record", link.name())));
        }
        if function.is_none() {
            return Err(Failure::new(Status::Null, format!("{}: the function is null", link.name())));
        }
        plan.links[link as usize] = Some(Callback { function, context });
        Ok(())
    };
    // SAFETY: as the caller promises.
    unsafe { set(structure, setting) }
}

/// The function that says what faces list as inner boundary components, for a structure of pointers. All lists together are read up
/// to twice as many as there are boundary components, and 17. The lists of faces and of boundary components are needed.
///
/// Errors: `NULL`; of `twinedge_validate`: `MISSING`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_follow_inner(
    structure: *mut Structure,
    function: InnerOf,
    context: *mut c_void,
) -> Status {
    let setting = |plan: &mut Plan| {
        if function.is_none() {
            return Err(Failure::new(Status::Null, "inner: the function is null"));
        }
        plan.inner = Some(Callback { function, context });
        Ok(())
    };
    // SAFETY: as the caller promises.
    unsafe { set(structure, setting) }
}

/// Holds the structure to the promises of a library, instead of `PLANE`: `surface_mesh` and `arrangement_2` (CGAL), `openmesh`, `trimesh`,
/// `compas`, `networkx`. All columns that are given are looked at. Errors: `NULL`, `UNKNOWN`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_preset(structure: *mut Structure, name: *const c_char) -> Status {
    if name.is_null() {
        // SAFETY: as the caller promises.
        return unsafe { set(structure, |_| Err(Failure::new(Status::Null, "preset: the name is null"))) };
    }
    // SAFETY: not null, so as the caller promises; it is used in this function only.
    let name = unsafe { CStr::from_ptr(name) };
    // SAFETY: as the caller promises.
    unsafe { set(structure, |plan| plan.asked.preset(&name.to_string_lossy())) }
}

/// Something that is expected, one of `twinedge_expected`: with a number, or 1 to ask for it and 0 not to. Errors: `NULL`, `UNKNOWN`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_expect(structure: *mut Structure, what: c_int, number: usize) -> Status {
    let setting = |plan: &mut Plan| {
        plan.asked.set(Expect::of(what)?, number);
        Ok(())
    };
    // SAFETY: as the caller promises.
    unsafe { set(structure, setting) }
}

/// Validates the structure. `*report` is the report, which the caller frees with `twinedge_report_free`, or null if there is an error.
/// That a structure is not valid is no error.
///
/// O(n) time and memory for n records. It returns on any links whatever. Errors: all of `twinedge_status`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_validate(structure: *mut Structure, report: *mut *mut Report) -> Status {
    if report.is_null() {
        // SAFETY: as the caller promises.
        return unsafe { set(structure, |_| Err(Failure::new(Status::Null, "the place for the report is null"))) };
    }
    // SAFETY: not null, so a place for a pointer.
    unsafe { report.write(null_mut()) };
    if structure.is_null() {
        return Status::Null;
    }
    // The plan is copied, so that no reference to the structure is held while callbacks run.
    let copy = |structure: &mut Structure| match structure.failed {
        None => {
            // Drops the message of an earlier validation.
            structure.message = CString::default();
            Ok(structure.plan.clone())
        }
        Some(status) => Err(status),
    };
    // SAFETY: as the caller promises.
    let plan = match unsafe { with_mut(structure, Err(Status::Panic), copy) } {
        Ok(plan) => plan,
        Err(status) => return status,
    };
    let panicked = || Err(Failure::new(Status::Panic, "the validation, or a function of the caller, panicked"));
    // SAFETY: as the caller promises for all that the plan leads to.
    let judged = guarded(None, || Some(unsafe { judge(&plan) })).unwrap_or_else(panicked);
    match judged {
        Ok(judged) => {
            let made = guarded(null_mut(), || handle(Report::new(judged)));
            // SAFETY: as above.
            unsafe { report.write(made) };
            if made.is_null() { Status::Panic } else { Status::Ok }
        }
        // SAFETY: as the caller promises.
        Err(failure) => unsafe { with_mut(structure, Status::Panic, |structure| structure.fail(&failure)) },
    }
}
