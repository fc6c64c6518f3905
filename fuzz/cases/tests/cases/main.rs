//! Each case takes every file of its corpus, and then, for about a second, files with some bytes changed, and any bytes.
//!
//! The inputs differ from run to run. A failure names a seed: `.seed(…)` after `.budget(…)` repeats it. With `ARBTEST_BUDGET_MS` in
//! the environment, the case runs for that long.

mod forms;

use arbitrary::Unstructured;
use arbtest::arbtest;
use std::fs;
use std::path::Path;
use std::time::Duration;

fn corpus(target: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../corpus").join(target);
    let mut files: Vec<_> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    assert!(!files.is_empty(), "{} is empty", folder.display());
    files.into_iter().map(|file| fs::read(file).unwrap()).collect()
}

/// A file with up to four bytes changed, inserted or removed; or, one time in four, any bytes.
fn input(source: &mut Unstructured<'_>, files: &[Vec<u8>]) -> arbitrary::Result<Vec<u8>> {
    if source.ratio(1, 4)? {
        return Ok(source.bytes(source.len())?.to_vec());
    }
    let mut bytes = source.choose(files)?.clone();
    for _ in 0..source.int_in_range(1..=4)? {
        let at = source.int_in_range(0..=bytes.len())?;
        match source.int_in_range(0..=3)? {
            0 => bytes.insert(at, source.arbitrary()?),
            1 => bytes.truncate(at),
            2 if at < bytes.len() => drop(bytes.remove(at)),
            _ => {
                let byte = source.arbitrary()?;
                bytes.get_mut(at).into_iter().for_each(|there| *there = byte);
            }
        }
    }
    Ok(bytes)
}

fn fuzz(target: &str, case: fn(&[u8])) {
    let files = corpus(target);
    for file in &files {
        case(file);
    }
    arbtest(|source| {
        case(&input(source, &files)?);
        Ok(())
    })
    .size_max(4096)
    .budget(Duration::from_secs(1));
}

macro_rules! cases {
    ($($target:ident)*) => {$(
        #[test]
        fn $target() {
            fuzz(stringify!($target), twinedge_fuzz_cases::$target);
        }
    )*};
}

cases! { programs in_step stale_keys validator_total certificates segments noding edits history geojson layer flatgeobuf shapefile topojson postgis }
