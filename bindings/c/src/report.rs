//! The handle of a report, and its accessors.

use crate::border::{free, with};
use crate::names::{Count, Record};
use crate::words::{self, Words};
use std::ffi::{CString, c_char, c_int};
use std::ptr::null;
use std::sync::OnceLock;
use twinedge::validate as rules;
use twinedge::validate::Counts;

/// The result of a validation. Strings that are read from it belong to it. Any number of threads may read it.
#[derive(Debug)]
pub struct Report {
    found: rules::Report,
    words: Words,
    violations: OnceLock<Vec<Violation>>,
    text: OnceLock<CString>,
    json: OnceLock<CString>,
}

/// One violation of a report, to which it belongs.
#[derive(Debug)]
pub struct Violation {
    rule: CString,
    kind: CString,
    message: CString,
    cause: CString,
    remedy: CString,
    records: [Option<rules::Record>; 2],
}

/// A string of C. No text of a report has a zero byte.
fn string(text: impl Into<Vec<u8>>) -> CString {
    CString::new(text).unwrap_or_default()
}

impl Report {
    pub(crate) fn new((found, words): (rules::Report, Words)) -> Self {
        Self { found, words, violations: OnceLock::new(), text: OnceLock::new(), json: OnceLock::new() }
    }

    fn violations(&self) -> &[Violation] {
        self.violations.get_or_init(|| {
            let of = |(position, violation): (usize, &rules::Violation)| Violation {
                rule: string(violation.rule().id()),
                kind: string(violation.kind()),
                message: string(self.words.message(position, violation)),
                cause: string(words::cause(violation)),
                remedy: string(words::remedy(violation)),
                records: violation.records(),
            };
            self.found.violations().iter().enumerate().map(of).collect()
        })
    }
}

const fn counted(counts: &Counts, count: Count) -> Option<usize> {
    match count {
        Count::Vertices => Some(counts.vertices),
        Count::HalfEdges => Some(counts.half_edges),
        Count::Edges => Some(counts.edges),
        Count::Faces => Some(counts.faces),
        Count::OuterBoundaries => Some(counts.outer_boundaries),
        Count::InnerBoundaries => Some(counts.inner_boundaries),
        Count::IsolatedVertices => Some(counts.isolated_vertices),
        Count::Components => counts.components,
        Count::Cycles => counts.cycles,
        Count::Borders => counts.borders,
        Count::Genus => counts.genus,
        Count::Violations => None,
    }
}

/// Frees the report, with its violations and strings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_report_free(report: *mut Report) {
    // SAFETY: as the caller promises.
    unsafe { free(report) }
}

/// Returns true if no violation was found and every rule that applies was checked.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_report_valid(report: *const Report) -> bool {
    // SAFETY: as the caller promises.
    unsafe { with(report, false, |report| report.found.is_valid()) }
}

/// A number of the report, one of `twinedge_count`; `UINT64_MAX` for what could not be counted because a rule is broken, and for a
/// number that names nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_report_count(report: *const Report, count: c_int) -> u64 {
    let read = |report: &Report| match Count::of(count).ok()? {
        Count::Violations => Some(report.found.violation_count()),
        count => counted(report.found.counts(), count).map(|n| n as u64),
    };
    // SAFETY: as the caller promises.
    unsafe { with(report, None, read) }.unwrap_or(u64::MAX)
}

/// The report as text, a line for each rule, then a line for each violation that is listed. It is for people, and may change.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_report_text(report: *const Report) -> *const c_char {
    // SAFETY: as the caller promises.
    unsafe { with(report, null(), |r| r.text.get_or_init(|| string(r.words.text(&r.found))).as_ptr()) }
}

/// The report as JSON, in the form of docs/report.md. Numbers that a double does not hold are strings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_report_json(report: *const Report) -> *const c_char {
    // SAFETY: as the caller promises.
    unsafe { with(report, null(), |r| r.json.get_or_init(|| string(r.words.json(&r.found))).as_ptr()) }
}

/// Returns the number of violations that are listed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_report_listed(report: *const Report) -> usize {
    // SAFETY: as the caller promises.
    unsafe { with(report, 0, |report| report.found.violations().len()) }
}

/// The violation at this position of the list, in the order of the rules; null past the end.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_report_violation(report: *const Report, position: usize) -> *const Violation {
    // SAFETY: as the caller promises.
    unsafe { with(report, null(), |report| report.violations().get(position).map_or(null(), std::ptr::from_ref)) }
}

/// The id of the broken rule, as `L1`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_violation_rule(violation: *const Violation) -> *const c_char {
    // SAFETY: as the caller promises.
    unsafe { with(violation, null(), |violation| violation.rule.as_ptr()) }
}

/// The kind of violation, one of the names in docs/report.md, as `twin_not_mutual`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_violation_kind(violation: *const Violation) -> *const c_char {
    // SAFETY: as the caller promises.
    unsafe { with(violation, null(), |violation| violation.kind.as_ptr()) }
}

/// Returns a sentence that says what is wrong.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_violation_message(violation: *const Violation) -> *const c_char {
    // SAFETY: as the caller promises.
    unsafe { with(violation, null(), |violation| violation.message.as_ptr()) }
}

/// Returns the usual cause of a violation of this kind.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_violation_cause(violation: *const Violation) -> *const c_char {
    // SAFETY: as the caller promises.
    unsafe { with(violation, null(), |violation| violation.cause.as_ptr()) }
}

/// Returns the remedy, in the words of this header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_violation_remedy(violation: *const Violation) -> *const c_char {
    // SAFETY: as the caller promises.
    unsafe { with(violation, null(), |violation| violation.remedy.as_ptr()) }
}

/// The record at position 0, which is at fault, or at position 1. Its kind goes to `*kind`, its index to `*index`; either may be null.
/// False if there is none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinedge_violation_record(
    violation: *const Violation,
    position: usize,
    kind: *mut c_int,
    index: *mut usize,
) -> bool {
    let read = |violation: &Violation| violation.records.get(position).copied().flatten();
    // SAFETY: as the caller promises.
    let Some(record) = (unsafe { with(violation, None, read) }) else { return false };
    let number = match record {
        rules::Record::Vertex(_) => Record::Vertex,
        rules::Record::HalfEdge(_) => Record::HalfEdge,
        rules::Record::Boundary(_) => Record::Boundary,
        rules::Record::Face(_) => Record::Face,
    };
    if !kind.is_null() {
        // SAFETY: not null, so a place for a number.
        unsafe { kind.write(number as c_int) };
    }
    if !index.is_null() {
        // SAFETY: the same.
        unsafe { index.write(record.index()) };
    }
    true
}
