//! Output files: written completely or not at all, and never over the input.

use crate::output::Failure;
use crate::progress::{finished, unfinished};
use same_file::is_same_file;
use std::fs;
use std::path::{MAIN_SEPARATOR, Path, PathBuf};
use twinedge_layers::{Format, files};

/// Writes a file, and refuses to overwrite an input under any path.
pub(crate) fn write_file<'a>(
    path: &Path,
    inputs: impl IntoIterator<Item = &'a Path>,
    contents: &[u8],
) -> Result<(), Failure> {
    let failed = |error: std::io::Error| Failure(format!("{}: {error}", path.display()));
    write_files(path, &[path.to_owned()], inputs, |path| fs::write(path, contents).map_err(failed))
}

/// Writes the files that belong to a path. `write` receives a path with the same name in a new folder next to it; the files that it writes there
/// replace the existing ones. A path that is not a plain file, such as `/dev/stdout`, is written directly.
pub(crate) fn write_files<'a>(
    path: &Path,
    all: &[PathBuf],
    inputs: impl IntoIterator<Item = &'a Path>,
    write: impl FnOnce(&Path) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let failed = |error: std::io::Error| {
        let text = error.to_string();
        // Drops the name of the temporary folder at the end of the error.
        let cause = text.split_once(" at path ").map_or(text.as_str(), |(cause, _)| cause);
        Failure(format!("{}: {cause}", path.display()))
    };
    for input in inputs {
        // Every file of a Shapefile is part of the input.
        let format = Format::of_path(input).unwrap_or(Format::GeoJson);
        let parts = files(input, format).into_iter().chain([input.to_owned()]);
        for part in parts {
            if let Some(same) = all.iter().find(|file| is_same_file(file, &part).unwrap_or(false)) {
                return Err(Failure(format!("{}: this is the input, and is not overwritten", same.display())));
            }
        }
    }
    if fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
        return write(path);
    }
    // Replace the target of a link, not the link.
    let real = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let folder = real.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let name = real.file_name().ok_or_else(|| Failure(format!("{}: this is no file", path.display())))?;
    let scratch = unfinished(|| tempfile::Builder::new().prefix(".twinedge-").tempdir_in(folder).map_err(failed))?;
    let written = scratch.path().join(name);
    let result = write(&written).and_then(|()| replace(&written, &real, all, failed));
    finished();
    // Messages name the requested file.
    let of_scratch = format!("{}{MAIN_SEPARATOR}", scratch.path().display());
    let prefix = path.parent().map(|folder| folder.join("").display().to_string()).unwrap_or_default();
    result.map_err(|Failure(message)| Failure(message.replace(&of_scratch, &prefix)))
}

/// Replaces the existing files by the written ones.
fn replace(
    written: &Path,
    real: &Path,
    all: &[PathBuf],
    failed: impl Fn(std::io::Error) -> Failure,
) -> Result<(), Failure> {
    for file in all {
        let (from, to) = match file.extension() {
            _ if all.len() == 1 => (written.to_owned(), real.to_owned()),
            Some(extension) => (written.with_extension(extension), real.with_extension(extension)),
            None => continue,
        };
        if from.exists() {
            if let Ok(metadata) = fs::metadata(&to) {
                fs::set_permissions(&from, metadata.permissions()).map_err(&failed)?;
            }
            fs::rename(from, to).map_err(&failed)?;
        } else if to.exists() {
            // A leftover file would belong to the previous output.
            fs::remove_file(to).map_err(&failed)?;
        }
    }
    Ok(())
}

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
