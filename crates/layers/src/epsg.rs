//! Reference systems of the EPSG, in Esri's definitions for `.prj`, and in PROJJSON.
//!
//! Source: the EPSG Geodetic Parameter Dataset (IOGP, <https://epsg.org>), written by PROJ; see `data/esri_wkt.py`,
//! `data/projjson.py`.

#[cfg(feature = "epsg")]
use flate2::read::GzDecoder;
#[cfg(feature = "epsg")]
use std::io::{BufRead, BufReader};

/// One line per system: its number, a tab, its definition.
#[cfg(feature = "epsg")]
const TABLE: &[u8] = include_bytes!("../data/esri-wkt.tsv.gz");

/// One line per system: its number, a tab, its definition in PROJJSON.
#[cfg(feature = "geoparquet")]
const PROJJSON: &[u8] = include_bytes!("../data/projjson.tsv.gz");

/// The only system known without the table.
#[cfg(not(feature = "epsg"))]
const WGS_84: (i64, &str) = (
    4326,
    "GEOGCS[\"GCS_WGS_1984\",DATUM[\"D_WGS_1984\",SPHEROID[\"WGS_1984\",6378137.0,298.257223563]],PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\",0.0174532925199433]]",
);

/// Returns the first result of `found` on the rows of a table. O(rows).
#[cfg(feature = "epsg")]
fn find<T>(table: &[u8], mut found: impl FnMut(&str, &str) -> Option<T>) -> Option<T> {
    let lines = BufReader::new(GzDecoder::new(table)).lines().map_while(Result::ok);
    lines.into_iter().find_map(|line| line.split_once('\t').and_then(|(code, wkt)| found(code, wkt)))
}

pub(super) fn wkt(code: i64) -> Option<String> {
    #[cfg(feature = "epsg")]
    return of_code(TABLE, code);
    #[cfg(not(feature = "epsg"))]
    return (code == WGS_84.0).then(|| WGS_84.1.to_owned());
}

#[cfg(feature = "geoparquet")]
pub(super) fn projjson(code: i64) -> Option<String> {
    of_code(PROJJSON, code)
}

#[cfg(feature = "epsg")]
fn of_code(table: &[u8], wanted: i64) -> Option<String> {
    let wanted = wanted.to_string();
    find(table, |code, definition| (code == wanted).then(|| definition.to_owned()))
}

/// Returns the number of the system with this definition, up to the last digits of numbers: older programs wrote more or fewer.
pub(super) fn code(wanted: &str) -> Option<i64> {
    #[cfg(not(feature = "epsg"))]
    return is_like(wanted.trim(), WGS_84.1).then_some(WGS_84.0);
    #[cfg(feature = "epsg")]
    {
        let wanted = wanted.trim();
        let number_if =
            |is_it: &dyn Fn(&str) -> bool| find(TABLE, |code, wkt| if is_it(wkt) { code.parse().ok() } else { None });
        number_if(&|wkt| wkt == wanted).or_else(|| number_if(&|wkt| is_like(wanted, wkt)))
    }
}

/// Returns true if two definitions are equal up to the last digits of numbers.
fn is_like(one: &str, other: &str) -> bool {
    const DIGITS: f64 = 1e-9;
    const ENDS: [char; 3] = [',', '[', ']'];
    let is_same = |(a, b): (&str, &str)| {
        a == b
            || match (a.parse::<f64>(), b.parse::<f64>()) {
                (Ok(a), Ok(b)) => (a - b).abs() <= DIGITS * a.abs().max(b.abs()),
                _ => false,
            }
    };
    let (mut words, mut others) = (one.split(ENDS), other.split(ENDS));
    loop {
        match (words.next(), others.next()) {
            (None, None) => return true,
            (Some(a), Some(b)) if is_same((a.trim(), b)) => {}
            _ => return false,
        }
    }
}
