//! Checks on the sources of this workspace. The tests of this package run them: `cargo test -p twinedge-sources`.
//!
//! # Imports run one way
//!
//! No files import each other in a loop, and no file of the library imports one of a layer that [`LAYERS`] does not allow it.
//!
//! A file *imports* another if its code names something that the other defines: in a `use`, in a path, or by a name that is in
//! scope through a re-export or a glob. What counts is the file of the definition: a name that `mod.rs` re-exports is imported
//! from the file that defines it, and `super::X` is an import of `mod.rs` only if `X` is defined there. A re-export
//! (`pub use`) imports nothing by itself, and neither does `mod x;`.
//!
//! Not seen: methods and fields, as they have no path; a function that comes through a glob or a re-export and is passed on
//! without being called; what a macro of another file makes; links in documentation.
//!
//! ```
//! use std::path::Path;
//! use twinedge_sources::{Crate, imports};
//!
//! let read = |path: &Path| match path.to_str()? {
//!     "lib.rs" => Some("pub mod map; pub mod walk;".to_owned()),
//!     "map.rs" => Some("use crate::walk::Walk; pub struct Map;".to_owned()),
//!     "walk.rs" => Some("pub struct Walk<'a>(&'a super::map::Map);".to_owned()),
//!     _ => None,
//! };
//! let library = Crate { name: "maps".to_owned(), root: "lib.rs".into(), is_library: true };
//! let loops = imports(&[library], read).unwrap().loops();
//! assert_eq!(loops[0].to_string(), "2 files import each other:\n  map.rs:1 imports Walk from walk.rs\n  walk.rs:1 imports Map from map.rs\n");
//! ```

mod graph;
mod guide;
mod layers;
mod modules;
mod names;
mod references;
mod workspace;

use std::path::Path;

pub use graph::{Import, Imports, Loop};
pub use guide::{Missing, missing_paths};
pub use layers::{LAYERS, Upward, upward};
pub use modules::Unreadable;
pub use workspace::{Crate, crates, crates_of};

/// All imports between the files of these crates.
///
/// # Errors
/// If a file is missing or is not Rust.
pub fn imports(crates: &[Crate], read: impl Fn(&Path) -> Option<String>) -> Result<Imports, Unreadable> {
    let forest = modules::read(crates, &read)?;
    Ok(references::imports(&forest))
}
