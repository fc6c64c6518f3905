//! Paths that a page of the repository names.

use std::path::{Path, PathBuf};

/// A path in a page that is not there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Missing {
    /// The line, counted from 1.
    pub line: usize,
    /// The path.
    pub path: String,
}

/// The paths in a page of Markdown that lead nowhere. O(n) questions.
///
/// A path is a text between backticks without a space that has a `/`, or ends like a file (`mod.rs`). It is relative to the root, or to
/// the folder of a path before it in the same line. `NAME` in a path stands for any name: the folder before it is looked for.
pub fn missing_paths(page: &str, exists: impl Fn(&Path) -> bool) -> Vec<Missing> {
    let mut missing = Vec::new();
    for (line, text) in (1..).zip(page.lines()) {
        let mut folders = vec![PathBuf::new()];
        for path in text.split('`').skip(1).step_by(2).filter(|text| is_path(text)) {
            let known = path.split("NAME").next().unwrap_or_default();
            let known =
                if known.len() < path.len() { known.rsplit_once('/').map_or("", |(folder, _)| folder) } else { known };
            let found = folders.iter().map(|folder| folder.join(known)).find(|path| exists(path));
            match found {
                Some(found) if known.len() < path.len() => folders.push(found),
                Some(found) => {
                    folders.push(if path.ends_with('/') { found } else { found.parent().unwrap_or(&found).to_owned() });
                }
                None => missing.push(Missing { line, path: path.to_owned() }),
            }
        }
    }
    missing
}

/// The endings of files without a folder.
const ENDINGS: [&str; 8] = [".rs", ".md", ".toml", ".txt", ".v", ".py", ".dict", ".svg"];

fn is_path(text: &str) -> bool {
    let is_plain = text.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"./_-".contains(&byte));
    is_plain && (text.contains('/') || ENDINGS.iter().any(|ending| text.len() > ending.len() && text.ends_with(ending)))
}
