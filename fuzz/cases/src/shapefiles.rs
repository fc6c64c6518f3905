//! Shapefiles.

use std::fs;
use std::path::{Path, PathBuf};
use std::{process, thread};
use twinedge_layers::{Format, Layer, ReadOptions, read_path, write_path};

/// Reads a Shapefile of up to four parts: the first byte selects them, and each is preceded by its length as two bytes,
/// the low one first. The last part is the rest. The reader returns, and its features are written and read again
/// unchanged.
///
/// # Panics
/// If the features differ, or if files cannot be written to the temporary folder.
pub fn shapefile(bytes: &[u8]) {
    let folder = folder();
    fs::create_dir_all(&folder).expect("a folder for temporary files");
    let once = lay_out(bytes, &folder.join("map.shp")).then(|| read(&folder.join("map.shp"))).flatten();
    // A Shapefile has one type of geometries, and other limits that an input may exceed.
    let written = once.and_then(|layer| written(&layer, &folder.join("once.shp")));
    if let Some(once) = written {
        let twice = self::written(&once, &folder.join("twice.shp")).expect("what was written once");
        // As text: a measure may be NaN.
        assert_eq!(format!("{:?}", once.features), format!("{:?}", twice.features));
    }
    let _ = fs::remove_dir_all(&folder);
}

/// A folder in memory, where the system has one: on disk, files take nine tenths of the time.
fn folder() -> PathBuf {
    let memory = Path::new("/dev/shm");
    let base = if memory.is_dir() { memory.to_owned() } else { std::env::temp_dir() };
    base.join(format!("twinedge-fuzz-{}-{:?}", process::id(), thread::current().id()))
}

fn read(path: &Path) -> Option<Layer> {
    read_path(path, &ReadOptions::default()).ok()
}

fn written(layer: &Layer, path: &Path) -> Option<Layer> {
    write_path(layer, path, Format::Shapefile).ok()?;
    Some(read_path(path, &ReadOptions::default()).expect("what was written is a Shapefile"))
}

/// Writes the parts; returns false if there are none.
fn lay_out(bytes: &[u8], path: &Path) -> bool {
    let Some((parts, mut rest)) = bytes.split_first() else { return false };
    let chosen: Vec<&str> = ["shp", "dbf", "shx", "cpg"]
        .into_iter()
        .enumerate()
        .filter(|(i, _)| parts >> i & 1 == 1)
        .map(|(_, e)| e)
        .collect();
    for (i, extension) in chosen.iter().enumerate() {
        let mut part = rest;
        if i + 1 < chosen.len() {
            let Some((length, after)) = rest.split_first_chunk() else { return false };
            let length = usize::from(u16::from_le_bytes(*length)).min(after.len());
            (part, rest) = after.split_at(length);
        }
        fs::write(path.with_extension(extension), part).expect("the folder is there");
    }
    !chosen.is_empty()
}
