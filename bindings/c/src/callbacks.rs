//! Structures of pointers: the caller lists the records, and functions of the caller return the record to which a link
//! leads.
//!
//! Records are numbered in the order of their lists. Each function is called once for each record, before the
//! validation; its answer is looked up, and kept as a column. So no answer is ever followed: a pointer that is in no
//! list dangles.
//!
//! # Why it is sound
//!
//! A function that is not null is called with the caller's arguments: its context, and records from its own lists. It
//! promises to be a function of that type. It is `extern "C-unwind"`, so an exception of C++ that leaves it has a
//! meaning here: Rust's runtime ends the process, as it cannot catch foreign exceptions. A panic of a function in Rust
//! becomes [`Status::Panic`]. No reference to anything that the function could reach through a handle is held
//! meanwhile.

use crate::cells::Cells;
use crate::failure::{Failure, Status};
use crate::names::{Link, Record};
use rustc_hash::FxHashMap;
use std::ffi::c_void;
use std::sync::atomic::AtomicI64;
use twinedge_columns::Column;

/// A function that returns the target of a link of a record: a record, or null for nil. It gets the context and a record, and is
/// called once for each record. It must not throw: that ends the process.
pub type LinkOf = Option<unsafe extern "C-unwind" fn(context: *mut c_void, record: *const c_void) -> *const c_void>;

/// The inner boundary component at this position of the list of a face, in `*inner`. False if the list has no such position. It gets
/// the context, a face and the positions from 0 on. It must not throw: that ends the process.
pub type InnerOf = Option<
    unsafe extern "C-unwind" fn(
        context: *mut c_void,
        face: *const c_void,
        position: usize,
        inner: *mut *const c_void,
    ) -> bool,
>;

/// A function, with its context.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Callback<F> {
    pub(crate) function: F,
    pub(crate) context: *mut c_void,
}

/// The number for a pointer to no record.
const DANGLING: i64 = -2;
const NIL: i64 = -1;

/// The records of one kind, with their numbers.
struct Numbering {
    records: Vec<*const c_void>,
    numbers: FxHashMap<usize, i64>,
}

impl Numbering {
    /// # Safety
    /// As [`Cells::pointer`], for every position.
    unsafe fn of(kind: Record, cells: Option<Cells>) -> Result<Self, Failure> {
        let count = cells.map_or(0, |cells| cells.count());
        let mut all = Self { records: Vec::new(), numbers: FxHashMap::default() };
        all.records.try_reserve_exact(count).map_err(|_| Failure::memory())?;
        all.numbers.try_reserve(count).map_err(|_| Failure::memory())?;
        if let Some(cells) = cells {
            for position in 0..count {
                // SAFETY: as the caller promises.
                let record = unsafe { cells.pointer(position) };
                if record.is_null() {
                    return Err(Failure::new(Status::Null, format!("the {} {position} is null", kind.name())));
                }
                if let Some(earlier) = all.numbers.insert(record as usize, position.cast_signed() as i64) {
                    let kind = kind.name();
                    let message = format!("the {kind} {position} is given before, as {kind} {earlier}");
                    return Err(Failure::new(Status::Conflict, message));
                }
                all.records.push(record);
            }
        }
        Ok(all)
    }

    fn number(&self, record: *const c_void) -> i64 {
        if record.is_null() { NIL } else { self.numbers.get(&(record as usize)).copied().unwrap_or(DANGLING) }
    }
}

/// The answers of the functions, as columns.
#[derive(Debug, Default)]
pub(crate) struct Answers {
    columns: [Option<Vec<AtomicI64>>; Link::KINDS],
    counts: [usize; Record::KINDS],
}

impl Answers {
    /// Calls every function.
    ///
    /// # Safety
    /// The lists of records exist, and the functions may be called.
    pub(crate) unsafe fn of(
        records: [Option<Cells>; Record::KINDS],
        links: &[Option<Callback<LinkOf>>; Link::KINDS],
        inner: Option<Callback<InnerOf>>,
    ) -> Result<Self, Failure> {
        let kinds = [Record::Vertex, Record::HalfEdge, Record::Boundary, Record::Face];
        // SAFETY: as the caller promises.
        let numbered = |kind: Record| unsafe { Numbering::of(kind, records[kind as usize]) };
        let all = [numbered(kinds[0])?, numbered(kinds[1])?, numbered(kinds[2])?, numbered(kinds[3])?];
        let mut answers = Self { counts: [0, 1, 2, 3].map(|kind| all[kind].records.len()), ..Self::default() };
        for link in Link::ALL {
            if let (Some(callback), Some((from, to))) = (links[link as usize], link.ends()) {
                // SAFETY: as the caller promises.
                let column = unsafe { ask(callback, &all[from as usize].records, &all[to as usize]) }?;
                answers.columns[link as usize] = Some(column);
            }
        }
        if let Some(callback) = inner {
            let (faces, boundaries) = (&all[Record::Face as usize].records, &all[Record::Boundary as usize]);
            // SAFETY: as the caller promises.
            let (first, list) = unsafe { ask_lists(callback, faces, boundaries) }?;
            answers.columns[Link::InnerFirst as usize] = Some(first);
            answers.columns[Link::Inner as usize] = Some(list);
        }
        Ok(answers)
    }

    pub(crate) fn columns(&self) -> [Option<Column<'_, AtomicI64>>; Link::KINDS] {
        Link::ALL.map(|link| self.columns[link as usize].as_ref().map(|column| Column::new(column)))
    }

    /// Returns the number of records of each kind.
    pub(crate) const fn counts(&self) -> [usize; Record::KINDS] {
        self.counts
    }
}

/// # Safety
/// The function may be called with its context and each of these records.
unsafe fn ask(
    callback: Callback<LinkOf>,
    records: &[*const c_void],
    to: &Numbering,
) -> Result<Vec<AtomicI64>, Failure> {
    let mut column = Vec::new();
    column.try_reserve_exact(records.len()).map_err(|_| Failure::memory())?;
    let Some(function) = callback.function else { return Ok(column) };
    for record in records {
        // SAFETY: as the caller promises.
        let answer = unsafe { function(callback.context, *record) };
        column.push(AtomicI64::new(to.number(answer)));
    }
    Ok(column)
}

/// Calls the function for the list of each face. Returns the start of each list, and all lists.
///
/// # Safety
/// The function may be called with its context and each of these faces.
unsafe fn ask_lists(
    callback: Callback<InnerOf>,
    faces: &[*const c_void],
    to: &Numbering,
) -> Result<(Vec<AtomicI64>, Vec<AtomicI64>), Failure> {
    let (mut first, mut list) = (Vec::new(), Vec::new());
    first.try_reserve_exact(faces.len() + 1).map_err(|_| Failure::memory())?;
    // An endless list is cut where the validator reports `list_too_long`: after twice as many as there are, and 16.
    let most = to.records.len().saturating_mul(2).saturating_add(17);
    let Some(function) = callback.function else { return Ok((first, list)) };
    for face in faces {
        first.push(AtomicI64::new(list.len().cast_signed() as i64));
        let mut position = 0;
        while list.len() < most {
            let mut inner = std::ptr::null();
            // SAFETY: as the caller promises; `inner` is a place for a pointer.
            if !unsafe { function(callback.context, *face, position, &raw mut inner) } {
                break;
            }
            list.try_reserve(1).map_err(|_| Failure::memory())?;
            list.push(AtomicI64::new(to.number(inner)));
            position += 1;
        }
    }
    first.push(AtomicI64::new(list.len().cast_signed() as i64));
    Ok((first, list))
}
