//! Reference systems of the EPSG, as Esri defines them in `.prj`, and in PROJJSON.
//!
//! Source: the EPSG Geodetic Parameter Dataset (IOGP, <https://epsg.org>), written by PROJ; see `data/esri_wkt.py` and
//! `data/projjson.py`.

use flate2::read::GzDecoder;
use std::io::{BufRead, BufReader};

/// A line for each system: its number, a tabulator, its definition.
const TABLE: &[u8] = include_bytes!("../../data/esri-wkt.tsv.gz");

/// The same with definitions in PROJJSON.
#[cfg(feature = "geoparquet")]
const PROJJSON: &[u8] = include_bytes!("../../data/projjson.tsv.gz");

/// The first row of a table for which `found` returns something. O(rows).
fn find<T>(table: &[u8], mut found: impl FnMut(&str, &str) -> Option<T>) -> Option<T> {
    let lines = BufReader::new(GzDecoder::new(table)).lines().map_while(Result::ok);
    lines.into_iter().find_map(|line| line.split_once('\t').and_then(|(code, wkt)| found(code, wkt)))
}

/// The definition of a system.
pub(super) fn wkt(code: i64) -> Option<String> {
    of_code(TABLE, code)
}

/// The definition of a system in PROJJSON.
#[cfg(feature = "geoparquet")]
pub(super) fn projjson(code: i64) -> Option<String> {
    of_code(PROJJSON, code)
}

fn of_code(table: &[u8], wanted: i64) -> Option<String> {
    let wanted = wanted.to_string();
    find(table, |code, definition| (code == wanted).then(|| definition.to_owned()))
}

/// The number of the system with this definition.
pub(super) fn code(wanted: &str) -> Option<i64> {
    find(TABLE, |code, wkt| if wkt == wanted.trim() { code.parse().ok() } else { None })
}
