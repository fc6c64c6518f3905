//! The files of a layer, on disk or in memory.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Files in memory, by their names, for example the parts of a Shapefile. Clones share their bytes.
///
/// ```
/// use std::path::Path;
/// use twinedge_layers::Files;
///
/// let files: Files = [("a.shp".into(), vec![0, 0, 0x27, 0x0a])].into_iter().collect();
/// assert_eq!(files.get(Path::new("a.shp")).map(<[u8]>::len), Some(4));
/// assert!(files.get(Path::new("a.dbf")).is_none());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Files(BTreeMap<PathBuf, Arc<[u8]>>);

impl Files {
    /// Adds or replaces a file.
    pub fn insert(&mut self, name: impl Into<PathBuf>, bytes: Vec<u8>) {
        self.0.insert(name.into(), bytes.into());
    }

    /// Returns the bytes of a file.
    #[must_use]
    pub fn get(&self, name: &Path) -> Option<&[u8]> {
        self.0.get(name).map(|bytes| &**bytes)
    }

    /// Returns the bytes of a file, shared.
    #[must_use]
    pub fn share(&self, name: &Path) -> Option<Arc<[u8]>> {
        self.0.get(name).map(Arc::clone)
    }

    /// Returns all files, by name.
    pub fn iter(&self) -> impl Iterator<Item = (&Path, &[u8])> {
        self.0.iter().map(|(name, bytes)| (name.as_path(), &**bytes))
    }
}

impl FromIterator<(PathBuf, Vec<u8>)> for Files {
    fn from_iter<I: IntoIterator<Item = (PathBuf, Vec<u8>)>>(files: I) -> Self {
        Self(files.into_iter().map(|(name, bytes)| (name, bytes.into())).collect())
    }
}
