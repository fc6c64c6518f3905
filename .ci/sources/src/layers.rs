//! The layers of the library, and the imports that run against them.

use std::fmt;
use std::path::Path;

use crate::graph::{Import, Imports};

/// Each layer, and those that it may import. Between files of one layer only loops are refused.
pub const LAYERS: &[(&str, &[&str])] = &[
    ("numbers", &[]),
    ("validate", &["numbers"]),
    ("store", &["numbers", "validate"]),
    ("dcel", &["numbers", "validate", "store"]),
    ("program", &["numbers", "validate", "store", "dcel"]),
];

/// An import of a layer that the importing one may not know.
#[derive(Clone, Debug)]
pub struct Upward {
    /// The layer of the importing file.
    pub layer: &'static str,
    /// The layer that it imports, or the file, if that is in none.
    pub imported: String,
    /// The import.
    pub import: Import,
}

impl fmt::Display for Upward {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} may not import {}: {}", self.layer, self.imported, self.import)
    }
}

/// The imports that run against the layers. `sources` is the folder of the library's root file.
#[must_use]
pub fn upward(imports: &Imports, sources: &Path) -> Vec<Upward> {
    let mut found = Vec::new();
    for import in imports.iter().filter(|import| is_inside(&import.from, sources)) {
        let (layer, allowed) = layer_of(&import.from, sources).unwrap_or(("a file of no layer", &[]));
        let to = layer_of(&import.to, sources).map(|(to, _)| to);
        let is_allowed = |to: &str| to == layer || allowed.contains(&to);
        if !to.is_some_and(is_allowed) {
            let imported = to.map_or_else(|| import.to.display().to_string(), str::to_owned);
            found.push(Upward { layer, imported, import });
        }
    }
    found
}

/// In the library, and not its root.
fn is_inside(file: &Path, sources: &Path) -> bool {
    file.starts_with(sources) && file != sources.join("lib.rs")
}

fn layer_of(file: &Path, sources: &Path) -> Option<(&'static str, &'static [&'static str])> {
    let inside = file.strip_prefix(sources).ok()?;
    let is_in = |layer: &str| inside.starts_with(layer) || inside == Path::new(&format!("{layer}.rs"));
    LAYERS.iter().find(|(layer, _)| is_in(layer)).copied()
}
