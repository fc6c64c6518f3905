//! Names of columns, each kept once.

use rustc_hash::FxHashMap;
use std::sync::Arc;

#[derive(Debug, Default)]
pub(super) struct Names(FxHashMap<Box<str>, Arc<str>>);

impl Names {
    /// Returns the shared copy of a name. O(its length), expected.
    pub(super) fn get(&mut self, name: &str) -> Arc<str> {
        if let Some(known) = self.0.get(name) {
            return known.clone();
        }
        let new: Arc<str> = name.into();
        self.0.insert(name.into(), new.clone());
        new
    }
}
