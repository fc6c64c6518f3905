//! The target that reads topologies of PostGIS.

use std::io::BufReader;
use twinedge_postgis::{ReadError, audit, read};

/// The number of violations to keep.
const LIMIT: usize = 5;

/// Reads three COPY streams, in one piece and in small ones, with the same result. Errors lie inside the input; the
/// topology is judged, and a valid one has no violation.
///
/// # Panics
/// If the results differ or contradict each other.
pub fn postgis(bytes: &[u8]) {
    let pieces = read(BufReader::with_capacity(3, bytes), LIMIT);
    match (read(bytes, LIMIT), pieces) {
        (Ok(whole), Ok(pieces)) => {
            let (whole, pieces) = (audit(&whole, LIMIT).expect("memory"), audit(&pieces, LIMIT).expect("memory"));
            // Compared as text: a coordinate may be NaN.
            assert_eq!(whole.to_string(), pieces.to_string());
            assert!(!whole.is_valid() || whole.violation_count() == 0, "{whole}");
            assert!(whole.violations().len() <= LIMIT);
        }
        (Err(whole), Err(pieces)) => {
            assert_eq!(whole.to_string(), pieces.to_string());
            let ReadError::Content { byte, .. } = whole else { panic!("{whole}") };
            assert!(byte <= bytes.len() as u64, "byte {byte} of {}", bytes.len());
        }
        (whole, pieces) => panic!("in one piece: {whole:?}, in small ones: {pieces:?}"),
    }
}
