//! The format named by the extension of an output file.

use crate::status::Failure;
use std::path::Path;

/// Returns the format for a file's extension; `None` without an extension. An extension that the command does not write is refused.
pub(crate) fn format_of<F: Copy>(path: Option<&Path>, known: &[(&str, F)]) -> Result<Option<F>, Failure> {
    let Some((path, extension)) = path.and_then(|path| Some((path, path.extension()?))) else { return Ok(None) };
    if let Some((_, format)) = known.iter().find(|(name, _)| extension.eq_ignore_ascii_case(name)) {
        return Ok(Some(*format));
    }
    let names: Vec<String> = known.iter().map(|(name, _)| format!(".{name}")).collect();
    let extension = extension.to_string_lossy();
    Err(Failure(format!("{}: this command writes {}, and no .{extension}", path.display(), names.join(", "))))
}
