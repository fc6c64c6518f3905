//! Reference systems of the EPSG, as Esri defines them in `.prj`.
//!
//! Source: the EPSG Geodetic Parameter Dataset (IOGP, <https://epsg.org>), written by PROJ; see `data/esri_wkt.py`.

use flate2::read::GzDecoder;
use std::io::{BufRead, BufReader};

/// A line for each system: its number, a tabulator, its definition.
const TABLE: &[u8] = include_bytes!("../../data/esri-wkt.tsv.gz");

/// The first row for which `found` returns something. O(rows).
fn find<T>(mut found: impl FnMut(&str, &str) -> Option<T>) -> Option<T> {
    let lines = BufReader::new(GzDecoder::new(TABLE)).lines().map_while(Result::ok);
    lines.into_iter().find_map(|line| line.split_once('\t').and_then(|(code, wkt)| found(code, wkt)))
}

/// The definition of a system.
pub(super) fn wkt(code: i64) -> Option<String> {
    let wanted = code.to_string();
    find(|code, wkt| (code == wanted).then(|| wkt.to_owned()))
}

/// The number of the system with this definition.
pub(super) fn code(wanted: &str) -> Option<i64> {
    find(|code, wkt| if wkt == wanted.trim() { code.parse().ok() } else { None })
}
