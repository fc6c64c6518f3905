//! Panics at the border. The C interface is tested in `tests/structure.c`.

use crate::border::{free, guarded, handle, with, with_mut};
use crate::failure::Status;
use crate::names::{Link, Record};
use crate::structure::{
    twinedge_follow, twinedge_follow_inner, twinedge_pointers, twinedge_structure_error, twinedge_structure_free,
    twinedge_structure_new, twinedge_validate,
};
use crate::words::{Words, cause, remedy};
use serde_json::json;
use std::ffi::{CStr, c_int, c_void};
use std::ptr::{dangling_mut, null, null_mut};
use twinedge::validate::Violation;

#[test]
fn a_panic_becomes_the_other_answer() {
    assert_eq!(guarded(7, || panic!("caught")), 7);
    assert_eq!(guarded(7, || 8), 8);
    let number = handle(5_i32);
    // SAFETY: handles of this library, or null; freed once, at the end.
    unsafe {
        assert_eq!(with(number, 0, |number| *number), 5);
        assert_eq!(with(number, 0, |_| panic!("caught")), 0);
        assert_eq!(with_mut(number, 0, |number| std::mem::replace(number, 6)), 5);
        assert_eq!(with_mut(number, 0, |_| panic!("caught")), 0);
        assert_eq!((with(null::<i32>(), 1, |_| 2), with_mut(null_mut::<i32>(), 1, |_| 2)), (1, 1));
        assert_eq!(with(number, 0, |number| *number), 6);
        free(number);
        free(null_mut::<i32>());
    }
}

struct Bomb;

impl Drop for Bomb {
    fn drop(&mut self) {
        panic!("caught");
    }
}

#[test]
fn a_panic_while_an_object_is_freed_stays_inside() {
    // SAFETY: a handle of this library, freed once.
    unsafe { free(handle(Bomb)) };
}

unsafe extern "C-unwind" fn leaves(_: *mut c_void, _: *const c_void) -> *const c_void {
    panic!("a function that leaves by a panic, as one in Rust can")
}

unsafe extern "C-unwind" fn is_nil(_: *mut c_void, _: *const c_void) -> *const c_void {
    null()
}

unsafe extern "C-unwind" fn inner_leaves(_: *mut c_void, _: *const c_void, _: usize, _: *mut *const c_void) -> bool {
    panic!("the same")
}

#[test]
fn a_function_that_does_not_return_is_an_error_of_the_validation() {
    let records = [1_u8, 2];
    let pointers = [(&raw const records[0]).cast::<c_void>(), (&raw const records[1]).cast()];
    for inner in [false, true] {
        let structure = twinedge_structure_new();
        // SAFETY: the handle is of this library and is freed at the end; the array outlives the validation.
        unsafe {
            for kind in [Record::Vertex, Record::HalfEdge, Record::Boundary, Record::Face] {
                assert_eq!(twinedge_pointers(structure, kind as c_int, pointers.as_ptr(), 2), Status::Ok);
            }
            for link in [Link::Origin, Link::Twin, Link::Next] {
                assert_eq!(twinedge_follow(structure, link as c_int, Some(is_nil), null_mut()), Status::Ok);
            }
            if inner {
                assert_eq!(twinedge_follow_inner(structure, Some(inner_leaves), null_mut()), Status::Ok);
            } else {
                assert_eq!(twinedge_follow(structure, Link::Next as c_int, Some(leaves), null_mut()), Status::Ok);
            }
            let mut report = dangling_mut();
            assert_eq!(twinedge_validate(structure, &raw mut report), Status::Panic);
            assert!(report.is_null());
            assert!(CStr::from_ptr(twinedge_structure_error(structure)).to_str().unwrap().contains("panicked"));
            // The handle is still valid.
            assert_eq!(twinedge_validate(structure, &raw mut report), Status::Panic);
            twinedge_structure_free(structure);
        }
    }
}

/// A violation of each kind, made up from the names of its fields in docs/report.md.
fn one_of_each_kind() -> Vec<Violation> {
    let values = [json!(0), json!({"face": 0}), json!("twin"), json!([0, 0]), json!("outer"), json!(null)];
    let of = |line: &str| -> Option<Violation> {
        let cells: Vec<_> = line.split('|').map(str::trim).collect();
        let [_, kind, _, fields, ..] = cells[..] else { return None };
        let kind = kind.strip_prefix('`')?.strip_suffix('`')?;
        let fields: Vec<_> =
            fields.split(", ").filter_map(|field| field.strip_prefix('`')?.strip_suffix('`')).collect();
        (0..values.len().pow(u32::try_from(fields.len()).ok()?)).find_map(|mut choice| {
            let mut holds = serde_json::Map::new();
            for field in &fields {
                holds.insert((*field).to_owned(), values[choice % values.len()].clone());
                choice /= values.len();
            }
            let mut entry = json!({ "kind": kind });
            if !fields.is_empty() {
                entry["fields"] = holds.into();
            }
            serde_json::from_value(entry).ok()
        })
    };
    include_str!("../../../docs/report.md").lines().filter_map(of).collect()
}

/// Messages for programs in C do not mention Rust.
#[test]
fn all_kinds_speak_of_the_header() {
    let all = one_of_each_kind();
    let kinds: Vec<_> = all.iter().map(Violation::kind).collect();
    assert_eq!(kinds, Violation::KINDS);
    let header = include_str!("../include/twinedge.h");
    for violation in all {
        let words = Words::default();
        for text in [words.message(0, &violation), remedy(&violation).to_owned(), cause(&violation).to_owned()] {
            for rust in [
                "::",
                "Expectation",
                "Part",
                "View",
                "_slots",
                "outer_half_edge",
                "no_unused",
                "Builder",
                "answer with",
            ] {
                assert!(!text.contains(rust), "{}: {text}", violation.kind());
            }
            // A name in backquotes is in the header, or is a link.
            for name in text.split('`').skip(1).step_by(2) {
                let is_link =
                    Link::ALL.iter().any(|link| name == link.name() || name.starts_with(&format!("{}(", link.name())));
                let is_known = is_link || header.contains(name);
                assert!(is_known, "{}: {name}", violation.kind());
            }
        }
    }
}

/// The numbers in the header match the enumerations, and every name is found by its number.
#[test]
fn numbers_name_links_and_records() {
    for (number, link) in Link::ALL.into_iter().enumerate() {
        assert_eq!((link as usize, Link::of(c_int::try_from(number).unwrap()).unwrap()), (number, link));
    }
    for (number, kind) in [Record::Vertex, Record::HalfEdge, Record::Boundary, Record::Face].into_iter().enumerate() {
        assert_eq!((kind as usize, Record::of(c_int::try_from(number).unwrap()).unwrap()), (number, kind));
    }
    assert!(
        Link::of(-1).is_err() && Link::of(16).is_err() && Record::of(4).is_err() && Record::of(c_int::MIN).is_err()
    );
}
