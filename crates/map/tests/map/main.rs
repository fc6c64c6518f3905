//! Maps with coordinates: building, editing, location.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[allow(dead_code, unused_macros, unused_imports, reason = "each test uses a part of it")]
mod support {
    #[path = "../../../../../tests/support/changes.rs"]
    pub(crate) mod changes;
    pub(crate) mod drawn;
    pub(crate) mod edits;
    #[path = "../../../../../tests/support/erased.rs"]
    pub(crate) mod erased;
    #[path = "../../../../geometry/tests/geometry/exact.rs"]
    pub(crate) mod exact;
    #[path = "../../../../../tests/support/inconsistent.rs"]
    pub(crate) mod inconsistent;
    #[path = "../../../../../tests/support/nested.rs"]
    pub(crate) mod nested;
    #[path = "../../../../../tests/support/only_live.rs"]
    pub(crate) mod only_live;
    pub(crate) mod oracle;
    #[path = "../../../../../tests/support/programs.rs"]
    pub(crate) mod programs;
    #[path = "../../../../../tests/support/saved.rs"]
    pub(crate) mod saved;
    #[path = "../../../../../tests/support/tables.rs"]
    pub(crate) mod tables;
    #[path = "../../../../../tests/support/tokens.rs"]
    pub(crate) mod tokens;
}

mod attributes;
mod audited;
mod certificate;
mod drawing;
mod edit;
mod edit_numbers;
mod edit_programs;
mod edited_maps;
mod equality;
mod history;
mod import;
mod location;
mod noding;
mod planar_map;
mod rewound;
mod rings;
mod saved;
#[cfg(debug_assertions)]
mod sorting;
mod threads;
